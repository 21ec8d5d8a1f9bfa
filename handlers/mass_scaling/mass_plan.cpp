#include <ringwatch/handlers/mass_scaling/mass_plan.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include <ringwatch/base/error.h>
#include <ringwatch/base/random.h>
#include <ringwatch/base/rounding.h>
#include <ringwatch/handlers/handler.h>
#include <ringwatch/handlers/mass_scaling/mass_scaling.h>
#include <ringwatch/handlers/selection/selection.h>
#include <ringwatch/monitor/bounds/factored_certificate.h>
#include <ringwatch/monitor/bounds/mass_scaled_operator.h>
#include <ringwatch/monitor/bounds/nodal_bound.h>
#include <ringwatch/monitor/metrics/metrics.h>
#include <ringwatch/monitor/small/symmetric_eigenpairs.h>

namespace ringwatch {

Body withAddedMass(const Body& body, const Eigen::VectorXd& added) {
  Body heavier = copyOf(body);
  for (std::int32_t i = 0; i < body.nodeCount(); ++i)
    if (added[i] > 0) heavier.addNodalMass(i, added[i]);
  return heavier;
}

MassPlan addedMassByHandler(const Body& body, const NodeVectors& x, std::unique_ptr<Integrator> base,
                            HandlerOptions options, double h) {
  Body heavier = copyOf(body);
  MassScaling handler(heavier, std::move(base), std::move(options));
  handler.prepare(x, h);
  return {(heavier.lumpedMass() - body.lumpedMass()).cwiseMax(0)};
}

namespace {

/// A few seconds for all factorisations and modes of a plan.
constexpr double mostOperations = 2e9;

MassPlan planByNodes(const Body& body, const NodeVectors& x, double lambda) {
  constexpr int rounds = 12, sweeps = 12;
  const Eigen::VectorXd& own = body.lumpedMass();
  HandlerOptions options;
  options.margin = 0.0;
  MassPlan best =
      addedMassByHandler(body, x, makeIntegrator("symplectic-euler"), std::move(options), 2 / std::sqrt(lambda));
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

/// The highest eigenvalues of a body over lambda, at most `most`, and the modes, mass-scaled. Empty unless they
/// converge.
std::optional<SymmetricEigenpairs> modesOver(const Body& body, const NodeVectors& x, double lambda, Eigen::Index most) {
  const MassScaledOperator op(body, x);
  const Eigen::Index rows = op.rows(), wanted = std::min(most, rows - 1);
  NodeVectors start(3, body.nodeCount());
  for (Eigen::Index i = 0; i < rows; ++i) start.data()[i] = randomEntry(20130517, static_cast<std::uint64_t>(i));
  op.restrict(start);
  SymmetricEigenpairs found = highestEigenpairs(
      rows,
      [&](const double* in, double* out) {
        op.apply(in, out);
        Eigen::VectorXd::Map(out, rows) /= lambda;
      },
      {.wanted = wanted, .basis = std::min(rows, 3 * wanted + 20), .start = start.data(), .tolerance = 1e-6});
  if (!found.converged) return std::nullopt;
  return found;
}

/// Empty where it cannot be had in good time.
std::optional<MassPlan> planByModes(const Body& body, const NodeVectors& x, double lambda) {
  constexpr int rounds = 60;
  constexpr Eigen::Index modes = 32;
  constexpr double near = 1e-4;  // of lambda: the rest is made up for below
  if (FactoredCertificate(body, x).cost().operations > mostOperations) return std::nullopt;
  MassPlan plan{Eigen::VectorXd::Zero(body.nodeCount())};
  bool done = false;
  for (int round = 0; round < rounds && !done; ++round) {
    const Body heavier = withAddedMass(body, plan.added);
    const std::optional<SymmetricEigenpairs> top = modesOver(heavier, x, lambda, modes);
    if (!top) return std::nullopt;
    Eigen::VectorXd more = Eigen::VectorXd::Zero(body.nodeCount());
    for (Eigen::Index k = 0; k < top->values.size(); ++k) {
      if (!(top->values[k] > 1)) continue;
      const Eigen::VectorXd size =
          Eigen::Map<const NodeVectors>(top->vectors.col(k).data(), 3, body.nodeCount()).colwise().squaredNorm();
      const Eigen::VectorXd share = (size / size.maxCoeff()).array().pow(4);
      more = more.cwiseMax((top->values[k] - 1) * heavier.lumpedMass().cwiseProduct(share));
    }
    plan.added += more;
    done = top->values.maxCoeff() <= 1 + near;
  }
  // What is missing at the end is so little that all of the added mass may grow for it.
  double growth = 1e-9;
  for (; done && growth < near * 100; growth *= 4) {
    const MassPlan grown{plan.added * (1 + growth)};
    const Body heavier = withAddedMass(body, grown.added);
    if (FactoredCertificate(heavier, x).certifies(lambda)) return grown;
  }
  return std::nullopt;
}

}  // namespace

MassPlan planAddedMass(const Body& body, const NodeVectors& x, double lambda) {
  if (!(lambda > 0) || !std::isfinite(lambda))
    throw InputError(joinText("lambda = ", lambda, " rad2/s2: must be a finite number > 0"));
  MassPlan plan = planByNodes(body, x, lambda);
  if (plan.total() == 0) return plan;
  const std::optional<MassPlan> byModes = planByModes(body, x, lambda);
  return byModes && byModes->total() < plan.total() ? *byModes : plan;
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
