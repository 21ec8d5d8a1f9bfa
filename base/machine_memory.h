#pragma once
#include <unistd.h>

#include <cstdint>
#include <limits>

namespace ringwatch {

/// Memory of the machine, bytes; the largest number where the system does not say.
inline std::uintmax_t machineMemory() {
  const long pages = ::sysconf(_SC_PHYS_PAGES), bytes = ::sysconf(_SC_PAGESIZE);
  return pages > 0 && bytes > 0 ? static_cast<std::uintmax_t>(pages) * static_cast<std::uintmax_t>(bytes)
                                : std::numeric_limits<std::uintmax_t>::max();
}

}  // namespace ringwatch
