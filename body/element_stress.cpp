#include <ringwatch/body/element_stress.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include <ringwatch/base/eigen_instances.h>
#include <ringwatch/base/parallel.h>

namespace ringwatch {
namespace {

double largestEigenvalue(const Eigen::Matrix3d& symmetric) {
  if (!symmetric.allFinite()) return std::numeric_limits<double>::quiet_NaN();
  return Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(symmetric, Eigen::EigenvaluesOnly).eigenvalues()[2];
}

double vonMisesStress(const ElementStress& element) {
  const Eigen::Matrix3d deviator = element.cauchy - element.cauchy.trace() / 3 * Eigen::Matrix3d::Identity();
  return std::sqrt(1.5) * deviator.norm();
}

double pressure(const ElementStress& element) { return -element.cauchy.trace() / 3; }

double largestPrincipalStress(const ElementStress& element) { return largestEigenvalue(element.cauchy); }

double largestStretch(const ElementStress& element) {
  double largest = 0;  // squared
  for (const Eigen::Matrix3d& F : element.F) {
    const double own = largestEigenvalue(F.transpose() * F);
    if (!(own <= largest)) largest = own;
    if (std::isnan(own)) break;
  }
  return std::sqrt(largest);
}

constexpr StressMeasure measuresOfElements[] = {
    {"von_mises", "von Mises stress (Pa)", "√(3/2 s:s), s the deviator of the element's mean Cauchy stress σ",
     vonMisesStress},
    {"pressure", "pressure (Pa)", "-tr σ / 3, positive where the element is pressed together", pressure},
    {"max_principal_stress", "largest principal stress (Pa)", "largest eigenvalue of σ", largestPrincipalStress},
    {"max_stretch", "largest stretch", "largest principal stretch at a quadrature point of the element",
     largestStretch},
};

}  // namespace

std::span<const StressMeasure> allStressMeasures() { return measuresOfElements; }

const StressMeasure* findStressMeasure(std::string_view name) {
  const auto found = std::ranges::find(measuresOfElements, name, &StressMeasure::name);
  return found == std::end(measuresOfElements) ? nullptr : &*found;
}

std::vector<std::vector<double>> stressOfElements(const Body& body, NodeVectorsView x,
                                                  std::span<const StressMeasure* const> measures) {
  std::vector<std::vector<double>> values(measures.size(), std::vector<double>(body.mesh().elementCount()));
  std::size_t first = 0;
  for (const auto& each : body.blocks()) {
    const ElementBlock& block = *each;
    const std::size_t points = block.rule().points.size();
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
        for (std::size_t m = 0; m < measures.size(); ++m)
          values[m][first + static_cast<std::size_t>(element)] = measures[m]->of(own);
      }
    });
    first += static_cast<std::size_t>(block.elementCount());
  }
  return values;
}

}  // namespace ringwatch
