#include <ringwatch/verify/step_rules/foreign_rules.h>

#include <ringwatch/meshes/generators/generators.h>
#include <ringwatch/monitor/metrics/element_metrics.h>
#include <ringwatch/monitor/step_limit.h>
#include <ringwatch/verify/study_bodies.h>

namespace ringwatch::detail {
namespace {

/// The exact step of a cube of one hexahedron over its edge's crossing by a pressure wave.
double stepOfCube(double poisson) {
  BarOptions cube;
  cube.element = "hex8";
  const Material material = makeMaterial("linear", 1, poisson, 1);
  const Body body(generateBar(cube), material);
  return stepFor(singleElement(body, body.mesh().X)[0][0], verletLimit) * material.waveSpeed();
}

constexpr ForeignRule rules[] = {
    {"shortest edge", "pressure-wave:shortest-edge"},
    {"diameter", "pressure-wave:cell-diameter"},
    {"cube of diameter", "pressure-wave:cell-diameter", stepOfCube},
    {"in-radius", "pressure-wave:in-radius"},
    {"V / max A", "pressure-wave:volume-over-area"},
    {"least height", "pressure-wave:min-height"},
    {"height or V/A", "pressure-wave"},
    {"0.9 of that", "pressure-wave", [](double /*poisson*/) { return 0.9; }},
    {"dilatational", "dilatational-mode"},
    {"CalculiX", "pressure-wave:calculix"},
    {"nodal", "pressure-wave:nodal", nullptr, true},
    {"single element", "single-element", nullptr, true},
};

}  // namespace

std::span<const ForeignRule> foreignRules() { return rules; }

}  // namespace ringwatch::detail
