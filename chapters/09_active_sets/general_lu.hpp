/// \file general_lu.hpp
/// The active rows of an A that is not symmetric, by LU. For a P-matrix the guesses still end (9.7).
#pragma once

#include "chapters/09_active_sets/block_principal_pivoting.hpp"

#include <Eigen/LU>
#include <vector>

namespace rigid {

class GeneralLu {
public:
    void load(const Mlcp& mlcp)
    {
        A_ = mlcp.A;
        factored_.clear();
    }

    bool factor(const GuessedProblem& problem, const std::vector<BoundState>& cases,
                ActiveSetWork& work);

    void solve(VecX& x) const
    {
        if (active_.empty()) return;
        const VecX right = x(active_);
        const VecX answer = lu_.solve(right);
        x(active_) = answer;
    }

    void multiply(const Mlcp& mlcp, const VecX& x, VecX& product) const
    {
        product = mlcp.A * x;
    }

private:
    MatX A_;
    std::vector<Index> active_;
    std::vector<BoundState> factored_;
    Eigen::PartialPivLU<MatX> lu_;
};

}  // namespace rigid
