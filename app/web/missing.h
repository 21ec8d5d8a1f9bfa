#pragma once
// What Emscripten's standard library, LLVM's of version 13, lacks of C++20. Every file of the page includes it first.
#include <bit>
#include <charconv>
#include <cmath>
#include <system_error>

#include <fast_float/fast_float.h>
#include <fmt/format.h>
#include <range/v3/algorithm.hpp>

namespace std {

template <class To, class From>
constexpr To bit_cast(const From& from) {
  return __builtin_bit_cast(To, from);
}

inline from_chars_result from_chars(const char* first, const char* last, double& value) {
  double read = 0;
  const auto [stop, fault] = fast_float::from_chars(first, last, read);
  // It gives infinity or zero for what is no double, where the standard's gives a fault.
  const char* const digits = first + (first < last && *first == '-');
  const bool tooLarge = std::isinf(read) && *digits != 'i' && *digits != 'I';
  if (fault == errc() && !tooLarge) value = read;
  return {stop, tooLarge ? errc::result_out_of_range : fault};
}

inline to_chars_result to_chars(char* first, char* last, double value) {
  const auto written = fmt::format_to_n(first, last - first, "{}", value);
  return {written.out, written.size > static_cast<size_t>(last - first) ? errc::value_too_large : errc()};
}

namespace ranges {
using ::ranges::adjacent_find, ::ranges::all_of, ::ranges::any_of, ::ranges::copy, ::ranges::count, ::ranges::count_if,
    ::ranges::equal, ::ranges::find, ::ranges::find_if, ::ranges::find_if_not, ::ranges::is_permutation,
    ::ranges::lexicographical_compare, ::ranges::lower_bound, ::ranges::max_element, ::ranges::min,
    ::ranges::min_element, ::ranges::none_of, ::ranges::replace, ::ranges::sort, ::ranges::stable_sort,
    ::ranges::upper_bound;
}  // namespace ranges

}  // namespace std
