/// \file rigid_scene.hpp
/// A scene of bodies that turn: where each is, its shape, what joins them, and walls.
///
/// A body's position is that of its centroid and its angle, (x, y, θ); its velocity is (v, ω). So the third number of
/// its inverse mass is 1/I [1/(kg m²)].
#pragma once

#include "chapters/02_velocity_constraints/constraint_kinds.hpp"
#include "chapters/11_rotation/polygon.hpp"
#include "common/elementary.hpp"
#include "common/shapes.hpp"
#include "common/typical_length.hpp"

#include <cstdint>
#include <vector>

namespace rigid {

/// One scalar constraint on points fixed in two bodies, or in the world and a body.
struct PointJoint {
    enum class Measure : unsigned char {
        distance,  ///< ‖p_b − p_a‖: a link, a rope
        /// n·(p_b − p_a), n fixed in the world: one half of a pin, a rail, a motor
        /// that pushes
        along,
        /// the same, with n fixed in body a and turning with it: a slider on a body
        turning,
        angle,  ///< gear_a θ_a + gear_b θ_b: a weld, gears, a motor that turns
        /// gear_a ‖p_a − q_a‖ + gear_b ‖p_b − q_b‖: a rope over two points of the
        /// world
        pulley,
        /// gear_a (θ_a − θ_b) + gear_b n·(p_b − p_a), n fixed in body b and turning
        /// with it: a rack, b, on a pinion around p_a
        rack,
    };
    Measure measure = Measure::distance;
    Index a = world, b = 0;
    Vec2 at_a = {0, 0},
         /// the points, from the centroid in the body's own axes; of the world: in
        /// its
        at_b = {0, 0};
    Vec2 direction = {1, 0};  ///< n, a unit vector, of along, turning, rack
    /// of angle: pure numbers [C is an angle], or radii [C is an arc]
    Real gear_a = -1, gear_b = 1;
    /// C is zero where what is measured is this [m, rad]
    Real length = 0;
    /// −1: C is what is left to the length, not what is beyond it
    Real sense = 1;
    ConstraintKind kind = ConstraintKind::bilateral;
    /// of a motor [m/s, N], or [rad/s, N m]; the force also of a spring, 0 = any
    Real speed = 0, force = 0;
    /// of a spring [N/m, N s/m], or [N m, N m s]
    Real stiffness = 0, damping = 0;
    Vec2 over_a = {0, 0}, over_b = {0, 0};  ///< q_a, q_b of a pulley, of the world
    bool collides = false;  ///< what it joins may touch (chapter 12)
};

/// Bodies `first` to `last` are the edges of one line, each beginning where the one before it ends: solid to the left,
/// open to the right, as the outline of a polygon is (chapter 12).
struct Chain {
    Index first = 0, last = 0;
    bool closed = false;  ///< the last one ends where the first one begins

    bool operator==(const Chain&) const = default;
};

/// The sine and the cosine of each body's angle, found once while it stays the same: with the bits of sin() and cos().
class Turns {
public:
    SineAndCosine of(Index k, Real angle)
    {
        const auto at = static_cast<std::size_t>(k);
        if (at >= known_.size()) known_.resize(at + 1);
        Known& here = known_[at];
        if (bits(here.angle) != bits(angle))  // of −0 as well, whose sine is −0
            here = {angle, sine_and_cosine(angle)};
        return here.turn;
    }

private:
    struct Known {
        Real angle = 0;
        SineAndCosine turn = {0, 1};
    };
    static std::uint64_t bits(Real angle)
    {
        return Eigen::numext::bit_cast<std::uint64_t>(angle);
    }
    std::vector<Known> known_;
};

/// The shape of a body that has several (chapter 19). Each has the number of a body of its own, which is where the body is
/// whose shape it is, and which nothing else is asked of.
struct CarriedShape {
    Index carrier = 0;     ///< the body
    Index next = 0;        ///< its next shape; after the last one itself
    Vec2 middle = {0, 0};  ///< the centroid of the shape, in the body's axes [m]
    bool pushes = true;    ///< false: nothing touches it
};

struct RigidScene {
    static constexpr int dof = 3;
    Bodies<3> bodies{0};
    /// one to a body, in its own axes, its centroid at (0, 0)
    std::vector<Polygon> shapes;
    /// one to each of them; empty = no body has another shape
    std::vector<CarriedShape> carried;
    std::vector<PointJoint> joints;
    std::vector<HalfSpace> walls;
    std::vector<Chain> chains;
    Vec2 gravity = {0, -9.81};  ///< [m/s²]
    /// the length that settings are measured in [m]; 0 = typical_length()
    Real length = 0;
    mutable Turns turns;  ///< memory of its joints and shapes

