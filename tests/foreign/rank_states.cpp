// States of small bodies in motion on the ranks of mpirun, for slepc_test.py: writes FOLDER/state_K.txt, with the
// bracket of the ranks in the first line and M^-½ K M^-½ over the free components below, a row of "row column value"
// for each entry.
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include <ringwatch/distributed/rank_domain.h>
#include <ringwatch/integrators/body_system.h>
#include <ringwatch/meshes/generators/generators.h>
#include <ringwatch/monitor/stability_monitor.h>

namespace ringwatch {
namespace {

void run(const std::string& folder) {
  Ranks ranks(MPI_COMM_WORLD);
  int written = 0;
  for (const char* element : {"tet4", "hex8"})
    for (const char* law : {"stvk", "neo-hookean"}) {
      BarOptions options;
      options.size = {0.12, 0.04, 0.04};
      options.cells = {9, 3, 3};
      options.element = element;
      options.jitter = 0.2;
      Body whole(generateBar(options), makeMaterial(law, 1e6, 0.3, 1000));
      for (std::int32_t i = 0; i < whole.nodeCount(); ++i)
        if (whole.mesh().X(0, i) < 1e-9) whole.constraints().fix(i);
      whole.addBodyForce({0, 0, -300});
      RankBody part(whole, partitionMesh(ranks, whole.mesh()), ranks.rank(), 1);
      Halo halo(ranks, part);
      RankDomain domain(ranks, halo, part);
      BodySystem system(part.body());
      const std::unique_ptr<Integrator> integrator = makeIntegrator("symplectic-euler");
      StabilityMonitor monitor(part.body(), {.limit = 2.0});
      State state = system.initialState();
      StepEvaluation evaluation;
      const double h = 1e-4;
      for (int step = 0; step <= 100; ++step) {
        const MonitorReport& report = monitor.observe(step, state.time, state.x, state.v, h, &evaluation,
                                                      [&] { system.complete(state, evaluation); });
        if (step % 50 == 0) {
          const NodeVectors x = gathered(ranks, part, state.x);
          if (ranks.rank() == 0) {
            std::FILE* file = std::fopen((folder + "/state_" + std::to_string(written++) + ".txt").c_str(), "w");
            if (!file || !report.bracket) MPI_Abort(MPI_COMM_WORLD, 1);
            std::fprintf(file, "%.17g %.17g %d\n", report.bracket->safe, report.bracket->optimistic,
                         3 * whole.nodeCount());
            const Eigen::SparseMatrix<double> K = whole.assembleTangent(x);
            const auto free = [&](Eigen::Index dof) {
              return !whole.constraints().isConstrained(static_cast<std::int32_t>(dof / 3), static_cast<int>(dof % 3));
            };
            for (Eigen::Index c = 0; c < K.outerSize(); ++c)
              for (Eigen::SparseMatrix<double>::InnerIterator at(K, c); at; ++at)
                if (free(at.row()) && free(at.col()))
                  std::fprintf(
                      file, "%d %d %.17g\n", static_cast<int>(at.row()), static_cast<int>(at.col()),
                      at.value() / std::sqrt(whole.lumpedMass()[at.row() / 3] * whole.lumpedMass()[at.col() / 3]));
            std::fclose(file);
          }
        }
        integrator->advance(system, state, h);
        halo.exchange(state.x);
      }
    }
}

}  // namespace
}  // namespace ringwatch

int main(int argc, char** argv) {
  MPI_Init(&argc, &argv);
  if (argc != 2) return 2;
  ringwatch::run(argv[1]);
  MPI_Finalize();
}
