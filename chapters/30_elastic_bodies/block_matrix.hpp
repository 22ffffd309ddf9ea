/// \file block_matrix.hpp
/// A symmetric sparse matrix of Dim × Dim blocks: node beside node, as a mesh couples them.
///
/// Only blocks on and below the diagonal are kept, column by column, the diagonal first.
/// The pattern is fixed when it is made; values are added to slots that are known, so
/// that an assembly searches nothing.
#pragma once

#include "chapters/30_elastic_bodies/stretches.hpp"

#include <array>
#include <span>
#include <vector>

namespace rigid {

/// Which nodes share an element.
struct BlockPattern {
    std::vector<int> start;  ///< of each column, N + 1
    std::vector<int> row;    ///< ascending in a column; the first is the diagonal

    int size() const { return static_cast<int>(start.size()) - 1; }
    int blocks() const { return static_cast<int>(row.size()); }
    /// Where the block of these two nodes is; −1: they share no element.
    int slot(int a, int b) const;
    bool operator==(const BlockPattern&) const = default;
};

/// \param pairs  of nodes that are coupled, in any order, also more than once
BlockPattern pattern_of(int nodes, std::vector<std::array<int, 2>> pairs);

template <int Dim>
struct BlockMatrix {
    static constexpr int entries = Dim * Dim;
    const BlockPattern* pattern = nullptr;
    std::vector<Real> value;  ///< blocks, each row by row: row node × column node

    void reset(const BlockPattern& of)
    {
        pattern = &of;
        value.assign(static_cast<std::size_t>(of.blocks() * entries), 0);
    }
    Real* block(int slot) { return value.data() + slot * entries; }
    const Real* block(int slot) const { return value.data() + slot * entries; }

    /// y ← A x
    void multiply(const VecX& x, VecX& y) const;
};

//! [condense]
/// Takes fixed freedoms out of a system: their rows and columns become those of the
/// identity, so that they do not move.
template <int Dim>
void fix(std::span<const char> fixed, BlockMatrix<Dim>& A);
//! [condense]

//! [cg]
/// Conjugate gradients for A x = b, each node's block of the diagonal as preconditioner.
struct ConjugateGradients {
    Real tolerance =
        1e-8;  ///< ‖b − A x‖ ≤ tolerance · ‖b‖, in the norm of the preconditioner
    int most = 1000;  ///< iterations

    // What is kept from solve to solve.
    VecX r, p, Ap, z;
    std::vector<Real> inverse;  ///< of the blocks on the diagonal
    int iterations = 0;         ///< of the last solve

    /// \param x  out: starts from zero. Returns whether the tolerance was met.
    template <int Dim>
    bool solve(const BlockMatrix<Dim>& A, const VecX& b, VecX& x);
};
//! [cg]

/// Sums of products in one order; four sums beside each other.
Real ordered_dot(const VecX& a, const VecX& b);

/// The inverse of a symmetric positive definite block, row by row. Returns false if it
/// is not positive definite.
template <int Dim>
bool invert(const Real* block, Real* inverse)
{
    // L D Lᵀ, then columns of the identity
    Real L[Dim][Dim], D[Dim];
    for (int j = 0; j < Dim; ++j) {
        D[j] = block[j * Dim + j];
        for (int k = 0; k < j; ++k) D[j] -= L[j][k] * L[j][k] * D[k];
        if (!(D[j] > 0)) return false;
        for (int i = j + 1; i < Dim; ++i) {
            L[i][j] = block[i * Dim + j];
            for (int k = 0; k < j; ++k) L[i][j] -= L[i][k] * L[j][k] * D[k];
            L[i][j] /= D[j];
        }
    }
    for (int c = 0; c < Dim; ++c) {
        Real x[Dim];
        for (int i = 0; i < Dim; ++i) {
            x[i] = i == c ? 1 : 0;
            for (int k = 0; k < i; ++k) x[i] -= L[i][k] * x[k];
        }
        for (int i = Dim - 1; i >= 0; --i) {
            x[i] /= D[i];
            for (int k = i + 1; k < Dim; ++k) x[i] -= L[k][i] * x[k];
        }
        for (int i = 0; i < Dim; ++i) inverse[i * Dim + c] = x[i];
    }
    return true;
}

}  // namespace rigid
