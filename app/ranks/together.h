#pragma once
#include <exception>
#include <new>
#include <string>

#include <ringwatch/app/output/exit_status.h>
#include <ringwatch/base/error.h>
#include <ringwatch/distributed/partition.h>
#include <ringwatch/distributed/ranks.h>

namespace ringwatch {

/// Thrown on the ranks but the first, which tells of the fault.
struct OtherRankFailed {
  ExitStatus status;
};

/// What a rank has to say of its work.
struct RankFault {
  ExitStatus status = ExitStatus::done;
  std::string text;
};

/// Cuts a mesh that all ranks have: the first one does, and tells the others. Throws as together(). Collective.
Partition cutTogether(Ranks& ranks, const Mesh& mesh);

/// Ends all ranks: others wait for this one, which cannot go on.
[[noreturn]] void endAll(const Ranks& ranks, const std::string& fault, ExitStatus status);
/// The same with a text that names the rank.
[[noreturn]] void abortAll(const Ranks& ranks, const std::string& text, ExitStatus status);

/// Throws on all ranks where the work of one has failed: on the first rank the fault of the first that failed, with the
/// name of that one unless all have failed, and OtherRankFailed on the others. Collective.
void requireNoFault(Ranks& ranks, const RankFault& own);

/// Work that is no collective, on every rank: it has been done on all of them, or all throw as requireNoFault does.
/// Collective.
template <class Work>
void together(Ranks& ranks, const Work& work) {
  RankFault fault;
  try {
    work();
  } catch (const NumericalError& found) {
    fault = {ExitStatus::unstable, found.what()};
  } catch (const std::bad_alloc&) {
    fault = {ExitStatus::badInput,
             "out of memory; use a smaller mesh, or fewer ranks on a machine with more threads each"};
  } catch (const std::exception& found) {
    fault = {ExitStatus::badInput, found.what()};
  }
  requireNoFault(ranks, fault);
}

}  // namespace ringwatch
