/// \file hermite.hpp
/// The motion between two steps, from what is known at their ends.
///
/// Position, velocity and acceleration at both ends are six conditions, and a polynomial of
/// degree five has six coefficients (1.45). Any method leaves them behind; no force is
/// asked again.
#pragma once

#include "chapters/01_euler_integration/integrators.hpp"

namespace rigid {

/// The motion during one step [t, t + h], from position, velocity and acceleration at both
/// ends.
template <int N>
struct Hermite {
    State<N> s0, s1;
    Vec<N> a0, a1;
    Real h = 0;  ///< [s]

    //! [hermite]
    /// (1.45): the state at the part 0 ≤ θ ≤ 1 of the step; its velocity is the
    /// derivative of its position. Error O(h⁶) in x, O(h⁵) in u. Costs no
    /// evaluation.
    State<N> at(Real theta) const
    {
        const Vec<N> D = s1.x - s0.x - h * s0.u - h * h / 2 * a0;
        const Vec<N> V = h * (s1.u - s0.u - h * a0);
        const Vec<N> W = h * h * (a1 - a0);
        const Vec<N> c3 = 10 * D - 4 * V + W / 2;
        const Vec<N> c4 = -15 * D + 7 * V - W;
        const Vec<N> c5 = 6 * D - 3 * V + W / 2;
        const Real th = theta * h;
        const Real q = theta * theta;
        return {s0.x + th * s0.u + th * th / 2 * a0 +
                    q * theta * (c3 + theta * (c4 + theta * c5)),
                s0.u + th * a0 +
                    q / h * (3 * c3 + theta * (4 * c4 + 5 * theta * c5))};
    }
    //! [hermite]
};

}  // namespace rigid
