#pragma once
#include <memory>
#include <span>
#include <string>
#include <string_view>

#include <ringwatch/meshes/mesh.h>

namespace ringwatch {

/// Where a run is: time, s; positions, m, and velocities, m/s, 3×N.
struct State {
  double time = 0;
  NodeVectors x;
  NodeVectors v;
};

/// ẍ = a(t, x, ẋ). A body under load is one (BodySystem), an oscillator another.
class SecondOrderSystem {
 public:
  virtual ~SecondOrderSystem() = default;
  /// Writes the acceleration, 3×N, m/s²; zero where motion is prescribed.
  virtual void acceleration(double time, const NodeVectors& x, const NodeVectors& v, NodeVectors& a) = 0;
};

/// What an integrator declares of itself; studies hold it to that.
struct IntegratorInfo {
  std::string_view name;
  std::string_view help;
  int order;                // of the error of x at a fixed time
  int forceEvaluations;     // per step; 0 when it varies
  double imaginaryLimit;    // largest stable h·omega without damping; 0: none, infinity: A-stable
  bool symplectic;
};

/// How a step went. On failure the state is as before the step.
struct StepStatus {
  bool done = true;
  std::string reason;  // why not
};

/// Advances a State by a step; does not choose the step. An integrator may remember the last acceleration from step to
/// step: call reset() when the state, the system or its constraints were changed from outside.
class Integrator {
 public:
  virtual ~Integrator() = default;
  virtual const IntegratorInfo& info() const = 0;
  /// Advances `state` by h seconds.
  virtual StepStatus step(SecondOrderSystem& system, State& state, double h) = 0;
  virtual void reset() {}
};

/// All integrators, one line each in registry.cpp.
std::span<const IntegratorInfo> allIntegrators();
/// nullptr when there is none of that name.
const IntegratorInfo* findIntegrator(std::string_view name);
/// Throws InputError that lists the names when there is none of that name.
std::unique_ptr<Integrator> makeIntegrator(std::string_view name);

}  // namespace ringwatch
