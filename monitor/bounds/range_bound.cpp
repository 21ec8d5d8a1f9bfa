#include <ringwatch/monitor/bounds/range_bound.h>

#include <algorithm>
#include <cmath>
#include <queue>
#include <variant>

#include <ringwatch/base/aligned.h>
#include <ringwatch/base/eigen_instances.h>
#include <ringwatch/base/error.h>
#include <ringwatch/base/infinity.h>
#include <ringwatch/base/rounding.h>
#include <ringwatch/body/discrete_forces.h>
#include <ringwatch/body/law_of_packs.h>
#include <ringwatch/monitor/tangent_bracket.h>

namespace ringwatch {
namespace {

/// The largest eigenvalue of ∂P/∂F at F = diag(s) of an isotropic law: of the 3×3 matrix of stretches, and of a 2×2
/// matrix for each pair of them. From above, to rounding.
double topModulus(const Material& material, const double (&s)[3]) {
  Matrix3<double> F = Matrix3<double>::zero();
  for (int i = 0; i < 3; ++i) F(i, i) = s[i];
  const auto column = [&](int i, int j) {
    Matrix3<double> unit = Matrix3<double>::zero();
    unit(i, j) = 1;
    return material.stressDifferential(F, unit);
  };
  Eigen::MatrixXd stretches(3, 3);
  double size = 0, top = -infinity;
  for (int j = 0; j < 3; ++j) {
    const Matrix3<double> own = column(j, j);
    for (int i = 0; i < 3; ++i) size = std::max(size, std::abs(stretches(i, j) = own(i, i)));
  }
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3;
    const Matrix3<double> one = column(i, j), other = column(j, i);
    const double middle = 0.5 * (one(i, j) + other(j, i)), off = 0.5 * (one(j, i) + other(i, j));
    top = std::max(top, middle + std::hypot(0.5 * (one(i, j) - other(j, i)), off));
    size = std::max({size, std::abs(one(i, j)), std::abs(other(j, i)), std::abs(off)});
  }
  const Eigen::MatrixXd symmetric = 0.5 * (stretches + stretches.transpose());
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(symmetric, Eigen::EigenvaluesOnly);
  return std::max(top, solver.eigenvalues()[2]) + modulusRounding * size;
}

TangentDriftCoefficients<double> driftOf(const Material& material, const Matrix3<double>& F) {
  return std::visit([&](const auto& law) { return law.drift(F); }, material.law);
}

/// A material with shares of its law, as a quadrature rule asks for them.
Material shareOf(const Material& material, double lambda, double rest) {
  Material share = material;
  share.law = std::visit([&](const auto& law) -> Law { return withShares(law, lambda, rest).value(); }, material.law);
  return share;
}

/// Stretches in a cube, and what the modulus is at most in it.
struct Cell {
  double centre[3], half;
  double bound;
  bool operator<(const Cell& other) const { return bound < other.bound; }
};

/// (D) of docs/theory/tangent_drift.md from the centre of a cube; infinite where the ball does not reach its corners.
/// reached: raised to the modulus at the centre.
void boundCell(const Material& material, Cell& cell, double& reached) {
  Matrix3<double> F = Matrix3<double>::zero();
  for (int i = 0; i < 3; ++i) F(i, i) = cell.centre[i];
  const double top = topModulus(material, cell.centre), delta = std::sqrt(3.0) * cell.half;
  const TangentDriftCoefficients<double> drift = driftOf(material, F);
  reached = std::max(reached, top);
  if (!(delta <= drift.radius)) {
    if (drift.radius < 0)
      throw InputError(joinText("stretch: the law ", material.lawName(), " declares no ball around stretches of ",
                                cell.centre[0], ", ", cell.centre[1], ", ", cell.centre[2],
                                ", so nothing is known of all stretches in a range"));
    cell.bound = infinity;
    return;
  }
  const double root = std::sqrt(std::max(0.0, top + drift.negative)) + std::sqrt(drift.kappa) * delta;
  cell.bound = root * root - drift.negative + (drift.linear + drift.quadratic * delta) * delta;
}

void checkRange(StretchRange range) {
  if (!(range.low > 0 && range.low <= range.high && std::isfinite(range.high)))
    throw InputError(joinText("stretch: ", range.low, " to ", range.high,
                              " is no range of stretches; must be two numbers a <= b with a > 0, 1 is at rest"));
}

/// Numbers c_i and c_ij, N/m, with v^T (K + f C) v <= Σ c_i |v_i|² + Σ c_ij |v_i - v_j|² of springs and contact,
/// wherever the nodes are: Theorem 66, docs/theory/discrete_forces.md.
struct DiscreteStiffness {
  std::vector<double> atNode;       // a number a node
  std::vector<std::int32_t> pairs;  // two nodes each
  std::vector<double> between;      // of each pair
};

DiscreteStiffness stiffnessAnywhere(const DiscreteForces& forces) {
  if (!forces.surfaces().empty())
    throw InputError(
        "stretch: contact of surfaces, in which all nodes can meet one face, leaves no step that a range of stretches "
        "proves");
  DiscreteStiffness result;
  result.atNode.assign(static_cast<std::size_t>(forces.nodeCount()), 0);
  constexpr double up = 1 + 1e-12;  // more than the sums are rounded by
  const double f = forces.dampingFactor();
  for (const Spring& spring : forces.springs()) {
    const double most = up * (spring.stiffness + f * spring.damping);
    if (spring.other < 0) {
      result.atNode[static_cast<std::size_t>(spring.node)] += most;
    } else if (most > 0) {
      result.pairs.insert(result.pairs.end(), {spring.node, spring.other});
      result.between.push_back(most);
    }
  }
  for (const PenaltyContact& contact : forces.contacts()) {
    if (contact.friction > 0)
      throw InputError(
          "stretch: contact has friction, whose damping grows with the depth to which nodes come; a range of stretches "
          "is proven without it");
    for (std::size_t k = 0; k < contact.nodes.size(); ++k)
      result.atNode[static_cast<std::size_t>(contact.nodes[k])] += up * (contact.penalty[k] + f * contact.damping[k]);
  }
  return result;
}

/// Adds the hourglass stiffness of the element in a lane to its n×n matrix, with what it errs by.
void addHourglass(const HourglassVectors& hourglass, int lane, double* L) {
  constexpr int n = HourglassVectors::nodes;
  const double k = hourglass.stiffness[lane];
  for (int a = 0; a < n; ++a) {
    for (int b = 0; b < n; ++b)
      for (const auto& gamma : hourglass.gamma) L[a * n + b] += k * gamma[a][lane] * gamma[b][lane];
    L[a * n + a] += n * k * hourglass.rounding[lane];
  }
}

}  // namespace

