// The functions of mlcp.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/03_mlcp_formulation/mlcp.hpp"

namespace rigid {

void require_valid(const Mlcp& mlcp)
{
    const Index n = mlcp.size();
    const auto refuse = [](const std::string& sentence) {
        throw std::invalid_argument(sentence);
    };
    if (mlcp.A.rows() != n || mlcp.A.cols() != n)
        refuse("A is " + std::to_string(mlcp.A.rows()) + " x " +
               std::to_string(mlcp.A.cols()) + "; q has " + std::to_string(n) +
               " entries");
    if (mlcp.lo.size() != n || mlcp.hi.size() != n)
        refuse("lo has " + std::to_string(mlcp.lo.size()) + " and hi " +
               std::to_string(mlcp.hi.size()) + " entries; q has " +
               std::to_string(n));
    for (Index i = 0; i < n; ++i) {
        for (SparseMatrix::InnerIterator entry(mlcp.A, i); entry; ++entry)
            if (!std::isfinite(entry.value()))
                refuse("A[" + std::to_string(i) + "," +
                       std::to_string(entry.col()) + "] is " +
                       shortest(entry.value()) + "; it must be finite");
        if (!std::isfinite(mlcp.q[i]))
            refuse("q[" + std::to_string(i) + "] is " + shortest(mlcp.q[i]) +
                   "; it must be finite");
        if (!(mlcp.lo[i] <= mlcp.hi[i]))
            refuse("row " + std::to_string(i) + " has lo = " +
                   shortest(mlcp.lo[i]) + " > hi = " + shortest(mlcp.hi[i]));
        if (mlcp.lo[i] == infinity || mlcp.hi[i] == -infinity)
            refuse(
                "row " + std::to_string(i) + " has lo = " + shortest(mlcp.lo[i]) +
                " and hi = " + shortest(mlcp.hi[i]) + "; no impulse is that large");
    }
}

}  // namespace rigid
