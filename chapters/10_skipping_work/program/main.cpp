/// Chapter 10: skipping what a scene doesn't need.

#include "chapters/10_skipping_work/program/skipping_run.hpp"
#include "chapters/10_skipping_work/program/skipping_scenes.hpp"

using namespace rigid;

namespace {

/// What all scenes have in common.
Demo skipping_scene(const std::string& name, const std::string& summary, Real h, int max_sweeps)
{
    Demo scene;
    scene.name = name;
    scene.summary = summary;
    scene.h = h;
    scene.h_low = 1e-4;
    scene.h_high = 1.0 / 60;
    scene.methods = {"skipping", "no_sleep", "one_island"};
    scene.tunables = {
        {"gravity", "m/s²", "size of gravity; changing it wakes everybody", 9.81, 0, 20, false, false, false},
        {"max_sweeps", "", "after so many sweeps an island makes do with what it has",
         static_cast<Real>(max_sweeps), 1, 500, true, false, false},
        {"exact_rows", "", "islands of up to so many rows are solved exactly", 8, 0, 32, true, false, false},
        {"digits", "", "the residual of an island is to be below 10^-digits m/s", 5, 2, 12, false, false,
         false},
        {"rest_speed", "m/s", "a body that is slower for rest_time is at rest", 1e-3, 1e-6, 0.1, false, false,
         false},
        {"rest_time", "s", "how long a body must be at rest before it sleeps", 0.5, 0.01, 10, false, false,
         false},
        {"skin", "m", "how far a disc may move before it asks the grid again", 0.01, 0, 1, false, true,
         false}};
    scene.columns = {{"awake", "", "bodies that the step looked at", true, false},
                     {"islands", "", "islands of those, single bodies included", true, false},
                     {"contacts", "", "contacts of those", false, false},
                     {"rows", "", "rows built and solved", true, false},
                     {"sweeps", "", "sweeps of the island that needed the most", true, false},
                     {"visits", "", "rows visited", true, false},
                     {"tested", "", "pairs of discs whose distance was computed", true, false},
                     {"asked", "", "discs that asked the grid", false, false},
                     {"woken", "", "bodies that were woken", false, false},
                     {"fell_asleep", "", "bodies that fell asleep", false, false},
                     {"unsolved", "", "islands whose residual did not meet the tolerance", false, false},
                     {"kinetic", "J", "kinetic energy of those who are awake", true, false}};
    return scene;
}

Demo rain_scene()
{
    Demo scene = skipping_scene(
        "rain", "Discs rain on hills, come to rest and sleep; pull one to wake its island", 1.0 / 120, 40);
    scene.view = {{0, 1.2}, {18.2, 5}};
    scene.tunables.push_back({"discs", "", "how many", 2000, 1, 20000, true, true, false});
    scene.start = [view = scene.view](const Settings& settings) {
        DiscScene rain = rain_on_hills(static_cast<Index>(settings["discs"]), settings.seed);
        return std::make_unique<SkippingRun>(std::move(rain), CollisionFilter{}, 0.03, settings["skin"],
                                             view);
    };
    return scene;
}

Demo field_scene()
{
    Demo scene = skipping_scene(
        "field", "A pendulum above discs at rest: it costs the same above ten thousand", 1.0 / 60, 30);
    scene.view = {{0, 2.6}, {4.5, 3}};
    scene.tunables.push_back({"sleepers", "", "discs on the floor", 1000, 0, 100000, true, true, false});
    scene.start = [view = scene.view](const Settings& settings) {
        DiscScene discs = field(static_cast<Index>(settings["sleepers"]));
        CollisionFilter filter = filter_of_links(discs.bodies.count(), discs.links);
        return std::make_unique<SkippingRun>(std::move(discs), std::move(filter), 0.02, settings["skin"],
                                             view);
    };
    return scene;
}

Demo columns_scene()
{
    Demo scene = skipping_scene(
        "columns", "Columns asleep; a ball wakes those that it meets, one after the other", 1.0 / 120, 50);
    scene.view = {{0, 1.7}, {4.2, 2}};
    scene.tunables.push_back({"wait", "s", "before the ball is let go", 2, 0, 10, false, true, false});
    scene.start = [view = scene.view](const Settings&) {
        DiscScene discs = columns_and_ball(8, 5);
        return std::make_unique<SkippingRun>(std::move(discs), CollisionFilter{}, 0.02, 0.01, view);
    };
    return scene;
}

Demo net_scene()
{
    Demo scene = skipping_scene(
        "net", "A net of linked discs that never collide with each other: no pair is tested", 1.0 / 240, 30);
    scene.view = {{0, -1.7}, {2.6, 2.2}};
    scene.tunables.push_back({"side", "", "discs along each side", 30, 2, 100, true, true, false});
    scene.start = [view = scene.view](const Settings& settings) {
        DiscScene discs = net(static_cast<Index>(settings["side"]));
        CollisionFilter filter = net_filter(discs);
        return std::make_unique<SkippingRun>(std::move(discs), std::move(filter), 0.02, settings["skin"],
                                             view);
    };
    return scene;
}

}  // namespace

int main(int argc, char** argv)
{
    const auto make = [] {
        Program program;
        program.name = "10_skipping_work";
        program.title = "Chapter 10. Skipping work";
        program.scenes = {rain_scene(), columns_scene(), field_scene(), net_scene()};
        return program;
    };
    return run_program(make, argc, argv);
}
