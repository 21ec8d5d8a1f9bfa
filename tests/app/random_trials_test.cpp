// Random bodies in random states and along short runs: materials whose stiffness and density differ by up to nine
// powers of ten, springs, point masses, dashpots, contact that comes and goes, damping of elements and Rayleigh's. The
// bracket of the critical step against the exact one, from matrices that are assembled here and dense eigenvalues.
//   RINGWATCH_STATE_CHECKS=N   goes on until N elements in states have been tried (by default some thousands)
//   RINGWATCH_WATCHED_RUNS=N   watches N runs with random options
//   RINGWATCH_SEED=S           other bodies, so that processes side by side try different ones
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <initializer_list>
#include <iostream>
#include <memory>
#include <numeric>
#include <utility>

#include <ringwatch/app/scene/integrator_catalog.h>
#include <ringwatch/base/error.h>
#include <ringwatch/base/infinity.h>
#include <ringwatch/body/discrete_forces.h>
#include <ringwatch/integrators/body_system.h>
#include <ringwatch/monitor/critical_step.h>
#include <ringwatch/monitor/incremental/run_bracket.h>
#include <ringwatch/monitor/stability_monitor.h>
#include <tests/monitor/monitor_cases.h>
#include <tests/support/dense.h>

namespace ringwatch {
namespace {

using Eigen::Matrix3d;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

/// What the safe side is of the exact step at least, at rest with the rule's reference there: springs between nodes and
/// damping that shares none of the stiffness' weights cost most.
constexpr double leastAtRest = 0.2;
constexpr double exact = 1e-9;  // of dense eigenvalues and of the contrast of the matrices, relative

/// A power of ten, uniform in its exponent.
double power(test::Random& random, double low, double high) { return std::pow(10.0, random.uniform(low, high)); }

/// A box whose elements are dealt out to up to three blocks.
Mesh randomMesh(test::Random& random) {
  static const std::vector<test::Subdivision> subdivisions = test::allSubdivisions();
  const test::Subdivision& subdivision = subdivisions[random.index(static_cast<int>(subdivisions.size()))];
  std::array<int, 3> cells;
  for (int& n : cells) n = 1 + static_cast<int>(random.index(2));
  if (!subdivision.other.empty()) cells[0] = 2;
  Mesh mesh = test::box(subdivision, cells, random.uniform(0, 0.25), random.index(1 << 20));
  std::vector<MeshBlock> blocks;
  for (const MeshBlock& from : mesh.blocks) {
    const auto parts = 1 + random.index(3);
    std::vector<MeshBlock> own(parts, MeshBlock{from.type, {}, {}});
    for (std::size_t e = 0; e < from.elementCount(); ++e) {
      MeshBlock& to = own[random.index(static_cast<int>(parts))];
      to.ids.push_back(from.id(e));
      to.connectivity.insert(to.connectivity.end(), from.element(e), from.element(e) + from.nodesPerElement());
    }
    for (MeshBlock& block : own)
      if (!block.ids.empty()) blocks.push_back(std::move(block));
  }
  mesh.blocks = std::move(blocks);
  mesh.elementSets.clear();
  return mesh;
}

/// A body of laws that all have a tangent in every state without inverted elements.
Body randomBody(test::Random& random) {
  Mesh mesh = randomMesh(random);
  std::vector<Material> materials;
  const double contrast = random.index(3) == 0 ? 0 : 4.5;
  for (std::size_t b = 0; b < mesh.blocks.size(); ++b) {
    const auto laws = allLaws();
    const double poissons[] = {0.3, 0, 0.45, 0.49, -0.2};
    materials.push_back(makeMaterial(laws[random.index(static_cast<int>(laws.size()))].name,
                                     test::young * power(random, -contrast, contrast), poissons[random.index(5)],
                                     test::density * power(random, -contrast, contrast)));
  }
  BodyOptions options = test::onThreads(1);
  if (random.index(3) == 0) options.rules["hex8"] = "uniform-strain";
  Body body(std::move(mesh), materials, options);
  for (auto masses = random.index(4); masses > 0; --masses) {
    const auto node = static_cast<std::int32_t>(random.index(body.nodeCount()));
    body.addNodalMass(node, body.lumpedMass()[node] * power(random, -2, 4));
  }
  for (auto held = random.index(5); held > 0; --held)
    body.constraints().fix(static_cast<std::int32_t>(random.index(body.nodeCount())),
                           static_cast<int>(random.index(3)));
  return body;
}

/// The stiffness and the mass of a node that counts most, for forces that are of its order.
struct Scale {
  double stiffness, mass, frequency;
};
Scale scaleOf(const Body& body, test::Random& random) {
  const auto node = static_cast<std::int32_t>(random.index(body.nodeCount()));
  BlockMatrix K;
  body.assembleBlocks(body.mesh().X, K);
  const double stiffness = diagonalBlock(K, node).trace() / 3, mass = body.lumpedMass()[node];
  return {stiffness, mass, std::sqrt(stiffness / mass)};
}

void addDamping(Body& body, test::Random& random) {
  std::vector<DampingConstants> constants;
  for (const auto& block : body.blocks()) {
    DampingConstants own;
    const double modulus = block->material().restModulus(),
                 time = test::cellSize / block->material().waveSpeed() * power(random, -2, 0.5);
    if (random.index(2)) own.linearBulk = power(random, -2, 0);
    if (random.index(2)) own.quadraticBulk = power(random, -1, 0.5);
    if (random.index(3) == 0) own.shearViscosity = time * modulus * random.uniform(0, 1);
    if (random.index(3) == 0) own.volumeViscosity = time * modulus * random.uniform(0, 1);
    if (random.index(3) == 0) own.massProportional = random.uniform(0, 1) / time;
    if (block->rule().uniformStrain && random.index(2)) own.hourglassViscosity = power(random, -2, 0);
    constants.push_back(own);
  }
  body.setElementDamping(constants);
}

/// What an obstacle is, for forces that are computed here once more: a sphere where it has a radius, else a plane.
struct Shape {
  Vector3d point, normal;
  double radius = 0;
  bool hollow = false;
};

std::vector<Shape> addForces(Body& body, test::Random& random) {
  std::vector<Shape> shapes;
  DiscreteForces forces(body.nodeCount());
  std::vector<Spring> springs;
  const auto damps = [&] { return random.index(2) ? power(random, -3, 0) : 0.0; };
  for (auto count = random.index(5); count > 0; --count) {
    const Scale scale = scaleOf(body, random);
    Spring spring;
    spring.node = static_cast<std::int32_t>(random.index(body.nodeCount()));
    spring.stiffness = scale.stiffness * power(random, -3, 1);
    spring.damping = damps() * scale.stiffness / scale.frequency;
    spring.anchor = body.mesh().X.col(spring.node);
    switch (random.index(3)) {
      case 0:
        spring.direction = random.vector(1).normalized();
        break;
      case 1:
        spring.other =
            static_cast<std::int32_t>((spring.node + 1 + random.index(body.nodeCount() - 1)) % body.nodeCount());
        spring.length = random.index(3) ? random.uniform(0.5, 1.5) * test::cellSize : 0;
        break;
      default:
        break;
    }
    springs.push_back(spring);
  }
  forces.add(springs);
  const Vector3d low = body.mesh().X.rowwise().minCoeff(), high = body.mesh().X.rowwise().maxCoeff();
  const auto touch = [&](const Shape& shape) {
    shapes.push_back(shape);
    const Scale scale = scaleOf(body, random);
    PenaltyContact contact;
    contact.obstacle = forces.add(shape.radius > 0 ? sphereObstacle(shape.point, shape.radius, shape.hollow)
                                                   : planeObstacle(shape.point, shape.normal));
    contact.nodes.resize(body.nodeCount());
    std::iota(contact.nodes.begin(), contact.nodes.end(), 0);
    contact.penalty.assign(body.nodeCount(), scale.stiffness * power(random, -3, 1));
    contact.damping.assign(body.nodeCount(), damps() * scale.stiffness / scale.frequency);
    forces.add(std::move(contact));
  };
  const double edge = test::cellSize;
  const Vector3d middle = 0.5 * (low + high), none = Vector3d::Zero();
  if (random.index(2)) touch({low - Vector3d(0, 0, 0.02 * edge), {0, 0, 1}});
  if (random.index(2)) touch({high + Vector3d(0.02 * edge, 0, 0), Vector3d(-1, -0.3, 0.2).normalized()});
  if (random.index(3) == 0) touch({middle + Vector3d(0, 2.2, 0) * edge, none, random.uniform(0.8, 1.5) * edge, false});
  if (random.index(4) == 0) touch({middle, none, 0.6 * (high - low).norm(), true});
  body.setDiscreteForces(std::move(forces));
  return shapes;
}

/// K and C of a body at positions and velocities, assembled here: elements one by one, bulk viscosity at the very
/// velocities, springs and contact by their own formulas.
struct Matrices {
  MatrixXd K, C;
  Matrices(Body& body, const NodeVectors& x, const NodeVectors& v, const std::vector<Shape>& shapes) {
    const Eigen::Index size = 3 * body.nodeCount();
    K = C = MatrixXd::Zero(size, size);
    const auto factor = body.elementDamping() ? body.elementDamping()->factor() : 0.0;
    for (std::size_t b = 0; b < body.blocks().size(); ++b)
      for (std::int32_t e = 0; e < body.blocks()[b]->elementCount(); ++e) addElement(body, {b, e}, x, v, factor);
    if (body.elementDamping()) body.elementDamping()->setFactor(factor);
    if (const DiscreteForces* forces = body.discreteForces()) {
      for (const Spring& spring : forces->springs()) addSpring(spring, x);
      for (const PenaltyContact& contact : forces->contacts()) addContact(shapes[contact.obstacle], contact, x);
    }
  }

