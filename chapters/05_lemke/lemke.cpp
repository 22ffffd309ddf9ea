// The functions of lemke.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/05_lemke/lemke.hpp"

namespace rigid {

void require_valid(const LemkeSettings& settings)
{
    if (!(settings.tolerance > 0) || !(settings.enough >= 0) ||
        settings.enough == infinity || settings.pivot_limit < 0)
        throw std::invalid_argument(
            "the tolerance is " + shortest(settings.tolerance) + ", enough " +
            shortest(settings.enough) + " m/s and the pivot limit " +
            std::to_string(settings.pivot_limit) +
            "; the tolerance must be positive, the others not negative, enough "
            "finite");
    require_share(settings.tolerance);
}

bool without_far_bounds(const Mlcp& mlcp, Mlcp& near)
{
    const Index n = mlcp.size();
    VecX unit(n);
    Real given = 0;
    for (Index i = 0; i < n; ++i) {
        unit[i] = row_unit(mlcp, i, mlcp.A.coeff(i, i));
        given = std::max(given, std::abs(mlcp.q[i]) / unit[i]);
    }
    bool any = false;
    for (Index i = 0; i < n; ++i) {
        const Real far = far_bound * given / unit[i];
        const bool below = mlcp.lo[i] < -far && mlcp.lo[i] > -infinity;
        const bool above = mlcp.hi[i] > far && mlcp.hi[i] < infinity;
        if ((below || above) && !any) near = mlcp;
        if (below) near.lo[i] = -infinity;
        if (above) near.hi[i] = infinity;
        any = any || below || above;
    }
    return any;
}

//! [walk]
bool walk_once(const Mlcp& mlcp, const Mlcp& given, Real last, int limit,
               const LemkeSettings& settings, Solution& solution)
{
    const StandardForm form(given);
    LemkeWalk walk(form.A, form.q, VecX::LinSpaced(form.q.size(), 1, last),
                   settings.ties, settings.tolerances);
    while (walk.place == LemkeWalk::Place::on_the_way &&
           solution.iterations + walk.pivots < limit)
        walk.step();
    solution.iterations += walk.pivots;
    const auto accepted = [&](const VecX& lambda, Status otherwise) {
        const Verification verified =
            verify(mlcp, lambda, {settings.tolerance, settings.enough});
        if (!verified.solved && !(verified.residual < solution.residual)) {
            solution.status = otherwise;
            return false;
        }
        solution.lambda = lambda;
        solution.residual = verified.residual;
        solution.status = verified.solved ? Status::solved : otherwise;
        return verified.solved;
    };
    switch (walk.place) {
    case LemkeWalk::Place::on_the_way:
        accepted(form.impulses(walk.z()), Status::iteration_limit);
        return true;
    case LemkeWalk::Place::ray:
        if (accepted(form.impulses(walk.z()), Status::ray_termination)) return true;
        if (!proves_infeasibility(mlcp, form.direction(walk.ray()))) return false;
        solution.status = Status::infeasible;
        return true;
    case LemkeWalk::Place::solution:
        break;
    }
    if (accepted(form.impulses(walk.z()), Status::singular)) return true;
    std::vector<Index> between;
    const VecX at_bounds = form.bounds_at(walk.tableau, between);
    return accepted(solve_between(mlcp, at_bounds, between), Status::singular);
}
//! [walk]

}  // namespace rigid
