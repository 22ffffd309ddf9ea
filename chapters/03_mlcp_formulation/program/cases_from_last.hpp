/// \file cases_from_last.hpp
/// The solver stage of the ten discs: cases, beginning with those of the last step. Which contacts are at work is seldom
/// news.
#pragma once

#include "chapters/03_mlcp_formulation/exact.hpp"
#include "chapters/03_mlcp_formulation/step.hpp"
#include "common/program/program.hpp"

#include <functional>
#include <string>
#include <vector>

namespace rigid {

struct CasesFromLast : PlainSolver {
    /// links are cases like contacts, instead of being solved apart (3.14c)
    bool links_too = false;
    MatrixSolver<std::function<void(const Mlcp&, Solution&)>> by_matrix;
    std::vector<Contact> last_contacts;
    std::vector<bool> last_pushed;  ///< of each of these: λ > 0

    /// \throws StepFailure  if no set of cases fits
    void solve(Bodies<2>& bodies, StepData<2>& now)
    {
        by_matrix.find = [&](const Mlcp& mlcp, Solution& solution) {
            EnumerationSettings settings;
            settings.stop_at_first = true;
            settings.most_sets = 2'000'000;
            settings.first = guess(mlcp, now);
            solution =
                links_too ? enumerate(mlcp, settings) : schur(mlcp, settings);
            if (solution.status != Status::solved)
                throw StepFailure(
                    "the " + std::to_string(now.contacts.size()) +
                    " contacts have no answer after " +
                    std::to_string(solution.iterations) +
                    " sets of cases: " + std::string(to_string(solution.status)));
        };
        by_matrix.solve(bodies, now);

        last_contacts = now.contacts;
        last_pushed.assign(now.contacts.size(), false);
        for (std::size_t i = 0; i < now.sources.size(); ++i)
            if (now.sources[i].of == Source::Of::contact)
                last_pushed[static_cast<std::size_t>(now.sources[i].index)] =
                    now.solution.lambda[static_cast<Index>(i)] > 0;
    }

private:
    /// For a contact that was there in the last step what it was then; for a new one what q says.
    std::vector<BoundState> guess(const Mlcp& mlcp, const StepData<2>& now) const
    {
        std::vector<BoundState> first;
        for (Index i = 0; i < mlcp.size(); ++i) {
            bool works = mlcp.q[i] < 0;
            const Source source = now.sources[static_cast<std::size_t>(i)];
            for (std::size_t old = 0;
                 source.of == Source::Of::contact && old < last_contacts.size();
                 ++old)
                if (is_same(now.contacts[static_cast<std::size_t>(source.index)],
                            last_contacts[old]))
                    works = last_pushed[old];
            first.push_back(works ? BoundState::between : BoundState::at_lo);
        }
        return first;
    }

    static bool is_same(const Contact& one, const Contact& other)
    {
        return one.a == other.a && one.b == other.b &&
               (one.a != world || one.normal == other.normal);
    }
};

/// The method of this chapter with that solver.
struct CasesFromLastMethod {
    AllPairs contacts;
    WholeError correction;
    ColdStart start;
    CasesFromLast solver;
};

}  // namespace rigid
