#include <ringwatch/monitor/metrics/element_metrics.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include <ringwatch/monitor/bounds/scaled_tangent.h>
#include <ringwatch/monitor/small/extreme_eigenvalues.h>

namespace ringwatch {
namespace {

using Values = std::vector<std::vector<double>>;

Values emptyValues(const Body& body) {
  Values values;
  for (const auto& block : body.blocks()) values.emplace_back(static_cast<std::size_t>(block->elementCount()));
  return values;
}

/// Largest and, when wanted, least eigenvalue of D^-½ K_e D^-½ of every element with the diagonal mass
/// massOf(element, mass[n]).
struct Extremes {
  Values largest, least;
};
template <class MassOf>
Extremes elementEigenvalues(const Body& body, NodeVectorsView x, const MassOf& massOf, bool wantLeast = false) {
  Extremes values{emptyValues(body), wantLeast ? emptyValues(body) : Values{}};
  body.forEachTangentBatch(x, [&](std::size_t b, std::int32_t batch, NativePack* K) {
    const ElementBlock& block = *body.blocks()[b];
    const int n = block.element().nodes;
    NativePack scale[3 * maxElementNodes], work[12 * maxElementNodes];
    forEachLane(block, batch, [&](int lane, std::int32_t e) {
      double mass[maxElementNodes];
      massOf(ElementRef{b, e}, mass);
      const auto nodes = block.nodesOf(e);
      for (int a = 0; a < n; ++a)
        for (int c = 0; c < 3; ++c) scale[3 * a + c].set(lane, freeFactor(body, nodes[a], c) / std::sqrt(mass[a]));
    });
    scaleSymmetric(K, 3 * n, scale);
    const auto extremes = extremeEigenvalues(K, 3 * n, work, wantLeast);
    // Not forEachLane: an empty lane holds zeros, and would write them over the first element's value.
    const std::int32_t* elements = block.layout().elements.data() + static_cast<std::ptrdiff_t>(batch) * lanes;
    for (int lane = 0; lane < lanes; ++lane) {
      if (elements[lane] < 0) continue;
      values.largest[b][elements[lane]] = extremes.largest[lane];
      if (wantLeast) values.least[b][elements[lane]] = extremes.least[lane];
    }
  });
  return values;
}

/// The masses of an element's nodes in the whole mesh.
auto nodalMass(const Body& body) {
  return [&body](ElementRef e, double* mass) {
    const auto nodes = body.blocks()[e.block]->nodesOf(e.element);
    for (std::size_t a = 0; a < nodes.size(); ++a) mass[a] = body.lumpedMass()[nodes[a]];
  };
}
auto unitMass(const Body& body) {
  return [&body](ElementRef e, double* mass) {
    std::fill_n(mass, body.blocks()[e.block]->nodesOf(e.element).size(), 1.0);
  };
}

/// Times the largest number of elements at a node; values below 0 become 0, NaN stays.
Values timesValence(const Body& body, Values values, double factor) {
  std::vector<int> valence(body.nodeCount(), 0);
  for (const auto& block : body.blocks())
    for (std::int32_t e = 0; e < block->elementCount(); ++e)
      for (std::int32_t node : block->nodesOf(e)) ++valence[node];
  const int most = *std::max_element(valence.begin(), valence.end());
  for (auto& block : values)
    for (double& value : block) value = (value < 0 ? 0.0 : value) * most * factor;
  return values;
}

/// Largest eigenvalues less what the other elements at the same nodes can take away.
Values lessNeighbours(const Body& body, Extremes extremes) {
  std::vector<double> takenAt(body.nodeCount(), 0.0);
  const auto forEachElement = [&](const auto& visit) {
    for (std::size_t b = 0; b < body.blocks().size(); ++b)
      for (std::int32_t e = 0; e < body.blocks()[b]->elementCount(); ++e)
        visit(body.blocks()[b]->nodesOf(e), extremes.largest[b][e], extremes.least[b][e]);
  };
  const auto taken = [](double least) { return least > 0 ? 0.0 : -least; };  // keeps NaN
  forEachElement([&](std::span<const std::int32_t> nodes, double&, double least) {
    for (const std::int32_t node : nodes) takenAt[node] += taken(least);
  });
  forEachElement([&](std::span<const std::int32_t> nodes, double& largest, double least) {
    double most = 0;
    for (const std::int32_t node : nodes) {
      const double others = takenAt[node] - taken(least);
      if (others > most || std::isnan(others)) most = others;
    }
    largest -= most;
  });
  return std::move(extremes.largest);
}

}  // namespace

std::vector<std::vector<double>> singleElement(const Body& body, NodeVectorsView x) {
  return elementEigenvalues(body, x, [&](ElementRef e, double* mass) { body.elementLumpedMass(e, mass); }).largest;
}

std::vector<std::vector<double>> shewchuk(const Body& body, NodeVectorsView x) {
  return timesValence(body, elementEigenvalues(body, x, nodalMass(body)).largest, 1);
}

std::vector<std::vector<double>> shewchukLower(const Body& body, NodeVectorsView x) {
  return lessNeighbours(body, elementEigenvalues(body, x, nodalMass(body), true));
}

std::vector<std::vector<double>> fried(const Body& body, NodeVectorsView x) {
  return timesValence(body, elementEigenvalues(body, x, unitMass(body)).largest, 1 / body.lumpedMass().minCoeff());
}

std::vector<std::vector<double>> friedLower(const Body& body, NodeVectorsView x) {
  Values values = lessNeighbours(body, elementEigenvalues(body, x, unitMass(body), true));
  const double most = body.lumpedMass().maxCoeff(), least = body.lumpedMass().minCoeff();
  for (auto& block : values)
    for (double& value : block) value /= value < 0 ? least : most;
  return values;
}

}  // namespace ringwatch
