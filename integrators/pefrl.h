#pragma once
#include <ringwatch/integrators/composition.h>

namespace ringwatch {

/// Position-extended Forest–Ruth-like method, fourth order with a small error constant (Omelyan, Mryglod & Folk 2002,
/// eq. 20). Four forces a step; stable for h·omega < 2.9894, where trace = -2.
class Pefrl final : public CompositionIntegrator<Pefrl> {
  static constexpr double xi = 0.1786178958448091, lambda = -0.2123418310626054, chi = -0.06626458266981849;
  static constexpr double drifts[] = {xi, chi, 1 - 2 * (chi + xi), chi, xi};
  static constexpr double kicks[] = {(1 - 2 * lambda) / 2, lambda, lambda, (1 - 2 * lambda) / 2};

 public:
  static constexpr Composition composition{drifts, kicks};
  static constexpr IntegratorInfo description{.name = "pefrl",
                                              .help = "fourth order, symplectic, small error, four forces a step",
                                              .order = 4,
                                              .forceEvaluations = 4,
                                              .imaginaryLimit = 2.98944954590672912,
                                              .symplectic = true,
                                              .reversible = true,
                                              .amplification = &amplification,
                                              .drifts = true};
};

}  // namespace ringwatch
