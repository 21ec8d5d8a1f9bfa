#pragma once
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include <ringwatch/app/output/exit_status.h>
#include <ringwatch/base/options.h>
#include <ringwatch/base/units.h>
#include <ringwatch/body/body.h>
#include <ringwatch/integrators/integrator.h>
#include <ringwatch/monitor/critical_step.h>
#include <ringwatch/monitor/stability_monitor.h>

namespace ringwatch {

/// A state of another program's results, and what is proven of it.
struct AuditedState {
  std::size_t index;                 // in the results, from 0
  std::optional<double> time, step;  // s; step: taken from here, or the mean of those to the next state
  std::optional<std::int64_t> increment;
  std::string where;                      // file or step of the results
  std::size_t notFinite = 0;              // nodes
  std::size_t deleted = 0;                // elements, by the other program
  std::optional<CriticalStep> bracket{};  // empty where the state has none
  std::string why = {};                   // it has none
  std::optional<Body::LeastDeterminant> least{};
  double strainEnergy = 0;  // J

  bool inverted() const { return least && !(least->value > 0); }
  bool indefinite() const { return bracket && bracket->indefinite(); }
  std::optional<Verdict> verdict() const {
    if (!bracket || !step) return std::nullopt;
    return verdictOfState(*step, *bracket);
  }
  bool violated() const { return verdict() == Verdict::violated; }
  /// Neither finite nor with a tangent.
  bool lost() const { return !bracket; }
};

/// What was found first at a state: its key in the JSON, in a few words, and as a sentence.
struct AuditEvent {
  std::string key, name, text;
  std::size_t state;  // place in the audited states
};

/// An audit as a page takes it.
struct Audit {
  std::string name;  // of the results
  const Body& body;
  const IntegratorInfo* integrator;  // nullptr where only its limit is known
  StepRule rule;
  RayleighDamping damping;
  const std::vector<AuditedState>& states;
  const std::vector<AuditEvent>& events;
  std::function<NodeVectors(const AuditedState&)> positions;  // 3×N, m
  nlohmann::ordered_json json;                                // the numbers of the audit
  std::vector<std::string> notes;
};

/// What `ringwatch audit` is asked.
struct AuditOptions {
  std::vector<std::filesystem::path> results;  // .frd, .pvd, or .vtu and .vtk files in their order
  std::filesystem::path scene;                 // a scene or a deck with the materials and supports; "" for none
  std::string model;                           // the law, instead of the scene's; "" for it, else "stvk"
  Options parameters;                          // of the law; must be given without a scene
  std::optional<double> density;               // kg/m³; likewise
  std::string displacement;                    // name of the field; "" for the usual ones
  std::optional<double> step;                  // s, that they took; empty: as the results tell, or by their increments
  std::optional<double> limit;                 // h omega of their integrator
  std::string integrator;                      // one of ours with that limit; "" for symplectic-euler
  std::vector<std::string> fix;                // nodes that are held, as inspect's
  std::vector<std::string> rules;              // ELEMENT=RULE: quadrature rules
  std::optional<Lumping> lumping;
  std::optional<Units> units;
  int every = 1;     // every so many states
  bool all = false;  // a line of the table for every state
  int threads = 0;
  std::function<void(const Audit&)> page;  // is called with what was found; empty for none
};

struct AuditResult {
  nlohmann::ordered_json json;
  std::string text;
  ExitStatus status = ExitStatus::done;
};

/// The bracket of every state that another program has left, against the step that it took: where its run left proven
/// ground. Throws InputError for bad input.
AuditResult auditResults(const AuditOptions& options);
/// The states of AuditResult::json as test cases in JUnit's XML. One fails where its step is not certified, an element
/// is inverted or the state is lost, and is skipped where its step is not told.
std::string junitOfStates(const nlohmann::ordered_json& audit);

}  // namespace ringwatch
