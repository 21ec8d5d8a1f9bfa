#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include <ringwatch/base/error.h>
#include <ringwatch/gpu/imex/device_imex_impl.h>
#include <ringwatch/handlers/imex/implicit_cluster.h>
#include <tests/gpu/cases.h>
#include <tests/gpu/checks.h>

using namespace ringwatch;
using checks::expect;
using checks::expectAtMost;
using checks::Test;

namespace {

using Clusters = std::vector<std::vector<ElementRef>>;

/// The elements whose centroids `wanted` takes, by clusters.
template <class Wanted>
Clusters clustersWhere(const Body& body, const Wanted& wanted) {
  std::vector<ElementRef> chosen;
  for (std::size_t b = 0; b < body.blocks().size(); ++b)
    for (std::int32_t e = 0; e < body.blocks()[b]->elementCount(); ++e) {
      Eigen::Vector3d centre = Eigen::Vector3d::Zero();
      const auto nodes = body.blocks()[b]->nodesOf(e);
      for (const std::int32_t node : nodes) centre += body.mesh().X.col(node) / static_cast<double>(nodes.size());
      if (wanted(centre, e)) chosen.push_back({b, e});
    }
  return clustersOf(body, chosen);
}

/// The CPU's scheme: symplectic Euler with the accelerations that ImplicitCluster allows.
class HostImex {
 public:
  /// fresh: K̂ is made again at every step, as on the device; else it is kept as Imex keeps it.
  HostImex(const Body& body, Clusters clusters, double h, const DeviceImexOptions& options, bool fresh)
      : body_(body), chosen_(std::move(clusters)), h_(h), fresh_(fresh) {
    const double alpha = options.dissipation, beta = 0.25 * (1 + alpha) * (1 + alpha);
    w_ = beta * h * h;
    c_ = alpha / (beta * h);
    options_.solver = ClusterSolver::conjugateGradients;
    options_.tolerance = options.tolerance;
    options_.iterations = options.iterations;
    x = body.mesh().X;
    v = NodeVectors::Zero(3, x.cols());
    body.constraints().imposeVelocity(v);
  }
  void step() {
    Body::Workspace workspace;
    NodeVectors f;
    body_.internalForce(x, f, workspace);
    NodeVectors a = (body_.externalForce() - f) * body_.lumpedMass().cwiseInverse().asDiagonal();
    body_.constraints().clearConstrained(a);
    if (fresh_ || clusters_.empty()) {
      clusters_.clear();
      for (const auto& elements : chosen_) clusters_.emplace_back(body_, elements, w_, x, options_);
    }
    for (ImplicitCluster& cluster : clusters_) {
      expect(cluster.follow(x), "the CPU's matrix follows");
      expect(cluster.solve(a, v, c_), "the CPU's solver converges");
    }
    v += h_ * a;
    x += h_ * v;
  }
  NodeVectors x, v;

