#pragma once
/// Marks a function that one source serves on the host and on a CUDA device. RINGWATCH_UNROLL before a loop keeps small
/// arrays that it indexes in registers there; a host compiler decides by itself.
#if defined(__CUDACC__)
#define RINGWATCH_HOST_DEVICE __host__ __device__
#define RINGWATCH_INLINE __host__ __device__ __forceinline__
#define RINGWATCH_UNROLL _Pragma("unroll")
#else
#define RINGWATCH_HOST_DEVICE
#define RINGWATCH_INLINE inline __attribute__((always_inline))
#define RINGWATCH_UNROLL
#endif
