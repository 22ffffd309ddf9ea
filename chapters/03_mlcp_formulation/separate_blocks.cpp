// The functions of separate_blocks.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/03_mlcp_formulation/separate_blocks.hpp"

namespace rigid {

std::vector<std::vector<int>> blocks_of(const Mlcp& mlcp)
{
    const auto m = static_cast<std::size_t>(mlcp.size());
    std::vector<int> above(m), number(m, -1);
    std::iota(above.begin(), above.end(), 0);
    for (int i = 0; i < static_cast<int>(m); ++i)
        for (SparseMatrix::InnerIterator entry(mlcp.A, i); entry; ++entry)
            if (entry.value() < 0 || entry.value() > 0)
                unite(above, i, static_cast<int>(entry.col()));
    std::vector<std::vector<int>> blocks;
    for (int i = 0; i < static_cast<int>(m); ++i) {
        int& of_block = number[static_cast<std::size_t>(lowest_of(above, i))];
        if (of_block < 0) {
            of_block = static_cast<int>(blocks.size());
            blocks.emplace_back();
        }
        blocks[static_cast<std::size_t>(of_block)].push_back(i);
    }
    return blocks;
}

Mlcp part_of(const Mlcp& mlcp, const std::vector<int>& rows)
{
    const auto n = static_cast<Index>(rows.size());
    Mlcp part{SparseMatrix(n, n), VecX(n), VecX(n), VecX(n)};
    std::vector<Eigen::Triplet<Real>> entries;
    for (Index k = 0; k < n; ++k) {
        const int i = rows[static_cast<std::size_t>(k)];
        part.q[k] = mlcp.q[i];
        part.lo[k] = mlcp.lo[i];
        part.hi[k] = mlcp.hi[i];
        for (SparseMatrix::InnerIterator entry(mlcp.A, i); entry; ++entry)
            if (const auto j = std::lower_bound(rows.begin(), rows.end(),
                                                static_cast<int>(entry.col()));
                j != rows.end() && *j == entry.col())
                entries.emplace_back(int(k), int(j - rows.begin()), entry.value());
    }
    part.A.setFromTriplets(entries.begin(), entries.end());
    return part;
}

}  // namespace rigid
