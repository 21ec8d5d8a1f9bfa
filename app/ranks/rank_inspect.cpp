#include <ringwatch/app/ranks/rank_inspect.h>

#include <optional>
#include <string>
#include <utility>

#include <fmt/format.h>

#include <ringwatch/app/ranks/rank_threads.h>
#include <ringwatch/app/ranks/together.h>
#include <ringwatch/distributed/halo.h>
#include <ringwatch/distributed/rank_body.h>
#include <ringwatch/distributed/rank_frequency.h>
#include <ringwatch/distributed/rank_monitor.h>

namespace ringwatch {
namespace {

void requireDistributable(const InspectOptions& options) {
  for (const auto& [given, option] : {std::pair{options.step.has_value(), "--step"},
                                      {!options.metrics.empty(), "--metric"},
                                      {options.lanczos.has_value(), "--lanczos"},
                                      {options.exact, "--exact"},
                                      {options.prove.has_value(), "--prove"},
                                      {options.stretch.has_value(), "--stretch"},
                                      {options.distribution, "--distribution"},
                                      {options.picture.has_value(), "--picture"},
                                      {options.vtu.has_value(), "--vtu"},
                                      {options.certificate.has_value(), "--certificate"},
                                      {static_cast<bool>(options.page), "--report"}})
    if (given)
      throw InputError(fmt::format(
          "{}: is not distributed over ranks; leave it out, or inspect with one process, without mpirun", option));
}

CriticalStep bracketOnRanks(Ranks& ranks, const RankBody& part, const NodeVectors& x, const StepRule& rule) {
  Halo halo(ranks, part);
  std::optional<RankMonitor> monitor;
  together(ranks, [&] { monitor.emplace(ranks, halo, part, RankMonitorOptions{.limit = rule}); });
  const NodeVectors own = x(Eigen::all, part.globalNodes());
  const CriticalStep step = monitor->bracketFromScratch(own);
  together(ranks, [&] {
    if (!step.isBracket()) throw NumericalError("the tangent is not finite");
  });
  return step;
}

}  // namespace

InspectResult inspectOnRanks(Ranks& ranks, const InspectOptions& asked) {
  bool begun = false;
  std::optional<RankBody> part;
  const auto inspect = [&] {
    requireDistributable(asked);
    InspectOptions options = asked;
    options.bracket = [&](const Body& body, const NodeVectors& x, const StepRule& rule) {
      begun = true;
      requireNoFault(ranks, {});  // of reading the mesh
      const Partition partition = cutTogether(ranks, body.mesh());
      together(ranks,
               [&] { part.emplace(body, partition, ranks.rank(), threadsOfRank(ranks, asked.threads, body.mesh())); });
      return bracketOnRanks(ranks, *part, x, rule);
    };
    options.globalFrequency = [&](const Body& body, const NodeVectors& x) {
      return globalFrequency(ranks, *part, body, x);
    };
    return inspectMesh(options);
  };
  try {
    try {
      return inspect();
    } catch (const NumericalError& fault) {
      if (!begun) requireNoFault(ranks, {ExitStatus::unstable, fault.what()});
      throw;
    } catch (const std::exception& fault) {
      if (!begun) requireNoFault(ranks, {ExitStatus::badInput, fault.what()});
      throw;
    }
  } catch (const OtherRankFailed& fault) {
    InspectResult nothing;
    nothing.status = fault.status;
    return nothing;
  }
}

}  // namespace ringwatch
