/// \file turning_honest.hpp
/// Whether an answer to rows with friction that calls itself solved is one.
#pragma once

#include "chapters/13_friction/friction_solver.hpp"
#include "tests/stress/columns.hpp"

namespace rigid::stress {

/// The rows of the last sub-step with their answer, the bounds of friction set by it: one step of sixteen.
struct HonestTurning {
    bool lambda_is_of_these_rows = true;
    long steps = 0;
    AssemblyScratch scratch;
    Mlcp mlcp;
    Solution answer;
    std::vector<FrictionBox> boxes;

    template <class Solving>
    void operator()(const Solving&, const StepData<3>& now)
    {
        if (!lambda_is_of_these_rows || now.solution.status != Status::solved || steps++ % 16 != 0) return;
        assemble(now.rows, now.u_star, scratch, mlcp);
        boxes_of(now.rows, boxes);
        answer = now.solution;  // of the rows: arcs and impacts are besides
        if (now.besides.size() == answer.lambda.size()) answer.lambda -= now.besides;
        bound_by(boxes, answer.lambda, mlcp);
        require_honest(mlcp, answer);
    }
};

}  // namespace rigid::stress
