#include <ringwatch/app/ranks/together.h>

#include <cstdio>
#include <cstdlib>
#include <utility>
#include <vector>

#include <fmt/format.h>

namespace ringwatch {

void endAll(const Ranks& ranks, const char* fault) {
  std::fprintf(stderr, "ringwatch: %s: %s\n", ranks.name().c_str(), fault);
  MPI_Abort(ranks.communicator(), static_cast<int>(ExitStatus::badInput));
  std::abort();
}

void requireNoFault(Ranks& ranks, const RankFault& own) {
  const bool failed = own.status != ExitStatus::done;
  const auto first = static_cast<int>(ranks.least(failed ? ranks.rank() : ranks.size()));
  if (first == ranks.size()) return;
  const bool all = ranks.least(failed ? 1 : 0) == 1;
  auto status = static_cast<int>(own.status);
  std::string text = all ? own.text : fmt::format("{}: {}", ranks.name(), own.text);
  std::size_t length = text.size();
  ranks.share(&status, sizeof status, first);
  ranks.share(&length, sizeof length, first);
  text.resize(length);
  ranks.share(text.data(), length, first);
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
