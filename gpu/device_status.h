#pragma once
#include <cstddef>
#include <string>
#include <vector>

namespace ringwatch {

/// A GPU of this machine.
struct DeviceStatus {
  bool available = false;
  std::string text;             // its name, or one line that says why there is none
  std::size_t freeMemory = 0;   // bytes
  std::size_t totalMemory = 0;  // bytes
  int multiprocessors = 0;
};
/// Searches for a GPU, by its number. Never throws.
DeviceStatus deviceStatus(int device = 0);
/// How many there are.
int deviceCount();
/// Throws InputError unless all these numbers are those of GPUs.
void requireDevices(const std::vector<int>& devices);
/// Throws InputError, with the need and what is free, unless so many bytes are free on the current device.
void requireDeviceMemory(std::size_t bytes);

}  // namespace ringwatch
