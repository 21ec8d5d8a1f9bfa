#include <ringwatch/handlers/filtered.h>

#include <algorithm>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <Eigen/LU>

#include <ringwatch/base/error.h>
#include <ringwatch/base/parallel.h>
#include <ringwatch/handlers/rotation_of.h>
#include <ringwatch/monitor/scaled_tangent.h>

namespace ringwatch {

class Filtered::Corrected final : public SecondOrderSystem {
 public:
  Corrected(Filtered& owner, double h) : owner_(owner), h_(h) {}
  void acceleration(double, const NodeVectors& x, const NodeVectors& v, NodeVectors& a) override {
    Filtered& o = owner_;
    o.explicitBody().internalForce(x, o.force_, o.workspace_);
    a = (o.body_.externalForce() - o.force_) * o.inverseMass_.asDiagonal();
    o.body_.constraints().clearConstrained(a);
    o.addFilteredForces(x, a);
    if (o.projection_) {
      o.predicted_ = x + h_ * (v + h_ * a);
      o.force_ = o.predicted_;
      const std::string reason = o.projection_->project(o.predicted_);
      if (!reason.empty() && fault.empty()) fault = reason;
      a += (o.predicted_ - o.force_) / (h_ * h_);
    } else {
      o.addCompliance(x, v, a);
    }
    if (!a.allFinite() && fault.empty()) fault = "the handled elements' nodes are not at finite positions";
  }
  bool velocityDependent() const override { return true; }

  std::string fault;

