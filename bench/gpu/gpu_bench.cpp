/// Elements per second on the device: force, step, and what else runs there, against the copy bandwidth of the same
/// machine and the bytes that each case must move. State and mesh are on the device before a clock starts, nothing is
/// copied while it runs, and every time includes all kernels of the operation. Medians of batches of many repetitions.
///
///   ringwatch_bench_gpu [FILTER]         only cases whose names contain FILTER
///   ringwatch_bench_gpu --mesh FILE      a mesh of elements about 1 m wide
///   ringwatch_bench_gpu --devices 0,1 [FILTER]   steps on several GPUs against the first of them
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <functional>
#include <memory>
#include <numeric>
#include <optional>
#include <random>
#include <sstream>
#include <string>

#include <Eigen/LU>

#include <bench/gpu/bench.h>
#include <ringwatch/base/median.h>
#include <ringwatch/base/parallel.h>
#include <ringwatch/gpu/body/device_body_impl.h>
#include <ringwatch/gpu/certificate/device_certificate.h>
#include <ringwatch/gpu/device_status.h>
#include <ringwatch/meshes/generators/generators.h>
#include <ringwatch/meshes/mesh_io.h>

using namespace ringwatch;
using bench::seconds;
using bench::timeOf;

namespace ringwatch::bench {

double seconds() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

double timeOf(const std::function<void(std::int64_t)>& repeat, const std::function<void()>& wait) {
  repeat(3);
  wait();
  double start = seconds();
  repeat(20);
  wait();
  const auto count = std::max<std::int64_t>(20, static_cast<std::int64_t>(0.03 / ((seconds() - start) / 20)) / 20 * 20);
  std::vector<double> times;
  for (int batch = 0; batch < 9; ++batch) {
    start = seconds();
    repeat(count);
    wait();
    times.push_back((seconds() - start) / static_cast<double>(count));
  }
  return median(std::move(times));
}

}  // namespace ringwatch::bench

