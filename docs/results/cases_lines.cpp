// Lines: chains that hang and columns that stand. The impulses of one step under gravity.
//
// reference: everything is at rest and stays at rest, u = 0.
#include "docs/results/cases.hpp"
#include "docs/results/one_step.hpp"

#include "chapters/02_velocity_constraints/geometry.hpp"
#include "chapters/04_pgs/rates.hpp"
#include "common/elementary.hpp"

namespace rigid::results {

OneStep resting_step(const DiscScene& scene, Real h)
{
    OneStep step;
    std::vector<Contact> contacts;
    // What touches, with a hair's breadth for the rounding of the positions; the walls' rows first: bottom-up.
    find_contacts(scene, 1e-9, contacts);
    std::stable_partition(contacts.begin(), contacts.end(), [](const Contact& c) { return c.a == world; });
    for (const Link& link : scene.links)
        step.rows.push_back(bilateral(distance_constraint(scene.bodies.x, link), scene.bodies.inverse_mass));
    for (const Contact& contact : contacts)
        step.rows.push_back(unilateral(contact_constraint(contact), scene.bodies.inverse_mass));
    for (std::size_t i = 0; i < scene.links.size(); ++i) step.keys.push_back(link_key(i));
    for (const Contact& contact : contacts) step.keys.push_back(contact_key(contact));
    step.u_star = VecX::Zero(scene.bodies.u.size());
    for (Index k = 0; k < scene.bodies.count(); ++k)
        if (scene.bodies.inverse_mass[2 * k] > 0) step.u_star.segment<2>(2 * k) = h * scene.gravity;
    step.exact_u = VecX::Zero(step.u_star.size());
    return step;
}

namespace {

/// Sweeps of Gauss-Seidel after which the error is below 1e-12, by its rate.
long sweeps_needed(Real rate) { return static_cast<long>(log(1e-12) / log(rate)); }

void add_line(Registry& registry, const std::string& name, const DiscScene& scene, Index rows, Real end_mass,
              const std::string& parameters)
{
    StepScene line;
    line.scene = name;
    line.parameters = parameters;
    line.reference = "rest";
    line.bilateral = !scene.links.empty();
    const Real rate = line_rate(rows, end_mass);
    line.omega = best_omega(rate);
    line.most_sweeps = sweeps_needed(rate);
    line.enumerable = !line.bilateral && rows <= 10;
    line.all_ways = rows == 20 || rows == 40;
    line.steps.push_back(resting_step(scene, line.fall / 9.81));
    add_solvers(registry, line);
}

}  // namespace

void add_lines(Registry& registry)
{
    for (const Index links : {10, 40, 200})
        for (const int mass : {1, 10, 100, 1000})
            add_line(registry, "chain", hanging_chain(links, mass), links, mass,
                     "links=" + std::to_string(links) + " end_mass=" + std::to_string(mass));
    for (const Index discs : {10, 20})
        for (const int mass : {1, 100, 10000})
            add_line(registry, "column", column(discs, mass), discs, mass,
                     "discs=" + std::to_string(discs) + " top_mass=" + std::to_string(mass));
}

}  // namespace rigid::results
