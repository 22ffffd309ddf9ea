/// \file random_definitions.hpp
/// Numbers, bodies, joints and settings for the attack on the engine, kind by kind.
#pragma once

#include "chapters/14_joints/joint_rows.hpp"
#include "chapters/19_engine/world_scenes.hpp"
#include "common/random.hpp"

#include <limits>
#include <string>
#include <string_view>

namespace rigid::properties {

inline constexpr std::string_view world_kinds[] = {
    "come and go",     // bodies, joints and blows at any time
    "powers of ten",   // masses, speeds and stiffness of up to 10^±150
    "any number",      // NaN, ∞, 0, negative, denormal, the largest: for every member of every definition
    "joined",          // chains and rings of all kinds of joints, mass ratios of up to 10^12
    "in one another",  // bodies that begin at one place, on edges, with any settings
};
inline constexpr Index world_kind_count = static_cast<Index>(std::size(world_kinds));

struct WorldTally {
    std::int64_t worlds = 0, steps = 0, refused = 0, held = 0, unsolved = 0, loaded = 0;
};

/// What a world is made of. All of it is drawn from one generator, in a fixed order.
class RandomDefinitions {
public:
    RandomDefinitions(Index kind, Random& random, WorldTally& tally)
        : kind_(kind), random_(random), tally_(tally)
    {
    }

protected:
    // ---- numbers ------------------------------------------------------------------------------------
    bool one_of(Index count) { return random_.index(count) == 0; }
    Real power(Real low, Real high) { return pow(10, random_.uniform(low, high)); }
    Real any()
    {
        constexpr Real list[] = {std::numeric_limits<Real>::quiet_NaN(),
                                 infinity,
                                 -infinity,
                                 0,
                                 -0.0,
                                 -1,
                                 std::numeric_limits<Real>::denorm_min(),
                                 std::numeric_limits<Real>::min(),
                                 std::numeric_limits<Real>::max(),
                                 -std::numeric_limits<Real>::max(),
                                 1e150,
                                 -1e150,
                                 1e-150,
                                 1e75,
                                 1e-20,
                                 1e20};
        const Index which = random_.index(24);
        const Real other = (which % 2 ? 1 : -1) * power(-9, 9);
        return which < 16 ? list[which] : other;
    }
    /// A number that makes sense, or in the kind "any number" now and then any.
    Real or_any(Real sane)
    {
        const bool it = kind_ == 2 && one_of(24);
        return it ? any() : sane;
    }
    Vec2 place(Real wide = 2)
    {
        const Real x = random_.uniform(-wide, wide), y = random_.uniform(-0.5, 3);
        const Real px = or_any(x), py = or_any(y);
        return {px, py};
    }
    Vec2 along(Real angle, Real length) { return {length * cos(angle), length * sin(angle)}; }

