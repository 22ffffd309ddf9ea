/// \file pond_run.hpp
/// Bodies on a pond: boxes, a boat, a raft, a duck. The left wall makes waves, the pointer drags bodies and presses the water.
#pragma once

#include "chapters/11_rotation/program/turning_run.hpp"
#include "chapters/15_trees/tree_method.hpp"
#include "chapters/29_waves/program/dam_run.hpp"
#include "chapters/29_waves/water_scenes.hpp"
#include "chapters/29_waves/water_step.hpp"

namespace rigid {

struct PondSetup {
    WaterScene pond;
    Index watched = 0;  ///< the body whose motion is the table's
};

class PondRun : public Run {
public:
    PondRun(PondSetup setup, const Settings& settings)
        : all_(std::move(setup.pond)), watched_(setup.watched)
    {
        floating_.settings = {settings["lid"], settings["drag"], 0.01};
        cover(all_.scene, {0.3, 0, 0, 0});
        still_ = all_.water.depth[0];
        floating_.displace(all_.scene, all_.water);
        // what comes to the right end is swallowed there
        const Index n = all_.water.cells();
        all_.water.damping.setZero(n + 1);
        for (Index f = n - n / 8; f < n; ++f) {
            const Real in =
                static_cast<Real>(f - n + n / 8) / static_cast<Real>(n / 8);
            all_.water.damping[f] = settings["sponge"] * in * in;
        }
        never_stop(trees_.contacts);
        never_stop(sweeps_.contacts);
        sweeps_.correction.method = Stabilizer::projection;
        sweeps_.solver.sweeps.max_sweeps = 20;
        volume_ = volume(all_.water);
        floating_.find(all_.scene, all_.water);
    }

    void step(const Settings& settings, const Input& input) override
    {
        floating_.settings.lid = settings["lid"];
        floating_.settings.drag = settings["drag"];
        const int parts = std::max(
            1, static_cast<int>(std::ceil(
                   settings.h / (0.9 * floating_.stable_step(all_.water)))));
        StepSettings how{.h = settings.h / parts};
        const bool on_body = input.pressed && hold(input.pointer, how);
        for (int n = 0; n < parts; ++n) {
            // the left wall moves to and fro: as much water comes in as goes out
            t_ += how.h;
            all_.water.u[0] = settings["waves"] * std::sqrt(all_.water.g / still_) *
                              sin(2 * pi * t_ / settings["period"]);
            if (input.pressed && !on_body) press(input.pointer.x(), how.h);
            if (settings.method == "trees")
                rigid::step(all_.scene, all_.water, floating_, how, trees_, now_);
            else rigid::step(all_.scene, all_.water, floating_, how, sweeps_, now_);
        }
        require_finite_state(all_.scene.bodies);
        if (!input.pressed) held_ = world;
    }

    std::vector<Real> measure() const override
    {
        const Vec<3> at = all_.scene.bodies.position(watched_);
        Real whole = momentum(all_.water);
        for (Index k = 0; k < all_.scene.bodies.count(); ++k)
            whole += all_.scene.bodies.velocity(k)[0] /
                     all_.scene.bodies.inverse_mass[3 * k];
        return {at[0], at[1], at[2] * 180 / pi, whole,
                volume(all_.water) / volume_ - 1};
    }

    void draw(Canvas& canvas) const override
    {
        for (Index k = 0; k < all_.scene.bodies.count(); ++k)
            paint_rigid_body(canvas, all_.scene, k);
        paint_water(canvas, all_.water);
        for (const PlacedJoint& placed : all_.scene.placed)
            canvas.disc(
                point_of(all_.scene.bodies.x, placed.joint.b, placed.joint.at_b),
                0.03, {Colour::orange, 1, 1, Paint::filled});
    }

private:
    /// The body under the pointer is pulled until the button is released.
    bool hold(const Vec2& pointer, StepSettings& how)
    {
        if (held_ == world) {
            const Index near = nearest_body(all_.scene.bodies, pointer);
            const Vec2 off = all_.scene.bodies.position(near).head<2>() - pointer;
            held_ = off.norm() < 0.6 ? near : no_body;
        }
        if (held_ == no_body) return false;
        how.pulled = held_;
        how.hand = pointer;
        return true;
    }
    /// A finger of half a metre presses: the water beside it is pushed away.
    void press(Real x, Real h)
    {
        for (Index f = 1; f < all_.water.cells(); ++f) {
            const Real s =
                (all_.water.origin + all_.water.dx * static_cast<Real>(f) - x) /
                0.5;
            if (s * s < 1) all_.water.u[f] += h * 20 * s * (1 - s * s);
        }
    }

