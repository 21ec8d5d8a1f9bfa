#pragma once
#include <span>
#include <string_view>
#include <vector>

#include <Eigen/Core>

#include <ringwatch/body/body.h>

namespace ringwatch {

/// What an element bears in a state.
struct ElementStress {
  Eigen::Matrix3d cauchy;              ///< Pa, the mean of the element as it is (ElementBlock::stressBatch)
  std::span<const Eigen::Matrix3d> F;  ///< at its quadrature points
  Eigen::Matrix3d greenStrain;         ///< E = (FᵀF - 1)/2, the mean over these points by their weights in the rule
};

/// One number or several that tell of it.
struct StressMeasure {
  std::string_view name;   ///< in scenes: "von_mises"
  std::string_view title;  ///< in files, with its unit: "von Mises stress (Pa)"
  std::string_view help;
  int components;                                             ///< at most 6
  void (*of)(const ElementStress& element, double* numbers);  ///< numbers[components]
};
/// Every measure, one line each.
std::span<const StressMeasure> allStressMeasures();
/// nullptr when there is none of that name.
const StressMeasure* findStressMeasure(std::string_view name);

/// Measures of each element of a body at positions x (3×N, m), values[measure][element * components + component],
/// elements in the order of blocks; the same bits for any number of threads. Stresses are not numbers where the
/// element's volume at x is not positive or its law knows no stress.
std::vector<std::vector<double>> stressOfElements(const Body& body, NodeVectorsView x,
                                                  std::span<const StressMeasure* const> measures);

}  // namespace ringwatch
