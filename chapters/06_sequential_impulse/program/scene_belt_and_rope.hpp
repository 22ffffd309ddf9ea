/// \file scene_belt_and_rope.hpp
/// A belt that drags, a rope that is taut or slack: more that a bias and two bounds can say.
#pragma once

#include "chapters/06_sequential_impulse/program/scene_machines.hpp"

namespace rigid {

/// Discs on a belt, each dragged with no more than a force, towards a wall.
class BeltRun : public MachineRun {
public:
    BeltRun()
    {
        scene_.bodies = Bodies<2>(3);
        scene_.radius = VecX::Constant(3, 0.1);
        for (Index k = 0; k < 3; ++k)
            scene_.bodies.position(k) = Vec2(-1.2 + 0.3 * static_cast<Real>(k), 0.1);
        scene_.walls = {{{0, 1}, 0}, {{-1, 0}, -1.2}};
    }
    std::vector<Real> measure() const override
    {
        return {scene_.bodies.u[0], scene_.bodies.u[2], scene_.bodies.u[4],
                force_of(0),        force_of(1),        force_of(2)};
    }
    void draw(Canvas& canvas) const override
    {
        canvas.segment({-1.5, 0}, {1.2, 0}, paint::wall);
        canvas.segment({1.2, 0}, {1.2, 0.6}, paint::wall);
        for (Real x = -1.5 + std::fmod(speed_ * t(), 0.2); x < 1.2; x += 0.2)
            canvas.segment({x, 0}, {x - 0.05, -0.06}, paint::grid);
        for (Index k = 0; k < 3; ++k) {
            const Vec2 p = scene_.bodies.position(k);
            canvas.disc(p, 0.1, paint::body);
            const Real drag = force_of(static_cast<std::size_t>(k));
            if (std::abs(drag) > 0.01)
                canvas.arrow(p - Vec2(0, 0.1), p + Vec2(0.15 * drag, -0.1),
                             {Colour::green, 2.5, 1, false, false});
        }
        canvas.text({-1.5, 0.7}, "belt " + significant(speed_, 3) + " m/s; green: its force on each disc", 14,
                    paint::label);
    }

private:
    void add_joints(const Settings& settings) override
    {
        speed_ = settings["speed"];
        for (Index k = 0; k < 3; ++k)
            scene_.joints.push_back({Joint::Kind::motor, world, k, Vec2(1, 0), 0, speed_, settings["force"]});
    }
    Real speed_ = 0;
};

inline Demo belt_scene()
{
    Demo scene =
        machine_scene("belt", "A belt drags three discs with a limited force until a wall stops them");
    scene.view = {{-0.15, 0.3}, {1.5, 0.6}};
    scene.tunables.push_back({"speed", "m/s", "of the belt", 1, -2, 2, false, false, true});
    scene.tunables.push_back({"force", "N", "on each disc, at most", 1, 0, 10, false, false, false});
    scene.columns = {{"speed_1", "m/s", "of the first disc", true, false},
                     {"speed_2", "m/s", "of the second", true, false},
                     {"speed_3", "m/s", "of the third", true, false},
                     {"force_1", "N", "of the belt on the first disc", true, false},
                     {"force_2", "N", "of the belt on the second", true, false},
                     {"force_3", "N", "of the belt on the third", true, false}};
    scene.start = [](const Settings&) { return std::make_unique<BeltRun>(); };
    return scene;
}

/// A disc on a rope: it flies free while the rope is slack.
class RopeRun : public MachineRun {
public:
    explicit RopeRun(const Settings& settings)
    {
        scene_ = hanging_chain(1);
        scene_.links.clear();
        scene_.linked = PairSet::all();  // the disc flies past its pivot
        scene_.radius << 0.03, 0.1;
        scene_.bodies.position(1) = Vec2(-0.5, 0.2);
        scene_.bodies.velocity(1) = Vec2(settings["throw"], 1);
    }
    std::vector<Real> measure() const override
    {
        const Real distance = (scene_.bodies.position(1) - scene_.bodies.position(0)).norm();
        return {length - distance, force_of(0), scene_.bodies.x[2], scene_.bodies.x[3],
                kinetic_energy(scene_.bodies) + potential_energy(scene_.bodies, scene_.gravity)};
    }
    void draw(Canvas& canvas) const override
    {
        std::vector<Vec2> circle;
        for (int i = 0; i <= 90; ++i)
            circle.push_back(length * Vec2(std::cos(pi * i / 45), std::sin(pi * i / 45)));
        canvas.polyline(circle, paint::grid);
        const Vec2 p = scene_.bodies.position(1);
        const bool taut = force_of(0) > 0;
        canvas.segment({0, 0}, p, {taut ? Colour::red : Colour::faint, taut ? 2.5 : 1.5, 1, false, !taut});
        canvas.polyline(trail_, {Colour::blue, 1, 0.6, false, false});
        canvas.disc({0, 0}, 0.03, paint::fixed_body);
        canvas.disc(p, 0.1, paint::body);
        canvas.text({-1.25, 1.1}, taut ? "taut: " + significant(force_of(0), 3) + " N" : "slack", 15,
                    paint::label);
    }

private:
    static constexpr Real length = 1;

    void add_joints(const Settings&) override
    {
        scene_.joints = {{Joint::Kind::rope, 0, 1, Vec2(0, 1), length, 0, 0}};
        trail_.push_back(scene_.bodies.position(1));
        if (trail_.size() > 600) trail_.erase(trail_.begin());
    }
    std::vector<Vec2> trail_;
};

inline Demo rope_scene()
{
    Demo scene =
        machine_scene("rope", "A disc on a rope: free while it is slack, on the circle while it is taut");
    scene.view = {{0, 0}, {1.35, 1.3}};
    scene.h = 1.0 / 240;
    scene.tunables.push_back({"throw", "m/s", "to the right, at the beginning", 2, -4, 4, false, true, true});
    scene.columns = {{"slack", "m", "length of the rope less the distance", true, false},
                     {"tension", "N", "of the rope", true, false},
                     {"x", "m", "of the disc", false, false},
                     {"y", "m", "of the disc", true, false},
                     {"energy", "J", "kinetic energy and that of the weight", true, false}};
    scene.start = [](const Settings& settings) { return std::make_unique<RopeRun>(settings); };
    return scene;
}

}  // namespace rigid
