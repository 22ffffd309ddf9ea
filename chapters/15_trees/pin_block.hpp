/// \file pin_block.hpp
/// A body of a tree that hangs on a pin: its block of the factor by the one motion that the pin leaves free.
///
///     J = ±(1 | j),  J_p = ∓(1 | p),  s = (−j, 1):  J s = 0
///     B = M + S,     D = sᵀ B s,      β = (B s)_v / D
///     K⁻¹ = B_vv − D β βᵀ,            K⁻¹ J G = (1 0) − β sᵀ
///
/// (15.19) to (15.22): what (15.5) and (15.6) say, with one division in place of five, and without G. It takes two rows
/// whose J begins with the identity, as those of a revolute joint do, and a body that can move in all directions.
#pragma once

#include "chapters/15_trees/joint_tree.hpp"

#include <cmath>

namespace rigid {

/// What its neighbours in the tree see of a body.
struct TreeBody {
    Vec<3> star, pull, u;  ///< of a solve: u*, G⁻¹ (u* − û), and the answer
    Eigen::Matrix<Real, 3, 3> S;  ///< (15.6); only the lower half is written
};

//! [pin_block]
struct PinBlock : TreeBody {
    /// Two numbers that stay two: Eigen loads a Vec2 as one register, and waits
    /// where they were just stored one by one.
    struct Pair {
        Real x = 0, y = 0;

        friend Pair operator+(Pair a, Pair b) { return {a.x + b.x, a.y + b.y}; }
        friend Pair operator-(Pair a, Pair b) { return {a.x - b.x, a.y - b.y}; }
        friend Pair operator*(Pair a, Real s) { return {a.x * s, a.y * s}; }
        friend Real dot(Pair a, Pair b) { return a.x * b.x + a.y * b.y; }
    };

    bool is_pin = false;
    Index other = world;  ///< the other body of the pin, if it cannot move
    Real sign = 1;        ///< of J
    Pair j_turn, p_turn;  ///< j and p
    Pair beta;            ///< β
    Real per_D;           ///< 1/D
    Real k00, k10, k11;   ///< K⁻¹
    Pair missing, y;      ///< of a solve: J u* + J_p u_p* + b, and K⁻¹ r
    Real along;           ///< of a solve: s · pull

    Pair inverse_times(Pair v) const
    {
        return {k00 * v.x + k10 * v.y, k10 * v.x + k11 * v.y};
    }

    /// How fast the point at p moves that turns with a body of velocity v.
    static Pair at_point(const Vec<3>& v, Pair p)
    {
        return Pair{v[0], v[1]} + p * v[2];
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
        j_turn = Pair{Jx[2], Jy[2]} * sign;
        p_turn = Pair{Jpx[2], Jpy[2]} * -sign;
        return true;
    }

    /// (15.19), (15.20), and the parent's S.
    /// \param parent  null = the world
    /// \return        rows that get no impulse: none, unless rounding has eaten D
    int factor_pin(const Vec<3>& inverse_mass, TreeBody* parent)
    {
        const Vec<3> m = inverse_mass.cwiseInverse();
        const Real b00 = m[0] + S(0, 0), b10 = S(1, 0), b11 = m[1] + S(1, 1),
                   b20 = S(2, 0), b21 = S(2, 1), b22 = m[2] + S(2, 2);
        const Pair Bs{b20 - b00 * j_turn.x - b10 * j_turn.y,
                      b21 - b10 * j_turn.x - b11 * j_turn.y};
        const Real D = b22 - b20 * j_turn.x - b21 * j_turn.y - dot(j_turn, Bs);
        const bool turns = D > 0;
        per_D = turns ? 1 / D : 0;
        beta = Bs * per_D;
        k00 = b00 - beta.x * Bs.x;
        k10 = b10 - beta.y * Bs.x;
        k11 = b11 - beta.y * Bs.y;
        if (parent != nullptr) {
            const Pair turn = inverse_times(p_turn);
            parent->S(0, 0) += k00;
            parent->S(1, 0) += k10;
            parent->S(1, 1) += k11;
            parent->S(2, 0) += turn.x;
            parent->S(2, 1) += turn.y;
            parent->S(2, 2) += dot(p_turn, turn);
        }
        return turns ? 0 : 2;
    }

    /// (15.21): up. The pin moves with the parent, or a body that nothing moves.
    template <class Bias>
    void up_pin(const Bias& b, const RowGroup& group, const VecX& u_all,
                TreeBody* parent)
    {
        missing = at_point(star, j_turn) +
                  Pair{b[group.rows[0]], b[group.rows[1]]} * sign;
        if (parent != nullptr) missing = missing - at_point(parent->star, p_turn);
        else if (other != world)
            missing = missing - at_point(u_all.segment<3>(3 * other), p_turn);
        const Pair push{pull[0], pull[1]};
        along = pull[2] - dot(j_turn, push);
        y = inverse_times(missing) - (push - beta * along);
        if (parent == nullptr) return;
        parent->pull[0] -= y.x;
        parent->pull[1] -= y.y;
        parent->pull[2] -= dot(p_turn, y);
    }

    /// (15.22): down. λ and u, once the parent's u is known.
    void down_pin(const RowGroup& group, const TreeBody* parent, VecX& lambda)
    {
        Pair l{-y.x, -y.y}, off = missing;
        if (parent != nullptr) {
            const Pair moved = at_point(parent->u - parent->star, p_turn);
            off = off - moved;
            l = l + inverse_times(moved);
        }
        lambda[group.rows[0]] = sign * l.x;
        lambda[group.rows[1]] = sign * l.y;
        const Real turn = dot(beta, off) - along * per_D;
        u[0] = star[0] - off.x - j_turn.x * turn;
        u[1] = star[1] - off.y - j_turn.y * turn;
        u[2] = star[2] + turn;
    }
};
//! [pin_block]

}  // namespace rigid
