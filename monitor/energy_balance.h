#pragma once
#include <ringwatch/body/body.h>

namespace ringwatch {

/// Energies at one state, J.
struct Energies {
  double kinetic = 0;
  double strain = 0;
  double externalWork = 0;  // by dead forces and by prescribed motion, since the start
  double balanceError = 0;  // kinetic + strain - externalWork - (kinetic + strain at the start)
};

/// Keeps the books of a run. Prescribed motion does work ∫ f · dx, f the internal force at moved nodes, summed by the
/// trapezoidal rule; dead forces do f · (x - x at the start).
class EnergyBalance {
 public:
  explicit EnergyBalance(const Body& body) : body_(body) {}

  /// Adds a state with its internal force (3×N, N). Call it at every step when motion is prescribed, else whenever
  /// wanted; the first call is the start.
  void record(const NodeVectors& x, const NodeVectors& internalForce);
  /// Energies at the last recorded state, with velocities v (3×N, m/s) belonging to it.
  Energies energies(const NodeVectors& v);

 private:
  const Body& body_;
  Body::Workspace workspace_;
  bool started_ = false, hasReference_ = false;
  double prescribedWork_ = 0, referenceEnergy_ = 0;
  NodeVectors firstX_, x_, force_;
};

}  // namespace ringwatch
