// A ball that bounces: let go 1 m above the ground, restitution 0.8.
//
// error: of the height after 2 s [m], when it has bounced three times. reference: parabolas, in closed form.
#include "docs/results/cases.hpp"

#include "chapters/01_euler_integration/event.hpp"
#include "chapters/01_euler_integration/systems.hpp"
#include "chapters/06_sequential_impulse/impulse_method.hpp"
#include "common/elementary.hpp"

#include <memory>

namespace rigid::results {
namespace {

constexpr Real g = 9.81, drop = 1, restitution = 0.8, end_time = 2;
const std::string scene_parameters = "drop=1 e=0.8 T=2";

/// Bounce by bounce: each flight begins with e times the speed of the last.
Real exact_height()
{
    Real t = std::sqrt(2 * drop / g), speed = restitution * g * t;
    while (t + 2 * speed / g <= end_time) {
        t += 2 * speed / g;
        speed *= restitution;
    }
    const Real flight = end_time - t;
    return speed * flight - g * flight * flight / 2;
}

Result judged(Real height, std::int64_t work, const char* status)
{
    const Real error = std::abs(height - exact_height());
    return {work, {}, std::isfinite(error) ? error : infinity, std::isfinite(error) ? status : "not finite"};
}

void add_events(Registry& registry)
{
    for (int digits = 2; digits <= 12; digits += 2) {
        const Real tolerance = pow(10, -digits);
        const std::string parameters = scene_parameters + " tolerance=1e-" + std::to_string(digits) +
                                       " unit=force_evaluation reference=closed_form";
        registry.add({"1", "adaptive_with_events", "bouncing_ball", parameters, 0, digits == 6, [=] {
                          const auto run = std::make_shared<Adaptive<2>>();
                          const auto outcome = std::make_shared<Outcome>();
                          Task task;
                          task.run = [=] {
                              const Projectile ball;
                              const Tolerance allowed{tolerance, tolerance, tolerance};
                              *run = start_adaptive(State<2>{Vec2(0, drop), Vec2(0, 0)}, ball, allowed);
                              const auto gap = [](const State<2>& s) { return s.x.y(); };
                              while ((*outcome = integrate_to_event(*run, end_time, ball, allowed, gap)) ==
                                     Outcome::event)
                                  run->s.u.y() *= -restitution;
                          };
                          task.judge = [=] {
                              return judged(run->s.x.y(), run->evaluations,
                                            *outcome == Outcome::reached ? "finished" : to_string(*outcome));
                          };
                          return task;
                      }});
    }
}

void add_steps(Registry& registry)
{
    for (int doubling = 0; doubling <= 9; ++doubling) {
        const int steps = 120 << doubling;
        const Real h = end_time / steps;
        const std::string parameters = scene_parameters + " unit=row_visit reference=closed_form";
        registry.add({"6", "sequential_impulse", "bouncing_ball", parameters, h, doubling == 3, [=] {
                          DiscScene start = column(1);
                          start.bodies.position(0).y() = drop + start.radius[0];
                          const auto scene = std::make_shared<DiscScene>(start);
                          const auto visits = std::make_shared<std::int64_t>();
                          ImpulseMethod method;
                          method.correction.restitution = restitution;
                          method.solver.sweeps.max_sweeps = 1;
                          Task task;
                          task.run = [=, method = std::move(method), now = StepData<2>()]() mutable {
                              scene->bodies = start.bodies;
                              *visits = 0;
                              for (int k = 0; k < steps; ++k) {
                                  step(*scene, {.h = h}, method, now);
                                  *visits += now.visits;
                              }
                          };
                          task.judge = [=] {
                              return judged(scene->bodies.position(0).y() - start.radius[0], *visits,
                                            "finished");
                          };
                          return task;
                      }});
    }
}

}  // namespace

void add_bounces(Registry& registry)
{
    add_events(registry);
    add_steps(registry);
}

}  // namespace rigid::results
