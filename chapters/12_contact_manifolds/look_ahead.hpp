/// \file look_ahead.hpp
/// How far a body may come in a step: two that close their gap in it get their rows before it, however small the margin is.
///
///     reach = min(h (|v| + |g| h + |ω| R), s inner radii),     0 where the way is within half the margin              (12.14)
///
/// A row with a gap lets the two come as near as the gap, and no nearer. Without it they overlap by what they move in a step,
/// before anybody has looked. It is about a line, not a shape, and is false beside a corner: hence the second bound. What
/// goes farther is stopped on its way (fast_bodies.hpp). A half-space has no corner: against it the whole way counts, and
/// so it does for the other end of an edge one end of which has a row.
#pragma once

#include "chapters/12_contact_manifolds/fast_bodies.hpp"

namespace rigid {

struct LookAhead {
    Real margin = 0;  ///< [m]
    Real most = 0;    ///< s [inner radii]; 0 = none looks ahead
    Real h = 0;       ///< of the step [s]
    /// of each body, where gravity is not all that moves it [m/s²]; empty = it is
    std::span<const Real> falls = {};
};

//! [ahead]
/// (12.14) of some bodies; others do not look.
/// \param before  those that looked in the step before
/// \param reach   of all bodies [m]
/// \param ways    of all bodies, without the second bound [m]
inline void look_ahead(const RigidScene& scene, const PlacedShapes& placed,
                       const LookAhead& how, std::span<const int> before,
                       std::span<const int> bodies, std::vector<Real>& reach,
                       std::vector<Real>& ways)
{
    if (!(how.most > 0)) {
        reach.clear();
        ways.clear();
        return;
    }
    for (std::vector<Real>* const far : {&reach, &ways}) {
        far->resize(static_cast<std::size_t>(scene.bodies.count()), 0);
        for (const int k : before)
            if (k < scene.bodies.count()) (*far)[static_cast<std::size_t>(k)] = 0;
    }
    const Real fall = scene.gravity.norm() * how.h;
    for (const int k : bodies) {
        const auto at = static_cast<std::size_t>(k);
        const Index body = scene.carrier(k);
        const Vec<3> u = scene.bodies.velocity(body);
        const Real falling =
                       how.falls.empty()
                           ? fall
                           : how.falls[static_cast<std::size_t>(body)] * how.h,
                   turns = std::abs(u[2]) * placed.turning[at],
                   falls = scene.bodies.can_move(body) ? falling : 0,
                   way = how.h * (u.head<2>().norm() + falls + turns),
                   inner = placed.inner[at];
        ways[at] = way > how.margin / 2 ? way : 0;
        reach[at] = std::min(ways[at], how.most * std::max(Real{0}, inner));
    }
}
//! [ahead]

}  // namespace rigid
