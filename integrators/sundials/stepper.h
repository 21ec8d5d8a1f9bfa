#pragma once
#include <functional>
#include <string>
#include <vector>

#include <ringwatch/integrators/sundials/implicit.h>
#include <ringwatch/integrators/sundials/newton_system.h>

namespace ringwatch::detail {

/// The part of an AdditiveSystem that is taken explicitly, in large steps.
struct NonstiffPart {
  SecondOrderSystem* system = nullptr;
  /// (0, a). 0, or 1 (recoverable) when it is not finite.
  int rightHandSide(double time, N_Vector y, N_Vector dy) const {
    positions(dy).setZero();
    system->acceleration(time, positions(y), velocities(y), velocities(dy));
    return velocities(dy).allFinite() ? 0 : 1;
  }
};

/// What all SUNDIALS integrators share: attaching the system, the vectors over the state, the step that either is done
/// or leaves the state alone, and the report of a failure.
class Stepper {
 public:
  Stepper(std::string library, const ImplicitOptions& options) : library_(std::move(library)), newton_(options) {}
  virtual ~Stepper() { release(); }
  Stepper(const Stepper&) = delete;
  Stepper& operator=(const Stepper&) = delete;

  StepStatus step(SecondOrderSystem& system, State& state, double h);
  /// Forgets everything of earlier steps.
  void release();

 protected:
  /// Brings SUNDIALS' memory, which may be there from the last step, to the start of this one. A SUNDIALS flag.
  virtual int begin(N_Vector start, const State& state, double h) = 0;
  /// Advances from `from` to `to`. A SUNDIALS flag.
  virtual int evolve(double from, double to, N_Vector end) = 0;
  /// The γ of the linear system at hand.
  virtual double gamma() const = 0;
  /// Takes what the scheme needs of a system; "" or why it cannot.
  virtual std::string attach(SecondOrderSystem& system);

  /// `work` is called when the memory is released; the last one added first.
  void onRelease(std::function<void()> work) { cleanup_.push_back(std::move(work)); }
  const ImplicitOptions& options() const { return newton_.options(); }

  // Callbacks; `self` is the Stepper.
  static int rightHandSide(double time, N_Vector y, N_Vector dy, void* self) {
    return static_cast<Stepper*>(self)->newton_.rightHandSide(time, y, dy);
  }
  static void keepMessage(int, const char*, const char*, char* text, void* self) {
    static_cast<Stepper*>(self)->message_ = text;
  }
  /// A linear solver that calls NewtonSystem::solve; freed on release.
  SUNLinearSolver makeLinearSolver();
  /// Absolute tolerances, freed on release.
  N_Vector makeTolerances(N_Vector like);

  std::string library_;
  NewtonSystem newton_;
  void* memory_ = nullptr;  // SUNDIALS'; nullptr when released

 private:
  State result_;
  bool backwards_ = false;
  std::string message_;
  std::vector<std::function<void()>> cleanup_;
};

}  // namespace ringwatch::detail
