#pragma once
#include <ctime>

namespace ringwatch {

/// Seconds that this program has computed so far: what other programs take meanwhile does not count. Times are reported
/// for information; no criterion of a study rests on one.
inline double processorSeconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

}  // namespace ringwatch
