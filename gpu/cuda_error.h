#pragma once
#include <stdexcept>

#include <cuda_runtime_api.h>

#include <ringwatch/base/error.h>

namespace ringwatch {

/// What a CUDA call refuses at run time: a failed launch, a lost device. The text names the call and CUDA's reason.
class DeviceError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Throws DeviceError unless a CUDA call went well.
inline void checkCuda(cudaError_t status, const char* what) {
  if (status != cudaSuccess) throw DeviceError(joinText("CUDA: ", what, ": ", cudaGetErrorString(status)));
}

/// Throws DeviceError when the launch just made was refused.
inline void checkLaunch(const char* kernel) { checkCuda(cudaGetLastError(), kernel); }

}  // namespace ringwatch
