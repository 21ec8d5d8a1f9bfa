#include <ringwatch/monitor/bounds/factored_certificate.h>

#include <cmath>
#include <limits>
#include <vector>

#include <ringwatch/base/eigen_instances.h>
#include <ringwatch/base/error.h>

namespace ringwatch {

bool certifiesFrequency(const TangentSource& source, NodeVectorsView x, double sigma) {
  if (!(sigma > 0) || !std::isfinite(sigma)) return false;
  std::vector<Eigen::Index> row(static_cast<std::size_t>(3 * source.nodeCount()), -1);
  Eigen::Index n = 0;
  for (std::int32_t i = 0; i < source.nodeCount(); ++i)
    for (int c = 0; c < 3; ++c)
      if (!source.constraints().isConstrained(i, c)) row[3 * i + c] = n++;
  if (n == 0) return true;

  const Eigen::SparseMatrix<double> K = source.assembleTangent(x);
  const Eigen::VectorXd inverseRoot = source.lumpedMass().cwiseSqrt().cwiseInverse();
  std::vector<Eigen::Triplet<double>> entries;  // lower triangle of A
  entries.reserve(static_cast<std::size_t>(K.nonZeros() / 2 + n));
  Eigen::VectorXd rowSum = Eigen::VectorXd::Zero(n);
  double trace = static_cast<double>(n) * sigma;
  for (Eigen::Index j = 0; j < K.outerSize(); ++j) {
    const Eigen::Index to = row[j];
    if (to < 0) continue;
    for (Eigen::SparseMatrix<double>::InnerIterator at(K, j); at; ++at) {
      const Eigen::Index from = row[at.row()];
      if (from < 0) continue;
      const double value = at.value() * inverseRoot[at.row() / 3] * inverseRoot[j / 3];
      rowSum[from] += std::abs(value);
      if (from == to) trace += std::abs(value);
      if (from >= to) entries.emplace_back(from, to, -value);
    }
  }
  const double norm = rowSum.maxCoeff();
  if (!std::isfinite(rowSum.sum())) return false;
  const double units = (static_cast<double>(n) + 2) * 0.5 * std::numeric_limits<double>::epsilon();
  const double gamma = units / (1 - units), margin = 4 * gamma / (1 - gamma) * trace + 1e-12 * (norm + sigma);
  for (Eigen::Index i = 0; i < n; ++i) entries.emplace_back(i, i, sigma - margin);
  Eigen::SparseMatrix<double> A(n, n);
  A.setFromTriplets(entries.begin(), entries.end());
  entries = {};
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factor(A);
  // The factorisation itself only minds a pivot of zero.
  if (factor.info() != Eigen::Success) return false;
  const Eigen::VectorXd pivots = factor.vectorD();
  for (const double pivot : pivots)
    if (!(pivot > 0)) return false;
  return true;
}

bool certifies(const TangentSource& source, NodeVectorsView x, double h, double limit) {
  if (!(h > 0)) throw InputError(joinText("h = ", h, ": must be > 0"));
  if (!(limit > 0)) throw InputError(joinText("limit = ", limit, ": must be > 0"));
  return certifiesFrequency(source, x, limit * limit / (h * h));
}

}  // namespace ringwatch
