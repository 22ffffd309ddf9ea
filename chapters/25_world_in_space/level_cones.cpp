// The functions of level_cones.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/25_world_in_space/level_cones.hpp"

namespace rigid {

//! [together]
void LevelCones::solve_together(Bodies<6>& bodies, StepData<6>& now)
{
    swept.clear();
    lanes.levels.begin(bodies.count(), islands.count());
    for (int i = 0; i < islands.count(); ++i) {
        const auto [first, count] = rows_of(i);
        if (solves_exactly(count) || count == 0 || sweeps.max_sweeps == 0) {
            solve_island(i, bodies.u, now);
            continue;
        }
        swept.push_back(i);
        lanes.levels.add(problem_of(i), i, first, bodies);
    }
    if (swept.empty()) return;
    lanes.arrange({rows, feedback, disc_at, discs, {}}, bodies);
    for (int n = 1; !swept.empty(); ++n) {
        lanes.sweep(sweeps.tolerance * now.length);
        std::erase_if(swept, [&](int i) { return is_done(i, n, bodies.u, now); });
    }
}

bool LevelCones::is_done(int island, int n, VecX& u, StepData<6>& now)
{
    const auto [first, count] = rows_of(island);
    const Real tolerance = sweeps.tolerance * now.length;
    now.visits += static_cast<std::int64_t>(count);
    if (n < sweeps.max_sweeps && lanes.off[static_cast<std::size_t>(island)])
        return false;
    for (const int k : islands.bodies_of(island))
        for (Index i = 6 * k; i < 6 * k + 6; ++i) u[i] = lanes.number(i);
    for (std::size_t k = first; k < first + count; ++k)
        rows[k].lambda = lanes.lambda(k);
    Real residual = infinity;
    if (tolerance > 0) residual = residual_of(problem_of(island), u);
    const bool last = patience.is_last(n, sweeps, residual, now);
    if (!last && tolerance > 0 && !(residual <= tolerance)) return false;
    lanes.leave(island);
    note(n, residual, now);
    return true;
}
//! [together]

}  // namespace rigid
