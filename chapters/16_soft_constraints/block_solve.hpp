/// \file block_solve.hpp
/// What block descent needs besides its equations: which rows a body has, the D of each, and a small definite system.
#pragma once

#include "chapters/03_mlcp_formulation/step_data.hpp"

#include <span>
#include <vector>

namespace rigid {

template <int N>
using Mat = Eigen::Matrix<Real, N, N>;

//! [solve_definite]
/// x of H x = f for a symmetric positive definite H, by H = L D Lᵀ. Only what is on
/// and below the diagonal is read.
template <int N>
Vec<N> solve_definite(Mat<N> H, Vec<N> f)
{
    for (int j = 0; j < N; ++j)
        for (int i = j + 1; i < N; ++i) {
            const Real l = H(i, j) / H(j, j);
            for (int k = j + 1; k <= i; ++k) H(i, k) -= l * H(k, j);
            f[i] -= l * f[j];
        }
    for (int j = N - 1; j >= 0; --j) {
        for (int i = j + 1; i < N; ++i) f[j] -= H(i, j) * f[i];
        f[j] /= H(j, j);
    }
    return f;
}
//! [solve_definite]

/// The rows of each body, and D of each of them.
class RowsOfBodies {
public:
    struct Meeting {
        int row = 0;
        bool is_a = false;  ///< the body is a of this row
    };

    template <int Dof>
    void find(const std::vector<Row<Dof>>& rows, Index bodies)
    {
        first_.assign(static_cast<std::size_t>(bodies) + 1, 0);
        for (const Row<Dof>& row : rows)
            for (const Index k : {row.a, row.b})
                if (k != world) ++first_[static_cast<std::size_t>(k) + 1];
        for (std::size_t k = 1; k < first_.size(); ++k) first_[k] += first_[k - 1];
        next_.assign(first_.begin(), first_.end());
        list_.resize(first_.back());
        for (std::size_t i = 0; i < rows.size(); ++i)
            for (const bool is_a : {true, false}) {
                const Index k = is_a ? rows[i].a : rows[i].b;
                if (k != world)
                    list_[next_[static_cast<std::size_t>(k)]++] = {
                        static_cast<int>(i), is_a};
            }
    }

    std::span<const Meeting> of(Index k) const
    {
        const auto i = static_cast<std::size_t>(k);
        return {list_.data() + first_[i], first_[i + 1] - first_[i]};
    }

    //! [curvature]
    /// D of (16.29): the lengths of the columns of each K = ∂J/∂x. Rows begin without.
    template <int Dof>
    void no_curvature(std::size_t rows)
    {
        curvature_.setZero(2 * Dof * static_cast<Index>(rows));
    }
    /// \param a, b  K of the row's a and of its b
    template <int Dof>
    void set_curvature(int row, const Mat<Dof>& a, const Mat<Dof>& b)
    {
        curvature_.segment<Dof>(at<Dof>(row, true)) = a.colwise().norm();
        curvature_.segment<Dof>(at<Dof>(row, false)) = b.colwise().norm();
    }
    //! [curvature]

    template <int Dof>
    Vec<Dof> curvature(const Meeting& one) const
    {
        return curvature_.segment<Dof>(at<Dof>(one.row, one.is_a));
    }

private:
    template <int Dof>
    static Index at(int row, bool is_a)
    {
        return Dof * (2 * row + (is_a ? 0 : 1));
    }

    std::vector<std::size_t> first_, next_;
    std::vector<Meeting> list_;
    VecX curvature_;
};

}  // namespace rigid
