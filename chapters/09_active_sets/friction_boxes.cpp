// The functions of friction_boxes.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/09_active_sets/friction_boxes.hpp"

#include <Eigen/SparseLU>  // here alone: no other source of the library factors so

namespace rigid {

void to_bounds(const Mlcp& mlcp, const std::vector<BoundState>& cases, VecX& lambda)
{
    for (Index i = 0; i < mlcp.size(); ++i) {
        const BoundState here = cases[static_cast<std::size_t>(i)];
        lambda[i] = here == BoundState::at_lo ? mlcp.lo[i]
                    : here == BoundState::at_hi
                        ? mlcp.hi[i]
                        : std::clamp(lambda[i], mlcp.lo[i], mlcp.hi[i]);
    }
}

bool solve_tied(const Mlcp& mlcp, std::span<const FrictionBox> boxes,
                const std::vector<BoundState>& cases, VecX& lambda)
{
    const Index n = mlcp.size();
    const auto at = [](auto& list, Index i) -> auto&
    {
        return list[static_cast<std::size_t>(i)];
    };
    std::vector<Index> place(static_cast<std::size_t>(n), -1), active;
    for (Index i = 0; i < n; ++i)
        if (at(cases, i) == BoundState::between) {
            at(place, i) = static_cast<Index>(active.size());
            active.push_back(i);
        }
    // λ = fixed + T λ_F
    std::vector<Eigen::Triplet<Real>> tie;
    VecX fixed = VecX::Zero(n);
    for (Index i = 0; i < n; ++i) {
        if (at(place, i) >= 0)
            tie.emplace_back(static_cast<int>(i), static_cast<int>(at(place, i)),
                             1);
        else fixed[i] = at(cases, i) == BoundState::at_lo ? mlcp.lo[i] : mlcp.hi[i];
    }
    for (const FrictionBox& box : boxes) {
        if (at(place, box.row) >= 0 || at(place, box.normal) < 0) continue;
        fixed[box.row] = 0;
        tie.emplace_back(
            static_cast<int>(box.row), static_cast<int>(at(place, box.normal)),
            at(cases, box.row) == BoundState::at_lo ? -box.mu : box.mu);
    }
    const auto f = static_cast<Index>(active.size());
    if (f == 0) return false;
    Eigen::SparseMatrix<Real> T(n, f);
    T.setFromTriplets(tie.begin(), tie.end());
    const Eigen::SparseMatrix<Real, Eigen::RowMajor> AT = mlcp.A * T;
    const VecX w = mlcp.A * fixed + mlcp.q;
    std::vector<Eigen::Triplet<Real>> entries;
    VecX right(f);
    for (Index k = 0; k < f; ++k) {
        right[k] = -w[at(active, k)];
        for (Eigen::SparseMatrix<Real, Eigen::RowMajor>::InnerIterator entry(
                 AT, at(active, k));
             entry; ++entry)
            entries.emplace_back(static_cast<int>(k), static_cast<int>(entry.col()),
                                 entry.value());
    }
    Eigen::SparseMatrix<Real> system(f, f);
    system.setFromTriplets(entries.begin(), entries.end());
    Eigen::SparseLU<Eigen::SparseMatrix<Real>> lu(system);
    if (lu.info() != Eigen::Success) return false;
    VecX x = lu.solve(right);
    x += lu.solve(VecX(right - system * x));
    const VecX tied = fixed + T * x;
    if (!tied.allFinite()) return false;
    lambda = tied;
    return true;
}

void require_valid(const Mlcp& mlcp, std::span<const FrictionBox> boxes)
{
    const Index n = mlcp.size();
    if (mlcp.lo.size() != n || mlcp.hi.size() != n) require_valid(mlcp);  // says so
    for (const FrictionBox& box : boxes)
        if (box.row < 0 || box.row >= n || box.normal < 0 || box.normal >= n ||
            box.row == box.normal || !(box.mu >= 0) || !std::isfinite(box.mu))
            throw std::invalid_argument(
                "a friction box for row " + std::to_string(box.row) + " by row " +
                std::to_string(box.normal) + " with mu = " + shortest(box.mu) +
                "; rows go from 0 to " + std::to_string(n - 1) +
                ", mu is at least 0");
}

//! [boxes]
void active_sets(const Mlcp& mlcp, std::span<const FrictionBox> boxes,
                 const ActiveSetSettings& settings, ActiveSetMemory& memory,
                 Solution& solution)
{
    require_valid(mlcp, boxes);
    const Index n = mlcp.size();
    Mlcp fixed = mlcp;
    solution.lambda.setZero(n);
    bound_by(boxes, solution.lambda, fixed);  // first without friction
    std::vector<BoundState> last;
    int guesses = 0;
    for (int round = 0; round < 200; ++round) {
        active_sets(fixed, settings, memory, solution);
        // λ = 0 did, and what the memory has is of another problem
        if (solution.iterations == 0)
            memory.cases.assign(static_cast<std::size_t>(n), BoundState::between);
        guesses += solution.iterations;
        solution.iterations = guesses;
        if (solution.status != Status::solved) return;
        bound_by(boxes, solution.lambda,
                 // the bounds of this very λ, which it may miss by its last digit
                 fixed);
        to_bounds(fixed, memory.cases, solution.lambda);
        bool right = verify_guess(fixed, settings, VecX(solution.lambda), solution);
        VecX tied;
        if ((right || memory.cases == last) &&
            solve_tied(fixed, boxes, memory.cases, tied)) {
            Mlcp own = fixed;
            Solution other = solution;
            bound_by(boxes, tied, own);
            to_bounds(own, memory.cases, tied);
            if (verify_guess(own, settings, tied, other)) {
                if (!right || other.residual < solution.residual) solution = other;
                right = true;
            }
            fixed = own;
        }
        if (right) return;
        solution.status = Status::iteration_limit;
        last = memory.cases;
    }
}
//! [boxes]

}  // namespace rigid
