#pragma once
#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <Eigen/SparseCholesky>

/// Eigen's products and decompositions of dynamic size, compiled once in eigen_instances.cpp instead of in every file
/// that uses them, where each takes the compiler 1 to 10 s with AVX-512. Include this header in place of Eigen's own.
#define RINGWATCH_EIGEN_INSTANCES(storage)                                                                             \
  namespace Eigen {                                                                                                    \
  namespace internal {                                                                                                 \
  storage template struct gebp_kernel<double, double, Index, blas_data_mapper<double, Index, ColMajor>,                \
                                      gebp_traits<double, double>::mr, gebp_traits<double, double>::nr, false, false>; \
  storage template struct gemm_pack_lhs<double, Index, const_blas_data_mapper<double, Index, ColMajor>,                \
                                        gebp_traits<double, double>::mr, gebp_traits<double, double>::LhsProgress,     \
                                        gebp_traits<double, double>::LhsPacket4Packing, ColMajor>;                     \
  storage template struct gemm_pack_lhs<double, Index, const_blas_data_mapper<double, Index, RowMajor>,                \
                                        gebp_traits<double, double>::mr, gebp_traits<double, double>::LhsProgress,     \
                                        gebp_traits<double, double>::LhsPacket4Packing, RowMajor>;                     \
  storage template struct gemm_pack_rhs<double, Index, const_blas_data_mapper<double, Index, ColMajor>,                \
                                        gebp_traits<double, double>::nr, ColMajor>;                                    \
  storage template struct gemm_pack_rhs<double, Index, const_blas_data_mapper<double, Index, RowMajor>,                \
                                        gebp_traits<double, double>::nr, RowMajor>;                                    \
  storage template struct general_matrix_vector_product<                                                               \
      Index, double, const_blas_data_mapper<double, Index, ColMajor>, ColMajor, false, double,                         \
      const_blas_data_mapper<double, Index, RowMajor>, false>;                                                         \
  storage template struct general_matrix_vector_product<                                                               \
      Index, double, const_blas_data_mapper<double, Index, RowMajor>, RowMajor, false, double,                         \
      const_blas_data_mapper<double, Index, ColMajor>, false>;                                                         \
  }                                                                                                                    \
  storage template SelfAdjointEigenSolver<MatrixXd>& SelfAdjointEigenSolver<MatrixXd>::compute(                        \
      const EigenBase<MatrixXd>&, int);                                                                                \
  storage template SelfAdjointEigenSolver<Matrix3d>& SelfAdjointEigenSolver<Matrix3d>::compute(                        \
      const EigenBase<Matrix3d>&, int);                                                                                \
  storage template LLT<MatrixXd>& LLT<MatrixXd>::compute(const EigenBase<MatrixXd>&);                                  \
  storage template class SimplicialCholeskyBase<SimplicialLLT<SparseMatrix<double>>>;                                  \
  storage template class SimplicialCholeskyBase<SimplicialLDLT<SparseMatrix<double>>>;                                 \
  storage template void SimplicialCholeskyBase<SimplicialLLT<SparseMatrix<double>>>::factorize_preordered<false>(      \
      const SparseMatrix<double>&);                                                                                    \
  storage template void SimplicialCholeskyBase<SimplicialLDLT<SparseMatrix<double>>>::factorize_preordered<true>(      \
      const SparseMatrix<double>&);                                                                                    \
  storage template class SimplicialLLT<SparseMatrix<double>>;                                                          \
  storage template class SimplicialLDLT<SparseMatrix<double>>;                                                         \
  }

RINGWATCH_EIGEN_INSTANCES(extern)
