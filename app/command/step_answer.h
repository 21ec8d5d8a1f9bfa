#pragma once
#include <string>

#include <nlohmann/json.hpp>

#include <ringwatch/monitor/step_limit.h>

namespace ringwatch {

/// Equal steps in `time` seconds of which none is longer than h; 0 for none that is finite.
double stepsIn(double time, double h);

/// "the tangent is indefinite, …: no step cures that", of a bracket for which it is; else "".
std::string indefiniteText(const CriticalStep& bracket);

/// What a bracket says of a step, one line.
struct StepAnswer {
  nlohmann::ordered_json json;  // the contract of `timestep`
  std::string text;
};
/// Of a step, s: whether it is proven stable or unstable, the largest one that is proven stable, and how many substeps
/// of it are. mayBeStable: as in Scene; then nothing is proven unstable.
StepAnswer answerStep(double step, const CriticalStep& bracket, const std::string& mayBeStable);

}  // namespace ringwatch
