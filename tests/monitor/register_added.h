#pragma once

namespace ringwatch::test {

/// registerElement<Wedge15>() and registerLaw<MooneyRivlin>(), which make the kernels of an element for every law and
/// of a law for every element: in a file of their own for the time that it takes to compile them.
void registerWedge15();
void registerMooneyRivlin();

}  // namespace ringwatch::test
