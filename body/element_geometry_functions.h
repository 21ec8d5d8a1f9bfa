#pragma once
#include <ringwatch/base/error.h>
#include <ringwatch/body/element_geometry.h>
#include <ringwatch/body/tangent_rounding.h>

/// The functions of ElementGeometry that are not inline: for element_geometry.cpp, which compiles them for the elements
/// of the library, and for elements that a program registers.
namespace ringwatch {

template <class Element>
void ElementGeometry<Element>::fill(const Mesh& mesh, const MeshBlock& meshBlock) {
  const ElementBlock& block = this->block();
  const QuadratureRule& rule = block.rule();
  shapeGradients_.resize(points_ * n * 3);
  tableNorm_.resize(points_);
  for (int q = 0; q < points_; ++q) {
    double* table = shapeGradients_.data() + static_cast<std::ptrdiff_t>(q) * n * 3;
    Element::shapeGradient(rule.points[q].xi, reinterpret_cast<double(*)[3]>(table));
    double sum = 0;
    for (int i = 0; i < 3 * n; ++i) sum += table[i] * table[i];
    tableNorm_[q] = std::sqrt(sum);
  }
  const std::int32_t batches = block.layout().batchCount();
  geometry_.resize(static_cast<std::size_t>(batches) * static_cast<std::size_t>(points_) * stride);
  extents_.resize(batches);
  // In twice the precision: determinants of flat elements cancel, and what is stored here serves every step.
  using Wide = DoubleDouble<P>;
  for (std::int32_t batch = 0; batch < batches; ++batch) {
    Wide X[n][3];
    this->loadWideEdges(mesh.X, batch, X);
    P extent2(0.0);
    for (const auto& edge : X)
      for (const Wide& entry : edge) extent2 += entry.high * entry.high;
    extents_[batch] = math::sqrt(extent2);
    P* point = geometry_.data() + static_cast<std::ptrdiff_t>(batch) * points_ * stride;
    for (int q = 0; q < pointCount(); ++q, point += stride) {
      const Matrix3<Wide> J =
          ElementOperators<Element, Wide>::naturalGradient([&](int a, int i) { return X[a][i]; }, shapeTable(q));
      const P det = determinant(J).rounded();
      const Matrix3<Wide> J1 = inverse(J);
      for (int i = 0; i < 9; ++i) point[i] = J1.m[i].rounded();
      for (int lane = 0; lane < lanes; ++lane) {
        const std::int32_t e = this->elementsOf(batch)[lane];
        if (e >= 0 && !(det[lane] > 0))
          throw NumericalError(joinText(Element::name, " element ", meshBlock.id(e), ": Jacobian determinant ",
                                        det[lane], " at quadrature point ", q, " must be > 0"));
        point[9].set(lane, e < 0 ? 0.0 : det[lane] * rule.points[q].weight);
      }
    }
  }
  if (!hasMean_) return;
  meanGradients_.resize(static_cast<std::size_t>(batches) * (3 * n + 1));
  for (std::int32_t batch = 0; batch < batches; ++batch)
    meanGradients(pointsOf(batch), meanGradients_.data() + static_cast<std::size_t>(batch) * (3 * n + 1));
}

template <class Element>
void ElementGeometry<Element>::meanGradients(const P* point, P* g) const {
  for (int i = 0; i <= 3 * n; ++i) g[i] = P(0.0);
  for (int q = 0; q < points_; ++q, point += stride) {
    P own[n][3];
    Operators::shapeGradients(inverseJacobian(point), shapeTable(q), own);
    for (int i = 0; i < 3 * n; ++i) g[i] += weight(point) * own[i / 3][i % 3];
    g[3 * n] += weight(point);
  }
  // Lanes without an element have no volume; they repeat the first lane's gradients, as positions do.
  const auto present = g[3 * n] > P(0.0);
  const P inverse = P(1.0) / select(present, g[3 * n], P(1.0));
  for (int i = 0; i < 3 * n; ++i) {
    const P own = g[i] * inverse;
    g[i] = select(present, own, P(own[0]));
  }
}

template <class Element>
void ElementGeometry<Element>::gatherPoints(const std::int32_t* elements, P* points) const {
  const int count = pointCount() * stride;
  for (int lane = 0; lane < lanes; ++lane) {
    const std::int32_t e = elements[lane] < 0 ? elements[0] : elements[lane];
    const std::int32_t place = this->block().layout().batchOfElement[e];
    const P* from = pointsOf(place / lanes);
    for (int i = 0; i < count; ++i) points[i].set(lane, from[i][place % lanes]);
    if (elements[lane] < 0)
      for (int q = 0; q < pointCount(); ++q) points[stride * q + 9].set(lane, 0.0);
  }
}

template <class Element>
typename ElementGeometry<Element>::P ElementGeometry<Element>::gatherExtents(const std::int32_t* elements) const {
  P extents;
  for (int lane = 0; lane < lanes; ++lane) {
    const std::int32_t place = this->block().layout().batchOfElement[elements[lane] < 0 ? elements[0] : elements[lane]];
    extents.set(lane, extents_[place / lanes][place % lanes]);
  }
  return extents;
}

template <class Element>
void ElementGeometry<Element>::laplacianOf(const std::int32_t* elements, double* L, double* rounding) const {
  P gathered[stride * maxPoints];
  gatherPoints(elements, gathered);
  P* l = reinterpret_cast<P*>(L);
  P* T = reinterpret_cast<P*>(rounding);
  for (int i = 0; i < n * n; ++i) l[i] = P(0.0);
  for (int a = 0; a < n; ++a) T[a] = P(0.0);
  const TangentRounding<Element, P> budget(P(0.0), gatherExtents(elements));
  const P* point = gathered;
  for (int q = 0; q < pointCount(); ++q, point += stride) {
    P g[n][3];
    const Matrix3<P> J1 = inverseJacobian(point);
    Operators::shapeGradients(J1, shapeTable(q), g);
    Operators::addLaplacian(weight(point), g, [&](int a, int b, const P& value) { l[a * n + b] += value; });
    budget.addPoint({P(1.0), P(0.0)}, math::sqrt(innerProduct(J1, J1)), tableNorm(q), weight(point), g, T);
  }
  for (int a = 0; a < n; ++a)
    for (int b = 0; b < a; ++b) l[b * n + a] = l[a * n + b];
}

template <class Element>
void ElementGeometry<Element>::minimumDeterminantBatch(std::int32_t batch, const double* x,
                                                       double* determinants) const {
  P edges[n][3];
  this->loadEdgesFromMesh(x, this->elementsOf(batch), edges);
  const P* point = pointsOf(batch);
  P least(0.0);
  for (int q = 0; q < pointCount(); ++q, point += stride) {
    const P d = determinant(gradient(edges, q, inverseJacobian(point)));
    least = q == 0 ? d : math::min(least, d);
  }
  if constexpr (offersMean)
    if (hasMean_) least = math::min(least, determinant(meanGradient(edges, meanGradientsOf(batch))));
  least.store(determinants);
}

template <class Element>
void ElementGeometry<Element>::volumeBatch(std::int32_t batch, double* volumes) const {
  P sum(0.0);
  for (int q = 0; q < points_; ++q) sum += weight(pointsOf(batch) + stride * q);
  sum.store(volumes);
}

}  // namespace ringwatch
