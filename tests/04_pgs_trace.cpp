/// Prints every bit of 600 steps of the ten discs. Built without and with optimisation: the output must be
/// the same.

#include "chapters/03_mlcp_formulation/step.hpp"
#include "chapters/04_pgs/pgs.hpp"
#include "common/program/scripted_pointer.hpp"

#include <cstdio>

int main()
{
    using namespace rigid;
    DiscScene scene = ten_discs();
    const ScriptedPointer pointer(1, {{0, 0}, scene.half_size});
    StepSettings settings{.h = 1.0 / 480};
    settings.stiffness = 1;
    settings.damping = 1;
    PgsSettings sweeps;
    sweeps.tolerance = 1e-6;
    PgsMemory memory;
    StepData<2> now;
    const auto solve = [&](const Mlcp& mlcp, Solution& solution) {
        cold_start(mlcp, solution.lambda);
        pgs(mlcp, sweeps, memory, solution);
    };
    for (int k = 0; k < 600; ++k) {
        scene.gravity = 9.81 * pointer.at(k * settings.h).cwiseQuotient(scene.half_size);
        step(scene, settings, by_matrix(solve), now);
        std::printf("%d %d %a", k, now.solution.iterations, now.solution.residual);
        for (Index i = 0; i < scene.bodies.x.size(); ++i)
            std::printf(" %a %a", scene.bodies.x[i], scene.bodies.u[i]);
        std::printf("\n");
    }
}
