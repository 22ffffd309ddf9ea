/// Prints every bit of some hundred steps in each order of the rows. Built without and with optimisation: the output
/// must be the same.

#include "chapters/06_sequential_impulse/block.hpp"
#include "chapters/06_sequential_impulse/small_scenes.hpp"
#include "common/program/scripted_pointer.hpp"

#include <cstdio>

using namespace rigid;

namespace {

void print(int k, const Solution& solution, const Bodies<2>& bodies)
{
    std::printf("%d %d %a", k, solution.iterations, solution.residual);
    for (Index i = 0; i < bodies.x.size(); ++i) std::printf(" %a %a", bodies.x[i], bodies.u[i]);
    std::printf("\n");
}

}  // namespace

int main()
{
    std::vector<Block> blocks;
    for (const Order order : {Order::given, Order::alternating, Order::shuffled, Order::coloured}) {
        DiscScene scene = ten_discs();
        const ScriptedPointer pointer(1, {{0, 0}, scene.half_size});
        ImpulseStepSettings settings;
        settings.h = 1.0 / 480;
        settings.stiffness = 1;
        settings.damping = 1;
        settings.restitution = 0.3;
        settings.order = order;
        settings.sweeps = {30, 1e-6, false};
        ImpulseStep now;
        const auto by_blocks = [&blocks](const std::vector<Row<2>>& rows, std::span<const int> places,
                                         const ImpulseSettings& sweeps, ImpulseMemory<2>& memory, VecX& u,
                                         Solution& solution) {
            block_impulse<2>(rows, places, sweeps, memory, blocks, u, solution);
        };
        for (int k = 0; k < 300; ++k) {
            settings.gravity = 9.81 * pointer.at(k * settings.h).cwiseQuotient(scene.half_size);
            if (k < 200) impulse_step(scene, settings, now);
            else impulse_step(scene, settings, by_blocks, now);
            print(k, now.solution, scene.bodies);
        }
    }
    for (const ImpactLaw law : {ImpactLaw::simultaneous, ImpactLaw::sequential}) {
        DiscScene scene = cradle(5, 1, 0.5);
        ImpulseStepSettings settings;
        settings.h = 1.0 / 240;
        settings.restitution = 1;
        ImpactStep now;
        for (int k = 0; k < 300; ++k) {
            impact_step(scene, settings, law, now);
            print(k, now.solution, scene.bodies);
        }
    }
}
