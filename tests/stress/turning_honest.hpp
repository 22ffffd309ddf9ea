/// \file turning_honest.hpp
/// Whether an answer to rows with friction that calls itself solved is one.
#pragma once

#include "chapters/13_friction/friction_solver.hpp"
#include "tests/stress/columns.hpp"

#include <cmath>

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
        answer = now.solution;
        if (now.besides.size() == answer.lambda.size()) take_rows_answer(now.besides);
        bound_by(boxes, answer.lambda, mlcp);
        require_honest(mlcp, answer);
    }

private:
    /// Arcs and impacts are besides the answer of the rows. What is left is at its bound where only the rounding of the sum
    /// that λ was lies between.
    void take_rows_answer(const VecX& besides)
    {
        const VecX sum = answer.lambda;
        answer.lambda -= besides;
        bound_by(boxes, answer.lambda, mlcp);
        for (Index i = 0; i < sum.size(); ++i) {
            const Real rounding = 4e-16 * (std::abs(sum[i]) + std::abs(besides[i]));
            for (const Real bound : {mlcp.lo[i], mlcp.hi[i]})
                if (std::abs(answer.lambda[i] - bound) <= rounding) answer.lambda[i] = bound;
        }
    }
};

}  // namespace rigid::stress