namespace {

double copyBandwidth = 0;  // bytes/s, read and written
std::string filter;

void measureCopy() {
  const std::size_t bytes = std::size_t{4} << 30;
  DeviceVector<char> from(bytes), to(bytes);
  from.fill(1);
  DeviceStream stream;
  const double time = timeOf(
      [&](std::int64_t count) {
        for (std::int64_t i = 0; i < count; ++i)
          checkCuda(cudaMemcpyAsync(to.data(), from.data(), bytes, cudaMemcpyDeviceToDevice, stream), "copy");
      },
      [&] { stream.synchronize(); });
  copyBandwidth = 2 * static_cast<double>(bytes) / time;
  std::printf("copy bandwidth %.2f TB/s\n", copyBandwidth * 1e-12);
}

/// Row sums of the consistent mass, as Body has them.
Eigen::VectorXd lumpedMassOf(const Mesh& mesh, double density) {
  Eigen::VectorXd mass = Eigen::VectorXd::Zero(mesh.X.cols());
  double N[maxElementNodes], dN[maxElementNodes][3];
  for (const MeshBlock& block : mesh.blocks) {
    const ElementInfo& element = elementInfo(block.type);
    for (std::size_t e = 0; e < block.elementCount(); ++e)
      for (const QuadraturePoint& point : element.massRule.points) {
        element.shape(point.xi, N);
        element.shapeGradient(point.xi, dN);
        Eigen::Matrix3d J = Eigen::Matrix3d::Zero();
        for (int a = 0; a < element.nodes; ++a) J += mesh.X.col(block.element(e)[a]) * Eigen::RowVector3d::Map(dN[a]);
        for (int a = 0; a < element.nodes; ++a)
          mass[block.element(e)[a]] += density * J.determinant() * point.weight * N[a];
      }
  }
  return mass;
}

/// Internal force by the plainest loop over the elements on the CPU, in double precision: what the device is held to.
NodeVectors referenceForce(const Mesh& mesh, const DeviceBodyInput& input, const NodeVectors& x) {
  NodeVectors f = NodeVectors::Zero(3, mesh.X.cols());
  for (std::size_t b = 0; b < mesh.blocks.size(); ++b) {
    const MeshBlock& block = mesh.blocks[b];
    const ElementInfo& element = elementInfo(block.type);
    std::visit(
        [&](const auto& law) {
          parallelFor(0, block.elementCount(), 0, [&](std::int64_t e) {
            const std::int32_t* nodes = block.element(e);
            for (const QuadraturePoint& point : input.rules[b]->points) {
              double dN[maxElementNodes][3];
              element.shapeGradient(point.xi, dN);
              Eigen::Matrix3d J = Eigen::Matrix3d::Zero(), D = Eigen::Matrix3d::Zero();
              for (int a = 0; a < element.nodes; ++a) {
                J += mesh.X.col(nodes[a]) * Eigen::RowVector3d::Map(dN[a]);
                D += x.col(nodes[a]) * Eigen::RowVector3d::Map(dN[a]);
              }
              const Eigen::Matrix3d inverse = J.inverse(), F = D * inverse;
              Matrix3<double> own;
              for (int i = 0; i < 9; ++i) own.m[i] = F(i / 3, i % 3);
              const Matrix3<double> P = law.stress(own);
              Eigen::Matrix3d T;
              for (int i = 0; i < 9; ++i) T(i / 3, i % 3) = P.m[i];
              T = point.weight * J.determinant() * T * inverse.transpose();
              for (int a = 0; a < element.nodes; ++a) {
                const Eigen::Vector3d share = T * Eigen::Vector3d::Map(dN[a]);
                for (int c = 0; c < 3; ++c) {
                  double& sum = f(c, nodes[a]);
#pragma omp atomic
                  sum += share[c];
                }
              }
            }
          });
        },
        input.materials[b].law);
  }
  return f;
}

/// Numbers nodes and elements at random.
void shuffle(Mesh& mesh) {
  std::mt19937 generator(5);
  std::vector<std::int32_t> order(mesh.nodeCount());
  std::iota(order.begin(), order.end(), 0);
  std::shuffle(order.begin(), order.end(), generator);
  NodeVectors X(3, mesh.X.cols());
  for (std::size_t i = 0; i < order.size(); ++i) X.col(order[i]) = mesh.X.col(i);
  mesh.X = X;
  for (MeshBlock& block : mesh.blocks) {
    const std::size_t n = block.nodesPerElement();
    std::vector<std::size_t> elements(block.elementCount());
    std::iota(elements.begin(), elements.end(), std::size_t{0});
    std::shuffle(elements.begin(), elements.end(), generator);
    std::vector<std::int32_t> connectivity(block.connectivity.size());
    for (std::size_t e = 0; e < elements.size(); ++e)
      for (std::size_t a = 0; a < n; ++a) connectivity[elements[e] * n + a] = order[block.connectivity[e * n + a]];
    block.connectivity = std::move(connectivity);
  }
}

struct Case {
  std::string name;
  const char* element;
  const char* law;
  int cells;
  int split;
  bool shuffled;
  bool forSeveral = false;  // too large for most single GPUs
};

/// Least bytes of one force evaluation with this plan: everything that is stored for it once.
template <class R>
double forceBytes(const DevicePlan& plan, const Mesh& mesh, const DeviceBodyInput& input) {
  double bytes = 0;
  for (std::size_t b = 0; b < plan.blocks.size(); ++b) {
    const DeviceBlockPlan& block = plan.blocks[b];
    const ElementInfo& element = elementInfo(mesh.blocks[b].type);
    const double numbers = element.constantGradient ? 9 : 10.0 * static_cast<double>(input.rules[b]->points.size());
    bytes += static_cast<double>(block.elements.size()) * (numbers * sizeof(R) + 2.0 * element.nodes);
    bytes += 2.0 * static_cast<double>(block.rows.size()) + 4.0 * static_cast<double>(block.groupRow.size());
    bytes += static_cast<double>(block.nodes.size()) * (4 + sizeof(Row4<R>));  // list, positions
  }
  const auto slots = static_cast<double>(plan.slot.size());
  bytes += slots * (2 * sizeof(Row4<R>) + 4) + 4.0 * static_cast<double>(plan.slotBegin.size());
  return bytes + static_cast<double>(mesh.nodeCount()) * sizeof(Row4<R>);  // the result
}

/// Checked steps of a body that is pulled slowly and vibrates, at 0.9 of the step that its bound at rest allows. Every
/// batch starts from rest, so that all of them, checked and plain, run through the same motion. The seconds of a plain
/// step and of a checked one; nothing where there was no certificate for all of them.
struct StepTimes {
  double plain = 0, checked = 0;
};
/// At the largest of some shares of the step that the bound at rest allows at which all steps are certified.
template <class Report>
std::optional<StepTimes> measureCertificate(const std::string& name, DeviceBody<double>& body, const Mesh& mesh,
                                            double noise, const Report& report) {
  std::mt19937 generator(4);
  std::uniform_real_distribution<double> uniform(-noise, noise);  // m/s
  NodeVectors v = 0.2 / mesh.X.maxCoeff() * mesh.X;
  for (Eigen::Index i = 0; i < v.size(); ++i) v.data()[i] += uniform(generator);
  const auto restart = [&] {
    body.setPositions(mesh.X);
    body.setVelocities(v);
  };
  restart();
  DeviceCertificate certificate(body);
  certificate.bound(12);
  double start = seconds();
  const double bound = certificate.bound(12).value, scratch = seconds() - start;
  constexpr std::int64_t steps = 200;
  constexpr int batches = 5;
  for (const double share : {0.9, 0.8, 0.7}) {
    const double h = share * 2 / std::sqrt(bound), sigma = 4 / (h * h);
    restart();
    if (!certificate.certify(sigma)) {
      std::printf("%-34s the certificate could not be had\n", name.c_str());
      return {};
    }
    start = seconds();
    if (!certificate.renew()) std::printf("%-34s the certificate could not be renewed\n", name.c_str());
    const double renewal = seconds() - start;
    bool certified = true;
    std::int64_t evaluated = 0, checked = 0;
    const auto medianOf = [&](bool withCertificate) {
      std::vector<double> times;
      for (int batch = 0; batch < batches && certified; ++batch) {
        restart();
        if (withCertificate) certificate.certify(sigma);
        body.synchronize();
        start = seconds();
        if (withCertificate)
          certificate.step(h, steps);
        else
          body.step(h, steps);
        body.synchronize();
        times.push_back((seconds() - start) / steps);
        if (!withCertificate) continue;
        const DeviceCertificate::Status status = certificate.status();
        certified = status.certified;
        evaluated += status.evaluated;
        checked += status.checked;
        if (!certified)
          std::printf("%-34s at %.1f of the step that the bound allows the certificate was lost at step %lld\n",
                      name.c_str(), share, static_cast<long long>(status.lostAt));
      }
      std::sort(times.begin(), times.end());
      return times[times.size() / 2];
    };
    const double withCertificate = medianOf(true);
    if (!certified) continue;
    const double plain = medianOf(false);
    report("step + certificate", withCertificate, 0);
    std::printf(
        "%-34s certificate: %+.1f %% of the step (%.2f us), certified in %d runs of %lld steps of %.4g s, %.1f of what "
        "the bound allows, %.3g evaluations an element and step; from scratch %.1f ms, renewed in %.1f ms; bound %.8g "
        "rad2/s2\n",
        name.c_str(), 100 * (withCertificate / plain - 1), plain * 1e6, batches, static_cast<long long>(steps), h,
        share, static_cast<double>(evaluated) / static_cast<double>(checked) / static_cast<double>(body.elementCount()),
        scratch * 1e3, renewal * 1e3, bound);
    return StepTimes{plain, withCertificate};
  }
  return {};
}

template <class R>
void measure(const Case& c, const DevicePlan& plan, const DeviceBodyInput& input) {
  const char* scalar = sizeof(R) == 8 ? "double" : "float";
  const std::string name = c.name + " " + scalar;
  if (name.find(filter) == std::string::npos) return;
  DeviceBody<R> body(input, &plan);
  const Mesh& mesh = *input.mesh;
  std::mt19937 generator(2);
  // Cells are 1 m wide; the flat tetrahedra of an unstructured mesh must not turn over, and want short steps.
  const bool flat = c.cells == 0;
  std::uniform_real_distribution<double> uniform(flat ? -1e-3 : -0.05, flat ? 1e-3 : 0.05);
  NodeVectors x = mesh.X;
  for (Eigen::Index i = 0; i < x.size(); ++i) x.data()[i] += uniform(generator);
  body.setPositions(x);
  const NodeVectors reference = referenceForce(mesh, input, x);
  std::printf("%-34s relative error of the force %.2g\n", name.c_str(),
              (body.internalForce() - reference).norm() / reference.norm());
  const auto elements = static_cast<double>(body.elementCount());
  const auto wait = [&] { body.synchronize(); };
  const double bytes = forceBytes<R>(plan, mesh, input),
               stepBytes = bytes + static_cast<double>(mesh.nodeCount()) * (48 + sizeof(R) * 2);
  const auto report = [&](const char* what, double time, double moved) {
    std::printf("%-34s %-16s %10.2f us %8.3f G/s", name.c_str(), what, time * 1e6, elements / time * 1e-9);
    if (moved > 0)
      std::printf("  %6.1f B/element, floor %7.2f G/s, %4.0f %% of copy bandwidth", moved / elements,
                  elements / moved * copyBandwidth * 1e-9, 100 * moved / time / copyBandwidth);
    std::printf("\n");
    std::fflush(stdout);
  };
  report("force",
         timeOf(
             [&](std::int64_t n) {
               for (; n > 0; --n) body.computeForce();
             },
             wait),
         bytes);
  const double h = flat ? 1e-6 : 1e-3;
  report("step", timeOf([&](std::int64_t n) { body.step(h, n); }, wait), stepBytes);
  report("tangent product",
         timeOf(
             [&](std::int64_t n) {
               for (; n > 0; --n) body.computeTangentProduct();
             },
             wait),
         0);
  if constexpr (std::is_same_v<R, double>) measureCertificate(name, body, mesh, flat ? 1e-5 : 0.1, report);
  if (!body.positions().allFinite()) std::printf("%-34s WARNING: the run did not stay finite\n", name.c_str());
}

bool wanted(const std::string& name) {
  return (name + " double").find(filter) != std::string::npos || (name + " float").find(filter) != std::string::npos;
}

Mesh meshOf(const Case& c) {
  BarOptions options;
  options.element = c.element;
  options.cells = {c.cells, c.cells, c.cells};
  options.size = {double(c.cells), double(c.cells), double(c.cells)};
  options.split = c.split;
  Mesh mesh = generateBar(options);
  if (c.shuffled) shuffle(mesh);
  return mesh;
}

DeviceBodyInput inputOf(const Case& c, const Mesh& mesh) {
  DeviceBodyInput input;
  input.mesh = &mesh;
  input.materials.assign(mesh.blocks.size(), makeMaterial(c.law, 30e3, 0.3, 1000));
  for (const MeshBlock& block : mesh.blocks) input.rules.push_back(&elementInfo(block.type).rules.front());
  input.lumpedMass = lumpedMassOf(mesh, 1000);
  return input;
}

/// Steps and checked steps on the first of the devices, then on all of them: how many times faster, whether the bits
/// are the same, and what is sent.
void runOnDevices(const Case& c, const Mesh& mesh, const std::vector<int>& devices) {
  double start = seconds();
  const DevicePlan plan = planPatches(mesh);
  const DeviceBodyInput input = inputOf(c, mesh);
  std::printf("%s: %zu elements, %d patches, planned in %.1f s\n", c.name.c_str(), mesh.elementCount(), plan.patchCount,
              seconds() - start);
  std::fflush(stdout);
  std::optional<StepTimes> one;
  NodeVectors x;
  for (const std::vector<int>& on : {std::vector<int>{devices.front()}, devices}) {
    if (on.size() == 1 && c.forSeveral) continue;
    start = seconds();
    DeviceBody<double> body(input, &plan, on);
    const std::string name = c.name + " on " + std::to_string(on.size());
    std::printf("%-34s set up in %.1f s, %.1f GB, %.2f MB exchanged a step\n", name.c_str(), seconds() - start,
                static_cast<double>(body.bytes()) * 1e-9, static_cast<double>(body.bytesExchanged()) * 1e-6);
    std::fflush(stdout);
    const std::optional<StepTimes> times =
        measureCertificate(name, body, mesh, 0.1, [](const char*, double, double) {});
    if (!times) continue;
    const auto elements = static_cast<double>(body.elementCount());
    std::printf("%-34s step %.1f us, %.2f G/s; step + certificate %.1f us, %.2f G/s", name.c_str(), times->plain * 1e6,
                elements / times->plain * 1e-9, times->checked * 1e6, elements / times->checked * 1e-9);
    const NodeVectors now = body.positions();
    if (one)
      std::printf("; %.3f and %.3f times one; positions after all steps %s", one->plain / times->plain,
                  one->checked / times->checked, (now.array() == x.array()).all() ? "have the same bits" : "DIFFER");
    std::printf("\n");
    std::fflush(stdout);
    one = times;
    x = now;
  }
}

void runCase(const Case& c, const Mesh& mesh) {
  const double start = seconds();
  const DevicePlan plan = planPatches(mesh);
  const double planTime = seconds() - start;
  const DeviceBodyInput input = inputOf(c, mesh);
  std::size_t nodes = 0, rows = 0;
  for (const DeviceBlockPlan& block : plan.blocks) {
    nodes += block.nodes.size();
    rows += block.rows.size();
  }
  std::printf(
      "%s: %zu elements, %zu nodes, %d patches, %.3f patch nodes an element, %.0f %% interior nodes, rows %.2f, "
      "plan %.1f s\n",
      c.name.c_str(), mesh.elementCount(), mesh.nodeCount(), plan.patchCount,
      double(nodes) / double(mesh.elementCount()), 100.0 * plan.interiorCount / double(mesh.nodeCount()),
      double(rows) / double(plan.blocks[0].corners.size()), planTime);
  measure<double>(c, plan, input);
  measure<float>(c, plan, input);
}

}  // namespace

