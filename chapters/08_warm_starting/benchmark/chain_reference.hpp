/// \file chain_reference.hpp
/// How a chain of links really moves: the accelerations from the exact tensions, and fourth-order steps.
///
///     M a = f + Jᵀ T,   J a + J̇ u = 0   →   (J M⁻¹ Jᵀ) T = −J M⁻¹ f − J̇ u
///
/// Each link shares a disc with the next one only: the matrix is tridiagonal and is solved directly. No velocity
/// row, no sweep and no bias of this book's steps is in it.
#pragma once

#include "common/scenes.hpp"

#include <vector>

namespace rigid {

class ChainReference {
public:
    /// \param scene  link k joins the bodies k and k + 1; body 0 cannot move
    explicit ChainReference(const DiscScene& scene)
        : x(scene.bodies.x), u(scene.bodies.u),
          inverse_mass_(scene.bodies.inverse_mass), gravity_(scene.gravity),
          links_(scene.links)
    {
        for (std::size_t k = 0; k < links_.size(); ++k)
            if (links_[k].a != static_cast<Index>(k) ||
                links_[k].b != static_cast<Index>(k) + 1)
                throw std::invalid_argument(
                    "link " + std::to_string(k) + " joins the bodies " +
                    std::to_string(links_[k].a) + " and " +
                    std::to_string(links_[k].b) + "; a chain goes from k to k + 1");
    }

    VecX x;  ///< [m]
    VecX u;  ///< [m/s]

    /// One step of the classical Runge-Kutta method.
    void step(Real h)
    {
        const VecX a1 = acceleration(x, u);
        const VecX u2 = u + h / 2 * a1, a2 = acceleration(x + h / 2 * u, u2);
        const VecX u3 = u + h / 2 * a2, a3 = acceleration(x + h / 2 * u2, u3);
        const VecX u4 = u + h * a3, a4 = acceleration(x + h * u3, u4);
        x += h / 6 * (u + 2 * u2 + 2 * u3 + u4);
        u += h / 6 * (a1 + 2 * a2 + 2 * a3 + a4);
    }

private:
    VecX acceleration(const VecX& at, const VecX& velocity)
    {
        const auto m = static_cast<Index>(links_.size());
        VecX a = VecX::Zero(at.size());
        for (Index k = 0; k < at.size(); k += 2)
            if (inverse_mass_[k] > 0) a.segment<2>(k) = gravity_;
        n_.resize(links_.size());
        diagonal_.resize(m);
        beside_.setZero(m);
        T_.resize(m);
        for (Index k = 0; k < m; ++k) {
            const Vec2 d = at.segment<2>(2 * k + 2) - at.segment<2>(2 * k);
            const Vec2 v =
                velocity.segment<2>(2 * k + 2) - velocity.segment<2>(2 * k);
            const Real length = d.norm();
            const Vec2 n = d / length;
            n_[static_cast<std::size_t>(k)] = n;
            diagonal_[k] = inverse_mass_[2 * k] + inverse_mass_[2 * k + 2];
            if (k > 0)
                beside_[k] = -inverse_mass_[2 * k] *
                             n.dot(n_[static_cast<std::size_t>(k - 1)]);
            // C = ‖d‖ − L:  J̇ u = (‖v‖² − (n·v)²)/‖d‖
            T_[k] = -n.dot(a.segment<2>(2 * k + 2) - a.segment<2>(2 * k)) -
                    (v.squaredNorm() - n.dot(v) * n.dot(v)) / length;
        }
        // the tridiagonal system, forwards and back
        for (Index k = 1; k < m; ++k) {
            const Real factor = beside_[k] / diagonal_[k - 1];
            diagonal_[k] -= factor * beside_[k];
            T_[k] -= factor * T_[k - 1];
        }
        for (Index k = m; k-- > 0;) {
            if (k + 1 < m) T_[k] -= beside_[k + 1] * T_[k + 1];
            T_[k] /= diagonal_[k];
        }
        for (Index k = 0; k < m; ++k) {
            const Vec2 pull = T_[k] * n_[static_cast<std::size_t>(k)];
            a.segment<2>(2 * k) -= inverse_mass_[2 * k] * pull;
            a.segment<2>(2 * k + 2) += inverse_mass_[2 * k + 2] * pull;
        }
        return a;
    }

    VecX inverse_mass_;
    Vec2 gravity_;
    std::vector<Link> links_;
    std::vector<Vec2> n_;
    VecX diagonal_, beside_, T_;
};

}  // namespace rigid
