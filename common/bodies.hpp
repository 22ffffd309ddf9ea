/// \file bodies.hpp
/// The state of all bodies of a scene.
///
/// Positions, velocities, forces and inverse masses are ONE vector each, body after
/// body, so that the formulas of the chapters are the code: `J * u + b` is \f$Ju + b\f$.
#pragma once

#include "common/math.hpp"
#include "common/text.hpp"

#include <cmath>
#include <stdexcept>
#include <string>
#include <string_view>

namespace rigid {

/// The body index that stands for the world: it never moves.
inline constexpr Index world = -1;

/// What is special about a kind of body is behind apply_inverse_mass() and integrate(): in space M⁻¹ is no diagonal, and
/// an orientation no sum of velocities.
/// \tparam Dof  degrees of freedom of a body: 2 for discs that do not turn, 3 for (x, y, θ) in the plane
template <int Dof>
struct Bodies {
    VecX x;             ///< positions [m], length Dof·K
    VecX u;             ///< velocities [m/s], length Dof·K
    VecX f;             ///< forces [N], length Dof·K
    VecX inverse_mass;  ///< [1/kg], length Dof·K (the diagonal of M⁻¹); zero = cannot move

    explicit Bodies(Index count = 0)
        : x(VecX::Zero(Dof * count)), u(x), f(x), inverse_mass(VecX::Ones(Dof * count))
    {
    }

    Index count() const { return x.size() / Dof; }

    /// Whether a force changes the velocity of body k; nothing moves the world.
    bool can_move(Index k) const
    {
        return k != world && inverse_mass.template segment<Dof>(Dof * k).maxCoeff() > 0;
    }

    /// M⁻¹ p: the change of velocity of body k under the impulse p [m/s].
    /// \param p  any vector expression of length Dof [N s]
    template <class Impulse>
    Vec<Dof> apply_inverse_mass(Index k, const Impulse& p) const
    {
        return inverse_mass.template segment<Dof>(Dof * k).cwiseProduct(p);
    }

    /// x ← x + h v of body k, (1.10).
    /// \param v  velocity [m/s], length Dof
    template <class Velocity>
    void integrate(Index k, const Velocity& v, Real h)
    {
        position(k) += h * v;
    }

    /// As many bodies as that. Those that there are keep their state; new ones are at the origin, at rest, of mass 1.
    void resize(Index bodies)
    {
        const Index before = x.size(), now = Dof * bodies;
        for (VecX* const v : {&x, &u, &f, &inverse_mass}) {
            v->conservativeResize(now);
            if (now > before) v->tail(now - before).setConstant(v == &inverse_mass ? 1 : 0);
        }
    }

    auto position(Index k) { return x.template segment<Dof>(Dof * k); }
    auto position(Index k) const { return x.template segment<Dof>(Dof * k); }
    auto velocity(Index k) { return u.template segment<Dof>(Dof * k); }
    auto velocity(Index k) const { return u.template segment<Dof>(Dof * k); }
    auto force(Index k) { return f.template segment<Dof>(Dof * k); }
    auto force(Index k) const { return f.template segment<Dof>(Dof * k); }
};

/// Throws std::invalid_argument, naming vector, entry and value, unless every entry is finite.
inline void require_finite(const VecX& v, std::string_view name)
{
    for (Index i = 0; i < v.size(); ++i)
        if (!std::isfinite(v[i]))
            throw std::invalid_argument(std::string(name) + "[" + std::to_string(i) + "] is " +
                                        shortest(v[i]) + "; it must be a finite number");
}

/// Throws std::invalid_argument unless the time step is a positive finite number.
inline void require_step(Real h)
{
    if (!(h > 0) || !std::isfinite(h))
        throw std::invalid_argument("the time step h is " + shortest(h) +
                                    " s; it must be positive and finite");
}

/// Throws std::invalid_argument, with a sentence that names the entry, unless all four
/// vectors have length Dof·K, all numbers are finite and no mass is negative.
template <int Dof>
void require_valid(const Bodies<Dof>& bodies)
{
    const Index n = bodies.x.size();
    if (n % Dof != 0)
        throw std::invalid_argument("x has " + std::to_string(n) + " entries; it must be a multiple of " +
                                    std::to_string(Dof));
    const auto check = [n](const VecX& v, std::string_view name) {
        if (v.size() != n)
            throw std::invalid_argument(std::string(name) + " has " + std::to_string(v.size()) +
                                        " entries; x has " + std::to_string(n));
        require_finite(v, name);
    };
    check(bodies.x, "x");
    check(bodies.u, "u");
    check(bodies.f, "f");
    check(bodies.inverse_mass, "inverse_mass");
    for (Index i = 0; i < n; ++i)
        if (bodies.inverse_mass[i] < 0)
            throw std::invalid_argument("inverse_mass[" + std::to_string(i) + "] is " +
                                        shortest(bodies.inverse_mass[i]) +
                                        " 1/kg; it must be zero (cannot move) or positive");
}

}  // namespace rigid
