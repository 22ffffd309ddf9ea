// Smooth motion: Kepler's orbit and a pendulum; the pendulum also as a disc on a rod, the way every scene with
// joints is stepped.
//
// error: distance from the exact place at the end [m], from the closed forms of chapter 1.
#include "docs/results/cases.hpp"
#include "docs/results/exact_solvers.hpp"

#include "chapters/01_euler_integration/benchmark/measured.hpp"
#ifdef RIGID_HAS_ODEINT
#include "chapters/01_euler_integration/benchmark/peers_odeint.hpp"
#endif
#include "chapters/02_velocity_constraints/geometry.hpp"
#include "chapters/03_mlcp_formulation/step.hpp"
#include "common/elementary.hpp"

#include <memory>

namespace rigid::results {
namespace {

template <class Run, class Error>
Task place_task(const Run& run, Index evaluations, const Error& error)
{
    auto end = std::make_shared<decltype(run())>();
    return {[=] { *end = run(); },
            [=] {
                const Real distance = error(*end);
                const bool fine = std::isfinite(distance);
                return Result{evaluations, {}, fine ? distance : infinity, fine ? "finished" : "not finite"};
            },
            {}};
}

/// The fixed steps of chapter 1, and odeint's where it is installed. An angle of 1 rad is 1 m of the circle.
template <class Problem>
void add_fixed(Registry& registry, const std::string& scene, const std::string& parameters,
               const Problem& problem, Index least)
{
    const auto error = [exact = problem.exact()](const auto& place) { return (place - exact).norm(); };
    for (const Method method : all_methods) {
        if (method == Method::dormand_prince) continue;
        for (int doubling = 0; doubling < 10; ++doubling) {
            const Index steps = (least << doubling) / evaluations_per_step(method);
            const Index work = steps * evaluations_per_step(method);
            const Real h = problem.T / static_cast<Real>(steps);
            const std::string all = parameters + " unit=force_evaluation reference=closed_form";
            registry.add({"1", name_of(method), scene, all, h, doubling == 3, [=] {
                              return place_task(
                                  [=] { return run_fixed(method, problem.start(), h, steps, problem.a); },
                                  work, [=](const State<Problem::N>& s) { return error(s.x); });
                          }});
#ifdef RIGID_HAS_ODEINT
            registry.add(
                {"peer", std::string("odeint_") + name_of(method), scene, all, h, false, [=] {
                     return place_task(
                         [=] { return Odeint<Problem>::run_fixed(method, problem.start(), h, steps); }, work,
                         error);
                 }});
#endif
        }
    }
}

/// The adaptive pair, and odeint's with the same tolerances and the same first step.
template <class Problem>
void add_adaptive(Registry& registry, const std::string& scene, const std::string& parameters,
                  const Problem& problem)
{
    constexpr int N = Problem::N;
    const auto error = [exact = problem.exact()](const auto& place) { return (place - exact).norm(); };
    for (int digits = 2; digits <= 12; ++digits) {
        const Real tolerance = pow(10, -digits);
        const std::string given = parameters + " tolerance=1e-" + std::to_string(digits);
        registry.add({"1", "dormand_prince", scene, given + " unit=force_evaluation reference=closed_form", 0,
                      digits == 6, [=] {
                          auto run = std::make_shared<Adaptive<N>>();
                          const auto go = [=] {
                              *run = run_adaptive(problem.start(), problem.T, tolerance, problem.a);
                          };
                          const auto judge = [=] {
                              return Result{run->evaluations, {}, error(run->s.x), "finished"};
                          };
                          return Task{go, judge, {}};
                      }});
#ifdef RIGID_HAS_ODEINT
        registry.add({"peer", "odeint_dormand_prince", scene, given + " unit=none reference=closed_form", 0,
                      false, [=] {
                          const Real first = start_at(problem.start(), tolerance, problem.a).h;
                          auto end = std::make_shared<Vec<N>>();
                          const auto go = [=] {
                              *end =
                                  Odeint<Problem>::run_adaptive(problem.start(), problem.T, tolerance, first);
                          };
                          const auto judge = [=] { return Result{{}, {}, error(*end), "finished"}; };
                          return Task{go, judge, {}};
                      }});
#endif
    }
}

// ---- the pendulum on a rod: a disc of 1 kg, 1 m from a point that does not move -----------------------------

constexpr Real swing_time = 2;  // [s], from 90 degrees

Vec2 exact_place()
{
    const Real angle = exact_pendulum(Pendulum{}, pi / 2, swing_time).x[0];
    return {sin(angle), -cos(angle)};
}

/// A task that steps a disc on a rod; step(scene, h) does one step.
template <class MakeStep>
void add_rod(Registry& registry, const std::string& chapter, const std::string& method,
             const std::string& parameters, const MakeStep& make_step, Index work_per_step, int finest = 9)
{
    for (int doubling = 0; doubling <= finest; ++doubling) {
        const Index steps = Index{120} << doubling;
        const Real h = swing_time / static_cast<Real>(steps);
        registry.add({chapter, method, "pendulum_on_a_rod",
                      "angle=90 T=2 " + parameters + "reference=closed_form", h, doubling == 3, [=] {
                          DiscScene start = swinging_chain(1);
                          start.links[0].length = 1;
                          start.bodies.position(1) << 1, 0;
                          auto scene = std::make_shared<DiscScene>(start);
                          auto step = std::make_shared<decltype(make_step(h))>(make_step(h));
                          return Task{[=] {
                                          scene->bodies = start.bodies;
                                          for (Index k = 0; k < steps; ++k) (*step)(*scene);
                                      },
                                      [=] {
                                          const Real error =
                                              (scene->bodies.position(1) - exact_place()).norm();
                                          const bool fine = std::isfinite(error);
                                          return Result{work_per_step * steps,
                                                        {},
                                                        fine ? error : infinity,
                                                        fine ? "finished" : "not finite"};
                                      },
                                      {}};
                      }});
    }
}

}  // namespace

void add_smooth_motion(Registry& registry)
{
    const KeplerProblem orbit{{}, 50};
    add_fixed(registry, "kepler", "e=0.6 T=50", orbit, 800);
    add_adaptive(registry, "kepler", "e=0.6 T=50", orbit);
    const PendulumProblem swing{{}, swing_time};
    add_fixed(registry, "pendulum", "angle=90 T=2", swing, 60);
    add_adaptive(registry, "pendulum", "angle=90 T=2", swing);

    // Chapter 2: one row, its error of position left alone or asked back.
    for (const bool repay : {false, true})
        add_rod(
            registry, "2", repay ? "one_row_repaid" : "one_row", "unit=row_visit ",
            [=](Real h) {
                return [=](DiscScene& scene) {
                    Bodies<2>& bodies = scene.bodies;
                    bodies.velocity(1) += h * scene.gravity;
                    const Constraint<2> rod = distance_constraint(bodies.x, scene.links[0]);
                    const rigid::Row<2> row = bilateral(rod, bodies.inverse_mass, repay ? rod.C / h : 0);
                    row.apply(solve_row(row, bodies.u).lambda, bodies.u);
                    bodies.x += h * bodies.u;
                };
            },
            1);
    // Chapter 3: the whole step, contacts looked for, A assembled, and factored.
    add_rod(
        registry, "3", "direct", "unit=factorisation ",
        [](Real h) {
            return [settings = StepSettings{.h = h}, now = StepData<2>(), method = by_matrix(solve_direct)](
                       DiscScene& scene) mutable { step(scene, settings, method, now); };
        },
        1);
}

}  // namespace rigid::results
