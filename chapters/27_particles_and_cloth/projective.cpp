// The functions of projective.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/27_particles_and_cloth/projective.hpp"

#include <Eigen/SparseCholesky>

#include <algorithm>

namespace rigid {

void Projective::prepare(const ClothScene& cloth, Real h)
{
    if (!cloth.hinges.empty())
        throw std::invalid_argument(
            "there are " + std::to_string(cloth.hinges.size()) +
            " hinges; projective dynamics takes bends, whose energy is "
            "quadratic, and no angles");
    std::vector<int> number(static_cast<std::size_t>(cloth.count()), -1), free;
    for (int k = 0; k < cloth.count(); ++k)
        if (cloth.bodies.inverse_mass[3 * k] > 0) {
            number[static_cast<std::size_t>(k)] = static_cast<int>(free.size());
            free.push_back(k);
        }
    std::vector<Eigen::Triplet<Real>> entries;
    for (const int k : free) {
        const int p = number[static_cast<std::size_t>(k)];
        entries.emplace_back(p, p, 1 / (h * h * cloth.bodies.inverse_mass[3 * k]));
    }
    const auto add = [&](int a, int b, Real value) {
        const int p = number[static_cast<std::size_t>(a)],
                  q = number[static_cast<std::size_t>(b)];
        if (p >= 0 && q >= 0) entries.emplace_back(p, q, value);
    };
    for (std::size_t i = 0; i < cloth.springs.size(); ++i) {
        const ClothSpring& s = cloth.springs[i];
        add(s.a, s.a, s.stiffness), add(s.b, s.b, s.stiffness);
        add(s.a, s.b, -s.stiffness), add(s.b, s.a, -s.stiffness);
    }
    for (const ClothBend& b : cloth.bends)
        for (std::size_t i = 0; i < 4 && b.p[i] >= 0; ++i)
            for (std::size_t j = 0; j < 4 && b.p[j] >= 0; ++j)
                add(b.p[i], b.p[j], b.stiffness * b.w[i] * b.w[j]);
    const auto n = static_cast<Index>(free.size());
    Eigen::SparseMatrix<Real> P(n, n);
    P.setFromTriplets(entries.begin(), entries.end());
    const Eigen::SimplicialLDLT<Eigen::SparseMatrix<Real>> ldlt(P);
    factor_ = ldlt.matrixL().nestedExpression(), pivot_ = ldlt.vectorD();
    order_.resize(free.size()), right_.resize(free.size());
    for (std::size_t p = 0; p < free.size();
         ++p)  // line of the factor, where a permutation is
        order_[ldlt.permutationP().size() > 0
                   ? static_cast<std::size_t>(
                         ldlt.permutationP().indices()[static_cast<Index>(p)])
                   : p] = free[p];
}

//! [pass]
void Projective::pass(const ClothScene& cloth, const VecX& y, Real h, VecX& x)
{
    force_.setZero(x.size());
    add_row_forces(cloth, x, force_);  // −Σ k wᵀ(w x − p): local
    residual = 0;
    for (std::size_t i = 0; i < order_.size(); ++i) {
        const Index k = 3 * order_[i];
        const Real w = cloth.bodies.inverse_mass[k];
        right_[i] = force_.segment<3>(k) -
                    (x.segment<3>(k) - y.segment<3>(k)) / (h * h * w);
        residual = std::max(residual, h * h * w * right_[i].norm());
    }
    const auto* const first = factor_.outerIndexPtr();
    const auto* const line = factor_.innerIndexPtr();
    const Real* const value = factor_.valuePtr();
    const auto n = static_cast<Index>(order_.size());
    const auto at = [this](Index i) -> Vec3& {
        return right_[static_cast<std::size_t>(i)];
    };
    for (Index j = 0; j < n; ++j)
        for (auto e = first[j]; e < first[j + 1]; ++e)
            at(line[e]) -= value[e] * at(j);
    for (Index j = n; j-- > 0;) {
        at(j) /= pivot_[j];
        for (auto e = first[j]; e < first[j + 1]; ++e)
            at(j) -= value[e] * at(line[e]);
    }
    for (Index j = 0; j < n; ++j)
        x.segment<3>(3 * order_[static_cast<std::size_t>(j)]) += at(j);
}
//! [pass]

}  // namespace rigid
