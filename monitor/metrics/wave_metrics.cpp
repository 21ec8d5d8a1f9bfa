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
  if (kind == CharacteristicLength::calculix) {
    double middle[3] = {0, 0, 0};
    for (int a = 0; a < corners; ++a)
      for (int c = 0; c < 3; ++c) middle[c] += element.referenceNodes[static_cast<std::size_t>(a)][c] / corners;
    element.shapeGradient(middle, dN);
    volume = jacobianOf(x, nodes.data(), element.nodes, dN[0]).determinant() * element.referenceVolume;
    const auto triangles = std::ranges::count_if(element.faces, [](const auto& face) { return face[3] < 0; });
    const double share = triangles == 0 ? 1.0 : triangles == 2 ? 0.5 : 1.0 / 3;
    // Half of h omega at the limit of the α-method: √(2/(γ + 2α(γ - β)))/2 with γ = 1/2 - α, β = (1 - α)²/4.
    constexpr double alpha = -0.05, gamma = 0.5 - alpha, beta = (1 - alpha) * (1 - alpha) / 4;
    const double limit = std::sqrt(2 / (gamma + 2 * alpha * (gamma - beta))) / 2;
    constexpr double safety = 0.8 * 0.98, quadratic = 0.3;
    return safety * limit * (element.order > 1 ? quadratic : 1) * share * volume / most;
  }
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

std::vector<std::vector<double>> pressureWaveAtNodes(const Body& body, NodeVectorsView x) {
  std::vector<std::vector<double>> values = pressureWave(body, x, CharacteristicLength::usual);
  std::vector<double> nodal(static_cast<std::size_t>(body.nodeCount()), 0.0);
  const auto forEachElement = [&](const auto& visit) {
    for (std::size_t b = 0; b < values.size(); ++b)
      for (std::int32_t e = 0; e < body.blocks()[b]->elementCount(); ++e)
        visit(ElementRef{b, e}, body.blocks()[b]->nodesOf(e), values[b][static_cast<std::size_t>(e)]);
  };
  forEachElement([&](ElementRef e, std::span<const std::int32_t> nodes, double& value) {
    double mass[maxElementNodes];
    body.elementLumpedMass(e, mass);
    for (std::size_t a = 0; a < nodes.size(); ++a) nodal[nodes[a]] += mass[a] * value / body.lumpedMass()[nodes[a]];
  });
  forEachElement([&](ElementRef, std::span<const std::int32_t> nodes, double& value) {
    value = 0;
    for (const std::int32_t node : nodes)
      if (nodal[node] > value || std::isnan(nodal[node])) value = nodal[node];
  });
  return values;
}

std::vector<std::vector<double>> dilatationalMode(const Body& body, NodeVectorsView x) {
  std::vector<std::vector<double>> values;
  for (std::size_t b = 0; b < body.blocks().size(); ++b) {
    const ElementBlock& block = *body.blocks()[b];
    auto& lambda = values.emplace_back(static_cast<std::size_t>(block.elementCount()));
    const ElementInfo& element = block.element();
    const double modulus = std::pow(block.material().waveSpeed(), 2) * block.material().density;
    parallelFor(0, block.elementCount(), body.threads(), [&](std::int64_t e) {
      const auto nodes = block.nodesOf(e);
      double volume = 0, dN[maxElementNodes][3], mass[maxElementNodes];
      Eigen::Matrix<double, 3, Eigen::Dynamic, 0, 3, maxElementNodes> B =
          Eigen::Matrix<double, 3, Eigen::Dynamic, 0, 3, maxElementNodes>::Zero(3, element.nodes);
      for (const QuadraturePoint& point : element.massRule.points) {
        element.shapeGradient(point.xi, dN);
        const Eigen::Matrix3d J = jacobianOf(x, nodes.data(), element.nodes, dN[0]);
        const double weight = J.determinant() * point.weight;
        volume += weight;
        B += weight * J.inverse().transpose() *
             Eigen::Map<const Eigen::Matrix<double, 3, Eigen::Dynamic>>(dN[0], 3, element.nodes);
      }
      body.elementLumpedMass({b, static_cast<std::int32_t>(e)}, mass);
      double sum = 0;
      for (int a = 0; a < element.nodes; ++a) sum += B.col(a).squaredNorm() / mass[a];
      lambda[e] = modulus / volume * sum;
    });
  }
  return values;
}

}  // namespace ringwatch
