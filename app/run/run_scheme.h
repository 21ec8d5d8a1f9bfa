#pragma once
#include <memory>
#include <optional>

#include <ringwatch/app/run/run_result.h>
#include <ringwatch/app/run/stepper.h>
#include <ringwatch/app/scene/scene.h>
#include <ringwatch/meshes/modify/cut.h>

namespace ringwatch {

struct RunOfPart;

/// How the states of a run's body advance: integrator, handler, the system that they work on, and what takes the steps.
/// A body that was cut gets a scheme of its own. Adds its notes, and what its handler did, to the result of the run.
class RunScheme {
 public:
  /// Prepares the handler, if the scene has one, at the reference positions for steps of h seconds (0: none is known
  /// yet). All of them must outlive the scheme. Throws InputError for a device that cannot be had.
  /// part: where the body is one; its handler takes what that of the whole has chosen.
  RunScheme(const Scene& scene, Body& body, RunResult& result, double h, RunOfPart* part = nullptr);
  /// The scheme of a body that was cut, at positions x (3×N, m), in steps of h seconds: the handler's choice is carried
  /// over from the scheme before, whose body may be gone.
  RunScheme(const Scene& scene, Body& body, RunResult& result, const NodeVectors& x, double h, const CutMesh& cut,
            const RunScheme& before);

  Stepper& stepper() { return *stepper_; }
  BodySystem& system() { return *system_; }
  /// nullptr where there is none.
  Handler* handler() { return handler_; }
  /// Elements that the handler handles, or that are in the stiff part of a partitioned integrator.
  std::int64_t treatedElements() const;
  /// Lets the handler choose at positions x for steps of h seconds. The masses may change: a known acceleration of a
  /// state, and what was observed of the body, no longer hold.
  void prepare(const NodeVectors& x, double h);

 private:
  void makeIntegrator();
  void makeStepper(double h);
  std::unique_ptr<Stepper> onDevice(double h);
  void noteChoice();

  const Scene& scene_;
  Body& body_;
  RunResult& result_;
  std::unique_ptr<Integrator> integrator_;
  Handler* handler_ = nullptr;  // the integrator, where it is one
  std::optional<BodySystem> system_;
  std::unique_ptr<Stepper> stepper_;
  std::int64_t stiffElements_ = 0;  // of a partitioned integrator
};

}  // namespace ringwatch
