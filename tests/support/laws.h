#pragma once
#include <ringwatch/materials/registry.h>

namespace ringwatch::test {

/// The law L with Young's modulus (Pa) and Poisson's ratio at rest; one that has an axis is that stiff across it, twice
/// as stiff along it, and turned.
template <class L>
L lawOf(double young, double poisson) {
  Options parameters = L::parametersFor(young, poisson);
  if constexpr (!L::isotropic) {
    parameters.set("young_axial", 2 * young).set("shear_axial", 0.7 * parameters.number("shear_axial"));
    parameters.set("axis_x", 1.0).set("axis_y", -2.0).set("axis_z", 0.5);
  }
  return L::of(parameters);
}

}  // namespace ringwatch::test
