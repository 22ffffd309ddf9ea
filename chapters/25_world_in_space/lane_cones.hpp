/// \file lane_cones.hpp
/// The visits of a row (6.3) and of a disc (24.4), written for lanes of numbers.
///
/// The sums are made in the order of chapter 6 and of visit_disc(), so each lane has their bits. W = M⁻¹ Jᵀ is not kept but
/// made where it is needed, from J and the inverse masses of the two bodies: 17 numbers a row to read, where SolverRow has 29.
#pragma once

#include "chapters/17_wide_sweeps/wide_rows.hpp"

namespace rigid {

//! [lane_row]
/// Six numbers of a body: three of its way, three of its turn.
template <class V>
struct LaneSix {
    V way[3], turn[3];

    const V& operator[](int d) const { return d < 3 ? way[d] : turn[d - 3]; }
    V& operator[](int d) { return d < 3 ? way[d] : turn[d - 3]; }
};
/// Velocities, or inverse masses, of the two bodies of a run.
template <class V>
struct LaneBodies {
    LaneSix<V> a, b;
};
/// A row in each lane.
template <class V>
struct LaneRow {
    LaneSix<V> Ja, Jb;
    V bias, mass, lo, hi, lambda;
};
/// What two rows of friction have besides: A = (a c; c b), and its larger eigenvalue.
template <class V>
struct LaneDisc {
    V a, b, c, det, largest;
    V friction;  ///< μ; of a row that is bounded by itself, too
};
//! [lane_row]

/// w = J u + b
template <class V>
inline V velocity(const LaneRow<V>& row, const LaneBodies<V>& u)
{
    const auto part = [&](int d) -> V {
        const V of_a = row.Ja[d] * u.a[d], of_b = row.Jb[d] * u.b[d];
        return of_a + of_b;
    };
    // as Eigen adds six numbers in pairs
    const V even = part(0) + (part(2) + part(4)),
            odd = part(1) + (part(3) + part(5));
    return row.bias + (even + odd);
}

/// u ← u + M⁻¹ Jᵀ Δλ
template <class V>
inline void push(const LaneRow<V>& row, const V& change,
                 const LaneBodies<V>& inverse, LaneBodies<V>& u)
{
    for (int d = 0; d < 6; ++d) {
        const V Wa = inverse.a[d] * row.Ja[d], Wb = inverse.b[d] * row.Jb[d];
        u.a[d] = u.a[d] + Wa * change;
        u.b[d] = u.b[d] + Wb * change;
    }
}

/// One visit of one row in each lane, (6.3) to (6.5).
/// \return  Δλ
template <class V>
inline V visit(LaneRow<V>& row, const V& lo, const V& hi,
               const LaneBodies<V>& inverse, LaneBodies<V>& u)
{
    const V free = row.lambda - row.mass * velocity(row, u);
    const V lambda = at_most(at_least(free, lo), hi);
    const V change = lambda - row.lambda;
    row.lambda = lambda;
    push(row, change, inverse, u);
    return change;
}

template <class Mask>
inline bool any_of(const Mask& mask)
{
    bool any = false;
    for (std::size_t i = 0; i < sizeof(Mask) / sizeof(mask[0]); ++i)
        any |= mask[i] != 0;
    return any;
}

//! [visit_disc]
/// (24.4) in each lane. Where all lanes hold, nothing is projected.
/// \param rows    two
/// \param radius  μ λ_n as it is now [N s]
/// \return        how far the rows were off [m/s]
template <class V>
inline V visit_disc(LaneRow<V>* rows, const LaneDisc<V>& disc, const V& radius,
                    const LaneBodies<V>& inverse, LaneBodies<V>& u)
{
    const V one = V{} + Real(1);
    const V w0 = velocity(rows[0], u), w1 = velocity(rows[1], u);
    const V l0 = rows[0].lambda, l1 = rows[1].lambda;
    // the λ that stops the sliding; 0 of a disc that nothing moves
    const auto moves = disc.largest > V{};
    const auto regular = disc.det > Real(1e-12) * disc.largest * disc.largest;
    const V largest = moves ? disc.largest : one;
    const V by = regular ? disc.det : largest;
    const V d0 = regular ? V(disc.b * w0 - disc.c * w1) : w0,
            d1 = regular ? V(disc.a * w1 - disc.c * w0) : w1;
    V next0 = moves ? V(l0 - d0 / by) : l0, next1 = moves ? V(l1 - d1 / by) : l1;
    const auto slides =
        moves & ~(root_of(V(next0 * next0 + next1 * next1)) <= radius);
    if (any_of(slides)) {  // a step towards it, and back onto the disc
        const V step0 = l0 - w0 / largest, step1 = l1 - w1 / largest;
        const V length = root_of(V(step0 * step0 + step1 * step1));
        const auto outside = length > radius;
        const V shrink = radius / (outside ? length : one);
        const V on0 = outside ? V(step0 * shrink) : step0,
                on1 = outside ? V(step1 * shrink) : step1;
        next0 = slides ? on0 : next0, next1 = slides ? on1 : next1;
    }
    const V change0 = next0 - l0, change1 = next1 - l1;
    rows[0].lambda = next0, rows[1].lambda = next1;
    push(rows[0], change0, inverse, u), push(rows[1], change1, inverse, u);
    return disc.largest * root_of(V(change0 * change0 + change1 * change1));
}
//! [visit_disc]

}  // namespace rigid