ModulusRange largestModulus(const Material& material, StretchRange range, double tolerance, int mostStates) {
  checkRange(range);
  if (material.outside)
    throw InputError(joinText("stretch: the law ", material.lawName(),
                              " was registered by a program; a range of stretches is proven for the library's own"));
  if (!material.info().isotropic)
    throw InputError(joinText("stretch: the law ", material.lawName(),
                              " is not isotropic; a range of stretches is proven for laws without a direction"));
  ModulusRange result{-infinity, -infinity, 0};
  std::priority_queue<Cell> cells;
  double done = -infinity;  // the largest bound of what need not be split
  const auto add = [&](Cell cell) {
    boundCell(material, cell, result.reached);
    ++result.states;
    cells.push(cell);
  };
  const double middle = 0.5 * (range.low + range.high);
  add({{middle, middle, middle}, 0.5 * (range.high - range.low), 0});
  while (!cells.empty()) {
    const Cell cell = cells.top();
    const double enough = result.reached + tolerance * std::abs(result.reached);
    if (cell.bound <= enough || cell.half == 0 || (result.states >= mostStates && std::isfinite(cell.bound))) {
      done = cell.bound;
      break;
    }
    cells.pop();
    const double half = 0.5 * cell.half;
    for (int corner = 0; corner < 8; ++corner) {
      Cell part{{}, half, 0};
      for (int i = 0; i < 3; ++i) part.centre[i] = cell.centre[i] + ((corner >> i & 1) != 0 ? half : -half);
      // The law does not tell the three stretches apart, so that cubes of s1 >= s2 >= s3 are enough; those across
      // count.
      if (part.centre[0] >= part.centre[1] && part.centre[1] >= part.centre[2]) add(part);
    }
  }
  result.bound = done + modulusRounding * std::abs(done);
  return result;
}

