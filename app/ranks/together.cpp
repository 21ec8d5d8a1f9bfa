#include <ringwatch/app/ranks/together.h>

#include <cstdio>
#include <cstdlib>
#include <utility>
#include <vector>

#include <fmt/format.h>

namespace ringwatch {

void endAll(const Ranks& ranks, const std::string& fault, ExitStatus status) {
  abortAll(ranks, fmt::format("{}: {}", ranks.name(), fault), status);
}

void abortAll(const Ranks& ranks, const std::string& text, ExitStatus status) {
  std::fprintf(stderr, "ringwatch: %s\n", text.c_str());
  MPI_Abort(ranks.communicator(), static_cast<int>(status));
  std::abort();
}

void requireNoFault(Ranks& ranks, const RankFault& own) {
  const bool failed = own.status != ExitStatus::done;
  const auto first = ranks.firstWhere(failed);
  if (first == ranks.size()) return;
  const bool all = ranks.least(failed ? 1 : 0) == 1;
  auto status = static_cast<int>(own.status);
  ranks.share(&status, sizeof status, first);
  const std::string text = ranks.shareText(all ? own.text : fmt::format("{}: {}", ranks.name(), own.text), first);
  if (ranks.rank() != 0) throw OtherRankFailed{static_cast<ExitStatus>(status)};
  if (static_cast<ExitStatus>(status) == ExitStatus::unstable) throw NumericalError(text);
  throw InputError(text);
}

Partition cutTogether(Ranks& ranks, const Mesh& mesh) {
  std::vector<std::int32_t> parts(mesh.elementCount());
  together(ranks, [&] {
    if (ranks.rank() == 0) parts = partitionMesh(mesh, ranks.size()).ofElement;
  });
  ranks.share(parts.data(), parts.size() * sizeof parts[0], 0);
  return partitionOf(mesh, std::move(parts), ranks.size());
}

}  // namespace ringwatch
