/// Prints every bit of 300 steps of the ten discs and of a triangle, warm. Built without and with optimisation: the
/// output must be the same.

#include "chapters/08_warm_starting/warm_method.hpp"

#include <cmath>
#include <cstdio>

int main()
{
    using namespace rigid;
    for (const bool ten : {true, false}) {
        DiscScene scene = ten ? ten_discs() : triangle(6);
        StepSettings settings;
        settings.h = ten ? 1.0 / 480 : 1.0 / 60;
        settings.stiffness = settings.damping = 1;
        WarmMethod method;
        method.start.from = Start::best_multiple;
        method.start.keep = 2;
        method.solver.ordering = Order::coloured;
        method.solver.sweeps.tolerance = 1e-6;
        method.solver.sweeps.max_sweeps = 200;
        method.correction.method = ten ? Stabilizer::baumgarte : Stabilizer::projection;
        StepData<2> now;
        for (int k = 0; k < 300; ++k) {
            // Gravity that turns by itself, in numbers that every compiler has.
            const Real turn = 0.01 * k, square = 1 + turn * turn;
            if (ten) scene.gravity = 9.81 * Vec2(2 * turn / square, (turn * turn - 1) / square);
            step(scene, settings, method, now);
            std::printf("%d %d %a %d", k, now.solution.iterations, now.solution.residual,
                        method.start.cache.found);
            for (Index i = 0; i < scene.bodies.x.size(); ++i)
                std::printf(" %a %a", scene.bodies.x[i], scene.bodies.u[i]);
            std::printf("\n");
        }
    }
}
