/// \file flush_faces.hpp
/// A floor of several bodies that stand is felt as one where their faces are flush: nothing catches on a seam.
///
///     hidden    p on a face of B, n out of B;   near p the face is inside C;   some c of C has n·(c − p) > 0        (12.13)
///
/// C is convex: from p to c it is solid, so in front of the face, as near to p as one likes, there is no room for anything. No
/// outline of B and C together has the normal n at p; what touches there touches C, and the contact with C says how. Where the
/// face is free beside p, as a floor is beside the foot of a wall, nothing is hidden. Where one face at p is free and another
/// one hidden, something else must bear what the free one would. The engine looks for hidden faces (chapter 19); chapter 12
/// has chains.
#pragma once

#include "chapters/12_contact_manifolds/casts.hpp"
#include "common/shapes.hpp"

namespace rigid {

//! [hides]
inline bool is_inside(const Placed& shape, const Vec2& point, Real tolerance)
{
    return distance_to(shape, point) <= tolerance;
}
inline bool is_inside(const HalfSpace& wall, const Vec2& point, Real tolerance)
{
    return wall.normal.dot(point) - wall.offset <= tolerance;
}

/// Whether some of it is in front of the plane through p with the normal n.
inline bool is_in_front(const Placed& shape, const Vec2& p, const Vec2& n,
                        Real tolerance)
{
    return std::any_of(
        shape.vertices.begin(), shape.vertices.end(),
        [&](const Vec2& c) { return n.dot(c - p) + shape.radius > tolerance; });
}
inline bool is_in_front(const HalfSpace& wall, const Vec2&, const Vec2& n, Real)
{
    return (n - wall.normal).squaredNorm() > 1e-6;
}

/// What another thing that stands, a shape or a half-space, does to the faces that a
/// shape has at p and that n leans on.
struct FacesAt {
    bool hidden = false;  ///< (12.13), one of them
    Vec2 free = {0, 0};   ///< the normal of one that is not; zero: there is none
};
/// \param p         on the outline of the shape
/// \param n         out of it
/// \param flush     how well the two must fit [m]
template <class Other>
FacesAt faces_at(const Other& other, const Placed& shape, const Vec2& p,
                 const Vec2& n, Real flush)
{
    FacesAt faces;
    if (!is_inside(other, p, flush) || !is_in_front(other, p, n, flush / 10))
        return faces;
    for (int i = 0; i < shape.edges(); ++i) {
        const Vec2& m = shape.normal(i);
        if (!(n.dot(m) > 1e-3)) continue;
        const Vec2 from = shape.vertex(i) + shape.radius * m,
                   e = shape.vertex(shape.next(i)) - shape.vertex(i);
        const Real length = e.norm(), along = e.dot(p - from) / length;
        if (std::abs(m.dot(p - from)) > flush || along < -flush ||
            along > length + flush)
            continue;
        const auto is_free = [&](Real at) {
            at = std::clamp(at, Real{0}, length);
            return !is_inside(other, Vec2(from + at / length * e), flush);
        };
        if (!is_free(along - 8 * flush) && !is_free(along + 8 * flush))
            faces.hidden = true;
        else faces.free = m;
    }
    return faces;
}
template <class Other>
bool hides(const Other& other, const Placed& shape, const Vec2& p, const Vec2& n,
           Real flush)
{
    return faces_at(other, shape, p, n, flush).hidden;
}

/// Whether each point of a manifold is on a face that is hidden.
/// \param of_b    the shape is its b
/// \param hidden  bool(p, n)
template <class Hidden>
bool all_hidden(const Manifold& m, bool of_b, const Hidden& hidden)
{
    const Vec2 n = of_b ? Vec2(-m.normal) : m.normal;
    for (int i = 0; i < m.count; ++i) {
        const ManifoldPoint& point = m.points[static_cast<std::size_t>(i)];
        if (!hidden(Vec2(point.point - point.gap / 2 * n), n)) return false;
    }
    return m.count > 0;
}

/// What is flush, for a body of this inner radius.
inline Real flush_within(Real margin, Real inner)
{
    return std::min(margin / 20, std::max(Real{0}, inner) / 8);
}

/// Shapes that stand: their body cannot move and does not.
inline bool stands(const RigidScene& scene, Index k)
{
    const Index body = scene.carrier(k);
    return !scene.bodies.can_move(body) && scene.bodies.velocity(body).isZero(0);
}
//! [hides]

//! [seams]
/// Takes those pairs out of a list that touch a hidden face alone.
struct Seams {
    bool look = false;  ///< false: every pair is for itself

