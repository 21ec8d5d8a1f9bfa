#pragma once
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include <ringwatch/body/body.h>
#include <ringwatch/integrators/integrator.h>
#include <ringwatch/verify/report.h>

namespace ringwatch {

/// One deformation of the comparison of handlers in B. Fierz, Stabilizing Explicit Dynamic Finite Element Simulations,
/// Diss. ETH 21051, 2013, section 4.5.2 ("Fierz 2013" below): a cube of 5 cm with small elements at one side, and a bar
/// of 10 cm with small elements in its middle, corotational, 30 kPa, 1000 kg/m³, stretched, compressed, bent and
/// twisted. Generated, so that nodes, elements, critical step and the number that the reduced 1-ring calls too small at
/// 0.4 ms are those of Fierz 2013's meshes within 3 %.
struct Deformation {
  std::string_view mesh;  // "cube" or "bar"
  std::string_view mode;  // "stretch", "compress", "bend" or "twist"
  bool byForce =
      false;  // a dead load on one face from t = 0, until it has pulled it far; else that face has a prescribed motion
  double poisson = 0.3;

  double end() const;  // s
  /// The body with its held face, and its moving or loaded one.
  Body body() const;
  /// Prescribes velocities that bring the moving face from where it belongs at time t to where it belongs at t + dt
  /// (s), in straight lines. Does nothing to a body that is loaded.
  void prescribeMotion(Body& body, double t, double dt) const;
};

/// Every deformation of both meshes at this Poisson's ratio: by mesh, mode, by position before by force.
std::vector<Deformation> allDeformations(double poisson);

/// Runs every deformation with every handler at 0.4 ms (`modal-filter`: 0.2 ms), with Verlet at 0.1 ms and in its own
/// certified step, and with implicit Euler on the cube (integrators: where to look for it), against Verlet at 0.05 ms.
/// At nu = 0.4, 0.45 and 0.49 the cube alone, in the steps of Fierz 2013.
///
/// Tables: deformations, a row a run with errors, time and energy; fierz2013, its errors beside ours.
/// Figures: mean error against time, and the bodies at the end with the error of each node. Checks: the mean error of
/// every handler over the largest displacement, by mode; mass scaling is not lost. Times are for information: no check
/// rests on one.
StudyReport verifyFierz2013(StudyEffort effort, std::span<const IntegratorEntry> integrators);

}  // namespace ringwatch
