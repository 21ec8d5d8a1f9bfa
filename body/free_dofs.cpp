#include <ringwatch/body/free_dofs.h>

namespace ringwatch {

FreeDofs::FreeDofs(const Body& body) : number_(3 * body.nodeCount(), -1) {
  for (std::int32_t node = 0; node < body.nodeCount(); ++node)
    for (int c = 0; c < 3; ++c)
      if (!body.constraints().isConstrained(node, c)) number_[3 * node + c] = count_++;
}
Eigen::VectorXd FreeDofs::gather(const NodeVectors& values) const {
  Eigen::VectorXd result(count_);
  for (std::size_t i = 0; i < number_.size(); ++i)
    if (number_[i] >= 0) result[number_[i]] = values.data()[i];
  return result;
}
void FreeDofs::addTo(NodeVectors& values, const Eigen::VectorXd& change) const {
  for (std::size_t i = 0; i < number_.size(); ++i)
    if (number_[i] >= 0) values.data()[i] += change[number_[i]];
}
Eigen::SparseMatrix<double> FreeDofs::reduce(const Eigen::SparseMatrix<double>& K) const {
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(K.nonZeros());
  for (int column = 0; column < K.outerSize(); ++column)
    for (Eigen::SparseMatrix<double>::InnerIterator it(K, column); it; ++it) {
      const int i = (*this)[it.row()], j = (*this)[column];
      if (i >= 0 && j >= 0) entries.emplace_back(i, j, it.value());
    }
  Eigen::SparseMatrix<double> result(count_, count_);
  result.setFromTriplets(entries.begin(), entries.end());
  return result;
}

}  // namespace ringwatch
