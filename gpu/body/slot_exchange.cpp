#include <ringwatch/gpu/body/slot_exchange.h>

#include <algorithm>

namespace ringwatch {
namespace {

/// Lets a device read and write the memory of another one directly, where the machine can.
void enableAccess(int device, int peer) {
  if (device == peer) return;
  int can = 0;
  checkCuda(cudaDeviceCanAccessPeer(&can, device, peer), "cudaDeviceCanAccessPeer");
  if (!can) return;
  const OnDevice here(device);
  const cudaError_t status = cudaDeviceEnablePeerAccess(peer, 0);
  if (status == cudaErrorPeerAccessAlreadyEnabled)
    cudaGetLastError();  // clears it
  else
    checkCuda(status, "cudaDeviceEnablePeerAccess");
}

std::size_t sentSlots(const std::vector<SlotLists>& lists) {
  std::size_t count = 0;
  for (const SlotLists& one : lists) count += one.send.size();
  return count;
}

}  // namespace

/// One part's side of the exchange.
struct SlotExchange::End {
  End(const Part& of, std::size_t bytesPerSlot) : part(of), buffer(sentSlots(*of.lists) * bytesPerSlot) {
    std::vector<std::int32_t> all;
    for (const SlotLists& one : *of.lists) all.insert(all.end(), one.send.begin(), one.send.end());
    list = DeviceVector<std::int32_t>(all);
  }
  Part part;
  DeviceVector<char> buffer;
  DeviceVector<std::int32_t> list;  // slots in the order of the buffer
  std::vector<std::unique_ptr<Copy>> copies;
  DeviceEvent packed, released;
};

SlotExchange::SlotExchange(const std::vector<Part>& parts, std::size_t bytesPerSlot) : bytesPerSlot_(bytesPerSlot) {
  for (const Part& part : parts) {
    const OnDevice here(part.device);
    ends_.push_back(std::make_unique<End>(part, bytesPerSlot));
  }
  for (std::size_t p = 0; p < parts.size(); ++p) {
    const OnDevice here(parts[p].device);
    std::size_t from = 0;
    for (const SlotLists& own : *parts[p].lists) {
      enableAccess(parts[p].device, parts[own.with].device);
      const std::vector<SlotLists>& theirs = *parts[own.with].lists;
      const auto place =
          std::find_if(theirs.begin(), theirs.end(), [p](const SlotLists& one) { return one.with == p; });
      auto copy = std::make_unique<Copy>();
      copy->to = own.with;
      copy->from = from;
      copy->size = own.send.size() * bytesPerSlot;
      copy->target =
          static_cast<char*>(parts[own.with].slots) + static_cast<std::size_t>(place->firstReceived) * bytesPerSlot;
      from += copy->size;
      ends_[p]->copies.push_back(std::move(copy));
    }
  }
}
SlotExchange::~SlotExchange() {
  // Copies may still be on their way into memory that goes.
  for (const auto& end : ends_)
    for (const auto& copy : end->copies) cudaStreamSynchronize(copy->stream);
}

void SlotExchange::pack(std::size_t part) {
  End& own = *ends_[part];
  if (own.copies.empty()) return;
  // The copies of the last use read the buffer.
  for (const auto& copy : own.copies) copy->arrived.holdUp(own.part.stream);
  launchPack(own.part.slots, own.list.data(), static_cast<std::int32_t>(own.list.size()), bytesPerSlot_,
             own.buffer.data(), own.part.stream);
  own.packed.record(own.part.stream);
  for (const auto& copy : own.copies) {
    own.packed.holdUp(copy->stream);
    ends_[copy->to]->released.holdUp(copy->stream);
    checkCuda(
        cudaMemcpyAsync(copy->target, own.buffer.data() + copy->from, copy->size, cudaMemcpyDefault, copy->stream),
        "copy to another device");
    copy->arrived.record(copy->stream);
  }
}
void SlotExchange::await(std::size_t part) {
  for (const auto& copy : ends_[part]->copies)
    for (const auto& back : ends_[copy->to]->copies)
      if (back->to == part) back->arrived.holdUp(ends_[part]->part.stream);
}
void SlotExchange::release(std::size_t part) {
  End& own = *ends_[part];
  if (!own.copies.empty()) own.released.record(own.part.stream);
}

std::size_t SlotExchange::bytes() const {
  std::size_t sum = 0;
  for (const auto& end : ends_) sum += end->buffer.size();
  return sum;
}
std::size_t SlotExchange::bytesOnDevice(const std::vector<SlotLists>& lists, std::size_t bytesPerSlot) {
  return sentSlots(lists) * (bytesPerSlot + sizeof(std::int32_t));
}

}  // namespace ringwatch
