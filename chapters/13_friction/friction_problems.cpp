// The functions of friction_problems.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/13_friction/friction_problems.hpp"

namespace rigid {

void add_contact(FrictionRows& problem, Index a, Index b, const Vec2& n,
                 const Vec2& arm_a, const Vec2& arm_b, Real mu)
{
    const auto number = static_cast<int>(problem.rows.size());
    problem.rows.push_back(
        contact_row(a, b, n, arm_a, arm_b, problem.inverse_mass));
    Row<3> friction =
        contact_row(a, b, perpendicular(n), arm_a, arm_b, problem.inverse_mass);
    friction.lo = -infinity;
    friction.bounded_by = number;
    friction.friction = mu;
    problem.rows.push_back(friction);
}

FrictionRows random_rubble(Random& random, int contacts, Real most_mu, Real jostle)
{
    FrictionRows problem;
    const auto width = static_cast<Index>(1 + std::sqrt(contacts / 3.0));
    const Index bodies = std::max<Index>(1, contacts / 2);
    problem.inverse_mass.resize(3 * bodies);
    problem.u_star.resize(3 * bodies);
    for (Index k = 0; k < bodies; ++k) {
        const Real mass = random.uniform(0.5, 5),
                   inertia = mass * random.uniform(0.05, 0.3);
        problem.inverse_mass.segment<3>(3 * k) << 1 / mass, 1 / mass, 1 / inertia;
        for (Index d = 0; d < 3; ++d)
            problem.u_star[3 * k + d] = jostle * random.uniform(-1, 1);
        problem.u_star[3 * k + 1] -= 9.81 / 60;
    }
    int left = contacts;
    for (Index b = 0; b < bodies && left > 0; ++b)
        for (int side = 0; side < 2 && left > 0; ++side) {
            const Index a = b < width ? world : std::min(b - 1, b - width + side);
            if (a == world && side == 1) continue;
            const Real tilt =
                a == world ? 0
                           : (side == 0 ? -0.5 : 0.5) + random.uniform(-0.4, 0.4);
            const Vec2 n(-sin(tilt), cos(tilt));
            const int points = random.uniform() < 0.5 ? 1 : 2;
            const Real mu = random.uniform(0, most_mu),
                       near = random.uniform(0.3, 0.5);
            for (int i = 0; i < points && left > 0; ++i, --left) {
                const Real off =
                    points == 1 ? random.uniform(-0.3, 0.3) : (i == 0 ? -0.4 : 0.4);
                const Vec2 along = off * perpendicular(n);
                add_contact(problem, a, b, n, near * n + along, -near * n + along,
                            mu);
            }
        }
    return problem;
}

}  // namespace rigid
