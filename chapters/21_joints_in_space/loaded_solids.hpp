/// \file loaded_solids.hpp
/// A loaded joint is stiff across its load, in space: chapter 15's section 15.E with a matrix for a number.
///
///     K = (f·r) 1 − ½ (f rᵀ + r fᵀ)                       f on the body at the arm r, in the body's own axes   (21.10)
///     κᵢ = max(0, Kᵢᵢ + Σ |Kᵢⱼ|),    Iᵢ → max(Iᵢ, h² κᵢ)                          (21.11), (21.12)
///
/// \cite tournier2015 \cite andrews2017
#pragma once

#include "chapters/07_baumgarte/correction.hpp"
#include "chapters/21_joints_in_space/all_solids.hpp"

#include <utility>
#include <vector>

namespace rigid {

//! [stiffness]
/// (21.10): a body that turns by a small φ under a force f at the arm r has the
/// torque −K φ more, but for a part across φ. All in one set of axes.
inline Mat3 turning_stiffness(const Vec3& f, const Vec3& r)
{
    const Mat3 both = f * r.transpose() + r * f.transpose();
    return f.dot(r) * Mat3::Identity() - both / 2;
}

/// (21.11): numbers that are, as a diagonal, at least K, and never below zero.
inline Vec3 at_least(const Mat3& K)
{
    const Vec3 sizes = K.cwiseAbs().rowwise().sum(), own = K.diagonal();
    return (sizes - own.cwiseAbs() + own).cwiseMax(0.0);
}
//! [stiffness]

/// Corrections of Part I, and bodies that turn as stiffly as their joints are loaded.
struct LoadedSolids : Correction {
    LoadedSolids() = default;
    LoadedSolids(const Correction& correction) : Correction(correction) {}

    /// false: rows along the J of the step's start alone, as in Part I
    bool stiff = true;

    //! [loaded]
    /// (21.12), from the impulses of the step before; then the rows.
    template <class Scene>
    void rows(Scene& scene, const StepSettings& settings, StepData<6>& now)
    {
        Bodies<6>& bodies = scene.bodies;
        forget();
        // Baumgarte's λ closes gaps as well: it is no load
        if (stiff && method != Stabilizer::baumgarte) sum_stiffness(scene, now);
        for (const int k : loaded_) {
            auto inverse = bodies.inverse_mass.segment<3>(6 * k + 3);
            kept_.emplace_back(k, inverse);
            const Vec3 kappa = at_least(stiffness_[static_cast<std::size_t>(k)]);
            const Vec3 harder =
                (settings.part() * kappa.cwiseProduct(inverse)).cwiseMax(1.0);
            inverse = inverse.cwiseQuotient(harder);
            auto turning = now.u_star.segment<3>(6 * k + 3);
            turning = turning.cwiseQuotient(harder);
        }
        Correction::rows(scene, settings, now);
    }

    /// With the inertia that the bodies have.
    template <class Scene, class Solver>
    void move(Scene& scene, const StepSettings& settings, Solver& solver,
              StepData<6>& now)
    {
        Bodies<6>& bodies = scene.bodies;
        for (const auto& [k, inverse] : kept_)
            bodies.inverse_mass.segment<3>(6 * k + 3) = inverse;
        kept_.clear();
        Correction::move(scene, settings, solver, now);
    }
    //! [loaded]

private:
    void forget();

    /// h K of each body that hangs on a loaded joint [N m s], in the body's axes.
    void sum_stiffness(const JointedSolids& scene, const StepData<6>& now);

    void add(const JointedSolids& scene, Index k, const Vec3& at,
             const Vec3& impulse);

    std::vector<Mat3> stiffness_;
    std::vector<char> is_loaded_;
    std::vector<int> loaded_;
    std::vector<std::pair<int, Vec3>> kept_;
};

}  // namespace rigid
