#pragma once
#include <ringwatch/verify/report.h>

namespace ringwatch {

/// The step rules that solvers take from the shape of elements against the exact critical step.
///
/// Shapes: random and bad tetrahedra, hexahedra, wedges and pyramids, alone and free, at rest and stretched, and
/// triangles and quadrilaterals in plane strain, for Poisson's ratios of 0 to 0.499. Tables, a row a family: `unsafe`,
/// the share of shapes on which a rule gives more than the exact step; `largest`, the largest step over the exact one;
/// `waste`, what a rule gives away on average where it is safe; `error`, its mean distance from the exact step; by
/// Poisson's ratio `largest-by-poisson`; `worst-shapes`, the shapes themselves.
/// Meshes: `step-rules`, a row a mesh: the exact step and each rule's step over it; `unsafe-meshes`, a row a rule.
/// Maps of triangles and of a plane of tetrahedra. Checks: the exact steps against dense eigenvalues, the proven
/// bracket on some shapes of each family and on each mesh.
StudyReport verifyAtlas(StudyEffort effort);

namespace detail {
/// Adds what the rules do on whole meshes: bars, balls and rings of every element, flat, slender and sliver ones,
/// nearly incompressible ones, free and at rest.
void addRulesOnMeshes(StudyReport& report);
}  // namespace detail

}  // namespace ringwatch
