/// \file engine_column.hpp
/// The engine of chapter 19 as a column of the matrices of bodies that turn: its own settings, its own choice of solvers.
#pragma once

#include "chapters/14_joints/placed_joints.hpp"
#include "chapters/19_engine/from_scene.hpp"
#include "tests/stress/columns.hpp"

#include <optional>

namespace rigid::stress {

/// Pairs of rows that chapter 11 calls a pin, as joints of chapter 14.
inline JointedScene with_joints(const RoughScene& scene)
{
    JointedScene jointed;
    static_cast<RoughScene&>(jointed) = scene;
    jointed.joints.clear();
    for (std::size_t i = 0; i + 1 < scene.joints.size(); i += 2) {
        const PointJoint &across = scene.joints[i], &up = scene.joints[i + 1];
        if (across.measure != PointJoint::Measure::along || up.measure != across.measure ||
            across.a != up.a || across.b != up.b || across.at_a != up.at_a || across.at_b != up.at_b)
            throw std::logic_error("rows " + std::to_string(i) + " and " + std::to_string(i + 1) +
                                   " are no pin");
        RigidJoint pin;
        pin.a = across.a, pin.b = across.b, pin.at_a = across.at_a, pin.at_b = across.at_b;
        add_joint(jointed, pin);
    }
    return jointed;
}
inline const JointedScene& with_joints(const JointedScene& scene) { return scene; }

/// A world beside a scene: made of it at the first step, given what was changed from outside, read back after each.
template <class Scene>
class WorldBeside {
public:
    /// \param settings  their gravity and length are the scene's
    void step(Scene& scene, Real h, WorldSettings settings, bool changed)
    {
        require_valid_surfaces(scene);  // which the world has been given once
        settings.gravity = scene.gravity;
        settings.length = typical_length(scene);
        if (!world_) {
            World made(settings);
            ids_ = put_in(made, with_joints(scene));
            world_ = std::move(made);
        } else {
            if (changed || settings.gravity != world_->settings().gravity) world_->change(settings);
            for (Index k = 0; k < scene.bodies.count(); ++k) {
                const BodyId id = ids_[static_cast<std::size_t>(k)];
                const Vec<3> x = scene.bodies.position(k), u = scene.bodies.velocity(k);
                if (x != x_.segment<3>(3 * k)) world_->move(id, x.head<2>(), x[2]);
                if (u != u_.segment<3>(3 * k)) world_->set_velocity(id, u.head<2>(), u[2]);
            }
        }
        world_->step(h);
        for (Index k = 0; k < scene.bodies.count(); ++k) {
            const BodyId id = ids_[static_cast<std::size_t>(k)];
            scene.bodies.position(k) << world_->position(id), world_->angle(id);
            scene.bodies.velocity(k) << world_->velocity(id), world_->spin(id);
        }
        x_ = scene.bodies.x;
        u_ = scene.bodies.u;
    }

private:
    std::optional<World> world_;
    std::vector<BodyId> ids_;
    VecX x_, u_;  ///< as the last step left them
};

inline std::vector<Setting> settings_of(WorldSettings& s)
{
    return {
        {"margin", &s.margin}, {"slop", &s.slop}, {"tolerance", &s.tolerance}, {"hit speed", &s.hit_speed}};
}

template <class Scene>
MethodOf<Scene> engine_method(const std::string& name, const WorldSettings& how)
{
    MethodOf<Scene> method;
    method.chapter = 19;
    method.name = name;
    method.budget =
        "its own choice, " + std::to_string(how.substeps) + (how.substeps > 1 ? " substeps" : " step");
    method.friction = true;
    {
        WorldSettings names;
        method.settings = names_of(settings_of(names));
    }
    method.start = [=](const std::shared_ptr<const Wish>& wish) {
        const auto memory = std::make_shared<WorldBeside<Scene>>();
        return checked<Scene>([=](Scene& scene, Real h) {
            WorldSettings settings = how;
            const bool spoilt = wish->setting >= 0;
            if (spoilt)
                *settings_of(settings).at(static_cast<std::size_t>(wish->setting)).value = wish->spoilt;
            memory->step(scene, h, settings, spoilt);
        });
    };
    return method;
}

}  // namespace rigid::stress
