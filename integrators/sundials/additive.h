#pragma once
#include <ringwatch/integrators/additive_system.h>
#include <ringwatch/integrators/sundials/implicit.h>

namespace ringwatch {

/// SUNDIALS' schemes for an AdditiveSystem. With y = (x, v), the stiff part is (v, a_stiff) and the non-stiff one
/// (0, a_nonstiff): velocities move positions with the stiff part.

/// Additive implicit–explicit Runge–Kutta method of order four by ARKODE, ARK4(3)7L[2]SA₁ (Kennedy & Carpenter 2019):
/// explicit in the non-stiff part, diagonally implicit and L-stable in the stiff one, seven stages. Of ARKODE's pairs
/// it is the one that damps undamped vibrations of the non-stiff part, whatever share of the stiffness is in the other;
/// the lower ones (ARK3(2)4L[2]SA, ARK4(3)6L[2]SA) let them grow, slowly but at every step.
class ArkodeArk final : public SundialsIntegrator {
 public:
  static constexpr IntegratorInfo description{
      .name = "arkode-ark",
      .help = "additive Runge-Kutta, fourth order, implicit in the stiff elements, explicit in the others",
      .order = 4,
      .forceEvaluations = 0,
      .imaginaryLimit = 3.0316837268136,  // by bisection of the step that its tables give
      .symplectic = false,
      .dampedOrder = 4,
      .partitioned = true};
  /// Steps of the size asked for, or adaptive ones within it.
  explicit ArkodeArk(bool adaptive = false, const ImplicitOptions& options = {});
};

/// Multirate infinitesimal step method of order three by ARKODE's MRIStep, MRI-GARK-ERK33a (Sandu 2019): large steps in
/// the non-stiff part, small explicit ones in the stiff part, which ARKStep takes by a method of order four
/// (Zonneveld).
class ArkodeMri final : public SundialsIntegrator {
 public:
  static constexpr IntegratorInfo description{
      .name = "arkode-mri",
      .help = "multirate infinitesimal step, third order, small explicit steps in the stiff elements",
      .order = 3,
      .forceEvaluations = 0,
      .imaginaryLimit = 2.6330527014099,  // by bisection of measured steps
      .symplectic = false,
      .dampedOrder = 3,
      .partitioned = true};
  /// substeps: equal small steps for a large one; 0: as many as error control to options.relativeTolerance asks for.
  /// Throws InputError for a negative number.
  explicit ArkodeMri(int substeps = 0, const ImplicitOptions& options = {});
};

}  // namespace ringwatch
