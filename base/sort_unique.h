#pragma once
#include <algorithm>
#include <vector>

namespace ringwatch {

/// Sorts the values and leaves one of each.
template <class T>
void sortUnique(std::vector<T>& values) {
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
}

}  // namespace ringwatch
