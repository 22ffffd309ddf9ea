/// \file block.hpp
/// Two rows in one visit: the 2×2 problem of both is solved exactly, within their bounds.
///
///     w = A λ + q,   A = (A₁₁ A₁₂; A₁₂ A₂₂),   q = w_now − A λ_now
///
/// (6.21) to (6.23). Chapter 3's enumeration, specialised: with one row at a given bound the other is a single
/// row, whose answer is a clamp. So five guesses do for the nine cases. A sweep over such pairs is block
/// Gauss-Seidel.
#pragma once

#include "chapters/06_sequential_impulse/sequential_impulse.hpp"

namespace rigid {

using Mat2 = Eigen::Matrix<Real, 2, 2>;

//! [solve_block]
/// The λ of two rows that solves both exactly, (6.21) to (6.23).
/// \param A  2×2 [1/kg], symmetric, positive definite
/// \param q  [m/s]
/// \return   λ [N s]; if rounding leaves no guess that fits, the one that fits best
inline Vec2 solve_block(const Mat2& A, const Vec2& q, const Vec2& lo,
                        const Vec2& hi)
{
    // Both between their bounds: w = 0 in both rows, Cramer's rule.
    const Real determinant = A(0, 0) * A(1, 1) - A(0, 1) * A(1, 0);
    const Real first = (A(0, 1) * q[1] - A(1, 1) * q[0]) / determinant;
    const Real second = (A(1, 0) * q[0] - A(0, 0) * q[1]) / determinant;
    if (first >= lo[0] && first <= hi[0] && second >= lo[1] && second <= hi[1])
        return {first, second};

    // One at a bound: then the other is a single row.
    Vec2 best(std::clamp(first, lo[0], hi[0]), std::clamp(second, lo[1], hi[1]));
    Real smallest = infinity;
    for (const Index i : {0, 1})
        for (const Real bound : {lo[i], hi[i]}) {
            if (!std::isfinite(bound)) continue;
            const Index j = 1 - i;
            Vec2 lambda;
            lambda[i] = bound;
            lambda[j] =
                std::clamp(-(q[j] + A(j, i) * bound) / A(j, j), lo[j], hi[j]);
            const Real w = A(i, 0) * lambda[0] + A(i, 1) * lambda[1] + q[i];
            const Real residual =
                natural_residual_row(A(i, i), bound, w, lo[i], hi[i]);
            // w has the sign that (4.1) requires at the bound
            if (residual <= 0) return lambda;
            if (residual < smallest) smallest = residual, best = lambda;
        }
    return best;
}
//! [solve_block]

/// Two rows that are solved together; `second` = −1: a row by itself.
struct Block {
    int first = 0, second = -1;  ///< places in the order of the visits
    Real coupling = 0;           ///< A₁₂ [1/kg]
};

/// \f$J_r M^{-1} J_s^T\f$ [1/kg]: what one unit of λ in row s does to the velocity of row r.
template <int Dof>
Real coupling(const SolverRow<Dof>& r, const SolverRow<Dof>& s)
{
    Real sum = 0;
    if (r.a == s.a) sum += r.Ja.dot(s.Wa);
    if (r.a == s.b) sum += r.Ja.dot(s.Wb);
    if (r.b == s.a) sum += r.Jb.dot(s.Wa);
    if (r.b == s.b) sum += r.Jb.dot(s.Wb);
    return sum;
}

//! [pair]
/// Pairs each row with the next one, in the order of the visits, if they share a
/// body and are not so nearly the same row that A is singular: then they are
/// visited one by one.
template <int Dof>
void pair_rows(const std::vector<SolverRow<Dof>>& rows, std::vector<Block>& blocks)
{
    blocks.clear();
    for (std::size_t k = 0; k < rows.size(); ++k) {
        Block block{static_cast<int>(k), -1, 0};
        if (k + 1 < rows.size() && rows[k].mass > 0 && rows[k + 1].mass > 0) {
            const Real A12 = coupling(rows[k], rows[k + 1]);
            // cos² of the rows' angle
            const Real share = A12 * A12 * rows[k].mass * rows[k + 1].mass;
            // 1 − share loses about 1e-16: with 1e-8 left, λ still has eight
            // digits.
            if (share > 0 && share < 1 - 1e-8)
                block.second = static_cast<int>(++k), block.coupling = A12;
        }
        blocks.push_back(block);
    }
}
//! [pair]

//! [visit_block]
/// One visit of two rows.
/// \return  how many of them were off by more than the tolerance [m/s]
template <int Dof>
int visit_block(SolverRow<Dof>& r, SolverRow<Dof>& s, Real coupling, Real tolerance,
                VecX& u)
{
    const auto w_of = [&u](const SolverRow<Dof>& row) {
        return velocity<Dof>(row, u.template segment<Dof>(row.a),
                             u.template segment<Dof>(row.b));
    };
    Mat2 A;
    A << 1 / r.mass, coupling, coupling, 1 / s.mass;
    const Vec2 before(r.lambda, s.lambda);
    // Number by number: two numbers that were stored one by one and are read back
    // as a pair have to wait until both have arrived in memory.
    const Vec2 q(w_of(r) - (A(0, 0) * before[0] + A(0, 1) * before[1]),
                 w_of(s) - (A(1, 0) * before[0] + A(1, 1) * before[1]));
    const Vec2 after = solve_block(A, q, {r.lo, s.lo}, {r.hi, s.hi});
    const Vec2 change(after[0] - before[0], after[1] - before[1]);
    u.template segment<Dof>(r.a) += r.Wa * change[0];
    u.template segment<Dof>(r.b) += r.Wb * change[0];
    u.template segment<Dof>(s.a) += s.Wa * change[1];
    u.template segment<Dof>(s.b) += s.Wb * change[1];
    r.lambda = after[0];
    s.lambda = after[1];
    return !(std::abs(change[0]) <= tolerance * r.mass) +
           !(std::abs(change[1]) <= tolerance * s.mass);
}
//! [visit_block]

/// sequential_impulse() two rows at a time.
template <int Dof>
void block_impulse(const std::vector<Row<Dof>>& rows, std::span<const int> order,
                   const ImpulseSettings& settings, ImpulseMemory<Dof>& memory,
                   std::vector<Block>& blocks, VecX& u, Solution& solution)
{
    const bool hopeless =
        begin_sweeps(rows, order, settings.tolerance, memory, u, solution);
    pair_rows(memory.rows, blocks);
    const std::span<SolverRow<Dof>> all(memory.rows);
    const std::span<const Feedback> feedback(memory.feedback);
    const auto of_both = [&](const Block& block, const auto& what) {
        if (feedback.empty()) return;
        for (const int k : {block.first, block.second})
            if (k >= 0)
                what(&all[static_cast<std::size_t>(k)],
                     feedback[static_cast<std::size_t>(k)]);
    };
    const auto visit_one = [&](const Block& block) {
        const auto first = static_cast<std::size_t>(block.first);
        if (block.second < 0)
            return sweep(all.subspan(first, 1),
                         feedback.empty() ? feedback : feedback.subspan(first, 1),
                         memory.u, settings.tolerance);
        of_both(block, take_bounds<Dof>);
        const int off =
            visit_block(all[first], all[static_cast<std::size_t>(block.second)],
                        block.coupling, settings.tolerance, memory.u);
        of_both(block, give_way<Dof>);
        return off;
    };
    const auto one_sweep = [&](int number) {
        int off = 0;
        if (settings.alternate && number % 2 == 1)
            for (std::size_t k = blocks.size(); k-- > 0;)
                off += visit_one(blocks[k]);
        else
            for (const Block& block : blocks) off += visit_one(block);
        return off;
    };
    sweep_until(settings, hopeless, one_sweep, memory, solution);
    end_sweeps(order, memory, u, solution);
}

// Compiled once, in block.cpp.
#define RIGID_BLOCK(TEMPLATE, Dof)                                                 \
    TEMPLATE void pair_rows(const std::vector<SolverRow<Dof>>&,                    \
                            std::vector<Block>&);                                  \
    TEMPLATE void block_impulse(const std::vector<Row<Dof>>&,                      \
                                std::span<const int>, const ImpulseSettings&,      \
                                ImpulseMemory<Dof>&, std::vector<Block>&, VecX&,   \
                                Solution&);
RIGID_BLOCK(extern template, 2)
RIGID_BLOCK(extern template, 3)
RIGID_BLOCK(extern template, 6)

}  // namespace rigid
