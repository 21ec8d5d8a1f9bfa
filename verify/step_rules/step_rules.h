#pragma once
#include <ringwatch/verify/report.h>

namespace ringwatch {

/// The step rules that solvers take from the shape of elements, against the exact critical step of free linear elastic
/// bars at rest: regular and jittered bars of every element, flat, slender and sliver ones, and nearly incompressible
/// ones.
///
/// Tables: step-rules, a row a mesh: the exact step and each rule's step over it, above 1 where the rule is unsafe;
/// unsafe, a row a rule: on how many meshes it is, and the mesh where it is most. Checks: the proven bracket on each
/// mesh. Without figures; quick and full are the same.
StudyReport verifyStepRules(StudyEffort effort);

}  // namespace ringwatch
