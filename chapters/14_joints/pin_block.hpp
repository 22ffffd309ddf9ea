/// \file pin_block.hpp
/// A body of a tree that hangs on a pin: its block of the factor by the one motion that the pin leaves free.
///
///     J = ±(1 | j),  J_p = ∓(1 | p),  s = (−j, 1):  J s = 0
///     B = M + S,     D = sᵀ B s,      β = (B s)_v / D
///     K⁻¹ = B_vv − D β βᵀ,            K⁻¹ J G = (1 0) − β sᵀ
///
/// (14.28) to (14.31): what (14.8) and (14.9) say, with one division in place of five, and without G. It takes two rows
/// whose J begins with the identity, as those of a revolute joint do, and a body that can move in all directions.
#pragma once

#include "chapters/14_joints/joint_tree.hpp"

#include <cmath>

namespace rigid {

/// What its neighbours in the tree see of a body.
struct TreeBody {
    Vec<3> star, pull, u;  ///< of a solve: u*, G⁻¹ (u* − û), and the answer
    Eigen::Matrix<Real, 3, 3> S;  ///< (14.9); only the lower half is written
};

//! [pin_block]
struct PinBlock : TreeBody {
    bool is_pin = false;
    Index other = world;  ///< the other body of the pin, if it cannot move
    Real sign = 1;        ///< of J
    Vec2 j_turn, p_turn;  ///< j and p
    Vec2 beta;            ///< β
    Real per_D;           ///< 1/D
    Real k00, k10, k11;   ///< K⁻¹
    Vec2 missing, y;      ///< of a solve: J u* + J_p u_p* + b, and K⁻¹ r
    Real along;           ///< of a solve: s · pull

    Vec2 inverse_times(const Vec2& v) const
    {
        return {k00 * v[0] + k10 * v[1], k10 * v[0] + k11 * v[1]};
    }

    /// Whether these rows are a pin's, and the j and p of it.
    bool load_pin(const Row<3>& first, const Row<3>& second, const TreeNode& node)
    {
        const bool is_b = first.b == node.body;
        if ((second.b == node.body) != is_b) return false;
        const auto begins = [](Real value, const RowVec<3>& line,
                               const RowVec<3>& next) {
            return line[0] == value && line[1] == 0 && next[0] == 0 &&
                   next[1] == value;
        };
        const RowVec<3>& Jx = is_b ? first.Jb : first.Ja;
        const RowVec<3>& Jy = is_b ? second.Jb : second.Ja;
        const RowVec<3>& Jpx = is_b ? first.Ja : first.Jb;
        const RowVec<3>& Jpy = is_b ? second.Ja : second.Jb;
        sign = Jx[0];
        other = is_b ? first.a : first.b;
        const Index same = is_b ? second.a : second.b;
        if (std::abs(sign) != 1 || !begins(sign, Jx, Jy) || first.softness != 0 ||
            second.softness != 0 || other != same ||
            (other != world && !begins(-sign, Jpx, Jpy)))
            return false;
        j_turn = sign * Vec2(Jx[2], Jy[2]);
        p_turn = -sign * Vec2(Jpx[2], Jpy[2]);
        return true;
    }

    /// (14.28), (14.29), and the parent's S.
    /// \param parent  null = the world
    /// \return        rows that get no impulse: none, unless rounding has eaten D
    int factor_pin(const Vec<3>& inverse_mass, TreeBody* parent)
    {
        const Vec<3> m = inverse_mass.cwiseInverse();
        const Real b00 = m[0] + S(0, 0), b10 = S(1, 0), b11 = m[1] + S(1, 1),
                   b20 = S(2, 0), b21 = S(2, 1), b22 = m[2] + S(2, 2);
        const Vec2 Bs(b20 - b00 * j_turn[0] - b10 * j_turn[1],
                      b21 - b10 * j_turn[0] - b11 * j_turn[1]);
        const Real D = b22 - b20 * j_turn[0] - b21 * j_turn[1] - j_turn.dot(Bs);
        const bool turns = D > 0;
        per_D = turns ? 1 / D : 0;
        beta = per_D * Bs;
        k00 = b00 - beta[0] * Bs[0];
        k10 = b10 - beta[1] * Bs[0];
        k11 = b11 - beta[1] * Bs[1];
        if (parent != nullptr) {
            const Vec2 turn = inverse_times(p_turn);
            parent->S(0, 0) += k00;
            parent->S(1, 0) += k10;
            parent->S(1, 1) += k11;
            parent->S(2, 0) += turn[0];
            parent->S(2, 1) += turn[1];
            parent->S(2, 2) += p_turn.dot(turn);
        }
        return turns ? 0 : 2;
    }

    /// (14.30): up. The pin moves with the parent, or a body that nothing moves.
    template <class Bias>
    void up_pin(const Bias& b, const RowGroup& group, const VecX& u_all,
                TreeBody* parent)
    {
        missing = star.head<2>() + j_turn * star[2] +
                  sign * Vec2(b[group.rows[0]], b[group.rows[1]]);
        if (parent != nullptr)
            missing -= parent->star.head<2>() + p_turn * parent->star[2];
        else if (other != world)
            missing -= u_all.segment<2>(3 * other) + p_turn * u_all[3 * other + 2];
        along = pull[2] - j_turn.dot(pull.head<2>());
        y = inverse_times(missing) - (pull.head<2>() - beta * along);
        if (parent == nullptr) return;
        parent->pull.head<2>() -= y;
        parent->pull[2] -= p_turn.dot(y);
    }

    /// (14.31): down. λ and u, once the parent's u is known.
    void down_pin(const RowGroup& group, const TreeBody* parent, VecX& lambda)
    {
        Vec2 l = -y, off = missing;
        if (parent != nullptr) {
            const Vec<3> change = parent->u - parent->star;
            const Vec2 moved = change.head<2>() + p_turn * change[2];
            off -= moved;
            l += inverse_times(moved);
        }
        lambda[group.rows[0]] = sign * l[0];
        lambda[group.rows[1]] = sign * l[1];
        const Real turn = beta.dot(off) - along * per_D;
        u[0] = star[0] - off[0] - j_turn[0] * turn;
        u[1] = star[1] - off[1] - j_turn[1] * turn;
        u[2] = star[2] + turn;
    }
};
//! [pin_block]

}  // namespace rigid
