#include <ringwatch/gpu/body/slot_exchange.h>

namespace ringwatch {
namespace {

constexpr int threads = 256;

__global__ void __launch_bounds__(threads)
    packKernel(const uint4* from, const std::int32_t* list, std::size_t count, int units, uint4* to) {
  const std::size_t i = static_cast<std::size_t>(blockIdx.x) * threads + threadIdx.x;
  const std::size_t row = i / static_cast<std::size_t>(units), unit = i % static_cast<std::size_t>(units);
  if (row < count) to[i] = from[static_cast<std::size_t>(list[row]) * static_cast<std::size_t>(units) + unit];
}

}  // namespace

void launchPack(const void* from, const std::int32_t* list, std::int32_t count, std::size_t bytes, void* to,
                cudaStream_t stream) {
  if (count == 0) return;
  const auto units = static_cast<int>(bytes / sizeof(uint4));
  const std::size_t all = static_cast<std::size_t>(count) * static_cast<std::size_t>(units);
  packKernel<<<static_cast<unsigned>((all + threads - 1) / threads), threads, 0, stream>>>(
      static_cast<const uint4*>(from), list, static_cast<std::size_t>(count), units, static_cast<uint4*>(to));
  checkLaunch("gathering of slots");
}

}  // namespace ringwatch
