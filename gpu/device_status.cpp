#include <ringwatch/gpu/device_status.h>

#include <cmath>

#include <ringwatch/gpu/cuda_error.h>

namespace ringwatch {

DeviceStatus deviceStatus() {
  DeviceStatus status;
  int count = 0;
  cudaDeviceProp properties{};
  cudaError_t error = cudaGetDeviceCount(&count);
  if (error == cudaSuccess && count == 0) error = cudaErrorNoDevice;
  if (error == cudaSuccess) error = cudaGetDeviceProperties(&properties, 0);
  if (error == cudaSuccess) error = cudaMemGetInfo(&status.freeMemory, &status.totalMemory);
  if (error != cudaSuccess) {
    status.text = std::string("no GPU can be used: ") + cudaGetErrorString(error);
    return status;
  }
  status.available = true;
  status.text = properties.name;
  status.multiprocessors = properties.multiProcessorCount;
  return status;
}

void requireDeviceMemory(std::size_t bytes) {
  std::size_t free = 0, total = 0;
  checkCuda(cudaMemGetInfo(&free, &total), "cudaMemGetInfo");
  const auto mebibytes = [](std::size_t count) {
    return joinText(std::ceil(static_cast<double>(count) / 1048576.0), " MiB");
  };
  if (bytes > free)
    throw InputError(joinText("the body needs ", mebibytes(bytes), " of device memory and ", mebibytes(free), " of ",
                              mebibytes(total), " are free: use a smaller mesh or device = \"cpu\""));
}

}  // namespace ringwatch
