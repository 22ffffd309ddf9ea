/// \file world.cpp
/// The settings of a world and its step. What a caller does with bodies is in world_bodies.cpp and world_changes.cpp, with
/// walls and joints in world_walls_joints.cpp, what it asks in world_questions.cpp; what outlives the world is in
/// world_kept.cpp.
#include "common/eigen_instances.hpp"

#include "chapters/19_engine/world.hpp"

#include "chapters/19_engine/body_checks.hpp"
#include "chapters/19_engine/told_stages.hpp"
#include "chapters/19_engine/world_cpp.hpp"

namespace rigid {

void require_valid(const WorldSettings& settings)
{
    const auto refuse = [](const char* name, const std::string& value,
                           const std::string& right) {
        throw std::invalid_argument(std::string("the ") + name +
                                    " of the world is " + value + "; it must be " +
                                    right);
    };
    const auto at_least_zero = [&](const char* name, Real value) {
        if (!(value >= 0) || !std::isfinite(value))
            refuse(name, shortest(value), "zero or positive, and finite");
    };
    if (!settings.gravity.allFinite())
        refuse("gravity",
               "(" + shortest(settings.gravity.x()) + ", " +
                   shortest(settings.gravity.y()) + ") m/s²",
               "finite");
    if (!(settings.length > 0) || !std::isfinite(settings.length))
        refuse("length", shortest(settings.length) + " m", "positive and finite");
    if (settings.substeps < 1)
        refuse("number of sub-steps", std::to_string(settings.substeps),
               "1 or more");
    at_least_zero("margin", settings.margin);
    at_least_zero("slop", settings.slop);
    require_valid(settings.rest);
    if (settings.solving > Solving::sweeps)
        refuse("solving", std::to_string(static_cast<int>(settings.solving)),
               "one of by_island, exact and sweeps");
    if (settings.sweeps < 1)
        refuse("number of sweeps", std::to_string(settings.sweeps), "1 or more");
    if (!(settings.tolerance > 0) || !std::isfinite(settings.tolerance))
        refuse("tolerance", shortest(settings.tolerance), "positive and finite");
    if (settings.most_exact < 0)
        refuse("number of rows that are exact at most",
               std::to_string(settings.most_exact), "zero or positive");
    at_least_zero("speed of hits", settings.hit_speed);
    // all of them are shares of the length
    for (const Real share : {settings.margin, settings.slop, settings.tolerance})
        if (!std::isfinite(share * settings.length))
            refuse("length", shortest(settings.length) + " m",
                   "smaller: " + shortest(share) + " times it is not finite");
}

const char* to_string(Stage stage)
{
    switch (stage) {
    case Stage::contacts:
        return "contacts";
    case Stage::start:
        return "start";
    case Stage::rows:
        return "rows";
    case Stage::solver:
        return "solver";
    case Stage::positions:
        return "positions";
    default:
        return "report";
    }
}

const char* to_string(BodyKind kind)
{
    switch (kind) {
    case BodyKind::fixed:
        return "fixed";
    case BodyKind::kinematic:
        return "kinematic";
    default:
        return "dynamic";
    }
}

World::World(const WorldSettings& settings)
{
    require_valid(settings);
    state_ = std::make_unique<State>();
    state_->settings = settings;
    state_->configure();
}
World::World(std::unique_ptr<State> state) : state_(std::move(state)) {}
World::~World() = default;
World::World(World&&) noexcept = default;
World& World::operator=(World&&) noexcept = default;

//! [step]
void World::step(Real h, const StageListener& listener)
{
    State& s = *state_;
    require_step(h);
    require_step(h / s.settings.substeps);  // of 5e-324 s a half is 0
    s.begin_events();
    s.work = {};
    s.work.bodies = s.bodies.count - s.more_shapes;
    s.taken_out.clear();
    ToldManifolds& sleepers = s.awake();
    // all sleep, and no call has changed anything: no step would change a bit
    s.work.skipped = s.steps > 0 && !s.changed && sleepers.set.awake.empty() &&
                     s.pulled == world;
    if (!s.work.skipped) {
        const StepSettings how{.h = h,
                               .substeps = s.settings.substeps,
                               .margin = s.settings.margin,
                               .pulled = s.pulled,
                               .hand = s.pulled_to};
        sleepers.touching.finder.tested = -1;  // not looked for yet
        s.method.correction.held.clear();
        s.list_driven();
        ToldStages told{s.method, listener};
        rigid::step(s.scene, how, told, s.now);
        s.changed = false;
        s.end_driven();
        told.tell(Stage::report);
        s.report();
    }
    s.time += h;
    ++s.steps;
    if (s.recording) s.note(Call::step, h, hash());
}
//! [step]

Real World::time() const { return state_->time; }
std::int64_t World::steps() const { return state_->steps; }
const WorldSettings& World::settings() const { return state_->settings; }
const StepWork& World::work() const { return state_->work; }
const Events& World::events() const { return state_->events; }

void World::change(const WorldSettings& settings)
{
    require_valid(settings);
    for (const BodyId body : bodies())
        require_weight(mass(body), gravity_scale(body) * settings.gravity);
    state_->settings = settings;
    state_->configure();
    state_->changed = true;
    state_->note(Call::change, settings);
}

}  // namespace rigid
