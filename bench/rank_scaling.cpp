// What steps of a distributed body take: mpirun -n RANKS ringwatch_rank_scaling weak|strong TETS STEPS. TETS: of a rank
// (weak) or of all (strong). Prints a line of JSON on rank 0. The body is a block of jittered cubes of 1 cm cut into
// six tetrahedra each, St. Venant-Kirchhoff, set in motion; steps are half the safe one, each certified in threshold
// mode. Times are of the slowest rank: medians over steps, with the quartiles beside them.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include <ringwatch/distributed/partition.h>
#include <ringwatch/distributed/rank_domain.h>
#include <ringwatch/integrators/body_system.h>
#include <ringwatch/meshes/generators/generators.h>
#include <ringwatch/monitor/energy_balance.h>
#include <ringwatch/monitor/stability_monitor.h>

namespace ringwatch {
namespace {

double now() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

struct Quartiles {
  double low, median, high;  // s
};
Quartiles quartilesOf(std::vector<double> times) {
  std::sort(times.begin(), times.end());
  const auto at = [&](double share) {
    return times[static_cast<std::size_t>(share * static_cast<double>(times.size() - 1))];
  };
  return {at(0.25), at(0.5), at(0.75)};
}

int run(const std::string& kind, double tets, int steps) {
  Ranks ranks(MPI_COMM_WORLD);
  const double all = kind == "weak" ? tets * ranks.size() : tets;
  const int side = std::max(1, static_cast<int>(std::lround(std::cbrt(all / 6))));
  const double setUpBegan = now();
  BarOptions options;
  options.cells = {side, side, side};
  options.size = {0.01 * side, 0.01 * side, 0.01 * side};
  options.element = "tet4";
  options.jitter = 0.15;
  std::unique_ptr<RankBody> part;
  std::int64_t elements = 0;
  State state;
  {
    const Body whole(generateBar(options), makeMaterial("stvk", 1e6, 0.3, 1000));
    elements = static_cast<std::int64_t>(whole.mesh().elementCount());
    part = std::make_unique<RankBody>(whole, partitionMesh(ranks, whole.mesh()), ranks.rank(), 1);
  }
  Halo halo(ranks, *part);
  RankDomain domain(ranks, halo, *part);
  BodySystem system(part->body());
  const std::unique_ptr<Integrator> integrator = makeIntegrator("symplectic-euler");
  StabilityMonitor monitor(part->body(), {.limit = 2.0, .mode = MonitorMode::threshold});
  state = system.initialState();
  // A wave through the block: the same velocity at a node for any number of ranks.
  for (Eigen::Index i = 0; i < state.v.cols(); ++i)
    state.v.col(i) =
        0.5 * Eigen::Vector3d(std::sin(40 * state.x(1, i)), std::sin(40 * state.x(2, i)), std::sin(40 * state.x(0, i)));
  StepEvaluation evaluation;
  const auto meanwhile = [&] { system.complete(state, evaluation); };
  double h = 1e-9;  // s, until the first bracket
  h = 0.5 * monitor.observe(0, 0, state.x, state.v, h, &evaluation, meanwhile).certified;
  std::vector<double> setUp{now() - setUpBegan};
  ranks.largest(setUp);

  // Steps without the certificate, then with it.
  Body::Workspace workspace;
  std::vector<double> plain(steps), certified(steps);
  const auto takePlain = [&] {
    evaluation.arrival = halo.arrival();
    part->body().evaluate(state.x, evaluation, workspace);
    evaluation.arrival = nullptr;
    system.complete(state, evaluation);
    integrator->advance(system, state, h);
    halo.begin(state.x);
  };
  for (int k = 0; k < 5; ++k) takePlain();
  for (int k = 0; k < steps; ++k) {
    const double began = now();
    takePlain();
    plain[k] = now() - began;
  }
  bool proven = true;
  double evaluated = 0;  // elements
  const Halo::Traffic sentBefore = halo.traffic();
  for (int k = 0; k < steps; ++k) {
    const double began = now();
    const MonitorReport& report = monitor.observe(k + 1, state.time, state.x, state.v, h, &evaluation, meanwhile);
    evaluated += static_cast<double>(report.elementsRefreshed);
    proven &= report.verdict == Verdict::certified;
    integrator->advance(system, state, h);
    halo.begin(state.x);
    certified[k] = now() - began;
  }
  halo.finish();
  const Halo::Traffic& sent = halo.traffic();
  std::vector<ExactSum> bytes(2);
  bytes[0].add(static_cast<double>(sent.received - sentBefore.received));
  bytes[1].add(static_cast<double>(sent.hidden - sentBefore.hidden));
  ranks.sum(bytes);
  std::vector<double> waited{(sent.waited - sentBefore.waited) / steps};
  ranks.largest(waited);
  ranks.largest(plain);
  ranks.largest(certified);
  const Energies energies = EnergyBalance(part->body()).evaluate(state.x, state.v);
  std::vector<double> most{static_cast<double>(part->elements()), static_cast<double>(part->ghostNodes()),
                           static_cast<double>(halo.traffic().bytes - sentBefore.bytes) / steps, evaluated / steps};
  ranks.largest(most);
  std::vector<ExactSum> held(1);
  held[0].add(static_cast<double>(part->elements()));
  ranks.sum(held);
  if (ranks.rank() != 0) return 0;
  const Quartiles p = quartilesOf(plain), c = quartilesOf(certified);
  std::printf(
      "{\"kind\": \"%s\", \"ranks\": %d, \"elements\": %lld, \"most_elements\": %.0f, \"computed_twice\": %.4f, "
      "\"most_ghosts\": %.0f, \"bytes_sent\": %.0f, \"hidden\": %.4f, \"waited\": %.3g, \"evaluated\": %.1f, "
      "\"set_up\": %.3g, "
      "\"step\": [%.6g, %.6g, %.6g], \"certified_step\": [%.6g, %.6g, %.6g], \"certified\": %s, \"strain\": "
      "\"%a\"}\n",
      kind.c_str(), ranks.size(), static_cast<long long>(elements), most[0],
      held[0].value() / static_cast<double>(elements) - 1, most[1], most[2],
      bytes[0].value() > 0 ? bytes[1].value() / bytes[0].value() : 0, waited[0], most[3], setUp[0], p.low, p.median,
      p.high, c.low, c.median, c.high, proven ? "true" : "false", energies.strain);
  return proven ? 0 : 1;
}

}  // namespace
}  // namespace ringwatch

int main(int argc, char** argv) {
  MPI_Init(&argc, &argv);
  const std::string kind = argc == 4 ? argv[1] : "";
  const double tets = argc == 4 ? std::atof(argv[2]) : 0;
  const int steps = argc == 4 ? std::atoi(argv[3]) : 0;
  int status = 2;
  if ((kind == "weak" || kind == "strong") && tets >= 6 && steps > 0)
    status = ringwatch::run(kind, tets, steps);
  else
    std::fprintf(stderr, "usage: mpirun -n RANKS %s weak|strong TETS STEPS, TETS >= 6\n", argv[0]);
  MPI_Finalize();
  return status;
}
