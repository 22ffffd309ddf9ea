/// \file eigenvalues.hpp
/// The eigenvalues of a matrix, for tests that look at them: Eigen's solvers take long to compile, so they are once.
#pragma once

#include "common/math.hpp"

namespace rigid {

/// Of any square matrix, in no order.
Eigen::VectorXcd eigenvalues(const MatX& matrix);

/// Of a symmetric matrix, the smallest first; only its lower triangle is read.
VecX symmetric_eigenvalues(const MatX& matrix);

}  // namespace rigid
