/// Prints every bit of 150 steps of the ten discs under each way to correct. Built without and with optimisation:
/// the output must be the same.

#include "chapters/07_baumgarte/corrected_method.hpp"
#include "common/program/scripted_pointer.hpp"

#include <cstdio>

int main()
{
    using namespace rigid;
    for (const Stabilizer stabilizer : {Stabilizer::none, Stabilizer::baumgarte, Stabilizer::relaxation,
                                        Stabilizer::split_impulse, Stabilizer::projection}) {
        DiscScene scene = ten_discs();
        const ScriptedPointer pointer(1, {{0, 0}, scene.half_size});
        StepSettings settings;
        settings.h = 1.0 / 120;
        settings.stiffness = 1;
        settings.damping = 1;
        settings.substeps = 2;
        CorrectedMethod method;
        method.correction.method = stabilizer;
        method.correction.restitution = 0.5;
        method.start.factor = 0.5;
        method.solver.ordering = Order::coloured;
        StepData<2> now;
        for (int k = 0; k < 150; ++k) {
            scene.gravity = 9.81 * pointer.at(k * settings.h).cwiseQuotient(scene.half_size);
            step(scene, settings, method, now);
            std::printf("%d %d", k, static_cast<int>(now.visits));
            for (Index i = 0; i < scene.bodies.x.size(); ++i)
                std::printf(" %a %a", scene.bodies.x[i], scene.bodies.u[i]);
            std::printf("\n");
        }
    }
}
