// The functions of conjugate_gradients.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/04_pgs/conjugate_gradients.hpp"

namespace rigid {

void multiply(const SparseMatrix& A, const VecX& x, VecX& y)
{
    y.resize(A.rows());
    for (Index i = 0; i < A.rows(); ++i) {
        Real sum = 0;
        for (SparseMatrix::InnerIterator entry(A, i); entry; ++entry)
            sum += entry.value() * x[entry.col()];
        y[i] = sum;
    }
}

void conjugate_gradients(const Mlcp& mlcp, Real tolerance, int max_iterations,
                         CgMemory& memory, Solution& solution)
{
    require_valid(mlcp);
    require_tolerance("conjugate gradients", tolerance);
    if (max_iterations < 0)
        throw std::invalid_argument("the limit of iterations is " +
                                    std::to_string(max_iterations) +
                                    "; it must be zero or positive");
    const Index n = mlcp.size();
    for (Index i = 0; i < n; ++i)
        if (mlcp.lo[i] > -infinity || mlcp.hi[i] < infinity)
            throw std::invalid_argument(
                "row " + std::to_string(i) +
                " has a bound; conjugate gradients take bilateral rows only");
    if (solution.lambda.size() != n || !solution.lambda.allFinite())
        throw std::invalid_argument("the start of conjugate gradients must have " +
                                    std::to_string(n) + " finite impulses");
    auto& [r, y, p, Ap, inverse_diagonal] = memory;
    inverse_diagonal.resize(n);
    for (Index i = 0; i < n; ++i) {
        const Real a = mlcp.A.coeff(i, i);
        inverse_diagonal[i] = 1 / (a > 0 ? a : 1);
    }
    VecX& lambda = solution.lambda;
    solution.status = Status::iteration_limit;

    //! [cg]
    multiply(mlcp.A, lambda, Ap);
    r = -(Ap + mlcp.q);  // minus the gradient of the merit: −w
    p = inverse_diagonal.cwiseProduct(r);
    Real slope = r.dot(p);
    int k = 0;
    for (; k < max_iterations && r.lpNorm<Eigen::Infinity>() > tolerance; ++k) {
        multiply(mlcp.A, p, Ap);
        const Real curvature = p.dot(Ap);
        if (!(curvature > 0)) {  // the merit falls without end along p
            solution.status = Status::singular;
            break;
        }
        const Real alpha = slope / curvature;  // (4.21): the lowest point along p
        lambda += alpha * p;
        r -= alpha * Ap;
        y = inverse_diagonal.cwiseProduct(r);
        const Real next_slope = r.dot(y);
        // (4.22): conjugate to all directions so far
        p = y + (next_slope / slope) * p;
        slope = next_slope;
    }
    //! [cg]

    solution.iterations = k;
    // of the answer itself, not of the recurrence
    solution.residual = natural_residual(mlcp, lambda);
    // and if it can't be trusted, λ is as good as infinite
    if (solution.residual <= tolerance)
        solution.status = verify(mlcp, lambda, {0, tolerance}).solved
                              ? Status::solved
                              : Status::singular;
    if (!std::isfinite(solution.residual)) {
        lambda.setZero();
        solution.residual = natural_residual(mlcp, lambda);
        solution.status = Status::singular;
    }
}

Solution conjugate_gradients(const Mlcp& mlcp, Real tolerance, int max_iterations)
{
    CgMemory memory;
    Solution solution;
    solution.lambda.setZero(mlcp.size());
    conjugate_gradients(mlcp, tolerance, max_iterations, memory, solution);
    return solution;
}

}  // namespace rigid
