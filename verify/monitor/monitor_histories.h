#pragma once
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include <ringwatch/integrators/body_system.h>
#include <ringwatch/monitor/energy_balance.h>
#include <ringwatch/monitor/stability_monitor.h>
#include <ringwatch/verify/report.h>

namespace ringwatch::detail {

/// A run with symplectic Euler at a fixed step; those of monitorHistories are of St. Venant–Kirchhoff, and their
/// critical step falls below that step.
struct History {
  std::string name, title;
  Body body;
  double h;         // s
  int steps;        // at most
  bool indefinite;  // whether it ends by compression, where the tangent loses its positive definiteness
};

/// A bar of 0.2 x 0.04 x 0.04 m of 5 n x n x n cells, n = cells, whose end x = 0 is held; the other one moves at a
/// velocity, m/s, or turns at a rate, 1/s, to begin with. law: of study_bodies.h's soft solid.
Body movedBar(std::string_view element, int cells, const Eigen::Vector3d& velocity, double rate,
              std::string_view law = "stvk");
/// A ball held at a few nodes near its top, in a field of force that grows toward its bottom; cells across.
Body hangingBall(std::string_view element, int cells, std::string_view law = "stvk");

/// A state of a history as its monitor saw it.
struct HistoryState {
  std::int64_t step;
  const State& state;
  const MonitorReport& seen;
  const Energies& energies;
  bool energyOff;  // the energy balance is off by a tenth of the largest energy: the last state
};
/// Runs a history under a monitor without a budget until it ends, its energy is off or it is no longer finite. visit:
/// for every state, before its step is taken.
void followHistory(const History& history, const std::function<void(const HistoryState&)>& visit);

/// Bars that are pulled, twisted and compressed, and a hanging ball: the histories of the monitor's study.
std::vector<History> monitorHistories(StudyEffort effort);

/// At rest at x = 0, the prescribed velocity at the other end, in proportion between: no shock to begin with.
State gentleStart(const BodySystem& system);

}  // namespace ringwatch::detail
