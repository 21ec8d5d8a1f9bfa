#pragma once
#include <array>
#include <string>
#include <vector>

#include "ball.h"

/// The tangent of one element in ball arithmetic, from the formulas of the books and from nothing of ringwatch.
namespace check {

using Matrix = std::array<std::array<Ball, 3>, 3>;
/// A square matrix, row by row.
struct Square {
  int size;
  std::vector<Ball> entries;
  explicit Square(int n) : size(n), entries(static_cast<std::size_t>(n) * static_cast<std::size_t>(n)) {}
  Ball& operator()(int i, int j) { return entries[i * size + j]; }
  const Ball& operator()(int i, int j) const { return entries[i * size + j]; }
};

/// The lower triangle of a symmetric matrix: of each row the entries from the first that is not zero to the diagonal.
using Rows = std::vector<std::vector<Ball>>;

/// Elements of one kind: shape, law, Lamé's constants, and the quadrature rule with its points, in exact doubles.
struct Kind {
  std::string element, law;
  double lambda = 0, mu = 0;
  /// Shares of lambda and mu at the points and at the mean deformation gradient.
  double pointLambda = 1, pointMu = 1, meanLambda = 0, meanMu = 0;
  std::vector<std::array<double, 4>> points;  // natural coordinates and weight
};

/// Nodes of an element by name; 0 for a name that is not known.
int nodesOf(const std::string& element);
bool knowsLaw(const std::string& law);
/// K of an element with reference positions X and positions x, three numbers a node, in balls. False where it cannot be
/// enclosed: a Jacobian or a law that has no value there. volume: of the element at rest, to rounding.
bool elementTangent(const Kind& kind, const double* X, const double* x, Square& K, double& volume);
/// Whether a symmetric matrix A is proven positive definite. For any lower triangular L of exact numbers L Lᵀ is
/// positive semidefinite, and so A is definite where A - L Lᵀ is: each diagonal entry exceeds the sizes of all others
/// of its row. L is the Cholesky factor, rounded, of A less 2^-54 of its diagonal. A is overwritten.
bool positiveDefinite(Rows& A);

}  // namespace check
