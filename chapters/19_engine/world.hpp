/// \file world.hpp
/// The engine: bodies, joints and walls that may come and go at any time, and one step for all of them.
///
///     World world;                                          // metres, kilograms, seconds; y is up
///     world.add_wall({{0, 1}, 0});
///     BodyId ball = world.add_body({.shape = disc(0.5), .position = {0, 3}});
///     for (int n = 0; n < 120; ++n) world.step(1.0 / 60);
///     world.position(ball);
///
/// The step is that of chapter 3. A world has no part in another one: two of them may step in two threads. Of one world,
/// one thread at a time may call functions; several may call those that are const after prepare_questions(). The same calls
/// give the same bits.
///
/// Each function throws std::invalid_argument, with a sentence that names the thing and the value, for an id of
/// something that is not there any more and for a number that makes no sense; then nothing has changed. Of places, angles,
/// shapes, frames and coefficients those beyond 1e75 (largest_number) make none.
#pragma once

#include "chapters/19_engine/events.hpp"

#include "common/jobs.hpp"

#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>

namespace rigid {

class Recording;

//! [world]
class World {
public:
    explicit World(const WorldSettings& settings = {});
    ~World();
    World(World&&) noexcept;
    World& operator=(World&&) noexcept;

    /// One time step. What it did is in work(), what happened in events().
    /// \param h         [s]; need not be the same each time
    /// \param listener  is told which stage begins; empty = none
    void step(Real h, const StageListener& listener = {});
    //! [world]
    /// Seconds since the beginning, and steps.
    Real time() const;
    std::int64_t steps() const;
    const WorldSettings& settings() const;
    /// All that rest wake if their rest depends on what is changed.
    void change(const WorldSettings& settings);
    const StepWork& work() const;
    const Events& events() const;

    //! [bodies]
    // ---- bodies -----------------------------------------------------------------
    /// \param more  its other shapes; their names are in shapes()
    BodyId add_body(const BodyDefinition& definition,
                    std::span<const ShapeDefinition> more = {});
    /// Edges from each point to the next, solid to the left, that nothing catches on;
    /// they cannot move. Returns the first; to remove one is to remove all.
    /// \param closed  the last point is joined to the first
    BodyId add_chain(std::span<const Vec2> points, bool closed = false,
                     const Surface& surface = {0.6, 0, 0, 0},
                     const Filter& filter = {});
    /// With its joints and all its shapes. What it carried wakes.
    void remove(BodyId body);
    bool has(BodyId body) const;
    //! [bodies]
    /// All bodies, in the order of their places.
    std::vector<BodyId> bodies() const;
    /// The names of a body's shapes, in their order; the first is its own name. shape(),
    /// surface(), filter(), user() and what sets them are about the shape that a name
    /// is of; all else is about its body.
    std::vector<BodyId> shapes(BodyId body) const;
    BodyId body_of(BodyId shape) const;

    Vec2 position(BodyId body) const;  ///< of the centroid [m]
    Real angle(BodyId body) const;     ///< [rad], not wrapped
    Vec2 velocity(BodyId body) const;  ///< of the centroid [m/s]
    Real spin(BodyId body) const;      ///< [rad/s]
    Real mass(BodyId body) const;      ///< [kg]; infinite: nothing pushes it
    Real inertia(BodyId body) const;   ///< about the centroid [kg m²]
    /// in the body's own axes, the centroid of the body at (0, 0)
    const Polygon& shape(BodyId body) const;
    const Surface& surface(BodyId body) const;
    const Filter& filter(BodyId body) const;
    std::uint64_t user(BodyId body) const;
    bool is_awake(BodyId body) const;
    BodyKind kind(BodyId body) const;
    bool is_enabled(BodyId body) const;
    bool has_fixed_rotation(BodyId body) const;
    Real gravity_scale(BodyId body) const;
    Real linear_damping(BodyId body) const;   ///< [1/s]
    Real angular_damping(BodyId body) const;  ///< [1/s]
    Vec2 force(BodyId body) const;   ///< that which lasts, of set_force() [N]
    Real torque(BodyId body) const;  ///< the same [N m]
    /// Where a point of the body's own axes is [m]; of the world: where it is.
    Vec2 point_of(BodyId body, const Vec2& own) const;

