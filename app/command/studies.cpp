#include <ringwatch/app/command/verify.h>
#include <ringwatch/app/scene/integrator_catalog.h>
#include <ringwatch/base/registry.h>
#include <ringwatch/verify/elements/elements.h>
#include <ringwatch/verify/handlers/handlers.h>
#include <ringwatch/verify/histories/histories.h>
#include <ringwatch/verify/integrators/integrators.h>
#include <ringwatch/verify/literature/literature.h>
#include <ringwatch/verify/monitor/monitor.h>
#include <ringwatch/verify/remeshing/remeshing.h>
#include <ringwatch/verify/robustness/robustness.h>
#include <ringwatch/verify/step_rules/atlas.h>
#include <ringwatch/verify/work_error/work_error.h>

namespace ringwatch {

namespace {

/// Every study, one entry each.
const StudyInfo studiesOfLibrary[] = {
    {"atlas", "step rules of other solvers, from shapes of elements, against the exact step: shapes, maps and meshes",
     verifyAtlas, "step-rules"},
    {"elements", "every element and quadrature rule: rank, patch test, derivatives, convergence, frequencies, locking",
     verifyElements},
    {"handlers",
     "every handler beyond the critical step: what it takes, error, cost, energy and momentum over many steps",
     verifyHandlers},
    {"histories", "nonlinear runs as a data set: exact steps, brackets, events and certificates", verifyHistories},
    {"integrators", "every integrator: stability limit, order, energy drift, reversibility, damping",
     [](StudyEffort effort) { return verifyIntegrators(effort, integratorCatalog().entries()); }},
    {"literature", "published frequencies and critical steps against ours, each with its source", verifyLiterature},
    {"monitor", "bracket, metrics, drift bounds and alarms of the monitor against exact values; nonlinear histories",
     verifyMonitor},
    {"remeshing", "bad meshes through TetGen and gmsh: what a better mesh gives, beside what handlers give",
     verifyRemeshing},
    {"robustness", "explicit integrators run long and on hard bodies: who survives, and with what error",
     [](StudyEffort effort) { return verifyRobustness(effort); }, "stress"},
    {"work-error", "error of displacement, energy and first frequency against time, by step rules and handlers",
     verifyWorkError},
};

Registry<StudyInfo>& registry() {
  static Registry<StudyInfo> studies("study", studiesOfLibrary);
  return studies;
}

}  // namespace

std::span<const StudyInfo> allStudies() { return registry().all(); }
JudgeFunction judgeOfStudies() { return judgeRule; }
void registerStudy(const StudyInfo& study) { registry().add(study); }

}  // namespace ringwatch
