#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <numeric>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Eigenvalues>

#include <ringwatch/base/error.h>
#include <ringwatch/base/random.h>
#include <ringwatch/distributed/halo.h>
#include <ringwatch/distributed/partition.h>
#include <ringwatch/distributed/rank_body.h>
#include <ringwatch/distributed/rank_domain.h>
#include <ringwatch/integrators/body_system.h>
#include <ringwatch/materials/registry.h>
#include <ringwatch/meshes/generators/generators.h>
#include <ringwatch/monitor/critical_step.h>
#include <ringwatch/monitor/energy_balance.h>
#include <ringwatch/monitor/incremental/part_bracket.h>
#include <ringwatch/monitor/stability_monitor.h>
#include <tests/distributed/some.h>

namespace ringwatch {
namespace {

using test::Some;
using test::worldSize;

/// A body in motion, the same on every rank.
struct Trial {
  std::unique_ptr<Body> body;
  State state;
  double h = 0;  // s
  RayleighDamping damping;
  bool verlet = false;
  std::string what;
};

Mesh twoTypes(double jitter, std::uint64_t seed, const std::array<int, 3>& cells) {
  // A box of hexahedra beside one of tetrahedra, joined at nothing: two blocks in one body.
  BarOptions options;
  options.size = {0.1, 0.05, 0.05};
  options.cells = cells;
  options.jitter = jitter;
  options.seed = seed;
  options.element = "hex8";
  Mesh mesh = generateBar(options);
  options.element = "tet4";
  const Mesh other = generateBar(options);
  const auto first = static_cast<std::int32_t>(mesh.nodeCount());
  NodeVectors X(3, mesh.X.cols() + other.X.cols());
  X << mesh.X, (other.X.colwise() + Eigen::Vector3d(0.2, 0, 0));
  mesh.X = X;
  mesh.nodeIds.clear();
  mesh.nodeSets.clear();
  mesh.elementSets.clear();
  MeshBlock block = other.blocks[0];
  for (std::int32_t& node : block.connectivity) node += first;
  mesh.blocks.push_back(block);
  return mesh;
}

Trial makeTrial(std::uint64_t seed, int threads, int most) {
  Random random(seed);
  constexpr std::string_view elements[]{"tet4", "tet4", "hex8", "tet10", "wedge6", "pyramid5", "hex20"};
  constexpr std::string_view laws[]{"stvk", "neo-hookean", "corotational", "mooney-rivlin", "stable-neo-hookean"};
  BarOptions options;
  options.size = {0.1, 0.05, 0.05};
  options.cells = {1 + random.index(most), 1 + random.index(most), 1 + random.index(most)};
  options.element = elements[random.index(std::size(elements))];
  options.jitter = random.uniform(0, 0.2);
  options.seed = seed;
  const bool mixed = random.index(5) == 0;
  const std::string_view law = laws[random.index(std::size(laws))];
  const Material material = makeMaterial(law, 1e6, 0.3, 1000);
  BodyOptions bodyOptions;
  bodyOptions.threads = threads;
  Trial trial;
  trial.body = std::make_unique<Body>(mixed ? twoTypes(options.jitter, seed, options.cells) : generateBar(options),
                                      material, bodyOptions);
  Body& body = *trial.body;
  const int constrained = random.index(4);
  for (std::int32_t i = 0; i < body.nodeCount(); ++i)
    if (body.mesh().X(0, i) < 1e-9) {
      if (constrained == 1) body.constraints().fix(i);
      if (constrained == 2) body.constraints().fix(i, 1);
      if (constrained == 3) body.constraints().move(i, 0, 0.3);
    }
  if (random.index(2) == 0) body.addBodyForce({0, 0, -9.81});
  if (random.index(4) == 0) trial.damping.alpha = 20;
  trial.verlet = random.index(2) == 0;
  trial.state = BodySystem(body).initialState();
  for (Eigen::Index i = 0; i < trial.state.v.size(); ++i) trial.state.v.data()[i] += random.uniform(-2, 2);
  body.constraints().imposeVelocity(trial.state.v);
  trial.h = criticalStep(body, body.mesh().X, 2.0).safe * random.uniform(0.3, 1.05);
  trial.what = "seed " + std::to_string(seed) + ": " + std::string(mixed ? "hex8 and tet4" : options.element) + ", " +
               std::string(law) + ", " + std::to_string(body.mesh().elementCount()) + " elements";
  return trial;
}

std::unique_ptr<Integrator> integratorOf(const Trial& trial) {
  return makeIntegrator(trial.verlet ? "verlet" : "symplectic-euler");
}

/// Parts of elements: by Scotch, at random element by element, all on one rank, or a slab each.
std::vector<std::int32_t> randomParts(const Mesh& mesh, MPI_Comm communicator, Random& random) {
  Ranks all(communicator);
  const int ranks = all.size();
  const auto count = static_cast<int>(mesh.elementCount());
  std::vector<std::int32_t> parts(mesh.elementCount());
  const int kind = random.index(4), only = random.index(ranks);
  if (kind == 0) return partitionMesh(all, mesh).ofElement;
  for (int e = 0; e < count; ++e)
    parts[e] = kind == 1 ? random.index(ranks) : kind == 2 ? only : static_cast<int>(std::int64_t{e} * ranks / count);
  return parts;
}

Partition worldPartition(const Mesh& mesh) {
  Ranks ranks(MPI_COMM_WORLD);
  return partitionMesh(ranks, mesh);
}

/// A trial on ranks.
class Distributed {
 public:
  Distributed(MPI_Comm communicator, const Trial& trial, const Partition& partition, int threads, MonitorMode mode,
              int every = 1)
      : ranks_(communicator),
        part_(*trial.body, partition, ranks_.rank(), threads),
        halo_(ranks_, part_),
        domain_(ranks_, halo_, part_),
        system_(part_.body(), trial.damping),
        integrator_(integratorOf(trial)),
        monitor_(part_.body(), {.limit = 2.0, .mode = mode, .every = every}) {
    state_.x.resize(3, part_.body().nodeCount());
    state_.v = state_.x;
    for (std::int32_t i = 0; i < part_.body().nodeCount(); ++i) {
      state_.x.col(i) = trial.state.x.col(part_.globalNode(i));
      state_.v.col(i) = trial.state.v.col(part_.globalNode(i));
    }
  }
  /// Ghosts get their positions with the next step.
  const MonitorReport& beginStep(std::int64_t k, double h) {
    const MonitorReport& report = observe(k, h);
    EXPECT_TRUE(integrator_->advance(system_, state_, h).done);
    halo_.begin(state_.x);
    return report;
  }
  const MonitorReport& step(std::int64_t k, double h) {
    const MonitorReport& report = beginStep(k, h);
    halo_.finish();
    return report;
  }
  const MonitorReport& observe(std::int64_t k, double h) {
    evaluation_.wantsForce = true;
    return monitor_.observe(k, state_.time, state_.x, state_.v, h, &evaluation_,
                            [&] { system_.complete(state_, evaluation_); });
  }
  Energies energies() { return EnergyBalance(part_.body()).evaluate(state_.x, state_.v); }
  const RankBody& part() const { return part_; }
  const State& state() const { return state_; }
  Ranks& ranks() { return ranks_; }
  Halo& halo() { return halo_; }
  StabilityMonitor& monitor() { return monitor_; }

