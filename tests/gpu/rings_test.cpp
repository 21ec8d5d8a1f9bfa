#include <cmath>
#include <limits>
#include <string>

#include <ringwatch/base/error.h>
#include <ringwatch/gpu/rings/device_rings_impl.h>
#include <ringwatch/monitor/bounds/reduced_ring.h>
#include <tests/gpu/cases.h>
#include <tests/gpu/checks.h>

using namespace ringwatch;
using checks::expect;
using checks::expectAtMost;
using checks::Test;

namespace {

/// Of the highest ring of all. Both sides compute an eigenvalue to 1e-12 of its matrix' spectral radius and assemble to
/// rounding, and no ring's radius is far above the highest ring.
constexpr double bound = 1e-11;

/// All rings on the device, into poisoned memory, against the CPU's.
void compare(const Body& body, const NodeVectors& x, const std::string& what) {
  DeviceBody<double> device(body);
  device.setPositions(x);
  DeviceRings rings(device);
  ReducedRing reference(body);
  const ReducedRing::Result& wanted = reference.evaluate(x);
  auto& impl = rings.impl();
  impl.pair.fill(0xff);
  impl.slots.fill(0xff);
  for (auto& block : impl.blocks) {
    block.largest.fill(0xff);
    block.highest.fill(0xff);
  }
  const auto values = rings.evaluate();
  expect(values.size() == wanted.largest.size(), what + " blocks");
  double worst = 0;
  for (std::size_t b = 0; b < values.size(); ++b) {
    expect(values[b].size() == wanted.largest[b].size(), what + " elements");
    for (std::size_t e = 0; e < values[b].size(); ++e) {
      const double off = std::abs(values[b][e] - wanted.largest[b][e]) / wanted.highest;
      worst = off <= worst ? worst : off;
    }
  }
  expectAtMost(worst, bound, what + " rings");
  const DeviceRings::Highest highest = rings.highest();
  expectAtMost(std::abs(highest.value / wanted.highest - 1), bound, what + " highest ring");
  const double there = wanted.largest[highest.element.block][highest.element.element];
  expectAtMost(std::abs(there / wanted.highest - 1), 2 * bound, what + " element of the highest ring");
}

void allLaws() {
  for (const char* law : lawNames) {
    const Mesh mesh = bar("tet4", {7, 5, 5});
    const Body body(mesh, makeMaterial(law, 3e4, 0.3, 1000));
    for (const unsigned seed : {3U, 4U}) compare(body, randomState(mesh, 0.02, seed), law);
    compare(body, mesh.X, std::string(law) + " at rest");
  }
}

void counts() {
  for (const std::size_t count : {1, 31, 33, 127, 129, 255, 257}) {
    const Mesh mesh = firstElements(bar("tet4", {8, 6, 6}), count);
    const Body body(mesh, makeMaterial("stvk", 3e4, 0.3, 1000));
    compare(body, randomState(mesh, 0.01, 5), std::to_string(count) + " tetrahedra");
  }
}

/// Held and drawn nodes, point masses, and blocks whose elements share edges.
void constraintsAndBlocks() {
  Body held = loadedBar("tet4", "neo-hookean", {8, 4, 4});
  held.addNodalMass(7, 3.0);
  held.constraints().fix(20);
  compare(held, randomState(held.mesh(), 0.01, 6), "constrained");

  Mesh mesh = bar("tet4", {6, 4, 4});
  MeshBlock second{mesh.blocks[0].type, {}, {}};
  MeshBlock& first = mesh.blocks[0];
  const std::size_t half = first.elementCount() / 2;
  second.ids.assign(first.ids.begin() + static_cast<std::ptrdiff_t>(half), first.ids.end());
  second.connectivity.assign(first.connectivity.begin() + static_cast<std::ptrdiff_t>(4 * half),
                             first.connectivity.end());
  first.ids.resize(half);
  first.connectivity.resize(4 * half);
  mesh.blocks.push_back(second);
  mesh.elementSets.clear();
  const Body body(mesh, {makeMaterial("stvk", 3e4, 0.3, 1000), makeMaterial("corotational", 9e4, 0.2, 2000)});
  compare(body, randomState(mesh, 0.01, 9), "two blocks");
}

void edgeCases() {
  const Mesh mesh = bar("tet4", {2, 2, 2});
  const Body whole(mesh, makeMaterial("stvk", 3e4, 0.3, 1000));
  const Body none(whole, {std::vector<bool>(mesh.elementCount(), false)});
  DeviceBody<double> empty(none);
  DeviceRings noRings(empty);
  expect(noRings.highest().value == 0, "no elements, no highest ring");
  expect(noRings.evaluate().front().empty(), "no elements, no rings");

  const Body body(bar("tet4", {8, 4, 4}), makeMaterial("stvk", 3e4, 0.3, 1000));
  NodeVectors x = randomState(body.mesh(), 0.01, 8);
  DeviceBody<double> device(body);
  device.setPositions(x);
  DeviceRings rings(device);
  const auto once = rings.evaluate();
  for (int repeat = 0; repeat < 5; ++repeat) expect(rings.evaluate() == once, "rings repeat to the last bit");
  x(1, 5) = std::numeric_limits<double>::quiet_NaN();
  device.setPositions(x);
  expect(std::isnan(rings.highest().value), "what is not a number has no highest ring");

  const Body hexahedra(bar("hex8", {2, 2, 2}), makeMaterial("stvk", 3e4, 0.3, 1000));
  DeviceBody<double> other(hexahedra);
  checks::expectThrows<InputError>([&] { DeviceRings refused(other); }, "for tet4 alone");
}

const Test tests[] = {
    {"rings-laws", true, allLaws},
    {"rings-counts", true, counts},
    {"rings-constraints-and-blocks", true, constraintsAndBlocks},
    {"rings-edge-cases", true, edgeCases},
};

}  // namespace