 private:
  const Body& body_;
  Clusters chosen_;
  double h_, w_ = 0, c_ = 0;
  bool fresh_;
  ClusterOptions options_;
  std::vector<ImplicitCluster> clusters_;
};

/// Steps from a turned, strained and moving state. Both sides solve to 1e-13 in the preconditioner's norm.
void compare(const Body& body, const Clusters& clusters, double h, int steps, double dissipation, double bound,
             const std::string& what) {
  DeviceImexOptions options;
  options.dissipation = dissipation;
  options.tolerance = 1e-13;
  HostImex host(body, clusters, h, options, true);
  host.x = randomState(body.mesh(), 0.002, 3);
  host.v = randomVectors(host.x.cols(), 0.05, 4);
  body.constraints().imposeVelocity(host.v);
  DeviceBody<double> device(body);
  device.setPositions(host.x);
  device.setVelocities(host.v);
  DeviceImex imex(device, body.mesh(), clusters, h, options);
  const NodeVectors start = host.x;
  imex.step(steps);
  for (int k = 0; k < steps; ++k) host.step();
  const DeviceImex::Status status = imex.status();
  expect(status.fault.empty() && status.steps == steps, what + " all steps are taken: " + status.fault);
  expect(imex.iterations() >= steps * static_cast<std::int64_t>(clusters.size()), what + " iterates");
  expect(host.x.allFinite(), what + " stays finite");
  expectAtMost((device.positions() - host.x).norm() / (host.x - start).norm(), bound, what + " positions");
  expectAtMost(relative(device.velocities(), host.v), bound, what + " velocities");
}

/// 8 to 20 times the explicit step of these elements.
constexpr double longStep = 0.05;

void oneStep() {
  for (const char* element : elementNames)
    for (const char* law : lawNames) {
      const Body body = loadedBar(element, law, {6, 3, 3});
      const Clusters clusters = clustersWhere(body, [](const auto& c, std::int32_t) { return c[0] < 0.8; });
      for (const double dissipation : {0.0, 0.1, 1.0})
        compare(body, clusters, longStep, 1, dissipation, 1e-10,
                std::string(element) + " " + law + " " + std::to_string(dissipation));
    }
}

/// Clusters of a warp, of a thread block and of several; held and free; of several mesh blocks.
void sizes() {
  const Body body = loadedBar("tet4", "stvk", {24, 8, 8});
  const auto slab = [](double from, double to) {
    return [=](const auto& c, std::int32_t) { return c[0] > from && c[0] < to; };
  };
  compare(body, clustersWhere(body, [](const auto& c, std::int32_t) { return c[0] > 2 && c[0] < 4; }), longStep, 1, 0.1,
          1e-10, "a cluster of a thread block");
  compare(body, clustersWhere(body, [](const auto&, std::int32_t) { return true; }), 0.01, 1, 0.1, 1e-10,
          "the whole body");
  const Clusters scattered = clustersWhere(body, [](const auto&, std::int32_t e) { return e % 97 == 0; });
  expect(scattered.size() > 50, "there are many small clusters");
  compare(body, scattered, longStep, 1, 0.1, 1e-10, "scattered elements");
  const Clusters mixed = clustersWhere(body, [&](const auto& c, std::int32_t e) {
    return slab(0, 0.5)(c, e) || slab(1, 3.5)(c, e) || (c[0] > 4 && e % 61 == 0);
  });
  compare(body, mixed, longStep, 1, 0.1, 1e-10, "clusters of all sizes");
  const ImexTeams teams = planTeams({{0, 3, false}, {3, 40, false}, {43, 500, true}, {543, 300, false}}, 50);
  expect(teams.ofWarps.size() == 1 && teams.ofBlocks.size() == 1 && teams.teams.size() == 2, "teams of three kinds");
  expect(teams.blockCount <= 50 && teams.teamBlocks < teams.blockCount, "that fit on the device");

  BarOptions options;
  options.cells = {8, 3, 3};
  options.size = {2, 0.75, 0.75};
  const Body blocks(generateMixedBar(options), makeMaterial("neo-hookean", 3e4, 0.3, 1000));
  compare(blocks, clustersWhere(blocks, [](const auto& c, std::int32_t) { return c[1] < 0.5; }), longStep, 1, 0.1,
          1e-10, "several mesh blocks");
}

void counts() {
  for (const std::size_t count : {1, 31, 33, 127, 129}) {
    const Mesh mesh = firstElements(bar("tet4", {8, 6, 6}), count);
    const Body body(mesh, makeMaterial("stvk", 3e4, 0.3, 1000));
    compare(body, clustersWhere(body, [](const auto&, std::int32_t) { return true; }), longStep, 1, 0.1, 1e-10,
            std::to_string(count) + " tetrahedra");
  }
}

/// Whole runs: to rounding against K̂ made again at each step, and near those of the CPU, which keeps it for a while.
void runs() {
  for (const char* law : lawNames) {
    const Body body = loadedBar("tet4", law, {8, 3, 3});
    const Clusters clusters =
        clustersWhere(body, [](const auto& c, std::int32_t e) { return c[0] < 0.6 || e % 89 == 0; });
    // Short enough for the explicit part.
    const double h = 2e-3;
    DeviceImexOptions options;
    options.tolerance = 1e-13;
    HostImex fresh(body, clusters, h, options, true), kept(body, clusters, h, options, false);
    DeviceBody<double> device(body);
    DeviceImex imex(device, body.mesh(), clusters, h, options);
    constexpr int steps = 120;
    imex.step(50);
    expect(imex.status().steps == 50, "steps so far");
    imex.step(steps - 50);
    for (int k = 0; k < steps; ++k) {
      fresh.step();
      kept.step();
    }
    expect(imex.status().steps == steps - 50, std::string(law) + " all steps are taken");
    const double moved = (fresh.x - body.mesh().X).norm();
    expectAtMost((device.positions() - fresh.x).norm() / moved, 1e-9, std::string(law) + " run");
    expectAtMost((device.positions() - kept.x).norm() / moved, 2e-3,
                 std::string(law) + " run of a matrix that is kept");
  }
}

/// A step that the explicit scheme does not survive.
void staysStable() {
  const Body body = loadedBar("tet4", "corotational", {8, 3, 3});
  const Clusters whole = clustersWhere(body, [](const auto&, std::int32_t) { return true; });
  DeviceBody<double> device(body), plain(body);
  DeviceImex imex(device, body.mesh(), whole, longStep);
  imex.step(200);
  plain.step(longStep, 200);
  expect(imex.status().fault.empty(), "no step fails");
  const NodeVectors x = device.positions();
  expect(x.allFinite() && (x - body.mesh().X).cwiseAbs().maxCoeff() < 20, "implicit steps stay bounded");
  const NodeVectors y = plain.positions();
  expect(!y.allFinite() || (y - body.mesh().X).cwiseAbs().maxCoeff() > 1e3,
         "explicit ones do not, else this tests little");
}

void repeats() {
  const Body body = loadedBar("tet4", "neo-hookean", {24, 8, 8});
  const Clusters clusters =
      clustersWhere(body, [](const auto& c, std::int32_t e) { return c[0] < 3 || (c[0] > 3.6 && e % 61 == 0); });
  DeviceBody<double> first(body), second(body);
  DeviceImex one(first, body.mesh(), clusters, 2e-3), other(second, body.mesh(), clusters, 2e-3);
  one.step(40);
  for (int k = 0; k < 40; ++k) other.step();
  expect(one.status().steps == 40 && other.status().steps == 40, "all steps are taken");
  expect(first.positions().allFinite(), "the run stays finite");
  expect(sameBits(first.positions(), second.positions()), "positions repeat to the last bit");
  expect(sameBits(first.velocities(), second.velocities()), "velocities repeat to the last bit");
}

/// A step that fails leaves the state before it.
void fails() {
  const Body body = loadedBar("tet4", "stvk", {8, 3, 3});
  const Clusters clusters = clustersWhere(body, [](const auto& c, std::int32_t) { return c[0] < 1; });
  DeviceImexOptions options;
  options.iterations = 2;
  options.tolerance = 1e-12;
  DeviceBody<double> device(body);
  DeviceImex imex(device, body.mesh(), clusters, longStep, options);
  const NodeVectors x = device.positions(), v = device.velocities();
  imex.step(30);
  const DeviceImex::Status status = imex.status();
  expect(status.fault.find("conjugate gradients did not converge in the cluster of") == 0, "fault: " + status.fault);
  expect(status.steps == 0 && device.steps() == 0, "the first step fails");
  expect(sameBits(device.positions(), x) && sameBits(device.velocities(), v), "the state is that before it");

  // Later: the device stops where single steps do.
  options.iterations = 200;
  DeviceBody<double> whole(body), single(body);
  NodeVectors fast = randomVectors(x.cols(), 0.01, 3);
  body.constraints().imposeVelocity(fast);
  whole.setVelocities(fast);
  single.setVelocities(fast);
  DeviceImex many(whole, body.mesh(), clusters, longStep, options),
      few(single, body.mesh(), clusters, longStep, options);
  many.step(400);  // the explicit part runs away, until nothing is finite
  const DeviceImex::Status end = many.status();
  expect(!end.fault.empty() && end.steps > 0 && end.steps < 400, "a later step fails: " + end.fault);
  std::int64_t taken = 0;
  NodeVectors before = single.positions();
  for (; taken < 400; ++taken) {
    few.step();
    if (few.status().steps == 0) break;
    before = single.positions();
  }
  expect(taken == end.steps, "single steps fail at the same one");
  expect(sameBits(whole.positions(), before) && sameBits(single.positions(), before), "and leave the same state");
  expect(whole.steps() == end.steps, "failed steps are not counted");
}

void refuses() {
  const Body body = loadedBar("tet4", "stvk", {2, 2, 2});
  DeviceBody<double> device(body);
  const auto make = [&](const Clusters& clusters, double h, const DeviceImexOptions& options) {
    DeviceImex imex(device, body.mesh(), clusters, h, options);
  };
  checks::expectThrows<InputError>([&] { make({{{0, 0}}}, 0, {}); }, "must be > 0");
  checks::expectThrows<InputError>([&] { make({{{0, 0}}}, 1, {2.0, 1e-8, 200}); }, "dissipation 2");
  checks::expectThrows<InputError>([&] { make({{{0, 0}}}, 1, {0.1, 1, 200}); }, "tolerance 1");
  checks::expectThrows<InputError>([&] { make({{{0, 100000}}}, 1, {}); }, "0:100000 is not in the mesh");
  checks::expectThrows<InputError>([&] { make({{{0, 0}}, {{0, 0}}}, 1, {}); }, "in two clusters");
  DeviceImex none(device, body.mesh(), {}, 1e-3);
  DeviceBody<double> plain(body);
  none.step(5);
  plain.step(1e-3, 5);
  expect(none.status().steps == 5, "no clusters");
  expect(sameBits(device.positions(), plain.positions()), "no clusters: the explicit scheme, bit for bit");
}

const Test tests[] = {
    {"imex-one-step", true, oneStep}, {"imex-sizes", true, sizes},        {"imex-counts", true, counts},
    {"imex-runs", true, runs},        {"imex-stable", true, staysStable}, {"imex-repeats", true, repeats},
    {"imex-fails", true, fails},      {"imex-refuses", true, refuses},
};

}  // namespace
