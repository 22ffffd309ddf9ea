/// \file bounded_rows.hpp
/// Rows with bounds above joints that are solved at once: the joints are eliminated, and what is left is a small Coulomb
/// problem, solved exactly.
///
///     w = A λ + q,   A = J_B M_J⁻¹ J_Bᵀ + Γ_B,   q = J_B û + b,   M_J⁻¹ = M⁻¹ − M⁻¹Jᵀ (J M⁻¹Jᵀ + Γ)⁻¹ J M⁻¹
///
/// (14.16). J_B are the rows with bounds, M_J⁻¹ is the inverse mass of the bodies as their joints hold them, û what the
/// joints alone make of u*. A column of A is one impulse and one solve of the tree; what is at a bound, chapter 13 finds.
#pragma once

#include "chapters/14_joints/bounded_problem.hpp"

#include <deque>

namespace rigid {

class BoundedRows {
public:
    BoundedIslands islands;
    int columns = 0;           ///< of A, computed in the last eliminate()
    int unsolved = 0;          ///< islands without an answer, of the last solve()
    int guesses = 0;           ///< of all islands, in the last solve()
    int swept = 0;             ///< islands that were too large for guesses
    int sweeps_made = 0;       ///< over the one that needed most of them
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
        for (std::size_t k = 0; k < used_; ++k) problems_[k].find.memory.forget();
        used_ = 0;
    }

    //! [eliminate]
    /// A of each island.
    void eliminate(JointFactor& joints, const std::vector<Row<3>>& rows,
                   const std::vector<char>& left_out, Index bodies)
    {
        islands.list(rows, joints.assemblies, left_out);
        if (problems_.size() < static_cast<std::size_t>(islands.count))
            problems_.resize(static_cast<std::size_t>(islands.count));
        used_ = std::max(used_, static_cast<std::size_t>(islands.count));
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
        entries = unsolved = guesses = swept = sweeps_made = 0;
        for (int k = 0; k < islands.count; ++k) {
            BoundedProblem& problem = problems_[at(k)];
            const std::vector<int>& here = islands.rows[at(k)];
            problem.begin(islands, here, rows, u, b, enough, lambda);
            Solution& solution = problem.solution;
            // an overflow has no answer
            if (!problem.is_finite() || !(enough < infinity)) {
                solution.lambda.setZero();
                solution.status = Status::singular;
            } else if (problem.mlcp.size() > most) {
                const int made = problem.sweep(settings, sweeps, enough);
                sweeps_made = std::max(sweeps_made, made);
                ++swept;
            } else {
                problem.find.settings = settings;
                problem.find(problem.mlcp, problem.boxes, enough, solution);
                guesses += solution.iterations;
                entries += problem.find.memory.work.entries;
            }
            unsolved += solution.status != Status::solved;
            problem.slide_held(islands, here, rows, enough);
            for (std::size_t i = 0; i < here.size(); ++i)
                lambda[here[i]] = solution.lambda[static_cast<Index>(i)];
        }
    }
    //! [solve]

private:
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

    std::deque<BoundedProblem> problems_;  ///< grows without copying their memory
    std::size_t used_ =
        0;  ///< of these, since forget(): what sleeps has had others
    std::vector<int> next_;
    VecX u_;  ///< zero between calls

    /// part of J M⁻¹ Jᵀ that joints must leave of a row, or it is held
    static constexpr Real rank_tolerance = 1e-11;
};

}  // namespace rigid
