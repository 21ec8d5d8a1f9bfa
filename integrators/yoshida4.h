#pragma once
#include <ringwatch/integrators/composition.h>

namespace ringwatch {

/// Yoshida's fourth-order composition of three leapfrog steps of h w, h (1 - 2w), h w with w = 1/(2 - 2^(1/3)) (Yoshida
/// 1990; Forest & Ruth 1990), drift first. Three forces a step; the middle step goes back in time, which costs accuracy
/// and stability: trace = 2 again at h·omega = 1.5734.
class Yoshida4 final : public Integrator {
  static constexpr double w = 1.3512071919596576340, middle = 1 - 2 * w;
  static constexpr double drifts[] = {w / 2, (w + middle) / 2, (w + middle) / 2, w / 2};
  static constexpr double kicks[] = {w, middle, w};

 public:
  static Eigen::Matrix2d amplification(double z, double dampingRatio) {
    return compositionAmplification({drifts, kicks}, z, dampingRatio);
  }
  static constexpr IntegratorInfo description{"yoshida4",
                                              "fourth order, symplectic, three forces a step",
                                              4,
                                              3,
                                              1.573401947434540057,
                                              true,
                                              true,
                                              1,
                                              &amplification,
                                              nullptr,
                                              false,
                                              false,
                                              false,
                                              false,
                                              0,
                                              true};
  const IntegratorInfo& info() const override { return description; }
  StepStatus step(SecondOrderSystem& system, State& state, double h) override {
    return stepComposition({drifts, kicks}, system, state, h, a_);
  }

 private:
  NodeVectors a_;
};

}  // namespace ringwatch