 private:
  void addElement(Body& body, ElementRef e, const NodeVectors& x, const NodeVectors& v, double factor) {
    const auto nodes = body.blocks()[e.block]->nodesOf(e.element);
    const auto add = [&](MatrixXd& to, const MatrixXd& own) {
      for (std::size_t a = 0; a < nodes.size(); ++a)
        for (std::size_t c = 0; c < nodes.size(); ++c)
          to.block<3, 3>(3 * nodes[a], 3 * nodes[c]) +=
              own.block<3, 3>(3 * static_cast<Eigen::Index>(a), 3 * static_cast<Eigen::Index>(c));
    };
    const DampedBlock* damped = body.elementDamping() ? body.elementDamping()->blocks()[e.block] : nullptr;
    if (!damped || !(factor > 0)) return add(K, body.elementTangent(e, x));
    body.elementDamping()->setFactor(factor);
    MatrixXd damping = body.elementTangent(e, x);
    body.elementDamping()->setFactor(0);
    const MatrixXd alone = body.elementTangent(e, x);
    add(K, alone);
    damping = (damping - alone) / factor;
    if (damped->constants().bulk()) {
      const std::int32_t place = damped->layout().batchOfElement[e.element];
      double volumes[lanes], rest[lanes];
      std::vector<double> gradient(3 * nodes.size() * lanes);
      damped->volumeGradient(place / lanes, x.data(), volumes, gradient.data());
      damped->volumeBatch(place / lanes, rest);
      const int lane = place % lanes;
      VectorXd w(3 * nodes.size()), own(3 * nodes.size());
      for (Eigen::Index k = 0; k < w.size(); ++k) w[k] = gradient[k * lanes + lane];
      for (std::size_t a = 0; a < nodes.size(); ++a) own.segment<3>(3 * static_cast<Eigen::Index>(a)) = v.col(nodes[a]);
      const Material& material = damped->material();
      const double volume = std::max(volumes[lane], 0.1 * rest[lane]), length = std::cbrt(rest[lane]),
                   speed = material.waveSpeed(), rate = w.dot(own) / volume;
      const double needed = damped->constants().linearBulk +
                            2 * std::pow(damped->constants().quadraticBulk, 2) * length / speed * std::max(-rate, 0.0);
      damping -= (damped->coefficient(place) - needed) * material.density * rest[lane] * speed * length /
                 (volume * volume) * w * w.transpose();
    }
    add(C, damping);
  }
  void addPair(MatrixXd& to, std::int32_t i, std::int32_t j, const Matrix3d& block) {
    to.block<3, 3>(3 * i, 3 * i) += block;
    if (j < 0) return;
    to.block<3, 3>(3 * j, 3 * j) += block;
    to.block<3, 3>(3 * i, 3 * j) -= block;
    to.block<3, 3>(3 * j, 3 * i) -= block;
  }
  void addSpring(const Spring& s, const NodeVectors& x) {
    Matrix3d along = Matrix3d::Identity(), across = Matrix3d::Zero();
    if (s.other < 0 && s.direction) along = *s.direction * s.direction->transpose();
    if (s.other >= 0 && s.length > 0) {
      const Vector3d line = x.col(s.other) - x.col(s.node);
      const Vector3d t = line.normalized();
      along = t * t.transpose();
      across = (1 - s.length / line.norm()) * (Matrix3d::Identity() - along);
    }
    addPair(K, s.node, s.other, s.stiffness * (along + across));
    addPair(C, s.node, s.other, s.damping * along);
  }
  void addContact(const Shape& shape, const PenaltyContact& contact, const NodeVectors& x) {
    for (std::size_t k = 0; k < contact.nodes.size(); ++k) {
      const std::int32_t node = contact.nodes[k];
      Vector3d normal = shape.normal;
      double gap = normal.dot(x.col(node) - shape.point);
      Matrix3d curvature = Matrix3d::Zero();
      if (shape.radius > 0) {
        const Vector3d from = x.col(node) - shape.point;
        const double distance = from.norm(), sign = shape.hollow ? -1 : 1;
        normal = sign * from / distance;
        gap = sign * (distance - shape.radius);
        curvature = sign / distance * (Matrix3d::Identity() - normal * normal.transpose());
      }
      if (!(gap < 0)) continue;
      const Matrix3d along = normal * normal.transpose();
      K.block<3, 3>(3 * node, 3 * node) += contact.penalty[k] * (along + gap * curvature);
      C.block<3, 3>(3 * node, 3 * node) += contact.damping[k] * along;
    }
  }
};

/// Runs that explode are left where the squares of their tangents leave single precision, in which bounds are kept:
/// there is no bracket beyond.
constexpr double largestTangent = 1e17;  // N/m

/// Whether an element is flattened to a line, to the rounding of the law's rotation: the two least singular values of
/// its deformation gradient, the last signed as the determinant, sum to almost nothing. A corotational law then has no
/// rotation that is known.
bool isFlattenedToALine(const Body& body, const NodeVectors& x) {
  constexpr double leastWidth = 1e-5;  // of the largest singular value
  for (const auto& block : body.blocks())
    for (std::int32_t e = 0; e < block->elementCount(); ++e) {
      std::vector<std::int32_t> pack(lanes, -1);
      pack[0] = e;
      std::vector<double> F(9 * lanes * block->rule().points.size());
      TangentDrift drift[lanes];
      block->deformationOf(pack.data(), x.data(), F.data(), drift);
      for (std::size_t q = 0; q < block->rule().points.size(); ++q) {
        Matrix3d own;
        for (int i = 0; i < 9; ++i) own(i / 3, i % 3) = F[(9 * q + i) * lanes];
        const Vector3d s = own.jacobiSvd().singularValues();
        if (s[1] + (own.determinant() < 0 ? -s[2] : s[2]) < leastWidth * s[0]) return true;
      }
    }
  return false;
}

/// What dense eigenvalues say of M - h/2 C - h²/4 K on the free components, C with Rayleigh's.
struct Exact {
  double step = 0;  ///< the largest h with it ≽ 0; 0 where there is none or a matrix is not finite
  /// K has no negative direction, or nothing damps: the steps below `step` are stable then, and those above are not.
  bool decides = true;
  bool holdsAtReference = false;  ///< it is ≽ 0 at the reference step

