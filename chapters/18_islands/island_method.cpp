// The functions of island_method.hpp, and its step.
#include "common/eigen_instances.hpp"

#include "chapters/18_islands/island_method.hpp"

#include <stdexcept>
#include <string>

namespace rigid {

void change(IslandMethod& method, const IslandSettings& settings)
{
    if (settings.substeps < 1)
        throw std::invalid_argument("the islands share out " +
                                    std::to_string(settings.substeps) +
                                    " sub-steps; there must be 1 or more");
    method.contacts.sleep = settings.sleep;
    method.correction.push_sweeps = settings.sweeps;
    IslandChoice& solver = method.solver;
    solver.solving = settings.solving;
    solver.most_exact = solver.rule.at_most;
    solver.heaps.substeps = settings.substeps;
    solver.slow = 10 * method.contacts.rest.speed;
    solver.sweeps.max_sweeps = settings.sweeps;
    solver.sweeps.tolerance = solver.tolerance;
    solver.all.anew = true;
}

IslandMethod island_method(const JointedScene& scene,
                           const IslandSettings& settings)
{
    IslandMethod made;
    Manifolds& touching = made.contacts.touching;
    touching.ahead = 1;
    touching.fast.goes_on.assign(static_cast<std::size_t>(scene.bodies.count()), 0);
    for (const PlacedJoint& placed : scene.placed)
        for (const Index k : {placed.joint.a, placed.joint.b})
            if (k != world) touching.fast.goes_on[static_cast<std::size_t>(k)] = 1;
    change(made, settings);
    return made;
}

template void step(JointedScene&, const StepSettings&, IslandMethod&, StepData<3>&);

}  // namespace rigid
