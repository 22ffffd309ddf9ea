/// \file boat_picture.hpp
/// What the picture of chapter 20 has besides hulls: boats.
#pragma once

#include "chapters/20_turning_in_space/program/solid_picture.hpp"
#include "chapters/24_friction_is_a_disc/rough_solids.hpp"

namespace rigid {

/// The lower half of an ellipsoid and its deck, in the body's axes.
inline void draw_boat(SolidPicture& picture, const SolidEllipsoid& e,
                      const Vec3& centre, const Mat3& R, Colour colour)
{
    const int rings = 6, slices = 16;
    const auto point = [&](int ring, int slice) -> Vec3 {
        const Real polar = pi / 2 * ring / rings, turn = 2 * pi * slice / slices;
        return centre +
               R * (e.at + e.stretch * Vec3(sin(polar) * cos(turn), -cos(polar),
                                            sin(polar) * sin(turn)));
    };
    std::vector<Vec3> deck;
    for (int slice = 0; slice < slices; ++slice) {
        for (int ring = 0; ring < rings; ++ring)
            picture.facet({point(ring, slice), point(ring + 1, slice),
                           point(ring + 1, slice + 1), point(ring, slice + 1)},
                          colour);
        deck.push_back(point(rings, slices - slice));
    }
    picture.facet(deck, Colour::yellow);
}

inline void draw_boats(SolidPicture& picture, const RoughSolids& scene)
{
    for (const SolidEllipsoid& e : scene.ellipsoids)
        draw_boat(picture, e, centre_of(scene.bodies.x, e.body),
                  rotation_of(scene.bodies.x, e.body), Colour::blue);
}

}  // namespace rigid
