#include <ringwatch/distributed/halo.h>

#include <algorithm>

namespace ringwatch {

Halo::~Halo() {
  // The vectors may be gone already.
  if (underWay_)
    MPI_Waitall(static_cast<int>(underWay_->requests.size()), underWay_->requests.data(), MPI_STATUSES_IGNORE);
  for (auto& [numbers, channel] : channels_)
    for (MPI_Request& request : channel.requests) MPI_Request_free(&request);
}

std::int64_t Halo::sentNodes() const {
  std::int64_t count = 0;
  for (const RankBody::Neighbour& neighbour : part_.neighbours())
    count += static_cast<std::int64_t>(neighbour.sent.size());
  return count;
}

Halo::Channel& Halo::channelOf(int numbers) {
  const auto [at, fresh] = channels_.try_emplace(numbers);
  Channel& channel = at->second;
  if (!fresh) return channel;
  channel.sent.resize(static_cast<std::size_t>(sentNodes() * numbers));
  channel.received.resize(static_cast<std::size_t>(part_.ghostNodes()) * static_cast<std::size_t>(numbers));
  double* sent = channel.sent.data();
  double* received = channel.received.data();
  for (const RankBody::Neighbour& neighbour : part_.neighbours()) {
    const int out = static_cast<int>(neighbour.sent.size()) * numbers, in = neighbour.receivedCount * numbers;
    MPI_Recv_init(received, in, MPI_DOUBLE, neighbour.rank, numbers, ranks_.communicator(),
                  &channel.requests.emplace_back());
    MPI_Send_init(sent, out, MPI_DOUBLE, neighbour.rank, numbers, ranks_.communicator(),
                  &channel.requests.emplace_back());
    sent += out;
    received += in;
  }
  return channel;
}

void Halo::exchange(double* data, int numbers) {
  begin(data, numbers);
  finish();
}

void Halo::begin(double* data, int numbers) {
  finish();
  Channel& channel = channelOf(numbers);
  double* to = channel.sent.data();
  for (const RankBody::Neighbour& neighbour : part_.neighbours())
    for (const std::int32_t node : neighbour.sent)
      to = std::copy_n(data + static_cast<std::ptrdiff_t>(node) * numbers, numbers, to);
  ++traffic_.exchanges;
  if (channel.requests.empty()) return;  // for which MPI_Startall has no array
  MPI_Startall(static_cast<int>(channel.requests.size()), channel.requests.data());
  traffic_.messages += static_cast<std::int64_t>(part_.neighbours().size());
  traffic_.bytes += static_cast<std::int64_t>(channel.sent.size() * sizeof(double));
  traffic_.received += static_cast<std::int64_t>(channel.received.size() * sizeof(double));
  underWay_ = &channel;
  data_ = data;
  numbers_ = numbers;
}

/// Receives and sends take turns in the requests.
void Halo::countArrived() {
  if (!underWay_) return;
  std::vector<MPI_Request>& requests = underWay_->requests;
  arrived_.resize(requests.size());
  int count = 0;
  MPI_Testsome(static_cast<int>(requests.size()), requests.data(), &count, arrived_.data(), MPI_STATUSES_IGNORE);
  if (count == MPI_UNDEFINED) return;  // all had come before
  for (int i = 0; i < count; ++i)
    if (arrived_[i] % 2 == 0)
      traffic_.hidden += static_cast<std::int64_t>(sizeof(double)) * numbers_ *
                         part_.neighbours()[static_cast<std::size_t>(arrived_[i] / 2)].receivedCount;
}

void Halo::finish() {
  if (!underWay_) return;
  Channel& channel = *underWay_;
  const double began = MPI_Wtime();
  MPI_Waitall(static_cast<int>(channel.requests.size()), channel.requests.data(), MPI_STATUSES_IGNORE);
  traffic_.waited += MPI_Wtime() - began;
  std::copy_n(channel.received.data(), channel.received.size(),
              data_ + static_cast<std::ptrdiff_t>(part_.ownedNodes()) * numbers_);
  underWay_ = nullptr;
}

}  // namespace ringwatch
