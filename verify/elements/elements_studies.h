#pragma once
#include <string>
#include <vector>

#include <ringwatch/body/body.h>
#include <ringwatch/verify/report.h>

/// The parts of verifyElements and what they share.
namespace ringwatch::detail {

/// An element with one of its quadrature rules.
struct ElementRule {
  const ElementInfo* element;
  const QuadratureRule* rule;
  std::string name() const { return std::string(element->name) + " " + std::string(rule->name); }
  bool isDefault() const { return rule == &element->rules[0]; }
  BodyOptions options() const { return {{{std::string(element->name), std::string(rule->name)}}, Lumping::rowSum, 0}; }
};
inline std::vector<ElementRule> allElementRules() {
  std::vector<ElementRule> all;
  for (const ElementInfo& element : allElements())
    for (const QuadratureRule& rule : element.rules) all.push_back({&element, &rule});
  return all;
}

void studyShapes(StudyReport& report);
void studyRank(StudyReport& report);
void studyPatch(StudyReport& report);
void studyDerivatives(StudyReport& report);
void studyConvergence(StudyReport& report, StudyEffort effort);
void studyFrequencies(StudyReport& report, StudyEffort effort);
void studyCantilever(StudyReport& report, StudyEffort effort);

}  // namespace ringwatch::detail
