// The functions of island_method.hpp, and its step.
#include "common/eigen_instances.hpp"

#include "chapters/18_islands/island_method.hpp"

#include <stdexcept>
#include <string>

namespace rigid {

void require_valid(const HeapSteps& how)
{
    const auto refuse = [](const std::string& what, const std::string& right) {
        throw std::invalid_argument("small steps of a heap: " + what +
                                    "; it must be " + right);
    };
    const std::pair<const char*, int> counts[] = {
        {"least", how.least}, {"visits", how.visits}, {"substeps", how.substeps}};
    for (const auto& [name, value] : counts)
        if (value < 1)
            refuse(std::string(name) + " is " + std::to_string(value),
                   "one or more");
    const std::pair<const char*, int> limits[] = {{"most", how.most},
                                                  {"again", how.again}};
    for (const auto& [name, value] : limits)
        if (value < 0)
            refuse(std::string(name) + " is " + std::to_string(value),
                   "zero or more");
    const std::pair<const char*, Real> numbers[] = {
        {"beta", how.beta}, {"fastest", how.fastest}, {"slop", how.slop},
        {"open", how.open}, {"slow", how.slow},       {"slowest", how.slowest}};
    for (const auto& [name, value] : numbers)
        if (!(value >= 0))
            refuse(std::string(name) + " is " + shortest(value),
                   "zero or positive");
    if (how.beta > 1) refuse("beta is " + shortest(how.beta), "at most 1");
}

void IslandChoice::require_valid() const
{
    if (!(tolerance > 0) || !std::isfinite(tolerance))
        throw std::invalid_argument("the tolerance of the islands is " +
                                    shortest(tolerance) +
                                    "; it must be positive and finite");
    rigid::require_valid(sweeps);
    rigid::require_valid(heaps);
    if (!(slow >= 0))
        throw std::invalid_argument("islands are slow below " + shortest(slow) +
                                    " l/s; it must be zero or positive");
}

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