  /// The largest step that may be called safe, and the least that may be called unstable, s.
  double mostSafe(double reference) const { return decides ? step : holdsAtReference ? infinity : reference; }
  double leastUnstable(double reference) const { return decides ? step : holdsAtReference ? reference : 0; }
};

/// By dense eigenvalues at steps that come down to the limit.
Exact exactStep(const Body& body, const Matrices& matrices, const RayleighDamping& rayleigh, double reference) {
  std::vector<Eigen::Index> free;
  for (std::int32_t i = 0; i < body.nodeCount(); ++i)
    for (int c = 0; c < 3; ++c)
      if (!body.constraints().isConstrained(i, c)) free.push_back(3 * i + c);
  const MatrixXd K = matrices.K(free, free), Cx = matrices.C(free, free);
  Exact result;
  if (free.empty() || !K.allFinite() || !Cx.allFinite()) return result;
  if (!((K + 2 / reference * Cx).cwiseAbs().maxCoeff() < largestTangent)) return result;
  MatrixXd M = MatrixXd::Zero(K.rows(), K.cols());
  for (std::size_t k = 0; k < free.size(); ++k)
    M(static_cast<Eigen::Index>(k), static_cast<Eigen::Index>(k)) = body.lumpedMass()[free[k] / 3];
  const MatrixXd C = rayleigh.alpha * M + rayleigh.beta * K + Cx;
  double h = reference;
  for (int iteration = 0; iteration < 60; ++iteration) {
    const auto modes = test::generalizedEigen(K + 2 / h * C, M);
    if (iteration == 0) result.holdsAtReference = modes.values[K.rows() - 1] <= 4 / (h * h);
    const VectorXd u = modes.vectors.col(K.rows() - 1);  // of unit length in M
    const double k = u.dot(K * u), c = u.dot(C * u);
    if (!(k + 2 / h * c > 0)) return result;
    const double next = 8 / (2 * c + std::sqrt(4 * c * c + 16 * k));
    if (!(next > 0)) return result;
    if (std::abs(next - h) <= 1e-13 * h || C.isZero(0)) {
      result.step = next;
      break;
    }
    h = next;
  }
  if (!C.isZero(0)) {
    const VectorXd own = test::generalizedEigen(K, M).values;
    result.decides = own[0] >= -1e-9 * own[own.size() - 1];
  }
  return result;
}

struct Tally {
  std::int64_t trials = 0;  // elements in states
  std::int64_t states = 0, alongRuns = 0, damped = 0, toggled = 0, indefinite = 0, skipped = 0, wrong = 0;
  std::int64_t loaded = 0;          // observations by a monitor that was loaded, and by the one that it is to go on as
  double tightest = 0, widest = 1;  // largest and least safe side over the exact step, and the least at rest with the
  double widestAtRest = 1;          // reference there
};

/// Whether the bracket holds the exact step; where K has a negative direction, whether it is right about the reference.
bool compare(const std::optional<CriticalStep>& step, const Exact& exactly, double reference, const std::string& what,
             Tally& tally) {
  ++tally.states;
  const double h = exactly.step;
  if (step && !exactly.decides) ++tally.indefinite;
  const bool right = step && step->safe <= exactly.mostSafe(reference) * (1 + exact) &&
                     step->optimistic >= exactly.leastUnstable(reference) * (1 - exact);
  if (right) {
    if (!exactly.decides) return true;
    tally.tightest = std::max(tally.tightest, step->safe / h);
    tally.widest = std::min(tally.widest, step->safe / h);
    return true;
  }
  ++tally.wrong;
  ADD_FAILURE() << what << ": "
                << (step ? joinText("safe ", step->safe / h, ", optimistic ", step->optimistic / h, " of the exact ", h,
                                    exactly.decides ? "" : ", K indefinite")
                         : std::string("no bracket"));
  return false;
}

/// A random body with its forces and damping, and the rule of a random integrator for it.
struct Trial {
  Body body;
  std::vector<Shape> shapes;
  RayleighDamping rayleigh;
  double undamped;   // s, the step at rest without Rayleigh's damping; 0: there is none
  double reference;  // s, of the rule
  bool tight;        // the reference is the exact step at rest, where the bracket is to be tight
  const IntegratorInfo* info;
  StepRule rule = 2.0;
  bool damped;
  bool dashpots;  // whether the rule is for springs, contact and elements that damp

