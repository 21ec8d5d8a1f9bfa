#include <ringwatch/body/element_stress.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include <ringwatch/base/eigen_instances.h>
#include <ringwatch/base/parallel.h>

namespace ringwatch {
namespace {

/// Ascending; not numbers where an entry is none.
Eigen::Vector3d eigenvaluesOf(const Eigen::Matrix3d& symmetric) {
  if (!symmetric.allFinite()) return Eigen::Vector3d::Constant(std::numeric_limits<double>::quiet_NaN());
  return Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(symmetric, Eigen::EigenvaluesOnly).eigenvalues();
}

/// In the order of VTK and ParaView.
void components(const Eigen::Matrix3d& symmetric, double* numbers) {
  constexpr int order[6][2] = {{0, 0}, {1, 1}, {2, 2}, {0, 1}, {1, 2}, {0, 2}};
  for (int i = 0; i < 6; ++i) numbers[i] = symmetric(order[i][0], order[i][1]);
}

/// The largest first.
void principalValues(const Eigen::Matrix3d& symmetric, double* numbers) {
  const Eigen::Vector3d values = eigenvaluesOf(symmetric);
  for (int i = 0; i < 3; ++i) numbers[i] = values[2 - i];
}

void vonMisesStress(const ElementStress& element, double* number) {
  const Eigen::Matrix3d deviator = element.cauchy - element.cauchy.trace() / 3 * Eigen::Matrix3d::Identity();
  *number = std::sqrt(1.5) * deviator.norm();
}

void pressure(const ElementStress& element, double* number) { *number = -element.cauchy.trace() / 3; }

void largestPrincipalStress(const ElementStress& element, double* number) {
  *number = eigenvaluesOf(element.cauchy)[2];
}

void largestStretch(const ElementStress& element, double* number) {
  double largest = 0;  // squared
  for (const Eigen::Matrix3d& F : element.F) {
    const double own = eigenvaluesOf(F.transpose() * F)[2];
    if (!(own <= largest)) largest = own;
    if (std::isnan(own)) break;
  }
  *number = std::sqrt(largest);
}

void cauchyStress(const ElementStress& element, double* numbers) { components(element.cauchy, numbers); }
void principalStresses(const ElementStress& element, double* numbers) { principalValues(element.cauchy, numbers); }
void greenStrain(const ElementStress& element, double* numbers) { components(element.greenStrain, numbers); }
void principalStrains(const ElementStress& element, double* numbers) { principalValues(element.greenStrain, numbers); }

constexpr StressMeasure measuresOfElements[] = {
    {"von_mises", "von Mises stress (Pa)", "√(3/2 s:s), s the deviator of the element's mean Cauchy stress σ", 1,
     vonMisesStress},
    {"pressure", "pressure (Pa)", "-tr σ / 3, positive where the element is pressed together", 1, pressure},
    {"max_principal_stress", "largest principal stress (Pa)", "largest eigenvalue of σ", 1, largestPrincipalStress},
    {"max_stretch", "largest stretch", "largest principal stretch at a quadrature point of the element", 1,
     largestStretch},
    {"cauchy_stress", "Cauchy stress (Pa)", "σ: xx, yy, zz, xy, yz, xz", 6, cauchyStress},
    {"principal_stresses", "principal stresses (Pa)", "eigenvalues of σ, the largest first", 3, principalStresses},
    {"green_strain", "Green strain", "E = (FᵀF - 1)/2, mean over the quadrature points: xx, yy, zz, xy, yz, xz", 6,
     greenStrain},
    {"principal_strains", "principal Green strains", "eigenvalues of E, the largest first", 3, principalStrains},
};

}  // namespace

std::span<const StressMeasure> allStressMeasures() { return measuresOfElements; }

const StressMeasure* findStressMeasure(std::string_view name) {
  const auto found = std::ranges::find(measuresOfElements, name, &StressMeasure::name);
  return found == std::end(measuresOfElements) ? nullptr : &*found;
}

std::vector<std::vector<double>> stressOfElements(const Body& body, NodeVectorsView x,
                                                  std::span<const StressMeasure* const> measures) {
  std::vector<std::vector<double>> values;
  for (const StressMeasure* measure : measures)
    values.emplace_back(body.mesh().elementCount() * static_cast<std::size_t>(measure->components));
  std::size_t first = 0;
  for (const auto& each : body.blocks()) {
    const ElementBlock& block = *each;
    const std::size_t points = block.rule().points.size();
    double weights = 0;
    for (const QuadraturePoint& point : block.rule().points) weights += point.weight;
    parallelFor(0, block.layout().batchCount(), body.threads(), [&](std::int64_t batch) {
      std::vector<double> gradients(9 * points * lanes);
      double stresses[6 * lanes];
      block.stressBatch(static_cast<std::int32_t>(batch), x.data(), stresses, gradients.data());
      std::vector<Eigen::Matrix3d> F(points);
      for (int lane = 0; lane < lanes; ++lane) {
        const std::int32_t element = block.layout().elements[batch * lanes + lane];
        if (element < 0) continue;
        const auto stress = [&](int i) { return stresses[i * lanes + lane]; };
        ElementStress own;
        own.cauchy << stress(0), stress(5), stress(4), stress(5), stress(1), stress(3), stress(4), stress(3), stress(2);
        for (std::size_t q = 0; q < points; ++q)
          for (std::size_t i = 0; i < 9; ++i)
            F[q](static_cast<Eigen::Index>(i / 3), static_cast<Eigen::Index>(i % 3)) =
                gradients[(9 * q + i) * lanes + static_cast<std::size_t>(lane)];
        own.F = F;
        own.greenStrain.setZero();
        for (std::size_t q = 0; q < points; ++q)
          own.greenStrain +=
              block.rule().points[q].weight / weights * (0.5 * (F[q].transpose() * F[q] - Eigen::Matrix3d::Identity()));
        for (std::size_t m = 0; m < measures.size(); ++m)
          measures[m]->of(own, values[m].data() + (first + static_cast<std::size_t>(element)) *
                                                      static_cast<std::size_t>(measures[m]->components));
      }
    });
    first += static_cast<std::size_t>(block.elementCount());
  }
  return values;
}

}  // namespace ringwatch
