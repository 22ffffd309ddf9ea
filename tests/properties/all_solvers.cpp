#include "tests/properties/all_solvers.hpp"

#include "chapters/03_mlcp_formulation/exact.hpp"
#include "chapters/04_pgs/conjugate_gradients.hpp"
#include "chapters/04_pgs/pgs.hpp"
#include "chapters/05_lemke/lemke.hpp"
#include "chapters/09_active_sets/dantzig.hpp"

#include <functional>

namespace rigid::properties {

struct AllSolvers::Memory {
    ActiveSetMemory active_sets, dantzig;
    PgsMemory pgs;
};

AllSolvers::AllSolvers() : memory_(std::make_unique<Memory>()) {}
AllSolvers::~AllSolvers() = default;

std::vector<Answer> AllSolvers::solve(const Mlcp& mlcp)
{
    std::vector<Answer> answers;
    const auto ask = [&](const std::string& solver, const std::function<Solution()>& solve, Real enough = 0) {
        try {
            answers.push_back({solver, solve(), enough});
        } catch (const std::invalid_argument&) {
        }
    };
    const Index n = mlcp.size();
    // Sweeps and conjugate gradients take a tolerance in m/s: a share of q, as the others' is.
    const Real tolerance = n > 0 ? 1e-9 * mlcp.q.lpNorm<Eigen::Infinity>() : 0;
    const auto swept = [&](Sweeps sweeps) {
        PgsSettings settings;
        settings.sweeps = sweeps;
        settings.tolerance = tolerance;
        settings.max_sweeps = 300;
        Solution solution;
        cold_start(mlcp, solution.lambda);
        pgs(mlcp, settings, memory_->pgs, solution);
        return solution;
    };
    const auto walked = [&](TieRule ties) {
        LemkeSettings settings;
        settings.ties = ties;
        settings.pivot_limit = 500;
        return lemke(mlcp, settings);
    };
    ask("direct", [&] { return direct(mlcp); });
    if (n <= 6) {
        ask("schur", [&] { return schur(mlcp); });
        ask("enumerate", [&] { return enumerate(mlcp); });
        EnumerationSettings first;
        first.stop_at_first = true;
        ask("enumerate to the first", [&] { return enumerate(mlcp, first); });
    }
    ask(
        "jacobi", [&] { return swept(Sweeps::jacobi); }, tolerance);
    ask(
        "gauss_seidel", [&] { return swept(Sweeps::gauss_seidel); }, tolerance);
    ask(
        "symmetric sweeps", [&] { return swept(Sweeps::symmetric); }, tolerance);
    ask(
        "cg", [&] { return conjugate_gradients(mlcp, tolerance, 100); }, tolerance);
    ask("lemke", [&] { return walked(TieRule::lexicographic); });
    ask("lemke by the last row", [&] { return walked(TieRule::last_row); });
    ask("active_sets", [&] { return active_sets(mlcp); });
    ask("active_sets alone", [&] {  // nothing is handed to Lemke's algorithm
        ActiveSetSettings settings;
        settings.limit = 200;
        return active_sets(mlcp, settings);
    });
    ask("active_sets warm", [&] {
        Solution solution;
        active_sets(mlcp, {}, memory_->active_sets, solution);
        return solution;
    });
    ask("dantzig", [&] {
        Solution solution;
        dantzig(mlcp, {}, memory_->dantzig, solution);
        return solution;
    });
    return answers;
}

}  // namespace rigid::properties
