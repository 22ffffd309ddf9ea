// The functions of general_lu.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/09_active_sets/general_lu.hpp"

namespace rigid {

bool GeneralLu::factor(const GuessedProblem& problem,
                       const std::vector<BoundState>& cases, ActiveSetWork& work)
{
    if (factored_ == cases) return true;
    ++work.factorisations;
    active_.clear();
    for (std::size_t i = 0; i < cases.size(); ++i)
        if (cases[i] == BoundState::between)
            active_.push_back(static_cast<Index>(i));
    work.entries = static_cast<Index>(active_.size() * active_.size());
    factored_ = cases;
    if (active_.empty()) return true;
    lu_.compute(A_(active_, active_));
    const VecX pivots = lu_.matrixLU().diagonal().cwiseAbs();
    for (Index k = 0; k < pivots.size(); ++k)
        if (!(pivots[k] >
              1e-13 * problem.diagonal[active_[static_cast<std::size_t>(k)]])) {
            factored_.clear();
            return false;
        }
    return true;
}

}  // namespace rigid
