/// Prints what active sets find, every digit: tests/09_active_sets.cmake compares two builds of it.

#include "chapters/03_mlcp_formulation/step.hpp"
#include "chapters/09_active_sets/active_sets.hpp"
#include "chapters/09_active_sets/benchmark/problems.hpp"

#include <cstdio>

using namespace rigid;

namespace {

void print(const VecX& numbers)
{
    for (const Real number : numbers) std::printf("%.17g ", number);
    std::printf("\n");
}

}  // namespace

int main()
{
    DiscScene scene = ten_discs();
    StepSettings settings{.h = 1.0 / 480};
    StepData<2> now;
    ActiveSetMemory memory;
    const auto solve = [&](const Mlcp& mlcp, Solution& solution) { active_sets(mlcp, {}, memory, solution); };
    for (int n = 0; n < 600; ++n) {
        scene.gravity = 9.81 * Vec2(std::sin(0.01 * n), -std::cos(0.01 * n));
        settings.stiffness = settings.damping = 1;
        step(scene, settings, by_matrix(solve), now);
        print(scene.bodies.x);
        std::printf("%d guesses\n", now.solution.iterations);
    }
    Random random(7);
    for (const Mlcp& mlcp :
         {pile_problem(box_column(60), in_impact).mlcp(), pile_problem(box_pyramid(7), in_impact).mlcp(),
          pile_problem(box_column(20), nudged, 0.5).mlcp(), random_spd(40, random)})
        print(active_sets(mlcp).lambda);
}
