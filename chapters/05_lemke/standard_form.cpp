// The functions of standard_form.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/05_lemke/standard_form.hpp"

namespace rigid {

StandardForm::StandardForm(const Mlcp& mlcp) : mlcp_(mlcp)
{
    eliminated_ = has_symmetric_bilateral_block();
    if (eliminated_) {
        eliminate_bilateral(mlcp, schur_);
        eliminated_ = schur_.block.singular_row() < 0;
    }
    const Mlcp& rest = eliminated_ ? schur_.rest : mlcp;

    fixed_ = VecX::Zero(rest.size());
    std::vector<Index> boxed;  // which z have an upper bound
    box_.clear();
    for (Index i = 0; i < rest.size(); ++i) {
        const bool below = rest.lo[i] > -infinity, above = rest.hi[i] < infinity;
        first_.push_back(row_.size());
        if (below || above) fixed_[i] = below ? rest.lo[i] : rest.hi[i];
        if (rest.lo[i] == rest.hi[i]) continue;
        if (below && above) boxed.push_back(static_cast<Index>(row_.size()));
        if (below || !above) add(i, 1);
        if (!below) add(i, -1);
        if (below && above) box_.back() = static_cast<Index>(boxed.size()) - 1;
    }
    first_.push_back(row_.size());

    const auto m = static_cast<Index>(row_.size()),
               s = static_cast<Index>(boxed.size());
    const VecX w = rest.A * fixed_ + rest.q;  // where all z are zero
    q.resize(m + s);
    A = MatX::Zero(m + s, m + s);
    for (Index k = 0; k < m; ++k) {
        const Index row = row_[static_cast<std::size_t>(k)];
        const Real sign = sign_[static_cast<std::size_t>(k)];
        q[k] = sign * w[row];
        for (SparseMatrix::InnerIterator entry(rest.A, row); entry; ++entry)
            for (auto l = first_[static_cast<std::size_t>(entry.col())];
                 l < first_[static_cast<std::size_t>(entry.col()) + 1]; ++l)
                A(k, static_cast<Index>(l)) = sign * sign_[l] * entry.value();
    }
    unit_ = row_units(A.topLeftCorner(m, m));
    for (Index k = 0; k < m; ++k) {
        q[k] /= unit_[k];
        for (Index l = 0; l < m; ++l) A(k, l) /= unit_[k] * unit_[l];
    }
    //! [box]
    for (Index k = 0; k < s; ++k) {  // (5.17), in the units of the row itself
        const Index i = boxed[static_cast<std::size_t>(k)];
        const Index row = row_[static_cast<std::size_t>(i)];
        A(i, m + k) = 1;
        A(m + k, i) = -1;
        q[m + k] = unit_[i] * (rest.hi[row] - rest.lo[row]);
    }
    //! [box]
}

VecX StandardForm::impulses(const VecX& z) const
{
    VecX lambda = fixed_;
    for (std::size_t k = 0; k < row_.size(); ++k) {
        const auto l = static_cast<Index>(k);
        lambda[row_[k]] += sign_[k] * z[l] / unit_[l];
    }
    VecX whole = eliminated_ ? schur_.whole(mlcp_, lambda) : lambda;
    return whole.cwiseMax(mlcp_.lo).cwiseMin(mlcp_.hi);
}

//! [vertex]
VecX StandardForm::bounds_at(const Tableau& tableau,
                             std::vector<Index>& between) const
{
    VecX lambda = VecX::Zero(mlcp_.size());
    between = eliminated_ ? schur_.bilateral : std::vector<Index>{};
    for (Index i = 0; i < fixed_.size(); ++i) {
        const Index row =
            eliminated_ ? schur_.others[static_cast<std::size_t>(i)] : i;
        lambda[row] = fixed_[i];
        const auto first = first_[static_cast<std::size_t>(i)],
                   last = first_[static_cast<std::size_t>(i) + 1];
        for (auto k = first; k < last; ++k) {
            if (!tableau.is_basic(static_cast<Index>(k))) continue;
            const Index m = static_cast<Index>(row_.size()), box = box_[k];
            if (box >= 0 && !tableau.is_basic(tableau.n + m + box))
                lambda[row] = mlcp_.hi[row];
            else between.push_back(row);
            break;
        }
    }
    return lambda;
}
//! [vertex]

VecX StandardForm::direction(const VecX& y) const
{
    VecX v = VecX::Zero(fixed_.size());
    for (std::size_t k = 0; k < row_.size(); ++k) {
        const auto l = static_cast<Index>(k);
        v[row_[k]] += sign_[k] * y[l] / unit_[l];
    }
    if (!eliminated_) return v;
    VecX whole = VecX::Zero(mlcp_.size());
    for (std::size_t k = 0; k < schur_.others.size(); ++k)
        whole[schur_.others[k]] = v[static_cast<Index>(k)];
    const VecX image = mlcp_.A.transpose() * whole;
    const VecX bilateral = schur_.block.solve(-image(schur_.bilateral));
    for (std::size_t k = 0; k < schur_.bilateral.size(); ++k)
        whole[schur_.bilateral[k]] = bilateral[static_cast<Index>(k)];
    return whole;
}

bool StandardForm::has_symmetric_bilateral_block() const
{
    bool any = false;
    for (Index i = 0; i < mlcp_.size(); ++i) {
        if (!is_bilateral(mlcp_, i)) continue;
        any = true;
        for (SparseMatrix::InnerIterator entry(mlcp_.A, i); entry; ++entry) {
            const Real mirrored = mlcp_.A.coeff(entry.col(), i);
            if (is_bilateral(mlcp_, entry.col()) &&
                std::abs(entry.value() - mirrored) > 1e-14 * std::abs(mirrored))
                return false;
        }
    }
    return any;
}

}  // namespace rigid
