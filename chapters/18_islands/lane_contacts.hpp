/// \file lane_contacts.hpp
/// Contacts into lanes, and their rows as they turn.
#pragma once

#include "chapters/18_islands/step_part.hpp"
#include "chapters/18_islands/turning_contacts.hpp"

#include <utility>

namespace rigid {

//! [write]
/// A contact into its lane.
/// \param row     of it in the part
/// \param places  of the two bodies of the lane, in the part
template <class V>
void write_contact(const Contact& contact, const StepData<3>& whole,
                   const StepPart& part, const Row<3>& row,
                   std::pair<int, int> places, int lane, LaneContact<V>& out)
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
    write_lane(out.is, lane, 1);
    write_lane(out.both, lane, both);
    write_lane(out.with_second, lane,
               (contact.normal_of == NormalOf::b) != swapped);
    const bool centres = contact.normal_of == NormalOf::centres;
    const LaneTurns turns = centres               ? LaneTurns::centres
                            : first.turns_normal  ? LaneTurns::first
                            : second.turns_normal ? LaneTurns::second
                                                  : LaneTurns::none;
    write_lane(out.turns, lane, static_cast<Real>(turns));
    out.some = true, out.some_centres |= centres;
    const Index alone = swapped ? row.b : row.a;
    if (both || alone == world || part.local.velocity(alone).isZero(0)) return;
    for (int i = 0; i < 3; ++i)
        write_lane(out.u[i], lane, part.local.u[3 * alone + i]);
}
//! [write]

/// What its rows say when a step begins: n, and of friction the arm and the belt.
/// \param drag  its row of friction; null: it has none
template <class V>
void begin_contact(const WideRow<3, V>& normal, const WideRow<3, V>* drag,
                   LaneContact<V>& at)
{
    V to{};  // from the centroid of the second body to that of the first
    for (int i = 0; i < 2; ++i) {
        at.n[i] = normal.Jb[i];
        to = to + (at.second[i] - at.first[i] - at.d[i]) * at.n[i];
    }
    if (!drag) return;
    const V none{}, first = drag->Jb[2] - to;
    at.arm = at.with_second > none ? drag->Jb[2] : first;
    at.belt = drag->bias +
              (drag->Jb[0] * at.u[0] + drag->Jb[1] * at.u[1] + first * at.u[2]);
}

//! [turn]
/// A row of a contact gets another J: the force along n on the second body, and its
/// two arms across n.
/// \param is  1 where it does
/// \return    J u of a first body that impulses do not move [m/s]
template <class V>
V turn_row(const V& is, const LaneContact<V>& at, const V (&n)[2], const V& first,
           const V& second, const LaneMasses<3, V>& inverse, WideRow<3, V>& row)
{
    const V none{}, Ja[3] = {none - n[0], none - n[1], none - first},
                    Jb[3] = {n[0], n[1], second};
    V A = row.softness, rate = none;
    for (int d = 0; d < 3; ++d) {
        row.Ja[d] = is > none ? V(at.both * Ja[d]) : row.Ja[d];
        row.Jb[d] = is > none ? Jb[d] : row.Jb[d];
        A = A + row.Ja[d] * (inverse.a[d] * row.Ja[d]) +
            row.Jb[d] * (inverse.b[d] * row.Jb[d]);
        rate = rate + Ja[d] * at.u[d];
    }
    row.mass = row.mass > none ? (A == none ? none : V((none + 1) / A)) : row.mass;
    return rate;
}

/// (18.8): the rows of a contact go on as its bodies do.
/// \param drag  its row of friction; null: it has none
/// \return      J u of the normal, of a first body that impulses do not move [m/s]
template <class V>
V turn_rows(const LaneContact<V>& at, const TurnedContact<V>& now,
            const LaneMasses<3, V>& inverse, WideRow<3, V>& normal,
            WideRow<3, V>* drag)
{
    const V none{};
    if (drag) {
        const V t[2] = {none - now.n[1], now.n[0]};
        const V rate = turn_row(at.drags, at, t, now.drag_first, now.drag_second,
                                inverse, *drag);
        drag->bias = at.drags > none ? V(at.belt + rate) : drag->bias;
    }
    return turn_row(at.is, at, now.n, now.first, now.second, inverse, normal);
}
//! [turn]

}  // namespace rigid
