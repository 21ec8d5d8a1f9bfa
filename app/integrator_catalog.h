#pragma once
#include <ringwatch/integrators/integrator.h>

namespace ringwatch {

/// The integrators that this program was built with, by name: the explicit ones and, with SUNDIALS, the implicit ones.
const IntegratorCatalog& integratorCatalog();
/// Their declarations, for lists and help texts.
std::vector<IntegratorInfo> integratorInfos();

}  // namespace ringwatch
