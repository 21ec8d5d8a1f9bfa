#pragma once
#include <ringwatch/verify/integrators/oscillator.h>

namespace ringwatch {

/// Studies of what single oscillators at rest do not show: forces of time, forces that are not linear, and nodes and
/// components that each have an answer of their own.

/// Error of (x, v) at t = 1.5 from the exact state at 0.5, with n steps, of ẍ = p̈ + g(x) - g(p), g(x) = -x - x³, whose
/// exact motion is p(t) = sin t + cos(2 t)/4. Partitioned integrators get half of the linear force in the stiff part.
double drivenError(const IntegratorFactory& make, int steps);
/// Order of that error, by orderOf().
double measureDrivenOrder(const IntegratorFactory& make);

/// How the steps of a field of oscillators differ from those of one component of one node. Numbers are relative to the
/// amplitudes; NaN where a step fails.
struct FieldErrors {
  /// Every component of every node has the motion of a node alone, scaled.
  double components;
  /// Seen from a frame that moves at a constant speed, which is a force of time, the motion is the same plus the
  /// frame's: a scheme that asks for a force at another time than that of its positions errs.
  double frame;
  /// No lag is left. Without damping State::a, where a step leaves it, is the acceleration of the new state; advance()
  /// and complete() give what step() gives.
  double left;
};
/// Three steps of h = 0.1 from t = 3, forces of time included. nodes: more than nodesOfAThread have two threads update
/// them.
FieldErrors fieldErrors(const IntegratorFactory& make, int nodes, double dampingRatio);

}  // namespace ringwatch
