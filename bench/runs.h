#pragma once
#include <ctime>
#include <utility>

#include <bench/support.h>
#include <ringwatch/integrators/body_system.h>
#include <ringwatch/integrators/symplectic_euler.h>
#include <ringwatch/monitor/bounds/reduced_ring.h>

/// What several benchmark programs time in the same way.
namespace ringwatch::bench {

/// CPU seconds of this process: other programs run beside.
inline double cpuSeconds() {
  timespec t{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

constexpr double stillStep = 1e-9;  // s; the state stays what it is, so that every step costs the same

/// Times symplectic Euler, force and update. The error is how far the state has moved at all.
inline void timeSteps(benchmark::State& state, Setup& s) {
  BodySystem system(s.body);
  SymplecticEuler integrator;
  State at = system.initialState();
  at.x = s.x;
  integrator.step(system, at, stillStep);
  for (auto _ : state) {
    integrator.step(system, at, stillStep);
    benchmark::DoNotOptimize(at.x.data());
    benchmark::ClobberMemory();
  }
  report(state, s.body.mesh().elementCount(), relativeDifference(at.x, s.x));
}

/// Times all reduced 1-rings from element tangents, as a run needs them: patterns kept from the observation before.
/// Returns the highest eigenvalue, rad²/s².
inline double timeReducedRings(benchmark::State& state, const Setup& s) {
  ReducedRing ring(s.body);
  double lambda = ring.evaluate(s.x).highest;
  for (auto _ : state) {
    lambda = ring.evaluate(s.x).highest;
    benchmark::DoNotOptimize(std::as_const(lambda));
  }
  return lambda;
}

}  // namespace ringwatch::bench
