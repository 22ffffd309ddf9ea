/// \file hung_demo.hpp
/// A chain that swings: energy, joints, and rows visited; for the methods of chapter 21 and of those after it.
#pragma once

#include "chapters/20_turning_in_space/program/solid_run.hpp"
#include "chapters/21_joints_in_space/joint_coordinates.hpp"

namespace rigid {

/// A chain that swings: energy, joints, and rows visited.
/// \tparam Steps   the methods of its chapter
/// \param make      the scene and how it is looked at
/// \param tunables  of the scene; those of the step are added
template <class Scene, class Steps>
Demo hung_demo(const std::string& name, const std::string& summary,
               const View& view,
               const std::function<SolidSetup<Scene>(const Settings&)>& make,
               const std::vector<Tunable>& tunables)
{
    Demo scene = solid_demo<Scene, Steps>(
        name, summary, view, 1.0 / 240, {"exact", "islands"},
        [make](const Settings& settings) {
            SolidSetup<Scene> setup = make(settings);
            setup.measure = [](const SolidState<Scene>& s) -> std::vector<Real> {
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
