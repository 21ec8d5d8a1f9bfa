#pragma once
#include <ringwatch/body/tangent_source.h>

namespace ringwatch {

/// The first element of all: the one that is named where none is more than others. {0, 0} where there is no element.
inline ElementRef firstElement(const TangentSource& source) {
  for (std::size_t b = 0; b < source.tangents().size(); ++b)
    if (source.tangents()[b]->elementCount() > 0) return {b, 0};
  return {};
}

}  // namespace ringwatch
