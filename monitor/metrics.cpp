#include <ringwatch/monitor/metrics.h>

#include <algorithm>
#include <array>
#include <cmath>

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <ringwatch/base/error.h>
#include <ringwatch/monitor/extreme_eigenvalues.h>
#include <ringwatch/monitor/nodal_bound.h>
#include <ringwatch/monitor/reduced_ring.h>
#include <ringwatch/monitor/scaled_tangent.h>

namespace ringwatch {
namespace {

constexpr int lanes = PatchLayout::lanes;
using Values = std::vector<std::vector<double>>;

Values emptyValues(const Body& body) {
  Values values;
  for (const auto& block : body.blocks()) values.emplace_back(static_cast<std::size_t>(block->elementCount()));
  return values;
}

/// lambda_max(D^-½ K_e D^-½) of every element with the diagonal mass massOf(element, mass[n]).
template <class MassOf>
Values elementEigenvalues(const Body& body, const NodeVectors& x, const MassOf& massOf) {
  Values values = emptyValues(body);
  body.forEachTangentBatch(x, [&](std::size_t b, std::int32_t batch, NativePack* K) {
    const ElementBlock& block = *body.blocks()[b];
    const int n = block.element().nodes;
    NativePack scale[3 * maxElementNodes], work[12 * maxElementNodes];
    forEachLane(block, batch, [&](int lane, std::int32_t e) {
      double mass[maxElementNodes];
      massOf(ElementRef{static_cast<std::int32_t>(b), e}, mass);
      const auto nodes = block.nodesOf(e);
      for (int a = 0; a < n; ++a)
        for (int c = 0; c < 3; ++c)
          scale[3 * a + c].set(lane, freeFactor(body, nodes[static_cast<std::size_t>(a)], c) / std::sqrt(mass[a]));
    });
    scaleSymmetric(K, 3 * n, scale);
    const auto extremes = extremeEigenvalues(K, 3 * n, work, false);
    // Not forEachLane: an empty lane holds zeros, and would write them over the first element's value.
    const std::int32_t* elements = block.layout().elements.data() + static_cast<std::ptrdiff_t>(batch) * lanes;
    for (int lane = 0; lane < lanes; ++lane)
      if (elements[lane] >= 0) values[b][static_cast<std::size_t>(elements[lane])] = extremes.largest[lane];
  });
  return values;
}

/// omega <= max omega_e, each element with its own lumped mass (Rayleigh; source, eq. 3.19 to 3.26).
Values singleElement(const Body& body, const NodeVectors& x) {
  return elementEigenvalues(body, x, [&](ElementRef e, double* mass) { body.elementLumpedMass(e, mass); });
}

/// lambda <= n max_e lambda_max(J_e), J_e the element's tangent scaled with the nodal masses of the mesh, n the largest
/// number of elements at a node (Shewchuk 2002; source, eq. 3.17).
Values shewchuk(const Body& body, const NodeVectors& x) {
  Values values = elementEigenvalues(body, x, [&](ElementRef e, double* mass) {
    const auto nodes = body.blocks()[static_cast<std::size_t>(e.block)]->nodesOf(e.element);
    for (std::size_t a = 0; a < nodes.size(); ++a) mass[a] = body.lumpedMass()[nodes[a]];
  });
  std::vector<int> valence(static_cast<std::size_t>(body.nodeCount()), 0);
  for (const auto& block : body.blocks())
    for (std::int32_t e = 0; e < block->elementCount(); ++e)
      for (std::int32_t node : block->nodesOf(e)) ++valence[static_cast<std::size_t>(node)];
  const int most = *std::max_element(valence.begin(), valence.end());
  for (auto& block : values)
    for (double& value : block) value = (value < 0 ? 0.0 : value) * most;  // keeps NaN
  return values;
}

/// omega = 2 s / L, s the speed of a pressure wave at rest, L = 3 V / max A for tetrahedra (their least height) and
/// V / max A else (Miller et al. 2006), of the current shape (source, eq. 3.27 and 3.28).
Values pressureWave(const Body& body, const NodeVectors& x) {
  Values values = emptyValues(body);
  for (std::size_t b = 0; b < values.size(); ++b) {
    const ElementBlock& block = *body.blocks()[b];
    const ElementInfo& element = block.element();
    const double speed = block.material().waveSpeed();
    const QuadratureRule& rule = element.massRule;
    parallelFor(0, block.elementCount(), body.threads(), [&](std::int64_t e) {
      const auto nodes = block.nodesOf(static_cast<std::int32_t>(e));
      auto at = [&](int a) { return Eigen::Vector3d(x.col(nodes[static_cast<std::size_t>(a)])); };
      double volume = 0, dN[maxElementNodes][3];
      for (const QuadraturePoint& point : rule.points) {
        element.shapeGradient(point.xi, dN);
        Eigen::Matrix3d J = Eigen::Matrix3d::Zero();
        for (int a = 0; a < element.nodes; ++a) J += at(a) * Eigen::RowVector3d::Map(dN[a]);
        volume += J.determinant() * point.weight;
      }
      double area = 0;
      for (const auto& face : element.faces) {
        // Area vector of a triangle, or of a quadrilateral by its diagonals.
        const bool triangle = face[3] < 0;
        const Eigen::Vector3d p = at(face[2]) - at(face[0]),
                              q = at(face[triangle ? 1 : 3]) - at(face[triangle ? 0 : 1]);
        area = std::max(area, 0.5 * p.cross(q).norm());
      }
      const double length = (element.faces.size() == 4 ? 3 : 1) * volume / area;
      values[b][static_cast<std::size_t>(e)] = std::pow(2 * speed / length, 2);
    });
  }
  return values;
}

Values reducedRing(const Body& body, const NodeVectors& x) {
  ReducedRing ring(body);
  return ring.evaluate(x).largest;
}

/// The nodal bound at each element's hottest node.
Values nodalBound(const Body& body, const NodeVectors& x) {
  NodalBound bound(body);
  constexpr int sweeps = 20;
  const double best = bound.evaluate(x, sweeps).value;
  Values values = emptyValues(body);
  // Nodal values of the last sweep lie about the best bound; none is shown above it.
  for (std::size_t b = 0; b < values.size(); ++b)
    for (std::size_t e = 0; e < values[b].size(); ++e)
      for (std::int32_t node : body.blocks()[b]->nodesOf(static_cast<std::int32_t>(e)))
        values[b][e] = std::max(values[b][e], std::min(best, bound.nodal()[static_cast<std::size_t>(node)]));
  double top = 0;
  for (const auto& block : values)
    for (double value : block) top = std::max(top, value);
  for (auto& block : values)
    for (double& value : block)
      if (value == top) value = best;
  return values;
}

struct Entry {
  MetricInfo info;
  Values (*evaluate)(const Body&, const NodeVectors&);
};

const std::array<Entry, 5> entries{{
    {{"single-element", "every element on its own, with its own mass", Direction::upperBound}, singleElement},
    {{"pressure-wave", "a pressure wave crossing the element's least height", Direction::estimate}, pressureWave},
    {{"shewchuk", "element with the mesh's nodal masses, times the largest valence", Direction::upperBound}, shewchuk},
    {{"reduced-1-ring", "assembled stiffness cut to the element's own nodes", Direction::lowerBound}, reducedRing},
    {{"nodal-bound", "proven bound by 3x3 shapes summed at nodes", Direction::upperBound}, nodalBound},
}};

}  // namespace

std::string_view directionName(Direction direction) {
  switch (direction) {
    case Direction::upperBound:
      return "upper-bound";
    case Direction::lowerBound:
      return "lower-bound";
    case Direction::estimate:
      return "estimate";
  }
  return "";
}

std::span<const MetricInfo> allMetrics() {
  static const auto table = [] {
    std::array<MetricInfo, entries.size()> infos{};
    for (std::size_t i = 0; i < entries.size(); ++i) infos[i] = entries[i].info;
    return infos;
  }();
  return table;
}

const MetricInfo* findMetric(std::string_view name) {
  for (const MetricInfo& info : allMetrics())
    if (info.name == name) return &info;
  return nullptr;
}

MetricResult evaluateMetric(std::string_view name, const Body& body, const NodeVectors& x) {
  for (std::size_t i = 0; i < entries.size(); ++i) {
    if (entries[i].info.name != name) continue;
    MetricResult result{&allMetrics()[i], 0, {}, entries[i].evaluate(body, x)};
    bool first = true;
    for (std::size_t b = 0; b < result.elementLambda.size(); ++b)
      for (std::size_t e = 0; e < result.elementLambda[b].size(); ++e)
        // NaN, an element without a tangent, stays once it was met.
        if (first || result.elementLambda[b][e] > result.lambda || std::isnan(result.elementLambda[b][e])) {
          result.lambda = result.elementLambda[b][e];
          result.controlling = {static_cast<std::int32_t>(b), static_cast<std::int32_t>(e)};
          first = false;
        }
    return result;
  }
  std::string names;
  for (const MetricInfo& info : allMetrics()) names += (names.empty() ? "" : ", ") + std::string(info.name);
  throw InputError(joinText("metric \"", name, "\": must be one of ", names));
}

}  // namespace ringwatch