int main(int argc, char** argv) {
  const bool ofFile = argc > 2 && std::string(argv[1]) == "--mesh",
             onSeveral = argc > 2 && std::string(argv[1]) == "--devices";
  filter = onSeveral ? (argc > 3 ? argv[3] : "") : argc > 1 && !ofFile ? argv[1] : "";
  const DeviceStatus status = deviceStatus();
  std::printf("%s\n", status.text.c_str());
  if (!status.available) return 1;
  measureCopy();
  if (ofFile) {
    runCase({"stvk, mesh of a file", "", "stvk", 0, 0, false}, loadMesh(argv[2]));
    return 0;
  }
  const Case cases[] = {
      {"tet4 stvk 5k", "tet4", "stvk", 10, 5, false},
      {"tet4 stvk 100k", "tet4", "stvk", 27, 5, false},
      {"tet4 stvk 1M", "tet4", "stvk", 58, 5, false},
      {"tet4 stvk 5M", "tet4", "stvk", 100, 5, false},
      {"tet4 stvk 5M shuffled", "tet4", "stvk", 100, 5, true},
      {"tet4 stvk 5M six a cell", "tet4", "stvk", 94, 6, false},
      {"tet4 corotational 5M", "tet4", "corotational", 100, 5, false},
      {"tet4 neo-hookean 5M", "tet4", "neo-hookean", 100, 5, false},
      {"tet4 linear 5M", "tet4", "linear", 100, 5, false},
      {"hex8 stvk 100k", "hex8", "stvk", 46, 1, false},
      {"hex8 stvk 5M", "hex8", "stvk", 171, 1, false},
      {"wedge6 stvk 2M", "wedge6", "stvk", 100, 0, false},
      {"pyramid5 stvk 6M", "pyramid5", "stvk", 100, 0, false},
      {"tet4 stvk 20M", "tet4", "stvk", 160, 5, false},
      {"tet4 stvk 200M", "tet4", "stvk", 342, 5, false, true},
  };
  if (onSeveral) {
    std::vector<int> devices;
    std::stringstream list(argv[2]);
    for (std::string number; std::getline(list, number, ',');) devices.push_back(std::stoi(number));
    for (const Case& c : cases)
      if (wanted(c.name)) runOnDevices(c, meshOf(c), devices);
    return 0;
  }
  for (const Case& c : cases)
    if (wanted(c.name) && !c.forSeveral) runCase(c, meshOf(c));
  bench::measureImex(filter);
  return 0;
}
