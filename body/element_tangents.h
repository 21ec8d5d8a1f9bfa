#pragma once
#include <cstdint>
#include <span>
#include <utility>

#include <ringwatch/body/patch_layout.h>

namespace ringwatch {

/// Elements of one number of nodes, known by their tangents alone: symmetric matrices, three degrees of freedom a node.
/// One virtual call a patch or batch, never an element. x: the state at which tangents are wanted, of a body its
/// positions (3×N, m, column by column); tangents that are given as numbers do not read it.
class ElementTangents {
 public:
  virtual ~ElementTangents() = default;
  ElementTangents(const ElementTangents&) = delete;
  ElementTangents& operator=(const ElementTangents&) = delete;

  int nodesPerElement() const { return nodesPerElement_; }
  const PatchLayout& layout() const { return layout_; }
  std::int32_t elementCount() const { return static_cast<std::int32_t>(layout_.batchOfElement.size()); }
  /// Nodes of an element.
  std::span<const std::int32_t> nodesOf(std::int32_t e) const {
    const std::size_t n = nodesPerElement_;
    return {connectivity_.data() + static_cast<std::size_t>(e) * n, n};
  }

  /// Copies the nodes of a patch from a 3×N vector into rows of four numbers, the last one zero: rows[4 * nodes].
  void gatherRows(const Patch& patch, const double* x, double* rows) const {
    const std::int32_t* nodes = layout_.nodes.data() + patch.nodeBegin;
    const int count = patch.nodeEnd - patch.nodeBegin;
    for (int i = 0; i < count; ++i) {
      const double* from = x + 3 * static_cast<std::ptrdiff_t>(nodes[i]);
      for (int c = 0; c < 3; ++c) rows[4 * i + c] = from[c];
      rows[4 * i + 3] = 0;
    }
  }

  /// Exact tangents of the elements of a batch: K[(row * 3n + column) * lanes + lane], rows and columns 3·node +
  /// component, N/m. Lanes without an element get zeros.
  /// rounding: unless nullptr, numbers T_a of the elements' nodes, T[a * lanes + lane], N/m: the blocks of what is
  /// computed err by at most √(T_a T_b) (Theorem 42, docs/theory/floating_point.md).
  virtual void tangentBatch(std::int32_t batch, const double* x, double* K, double* rounding) const = 0;
  /// Exact tangents of any elements, one a lane (-1: none), as tangentBatch gives them.
  virtual void tangentOf(const std::int32_t* elements, const double* x, double* K, double* rounding) const = 0;
  void tangentBatch(std::int32_t batch, const double* x, double* K) const { tangentBatch(batch, x, K, nullptr); }
  void tangentOf(const std::int32_t* elements, const double* x, double* K) const { tangentOf(elements, x, K, nullptr); }
  /// Adds the T_a of the elements of a patch into the first number of its slots, without their tangents.
  virtual void addTangentRounding(const Patch& patch, const double* x, double* slots) const = 0;
  /// Adds K(x) v of the elements of a patch into its slots; v: 3×N.
  virtual void addTangentProduct(const Patch& patch, const double* x, const double* v, double* slots) const = 0;

 protected:
  /// connectivity: by reference.
  ElementTangents(int nodesPerElement, PatchLayout layout, std::span<const std::int32_t> connectivity)
      : nodesPerElement_(nodesPerElement), layout_(std::move(layout)), connectivity_(connectivity) {}

 private:
  int nodesPerElement_;
  PatchLayout layout_;
  std::span<const std::int32_t> connectivity_;
};

}  // namespace ringwatch
