/// \file joint_sweeps.hpp
/// Sweeps that visit the rows of a joint together: block Gauss-Seidel.
///
///     Δλ = −K⁻¹ (J u + b),   K = J M⁻¹ Jᵀ       2×2 for a pin, 3×3 for a weld;   u ← u + M⁻¹ Jᵀ Δλ
///
/// (14.6). Rows that have a bound or are soft are visited one by one, as in chapter 6.
#pragma once

#include "chapters/06_sequential_impulse/block.hpp"

namespace rigid {

/// Rows of one joint that follow each other, and the inverse of their K.
struct RowRun {
    int first = 0, count = 1;
    Eigen::Matrix<Real, 3, 3> inverse = Eigen::Matrix<Real, 3, 3>::Zero();
};

//! [runs]
/// The runs of rows in the order of the visits: up to three neighbours without
/// bounds between the same two bodies. A row that says nearly what those before it
/// say (a pivot below 10⁻⁸ of its K_ii) begins a run of its own.
/// \param feedback  of the rows; empty = none has any
inline void find_runs(const std::vector<SolverRow<3>>& rows,
                      std::span<const Feedback> feedback, std::vector<RowRun>& runs)
{
    runs.clear();
    const auto alone = [&](std::size_t k) {
        return rows[k].lo > -infinity || rows[k].hi < infinity ||
               !(rows[k].mass > 0) ||
               (!feedback.empty() &&
                (feedback[k].softness > 0 || feedback[k].bounding != 0));
    };
    Eigen::Matrix<Real, 3, 3> K, L;
    for (std::size_t k = 0; k < rows.size();) {
        RowRun run{static_cast<int>(k)};
        const auto row = [&](int i) -> const SolverRow<3>& {
            return rows[k + static_cast<std::size_t>(i)];
        };
        K(0, 0) = L(0, 0) = rows[k].mass > 0 ? 1 / rows[k].mass : 1;
        const bool may_grow = !alone(k);
        for (int d = 1; may_grow && d < 3; ++d, ++run.count) {
            if (k + static_cast<std::size_t>(d) >= rows.size() ||
                alone(k + static_cast<std::size_t>(d)) || row(d).a != row(0).a ||
                row(d).b != row(0).b)
                break;
            Real pivot = K(d, d) = 1 / row(d).mass;
            for (int j = 0; j < d; ++j) {
                L(d, j) = K(d, j) = K(j, d) = coupling(row(d), row(j));
                for (int i = 0; i < j; ++i) L(d, j) -= L(d, i) * L(j, i) / L(i, i);
                pivot -= L(d, j) * L(d, j) / L(j, j);
            }
            L(d, d) = pivot;
            if (!(pivot > 1e-8 * K(d, d))) break;
        }
        if (run.count == 2)
            run.inverse.topLeftCorner<2, 2>() =
                K.topLeftCorner<2, 2>().inverse().eval();
        if (run.count == 3) run.inverse = K.inverse().eval();
        k += static_cast<std::size_t>(run.count);
        runs.push_back(run);
    }
}
//! [runs]

//! [visit_run]
/// One visit of d rows, (14.6).
/// \return  how many of them were off by more than the tolerance [m/s]
template <int d>
int visit_run(SolverRow<3>* row, const RowRun& run, Real tolerance, VecX& u)
{
    const Index a = row->a, b = row->b;
    Vec<3> ua = u.segment<3>(a), ub = u.segment<3>(b);
    Vec<d> w;
    for (int i = 0; i < d; ++i) w[i] = velocity(row[i], ua, ub);
    const Vec<d> change = -(run.inverse.topLeftCorner<d, d>() * w);
    int off = 0;
    for (int i = 0; i < d; ++i) {
        row[i].lambda += change[i];
        ua += row[i].Wa * change[i];
        ub += row[i].Wb * change[i];
        off += !(std::abs(change[i]) <= tolerance * row[i].mass);
    }
    u.segment<3>(a) = ua;
    u.segment<3>(b) = ub;  // last: a row of the world has a = b
    return off;
}
//! [visit_run]

//! [joint_sweeps]
/// sequential_impulse() a joint at a time.
/// \param runs  memory
inline void joint_sweeps(const std::vector<Row<3>>& rows,
                         const ImpulseSettings& settings, ImpulseMemory<3>& memory,
                         std::vector<RowRun>& runs, VecX& u, Solution& solution)
{
    const bool hopeless =
        begin_sweeps<3>(rows, {}, settings.tolerance, memory, u, solution);
    find_runs(memory.rows, memory.feedback, runs);
    const std::span<SolverRow<3>> all(memory.rows);
    const std::span<const Feedback> feedback(memory.feedback);
    const auto one_sweep = [&](int) {
        int off = 0;
        for (const RowRun& run : runs) {
            const auto first = static_cast<std::size_t>(run.first);
            SolverRow<3>* const row = &all[first];
            if (run.count == 2)
                off += visit_run<2>(row, run, settings.tolerance, memory.u);
            else if (run.count == 3)
                off += visit_run<3>(row, run, settings.tolerance, memory.u);
            else if (feedback.empty())
                off += sweep(all.subspan(first, 1), memory.u, settings.tolerance);
            else {
                take_bounds(row, feedback[first]);
                off += sweep(all.subspan(first, 1), memory.u, settings.tolerance);
                give_way(row, feedback[first]);
            }
        }
        return off;
    };
    sweep_until(settings, hopeless, one_sweep, memory, solution);
    end_sweeps<3>({}, memory, u, solution);
}
//! [joint_sweeps]

}  // namespace rigid
