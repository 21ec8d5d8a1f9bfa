#pragma once
#include <string_view>

namespace ringwatch {

/// Laws whose tangent stiffens with stretch. Linear elasticity has one tangent. The corotational law's ∂P/∂F exceeds
/// the turned one at rest by its part on spins alone, 2μ + 2 (λ (tr U - 3) - 2μ)/(sum of two stretches), where the
/// turned tangent has nothing that could be scaled, and its highest eigenvalue stays 3λ + 2μ while three times that sum
/// exceeds 2 (tr U - 3).
constexpr bool stiffensWithStretch(std::string_view law) { return law != "linear" && law != "corotational"; }

}  // namespace ringwatch
