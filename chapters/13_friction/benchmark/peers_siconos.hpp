/// \file peers_siconos.hpp
/// Siconos' planar friction solvers on A, q and μ of this chapter: each contact a normal row and, behind it, its friction.
#pragma once

#include "chapters/13_friction/coulomb_residual.hpp"

#include <FrictionContactProblem.h>
#include <Friction_cst.h>
#include <NumericsMatrix.h>
#include <SolverOptions.h>
#include <SparseBlockMatrix.h>
#include <fc2d_Solvers.h>

#include <chrono>
#include <cstdlib>
#include <stdexcept>
#include <vector>

namespace rigid::peers {

/// A in blocks of 2×2, a contact each way, those that are zero left out.
class ContactBlocks {
public:
    explicit ContactBlocks(const SparseMatrix& A)
    {
        const Index contacts = A.rows() / 2;
        ends_.resize(static_cast<std::size_t>(contacts));
        std::vector<Index> place(static_cast<std::size_t>(contacts), -1);
        first_.push_back(0);
        for (Index i = 0; i < contacts; ++i) {
            ends_[static_cast<std::size_t>(i)] = static_cast<unsigned>(2 * (i + 1));
            for (Index line = 0; line < 2; ++line)
                for (SparseMatrix::InnerIterator entry(A, 2 * i + line); entry;
                     ++entry) {
                    const Index j = entry.col() / 2;
                    Index& here = place[static_cast<std::size_t>(j)];
                    if (here < static_cast<Index>(first_.back())) {
                        here = static_cast<Index>(columns_.size());
                        columns_.push_back(static_cast<std::size_t>(j));
                        values_.insert(values_.end(), 4, 0);
                    }
                    // a block lies column by column
                    values_[static_cast<std::size_t>(
                        4 * here + 2 * (entry.col() % 2) + line)] = entry.value();
                }
            first_.push_back(columns_.size());
        }
        for (std::size_t k = 0; k < columns_.size(); ++k)
            blocks_.push_back(&values_[4 * k]);
        matrix_.nbblocks = static_cast<unsigned>(blocks_.size());
        matrix_.block = blocks_.data();
        matrix_.blocknumber0 = matrix_.blocknumber1 =
            static_cast<unsigned>(contacts);
        matrix_.blocksize0 = matrix_.blocksize1 = ends_.data();
        matrix_.filled1 = first_.size();
        matrix_.filled2 = columns_.size();
        matrix_.index1_data = first_.data();
        matrix_.index2_data = columns_.data();
    }
    ~ContactBlocks()
    {
        std::free(matrix_.diagonal_blocks);
    }  // found by the library
    ContactBlocks(const ContactBlocks&) = delete;
    ContactBlocks& operator=(const ContactBlocks&) = delete;

    SparseBlockStructuredMatrix* get() { return &matrix_; }

private:
    std::vector<double> values_;
    std::vector<double*> blocks_;
    std::vector<unsigned> ends_;
    std::vector<std::size_t> first_, columns_;
    SparseBlockStructuredMatrix matrix_{};
};

/// \param solver  SICONOS_FRICTION_2D_NSGS on blocks, _LEMKE or _ENUM on a dense matrix
/// \param most    sweeps, pivots
/// \param lambda  out: zero where it is not finite
/// \return        how long it took, without making the matrix [µs]
inline Real siconos(const Mlcp& mlcp, std::span<const FrictionBox> boxes,
                    int solver, int most, VecX& lambda)
{
    const auto n = static_cast<int>(mlcp.size());
    VecX q = mlcp.q, w = VecX::Zero(n), mu(n / 2);
    for (const FrictionBox& box : boxes) {
        if (box.normal % 2 != 0 || box.row != box.normal + 1)
            throw std::invalid_argument(
                "friction row " + std::to_string(box.row) + " is bounded by row " +
                std::to_string(box.normal) +
                "; each friction row must follow its normal");
        mu[box.normal / 2] = box.mu;
    }
    lambda.setZero(n);
    MatX A;
    ContactBlocks blocks(mlcp.A);
    const bool sparse = solver == SICONOS_FRICTION_2D_NSGS;
    if (!sparse) A = mlcp.A;
    NumericsMatrix* const M = sparse
                                  ? NM_new_SBM(n, n, blocks.get())
                                  : NM_create_from_data(NM_DENSE, n, n, A.data());
    FrictionContactProblem problem{2, n / 2, M, q.data(), mu.data()};
    SolverOptions* const options = solver_options_create(solver);
    options->iparam[SICONOS_IPARAM_MAX_ITER] = most;
    options->dparam[SICONOS_DPARAM_TOL] = 1e-10;
    int info = 0;
    const auto start = std::chrono::steady_clock::now();
    if (sparse) fc2d_nsgs_sbm(&problem, lambda.data(), w.data(), &info, options);
    else if (solver == SICONOS_FRICTION_2D_LEMKE)
        fc2d_lexicolemke(&problem, lambda.data(), w.data(), &info, options);
    else fc2d_enum(&problem, lambda.data(), w.data(), &info, options);
    const std::chrono::duration<Real, std::micro> needed =
        std::chrono::steady_clock::now() - start;
    solver_options_delete(options);
    if (sparse) NM_free_not_SBM(M);
    else NM_free_not_dense(M);
    if (!lambda.allFinite()) lambda.setZero();
    return needed.count();
}

}  // namespace rigid::peers
