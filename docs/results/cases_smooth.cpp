// Smooth motion: Kepler's orbit and a pendulum; the pendulum also as a disc on a rod, the way every scene with
// joints is stepped.
//
// error: distance from the exact place at the end [m], from the closed forms of chapter 1.
#include "docs/results/cases.hpp"
#include "docs/results/exact_solvers.hpp"

#include "chapters/01_euler_integration/adaptive.hpp"
#include "chapters/01_euler_integration/exact.hpp"
#include "chapters/02_velocity_constraints/geometry.hpp"
#include "chapters/03_mlcp_formulation/disc_step.hpp"

#include <memory>

namespace rigid::results {
namespace {

const char* const per_force = "unit=force_evaluation reference=closed_form";

/// A motion without constraints. Its place is a point of the plane, so that all scenes have errors in metres.
template <class A, int N>
struct Motion {
    std::string scene, parameters;
    A a;
    State<N> start;
    Real T;
    Index least;  ///< force evaluations of the coarsest run
    std::function<Real(const State<N>&)> error;
};

template <int N, class Run>
Task fixed_task(const Run& run, Index evaluations, const std::function<Real(const State<N>&)>& error)
{
    auto end = std::make_shared<State<N>>();
    return {[=] { *end = run(); },
            [=] {
                const Real distance = error(*end);
                const bool fine = std::isfinite(distance);
                return Result{evaluations, {}, fine ? distance : infinity, fine ? "finished" : "not finite"};
            },
            {}};
}

/// The fixed-step methods of chapter 1 under one name each: force evaluations a step, and the march.
template <class A, int N>
void add_fixed(Registry& registry, const Motion<A, N>& motion)
{
    using Run = std::function<State<N>(Real, Index)>;
    const A a = motion.a;
    const State<N> s = motion.start;
    const std::tuple<const char*, Index, Run> methods[] = {
        {"explicit_euler", 1,
         [=](Real h, Index n) {
             return march(s, h, n, [a](const State<N>& y, Real k) { return explicit_euler(y, k, a); });
         }},
        {"symplectic_euler", 1,
         [=](Real h, Index n) {
             return march(s, h, n, [a](const State<N>& y, Real k) { return symplectic_euler(y, k, a); });
         }},
        {"verlet", 1,
         [=](Real h, Index n) {
             return march(s, h, n, [a, now = a(s.x)](const State<N>& y, Real k) mutable {
                 return velocity_verlet(y, now, k, a);
             });
         }},
        {"yoshida4", 3,
         [=](Real h, Index n) {
             return march(s, h, n, [a](const State<N>& y, Real k) { return yoshida4(y, k, a); });
         }},
        {"rk4", 4, [=](Real h, Index n) {
             return march(s, h, n, [a](const State<N>& y, Real k) { return rk4(y, k, a); });
         }}};
    for (const auto& [name, per_step, run] : methods)
        for (int doubling = 0; doubling < 10; ++doubling) {
            const Index steps = (motion.least << doubling) / per_step;
            const Real h = motion.T / static_cast<Real>(steps);
            registry.add({"1", name, motion.scene, motion.parameters + ' ' + per_force, h, doubling == 3,
                          [=, run = run, evaluations = steps * per_step, error = motion.error] {
                              return fixed_task<N>([=] { return run(h, steps); }, evaluations, error);
                          }});
        }
}

template <class A, int N>
void add_adaptive(Registry& registry, const Motion<A, N>& motion)
{
    for (int digits = 2; digits <= 12; ++digits) {
        const Real tolerance = std::pow(10, -digits);
        registry.add({"1", "dormand_prince", motion.scene,
                      motion.parameters + " tolerance=1e-" + std::to_string(digits) + ' ' + per_force, 0,
                      digits == 6, [=] {
                          auto run = std::make_shared<Adaptive<N>>();
                          auto outcome = std::make_shared<Outcome>();
                          const Tolerance allowed{tolerance, tolerance, tolerance};
                          return Task{[=] {
                                          *run = start_adaptive(motion.start, motion.a, allowed);
                                          *outcome = integrate(*run, motion.T, motion.a, allowed);
                                      },
                                      [=] {
                                          const bool there = *outcome == Outcome::reached;
                                          return Result{run->evaluations,
                                                        {},
                                                        motion.error(run->s),
                                                        there ? "finished" : to_string(*outcome)};
                                      },
                                      {}};
                      }});
    }
}

// ---- the pendulum on a rod: a disc of 1 kg, 1 m from a point that does not move -----------------------------

constexpr Real swing_time = 2;  // [s], from 90 degrees

Vec2 exact_place()
{
    const Real angle = exact_pendulum(Pendulum{}, pi / 2, swing_time).x[0];
    return {std::sin(angle), -std::cos(angle)};
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
    const Kepler kepler;
    const Motion<Kepler, 2> orbit{
        "kepler", "e=0.6 T=50", kepler, kepler_perihelion(kepler, 0.6), 50, 800, [=](const State<2>& s) {
            return (s.x - exact_kepler(kepler, 0.6, 50).x).norm();
        }};
    add_fixed(registry, orbit);
    add_adaptive(registry, orbit);

    const Pendulum pendulum;
    const Motion<Pendulum, 1> swing{
        "pendulum",
        "angle=90 T=2",
        pendulum,
        {Vec<1>(pi / 2), Vec<1>(0)},
        swing_time,
        60,
        [](const State<1>& s) { return (Vec2(std::sin(s.x[0]), -std::cos(s.x[0])) - exact_place()).norm(); }};
    add_fixed(registry, swing);
    add_adaptive(registry, swing);

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
            DiscSettings settings;
            settings.h = h;
            return [settings, now = DiscStep()](DiscScene& scene) mutable {
                step(scene, settings, solve_direct, now);
            };
        },
        1);
}

}  // namespace rigid::results
