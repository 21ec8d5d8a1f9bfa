#include <cstdio>
#include <exception>

#include <ringwatch/distributed/partition.h>
#include <ringwatch/distributed/rank_domain.h>
#include <ringwatch/integrators/body_system.h>
#include <ringwatch/meshes/generators/generators.h>
#include <ringwatch/monitor/energy_balance.h>
#include <ringwatch/monitor/stability_monitor.h>

namespace {

int run() {
  using namespace ringwatch;
  Ranks ranks(MPI_COMM_WORLD);
  // Every rank makes the whole body and takes its part.
  BarOptions bar;
  bar.size = {0.2, 0.04, 0.04};
  bar.cells = {40, 8, 8};
  bar.element = "tet4";
  Body whole(generateBar(bar), makeMaterial("stvk", 30e3, 0.3, 1000));
  for (std::int32_t i = 0; i < whole.nodeCount(); ++i)
    if (whole.mesh().X(0, i) < 1e-9) whole.constraints().fix(i);
  whole.addBodyForce({0, 0, -9.81});
  RankBody part(whole, partitionMesh(ranks, whole.mesh()), ranks.rank(), 1);

  Halo halo(ranks, part);
  RankDomain domain(ranks, halo, part);
  BodySystem system(part.body());
  const std::unique_ptr<Integrator> integrator = makeIntegrator("symplectic-euler");
  StabilityMonitor monitor(part.body(), {.limit = integrator->info().imaginaryLimit});
  State state = system.initialState();
  StepEvaluation evaluation;
  double h = 1e-4;
  for (int step = 0; step < 200; ++step) {
    const MonitorReport& report = monitor.observe(step, state.time, state.x, state.v, h, &evaluation,
                                                  [&] { system.complete(state, evaluation); });
    if (!report.bracket) return 1;  // the state is no longer finite, and no step helps
    if (report.verdict != Verdict::certified) h = 0.9 * report.bracket->safe;
    if (ranks.rank() == 0 && step % 50 == 0)
      std::printf("step %d: h = %.3g s, critical step between %.17g and %.17g s: %s\n", step, h, report.bracket->safe,
                  report.bracket->optimistic, std::string(verdictName(report.verdict)).c_str());
    integrator->advance(system, state, h);
    halo.begin(state.x);  // ends behind the elements of the next observation that need no ghost
  }
  halo.finish();
  const Energies energies = EnergyBalance(part.body()).evaluate(state.x, state.v);
  const NodeVectors x = gathered(ranks, part, state.x);
  if (ranks.rank() == 0)
    std::printf("kinetic %.17g J, strain %.17g J, lowest node at z = %.17g m\n", energies.kinetic, energies.strain,
                x.row(2).minCoeff());
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  MPI_Init(&argc, &argv);
  int status = 1;
  try {
    status = run();
  } catch (const std::exception& fault) {
    std::fprintf(stderr, "%s: %s\n", ringwatch::Ranks(MPI_COMM_SELF).name().c_str(), fault.what());
    MPI_Abort(MPI_COMM_WORLD, 1);
  }
  MPI_Finalize();
  return status;
}
