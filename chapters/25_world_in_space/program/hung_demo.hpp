/// \file hung_demo.hpp
/// A chain that swings: energy, joints, and rows visited.
#pragma once

#include "chapters/25_world_in_space/program/space_run.hpp"

namespace rigid {

/// \param make      the scene and how it is looked at
/// \param tunables  of the scene; those of the step are added
inline Demo hung_demo(const std::string& name, const std::string& summary,
                      const View& view,
                      const std::function<SpaceSetup(const Settings&)>& make,
                      const std::vector<Tunable>& tunables)
{
    Demo scene = space_demo(
        name, summary, view, 1.0 / 240, {"exact", "islands"},
        [make](const Settings& settings) {
            SpaceSetup setup = make(settings);
            setup.measure = [](const SpaceState& s) -> std::vector<Real> {
                return {energy(s.scene) - s.energy, largest_joint_error(s.scene),
                        static_cast<Real>(s.now.visits)};
            };
            return setup;
        });
    scene.tunables.insert(scene.tunables.end(), tunables.begin(), tunables.end());
    scene.tunables.push_back(
        {"substeps", "", "parts of a step", 4, 1, 64, Numbers::whole});
    scene.columns = {
        {"energy_error", "J", "energy minus that of the start", Plot::linear},
        {"joint_error", "m", "largest of a locked coordinate", Plot::logarithmic},
        {"visits", "", "rows visited", Plot::linear}};
    return scene;
}

}  // namespace rigid
