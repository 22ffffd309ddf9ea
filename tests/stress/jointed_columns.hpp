/// \file jointed_columns.hpp
/// A method of the one step as a column of bodies on joints.
#pragma once

#include "tests/stress/jointed.hpp"
#include "tests/stress/stepping.hpp"
#include "tests/stress/turning_honest.hpp"

namespace rigid::stress {

/// What moves bodies by itself, without rows that a solver answers, has nothing that could be called solved.
struct NothingSaid {
    template <class Solving>
    void operator()(const Solving&, const StepData<3>&) const
    {
    }
};

inline Manifolds& touching(Manifolds& contacts) { return contacts; }
inline Manifolds& touching(AwakeManifolds& contacts) { return contacts.touching; }

template <class Solving, class Honest = HonestTurning>
JointedMethod jointed(int chapter, const std::string& name, const std::string& budget, Solving by,
                      int substeps = 1, const Honest& honest = {})
{
    never_stop(touching(by.contacts));  // section 15.C
    auto method = stepping<JointedScene>(chapter, name, budget, by, substeps, honest);
    method.friction = true;
    return method;
}

}  // namespace rigid::stress
