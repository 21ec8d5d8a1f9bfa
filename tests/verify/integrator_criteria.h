#pragma once
#include <vector>

#include "criteria.h"

namespace ringwatch::test {

/// Of all integrators, quick.
inline std::vector<Criterion> commonIntegratorCriteria() {
  constexpr double bisected = 3e-10;  // of limits of at most 3, to 1e-10
  return {{"*: time advances by * relative error", 2e-14, Basis::rounding},
          {"*: limit on the *", bisected, Basis::rounding},
          {"*: limit at damping ratio *", bisected, Basis::rounding},
          {"*: largest energy drift of a scheme that loses energy", 3.5e-9, Basis::theory}};
}

/// Of the library's own explicit ones.
inline std::vector<Criterion> integratorCriteria() {
  std::vector<Criterion> all = commonIntegratorCriteria();
  constexpr double rounding = 1e-14;  // of steps at numbers of order one
  const std::vector<Criterion> own{
      {"*: trace and determinant of a step, against the declared amplification", rounding, Basis::rounding},
      {"*: components of 1100 nodes, each against one alone", rounding, Basis::rounding},
      {"*: forces at the times of their positions: *", rounding, Basis::rounding},
      {"*: what a step leaves: *", rounding, Basis::rounding},
      // What is left of the next order.
      {"*: order with forces of time that are not linear", 0.01, Basis::measured},
      {"*: order", 0.017, Basis::measured},
      {"*: order with damping", 0.0045, Basis::measured},
      {"*: forces a step", 0, Basis::theory},
      {"*: symplectic: |det - 1|", rounding, Basis::rounding},
      {"*: reversible: 100 steps and back", rounding, Basis::rounding},
      {"*: energy drift over 1e6 periods, by powers", 3.5e-9, Basis::rounding},  // of 1e7 steps
      {"*: energy drift over 1000 periods, by steps", 5e-14, Basis::rounding},   // a random walk
      // Bisected to 1e-4, over runs too short for growth just above the limit to show.
      {"*: critical step of real runs, *", 1e-3, Basis::measured}};
  all.insert(all.end(), own.begin(), own.end());
  return all;
}

}  // namespace ringwatch::test
