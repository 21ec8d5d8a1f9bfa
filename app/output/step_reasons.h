#pragma once
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

#include <ringwatch/body/body.h>
#include <ringwatch/integrators/integrator.h>
#include <ringwatch/monitor/critical_step.h>
#include <ringwatch/monitor/metrics/metrics.h>

namespace ringwatch {

/// What can make a critical step small.
enum class StepFault { penalty, damping, strain, shape, size, poisson, material };
inline constexpr auto stepFaultNames = nameTable<StepFault>({
    {StepFault::penalty, "penalty"},
    {StepFault::damping, "damping"},
    {StepFault::strain, "strain"},
    {StepFault::shape, "shape"},
    {StepFault::size, "size"},
    {StepFault::poisson, "poisson"},
    {StepFault::material, "material"},
});

/// What a bracket of a body at positions x (3×N, m) and its controlling element say of why the step is small: `why` of
/// the JSON files, without remedies and text. rule: of the bracket; integrator: whose undamped limit damping is
/// measured by. Null where every step is proven, or none.
nlohmann::ordered_json stepReasons(const Body& body, NodeVectorsView x, const StepRule& rule,
                                   const IntegratorInfo& integrator, const CriticalStep& step);

/// How the step without the elements in the way is had: from a bracket of its own, or from their rings.
enum class StepWithout { proven, guessed };
/// Completes what stepReasons() gave, of the same body and positions x: what it would bring to remesh, to add mass or
/// to take a handler, by the steps of the elements' reduced 1-rings, and the paragraph, a line an entry of `text`.
/// ring: at x where it is known; else it is evaluated in bodies of up to 20 000 elements. A step is proven for bodies
/// of up to 5000 elements that take handlers, and else guessed; where it is proven, so is that without the controlling
/// element alone.
void addRemedies(nlohmann::ordered_json& why, const Body& body, NodeVectorsView x, const StepRule& rule,
                 const IntegratorInfo& integrator, StepWithout without, const MetricResult* ring = nullptr);
/// The paragraph alone, where the body or the state is not at hand any more.
void addParagraph(nlohmann::ordered_json& why);

/// "element 1357 limits the step, without it 7.1e-08 s, +7 %; no handler pays", of `why`; "" of null.
std::string limitText(const nlohmann::ordered_json& why);

enum class Reasons { alone, withRemedies };
/// The paragraph, each of its lines between two texts; "" where there is none.
std::string reasonsText(const nlohmann::ordered_json& why, std::string_view before, std::string_view after,
                        Reasons which = Reasons::withRemedies);
/// What would help, in sentences; none where nothing is known.
std::vector<std::string> remediesOf(const nlohmann::ordered_json& why);

}  // namespace ringwatch
