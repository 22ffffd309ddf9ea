/// \file bounded_rows.hpp
/// Rows with bounds above joints that are solved at once: the joints are eliminated, and what is left is a small Coulomb
/// problem, solved exactly.
///
///     w = A λ + q,   A = J_B M_J⁻¹ J_Bᵀ + Γ_B,   q = J_B û + b,   M_J⁻¹ = M⁻¹ − M⁻¹Jᵀ (J M⁻¹Jᵀ + Γ)⁻¹ J M⁻¹
///
/// (14.16). J_B are the rows with bounds, M_J⁻¹ is the inverse mass of the bodies as their joints hold them, û what the
/// joints alone make of u*. A column of A is one impulse and one solve of the tree; what is at a bound, chapter 13 finds.
#pragma once

#include "chapters/13_friction/friction_solver.hpp"
#include "chapters/14_joints/bounded_islands.hpp"

namespace rigid {

class BoundedRows {
public:
    BoundedIslands islands;
    int columns = 0;           ///< of A, computed in the last eliminate()
    int unsolved = 0;          ///< islands without an answer, of the last solve()
    int guesses = 0;           ///< of all islands, in the last solve()
    int swept = 0;             ///< islands that were too large for guesses
    std::int64_t entries = 0;  ///< that guesses looked at

    /// A of an island.
    const SparseMatrix& matrix(int island) const
    {
        return problems_[at(island)].mlcp.A;
    }

    /// The next guesses begin from λ alone: cases and factors of earlier solves are
    /// nothing to them.
    void forget()
    {
        for (Problem& problem : problems_) problem.find.memory.forget();
    }

    //! [eliminate]
    /// A of each island.
    void eliminate(JointFactor& joints, const std::vector<Row<3>>& rows,
                   const std::vector<char>& left_out, Index bodies)
    {
        islands.list(rows, joints.assemblies, left_out);
        if (problems_.size() < static_cast<std::size_t>(islands.count))
            problems_.resize(static_cast<std::size_t>(islands.count));
        if (u_.size() != 3 * bodies) u_.setZero(3 * bodies);
        columns = 0;
        for (int k = 0; k < islands.count; ++k)
            eliminate(k, joints, rows, problems_[at(k)].mlcp);
    }
    //! [eliminate]

    //! [solve]
    /// λ of the rows with bounds.
    /// \param u       û, what the joints alone make of u* [m/s]
    /// \param b       of all rows
    /// \param lambda  in: where the guesses begin; out: the answer, where there is
    ///                one, else the best that was found
    /// \param most    rows that an island may have to be guessed
    /// \param sweeps  over those of a larger one
    /// \param enough  a residual below this is none [m/s]
    void solve(const std::vector<Row<3>>& rows, const VecX& u, const VecX& b,
               const FrictionSettings& settings, int most, int sweeps, Real enough,
               VecX& lambda)
    {
        entries = unsolved = guesses = swept = 0;
        for (int k = 0; k < islands.count; ++k) {
            Problem& problem = problems_[at(k)];
            const std::vector<int>& here = islands.rows[at(k)];
            const auto m = static_cast<Index>(here.size());
            Mlcp& mlcp = problem.mlcp;
            mlcp.q.resize(m), mlcp.lo.resize(m), mlcp.hi.resize(m);
            Solution& solution = problem.solution;
            solution.lambda.resize(m);
            problem.boxes.clear();
            for (Index i = 0; i < m; ++i) {
                const int number = here[at(i)];
                mlcp.q[i] = speed_along(rows[at(number)], u) + b[number];
                bound(rows, i, number, enough, problem);
                solution.lambda[i] = lambda[number];
            }
            if (!is_finite(mlcp)) {  // an overflow has no answer
                solution.lambda.setZero();
                solution.status = Status::singular;
            } else if (m > most) sweep(problem, settings, sweeps, enough);
            else {
                problem.find.settings = settings;
                problem.find(mlcp, problem.boxes, enough, solution);
                guesses += solution.iterations;
                entries += problem.find.memory.work.entries;
            }
            swept += m > most;
            unsolved += solution.status != Status::solved;
            slide_held(rows, here, enough, problem);
            for (Index i = 0; i < m; ++i) lambda[here[at(i)]] = solution.lambda[i];
        }
    }
    //! [solve]

private:
    struct Problem {
        Mlcp mlcp;
        std::vector<FrictionBox> boxes;
        FindFriction find;
        Solution solution;
    };

    //! [sweep]
    /// Sweeps over A, each row by what the joints leave of its impulse.
    static void sweep(Problem& problem, const FrictionSettings& settings,
                      int sweeps, Real enough)
    {
        FrictionMemory& memory = problem.find.memory;
        Solution& solution = problem.solution;
        memory.problem.mlcp = &problem.mlcp;
        memory.problem.boxes = problem.boxes;
        std::vector<int>& box_of = memory.guess.box_of;
        box_of.assign(at(problem.mlcp.size()), -1);
        for (std::size_t i = 0; i < problem.boxes.size(); ++i)
            box_of[at(problem.boxes[i].row)] = static_cast<int>(i);
        memory.guess.lambda = solution.lambda;
        sweep_changes(memory.problem, sweeps, enough / 10, memory.guess);
        memory.candidate = memory.guess.lambda;
        solution.status = Status::iteration_limit;
        solution.residual = infinity;
        accept_coulomb(problem.mlcp, problem.boxes, {settings.tolerance, enough},
                       memory.candidate, solution);
    }
    //! [sweep]

