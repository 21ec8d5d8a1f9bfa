#include <cmath>
#include <cstdio>
#include <functional>
#include <set>
#include <string>

#include <ringwatch/base/error.h>
#include <ringwatch/gpu/body/device_body_impl.h>
#include <ringwatch/gpu/device_status.h>
#include <ringwatch/meshes/generators/generators.h>
#include <tests/gpu/cases.h>
#include <tests/gpu/checks.h>

using namespace ringwatch;
using checks::expect;
using checks::expectAtMost;
using checks::Test;

namespace {

constexpr double doubleBound = 1e-12, floatBound = 1e-5;
template <class R>
constexpr double boundOf = sizeof(R) == 8 ? doubleBound : floatBound;
template <class R>
constexpr const char* nameOf = sizeof(R) == 8 ? "double" : "float";

/// Force, tangent product and energy on the device against the CPU's double result, into poisoned memory.
template <class R>
void compare(const Body& body, const NodeVectors& x, const std::string& what) {
  DeviceBody<R> device(body);
  device.setPositions(x);
  const NodeVectors p = randomVectors(x.cols(), 1, 7);
  Body::Workspace workspace;
  NodeVectors f, Kp;
  body.internalForce(x, f, workspace);
  body.tangentProduct(x, p, Kp, workspace);
  const double energy = body.energy(x, workspace);
  const auto fillWithNan = [&] {
    device.impl().forEachPart([](auto& part) {
      part.result.fill(0xff);
      part.slots.fill(0xff);
      part.partial.fill(0xff);
      part.sum.fill(0xff);
    });
  };
  fillWithNan();
  expectAtMost(relative(device.internalForce(), f), boundOf<R>, what + " force");
  fillWithNan();
  expectAtMost(relative(device.tangentProduct(p), Kp), boundOf<R>, what + " tangent product");
  fillWithNan();
  expectAtMost(std::abs(device.strainEnergy() - energy) / std::abs(energy), boundOf<R>, what + " energy");
}

template <class R>
void compareAll() {
  for (const char* element : elementNames)
    for (const char* law : lawNames) {
      const Mesh mesh = bar(element, {5, 4, 4});
      const Body body(mesh, makeMaterial(law, 3e4, 0.3, 1000));
      compare<R>(body, randomState(mesh, 0.01, 3), std::string(element) + " " + law);
    }
}

template <class R>
void compareCounts() {
  for (const char* element : elementNames)
    for (const std::size_t count : {1, 31, 33, 127, 129, 255, 257}) {
      const Mesh mesh = firstElements(bar(element, {8, 6, 6}), count);
      const Body body(mesh, makeMaterial("stvk", 3e4, 0.3, 1000));
      compare<R>(body, randomState(mesh, 0.01, 5), std::string(element) + " x " + std::to_string(count));
    }
}

template <class R>
void compareMixed() {
  BarOptions options;
  options.cells = {10, 4, 4};
  options.size = {2.5, 1, 1};
  const Mesh mesh = generateMixedBar(options);
  std::vector<Material> materials;
  for (std::size_t b = 0; b < mesh.blocks.size(); ++b)
    materials.push_back(makeMaterial(lawNames[b % 4], 3e4 * static_cast<double>(1 + b), 0.3, 1000));
  const Body body(mesh, materials);
  expect(mesh.blocks.size() > 3, "the mixed bar has blocks of all elements");
  compare<R>(body, randomState(mesh, 0.01, 9), "mixed");
}

/// Symplectic Euler on the CPU.
void stepOnHost(const Body& body, NodeVectors& x, NodeVectors& v, double h, int count) {
  Body::Workspace workspace;
  NodeVectors f;
  for (int k = 0; k < count; ++k) {
    body.internalForce(x, f, workspace);
    NodeVectors a = (body.externalForce() - f) * body.lumpedMass().cwiseInverse().asDiagonal();
    body.constraints().clearConstrained(a);
    v += h * a;
    x += h * v;
  }
}

template <class R>
void compareRun(double bound) {
  for (const char* element : {"tet4", "hex8"}) {
    const Body body = loadedBar(element, "stvk");
    DeviceBody<R> device(body);
    NodeVectors x = body.mesh().X, v = NodeVectors::Zero(3, x.cols());
    body.constraints().imposeVelocity(v);
    const double h = 2e-3;
    stepOnHost(body, x, v, h, 137);
    device.step(h, 137);
    expect(device.steps() == 137, "steps are counted");
    expectAtMost(relative(device.positions(), x), bound, std::string(element) + " positions after 137 steps");
    expectAtMost(relative(device.velocities(), v), 30 * bound, std::string(element) + " velocities after 137 steps");
    const double kinetic = 0.5 * (v.colwise().squaredNorm() * body.lumpedMass())(0);
    expectAtMost(std::abs(device.kineticEnergy() / kinetic - 1), 30 * bound, std::string(element) + " kinetic energy");
    stepOnHost(body, x, v, 0.5 * h, 7);
    device.step(0.5 * h, 7);
    expectAtMost(relative(device.positions(), x), bound, std::string(element) + " positions after another step size");
  }
}

template <class R>
void repeatBitwise() {
  const Body body = loadedBar("tet4", "neo-hookean", {12, 8, 8});
  const NodeVectors start = randomState(body.mesh(), 0.01, 11);
  DeviceBody<R> first(body), second(body);
  first.setPositions(start);
  second.setPositions(start);
  const NodeVectors f = first.internalForce();
  const NodeVectors p = randomVectors(start.cols(), 1, 7), Kp = first.tangentProduct(p);
  const double energy = first.strainEnergy();
  for (int repeat = 0; repeat < 5; ++repeat) {
    expect(sameBits(first.internalForce(), f), "force repeats to the last bit");
    expect(sameBits(first.tangentProduct(p), Kp), "tangent product repeats to the last bit");
    expect(first.strainEnergy() == energy, "energy repeats to the last bit");
  }
  first.step(5e-4, 50);
  for (int k = 0; k < 50; ++k) second.step(5e-4);
  expect(first.positions().allFinite(), "the run stays finite");
  expect(sameBits(first.positions(), second.positions()), "positions after 50 steps repeat to the last bit");
  expect(sameBits(first.velocities(), second.velocities()), "velocities after 50 steps repeat to the last bit");
}

void checkPlan() {
  for (const char* element : elementNames) {
    const Mesh mesh = bar(element, {9, 8, 7});
    const DevicePlan plan = planPatches(mesh);
    std::vector<int> seen(mesh.elementCount(), 0), nodeSeen(mesh.nodeCount(), 0);
    for (const std::int32_t node : plan.deviceNode) ++nodeSeen.at(node);
    expect(std::set<int>(nodeSeen.begin(), nodeSeen.end()) == std::set<int>{1}, "device nodes are a permutation");
    const DeviceBlockPlan& block = plan.blocks.front();
    const auto n = static_cast<std::size_t>(mesh.blocks.front().nodesPerElement()),
               threads = static_cast<std::size_t>(block.threads);
    bool right = true;
    std::vector<std::set<std::size_t>> patchesOf(mesh.nodeCount());
    for (std::size_t p = 0; p < block.patches.size(); ++p)
      for (std::size_t t = 0; t < static_cast<std::size_t>(block.patches[p].elementCount); ++t) {
        const std::size_t e = block.elements[p * threads + t];
        ++seen.at(e);
        for (std::size_t a = 0; a < n; ++a) {
          const std::size_t local = block.corners[(p * threads + t) * n + a];
          const std::int32_t node = plan.deviceNode[mesh.blocks.front().element(e)[a]];
          right = right && block.nodes[p * static_cast<std::size_t>(block.nodeCapacity) + local] == node;
          patchesOf[node].insert(p);
          // The corner is in its node's rows, once.
          const auto group = p * static_cast<std::size_t>(block.groups()) + local / 32;
          int found = 0;
          for (auto row = block.groupRow[group]; row < block.groupRow[group + 1]; ++row)
            found += block.rows[static_cast<std::size_t>(row) * 32 + local % 32] == a * threads + t;
          right = right && found == 1;
        }
      }
    expect(std::set<int>(seen.begin(), seen.end()) == std::set<int>{1}, "every element is in one patch");
    expect(right, "corners and rows agree with the connectivity");
    bool interior = true;
    for (std::size_t i = 0; i < patchesOf.size(); ++i)
      interior = interior && (patchesOf[i].size() == 1) == (i < static_cast<std::size_t>(plan.interiorCount));
    expect(interior, "interior nodes are those of one patch");
  }
}

struct OwnHexahedron : Hex8 {
  static constexpr std::string_view name = "own-hexahedron";
  static constexpr int vtkCellType = 0, gmshType = 0;
};

void refuses() {
  const Mesh quadratic = bar("tet10", {2, 2, 2}, 0);
  checks::expectThrows<InputError>([&] { planPatches(quadratic); }, "tet10 are not on the device");
  // Kernels are compiled for the elements of the library; one that a program registers stays on the CPU.
  Mesh own = bar("hex8", {2, 2, 2}, 0);
  own.blocks[0].type = detail::registerElement(elementInfoOf<OwnHexahedron>(ElementType{}));
  checks::expectThrows<InputError>([&] { planPatches(own); },
                                   "own-hexahedron are not on the device; it has tet4, hex8, wedge6 and pyramid5");
}

void refusesOnDevice() {
  const Mesh mesh = bar("hex8", {2, 2, 2});
  BodyOptions options;
  options.rules["hex8"] = "selective";
  const Body body(mesh, makeMaterial("stvk", 3e4, 0.3, 1000), options);
  checks::expectThrows<InputError>([&] { DeviceBody<double> device(body); },
                                   "\"selective\" evaluates the element's mean");
  checks::expectThrows<InputError>([] { requireDeviceMemory(std::size_t{1} << 60); }, "of device memory and");
  DeviceBody<double> device(Body(mesh, makeMaterial("stvk", 3e4, 0.3, 1000)));
  checks::expectThrows<InputError>([&] { device.setPositions(NodeVectors::Zero(3, 5)); }, "5 nodes");
}

void emptyBody() {
  const Mesh mesh = bar("tet4", {2, 2, 2});
  const Body whole(mesh, makeMaterial("stvk", 3e4, 0.3, 1000));
  const Body none(whole, {std::vector<bool>(mesh.elementCount(), false)});
  DeviceBody<double> device(none);
  device.impl().only("poison").result.fill(0xff);
  expect(device.internalForce().isZero(0), "no elements, no force");
  expect(device.strainEnergy() == 0, "no elements, no energy");
  device.setVelocities(NodeVectors::Constant(3, mesh.X.cols(), 2.0));
  device.step(0.25, 2);
  expectAtMost((device.positions() - mesh.X - NodeVectors::Constant(3, mesh.X.cols(), 1.0)).norm(), 1e-14,
               "free flight");
}

const Test tests[] = {
    {"plan", false, checkPlan},
    {"refuses", false, refuses},
    {"refuses-on-device", true, refusesOnDevice},
    {"empty-body", true, emptyBody},
    {"all-double", true, compareAll<double>},
    {"all-float", true, compareAll<float>},
    {"counts-double", true, compareCounts<double>},
    {"counts-float", true, compareCounts<float>},
    {"mixed-double", true, compareMixed<double>},
    {"mixed-float", true, compareMixed<float>},
    {"run-double", true, [] { compareRun<double>(1e-12); }},
    {"run-float", true, [] { compareRun<float>(1e-5); }},
    {"repeats-double", true, repeatBitwise<double>},
    {"repeats-float", true, repeatBitwise<float>},
};

}  // namespace

int main(int argc, char** argv) {
  const DeviceStatus status = deviceStatus();
  std::printf("%s\n", status.text.c_str());
  return checks::run(argc > 1 ? argv[1] : "", status.available);
}
