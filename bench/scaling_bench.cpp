// How cost grows: the passes of a run from a thousand to four million tetrahedra, the order of nodes in memory, threads
// over one; each with its error and, where it has one, its floor.
#include <algorithm>
#include <numeric>
#include <thread>
#include <utility>
#include <vector>

#include <Eigen/IterativeLinearSolvers>

#include <bench/needs.h>
#include <bench/runs.h>
#include <bench/support.h>
#include <ringwatch/base/error.h>
#include <ringwatch/base/median.h>
#include <ringwatch/integrators/body_system.h>
#include <ringwatch/integrators/symplectic_euler.h>
#include <ringwatch/meshes/node_order.h>
#include <ringwatch/monitor/bounds/global_frequency.h>
#include <ringwatch/monitor/bounds/nodal_bound.h>
#include <ringwatch/monitor/bounds/reduced_ring.h>
#include <ringwatch/monitor/stability_monitor.h>
#ifdef RINGWATCH_HAS_SUNDIALS
#include <ringwatch/integrators/sundials/implicit.h>
#endif

namespace ringwatch::bench {
namespace {

double nodesPerElement(const Setup& s) {
  return static_cast<double>(s.body.nodeCount()) / static_cast<double>(s.body.mesh().elementCount());
}
Need sum(const Need& a, const Need& b) { return {a.flops + b.flops, a.bytes + b.bytes}; }
/// Bytes for each node, where the body does not fit into the cache.
Need nodalBytes(const Case& c, const Setup& s, double bytes) {
  return {0, c.elements > 5000 ? bytes * nodesPerElement(s) : 0};
}

/// Step of the estimate over the true one, less one; the truth to 1e-6, once a mesh.
double stepError(const Case& c, const Setup& s, double lambda) {
  static std::map<std::pair<int, std::string>, double> known;
  const auto [entry, isNew] = known.try_emplace({c.elements, c.law}, 0.0);
  if (isNew) {
    const GlobalFrequency global = globalFrequency(s.body, s.x, 1e-6);
    entry->second = global.converged ? global.lambda : std::numeric_limits<double>::quiet_NaN();
  }
  return std::sqrt(entry->second / lambda) - 1;
}

void force(benchmark::State& state, const Case& c) {
  Setup& s = setupOf(c);
  NodeVectors f;
  s.body.internalForce(s.x, f, s.workspace);  // the first one also gets its memory
  for (auto _ : state) {
    s.body.internalForce(s.x, f, s.workspace);
    benchmark::DoNotOptimize(f.data());
    benchmark::ClobberMemory();
  }
  // Internal forces are in balance, whatever the size: their sum against the sum of their norms.
  report(state, s.body.mesh().elementCount(), f.rowwise().sum().norm() / f.colwise().norm().sum());
  reportFloor(state, s.body.mesh().elementCount(), needOf(c, s, Pass::force));
}

/// Symplectic Euler, force and update.
void explicitStep(benchmark::State& state, const Case& c) {
  Setup& s = setupOf(c);
  timeSteps(state, s);
  // Beside the force: reads x, v, the external force and 1/m, writes x and v. f need not leave the cache.
  reportFloor(state, s.body.mesh().elementCount(), sum(needOf(c, s, Pass::force), nodalBytes(c, s, 3 * 24 + 8)));
}

/// A system whose acceleration is known already.
class GivenAcceleration final : public SecondOrderSystem {
 public:
  GivenAcceleration(NodeVectors a, int threads) : a_(std::move(a)), threads_(threads) {}
  void acceleration(double, const NodeVectors&, const NodeVectors&, NodeVectors& a) override {
    if (a.cols() != a_.cols()) a = a_;  // else it is there from the step before
  }
  bool velocityDependent() const override { return false; }
  int threads() const override { return threads_; }

