#pragma once
#include <ringwatch/body/body.h>

namespace ringwatch {

/// v ↦ M^-½ K(x) M^-½ v over the free degrees of freedom, matrix-free; constrained components of v and of the result
/// are zero.
class MassScaledOperator {
 public:
  MassScaledOperator(const Body& body, const NodeVectors& x)
      : body_(body), x_(x), inverseRootMass_(body.lumpedMass().cwiseSqrt().cwiseInverse()) {}

  Eigen::Index rows() const { return 3 * body_.nodeCount(); }
  void apply(const double* in, double* out) const {
    const Eigen::Map<const NodeVectors> v(in, 3, body_.nodeCount());
    Eigen::Map<NodeVectors> y(out, 3, body_.nodeCount());
    scaled_ = v * inverseRootMass_.asDiagonal();
    body_.constraints().clearConstrained(scaled_);
    body_.tangentProduct(x_, scaled_, product_, workspace_);
    product_ = product_ * inverseRootMass_.asDiagonal();
    body_.constraints().clearConstrained(product_);
    y = product_;
    ++products_;
  }
  int products() const { return products_; }
  const Eigen::VectorXd& inverseRootMass() const { return inverseRootMass_; }

 private:
  const Body& body_;
  const NodeVectors& x_;
  Eigen::VectorXd inverseRootMass_;
  // An operator serves one thread.
  mutable NodeVectors scaled_, product_;
  mutable Body::Workspace workspace_;
  mutable int products_ = 0;
};

}  // namespace ringwatch
