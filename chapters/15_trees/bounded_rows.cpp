// The functions of bounded_rows.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/15_trees/bounded_rows.hpp"

namespace rigid {

//! [eliminate]
void BoundedRows::eliminate(JointFactor& joints, const std::vector<Row<3>>& rows,
                            const std::vector<char>& left_out, Index bodies,
                            const BoundedRows* known)
{
    islands.list(rows, joints.assemblies, left_out);
    if (problems_.size() < static_cast<std::size_t>(islands.count))
        problems_.resize(static_cast<std::size_t>(islands.count));
    used_ = std::max(used_, static_cast<std::size_t>(islands.count));
    if (u_.size() != 3 * bodies) u_.setZero(3 * bodies);
    columns = 0;
    for (int k = 0; k < islands.count; ++k) {
        Mlcp& mlcp = problems_[at(k)].mlcp;
        if (known && known->has(islands.rows[at(k)])) take_part(*known, k, mlcp);
        else eliminate(k, joints, rows, mlcp);
    }
}
//! [eliminate]

//! [solve]
void BoundedRows::solve(const std::vector<Row<3>>& rows, const VecX& u,
                        const VecX& b, const FrictionSettings& settings, int most,
                        int sweeps, Real enough, VecX& lambda)
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

//! [column]
void BoundedRows::eliminate(int k, JointFactor& joints,
                            const std::vector<Row<3>>& rows, Mlcp& mlcp)
{
    const std::vector<int>& here = islands.rows[at(k)];
    const auto m = static_cast<int>(here.size());
    mlcp.A.resize(m, m);
    int* const begin = mlcp.A.outerIndexPtr();
    for (int j = 0; j < m; ++j)
        islands.for_each_from(here[at(j)], islands.places_of(rows[at(here[at(j)])]),
                              [&](int i) {
                                  ++begin[j + 1];
                                  if (i != here[at(j)])
                                      ++begin[islands.number[at(i)] + 1];
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
        const bool held =
            !(speed_along(row, u_) > rank_tolerance * row.inverse_effective_mass());
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

bool BoundedRows::has(const std::vector<int>& some) const
{
    return std::all_of(some.begin(), some.end(),
                       [&](int i) { return islands.number[at(i)] >= 0; });
}

//! [take_part]
/// A_ij is a matter of rows i and j and of the joints: with fewer rows it stays.
void BoundedRows::take_part(const BoundedRows& known, int k, Mlcp& mlcp) const
{
    const std::vector<int>& here = islands.rows[at(k)];
    const auto m = static_cast<int>(here.size());
    mlcp.A.resize(m, m);
    for (int j = 0; j < m; ++j) {
        const int row = here[at(j)], island = known.islands.of[at(row)];
        mlcp.A.startVec(j);
        for (SparseMatrix::InnerIterator it(known.matrix(island),
                                            known.islands.number[at(row)]);
             it; ++it) {
            const int other = known.islands.rows[at(island)][at(it.col())];
            const int column = islands.number[at(other)];
            if (column >= 0) mlcp.A.insertBack(j, column) = it.value();
        }
    }
    mlcp.A.finalize();
}
//! [take_part]

void BoundedRows::clear(int place, const JointFactor& joints)
{
    const int assembly = islands.assembly_at(place);
    if (assembly < 0) u_.segment<3>(3 * islands.body_at(place)).setZero();
    else
        for (const int n : joints.assemblies.nodes_of(assembly))
            u_.segment<3>(joints.place(n)).setZero();
}

}  // namespace rigid
