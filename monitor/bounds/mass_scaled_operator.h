#pragma once
#include <algorithm>
#include <functional>
#include <utility>

#include <ringwatch/body/discrete_forces.h>
#include <ringwatch/body/tangent_source.h>

namespace ringwatch {

/// K(x) v of a TangentSource, computed by others: v and the result are 3×N, m and N.
using TangentProduct = std::function<void(NodeVectorsView v, NodeVectors& Kv)>;

/// v ↦ M^-½ K(x) M^-½ v over the free degrees of freedom, matrix-free; constrained components of v and of the result
/// are zero. With rigid bodies it is Q M^-½ K M^-½ Q, Q the orthogonal projector onto the mass-scaled motions that
/// leave them rigid (Theorem 62, docs/theory/rigid_bodies.md).
class MassScaledOperator {
 public:
  /// product: K(x) v; TangentSource::tangentProduct where there is none.
  MassScaledOperator(const TangentSource& source, NodeVectorsView x, TangentProduct product = {})
      : source_(source),
        x_(x),
        tangentProduct_(std::move(product)),
        inverseRootMass_(source.lumpedMass().cwiseSqrt().cwiseInverse()) {}

  Eigen::Index rows() const { return 3 * source_.nodeCount(); }
  /// Makes a mass-scaled vector, 3×N, one of the free motions.
  void restrict(NodeVectors& v) const {
    source_.constraints().clearConstrained(v);
    if (source_.constraints().rigidBodies().empty()) return;
    v = v * inverseRootMass_.asDiagonal();
    source_.constraints().projectTied(x_, v);
    v = v * inverseRootMass_.cwiseInverse().asDiagonal();
  }
  void apply(const double* in, double* out) const {
    const Eigen::Map<const NodeVectors> v(in, 3, source_.nodeCount());
    Eigen::Map<NodeVectors> y(out, 3, source_.nodeCount());
    scale(v);
    if (tangentProduct_)
      tangentProduct_(scaled_, product_);
    else
      source_.tangentProduct(x_, scaled_, product_, workspace_);
    product_ = product_ * inverseRootMass_.asDiagonal();
    source_.constraints().clearConstrained(product_);
    if (!source_.constraints().rigidBodies().empty()) {
      unrestricted_ = product_.norm();
      restrict(product_);
    }
    y = product_;
    ++products_;
  }
  /// What vᵀ M^-½ K M^-½ v errs by when K does: TangentSource::formRounding.
  double formRounding(const NodeVectors& v) const {
    scale(v);
    return source_.formRounding(x_, scaled_, workspace_);
  }
  /// What vᵀ M^-½ K M^-½ v of the last apply(), |v| = 1, errs by at most where the motion of rigid bodies is rigid to
  /// rounding alone.
  double rigidRounding() const {
    double relative = 0;
    for (const RigidBody& body : source_.constraints().rigidBodies())
      relative = std::max(relative, body.projectionRounding());
    return 2 * relative * unrestricted_;
  }
  /// What dashpots and elements that damp give of vᵀ M^-½ (K + f C) M^-½ v; zero without any. formRounding() bounds
  /// the rounding of the elements' part.
  DiscreteForces::DampingForm dampingForm(const NodeVectors& v) const {
    const DiscreteForces* discrete = source_.discreteForces();
    const bool dashpots = discrete && discrete->damped();
    if (!dashpots && !source_.dampedElements()) return {};
    scale(v);
    DiscreteForces::DampingForm form;
    if (dashpots) form = discrete->dampingForm(x_, scaled_);
    form.value += source_.elementDampingForm(x_, scaled_, workspace_);
    return form;
  }
  int products() const { return products_; }
  const Eigen::VectorXd& inverseRootMass() const { return inverseRootMass_; }

 private:
  void scale(const Eigen::Ref<const NodeVectors>& v) const {
    scaled_ = v * inverseRootMass_.asDiagonal();
    source_.constraints().clearConstrained(scaled_);
    source_.constraints().projectTied(x_, scaled_);
  }

  const TangentSource& source_;
  NodeVectorsView x_;
  TangentProduct tangentProduct_;
  Eigen::VectorXd inverseRootMass_;
  // An operator serves one thread.
  mutable NodeVectors scaled_, product_;
  mutable TangentSource::Workspace workspace_;
  mutable int products_ = 0;
  mutable double unrestricted_ = 0;  // norm of the last product before it was projected
};

}  // namespace ringwatch
