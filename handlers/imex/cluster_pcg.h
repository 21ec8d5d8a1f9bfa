#pragma once
#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include <ringwatch/base/aligned.h>
#include <ringwatch/handlers/imex/cluster_matrix.h>

namespace ringwatch {

/// Conjugate gradients with block-Jacobi preconditioner over the free components of a matrix of 3×3 blocks, in numbers
/// of type S: the matrix is copied and, with vectors, scaled to the order of one, so that float neither over- nor
/// underflows. Solves for the difference from a first guess: what float rounds is that alone.
template <class S>
class ClusterPcg {
 public:
  /// constrained: [3 * row + component]. mass: what to divide the matrix by, kg. Results have the same bits for any
  /// number of threads.
  ClusterPcg(const UpperBlocks& A, std::vector<std::uint8_t> constrained, double mass, int threads = 1);

  /// Copies the rows that have changed and clears their marks.
  void refresh(const UpperBlocks& A, std::vector<std::uint8_t>& changed);
  struct Result {
    bool converged;
    int iterations;
  };
  /// Solves A u = right from u. Converged: the residual is at most `tolerance` times the right-hand side, both in the
  /// preconditioner's norm. Constrained components of right and u must be zero.
  Result solve(const Eigen::VectorXd& right, Eigen::VectorXd& u, double tolerance, int mostIterations);

  /// product = A u. Constrained components of u must be zero.
  void multiply(const Eigen::VectorXd& u, Eigen::VectorXd& product);

 private:
  static constexpr std::size_t stride = 12;  // numbers of a block: three columns of four
  void invert(const UpperBlocks& A, std::int32_t row);

  double scale_;
  int threads_;
  std::vector<std::uint8_t> constrained_;
  std::vector<std::size_t> order_;                 // of the rows in what follows
  std::vector<std::int32_t> rowBegin_, column_;    // of all blocks; four times the column
  std::vector<std::int32_t> ownPlace_, mirrored_;  // of the upper ones
  AlignedVector<S> blocks_, inverses_;             // by place, and of the diagonal ones by row
  AlignedVector<S> u_, r_, z_, p_, q_;             // four numbers a row
};

extern template class ClusterPcg<float>;
extern template class ClusterPcg<double>;

}  // namespace ringwatch
