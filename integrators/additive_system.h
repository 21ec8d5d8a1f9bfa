#pragma once
#include <ringwatch/integrators/integrator.h>

namespace ringwatch {

/// The highest frequency that the nonstiff part is to have at most, over the integrator's own limit: half, since the
/// limit shrinks where a node belongs to both parts, to 1.57 of 3.03 with arkode-ark (`ringwatch verify integrators`).
inline constexpr double nonstiffShareOfLimit = 0.5;

/// A system whose acceleration is the sum of two parts, for schemes that treat them apart
/// (IntegratorInfo::partitioned): additive implicit-explicit ones take the stiff part implicitly, multirate ones in
/// small steps. The parts may be two sets of elements (PartitionedBodySystem), two kinds of force, or whatever else the
/// caller splits by. Both give zero where motion is prescribed.
class AdditiveSystem : public SecondOrderSystem {
 public:
  /// The part for large explicit steps.
  virtual SecondOrderSystem& nonstiff() = 0;
  /// The part that would need small ones, with its own tangent and the mass of the whole.
  virtual DifferentiableSystem& stiff() = 0;

  /// The sum, 3×N, m/s².
  void acceleration(double time, const NodeVectors& x, const NodeVectors& v, NodeVectors& a) override {
    stiff().acceleration(time, x, v, a);
    nonstiff().acceleration(time, x, v, other_);
    a += other_;
  }

 private:
  NodeVectors other_;
};

}  // namespace ringwatch
