// The functions of tree_solver.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/15_trees/tree_solver.hpp"

namespace rigid {

void TreeSolver::answer(Bodies<3>& bodies, StepData<3>& now)
{
    const auto from_free = [&] {
        for (const int k : now.active)
            bodies.velocity(k) = now.u_star.segment<3>(3 * k);
    };
    run(joints, bounded, listed_, {}, nullptr, sweeps, tolerance * now.length,
        from_free, bodies.u, now.solution.lambda, now);
    judge(bodies.u, now.solution.lambda, now, now.solution);
}

//! [sweep_on]
bool TreeSolver::sweep_on(JointFactor& factor, const std::vector<char>& left_out,
                          int most, Real small, VecX& u, VecX& lambda,
                          StepData<3>& now)
{
    int changed = 1;
    for (; sweeps_made < most && changed > 0; ++sweeps_made) {
        changed = 0;
        for (std::size_t i = 0; i < now.rows.size(); ++i) {
            const Row<3>& row = now.rows[i];
            if (JointTree::takes(row) || (!left_out.empty() && left_out[i]))
                continue;
            ++now.visits;
            const auto k = static_cast<Index>(i);
            const Real A = row.diagonal();
            if (!(A > 0)) continue;
            const Real w =
                row.velocity(u) - row.bias + bias_[k] + row.softness * lambda[k];
            const auto [lo, hi] = bounds_of(row, lambda);
            const Real change = std::clamp(lambda[k] - w / A, lo, hi) - lambda[k];
            lambda[k] += change;
            row.apply(change, u);
            changed += !(std::abs(change) * A <= small);
        }
        if (changed > 0) answer_.solve(factor, now.rows, bias_, u, lambda);
    }
    return changed == 0;
}
//! [sweep_on]

void TreeSolver::judge(const VecX& u, const VecX& lambda, const StepData<3>& now,
                       Solution& solution) const
{
    const Real left = natural_residual(now.rows, bias_, lambda, u);
    const Real residual = solution.residual = std::max(left, answer_.unlike);
    solution.iterations = sweeps_made;
    solution.status = residual <= enough_ && enough_ < infinity ? Status::solved
                      : joints.is_dependent() || !std::isfinite(residual)
                          ? Status::singular
                          : Status::iteration_limit;
}

}  // namespace rigid
