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
    for (const Order order : {Order::given, Order::alternating, Order::shuffled, Order::coloured}) {
        DiscScene scene = ten_discs();
        const ScriptedPointer pointer(1, {{0, 0}, scene.half_size});
        StepSettings settings{.h = 1.0 / 480, .stiffness = 1, .damping = 1};
        ImpulseMethod method;
        method.correction.restitution = 0.3;
        method.solver.ordering = order;
        method.solver.sweeps = {.max_sweeps = 30, .tolerance = 1e-6};
        StepData<2> now;
        for (int k = 0; k < 300; ++k) {
            scene.gravity = 9.81 * pointer.at(k * settings.h).cwiseQuotient(scene.half_size);
            method.solver.in_pairs = k >= 200;
            step(scene, settings, method, now);
            print(k, now.solution, scene.bodies);
        }
    }
    for (const ImpactOrder law : {ImpactOrder::simultaneous, ImpactOrder::sequential}) {
        DiscScene scene = cradle(5, 1, 0.5);
        const StepSettings settings{.h = 1.0 / 240};
        ImpactStep now;
        now.restitution = 1;
        for (int k = 0; k < 300; ++k) {
            impact_step(scene, settings, law, now);
            print(k, now.solution, scene.bodies);
        }
    }
}
