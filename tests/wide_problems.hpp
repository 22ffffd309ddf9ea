/// \file wide_problems.hpp
/// Rows for wide sweeps, and what a solver makes of them.
#pragma once

#include "chapters/12_contact_manifolds/stacks.hpp"
#include "chapters/13_friction/houses.hpp"
#include "chapters/17_wide_sweeps/wide_method.hpp"
#include "common/random.hpp"

#include <vector>

namespace rigid {

/// Bodies in a line, and rows between neighbours.
inline std::vector<Row<2>> line_rows(Index bodies)
{
    std::vector<Row<2>> rows;
    for (Index k = 0; k + 1 < bodies; ++k) {
        Constraint<2> c;
        c.a = k, c.b = k + 1;
        c.Ja = {-1, 0}, c.Jb = {1, 0};
        rows.push_back(bilateral(c, VecX::Ones(2 * bodies)));
    }
    return rows;
}

/// A pyramid with friction after some steps of chapter 13, whose rows are to be solved.
struct Problem {
    JointedScene scene;
    StepData<3> now;
};

inline Problem pyramid_problem(int base)
{
    Problem p;
    static_cast<RigidScene&>(p.scene) = box_pyramid(base);
    cover(p.scene, {0.6, 0, 0, 0});
    JointSweeps<Manifolds> method;
    method.correction = steady_contacts();
    for (int i = 0; i < 3; ++i) step(p.scene, {.h = 1.0 / 60}, method, p.now);
    return p;
}

/// Rows of all kinds between random bodies, some of which cannot move: friction, soft rows, rows of the world.
inline std::vector<Row<3>> random_rows(Random& random, Index bodies, int contacts, VecX& inverse_mass)
{
    inverse_mass = VecX::Zero(3 * bodies);
    for (Index k = 0; k < bodies; ++k)
        if (random.index(6) > 0)
            for (int d = 0; d < 3; ++d) inverse_mass[3 * k + d] = random.uniform(0.2, 3);
    std::vector<Row<3>> rows;
    for (int i = 0; i < contacts; ++i) {
        Constraint<3> c;
        c.a = random.index(bodies + 1) - 1;
        c.b = random.index(bodies - 1);
        if (c.b >= c.a) ++c.b;
        for (int d = 0; d < 3; ++d) {
            if (c.a != world) c.Ja[d] = random.uniform(-1, 1);
            c.Jb[d] = random.uniform(-1, 1);
        }
        Row<3> normal = unilateral(c, inverse_mass, random.uniform(-1, 0.2));
        if (random.index(4) == 0) normal.softness = random.uniform(0, 1);
        rows.push_back(normal);
        if (random.index(3) == 0) continue;
        for (int d = 0; d < 3; ++d) c.Jb[d] = random.uniform(-1, 1);
        Row<3> drag = bilateral(c, inverse_mass, 0.1);
        drag.bounded_by = static_cast<int>(rows.size()) - 1;
        drag.friction = random.uniform(0, 1);
        rows.push_back(drag);
    }
    return rows;
}

struct Answer {
    VecX lambda, u;
    int iterations = 0;
    Status status = Status::iteration_limit;
    Real residual = infinity;
};

inline bool same(const Answer& a, const Answer& b)
{
    return (a.lambda.array() == b.lambda.array()).all() && (a.u.array() == b.u.array()).all() &&
           a.iterations == b.iterations;
}

template <class Solver>
Answer answer(Problem p, Solver solver, int sweeps, Real tolerance = 0)
{
    solver.sweeps.max_sweeps = sweeps;
    solver.sweeps.tolerance = tolerance;
    p.now.substep = 0;
    p.now.same_rows = false;
    solver.solve(p.scene.bodies, p.now);
    return {p.now.solution.lambda, p.scene.bodies.u, p.now.solution.iterations, p.now.solution.status,
            p.now.solution.residual};
}

}  // namespace rigid