    static bool is_finite(const Mlcp& mlcp)
    {
        const Eigen::Map<const VecX> values(mlcp.A.valuePtr(), mlcp.A.nonZeros());
        return mlcp.q.allFinite() && values.allFinite();
    }

    template <class Number>
    static std::size_t at(Number i)
    {
        return static_cast<std::size_t>(i);
    }

    //! [column]
    void eliminate(int k, JointFactor& joints, const std::vector<Row<3>>& rows,
                   Mlcp& mlcp)
    {
        const std::vector<int>& here = islands.rows[at(k)];
        const auto m = static_cast<int>(here.size());
        mlcp.A.resize(m, m);
        int* const begin = mlcp.A.outerIndexPtr();
        for (int j = 0; j < m; ++j)
            islands.for_each_from(
                here[at(j)], islands.places_of(rows[at(here[at(j)])]), [&](int i) {
                    ++begin[j + 1];
                    if (i != here[at(j)]) ++begin[islands.number[at(i)] + 1];
                });
        for (int j = 0; j < m; ++j) begin[j + 1] += begin[j];
        mlcp.A.resizeNonZeros(begin[m]);
        next_.assign(begin, begin + m);
        const auto append = [&](int line, int column, Real value) {
            const int place = next_[at(line)]++;
            mlcp.A.innerIndexPtr()[place] = column;
            mlcp.A.valuePtr()[place] = value;
        };
        for (int j = 0; j < m; ++j) {
            const Row<3>& row = rows[at(here[at(j)])];
            const auto places = islands.places_of(row);
            // one unit of λ, and what the joints leave of it
            row.apply(1, u_);
            for (const int place : {places.first, places.second})
                if (place >= 0 && islands.assembly_at(place) >= 0)
                    joints.hold(rows, islands.assembly_at(place), u_);
            ++columns;
            // joints hold the row whatever it does: rounding is no mobility
            const bool held = !(speed_along(row, u_) >
                                rank_tolerance * row.inverse_effective_mass());
            islands.for_each_from(here[at(j)], places, [&](int i) {
                const Real value = held ? 0 : speed_along(rows[at(i)], u_);
                const int line = islands.number[at(i)];
                append(j, line, value + (line == j ? row.softness : 0));
                if (line != j) append(line, j, value);
            });
            for (const int place : {places.first, places.second})
                if (place >= 0) clear(place, joints);
        }
    }
    //! [column]

    void clear(int place, const JointFactor& joints)
    {
        const int assembly = islands.assembly_at(place);
        if (assembly < 0) u_.segment<3>(3 * islands.body_at(place)).setZero();
        else
            for (const int n : joints.assemblies.nodes_of(assembly))
                u_.segment<3>(joints.place(n)).setZero();
    }

    /// The bounds of a row. One that nothing moves is at the bound to which its w points.
    void bound(const std::vector<Row<3>>& rows, Index i, int number, Real enough,
               Problem& problem) const
    {
        const Row<3>& row = rows[at(number)];
        Mlcp& mlcp = problem.mlcp;
        Real &lo = mlcp.lo[i], &hi = mlcp.hi[i];
        lo = row.lo, hi = row.hi;
        if (row.bounded_by >= 0) {
            const int normal = islands.number[at(row.bounded_by)];
            lo = hi = 0;
            if (normal >= 0 && mlcp.A.coeff(i, i) > 0)
                problem.boxes.push_back({i, normal, row.friction});
            return;
        }
        if (mlcp.A.coeff(i, i) > 0) return;
        const Real w = mlcp.q[i];
        const Real there = w > enough    ? lo
                           : w < -enough ? hi
                                         : std::clamp(Real{0}, lo, hi);
        lo = hi = std::isfinite(there) ? there : 0;
    }

    /// Friction that moves nothing still slides where its w says so.
    void slide_held(const std::vector<Row<3>>& rows, const std::vector<int>& here,
                    Real enough, Problem& problem) const
    {
        for (Index i = 0; i < problem.mlcp.size(); ++i) {
            const Row<3>& row = rows[at(here[at(i)])];
            if (row.bounded_by < 0 || problem.mlcp.A.coeff(i, i) > 0) continue;
            const int normal = islands.number[at(row.bounded_by)];
            const Real w = problem.mlcp.q[i];
            if (normal < 0 || !(std::abs(w) > enough)) continue;
            const Real most =
                row.friction * std::max(Real{0}, problem.solution.lambda[normal]);
            problem.solution.lambda[i] = w > 0 ? -most : most;
        }
    }

    std::vector<Problem> problems_;
    std::vector<int> next_;
    VecX u_;  ///< zero between calls

    /// part of J M⁻¹ Jᵀ that joints must leave of a row, or it is held
    static constexpr Real rank_tolerance = 1e-11;
};

}  // namespace rigid
