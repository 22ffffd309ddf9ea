#include "chapters/15_trees/tree_method.hpp"
#include "chapters/16_soft_constraints/soft_method.hpp"
#include "chapters/26_four_ways/acceleration_level.hpp"
#include "chapters/26_four_ways/reduced_motion.hpp"
#include "chapters/26_four_ways/spring_forces.hpp"
#include "tests/stress/engine_column.hpp"
#include "tests/stress/jointed.hpp"
#include "tests/stress/stepping.hpp"
#include "tests/stress/turning_honest.hpp"

#include <optional>

namespace rigid::stress {

namespace {

/// What moves bodies by itself, without rows that a solver answers, has nothing that could be called solved.
struct NothingSaid {
    template <class Solving>
    void operator()(const Solving&, const StepData<3>&) const
    {
    }
};

Manifolds& touching(Manifolds& contacts) { return contacts; }
Manifolds& touching(AwakeManifolds& contacts) { return contacts.touching; }

template <class Solving, class Honest = HonestTurning>
JointedMethod jointed(int chapter, const std::string& name, const std::string& budget, Solving by,
                      int substeps = 1, const Honest& honest = {})
{
    never_stop(touching(by.contacts));  // section 15.C
    auto method = stepping<JointedScene>(chapter, name, budget, by, substeps, honest);
    method.friction = true;
    method.springs = !std::is_same_v<Solving, JointRattle<Manifolds>>;
    return method;
}

JointedMethod by_sweeps(const std::string& name, const Spending& spending)
{
    JointSweeps<Manifolds> by;
    by.correction = correction_of(spending);
    by.correction.at_the_end = spending.correction == Stabilizer::projection;
    by.start.from = Start::best_multiple;
    by.solver.sweeps.max_sweeps = spending.sweeps;
    return jointed(14, name, budget(spending), by, spending.substeps);
}

// The ways of chapter 26 that joints can be said in. Impulses one at a time are not: what is joined never collides.

/// Springs of joints and contacts [N/m]: what eight steps bear at a rod of 10 kg, and what one bears at its end.
template <template <class> class Springs>
JointedMethod by_springs(const std::string& name, const std::string& budget, Real stiffness, int substeps)
{
    Springs<Manifolds> by;
    by.correction.springs.stiffness = stiffness;
    return jointed(26, name, budget, by, substeps, NothingSaid{});
}

std::vector<Setting> own_settings(AccelerationLevel& by)
{
    return {{"gap", &by.settings.gap},
            {"stick speed", &by.settings.stick_speed},
            {"rest speed", &by.settings.rest_speed},
            {"rate", &by.settings.rate}};
}
std::vector<Setting> own_settings(ReducedMotion&) { return {}; }

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

std::string exactly(int substeps)
{
    return "exact, " + std::to_string(substeps) + (substeps > 1 ? " substeps" : " step");
}

}  // namespace

std::vector<JointedMethod> jointed_methods()
{
    SoftSweeps<Manifolds> soft;
    soft.solver.sweeps.max_sweeps = 1;
    BodyDescent<Manifolds> descent;
    return {by_sweeps("joint sweeps", {Stabilizer::baumgarte, 10, 0, 1, infinity, 0.2}),
            by_sweeps("joint small steps", {Stabilizer::projection, 1, 1, 8, infinity, 1}),
            jointed(15, "trees", exactly(1), JointTrees<Manifolds>{}),
            jointed(15, "trees substeps", exactly(8), JointTrees<Manifolds>{}, 8),
            jointed(15, "trees that sleep", exactly(1), SkippingJoints{}),
            jointed(15, "joint rattle", exactly(1) + " with positions met", JointRattle<Manifolds>{}, 1,
                    NothingSaid{}),
            jointed(16, "soft small steps", "8 sweeps in 8 substeps", soft, 8, NothingSaid{}),
            jointed(16, "xpbd", "8 sweeps in 8 substeps", PositionSweeps<Manifolds>{}, 8, NothingSaid{}),
            jointed(16, "block descent", "10 sweeps", descent, 1, NothingSaid{}),
            engine_method<JointedScene>("engine", {}),
            by_springs<ExplicitPenalty>("springs", "none: 8 substeps, 300 kN/m", 3e5, 8),
            by_springs<ImplicitPenalty>("springs at the end", "exact, 1 step, 10 MN/m", 1e7, 1),
            by_way<AccelerationLevel>("accelerations", "order 4 between events",
                                      [](const JointedScene&) { return AccelerationLevel{}; }),
            by_way<ReducedMotion>("coordinates", "order 4, or exact rows",
                                  [](const JointedScene& scene) { return ReducedMotion(scene); })};
}

}  // namespace rigid::stress
