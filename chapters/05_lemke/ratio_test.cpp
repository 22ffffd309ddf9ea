// The functions of ratio_test.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/05_lemke/ratio_test.hpp"

namespace rigid {

//! [lexicographic]
void break_tie(const Tableau& tableau, Index c, std::vector<Index>& tied)
{
    const Index n = tableau.n;
    const Real tie = tableau.tolerances.tie;
    const auto slope = tableau.column(c);
    Real scale = 0;
    std::vector<char> in(static_cast<std::size_t>(n), false);
    for (const Index i : tied) {
        scale = std::max(scale, 1 / -slope[i]);
        in[static_cast<std::size_t>(i)] = true;
    }
    std::size_t left = tied.size();
    for (Index k = 0; k < n && left > 1; ++k) {
        // in its own row 1, in all others 0: that row comes later
        if (tableau.is_basic(n + k)) {
            const Index i = tableau.row_of(n + k);
            if (!in[static_cast<std::size_t>(i)] || 1 / -slope[i] <= tie * scale)
                continue;
            in[static_cast<std::size_t>(i)] = false;
            --left;
            continue;
        }
        std::erase_if(tied,
                      [&](Index i) { return !in[static_cast<std::size_t>(i)]; });
        const auto w = tableau.column(tableau.column_of(n + k));
        Real least = infinity;
        for (const Index i : tied) {
            least = std::min(least, w[i] / slope[i]);
            scale = std::max(scale, std::abs(w[i] / slope[i]));
        }
        for (const Index i : tied)
            if (w[i] / slope[i] > least + tie * scale) {
                in[static_cast<std::size_t>(i)] = false;
                --left;
            }
    }
    std::erase_if(tied, [&](Index i) { return !in[static_cast<std::size_t>(i)]; });
}
//! [lexicographic]

}  // namespace rigid