  explicit Trial(test::Random& random) : body(randomBody(random)) {
    if (random.index(3)) addDamping(body, random);
    if (random.index(3)) shapes = addForces(body, random);
    dashpots = (body.discreteForces() && body.discreteForces()->damped()) || body.elementDamping();
    // Of a body without any other damping the order of its step.
    undamped = exactAt(body.mesh().X, still(), {}, 1).step;
    if (!(undamped > 0)) return;
    if (random.index(3) == 0) rayleigh = {random.uniform(0, 0.5) / undamped, random.uniform(0, 0.5) * undamped};
    tight = random.index(2) == 0;
    reference = undamped * power(random, -0.7, 0.3);
    if (body.elementDamping()) body.elementDamping()->setFactor(1 / undamped);
    if (tight) reference = exactAt(body.mesh().X, still(), rayleigh, undamped).step;
    const double factor = dampingFactor(rayleigh, reference);
    if (body.discreteForces()) body.discreteForces()->setDampingFactor(factor);
    if (body.elementDamping()) body.elementDamping()->setFactor(factor);
    info = integratorCatalog().find(random.index(2) ? "verlet" : "symplectic-euler");
    rule = dashpots ? stepRuleWithDashpots(*info, rayleigh, reference,
                                           body.elementDamping() ? body.elementDamping()->overcount() : 0)
                    : stepRule(*info, rayleigh);
    damped = dashpots || rayleigh.any();
  }
  /// Other springs and obstacles, where the rule is for such as damp.
  void changeForces(test::Random& random) {
    if (!dashpots) return;
    shapes = addForces(body, random);
    body.discreteForces()->setDampingFactor(dampingFactor(rayleigh, reference));
  }
  NodeVectors still() const { return NodeVectors::Zero(3, body.nodeCount()); }
  std::int64_t elements() const { return static_cast<std::int64_t>(body.mesh().elementCount()); }
  Exact exactAt(const NodeVectors& x, const NodeVectors& v) { return exactAt(x, v, rayleigh, reference); }

