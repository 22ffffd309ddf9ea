/// \file force_problems.hpp
/// (26.5) of some scenes where they start, and the solvers of other programs on it: they are given A, q and the bounds, no scene.
///
///     no friction    ODE's and Bullet's Dantzig, Siconos' Lemke; A may be any matrix for the last alone
///     friction       Siconos' planar solvers: Lemke, and its sweeps
///
/// An answer's error is its natural residual, with the bounds that it sets itself.
#pragma once

#include "chapters/05_lemke/lemke.hpp"
#include "chapters/09_active_sets/dantzig.hpp"
#include "chapters/12_contact_manifolds/stacks.hpp"
#include "chapters/13_friction/coulomb_residual.hpp"
#include "chapters/13_friction/friction_solver.hpp"
#include "chapters/26_four_ways/acceleration_level.hpp"
#include "chapters/26_four_ways/way_scenes.hpp"

#include "chapters/09_active_sets/benchmark/peers.hpp"
#ifdef RIGID_HAS_SICONOS
#include "chapters/13_friction/benchmark/peers_siconos.hpp"
#endif

#include <string>
#include <vector>

namespace rigid {

struct ForceProblem {
    std::string name;
    Mlcp mlcp;
    std::vector<FrictionBox> boxes;
    Solution ours;  ///< of AccelerationLevel itself

    Real residual(const VecX& f) const
    {
        if (!f.allFinite()) return infinity;
        Mlcp copy = mlcp;
        return coulomb_residual(copy, boxes, f);
    }
};

/// The problem of the forces where a scene is.
inline ForceProblem force_problem(const std::string& name,
                                  const JointedScene& scene)
{
    AccelerationLevel level;
    level.close(scene, 0.05 * typical_length(scene));
    VecX a;
    ForceProblem one;
    one.name = name;
    one.ours.status = level.accelerations(scene, scene.bodies.x, scene.bodies.u, a);
    one.ours.lambda = level.forces();
    one.mlcp = level.problem();
    one.boxes = level.boxes();
    return one;
}

/// A stack of N boxes without friction.
inline JointedScene smooth_stack(int boxes)
{
    JointedScene scene;
    static_cast<RigidScene&>(scene) = box_stack(boxes);
    return scene;
}

inline std::vector<ForceProblem> force_problems()
{
    return {force_problem("5 smooth boxes", smooth_stack(5)),
            force_problem("20 smooth boxes", smooth_stack(20)),
            force_problem("80 smooth boxes", smooth_stack(80)),
            force_problem("stack of five", stack_of_five().scene),
            force_problem("block on a slope", sliding_block().scene),
            force_problem("Painleve's rod", jammed_rod().scene)};
}

/// What a solver made of a problem.
struct Forces {
    VecX f;
    Real us = 0;
    bool ran = true;  ///< false: it is not here, or the problem not of its kind
};

/// How a program solves it; one that is not installed is not in the list.
struct ForceSolver {
    std::string name;
    Forces (*solve)(const ForceProblem&);
};

inline Forces of(const peers::Answer& answer)
{
    return {answer.lambda, answer.us, answer.ran};
}

inline bool is_plain(const ForceProblem& problem) { return problem.boxes.empty(); }
/// Dantzig's method is one of symmetric matrices.
inline bool is_dantzigs(const ForceProblem& problem)
{
    const MatX A = problem.mlcp.A;
    return is_plain(problem) && A == MatX(A.transpose()) &&
           (A.diagonal().array() > 0).all();
}

/// This chapter's: Dantzig's without friction, else guesses; with one contact that slides, Lemke's.
inline Forces forces_of_this_book(const ForceProblem& problem)
{
    Mlcp mlcp = problem.mlcp;
    Solution found;
    found.lambda.setZero(mlcp.size());
    FindFriction find;
    const Real us = microseconds([&] {
        if (is_dantzigs(problem)) found = dantzig(mlcp);
        else if (is_plain(problem)) found = lemke(mlcp);
        else find(mlcp, problem.boxes, 1e-9, found);
    });
    return {found.lambda, us, true};
}

#ifdef RIGID_HAS_SICONOS
/// \param most  pivots, sweeps
inline Forces by_siconos(const ForceProblem& problem, int solver, int most)
{
    Forces forces;
    forces.us = peers::siconos(problem.mlcp, problem.boxes, solver, most, forces.f);
    return forces;
}
#endif

inline std::vector<ForceSolver> force_solvers()
{
    std::vector<ForceSolver> solvers{{"this_book", forces_of_this_book}};
#ifdef RIGID_HAS_ODE
    solvers.push_back({"ODE", [](const ForceProblem& problem) {
                           if (!is_dantzigs(problem)) return Forces{{}, 0, false};
                           return of(peers::ode(peers::FreeFirst(problem.mlcp)));
                       }});
#endif
#ifdef RIGID_HAS_BULLET
    solvers.push_back({"Bullet", [](const ForceProblem& problem) {
                           if (!is_dantzigs(problem)) return Forces{{}, 0, false};
                           return of(peers::bullet(peers::FreeFirst(problem.mlcp)));
                       }});
#endif
#ifdef RIGID_HAS_SICONOS
    solvers.push_back(
        {"Siconos_Lemke", [](const ForceProblem& problem) {
             if (is_plain(problem))
                 return of(peers::siconos(peers::FreeFirst(problem.mlcp)));
             return by_siconos(problem, SICONOS_FRICTION_2D_LEMKE, 10'000);
         }});
    solvers.push_back({"Siconos_sweeps", [](const ForceProblem& problem) {
                           if (is_plain(problem)) return Forces{{}, 0, false};
                           return by_siconos(problem, SICONOS_FRICTION_2D_NSGS,
                                             20'000);
                       }});
#endif
    return solvers;
}

}  // namespace rigid
