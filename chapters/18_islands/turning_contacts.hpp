/// \file turning_contacts.hpp
/// Contacts in small steps: their normals turn as those of (12.4) do, so that C is the gap, however far a pair has turned.
///
///     C = C₀ + J Δx + n·(e_b − e_a) + (n' − n)·d' − Δθ n⊥·d,    e = (R − 1) r − θ r⊥                                  (18.8)
///
/// for an arm r of a body that has turned by θ, and d = p_b − p_a. J stays as it was when the step began. What it is off by is
/// of first order in how far a pair has turned, and the C of the next small step makes up for it.
#pragma once

#include "chapters/17_wide_sweeps/wide_rows.hpp"
#include "chapters/18_islands/step_part.hpp"

#include <utility>

namespace rigid {

//! [contact]
/// What the normal of a contact turns with, in its lane.
enum class LaneTurns { none, first, second, centres };

/// A contact in each lane. If only one of its bodies is moved by impulses it is the
/// second one, and the first goes on as it goes; n, which is in J, goes from the
/// first to the second.
template <class V>
struct LaneContact {
    bool some = false, some_centres = false;  ///< of the lanes
    int driven = -1;  ///< velocities of first ones that impulses do not move
    V first[2]{}, second[2]{};  ///< r, from the centroids to the points [m]
    V d[2]{};                   ///< from point to point, when the step began [m]
    V both{};                   ///< 1: impulses move the first one, too
    V turns{};                  ///< a LaneTurns, as a number
};
/// v and ω of a body in each lane [m/s, rad/s].
template <class V>
struct LaneSpeed {
    V u[3]{};
};
//! [contact]

//! [write]
/// A contact into its lane.
/// \param row     of it in the part
/// \param places  of the two bodies of the lane, in the part
/// \param speeds  of what is driven
template <class V>
void write_contact(const Contact& contact, const StepData<3>& whole,
                   const StepPart& part, const Row<3>& row,
                   std::pair<int, int> places, int lane, LaneContact<V>& out,
                   std::vector<LaneSpeed<V>>& speeds)
{
    struct Side {
        Vec2 r, p;  // from the centroid to the point, and where that is
        bool turns_normal;
    };
    const auto side = [&](Index in_scene, Index in_part, Real core, NormalOf own) {
        const Vec2 point = contact.point + core * contact.normal;
        if (in_part == world) return Side{Vec2(0, 0), point, false};
        const Vec<3> found = whole.x_found.segment<3>(3 * in_scene),
                     x = part.local.x.segment<3>(3 * in_part);
        const Vec2 then = point - found.head<2>();
        const auto [s, c] = sine_and_cosine(x[2] - found[2]);
        const Vec2 r = c * then + s * perpendicular(then);
        return Side{r, x.head<2>() + r, contact.normal_of == own};
    };
    Side first = side(contact.a, row.a, -contact.core_a, NormalOf::a),
         second = side(contact.b, row.b, contact.core_b, NormalOf::b);
    const bool swapped = places.second != row.b,
               both = places.first != places.second;
    if (swapped) std::swap(first, second);
    const Vec2 d = second.p - first.p;
    for (int i = 0; i < 2; ++i) {
        write_lane(out.d[i], lane, d[i]);
        write_lane(out.first[i], lane, first.r[i]);
        write_lane(out.second[i], lane, second.r[i]);
    }
    write_lane(out.both, lane, both);
    const bool centres = contact.normal_of == NormalOf::centres;
    const LaneTurns turns = centres               ? LaneTurns::centres
                            : first.turns_normal  ? LaneTurns::first
                            : second.turns_normal ? LaneTurns::second
                                                  : LaneTurns::none;
    write_lane(out.turns, lane, static_cast<Real>(turns));
    out.some = true, out.some_centres |= centres;
    const Index alone = swapped ? row.b : row.a;
    if (both || alone == world || part.local.velocity(alone).isZero(0)) return;
    if (out.driven < 0)
        out.driven = static_cast<int>(speeds.size()), speeds.emplace_back();
    for (int i = 0; i < 3; ++i)
        write_lane(speeds[static_cast<std::size_t>(out.driven)].u[i], lane,
                   part.local.u[3 * alone + i]);
}
//! [write]

//! [turned]
/// What an arm does besides turning along J.
template <class V>
struct TurnedArm {
    V cosine, sine;     ///< cos θ − 1 and sin θ
    V way[2], rest[2];  ///< (R − 1) r, and e of it [m]

    TurnedArm(const V& theta, const V (&r)[2])
    {
        const V none{}, s = theta * theta;  // Taylor: to θ⁹/362880
        const V beyond = theta * s *
                         (none - Real(1) / 6 +
                          s * (none + Real(1) / 120 - s * (none + Real(1) / 5040)));
        cosine =
            s * (none - Real(0.5) +
                 s * (none + Real(1) / 24 -
                      s * (none + Real(1) / 720 - s * (none + Real(1) / 40320))));
        sine = theta + beyond;
        way[0] = cosine * r[0] - sine * r[1];
        way[1] = cosine * r[1] + sine * r[0];
        rest[0] = cosine * r[0] - beyond * r[1];
        rest[1] = cosine * r[1] + beyond * r[0];
    }
};

/// (18.8) without C₀ + J Δx.
/// \param n       when the step began
/// \param x1, x2  Δx of the two bodies
template <class V>
V turned_gap(const LaneContact<V>& at, const V (&n)[2], const V (&x1)[3],
             const V (&x2)[3])
{
    const V none{}, one = none + 1;
    const auto with = [&](LaneTurns what, const V& of_it) -> V {
        return at.turns == none + static_cast<Real>(what) ? of_it : none;
    };
    const TurnedArm<V> a(x1[2], at.first), b(x2[2], at.second);
    const V cosine = with(LaneTurns::first, a.cosine) +
                     with(LaneTurns::second, b.cosine),
            sine = with(LaneTurns::first, a.sine) + with(LaneTurns::second, b.sine),
            angle = with(LaneTurns::first, x1[2]) + with(LaneTurns::second, x2[2]);
    V more[2] = {cosine * n[0] - sine * n[1],
                 cosine * n[1] + sine * n[0]};  // n' − n
    V d[2];
    for (int i = 0; i < 2; ++i)
        d[i] = at.d[i] + (x2[i] + b.way[i]) - (x1[i] + a.way[i]);
    if (at.some_centres) {
        const V length = root_of(V(d[0] * d[0] + d[1] * d[1])),
                by = length > none ? length : one;
        for (int i = 0; i < 2; ++i) {
            const V turned = length > none ? V(d[i] / by - n[i]) : none;
            more[i] = more[i] + with(LaneTurns::centres, turned);
        }
    }
    const V along = n[0] * (b.rest[0] - a.rest[0]) + n[1] * (b.rest[1] - a.rest[1]);
    return along + (more[0] * d[0] + more[1] * d[1]) -
           angle * (n[0] * at.d[1] - n[1] * at.d[0]);
}
//! [turned]

}  // namespace rigid
