// The exchange bound along a run: proven at every state it is followed to, tight where weights are not, and gone where
// its proof is.
#include <gtest/gtest.h>

#include <map>

#include <ringwatch/body/discrete_forces.h>
#include <ringwatch/body/element_damping.h>
#include <ringwatch/monitor/incremental/exchange_certificate.h>
#include <ringwatch/monitor/small/packed_cholesky.h>
#include <ringwatch/monitor/stability_monitor.h>
#include <tests/monitor/discrete_cases.h>

namespace ringwatch {
namespace {

using test::DenseTangent;
using test::Hold;
using test::Subdivision;

TEST(PackedCholesky, KnowsDefiniteMatrices) {
  test::Random random(5);
  for (const int n : {1, 2, 12, 13, 15, 18, 24, 30})
    for (const double least : {-1.0, -1e-9, 1e-9, 1.0}) {
      AlignedVector<NativePack> A(n * n);
      bool definite[lanes];
      for (int lane = 0; lane < lanes; ++lane) {
        // Of random eigenvectors, the least eigenvalue given; in odd lanes the other sign of it.
        const Eigen::MatrixXd B = Eigen::MatrixXd::NullaryExpr(n, n, [&] { return random.uniform(-1, 1); });
        const Eigen::MatrixXd Q = B.householderQr().householderQ();
        Eigen::VectorXd values = Eigen::VectorXd::NullaryExpr(n, [&] { return random.uniform(1, 2); });
        values[random.index(n)] = lane % 2 ? -least : least;
        const Eigen::MatrixXd M = Q * values.asDiagonal() * Q.transpose();
        for (int i = 0; i < n * n; ++i) A[i].set(lane, M(i / n, i % n));
        definite[lane] = values.minCoeff() > 0;
      }
      const NativePack found = pivotsArePositive(A.data(), n);
      for (int lane = 0; lane < lanes; ++lane) EXPECT_EQ(found[lane] > 0, definite[lane]) << n << ", " << least;
    }
  NativePack none(std::nan(""));
  EXPECT_EQ(pivotsArePositive(&none, 1)[0], 0);
}

/// Shares at x, aimed by the top mode and its eigenvalue.
struct Shared {
  explicit Shared(const Body& body) : weights(body), certificate(body, weights) {}
  void share(const Body& body, const NodeVectors& x, int iterations = 30) {
    const DenseTangent tangent(body, x);
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(tangent.matrix);
    NodeVectors mode = NodeVectors::Zero(3, body.nodeCount());
    for (std::size_t k = 0; k < tangent.components.size(); ++k) {
      const auto [node, component] = tangent.components[k];
      mode(component, node) = solver.eigenvectors()(static_cast<Eigen::Index>(k), solver.eigenvectors().cols() - 1) /
                              std::sqrt(body.lumpedMass()[node]);
    }
    if (!certificate.hasShares()) weights.evaluate(x, 3);
    certificate.share(x, mode, {solver.eigenvalues().tail(1)[0]}, iterations);
  }
  NodalBound weights;
  ExchangeCertificate certificate;
};

class ExchangeCertificateTest : public testing::TestWithParam<Subdivision> {};

TEST_P(ExchangeCertificateTest, HoldsAlongRandomMotions) {
  int held = 0, followed = 0;
  for (const LawInfo& law : allLaws())
    for (const Hold hold : {Hold::nothing, Hold::components}) {
      Body body = test::boxBody(GetParam(), law.name);
      test::holdBody(body, hold);
      Shared shared(body);
      test::Random random(17);
      int seed = 0;
      for (const test::NamedState& state : test::deformedStates(body.mesh().X, 6)) {
        NodeVectors x = state.x;
        const DenseTangent start(body, x);
        if (!start.finite() || !(start.largest() > 0)) continue;
        // Any number of iterations: shares that are not tight are shares.
        shared.share(body, x, 2 + 8 * (seed++ % 3));
        for (const double size : {0.0, 1e-4, 1e-3, 3e-3, 0.01, 0.03, 0.1}) {
          const Eigen::Matrix3d turn =
              Eigen::AngleAxisd(3 * size, random.rotation().col(0)).toRotationMatrix() + random.matrix(size);
          x = turn * x + random.nodeVectors(x.cols(), 0.3 * size * test::cellSize);
          shared.certificate.follow(x, 1.5);
          ++followed;
          if (!shared.certificate.holds()) {
            EXPECT_TRUE(std::isinf(shared.certificate.certifiedEigenvalue()));
            continue;
          }
          ++held;
          const double lambda = DenseTangent(body, x).largest();
          EXPECT_GE(shared.certificate.certifiedEigenvalue(), lambda * (1 - 1e-10))
              << law.name << ", " << test::holdName(hold) << ", " << state.name << ", " << size;
          EXPECT_LE(shared.certificate.verify(x), 1e-9)
              << law.name << ", " << test::holdName(hold) << ", " << state.name << ", " << size;
        }
      }
    }
  EXPECT_GE(3 * held, followed);
}
INSTANTIATE_TEST_SUITE_P(Subdivisions, ExchangeCertificateTest, testing::ValuesIn(test::allSubdivisions()),
                         [](const auto& parameter) { return parameter.param.name; });

/// A box of two halves whose stiffness differs by up to 1e6, with springs, contact and elements that damp in all ways;
/// hexahedra with one point or eight.
Body mixedBody(Subdivision subdivision, std::string_view law, int seed) {
  test::Random random(seed);
  if (subdivision.other.empty()) {
    subdivision.other = subdivision.element;
    subdivision.otherSplit = subdivision.split;
  }
  const double soft = test::young, stiff = soft * std::pow(10.0, random.uniform(0, 6));
  const auto material = [&](double young) {
    return makeMaterial(law, young, random.uniform(0.1, 0.4), test::density * random.uniform(0.5, 2));
  };
  BodyOptions options;
  options.threads = 1;
  const bool onePoint = seed % 2 == 1 && subdivision.element == "hex8";
  if (onePoint) {
    options.rules["hex8"] = "uniform-strain";
    options.hourglassControl.stiffness = 0.1;
  }
  Body body(test::box(subdivision, {4, 2, 2}, 0.2, static_cast<std::uint64_t>(seed)), {material(soft), material(stiff)},
            options);
  test::holdBody(body, seed % 3 == 0 ? Hold::nothing : seed % 3 == 1 ? Hold::face : Hold::components);
  test::addForces(body, (seed % 4 == 3 ? 10 : 0.3) * stiff * test::cellSize, static_cast<std::uint64_t>(seed));
  if (seed % 5 != 4) {
    const double viscosity = 0.1 * stiff / 1e3;
    const DampingConstants all{0.1, 1.2, viscosity, viscosity, 10, 0},
        some{0.06, seed % 5 == 1 ? 0.0 : 1.2, 0, 0, 0, 0};
    const auto kind = [&](std::string_view element, DampingConstants own) {
      if (onePoint && element == "hex8") own.hourglassViscosity = 0.1;
      return own;
    };
    body.setElementDamping({kind(subdivision.element, all), kind(subdivision.other, some)});
    body.elementDamping()->setFactor(1e3);
  }
  return body;
}

// The proof of K + f C with majorants at nodes, at every state of motions in which nodes touch and leave and rates
// change.
TEST_P(ExchangeCertificateTest, HoldsWithDiscreteForcesDampingAndContrasts) {
  int held = 0, followed = 0, toggled = 0, contactAbove = 0, seed = 0;
  double tightest = infinity;
  for (const char* law : {"stvk", "neo-hookean", "corotational"})
    for (int k = 0; k < 5; ++k) {
      Body body = mixedBody(GetParam(), law, ++seed);
      test::Random random(static_cast<std::uint64_t>(seed));
      Shared shared(body);
      NodeVectors x = test::strained(body.mesh().X, static_cast<std::uint64_t>(seed), 0.03);
      body.followDampingRates(x, random.nodeVectors(x.cols(), 1));
      shared.share(body, x, 30);
      std::int64_t touching = -1;
      for (int step = 0; step < 12; ++step) {
        const double size = 2e-3 * step, fall = 0.1 * test::cellSize * std::sin(1.3 * step);
        const Eigen::Matrix3d turn =
            Eigen::AngleAxisd(size, random.rotation().col(0)).toRotationMatrix() + random.matrix(0.2 * size);
        x = turn * x + random.nodeVectors(x.cols(), 0.05 * size * test::cellSize);
        x.row(2).array() += fall;
        body.followDampingRates(x, random.nodeVectors(x.cols(), 0.2 * step));
        body.discreteForces()->setReach(step % 3 == 0 ? 0.05 * test::cellSize : 0);
        if (step == 6) shared.share(body, x, 10);
        shared.certificate.follow(x, 1.5);
        const std::int64_t now = body.discreteForces()->contactState(x).touching;
        toggled += now != touching;
        touching = now;
        ++followed;
        if (!shared.certificate.holds()) continue;
        ++held;
        const double lambda = DenseTangent(body, x).largest(), certified = shared.certificate.certifiedEigenvalue();
        const std::string what = joinText(GetParam().name, ", ", law, ", ", seed, ", ", step);
        ASSERT_GE(certified, lambda * (1 - 1e-10)) << what;
        EXPECT_LE(shared.certificate.verify(x), 1e-9) << what;
        contactAbove += certified > shared.certificate.ofElements();
        tightest = std::min(tightest, certified / lambda);
      }
    }
  EXPECT_GE(2 * held, followed);
  EXPECT_GE(2 * toggled, followed);
  EXPECT_GE(8 * contactAbove, held);
  EXPECT_LE(tightest, 1.1);
  printf("%d of %d held, %d toggled, %d above the elements' part, tightest %.3f\n", held, followed, toggled,
         contactAbove, tightest);
}

TEST(ExchangeCertificate, PairsOfNodesAddUpToZero) {
  for (const Subdivision& subdivision : test::allSubdivisions()) {
    const Body body = test::boxBody(subdivision, "stvk", {3, 2, 2});
    NodalBound weights(body);
    weights.evaluate(body.mesh().X, 3);
    ExchangeWork work{};
    const double sigma = weights.last();
    const ExchangeShares shares =
        roomyExchangeShares(body, body.mesh().X, weights, nullptr, {}, nullptr, 0.9 * sigma, 0, 5, work);
    EXPECT_EQ(work.iterations, 5);
    std::map<std::array<std::int32_t, 4>, std::int64_t> sums;
    const std::int32_t* entry = shares.entries.data();
    for (const auto& block : body.blocks())
      for (std::int32_t e = 0; e < block->elementCount(); ++e)
        for (int i = 0; i < 3 * block->nodesPerElement(); ++i)
          for (int j = 0; j <= i; ++j, ++entry) {
            EXPECT_LE(std::abs(*entry), 32767);
            std::array<std::int32_t, 2> row{block->nodesOf(e)[i / 3], i % 3}, column{block->nodesOf(e)[j / 3], j % 3};
            if (row[0] < column[0]) std::swap(row, column);
            if (row[0] != column[0]) sums[{row[0], row[1], column[0], column[1]}] += *entry;
          }
    EXPECT_FALSE(sums.empty());
    for (const auto& [pair, sum] : sums) EXPECT_EQ(sum, 0) << subdivision.name;
  }
}

TEST(ExchangeCertificate, TurnsWithTheBody) {
  for (const Subdivision& subdivision : test::allSubdivisions()) {
    const Body body = test::boxBody(subdivision, "stvk", {3, 2, 2}, 0);
    NodeVectors x = body.mesh().X;
    const double lambda = DenseTangent(body, x).largest();
    Shared shared(body);
    shared.share(body, x);
    const double first = shared.certificate.certifiedEigenvalue();
    const Eigen::Matrix3d turn = Eigen::AngleAxisd(0.02, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix();
    for (int k = 0; k < 100; ++k) {
      x = turn * x;
      shared.certificate.follow(x, 1.5);
    }
    ASSERT_TRUE(shared.certificate.holds()) << subdivision.name;
    EXPECT_GE(shared.certificate.certifiedEigenvalue(), lambda) << subdivision.name;
    EXPECT_LE(shared.certificate.certifiedEigenvalue(), 1.03 * first) << subdivision.name;
    EXPECT_LE(shared.certificate.verify(x), 1e-9) << subdivision.name;
  }
}

TEST(ExchangeCertificate, EndsWithTheBodysMassesAndConstraints) {
  Body body = test::boxBody(test::allSubdivisions()[0], "stvk");
  const NodeVectors& X = body.mesh().X;
  Shared shared(body);
  shared.share(body, X);
  EXPECT_TRUE(shared.certificate.holds());
  body.addNodalMass(0, 1e-3);
  shared.certificate.follow(X, 1.5);
  EXPECT_FALSE(shared.certificate.holds());
  EXPECT_FALSE(shared.certificate.hasShares());
}

/// A bar of 2×2 cells in a cross section pulled slowly, its nodes trembling; holds and median width against dense
/// eigenvalues, % of the step.
struct Pulled {
  double median, worst, byExchange;
  std::vector<double> safe;
};
/// What a bar is pulled with, each of the order of a tenth of the stiffness that governs it.
struct Beside {
  bool springs = false, contact = false, damping = false;
};
constexpr std::string_view onePoint = "hex8_of_one_point", contrast = "of_contrast_1000";
/// With a rule and materials as the name of the subdivision says.
Body barBody(const Subdivision& subdivision, std::string_view law, double jitter, int threads) {
  constexpr std::array<int, 3> cells{6, 2, 2};
  if (subdivision.name == onePoint)
    return Body(test::box(subdivision, cells, jitter), makeMaterial(law, test::young, test::poisson, test::density),
                {{{"hex8", "uniform-strain"}}, Lumping::rowSum, threads, {0.1}});
  if (!subdivision.name.ends_with(contrast)) return test::boxBody(subdivision, law, cells, jitter, 3, threads);
  return Body(test::box(subdivision, cells, jitter),
              {makeMaterial(law, test::young, test::poisson, test::density),
               makeMaterial(law, 1000 * test::young, test::poisson, test::density)},
              test::onThreads(threads));
}
void addBeside(Body& body, const Beside& beside, bool hourglass) {
  const double highest = DenseTangent(body, body.mesh().X).largest(), share = 0.1;
  test::Random random(9);
  DiscreteForces forces(body.nodeCount());
  if (beside.springs) {
    std::vector<Spring> springs;
    for (int k = 0; k < 8; ++k) {
      Spring spring;
      spring.node = static_cast<std::int32_t>(random.index(body.nodeCount()));
      spring.stiffness = share * highest * body.lumpedMass()[spring.node];
      spring.anchor = body.mesh().X.col(spring.node);
      if (k % 2 == 1) {
        spring.other = (spring.node + 1 + random.index(body.nodeCount() - 1)) % body.nodeCount();
        spring.length = (body.mesh().X.col(spring.other) - body.mesh().X.col(spring.node)).norm();
        spring.stiffness = share * highest * std::min(body.lumpedMass()[spring.node], body.lumpedMass()[spring.other]);
      }
      springs.push_back(spring);
    }
    forces.add(springs);
  }
  if (beside.contact) {
    // A floor that the lowest nodes tremble against.
    PenaltyContact contact;
    contact.obstacle = forces.add(planeObstacle({0, 0, 0}, {0, 0, 1}));
    for (std::int32_t i = 0; i < body.nodeCount(); ++i)
      if (body.mesh().X(2, i) < 0.5 * test::cellSize) {
        contact.nodes.push_back(i);
        contact.penalty.push_back(share * highest * body.lumpedMass()[i]);
        contact.damping.push_back(0);
      }
    forces.add(std::move(contact));
    forces.setReach(1e-5);
  }
  if (beside.springs || beside.contact) body.setDiscreteForces(std::move(forces));
  if (beside.damping) {
    const double factor = std::sqrt(highest), viscosity = 0.02 * test::young / factor;
    const DampingConstants constants = hourglass ? DampingConstants{0, 0, 0, 0, 0.01 * factor, 0.05}
                                                 : DampingConstants{0.06, 1.2, viscosity, viscosity, 0.01 * factor, 0};
    body.setElementDamping(std::vector<DampingConstants>(body.blocks().size(), constants));
    body.elementDamping()->setFactor(factor);
  }
}
const MonitorOptions withoutLimit{.budget = infinity};
Pulled pulled(const Subdivision& subdivision, std::string_view law, int threads, int savedAt = -1,
              const Beside& beside = {}, double jitter = 0) {
  Body body = barBody(subdivision, law, jitter, threads);
  addBeside(body, beside, subdivision.name == onePoint);
  const NodeVectors& X = body.mesh().X;
  std::optional<StabilityMonitor> monitor(std::in_place, body, withoutLimit);
  const NodeVectors v = NodeVectors::Zero(3, body.nodeCount());
  Pulled result{};
  std::vector<double> widths;
  constexpr int steps = 400, sampleEvery = 20;
  constexpr int begun = 60;  // the first proof ends early, and a better one follows
  int by = 0;
  for (int k = 0; k < steps; ++k) {
    const double stretch = 1 + 2.5e-4 * k;
    NodeVectors x = Eigen::Vector3d(stretch, 1 - 0.3 * (stretch - 1), 1 - 0.3 * (stretch - 1)).asDiagonal() * X;
    for (Eigen::Index i = 0; i < x.cols(); ++i) {
      x(1, i) += 2e-5 * std::sin(300 * X(0, i) + 0.7 * k);
      x(2, i) += 2e-5 * std::sin(200 * X(0, i) + 0.3 * k);
    }
    body.followDampingRates(x, std::sin(0.05 * k) * (x - X) / 0.02);
    const MonitorReport& report = monitor->observe(k, k, x, v, 1e-9);
    if (!report.bracket) {
      ADD_FAILURE() << subdivision.name << ": no bracket at " << k;
      return result;
    }
    result.safe.push_back(report.bracket->safe);
    by += report.bracket->safeBy == "incremental-exchange-bound";
    if (k == savedAt) {
      const std::string saved = monitor->save();
      monitor.emplace(body, withoutLimit);
      monitor->load(saved);
    }
    if (k % sampleEvery != 0) continue;
    const double exact = 2 / std::sqrt(DenseTangent(body, x).largest());
    EXPECT_LE(report.bracket->safe, exact * (1 + 1e-10)) << subdivision.name << ", " << k;
    if (k >= begun) widths.push_back(100 * (1 - report.bracket->safe / exact));
  }
  std::sort(widths.begin(), widths.end());
  result.median = widths[widths.size() / 2];
  result.worst = widths.back();
  result.byExchange = static_cast<double>(by) / steps;
  return result;
}

TEST(ExchangeCertificate, IsTightOnRegularBarsInASlowPull) {
  for (const Subdivision& subdivision : test::allSubdivisions())
    for (const char* law : {"stvk", "neo-hookean", "corotational"}) {
      const Pulled run = pulled(subdivision, law, 1);
      // Shares are not made again for bodies of linear tetrahedra until more is gained than five a cell have to gain.
      const bool fivePerCell = subdivision.name == "tet4_5";
      EXPECT_LE(run.median, fivePerCell ? 9 : 5) << subdivision.name << ", " << law;
      EXPECT_LE(run.worst, fivePerCell ? 11 : 10) << subdivision.name << ", " << law;
    }
}

// Springs, contact that toggles and elements that damp: medians of the safe side as without, but for 4 % of the step at
// most, with one point and eight, and with a contrast of 1000; all together for every law. Of five tetrahedra a cell 5
// %: see above.
TEST(ExchangeCertificate, IsAsTightBesideSpringsContactAndDamping) {
  std::vector<Subdivision> subdivisions = test::allSubdivisions();
  subdivisions.push_back({std::string(onePoint), "hex8", 1, "", 0});
  subdivisions.push_back({"hex8_of_contrast_1000", "hex8", 1, "hex8", 1});
  subdivisions.push_back({"tet4_of_contrast_1000", "tet4", 6, "tet4", 6});
  for (const Subdivision& subdivision : subdivisions)
    for (const double jitter : {0.0, 0.2})
      for (const std::string_view law : {"stvk", "neo-hookean", "corotational"}) {
        const Pulled without = pulled(subdivision, law, 1, -1, {}, jitter);
        std::vector<Beside> all{Beside{true, true, true}};
        if (law == "stvk")
          all.insert(all.end(), {Beside{true, false, false}, Beside{false, true, false}, Beside{false, false, true}});
        for (const Beside& beside : all) {
          const Pulled with = pulled(subdivision, law, 1, -1, beside, jitter);
          EXPECT_LE(with.median, without.median + (subdivision.name == "tet4_5" ? 5.5 : 4))
              << subdivision.name << ", jitter " << jitter << beside.springs << beside.contact << beside.damping;
        }
      }
}

TEST(ExchangeCertificate, HasTheSameBitsForAnyThreadsAndWhenItGoesOnFromBytes) {
  for (const Subdivision& subdivision : test::allSubdivisions()) {
    if (subdivision.name != "tet4_6") continue;  // where weights are looser than shares
    const Pulled one = pulled(subdivision, "stvk", 1);
    EXPECT_GE(one.byExchange, 0.8);
    EXPECT_EQ(one.safe, pulled(subdivision, "stvk", 2).safe) << subdivision.name;
    EXPECT_EQ(one.safe, pulled(subdivision, "stvk", 3, 150).safe) << subdivision.name;
    const Beside all{true, true, true};
    EXPECT_EQ(pulled(subdivision, "stvk", 1, -1, all).safe, pulled(subdivision, "stvk", 3, 150, all).safe)
        << subdivision.name;
  }
}

/// A regular bar in threshold mode at 0.95 of its critical step, where weights prove nothing: it trembles, and is then
/// stretched until the step is too large. What is said at each observation, in 1 for certified, and elements refreshed.
struct Rested {
  std::vector<double> said;
  std::int64_t refreshed = 0;  // while it trembles, after the first observation
};
Rested restedOnShares(const Subdivision& subdivision, std::string_view law, double budget, int threads,
                      int savedAt = -1) {
  constexpr int trembling = 100, steps = 300, sampleEvery = 10;
  const Body body = barBody(subdivision, law, 0, threads);
  const NodeVectors& X = body.mesh().X;
  const double h = 0.95 * 2 / std::sqrt(DenseTangent(body, X).largest());
  MonitorOptions options;
  options.mode = MonitorMode::threshold;
  options.budget = budget;
  options.workInAdvance = 0;
  std::optional<StabilityMonitor> monitor(std::in_place, body, options);
  const NodeVectors v = NodeVectors::Zero(3, body.nodeCount());
  Rested result;
  for (int k = 0; k < steps; ++k) {
    const double stretch = 1 + 5e-4 * std::max(0, k - trembling);
    NodeVectors x = Eigen::Vector3d(stretch, 1, 1).asDiagonal() * X;
    for (Eigen::Index i = 0; i < x.cols(); ++i) x(1, i) += 2e-5 * std::sin(300 * X(0, i) + 0.7 * k);
    const MonitorReport& report = monitor->observe(k, k, x, v, h);
    result.said.push_back(report.verdict == Verdict::certified ? 1 : report.bracket ? report.bracket->safe : 0);
    if (k > 0 && k < trembling) result.refreshed += report.elementsRefreshed;
    if (k < trembling) {
      EXPECT_EQ(report.verdict, Verdict::certified) << subdivision.name << ", " << law << ", " << k;
    }
    if (k % sampleEvery == 0 && report.verdict == Verdict::certified) {
      EXPECT_LE(h, 2 / std::sqrt(DenseTangent(body, x).largest()) * (1 + 1e-10)) << subdivision.name << ", " << k;
    }
    if (k == savedAt) {
      const std::string saved = monitor->save();
      monitor.emplace(body, options);
      monitor->load(saved);
    }
  }
  return result;
}

TEST(ExchangeCertificate, ThresholdModeRestsOnSharesWhereWeightsDoNotProveTheStep) {
  for (const Subdivision& subdivision : test::allSubdivisions()) {
    if (subdivision.name != "tet4_6" && subdivision.name != "hex8") continue;
    for (const char* law : {"stvk", "corotational"})
      for (const double budget : {infinity, 0.1}) {
        const Rested one = restedOnShares(subdivision, law, budget, 1);
        EXPECT_EQ(one.refreshed, 0) << subdivision.name << ", " << law;
        EXPECT_EQ(one.said, restedOnShares(subdivision, law, budget, 3, 50).said) << subdivision.name << ", " << law;
        EXPECT_EQ(one.said, restedOnShares(subdivision, law, budget, 2, 220).said) << subdivision.name << ", " << law;
      }
  }
}

TEST(ExchangeCertificate, SeesEveryInversionInThresholdMode) {
  for (const Subdivision& subdivision : test::allSubdivisions()) {
    if (subdivision.name != "tet4_6" && subdivision.name != "hex8") continue;
    for (const LawInfo& law : allLaws()) {
      if (law.allowsInversion) continue;
      const Body body = barBody(subdivision, law.name, 0, 1);
      const NodeVectors& X = body.mesh().X;
      MonitorOptions options;
      options.mode = MonitorMode::threshold;
      StabilityMonitor monitor(body, options);
      const double h = 0.95 * 2 / std::sqrt(DenseTangent(body, X).largest());
      const NodeVectors v = NodeVectors::Zero(3, body.nodeCount());
      const Eigen::Vector3d across = (X.rowwise().mean() - X.col(0)) * 1.7;
      for (int step = 0; step <= 40; ++step) {
        NodeVectors x = X;
        x.col(0) += 0.025 * step * across;
        monitor.observe(step, step, x, v, h);
        const bool inverted = !(body.leastDeterminant(x).value > 0);
        const auto told = std::count_if(monitor.events().begin(), monitor.events().end(),
                                        [](const MonitorEvent& event) { return event.kind == EventKind::inverted; });
        EXPECT_EQ(told, inverted) << subdivision.name << ", " << law.name << ", " << step;
        if (inverted) break;
      }
    }
  }
}

}  // namespace
}  // namespace ringwatch