    /// \tparam Pairs  of what has a, b and a manifold
    template <class Pairs>
    void leave_out(const RigidScene& scene, const PlacedShapes& placed,
                   const ChainEdges& edges, Real margin, Pairs& pairs)
    {
        of_.clear();
        if (!look) return;
        for (std::size_t i = 0; i < pairs.size(); ++i) {
            const bool a = stands(scene, pairs[i].a), b = stands(scene, pairs[i].b);
            if (a == b) continue;
            const int still = a ? pairs[i].a : pairs[i].b;
            if (!edges.has(still))
                of_.push_back({a ? pairs[i].b : pairs[i].a, still, i, !a});
        }
        std::sort(of_.begin(), of_.end());
        bool any = false;
        for (auto first = of_.begin(); first != of_.end();) {
            const auto last = std::find_if(first, of_.end(), [&](const auto& it) {
                return it.mover != first->mover;
            });
            const std::span<Touching> touched(
                &*first, static_cast<std::size_t>(last - first));
            first = last;
            if (touched.size() < 2 && scene.walls.empty()) continue;
            const Real flush = flush_within(
                margin, placed.inner[static_cast<std::size_t>(touched[0].mover)]);
            const auto is_hidden = [&](const Touching& it) {
                return all_hidden(
                    pairs[it.pair].manifold, it.of_b,
                    [&](const Vec2& p, const Vec2& n) {
                        const Placed shape = placed.of(it.still);
                        const auto bears = [&](const Vec2& m) {
                            const auto shape_does = [&](const Touching& other) {
                                const Vec2& way = pairs[other.pair].manifold.normal;
                                return other.still != it.still && !other.hidden &&
                                       (other.of_b ? -way : way).dot(m) > 0.5 &&
                                       is_inside(placed.of(other.still), p, flush);
                            };
                            const auto wall_does = [&](const HalfSpace& wall) {
                                return wall.normal.dot(m) > 0.5 &&
                                       is_inside(wall, p, flush);
                            };
                            return std::any_of(touched.begin(), touched.end(),
                                               shape_does) ||
                                   std::any_of(scene.walls.begin(),
                                               scene.walls.end(), wall_does);
                        };
                        // at a corner whose other face is free, something else must
                        // bear there what that would bear
                        const auto is_by = [&](const auto& other) {
                            const FacesAt faces =
                                faces_at(other, shape, p, n, flush);
                            return faces.hidden &&
                                   (faces.free.isZero(0) || bears(faces.free));
                        };
                        const auto by = [&](const Touching& other) {
                            return other.still != it.still && !other.hidden &&
                                   is_by(placed.of(other.still));
                        };
                        const auto by_wall = [&](const HalfSpace& wall) {
                            return is_by(wall);
                        };
                        return std::any_of(touched.begin(), touched.end(), by) ||
                               std::any_of(scene.walls.begin(), scene.walls.end(),
                                           by_wall);
                    });
            };
            for (Touching& it : touched) it.next = is_hidden(it);
            for (Touching& it : touched) it.hidden = it.next;
            // what only hidden ones hide stays: the body would touch nothing
            for (Touching& it : touched) it.next = it.hidden && is_hidden(it);
            for (Touching& it : touched) {
                it.hidden = it.next;
                any = any || it.hidden;
            }
        }
        if (!any) return;
        for (const Touching& it : of_)
            if (it.hidden) pairs[it.pair].manifold.count = 0;
        std::erase_if(pairs,
                      [](const auto& pair) { return pair.manifold.count == 0; });
    }

private:
    struct Touching {
        int mover = 0, still = 0;
        std::size_t pair = 0;
        bool of_b = false;  ///< what stands is the pair's b
        bool hidden = false, next = false;

        bool operator<(const Touching& it) const
        {
            return std::pair(mover, pair) < std::pair(it.mover, it.pair);
        }
    };
    std::vector<Touching> of_;  ///< what stands, by what touches it
};
//! [seams]

}  // namespace rigid
