/// \file driven_bodies.hpp
/// Bodies that nothing pushes and that a caller has given another velocity: in a step of n sub-steps it changes by a part in
/// each.
///
///     u_i = u_then + (i + 1)/n (u − u_then),     i = 0 … n − 1
///
/// All of the change in the first sub-step would be a jump that friction has to bear with μ g h/n in place of μ g h: a block
/// would slip on a platform that accelerates slowly enough to carry it. A body with a target has to be there after the step, so
/// its velocities have the mean v that brings it there, and change within the step as v has changed since the step before:
///
///     u_i = v + (2 i + 1 − n)/(2 n) (v − v_then)                                                   (19.4)
#pragma once

#include "chapters/03_mlcp_formulation/step_data.hpp"

#include <vector>

namespace rigid {

//! [driven]
struct DrivenBody {
    Index body = 0;
    Vec<3> then = Vec<3>::Zero();  ///< its velocity in the step before [m/s, rad/s]
    Vec<3> now = Vec<3>::Zero();   ///< that which it ends this step with
    bool aims = false;             ///< `now` is the mean of this step

    Vec<3> in(int substep, int substeps) const
    {
        if (aims)
            return now +
                   (2 * substep + 1 - substeps) * (now - then) / (2 * substeps);
        if (substep + 1 == substeps) return now;
        return then + (substep + 1) * (now - then) / substeps;
    }
};

struct DrivenBodies {
    std::vector<DrivenBody> list;  ///< of this step

    /// Their velocities in the present sub-step; rows see no others.
    void drive(Bodies<3>& bodies, int substeps, StepData<3>& now) const
    {
        for (const DrivenBody& it : list) {
            bodies.velocity(it.body) = it.in(now.substep, substeps);
            now.u_star.segment<3>(3 * it.body) = bodies.velocity(it.body);
        }
    }
};
//! [driven]

}  // namespace rigid
