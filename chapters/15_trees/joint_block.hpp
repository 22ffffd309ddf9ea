/// \file joint_block.hpp
/// One body of a tree and the joint that it hangs on: its block of the factor, and its part of a solve.
///
///     K = J G Jᵀ + Γ = L diag(pivot) Lᵀ,   S_parent += J_pᵀ K⁻¹ J_p,   G = (M + S)⁻¹
///
/// (15.5), (15.6). At most four rows, so that all loops are unrolled. J G and K⁻¹ J_p are kept: with them a body waits
/// for the one before it by two short products on the way up, and by two on the way down. Pins have a shorter way:
/// pin_block.hpp.
#pragma once

#include "chapters/15_trees/pin_block.hpp"

#include <utility>

namespace rigid {

/// what<i>() for i = 0 … d − 1: no loop is left of it at any level of optimisation.
template <int d, class What>
void unrolled([[maybe_unused]] const What& what)
{
    [&]<int... i>(std::integer_sequence<int, i...>)
    {
        (what.template operator()<i>(), ...);
    }
    (std::make_integer_sequence<int, d>());
}

/// A body and the joint that it hangs on.
struct JointBlock : PinBlock {
    /// a row lies in one piece
    template <int d>
    using Lines = Eigen::Matrix<Real, d, 3, Eigen::RowMajor>;
    using Mat3 = Eigen::Matrix<Real, 3, 3>;

    int count = 0;  ///< rows of the joint
    /// of each row the other body, if it cannot move
    std::array<Index, RowGroup::most> others{};
    Vec<4> Kr;       ///< of a solve: K⁻¹ r, r as in (15.18)
    Lines<4> J, Jp;  ///< J of the rows for the body, the parent
    Lines<4> JG;     ///< line i: what one unit of λ_i does to the body
    Lines<4> KJp;    ///< K⁻¹ J_p: what −λ becomes per velocity of the parent
    Vec<4> inverse_pivot;
    Eigen::Matrix<Real, 4, 4> L;  ///< K = L diag(pivot) Lᵀ
    Mat3 G;
    Vec<4> softness;

    void load(const std::vector<Row<3>>& rows, const RowGroup& group,
              const TreeNode& node, const Vec<3>& inverse_mass);

    //! [mobility]
    /// (15.6): M + S = l diag(p) lᵀ, and G = l⁻ᵀ diag(1/p) l⁻¹. What cannot move in
    /// some direction has m = 1/0 there, and so 1/p = 0: no motion.
    void find_mobility(const Vec<3>& inverse_mass)
    {
        const Vec<3> m = inverse_mass.cwiseInverse();
        const Real q0 = 1 / (m[0] + S(0, 0));
        const Real l10 = S(1, 0) * q0, l20 = S(2, 0) * q0;
        const Real q1 = 1 / (m[1] + S(1, 1) - l10 * S(1, 0));
        const Real b21 = S(2, 1) - l20 * S(1, 0), l21 = b21 * q1;
        const Real q2 = 1 / (m[2] + S(2, 2) - l20 * S(2, 0) - l21 * b21);
        const Real m20 = l21 * l10 - l20;  // of l⁻¹
        G(0, 0) = q0 + l10 * l10 * q1 + m20 * m20 * q2;
        G(1, 1) = q1 + l21 * l21 * q2;
        G(2, 2) = q2;
        G(1, 0) = G(0, 1) = -(l10 * q1 + l21 * m20 * q2);
        G(2, 0) = G(0, 2) = m20 * q2;
        G(2, 1) = G(1, 2) = -l21 * q2;
    }
    //! [mobility]

