/// \file joint_block.hpp
/// One body of a tree and the joint that it hangs on: its block of the factor, and its part of a solve.
///
///     K = J G Jᵀ + Γ = L diag(pivot) Lᵀ,   S_parent += J_pᵀ K⁻¹ J_p,   G = D (1 + D S D)⁻¹ D,  D = M^(−½)
///
/// (14.8), (14.9). At most four rows, so that all loops are unrolled.
#pragma once

#include "chapters/14_joints/joint_tree.hpp"

namespace rigid {

/// A body and the joint that it hangs on.
struct JointBlock {
    using Mat3 = Eigen::Matrix<Real, 3, 3>;
    int count = 0;        ///< rows of the joint
    Index other = world;  ///< the other body of the joint, if it cannot move
    Eigen::Matrix<Real, 4, 3> J, Jp;  ///< their J for the body, the parent
    Eigen::Matrix<Real, 4, 4> L;      ///< K = L diag(pivot) Lᵀ
    Vec<4> softness, inverse_pivot, y;
    Mat3 S, G;
    Vec<3> D, star, pull, free, u;

    void load(const std::vector<Row<3>>& rows, const RowGroup& group,
              const TreeNode& node)
    {
        const Index body = node.body;
        other = world;
        for (count = 0; count < group.count; ++count) {
            const Row<3>& row = rows[static_cast<std::size_t>(
                group.rows[static_cast<std::size_t>(count)])];
            const bool is_b = row.b == body;
            J.row(count) = is_b ? row.Jb : row.Ja;
            Jp.row(count) = is_b ? row.Ja : row.Jb;
            softness[count] = row.softness;
            if (node.parent < 0) other = is_b ? row.a : row.b;
        }
    }

    //! [mobility]
    /// (14.9): G = (M + S)⁻¹, in a form that takes 1/m = 0 and keeps symmetry:
    /// 1 + D S D = l diag(p) lᵀ, and G = D (l⁻ᵀ diag(1/p) l⁻¹) D.
    void find_mobility()
    {
        const Real b10 = D[1] * S(1, 0) * D[0], b20 = D[2] * S(2, 0) * D[0];
        const Real q0 = 1 / (1 + D[0] * S(0, 0) * D[0]);
        const Real l10 = b10 * q0, l20 = b20 * q0;
        const Real q1 = 1 / (1 + D[1] * S(1, 1) * D[1] - l10 * b10);
        const Real b21 = D[2] * S(2, 1) * D[1] - l20 * b10, l21 = b21 * q1;
        const Real q2 = 1 / (1 + D[2] * S(2, 2) * D[2] - l20 * b20 - l21 * b21);
        const Real m20 = l21 * l10 - l20;  // of l⁻¹
        G(0, 0) = D[0] * D[0] * (q0 + l10 * l10 * q1 + m20 * m20 * q2);
        G(1, 1) = D[1] * D[1] * (q1 + l21 * l21 * q2);
        G(2, 2) = D[2] * D[2] * q2;
        G(1, 0) = G(0, 1) = -D[1] * D[0] * (l10 * q1 + l21 * m20 * q2);
        G(2, 0) = G(0, 2) = D[2] * D[0] * m20 * q2;
        G(2, 1) = G(1, 2) = -D[2] * D[1] * l21 * q2;
    }
    //! [mobility]

    //! [joint_block]
    /// (14.8) and (14.10) for a joint of d rows. A row whose pivot is nothing
    /// beside its diagonal says what others say already: it gets no impulse.
    /// \param parent  S of the parent; null = the world
    /// \return        such rows
    template <int d>
    int factor(Mat3* parent)
    {
        const Eigen::Matrix<Real, d, d> K =
            J.topRows<d>() * G * J.topRows<d>().transpose();
        int nothing = 0;
        for (int i = 0; i < d; ++i) {
            Real pivot = K(i, i) + softness[i];
            for (int j = 0; j < i; ++j) {
                Real l = K(i, j);
                for (int k = 0; k < j; ++k) l -= y[k] * L(i, k) * L(j, k);
                L(i, j) = l * inverse_pivot[j];
                pivot -= L(i, j) * l;
            }
            const Real whole =
                J.row(i) * D.cwiseAbs2().asDiagonal() * J.row(i).transpose();
            const bool counts = pivot > rank_tolerance * (whole + softness[i]);
            y[i] = counts ? pivot : 0;
            inverse_pivot[i] = counts ? 1 / pivot : 0;
            nothing += !counts;
        }
        if (parent == nullptr) return nothing;
        auto Y = Jp;  // L⁻¹ J_p
        for (int i = 0; i < d; ++i) {
            for (int j = 0; j < i; ++j) Y.row(i) -= L(i, j) * Y.row(j);
            *parent += inverse_pivot[i] * (Y.row(i).transpose() * Y.row(i));
        }
        return nothing;
    }
    //! [joint_block]

    //! [up_and_down]
    /// (14.10): what the joint asks of the parent if that keeps its u*.
    template <int d, class Bias>
    void up(const Bias& b, const RowGroup& group, const VecX& u_all,
            JointBlock* parent)
    {
        Vec<d> r = J.topRows<d>() * free;
        if (parent) r += Jp.topRows<d>() * parent->star;
        // what no impulse moves may still move
        else if (other != world) r += Jp.topRows<d>() * u_all.segment<3>(3 * other);
        for (int i = 0; i < d; ++i) r[i] += b[number(group, i)];
        y.head<d>() = r;
        if (!parent) return;
        divide<d>(r);
        parent->pull += Jp.topRows<d>().transpose() * r;
    }

    /// (14.8) and (14.7): λ and u, once the parent's u is known.
    template <int d>
    void down(const RowGroup& group, const JointBlock* parent, VecX& lambda)
    {
        Vec<d> r = y.head<d>();
        if (parent) r += Jp.topRows<d>() * (parent->u - parent->star);
        divide<d>(r);
        for (int i = 0; i < d; ++i) lambda[number(group, i)] = -r[i];
        u = free - G * (J.topRows<d>().transpose() * r);
    }
    //! [up_and_down]

    /// r ← K⁻¹ r
    template <int d>
    void divide(Vec<d>& r) const
    {
        for (int i = 1; i < d; ++i)
            for (int j = 0; j < i; ++j) r[i] -= L(i, j) * r[j];
        for (int i = d - 1; i >= 0; --i) {
            r[i] *= inverse_pivot[i];
            for (int j = i + 1; j < d; ++j)
                // a row that says nothing new keeps its zero
                if (inverse_pivot[i] > 0) r[i] -= L(j, i) * r[j];
        }
    }

    /// share of J M⁻¹ Jᵀ that the pivot of a row must keep
    static constexpr Real rank_tolerance = 1e-13;

    static Index number(const RowGroup& group, int i)
    {
        return group.rows[static_cast<std::size_t>(i)];
    }
};

}  // namespace rigid
