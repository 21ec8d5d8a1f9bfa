#include <ringwatch/base/eigen_instances.h>

namespace Eigen {

template SelfAdjointEigenSolver<MatrixXd>& SelfAdjointEigenSolver<MatrixXd>::compute(const EigenBase<MatrixXd>&, int);
template SelfAdjointEigenSolver<Matrix3d>& SelfAdjointEigenSolver<Matrix3d>::compute(const EigenBase<Matrix3d>&, int);
template LLT<MatrixXd>& LLT<MatrixXd>::compute(const EigenBase<MatrixXd>&);

template class SimplicialCholeskyBase<SimplicialLLT<SparseMatrix<double>>>;
template class SimplicialCholeskyBase<SimplicialLDLT<SparseMatrix<double>>>;
template void SimplicialCholeskyBase<SimplicialLLT<SparseMatrix<double>>>::factorize_preordered<false>(
    const SparseMatrix<double>&);
template void SimplicialCholeskyBase<SimplicialLDLT<SparseMatrix<double>>>::factorize_preordered<true>(
    const SparseMatrix<double>&);
template class SimplicialLLT<SparseMatrix<double>>;
template class SimplicialLDLT<SparseMatrix<double>>;

}  // namespace Eigen
