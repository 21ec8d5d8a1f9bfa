#pragma once
#include <string>

#include <ringwatch/monitor/bounds/range_bound.h>

namespace ringwatch {

/// A number > 0 or a fraction of two, such as "0.02" or "1/60". Throws InputError "OPTION: …".
double parsePositiveNumber(const std::string& text, const std::string& option);
/// A range of stretches "a:b", 0 < a <= b. Throws InputError "OPTION: …".
StretchRange parseStretchRange(const std::string& text, const std::string& option);

}  // namespace ringwatch
