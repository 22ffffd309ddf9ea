/// \file race.cpp
/// Our side of the race (docs/race.md), for a page: scenes, the engine of chapter 19 on them, and the referee of both sides.
/// As web_program.cpp: a function that can fail returns 0, or 1 and a sentence in web_sentence().
#include "docs/race/race_scenes.hpp"

#include "chapters/19_engine/from_scene.hpp"
#include "docs/race/world_text.hpp"

#include <optional>

namespace rigid::race {
namespace {

/// The engine's own choice, and its two kinds of solver alone.
const std::vector<std::pair<std::string, Solving>> methods = {
    {"engine", Solving::by_island}, {"exact", Solving::exact}, {"sweeps", Solving::sweeps}};

/// Things of one group that is negative do not meet.
constexpr Filter nothing{1, 0xffff'ffff, -1};

/// What its walls have; a world tells it of bodies only.
Real wall_friction(const JointedScene& scene)
{
    return scene.wall_surfaces.empty() ? 0 : scene.wall_surfaces.front().friction;
}

/// One run: a world with all settings as they come, but for the two that are chosen, and without sleep.
class Ours {
public:
    Ours(const RaceScene& race, Solving solving, int substeps)
        : world_({.substeps = substeps, .sleep = false, .solving = solving}),
          wall_friction_(wall_friction(race.scene))
    {
        bodies_ = put_in(world_, race.scene, race.touches ? Filter{} : nothing);
        x_.resize(3 * static_cast<Index>(bodies_.size()));
    }

    void step() { world_.step(1.0 / 60); }
    std::string text() const { return world_text(world_, wall_friction_); }
    /// (x, y, θ) of each body.
    const VecX& x()
    {
        for (std::size_t k = 0; k < bodies_.size(); ++k)
            x_.segment<3>(3 * static_cast<Index>(k)) << world_.position(bodies_[k]), world_.angle(bodies_[k]);
        return x_;
    }

private:
    World world_;
    Real wall_friction_;
    std::vector<BodyId> bodies_;
    VecX x_;
};

struct Page {
    std::vector<RaceScene> scenes = race_scenes();
    std::size_t scene = 0;
    std::optional<Ours> ours;
    Manifolds referee;
    StepData<3> found;
    VecX theirs;
};

Page& page()
{
    static Page one;
    return one;
}

std::string description()
{
    const char* const errors[] = {"moved", "overlap", "gap"};
    std::string names, scenes;
    for (const auto& [name, solving] : methods) names += (names.empty() ? "" : ",") + json(name);
    for (const RaceScene& race : page().scenes) {
        scenes += (scenes.empty() ? "" : ",") + ("{\"name\":" + json(race.name)) +
                  ",\"title\":" + json(race.title) + ",\"summary\":" + json(race.summary) + ",\"view\":" +
                  list({race.centre.x(), race.centre.y(), race.half_size.x(), race.half_size.y()}) +
                  ",\"error\":" + json(errors[static_cast<int>(race.error)]) +
                  ",\"steps\":" + std::to_string(race.steps) + ",\"methods\":[" + names + "]}";
    }
    return "{\"name\":\"race\",\"scenes\":[" + scenes + "]}";
}

}  // namespace
}  // namespace rigid::race

using namespace rigid;
using namespace rigid::race;

RIGID_PAGE(web_start) int web_start()
{
    return attempt([] { page(); });
}
RIGID_PAGE(web_description) const char* web_description() { return said(description()); }
RIGID_PAGE(web_sentence) const char* web_sentence() { return last_said().sentence.c_str(); }

/// Begins a run. The numbers are places in the lists of the description.
RIGID_PAGE(race_open) int race_open(int scene, int method, int substeps)
{
    return attempt([&] {
        Page& all = page();
        const RaceScene& race = all.scenes.at(static_cast<std::size_t>(scene));
        all.scene = static_cast<std::size_t>(scene);
        all.ours.emplace(race, methods.at(static_cast<std::size_t>(method)).second, substeps);
        all.theirs = race.scene.bodies.x;
        all.referee = {};
    });
}
RIGID_PAGE(race_scene) const char* race_scene() { return said(page().ours->text()); }
RIGID_PAGE(race_step) int race_step(int steps)
{
    return attempt([&] {
        for (int k = 0; k < steps; ++k) page().ours->step();
    });
}
/// Where our bodies are, (x, y, θ) of each; and room for where theirs are.
RIGID_PAGE(race_ours) const double* race_ours() { return page().ours->x().data(); }
RIGID_PAGE(race_theirs) double* race_theirs() { return page().theirs.data(); }
/// The error of our positions, and of theirs, by the same function.
RIGID_PAGE(race_error) double race_error(int theirs)
{
    Page& all = page();
    return error_of(all.scenes[all.scene], theirs != 0 ? all.theirs : all.ours->x(), all.referee, all.found);
}
