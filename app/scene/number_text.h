#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <ringwatch/monitor/bounds/range_bound.h>

namespace ringwatch {

/// A number > 0 or a fraction of two, such as "0.02" or "1/60". Throws InputError "OPTION: …".
double parsePositiveNumber(const std::string& text, const std::string& option);
/// The finite value of a number or of a fraction of two, such as 1/60; empty for another text.
std::optional<double> numberOrFraction(std::string_view text);
/// The numbers of a selection "#3,7" of nodes or elements, which `what` says. Throws InputError "origin: …".
std::vector<std::int64_t> numbersOfSelection(const std::string& selection, std::string_view what,
                                             const std::string& origin);
/// A range of stretches "a:b", 0 < a <= b. Throws InputError "OPTION: …".
StretchRange parseStretchRange(const std::string& text, const std::string& option);

}  // namespace ringwatch
