#include <ringwatch/gpu/device_status.h>

#include <cmath>

#include <ringwatch/gpu/cuda_error.h>

namespace ringwatch {

DeviceStatus deviceStatus(int device) {
  DeviceStatus status;
  int count = 0, before = 0;
  cudaDeviceProp properties{};
  cudaError_t error = cudaGetDeviceCount(&count);
  if (error == cudaSuccess && count == 0) error = cudaErrorNoDevice;
  if (error == cudaSuccess) error = cudaGetDeviceProperties(&properties, device);
  if (error == cudaSuccess) error = cudaGetDevice(&before);
  if (error == cudaSuccess) error = cudaSetDevice(device);
  if (error == cudaSuccess) {
    error = cudaMemGetInfo(&status.freeMemory, &status.totalMemory);
    cudaSetDevice(before);
  }
  if (error != cudaSuccess) {
    status.text = std::string("no GPU can be used: ") + cudaGetErrorString(error);
    return status;
  }
  status.available = true;
  status.text = properties.name;
  status.multiprocessors = properties.multiProcessorCount;
  return status;
}

int deviceCount() {
  int count = 0;
  return cudaGetDeviceCount(&count) == cudaSuccess ? count : 0;
}

void requireDevices(const std::vector<int>& devices) {
  const int count = deviceCount();
  for (const int device : devices)
    if (device < 0 || device >= count)
      throw InputError(
          joinText("GPU ", device, ": this machine has ", count, count == 1 ? " GPU" : " GPUs", ", counted from 0"));
}

void requireDeviceMemory(std::size_t bytes) {
  std::size_t free = 0, total = 0;
  checkCuda(cudaMemGetInfo(&free, &total), "cudaMemGetInfo");
  const auto mebibytes = [](std::size_t count) {
    return joinText(std::ceil(static_cast<double>(count) / 1048576.0), " MiB");
  };
  if (bytes > free)
    throw InputError(joinText("the body needs ", mebibytes(bytes), " of device memory and ", mebibytes(free), " of ",
                              mebibytes(total), " are free: use a smaller mesh, more GPUs or device = \"cpu\""));
}

}  // namespace ringwatch
