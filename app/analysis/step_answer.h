#pragma once
#include <string>
#include <string_view>

#include <nlohmann/json.hpp>

#include <ringwatch/app/scene/scene.h>
#include <ringwatch/monitor/stability_monitor.h>
#include <ringwatch/monitor/step_limit.h>

namespace ringwatch {

/// Equal steps in `time` seconds of which none is longer than h; 0 for none that is finite.
double stepsIn(double time, double h);

/// "the tangent is indefinite, …: no step cures that", of a bracket for which it is; else "".
std::string indefiniteText(const CriticalStep& bracket);

/// What is proven of steps up to a safe one: "stable", or of an indefinite tangent what is left of that.
std::string_view stableUpTo(const CriticalStep& bracket);
/// What a bracket says of a step, s. mayBeStable: as in Scene; then nothing is proven unstable.
Verdict verdictOf(double step, const CriticalStep& bracket, const std::string& mayBeStable);
/// A verdict in words.
std::string verdictText(Verdict verdict, const CriticalStep& bracket, const std::string& mayBeStable = "");

/// What a bracket says of a step, one line.
struct StepAnswer {
  nlohmann::ordered_json json;  // the contract of `timestep`
  std::string text;
};
/// Of the step of a scene, else of the one that its own program takes (Scene::ownStep): whether it is proven stable or
/// unstable, the largest one that is proven stable, and how many substeps of it are. The latter step has no bulk
/// viscosity at rest, and so has what it is held against; it is not read from `bracket` then.
StepAnswer answerStep(const Scene& scene, const Body& body, CriticalStep bracket);

}  // namespace ringwatch
