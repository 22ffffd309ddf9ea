#include "chapters/10_skipping_work/skipping_world.hpp"
#include "tests/stress/columns.hpp"

#include <optional>

namespace rigid::stress {

namespace {

std::vector<Setting> skipping_settings(DiscScene& scene, SkippingSettings& s)
{
    return {{"gravity x", &scene.gravity.x()},
            {"gravity y", &scene.gravity.y()},
            {"stiffness", &s.stiffness},
            {"damping", &s.damping},
            {"hand x", &s.hand.x()},
            {"hand y", &s.hand.y()},
            {"tolerance", &s.sweeps.tolerance},
            {"beta", &s.stabilizer.beta},
            {"slop", &s.stabilizer.slop},
            {"bilateral_slop", &s.stabilizer.bilateral_slop},
            or_infinity("max_correction_speed", &s.stabilizer.max_correction_speed),
            {"rest speed", &s.rest.speed},
            {"rest acceleration", &s.rest.acceleration},
            {"rest time", &s.rest.time},
            {"row_slack", &s.row_slack}};
}

/// Chapter 10's step. Its world is made of the scene that the first step is given. Later changes are scene edits; here
/// there are none but bad input, which is refused before it enters the world.
/// \param sweeps  an island may make so many; it stops when its residual is small
Method skipping(const std::string& name, int sweeps)
{
    Method method;
    method.chapter = 10;
    method.name = name;
    method.budget = "to 1e-6 m/s, " + std::to_string(sweeps) + " sweeps at most; eight rows exactly";
    method.has_beta = true;
    {
        DiscScene scene;
        SkippingSettings settings;
        method.settings = names_of(skipping_settings(scene, settings));
    }
    method.start = [=](const std::shared_ptr<const Wish>& wish) {
        const auto now = std::make_shared<std::optional<SkippingWorld>>();
        return checked([=](DiscScene& scene, Real h) {
            const GravityGuard guard(scene);
            SkippingSettings settings;
            settings.h = h;
            settings.sweeps.max_sweeps = sweeps;
            settings.sweeps.tolerance = 1e-6;
            settings.start = Start::previous;
            settings.stabilizer.method = Stabilizer::baumgarte;
            if (wish->beta >= 0) settings.stabilizer.beta = wish->beta;
            spoil(*wish, skipping_settings(scene, settings), settings);
            if (!*now) *now = make_world(scene, filter_of(scene));
            (*now)->scene.gravity = scene.gravity;
            skipping_step(**now, settings);
            scene.bodies.x = (*now)->scene.bodies.x;
            scene.bodies.u = (*now)->scene.bodies.u;
        });
    };
    return method;
}

}  // namespace

std::vector<Method> skipping_methods(int sweeps)
{
    return {skipping("skipping", sweeps), skipping("skipping to the end", 2000)};
}

}  // namespace rigid::stress
