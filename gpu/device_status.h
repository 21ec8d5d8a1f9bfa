#pragma once
#include <cstddef>
#include <string>

namespace ringwatch {

/// The GPU that this process would use.
struct DeviceStatus {
  bool available = false;
  std::string text;             // its name, or one line that says why there is none
  std::size_t freeMemory = 0;   // bytes
  std::size_t totalMemory = 0;  // bytes
  int multiprocessors = 0;
};
/// Searches for a GPU. Never throws.
DeviceStatus deviceStatus();
/// Throws InputError, with the need and what is free, unless so many bytes are free on the device.
void requireDeviceMemory(std::size_t bytes);

}  // namespace ringwatch
