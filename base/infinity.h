#pragma once
#include <limits>

namespace ringwatch {

inline constexpr double infinity = std::numeric_limits<double>::infinity();

}  // namespace ringwatch
