#include <ringwatch/app/scene/capabilities.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include <ringwatch/app/scene/integrator_catalog.h>
#include <ringwatch/body/element_stress.h>
#include <ringwatch/handlers/imex/imex.h>
#include <ringwatch/handlers/mass_scaling/mass_scaling.h>

namespace ringwatch {
namespace {

using F = Feature;
using U = SceneUse;

/// Whether a member of a scene, or what it returns, is there: not empty, not false.
template <auto member>
bool has(const Scene& scene) {
  decltype(auto) value = std::invoke(member, scene);
  if constexpr (requires { value.empty(); })
    return !value.empty();
  else
    return static_cast<bool>(value);
}
template <OnViolation wanted>
bool onViolationIs(const Scene& scene) {
  return scene.onViolation == wanted;
}
bool isImex(const Scene& scene) { return scene.handler == Imex::description.name; }
bool dashpotsIn(const Scene& s) {
  return !s.massDampings.empty() || std::ranges::any_of(s.springs, [](const auto& one) { return one.damping > 0; }) ||
         std::ranges::any_of(s.contacts, [](const auto& one) { return one.damping > 0 || one.friction > 0; });
}
bool rubs(const Scene& s) {
  return std::ranges::any_of(s.contacts, [](const auto& one) { return one.friction > 0; });
}
bool changesInTime(const Scene& s) {
  const auto hasTable = [](const auto& one) { return one.table.has_value(); };
  return !s.pressures.empty() || std::ranges::any_of(s.moves, &Scene::Move::changes) ||
         std::ranges::any_of(s.forces, hasTable) || std::ranges::any_of(s.obstacles, hasTable);
}
bool solvesOtherwise(const Scene& s) {
  const OptionValue* solver = s.handlerOptions.own.find("solver");
  return isImex(s) && solver && *solver != OptionValue(Imex::newton) && *solver != OptionValue("auto");
}
bool hasOtherFields(const Scene& s) {
  return s.frameInterval && std::ranges::any_of(s.fields, [](const std::string& field) {
           return field != "critical_step" && !findStressMeasure(field);
         });
}

/// Explicit steps of fixed order, whose states are positions and velocities.
bool isExplicit(const IntegratorInfo& info) {
  return info.forceEvaluations > 0 && !info.partitioned && !info.adaptive && !std::isinf(info.imaginaryLimit);
}
bool hasOneForce(const IntegratorInfo& info) { return info.forceEvaluations == 1 && isExplicit(info); }
bool highestModeBinds(const IntegratorInfo& info) { return info.highestModeBinds; }

constexpr std::string_view statesAlone =
                               "their forces are those of the states of a run, of which each step asks for one",
                           proven = "the bracket is proven with damping where the highest mode binds",
                           wholeState = "a state must be positions and velocities alone";

/// What is no elastic element.
constexpr Features forces{F::discrete, F::elementDamping, F::rigid};
constexpr Features watching{F::probes, F::reactions, F::exactTimes};

constexpr FeatureInfo features[] = {
    {F::handler, F::handler, "handlers", has<&Scene::handler>, takesHandler,
     "they replace explicit steps of one force whose limit is 2"},
    {F::timed, F::timed, "loads and motions that change in time", changesInTime, hasOneForce, statesAlone},
    {F::pressure, F::timed, "pressures", has<&Scene::pressures>},
    {F::discrete, F::discrete, "springs and contact", has<&Scene::hasDiscreteForces>, isExplicit,
     "they are forces of explicit steps"},
    {F::surfaces, F::discrete, "surfaces in contact",
     [](const Scene& s) { return std::ranges::any_of(s.contacts, &Scene::Contact::withSurface); }},
    {F::movingObstacles, F::discrete, "moving obstacles", has<&Scene::movesObstacles>, hasOneForce, statesAlone},
    {F::dashpots, F::discrete, "dashpots and friction", dashpotsIn, highestModeBinds, proven},
    {F::friction, F::discrete, "friction", rubs},
    {F::elementDamping, F::elementDamping, "elements that damp", has<&Scene::hasElementDamping>, highestModeBinds,
     proven},
    {F::rayleigh, F::rayleigh, "Rayleigh damping", [](const Scene& s) { return s.damping.any(); }},
    {F::stiffnessDamping, F::rayleigh, "stiffness-proportional damping",
     [](const Scene& s) { return s.damping.beta != 0; }},
    {F::provenDamping, F::rayleigh, "proofs with Rayleigh damping",
     [](const Scene& s) { return s.damping.any() && s.proves(); }, highestModeBinds, proven},
    {F::rigid, F::rigid, "rigid bodies", has<&Scene::rigids>, [](const IntegratorInfo& info) { return info.drifts; },
     "their nodes do not move along straight lines"},
    {F::cuts, F::cuts, "cuts", has<&Scene::cuts>},
    {F::erosion, F::erosion, "elements that erode", has<&Scene::erosion>, isExplicit, wholeState},
    {F::uniformStrain, F::uniformStrain, "rules of uniform strain", has<&Scene::hasUniformStrain>},
    {F::otherLaws, F::otherLaws, "laws without young and poisson",
     [](const Scene& s) {
       return std::ranges::any_of(
           s.materials, [](const auto& m) { return !m.parameters.find("young") || !m.parameters.find("poisson"); });
     }},
    {F::nodalMass, F::nodalMass, "whole masses of nodes",
     [](const Scene& s) {
       return std::ranges::any_of(s.pointMasses, [](const auto& m) { return m.nodal.has_value(); });
     }},
    {F::certificates, F::certificates, "certificates along a run", has<&Scene::certificates>},
    {F::mustCertify, F::mustCertify, "runs that must be certified", has<&Scene::requireCertified>},
    {F::gaps, F::gaps, "steps that are not observed", [](const Scene& s) { return s.every > 1; }},
    {F::savedStates, F::savedStates, "saved states",
     [](const Scene& s) { return s.checkpointInterval || s.onViolation == OnViolation::repeat; }, isExplicit,
     wholeState},
    {F::repeat, F::savedStates, "runs that go back", onViolationIs<OnViolation::repeat>},
    {F::reduceStep, F::reduceStep, "steps that are reduced", onViolationIs<OnViolation::reduceStep>},
    {F::hold, F::hold, "steps that are held", has<&Scene::holdsStep>},
    {F::checkpoints, F::savedStates, "checkpoints", has<&Scene::checkpointInterval>},
    {F::exactTimes, F::exactTimes, "frames between steps", has<&Scene::exactTimes>},
    {F::probes, F::probes, "probes", has<&Scene::probes>},
    {F::reactions, F::reactions, "reactions", has<&Scene::reactions>},
    {F::metric, F::metric, "metrics", has<&Scene::metric>},
    {F::noBracket, F::noBracket, "runs without a bracket", [](const Scene& s) { return !s.proves(); }},
    {F::budget, F::budget, "budgets of the monitor", has<&Scene::budget>},
    {F::fields, F::fields, "fields of frames but critical_step and stresses", hasOtherFields},
    {F::handlerAuto, F::handler, "handlers with step = \"auto\"",
     [](const Scene& s) { return !s.handler.empty() && !s.step; }},
    {F::handlerSolver, F::handler, "linear solvers of imex", solvesOtherwise},
    {F::handlerDamping, F::handler, "imex with damping", [](const Scene& s) { return isImex(s) && s.damping.any(); }},
    {F::handlerHandle, F::handler, "choices of imex along a run",
     [](const Scene& s) { return isImex(s) && s.onViolation == OnViolation::handle; }},
    {F::handlerHalves, F::handler, "handlers that halve the step",
     [](const Scene& s) { return isImex(s) && s.reduceOnFailure; }},
    {F::handlerDevices, F::handler, "handlers on several GPUs",
     [](const Scene& s) { return !s.handler.empty() && s.devices.size() != 1; }},
};

constexpr Conflict conflicts[] = {
    {forces | F::timed, {F::handler}, "a handler chooses among elements alone, under loads that stay as they are"},
    {{F::erosion}, {F::handler}, "a handler has chosen among elements that stay"},
    {{F::certificates}, {F::handler}, "certificates are of the whole body, which a handler takes apart"},
    {{F::reduceStep, F::hold}, {F::handler}, "a handler keeps the step that is given, or follows the bracket"},
    {forces | F::timed | F::erosion | F::nodalMass, {F::cuts}, "a cut gives the body other nodes and elements"},
    {{F::erosion}, {F::pressure}, "the surface that is pressed would change"},
    {{F::certificates},
     forces | F::uniformStrain | F::otherLaws,
     "files of proofs know undamped elements alone, by Young's modulus and full quadrature"},
    {{F::certificates}, {F::erosion}, "certificates along a run are of one body"},
    {{F::certificates, F::mustCertify}, {F::noBracket}, "what is certified is proven by a bracket"},
    {{F::mustCertify}, {F::gaps}, "nothing is proven of the steps between two observations"},
    {{F::savedStates}, {F::handler, F::cuts, F::erosion}, wholeState},
    {{F::repeat}, {F::checkpoints}, "a checkpoint would hold a state that is taken back"},
};

constexpr std::string_view runDoes = "ringwatch run does";
constexpr SceneUseInfo uses[] = {
    {U::gpu, "a GPU", "set integrator.device = \"cpu\"", [](const IntegratorInfo& info) { return info.runsOnGpu; },
     "its steps are not there", [](const HandlerInfo& info) { return info.forGpu != nullptr; },
     "its steps are not there"},
    {U::ranks, "a run on ranks", "run the scene with one process, without mpirun", isExplicit,
     "ranks share the forces of explicit steps",
     [](const HandlerInfo& info) {
       return info.name == Imex::description.name || info.name == MassScaling::description.name;
     },
     "its steps are not distributed"},
    {U::compare, "compare", runDoes},
    {U::advise, "advise", runDoes, takesHandler, "it takes no handler"},
    {U::suggest, "suggest", runDoes, hasCriticalStep, "it has no critical step"},
    {U::stretch, "--stretch", "leave it out"},
    {U::scaleMass, "scale-mass", runDoes, hasCriticalStep, "it has no critical step"},
    {U::audit, "audit", runDoes},
};

constexpr std::string_view ways = "it tries ways to step on elements that stay, under loads that stay";
constexpr SceneUses commands{U::compare, U::advise, U::suggest, U::stretch, U::scaleMass, U::audit};
constexpr Fate left = Fate::meansNothing;
constexpr bool told = true;
constexpr Limit limits[] = {
    {{U::gpu}, forces | F::rayleigh | F::uniformStrain, "its kernels know undamped elements under dead loads"},
    {{U::gpu}, {F::timed, F::cuts, F::erosion, F::exactTimes, F::savedStates}, "it takes several steps at a time"},
    {{U::gpu}, {F::handlerAuto}, "it handles elements in steps of one size"},
    {{U::gpu}, {F::handlerDevices}, "the elements that are handled are on one"},
    {{U::ranks}, forces | F::pressure | F::cuts | F::erosion, "ranks share the forces of undamped elements that stay"},
    {{U::ranks},
     {F::handlerAuto, F::handlerSolver, F::handlerDamping, F::handlerHandle, F::handlerHalves},
     "ranks choose elements once, for one step"},
    {{U::ranks},
     {F::probes, F::reactions, F::metric, F::budget, F::certificates, F::repeat, F::fields},
     "ranks watch by the bracket or not at all, and write history, frames and checkpoints"},
    {{U::compare, U::advise}, forces, "it tries ways to step undamped elements alone"},
    {{U::compare, U::advise}, {F::timed, F::erosion}, ways},
    {{U::compare}, {F::cuts}, ways},
    {{U::suggest}, {F::surfaces}, "which faces come to touch is known along a run alone"},
    {{U::stretch}, {F::elementDamping}, "what damps is not bounded over a range of stretches"},
    {{U::stretch}, {F::friction}, "its damping grows with the depth to which nodes come"},
    {{U::scaleMass}, forces, "it weighs the stiffness of elements alone"},
    {{U::audit}, {F::discrete, F::rigid}, "it audits elements alone"},
    {{U::audit}, {F::cuts, F::erosion}, "the states that it is given are of elements that stay"},
    {{U::advise, U::suggest, U::scaleMass}, {F::cuts}, "it is of the body before the first cut", left, told},
    {{U::suggest, U::scaleMass}, {F::erosion}, "it is of the body with all its elements", left, told},
    {{U::suggest}, {F::handler}, "without the handler; with it larger steps are possible", left, told},
    {{U::compare, U::advise, U::scaleMass, U::audit}, {F::handler}, "it tries handlers of its own, or none", left},
    {commands,
     watching | F::noBracket | F::metric | F::budget | F::certificates | F::mustCertify | F::gaps | F::savedStates |
         F::reduceStep | F::hold | F::fields,
     "it is of a run", left},
};

template <class Table>
constexpr bool inOrder(const Table& table, auto key) {
  for (std::size_t i = 0; i < std::size(table); ++i)
    if (static_cast<std::size_t>(table[i].*key) != i) return false;
  return true;
}
static_assert(inOrder(features, &FeatureInfo::feature) && inOrder(uses, &SceneUseInfo::use));

/// Whether a row names a feature, or the whole that it is a part of.
bool names(const Features& row, Feature feature) { return row.has(feature) || row.has(infoOf(feature).whole); }

}  // namespace

std::span<const FeatureInfo> sceneFeatures() { return features; }
std::span<const SceneUseInfo> sceneUses() { return uses; }
std::span<const Conflict> featureConflicts() { return conflicts; }
std::span<const Limit> useLimits() { return limits; }
const FeatureInfo& infoOf(Feature feature) { return features[static_cast<std::size_t>(feature)]; }
const SceneUseInfo& infoOf(SceneUse use) { return uses[static_cast<std::size_t>(use)]; }

Capability capability(Feature one, Feature other) {
  for (const Conflict& row : conflicts)
    if ((names(row.these, one) && names(row.those, other)) || (names(row.these, other) && names(row.those, one)))
      return {Fate::refused, row.why};
  return {};
}

Capability capability(Feature feature, SceneUse use) {
  for (const Limit& row : limits)
    if (row.by.has(use) && names(row.of, feature)) return {row.fate, row.why};
  return {};
}

}  // namespace ringwatch
