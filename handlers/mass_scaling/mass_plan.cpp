#include <ringwatch/handlers/mass_scaling/mass_plan.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include <ringwatch/base/error.h>
#include <ringwatch/base/rounding.h>
#include <ringwatch/handlers/handler.h>
#include <ringwatch/handlers/mass_scaling/mass_scaling.h>
#include <ringwatch/handlers/selection/selection.h>
#include <ringwatch/monitor/bounds/nodal_bound.h>
#include <ringwatch/monitor/metrics/metrics.h>

namespace ringwatch {

Body withAddedMass(const Body& body, const Eigen::VectorXd& added) {
  Body heavier = copyOf(body);
  for (std::int32_t i = 0; i < body.nodeCount(); ++i)
    if (added[i] > 0) heavier.addNodalMass(i, added[i]);
  return heavier;
}

MassPlan planAddedMass(const Body& body, const NodeVectors& x, double lambda, int rounds) {
  constexpr int sweeps = 12;
  if (!(lambda > 0) || !std::isfinite(lambda))
    throw InputError(joinText("lambda = ", lambda, " rad2/s2: must be a finite number > 0"));
  const Eigen::VectorXd& own = body.lumpedMass();
  MassPlan best{Eigen::VectorXd::Zero(body.nodeCount())};
  {
    Body heavier = withAddedMass(body, best.added);
    HandlerOptions options;
    options.margin = 0.0;
    MassScaling handler(heavier, makeIntegrator("symplectic-euler"), std::move(options));
    handler.prepare(x, 2 / std::sqrt(lambda));
    best.added = (heavier.lumpedMass() - own).cwiseMax(0);
  }
  Eigen::VectorXd added = best.added;
  for (int round = 0; round < rounds && best.total() > 0; ++round) {
    const Body heavier = withAddedMass(body, added);
    NodalBound bound(heavier);
    if (!std::isfinite(bound.evaluate(x, sweeps).value))
      throw NumericalError("added mass: the tangent is not finite here, and no mass helps");
    for (std::int32_t i = 0; i < body.nodeCount(); ++i) {
      const double needed =
          heavier.lumpedMass()[i] * bound.nodal()[static_cast<std::size_t>(i)] / lambda * (1 + scaledValueRounding);
      added[i] = std::max(0.0, needed - own[i]);
    }
    if (added.sum() < best.total()) best.added = added;
  }
  return best;
}

MassPlan addedMassByElement(const Body& body, const NodeVectors& x, double lambda) {
  MassPlan plan{Eigen::VectorXd::Zero(body.nodeCount())};
  const MetricResult own = evaluateMetric("single-element", body, x);
  std::vector<double> mass;
  for (std::size_t b = 0; b < body.blocks().size(); ++b)
    for (std::int32_t e = 0; e < body.blocks()[b]->elementCount(); ++e) {
      const double more = own.elementLambda[b][static_cast<std::size_t>(e)] / lambda * (1 + scaledValueRounding) - 1;
      if (!(more > 0)) continue;
      const auto nodes = body.blocks()[b]->nodesOf(e);
      mass.resize(nodes.size());
      body.elementLumpedMass({b, e}, mass.data());
      for (std::size_t a = 0; a < nodes.size(); ++a) plan.added[nodes[a]] += more * mass[a];
    }
  return plan;
}

}  // namespace ringwatch
