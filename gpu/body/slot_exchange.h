#pragma once
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include <ringwatch/gpu/body/device_patches.h>
#include <ringwatch/gpu/device_stream.h>
#include <ringwatch/gpu/device_vector.h>

namespace ringwatch {

/// Copies slots of border nodes between the devices that have parts of a body, from each to all others that have the
/// node, beside what the devices compute meanwhile. For every use, in this order: pack() of every part behind the work
/// that fills its slots; await() and, behind the work that reads what was received, release() of every part. All return
/// at once. With one part nothing is done.
///
/// Copies are those that CUDA brings: over NVLink or PCIe where the devices reach each other's memory, else by the
/// host's; parts on one device exchange too.
class SlotExchange {
 public:
  /// What it needs to know of a part. Slots and lists must outlive the exchange.
  struct Part {
    int device;
    cudaStream_t stream;
    void* slots;
    const std::vector<SlotLists>* lists;
  };
  /// bytesPerSlot: a multiple of 16.
  SlotExchange(const std::vector<Part>& parts, std::size_t bytesPerSlot);
  ~SlotExchange();

  /// Gathers the slots that the others need behind what is in the part's stream, and copies them beside it.
  void pack(std::size_t part);
  /// Has the part's stream wait for all that the others send. After pack() of all parts.
  void await(std::size_t part);
  /// What is in the part's stream by now was the last to read what was received.
  void release(std::size_t part);

  /// Bytes that all parts send in one use.
  std::size_t bytes() const;
  /// Memory that it takes on the device of a part with these lists.
  static std::size_t bytesOnDevice(const std::vector<SlotLists>& lists, std::size_t bytesPerSlot);

 private:
  struct Copy {
    std::size_t to = 0;              // number of the other part
    std::size_t from = 0, size = 0;  // in the buffer, bytes
    void* target = nullptr;          // in the other part's slots
    DeviceStream stream;
    DeviceEvent arrived;
  };
  struct End;
  std::vector<std::unique_ptr<End>> ends_;
  std::size_t bytesPerSlot_;
};

/// Gathers rows of `bytes` bytes, a multiple of 16: to[i] = from[list[i]].
void launchPack(const void* from, const std::int32_t* list, std::int32_t count, std::size_t bytes, void* to,
                cudaStream_t stream);

}  // namespace ringwatch
