/// \file quiet_sweeps.hpp
/// The methods of the library that the small programs are held to, stopped as those stop.
#pragma once

#include "chapters/06_sequential_impulse/impulse_solver.hpp"
#include "chapters/07_baumgarte/correction.hpp"
#include "chapters/08_warm_starting/warm_start.hpp"

namespace rigid {

/// The sweeps of the library, as often as the small programs sweep: until no row is off by more than 1e-6 m/s.
template <int Dof>
struct QuietSweeps : ImpulseSolver<Dof> {
    int most = 100000;
    int made = 0;  ///< in the last step

    void solve(Bodies<Dof>& bodies, StepData<Dof>& now)
    {
        bodies.u = now.u_star;
        prepare<Dof>(now.rows, {}, now.solution.lambda, this->memory.rows);
        for (std::size_t i = 0; i < now.rows.size(); ++i)
            now.rows[i].apply(now.solution.lambda[static_cast<Index>(i)], bodies.u);
        int off = 1;
        for (made = 0; off > 0 && made < most; ++made) off = sweep<Dof>(this->memory.rows, bodies.u, 1e-6);
        for (std::size_t i = 0; i < now.rows.size(); ++i)
            now.solution.lambda[static_cast<Index>(i)] = this->memory.rows[i].lambda;
    }
};

template <int Dof, class Contacts, class Correction, class Start>
struct QuietMethod {
    Contacts contacts;
    Correction correction;
    Start start;
    QuietSweeps<Dof> solver;
    StepData<Dof> now;

    template <class Scene>
    int operator()(Scene& scene, Real h = 1.0 / 240)
    {
        step(scene, {.h = h}, *this, now);
        return solver.made;
    }
};

}  // namespace rigid
