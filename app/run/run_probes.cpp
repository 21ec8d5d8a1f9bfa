#include <ringwatch/app/run/run_probes.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <fmt/format.h>
#include <Eigen/Geometry>

#include <ringwatch/app/output/frames.h>
#include <ringwatch/base/error.h>
#include <ringwatch/body/element_energy.h>
#include <ringwatch/body/element_stress.h>
#include <ringwatch/meshes/adjacency.h>

namespace ringwatch {
namespace {

using Quantity = ProbeQuantity::Kind;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// Makes one number of those of some nodes or elements; one that is none stays none.
class Reduced {
 public:
  explicit Reduced(ProbeReduction as) : as_(as) {}
  void add(double value, double weight = 1) {
    if (as_ == ProbeReduction::least || as_ == ProbeReduction::largest) {
      const bool better = as_ == ProbeReduction::least ? value < value_ : value > value_;
      if (weight_ == 0 || better || std::isnan(value)) value_ = std::isnan(value_) && weight_ > 0 ? value_ : value;
      weight_ = 1;
      return;
    }
    value_ += weight * value;
    weight_ += weight;
  }
  double value() const { return weight_ == 0 ? nan : as_ == ProbeReduction::mean ? value_ / weight_ : value_; }

 private:
  ProbeReduction as_;
  double value_ = 0, weight_ = 0;
};

/// The acceleration of a prescribed motion of a node, m/s²: see RunProbes.
Eigen::Vector3d prescribedAcceleration(const Scene::Move& move, const Eigen::Vector3d& X, double time, double h) {
  if (!move.changes()) return Eigen::Vector3d::Zero();
  const Eigen::Vector3d before =
      time > h ? move.displacement(X, time - h) : Eigen::Vector3d((time - h) * move.velocityAtStart(X));
  return (move.displacement(X, time + h) - 2 * move.displacement(X, time) + before) / (h * h);
}

/// The angular acceleration of one, rad/s².
Eigen::Vector3d prescribedTurning(const Scene::Move& move, double time, double h) {
  if (!move.changes()) return Eigen::Vector3d::Zero();
  const Eigen::Vector3d before =
      time > h ? move.turned(time - h)
               : Eigen::Vector3d((time - h) * (move.table ? move.table->at(0) : 1) * move.angularVelocity);
  return (move.turned(time + h) - 2 * move.turned(time) + before) / (h * h);
}

}  // namespace

RunProbes::RunProbes(const Scene& scene, const Body& body, const StepRule& rule)
    : scene_(scene), body_(body), rule_(rule) {
  if (scene.reactions) reacts_ = true;
  for (const Scene::Probe& probe : scene.probes) {
    reacts_ = reacts_ || probe.quantity.kind == Quantity::reaction;
    forced_ = forced_ || (probe.quantity.ofRigidBodies() && probe.quantity.needsForce());
  }
  const auto guides = [](const auto& section) { return Scene::guides(section); };
  if (scene.reactions && (std::ranges::any_of(scene.fixes, guides) || std::ranges::any_of(scene.moves, guides)))
    forced_ = true;
  follow();
}

void RunProbes::follow() {
  if (!scene_.probed()) return;
  const bool begun = !targets_.empty();
  const Mesh& mesh = body_.mesh();
  targets_.clear();
  for (const Scene::Probe& probe : scene_.probes) {
    Target& target = targets_.emplace_back();
    if (probe.quantity.ofRigidBodies()) continue;
    if (probe.quantity.ofNodes()) {
      if (probe.selection)
        target.nodes = probe.selection->nodesOf(mesh);
      else
        for (std::int32_t i = 0; i < body_.nodeCount(); ++i) target.nodes.push_back(i);
      continue;
    }
    try {
      if (probe.selection) {
        const NodeSelection& chosen = *probe.selection;
        target.elements = selectedElements(mesh, chosen.where, chosen.set, chosen.origin);
      } else {
        target.elements = selectedElements(mesh, {}, {}, probe.origin);
      }
    } catch (const InputError&) {
      if (!begun) throw;  // later all of its elements may have eroded
    }
    const std::vector<int> materials = materialOfBlocks(mesh);
    if (probe.material && !materials.empty())
      std::erase_if(target.elements, [&](ElementRef e) { return materials[e.block] != *probe.material; });
    if (probe.quantity.kind == Quantity::energy) target.mass = lumpedMassOfElements(body_, target.elements);
  }
  metrics_.clear();
  const auto ofStress = [](const Scene::Probe& probe) { return probe.quantity.kind == Quantity::stress; };
  if (std::ranges::any_of(scene_.probes, ofStress)) {
    first_ = blockOffsets(mesh);
    volume_ = volumeOfElements(body_);
  }
  if (reacts_) {
    supports_.assign(3 * static_cast<std::size_t>(body_.nodeCount()), -1);
    std::int32_t section = 0;
    const auto hold = [&](const NodeSelection& selection, const std::array<bool, 3>& components) {
      for (const std::int32_t node : selection.nodesOf(mesh))
        for (std::size_t c = 0; c < 3; ++c)
          if (std::int32_t& by = supports_[3 * static_cast<std::size_t>(node) + c]; components[c] && by < 0)
            by = section;
      ++section;
    };
    constexpr std::array<bool, 3> none{};  // of a rigid body with some freedom the support is not that of its nodes
    for (const Scene::Fix& fix : scene_.fixes) hold(fix.nodes, Scene::guides(fix) ? none : fix.components);
    for (const Scene::Move& move : scene_.moves) hold(move.nodes, Scene::guides(move) ? none : move.components);
  }
  nameColumns();
}

void RunProbes::nameColumns() {
  columns_.clear();
  for (const Scene::Probe& probe : scene_.probes) {
    const ProbeQuantity& quantity = probe.quantity;
    std::string name = quantity.name;
    if (quantity.kind == Quantity::step) name = fmt::format("{}_step", stepSide(metricDirection(probe.metric, body_)));
    for (const std::string& part : quantity.parts)
      columns_.push_back({fmt::format("{}.{}{}{}{}{}", probe.name, name, part.empty() ? "" : "_", part,
                                      quantity.unit.empty() ? "" : "_", quantity.unit),
                          quantity.unit,
                          fmt::format("{}{}{}: {}", probeReductionNames.nameOf(probe.as),
                                      probe.metric.empty() ? "" : " by ", probe.metric, quantity.help)});
  }
  const auto add = [&](const char* section, std::size_t number) {
    for (const char* part : {"x", "y", "z"})
      columns_.push_back(
          {fmt::format("{}.{}.reaction_{}_N", section, number, part), "N",
           fmt::format("of [[{}]] number {}, counted from 0, on the nodes that it holds first", section, number)});
  };
  for (std::size_t i = 0; scene_.reactions && i < scene_.fixes.size(); ++i) add("fix", i);
  for (std::size_t i = 0; scene_.reactions && i < scene_.moves.size(); ++i) add("move", i);
  for (ProbeColumn& column : columns_) {
    column.name = labelledColumns(column.name);
    column.unit = unitNamed(column.unit);
  }
}

std::string RunProbes::heading() const {
  std::string line = labelledColumns("step,time_s");
  for (const ProbeColumn& column : columns_) line += "," + column.name;
  return line;
}

void RunProbes::react(const State& state, double h, const NodeVectors& internalForce, BodySystem& system) {
  reaction_.setZero(3, body_.nodeCount());
  ofSections_.assign(scene_.fixes.size() + scene_.moves.size(), Eigen::Vector3d::Zero());
  const bool damped = system.velocityDependent();
  if (damped) system.dampingForceBesideElements(state.x, state.v, dampingForce_);
  for (std::int32_t node = 0; node < body_.nodeCount(); ++node) {
    std::int32_t moved = -1;  // whose acceleration is known
    Eigen::Vector3d acceleration = Eigen::Vector3d::Zero();
    for (int c = 0; c < 3; ++c) {
      const std::int32_t section = supports_[3 * static_cast<std::size_t>(node) + static_cast<std::size_t>(c)];
      if (section < 0) continue;
      double force = internalForce(c, node) - body_.externalForce()(c, node);
      if (damped) force += dampingForce_(c, node);
      if (const auto move = section - static_cast<std::int32_t>(scene_.fixes.size()); move >= 0) {
        if (move != moved)
          acceleration = prescribedAcceleration(scene_.moves[move], body_.mesh().X.col(node), state.time, h);
        moved = move;
        force += body_.lumpedMass()[node] * acceleration[c];
      }
      reaction_(c, node) = force;
      ofSections_[section][c] += force;
    }
  }
  if (!forced_) return;
  std::size_t section = 0;
  const auto addGuided = [&](const auto& sections) {
    for (const auto& one : sections) {
      if (Scene::guides(one))
        ofSections_[section] = supportOf(body_.constraints().rigidBody(one.guide->body), state, h).force;
      ++section;
    }
  };
  addGuided(scene_.fixes);
  addGuided(scene_.moves);
}

RigidBody::Load RunProbes::supportOf(const RigidBody& rigid, const State& state, double h) const {
  Eigen::Vector3d acceleration = Eigen::Vector3d::Zero(), turning = acceleration;
  for (const Scene::Move& move : scene_.moves)
    if (move.guide && move.guide->body == rigid.name()) {
      acceleration = prescribedAcceleration(move, move.point, state.time, h);
      turning = prescribedTurning(move, state.time, h);
    }
  return rigid.support(state.x, state.v, force_, acceleration, turning);
}

const MetricValues& RunProbes::metric(const std::string& name, NodeVectorsView x) {
  const MetricValues*& known = evaluated_[name];
  if (known) return *known;
  std::unique_ptr<MetricEvaluator>& evaluator = metrics_[name];
  if (!evaluator) evaluator = makeMetricEvaluator(name, body_);
  known = &evaluator->evaluate(x);
  return *known;
}

void RunProbes::addValues(const Scene::Probe& probe, const Target& target, const State& state, double h,
                          std::vector<double>& values) {
  const auto eachComponent = [&](const auto& of) {
    Reduced reduced[3]{Reduced(probe.as), Reduced(probe.as), Reduced(probe.as)};
    for (const std::int32_t node : target.nodes) {
      const Eigen::Vector3d value = of(node);
      for (int c = 0; c < 3; ++c) reduced[c].add(value[c]);
    }
    for (const Reduced& one : reduced) values.push_back(one.value());
  };
  if (probe.quantity.ofRigidBodies()) return addOfRigidBody(probe, state, h, values);
  switch (probe.quantity.kind) {
    case Quantity::displacement:
      return eachComponent([&](std::int32_t i) { return state.x.col(i) - body_.mesh().X.col(i); });
    case Quantity::velocity:
      return eachComponent([&](std::int32_t i) { return state.v.col(i); });
    case Quantity::momentum:
      return eachComponent([&](std::int32_t i) { return body_.lumpedMass()[i] * state.v.col(i); });
    case Quantity::angularMomentum:
      return eachComponent([&](std::int32_t i) {
        const Eigen::Vector3d x = state.x.col(i), v = state.v.col(i);
        return Eigen::Vector3d(body_.lumpedMass()[i] * x.cross(v));
      });
    case Quantity::load:
      return eachComponent([&](std::int32_t i) { return body_.externalForce().col(i); });
    case Quantity::reaction:
      return eachComponent([&](std::int32_t i) { return reaction_.col(i); });
    case Quantity::energy: {
      double kinetic = 0;
      for (std::int32_t i = 0; i < body_.nodeCount(); ++i)
        kinetic += 0.5 * target.mass[i] * state.v.col(i).squaredNorm();
      if (strain_.empty()) strain_ = strainEnergyOfElements(body_, state.x);
      double strain = 0;
      for (const ElementRef e : target.elements) strain += strain_[e.block][e.element];
      values.push_back(kinetic);
      values.push_back(strain);
      return;
    }
    case Quantity::step: {
      const MetricValues& lambda = metric(probe.metric, state.x);
      Reduced least(probe.as);
      for (const ElementRef e : target.elements) least.add(rule_(lambda[e.block][e.element]));
      values.push_back(least.value());
      return;
    }
    case Quantity::stress: {
      const StressMeasure* const measure = findStressMeasure(probe.quantity.name);
      const std::vector<double> all = std::move(stressOfElements(body_, state.x, std::span(&measure, 1)).front());
      std::vector<Reduced> reduced(static_cast<std::size_t>(measure->components), Reduced(probe.as));
      for (const ElementRef e : target.elements) {
        const std::size_t i = first_[e.block] + static_cast<std::size_t>(e.element);
        for (std::size_t c = 0; c < reduced.size(); ++c) reduced[c].add(all[i * reduced.size() + c], volume_[i]);
      }
      for (const Reduced& one : reduced) values.push_back(one.value());
      return;
    }
    default:
      return;
  }
}

void RunProbes::addOfRigidBody(const Scene::Probe& probe, const State& state, double h,
                               std::vector<double>& values) const {
  const RigidBody& rigid = body_.constraints().rigidBody(scene_.rigids[probe.rigid].name);
  const auto add = [&](const Eigen::Vector3d& value) { values.insert(values.end(), value.begin(), value.end()); };
  if (probe.quantity.needsForce()) {
    const RigidBody::Load load = probe.quantity.ofSupports() ? supportOf(rigid, state, h) : rigid.load(state.x, force_);
    const bool force = probe.quantity.kind == Quantity::force || probe.quantity.kind == Quantity::supportForce;
    return add(force ? load.force : load.torque);
  }
  const RigidBody::Motion motion = rigid.motion(state.x, state.v);
  if (probe.quantity.kind == Quantity::centre) return add(motion.centre);
  if (probe.quantity.kind == Quantity::centreVelocity) return add(motion.velocity);
  if (probe.quantity.kind == Quantity::angularVelocity) return add(motion.angularVelocity);
  const Eigen::AngleAxisd turn(motion.rotation);
  add(turn.angle() * turn.axis());
}

std::string RunProbes::row(std::int64_t k, const State& state, double h, const NodeVectors& internalForce,
                           BodySystem& system) {
  if (bodyVersion_ != body_.version()) metrics_.clear();
  bodyVersion_ = body_.version();
  evaluated_.clear();
  strain_.clear();
  if (forced_) {
    force_ = body_.externalForce() - internalForce;
    if (system.velocityDependent()) {
      system.dampingForceBesideElements(state.x, state.v, dampingForce_);
      force_ -= dampingForce_;
    }
  }
  if (reacts_) react(state, h, internalForce, system);
  std::vector<double> values;
  for (std::size_t i = 0; i < targets_.size(); ++i) addValues(scene_.probes[i], targets_[i], state, h, values);
  if (scene_.reactions)
    for (const Eigen::Vector3d& force : ofSections_) values.insert(values.end(), {force[0], force[1], force[2]});
  std::string line = fmt::format("{},{}", k, state.time);
  for (const double value : values) line += std::isfinite(value) ? fmt::format(",{}", value) : std::string(",");
  return line;
}

}  // namespace ringwatch
