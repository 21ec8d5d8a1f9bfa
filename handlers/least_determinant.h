#pragma once
#include <optional>
#include <span>
#include <vector>

#include <ringwatch/body/body.h>

namespace ringwatch {

/// The least det F over some elements of a body and their quadrature points, batch by batch.
class LeastDeterminant {
 public:
  /// The body must outlive this.
  LeastDeterminant(const Body& body, std::span<const ElementRef> elements);
  /// At positions x (3×N, m), with its element, and the first that is not a number where there is one; nothing where
  /// there are no elements. Of a part of a body (body/domain.h) that of all parts, not a number where one of them is,
  /// with the element's number in the whole. Collective.
  std::optional<Body::LeastDeterminant> at(NodeVectorsView x) const;

 private:
  std::optional<Body::LeastDeterminant> here(NodeVectorsView x) const;

  const Body* body_;
  std::vector<std::vector<std::int32_t>> places_;  // in the layouts of the blocks, ascending
};

}  // namespace ringwatch
