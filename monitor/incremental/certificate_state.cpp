#include <ringwatch/monitor/incremental/certificate_state.h>

#include <algorithm>
#include <cmath>

#include <ringwatch/base/eigen_instances.h>
#include <ringwatch/base/infinity.h>
#include <ringwatch/base/short_floats.h>
#include <ringwatch/body/discrete_forces.h>
#include <ringwatch/body/domain.h>
#include <ringwatch/monitor/bounds/scaled_tangent.h>

namespace ringwatch {

double largestEigenvalue(const Eigen::Matrix3d& S) {
  Eigen::Matrix3d A = S;
  double work[12];
  const auto extremes = extremeEigenvalues(A.data(), 3, work, false);
  return extremes.largest + eigenvalueRounding * extremes.scale;
}

double largestScaling(const Eigen::Matrix3d& base, const Eigen::Matrix3d& part, double sigma) {
  const Eigen::LLT<Eigen::Matrix3d> factor(sigma * Eigen::Matrix3d::Identity() - base);
  if (factor.info() != Eigen::Success) return 0;
  const Eigen::Matrix3d half = factor.matrixL().solve(part);
  const double top = largestEigenvalue(factor.matrixL().solve(half.transpose()));
  return top > 0 ? 1 / (top * (1 + allowanceRounding)) : infinity;
}

void evaluateElements(const Body& body, const NodalBound& weights, NodeVectorsView x, std::int32_t b,
                      const std::int32_t* elements, double* values, double* norms) {
  const ElementBlock& block = *body.blocks()[b];
  NativePack K[9 * maxElementNodes * maxElementNodes], A[9 * maxElementNodes * maxElementNodes];
  NativePack ofTangent[maxElementNodes], ofLaplacian[maxElementNodes];
  NodalBound::ElementMatrices sets[2];
  std::size_t count = 0;
  if (values) {
    block.tangentOf(elements, x.data(), reinterpret_cast<double*>(K), reinterpret_cast<double*>(ofTangent));
    sets[count++] = {K, ofTangent, values};
  }
  if (norms) {
    const int n = block.nodesPerElement(), size = 3 * n;
    NativePack L[maxElementNodes * maxElementNodes];
    block.laplacianOf(elements, reinterpret_cast<double*>(L), reinterpret_cast<double*>(ofLaplacian));
    for (int i = 0; i < size; ++i)
      for (int j = 0; j < size; ++j) A[i * size + j] = i % 3 == j % 3 ? L[i / 3 * n + j / 3] : NativePack(0.0);
    sets[count++] = {A, ofLaplacian, norms};
  }
  weights.weightedLargest(b, elements, {sets, count});
}

template <class Allowance>
CertificateState<Allowance>::CertificateState(const Body& body) : body_(body), weights_(body) {
  weights_.setDomain(body.domain());
  for (const auto& block : body.blocks()) allowances_.emplace_back(block->layout().elements.size());
}

template <class Allowance>
void CertificateState<Allowance>::allowRotations() {
  for (const auto& own : allowances_) rotations_.emplace_back(own.size(), Eigen::Matrix3d::Identity());
}

template <class Allowance>
Eigen::Matrix3d CertificateState<Allowance>::sumOfAllowances(std::int32_t node) const {
  return freePart(body_, node, weights_.majorantAt(node) + sumOfElements(node));
}

template <class Allowance>
Eigen::Matrix3d CertificateState<Allowance>::sumOfElements(std::int32_t node) const {
  Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
  for (const NodalBound::Incidence at : weights_.incidences(node)) {
    const ElementRef e = weights_.elementAt(at);
    if (excluded(e)) continue;
    if (rotations_.empty())
      sum += allowance(e) * weights_.weight(at);
    else
      sum += allowance(e) * (rotation(e) * weights_.weight(at) * rotation(e).transpose());
  }
  return sum;
}

template <class Allowance>
double CertificateState<Allowance>::verify(NodeVectorsView x) const {
  double excess = -1;
  for (std::size_t b = 0; b < body_.blocks().size(); ++b) {
    const ElementBlock& block = *body_.blocks()[b];
    const int n = block.nodesPerElement(), size = 3 * n;
    AlignedVector<NativePack> K(size * size), T(n);
    for (std::int32_t e = 0; e < block.elementCount(); ++e) {
      const ElementRef element{b, e};
      if (excluded(element)) continue;
      std::int32_t elements[lanes];
      std::fill(elements, elements + lanes, -1);
      elements[0] = e;
      block.tangentOf(elements, x.data(), reinterpret_cast<double*>(K.data()), reinterpret_cast<double*>(T.data()));
      if (!rotations_.empty()) {
        // The eigenvalues of (R D Rᵀ)⁻¹K are those of D⁻¹ RᵀKR.
        const Eigen::Matrix3d& R = rotation(element);
        for (int a = 0; a < n; ++a)
          for (int c = 0; c < n; ++c) {
            Eigen::Matrix3d own;
            for (int i = 0; i < 9; ++i) own(i / 3, i % 3) = K[(3 * a + i / 3) * size + 3 * c + i % 3][0];
            own = R.transpose() * own * R;
            for (int i = 0; i < 9; ++i) K[(3 * a + i / 3) * size + 3 * c + i % 3].set(0, own(i / 3, i % 3));
          }
      }
      double value[lanes];
      const NodalBound::ElementMatrices tangent{K.data(), T.data(), value};
      weights_.weightedLargest(element.block, elements, {&tangent, 1});
      if (std::isnan(value[0])) excess = infinity;
      if (value[0] > 0) excess = std::max(excess, value[0] / allowance(element) - 1);
    }
  }
  if (const DiscreteForces* discrete = body_.discreteForces()) {
    std::vector<Eigen::Matrix3d> needed;
    discrete->majorants(x, false, needed);
    for (std::size_t k = 0; k < needed.size(); ++k) {
      const double lacking = largestEigenvalue(needed[k] - weights_.majorants()[k]);
      if (lacking > 0) excess = std::max(excess, lacking / needed[k].trace());
    }
  }
  Domain& domain = body_.domain();
  for (std::int32_t node = 0; node < domain.owned(body_.nodeCount()); ++node)
    excess = std::max(excess,
                      largestEigenvalue(sumOfAllowances(node) / body_.lumpedMass()[node]) / certifiedEigenvalue_ - 1);
  domain.largest({&excess, 1});
  return excess;
}

template class CertificateState<RoundedDown<float>>;
template class CertificateState<double>;

}  // namespace ringwatch
