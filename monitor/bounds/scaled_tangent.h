#pragma once
#include <ringwatch/body/tangent_source.h>

namespace ringwatch {

/// 1 for a free degree of freedom, 0 for a constrained one: constrained rows and columns leave the stability problem.
RINGWATCH_INLINE double freeFactor(const TangentSource& source, std::int32_t node, int component) {
  return source.constraints().any() && source.constraints().isConstrained(node, component) ? 0.0 : 1.0;
}

/// The same where nodes are considered by themselves, with all others at rest: nodes of rigid bodies stay too, since
/// they cannot move alone.
RINGWATCH_INLINE double cutFactor(const TangentSource& source, std::int32_t node, int component) {
  return source.constraints().isTied(node) ? 0.0 : freeFactor(source, node, component);
}

/// A 3×3 block at a node without the rows and columns of its constrained components.
inline Eigen::Matrix3d freePart(const TangentSource& source, std::int32_t node, Eigen::Matrix3d S) {
  for (int c = 0; c < 3; ++c)
    if (freeFactor(source, node, c) == 0) {
      S.row(c).setZero();
      S.col(c).setZero();
    }
  return S;
}

/// K ← diag(s) K diag(s) for the elements of a batch. s: 3n packs.
RINGWATCH_INLINE void scaleSymmetric(NativePack* K, int size, const NativePack* s) {
  for (int i = 0; i < size; ++i)
    for (int j = 0; j < size; ++j) K[i * size + j] *= s[i] * s[j];
}

/// Calls set(lane, nodes) for the elements of a batch; empty lanes repeat the batch's first element.
template <class Set>
void forEachLane(const ElementTangents& block, std::int32_t batch, const Set& set) {
  const std::int32_t* elements = block.layout().elements.data() + static_cast<std::ptrdiff_t>(batch) * lanes;
  for (int lane = 0; lane < lanes; ++lane) set(lane, elements[lane] < 0 ? elements[0] : elements[lane]);
}

}  // namespace ringwatch
