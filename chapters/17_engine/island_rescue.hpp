/// \file island_rescue.hpp
/// Islands that are solved exactly after all, from where another solver has left them.
#pragma once

#include "chapters/10_skipping_work/fall_asleep.hpp"
#include "chapters/14_joints/tree_solver.hpp"
#include "chapters/17_engine/island_shape.hpp"
#include "chapters/17_engine/step_part.hpp"

namespace rigid {

//! [price]
/// How good a solve must be where guesses do not settle it, and what it may cost.
inline void set_price(Real late, std::int64_t entries, TreeSolver& solver)
{
    solver.exact.late = late;
    solver.exact.most_entries = entries;
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

//! [rescue]
struct IslandRescue {
    TreeSolver solver;
    StepPart part;
    std::int64_t entries = 0;  ///< of matrices, that it looked at

    /// Solves those islands that are meant and whose residual is above `enough`.
    /// \param enough  [m/s]
    /// \param meant   bool(int island)
    /// \return        how many they were
    template <class Meant>
    int operator()(const Islands& islands, Bodies<3>& bodies, StepData<3>& now,
                   Real enough, const Meant& meant)
    {
        int count = 0;
        part.clear();
        for (int i = 0; i < islands.count(); ++i) {
            if (!meant(i)) continue;
            const std::span<const int> rows = islands.rows_of(i),
                                       members = islands.bodies_of(i);
            if (natural_residual(now, rows, bodies.u) <= enough) continue;
            ++count;
            part.rows.insert(part.rows.end(), rows.begin(), rows.end());
            part.bodies.insert(part.bodies.end(), members.begin(), members.end());
        }
        if (count == 0) return 0;
        part.number(now, bodies.count());
        part.gather(bodies, now);
        solver.solve(part.local, part.now);
        entries += solver.bounded.entries;
        part.scatter(bodies, now);
        return count;
    }
};
//! [rescue]

//! [slow]
/// Whether each of these bodies is slow.
/// \param length  a spin counts as the speed at this distance [m]
inline bool are_slow(std::span<const int> bodies, const VecX& u, Real speed,
                     Real length)
{
    return std::all_of(bodies.begin(), bodies.end(), [&](int k) {
        const Vec<3> v = u.segment<3>(3 * k);
        return v.head<2>().squaredNorm() + length * length * v[2] * v[2] <=
               speed * speed;
    });
}
//! [slow]

}  // namespace rigid
