#include <ringwatch/monitor/element_cause.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include <Eigen/LU>
#include <Eigen/SVD>

#include <ringwatch/base/error.h>
#include <ringwatch/base/infinity.h>
#include <ringwatch/base/number_format.h>
#include <ringwatch/body/domain.h>
#include <ringwatch/meshes/jacobian.h>
#include <ringwatch/monitor/element_strain.h>

namespace ringwatch {
namespace {

/// element: of the part.
ElementCause causeHere(const Body& body, NodeVectorsView x, ElementRef element, double meanVolume) {
  const Mesh& mesh = body.mesh();
  const NodeVectors& X = mesh.X;
  const std::size_t b = element.block;
  const ElementBlock& block = *body.blocks()[b];
  const auto nodes = block.nodesOf(element.element);
  ElementCause cause;
  cause.leastDeterminant = infinity;
  double dN[maxElementNodes][3];
  for (const QuadraturePoint& point : block.rule().points) {
    block.element().shapeGradient(point.xi, dN);
    const int n = block.element().nodes;
    const Eigen::Matrix3d F = jacobianOf(x, nodes.data(), n, dN[0]) * jacobianOf(X, nodes.data(), n, dN[0]).inverse();
    cause.finite = cause.finite && F.allFinite();
    if (!cause.finite) break;
    const Eigen::Vector3d stretches = Eigen::JacobiSVD<Eigen::Matrix3d>(F).singularValues();
    cause.leastDeterminant = std::min(cause.leastDeterminant, F.determinant());
    cause.largestStretch = std::max(cause.largestStretch, stretches[0]);
    cause.leastStretch = std::min(cause.leastStretch, stretches[2]);
  }
  cause.shape = elementShape(mesh.blocks[b], element.element, X, meanVolume);
  return cause;
}

}  // namespace

bool ElementCause::badlyShaped() const {
  // What a hexahedron, wedge or pyramid must exceed.
  constexpr double sharp = 30, flat = 150, slender = 5;
  if (shape.shape != ShapeClass::other) return shape.shape != ShapeClass::round;
  return shape.minDihedral < sharp || shape.maxDihedral > flat || shape.aspect > slender;
}

ElementCause elementCause(const Body& body, NodeVectorsView x, ElementRef element) {
  const SizeOfWhole size = sizeOfWhole(body);
  const std::optional<ElementRef> here = body.domain().here(element);
  ElementCause cause;
  if (here) cause = causeHere(body, x, *here, size.volume / size.elements);
  body.domain().share(&cause, sizeof cause, here.has_value());
  return cause;
}

ElementStrain strainOf(const ElementCause& cause) {
  constexpr double worthMention = 1.05;
  if (!cause.finite) return ElementStrain::notFinite;
  if (cause.leastDeterminant <= 0) return ElementStrain::inverted;
  if (std::max(cause.largestStretch, 1 / cause.leastStretch) < worthMention) return ElementStrain::none;
  return cause.largestStretch * cause.leastStretch >= 1 ? ElementStrain::stretched : ElementStrain::compressed;
}

std::string causeText(const ElementCause& cause) {
  const ElementStrain strain = strainOf(cause);
  std::string text(elementStrainNames.nameOf(strain));
  if (strain == ElementStrain::none)
    text = cause.badlyShaped() ? "" : "well shaped, " + text;
  else if (strain == ElementStrain::inverted)
    text += ", det F = " + digitsOf(cause.leastDeterminant, 2);
  else if (strain == ElementStrain::stretched)
    text += " " + digitsOf(cause.largestStretch, 2);
  else if (strain == ElementStrain::compressed)
    text += " to " + digitsOf(cause.leastStretch, 2);
  if (cause.badlyShaped()) text += joinText(text.empty() ? "" : "; ", cause.shape.text());
  return text;
}

}  // namespace ringwatch
