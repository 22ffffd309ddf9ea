// The functions of small_llt.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/09_active_sets/small_llt.hpp"

namespace rigid {

bool llt_in_place(MatX& L, Index f)
{
    if (f > small_llt) {
        Eigen::Ref<MatX> block = L.topLeftCorner(f, f);
        const Eigen::LLT<Eigen::Ref<MatX>> llt(block);
        return llt.info() == Eigen::Success;
    }
    for (Index c = 0; c < f; ++c) {
        for (Index j = 0; j < c; ++j) {
            const Real l = L(c, j);
            if (l == 0) continue;
            for (Index r = c; r < f; ++r) L(r, c) -= l * L(r, j);
        }
        if (!(L(c, c) > 0)) return false;
        L(c, c) = std::sqrt(L(c, c));
        const Real inverse = 1 / L(c, c);
        for (Index r = c + 1; r < f; ++r) L(r, c) *= inverse;
    }
    return true;
}

}  // namespace rigid
