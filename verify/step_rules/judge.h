#pragma once
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <ringwatch/body/body.h>
#include <ringwatch/verify/report.h>

namespace ringwatch {

/// The step, s, of central differences that another's rule gives for a mesh as it is now, free and of one elastic
/// material: young in Pa, density in kg/m³.
using StepRuleOfOthers = std::function<double(const Mesh& mesh, double young, double poisson, double density)>;

/// What a rule is judged on.
struct JudgeOptions {
  int shapesOfFamily = 20;                           // of each family of the atlas; 0 for none
  std::vector<std::string> elements;                 // whose shapes; empty for all
  std::vector<std::pair<std::string, Mesh>> meshes;  // with their names
  bool histories = false;                            // states of bars and a ball that are pulled, twisted, compressed
  double young = 1e6, poisson = 0.3, density = 1000;
};

/// The case in which a rule is farthest above the exact step.
struct WorstCase {
  std::string name;
  Mesh mesh;                       // as the rule saw it
  NodeVectors rest;                // its nodes before it moved, 3×N, m
  std::string law;                 // of its material
  std::vector<std::int32_t> held;  // nodes that follow no forces
  double given, exact;             // s
  double young, poisson, density;
};

struct Judgement {
  /// Tables: `judge`, a row a family, mesh or history: on how many cases the step is above the exact one, the largest
  /// step over it, and what safe steps give away on average. Checks: that it is above nowhere.
  StudyReport report;
  std::optional<WorstCase> worst;  // where the rule is unsafe somewhere
};

/// Judges a rule by exact steps. Throws InputError where there is nothing to judge it on, for an element that no family
/// has, for a mesh whose highest frequency does not exist, and where the rule gives what is no positive number, naming
/// the case; and what the rule throws.
Judgement judgeRule(const StepRuleOfOthers& rule, const JudgeOptions& options);

}  // namespace ringwatch
