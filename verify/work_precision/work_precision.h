#pragma once
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <ringwatch/body/body.h>
#include <ringwatch/integrators/additive_system.h>
#include <ringwatch/verify/integrators/oscillator.h>
#include <ringwatch/verify/report.h>

namespace ringwatch {

/// A motion whose end is known, for integrators to compete on.
struct WorkPrecisionCase {
  std::string name;   // a file name and a JSON key
  std::string title;  // one line, human-readable
  DifferentiableSystem& system;
  State start;
  double end;             // s
  double lambda;          // highest eigenvalue at the start, rad²/s²
  NodeVectors reference;  // positions at the end, 3×N, m
  double referenceError;  // of the reference, over the displacement at the end; 0 when it is exact
  /// The system in parts for a partitioned integrator at a step (s), and the share of its cost that is in the stiff
  /// one; empty where there are none: such integrators are left out then.
  struct Parts {
    std::unique_ptr<AdditiveSystem> system;
    double stiffShare;
  };
  std::function<Parts(const IntegratorInfo&, double h)> split;
  /// The error of the state at the end; empty: |x - reference| over |reference - start|.
  std::function<double(const State& end)> errorOf = {};
};

/// One integrator at one step.
struct WorkPrecisionRun {
  std::string integrator;
  double h;            // s
  double error;        // see WorkPrecisionCase::errorOf; NaN when the run was lost
  double seconds;      // of computing by the calling thread, the best of up to three
  double forces;       // evaluations of the force; those of a part count by its share
  double products;     // tangent products, K(x) u
  double matrices;     // assembled tangents
  std::string reason;  // why it was lost; "" when it was not
};

/// What a run is made of: an integrator ready for its step, and the system that it is to run, with all that this needs
/// to stay alive.
struct PreparedRun {
  std::unique_ptr<Integrator> integrator;
  std::unique_ptr<SecondOrderSystem> system;
  std::shared_ptr<void> keep = nullptr;
};
/// One run of a case at a step of at most h (s) that divides its end. prepare: called before each of up to three
/// repetitions, with the step; its time does not count. Counts of forces, products and matrices are left to the caller.
WorkPrecisionRun runPrepared(const WorkPrecisionCase& c, std::string_view name, double h,
                             const std::function<PreparedRun(double h)>& prepare);

struct WorkPrecisionOptions {
  std::vector<double> steps;  // s; empty: halvings of the largest step that makes sense for each integrator
  int levels = 7;             // of halvings
  std::function<void(const std::string& what, double share)> progress;  // called before every run
};

/// The end of a motion by ever smaller steps of a fourth-order scheme (PEFRL; classical Runge-Kutta with damping),
/// until halving the step changes it by less than `tolerance` of the displacement. Throws NumericalError when it does
/// not converge: then there is nothing to compare with. Displacements of less than 1e-12 of the positions are rounding:
/// where no step gives more, nothing moves.
struct ConvergedMotion {
  NodeVectors x;
  double change;  // at the last halving, relative
  double h;       // s
  bool moves;     // else change is 0
};
ConvergedMotion convergedMotion(SecondOrderSystem& system, const State& start, double end, double lambda,
                                double tolerance = 1e-9);

/// Runs every integrator over a range of steps. One that is unstable at every step without damping is left out, unless
/// steps are given.
std::vector<WorkPrecisionRun> runWorkPrecision(const WorkPrecisionCase& c, std::span<const IntegratorEntry> integrators,
                                               const WorkPrecisionOptions& options = {});

/// The run that reaches an error at the least cost.
struct CheapestRuns {
  std::string label;  // "1 %"
  double error;
  const WorkPrecisionRun* byTime = nullptr;    // nullptr: none reaches it
  const WorkPrecisionRun* byForces = nullptr;  // forces and tangent products together
};
/// The cheapest runs for errors of 1 %, 0.1 % and 1e-6. Points into `runs`.
std::vector<CheapestRuns> cheapestRuns(const std::vector<WorkPrecisionRun>& runs);

/// Adds the tables NAME_runs and NAME_cheapest and the figures work_precision_NAME_time and …_forces to a report.
void addWorkPrecision(const WorkPrecisionCase& c, const std::vector<WorkPrecisionRun>& runs, StudyReport& report);

/// Fierz 2013's fig. 1.2: seconds of computing for one millisecond of a 10 x 1 x 1 cm corotational bar under gravity,
/// fixed at one end, as it is refined: symplectic Euler in as many steps as 0.9 of its limit asks for, against one step
/// of `implicit`. Adds a table and a figure to the report.
void addRefinedBar(const IntegratorFactory& implicit, int finest, StudyReport& report);

/// The standard cases: an oscillator over ten periods, a swinging St. Venant–Kirchhoff bar, the same with slivers.
/// levels, end: as above; s of the bars.
void addStandardCases(std::span<const IntegratorEntry> integrators, int levels, double end, StudyReport& report,
                      const std::function<void(const WorkPrecisionCase&, const std::vector<WorkPrecisionRun>&)>& seen);

/// The body in two parts for a partitioned integrator at a step h (s). Stiff are the elements that alone would be
/// unstable, such that the others' highest frequency, proven at rest, is at most nonstiffShareOfLimit of the
/// integrator's limit over h.
WorkPrecisionCase::Parts partitionForStep(const Body& body, const RayleighDamping& damping, const IntegratorInfo& info,
                                          double h);

}  // namespace ringwatch
