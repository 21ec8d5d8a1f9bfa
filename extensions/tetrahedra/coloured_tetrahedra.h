#pragma once
#include <array>
#include <cstdint>
#include <cstring>
#include <vector>

#include <ringwatch/base/aligned.h>
#include <ringwatch/base/matrix3.h>
#include <ringwatch/base/parallel.h>
#include <ringwatch/body/body.h>

namespace ringwatch {

/// Tetrahedra that move their predicted nodes x* = x + h (v + h a) element by element, in batches of elements without
/// common nodes: a SIMD lane an element. Batches of a colour have no common nodes either, so threads share them, and
/// the order of the visits, colour by colour, does not depend on their number.
class ColouredTetrahedra {
 public:
  using P = NativePack;
  static constexpr int lanes = P::width;

  /// elements: of type tet4. h: s. Masses and constraints are those of the body now; it must outlive this.
  ColouredTetrahedra(const Body& body, const std::vector<ElementRef>& elements, double h);

  std::int32_t batchCount() const { return colourBegin_.back(); }
  /// batch · lanes + lane of an element, by its position in the list given.
  std::int32_t placeOf(std::size_t element) const { return place_[element]; }
  /// Nodes of the elements, ascending.
  const std::vector<std::int32_t>& nodes() const { return nodes_; }
  int largestOverlap() const { return largestOverlap_; }  ///< the most elements at a node

  /// Sets the nodes to positions x (3×N, m) with velocities v (m/s) and accelerations a (m/s²).
  void start(const NodeVectors& x, const NodeVectors& v, const NodeVectors& a);
  /// Adds to a what the visits have added since; constrained components stay. False when a result is not finite.
  bool finish(const NodeVectors& v, NodeVectors& a) const;
  /// What visits add is seen by none of them: the elements move all at once. Until the next start.
  void keepApart() { apart_ = rows_; }

  /// Calls visit(batch) for all batches, colour by colour, or in the reverse order.
  template <class Visit>
  void sweep(bool forward, const Visit& visit) const {
    constexpr std::int64_t grain = 32;  // fewer are not worth a thread
    const auto colours = static_cast<std::int32_t>(colourBegin_.size()) - 1;
    for (std::int32_t i = 0; i < colours; ++i) {
      const std::size_t c = forward ? i : colours - 1 - i;
      parallelFor(
          colourBegin_[c], colourBegin_[c + 1], body_.threads(), [&](std::int64_t batch) { visit(batch); }, grain);
    }
  }

  /// Passes forward and back over the elements by members of a relaxation: `first` is the first sweep, `last` the last
  /// one, `inner` all between.
  template <class Relaxation>
  void sweepInPasses(Relaxation& relaxation, int passes, void (Relaxation::*first)(std::int32_t),
                     void (Relaxation::*inner)(std::int32_t), void (Relaxation::*last)(std::int32_t)) const {
    for (int k = 0; k < 2 * passes; ++k) {
      const auto visit = k == 0 ? first : k + 1 == 2 * passes ? last : inner;
      sweep(k % 2 == 0, [&](std::int32_t batch) { (relaxation.*visit)(batch); });
    }
  }

  /// The nodes of a batch. A missing element has its nodes at the origin and at the unit vectors, with 1/m = 0: with
  /// unit vectors for its gradients, F = I.
  struct Nodes {
    P x[4][4];  // m; 1/m (1/kg), 0 at fixed nodes
    P q[4][3];  // v/h + a, m/s²
  };
  RINGWATCH_INLINE void load(std::int32_t batch, Nodes& nodes) const {
    for (int n = 0; n < 4; ++n) loadRow(rows_.data(), rowsOf(batch, n), nodes.x[n], nodes.q[n]);
  }
  /// Deformation gradients at x and, F, at x*, with gradients ∂N_a/∂X of nodes 1 to 3.
  RINGWATCH_INLINE void gradients(const Nodes& nodes, const P (&g)[3][3], Matrix3<P>& F0, Matrix3<P>& F) const {
    F0 = F = Matrix3<P>::zero();
    for (int n = 1; n < 4; ++n)
      for (int i = 0; i < 3; ++i) {
        const P start = nodes.x[n][i] - nodes.x[0][i], predicted = start + P(square_) * (nodes.q[n][i] - nodes.q[0][i]);
        for (int j = 0; j < 3; ++j) {
          F0(i, j) += start * g[n - 1][j];
          F(i, j) += predicted * g[n - 1][j];
        }
      }
  }
  /// Adds the accelerations f/m by the forces f_a = -T ∂N_a/∂X, T a stress times the volume, N·m. nodes are
  /// overwritten.
  RINGWATCH_INLINE void push(std::int32_t batch, Nodes& nodes, const P (&g)[3][3], const Matrix3<P>& T) {
    P f[4][3];
    for (int i = 0; i < 3; ++i) f[0][i] = P(0.0);
    for (int n = 1; n < 4; ++n)
      for (int i = 0; i < 3; ++i) {
        const P pull = T(i, 0) * g[n - 1][0] + T(i, 1) * g[n - 1][1] + T(i, 2) * g[n - 1][2];
        f[0][i] += pull;
        f[n][i] = -pull;
      }
    for (int n = 0; n < 4; ++n)
      for (int i = 0; i < 3; ++i) f[n][i] *= nodes.x[n][3];
    const std::int32_t freeAt = freeOf_[batch];
    if (freeAt >= 0) {
      const Free& free = free_[freeAt];
      for (std::size_t n = 0; n < 4; ++n)
        for (std::size_t i = 0; i < 3; ++i) f[n][i] *= free[3 * n + i];
    }
    double* rows = (apart_.empty() ? rows_ : apart_).data();
    for (int n = 0; n < 4; ++n) {
      if (!apart_.empty()) loadRow(rows, rowsOf(batch, n), nodes.x[n], nodes.q[n]);
      for (int i = 0; i < 3; ++i) nodes.q[n][i] += f[n][i];
      storeRow(rows, rowsOf(batch, n), nodes.q[n]);
    }
  }

