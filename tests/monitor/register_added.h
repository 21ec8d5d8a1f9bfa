#pragma once

namespace ringwatch::test {

/// registerElement<Wedge15>() and registerLaw<LogMooneyRivlin>(), which make the kernels of an element for every law
/// and of a law for every element: in a file of their own for the time that it takes to compile them.
void registerWedge15();
void registerLogMooneyRivlin();

}  // namespace ringwatch::test