 private:
  NodeVectors a_;
  int threads_;
};

/// The update of symplectic Euler alone.
void update(benchmark::State& state, const Case& c) {
  Setup& s = setupOf(c);
  GivenAcceleration system(s.v, s.body.threads());
  SymplecticEuler integrator;
  State at{0, s.x, NodeVectors::Zero(3, s.x.cols())};
  integrator.step(system, at, stillStep);
  int steps = 1;
  for (auto _ : state) {
    integrator.step(system, at, stillStep);
    ++steps;
    benchmark::DoNotOptimize(at.x.data());
    benchmark::ClobberMemory();
  }
  const NodeVectors expected = steps * stillStep * s.v;
  report(state, s.body.mesh().elementCount(), relativeDifference(at.v, expected));
  Need need = nodalBytes(c, s, 5 * 24);
  need.flops = 12 * nodesPerElement(s);
  reportFloor(state, s.body.mesh().elementCount(), need);
}

/// The least that a direct method needs for the eigenvalues of a 12×12 matrix: Householder's tridiagonal form.
constexpr double tridiagonalFlops = 4.0 / 3 * 12 * 12 * 12;

/// All reduced 1-rings, pattern kept.
void reducedRing(benchmark::State& state, const Case& c) {
  Setup& s = setupOf(c);
  const double lambda = timeReducedRings(state, s);
  report(state, s.body.mesh().elementCount(), stepError(c, s, lambda));
  // Assembly; then ten blocks cut out and scaled, their places read, the matrix read again.
  Need need = needOf(c, s, Pass::assembly);
  need.flops += 10 * 18 + tridiagonalFlops;
  if (need.bytes > 0) {
    BlockMatrix pattern;
    s.body.assembleBlocks(s.x, pattern);
    need.bytes +=
        10 * 4 + 8 + static_cast<double>(pattern.valueBytes()) / static_cast<double>(s.body.mesh().elementCount());
  }
  reportFloor(state, s.body.mesh().elementCount(), need);
}

/// One evaluation of the nodal bound, its weights kept.
void nodalBound(benchmark::State& state, const Case& c) {
  Setup& s = setupOf(c);
  NodalBound bound(s.body);
  double lambda = bound.evaluate(s.x, 2).value;
  for (auto _ : state) {
    lambda = bound.evaluate(s.x, 0).value;
    benchmark::DoNotOptimize(std::as_const(lambda));
  }
  report(state, s.body.mesh().elementCount(), stepError(c, s, lambda));
  // Tangent; ten blocks scaled by two triangles each; then the nodes' sums and their 3×3 eigenvalues, a few hundred
  // operations a node. Weights are read, six numbers for each of four nodes, and incidences, 4 bytes each.
  Need need = needOf(c, s, Pass::tangent);
  need.flops += 10 * 54 + tridiagonalFlops + 4 * 12 + 200 * nodesPerElement(s);
  if (need.bytes > 0) need.bytes += 4 * (6 * 4 + 4) + 8;
  reportFloor(state, s.body.mesh().elementCount(), need);
}

/// What the certificate of a step costs along a run: threshold mode, at every step, a box pulled by a tenth of its
/// length a second at 0.8 of the critical step at rest. The observation at the start, from scratch, is counted apart.
/// `ratio` is over the step itself: a run that is watched, where the monitor works in the pass of the force, less the
/// same run alone, which takes turns with it.
void certificate(benchmark::State& state, const Case& c) {
  Body body(makeMesh(c), makeMaterial(c.law, 30e3, 0.3, 1000), {{}, Lumping::rowSum, c.threads});
  const double length = body.mesh().X.row(0).maxCoeff();
  for (std::int32_t i = 0; i < body.nodeCount(); ++i) {
    if (body.mesh().X(0, i) > 1e-9 && body.mesh().X(0, i) < length - 1e-9) continue;
    body.constraints().fix(i);
    if (body.mesh().X(0, i) > 1e-9) body.constraints().move(i, 0, 0.1 * length);
  }
  BodySystem system(body), plainSystem(body);
  SymplecticEuler integrator, plainIntegrator;
  MonitorOptions options;
  options.mode = MonitorMode::threshold;
  const double h = 0.8 * 2 / std::sqrt(globalFrequency(body, body.mesh().X, 1e-6).lambda);
  constexpr int steps = 60, turn = 20;
  double stepTime = 0, watchTime = 0, startTime = 0, certified = 0;
  for (auto _ : state) {
    StabilityMonitor monitor(body, options);
    State at = system.initialState(), plain = at;
    StepEvaluation evaluation;
    stepTime = watchTime = certified = 0;
    for (int step = 0; step <= steps; ++step) {
      const double begin = cpuSeconds();
      const bool proven = monitor.observe(step, at.time, at.x, at.v, h, &evaluation).verdict == Verdict::certified;
      const double watched = cpuSeconds();
      system.complete(at, evaluation);
      integrator.advance(system, at, h);
      if (step == 0) {
        startTime = watched - begin;
      } else {
        certified += proven;
        watchTime += cpuSeconds() - begin;
      }
      if (step % turn != 0) continue;
      const double alone = cpuSeconds();
      for (int k = step == 0 ? 1 : turn; k > 0; --k) plainIntegrator.step(plainSystem, plain, h);
      if (step > 0) stepTime += cpuSeconds() - alone;
    }
    watchTime -= stepTime;
    state.SetIterationTime(watchTime / steps);
  }
  const auto elements = static_cast<double>(body.mesh().elementCount());
  report(state, body.mesh().elementCount(), 1 - certified / steps);  // share of steps without a certificate
  state.counters["watch_ns"] = 1e9 * watchTime / steps / elements;
  state.counters["start_ns"] = 1e9 * startTime / elements;
  state.counters["ratio"] = watchTime / stepTime;
}

#ifdef RINGWATCH_HAS_SUNDIALS
/// Counts tangent products.
class CountedProducts final : public DifferentiableSystem {
 public:
  explicit CountedProducts(BodySystem& inner) : inner_(inner) {}
  void acceleration(double t, const NodeVectors& x, const NodeVectors& v, NodeVectors& a) override {
    inner_.acceleration(t, x, v, a);
  }
  bool velocityDependent() const override { return inner_.velocityDependent(); }
  const Eigen::VectorXd& mass() const override { return inner_.mass(); }
  RayleighDamping damping() const override { return inner_.damping(); }
  void stiffnessProduct(const NodeVectors& x, const NodeVectors& u, NodeVectors& Ku) override {
    ++products;
    inner_.stiffnessProduct(x, u, Ku);
  }
  Eigen::SparseMatrix<double> stiffness(const NodeVectors& x) override { return inner_.stiffness(x); }
  void stiffnessDiagonal(const NodeVectors& x, std::vector<Eigen::Matrix3d>& blocks) override {
    inner_.stiffnessDiagonal(x, blocks);
  }
  bool isConstrained(std::int32_t node, int component) const override { return inner_.isConstrained(node, component); }
  int products = 0;