 private:
  Exact exactAt(const NodeVectors& x, const NodeVectors& v, const RayleighDamping& damping, double at) {
    return exactStep(body, Matrices(body, x, v, shapes), damping, at);
  }
};

void tryOne(test::Random& random, const std::string& what, Tally& tally) {
  Trial trial(random);
  if (!(trial.undamped > 0)) {
    ++tally.skipped;
    return;
  }
  Body& body = trial.body;
  const double reference = trial.reference;
  const StepRule& rule = trial.rule;
  const auto count = [&] {
    tally.trials += trial.elements();
    tally.damped += trial.damped;
  };
  const NodeVectors& X = body.mesh().X;
  const NodeVectors still = trial.still();

  // From scratch at rest, and in a state far from it.
  const auto fromScratch = [&](const NodeVectors& x) -> std::optional<CriticalStep> {
    try {
      return criticalStep(body, x, rule);
    } catch (const NumericalError& fault) {
      ADD_FAILURE() << what << ": " << fault.what();
      return std::nullopt;
    }
  };
  if (trial.tight) {
    if (body.elementDamping()) body.elementDamping()->forgetRates();
    const std::optional<CriticalStep> step = fromScratch(X);
    if (!compare(step, trial.exactAt(X, still), reference, what + ", at rest", tally)) return;
    tally.widestAtRest = std::min(tally.widestAtRest, step->safe / reference);
    count();
  }
  const auto states = test::deformedStates(X, random.index(1 << 20));
  const NodeVectors x = states[random.index(static_cast<int>(states.size()))].x,
                    v = random.nodeVectors(X.cols(), 0.3 * test::cellSize / reference * power(random, -4, 0));
  body.followDampingRates(x, v);
  if (const Exact own = trial.exactAt(x, v); own.step > 0) {
    if (!compare(fromScratch(x), own, reference, what + ", from scratch", tally)) return;
    count();
  } else {
    ++tally.skipped;
  }

  // Along a run whose nodes move by some hundredths of a cell a step.
  if (body.elementDamping()) body.elementDamping()->forgetRates();
  RunBracket bracket(body, random.index(2) ? 0.05 : 0.02, random.index(4) ? infinity : 0.1);
  BodySystem system(body, trial.rayleigh);
  const std::unique_ptr<Integrator> integrator = integratorCatalog().make(trial.info->name);
  State state{0, X, still};
  const double h = 0.3 * trial.undamped;
  const double speed = power(random, -3, -1) * test::cellSize / h;
  state.v = random.nodeVectors(X.cols(), 0.3 * speed);
  state.v.colwise() += random.vector(speed);
  body.constraints().clearConstrained(state.v);
  std::int64_t touching = 0;
  for (int k = 0; k < 12; ++k) {
    body.followDampingRates(state.x, state.v);
    if (body.discreteForces()) {
      body.discreteForces()->setReach(random.index(2) ? 2 * h * body.discreteForces()->largestSpeed(state.v) : 0);
      const std::int64_t now = body.discreteForces()->contactState(state.x).touching;
      tally.toggled += now != touching;
      touching = now;
    }
    const Exact own = trial.exactAt(state.x, state.v);
    if (!(own.step > 0)) {
      ++tally.skipped;
      return;
    }
    if (!compare(bracket.evaluate(state.x, rule, std::nullopt, nullptr), own, reference, joinText(what, ", step ", k),
                 tally))
      return;
    count();
    ++tally.alongRuns;
    if (!integrator->step(system, state, std::min(h, 0.9 * own.step)).done || !isFinite(state, 1)) return;
  }
}

/// What the report of an observation says of the step h, if one is taken, and of all others.
bool isRight(const MonitorReport& report, MonitorMode mode, std::optional<double> h, const Exact& exactly,
             double reference, const std::string& what, Tally& tally) {
  if (mode == MonitorMode::bracket || report.bracket)
    if (!compare(report.bracket, exactly, reference, what, tally)) return false;
  const double most = exactly.mostSafe(reference) * (1 + exact), least = exactly.leastUnstable(reference) * (1 - exact);
  const bool right = report.certified <= most && (!h || report.verdict != Verdict::certified || *h <= most) &&
                     (!h || report.verdict != Verdict::violated || *h >= least);
  if (right) return true;
  ++tally.wrong;
  ADD_FAILURE() << what << ": " << report.certified << " s is certified, and h = " << h.value_or(0) << " s "
                << verdictName(report.verdict) << ", of the exact " << exactly.step << " s"
                << (exactly.decides ? "" : joinText(", K indefinite, reference ", reference, " s"));
  return false;
}

/// A run that is watched with random options, by its own force or by the monitor's pass; in which the step is chosen
/// anew, the body stays or is put elsewhere, is held, freed or laden, meets others, and the monitor is saved and
/// loaded.
class WatchedRun {
 public:
  WatchedRun(test::Random& random, std::string what, Tally& tally)
      : random_(random), what_(std::move(what)), tally_(tally), trial_(random) {}

