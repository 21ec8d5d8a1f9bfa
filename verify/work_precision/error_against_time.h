#pragma once
#include <functional>
#include <string>
#include <vector>

#include <ringwatch/integrators/integrator.h>
#include <ringwatch/verify/report.h>

namespace ringwatch {

/// One way to compute a motion, with all errors in one number: of mesh, element and integration.
struct ErrorCost {
  std::string motion;         // "swinging" or "stretched"
  std::string element;        // with the default rule
  std::string mesh;           // "regular", or "slivers"
  std::string method;         // integrator, or handler on verlet
  std::int64_t elements = 0;  // how many
  double h = 0;               // s
  double error = 0;           // see addErrorAgainstTime
  double seconds = 0;         // of computing, one thread, without set-up
};

/// The whole picture of accuracy against cost: a St. Venant–Kirchhoff bar of 20 x 4 x 4 cm (30 kPa, 1000 kg/m³,
/// double precision) that swings under its weight for 0.5 s (nu = 0), and one that is pulled to 1.2 of its length in
/// 0.4 s (nu = 0.3), by every element, several sizes, integrators, steps and, on meshes with slivers, handlers.
///
/// The error is that of the displacement at the end in points on the bar's edges that every mesh has as nodes, root
/// mean square over that of the displacement itself: at every tenth of the swinging bar; of the pulled one from 0.3 to
/// 0.7 of its length, away from the clamps, in whose corners the stress is infinite, and with the uniform stretch taken
/// off. The reference is the finest mesh of twenty-node hexahedra in half its largest stable step; the report's checks
/// hold its difference from the second finest to 0.2 and 0.3 %, and errors below that difference are not asked for.
///
/// Adds the table error_against_time_cheapest, for 10 %, 1 % and 0.1 % the cheapest of all and of every element that
/// reaches it, and for each motion a figure of the runs that none beats in both error and time, by element.
/// integrators: those to compare; implicit and partitioned ones run on small meshes only.
std::vector<ErrorCost> addErrorAgainstTime(std::span<const IntegratorEntry> integrators, StudyEffort effort,
                                           StudyReport& report,
                                           const std::function<void(const std::string&)>& progress = {});

/// The runs that no other beats in both error and time, by time ascending.
std::vector<ErrorCost> paretoFront(std::vector<ErrorCost> runs);

}  // namespace ringwatch
