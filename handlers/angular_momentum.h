#pragma once
#include <cstdint>
#include <span>

#include <ringwatch/body/body.h>

namespace ringwatch {

/// Whether forces among these elements have no torque that a support or a law brings in: no node of theirs is
/// constrained and their laws are objective. Then what replaces them must have none either.
bool isFreeOfTorque(const Body& body, std::span<const ElementRef> elements, std::span<const std::int32_t> nodes);

/// Changes accelerations a (3×N, m/s²) at some nodes so that they exert the same torque at positions x (3×N, m) as
/// those before, which are given at these nodes (3×n), by a rotation of where the step ends, y = x + h (v + h a), about
/// its centre of mass: h² δa_i = w × (y_i - c). Linear momentum stays, and no element changes its handedness (Theorem
/// 68, docs/theory/handlers.md).
void keepAngularMomentum(const Body& body, std::span<const std::int32_t> nodes, NodeVectorsView x, const NodeVectors& v,
                         double h, const NodeVectors& before, NodeVectors& a);

/// Takes from velocities v (3×N, m/s) at positions x (m) the rigid motion that added mass has brought with the velocity
/// of its nodes: afterwards momentum and angular momentum are those of v with the mass before (kg, by node).
void keepMomenta(const Body& body, const Eigen::VectorXd& massBefore, NodeVectorsView x, NodeVectors& v);

}  // namespace ringwatch
