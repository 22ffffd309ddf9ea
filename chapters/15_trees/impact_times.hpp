/// \file impact_times.hpp
/// When the contacts of a step close, while impact follows on impact: each body has the time of its last one, and its way there.
#pragma once

#include "chapters/03_mlcp_formulation/step_data.hpp"

namespace rigid {

//! [times]
struct ImpactTimes {
    VecX u;     ///< of each body, after its last impact [m/s]
    VecX way;   ///< of each body, from the beginning of the step to that [m]
    VecX time;  ///< when it was [s]

    /// From here on body k moves on its way.
    void begin(const Bodies<3>& bodies, Index k)
    {
        u.segment<3>(3 * k) = bodies.velocity(k);
        way.segment<3>(3 * k).setZero();
        time[k] = 0;
    }
    void resize(const Bodies<3>& bodies)
    {
        if (u.size() == bodies.u.size()) return;
        u = way = bodies.u;
        time.setZero(bodies.count());
    }

    /// When a row's gap closes, if its bodies go on as they do [s].
    /// \param gap  at the beginning of the step [m]
    /// \param v    of the approach, positive [m/s]
    Real of(const Row<3>& row, Real gap, Real v) const
    {
        Real t = 0;
        for (const Index k : {row.a, row.b})
            if (k != world) t = std::max(t, time[k]);
        if (row.a != world) gap += row.Ja.dot(place(row.a, t));
        if (row.b != world) gap += row.Jb.dot(place(row.b, t));
        return t + std::max(Real{0}, gap) / v;
    }
    /// The bodies of a row have an impact at the time t.
    void reach(const Row<3>& row, Real t)
    {
        for (const Index k : {row.a, row.b}) {
            if (k == world || t <= time[k]) continue;
            way.segment<3>(3 * k) = place(k, t);
            time[k] = t;
        }
    }

private:
    Vec<3> place(Index k, Real t) const
    {
        return way.segment<3>(3 * k) + u.segment<3>(3 * k) * (t - time[k]);
    }
};
//! [times]

}  // namespace rigid