    /// The body that shape k is of.
    Index carrier(Index k) const
    {
        return carried.empty() || k == world
                   ? k
                   : carried[static_cast<std::size_t>(k)].carrier;
    }
    /// Whether shape k may touch something, if its body can move.
    bool pushes(Index k) const
    {
        return carried.empty() || carried[static_cast<std::size_t>(k)].pushes;
    }
    /// Calls visit(number) for the shapes of body k, its own first.
    template <class Visit>
    void for_each_shape(Index k, const Visit& visit) const
    {
        Index shape = k;
        do {
            visit(shape);
            if (carried.empty()) return;
            shape = carried[static_cast<std::size_t>(shape)].next;
        } while (shape != k);
    }
};

/// ℓ, the length that settings are measured in (chapter 3).
Real typical_length(const RigidScene& scene);

/// Where a point of body k is now; a point of the world is where it is. p = x + R(θ) r
/// \param turns  memory; may be null
inline Vec2 point_of(const VecX& x, Index k, const Vec2& at, Turns* turns = nullptr)
{
    if (k == world) return at;
    const Real angle = x[3 * k + 2];
    const auto [s, c] = turns ? turns->of(k, angle) : sine_and_cosine(angle);
    return {x[3 * k] + c * at.x() - s * at.y(),
            x[3 * k + 1] + s * at.x() + c * at.y()};
}

/// Where the centroid of shape k is: that of its body, unless it has several.
inline Vec2 middle_of(const RigidScene& scene, const VecX& x, Index k)
{
    if (scene.carried.empty()) return x.segment<2>(3 * k);
    const Vec2& middle = scene.carried[static_cast<std::size_t>(k)].middle;
    return point_of(x, k, middle, &scene.turns);
}

//! [point_velocity]
/// (11.3): v + ω × r, the velocity of the point p of body k; the world has none.
inline Vec2 velocity_at(const Bodies<3>& bodies, Index k, const Vec2& p)
{
    if (k == world) return {0, 0};
    const Vec<3> motion = bodies.velocity(k);
    const Vec2 r = p - bodies.position(k).head<2>();
    return motion.head<2>() + motion[2] * perpendicular(r);
}
//! [point_velocity]

/// Adds a body whose mass is given: a thin rod, or one that cannot move (mass and inertia zero).
/// \param at     of the centroid [m]
/// \param angle  [rad]
/// \return       its number
/// Throws std::invalid_argument for a mass that is negative or not finite, for inertia without mass, for mass without
/// inertia, and for a place or a centroid that is no number.
Index add_body(RigidScene& scene, const Polygon& shape, const Mass& mass,
               const Vec2& at, Real angle = 0);

/// Adds a uniform body of the given density [kg/m²].
inline Index add_body(RigidScene& scene, const Polygon& shape, Real density,
                      const Vec2& at, Real angle = 0)
{
    return add_body(scene, shape, mass_of(shape, density), at, angle);
}

/// Adds the two rows of a pin: the point `at_a` of body a and the point `at_b` of body b stay in one place.
void add_pin(RigidScene& scene, Index a, const Vec2& at_a, Index b,
             const Vec2& at_b);

/// Adds gears that mesh: the arcs that run over the rims of a and b, of these radii, are opposite, r_a θ_a + r_b θ_b = 0.
/// Throws std::invalid_argument unless these are two bodies of the scene; only a may be the world.
void add_gears(RigidScene& scene, Index a, Real radius_a, Index b, Real radius_b);

/// Adds a motor that turns body b against a, as far as a torque of ±`torque` can.
void add_turning_motor(RigidScene& scene, Index a, Index b, Real speed,
                       Real torque);

}  // namespace rigid
