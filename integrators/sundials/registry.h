#pragma once
#include <ringwatch/integrators/integrator.h>

namespace ringwatch {

/// The implicit, additive and multirate integrators, on SUNDIALS; one line each in registry.cpp. A program that links
/// ringwatch::sundials composes its catalog from this list and coreIntegrators().
std::span<const IntegratorEntry> sundialsIntegrators();

}  // namespace ringwatch
