#include "chapters/16_soft_constraints/soft_method.hpp"
#include "chapters/26_four_ways/acceleration_level.hpp"
#include "chapters/26_four_ways/reduced_motion.hpp"
#include "chapters/26_four_ways/single_impulses.hpp"
#include "chapters/26_four_ways/spring_forces.hpp"
#include "tests/stress/engine_column.hpp"
#include "tests/stress/jointed.hpp"
#include "tests/stress/jointed_columns.hpp"

#include <optional>

namespace rigid::stress {

namespace {

/// Springs of joints and contacts [N/m].
template <template <class> class Springs>
JointedMethod by_springs(const std::string& name, const std::string& budget, Real stiffness, int substeps)
{
    Springs<Manifolds> by;
    by.correction.springs.stiffness = stiffness;
    return jointed(26, name, budget, by, substeps, NothingSaid{});
}
JointedMethod springs(const std::string& budget, Real stiffness)
{
    return by_springs<ExplicitPenalty>("springs", "none: 8 substeps, " + budget, stiffness, 8);
}
JointedMethod springs_at_the_end()
{
    return by_springs<ImplicitPenalty>("springs at the end", "exact, 1 step, 10 MN/m", 1e7, 1);
}

std::vector<Setting> own_settings(AccelerationLevel& by)
{
    return {{"gap", &by.settings.gap},
            {"stick speed", &by.settings.stick_speed},
            {"rest speed", &by.settings.rest_speed},
            {"rate", &by.settings.rate}};
}
std::vector<Setting> own_settings(SingleImpulses& by) { return {{"hop", &by.settings.hop}}; }
std::vector<Setting> own_settings(ReducedMotion& by)
{
    return {{"gap", &by.settings.gap}, {"rest speed", &by.settings.rest_speed}};
}

/// A way that keeps its own state and says by its status when it cannot go on.
template <class By, class Make>
JointedMethod by_way(const std::string& name, const std::string& budget, const Make& make)
{
    JointedMethod method;
    method.chapter = 26;
    method.name = name;
    method.budget = budget;
    method.friction = true;
    method.springs = method.motors = false;
    method.most_rows = 400;  // rods that fall on each other: a dense matrix in each evaluation
    {
        By names = make(JointedScene{});
        method.settings = names_of(own_settings(names));
    }
    method.start = [make](const std::shared_ptr<const Wish>& wish) {
        const auto memory = std::make_shared<std::optional<By>>();
        return checked<JointedScene>([=](JointedScene& scene, Real h) {
            if (!*memory) *memory = make(scene);
            const std::vector<Setting> all = own_settings(**memory);
            const auto spoilt = static_cast<std::size_t>(wish->setting);
            const Real before = wish->setting >= 0 ? *all.at(spoilt).value : 0;
            if (wish->setting >= 0) *all.at(spoilt).value = wish->spoilt;
            Status status = Status::solved;
            try {
                status = (*memory)->advance(scene, h);
            } catch (...) {
                if (wish->setting >= 0) *all.at(spoilt).value = before;
                throw;
            }
            if (wish->setting >= 0) *all.at(spoilt).value = before;
            if (status != Status::solved) throw Stopped(std::string(to_string(status)));
        });
    };
    return method;
}

JointedMethod accelerations()
{
    return by_way<AccelerationLevel>("accelerations", "order 4 between events",
                                     [](const JointedScene&) { return AccelerationLevel{}; });
}
JointedMethod single_impulses()
{
    return by_way<SingleImpulses>("single impulses", "each collision by itself",
                                  [](const JointedScene&) { return SingleImpulses{}; });
}
JointedMethod coordinates()
{
    return by_way<ReducedMotion>("coordinates", "order 4, or exact rows",
                                 [](const JointedScene& scene) { return ReducedMotion(scene); });
}

/// The same where pins are rows of chapter 11.
TurningMethod turning(const JointedMethod& of, Index most_rows)
{
    TurningMethod method;
    method.chapter = 26;
    method.name = of.name;
    method.budget = of.budget;
    method.friction = true;
    method.most_rows = most_rows;
    method.settings = of.settings;
    method.start = [start = of.start](const std::shared_ptr<const Wish>& wish) {
        return checked<RoughScene>([step = start(wish)](RoughScene& scene, Real h) {
            JointedScene inner = with_joints(scene);
            step(inner, h);
            scene.bodies = inner.bodies;
            scene.gravity = inner.gravity;
        });
    };
    return method;
}

}  // namespace

std::vector<JointedMethod> ways_with_joints()
{
    return {springs("300 kN/m", 3e5), springs_at_the_end(), accelerations(), coordinates()};
}

std::vector<TurningMethod> ways_of_turning()
{
    JointedMethod positions =
        jointed(16, "positions", "8 sweeps in 8 substeps", PositionSweeps<Manifolds>{}, 8, NothingSaid{});
    // Beyond three bodies what trembles makes hundreds of events or collisions a step.
    TurningMethod single = turning(single_impulses(), 12);
    single.joints = false;
    return {turning(springs("30 kN/m", 3e4), 1'000'000),
            turning(springs_at_the_end(), 330),
            turning(accelerations(), 12),
            single,
            turning(positions, 1'000'000),
            turning(coordinates(), 100)};
}

}  // namespace rigid::stress