 private:
  BodySystem& inner_;
};

/// A conjugate-gradient iteration of implicit Euler: everything that a step costs over its tangent products.
/// Matrix-free with block-Jacobi. Error: residual of the step's equation of motion over its inertia.
void conjugateGradients(benchmark::State& state, const Case& c) {
  Setup& s = setupOf(c);
  BodySystem inner(s.body);
  CountedProducts system(inner);
  ImplicitOptions options;
  options.linearSolve = LinearSolve::conjugateGradients;
  options.relativeTolerance = options.linearTolerance = 1e-6;
  ImplicitEuler integrator(options);
  // Ten times the explicit limit of a 1 cm cell of this material.
  const double h = 5e-3;
  const State start = inner.initialState();
  State from = start;
  from.v = 1e-2 * s.v;
  State at = from;
  integrator.step(system, at, h);
  system.products = 0;
  for (auto _ : state) {
    at = from;
    const double begin = cpuSeconds();
    integrator.step(system, at, h);
    state.SetIterationTime(cpuSeconds() - begin);
  }
  NodeVectors a;
  inner.acceleration(at.time, at.x, at.v, a);
  const NodeVectors inertia = (at.v - from.v) / h;
  const auto elements = static_cast<double>(s.body.mesh().elementCount());
  report(state, s.body.mesh().elementCount(), (inertia - a).norm() / inertia.norm());
  state.counters["iterations_each"] = static_cast<double>(system.products) / static_cast<double>(state.iterations());
  state.counters["elements"] = elements * state.counters["iterations_each"];
  // Beside the product: the inverse blocks and the mass, r, u, d and K d read, r, u and d written.
  reportFloor(state, state.counters["elements"], sum(needOf(c, s, Pass::product), nodalBytes(c, s, 72 + 8 + 5 * 24)));
}
#endif

/// The baseline: Eigen's conjugate gradients on the assembled matrix of the same step, an iteration.
void eigenConjugateGradients(benchmark::State& state, const Case& c) {
  Setup& s = setupOf(c);
  const double h = 5e-3;
  Eigen::setNbThreads(1);
  Eigen::SparseMatrix<double, Eigen::RowMajor> A = h * h * s.body.assembleTangent(s.body.mesh().X);
  for (Eigen::Index i = 0; i < A.rows(); ++i) A.coeffRef(i, i) += s.body.lumpedMass()[i / 3];
  const Eigen::VectorXd b = s.v.reshaped();
  Eigen::ConjugateGradient<decltype(A), Eigen::Lower | Eigen::Upper> solver;
  solver.setTolerance(1e-6);
  solver.compute(A);
  Eigen::VectorXd u;
  for (auto _ : state) {
    u = solver.solve(b);
    benchmark::DoNotOptimize(u.data());
  }
  report(state, s.body.mesh().elementCount(), (A * u - b).norm() / b.norm());
  state.counters["iterations_each"] = static_cast<double>(solver.iterations());
  state.counters["elements"] =
      static_cast<double>(s.body.mesh().elementCount()) * static_cast<double>(solver.iterations());
}

/// The baseline of the matrix-free product: Eigen's, of the assembled matrix.
void eigenProduct(benchmark::State& state, const Case& c) {
  Setup& s = setupOf(c);
  Eigen::setNbThreads(1);
  const Eigen::SparseMatrix<double, Eigen::RowMajor> K = s.body.assembleTangent(s.x);
  NodeVectors Kv(3, s.x.cols()), expected;
  for (auto _ : state) {
    Kv.reshaped() = K * s.v.reshaped();
    benchmark::DoNotOptimize(Kv.data());
    benchmark::ClobberMemory();
  }
  s.body.tangentProduct(s.x, s.v, expected, s.workspace);
  report(state, s.body.mesh().elementCount(), relativeDifference(Kv, expected));
}

/// Wall seconds of a call.
template <class Work>
double secondsOf(const Work& work) {
  const auto begin = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

/// A pass of several bodies, one after the other and again, so that other programs hurt all of them alike: median
/// seconds of each. work(i): the pass of body i.
template <class Work>
std::vector<double> interleaved(int bodies, const Work& work) {
  constexpr int rounds = 15;
  std::vector<std::vector<double>> seconds(bodies);
  for (int round = 0; round <= rounds; ++round)
    for (int i = 0; i < bodies; ++i) {
      const double time = secondsOf([&] { work(i); });
      if (round > 0) seconds[i].push_back(time);  // the first round is for the caches
    }
  std::vector<double> medians;
  for (auto& times : seconds) medians.push_back(median(std::move(times)));
  return medians;
}

/// Threads against one, wall time, interleaved; `ratio` is how many times as fast. Error: the largest difference of
/// their results, which must be zero.
enum class Threaded { force, product, step, reassembly, ring };
void threadsOverOne(benchmark::State& state, const Case& c, Threaded pass, int most) {
  struct Own {
    Body body;
    BodySystem system;
    SymplecticEuler integrator{};
    State at{};
    NodeVectors result{};
    Body::Workspace workspace{};
    BlockMatrix blocks{};
    ReducedRing ring;
    double highest = 0;
    Own(const Case& of, int threads)
        : body(makeMesh(of), makeMaterial(of.law, 30e3, 0.3, 1000), {{}, Lumping::rowSum, threads}),
          system(body),
          ring(body) {}
  };
  const Setup& s = setupOf(c);
  std::vector<std::unique_ptr<Own>> own;
  for (const int threads : {1, most}) {
    own.push_back(std::make_unique<Own>(c, threads));
    own.back()->at = {0, s.x, NodeVectors::Zero(3, s.x.cols())};
  }
  // A turn has several calls, as a run does: threads that have waited for a turn of one thread have gone to sleep.
  const auto calls = std::max<std::int64_t>(1, 2'000'000 / c.elements);
  std::vector<double> seconds;
  const auto once = [&](Own& o) {
    if (pass == Threaded::force) o.body.internalForce(s.x, o.result, o.workspace);
    if (pass == Threaded::product) o.body.tangentProduct(s.x, s.v, o.result, o.workspace);
    if (pass == Threaded::step) o.integrator.step(o.system, o.at, stillStep);
    if (pass == Threaded::reassembly) o.body.assembleBlocks(s.x, o.blocks);
    if (pass == Threaded::ring) o.highest = o.ring.evaluate(s.x).highest;
  };
  for (auto _ : state) {
    seconds = interleaved(2, [&](int i) {
      for (std::int64_t k = 0; k < calls; ++k) once(*own[i]);
    });
    for (double& turn : seconds) turn /= static_cast<double>(calls);
    state.SetIterationTime(seconds[1]);
  }
  double difference = 0;
  if (pass == Threaded::force || pass == Threaded::product)
    difference = (own[0]->result - own[1]->result).cwiseAbs().maxCoeff();
  if (pass == Threaded::step) difference = (own[0]->at.x - own[1]->at.x).cwiseAbs().maxCoeff();
  if (pass == Threaded::ring) difference = std::abs(own[0]->highest - own[1]->highest);
  for (std::size_t k = 0; k < own[0]->blocks.block.size(); ++k)
    difference = std::max(difference, (own[0]->blocks.block[k] - own[1]->blocks.block[k]).cwiseAbs().maxCoeff());
  report(state, s.body.mesh().elementCount(), difference);
  state.counters["one_ns"] = 1e9 * seconds[0] / static_cast<double>(s.body.mesh().elementCount());
  state.counters["ratio"] = seconds[0] / seconds[1];
}

/// A mesh with its nodes and elements in random order.
Mesh shuffled(const Mesh& mesh) {
  Random source(7);
  const auto permutation = [&](std::size_t count) {
    std::vector<std::int32_t> order(count);
    std::iota(order.begin(), order.end(), 0);
    for (std::size_t i = count; i-- > 1;) std::swap(order[i], order[source.index(static_cast<int>(i) + 1)]);
    return order;
  };
  const auto newNode = permutation(mesh.nodeCount()), oldElement = permutation(mesh.elementCount());
  Mesh result;
  result.X.resize(3, mesh.X.cols());
  for (std::size_t i = 0; i < newNode.size(); ++i) {
    result.X.col(newNode[i]) = mesh.X.col(i);
    result.nodeIds.push_back(0);
  }
  for (std::size_t i = 0; i < newNode.size(); ++i) result.nodeIds[newNode[i]] = static_cast<std::int64_t>(i);
  const MeshBlock& from = mesh.blocks[0];
  MeshBlock block{from.type, {}, {}};
  for (const std::int32_t e : oldElement) {
    block.ids.push_back(e);
    for (int a = 0; a < from.nodesPerElement(); ++a) block.connectivity.push_back(newNode[from.element(e)[a]]);
  }
  result.blocks.push_back(std::move(block));
  return result;
}
/// What the order of the nodes costs: as generated (row after row), shuffled, shuffled and renumbered; `ratio` is of
/// the last two.
void order(benchmark::State& state, const Case& c, Threaded pass) {
  const Material material = makeMaterial(c.law, 30e3, 0.3, 1000);
  const BodyOptions options{{}, Lumping::rowSum, 1};
  std::vector<std::unique_ptr<Body>> bodies;
  bodies.push_back(std::make_unique<Body>(makeMesh(c), material, options));
  bodies.push_back(std::make_unique<Body>(shuffled(bodies[0]->mesh()), material, options));
  Mesh again = bodies[1]->mesh();
  renumberNodes(again);
  bodies.push_back(std::make_unique<Body>(std::move(again), material, options));
  std::vector<std::unique_ptr<BodySystem>> systems;
  std::vector<State> at;
  Eigen::Matrix3d F;
  F << 1.1, 0.02, 0, -0.03, 0.95, 0.01, 0, 0.04, 1.02;
  for (const auto& body : bodies) {
    systems.push_back(std::make_unique<BodySystem>(*body));
    at.push_back({0, F * body->mesh().X, NodeVectors::Zero(3, body->mesh().X.cols())});
  }
  std::vector<SymplecticEuler> integrators(bodies.size());
  std::vector<NodeVectors> f(bodies.size());
  std::vector<Body::Workspace> workspaces(bodies.size());
  std::vector<SparseTangent> tangents(bodies.size());
  std::vector<double> seconds;
  for (auto _ : state) {
    seconds = interleaved(static_cast<int>(bodies.size()), [&](int k) {
      const std::size_t i = k;
      if (pass == Threaded::force) bodies[i]->internalForce(at[i].x, f[i], workspaces[i]);
      if (pass == Threaded::product) bodies[i]->tangentProduct(at[i].x, at[i].x, f[i], workspaces[i]);
      if (pass == Threaded::step) integrators[i].step(*systems[i], at[i], stillStep);
      if (pass == Threaded::reassembly) bodies[i]->assembleBlocks(at[i].x, tangents[i].blocks);
    });
    state.SetIterationTime(seconds[0]);
  }
  const std::size_t elements = bodies[0]->mesh().elementCount();
  // Node by node the results of shuffled and renumbered are the same but for the order of sums.
  double error = 0;
  if (f[2].size() > 0) {
    const std::vector<std::int64_t>&shuffledIds = bodies[1]->mesh().nodeIds, &ids = bodies[2]->mesh().nodeIds;
    NodeVectors byId[2] = {f[1], f[2]};
    for (std::size_t i = 0; i < ids.size(); ++i) {
      byId[0].col(shuffledIds[i]) = f[1].col(i);
      byId[1].col(ids[i]) = f[2].col(i);
    }
    error = relativeDifference(byId[1], byId[0]);
  }
  report(state, elements, error);
  const double ns = 1e9 / static_cast<double>(elements);
  state.counters["shuffled_ns"] = ns * seconds[1];
  state.counters["renumbered_ns"] = ns * seconds[2];
  state.counters["ratio"] = seconds[1] / seconds[2];
}

void registerAll() {
  const auto add = [](std::string_view name, const Case& c, const auto& run) {
    return benchmark::RegisterBenchmark((std::string(name) + "/" + c.name()).c_str(),
                                        [=](benchmark::State& state) { run(state, c); })
        ->Unit(benchmark::kMicrosecond);
  };
  for (const int elements : {1000, 10000, 100000, 1000000, 4000000}) {
    const Case c{"tet4", elements, "stvk", 1};
    add("sizes/force", c, force);
    add("sizes/step", c, explicitStep);
    add("sizes/update", c, update);
    add("sizes/reduced_ring", c, reducedRing);
    add("sizes/nodal_bound", c, nodalBound);
    add("sizes/certificate", c, certificate)->UseManualTime()->Iterations(1)->Repetitions(1);
    if (elements > 1000000) continue;
    add("sizes/eigen_product", c, eigenProduct);
#ifdef RINGWATCH_HAS_SUNDIALS
    add("sizes/cg_iteration", c, conjugateGradients)->UseManualTime();
#endif
    add("sizes/eigen_cg_iteration", c, eigenConjugateGradients);
  }
  const std::pair<const char*, Threaded> passes[] = {{"force", Threaded::force},
                                                     {"step", Threaded::step},
                                                     {"tangent_product", Threaded::product},
                                                     {"reassemble_blocks", Threaded::reassembly},
                                                     {"reduced_ring", Threaded::ring}};
  const int cores = static_cast<int>(std::thread::hardware_concurrency());
  for (const Case& c : {Case{"tet4", 100000, "stvk", 1}, Case{"tet4", 1000000, "stvk", 1},
                        Case{"tet4", 4000000, "stvk", 1}, Case{"hex8", 100000, "stvk", 1}})
    for (const auto& [name, pass] : passes)
      for (int threads = 2; threads <= cores; threads *= 2)
        add(joinText("threads_over_one/", name, "/", threads), c,
            [pass = pass, threads](benchmark::State& state, const Case& of) {
              threadsOverOne(state, of, pass, threads);
            })
            ->UseManualTime()
            ->Iterations(1)
            ->Repetitions(1);
  for (const int elements : {100000, 1000000}) {
    const Case c{"tet4", elements, "stvk", 1};
    for (const auto& [name, pass] : passes) {
      if (pass != Threaded::ring)
        add(std::string("order/") + name, c,
            [pass = pass](benchmark::State& state, const Case& of) { order(state, of, pass); })
            ->UseManualTime()
            ->Iterations(1)
            ->Repetitions(1);
    }
  }
}

}  // namespace
}  // namespace ringwatch::bench

int main(int argc, char** argv) { return ringwatch::bench::runBenchmarks(argc, argv, ringwatch::bench::registerAll); }
