/// Prints every bit of 150 steps of the ten discs under each way to repay. Built without and with optimisation:
/// the output must be the same.

#include "chapters/07_baumgarte/stabilized_step.hpp"
#include "common/program/scripted_pointer.hpp"

#include <cstdio>

int main()
{
    using namespace rigid;
    for (const Stabilizer method : {Stabilizer::none, Stabilizer::baumgarte, Stabilizer::relaxation,
                                    Stabilizer::split_impulse, Stabilizer::projection}) {
        DiscScene scene = ten_discs();
        const ScriptedPointer pointer(1, {{0, 0}, scene.half_size});
        StabilizedStepSettings settings;
        settings.h = 1.0 / 120;
        settings.stiffness = 1;
        settings.damping = 1;
        settings.substeps = 2;
        settings.carry = 0.5;
        settings.restitution = 0.5;
        settings.order = Order::coloured;
        settings.stabilizer.method = method;
        StabilizedStep now;
        for (int k = 0; k < 150; ++k) {
            settings.gravity = 9.81 * pointer.at(k * settings.h).cwiseQuotient(scene.half_size);
            stabilized_step(scene, settings, now);
            std::printf("%d %d", k, static_cast<int>(now.visits));
            for (Index i = 0; i < scene.bodies.x.size(); ++i)
                std::printf(" %a %a", scene.bodies.x[i], scene.bodies.u[i]);
            std::printf("\n");
        }
    }
}
