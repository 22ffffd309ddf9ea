/// \file wide_method.hpp
/// The method of this chapter: chapter 13's sweeps with one stage replaced, the solver.
#pragma once

#include "chapters/14_joints/joint_method.hpp"
#include "chapters/16_wide_sweeps/wide_solver.hpp"

namespace rigid {

//! [method]
/// \tparam T, L  numbers of what kind, and how many side by side
template <class Contacts, class T = Real, int L = full_lanes<T>>
struct WideSweeps {
    WithJoints<WithFriction<Contacts>> contacts;
    Correction correction = steady_contacts();
    WarmStart start;
    WideSolver<3, T, L> solver;
};
//! [method]

}  // namespace rigid
