// The functions of pgs.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/04_pgs/pgs.hpp"

namespace rigid {

bool has_hopeless_row(const Mlcp& mlcp, const SweepRows& sweep, Real tolerance)
{
    // by the entries as they were given: scaled ones may vanish
    const auto moves_it = [&mlcp](Index i) {
        for (SparseMatrix::InnerIterator entry(mlcp.A, i); entry; ++entry)
            if (entry.value() < 0 || entry.value() > 0) return true;
        return false;
    };
    for (std::size_t k = 0; k < sweep.rows.size(); ++k) {
        const SweepRow& row = sweep.rows[k];
        if (is_empty(sweep, k) && row.lo < row.hi &&
            std::abs(mlcp.q[sweep.row_at[k]]) > tolerance &&
            !moves_it(sweep.row_at[k]))
            return true;
    }
    return false;
}

void require_valid(const PgsSettings& settings)
{
    require_tolerance("the sweeps", settings.tolerance);
    if (settings.max_sweeps < 0)
        throw std::invalid_argument("the number of sweeps is " +
                                    std::to_string(settings.max_sweeps) +
                                    "; it must be zero or positive");
}

}  // namespace rigid
