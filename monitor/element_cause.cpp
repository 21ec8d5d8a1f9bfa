#include <ringwatch/monitor/element_cause.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

#include <Eigen/LU>
#include <Eigen/SVD>

#include <ringwatch/base/error.h>
#include <ringwatch/meshes/quality.h>

namespace ringwatch {
namespace {

std::string twoDigits(double value) {
  std::ostringstream text;
  text.precision(2);
  text << value;
  return text.str();
}

/// Departure from rest over the quadrature points; "" when there is little.
std::string deformationCause(const ElementBlock& block, const NodeVectors& X, const NodeVectors& x, std::int32_t e) {
  const auto nodes = block.nodesOf(e);
  double leastDeterminant = std::numeric_limits<double>::infinity(), most = 1, least = 1, dN[maxElementNodes][3];
  for (const QuadraturePoint& point : block.rule().points) {
    block.element().shapeGradient(point.xi, dN);
    Eigen::Matrix3d rest = Eigen::Matrix3d::Zero(), current = Eigen::Matrix3d::Zero();
    for (std::size_t a = 1; a < nodes.size(); ++a) {
      rest += (X.col(nodes[a]) - X.col(nodes[0])) * Eigen::RowVector3d::Map(dN[a]);
      current += (x.col(nodes[a]) - x.col(nodes[0])) * Eigen::RowVector3d::Map(dN[a]);
    }
    const Eigen::Matrix3d F = current * rest.inverse();
    if (!F.allFinite()) return "not finite";
    const Eigen::Vector3d stretches = Eigen::JacobiSVD<Eigen::Matrix3d>(F).singularValues();
    leastDeterminant = std::min(leastDeterminant, F.determinant());
    most = std::max(most, stretches[0]);
    least = std::min(least, stretches[2]);
  }
  constexpr double worthMention = 1.05;
  if (leastDeterminant <= 0) return joinText("inverted, det F = ", twoDigits(leastDeterminant));
  if (std::max(most, 1 / least) < worthMention) return {};
  return most * least >= 1 ? joinText("stretched ", twoDigits(most)) : joinText("compressed to ", twoDigits(least));
}

}  // namespace

std::string elementCause(const Body& body, const NodeVectors& x, ElementRef element) {
  const Mesh& mesh = body.mesh();
  const auto b = static_cast<std::size_t>(element.block);
  std::string cause = deformationCause(*body.blocks()[b], mesh.X, x, element.element);
  const double meanVolume = body.volume() / static_cast<double>(mesh.elementCount());
  const ElementShape shape =
      elementShape(mesh.blocks[b], static_cast<std::size_t>(element.element), mesh.X, meanVolume);
  // What a hexahedron, wedge or pyramid must exceed to be called badly shaped.
  constexpr double sharp = 30, flat = 150, slender = 5;
  const bool bad = shape.shape == ShapeClass::other
                       ? shape.minDihedral < sharp || shape.maxDihedral > flat || shape.aspect > slender
                       : shape.shape != ShapeClass::round;
  if (bad) cause += joinText(cause.empty() ? "" : "; ", shape.text());
  return cause.empty() ? "well shaped, unstrained" : cause;
}

}  // namespace ringwatch
