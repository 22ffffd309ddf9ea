/// \file beside_plane.cpp
/// Our side of the runs in node (beside.mjs) in the plane: scenes as worlds of chapter 19, the engine on them, and the
/// judge of both sides, which is that of chapter 19's benchmark.
#include "chapters/19_engine/benchmark/world_judge.hpp"
#include "chapters/19_engine/moving_worlds.hpp"
#include "docs/race/race_scenes.hpp"
#include "docs/race/world_text.hpp"

#include <array>
#include <functional>
#include <optional>

namespace rigid::race {
namespace {

struct WorldRun : Measured {
    std::function<World()> make;
    Real wall_friction = 0.6;  ///< of add_wall()
    Real spin = 0;             ///< of the drum, whose walls are the first four bodies [rad/s]
};

/// The scenes of the page, and of chapter 19's benchmark what moves. What should rest begins a nanometre beside its place.
std::vector<WorldRun> world_runs()
{
    std::vector<WorldRun> all;
    for (const RaceScene& race : race_scenes()) {
        const char* const what[] = {"m", "o", "g"};
        all.push_back({{race.name, race.title, what[static_cast<int>(race.error)], race.steps},
                       [race] {
                           World made;
                           put_in(made, race.scene, race.touches ? Filter{} : meets_no_twin);
                           return made;
                       },
                       race.scene.wall_surfaces.empty() ? 0 : race.scene.wall_surfaces.front().friction});
    }
    all.push_back({{"pour", "300 poured", "o"}, [] { return poured_world(300); }});
    all.push_back({{"dolls", "ten dolls on stairs", "go"}, [] { return dolls_world(10); }});
    all.push_back({{"tumbler", "a tumbler with 40 boxes", "o", 240, 4},
                   [] { return tumbler_world(40, 0.5); },
                   0.6,
                   0.5});
    all.push_back({{"bridge", "a bridge of 30 planks, and balls", "go"}, [] { return bridge_world(30); }});
    return all;
}

struct Page {
    std::vector<WorldRun> runs = world_runs();
    const WorldRun* run = nullptr;
    std::optional<World> start, ours;
    std::optional<WorldJudge> judge;
    std::vector<BodyId> ids;
    Poses first, now;
    VecX theirs, drive;
    std::array<Real, 3> found{};
};

Page& page()
{
    static Page one;
    return one;
}

void read_ours(Poses& poses)
{
    poses.clear();
    for (const BodyId id : page().ids)
        poses.push_back(
            {page().ours->position(id).x(), page().ours->position(id).y(), page().ours->angle(id)});
}

void read_theirs(Poses& poses)
{
    poses.resize(page().ids.size());
    for (std::size_t k = 0; k < poses.size(); ++k)
        poses[k] = page().theirs.segment<3>(3 * static_cast<Index>(k));
}

}  // namespace
}  // namespace rigid::race

using namespace rigid;
using namespace rigid::race;

RIGID_PAGE(web_start) int web_start()
{
    return attempt([] { page(); });
}
RIGID_PAGE(web_description) const char* web_description()
{
    return said(description_of("beside_plane", page().runs));
}
RIGID_PAGE(web_sentence) const char* web_sentence() { return last_said().sentence.c_str(); }

/// Begins a run. \param solving  as Solving has them; \param sweeps  0: as they come
RIGID_PAGE(race_open) int race_open(int scene, int solving, int substeps, int sweeps, int sleep)
{
    return attempt([&] {
        Page& all = page();
        all.run = &all.runs.at(static_cast<std::size_t>(scene));
        all.ours.emplace(all.run->make());
        WorldSettings settings = all.ours->settings();
        settings.substeps = substeps;
        settings.solving = static_cast<Solving>(solving);
        if (sweeps > 0) settings.sweeps = sweeps;
        settings.sleep = sleep != 0;
        all.ours->change(settings);
        all.start.emplace(World::load(all.ours->save()));
        all.judge.emplace(*all.start);
        all.ids = all.ours->bodies();
        read_ours(all.first);
        all.theirs.resize(3 * static_cast<Index>(all.ids.size()));
        all.drive.setZero(12);
    });
}
RIGID_PAGE(race_scene) const char* race_scene()
{
    return said(world_text(*page().ours, page().run->wall_friction));
}
RIGID_PAGE(race_step) int race_step(double h)
{
    return attempt([&] { page().ours->step(h); });
}
/// The walls of a drum go on along a circle: what their velocities are to be, (v_x, v_y, ω) of each; ours get them here.
RIGID_PAGE(race_drive) const double* race_drive(int theirs, double h)
{
    Page& all = page();
    if (theirs == 0) turn_tumbler(*all.ours, all.run->spin, h);
    else {
        const Real c = rigid::cos(all.run->spin * h), s = rigid::sin(all.run->spin * h);
        for (Index k = 0; k < 4; ++k) {
            const Vec2 p = all.theirs.segment<2>(3 * k), next(c * p.x() - s * p.y(), s * p.x() + c * p.y());
            all.drive.segment<3>(3 * k) << (next - p) / h, all.run->spin;
        }
    }
    return all.drive.data();
}
/// Room for where their bodies are, (x, y, θ) of each.
RIGID_PAGE(race_theirs) double* race_theirs() { return page().theirs.data(); }
/// The errors of our positions, or of theirs: moved, gap, overlap [m]; what is no error of the scene is 0.
RIGID_PAGE(race_errors) const double* race_errors(int theirs)
{
    Page& all = page();
    theirs != 0 ? read_theirs(all.now) : read_ours(all.now);
    all.found.fill(0);
    for (const Vec<3>& pose : all.now)
        if (!pose.allFinite()) {
            all.found.fill(infinity);
            return all.found.data();
        }
    if (all.run->by('m')) all.found[0] = WorldJudge::moved(all.first, all.now);
    if (all.run->by('g')) all.found[1] = all.judge->gap(all.now);
    if (all.run->by('o')) all.found[2] = all.judge->overlap(all.now);
    return all.found.data();
}