  void run() {
    if (!(trial_.undamped > 0)) {
      ++tally_.skipped;
      return;
    }
    chooseOptions();
    Body& body = trial_.body;
    if (body.elementDamping()) body.elementDamping()->forgetRates();
    monitor_ = std::make_unique<StabilityMonitor>(body, options_);
    BodySystem system(body, trial_.rayleigh);
    const std::unique_ptr<Integrator> integrator = integratorCatalog().make(trial_.info->name);
    stride_ = trial_.undamped * power(random_, -2, -0.5);
    state_ = {0, body.mesh().X, trial_.still()};
    state_.v = random_.nodeVectors(body.nodeCount(), test::cellSize / stride_ * power(random_, -4, -1.5));
    for (int k = 0; k < steps; ++k) {
      change();
      body.constraints().clearConstrained(state_.v);
      body.followDampingRates(state_.x, state_.v);
      if (DiscreteForces* const forces = body.discreteForces())
        forces->setReach(random_.index(2) ? 2 * stride_ * options_.every * forces->largestSpeed(state_.v) : 0);
      const Exact exactly = trial_.exactAt(state_.x, state_.v);
      if (!(exactly.step > 0)) {
        ++tally_.skipped;
        return;
      }
      if (!observe(k, exactly)) return;
      if (rest_ > 0)
        --rest_;
      else if (!integrator->step(system, state_, std::min(stride_, 0.9 * exactly.step)).done || !isFinite(state_, 1))
        return;
    }
  }

