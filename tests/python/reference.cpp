// What the Python module is compared with: the same observations, made in C++.
//
//   ringwatch_python_reference observe MESH LAW STEPS [BUDGET]    a line a step: safe, optimistic, elements refreshed,
//                                                                 work spent by purpose; reals hexadecimal
//   ringwatch_python_reference time MESH LAW ROUNDS               a line a round: µs of processor time an observation
//
// The bar is stretched along x: step k has x = X (1 + k / 4096).
#include <cstdio>
#include <cstdlib>
#include <string_view>

#include <time.h>

#include <ringwatch/meshes/mesh_io.h>
#include <ringwatch/monitor/stability_monitor.h>

namespace {

using namespace ringwatch;

NodeVectors stretched(const Mesh& mesh, int k) {
  NodeVectors x = mesh.X;
  x.row(0) *= 1 + k / 4096.0;
  return x;
}

void observe(const Body& body, int steps, const MonitorOptions& options) {
  StabilityMonitor monitor(body, options);
  const NodeVectors v = NodeVectors::Zero(3, body.nodeCount());
  for (int k = 0; k < steps; ++k) {
    const MonitorReport& report = monitor.observe(k, 1e-3 * k, stretched(body.mesh(), k), v, 1e-4);
    std::printf("%a %a %lld", report.bracket->safe, report.bracket->optimistic,
                static_cast<long long>(report.elementsRefreshed));
    for (const double part : report.spent.of) std::printf(" %a", part);
    std::printf("\n");
  }
}

double processorTime() {
  timespec now;
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return 1e6 * static_cast<double>(now.tv_sec) + 1e-3 * static_cast<double>(now.tv_nsec);
}

void measure(const Body& body, int rounds) {
  constexpr int observations = 200;  // a round: the states of rest and of one stretched by 1/4096 in turn
  StabilityMonitor monitor(body, {.limit = 2.0});
  const NodeVectors v = NodeVectors::Zero(3, body.nodeCount());
  const NodeVectors states[] = {body.mesh().X, stretched(body.mesh(), 1)};
  for (int round = 0; round < rounds; ++round) {
    const double begin = processorTime();
    for (int k = 0; k < observations; ++k) monitor.observe(k, 1e-3 * k, states[k % 2], v, 1e-4);
    std::printf("%.6f\n", (processorTime() - begin) / observations);
  }
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 5 || argc > 6) return 2;
  const Body body(loadMesh(argv[2]), makeMaterial(argv[3], 30e3, 0.3, 1000), {{}, Lumping::rowSum, 1});
  const int count = std::atoi(argv[4]);
  if (std::string_view(argv[1]) == "observe")
    observe(body, count,
            argc > 5 ? MonitorOptions{.budget = std::atof(argv[5]), .workInAdvance = 0} : MonitorOptions{});
  else
    measure(body, count);
  return 0;
}
