/// Chapter 19: each field of each public definition is turned, and what should move does, the way that it should.

#include "chapters/19_engine/world.hpp"

#include "tests/catch.hpp"
#include "tests/world_run.hpp"

#include <algorithm>
#include <functional>

using namespace rigid;

namespace each_field {  // sources of one target are compiled together

namespace {

using worlds::frame;
using worlds::run;
using Turn = std::function<void(BodyDefinition&)>;

/// A box that slides on a floor; what is turned is turned on the box.
struct Slide {
    World engine;
    BodyId box_;
    Real top = 0;

    explicit Slide(const Turn& turn, const WorldSettings& settings = {},
                   const Surface& floor = {0.5, 0, 0, 0})
        : engine(settings)
    {
        engine.add_wall({{0, 1}, 0}, floor);
        BodyDefinition body;
        body.shape = box(0.6, 0.4);
        body.position = {0, 0.2};
        body.velocity = {2, 0};
        body.surface = {0.5, 0, 0, 0};
        turn(body);
        box_ = engine.add_body(body);
        for (int n = 0; n < 60; ++n) {
            engine.step(frame);
            top = std::max(top, engine.position(box_).y());
        }
    }
    Vec2 at() const { return engine.position(box_); }
};
const Turn none = [](BodyDefinition&) {};

/// A rod on a pin at the origin, level, with whatever the joint has besides.
struct Hung {
    World engine;
    BodyId rod;
    JointId joint;
    Real top_spin = 0;
    bool broke = false;