 private:
  double oneOf(std::initializer_list<double> values) {
    return values.begin()[random_.index(static_cast<int>(values.size()))];
  }
  std::int32_t anyNode() { return static_cast<std::int32_t>(random_.index(trial_.body.nodeCount())); }

  void chooseOptions() {
    options_.limit = trial_.rule;
    options_.mode = random_.index(3) ? MonitorMode::bracket : MonitorMode::threshold;
    options_.every = static_cast<int>(oneOf({1, 1, 1, 2, 3, 7}));
    options_.width = oneOf({0.05, 0.02, 0.2});
    options_.budget = oneOf({0, 0.02, 0.1, 0.3, 1, infinity});
    options_.steps = static_cast<std::int64_t>(oneOf({0, 100, 1e5}));
    options_.workInAdvance = oneOf({0, 0, 1e5, 5e7});
    options_.firstObservationElements = random_.index(2) ? 10000 : 0;
    chooseStep();
  }
  void chooseStep() {
    h_.reset();
    if (random_.index(4)) h_ = trial_.undamped * power(random_, -0.7, 0.1);
  }

  /// Now and then something changes between two steps.
  void change() {
    Body& body = trial_.body;
    switch (random_.index(80)) {
      case 0:
        body.constraints().fix(anyNode(), static_cast<int>(random_.index(3)));
        break;
      case 1: {
        const std::int32_t node = anyNode();
        body.addNodalMass(node, body.lumpedMass()[node] * power(random_, -2, 2));
        break;
      }
      case 2: {
        const auto states = test::deformedStates(body.mesh().X, random_.index(1 << 20));
        state_.x = states[random_.index(static_cast<int>(states.size()))].x;
        break;
      }
      case 3:
        saved_ = std::exchange(monitor_, std::make_unique<StabilityMonitor>(body, options_));
        monitor_->load(saved_->save());
        break;
      case 4:
        rest_ = 12;
        break;
      case 5:
        chooseStep();
        break;
      case 6:
        body.constraints() = Constraints(static_cast<std::size_t>(body.nodeCount()));
        break;
      case 7:
        trial_.changeForces(random_);
        break;
      default:
        break;
    }
  }

  /// Whether the run goes on.
  bool observe(int k, const Exact& exactly) {
    StepEvaluation evaluation;
    const bool together = random_.index(2);
    const MonitorReport& report =
        monitor_->observe(k, state_.time, state_.x, state_.v, h_, together ? &evaluation : nullptr);
    const std::string where = joinText(what_, ", step ", k);
    if (together) {
      StepEvaluation alone;
      Body::Workspace workspace;
      trial_.body.evaluate(state_.x, alone, workspace);
      if (evaluation.internalForce != alone.internalForce)
        return fail(where + ": the monitor's pass has another force");
    }
    if (saved_) {
      const MonitorReport& other = saved_->observe(k, state_.time, state_.x, state_.v, h_);
      ++tally_.loaded;
      const bool same = other.certified == report.certified && other.verdict == report.verdict &&
                        other.elementsRefreshed == report.elementsRefreshed &&
                        other.bracket.has_value() == report.bracket.has_value() &&
                        (!report.bracket || (other.bracket->safe == report.bracket->safe &&
                                             other.bracket->optimistic == report.bracket->optimistic));
      if (!same) return fail(where + ": the monitor that was loaded says something else than the one that was saved");
    }
    if (!report.fresh) return true;
    // A law may have no tangent, or none that is known in double precision, where an element is inverted or a line.
    const bool unknown = report.verdict == Verdict::violated && !report.bracket;
    if (unknown && (trial_.body.leastDeterminant(state_.x).value <= 0 || isFlattenedToALine(trial_.body, state_.x))) {
      ++tally_.skipped;
      return false;
    }
    if (!isRight(report, options_.mode, h_, exactly, trial_.reference, where, tally_)) return false;
    tally_.trials += trial_.elements();
    ++tally_.alongRuns;
    return true;
  }
  bool fail(const std::string& fault) {
    ++tally_.wrong;
    ADD_FAILURE() << fault;
    return false;
  }

