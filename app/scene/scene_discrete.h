#pragma once
#include <functional>

#include <ringwatch/app/scene/scene.h>

namespace ringwatch {

/// Adds the point masses of a scene to its body. Throws InputError for selections without nodes.
void addPointMasses(const Scene& scene, Body& body);
/// Gives the body the springs and contact of its scene, if there are any; obstacles are where they are at the start.
/// Throws InputError for selections without nodes, obstacles that start inside the body, and a penalty "auto" that
/// cannot be had.
void addDiscreteForces(const Scene& scene, Body& body);

/// Builds the contact with the surface again on the elements that a body of the scene has left: faces of elements that
/// are gone no longer push, those that came to light do. Nodes and edges keep their penalties; new ones get, for their
/// mass, as little as the least of the others. A contact one side of which is gone ends. time: s, where obstacles are.
/// contacts: positions in scene.contacts of those with the surface that the body has; stays so.
void renewSurfaceContact(const Scene& scene, double time, std::vector<std::size_t>& contacts, Body& body);

/// The rule of the steps of a scene on its body. With dashpots or elements that damp it is exact at the scene's step;
/// the body then counts their damping for that step (DiscreteForces::setDampingFactor, ElementDamping::setFactor).
StepRule sceneStepRule(const Scene& scene, Body& body);
/// A rule that is exact at a step (reference, s), whatever the scene's is.
struct ReferencedRule {
  StepRule rule;
  double reference = 0;
};
/// A step of the body, s, by a rule; not positive and finite where there is none.
using StepByRule = std::function<double(const StepRule&)>;
/// About the safe step at positions x (3×N, m), for a reference, by the Rayleigh quotient of the top mode: it takes a
/// small part of what a bracket does. It follows the mode from call to call. body, x: by reference. side: what is made
/// of the quotient.
StepByRule stepOfTopMode(
    const Body& body, const NodeVectors& x,
    double (*side)(const StepRule&, LowerBound) = [](const StepRule& rule, LowerBound lambda) {
      return optimisticStep(lambda, rule);
    });
/// What counts of damping by velocities (ElementDamping::overcount).
enum class DampingRates {
  atRest,   ///< what bodies need that do not move, exactly
  followed  ///< what Body::followDampingRates leaves
};
/// The rule of the steps of a scene on its body, exact at a step h (s); the body then counts its damping for that step.
StepRule stepRuleAt(const Scene& scene, Body& body, double h, DampingRates rates);
/// Of the reference of a bracket, whose sides are some percent apart.
inline constexpr double ownStepTolerance = 1e-3;
/// The rule that is exact at the step which it gives itself, to a relative tolerance: what it says depends on no step
/// of the scene. The critical step is the one at which M - (h/2) C - (h²/4) K becomes singular, Theorem 47,
/// docs/theory/discrete_forces.md.
ReferencedRule ruleAtOwnStep(const Scene& scene, Body& body, DampingRates rates, double tolerance,
                             const StepByRule& step);

/// How far the penalties of contact could grow.
struct PenaltyRoom {
  double elementsAlone = 0;  ///< s, that the elements at rest prove without springs and contact
  double penalty = 0;        ///< N/m at each contact node, with which `share` of that step is proven
  double share = 0.95;
  std::optional<double> penaltyAtStep;  ///< N/m at each contact node, with which the run's step is proven
};
/// Of a scene's body at rest and a run of steps of at most `step` seconds; empty where the elements prove nothing, and
/// where they damp.
/// Theorem 46, docs/theory/discrete_forces.md.
std::optional<PenaltyRoom> penaltyRoom(const Scene& scene, const Body& body, double step);

/// Puts the obstacles of a scene where they are at a time, s.
void placeObstacles(const Scene& scene, double time, DiscreteForces& forces);

}  // namespace ringwatch
