#pragma once
#include <algorithm>
#include <cmath>
#include <vector>

#include <Eigen/Core>

namespace ringwatch {

/// The matrix T that a Lanczos iteration makes: symmetric and tridiagonal, alpha on its diagonal, beta beside it.
/// beta.back() belongs to the vector to come and lies outside.
struct LanczosMatrix {
  std::vector<double> alpha, beta;
  double radius = 0;  ///< no eigenvalue of T, with beta.back() in it, is larger in size: Gershgorin's discs

  void append(double a, double b) {
    radius = std::max(radius, std::abs(a) + b + (beta.empty() ? 0.0 : beta.back()));
    alpha.push_back(a);
    beta.push_back(b);
  }
  void clear() {
    alpha.clear();
    beta.clear();
    radius = 0;
  }
  Eigen::Index size() const { return static_cast<Eigen::Index>(alpha.size()); }
  Eigen::MatrixXd dense() const {
    Eigen::MatrixXd T = Eigen::MatrixXd::Zero(size(), size());
    for (Eigen::Index i = 0; i < size(); ++i) {
      T(i, i) = alpha[i];
      if (i + 1 < size()) T(i, i + 1) = T(i + 1, i) = beta[i];
    }
    return T;
  }
};

/// The Lanczos iteration of a symmetric matrix A, Golub & Van Loan (2013), algorithm 10.1.1, with full
/// orthogonalisation: for few steps, whose Ritz vectors stay what they claim to be. Vector: of any shape, the inner
/// product is the sum over its entries. The caller multiplies by A:
///
///   lanczos.begin(v);                           // |v| = 1
///   while (true) {
///     product = A * lanczos.current();
///     lanczos.advance(product);                 // matrix() has another row
///     if (enough) break;
///     lanczos.extend(product);
///   }
template <class Vector>
class Lanczos {
 public:
  void begin(const Vector& v) {
    basis_.assign(1, v);
    matrix_.clear();
  }
  /// The vector that is to be multiplied.
  const Vector& current() const { return basis_.back(); }
  /// product: A current(), which is made orthogonal to all vectors so far. What is left has the norm beta.back().
  void advance(Vector& product) {
    const double alpha = product.cwiseProduct(current()).sum();
    for (const Vector& q : basis_) product -= product.cwiseProduct(q).sum() * q;
    matrix_.append(alpha, product.norm());
  }
  /// Goes on with what advance() has left, which must not be zero.
  void extend(const Vector& product) { basis_.push_back(product / matrix_.beta.back()); }
  const LanczosMatrix& matrix() const { return matrix_; }
  /// Σ y_i q_i: the Ritz vector of an eigenvector y of the matrix.
  Vector combine(const Eigen::VectorXd& y) const {
    Vector sum = y[0] * basis_[0];
    for (Eigen::Index i = 1; i < y.size(); ++i) sum += y[i] * basis_[i];
    return sum;
  }

 private:
  std::vector<Vector> basis_;
  LanczosMatrix matrix_;
};

}  // namespace ringwatch
