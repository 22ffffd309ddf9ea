#include "tests/eigenvalues.hpp"

#include <Eigen/Eigenvalues>

namespace rigid {

Eigen::VectorXcd eigenvalues(const MatX& matrix)
{
    return Eigen::EigenSolver<MatX>(matrix, false).eigenvalues();
}

VecX symmetric_eigenvalues(const MatX& matrix)
{
    return Eigen::SelfAdjointEigenSolver<MatX>(matrix, Eigen::EigenvaluesOnly).eigenvalues();
}

}  // namespace rigid
