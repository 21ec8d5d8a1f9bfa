#pragma once
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include <ringwatch/gpu/cuda_error.h>

namespace ringwatch {

/// An array on the device that it frees. Contents are not initialised.
template <class T>
class DeviceVector {
 public:
  DeviceVector() = default;
  explicit DeviceVector(std::size_t size) : size_(size) {
    if (size > 0) checkCuda(cudaMalloc(reinterpret_cast<void**>(&data_), size * sizeof(T)), "cudaMalloc");
  }
  explicit DeviceVector(std::span<const T> values) : DeviceVector(values.size()) { upload(values); }
  explicit DeviceVector(const std::vector<T>& values) : DeviceVector(std::span<const T>(values)) {}
  DeviceVector(DeviceVector&& other) noexcept { swap(other); }
  DeviceVector& operator=(DeviceVector&& other) noexcept {
    swap(other);
    return *this;
  }
  DeviceVector(const DeviceVector&) = delete;
  DeviceVector& operator=(const DeviceVector&) = delete;
  ~DeviceVector() { cudaFree(data_); }

  T* data() { return data_; }
  const T* data() const { return data_; }
  std::size_t size() const { return size_; }

  /// Copies values.size() numbers from the host to the front.
  void upload(std::span<const T> values) {
    if (values.empty()) return;
    checkCuda(cudaMemcpy(data_, values.data(), values.size() * sizeof(T), cudaMemcpyHostToDevice),
              "copy to the device");
  }
  /// All of it, on the host. Waits for what the device still has to do.
  std::vector<T> download() const {
    std::vector<T> values(size_);
    if (size_ > 0)
      checkCuda(cudaMemcpy(values.data(), data_, size_ * sizeof(T), cudaMemcpyDeviceToHost), "copy from the device");
    return values;
  }
  /// Sets every byte.
  void fill(int byte) {
    if (size_ > 0) checkCuda(cudaMemset(data_, byte, size_ * sizeof(T)), "cudaMemset");
  }

 private:
  void swap(DeviceVector& other) noexcept {
    std::swap(data_, other.data_);
    std::swap(size_, other.size_);
  }
  T* data_ = nullptr;
  std::size_t size_ = 0;
};

}  // namespace ringwatch
