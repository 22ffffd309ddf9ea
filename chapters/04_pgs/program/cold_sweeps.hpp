/// \file cold_sweeps.hpp
/// Chapter 3's step with sweeps for a solver, as the scenes of this program run it: how the reader's settings become a
/// method, and what is measured.
#pragma once

#include "chapters/03_mlcp_formulation/program/columns.hpp"
#include "chapters/04_pgs/conjugate_gradients.hpp"
#include "chapters/04_pgs/pgs.hpp"
#include "chapters/04_pgs/rates.hpp"
#include "common/elementary.hpp"
#include "common/random.hpp"

#include <numeric>
#include <utility>
#include <vector>

namespace rigid {

/// The order of the visits: 0 as given, 1 reversed, 2 shuffled.
inline std::vector<int> row_order(Index count, int kind, std::uint64_t seed)
{
    if (kind == 0) return {};
    std::vector<int> order(static_cast<std::size_t>(count));
    std::iota(order.begin(), order.end(), 0);
    if (kind == 1) std::reverse(order.begin(), order.end());
    Random random(seed);
    for (std::size_t k = order.size(); kind == 2 && k-- > 1;)
        std::swap(order[k], order[static_cast<std::size_t>(
                                random.index(static_cast<Index>(k) + 1))]);
    return order;
}

/// A solver of the MLCP: sweeps of each kind, or conjugate gradients. Nothing is remembered from step to step but memory.
struct ColdSweeps {
    PgsSettings settings;
    PgsMemory memory;
    CgMemory conjugate_memory;
    bool conjugate = false;
    int order = 0;  ///< as row_order() counts
    std::uint64_t seed = 1;

    void operator()(const Mlcp& mlcp, Solution& solution)
    {
        // nothing is remembered from the last step
        cold_start(mlcp, solution.lambda);
        if (conjugate)
            conjugate_gradients(mlcp, settings.tolerance, settings.max_sweeps,
                                conjugate_memory, solution);
        else pgs(mlcp, tuned(mlcp), memory, solution);
    }

private:
    /// The settings for this problem: its order of visits, and for Jacobi the relaxation that keeps it from
    /// growing.
    const PgsSettings& tuned(const Mlcp& mlcp)
    {
        if (order == 0) settings.order.clear();
        else settings.order = row_order(mlcp.size(), order, seed);
        if (settings.sweeps == Sweeps::jacobi)
            settings.omega = std::min(1.0, 0.95 * safe_jacobi_omega(mlcp));
        return settings;
    }
};

/// What the reader has set for the sweeps.
inline void tune_sweeps(const Settings& settings, ColdSweeps& sweeps)
{
    sweeps.settings.tolerance = pow(10, -settings["digits"]);
    sweeps.settings.max_sweeps = static_cast<int>(settings["max_sweeps"]);
    sweeps.settings.omega = settings.method == "sor" ? settings["omega"] : 1;
    sweeps.settings.sweeps = settings.method == "jacobi" ? Sweeps::jacobi
                             : settings.method == "symmetric"
                                 ? Sweeps::symmetric
                                 : Sweeps::gauss_seidel;
    sweeps.conjugate = settings.method == "cg";
    sweeps.order = static_cast<int>(settings["order"]);
    sweeps.seed = settings.seed;
}

/// What is measured of scenes that are solved with a matrix.
/// \tparam Solve  ColdSweeps, or what has them to compare with
/// \param counted  the column of what the solver counts, and what it counts
template <class Solve>
std::vector<Measured<RunState<MatrixMethod<Solve>>>>
matrix_columns(const std::string& counted, const std::string& help)
{
    using State = RunState<MatrixMethod<Solve>>;
    const Measured<State> row_visits = {
        {"row_visits", "",
         "of sweeps: rows visited, those of computed residuals included"},
        [](const State& s) {
            const PgsMemory& memory = s.method.solver.find.memory;
            return static_cast<Real>(s.now.rows.size()) *
                   (s.now.solution.iterations + memory.checks);
        }};
    return {columns::iterations(counted, help),
            columns::residual(),
            row_visits,
            columns::rows(),
            columns::unsolved(),
            columns::link_error(),
            columns::penetration(),
            columns::kinetic(),
            columns::energy()};
}

}  // namespace rigid
