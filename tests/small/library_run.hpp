/// \file library_run.hpp
/// The scene of a small program in the types of the library, and a run of both side by side.
#pragma once

#include "chapters/03_mlcp_formulation/step.hpp"
#include "tests/catch.hpp"

#include <algorithm>

namespace rigid {

/// The same discs, walls and links; gravity points down.
template <class Discs>
DiscScene library_scene(const Discs& d)
{
    DiscScene scene;
    const Index K = d.radius.size();
    scene.bodies = Bodies<2>(K);
    scene.bodies.x = d.x;
    scene.bodies.u = d.u;
    scene.bodies.inverse_mass = d.inverse_mass;
    scene.radius = d.radius;
    scene.gravity = {0, -9.81};
    scene.length = 1;
    for (Index i = 0; i < d.walls.cols(); ++i)
        scene.walls.push_back({d.walls.col(i).template head<2>(), d.walls(2, i)});
    for (Index k = 1; k < d.chain; ++k) scene.links.push_back({k - 1, k, d.radius[k - 1] + d.radius[k]});
    link_neighbours(scene);
    require_valid(scene);
    return scene;
}

/// How far two runs are apart [m], [m/s].
template <class Discs>
Real apart(const Discs& d, const DiscScene& scene)
{
    return std::max((d.x - scene.bodies.x).cwiseAbs().maxCoeff(),
                    (d.u - scene.bodies.u).cwiseAbs().maxCoeff());
}

/// Takes 100 steps of 1/240 s of both, and looks at each that they agree and did equal work. Within these steps the
/// three discs land, the chain lands on them, and it bends.
/// \param small_step    the work that it took, of the small program's discs
/// \param library_step  the same of the library's scene
/// \return the greatest distance of both [m], [m/s]
template <class Discs, class SmallStep, class LibraryStep>
Real farthest_in_a_run(Discs d, const SmallStep& small_step, LibraryStep&& library_step)
{
    DiscScene scene = library_scene(d);
    const VecX start = d.x;
    Real farthest = 0;
    for (int n = 0; n < 100; ++n) {
        INFO("step " << n);
        const int work = small_step(d);
        REQUIRE(library_step(scene) == work);
        farthest = std::max(farthest, apart(d, scene));
    }
    CHECK((d.x - start).norm() > 0.5);  // nothing was compared that stood still
    return farthest;
}

/// What the 480 steps that the text speaks of take in all.
template <class Discs, class Start, class Step>
int work_of_the_text(const Start& start, const Step& step_once)
{
    Discs d = start();
    int work = 0;
    for (int n = 0; n < 480; ++n) work += step_once(d, 1.0 / 240);
    return work;
}

}  // namespace rigid
