#pragma once
#include <ringwatch/base/matrix3.h>

/// Who shares a piece of work on the device: a single thread or the threads of a warp. Work over many items takes those
/// of `first()`, `first() + size`, …; what the threads found is put together by the other functions, on all of them.
namespace ringwatch::detail {

struct SingleThread {
  static constexpr int size = 1;
  static __device__ __forceinline__ int first() { return 0; }
  static __device__ __forceinline__ double largest(double x) { return x; }
  static __device__ __forceinline__ double least(double x) { return x; }
  static __device__ __forceinline__ double sum(double x) { return x; }
};

/// All threads of the warp take part in every call.
struct Warp {
  static constexpr int size = 32;
  static constexpr unsigned all = 0xffffffffU;
  static __device__ __forceinline__ int first() { return static_cast<int>(threadIdx.x) % size; }
  static __device__ __forceinline__ double largest(double x) {
    return together(x, [](double a, double b) { return fmax(a, b); });
  }
  static __device__ __forceinline__ double least(double x) {
    return together(x, [](double a, double b) { return fmin(a, b); });
  }
  static __device__ __forceinline__ double sum(double x) {
    return together(x, [](double a, double b) { return a + b; });
  }

 private:
  template <class Join>
  static __device__ __forceinline__ double together(double x, const Join& join) {
#pragma unroll
    for (int offset = size / 2; offset > 0; offset /= 2) x = join(x, __shfl_xor_sync(all, x, offset));
    return x;
  }
};

}  // namespace ringwatch::detail
