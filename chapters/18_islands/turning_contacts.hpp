/// \file turning_contacts.hpp
/// Contacts in small steps: their normals turn as those of (12.4) do, and C and J are those of where the bodies are.
///
///     C = C₀ + n'·d' − n·d,    J_n = (−n', −r_a × n'), (n', r_b × n'),    J_t = (−t', −q_a·n'), (t', q_b·n')        (18.8)
///
/// for the way d from the point of a to that of b, the arms r of C's derivative (11.13) and those q to the point of friction
/// (13.3), t' at right angles to n'.
#pragma once

#include "chapters/17_wide_sweeps/wide_rows.hpp"

namespace rigid {

//! [contact]
/// What the normal of a contact turns with, in its lane.
enum class LaneTurns { none, first, second, centres };

/// A contact in each lane. If only one of its bodies is moved by impulses it is the
/// second one, and the first goes on as it goes; n goes from the first to the second.
template <class V>
struct LaneContact {
    bool some = false, some_centres = false;  ///< of the lanes
    int drag = -1;  ///< the row of its friction; −1: none
    V is{};         ///< 1, or 0 in lanes of others
    V both{};       ///< 1: impulses move the first one, too
    V u[3]{};       ///< of a first one that they do not move [m/s, rad/s]
    V turns{};      ///< a LaneTurns, as a number
    // when the step began
    V n[2]{};
    V first[2]{}, second[2]{};  ///< r, from the centroids to the points [m]
    V d[2]{};                   ///< from point to point [m]
    // of friction
    V drags{};        ///< 1 where there is some
    V with_second{};  ///< 1: its point goes with the second body
    V arm{};          ///< q·n of the body that the point goes with [m]
    V belt{};         ///< b, less J u of what nothing moves [m/s]
};
//! [contact]

//! [turned]
/// What an arm does as its body turns.
template <class V>
struct TurnedArm {
    V cosine, sine;  ///< cos θ − 1 and sin θ
    V way[2];        ///< (R − 1) r [m]

    TurnedArm(const V& theta, const V (&r)[2])
    {
        // of half the angle by Taylor, to x⁹/362880; nothing turns more than once
        const V none{},
            most = none + pi,
            x = at_most(at_least(V(theta * Real(0.5)), V(none - most)), most),
            s = x * x,
            half_sine = x + x * s *
                                (none - Real(1) / 6 +
                                 s * (none + Real(1) / 120 -
                                      s * (none + Real(1) / 5040 -
                                           s * (none + Real(1) / 362880)))),
            half_cosine = none + 1 +
                          s * (none - Real(0.5) +
                               s * (none + Real(1) / 24 -
                                    s * (none + Real(1) / 720 -
                                         s * (none + Real(1) / 40320))));
        sine = 2 * half_sine * half_cosine;
        cosine = none - 2 * half_sine * half_sine;
        way[0] = cosine * r[0] - sine * r[1];
        way[1] = cosine * r[1] + sine * r[0];
    }
};

/// (18.8): a contact where its bodies are.
template <class V>
struct TurnedContact {
    V C;                        ///< less C₀ [m]
    V n[2];                     ///< n'
    V first, second;            ///< r × n' of both bodies, as J has it [m]
    V drag_first, drag_second;  ///< q·n' [m]

    /// \param x1, x2  Δx of the two bodies
    TurnedContact(const LaneContact<V>& at, const V (&x1)[3], const V (&x2)[3])
    {
        const V none{}, one = none + 1;
        const auto with = [&](LaneTurns what, const V& of_it) -> V {
            return at.turns == none + static_cast<Real>(what) ? of_it : none;
        };
        const TurnedArm<V> a(x1[2], at.first), b(x2[2], at.second);
        const V cosine = with(LaneTurns::first, a.cosine) +
                         with(LaneTurns::second, b.cosine),
                sine = with(LaneTurns::first, a.sine) +
                       with(LaneTurns::second, b.sine);
        V more[2] = {cosine * at.n[0] - sine * at.n[1],
                     cosine * at.n[1] + sine * at.n[0]};  // n' − n
        V way[2], d[2];
        for (int i = 0; i < 2; ++i) {
            way[i] = (x2[i] + b.way[i]) - (x1[i] + a.way[i]);
            d[i] = at.d[i] + way[i];
        }
        if (at.some_centres) {
            const V length = root_of(V(d[0] * d[0] + d[1] * d[1])),
                    by = length > none ? length : one;
            for (int i = 0; i < 2; ++i) {
                const V turned = length > none ? V(d[i] / by - at.n[i]) : none;
                more[i] = more[i] + with(LaneTurns::centres, turned);
            }
        }
        C = (at.n[0] * way[0] + at.n[1] * way[1]) +
            (more[0] * d[0] + more[1] * d[1]);
        V r1[2], r2[2], apart[2];  // from the centroid of the second to the first
        for (int i = 0; i < 2; ++i) {
            n[i] = at.n[i] + more[i];
            r1[i] = at.first[i] + a.way[i], r2[i] = at.second[i] + b.way[i];
            apart[i] = r2[i] - r1[i] - d[i];
        }
        const auto along = [&](const V(&r)[2]) -> V {
            return r[0] * n[0] + r[1] * n[1];
        };
        const auto across = [&](const V(&r)[2]) -> V {
            return r[0] * n[1] - r[1] * n[0];
        };
        const V turn = across(d);
        first = across(r1) + with(LaneTurns::first, turn);
        second = across(r2) - with(LaneTurns::second, turn);
        const V more1 = along(r1) - (at.first[0] * at.n[0] + at.first[1] * at.n[1]),
                more2 =
                    along(r2) - (at.second[0] * at.n[0] + at.second[1] * at.n[1]),
                own = at.with_second > none ? more2 : more1,
                q = at.arm + (at.turns > none ? own : none), to = along(apart);
        drag_first = at.with_second > none ? V(q - to) : q;
        drag_second = at.with_second > none ? q : V(q + to);
    }
};
//! [turned]

}  // namespace rigid