 private:
  Ranks ranks_;
  RankBody part_;
  Halo halo_;
  RankDomain domain_;
  BodySystem system_;
  std::unique_ptr<Integrator> integrator_;
  StabilityMonitor monitor_;
  State state_;
  StepEvaluation evaluation_;
};

bool sameBits(const double* a, const double* b, std::size_t count) {
  return std::memcmp(a, b, count * sizeof(double)) == 0;
}
/// Whether a test has failed on a rank: one that stopped alone would leave the others waiting.
bool failedSomewhere() {
  int failed = ::testing::Test::HasFailure() ? 1 : 0, any = 0;
  MPI_Allreduce(&failed, &any, 1, MPI_INT, MPI_MAX, MPI_COMM_WORLD);
  return any != 0;
}
std::string textOf(const MonitorReport& report) {
  char text[400];
  std::snprintf(text, sizeof text, "%a %a %a %d:%d %s %zu", report.certified,
                report.bracket ? report.bracket->safe : -1, report.bracket ? report.bracket->optimistic : -1,
                report.bracket ? report.bracket->controlling.block : -1,
                report.bracket ? report.bracket->controlling.element : -1,
                std::string(verdictName(report.verdict)).c_str(), report.newEvents.size());
  std::string all = text;
  for (const MonitorEvent& event : report.newEvents) {
    const ElementRef e = event.element.value_or(ElementRef{-1, -1});
    std::snprintf(text, sizeof text, ", %s %a %d:%d", std::string(eventName(event.kind)).c_str(), event.value, e.block,
                  e.element);
    all += text;
  }
  return all;
}

int trials(int atLeast) {
  const char* wanted = std::getenv("RINGWATCH_DISTRIBUTED_TRIALS");
  return wanted ? std::atoi(wanted) : atLeast;
}

/// Positions are those of the program without ranks, to the last bit; what the monitor says is what it says on one
/// rank.
TEST(Distributed, HasTheBitsOfOneRankForAnyPartition) {
  constexpr int steps = 12;
  for (int k = 0; k < trials(25) && !failedSomewhere(); ++k) {
    const std::uint64_t seed = 100 + static_cast<std::uint64_t>(k);
    Random random(seed);
    const int count = 1 + random.index(worldSize()), threads = 1 + random.index(2);
    const MonitorMode mode = random.index(2) == 0 ? MonitorMode::bracket : MonitorMode::threshold;
    const Some some(count);
    if (!some.has()) continue;
    const Trial trial = makeTrial(seed, 1, 4);
    const Mesh& mesh = trial.body->mesh();
    const Partition partition = partitionOf(mesh, randomParts(mesh, some.get(), random), count);
    Distributed whole(MPI_COMM_SELF, trial, partitionOf(mesh, std::vector<std::int32_t>(mesh.elementCount(), 0), 1), 1,
                      mode);
    Distributed parts(some.get(), trial, partition, threads, mode);
    BodySystem system(*trial.body, trial.damping);
    const std::unique_ptr<Integrator> integrator = integratorOf(trial);
    State state = trial.state;
    // Some runs go unstable: then there are events, which name an element.
    const double h = trial.h * (random.index(4) == 0 ? 4 : 1);
    for (int step = 0; step < steps; ++step) {
      const std::string alone = textOf(whole.step(step, h)), together = textOf(parts.beginStep(step, h));
      EXPECT_EQ(alone, together) << trial.what << ", step " << step << ", " << count << " ranks";
      // Most exchanges end within the next observation.
      const bool early = step % 4 == 3;
      if (early) parts.halo().finish();
      const Energies one = whole.energies(), all = early ? parts.energies() : one;
      EXPECT_TRUE(sameBits(&one.kinetic, &all.kinetic, 1) && sameBits(&one.strain, &all.strain, 1)) << trial.what;
      integrator->advance(system, state, h);
      // Beyond that the order of terms decides whether an overflow is infinite or not a number; a run ends there.
      if (!state.x.allFinite() || !state.v.allFinite()) break;
      bool same = true;
      for (std::int32_t i = 0; i < (early ? parts.part().body().nodeCount() : parts.part().ownedNodes()); ++i)
        same &= sameBits(parts.state().x.col(i).data(), state.x.col(parts.part().globalNode(i)).data(), 3);
      for (std::int32_t i = 0; i < parts.part().ownedNodes(); ++i)
        same &= sameBits(parts.state().v.col(i).data(), state.v.col(parts.part().globalNode(i)).data(), 3);
      EXPECT_TRUE(same) << trial.what << ", step " << step << ", " << count << " ranks, " << threads << " threads";
      if (state.lag != 0) complete(system, state);
    }
  }
}

/// Eigenvalues of M⁻¹K over the free components, by a dense solver.
Eigen::VectorXd eigenvalues(const Body& body, const NodeVectors& x) {
  const Eigen::MatrixXd K = body.assembleTangent(x);
  std::vector<Eigen::Index> free;
  for (std::int32_t i = 0; i < body.nodeCount(); ++i)
    for (int c = 0; c < 3; ++c)
      if (!body.constraints().isConstrained(i, c)) free.push_back(3 * i + c);
  Eigen::MatrixXd A(free.size(), free.size());
  for (std::size_t r = 0; r < free.size(); ++r)
    for (std::size_t c = 0; c < free.size(); ++c)
      A(static_cast<Eigen::Index>(r), static_cast<Eigen::Index>(c)) =
          K(free[r], free[c]) / std::sqrt(body.lumpedMass()[free[r] / 3] * body.lumpedMass()[free[c] / 3]);
  return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(A, Eigen::EigenvaluesOnly).eigenvalues();
}

TEST(Distributed, BracketsTheDenseEigenvalue) {
  for (int k = 0; k < 12; ++k) {
    const std::uint64_t seed = 9000 + static_cast<std::uint64_t>(k);
    Random random(seed);
    Trial trial = makeTrial(seed, 1, 2);
    const Mesh& mesh = trial.body->mesh();
    const Partition partition = partitionOf(mesh, randomParts(mesh, MPI_COMM_WORLD, random), worldSize());
    Distributed parts(MPI_COMM_WORLD, trial, partition, 1, MonitorMode::bracket);
    BodySystem system(*trial.body, trial.damping);
    const std::unique_ptr<Integrator> integrator = integratorOf(trial);
    State state = trial.state;
    const double h = 0.3 * trial.h;
    PartBracket bracket(parts.part().body(), 0.05, false);
    StepEvaluation evaluation;
    for (int step = 0; step < 60; ++step) {
      const NodeVectors x = state.x;
      const MonitorReport& report = parts.step(step, h);
      EXPECT_TRUE(report.bracket.has_value()) << trial.what;
      if (step % 20 == 0 && report.bracket) {
        const double exact = 2 / std::sqrt(eigenvalues(*trial.body, x).maxCoeff());
        EXPECT_LE(report.bracket->safe, exact) << trial.what << ", step " << step;
        EXPECT_GE(report.bracket->optimistic, exact) << trial.what << ", step " << step;
        // Both sides are near it, or they would be worth nothing.
        EXPECT_GE(report.bracket->safe, 0.7 * exact) << trial.what << ", step " << step;
        EXPECT_LE(report.bracket->optimistic, 1.1 * exact) << trial.what << ", step " << step;
      }
      integrator->advance(system, state, h);
      if (state.lag != 0) complete(system, state);
      EXPECT_TRUE(bracket.test(parts.state().x, true, true, evaluation, {}));
      bracket.update(parts.state().x, 2.0, h);
    }
    // What has been certified holds at the state, by plain evaluation of every element and node.
    EXPECT_LE(bracket.certificate().verify(parts.state().x), 1e-9) << trial.what;
  }
}

/// A direction of negative stiffness is found where a dense solver says that there is one, and nowhere else.
TEST(Distributed, FindsIndefiniteTangents) {
  for (const char* element : {"tet4", "hex8"})
    for (const double stretch : {0.6, 0.8, 1.2}) {
      BarOptions options;
      options.size = {0.1, 0.05, 0.05};
      options.cells = {4, 2, 2};
      options.element = element;
      options.jitter = 0.1;
      Trial trial;
      trial.body = std::make_unique<Body>(generateBar(options), makeMaterial("stvk", 1e6, 0.3, 1000));
      for (std::int32_t i = 0; i < trial.body->nodeCount(); ++i)
        if (trial.body->mesh().X(0, i) < 1e-9) trial.body->constraints().fix(i);
      trial.state = BodySystem(*trial.body).initialState();
      trial.state.x.row(0) *= stretch;
      const double least = eigenvalues(*trial.body, trial.state.x).minCoeff();
      Distributed parts(MPI_COMM_WORLD, trial, worldPartition(trial.body->mesh()), 1, MonitorMode::bracket);
      const MonitorReport& report = parts.observe(0, 1e-6);
      const CriticalStep alone = criticalStep(parts.part().body(), parts.state().x, 2.0);
      ASSERT_TRUE(report.bracket);
      for (const double found : {report.bracket->lowestRing, alone.lowestRing}) {
        EXPECT_GE(found, std::min(least, 0.0) * (1 + 1e-9)) << element << ", " << stretch;
        EXPECT_EQ(found < 0, least < 0) << element << ", " << stretch << ": " << least;
      }
      ASSERT_EQ(report.newEvents.size(), least < 0 ? 1u : 0u);
      if (least < 0) {
        EXPECT_EQ(report.newEvents[0].kind, EventKind::indefinite);
        EXPECT_EQ(report.newEvents[0].value, report.bracket->lowestRing);
        EXPECT_LT(report.newEvents[0].cause->leastStretch, 0.9);
      }
      EXPECT_EQ(stretch < 1, least < 0);
    }
}

TEST(Distributed, SendsWhatTheModelSays) {
  const Trial trial = makeTrial(77, 1, 4);
  const Mesh& mesh = trial.body->mesh();
  Trial damped = makeTrial(77, 1, 4);
  damped.damping.alpha = 5;
  for (const Trial* one : {&trial, static_cast<const Trial*>(&damped)}) {
    Distributed parts(MPI_COMM_WORLD, *one, worldPartition(mesh), 1, MonitorMode::threshold);
    const double h = 0.2 * one->h;  // well below: no element leaves its allowance
    parts.beginStep(0, h);
    const Halo::Traffic before = parts.halo().traffic();
    const std::int64_t reductions = parts.ranks().reductions();
    constexpr int steps = 10;
    for (int k = 1; k <= steps; ++k) parts.beginStep(k, h);
    const Halo::Traffic& after = parts.halo().traffic();
    std::array<std::int64_t, 3> own{after.bytes - before.bytes, parts.part().ghostNodes(),
                                    after.messages - before.messages},
        all{};
    MPI_Allreduce(own.data(), all.data(), 3, MPI_INT64_T, MPI_SUM, MPI_COMM_WORLD);
    EXPECT_EQ(after.exchanges - before.exchanges, steps);
    EXPECT_EQ(all[0], steps * 24 * all[1]);
    EXPECT_EQ(after.received - before.received, 24 * steps * own[1]);
    EXPECT_LE(after.hidden - before.hidden, after.received - before.received);
    EXPECT_EQ(own[2], steps * static_cast<std::int64_t>(parts.part().neighbours().size()));
    EXPECT_EQ(parts.ranks().reductions() - reductions, steps);
  }
}

/// Energies and gathered vectors are those of the body, whose own sums are rounded.
TEST(Distributed, AddsUpAndGathers) {
  const Trial trial = makeTrial(41, 1, 3);
  const Mesh& mesh = trial.body->mesh();
  Distributed parts(MPI_COMM_WORLD, trial, worldPartition(mesh), 1, MonitorMode::bracket);
  for (int k = 0; k < 3; ++k) parts.step(k, 0.5 * trial.h);
  const NodeVectors x = gathered(parts.ranks(), parts.part(), parts.state().x),
                    v = gathered(parts.ranks(), parts.part(), parts.state().v);
  const Energies energies = parts.energies();
  if (parts.ranks().rank() != 0) {
    EXPECT_EQ(x.cols(), 0);
    return;
  }
  ASSERT_EQ(x.cols(), trial.body->nodeCount());
  Body::Workspace workspace;
  EXPECT_NEAR(energies.strain, trial.body->energy(x, workspace), 1e-13 * energies.strain);
  const double kinetic = 0.5 * (v.colwise().squaredNorm() * trial.body->lumpedMass()).value();
  EXPECT_NEAR(energies.kinetic, kinetic, 1e-13 * kinetic);
  EXPECT_GT(energies.strain, 0);
}

TEST(Distributed, RefusesWhatDoesNotFit) {
  const Trial trial = makeTrial(3, 1, 2);
  const Mesh& mesh = trial.body->mesh();
  EXPECT_THROW(partitionMesh(mesh, 0), InputError);
  EXPECT_THROW(partitionOf(mesh, {0}, 1), InputError);
  EXPECT_THROW(partitionOf(mesh, std::vector<std::int32_t>(mesh.elementCount(), 2), 2), InputError);
  Ranks ranks(MPI_COMM_SELF);
  RankBody part(*trial.body, partitionMesh(mesh, 1), 0);
  Halo halo(ranks, part);
  RankDomain domain(ranks, halo, part);
  EXPECT_THROW(StabilityMonitor(part.body(), {.mode = MonitorMode::metric, .metric = "single-element"}), InputError);
  StabilityMonitor monitor(part.body(), {});
  EXPECT_THROW(monitor.save(), InputError);
}

/// One rank whose state is not finite is known to all.
TEST(Distributed, KnowsOfTheOthers) {
  const Trial trial = makeTrial(12, 1, 3);
  Distributed parts(MPI_COMM_WORLD, trial, worldPartition(trial.body->mesh()), 1, MonitorMode::bracket);
  const bool last = parts.ranks().rank() == parts.ranks().size() - 1;
  NodeVectors x = parts.state().x;
  StepEvaluation evaluation;
  EXPECT_NE(parts.monitor().observe(0, 0, x, parts.state().v, trial.h, &evaluation).verdict, Verdict::violated);
  EXPECT_TRUE(parts.monitor().stateIsFinite());
  if (last) x(0, 0) = std::nan("");
  const MonitorReport& report = parts.monitor().observe(1, 0, x, parts.state().v, trial.h, &evaluation);
  EXPECT_FALSE(parts.monitor().stateIsFinite());
  EXPECT_EQ(report.verdict, Verdict::violated);
  EXPECT_FALSE(report.bracket.has_value());
  ASSERT_EQ(report.newEvents.size(), 1u);
  EXPECT_EQ(report.newEvents[0].kind, EventKind::nonFinite);
}

TEST(Ranks, SumsAreExact) {
  Ranks ranks(MPI_COMM_WORLD);
  ExactSum sum;
  if (ranks.rank() == 0) sum.add(1e300);
  if (ranks.rank() == ranks.size() - 1) {
    sum.add(-1e300);
    sum.add(3);
  }
  ranks.sum({&sum, 1});
  EXPECT_EQ(sum.value(), 3);
  double numbers[2]{static_cast<double>(ranks.rank()), ranks.rank() == 0 ? std::nan("") : 1.0};
  ranks.largest(numbers);
  EXPECT_EQ(numbers[0], ranks.size() - 1);
  EXPECT_TRUE(std::isnan(numbers[1]));
}

}  // namespace
}  // namespace ringwatch
