/// \file cloths.hpp
/// What the tests of chapters 27 and 28 do with a cloth.
#pragma once

#include "chapters/27_particles_and_cloth/cloth_scenes.hpp"
#include "chapters/27_particles_and_cloth/cloth_step.hpp"
#include "tests/catch.hpp"

#include <functional>

namespace rigid {

/// What is said when something is refused.
inline std::string refusal(const std::function<void()>& what)
{
    try {
        what();
    } catch (const std::invalid_argument& error) {
        return error.what();
    }
    return "nothing was refused";
}

/// One step by a method.
inline void one_step(ClothScene& cloth, ClothMethod method, Real h, int sweeps = 1, int substeps = 1)
{
    ClothMemory memory;
    ClothSettings how;
    how.h = h, how.method = method, how.sweeps = sweeps, how.substeps = substeps;
    step(cloth, how, memory);
}

/// Where all forces balance: Newton's steps of three seconds, each from rest, until nothing moves by a picometre.
inline void settle(ClothScene& cloth)
{
    ClothMemory memory;
    ClothSettings how;
    how.h = 3, how.method = ClothMethod::newton;
    memory.newton.iterations = 200, memory.newton.tolerance = 1e-9;
    for (int n = 0; n < 100; ++n) {
        const VecX before = cloth.bodies.x;
        step(cloth, how, memory);
        cloth.bodies.u.setZero();
        if ((cloth.bodies.x - before).cwiseAbs().maxCoeff() < 1e-12) return;
    }
    FAIL_CHECK("the cloth did not settle");
}

/// M⁻¹ᐟ² K M⁻¹ᐟ² of small motions along a direction, by central differences of the forces.
inline MatX stiffness_along(const ClothScene& cloth, const Vec3& along, Real step)
{
    std::vector<int> free;
    for (int k = 0; k < cloth.count(); ++k)
        if (cloth.bodies.inverse_mass[3 * k] > 0) free.push_back(k);
    const auto n = static_cast<Index>(free.size());
    MatX K(n, n);
    for (Index j = 0; j < n; ++j) {
        VecX x = cloth.bodies.x, up = VecX::Zero(x.size()), down = up;
        const int k = free[static_cast<std::size_t>(j)];
        x.segment<3>(3 * k) += step * along;
        add_row_forces(cloth, x, up);
        x.segment<3>(3 * k) -= 2 * step * along;
        add_row_forces(cloth, x, down);
        for (Index i = 0; i < n; ++i) {
            const int p = free[static_cast<std::size_t>(i)];
            const Real scale = std::sqrt(cloth.bodies.inverse_mass[3 * p] * cloth.bodies.inverse_mass[3 * k]);
            K(i, j) = scale * along.dot(down.segment<3>(3 * p) - up.segment<3>(3 * p)) / (2 * step);
        }
    }
    return (K + K.transpose()) / 2;
}

}  // namespace rigid
