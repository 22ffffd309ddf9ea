// The functions of small_steps.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/08_warm_starting/small_steps.hpp"

namespace rigid {

SmallStepSettings careful_steps()
{
    SmallStepSettings settings;
    settings.substeps = 16;
    settings.first_sweeps = 10000;
    settings.first_tolerance = 1e-6;
    return settings;
}

//! [refresh]
Real refresh(const VecX& x, const VecX& inverse_mass, Real rest, SolverRow<2>& row)
{
    // a wall is flat: its normal stays
    if (row.a == row.b) return row.Jb.dot(x.segment<2>(row.b)) - rest;
    Vec2 n = x.segment<2>(row.b) - x.segment<2>(row.a);
    const Real distance = n.norm();
    n = direction_of(n, distance, {0, 1});
    row.Ja = -n.transpose();
    row.Jb = n.transpose();
    row.Wa = -inverse_mass[row.a] * n;
    row.Wb = inverse_mass[row.b] * n;
    return distance - rest;
}
//! [refresh]

void carry(std::size_t k, SmallStep& now)
{
    const SolverRow<2>& row = now.rows[k];
    now.change.segment<2>(row.a) += row.Wa * row.lambda;
    now.change.segment<2>(row.b) += row.Wb * row.lambda;
    Real& slope = now.starts[now.group_of_row[k]].slope;
    if (row.bias > 0) slope += row.bias * row.lambda;
    if (!now.driven) return;
    const auto of_driven = [&now](const RowVec<2>& J, int from) {
        return now.mass[from / 2] > 0 ? 0 : J.dot(now.u.segment<2>(from));
    };
    slope += row.lambda * (of_driven(row.Ja, row.a) + of_driven(row.Jb, row.b));
}

//! [start_rows]
void begin_substep(const Bodies<2>& bodies, Real h, SmallStep& now)
{
    const Real per_second = 1 / h;
    for (StartOfGroup& group : now.starts) group = {};
    for (std::size_t k = 0; k < now.rows.size(); ++k) {
        SolverRow<2>& row = now.rows[k];
        const Real C = refresh(bodies.x, bodies.inverse_mass, now.rest[k], row);
        row.bias = row.lo == 0 && C > 0 ? C * per_second : 0;
        carry(k, now);
    }
}

void take_multiples(const MultipleRule& rule, const Vec2& gain, SmallStep& now)
{
    for (const BodyRun& run : now.runs) {
        Vec2 slope = {0, 0}, curvature = {0, 0};
        for (Index k = run.begin; k < run.end; ++k) {
            auto u = now.u.segment<2>(2 * k);
            if (now.mass[k] > 0) u += gain;
            const Vec2 change = now.change.segment<2>(2 * k),
                       momentum = now.mass[k] * change;
            slope += momentum.cwiseProduct(u);
            curvature += momentum.cwiseProduct(change);
        }
        now.starts[run.group].slope += slope.sum();
        now.starts[run.group].curvature += curvature.sum();
    }
    for (StartOfGroup& group : now.starts)
        group.multiple = multiple_of(group.slope, group.curvature, rule);
    for (const BodyRun& run : now.runs) {
        const Real multiple = now.starts[run.group].multiple;
        for (Index k = 2 * run.begin; k < 2 * run.end; k += 2) {
            now.u.segment<2>(k) += multiple * now.change.segment<2>(k);
            now.change.segment<2>(k).setZero();
        }
    }
}
//! [start_rows]

int first_sweeps(const SmallStepSettings& settings, int sweeps, SmallStep& now)
{
    for (Real change = infinity; sweeps < settings.first_sweeps &&
                                 change > settings.first_tolerance * now.length;
         ++sweeps) {
        if (sweeps % 16 == 0) {
            for (StartOfGroup& group : now.starts) group = {};
            for (std::size_t k = 0; k < now.rows.size(); ++k) carry(k, now);
            now.u -= now.change;
            take_multiples({}, {0, 0}, now);
            for (std::size_t k = 0; k < now.rows.size(); ++k)
                now.rows[k].lambda *= now.starts[now.group_of_row[k]].multiple;
        }
        change = 0;
        for (SolverRow<2>& row : now.rows) {
            const Real A = row.Ja.dot(row.Wa) + row.Jb.dot(row.Wb);
            change = std::max(change, A * std::abs(visit(row, now.u)));
        }
    }
    return sweeps;
}

}  // namespace rigid
