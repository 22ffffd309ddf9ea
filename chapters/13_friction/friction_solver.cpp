// The functions of friction_solver.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/13_friction/friction_solver.hpp"

namespace rigid {

void FindByStewartTrinkle::operator()(Mlcp& mlcp,
                                      std::span<const FrictionBox> boxes,
                                      Real enough, Solution& solution) const
{
    for (const FrictionBox& box : boxes) mlcp.lo[box.row] = mlcp.hi[box.row] = 0;
    LemkeSettings settings;
    settings.enough = enough;
    const Solution found = stewart_trinkle_by_lemke(mlcp, boxes, settings);
    VecX lambda = found.lambda;
    solution = found;
    solution.residual = infinity;
    if (!accept_coulomb(mlcp, boxes, {1e-10, enough}, lambda, solution) &&
        found.status == Status::solved)
        solution.status = Status::singular;
}

template void step(RoughScene&, const StepSettings&, FrictionSweeps<AllBodies>&,
                   StepData<3>&);
template void step(RoughScene&, const StepSettings&, FrictionSweeps<Manifolds>&,
                   StepData<3>&);
template void step(RoughScene&, const StepSettings&, ExactFriction<AllBodies>&,
                   StepData<3>&);
template void step(RoughScene&, const StepSettings&, ExactFriction<Manifolds>&,
                   StepData<3>&);
template void step(RoughScene&, const StepSettings&, LemkeFriction<AllBodies>&,
                   StepData<3>&);
template void step(RoughScene&, const StepSettings&, SkippingFriction&,
                   StepData<3>&);

}  // namespace rigid
