#pragma once
#include <vector>

#include <Eigen/SparseCore>

#include <ringwatch/body/body.h>

namespace ringwatch {

/// Free degrees of freedom of a body, numbered 0, 1, … in order; constrained ones have -1.
class FreeDofs {
 public:
  explicit FreeDofs(const Body& body);
  int count() const { return count_; }
  int operator[](Eigen::Index dof) const { return number_[dof]; }
  /// The free entries of a 3×N array.
  Eigen::VectorXd gather(const NodeVectors& values) const;
  /// Adds to the free entries of a 3×N array.
  void addTo(NodeVectors& values, const Eigen::VectorXd& change) const;
  /// Rows and columns of the free degrees of freedom.
  Eigen::SparseMatrix<double> reduce(const Eigen::SparseMatrix<double>& K) const;

 private:
  std::vector<int> number_;
  int count_ = 0;
};

}  // namespace ringwatch
