#pragma once
#include <string>
#include <vector>

#include <ringwatch/body/body.h>
#include <tests/support/meshes.h>
#include <tests/support/registry_types.h>

namespace ringwatch::test {

/// One of all registered combinations of element, law and quadrature rule.
struct BodyCase {
  const ElementInfo* element;
  std::string law;
  bool objective;
  const QuadratureRule* rule;
};
inline std::vector<BodyCase> allBodyCases() {
  std::vector<BodyCase> cases;
  for (const ElementInfo& element : allElements())
    forEachType(Laws{}, [&](auto tag) {
      using L = typename decltype(tag)::type;
      for (const QuadratureRule& rule : element.rules)
        cases.push_back({&element, std::string(L::name), L::objective, &rule});
    });
  return cases;
}
inline std::string bodyCaseName(const BodyCase& c) {
  return testName(std::string(c.element->name) + "_" + c.law + "_" + std::string(c.rule->name));
}

constexpr double young = 30e3, poisson = 0.3, density = 1000, cellSize = 0.01;
/// Nodal forces of order one strain, N: what rounding is measured against.
constexpr double forceScale = young * cellSize * cellSize;

inline Material materialOf(const BodyCase& c) { return makeMaterial(c.law, young, poisson, density); }
inline BodyOptions optionsOf(const BodyCase& c, int threads = 1) {
  return {{{std::string(c.element->name), std::string(c.rule->name)}}, Lumping::rowSum, threads};
}
/// A box of cells of 1 cm with distorted elements.
inline Mesh distortedBox(std::string_view element, Cells cells, double jitter = 0.2) {
  return gridMesh(element, cells, {cells[0] * cellSize, cells[1] * cellSize, cells[2] * cellSize}, jitter, 3);
}
/// Positions strained by some ten per cent: F differs from element to element, and none is inverted.
inline NodeVectors strained(const NodeVectors& X, std::uint64_t seed = 5, double disturbance = 0.05) {
  Random random(seed);
  const Eigen::Matrix3d F = Eigen::Matrix3d::Identity() + random.matrix(0.15);
  return F * X + random.nodeVectors(X.cols(), disturbance * cellSize);
}

}  // namespace ringwatch::test
