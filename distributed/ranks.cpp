#include <ringwatch/distributed/ranks.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include <ringwatch/base/error.h>
#include <ringwatch/base/infinity.h>

namespace ringwatch {

Ranks::Ranks(MPI_Comm communicator) : communicator_(communicator) {
  MPI_Comm_rank(communicator_, &rank_);
  MPI_Comm_size(communicator_, &size_);
  MPI_Comm machine = MPI_COMM_NULL;
  MPI_Comm_split_type(communicator_, MPI_COMM_TYPE_SHARED, rank_, MPI_INFO_NULL, &machine);
  MPI_Comm_size(machine, &onThisMachine_);
  MPI_Comm_free(&machine);
}

std::string Ranks::name() const {
  char machine[MPI_MAX_PROCESSOR_NAME];
  int length = 0;
  MPI_Get_processor_name(machine, &length);
  return joinText("rank ", rank_, " of ", size_, " on ", std::string(machine, static_cast<std::size_t>(length)));
}

void Ranks::largest(std::span<double> numbers, const std::function<void()>& meanwhile) {
  ++reductions_;
  // MPI says nothing of NaN. Infinity stands for it: no other number that is reduced can be infinite.
  for (double& number : numbers)
    if (std::isnan(number)) number = infinity;
  const std::vector<double> sent(numbers.begin(), numbers.end());
  MPI_Request pending = MPI_REQUEST_NULL;
  MPI_Iallreduce(sent.data(), numbers.data(), static_cast<int>(numbers.size()), MPI_DOUBLE, MPI_MAX, communicator_,
                 &pending);
  if (meanwhile) meanwhile();
  MPI_Wait(&pending, MPI_STATUS_IGNORE);
  for (double& number : numbers)
    if (number == infinity) number = std::numeric_limits<double>::quiet_NaN();
}

void Ranks::sum(std::span<ExactSum> sums) {
  ++reductions_;
  constexpr std::size_t width = ExactSum::digitCount + 1;
  std::vector<std::int64_t> own(sums.size() * width), all(own.size());
  for (std::size_t i = 0; i < sums.size(); ++i) {
    const ExactSum::Digits& digits = sums[i].digits();
    std::copy(digits.begin(), digits.end(), own.begin() + static_cast<std::ptrdiff_t>(i * width));
    own[i * width + ExactSum::digitCount] = sums[i].notFinite();
  }
  MPI_Allreduce(own.data(), all.data(), static_cast<int>(own.size()), MPI_INT64_T, MPI_SUM, communicator_);
  for (std::size_t i = 0; i < sums.size(); ++i) {
    sums[i] = ExactSum();
    sums[i].addDigits(all.data() + i * width, all[i * width + ExactSum::digitCount]);
  }
}

std::int64_t Ranks::least(std::int64_t number) {
  ++reductions_;
  std::int64_t least = 0;
  MPI_Allreduce(&number, &least, 1, MPI_INT64_T, MPI_MIN, communicator_);
  return least;
}

int Ranks::firstWhere(bool yes) { return static_cast<int>(least(yes ? rank_ : size_)); }

void Ranks::share(void* data, std::size_t bytes, int from) {
  constexpr std::size_t most = std::size_t{1} << 30;  // an int counts the bytes of a message
  for (std::size_t begin = 0; begin < bytes; begin += most)
    MPI_Bcast(static_cast<char*>(data) + begin, static_cast<int>(std::min(most, bytes - begin)), MPI_BYTE, from,
              communicator_);
}

std::string Ranks::shareText(std::string text, int from) {
  std::size_t length = text.size();
  share(&length, sizeof length, from);
  text.resize(length);
  share(text.data(), length, from);
  return text;
}

std::optional<ElementRef> Ranks::first(std::optional<ElementRef> found) {
  constexpr std::int64_t none = std::numeric_limits<std::int64_t>::max();
  const std::int64_t code = least(found ? (std::int64_t{found->block} << 32) | found->element : none);
  if (code == none) return std::nullopt;
  return ElementRef{code >> 32, code & 0xffffffff};
}

}  // namespace ringwatch
