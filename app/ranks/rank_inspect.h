#pragma once
#include <ringwatch/app/analysis/inspect.h>
#include <ringwatch/distributed/ranks.h>

namespace ringwatch {

/// inspectMesh() with a bracket that the ranks find on their parts: the same on all of them, and for any number of them
/// (Theorems 79 and 95, docs/theory/distribution.md). Every rank reads the whole mesh, but of an MSH 4.1 binary file
/// each reads a share and holds its part alone, unless the whole body is asked for (InspectOptions::global). Throws
/// InputError or NumericalError on the first rank, and InputError for what is not distributed; the others have the exit
/// status then. Collective.
InspectResult inspectOnRanks(Ranks& ranks, const InspectOptions& options);

}  // namespace ringwatch