    /// Whatever is changed wakes, and what touches it.
    void move(BodyId body, const Vec2& position, Real angle);
    /// Of a body that nothing pushes it changes in equal parts over the sub-steps of
    /// the next step.
    void set_velocity(BodyId body, const Vec2& velocity, Real spin);
    /// A body that nothing pushes gets the velocity that brings it to a place in the
    /// next step, (19.4), and keeps it.
    /// \param h  of that step [s]
    void set_target(BodyId body, const Vec2& position, Real angle, Real h);
    /// A force at the centroid [N] and a torque [N m] that last until they are set
    /// again, (19.3).
    void set_force(BodyId body, const Vec2& force, Real torque = 0);
    /// Its weight is so many times m g, also 0 or below it.
    void set_gravity_scale(BodyId body, Real scale);
    /// Drag on velocity and spin, (19.3) [1/s].
    void set_damping(BodyId body, Real linear, Real angular);
    void set_surface(BodyId body, const Surface& surface);
    void set_filter(BodyId body, const Filter& filter);
    void set_bullet(BodyId body, bool bullet);
    void set_user(BodyId body, std::uint64_t user);
    /// Another shape, its centroid where that of the old one is; the mass stays.
    void set_shape(BodyId body, const Polygon& shape);
    /// A mass [kg] and an inertia about the centroid [kg m²]; the body is dynamic.
    void set_mass(BodyId body, Real mass, Real inertia);
    /// The mass and inertia that its shape has at a density [kg/m²]; 0: nothing pushes
    /// the body from now on. Throws for a body of several shapes, unless it is 0.
    void set_density(BodyId body, Real density);
    /// Fixed: it stops. Kinematic: it goes on as it goes. Dynamic: with the mass that
    /// it had or was given; throws if there is none.
    void set_kind(BodyId body, BodyKind kind);
    /// Nothing turns it any more, and it does not turn; or it turns as its inertia says.
    void set_fixed_rotation(BodyId body, bool fixed);
    /// Switched off it stays where it is, and meets, moves and holds nothing; nobody
    /// finds it. Of a chain all edges are switched. On again it goes on as it was.
    void set_enabled(BodyId body, bool enabled);
    void wake(BodyId body);
    /// An impulse [N s] at a point of the world [m].
    void push(BodyId body, const Vec2& impulse, const Vec2& at);
    /// A hand pulls the body's centroid to a point; none without a body. One at a time.
    void pull(BodyId body, const Vec2& to = {0, 0});

    //! [walls]
    // ---- walls: half-spaces ------------------------------------------------------
    WallId add_wall(const HalfSpace& wall, const Surface& surface = {0.6, 0, 0, 0});
    void remove(WallId wall);
    bool has(WallId wall) const;
    //! [walls]
    std::vector<WallId> walls() const;
    const HalfSpace& wall(WallId wall) const;
    const Surface& surface(WallId wall) const;
    void set_surface(WallId wall, const Surface& surface);

