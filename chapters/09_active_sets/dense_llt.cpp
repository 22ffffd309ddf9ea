// The functions of dense_llt.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/09_active_sets/dense_llt.hpp"

namespace rigid {

void DenseLlt::load(const Mlcp& mlcp)
{
    const Index n = mlcp.size();
    make_room(A_, n);
    A_.setZero();
    for (Index i = 0; i < n; ++i)
        for (SparseMatrix::InnerIterator entry(mlcp.A, i); entry; ++entry)
            A_(entry.col(), i) = entry.value();
    make_room(L_, n);
    place_.resize(static_cast<std::size_t>(n));
    x_.resize(n);
    forget();
}

bool DenseLlt::factor(const GuessedProblem& problem,
                      const std::vector<BoundState>& cases, ActiveSetWork& work)
{
    if (factored_ == cases) return true;
    if (!factored_.empty() && border(problem, cases)) ++work.updates;
    else {
        ++work.factorisations;
        factored_.clear();
        if (!factor_anew(problem, cases)) return false;
        work.entries = base() * (base() - 1) / 2;
    }
    factored_ = cases;
    return true;
}

void DenseLlt::solve(VecX& x) const
{
    const Index f = base(), k = size(changed_);
    auto z = x_.head(f);
    for (Index r = 0; r < f; ++r) z[r] = x[base_[index(r)]];
    lower_solve(L_, f, z);
    if (k == 0) upper_solve(L_, f, z);
    else {
        //! [bordered]
        VecX y(k);  // (9.11): S y = c − Yᵀ z, then Lᵀ x = z − Y y
        for (Index c = 0; c < k; ++c)
            y[c] = came_in(c) * x[changed_[index(c)]] -
                   Y_.col(column_[index(c)]).head(f).dot(z);
        y = S_.solve(y);
        for (Index c = 0; c < k; ++c) z -= y[c] * Y_.col(column_[index(c)]).head(f);
        upper_solve(L_, f, z);
        //! [bordered]
        for (Index c = 0; c < k; ++c) x[changed_[index(c)]] = came_in(c) * y[c];
    }
    for (Index r = 0; r < f; ++r) x[base_[index(r)]] = z[r];
    for (Index c = 0; c < k; ++c)  // those that went out
        if (came_in(c) == 0) x[changed_[index(c)]] = 0;
}

//! [from_the_beginning]
bool DenseLlt::factor_anew(const GuessedProblem& problem,
                           const std::vector<BoundState>& cases)
{
    base_.clear();
    changed_.clear();
    slots_.clear();
    std::fill(place_.begin(), place_.end(), -1);
    for (Index i = 0; i < size(cases); ++i)
        if (cases[index(i)] == BoundState::between) {
            place_[index(i)] = base();
            base_.push_back(i);
        }
    const Index f = base();
    for (Index c = 0; c < f; ++c) {
        const Real* const column = A_.col(base_[index(c)]).data();
        for (Index r = c; r < f; ++r) L_(r, c) = column[base_[index(r)]];
        if (problem.shifted) L_(c, c) += problem.shift[base_[index(c)]];
    }
    if (!llt_in_place(L_, f)) return false;
    for (Index r = 0; r < f; ++r) {
        const Index i = base_[index(r)];
        const Real nothing = problem.shifted ? 0.01 * problem.shift[i]
                                             : rank_tolerance * problem.diagonal[i];
        if (!(L_(r, r) * L_(r, r) > nothing)) return false;
    }
    return true;
}
//! [from_the_beginning]

//! [border]
bool DenseLlt::border(const GuessedProblem& problem,
                      const std::vector<BoundState>& cases)
{
    const Index f = base(), most = f / 6;
    changed_.clear();
    for (Index i = 0; i < size(cases); ++i)
        if ((cases[index(i)] == BoundState::between) != (place_[index(i)] >= 0))
            changed_.push_back(i);
    const Index k = size(changed_);
    if (k > most) return false;
    in_.resize(changed_.size());
    column_.resize(changed_.size());
    for (Index c = 0; c < k; ++c) {
        const Index i = changed_[index(c)];
        const bool in = place_[index(i)] < 0;
        in_[index(c)] = in ? 1 / std::sqrt(problem.diagonal[i]) : 0;
        Index slot = 0;
        while (slot < size(slots_) && slots_[index(slot)] != i) ++slot;
        column_[index(c)] = slot;
        if (slot < size(slots_)) continue;  // it has been solved for already
        if (slot >= 2 * most) return false;
        if (Y_.rows() < A_.rows() || Y_.cols() <= slot)
            Y_.conservativeResize(A_.rows(), 2 * most);
        auto y = Y_.col(slot).head(f);
        if (in)
            for (Index r = 0; r < f; ++r)
                y[r] = in_[index(c)] * A_(base_[index(r)], i);
        else {
            y.setZero();
            y[place_[index(i)]] = std::sqrt(problem.diagonal[i]);
        }
        lower_solve(L_, f, y);
        slots_.push_back(i);
    }
    MatX& S = schur_;
    S.resize(k, k);  // S = D − Yᵀ Y
    for (Index c = 0; c < k; ++c)
        for (Index d = 0; d <= c; ++d) {
            const Index i = changed_[index(c)], j = changed_[index(d)];
            Real entry = in_[index(c)] * in_[index(d)] * A_(i, j);
            if (i == j && problem.shifted)
                entry += in_[index(c)] * in_[index(c)] * problem.shift[i];
            entry -= Y_.col(column_[index(c)])
                         .head(f)
                         .dot(Y_.col(column_[index(d)]).head(f));
            S(c, d) = S(d, c) = entry;
        }
    if (k == 0) return true;
    S_.compute(S);
    const auto pivots = S_.matrixLU().diagonal().cwiseAbs();
    // else too much is lost: factor again
    return pivots.minCoeff() > 1e-8 && pivots.maxCoeff() < 1e8;
}
//! [border]

}  // namespace rigid
