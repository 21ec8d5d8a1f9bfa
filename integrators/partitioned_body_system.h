#pragma once
#include <optional>
#include <vector>

#include <ringwatch/body/body.h>
#include <ringwatch/integrators/additive_system.h>

namespace ringwatch {

/// A body in two sets of elements, as an AdditiveSystem: the stiff part is the internal force of the elements named,
/// the non-stiff part that of all others and the loads. Masses and constraints are those of the whole body. Stiffness
/// damping goes with its elements, mass damping with the stiff part.
class PartitionedBodySystem final : public AdditiveSystem {
 public:
  /// The body must outlive the system; its constraints and loads may change, its elements not. Throws InputError for an
  /// element that the body does not have.
  PartitionedBodySystem(const Body& body, const std::vector<ElementRef>& stiff, const RayleighDamping& damping = {});

  SecondOrderSystem& nonstiff() override { return nonstiff_; }
  DifferentiableSystem& stiff() override { return stiff_; }
  bool velocityDependent() const override { return stiff_.velocityDependent() || nonstiff_.velocityDependent(); }
  const Body& body() const { return body_; }

 private:
  /// The elements of one set, on a body of their own whose nodes are those that the set touches.
  class Part final : public DifferentiableSystem {
   public:
    Part(const Body& whole, const std::vector<std::vector<bool>>& chosen, bool loaded, const RayleighDamping& damping);
    void acceleration(double time, const NodeVectors& x, const NodeVectors& v, NodeVectors& a) override;
    bool velocityDependent() const override { return damping_.any(); }
    const Eigen::VectorXd& mass() const override { return whole_.lumpedMass(); }
    RayleighDamping damping() const override { return damping_; }
    void stiffnessProduct(const NodeVectors& x, const NodeVectors& u, NodeVectors& Ku) override;
    Eigen::SparseMatrix<double> stiffness(const NodeVectors& x) override;
    void stiffnessDiagonal(const NodeVectors& x, std::vector<Eigen::Matrix3d>& blocks) override;
    bool isConstrained(std::int32_t node, int component) const override {
      return whole_.constraints().isConstrained(node, component);
    }

   private:
    void gather(const NodeVectors& all, NodeVectors& own) const;

    const Body& whole_;
    bool loaded_;
    RayleighDamping damping_;
    std::vector<std::int32_t> nodes_;  // of the whole body, by own node
    std::optional<Body> body_;         // empty when the set is
    NodeVectors x_, u_, force_;
    Body::Workspace workspace_;
    BlockMatrix blocks_;
  };

  const Body& body_;
  std::vector<std::vector<bool>> chosen_;  // [block][element]: whether it is stiff
  Part nonstiff_, stiff_;
};

}  // namespace ringwatch
