#pragma once
#include <functional>

namespace ringwatch {

/// Opens what the caller left closed of standard input, output and error, so that no result gets their descriptors: it
/// would receive the messages. Writing to a standard output that was closed still fails.
void holdStandardStreams();

/// Keeps memory that is given back when there is no more, so that what ends then can say so; where it is spent too, an
/// allocation that may not fail ends the program by its line.
void keepMemoryInReserve();

/// Makes writing beyond a limit on the size of files (`ulimit -f`) an error of the write instead of the program's end.
void reportFileSizeLimit();

/// Calls work on a stack that is large enough: on the caller's, or on a thread of its own where the limit
/// (`ulimit -s`) is small. Threads that start later get as much. Throws InputError when OMP_STACKSIZE asks for less.
void onLargeStack(const std::function<void()>& work);

}  // namespace ringwatch