    //! [joints]
    // ---- joints -----------------------------------------------------------------
    /// \param a    may be the world: BodyId()
    /// \param how  kind, frames, limits, drives: see joint.hpp; its a and b are not
    ///             looked at
    JointId add_joint(BodyId a, BodyId b, RigidJoint how);
    /// A joint of two bodies at one place of the world, with their frames as they are
    /// now, for add_joint().
    RigidJoint joint_at(JointKind kind, BodyId a, BodyId b,
                        const Vec2& place) const;
    void remove(JointId joint);
    bool has(JointId joint) const;
    //! [joints]
    /// Another motor, spring, target or limit, also where there was none, or none
    /// where there was one; the kind and the bodies stay.
    void change(JointId joint, RigidJoint how);
    void set_user(JointId joint, std::uint64_t user);
    std::uint64_t user(JointId joint) const;
    const RigidJoint& joint(JointId joint) const;
    std::vector<JointId> joints() const;
    std::vector<JointId> joints(BodyId body) const;  ///< that hold it
    BodyId body_a(JointId joint) const;
    BodyId body_b(JointId joint) const;
    bool is_broken(JointId joint) const;
    /// The coordinate q that the joint leaves free [m, rad].
    Real coordinate(JointId joint) const;
    /// The force on b at its frame [N], in the last sub-step; of sleepers at rest.
    Vec2 force(JointId joint) const;
    Real torque(JointId joint) const;  ///< on b, besides that [N m]
    Real error(JointId joint) const;   ///< the largest |C| of its rows [m, rad]

    //! [questions]
    // ---- questions ----------------------------------------------------------------
    /// Shapes are placed where the bodies are now. The first question after a step or
    /// a change does it by itself; after this call, and until a function that is not
    /// const, several threads may ask at once.
    void prepare_questions() const;
    /// What a ray from a point along a way meets first, sensors left out.
    std::optional<Met> ray(const Vec2& from, const Vec2& way,
                           const Filter& filter = {}) const;
    /// All that it meets, in the order of the way; each once, where it goes in.
    std::vector<Met> ray_all(const Vec2& from, const Vec2& way,
                             const Filter& filter = {}) const;
    /// The same for a shape that goes along a way without turning.
    std::optional<Met> cast(const Polygon& shape, const Vec2& from, Real angle,
                            const Vec2& way, const Filter& filter = {}) const;
    std::vector<Met> cast_all(const Polygon& shape, const Vec2& from, Real angle,
                              const Vec2& way, const Filter& filter = {}) const;
    /// What overlaps a shape, shape by shape, in the order of their places.
    std::vector<BodyId> overlapping(const Polygon& shape, const Vec2& at,
                                    Real angle = 0,
                                    const Filter& filter = {}) const;
    std::vector<BodyId> at(const Vec2& point, const Filter& filter = {}) const;
    //! [questions]
    /// The contacts of bodies that are awake, as the last step had them.
    void contacts(std::vector<ContactView>& list) const;
    /// Those of one body; of one that sleeps, what it rests on. (Passes the contacts of
    /// all that are awake, or sleep.)
    void contacts(BodyId body, std::vector<ContactView>& list) const;
    /// The bodies that the last step has moved, or could have: those that it looked
    /// at, ascending; which fell asleep is_awake() says.
    void moved(std::vector<BodyId>& list) const;

    //! [callbacks]
    // ---- callbacks: see events.hpp; no saved world and no recording has them --------
    // What sleeps is asked about when it wakes. An empty function takes one away.
    void set_contact_filter(ContactFilter filter);
    void set_pre_solve(PreSolve pre_solve);
    /// What helps with pairs and islands, see common/jobs.hpp; the bits are the same.
    void set_jobs(Jobs jobs);
    //! [callbacks]

    //! [kept]
    // ---- what outlives a world ----------------------------------------------------
    /// All of it as bytes: a world that is loaded from them goes on to the same bits.
    std::string save() const;
    /// Throws for bytes that no world of this version has saved.
    static World load(std::string_view bytes);
    /// One number of all positions and velocities, equal only where all bits are.
    std::uint64_t hash() const;
    /// From here on all calls go into the recording as well, until another one or
    /// none takes its place; it must live as long.
    void record(Recording* recording);
    //! [kept]

private:
    struct State;
    explicit World(std::unique_ptr<State> state);
    std::unique_ptr<State> state_;
    friend class Recording;
};

}  // namespace rigid
