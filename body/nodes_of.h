#pragma once
#include <span>
#include <vector>

#include <ringwatch/base/sort_unique.h>
#include <ringwatch/body/tangent_source.h>

namespace ringwatch {

/// The nodes of some elements, ascending.
inline std::vector<std::int32_t> nodesOfElements(const TangentSource& source, std::span<const ElementRef> elements) {
  std::vector<std::int32_t> nodes;
  for (const ElementRef e : elements) {
    const auto own = source.tangents()[e.block]->nodesOf(e.element);
    nodes.insert(nodes.end(), own.begin(), own.end());
  }
  sortUnique(nodes);
  return nodes;
}

}  // namespace ringwatch
