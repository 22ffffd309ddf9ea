// The functions of units.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/05_lemke/units.hpp"

namespace rigid {

//! [units]
VecX row_units(const MatX& A)
{
    const Index n = A.rows();
    const Real most = n > 0 ? std::max(A.diagonal().maxCoeff(), Real{0}) : 0;
    const Real eta =
        most > 0 ? std::ldexp(1, static_cast<int>(std::floor(log2(most) / 2))) : 1;
    VecX unit = VecX::Constant(n, eta);
    for (Index i = 0; i < n; ++i) {
        if (A(i, i) > 0) continue;
        Real beside = 0, any = 0;
        for (Index j = 0; j < n; ++j) {
            const Real entry = std::max(std::abs(A(i, j)), std::abs(A(j, i)));
            if (A(j, j) > 0) beside = std::max(beside, entry);
            any = std::max(any, entry);
        }
        if (beside > 0) unit[i] = beside / most * eta;
        else if (any > 0) unit[i] = std::sqrt(any);
    }
    return unit;
}
//! [units]

}  // namespace rigid