    // ---- things -------------------------------------------------------------------------------------
    WorldSettings some_settings()
    {
        WorldSettings s;
        const Index solving = random_.index(5);
        s.solving = solving < 3 ? Solving::by_island : static_cast<Solving>(solving - 2);
        s.substeps = 1 + static_cast<int>(random_.index(3));
        s.sleep = !one_of(4);
        s.stop_fast = !one_of(4);
        wild_ = random_.uniform(0, 150);
        if (kind_ < 2) return s;
        if (one_of(4)) s.sweeps = 1 + static_cast<int>(random_.index(100));
        if (one_of(4)) s.most_exact = static_cast<int>(random_.index(40));
        if (one_of(4)) s.length = power(-3, 3);
        if (one_of(4)) s.margin = power(-6, 1);
        if (one_of(4)) s.slop = power(-9, 0);
        if (one_of(4)) s.tolerance = power(-12, 0);
        const Real down = random_.uniform(0, 7);
        if (one_of(4)) s.gravity = along(down, power(-3, 4));
        for (Real* const number :
             {&s.length, &s.margin, &s.slop, &s.tolerance, &s.rest.speed, &s.rest.acceleration, &s.rest.time,
              &s.hit_speed, &s.gravity.x(), &s.gravity.y()})
            *number = or_any(*number);
        try {
            require_valid(s);
        } catch (const std::invalid_argument&) {
            ++tally_.refused;
            return {};
        }
        return s;
    }
    Polygon some_shape(Real size)
    {
        switch (random_.index(kind_ == 2 ? 6 : 5)) {
        case 0:
            return disc(size);
        case 1:
            return capsule(size, 0.3 * size);
        case 2:
            return box(size, (one_of(4) ? 0.002 : 0.2) * size);
        case 3:
            return box(size, size, 0.1 * size);
        case 4: {
            Polygon shape;
            const Index corners = 3 + random_.index(6);
            const Real from = random_.uniform(0, 7);
            for (Index i = 0; i < corners; ++i)
                shape.vertices.push_back(
                    along(from + 2 * pi * static_cast<Real>(i) / static_cast<Real>(corners), size));
            return shape;
        }
        default: {
            Polygon shape;
            const Index corners = random_.index(6);
            for (Index i = 0; i < corners; ++i) shape.vertices.push_back(place(size));
            shape.radius = or_any(random_.uniform(0, 0.2));
            return shape;
        }
        }
    }
    BodyDefinition some_body()
    {
        BodyDefinition body;
        body.shape = some_shape(kind_ == 0 ? power(-2.5, 1) : kind_ == 1 ? power(-1.5, 0.5) : power(-1.5, 0));
        body.position = kind_ == 4 && !one_of(3) ? Vec2(0, 0.5) : place();
        body.angle = or_any(kind_ == 4 && one_of(2) ? 0 : random_.uniform(-7, 7));
        body.density = or_any(one_of(8)    ? 0
                              : kind_ == 1 ? power(-wild_, wild_)
                              : kind_ == 3 ? power(-6, 6)
                                           : power(-4, 4));
        const bool fast = one_of(4);
        const Real speed = kind_ == 1   ? power(-2, fast ? 2 * wild_ : 3)
                           : kind_ == 0 ? power(-2, 3)
                                        : power(-2, fast ? 3 : 0.5);
        body.velocity = along(random_.uniform(0, 7), speed);
        const Real spin = kind_ == 1 ? power(0, fast ? 2 * wild_ : 2) : power(-2, 2);
        body.spin = one_of(2) ? spin : -spin;
        Surface& surface = body.surface;
        surface.friction = one_of(6) ? power(-3, 3) : random_.uniform(0, 1.5);
        surface.restitution = one_of(2) ? 0 : random_.uniform();
        if (one_of(6)) surface.belt = random_.uniform(-5, 5);
        if (one_of(6)) surface.rolling = power(-4, 0);
        for (Real* const number : {&body.velocity.x(), &body.velocity.y(), &body.spin, &surface.friction,
                                   &surface.restitution, &surface.belt, &surface.rolling})
            *number = or_any(*number);
        if (kind_ == 2 && one_of(6)) {
            Mass mass;
            mass.mass = or_any(power(-3, 3));
            mass.inertia = or_any(power(-3, 3));
            mass.centroid = place(0.1);
            body.mass = mass;
        }
        body.bullet = one_of(6);
        body.sensor = one_of(16);
        if (body.sensor && !one_of(8)) body.density = 0, body.mass.reset();
        if (one_of(6))
            body.filter = {1u << random_.index(3), 7, static_cast<std::int32_t>(random_.index(3)) - 1};
        return body;
    }
    /// What a body has besides its first shape.
    std::vector<ShapeDefinition> some_shapes()
    {
        std::vector<ShapeDefinition> more(static_cast<std::size_t>(1 + random_.index(3)));
        for (ShapeDefinition& it : more) {
            it.shape = some_shape(power(-1.5, 0));
            const Vec2 by = along(random_.uniform(0, 7), power(-2, 0.5));
            for (Vec2& vertex : it.shape.vertices) vertex += by;
            if (one_of(3)) it.density = or_any(one_of(4) ? 0 : power(-4, 4));
            it.surface = {or_any(random_.uniform(0, 1.5)), or_any(random_.uniform()), 0, 0};
            it.sensor = one_of(10);
            if (one_of(6)) it.filter = {1u << random_.index(3), 7, 0};
        }
        return more;
    }
    JointKind some_joint_kind() { return static_cast<JointKind>(random_.index(joint_kind_count)); }
    /// The rest of a joint that has its kind and its points.
    void fill_in(RigidJoint& joint)
    {
        const JointKind kind = joint.kind;
        const Real stiff = kind_ == 1 ? power(-wild_, 2 * wild_) : power(-3, 6);
        if (kind == JointKind::distance || kind == JointKind::rope || kind == JointKind::pulley || one_of(8))
            joint.length = random_.uniform(0, 3);
        joint.ratio = one_of(4) ? -power(-3, 3) : 1;
        joint.over_a = place(), joint.over_b = place();
        const bool can = has_coordinate(kind) || one_of(20);
        if (can && one_of(2))
            joint.lower = -random_.uniform(), joint.upper = one_of(5) ? joint.lower : random_.uniform();
        if (can && one_of(3)) joint.motor.force = stiff, joint.motor.speed = random_.uniform(-30, 30);
        const bool poses = kind == JointKind::mouse || kind == JointKind::motor;
        if (poses || kind == JointKind::wheel || (can && one_of(3)))
            joint.spring = {0, one_of(2) ? stiff : 0, stiff, one_of(2) ? 0 : power(-3, 4),
                            random_.uniform(-1, 1)};
        if (poses) joint.spring.target = 0;
        if (kind == JointKind::friction || kind == JointKind::motor) joint.torque = stiff;
        if (kind == JointKind::friction) joint.motor.force = stiff;
        if (one_of(8)) joint.breaking_force = power(-2, 5);
        if (one_of(8)) joint.breaking_torque = power(-2, 5);
        joint.collide_connected = one_of(3);
        for (Real* const number :
             {&joint.at_a.x(), &joint.at_b.y(), &joint.axis.x(), &joint.angle, &joint.length, &joint.ratio,
              &joint.over_a.x(), &joint.over_b.y(), &joint.lower, &joint.upper, &joint.motor.speed,
              &joint.motor.force, &joint.spring.force, &joint.spring.stiffness, &joint.spring.damping,
              &joint.spring.target, &joint.torque, &joint.breaking_force, &joint.breaking_torque})
            *number = or_any(*number);
    }

    Index kind_;
    Random& random_;
    WorldTally& tally_;

private:
    Real wild_ = 0;  ///< powers of ten
};

}  // namespace rigid::properties
