/// \file contact.hpp
/// Which discs touch each other or a wall, or nearly do.
///
/// The normal points from a to b and the gap is positive while they are apart. Here each
/// pair is tested, N²/2 of them; chapter 10 finds out which of them it can leave out.
#pragma once

#include "common/scenes.hpp"

#include <vector>

namespace rigid {

/// What the normal of a contact turns with: the body whose face it is of, or the centres of two discs. That of a wall of the
/// world stays, and so does one from corner to corner, for these may pass each other.
enum class NormalOf : char { fixed, a, b, centres };

struct Contact {
    Index a = world, b = 0;  ///< the bodies; a wall of the world is always a
    Vec2 normal = {0, 1};    ///< unit vector from a to b
    Real gap = 0;            ///< distance of the surfaces [m]; negative = penetration
    Index feature = 0;    ///< which of several contacts of this pair: the number of the wall, segments last
    Vec2 point = {0, 0};  ///< where they touch [m], of bodies that turn (chapter 11)
    Real core_a = 0,
         core_b = 0;  ///< from there, against and along the normal, to what turns with a and with b [m]
    /// of bodies of several shapes (chapter 19): from the numbers of the bodies to those of the shapes that touch
    int from_a = 0, from_b = 0;
    NormalOf normal_of = NormalOf::fixed;

    Index shape_a() const { return a + from_a; }
    Index shape_b() const { return b + from_b; }
};

/// What a contact is between bodies of Dof numbers: in space it is another (chapter 25).
template <int Dof>
struct ContactOf {
    using Type = Contact;
};

/// The contact of two discs, a < b, at the positions x. Two centres in one point have no direction; any will part them.
inline Contact disc_contact(const DiscScene& scene, const VecX& x, Index a, Index b)
{
    const Vec2 d = x.segment<2>(2 * b) - x.segment<2>(2 * a);
    const Real distance = d.norm();
    return {a, b, direction_of(d, distance, {0, 1}), distance - scene.radius[a] - scene.radius[b], 0};
}

/// The contact of disc b with a segment. Beside it the normal is that of the segment, towards the disc; beyond its ends
/// it comes from the end.
Contact segment_contact(const DiscScene& scene, const VecX& x, std::size_t segment, Index b);

/// The contact of disc b with a wall of the world at the positions x.
/// \param wall  below the number of half-spaces: one of them; the others are segments
inline Contact wall_contact(const DiscScene& scene, const VecX& x, Index wall, Index b)
{
    const auto i = static_cast<std::size_t>(wall);
    if (i >= scene.walls.size()) return segment_contact(scene, x, i - scene.walls.size(), b);
    const HalfSpace& half = scene.walls[i];
    return {world, b, half.normal, half.normal.dot(x.segment<2>(2 * b)) - half.offset - scene.radius[b],
            wall};
}

/// Collects the contacts of discs with each other and with walls whose gap is below the margin.
/// \param margin    [m]; a contact with a gap of up to this much is reported before it closes
/// \param contacts  is emptied and filled: pairs a < b in ascending order, then walls. Its
///                  memory is kept, so that a steady scene does not allocate.
/// \throws std::invalid_argument  unless each disc has two coordinates and a radius, and the margin makes sense
void find_contacts(const DiscScene& scene, Real margin, std::vector<Contact>& contacts);

/// Calls visit(contact) for each wall whose gap to disc b is below the margin.
template <class Visit>
void for_each_wall(const DiscScene& scene, Index b, Real margin, const Visit& visit)
{
    const auto count = static_cast<Index>(scene.walls.size() + scene.segments.size());
    for (Index wall = 0; wall < count; ++wall)
        if (const Contact contact = wall_contact(scene, scene.bodies.x, wall, b); contact.gap < margin)
            visit(contact);
}

}  // namespace rigid
