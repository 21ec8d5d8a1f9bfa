#pragma once
#include <string>
#include <vector>

#include <ringwatch/integrators/body_system.h>
#include <ringwatch/verify/report.h>

namespace ringwatch::detail {

/// A run of St. Venant–Kirchhoff with symplectic Euler at a fixed step that its critical step falls below.
struct History {
  std::string name, title;
  Body body;
  double h;         // s
  int steps;        // at most
  bool indefinite;  // whether it ends by compression, where the tangent loses its positive definiteness
};

/// Bars that are pulled, twisted and compressed, and a hanging ball: the histories of the monitor's study.
std::vector<History> monitorHistories(StudyEffort effort);

/// At rest at x = 0, the prescribed velocity at the other end, in proportion between: no shock to begin with.
State gentleStart(const BodySystem& system);

}  // namespace ringwatch::detail
