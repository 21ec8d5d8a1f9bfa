#pragma once
#include <algorithm>
#include <cstring>

#include <ringwatch/base/double_double.h>
#include <ringwatch/body/element_block.h>

namespace ringwatch {

/// Nodal vectors of the elements of a block, n nodes each, in packs: a lane an element. They are edges: each node's
/// less that of the first node.
template <int n>
class ElementNodes {
 public:
  using P = NativePack;

  /// Keeps the block by reference.
  explicit ElementNodes(const ElementBlock& block) : block_(block) {}

  /// Edges of the elements of a batch, from the rows of its patch.
  RINGWATCH_INLINE void loadEdges(const double* rows, std::int32_t batch, P (&out)[n][3]) const {
    const std::uint16_t* local = localNodes(batch);
    for (int a = 0; a < n; ++a) loadRows(rows, local + a * lanes, out[a]);
    subtractFirst(out);
  }
  /// Edges of any elements, one a lane, from the nodes of the mesh; lanes without an element (-1) repeat the first.
  [[gnu::noinline]] void loadEdgesFromMesh(const double* x, const std::int32_t* elements, P (&out)[n][3]) const {
    alignas(64) double rows[4 * n * lanes];
    std::uint16_t local[n * lanes];
    for (int lane = 0; lane < lanes; ++lane) {
      const auto nodes = block_.nodesOf(elements[lane] < 0 ? elements[0] : elements[lane]);
      for (int a = 0; a < n; ++a) {
        const int row = a * lanes + lane;
        const double* from = x + 3 * static_cast<std::ptrdiff_t>(nodes[a]);
        const detail::Row4 padded{from[0], from[1], from[2], 0.0};
        std::memcpy(rows + 4 * row, &padded, sizeof padded);
        local[row] = static_cast<std::uint16_t>(row);
      }
    }
    for (int a = 0; a < n; ++a) loadRows(rows, local + a * lanes, out[a]);
    subtractFirst(out);
  }
  /// Edges of the elements of a batch in twice the precision, exact.
  [[gnu::noinline]] void loadWideEdges(const NodeVectors& X, std::int32_t batch, DoubleDouble<P> (&out)[n][3]) const {
    for (int a = 0; a < n; ++a)
      for (int i = 0; i < 3; ++i) {
        P own, first;
        for (int lane = 0; lane < lanes; ++lane) {
          const std::int32_t e = elementsOf(batch)[lane] < 0 ? elementsOf(batch)[0] : elementsOf(batch)[lane];
          own.set(lane, X(i, block_.nodesOf(e)[a]));
          first.set(lane, X(i, block_.nodesOf(e)[0]));
        }
        out[a][i] = DoubleDouble<P>::sum(own, -first);
      }
  }
  /// Adds values at the nodes of a batch into the slots of its patch.
  RINGWATCH_INLINE void addToSlots(double* slots, std::int32_t batch, const P (&values)[n][3]) const {
    const std::uint16_t* local = localNodes(batch);
    for (int a = 0; a < n; ++a) addRows(slots, local + a * lanes, values[a]);
  }
  /// A batch whose geometry to ask memory for while this one is computed: that takes about as long as two batches, and
  /// the processor does not see it coming by itself in passes of many streams.
  std::int32_t ahead(std::int32_t batch) const { return std::min(batch + 2, block_.layout().batchCount() - 1); }
  template <int count>
  RINGWATCH_INLINE static void prefetch(const P* packs) {
    RINGWATCH_UNROLL
    for (int i = 0; i < count; ++i) __builtin_prefetch(packs + i);
  }
  /// The elements of a batch, -1 in lanes without one.
  const std::int32_t* elementsOf(std::int32_t batch) const {
    return block_.layout().elements.data() + static_cast<std::ptrdiff_t>(batch) * lanes;
  }

  /// Rows of the elements' nodes in their patch, [a][lane].
  const std::uint16_t* localNodes(std::int32_t batch) const {
    return block_.layout().localNodes.data() + static_cast<std::ptrdiff_t>(batch) * n * lanes;
  }

 protected:
  const ElementBlock& block() const { return block_; }

 private:
  RINGWATCH_INLINE static void subtractFirst(P (&x)[n][3]) {
    for (int a = 1; a < n; ++a)
      for (int i = 0; i < 3; ++i) x[a][i] -= x[0][i];
    for (int i = 0; i < 3; ++i) x[0][i] = P(0.0);
  }

  const ElementBlock& block_;
};

}  // namespace ringwatch
