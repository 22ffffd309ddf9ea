/// \file kept_exact.hpp
/// Motions that are right: of what hangs on joints by steps of fifth order with a tolerance, of two bodies that fall and
/// bounce from blow to blow.
#pragma once

#include "chapters/01_euler_integration/adaptive.hpp"
#include "chapters/15_trees/joint_accelerations.hpp"
#include "chapters/19_engine/benchmark/kept_motion.hpp"
#include "chapters/19_engine/from_scene.hpp"

namespace rigid::kept {

/// A scene on joints as a world in which nothing touches.
inline World hung(const JointedScene& scene)
{
    World made;
    put_in(made, scene, {1, 0xffff'ffff, -1});
    return made;
}

/// Its motion by Dormand and Prince's pair at a tolerance of 1e-12. Throws std::runtime_error where that comes to no end.
inline Motion exact_motion(const JointedScene& scene, Real seconds)
{
    constexpr int any = Eigen::Dynamic;
    JointAccelerations joints;
    const auto a = [&](const VecX& x, const VecX& u) -> VecX {
        VecX free = VecX::Zero(x.size());
        for (Index k = 0; k < scene.bodies.count(); ++k)
            free.segment<2>(3 * k) = scene.gravity;
        joints.find(scene, x, u, free);
        return free;
    };
    const Tolerance tolerance{1e-12, 1e-12, 1e-12};
    Adaptive<any> run =
        start_adaptive<any>({scene.bodies.x, scene.bodies.u}, a, tolerance);
    Motion motion{hung(scene), {}, {}};
    const auto poses = [](const VecX& all) {
        Poses each;
        for (Index k = 0; 3 * k < all.size(); ++k)
            each.push_back(all.segment<3>(3 * k));
        return each;
    };
    for (int n = 0; n <= std::lround(seconds / frame); ++n) {
        const Outcome outcome = integrate(run, n * frame, a, tolerance);
        if (outcome != Outcome::reached)
            throw std::runtime_error(to_string(outcome));
        motion.x.push_back(poses(run.s.x));
        motion.u.push_back(poses(run.s.u));
    }
    return motion;
}

/// Two bodies fall together, the upper one a gap above the lower one, and bounce with e = 1: how high the upper one then
/// is above its place on the lower one at rest [m]. From blow to blow: all fall alike, so a gap changes at a constant speed.
inline Real first_apex(Real lower_mass, Real upper_mass, Real fall, Real gap)
{
    const Real g = 9.81, M = lower_mass, m = upper_mass;
    Real z = fall, Z = fall + gap, v = 0, V = 0;  // lower, upper; from the floor
    for (int blow = 0; blow < 100'000; ++blow) {
        const Real floor = (v + std::sqrt(v * v + 2 * g * z)) / g,
                   met = v > V ? (Z - z) / (v - V) : infinity,
                   apex = V > 0 ? V / g : infinity, t = std::min(floor, met);
        if (apex <= t) return Z + V * V / (2 * g);
        z += (v - g * t / 2) * t, Z += (V - g * t / 2) * t;
        v -= g * t, V -= g * t;
        if (floor < met) {
            z = 0, v = -v;
        } else {
            const Real P = 2 * M * m / (M + m) * (v - V);
            v -= P / M, V += P / m;
        }
    }
    throw std::runtime_error("two bodies that bounce reached no apex");
}

}  // namespace rigid::kept
