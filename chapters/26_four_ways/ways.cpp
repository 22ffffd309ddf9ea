// The functions of ways.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/26_four_ways/ways.hpp"

#include "chapters/16_soft_constraints/soft_method.hpp"
#include "chapters/26_four_ways/acceleration_level.hpp"
#include "chapters/26_four_ways/push_joints.hpp"
#include "chapters/26_four_ways/reduced_motion.hpp"
#include "chapters/26_four_ways/single_impulses.hpp"
#include "chapters/26_four_ways/spring_forces.hpp"

namespace rigid {

struct WayRun::Stepper {
    virtual ~Stepper() = default;
    virtual Status advance(JointedScene& scene, Real h) = 0;
};

namespace {

bool is_finite(const JointedScene& scene)
{
    return scene.bodies.x.allFinite() && scene.bodies.u.allFinite();
}

/// A method of the book's step.
template <class Method>
struct OfTheBook : WayRun::Stepper {
    Method method;
    StepData<3> now;
    bool solves = false;

    explicit OfTheBook(const CollisionFilter& filter, bool solving)
        : solves(solving)
    {
        Manifolds& touching = method.contacts;
        touching.finder.filter = filter;
        never_stop(touching);
    }
    Status advance(JointedScene& scene, Real h) override
    {
        step(scene, {.h = h}, method, now);
        if (!is_finite(scene)) return Status::iteration_limit;
        const bool has_rows = !now.active.empty() && !now.rows.empty();
        return solves && has_rows ? now.solution.status : Status::solved;
    }
};

template <class Class>
struct OfThisChapter : WayRun::Stepper {
    Class by;