 private:
  Filtered& owner_;
  double h_;
};

Filtered::Filtered(Body& body, std::unique_ptr<Integrator> base, HandlerOptions options)
    : Handler(body, std::move(base), std::move(options)), projects_(options_.variant == "projection") {
  if (!projects_ && !options_.variant.empty() && options_.variant != "compliant")
    throw InputError(joinText("variant \"", options_.variant, "\" of filtered: must be one of compliant, projection"));
  if (options_.selection == "reduced-1-ring")
    throw InputError(
        "filtered leaves handled elements in the explicit part: selection must be certified or "
        "single-element");
  if (options_.passes == 0) options_.passes = 1;
  if (options_.passes < 1) throw InputError(joinText("passes ", options_.passes, ": must be >= 1"));
}

void Filtered::take(const NodeVectors&, double h, const ElementFlags& chosen) {
  const auto elements = chosenElements(chosen);
  requireTurningTetrahedra(elements);
  h_ = h;
  const double lambda = allowedLambda(h);
  Eigen::VectorXd share = Eigen::VectorXd::Zero(body_.nodeCount());  // certified: of each handled element, N/m
  if (certificate()) {
    for (const ElementRef e : elements)
      for (const std::int32_t n : nodesOf(e)) ++share[n];
    for (std::int32_t i = 0; i < body_.nodeCount(); ++i) {
      if (share[i] == 0) continue;
      const Eigen::Matrix3d rest = freePart(body_, i, certificate()->nodalSums[static_cast<std::size_t>(i)]);
      const double used = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(rest, Eigen::EigenvaluesOnly).eigenvalues()[2];
      const double whole = lambda * body_.lumpedMass()[i];
      share[i] = std::max(whole - used, 1e-9 * whole) / share[i];  // no budget may vanish
    }
  }
  items_.clear();
  for (const ElementRef e : elements) {
    Item item;
    const auto nodes = nodesOf(e);
    Eigen::Vector4d budget, mass;
    body_.elementLumpedMass(e, mass.data());
    for (int a = 0; a < 4; ++a) {
      const std::int32_t n = nodes[static_cast<std::size_t>(a)];
      item.nodes[static_cast<std::size_t>(a)] = n;
      item.rest.col(a) = body_.mesh().X.col(n);
      const int free = body_.constraints().freeComponents(n);
      item.inverseMass[a] = free == 0 ? 0 : 1 / body_.lumpedMass()[n];
      item.constrained = item.constrained || free < 3;
      budget[a] = certificate() ? share[n] : lambda * mass[a];
    }
    const Eigen::Matrix3d edges = item.rest.rightCols<3>().colwise() - item.rest.col(0);
    item.inverseEdges = edges.inverse();
    item.stiffness = filterModes(body_.elementTangent(e, body_.mesh().X), budget);
    Eigen::Matrix<double, 12, 6> weighted = item.stiffness.mode;
    for (int d = 0; d < 12; ++d) weighted.row(d) *= h * h * item.inverseMass[d / 3];
    Eigen::Matrix<double, 6, 6> matrix = item.stiffness.mode.transpose() * weighted;
    matrix.diagonal() += item.stiffness.compliance;
    item.inverse = matrix.inverse();
    items_.push_back(item);
  }
  if (projects_)
    projection_.emplace(body_, shapeConstraints(body_.mesh(), elements), options_.projectionTolerance,
                        options_.cluster.iterations);
  inverseMass_ = body_.lumpedMass().cwiseInverse();
  splitOff(chosen);
}

Filtered::Vector12 Filtered::displacementOf(const Item& item, const NodeVectors& x) const {
  Vector12 u;
  for (int a = 0; a < 4; ++a)
    u.segment<3>(3 * a) = item.R.transpose() * (x.col(item.nodes[static_cast<std::size_t>(a)]) - x.col(item.nodes[0])) -
                          (item.rest.col(a) - item.rest.col(0));
  return u;
}

void Filtered::addForces(const Item& item, const NodeVectors& x, const Vector12& local, NodeVectors& a) const {
  Eigen::Matrix<double, 3, 4> f;
  for (int n = 0; n < 4; ++n) f.col(n) = item.R * local.segment<3>(3 * n);
  if (!item.constrained) {
    // Free of torque about x by the rigid rotation that costs least.
    Eigen::Vector3d centre = Eigen::Vector3d::Zero(), torque = Eigen::Vector3d::Zero();
    double mass = 0;
    for (int n = 0; n < 4; ++n) {
      centre += x.col(item.nodes[static_cast<std::size_t>(n)]) / item.inverseMass[n];
      mass += 1 / item.inverseMass[n];
    }
    centre /= mass;
    Eigen::Matrix3d inertia = Eigen::Matrix3d::Zero();
    Eigen::Matrix<double, 3, 4> arm;
    for (int n = 0; n < 4; ++n) {
      arm.col(n) = x.col(item.nodes[static_cast<std::size_t>(n)]) - centre;
      torque += arm.col(n).cross(f.col(n));
      inertia += (arm.col(n).squaredNorm() * Eigen::Matrix3d::Identity() - arm.col(n) * arm.col(n).transpose()) /
                 item.inverseMass[n];
    }
    if (inertia.determinant() > 1e-13 * std::pow(inertia.trace(), 3)) {
      const Eigen::Vector3d w = inertia.inverse() * torque;
      for (int n = 0; n < 4; ++n) f.col(n) -= w.cross(arm.col(n)) / item.inverseMass[n];
    }
  }
  for (int n = 0; n < 4; ++n) {
    const std::int32_t node = item.nodes[static_cast<std::size_t>(n)];
    for (int c = 0; c < 3; ++c)
      if (!body_.constraints().isConstrained(node, c)) a(c, node) += f(c, n) * inverseMass_[node];
  }
}

void Filtered::addFilteredForces(const NodeVectors& x, NodeVectors& a) {
  parallelFor(0, static_cast<std::int64_t>(items_.size()), body_.threads(), [&](std::int64_t i) {
    Item& item = items_[static_cast<std::size_t>(i)];
    Eigen::Matrix3d edges;
    for (int k = 0; k < 3; ++k)
      edges.col(k) = x.col(item.nodes[static_cast<std::size_t>(k) + 1]) - x.col(item.nodes[0]);
    item.R = rotationOf(edges * item.inverseEdges);
  });
  for (const Item& item : items_) addForces(item, x, -(item.stiffness.kept * displacementOf(item, x)), a);
}

void Filtered::relaxItem(Item& item) {
  if (item.stiffness.modes == 0) return;
  const Eigen::Matrix<double, 6, 1> residual = item.stiffness.mode.transpose() * displacementOf(item, predicted_) +
                                               item.stiffness.compliance.cwiseProduct(item.multiplier);
  const Eigen::Matrix<double, 6, 1> change = -(item.inverse * residual);
  item.multiplier += change;
  const Vector12 force = item.stiffness.mode * change;
  for (int n = 0; n < 4; ++n) {
    const std::int32_t node = item.nodes[static_cast<std::size_t>(n)];
    const Eigen::Vector3d move = h_ * h_ * inverseMass_[node] * (item.R * force.segment<3>(3 * n));
    for (int c = 0; c < 3; ++c)
      if (!item.constrained || !body_.constraints().isConstrained(node, c)) predicted_(c, node) += move[c];
  }
}

void Filtered::addCompliance(const NodeVectors& x, const NodeVectors& v, NodeVectors& a) {
  predicted_ = x + h_ * (v + h_ * a);
  for (Item& item : items_) item.multiplier.setZero();
  for (int pass = 0; pass < options_.passes; ++pass) {
    for (auto item = items_.begin(); item != items_.end(); ++item) relaxItem(*item);
    for (auto item = items_.rbegin(); item != items_.rend(); ++item) relaxItem(*item);
  }
  for (const Item& item : items_) addForces(item, x, item.stiffness.mode * item.multiplier, a);
}

StepStatus Filtered::handledStep(SecondOrderSystem&, State& state, double h) {
  Corrected corrected(*this, h);
  return baseStep(corrected, state, h, corrected.fault);
}

std::vector<HandlerFigure> Filtered::figures() const {
  double modes = 0;
  for (const Item& item : items_) modes += item.stiffness.modes;
  std::vector<HandlerFigure> result{{"filtered_modes", modes}};
  if (projection_) {
    result.push_back({"constraints", static_cast<double>(projection_->constraints().size())});
    result.push_back({"iterations", static_cast<double>(projection_->iterations())});
  } else {
    result.push_back({"passes", static_cast<double>(options_.passes)});
  }
  return result;
}

}  // namespace ringwatch
