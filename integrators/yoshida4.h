#pragma once
#include <ringwatch/integrators/composition.h>

namespace ringwatch {

/// Yoshida's fourth-order composition of three leapfrog steps of h w, h (1 - 2w), h w with w = 1/(2 - 2^(1/3)) (Yoshida
/// 1990; Forest & Ruth 1990), drift first. Three forces a step; the middle step goes back in time, which costs accuracy
/// and stability: trace = 2 again at h·omega = 1.5734.
class Yoshida4 final : public CompositionIntegrator<Yoshida4> {
  static constexpr double w = 1.3512071919596576340, middle = 1 - 2 * w;
  static constexpr double drifts[] = {w / 2, (w + middle) / 2, (w + middle) / 2, w / 2};
  static constexpr double kicks[] = {w, middle, w};

 public:
  static constexpr Composition composition{drifts, kicks};
  static constexpr IntegratorInfo description{.name = "yoshida4",
                                              .help = "fourth order, symplectic, three forces a step",
                                              .order = 4,
                                              .forceEvaluations = 3,
                                              .imaginaryLimit = 1.573401947434540057,
                                              .symplectic = true,
                                              .reversible = true,
                                              .amplification = &amplification,
                                              .drifts = true};
};

}  // namespace ringwatch
