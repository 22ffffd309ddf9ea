// The functions of friction_boxes.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/09_active_sets/friction_boxes.hpp"
#include "chapters/09_active_sets/friction_lu.hpp"

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
    const auto is_active = [&cases](Index i) {
        return cases[static_cast<std::size_t>(i)] == BoundState::between;
    };
    std::vector<char> active(static_cast<std::size_t>(n));
    VecX tied = VecX::Zero(n);
    to_bounds(mlcp, cases, tied);
    for (Index i = 0; i < n; ++i)
        if (is_active(i)) active[static_cast<std::size_t>(i)] = 1, tied[i] = 0;
    VecX tie = VecX::Zero(static_cast<Index>(boxes.size()));
    for (std::size_t k = 0; k < boxes.size(); ++k) {
        const auto& [row, normal, mu] = boxes[k];
        if (is_active(row) || !is_active(normal)) continue;
        const bool low = cases[static_cast<std::size_t>(row)] == BoundState::at_lo;
        tie[static_cast<Index>(k)] = low ? -mu : mu;
    }
    const auto follow = [&] {
        for (std::size_t k = 0; k < boxes.size(); ++k)
            if (const Real t = tie[static_cast<Index>(k)]; t != 0)
                tied[boxes[k].row] = t * tied[boxes[k].normal];
    };
    follow();
    FrictionLu factor;
    factor.analyse(mlcp.A, boxes);
    factor.factor(active, tie, VecX::Zero(n));
    for (int round = 0; round < 2; ++round) {  // the second for the rounding
        VecX change = -(mlcp.A * tied + mlcp.q);
        factor.solve(change);
        for (Index i = 0; i < n; ++i)
            if (is_active(i)) tied[i] += change[i];
        follow();
    }
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