  static constexpr int steps = 100;
  test::Random& random_;
  std::string what_;
  Tally& tally_;
  Trial trial_;
  MonitorOptions options_;
  std::optional<double> h_;
  State state_;
  double stride_ = 0;
  int rest_ = 0;                                       // observations for which the body stays where it is
  std::unique_ptr<StabilityMonitor> monitor_, saved_;  // saved_: that monitor_ was loaded from, which goes on beside it
};

/// A body by a seed of its own, so that it can be tried again alone.
void tryBody(std::uint64_t seed, std::uint64_t body, Tally& tally, bool watched = false) {
  test::Random random(seed * 1000000007ULL + body);
  const std::string what = joinText("seed ", seed, ", body ", body);
  if (watched)
    WatchedRun(random, what, tally).run();
  else
    tryOne(random, what, tally);
}

/// A number that a variable of the environment asks for.
std::optional<std::uint64_t> asked(const char* variable) {
  const char* const value = std::getenv(variable);
  return value ? std::optional<std::uint64_t>(std::strtoull(value, nullptr, 10)) : std::nullopt;
}
std::uint64_t askedSeed() { return asked("RINGWATCH_SEED").value_or(1); }
/// The first body, to try one again.
std::uint64_t askedBody() { return asked("RINGWATCH_FIRST_BODY").value_or(0); }

// With a budget, bodies whose shares of the exchange bound cannot be made again while the weights rest.
TEST(RandomTrials, SharesThatCannotBeMadeAgainLeaveABracket) {
  Tally tally;
  tryBody(2, 1030, tally);
  tryBody(6, 3251, tally);
  EXPECT_GT(tally.alongRuns, 20);
  EXPECT_EQ(tally.wrong, 0);
}

TEST(RandomTrials, BracketsHoldTheExactStep) {
  const auto checks = asked("RINGWATCH_STATE_CHECKS");
  const auto wanted = static_cast<std::int64_t>(checks.value_or(20000));
  Tally tally;
  for (std::uint64_t body = askedBody(); tally.trials < wanted && tally.wrong < 5; ++body) {
    tryBody(askedSeed(), body, tally);
    ASSERT_LT(tally.skipped, 100 + tally.states);
  }
  EXPECT_EQ(tally.wrong, 0);
  EXPECT_GE(tally.trials, wanted);
  EXPECT_GT(tally.alongRuns, tally.states / 2);
  EXPECT_GT(tally.damped, tally.states / 4);
  EXPECT_GT(tally.toggled, 10);
  EXPECT_GT(tally.widestAtRest, leastAtRest);
  if (checks)
    std::cout << tally.trials << " elements in " << tally.states << " states, " << tally.alongRuns
              << " of them along runs, " << tally.damped << " damped, contact changed " << tally.toggled << " times, "
              << tally.indefinite << " of indefinite stiffness, " << tally.wrong << " wrong, " << tally.skipped
              << " without a positive direction or a tangent; safe side " << tally.widest << " to " << tally.tightest
              << " of the exact step, at rest with its own reference from " << tally.widestAtRest << "\n";
}

TEST(RandomTrials, WatchedRunsHoldTheExactStep) {
  const auto watched = asked("RINGWATCH_WATCHED_RUNS");
  const std::uint64_t runs = watched.value_or(20), first = askedBody();
  Tally tally;
  for (std::uint64_t body = first; body < first + runs && tally.wrong < 5; ++body)
    tryBody(askedSeed(), body, tally, true);
  EXPECT_EQ(tally.wrong, 0);
  EXPECT_GT(tally.alongRuns, 10 * static_cast<std::int64_t>(runs));
  EXPECT_GT(tally.loaded, 0);
  if (watched)
    std::cout << tally.trials << " elements in " << tally.alongRuns << " states along " << runs << " runs, "
              << tally.indefinite << " of indefinite stiffness, " << tally.loaded
              << " compared with a monitor that was saved, " << tally.wrong << " wrong, " << tally.skipped
              << " runs ended without a positive direction or a tangent; safe side " << tally.widest << " to "
              << tally.tightest << " of the exact step\n";
}

}  // namespace
}  // namespace ringwatch
