// The functions of cases.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/03_mlcp_formulation/cases.hpp"

namespace rigid {

void require_all_rows(const std::vector<BoundState>& first, Index rows)
{
    if (!first.empty() && static_cast<Index>(first.size()) != rows)
        throw std::invalid_argument("the set to begin with names " +
                                    std::to_string(first.size()) +
                                    " rows; there are " + std::to_string(rows));
}

CaseSets::CaseSets(const Mlcp& mlcp, const std::vector<BoundState>& first)
{
    require_all_rows(first, mlcp.size());
    for (Index i = 0; i < mlcp.size(); ++i) {
        const bool room = mlcp.lo[i] < mlcp.hi[i];
        std::vector<BoundState>& cases = cases_.emplace_back();
        if (room) cases.push_back(BoundState::between);
        if (std::isfinite(mlcp.lo[i])) cases.push_back(BoundState::at_lo);
        if (room && std::isfinite(mlcp.hi[i])) cases.push_back(BoundState::at_hi);
        count_ *= static_cast<Real>(cases.size());
        if (cases.size() > 1) choices_.push_back(static_cast<std::size_t>(i));
        BoundState guess = mlcp.q[i] < 0 ? BoundState::between : BoundState::at_lo;
        if (!first.empty()) guess = first[static_cast<std::size_t>(i)];
        const bool possible =
            std::find(cases.begin(), cases.end(), guess) != cases.end();
        set_.push_back(possible ? guess : cases.front());
    }
}

}  // namespace rigid
