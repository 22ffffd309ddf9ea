// The functions of solve_rows.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/02_velocity_constraints/solve_rows.hpp"

namespace rigid {

template <int Dof>
const RowsAnswer& RowsSolver<Dof>::solve(const std::vector<Row<Dof>>& rows,
                                         const VecX& u)
{
    const Index m = static_cast<Index>(rows.size());
    require_bilateral(rows, u);
    answer_.at_odds.clear();
    answer_.lambda.resize(m);
    if (m == 0) {
        answer_ = {};
        return answer_;
    }
    //! [solve_rows]
    A_.resize(m, m);
    q_.resize(m);
    scale_.resize(m);
    for (Index i = 0; i < m; ++i) {  // (2.24): A = J M⁻¹ Jᵀ and q = J u + b
        q_[i] = row(rows, i).velocity(u);
        for (Index j = 0; j <= i; ++j)
            A_(i, j) = coupling(row(rows, i), row(rows, j));
        A_(i, i) += row(rows, i).softness;
        scale_[i] = A_(i, i) > 0 ? 1 / std::sqrt(A_(i, i)) : 1;
    }
    for (Index i = 0; i < m; ++i)  // to a unit diagonal
        for (Index j = 0; j <= i; ++j) A_(j, i) = A_(i, j) *= scale_[i] * scale_[j];
    q_.array() *= scale_.array();

    ldlt_.compute(A_);
    answer_.rank = m;
    if (ldlt_.vectorD().minCoeff() > rank_tolerance) {
        answer_.lambda = ldlt_.solve(-q_);
    } else {
        // rows that repeat others: the least λ of those that leave the least w
        orthogonal_.setThreshold(rank_tolerance);
        orthogonal_.compute(A_);
        answer_.rank = orthogonal_.rank();
        answer_.lambda = orthogonal_.solve(-q_);
    }
    answer_.lambda.array() *= scale_.array();
    //! [solve_rows]
    judge(rows, u);
    return answer_;
}

template <int Dof>
void RowsSolver<Dof>::require_bilateral(const std::vector<Row<Dof>>& rows,
                                        const VecX& u)
{
    require_finite(u, "u");
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const std::string name = "row " + std::to_string(i);
        require_valid(rows[i], name, u.size() / Dof);
        if (rows[i].lo != -infinity || rows[i].hi != infinity ||
            rows[i].bounded_by >= 0)
            throw std::invalid_argument(
                name + " is bounded; rows are solved together only if they may "
                       "push and "
                       "pull without bound (lo = -infinity, hi = infinity)");
    }
}

template <int Dof>
void RowsSolver<Dof>::judge(const std::vector<Row<Dof>>& rows, const VecX& u)
{
    const Index m = answer_.lambda.size();
    u_ = u;
    for (Index i = 0; i < m; ++i) row(rows, i).apply(answer_.lambda[i], u_);
    answer_.w.resize(m);
    Real worst = 0, speed = 0;  // of the scaled rows
    for (Index i = 0; i < m; ++i) {
        answer_.w[i] =
            row(rows, i).velocity(u_) + row(rows, i).softness * answer_.lambda[i];
        worst = std::max(worst, scale_[i] * std::abs(answer_.w[i]));
        speed = std::max(speed, scale_[i] * std::max(reach(row(rows, i), u),
                                                     reach(row(rows, i), u_)));
    }
    answer_.residual = answer_.w.cwiseAbs().maxCoeff();
    answer_.verdict = answer_.rank == m ? Verdict::independent : Verdict::redundant;
    if (worst <= conflict_tolerance * speed) return;
    answer_.verdict = Verdict::conflicting;
    for (Index i = 0; i < m; ++i)
        if (scale_[i] * std::abs(answer_.w[i]) > 1e-6 * worst)
            answer_.at_odds.push_back(i);
}

template <int Dof>
Real RowsSolver<Dof>::reach(const Row<Dof>& row, const VecX& u)
{
    Real sum = std::abs(row.bias) +
               row.Jb.norm() * u.template segment<Dof>(Dof * row.b).norm();
    if (row.a != world)
        sum += row.Ja.norm() * u.template segment<Dof>(Dof * row.a).norm();
    return sum;
}

std::string sentence(const RowsAnswer& answer)
{
    const std::string rows = std::to_string(answer.lambda.size()) +
                             " rows of rank " + std::to_string(answer.rank);
    if (answer.verdict == Verdict::independent)
        return rows + ": each has its own say, one answer";
    if (answer.verdict == Verdict::redundant)
        return rows + ": redundant, the velocity is certain but lambda is not; the "
                      "smallest is given";
    std::string names;
    for (std::size_t i = 0; i < answer.at_odds.size() && i < 8; ++i)
        names += (i ? ", " : "") + std::to_string(answer.at_odds[i]);
    if (answer.at_odds.size() > 8) names += ", ...";
    return rows + ": no velocity meets row(s) " + names +
           " together; the best compromise misses by " + readable(answer.residual) +
           " m/s";
}

template class RowsSolver<1>;
template class RowsSolver<2>;
template class RowsSolver<3>;
template class RowsSolver<6>;

}  // namespace rigid