    static constexpr Index no_body = -2;
    WaterScene all_;
    Index watched_, held_ = world;
    Floating floating_;
    JointTrees<Manifolds> trees_;
    JointSweeps<Manifolds> sweeps_;
    StepData<3> now_;
    Real t_ = 0, still_ = 1, volume_ = 1;
};

inline Demo pond_demo(const std::string& name, const std::string& summary,
                      std::vector<Tunable> tunables,
                      const std::function<PondSetup(const Settings&)>& setup)
{
    tunables.insert(
        tunables.end(),
        {{"waves", "m", "height of waves from the left wall", 0.1, 0, 0.5},
         {"period", "s", "of these waves", 2, 0.5, 10},
         {"lid", "", "part of what a hull displaces that lifts the surface", 0.5, 0,
          0.9},
         {"drag", "", "of what goes ahead", 1, 0, 10},
         wave_number("sponge", "1/s", "damping at the right end", 4, 0, 20)});
    Demo scene =
        demo_of<PondRun>(name, summary, {{0, 1.55}, {8.2, 1.85}}, 1.0 / 120,
                         {"trees", "sweeps"}, std::move(tunables), setup);
    scene.held = "drags a body or presses the water";
    scene.columns = {
        {"x", "m", "of the body"},
        {"y", "m", "of the body", Plot::linear},
        {"angle", "°", "of the body", Plot::linear},
        {"momentum", "N s", "of water and bodies", Plot::linear},
        {"volume", "", "of the water, over that of the start, less 1"}};
    return scene;
}

inline Demo boxes_demo()
{
    return pond_demo(
        "boxes", "Which box capsizes?",
        {wave_number("part", "", "density over that of water", 0.5, 0.05, 0.95),
         wave_number("ratio", "", "width over height of the middle one", 1.2, 0.3,
                     4)},
        [](const Settings& settings) {
            PondSetup setup{pond(256, 16, 1.5), 1};
            const Real part = settings["part"];
            add_floating_box(setup.pond, -3.03, 0.6, 1, part, 0.02);
            add_floating_box(setup.pond, 0.02, 0.6, settings["ratio"], part, 0.02);
            add_floating_box(setup.pond, 3.01, 0.6, 1.7, part, 0.02);
            return setup;
        });
}

inline Demo boat_demo()
{
    return pond_demo("boat", "A boat with ballast and a mast on waves", {},
                     [](const Settings&) {
                         PondSetup setup{pond(256, 16, 1.5), 0};
                         setup.watched = add_boat(setup.pond, -1);
                         return setup;
                     });
}

inline Demo raft_demo()
{
    return pond_demo(
        "raft", "Planks on pins, and a box that rides on them",
        {wave_number("planks", "", "of the raft", 7, 1, 16, Numbers::whole)},
        [](const Settings& settings) {
            PondSetup setup{pond(256, 16, 1.5), 0};
            setup.watched =
                add_raft(setup.pond, 0, static_cast<int>(settings["planks"]));
            add_body(setup.pond.scene, box(0.4, 0.3), 100.0,
                     {0.1, 1.5 + 0.09 + 0.15});
            return setup;
        });
}

inline Demo duck_demo()
{
    return pond_demo("duck", "A duck", {}, [](const Settings&) {
        PondSetup setup{pond(256, 16, 1.5), 0};
        setup.watched = add_duck(setup.pond, 0);
        return setup;
    });
}

}  // namespace rigid
