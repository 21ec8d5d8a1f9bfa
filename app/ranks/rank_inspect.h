#pragma once
#include <ringwatch/app/command/inspect.h>
#include <ringwatch/distributed/ranks.h>

namespace ringwatch {

/// inspectMesh() of a mesh that every rank reads, with a bracket that the ranks find on their parts: the same on all of
/// them, and for any number of them (Theorem 79, docs/theory/distribution.md). Throws InputError or NumericalError on
/// the first rank, and InputError for what is not distributed; the others have the exit status then. Collective.
InspectResult inspectOnRanks(Ranks& ranks, const InspectOptions& options);

}  // namespace ringwatch
