#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <vector>

#include <bench/gpu/bench.h>
#include <ringwatch/base/median.h>
#include <ringwatch/gpu/certificate/device_certificate.h>
#include <ringwatch/gpu/imex/device_imex_impl.h>
#include <ringwatch/handlers/imex/implicit_cluster.h>
#include <ringwatch/meshes/generators/generators.h>

namespace ringwatch::bench {
namespace {

constexpr int hostThreads = 2, cells = 58, tetrahedra = 5;

/// Imex's step on the CPU, with its solvers as they are by default.
class HostImex {
 public:
  HostImex(const Body& body, const std::vector<std::vector<ElementRef>>& chosen, double h,
           const DeviceImexOptions& options, const NodeVectors& start)
      : x(start), v(NodeVectors::Zero(3, start.cols())), body_(body), h_(h) {
    const double alpha = options.dissipation, beta = 0.25 * (1 + alpha) * (1 + alpha);
    c_ = alpha / (beta * h);
    ClusterOptions solver;
    solver.tolerance = options.tolerance;
    solver.iterations = options.iterations;
    for (const auto& elements : chosen) clusters_.emplace_back(body, elements, beta * h * h, x, solver);
  }
  bool step() {
    body_.internalForce(x, f_, workspace_);
    a_.resize(3, x.cols());
    parallelFor(0, x.cols(), hostThreads, [&](std::int64_t i) {
      a_.col(i) = (body_.externalForce().col(i) - f_.col(i)) / body_.lumpedMass()[i];
    });
    std::vector<std::uint8_t> failed(clusters_.size(), 0);
    parallelFor(0, clusters_.size(), hostThreads, [&](std::int64_t k) {
      ImplicitCluster& cluster = clusters_[k];
      failed[k] = !cluster.follow(x) || !cluster.solve(a_, v, c_);
    });
    parallelFor(0, x.cols(), hostThreads, [&](std::int64_t i) {
      v.col(i) += h_ * a_.col(i);
      x.col(i) += h_ * v.col(i);
    });
    return std::find(failed.begin(), failed.end(), 1) == failed.end();
  }
  NodeVectors x, v;

 private:
  const Body& body_;
  double h_, c_ = 0;
  std::vector<ImplicitCluster> clusters_;
  Body::Workspace workspace_;
  NodeVectors f_, a_;
};

void measure(const std::string& name, bool layer) {
  BarOptions options;
  options.element = "tet4";
  options.cells = {cells, cells, cells};
  options.size = {cells, cells, cells};
  options.split = tetrahedra;
  Mesh mesh = generateBar(options);
  std::vector<ElementRef> implicit;
  double h = 0;
  {
    // Half of the step that the bound allows to cells of one size.
    Body even(mesh, makeMaterial("stvk", 30e3, 0.3, 1000));
    DeviceBody<double> device(even);
    h = 0.5 * 2 / std::sqrt(DeviceCertificate(device).bound(12).value);
  }
  // Three layers of cells a tenth as thick, or each twentieth cell, which no two neighbours are.
  constexpr double layers = 3;
  if (layer)
    for (Eigen::Index i = 0; i < mesh.X.cols(); ++i)
      mesh.X(0, i) = mesh.X(0, i) <= layers ? 0.1 * mesh.X(0, i) : mesh.X(0, i) - 0.9 * layers;
  const MeshBlock& block = mesh.blocks.front();
  for (std::size_t e = 0; e < block.elementCount(); ++e) {
    double most = 0;
    for (int a = 0; a < 4; ++a) most = std::max(most, mesh.X(0, block.element(e)[a]));
    if (layer ? most <= 0.1 * layers + 1e-9 : e / tetrahedra % 20 == 0)
      implicit.push_back({0, static_cast<std::int32_t>(e)});
  }
  BodyOptions threads;
  threads.threads = hostThreads;
  const Body body(mesh, makeMaterial("stvk", 30e3, 0.3, 1000), threads);
  NodeVectors x = mesh.X;
  for (Eigen::Index i = 0; i < x.cols(); ++i)
    for (int c = 0; c < 3; ++c) x(c, i) *= 1 + 0.01 * std::sin(0.1 * x((c + 1) % 3, i));
  const auto clusters = clustersOf(body, implicit);
  std::size_t largest = 0;
  for (const auto& cluster : clusters) largest = std::max(largest, cluster.size());

  const DeviceImexOptions solver;
  DeviceBody<double> device(body);
  device.setPositions(x);
  double start = seconds();
  DeviceImex imex(device, mesh, clusters, h, solver);
  const double made = seconds() - start;
  HostImex host(body, clusters, h, solver, x);
  constexpr int compared = 5;
  std::vector<double> times;
  bool good = true;
  for (int k = 0; k < compared; ++k) {
    start = seconds();
    good = host.step() && good;
    times.push_back(seconds() - start);
  }
  const double hostTime = median(std::move(times));
  imex.step(compared);
  const DeviceImex::Status status = imex.status();
  good = good && status.fault.empty();
  const double error = (device.positions() - host.x).norm() / (host.x - x).norm();
  const auto wait = [&] { device.synchronize(); };
  const std::int64_t iterations = imex.iterations(), steps = device.steps();
  const double time = timeOf([&](std::int64_t count) { imex.step(count); }, wait);
  const double each = static_cast<double>(imex.iterations() - iterations) / static_cast<double>(device.steps() - steps);
  good = good && imex.status().fault.empty() && device.positions().allFinite();
  const double plain = timeOf([&](std::int64_t count) { device.step(1e-9 * h, count); }, wait);
  std::printf(
      "%-34s %d clusters, the largest of %zu elements, %.1f %% of %zu: step %.2f us (explicit %.2f us), %.1f "
      "iterations "
      "a cluster; on %d CPU threads %.2f ms: %.0fx; made in %.2f s, %.0f MB; positions after %d steps differ by %.2g "
      "of "
      "the motion%s\n",
      name.c_str(), static_cast<int>(clusters.size()), largest,
      100.0 * static_cast<double>(implicit.size()) / static_cast<double>(mesh.elementCount()), mesh.elementCount(),
      time * 1e6, plain * 1e6, each / static_cast<double>(clusters.size()), hostThreads, hostTime * 1e3,
      hostTime / time, made, static_cast<double>(imex.bytes()) * 1e-6, compared, error,
      good ? "" : "; WARNING: a step FAILED");
  std::fflush(stdout);
}

}  // namespace

void measureImex(const std::string& filter) {
  for (const bool layer : {true, false}) {
    const std::string name = layer ? "tet4 imex 1M, a layer" : "tet4 imex 1M, scattered";
    if (name.find(filter) != std::string::npos) measure(name, layer);
  }
}

}  // namespace ringwatch::bench