    template <class... Given>
    explicit OfThisChapter(const CollisionFilter& filter, const Given&... given)
        : by(given...)
    {
        by.filter = filter;
    }
    Status advance(JointedScene& scene, Real h) override
    {
        const Status status = by.advance(scene, h);
        return is_finite(scene) ? status : Status::iteration_limit;
    }
};

std::unique_ptr<WayRun::Stepper> stepper(Way way, const JointedScene& scene,
                                         const CollisionFilter& filter,
                                         const WaySettings& settings)
{
    switch (way) {
    case Way::spring: {
        auto one =
            std::make_unique<OfTheBook<ExplicitPenalty<Manifolds>>>(filter, false);
        one->method.correction.springs.stiffness = settings.stiffness;
        return one;
    }
    case Way::end_spring: {
        auto one =
            std::make_unique<OfTheBook<ImplicitPenalty<Manifolds>>>(filter, true);
        one->method.correction.springs.stiffness = settings.stiffness;
        return one;
    }
    case Way::acceleration:
        return std::make_unique<OfThisChapter<AccelerationLevel>>(filter);
    case Way::single:
        return std::make_unique<OfThisChapter<SingleImpulses>>(filter);
    case Way::impulses:
        return std::make_unique<OfTheBook<JointTrees<Manifolds>>>(filter, true);
    case Way::positions: {
        auto one =
            std::make_unique<OfTheBook<PositionSweeps<Manifolds>>>(filter, false);
        one->method.correction.sweeps = settings.sweeps;
        return one;
    }
    case Way::coordinates:
        return std::make_unique<OfThisChapter<ReducedMotion>>(filter, scene);
    }
    throw std::invalid_argument("there is no such way");
}

}  // namespace

void require_valid(const WaySettings& settings)
{
    require_valid(PenaltySprings{.stiffness = settings.stiffness});
    Xpbd positions;
    positions.sweeps = settings.sweeps;
    positions.require_valid();
}

namespace {

const JointedScene& checked(const WayScene& way, const WaySettings& settings)
{
    require_valid(settings);
    require_valid(static_cast<const RigidScene&>(way.scene));
    require_valid_surfaces(way.scene);
    require_fits(way.filter, way.scene.shapes.size());
    return way.scene;
}

void require_time(const WayScene& scene)
{
    if (!(scene.time > 0) || !std::isfinite(scene.time))
        throw std::invalid_argument("the time of the scene is " +
                                    shortest(scene.time) +
                                    " s; it must be positive and finite");
}

}  // namespace

WayRun::WayRun(Way way, const WayScene& scene, const WaySettings& settings)
    : scene_(checked(scene, settings)),
      stepper_(stepper(way, scene_, scene.filter, settings))
{
    if (way == Way::single) SingleImpulses{}.require_valid(scene_);
    if (way == Way::acceleration) AccelerationLevel{}.require_valid(scene_);
}
WayRun::~WayRun() = default;
WayRun::WayRun(WayRun&&) noexcept = default;

Status WayRun::advance(Real h) { return stepper_->advance(scene_, h); }

std::string refusal(Way way, const WayScene& scene)
{
    try {
        const WayRun run(way, scene, settings_of(scene));
    } catch (const std::invalid_argument& refused) {
        return refused.what();
    }
    return {};
}

WayDrift drift_of(const WayScene& way, const JointedScene& scene)
{
    WayDrift drift;
    const Bodies<3>& bodies = scene.bodies;
    for (const PointJoint& joint : scene.joints)
        if (joint.kind == ConstraintKind::bilateral) {
            const Constraint<3> c = joint_constraint(bodies.x, joint);
            drift.C = std::max(drift.C, std::abs(c.C));
            drift.rate = std::max(
                drift.rate,
                std::abs(bilateral(c, bodies.inverse_mass).velocity(bodies.u)));
        }
    std::vector<PushJoint> near;
    const Real closed = 1e-6 * typical_length(scene);
    find_push_joints(scene, way.filter, closed, near);
    for (const PushJoint& push : near) {
        const Constraint<3> c = gap_of(push, bodies.x);
        if (c.C > closed) continue;
        drift.C = std::max(drift.C, -c.C);
        drift.rate = std::max(
            drift.rate, -bilateral(c, bodies.inverse_mass).velocity(bodies.u));
    }
    return drift;
}

int steps_of(const WayScene& scene, Real h)
{
    require_step(h);
    require_time(scene);
    const Real steps = std::ceil(scene.time / h - 1e-9);
    if (steps > 1e9)
        throw std::invalid_argument("the scene takes " + shortest(steps) +
                                    " steps of " + shortest(h) +
                                    " s; it must be at most 1e9");
    return std::max(1, static_cast<int>(steps));
}

std::string advance_to_end(WayRun& run, const WayScene& scene, int steps)
{
    require_time(scene);
    if (steps < 1)
        throw std::invalid_argument("the number of steps is " +
                                    std::to_string(steps) +
                                    "; it must be at least 1");
    for (int i = 0; i < steps; ++i) {
        const Status status = run.advance(scene.time / steps);
        if (status == Status::solved) continue;
        return is_finite(run.scene()) ? std::string(to_string(status))
                                      : "it flies apart";
    }
    return {};
}

WayResult result_of(const WayScene& scene, const JointedScene& end)
{
    if (!scene.error)
        throw std::invalid_argument(
            "the scene does not say how its error is measured");
    WayResult result;
    result.error = scene.error(end);
    result.energy_gain = energy(end) - energy(scene.scene);
    // but for the doll, which only loses, no scene has more than 15 J to move with
    if (!(result.error < 100) || !(result.energy_gain < 15))
        result.why_not = "it flies apart";
    else result.drift = drift_of(scene, end);
    return result;
}

WayResult run_way(Way way, const WayScene& scene, Real h,
                  const WaySettings& settings)
{
    WayResult result;
    try {
        WayRun run(way, scene, settings);
        result.why_not = advance_to_end(run, scene, steps_of(scene, h));
        if (result.why_not.empty()) result = result_of(scene, run.scene());
    } catch (const std::invalid_argument& refused) {
        result.why_not = refused.what();
    }
    return result;
}

}  // namespace rigid
