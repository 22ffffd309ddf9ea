/// \file surfaces.hpp
/// What a surface is like, and how two of them combine: μ, e, the speed of a belt, rolling resistance.
///
///     μ = √(μ_a μ_b),   e = max(e_a, e_b),   belt speeds add,   rolling arms: the longer one
///
/// μ and e belong to a pair of materials, and so do the numbers of the tables. A number per surface and a rule to
/// combine two is a makeshift that saves the table of pairs. The geometric mean keeps what is certain: equal surfaces
/// have their own μ, and what one surface does without friction, no partner can change.
#pragma once

#include "chapters/11_rotation/rigid_scene.hpp"

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>

namespace rigid {

//! [surface]
struct Surface {
    Real friction = 0;     ///< μ ≥ 0
    Real restitution = 0;  ///< e, 0 … 1
    /// speed of a belt: how fast the surface runs counterclockwise around its body
    /// [m/s]
    Real belt = 0;
    /// the arm of rolling resistance: its moment is at most this times λ_n [m]
    Real rolling = 0;
    /// μ of what slides, at most `friction`; none = the same (section 13.D)
    std::optional<Real> kinetic = std::nullopt;

    Real while_sliding() const { return kinetic.value_or(friction); }
    bool operator==(const Surface&) const = default;
};

/// The surface of two that touch.
inline Surface combined(const Surface& a, const Surface& b)
{
    Surface both{std::sqrt(a.friction * b.friction),
                 std::max(a.restitution, b.restitution), a.belt + b.belt,
                 std::max(a.rolling, b.rolling)};
    if (a.kinetic || b.kinetic)
        both.kinetic = std::sqrt(a.while_sliding() * b.while_sliding());
    return both;
}
//! [surface]

/// What bodies slide and spin on in a scene that is seen from above, such as the cloth of a pool table.
struct Cloth {
    Real friction = 0;    ///< μ ≥ 0
    Real gravity = 9.81;  ///< into the picture [m/s²]
    /// the arm of the moment that stops a spin: at most this times μ m g [m]
    Real arm = 0;

    bool operator==(const Cloth&) const = default;
};

//! [rough_scene]
/// A scene of bodies that turn, with surfaces. Where a list is empty nothing there
/// has friction.
struct RoughScene : RigidScene {
    std::vector<Surface> surfaces;       ///< one to a body, or none
    std::vector<Surface> wall_surfaces;  ///< one to a wall, or none
    Cloth cloth;
};
//! [rough_scene]

/// Throws std::invalid_argument, naming the surface and the value, unless it makes sense.
/// \param name    of what it belongs to: "the chain", "body"
/// \param number  behind the name, unless it is negative; a step checks every surface, and only a refusal puts
///                the two together
void require_valid(const Surface& surface, std::string_view name,
                   Index number = -1);

/// Throws std::invalid_argument, with a sentence that names the thing, unless the surfaces of a scene make sense.
void require_valid_surfaces(const RoughScene& scene);

/// Whether μ of anything in the scene depends on whether it slides.
bool has_kinetic_friction(const RoughScene& scene);

/// The same surface for all bodies and all walls.
inline void cover(RoughScene& scene, const Surface& surface)
{
    scene.surfaces.assign(scene.shapes.size(), surface);
    scene.wall_surfaces.assign(scene.walls.size(), surface);
}

/// The wall that a contact is on: the half-space with its normal on which its point lies.
std::size_t wall_of(const RigidScene& scene, const Vec2& normal, const Vec2& point);

}  // namespace rigid
