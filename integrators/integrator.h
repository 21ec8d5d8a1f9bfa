#pragma once
#include <initializer_list>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <Eigen/SparseCore>

#include <ringwatch/base/parallel.h>
#include <ringwatch/meshes/all_finite.h>
#include <ringwatch/meshes/mesh.h>

namespace ringwatch {

/// Where a run is: time, s; positions, m, and velocities, m/s, 3×N.
struct State {
  double time = 0;
  NodeVectors x;
  NodeVectors v;
  /// Acceleration of this state, 3×N, m/s², where it is known; else empty. An integrator that begins its steps with
  /// it (Integrator::beginsWithAcceleration) need not evaluate it again. Empty it when anything else of the state, the
  /// system or its constraints is changed.
  NodeVectors a = NodeVectors(3, 0);
  /// Time, s, by which v lags: the velocity of the state is v + lag · a. 0 but between Integrator::advance and
  /// complete.
  double lag = 0;
};

/// Whether all positions and velocities are finite. threads: 0 for all that OpenMP offers.
inline bool isFinite(const State& state, int threads) {
  return allFinite(state.x, threads) && allFinite(state.v, threads);
}

/// ẍ = a(t, x, ẋ). A body under load is one (BodySystem), an oscillator another.
class SecondOrderSystem {
 public:
  virtual ~SecondOrderSystem() = default;
  /// Writes the acceleration, 3×N, m/s²; zero where motion is prescribed.
  virtual void acceleration(double time, const NodeVectors& x, const NodeVectors& v, NodeVectors& a) = 0;
  /// Whether the acceleration depends on v (damping). When it does not, schemes may pass any v.
  virtual bool velocityDependent() const { return false; }
  /// Threads that updates of its states may use; 0: all that OpenMP offers.
  virtual int threads() const { return 1; }
  /// Whether nodes are tied to rigid bodies, which do not drift along straight lines: kickAndDrift() then asks the
  /// system.
  virtual bool tiesNodes() const { return false; }
  /// Finds the motion of tied nodes over h seconds with the momenta of v + kick · a, without a change of the state.
  /// False where there is none, which is where a body turns too far for one step.
  virtual bool findTiedMotion(const State& /*state*/, double /*kick*/, const NodeVectors& /*a*/, double /*h*/) {
    return true;
  }
  /// Gives tied nodes the positions and velocities of the motion that was found last.
  virtual void placeTiedNodes(State& /*state*/) {}
};

/// Mass- and stiffness-proportional damping, C = alpha M + beta K. A mode of frequency omega (rad/s) has the damping
/// ratio ξ = alpha / (2 omega) + beta omega / 2.
struct RayleighDamping {
  double alpha = 0;  // 1/s, >= 0
  double beta = 0;   // s, >= 0
  bool any() const { return alpha != 0 || beta != 0; }
};

/// A system M a = f(t, x) - (alpha M + beta K(x)) v with K = -∂f/∂x: what implicit schemes solve with. Degrees of
/// freedom are numbered 3·node + component.
class DifferentiableSystem : public SecondOrderSystem {
 public:
  /// Mass of each node, N numbers, kg.
  virtual const Eigen::VectorXd& mass() const = 0;
  virtual RayleighDamping damping() const { return {}; }
  /// K(x) u, 3×N; constrained components of the result need not be zero.
  virtual void stiffnessProduct(const NodeVectors& x, const NodeVectors& u, NodeVectors& Ku) = 0;
  /// K(x), 3N×3N, constrained degrees of freedom included, both triangles.
  virtual Eigen::SparseMatrix<double> stiffness(const NodeVectors& x) = 0;
  /// The 3×3 diagonal blocks of K(x), N of them, N/m: for preconditioners.
  virtual void stiffnessDiagonal(const NodeVectors& x, std::vector<Eigen::Matrix3d>& blocks) {
    const Eigen::SparseMatrix<double> K = stiffness(x);
    blocks.assign(x.cols(), Eigen::Matrix3d::Zero());
    for (Eigen::Index column = 0; column < K.outerSize(); ++column)
      for (Eigen::SparseMatrix<double>::InnerIterator entry(K, column); entry; ++entry)
        if (entry.row() / 3 == column / 3) blocks[column / 3](entry.row() % 3, column % 3) = entry.value();
  }
  /// Whether the motion of a component is prescribed.
  virtual bool isConstrained(std::int32_t /*node*/, int /*component*/) const { return false; }
};

/// What an integrator declares of itself; studies hold it to that.
struct IntegratorInfo {
  std::string_view name;
  std::string_view help;
  int order;              // of the error of x at a fixed time, without damping
  int forceEvaluations;   // per step; 0 when it varies
  double imaginaryLimit;  // largest stable h·omega without damping; 0: none, infinity: stable for every step
  bool symplectic;
  bool reversible = false;  // a step forward and a step back give the state again (to rounding, without damping)
  int dampedOrder = 1;      // of the error of x when the acceleration depends on the velocity
  /// One step for ẍ = -omega² x - 2 ξ omega ẋ in (omega x, ẋ), as a function of z = h·omega and ξ, up to a similarity:
  /// limits with damping follow from it (stability_limit.h). nullptr when not declared.
  Eigen::Matrix2d (*amplification)(double z, double dampingRatio) = nullptr;
  /// Largest stable z for a damping ratio in closed form, where there is one; else nullptr.
  double (*dampedLimit)(double dampingRatio) = nullptr;
  /// With Rayleigh damping the highest mode binds, whatever the damping: Theorem 30, docs/theory/integrators.md. A step
  /// made of an upper bound of the highest eigenvalue is safe then, one made of a lower bound optimistic.
  bool highestModeBinds = false;
  /// Chooses steps of its own within h, to a tolerance.
  bool adaptive = false;
  /// Treats the two parts of an AdditiveSystem apart and takes no other system. Its limit is that of the non-stiff part
  /// when the stiff one is zero.
  bool partitioned = false;
  /// Its steps can be taken on a GPU, without damping.
  bool runsOnGpu = false;
  /// Largest stable h·omega of critical damping, on the negative real axis, where the literature gives it; else 0.
  double realLimit = 0;
  /// Positions advance by kickAndDrift() alone, which is what rigid bodies need.
  bool drifts = false;
};

/// How a step went. On failure the state is as before the step.
struct StepStatus {
  bool done = true;
  std::string reason;  // why not
};

/// Advances a State by a step; does not choose the step.
class Integrator {
 public:
  virtual ~Integrator() = default;
  virtual const IntegratorInfo& info() const = 0;
  /// Advances `state` by h seconds.
  virtual StepStatus step(SecondOrderSystem& system, State& state, double h) = 0;
  /// The same, but the state may be left with a lag: its last kick needs the acceleration at the new positions, which
  /// the caller provides in State::a, evaluated together with whatever else is wanted there. Then call complete().
  virtual StepStatus advance(SecondOrderSystem& system, State& state, double h) { return step(system, state, h); }
  /// Whether steps begin with the acceleration of the state by the system that they are given, and take State::a for it
  /// when it is not empty. They leave it empty, or as the acceleration of the new state.
  virtual bool beginsWithAcceleration() const { return false; }
  /// Forgets what is remembered from step to step: call it when the state, the system or its constraints were changed
  /// from outside.
  virtual void reset() {}
};

/// Nodes a thread updates at least: some 50 kB of state, below which waking it costs more.
inline constexpr Eigen::Index nodesOfAThread = 512;
/// Updates vectors of nodes, in parallel: update(slice), where slice(v) are the same columns of any 3×N vector. Each
/// column may depend on its own columns alone, so that results do not depend on the number of threads.
template <class Update>
void updateNodes(const SecondOrderSystem& system, Eigen::Index nodes, const Update& update) {
  parallelParts(nodes, system.threads(), nodesOfAThread, [&](Eigen::Index begin, Eigen::Index end) {
    update([=](auto& vectors) { return vectors.middleCols(begin, end - begin); });
  });
}

/// One kick and one drift, v += kick · a and x += h v, of tied nodes as their rigid bodies move. The time of the state
/// is the caller's. a: read where kick is not 0.
inline StepStatus kickAndDrift(SecondOrderSystem& system, State& state, double kick, const NodeVectors& a, double h) {
  const bool ties = system.tiesNodes();
  if (ties && !system.findTiedMotion(state, kick, a, h))
    return {false, "a rigid body turns by more than a right angle in a step, or its motion is not finite"};
  updateNodes(system, state.x.cols(), [&](auto slice) {
    if (kick != 0) slice(state.v) += kick * slice(a);
    slice(state.x) += h * slice(state.v);
  });
  if (ties) system.placeTiedNodes(state);
  return {};
}

/// The acceleration of a state, evaluated unless it has it.
inline const NodeVectors& accelerationOf(SecondOrderSystem& system, State& state) {
  if (state.a.cols() == 0) system.acceleration(state.time, state.x, state.v, state.a);
  return state.a;
}
/// Ends a step of Integrator::advance: adds the kick that the velocity lags by. Compiled once, so that it has the same
/// bits in every program.
void complete(SecondOrderSystem& system, State& state);

/// An integrator that can be made by name.
struct IntegratorEntry {
  const IntegratorInfo* info;
  std::unique_ptr<Integrator> (*make)();
};
template <class I>
constexpr IntegratorEntry integratorEntry() {
  return {&I::description, []() -> std::unique_ptr<Integrator> { return std::make_unique<I>(); }};
}

/// Integrators of several lists, by name. A program composes it from the lists of what it links:
/// IntegratorCatalog({coreIntegrators(), sundialsIntegrators()}).
class IntegratorCatalog {
 public:
  IntegratorCatalog(std::initializer_list<std::span<const IntegratorEntry>> lists);
  std::span<const IntegratorEntry> entries() const { return entries_; }
  /// nullptr when there is none of that name.
  const IntegratorInfo* find(std::string_view name) const;
  /// Throws InputError that lists the names when there is none of that name.
  std::unique_ptr<Integrator> make(std::string_view name) const;

 private:
  std::vector<IntegratorEntry> entries_;
};

/// The explicit integrators, which need nothing but this library, one line each in registry.cpp, and those that were
/// registered.
std::span<const IntegratorEntry> coreIntegrators();
/// Adds one; call it when the program starts, before any is asked for. Throws InputError when the name is taken.
void registerIntegrator(const IntegratorEntry& entry);

/// What these integrators declare.
std::span<const IntegratorInfo> allIntegrators();
/// nullptr when there is none of that name.
const IntegratorInfo* findIntegrator(std::string_view name);
/// Throws InputError that lists the names when there is none of that name.
std::unique_ptr<Integrator> makeIntegrator(std::string_view name);

}  // namespace ringwatch
