#pragma once
#include <ringwatch/integrators/integrator.h>

namespace ringwatch {

/// n equal masses (kg) in a row along x between two walls, n + 1 equal springs (N/m), optionally with Rayleigh damping.
/// Its frequencies are omega_j = 2 √(k/m) sin(j π / (2 (n + 1))), j = 1 … n.
class SpringChain final : public DifferentiableSystem {
 public:
  SpringChain(int masses, double mass, double stiffness, const RayleighDamping& damping = {});
  void acceleration(double time, const NodeVectors& x, const NodeVectors& v, NodeVectors& a) override;
  bool velocityDependent() const override { return damping_.any(); }
  const Eigen::VectorXd& mass() const override { return mass_; }
  RayleighDamping damping() const override { return damping_; }
  void stiffnessProduct(const NodeVectors& x, const NodeVectors& u, NodeVectors& Ku) override;
  Eigen::SparseMatrix<double> stiffness(const NodeVectors& x) override;
  bool isConstrained(std::int32_t, int component) const override { return component != 0; }

  int count() const { return static_cast<int>(mass_.size()); }
  /// omega_j, rad/s, 1 <= j <= count().
  double frequency(int j) const;
  double highestFrequency() const { return frequency(count()); }
  /// Displacements of mode j, largest about 1, 3×N. Positions are displacements: rest is zero.
  NodeVectors mode(int j) const;
  /// Kinetic plus spring energy, J.
  double energy(const NodeVectors& x, const NodeVectors& v);

 private:
  Eigen::VectorXd mass_;
  double stiffness_;
  RayleighDamping damping_;
  NodeVectors product_;
};

}  // namespace ringwatch
