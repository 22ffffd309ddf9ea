/// \file columns.hpp
/// What the columns of the stability matrix have in common: the door, the check of honesty, and settings to spoil.
#pragma once

#include "chapters/03_mlcp_formulation/assembly.hpp"
#include "chapters/03_mlcp_formulation/step_data.hpp"
#include "chapters/03_mlcp_formulation/verification.hpp"
#include "common/text.hpp"
#include "tests/stress/method.hpp"

namespace rigid::stress {

std::vector<Method> matrix_methods(int sweeps);    ///< chapters 3 to 5
std::vector<Method> impulse_methods(int sweeps);   ///< chapters 6 to 8
std::vector<Method> exact_methods(int sweeps);     ///< chapter 9
std::vector<Method> skipping_methods(int sweeps);  ///< chapter 10

/// The door. Steps don't look at a whole scene each time, the caller does: here, before every step, since
/// a stress may change the scene in the middle of a run.
template <class Scene = DiscScene, class Advance>
StepOf<Scene> checked(Advance advance)
{
    return [advance = std::move(advance)](Scene& scene, Real h) {
        // a step in space looks at its scene each time
        if constexpr (Scene::dof < 6) require_valid(scene);
        require_step(h);
        advance(scene, h);
    };
}

/// Throws if an answer calls itself solved and its residual, computed here, says that it isn't.
inline void require_honest(const Mlcp& mlcp, const Solution& solution)
{
    if (solution.status != Status::solved) return;
    // 1e-6 of the numbers in the problem: a thousand times what the solvers themselves ask for.
    const Verification verified = verify(mlcp, solution.lambda, {1e-6, 1e-6});
    if (!verified.solved)
        throw SilentError("an answer with the residual " + shortest(verified.residual) +
                          " m/s is called solved");
}

/// The same for rows that were swept without a matrix. Looks at one step of sixteen: the matrix costs more than
/// the step.
class HonestRows {
public:
    template <class Now>
    void look(const Now& now, bool lambda_is_of_these_rows)
    {
        if (!lambda_is_of_these_rows || now.solution.status != Status::solved || steps_++ % 16 != 0) return;
        assemble(now.rows, now.u_star, scratch_, mlcp_);
        require_honest(mlcp_, now.solution);
    }

private:
    long steps_ = 0;
    AssemblyScratch scratch_;
    Mlcp mlcp_;
};

/// The settings of the one step. Gravity is the scene's; in space there is no hand.
template <class Scene>
std::vector<Setting> step_settings(Scene& scene, StepSettings& s)
{
    if constexpr (Scene::dof == 6)
        return {{"gravity x", &scene.gravity.x()},
                {"gravity y", &scene.gravity.y()},
                {"gravity z", &scene.gravity.z()},
                or_infinity("margin", &s.margin)};
    else
        return {{"gravity x", &scene.gravity.x()},
                {"gravity y", &scene.gravity.y()},
                {"stiffness", &s.stiffness},
                {"damping", &s.damping},
                or_infinity("margin", &s.margin),
                {"hand x", &s.hand.x()},
                {"hand y", &s.hand.y()}};
}

/// Writes what the wish wants spoilt. A hand is looked at only if it pulls.
template <class Settings>
void spoil(const Wish& wish, const std::vector<Setting>& all, Settings& settings)
{
    if (wish.setting < 0) return;
    if constexpr (requires { settings.pulled; }) settings.pulled = 0;
    *all.at(static_cast<std::size_t>(wish.setting)).value = wish.spoilt;
}

/// A spoilt gravity is for one step: the scene gets its own back.
template <class Scene>
class GravityGuard {
public:
    explicit GravityGuard(Scene& scene) : scene_(scene), gravity_(scene.gravity) {}
    ~GravityGuard() { scene_.gravity = gravity_; }
    GravityGuard(const GravityGuard&) = delete;
    GravityGuard& operator=(const GravityGuard&) = delete;

private:
    Scene& scene_;
    decltype(Scene::gravity) gravity_;
};

/// The names alone.
inline std::vector<Setting> names_of(std::vector<Setting> settings)
{
    for (Setting& setting : settings) setting.value = nullptr;
    return settings;
}

/// The names of the settings of the one step, before those of a method.
inline std::vector<Setting> step_setting_names()
{
    DiscScene scene;
    StepSettings settings;
    return names_of(step_settings(scene, settings));
}

}  // namespace rigid::stress