    explicit Hung(const std::function<void(RigidJoint&)>& turn, JointKind kind = JointKind::revolute,
                  int steps = 60)
    {
        BodyDefinition body;
        body.shape = capsule(0.8, 0.1);
        body.position = {0.5, 0};
        rod = engine.add_body(body);
        RigidJoint how = engine.joint_at(kind, {}, rod, {0, 0});
        if (kind == JointKind::distance || kind == JointKind::rope) {
            how = RigidJoint{};
            how.kind = kind;
            how.length = 0.5;
        }
        turn(how);
        joint = engine.add_joint({}, rod, how);
        for (int n = 0; n < steps; ++n) {
            engine.step(frame);
            top_spin = std::max(top_spin, std::abs(engine.spin(rod)));
            broke = broke || !engine.events().broken.empty();
        }
    }
    Vec2 at() const { return engine.position(rod); }
};
const std::function<void(RigidJoint&)> as_it_is = [](RigidJoint&) {};

}  // namespace

TEST_CASE("each field of a surface does what it says", "[idea]")
{
    const Real far = Slide(none).at().x();
    CHECK(far == Approx(0.4).margin(0.05));  // v²/2μg = 0.41 m
    CHECK(Slide([](auto& b) { b.surface.friction = 0.1; }).at().x() > far + 0.2);
    CHECK_THROWS_AS(Slide([](auto& b) { b.surface.kinetic = 0.05; }),
                    std::invalid_argument);                       // a world has one μ
    CHECK(Slide(none, {}, {0.5, 0, 1, 0}).at().x() < far - 0.3);  // a floor's belt runs to the left
    const Turn drop = [](BodyDefinition& b) { b.position = {0, 1.2}, b.velocity = {0, 0}; };
    const auto after = [&](Real e) {
        Slide it([&](BodyDefinition& b) { drop(b), b.surface.restitution = e; });
        return it.engine.velocity(it.box_).y();
    };
    CHECK(after(0) == Approx(0).margin(1e-9));
    CHECK(std::abs(after(0.9)) > 1);
    const auto rolls = [](Real arm) {
        Slide it([&](BodyDefinition& b) { b.shape = disc(0.2), b.spin = -10, b.surface.rolling = arm; });
        return it.at().x();
    };
    CHECK(rolls(0) == Approx(2).margin(0.01));
    CHECK(rolls(0.05) < 1.5);
}

TEST_CASE("each field of a body does what it says", "[idea]")
{
    const Slide plain(none);
    CHECK(Slide([](auto& b) { b.position = {1, 0.2}; }).at().x() == Approx(plain.at().x() + 1).margin(1e-9));
    CHECK(Slide([](auto& b) { b.velocity = {-2, 0}; }).at().x() == Approx(-plain.at().x()).margin(1e-9));
    CHECK(Slide([](auto& b) { b.angle = pi / 2, b.position.y() = 0.3; }).at().y() ==
          Approx(0.3).margin(0.01));
    CHECK(Slide([](auto& b) { b.position.y() = 1, b.spin = 3; }).engine.angle(plain.box_) !=
          plain.engine.angle(plain.box_));
    CHECK(Slide([](auto& b) { b.shape = box(0.6, 0.6), b.position.y() = 0.3; }).at().y() ==
          Approx(0.3).margin(0.01));
    CHECK(Slide([](auto& b) { b.density = 7; }).engine.mass(plain.box_) == Approx(7 * 0.24));
    CHECK(Slide([](auto& b) { b.mass = Mass{3, {0, 0}, 5}; }).engine.inertia(plain.box_) == Approx(5));
    CHECK(Slide([](auto& b) { b.user = 42; }).engine.user(plain.box_) == 42);
    const Slide driven([](auto& b) { b.density = 0; });
    CHECK(driven.at().x() == Approx(2).margin(1e-9));  // nothing pushes it, and it goes on

    // a second body above the first: filters
    const auto lies_on_it = [](const Filter& below, const Filter& above) {
        World engine;
        engine.add_wall({{0, 1}, 0});
        BodyDefinition body;
        body.position = {0, 0.5}, body.filter = below;
        engine.add_body(body);
        body.position = {0, 1.6}, body.filter = above;
        const BodyId it = engine.add_body(body);
        run(engine, 60);
        return engine.position(it).y() > 1.4;
    };
    CHECK(lies_on_it({}, {}));
    CHECK_FALSE(lies_on_it({2, 0xffff'ffff, 0}, {1, 1, 0}));
    CHECK_FALSE(lies_on_it({1, 0xffff'ffff, -3}, {1, 0xffff'ffff, -3}));
    CHECK(lies_on_it({2, 0, 3}, {1, 0, 3}));

    // a sensor reports and pushes nothing; a bullet is stopped though the world stops nothing
    const auto through = [](bool stop, bool bullet, bool sensor) {
        World engine({.gravity = {0, 0}, .stop_fast = stop});
        BodyDefinition plate;
        plate.shape = box(0.1, 2), plate.position = {3, 0}, plate.density = 0, plate.sensor = sensor;
        const BodyId it = engine.add_body(plate);
        BodyDefinition shot;
        shot.shape = disc(0.05), shot.velocity = {400, 0}, shot.bullet = bullet;
        if (sensor) shot.velocity = {3, 0};
        const BodyId ball = engine.add_body(shot);
        bool seen = false;
        for (int n = 0; n < 90; ++n) {
            engine.step(frame);
            for (const Seen& one : engine.events().entered)
                seen = seen || (one.sensor == it && one.body == ball);
        }
        return std::pair{engine.position(ball).x() > 3.2, seen};
    };
    CHECK(through(false, false, false).first);
    CHECK_FALSE(through(false, true, false).first);
    CHECK_FALSE(through(true, false, false).first);
    CHECK(through(true, false, true) == std::pair{true, true});
}

TEST_CASE("each setting of a world does what it says", "[idea]")
{
    const auto slid = [](const WorldSettings& settings) {
        Slide it([](BodyDefinition& b) { b.position.y() = 0.6; }, settings);
        return it;
    };
    WorldSettings turned;
    turned.gravity = {0, -1};
    CHECK(slid(turned).at().x() > slid({}).at().x() + 0.1);
    turned = {}, turned.substeps = 4;
    CHECK(slid(turned).engine.hash() != slid({}).engine.hash());
    // what overlaps by less than the slop stays so, but for a 200th of the inner radius; lengths are measured in ℓ
    const auto rises = [](Real slop, Real length) {
        WorldSettings settings;
        settings.slop = slop, settings.length = length;
        return Slide(
                   [](BodyDefinition& b) {
                       b.position.y() = 0.1992, b.velocity = {0, 0};
                   },
                   settings)
            .at()
            .y();
    };
    CHECK(rises(0.005, 1) == Approx(0.1992).margin(1e-6));
    CHECK(rises(1e-4, 1) > 0.1998);
    CHECK(rises(1e-4, 10) == Approx(0.1992).margin(1e-6));
    const auto asleep_after = [](const WorldSettings& settings) {
        World engine(settings);
        engine.add_wall({{0, 1}, 0});
        BodyDefinition body;
        body.position = {0, 0.5};
        const BodyId it = engine.add_body(body);
        engine.step(frame);
        CHECK(engine.is_awake(it) != settings.sleep);
        engine.wake(it);
        int n = 0;
        while (n < 300 && (n == 0 || engine.is_awake(it))) engine.step(frame), ++n;
        return n;
    };
    const int asleep = asleep_after({});
    CHECK(asleep == 31);  // half a second
    turned = {}, turned.sleep = false;
    CHECK(asleep_after(turned) == 300);
    turned = {}, turned.rest.time = 2;
    CHECK(asleep_after(turned) > asleep + 60);
    const auto rolls_for =
        [](const WorldSettings& settings) {  // a disc that is slowed down by 0.02 m/s² and rad/s²
            Slide it(
                [&](BodyDefinition& b) {
                    b.shape = disc(1), b.position.y() = 1, b.velocity = {0.06, 0}, b.spin = -0.06,
                    b.surface.rolling = 0.003;
                },
                settings);
            int n = 0;
            while (n < 600 && it.engine.is_awake(it.box_)) it.engine.step(frame), ++n;
            return n;
        };
    turned = {}, turned.rest.speed = 0.05, turned.rest.acceleration = 0.04;
    const int soon = rolls_for(turned);
    turned.rest.speed = 1e-3;
    CHECK(rolls_for(turned) > soon + 30);
    turned.rest.speed = 0.05, turned.rest.acceleration = 0.02;
    CHECK(rolls_for(turned) > soon + 30);

    const auto work_of = [](const WorldSettings& settings) {  // a column that was put down
        World engine(settings);
        engine.add_wall({{0, 1}, 0});
        for (int i = 0; i < 12; ++i) {
            BodyDefinition body;
            body.position = {0.01 * (i % 2), 0.5 + 1.001 * i};
            engine.add_body(body);
        }
        StepWork most;
        for (int n = 0; n < 20; ++n) {
            engine.step(frame);
            const StepWork& now = engine.work();
            most.exact = std::max(most.exact, now.exact), most.swept = std::max(most.swept, now.swept);
            most.sweeps = std::max(most.sweeps, now.sweeps),
            most.contacts = std::max(most.contacts, now.contacts);
            most.residual = std::max(most.residual, now.residual);
        }
        return most;
    };
    turned = {}, turned.solving = Solving::exact;
    CHECK(work_of(turned).exact == 1);
    turned = {}, turned.solving = Solving::sweeps;
    CHECK(work_of(turned).swept == 1);
    const StepWork sixty = work_of(turned);
    turned.sweeps = 7;
    CHECK(work_of(turned).sweeps == 7);
    CHECK(work_of(turned).residual > sixty.residual);
    turned.sweeps = 5000;
    const int fine = work_of(turned).sweeps;
    turned.tolerance = 1e-2;
    CHECK(work_of(turned).sweeps < fine);
    turned = {}, turned.solving = Solving::exact, turned.most_exact = 4;
    CHECK(work_of(turned).exact == 0);

    const auto hits = [](Real speed) {
        World engine({.hit_speed = speed});
        engine.add_wall({{0, 1}, 0});
        BodyDefinition body;
        body.position = {0, 1.5};
        engine.add_body(body);
        std::size_t sum = 0;
        for (int n = 0; n < 60; ++n) engine.step(frame), sum += engine.events().hits.size();
        return sum;
    };
    CHECK(hits(1) == 1);
    CHECK(hits(10) == 0);
    const auto near = [](Real margin) {  // a body that hovers 5 cm above the floor has a contact, or none
        World engine({.gravity = {0, 0}, .margin = margin});
        engine.add_wall({{0, 1}, 0});
        BodyDefinition body;
        body.position = {0, 0.55};
        engine.add_body(body);
        engine.step(frame);
        return engine.work().contacts;
    };
    CHECK(near(0.02) == 0);
    CHECK(near(0.1) == 2);
}

TEST_CASE("each field of a joint does what it says", "[idea]")
{
    const Hung plain(as_it_is);
    CHECK(plain.at().norm() == Approx(0.5).margin(1e-6));
    Hung held([](RigidJoint& j) { j.lower = -0.3; });
    CHECK(held.engine.angle(held.rod) > -0.32);
    CHECK(plain.engine.angle(plain.rod) < -0.5);
    Hung raised([](RigidJoint& j) { j.motor = {.speed = 1, .force = 100}; });
    CHECK(raised.engine.angle(raised.rod) == Approx(1).margin(0.05));
    Hung weak([](RigidJoint& j) { j.motor = {.speed = 1, .force = 0.01}; });
    CHECK(weak.engine.angle(weak.rod) < -0.3);
    Hung other([](RigidJoint& j) { j.upper = 0.2, j.motor = {.speed = 1, .force = 100}; });
    CHECK(other.engine.angle(other.rod) == Approx(0.2).margin(0.01));
    const auto sprung = [](Real stiffness, Real damping, Real target, Real force) {
        return Hung([=](RigidJoint& j) {
            j.spring = {.force = force, .stiffness = stiffness, .damping = damping, .target = target};
        });
    };
    const Real soft = sprung(20, 5, 0, 0).engine.angle(plain.rod);
    CHECK(sprung(200, 5, 0, 0).engine.angle(plain.rod) > soft + 0.01);
    CHECK(sprung(20, 5, 0.5, 0).engine.angle(plain.rod) > soft + 0.3);
    CHECK(sprung(20, 5, 0, 0.05).engine.angle(plain.rod) < soft - 0.1);
    CHECK(sprung(20, 0, 0, 0).top_spin > sprung(20, 20, 0, 0).top_spin);
    Hung turned([](RigidJoint& j) { j.angle = 0.4, j.lower = 0; });  // its zero is elsewhere
    CHECK(turned.engine.coordinate(turned.joint) == Approx(0).margin(0.02));
    CHECK(Hung([](RigidJoint& j) { j.breaking_force = 0.5; }).broke);
    CHECK_FALSE(plain.broke);
    CHECK(Hung([](RigidJoint& j) { j.breaking_torque = 0.01; }, JointKind::weld).broke);
    CHECK(Hung([](RigidJoint& j) { j.at_a = {0, 1}; }).at().y() > plain.at().y());
    CHECK(std::abs(Hung([](RigidJoint& j) { j.at_b = {0.2, 0}; }).at().norm() - 0.5) > 0.1);

    Hung line(as_it_is, JointKind::distance),
        longer([](RigidJoint&j) { j.length = 0.8; }, JointKind::distance);
    CHECK(line.at().norm() == Approx(0.5).margin(1e-6));
    CHECK(longer.at().norm() == Approx(0.8).margin(1e-6));
    Hung rope([](RigidJoint& j) { j.length = 2; }, JointKind::rope, 20);
    CHECK(rope.at().x() == Approx(0.5).margin(1e-6));  // slack: it falls
    CHECK(rope.at().y() < -0.3);
    Hung rail([](RigidJoint& j) { j.axis = {0, -1}; }, JointKind::prismatic, 30);
    CHECK(rail.at().y() < -1);
    CHECK(rail.at().x() == Approx(0.5).margin(1e-6));
    Hung flat(as_it_is, JointKind::prismatic, 30);
    CHECK(flat.at().y() == Approx(0).margin(1e-6));
    Hung friction([](RigidJoint& j) { j.motor.force = 100, j.torque = 100; }, JointKind::friction);
    CHECK(friction.at().y() == Approx(0).margin(1e-3));
    Hung little([](RigidJoint& j) { j.motor.force = 100, j.torque = 0.01; }, JointKind::friction);
    CHECK(little.engine.angle(little.rod) < -0.1);

    // may two that are joined touch?
    const auto folded = [](bool collide) {
        World engine({.gravity = {0, 0}});
        BodyDefinition body;
        body.shape = box(1, 0.2), body.density = 0;
        const BodyId a = engine.add_body(body);
        body.position = {0.5, 0.25}, body.density = 1, body.spin = -3, body.velocity = {0, -1.5};
        const BodyId b = engine.add_body(body);
        RigidJoint pin = engine.joint_at(JointKind::revolute, a, b, {0, 0.25});
        pin.collide_connected = collide;
        engine.add_joint(a, b, pin);
        run(engine, 60);
        return engine.angle(b);
    };
    CHECK(folded(false) == Approx(-3).margin(0.1));
    CHECK(folded(true) > -0.5);

    const auto geared = [](Real ratio) {
        World engine({.gravity = {0, 0}});
        BodyDefinition wheel;
        wheel.shape = disc(0.3), wheel.spin = 2;
        const BodyId a = engine.add_body(wheel);
        wheel.position = {1, 0}, wheel.spin = 0;
        const BodyId b = engine.add_body(wheel);
        for (const BodyId it : {a, b})
            engine.add_joint({}, it, engine.joint_at(JointKind::revolute, {}, it, engine.position(it)));
        engine.add_joint(a, b, {.kind = JointKind::gear, .ratio = ratio});
        run(engine, 10);
        return engine.spin(a) / engine.spin(b);
    };
    CHECK(geared(1) == Approx(-1).margin(1e-6));
    CHECK(geared(2) == Approx(-2).margin(1e-6));
}

}  // namespace each_field
