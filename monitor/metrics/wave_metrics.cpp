#include <ringwatch/monitor/metrics/wave_metrics.h>

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <ringwatch/base/infinity.h>
#include <ringwatch/meshes/jacobian.h>

namespace ringwatch {

double characteristicLength(const ElementInfo& element, NodeVectorsView x, std::span<const std::int32_t> nodes,
                            CharacteristicLength kind) {
  const auto at = [&](int a) { return Eigen::Vector3d(x.col(nodes[a])); };
  const int corners = cornerCount(element);
  if (kind == CharacteristicLength::shortestEdge) {
    double least = infinity;
    for (std::size_t i = 0; i < element.edges.size(); ++i) {
      const Eigen::Vector3d p = at(element.edges[i][0]), q = at(element.edges[i][1]);
      if (element.order == 1) {
        least = std::min(least, (q - p).norm());
      } else {
        const Eigen::Vector3d middle = at(corners + static_cast<int>(i));
        least = std::min({least, (middle - p).norm(), (q - middle).norm()});
      }
    }
    return least;
  }
  if (kind == CharacteristicLength::cellDiameter) {
    double largest = 0;
    for (int a = 1; a < corners; ++a)
      for (int b = 0; b < a; ++b) largest = std::max(largest, (at(a) - at(b)).norm());
    return largest;
  }
  double most = 0, sum = 0, height = infinity;
  for (const auto& face : element.faces) {
    // Area vector of a triangle, or of a quadrilateral by its diagonals.
    const bool triangle = face[3] < 0;
    const Eigen::Vector3d p = at(face[2]) - at(face[0]), q = at(face[triangle ? 1 : 3]) - at(face[triangle ? 0 : 1]);
    const Eigen::Vector3d normal = p.cross(q);
    const double area = 0.5 * normal.norm();
    most = std::max(most, area);
    sum += area;
    if (kind != CharacteristicLength::minHeight) continue;
    Eigen::Vector3d middle = Eigen::Vector3d::Zero();
    for (int k = 0; k < (triangle ? 3 : 4); ++k) middle += at(face[k]) / (triangle ? 3 : 4);
    double farthest = 0;
    for (int a = 0; a < corners; ++a)
      farthest = std::max(farthest, std::abs((at(a) - middle).dot(normal)) / (2 * area));
    height = std::min(height, farthest);
  }
  if (kind == CharacteristicLength::minHeight) return height;
  double volume = 0, dN[maxElementNodes][3];
  for (const QuadraturePoint& point : element.massRule.points) {
    element.shapeGradient(point.xi, dN);
    volume += jacobianOf(x, nodes.data(), element.nodes, dN[0]).determinant() * point.weight;
  }
  if (kind == CharacteristicLength::inRadius) return 3 * volume / sum;
  const bool tetrahedron = element.faces.size() == 4 && kind == CharacteristicLength::usual;
  return (tetrahedron ? 3 : 1) * volume / most;
}

std::vector<std::vector<double>> pressureWave(const Body& body, NodeVectorsView x, CharacteristicLength length) {
  std::vector<std::vector<double>> values;
  for (const auto& block : body.blocks()) {
    auto& lambda = values.emplace_back(static_cast<std::size_t>(block->elementCount()));
    const double speed = block->material().waveSpeed();
    parallelFor(0, block->elementCount(), body.threads(), [&](std::int64_t e) {
      const auto nodes = block->nodesOf(e);
      lambda[e] = std::pow(2 * speed / characteristicLength(block->element(), x, nodes, length), 2);
    });
  }
  return values;
}

}  // namespace ringwatch
