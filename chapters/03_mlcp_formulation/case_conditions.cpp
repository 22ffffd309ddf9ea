// The functions of case_conditions.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/03_mlcp_formulation/case_conditions.hpp"

namespace rigid {

bool is_spread(const DenseMlcp& dense)
{
    if (dense.q.size() == 0) return false;
    Real least = infinity, most = dense.q.cwiseAbs().maxCoeff();
    if (most > 0) least = most;
    for (const VecX* bounds : {&dense.lo, &dense.hi})
        for (const Real bound : *bounds)
            if (const Real size = std::abs(bound); size > 0 && size < infinity) {
                least = std::min(least, size);
                most = std::max(most, size);
            }
    return !(most <= 1e10 * least) || !(dense.A.cwiseAbs().maxCoeff() <= 1e10);
}

bool is_contradiction(const MatX& block, const VecX& right, Real numbers)
{
    const MatX null = Eigen::FullPivLU<MatX>(block.transpose())
                          .setThreshold(rank_tolerance)
                          .kernel();
    for (Index c = 0; c < null.cols(); ++c) {
        Real moved = 0;
        for (Index k = 0; k < block.cols(); ++k) {
            Real sum = 0, rest = 0;
            for (Index r = 0; r < block.rows(); ++r) {
                const Real product = null(r, c) * block(r, k);
                sum += product;
                rest += std::fma(null(r, c), block(r, k), -product);
            }
            moved += std::abs(sum + rest);
        }
        const Real left = std::abs(null.col(c).dot(right));
        if (left > 1e-10 * numbers && left > 1e11 * moved * numbers) return true;
    }
    return false;
}

Real least_bound(const DenseMlcp& dense)
{
    Real least = infinity;
    for (const VecX* bounds : {&dense.lo, &dense.hi})
        for (const Real bound : *bounds)
            if (std::abs(bound) > 0) least = std::min(least, std::abs(bound));
    return least < infinity ? least : 1;
}

//! [family]
void look_around(const DenseMlcp& dense, const std::vector<BoundState>& set,
                 const MatX& null, std::span<const Index> free, Real numbers,
                 Answers& answers)
{
    const VecX here = answers.last();
    const Index k = null.rows();
    MatX moves_w = MatX::Zero(dense.q.size(), null.cols());
    for (Index r = 0; r < k; ++r)
        moves_w += dense.A.col(free[static_cast<std::size_t>(r)]) * null.row(r);
    Real size = std::max(numbers, here.cwiseAbs().maxCoeff());
    // q = 0 and λ = 0: the answers are a cone
    if (!(size > 0)) size = least_bound(dense);
    const Real step = 1e-5 * size;
    const Family family(dense, set);
    const auto try_member = [&](const std::optional<VecX>& other) {
        if (other && !answers.accept(*other)) answers.doubt();
    };
    for (const Real side : {1.0, -1.0}) {
        for (Index r = 0; r < k && !answers.lambda_differs(); ++r) {
            if (!(null.row(r).cwiseAbs().maxCoeff() > 1e-9)) continue;
            const Index i = free[static_cast<std::size_t>(r)];
            try_member(family.member_with_lambda(i, here[i] + side * step));
            const Real bound = side > 0 ? dense.hi[i] : dense.lo[i];
            // there may be less room than a step
            const Real half = std::abs(bound - here[i]) / 2;
            if (half > 0 && half < step)
                try_member(family.member_with_lambda(i, here[i] + side * half));
        }
        for (Index i = 0; i < dense.q.size() && !answers.w_differs(); ++i)
            if (set[static_cast<std::size_t>(i)] != BoundState::between &&
                moves_w.row(i).cwiseAbs().maxCoeff() > 1e-9) {
                const Real w = dense.A.row(i).dot(here) + dense.q[i];
                try_member(family.member_with_w(i, w + side * step));
            }
    }
    if (family.unsure()) answers.doubt();
}
//! [family]

}  // namespace rigid