RangeStep rangeStep(const Body& body, StretchRange range, const StepRule& rule) {
  if (body.elementDamping())
    throw InputError("a body whose elements damp: a step for a range of states knows no damping");
  DiscreteStiffness discrete;
  if (body.discreteForces()) discrete = stiffnessAnywhere(*body.discreteForces());
  RangeStep result{infinity, {0}, {}};
  std::vector<TangentBracket::Elements> groups;
  std::vector<std::vector<std::int32_t>> nodes;
  std::vector<std::vector<double>> laplacians;
  for (const auto& block : body.blocks()) {
    const LameShares& shares = block->rule().shares;
    // Of a rule with a share at the mean: V B̄ᵀB̄ ≼ Σ w BᵀB, so that both bounds add up.
    const auto share = [&](double lambda, double rest) {
      if (lambda == 0 && rest == 0) return ModulusRange{0, 0, 0};
      if (lambda == 1 && rest == 1) return largestModulus(block->material(), range);
      return largestModulus(shareOf(block->material(), lambda, rest), range);
    };
    const ModulusRange point = share(shares.pointLambda, shares.pointMu),
                       mean = share(shares.meanLambda, shares.meanMu);
    result.modulus.push_back({std::max(0.0, point.bound) + std::max(0.0, mean.bound),
                              std::max(0.0, point.reached) + std::max(0.0, mean.reached), point.states + mean.states});
    const double kappa = result.modulus.back().bound;
    const int n = block->nodesPerElement();
    auto& own = nodes.emplace_back();
    auto& L = laplacians.emplace_back();
    AlignedVector<NativePack> packed(static_cast<std::size_t>(n * n)), rounding(static_cast<std::size_t>(n));
    for (std::int32_t first = 0; first < block->elementCount(); first += lanes) {
      std::int32_t elements[lanes];
      const int count = std::min<int>(lanes, block->elementCount() - first);
      for (int lane = 0; lane < lanes; ++lane) elements[lane] = lane < count ? first + lane : -1;
      block->laplacianOf(elements, reinterpret_cast<double*>(packed.data()),
                         reinterpret_cast<double*>(rounding.data()));
      HourglassVectors hourglass;
      const bool hasHourglass = block->hourglassOf(elements, hourglass);
      for (int lane = 0; lane < count; ++lane) {
        const auto of = block->nodesOf(first + lane);
        own.insert(own.end(), of.begin(), of.end());
        const std::size_t at = L.size();
        for (int i = 0; i < n * n; ++i) L.push_back(kappa * packed[static_cast<std::size_t>(i)][lane]);
        // |L̂_ab - L_ab| <= √(T_a T_b): the difference is at most n diag(T_a).
        for (int a = 0; a < n; ++a)
          L[at + static_cast<std::size_t>(a * n + a)] += kappa * n * rounding[static_cast<std::size_t>(a)][lane];
        if (hasHourglass) addHourglass(hourglass, lane, L.data() + at);
      }
    }
    groups.push_back({n, own});
  }
  if (!discrete.atNode.empty()) {
    // What acts at a node goes to the elements there, in equal parts.
    std::vector<double> elementsAt(discrete.atNode.size(), 0);
    for (const auto& own : nodes)
      for (const std::int32_t node : own) ++elementsAt[static_cast<std::size_t>(node)];
    for (std::size_t b = 0; b < nodes.size(); ++b) {
      const auto n = static_cast<std::size_t>(groups[b].nodesPerElement);
      for (std::size_t i = 0; i < nodes[b].size(); ++i) {
        const auto node = static_cast<std::size_t>(nodes[b][i]);
        laplacians[b][i / n * n * n + i % n * (n + 1)] += discrete.atNode[node] / elementsAt[node];
      }
    }
    if (!discrete.pairs.empty()) {
      groups.push_back({2, discrete.pairs});
      nodes.push_back(discrete.pairs);
      auto& L = laplacians.emplace_back();
      for (const double c : discrete.between) L.insert(L.end(), {c, -c, -c, c});
    }
  }
  for (std::size_t b = 0; b < nodes.size(); ++b) groups[b].nodes = nodes[b];
  const Eigen::VectorXd& mass = body.lumpedMass();
  std::vector<std::uint8_t> held(static_cast<std::size_t>(body.nodeCount()), 1);
  for (std::int32_t i = 0; i < body.nodeCount(); ++i)
    for (int c = 0; c < 3; ++c)
      if (!body.constraints().isConstrained(i, c)) held[static_cast<std::size_t>(i)] = 0;
  TangentBracket bracket(NodalMass{{mass.data(), static_cast<std::size_t>(mass.size())}, 1}, groups, held,
                         body.threads());
  std::vector<std::span<const double>> tangents(laplacians.begin(), laplacians.end());
  const double safe = bracket.evaluate(tangents, 2.0).safe;
  result.lambda.value = std::isfinite(safe) ? (4 / (safe * safe)) * (1 + 1e-14) : 0;
  result.safe = safeStep(result.lambda, rule);
  return result;
}

}  // namespace ringwatch
