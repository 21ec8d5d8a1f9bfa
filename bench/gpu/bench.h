#pragma once
#include <cstdint>
#include <functional>
#include <string>

namespace ringwatch::bench {

double seconds();
/// Median time of one repetition, s. repeat(k) puts k repetitions into the device's queue, wait() waits for them.
double timeOf(const std::function<void(std::int64_t)>& repeat, const std::function<void()>& wait);
/// Steps with 5 % of a million tetrahedra implicit, on the device and on two threads of the CPU, for cases whose names
/// contain `filter`.
void measureImex(const std::string& filter);

}  // namespace ringwatch::bench
