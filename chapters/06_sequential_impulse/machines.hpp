/// \file machines.hpp
/// Rows of small machines for a scene of discs: a lift, a belt, a rope. The caller hands them to impulse_step() as
/// `machines`, made anew from the present positions in each step.
#pragma once

#include "chapters/06_sequential_impulse/bias_and_bounds.hpp"
#include "common/bodies.hpp"

#include <vector>

namespace rigid {

struct Lift {
    Index body = 0;
    Real shaft = 0;          ///< x of the shaft [m]
    Real low = 0, high = 1;  ///< y of the stops [m]
    Real speed = 1;          ///< that the motor wants [m/s], upwards
    Real force = 0;          ///< that it has [N]
};

/// A body in a vertical shaft with a motor between two stops: four rows that chapter 2 has all the geometry for.
inline void add_lift(const Bodies<2>& bodies, const Lift& lift, Real h, std::vector<Row<2>>& rows)
{
    //! [lift]
    const auto along = [&](Vec2 n, Real offset) {
        return alignment_constraint<2>(bodies.x, world, lift.body, n, offset);
    };
    const VecX& inverse_mass = bodies.inverse_mass;
    rows.push_back(bilateral(along({1, 0}, lift.shaft), inverse_mass));
    rows.push_back(motor(along({0, 1}, 0), inverse_mass, lift.speed, lift.force, h));
    rows.push_back(one_sided(along({0, 1}, lift.low), inverse_mass, h));     // the stop below: y ≥ low
    rows.push_back(one_sided(along({0, -1}, -lift.high), inverse_mass, h));  // the stop above: −y ≥ −high
    //! [lift]
}

/// A belt that drags a body along x, with no more than a force: what lies on it is not glued to it.
inline void add_belt(const Bodies<2>& bodies, Index body, Real speed, Real force, Real h,
                     std::vector<Row<2>>& rows)
{
    const Constraint<2> along = alignment_constraint<2>(bodies.x, world, body, Vec2(1, 0), 0);
    rows.push_back(motor(along, bodies.inverse_mass, speed, force, h));
}

/// A rope between two bodies, at most as long as the link.
inline void add_rope(const Bodies<2>& bodies, const Link& link, Real h, std::vector<Row<2>>& rows)
{
    rows.push_back(one_sided(slack_constraint(bodies.x, link), bodies.inverse_mass, h));
}

}  // namespace rigid
