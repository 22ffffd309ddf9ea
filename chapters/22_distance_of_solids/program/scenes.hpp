/// \file scenes.hpp
/// A solid that passes another one, and beside both the solid of their differences.
#pragma once

#include "chapters/20_turning_in_space/program/solid_run.hpp"
#include "chapters/22_distance_of_solids/convex_hull.hpp"
#include "chapters/22_distance_of_solids/gjk.hpp"
#include "chapters/22_distance_of_solids/separating_axes.hpp"

namespace rigid {

/// Nothing pushes the bodies: they fly on and tumble.
class PassingSteps {
public:
    explicit PassingSteps(const SolidSetup<SolidScene>&) {}
    void step(SolidScene& scene, const Settings&, const StepSettings& how,
              StepData<6>&)
    {
        for (Index k = 0; k < scene.bodies.count(); ++k)
            scene.bodies.integrate(k, scene.bodies.velocity(k), how.h);
    }
    static void draw_ground(SolidPicture&, const SolidScene&) {}
    static void draw_more(SolidPicture&, const SolidScene&) {}
};

/// How two bodies lie to each other.
struct Between {
    PlacedSolid a, b;
    Nearest near;  ///< (22.1)
    Axis axis;     ///< (22.3), the best of (22.4)
};

inline Between between(const SolidScene& scene, const SolidForm& form_a,
                       const SolidForm& form_b)
{
    Between found;
    const VecX& x = scene.bodies.x;
    found.a.place(form_a, centre_of(x, 0), rotation_of(x, 0));
    found.b.place(form_b, centre_of(x, 1), rotation_of(x, 1));
    found.near = nearest_points(found.a, found.b);
    found.axis = best_face(found.a, found.b, 0);
    const Axis edges = best_across_edges(found.a, found.b);
    if (edges.separation > found.axis.separation) found.axis = edges;
    return found;
}

inline Demo pass_scene()
{
    Demo scene = solid_demo<SolidScene, PassingSteps>(
        "pass", "A tetrahedron passes a box; right, the solid of their differences",
        {{1.4, 0}, {3.3, 2.2}}, 1.0 / 60, {"gjk"}, [](const Settings& settings) {
            SolidSetup<SolidScene> setup;
            const Hull box = solid_box({1, 0.8, 1.2}),
                       other = solid_hull({{-0.4, -0.4, -0.4},
                                           {0.6, -0.3, -0.2},
                                           {-0.2, 0.7, -0.1},
                                           {-0.1, 0, 0.6}});
            SolidScene& bodies = setup.scene;
            bodies.gravity.setZero();
            add_body(bodies, {box}, 1.0, {0, 0, 0});
            add_body(bodies, {other}, 1.0, {-1.2, settings["height"], 0.3});
            bodies.bodies.u.segment<3>(6) = Vec3(settings["speed"], 0, 0);
            bodies.bodies.u.segment<3>(9) = Vec3(0.3, 1, 0.2);
            setup.camera.distance = 9;
            const SolidForm fa = form_of(bodies.shapes[0][0]),
                            fb = form_of(bodies.shapes[1][0]);
            using State = SolidState<SolidScene>;
            setup.measure = [fa, fb](const State& s) -> std::vector<Real> {
                const Between now = between(s.scene, fa, fb);
                return {now.near.distance, now.axis.separation};
            };
            setup.picture = [fa, fb](SolidPicture& picture, const State& s) {
                const Between now = between(s.scene, fa, fb);
                // the way from a to b: that of the nearest points, or the shortest out
                const Vec3 way = now.near.distance > 0
                                     ? Vec3(now.near.on_b - now.near.on_a)
                                     : now.axis.separation * now.axis.normal;
                const Style red{Colour::red, 2, 1};
                if (now.near.distance > 0)
                    picture.line({now.near.on_a, now.near.on_b}, red);
                std::vector<Vec3> differences;
                for (const Vec3& q : now.b.vertices)
                    for (const Vec3& p : now.a.vertices)
                        differences.push_back(q - p);
                const Vec3 origin(3, 0, -0.5);  // of the second picture
                picture.hull(solid_hull(differences), origin, Mat3::Identity(),
                             Colour::green);
                picture.line({origin, origin + way}, red);
                for (int i = 0; i < 3; ++i) {
                    const Vec3 arm = 0.12 * Vec3::Unit(i);
                    picture.line({origin - arm, origin + arm}, {Colour::ink, 2, 1});
                }
            };
            return setup;
        });
    scene.tunables.push_back({"speed", "m/s", "of the tetrahedron", 0.5, 0.1, 2,
                              Numbers::real, OnChange::restarts});
    scene.tunables.push_back({"height", "m", "at which it passes", 0.85, -1.5, 1.5,
                              Numbers::real, OnChange::restarts});
    scene.columns = {
        {"distance", "m", "of both, 0 where they overlap", Plot::linear},
        {"separation", "m", "along the best face or pair of edges", Plot::linear}};
    return scene;
}

}  // namespace rigid
