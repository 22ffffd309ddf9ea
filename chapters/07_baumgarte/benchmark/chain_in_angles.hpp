/// \file chain_in_angles.hpp
/// A swinging chain without constraints: N angles in place of 2N coordinates and N rows, so no C can be off.
///
///     Σ_k M_jk cos(θ_j − θ_k) θ̈_k = −Σ_k M_jk sin(θ_j − θ_k) θ̇_k² − (g/L) M_jj sin θ_j,   M_jk = Σ_{i ≥ max(j,k)} m_i
///
/// These are the equations of Lagrange for N pendulums one below the other, integrated by the method of Runge and
/// Kutta of order 4 (chapter 1). What the ways to repay a position error are measured against.
#pragma once

#include "common/math.hpp"
#include "common/text.hpp"

#include <Eigen/Cholesky>
#include <cmath>
#include <stdexcept>
#include <string>

namespace rigid {

class ChainInAngles {
public:
    /// Straight, at one angle from straight down, at rest.
    /// \param mass    [kg], one for each disc from the anchor on
    /// \param length  of each link [m]
    /// \param angle   [rad], counterclockwise
    ChainInAngles(const VecX& mass, Real length, Real angle, Real g)
        : length_(length), g_(g), below_(mass),
          theta_(VecX::Constant(mass.size(), angle)),
          omega_(VecX::Zero(mass.size()))
    {
        if (!(length > 0) || mass.size() == 0 || !(mass.minCoeff() > 0))
            throw std::invalid_argument(
                "a chain needs at least one disc of positive mass and links of "
                "positive length; the length is " +
                shortest(length) + " m");
        for (Index k = mass.size() - 1; k-- > 0;) below_[k] += below_[k + 1];
    }

    void step(Real h)
    {
        const VecX a1 = acceleration(theta_, omega_), w2 = omega_ + h / 2 * a1;
        const VecX a2 = acceleration(theta_ + h / 2 * omega_, w2),
                   w3 = omega_ + h / 2 * a2;
        const VecX a3 = acceleration(theta_ + h / 2 * w2, w3), w4 = omega_ + h * a3;
        const VecX a4 = acceleration(theta_ + h * w3, w4);
        theta_ += h / 6 * (omega_ + 2 * w2 + 2 * w3 + w4);
        omega_ += h / 6 * (a1 + 2 * a2 + 2 * a3 + a4);
    }

    /// Where the last disc is, from the anchor [m].
    Vec2 tip() const
    {
        Vec2 place = Vec2::Zero();
        for (Index k = 0; k < theta_.size(); ++k)
            place += length_ * Vec2(std::sin(theta_[k]), -std::cos(theta_[k]));
        return place;
    }

    /// Kinetic energy and that of the weight [J].
    Real energy() const
    {
        Real sum = 0;
        for (Index j = 0; j < theta_.size(); ++j) {
            sum -= below_[j] * g_ * length_ * std::cos(theta_[j]);
            for (Index k = 0; k < theta_.size(); ++k)
                sum += below_[std::max(j, k)] * length_ * length_ *
                       std::cos(theta_[j] - theta_[k]) * omega_[j] * omega_[k] / 2;
        }
        return sum;
    }

private:
    VecX acceleration(const VecX& theta, const VecX& omega) const
    {
        const Index N = theta.size();
        MatX M(N, N);
        VecX right(N);
        for (Index j = 0; j < N; ++j) {
            right[j] = -g_ / length_ * below_[j] * std::sin(theta[j]);
            for (Index k = 0; k < N; ++k) {
                const Real m = below_[std::max(j, k)], turned = theta[j] - theta[k];
                M(j, k) = m * std::cos(turned);
                right[j] -= m * std::sin(turned) * omega[k] * omega[k];
            }
        }
        return M.llt().solve(right);
    }

    Real length_, g_;
    VecX below_;  ///< mass that hangs on each link [kg]
    VecX theta_, omega_;
};

}  // namespace rigid
