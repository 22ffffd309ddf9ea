// Heaps: triangles of discs at rest, up to a thousand of them, and the ten discs in the middle of their tumble.
//
// reference of a triangle: at rest, u = 0. Its impulses are not unique, the velocities are.
// reference of the ten discs: chapter 3's enumeration of all sets of cases; of the enumeration itself, Lemke's walk.
#include "docs/results/cases.hpp"
#include "docs/results/exact_solvers.hpp"

#include "chapters/03_mlcp_formulation/step.hpp"
#include "common/program/scripted_pointer.hpp"

namespace rigid::results {
namespace {

void add_triangle(Registry& registry, Index base)
{
    StepScene heap;
    const DiscScene scene = triangle(base);
    heap.scene = "triangle";
    heap.parameters = "base=" + std::to_string(base) + " discs=" + std::to_string(scene.bodies.count());
    heap.reference = "rest";
    heap.most_sweeps = 4096;
    heap.all_ways = base == 10;
    heap.steps.push_back(resting_step(scene, heap.fall / 9.81));
    add_solvers(registry, heap);
}

/// Sixty steps that follow each other, a second after the beginning, under the seeded pointer that steers gravity;
/// the state moves on by the reference, so that no method pays for what another one did.
StepScene tumble(bool by_enumeration)
{
    DiscScene scene = ten_discs();
    const ScriptedPointer pointer(1, {{0, 0}, {0.8, 0.57}});
    StepSettings settings{.h = 1.0 / 480};
    settings.stiffness = 1;
    settings.damping = 1;
    StepData<2> now;
    StepScene result;
    result.scene = "ten_discs";
    result.parameters = "steps=60";
    result.reference = by_enumeration ? "enumeration" : "lemke";
    result.fall = 9.81 * settings.h;
    result.most_sweeps = 4096;
    result.all_ways = true;
    constexpr int first = 1200, count = 60;
    for (int k = 0; k < first + count; ++k) {
        const Vec2 tilt = pointer.at(k * settings.h).cwiseQuotient(scene.half_size);
        scene.gravity = 9.81 * tilt / std::max(Real{1}, tilt.norm());
        step(scene, settings, by_matrix(by_enumeration && k >= first ? solve_by_cases : solve_by_lemke), now);
        if (now.solution.status != Status::solved)
            throw std::logic_error("the reference of the ten discs is not solved in step " +
                                   std::to_string(k));
        if (k < first) continue;
        OneStep one{now.rows, {}, now.u_star, scene.bodies.u};
        for (std::size_t i = 0; i < scene.links.size(); ++i) one.keys.push_back(link_key(i));
        for (const Contact& contact : now.contacts) one.keys.push_back(contact_key(contact));
        result.steps.push_back(std::move(one));
    }
    return result;
}

}  // namespace

void add_heaps(Registry& registry)
{
    for (const Index base : {10, 44}) add_triangle(registry, base);
    add_solvers(registry, tumble(true));
    // The enumeration is not measured against itself.
    const auto other = std::make_shared<const StepScene>(tumble(false));
    add_exact(registry, other, "3", "enumeration", "case_set", solve_by_cases);
}

}  // namespace rigid::results
