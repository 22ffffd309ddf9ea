/// \file race.cpp
/// Our side of the race (docs/race.md), for a page: scenes, the engine of chapter 17 on them, and the referee of both sides.
/// As web_program.cpp: a function that can fail returns 0, or 1 and a sentence in web_sentence().
#include "docs/race/race_scenes.hpp"

#include "chapters/17_engine/from_scene.hpp"
#include "common/program/web_description.hpp"
#include "common/text.hpp"

#include <optional>

namespace rigid::race {
namespace {

/// The engine's own choice, and its two kinds of solver alone.
const std::vector<std::pair<std::string, Solving>> methods = {
    {"engine", Solving::by_island}, {"exact", Solving::exact}, {"sweeps", Solving::sweeps}};

/// Things of one group that is negative do not meet.
constexpr Filter nothing{1, 0xffff'ffff, -1};

/// One run: a world with all settings as they come, but for the two that are chosen, and without sleep.
class Ours {
public:
    Ours(const RaceScene& race, Solving solving, int substeps)
        : world_({.substeps = substeps, .sleep = false, .solving = solving})
    {
        bodies_ = put_in(world_, race.scene, race.touches ? Filter{} : nothing);
        x_.resize(3 * static_cast<Index>(bodies_.size()));
    }

    void step() { world_.step(1.0 / 60); }
    /// (x, y, θ) of each body.
    const VecX& x()
    {
        for (std::size_t k = 0; k < bodies_.size(); ++k)
            x_.segment<3>(3 * static_cast<Index>(k)) << world_.position(bodies_[k]), world_.angle(bodies_[k]);
        return x_;
    }

private:
    World world_;
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
    std::string text, sentence;
};

Page& page()
{
    static Page one;
    return one;
}

const char* said(std::string text)
{
    page().text = std::move(text);
    return page().text.c_str();
}

std::string list(std::initializer_list<Real> numbers)
{
    std::string text;
    for (const Real one : numbers) text += (text.empty() ? "" : ",") + shortest(one);
    return '[' + text + ']';
}

std::string vertices_of(const Polygon& shape)
{
    std::string text;
    for (const Vec2& v : shape.vertices) text += (text.empty() ? "" : ",") + list({v.x(), v.y()});
    return '[' + text + ']';
}

Real friction_of(const std::vector<Surface>& surfaces)
{
    return surfaces.empty() ? 0 : surfaces.front().friction;
}

/// All that another engine needs to build the same scene.
std::string scene_text(const RaceScene& race)
{
    const JointedScene& scene = race.scene;
    std::string bodies, walls, pins;
    for (Index k = 0; k < scene.bodies.count(); ++k) {
        const Vec<3> x = scene.bodies.position(k), u = scene.bodies.velocity(k),
                     W = scene.bodies.inverse_mass.segment<3>(3 * k);
        const Polygon& shape = scene.shapes[static_cast<std::size_t>(k)];
        bodies += (bodies.empty() ? "" : ",") + ("{\"x\":" + list({x[0], x[1], x[2]})) +
                  ",\"u\":" + list({u[0], u[1], u[2]}) + ",\"mass\":" + shortest(1 / W[0]) +
                  ",\"inertia\":" + shortest(1 / W[2]) + ",\"radius\":" + shortest(shape.radius) +
                  ",\"vertices\":" + vertices_of(shape) + '}';
    }
    for (const HalfSpace& wall : scene.walls)
        walls += (walls.empty() ? "" : ",") + list({wall.normal.x(), wall.normal.y(), wall.offset});
    for (const PlacedJoint& placed : scene.placed) {
        const RigidJoint& pin = placed.joint;
        pins += (pins.empty() ? "" : ",") + list({static_cast<Real>(pin.a), static_cast<Real>(pin.b),
                                                  pin.at_a.x(), pin.at_a.y(), pin.at_b.x(), pin.at_b.y()});
    }
    return "{\"bodies\":[" + bodies + "],\"walls\":[" + walls + "],\"pins\":[" + pins +
           "],\"gravity\":" + list({scene.gravity.x(), scene.gravity.y()}) +
           ",\"friction\":" + shortest(friction_of(scene.surfaces)) +
           ",\"touches\":" + (race.touches ? "true" : "false") + '}';
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

template <class Do>
int attempt(const Do& what)
{
    try {
        what();
        return 0;
    } catch (const std::exception& error) {
        page().sentence = error.what();
        return 1;
    }
}

}  // namespace
}  // namespace rigid::race

using namespace rigid;
using namespace rigid::race;

#define RIGID_PAGE(name) extern "C" __attribute__((export_name(#name), used))

RIGID_PAGE(web_start) int web_start()
{
    return attempt([] { page(); });
}
RIGID_PAGE(web_description) const char* web_description() { return said(description()); }
RIGID_PAGE(web_sentence) const char* web_sentence() { return page().sentence.c_str(); }

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
RIGID_PAGE(race_scene) const char* race_scene() { return said(scene_text(page().scenes[page().scene])); }
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
