// What it costs to start: a box of tetrahedra is written to a file, read, checked and set up, stepped and watched.
// Times in steps of the same body, and memory a tetrahedron.
//
//   ringwatch_start_up [ELEMENTS] [FORMAT]
//
// ELEMENTS: about so many, 1000000 by default. FORMAT: msh (4.1, text), msh-binary or vtu; msh-binary by default.
// One thread. Times are CPU seconds of this process, the step's the median of 15. Memory is the growth of the resident
// set since before the file was read, after what was freed has been given back, in bytes a tetrahedron; the peak is the
// system's own count and holds the generator's mesh, which lives only before the file is read.
#include <malloc.h>
#include <unistd.h>

#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>
#include <functional>
#include <string>

#include <bench/runs.h>
#include <bench/support.h>
#include <ringwatch/base/error.h>
#include <ringwatch/base/median.h>
#include <ringwatch/integrators/body_system.h>
#include <ringwatch/integrators/symplectic_euler.h>
#include <ringwatch/meshes/mesh_io.h>
#include <ringwatch/meshes/node_order.h>
#include <ringwatch/monitor/bounds/global_frequency.h>
#include <ringwatch/monitor/stability_monitor.h>

namespace ringwatch::bench {
namespace {

double secondsOf(const std::function<void()>& work) {
  const double begin = cpuSeconds();
  work();
  return cpuSeconds() - begin;
}
/// Resident set without shared pages of files, bytes.
double residentBytes() {
  malloc_trim(0);
  std::ifstream statm("/proc/self/statm");
  double size = 0, resident = 0, shared = 0;
  statm >> size >> resident >> shared;
  return (resident - shared) * static_cast<double>(sysconf(_SC_PAGESIZE));
}

struct Format {
  std::string name, extension;
  MeshFormat format;
};
const Format formats[] = {{"msh", ".msh", MeshFormat::msh41},
                          {"msh-binary", ".msh", MeshFormat::msh41Binary},
                          {"vtu", ".vtu", MeshFormat::vtu}};

void startUp(int wanted, const Format& format) {
  const std::filesystem::path file =
      std::filesystem::temp_directory_path() / joinText("ringwatch_start_up_", getpid(), format.extension);
  writeMesh(makeMesh({"tet4", wanted, "stvk", 1}), file, format.format);
  const double before = residentBytes();
  double elements = 0;
  struct Row {
    std::string what;
    double seconds, bytes;
  };
  std::vector<Row> rows;
  const auto stage = [&](const std::string& what, const std::function<void()>& work) {
    const double seconds = secondsOf(work);
    rows.push_back({what, seconds, residentBytes() - before});
  };

  Mesh mesh;
  stage("read", [&] { mesh = readMesh(file); });
  std::filesystem::remove(file);
  elements = static_cast<double>(mesh.elementCount());
  stage("check", [&] { requireSound(mesh, "the mesh"); });
  stage("renumber", [&] { renumberNodes(mesh); });
  std::unique_ptr<Body> body;
  stage("body", [&] {
    body = std::make_unique<Body>(std::move(mesh), makeMaterial("stvk", 30e3, 0.3, 1000),
                                  BodyOptions{{}, Lumping::rowSum, 1});
  });
  const double length = body->mesh().X.row(0).maxCoeff();
  for (std::int32_t i = 0; i < body->nodeCount(); ++i) {
    if (body->mesh().X(0, i) > 1e-9 && body->mesh().X(0, i) < length - 1e-9) continue;
    body->constraints().fix(i);
    if (body->mesh().X(0, i) > 1e-9) body->constraints().move(i, 0, 0.1 * length);
  }
  std::unique_ptr<BodySystem> system;
  SymplecticEuler integrator;
  State state;
  const double h = 0.8 * 2 / std::sqrt(lanczosUpperBound(*body, body->mesh().X).upper.value);
  stage("first step", [&] {
    system = std::make_unique<BodySystem>(*body);
    state = system->initialState();
    integrator.step(*system, state, h);
  });
  std::vector<double> steps(15);
  for (double& step : steps) step = secondsOf([&] { integrator.step(*system, state, h); });
  const double step = median(std::move(steps)), started = [&] {
    double sum = 0;
    for (const Row& row : rows) sum += row.seconds;
    return sum;
  }();
  rows.push_back({"all this", started, rows.back().bytes});
  for (const MonitorMode mode : {MonitorMode::threshold, MonitorMode::bracket, MonitorMode::metric}) {
    MonitorOptions options;
    options.mode = mode;
    if (mode == MonitorMode::metric) options.metric = "reduced-1-ring";
    std::unique_ptr<StabilityMonitor> monitor;
    const std::string name(monitorModeName(mode));
    // As in a run: an observation leaves the forces of the step that follows.
    StepEvaluation evaluation;
    stage("monitor " + name + ", first observation", [&] {
      monitor = std::make_unique<StabilityMonitor>(*body, options);
      monitor->observe(0, state.time, state.x, state.v, h, &evaluation);
    });
    stage("monitor " + name + ", 3 more", [&] {
      for (int k = 1; k <= 3; ++k) {
        system->complete(state, evaluation);
        integrator.advance(*system, state, h);
        monitor->observe(k, state.time, state.x, state.v, h, &evaluation);
      }
    });
    rows.back().seconds -= 3 * step;
  }

  std::printf("%.0f tetrahedra from %s; a step takes %.3g ms, %.3g ns a tetrahedron\n\n", elements, format.name.c_str(),
              1e3 * step, 1e9 * step / elements);
  std::printf("| stage | s | in steps | bytes a tetrahedron |\n|---|---|---|---|\n");
  for (const Row& row : rows)
    std::printf("| %s | %.3g | %.1f | %.0f |\n", row.what.c_str(), row.seconds, row.seconds / step,
                row.bytes / elements);
}

}  // namespace
}  // namespace ringwatch::bench

int main(int argc, char** argv) try {
  using namespace ringwatch;
  const int elements = argc > 1 ? std::stoi(argv[1]) : 1000000;
  const std::string wanted = argc > 2 ? argv[2] : "msh-binary";
  for (const bench::Format& format : bench::formats)
    if (format.name == wanted) {
      bench::startUp(elements, format);
      return 0;
    }
  std::fprintf(stderr, "unknown format \"%s\"; known are msh, msh-binary and vtu\n", wanted.c_str());
  return 1;
} catch (const std::exception& fault) {
  std::fprintf(stderr, "%s\n", fault.what());
  return 1;
}
