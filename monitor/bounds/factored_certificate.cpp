#include <ringwatch/monitor/bounds/factored_certificate.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include <ringwatch/base/eigen_instances.h>
#include <ringwatch/base/infinity.h>
#include <ringwatch/base/rounding.h>

namespace ringwatch {
namespace {

using SparseMatrix = Eigen::SparseMatrix<double>;

/// LDLᵀ that tells what it takes.
class Factor : public Eigen::SimplicialLDLT<SparseMatrix> {
 public:
  FactorisationCost cost() const {
    FactorisationCost cost{0, 0, 0};
    for (const SparseMatrix::StorageIndex below : m_nonZerosPerCol) {
      const auto count = static_cast<double>(below);
      cost.numbers += count;
      cost.operations += count * (count + 3);
    }
    cost.bytes = cost.numbers * (sizeof(double) + sizeof(SparseMatrix::StorageIndex));
    return cost;
  }
  /// Most entries in a row, diagonal included, counted by the elimination tree: the columns of row k are the nodes on
  /// the ways from its entries up to k.
  Eigen::Index longestRow(const SparseMatrix& lower) const {
    const Eigen::Index n = lower.rows();
    std::vector<std::vector<Eigen::Index>> entries(n);  // of the ordered matrix, by row
    for (Eigen::Index j = 0; j < n; ++j)
      for (SparseMatrix::InnerIterator at(lower, j); at; ++at) {
        const Eigen::Index a = m_P.indices()[at.row()], b = m_P.indices()[j];
        if (a != b) entries[std::max(a, b)].push_back(std::min(a, b));
      }
    std::vector<Eigen::Index> reachedBy(n, -1);
    Eigen::Index most = 1;
    for (Eigen::Index k = 0; k < n; ++k) {
      Eigen::Index count = 1;
      reachedBy[k] = k;
      for (Eigen::Index i : entries[k])
        for (; reachedBy[i] != k; i = m_parent[i]) {
          reachedBy[i] = k;
          ++count;
        }
      most = std::max(most, count);
    }
    return most;
  }
};

}  // namespace

struct FactoredCertificate::Impl {
  Eigen::Index n = 0;
  bool finite = true;
  SparseMatrix scaled;      // -M^-½ K M^-½, lower triangle, with a whole diagonal
  Eigen::VectorXd own;      // its diagonal
  Eigen::VectorXd margins;  // what the tangents of elements err by at each row, rad²/s²
  double norm = 0, absoluteTrace = 0;
  Eigen::Index longestRow = 0;
  Factor factor;

  /// Of rounding in the factorisation and in the scaled matrix, at every row alike.
  double rounding(double sigma) const {
    const double units = (static_cast<double>(longestRow) + 2) * unitRoundoff, gamma = units / (1 - units);
    return pivotBounds * gamma / (1 - gamma) * (static_cast<double>(n) * sigma + absoluteTrace) +
           assemblyRounding * (norm + sigma);
  }
};

FactoredCertificate::FactoredCertificate(FactoredCertificate&&) noexcept = default;
FactoredCertificate& FactoredCertificate::operator=(FactoredCertificate&&) noexcept = default;
FactoredCertificate::~FactoredCertificate() = default;

FactoredCertificate::FactoredCertificate(const TangentSource& source, NodeVectorsView x)
    : impl_(std::make_unique<Impl>()) {
  source.checkNodal("x", x);
  Impl& my = *impl_;
  std::vector<Eigen::Index> row(3 * source.nodeCount(), -1);
  for (std::int32_t i = 0; i < source.nodeCount(); ++i)
    for (int c = 0; c < 3; ++c)
      if (!source.constraints().isConstrained(i, c)) row[3 * i + c] = my.n++;
  if (my.n == 0) return;

  const SparseMatrix K = source.assembleTangent(x);
  const Eigen::VectorXd inverseRoot = source.lumpedMass().cwiseSqrt().cwiseInverse();
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(K.nonZeros() / 2 + my.n);
  Eigen::VectorXd rowSum = Eigen::VectorXd::Zero(my.n);
  for (Eigen::Index j = 0; j < K.outerSize(); ++j) {
    const Eigen::Index to = row[j];
    if (to < 0) continue;
    for (SparseMatrix::InnerIterator at(K, j); at; ++at) {
      const Eigen::Index from = row[at.row()];
      if (from < 0) continue;
      const double value = at.value() * inverseRoot[at.row() / 3] * inverseRoot[j / 3];
      rowSum[from] += std::abs(value);
      if (from == to) my.absoluteTrace += std::abs(value);
      if (from >= to) entries.emplace_back(from, to, -value);
    }
  }
  for (Eigen::Index i = 0; i < my.n; ++i) entries.emplace_back(i, i, 0.0);  // nodes without elements have no entry
  my.scaled.resize(my.n, my.n);
  my.scaled.setFromTriplets(entries.begin(), entries.end());
  entries = {};
  my.own = my.scaled.diagonal();

  TangentSource::Workspace workspace;
  const Eigen::VectorXd tau = source.tangentRounding(x, workspace);
  const int mostNodes = source.mostNodesOfAnElement();
  my.margins.resize(my.n);
  for (std::size_t d = 0; d < row.size(); ++d)
    if (row[d] >= 0) {
      const Eigen::Index node = d / 3;
      my.margins[row[d]] = mostNodes * tau[node] / source.lumpedMass()[node];
    }
  my.norm = rowSum.maxCoeff();
  my.finite = std::isfinite(rowSum.sum()) && my.margins.allFinite();
  my.factor.analyzePattern(my.scaled);
  my.longestRow = my.factor.longestRow(my.scaled);
}

FactorisationCost FactoredCertificate::cost() const {
  const Impl& my = *impl_;
  FactorisationCost cost = my.factor.cost();
  // The matrix, its copy with sigma on the diagonal and the one in the order of the factor.
  cost.bytes += 3 * static_cast<double>(my.scaled.nonZeros()) * (sizeof(double) + sizeof(SparseMatrix::StorageIndex));
  return cost;
}

double FactoredCertificate::margin(double sigma) const {
  const Impl& my = *impl_;
  if (my.n == 0) return 0;
  if (!my.finite) return infinity;
  return my.margins.maxCoeff() + my.rounding(sigma);
}

bool FactoredCertificate::certifies(double sigma) {
  Impl& my = *impl_;
  if (!(sigma > 0) || !std::isfinite(sigma) || !my.finite) return false;
  if (my.n == 0) return true;
  SparseMatrix A = my.scaled;
  A.diagonal() = (my.own - my.margins).array() + (sigma - my.rounding(sigma));
  my.factor.factorize(A);
  // The factorisation itself only minds a pivot of zero.
  if (my.factor.info() != Eigen::Success) return false;
  const Eigen::VectorXd pivots = my.factor.vectorD();
  return std::all_of(pivots.begin(), pivots.end(), [](double pivot) { return pivot > 0; });
}

}  // namespace ringwatch