 private:
  using Free = std::array<P, 12>;  // 1, or 0 where a component of a node is constrained
  static constexpr std::ptrdiff_t rowSize = 8;

  void colour(const std::vector<ElementRef>& elements);
  const std::int32_t* rowsOf(std::int32_t batch, int node) const {
    return row_.data() + (4 * static_cast<std::ptrdiff_t>(batch) + node) * lanes;
  }
  /// Rows of a node of each lane. A template, as storeRow is, so that packs of other widths do not meet the branch for
  /// eight.
  template <class Pack>
  RINGWATCH_INLINE static void loadRow(const double* rows, const std::int32_t* row, Pack (&x)[4], Pack (&q)[3]) {
    if constexpr (Pack::width == 8) {
      typename Pack::Values v[8];
      for (int lane = 0; lane < 8; ++lane) std::memcpy(&v[lane], rows + rowSize * row[lane], sizeof v[lane]);
      detail::transpose8(v);
      for (int k = 0; k < 4; ++k) x[k].v = v[k];
      for (int k = 0; k < 3; ++k) q[k].v = v[k + 4];
    } else {
      for (int lane = 0; lane < Pack::width; ++lane) {
        const double* from = rows + rowSize * row[lane];
        for (int k = 0; k < 4; ++k) x[k].set(lane, from[k]);
        for (int k = 0; k < 3; ++k) q[k].set(lane, from[k + 4]);
      }
    }
  }
  /// Lanes without an element, of the last batch of a colour alone, share rows, where they write zeros.
  template <class Pack>
  RINGWATCH_INLINE static void storeRow(double* rows, const std::int32_t* row, const Pack (&q)[3]) {
    if constexpr (Pack::width == 8) {
      const auto four = [&](int first, auto half) {
        const detail::Row4 x = half(q[0].v), y = half(q[1].v), z = half(q[2].v), zero{};
        const detail::Row4 t0 = __builtin_shufflevector(x, y, 0, 4, 2, 6),
                           t1 = __builtin_shufflevector(x, y, 1, 5, 3, 7);
        const detail::Row4 t2 = __builtin_shufflevector(z, zero, 0, 4, 2, 6),
                           t3 = __builtin_shufflevector(z, zero, 1, 5, 3, 7);
        const detail::Row4 r[4] = {
            __builtin_shufflevector(t0, t2, 0, 1, 4, 5), __builtin_shufflevector(t1, t3, 0, 1, 4, 5),
            __builtin_shufflevector(t0, t2, 2, 3, 6, 7), __builtin_shufflevector(t1, t3, 2, 3, 6, 7)};
        for (int i = 0; i < 4; ++i) std::memcpy(rows + rowSize * row[first + i] + 4, &r[i], sizeof r[i]);
      };
      four(0, [](auto v) { return __builtin_shufflevector(v, v, 0, 1, 2, 3); });
      four(4, [](auto v) { return __builtin_shufflevector(v, v, 4, 5, 6, 7); });
    } else {
      for (int lane = 0; lane < Pack::width; ++lane)
        for (int k = 0; k < 3; ++k) rows[rowSize * row[lane] + 4 + k] = q[k][lane];
    }
  }

  const Body& body_;
  double h_, square_;                      // s, s²
  std::vector<std::int32_t> colourBegin_;  // first batch of each colour, and the end
  std::vector<std::int32_t> place_, nodes_;
  std::vector<std::int32_t> row_;     // [batch][node][lane]
  std::vector<std::int32_t> freeOf_;  // [batch]: place in free_; -1 where nodes are free or fixed in all components
  AlignedVector<Free> free_;
  AlignedVector<double> rows_;   // of each node: x, 1/m; v/h + a, 0. Four more for missing elements
  AlignedVector<double> apart_;  // the rows to write where they are not the same
  int largestOverlap_ = 0;
};

/// A tetrahedron at rest, its axes those of H = Σ ∂N_a ∂N_aᵀ/m_a.
struct PrincipalTetrahedron {
  Eigen::Matrix<double, 3, 4> gradient;  // ∂N_a/∂X in the axes of H, 1/m
  Eigen::Vector3d eta;                   // of H, ascending, 1/(kg m²)
  Eigen::Matrix3d axes;                  // a rotation: X = axes · (in the axes of H)
  double volume;                         // m³
};
/// X: 3×N, m. inverseMass: 1/m_a of the four nodes, 1/kg.
PrincipalTetrahedron principalTetrahedron(const NodeVectors& X, std::span<const std::int32_t> nodes,
                                          const Eigen::Vector4d& inverseMass);

}  // namespace ringwatch
