#pragma once
/// Marks a function that one source serves on the host and on a CUDA device.
#if defined(__CUDACC__)
#define RINGWATCH_HOST_DEVICE __host__ __device__
#define RINGWATCH_INLINE __host__ __device__ __forceinline__
#else
#define RINGWATCH_HOST_DEVICE
#define RINGWATCH_INLINE inline __attribute__((always_inline))
#endif