    //! [joint_block]
    /// (15.5) and (15.7) for a joint of d rows. A row whose pivot is nothing
    /// beside its diagonal says what others say already: it gets no impulse.
    /// \param parent  null = the world
    /// \return        such rows
    template <int d>
    int factor(const Vec<3>& inverse_mass, TreeBody* parent)
    {
        JG.topRows<d>().noalias() = J.topRows<d>() * G;
        int nothing = 0;
        Vec<d> pivot;
        unrolled<d>([&]<int i>() {
            pivot[i] = JG.row(i).dot(J.row(i)) + softness[i];
            unrolled<i>([&]<int j>() {
                Real l = JG.row(i).dot(J.row(j));
                unrolled<j>([&]<int k>() { l -= pivot[k] * L(i, k) * L(j, k); });
                L(i, j) = l * inverse_pivot[j];
                pivot[i] -= L(i, j) * l;
            });
            const Real whole = J.row(i).cwiseAbs2().dot(inverse_mass);
            const bool counts = pivot[i] > rank_tolerance * (whole + softness[i]);
            inverse_pivot[i] = counts ? 1 / pivot[i] : 0;
            nothing += !counts;
        });
        if (parent == nullptr) return nothing;
        Lines<d> Y = Jp.topRows<d>();  // L⁻¹ J_p
        unrolled<d>([&]<int i>() {
            unrolled<i>([&]<int j>() { Y.row(i) -= L(i, j) * Y.row(j); });
            KJp.row(i) = inverse_pivot[i] * Y.row(i);
            unrolled<3>([&]<int k>() {
                unrolled<k + 1>(
                    [&]<int j>() { parent->S(k, j) += KJp(i, k) * Y(i, j); });
            });
        });
        for (int i = d - 2; i >= 0; --i)  // K⁻¹ J_p = L⁻ᵀ diag(1/pivot) L⁻¹ J_p
            for (int j = i + 1; j < d; ++j) KJp.row(i) -= L(j, i) * KJp.row(j);
        return nothing;
    }
    //! [joint_block]

    //! [up_and_down]
    /// (15.7): what the joint asks of the parent if that keeps its u*.
    template <int d, class Bias>
    void up(const Bias& b, const RowGroup& group, const VecX& u_all,
            TreeBody* parent)
    {
        Vec<d> r = J.topRows<d>() * star;
        if (parent) r += Jp.topRows<d>() * parent->star;
        unrolled<d>([&]<int i>() {
            r[i] += b[number(group, i)];
            // what no impulse moves may still move
            if (others[i] != world)
                r[i] += Jp.row(i).dot(u_all.segment<3>(3 * others[i]));
        });
        r -= JG.topRows<d>() * pull;
        if (parent) parent->pull += KJp.topRows<d>().transpose() * r;
        divide<d>(r);
        Kr.head<d>() = r;
    }

    /// (15.5) and (15.4): λ and u, once the parent's u is known. The body's u was û before.
    template <int d>
    void down(const RowGroup& group, const TreeBody* parent, VecX& lambda)
    {
        Vec<d> l = -Kr.head<d>();
        if (parent) l -= KJp.topRows<d>() * (parent->u - parent->star);
        unrolled<d>([&]<int i>() { lambda[number(group, i)] = l[i]; });
        u += JG.topRows<d>().transpose() * l;
    }
    //! [up_and_down]

    /// r ← K⁻¹ r. Of a row that says nothing new 1/pivot and its column of L are zero, and so its λ.
    template <int d>
    void divide(Vec<d>& r) const
    {
        unrolled<d>([&]<int i>() {
            unrolled<i>([&]<int j>() { r[i] -= L(i, j) * r[j]; });
        });
        unrolled<d>([&]<int back>() {
            constexpr int i = d - 1 - back;
            r[i] *= inverse_pivot[i];
            unrolled<d - 1 - i>(
                [&]<int j>() { r[i] -= L(i + 1 + j, i) * r[i + 1 + j]; });
        });
    }

    /// share of J M⁻¹ Jᵀ that the pivot of a row must keep
    static constexpr Real rank_tolerance = 1e-13;

    static Index number(const RowGroup& group, int i)
    {
        return group.rows[static_cast<std::size_t>(i)];
    }
};

}  // namespace rigid
