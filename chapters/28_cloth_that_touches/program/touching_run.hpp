/// \file touching_run.hpp
/// One scene of cloth that touches: chapter 27's run with solids, which are drawn, and contacts, which are counted.
#pragma once

#include "chapters/22_distance_of_solids/convex_hull.hpp"
#include "chapters/27_particles_and_cloth/program/scenes.hpp"
#include "chapters/28_cloth_that_touches/touching_scenes.hpp"
#include "chapters/28_cloth_that_touches/touching_step.hpp"

namespace rigid {

using TouchingState = ClothStateOf<TouchingCloth, TouchingMemory>;

inline void draw_solids(SolidPicture& picture, const TouchingCloth& cloth)
{
    for (Index k = 0; k < cloth.solids.count(); ++k) {
        const ClothSolid& s = cloth.shapes[static_cast<std::size_t>(k)];
        if (s.shape == ClothSolid::Shape::wall) continue;
        if (s.shape == ClothSolid::Shape::mesh) {
            const Mat3 axes = rotation_of(cloth.solids.x, k);
            const Vec3 centre = centre_of(cloth.solids.x, k);
            const auto place = [&](int t, int i) -> Vec3 {
                // its large triangles would show through the cloth
                return centre + axes * s.mesh->corner(t, i) - Vec3(0, 0.06, 0);
            };
            for (int t = 0; t < s.mesh->count(); ++t)
                picture.facet({place(t, 0), place(t, 1), place(t, 2)},
                              Colour::orange);
            continue;
        }
        Hull hull;
        if (s.shape == ClothSolid::Shape::box)
            hull = solid_box(2 * (s.half + Vec3::Constant(s.radius)));
        else {
            hull.vertices = {-s.half, s.half};
            if (s.half.isZero(0)) hull.vertices.pop_back();
            hull.radius =
                0.88 * s.radius;  // its slices would show through the cloth
        }
        picture.hull(hull, centre_of(cloth.solids.x, k),
                     rotation_of(cloth.solids.x, k), Colour::orange);
    }
    const auto pinned = [&cloth](int p) {
        return !(cloth.bodies.inverse_mass[3 * p] > 0);
    };
    for (const ClothTie& t : cloth.ties)  // ropes that hold a solid
        for (const ClothSpring& spring : cloth.springs)
            if (spring.a == t.particle && pinned(spring.b))
                picture.line({Vec3(cloth.bodies.position(spring.a)),
                              Vec3(cloth.bodies.position(spring.b))},
                             {Colour::blue, 1.5, 0.9});
}

inline std::vector<Real> touching_measures(const TouchingState& s)
{
    std::vector<Real> all = cloth_measures(s);
    all.push_back(static_cast<Real>(s.memory.touch.contacts.size()));
    return all;
}

/// A scene of chapter 27's kind with one more column.
inline Demo
touching_demo(const std::string& name, const std::string& summary, const View& view,
              const Camera& camera, Real ground, Real squares, Real k,
              std::function<TouchingCloth(const Settings&)> make,
              std::function<void(TouchingState&, const Settings&)> change = {},
              std::function<std::vector<Real>(const TouchingState&)> measure =
                  touching_measures)
{
    Demo scene = sheet_demo<TouchingState>(name, summary, view, camera, ground,
                                           squares, k, std::move(make),
                                           std::move(change), std::move(measure));
    scene.columns.push_back(
        {"contacts", "", "particles near a solid", Plot::linear});
    return scene;
}

}  // namespace rigid
