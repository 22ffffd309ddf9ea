// The functions of active_sets.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/09_active_sets/active_sets.hpp"

namespace rigid {

ActiveSetMemory::ActiveSetMemory() = default;
ActiveSetMemory::ActiveSetMemory(const ActiveSetMemory&) = default;
ActiveSetMemory::ActiveSetMemory(ActiveSetMemory&&) noexcept = default;
ActiveSetMemory& ActiveSetMemory::operator=(const ActiveSetMemory&) = default;
ActiveSetMemory& ActiveSetMemory::operator=(ActiveSetMemory&&) noexcept = default;
ActiveSetMemory::~ActiveSetMemory() = default;

template bool settle(const Mlcp&, const ActiveSetSettings&, DenseLlt&,
                     ActiveSetMemory&, Solution&);
template bool settle(const Mlcp&, const ActiveSetSettings&, SparseLdlt&,
                     ActiveSetMemory&, Solution&);
template GuessEnd correct_guess(const GuessedProblem&, GeneralLu&, int, int, bool,
                                Guess&, ActiveSetWork&);

void walk(const Mlcp& mlcp, const ActiveSetSettings& settings,
          ActiveSetMemory& memory, Solution& solution)
{
    LemkeSettings lemke_settings;
    lemke_settings.tolerance = settings.tolerance;
    lemke_settings.enough = settings.enough;
    ++memory.work.walks;
    const Solution walked = lemke(mlcp, lemke_settings);
    if (walked.status != Status::solved && walked.status != Status::infeasible &&
        solution.residual <= walked.residual)
        return;  // the last guess is as good, and its status says what is wrong
    solution = walked;
    for (Index i = 0; i < mlcp.size(); ++i)
        memory.guess.cases[static_cast<std::size_t>(i)] =
            walked.lambda[i] <= mlcp.lo[i]   ? BoundState::at_lo
            : walked.lambda[i] >= mlcp.hi[i] ? BoundState::at_hi
                                             : BoundState::between;
}

void keep_lowest(const Mlcp& mlcp, const ActiveSetSettings& settings,
                 ActiveSetMemory& memory, Solution& solution)
{
    VecX &trial = memory.guess.trial, &w = memory.guess.way;
    const auto height = [&](const VecX& lambda) {
        w.noalias() = mlcp.A * lambda;
        return lambda.dot(0.5 * w + mlcp.q);
    };
    const Status status = solution.status;
    Real least = height(solution.lambda);
    for (const bool nothing : {false, true}) {
        if (nothing) trial.setZero(mlcp.size());
        else if (memory.guess.start.size() == mlcp.size())
            trial = memory.guess.start;
        else continue;
        clamp_into_bounds(mlcp, trial);
        const Real there = height(trial);
        if (!(there < least) && std::isfinite(least)) continue;
        least = there;
        verify_guess(mlcp, settings, trial, solution);
        if (solution.status == Status::solved) return;
        solution.status = status;
    }
}

}  // namespace rigid
