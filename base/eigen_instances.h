#pragma once
#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/SparseCholesky>

/// Eigen's decompositions of dynamic size, compiled once in eigen_instances.cpp instead of in every file that uses
/// them, where each takes the compiler 2 to 10 s with AVX-512. Include this header in place of Eigen's own.
namespace Eigen {

extern template SelfAdjointEigenSolver<MatrixXd>& SelfAdjointEigenSolver<MatrixXd>::compute(const EigenBase<MatrixXd>&,
                                                                                            int);
extern template SelfAdjointEigenSolver<Matrix3d>& SelfAdjointEigenSolver<Matrix3d>::compute(const EigenBase<Matrix3d>&,
                                                                                            int);
extern template LLT<MatrixXd>& LLT<MatrixXd>::compute(const EigenBase<MatrixXd>&);

extern template class SimplicialCholeskyBase<SimplicialLLT<SparseMatrix<double>>>;
extern template class SimplicialCholeskyBase<SimplicialLDLT<SparseMatrix<double>>>;
extern template void SimplicialCholeskyBase<SimplicialLLT<SparseMatrix<double>>>::factorize_preordered<false>(
    const SparseMatrix<double>&);
extern template void SimplicialCholeskyBase<SimplicialLDLT<SparseMatrix<double>>>::factorize_preordered<true>(
    const SparseMatrix<double>&);
extern template class SimplicialLLT<SparseMatrix<double>>;
extern template class SimplicialLDLT<SparseMatrix<double>>;

}  // namespace Eigen
