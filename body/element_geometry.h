#pragma once
#include <algorithm>

#include <ringwatch/body/element_nodes.h>
#include <ringwatch/body/element_operators.h>
#include <ringwatch/elements/registry.h>

namespace ringwatch {

/// What the elements of a block are before any law: where their nodes lie in patches and mesh, and at each quadrature
/// point the inverse Jacobian J⁻¹ and the weight w det(J). In packs, a lane an element.
///
/// Functions that are not inline are compiled once for each element type: element_geometry_functions.h.
template <class Element>
class ElementGeometry : public ElementNodes<Element::nodes> {
 public:
  using P = NativePack;
  using Operators = ElementOperators<Element, P>;
  static constexpr int n = Element::nodes;
  /// Numbers stored for a point: J⁻¹ row by row, w det(J), which is zero in lanes without an element.
  static constexpr int stride = 10;
  static constexpr std::size_t maxPoints = [] {
    std::size_t most = 1;
    for (const QuadratureRule& rule : Element::rules) most = std::max(most, rule.points.size());
    return most;
  }();
  /// Whether some rule treats a share of the law at the mean deformation gradient (LameShares).
  static constexpr bool offersMean = [] {
    for (const QuadratureRule& rule : Element::rules)
      if (rule.shares.mean()) return true;
    return false;
  }();
  static_assert(!Element::constantGradient || std::ranges::all_of(Element::rules, [](const QuadratureRule& rule) {
    return rule.points.size() == 1;
  }));

  /// Throws NumericalError when a Jacobian determinant is not positive. Keeps the block by reference.
  ElementGeometry(const ElementBlock& block, const Mesh& mesh, const MeshBlock& meshBlock)
      : ElementNodes<n>(block),
        points_(static_cast<int>(block.rule().points.size())),
        hasMean_(block.rule().shares.mean()) {
    if constexpr (offersDirections) hasDirections_ = haveDirections<typename Element::Directions>(block.rule());
    fill(mesh, meshBlock);
  }
  /// The constructor's work, which is compiled once an element (element_geometry.cpp): a constructor has no address
  /// that would make every compiler emit all its variants there.
  [[gnu::noinline]] void fill(const Mesh& mesh, const MeshBlock& meshBlock);

  /// Known at compile time for elements of constant gradient: the loop over points goes, and the sums stay in
  /// registers.
  RINGWATCH_INLINE int pointCount() const { return Element::constantGradient ? 1 : points_; }
  /// Of the first point of a batch; the others follow.
  const P* pointsOf(std::int32_t batch) const {
    return geometry_.data() + static_cast<std::ptrdiff_t>(batch) * points_ * stride;
  }
  RINGWATCH_INLINE static Matrix3<P> inverseJacobian(const P* point) {
    Matrix3<P> r;
    for (int i = 0; i < 9; ++i) r.m[i] = point[i];
    return r;
  }
  RINGWATCH_INLINE static const P& weight(const P* point) { return point[9]; }
  /// ∂N_a/∂ξ_j at a point, [a][j].
  const double (*shapeTable(int q) const)[3] {
    return reinterpret_cast<const double(*)[3]>(shapeGradients_.data() + static_cast<std::ptrdiff_t>(q) * n * 3);
  }
  /// Σ_a u_a ⊗ ∂N_a/∂ξ of edges u, from the tables.
  class Field {
   public:
    RINGWATCH_INLINE Field(const ElementGeometry& geometry, const P (&edges)[n][3])
        : geometry_(geometry), edges_(edges) {}
    RINGWATCH_INLINE Matrix3<P> operator()(int q) const {
      return Operators::naturalGradient([&](int a, int i) { return edges_[a][i]; }, geometry_.shapeTable(q));
    }

   private:
    const ElementGeometry& geometry_;
    const P (&edges_)[n][3];
  };
  /// Deformation gradient (or gradient of any nodal vectors) at a point.
  RINGWATCH_INLINE Matrix3<P> gradient(const P (&edges)[n][3], int q, const Matrix3<P>& inverseJacobianHere) const {
    return Field(*this, edges)(q) * inverseJacobianHere;
  }

  /// Norm of ∂N/∂ξ at a point, over all nodes.
  double tableNorm(int q) const { return tableNorm_[q]; }
  /// (Σ_a |X_a - X_0|²)^½ of the elements of a batch, m; one in lanes without an element.
  const P& extentOf(std::int32_t batch) const { return extents_[batch]; }
  /// The same of any elements, one a lane; lanes without an element (-1) repeat the first.
  P gatherExtents(const std::int32_t* elements) const;

  bool hasMean() const { return hasMean_; }
  /// Whether the element's operators can go one direction after the other, and whether they can at this rule's points
  /// (elements/directions.h).
  static constexpr bool offersDirections = requires { typename Element::Directions; };
  bool hasDirections() const { return hasDirections_; }
  /// Mean gradients ∂N_a/∂X of the elements of a batch, row by row, then their volume.
  const P* meanGradientsOf(std::int32_t batch) const {
    return meanGradients_.data() + static_cast<std::ptrdiff_t>(batch) * (3 * n + 1);
  }
  /// The same of elements whose points were gathered.
  void meanGradients(const P* points, P* g) const;
  RINGWATCH_INLINE static Matrix3<P> meanGradient(const P (&edges)[n][3], const P* g) {
    Matrix3<P> r = Matrix3<P>::zero();
    for (int a = 1; a < n; ++a)
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) r(i, j) += edges[a][i] * g[3 * a + j];
    return r;
  }
  RINGWATCH_INLINE static void addMeanForces(const Matrix3<P>& T, const P* g, P (&force)[n][3]) {
    for (int a = 0; a < n; ++a)
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) force[a][i] += T(i, j) * g[3 * a + j];
  }

  /// Points of any elements, one a lane, maxPoints * stride numbers; lanes without an element (-1) repeat the first and
  /// weigh nothing.
  void gatherPoints(const std::int32_t* elements, P* points) const;

  /// See the functions of the same names in ElementBlock.
  void laplacianOf(const std::int32_t* elements, double* L, double* rounding) const;
  void minimumDeterminantBatch(std::int32_t batch, const double* x, double* determinants) const;
  void volumeBatch(std::int32_t batch, double* volumes) const;

 private:
  int points_;
  bool hasMean_;
  bool hasDirections_ = false;
  std::vector<double> shapeGradients_;  // [q][a][j]
  std::vector<double> tableNorm_;       // [q]
  AlignedVector<P> extents_;            // [batch]
  AlignedVector<P> geometry_;           // [batch][q][stride]
  AlignedVector<P> meanGradients_;      // [batch][3n + 1]; empty without a mean share
};

}  // namespace ringwatch
