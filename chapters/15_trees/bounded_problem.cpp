// The functions of bounded_problem.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/15_trees/bounded_problem.hpp"

namespace rigid {

void BoundedProblem::begin(const BoundedIslands& islands,
                           const std::vector<int>& here,
                           const std::vector<Row<3>>& rows, const VecX& u,
                           const VecX& b, Real enough, const VecX& lambda)
{
    const auto m = static_cast<Index>(here.size());
    mlcp.q.resize(m), mlcp.lo.resize(m), mlcp.hi.resize(m);
    solution.lambda.resize(m);
    boxes.clear();
    for (Index i = 0; i < m; ++i) {
        const int number = here[static_cast<std::size_t>(i)];
        const Row<3>& row = rows[static_cast<std::size_t>(number)];
        mlcp.q[i] = speed_along(row, u) + b[number];
        bound(islands, row, i, enough);
        solution.lambda[i] = lambda[number];
    }
}

//! [sweep]
int BoundedProblem::sweep(const FrictionSettings& settings, int sweeps, Real enough)
{
    FrictionMemory& memory = find.memory;
    memory.problem.mlcp = &mlcp;
    memory.problem.boxes = boxes;
    std::vector<int>& box_of = memory.guess.box_of;
    box_of.assign(static_cast<std::size_t>(mlcp.size()), -1);
    for (std::size_t i = 0; i < boxes.size(); ++i)
        box_of[static_cast<std::size_t>(boxes[i].row)] = static_cast<int>(i);
    memory.guess.lambda = solution.lambda;
    const int made =
        sweep_changes(memory.problem, sweeps, enough / 10, memory.guess);
    memory.candidate = memory.guess.lambda;
    solution.status = Status::iteration_limit;
    solution.residual = infinity;
    accept_coulomb(mlcp, boxes, {settings.tolerance, enough}, memory.candidate,
                   solution);
    return made;
}
//! [sweep]

void BoundedProblem::slide_held(const BoundedIslands& islands,
                                const std::vector<int>& here,
                                const std::vector<Row<3>>& rows, Real enough)
{
    for (Index i = 0; i < mlcp.size(); ++i) {
        const Row<3>& row =
            rows[static_cast<std::size_t>(here[static_cast<std::size_t>(i)])];
        if (row.bounded_by < 0 || mlcp.A.coeff(i, i) > 0) continue;
        const int normal = islands.number[static_cast<std::size_t>(row.bounded_by)];
        const Real w = mlcp.q[i];
        if (normal < 0 || !(std::abs(w) > enough)) continue;
        const Real most = row.friction * std::max(Real{0}, solution.lambda[normal]);
        solution.lambda[i] = w > 0 ? -most : most;
    }
}

void BoundedProblem::bound(const BoundedIslands& islands, const Row<3>& row,
                           Index i, Real enough)
{
    Real &lo = mlcp.lo[i], &hi = mlcp.hi[i];
    lo = row.lo, hi = row.hi;
    if (row.bounded_by >= 0) {
        const int normal = islands.number[static_cast<std::size_t>(row.bounded_by)];
        lo = hi = 0;
        if (normal >= 0 && mlcp.A.coeff(i, i) > 0)
            boxes.push_back({i, normal, row.friction});
        return;
    }
    if (mlcp.A.coeff(i, i) > 0) return;
    const Real w = mlcp.q[i];
    const Real there = w > enough    ? lo
                       : w < -enough ? hi
                                     : std::clamp(Real{0}, lo, hi);
    lo = hi = std::isfinite(there) ? there : 0;
}

}  // namespace rigid
