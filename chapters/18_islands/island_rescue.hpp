/// \file island_rescue.hpp
/// An island that is solved by its joints at once: in the first place, or after all, from where another solver has left it.
#pragma once

#include "chapters/10_skipping_work/fall_asleep.hpp"
#include "chapters/15_trees/tree_solver.hpp"
#include "chapters/18_islands/choice_rule.hpp"
#include "chapters/18_islands/step_part.hpp"

namespace rigid {

//! [price]
/// How good a solve must be where guesses do not settle it, and what it may cost.
/// \param entries  at most, however large the island
inline void set_price(Real late, std::int64_t entries, const ChoiceRule& rule,
                      FrictionSettings& exact)
{
    exact.late = late;
    exact.most_entries = entries;
    exact.pair_entries = rule.pair_entries;
    exact.idle_steps = rule.idle_steps;
    exact.most_rows_of_rounds = 0;
}

/// Of the trees of joints, since the beginning.
inline std::int64_t joint_entries(const TreeSolver& solver)
{
    std::int64_t sum = 0;
    for (const JointFactor* it : {&solver.joints, &solver.apart})
        sum += it->border_entries +
               price::solved_joint * it->tree.work.solved_rows +
               price::factored_joint * it->tree.work.factored_rows;
    return sum;
}
//! [price]

//! [trees]
/// An island with a solver of chapter 15.
struct TreePart {
    StepPart part;
    TreeSolver solver;
    std::int64_t entries =
        0;  ///< that its guesses looked at in this step, less old joints

    /// What guesses began from and old factors do not outlive a step, so that its
    /// bits depend on the state alone.
    void forget()
    {
        solver.bounded.forget();
        for (TreeSolver::Apart& other : solver.others) other.bounded.forget();
        part.second.solution.lambda.setZero();
        entries = -joint_entries(solver);
    }
    void solve(Bodies<3>& bodies, StepData<3>& now)
    {
        part.gather(bodies, now);
        solver.solve(part.local, part.now);
        entries += solver.bounded.entries;
        part.scatter(bodies, now);
    }
    /// The rows have another J.
    void factor_again(const Bodies<3>& bodies, const StepData<3>& now)
    {
        part.gather_rows(bodies, now);
        solver.factor_again(part.local, part.now);
    }
    std::int64_t all_entries() const { return entries + joint_entries(solver); }
};
//! [trees]

/// u of these bodies, from u* and the impulses of their rows. What cannot move is not
/// touched: zero times an impulse that has overflowed is no zero.
inline void push(const StepData<3>& now, std::span<const int> rows,
                 std::span<const int> members, Bodies<3>& bodies)
{
    for (const int k : members) bodies.velocity(k) = now.u_star.segment<3>(3 * k);
    for (const int i : rows) {
        const Row<3>& row = now.rows[static_cast<std::size_t>(i)];
        const Real lambda = now.solution.lambda[i];
        if (bodies.can_move(row.a)) bodies.velocity(row.a) += row.Wa * lambda;
        if (bodies.can_move(row.b)) bodies.velocity(row.b) += row.Wb * lambda;
    }
}

//! [slow]
/// \param length  a spin counts as the speed at this distance [m]
/// \return        [m²/s²]
inline Real speed_squared(int body, const VecX& u, Real length)
{
    const Vec<3> v = u.segment<3>(3 * body);
    return v.head<2>().squaredNorm() + length * length * v[2] * v[2];
}
/// The speed of the fastest of these bodies [m/s]
inline Real fastest(std::span<const int> bodies, const VecX& u, Real length)
{
    Real most = 0;
    for (const int k : bodies) most = std::max(most, speed_squared(k, u, length));
    return std::sqrt(most);
}
/// Whether each of them is slow.
inline bool are_slow(std::span<const int> bodies, const VecX& u, Real speed,
                     Real length)
{
    return std::all_of(bodies.begin(), bodies.end(), [&](int k) {
        return speed_squared(k, u, length) <= speed * speed;
    });
}
//! [slow]

//! [stands]
/// The most that the forces of a step give one of these bodies: |g| h under gravity
/// alone [m/s]
/// \param u  of the step before
inline Real given_speed(std::span<const int> bodies, const VecX& u,
                        const VecX& u_star)
{
    Real given = 0;
    for (const int k : bodies)
        given = std::max(given,
                         (u_star.segment<2>(3 * k) - u.segment<2>(3 * k)).norm());
    return given;
}
/// Whether each body is slower than that, as all are that stand, or have stood
/// until now.
inline bool stand(std::span<const int> bodies, const VecX& u, const VecX& u_star,
                  Real length)
{
    return are_slow(bodies, u, given_speed(bodies, u, u_star), length);
}
//! [stands]

}  // namespace rigid
