// Engines step bodies that turn, the book's own of chapter 19 and two others, with what the book's methods have: small steps,
// sleep or none, friction, the slop.
#include "docs/results/turning_runs.hpp"

#include "chapters/14_joints/placed_joints.hpp"
#include "chapters/19_engine/from_scene.hpp"

#ifdef RIGID_HAS_BOX2D
#include <box2d/box2d.h>
#endif
#ifdef RIGID_HAS_CHIPMUNK
#include <chipmunk/chipmunk.h>
#endif

#include <ctime>
#include <limits>

namespace rigid::results {
namespace {

struct EngineSettings {
    int substeps = 1;  ///< 1: the engine's own number of iterations, else one iteration in each
    bool may_sleep = false;
    Real slop = 5e-3;  ///< [m]
};

/// How long to each side a wall is [m].
[[maybe_unused]] Real reach_of(const JointedScene& scene)
{
    return 20 + 2 * scene.bodies.x.lpNorm<Eigen::Infinity>();
}

[[maybe_unused]] Real friction_of(const std::vector<Surface>& surfaces)
{
    return surfaces.empty() ? 0 : surfaces.front().friction;
}

/// Rows of joints that no joint of chapter 14 made are two a pin.
JointedScene with_pins(JointedScene scene)
{
    if (!scene.placed.empty()) return scene;
    std::vector<PointJoint> rows;
    rows.swap(scene.joints);
    for (std::size_t j = 0; j + 1 < rows.size(); j += 2) {
        RigidJoint pin;
        pin.a = rows[j].a, pin.b = rows[j].b;
        pin.at_a = rows[j].at_a, pin.at_b = rows[j].at_b;
        add_joint(scene, pin);
    }
    return scene;
}

/// Chapter 19's.
class TurningWorld {
public:
    TurningWorld(const TurningScene& run, const EngineSettings& settings)
    {
        WorldSettings wanted;
        wanted.gravity = run.scene.gravity;
        wanted.substeps = settings.substeps;
        wanted.slop = settings.slop;
        wanted.sleep = settings.may_sleep;
        world_.change(wanted);
        bodies_ = put_in(world_, with_pins(run.scene), run.touches ? Filter{} : Filter{.group = -1});
        for (const auto& [a, b] : run.apart)  // a doll's limbs
            for (const Index k : {a, b})
                world_.set_filter(bodies_[static_cast<std::size_t>(k)], {.group = -1});
    }
    void step(Real h)
    {
        world_.step(h);
        visits_ += world_.work().visits;
    }
    std::optional<std::int64_t> work() const { return visits_; }
    void poses(JointedScene& scene) const
    {
        for (std::size_t k = 0; k < bodies_.size(); ++k) {
            const Vec2 p = world_.position(bodies_[k]);
            scene.bodies.position(static_cast<Index>(k)) << p, world_.angle(bodies_[k]);
        }
    }

private:
    World world_;
    std::vector<BodyId> bodies_;
    std::int64_t visits_ = 0;
};

#ifdef RIGID_HAS_BOX2D
/// As in chapter 8's peers: its slop is a constant of the library, so all lengths and gravity are scaled instead.
class TurningBox2d {
public:
    TurningBox2d(const TurningScene& run, const EngineSettings& settings)
        : scale_(static_cast<Real>(b2_linearSlop) / settings.slop), world_(vector(run.scene.gravity)),
          substeps_(settings.substeps)
    {
        const JointedScene& scene = run.scene;
        world_.SetAllowSleeping(settings.may_sleep);
        world_.SetContinuousPhysics(false);
        const Real mu = friction_of(scene.surfaces);
        for (Index k = 0; k < scene.bodies.count(); ++k) {
            b2BodyDef def;
            def.type = b2_dynamicBody;
            def.position = vector(scene.bodies.position(k).head<2>());
            def.angle = static_cast<float>(scene.bodies.x[3 * k + 2]);
            b2Body* const body = world_.CreateBody(&def);
            if (run.touches) {
                // A polygon has a skin of its own around it: it is made smaller by that, so that boxes touch where ours do.
                b2PolygonShape shape;
                std::vector<b2Vec2> points;
                for (const Vec2& v : scene.shapes[static_cast<std::size_t>(k)].vertices)
                    points.push_back(vector(v));
                for (b2Vec2& p : points) {
                    p.x -= p.x > 0 ? shape.m_radius : -shape.m_radius;
                    p.y -= p.y > 0 ? shape.m_radius : -shape.m_radius;
                }
                shape.Set(points.data(), static_cast<int>(points.size()));
                add(*body, shape, mu);
            }
            const Vec<3> inverse = scene.bodies.inverse_mass.segment<3>(3 * k);
            const b2MassData mass{
                static_cast<float>(1 / inverse[0]), {0, 0}, static_cast<float>(scale_ * scale_ / inverse[2])};
            body->SetMassData(&mass);
            bodies_.push_back(body);
        }
        b2BodyDef ground_def;
        b2Body* const ground = world_.CreateBody(&ground_def);
        for (std::size_t j = 0; j + 1 < scene.joints.size(); j += 2) {  // two rows of a pin
            const PointJoint& pin = scene.joints[j];
            b2RevoluteJointDef def;
            def.bodyA = pin.a == world ? ground : bodies_[static_cast<std::size_t>(pin.a)];
            def.bodyB = bodies_[static_cast<std::size_t>(pin.b)];
            def.localAnchorA = vector(pin.at_a);
            def.localAnchorB = vector(pin.at_b);
            world_.CreateJoint(&def);
        }
        const Real reach = reach_of(scene);
        for (const HalfSpace& wall : scene.walls) {
            b2PolygonShape box;
            const Real skin = static_cast<Real>(box.m_radius) / scale_;
            const Vec2 middle = (wall.offset - skin - reach / 2) * wall.normal;
            box.SetAsBox(static_cast<float>(scale_ * reach), static_cast<float>(scale_ * reach / 2),
                         vector(middle), static_cast<float>(std::atan2(-wall.normal.x(), wall.normal.y())));
            add(*ground, box, friction_of(scene.wall_surfaces));
        }
    }

    void step(Real h)
    {
        if (substeps_ == 1) world_.Step(static_cast<float>(h), 8, 3);
        else
            for (int k = 0; k < substeps_; ++k) world_.Step(static_cast<float>(h / substeps_), 1, 1);
    }

    void poses(JointedScene& scene) const
    {
        for (std::size_t k = 0; k < bodies_.size(); ++k) {
            const b2Vec2& p = bodies_[k]->GetPosition();
            scene.bodies.position(static_cast<Index>(k)) << static_cast<Real>(p.x) / scale_,
                static_cast<Real>(p.y) / scale_, static_cast<Real>(bodies_[k]->GetAngle());
        }
    }

private:
    b2Vec2 vector(const Vec2& v) const
    {
        return {static_cast<float>(scale_ * v.x()), static_cast<float>(scale_ * v.y())};
    }
    static void add(b2Body& body, const b2Shape& shape, Real mu)
    {
        b2FixtureDef def;
        def.shape = &shape;
        def.density = 1;
        def.friction = static_cast<float>(mu);  // of two: the root of their product, as the book's
        def.restitution = 0;
        body.CreateFixture(&def);
    }

    Real scale_;
    b2World world_;
    int substeps_;
    std::vector<b2Body*> bodies_;
};
#endif

#ifdef RIGID_HAS_CHIPMUNK
class TurningChipmunk {
public:
    TurningChipmunk(const TurningScene& run, const EngineSettings& settings)
        : space_(cpSpaceNew()), substeps_(settings.substeps)
    {
        const JointedScene& scene = run.scene;
        cpSpaceSetGravity(space_, vector(scene.gravity));
        cpSpaceSetCollisionSlop(space_, settings.slop);
        cpSpaceSetSleepTimeThreshold(space_,
                                     settings.may_sleep ? 0.5 : std::numeric_limits<cpFloat>::infinity());
        // Of two it takes the product: each has the root.
        const Real mu = std::sqrt(friction_of(scene.surfaces));
        for (Index k = 0; k < scene.bodies.count(); ++k) {
            const Vec<3> inverse = scene.bodies.inverse_mass.segment<3>(3 * k);
            cpBody* const body = cpSpaceAddBody(space_, cpBodyNew(1 / inverse[0], 1 / inverse[2]));
            cpBodySetPosition(body, vector(scene.bodies.position(k).head<2>()));
            cpBodySetAngle(body, scene.bodies.x[3 * k + 2]);
            bodies_.push_back(body);
            if (!run.touches) continue;
            std::vector<cpVect> points;
            for (const Vec2& v : scene.shapes[static_cast<std::size_t>(k)].vertices)
                points.push_back(vector(v));
            add(cpPolyShapeNew(body, static_cast<int>(points.size()), points.data(), cpTransformIdentity, 0),
                mu);
        }
        for (std::size_t j = 0; j + 1 < scene.joints.size(); j += 2) {
            const PointJoint& pin = scene.joints[j];
            cpBody* const a =
                pin.a == world ? cpSpaceGetStaticBody(space_) : bodies_[static_cast<std::size_t>(pin.a)];
            joints_.push_back(
                cpSpaceAddConstraint(space_, cpPivotJointNew2(a, bodies_[static_cast<std::size_t>(pin.b)],
                                                              vector(pin.at_a), vector(pin.at_b))));
        }
        const Real reach = reach_of(scene);
        for (const HalfSpace& wall : scene.walls) {
            const Vec2 middle = (wall.offset - reach) * wall.normal,
                       along = reach * perpendicular(wall.normal);
            add(cpSegmentShapeNew(cpSpaceGetStaticBody(space_), vector(middle - along),
                                  vector(middle + along), reach),
                std::sqrt(friction_of(scene.wall_surfaces)));
        }
    }
    ~TurningChipmunk()
    {
        for (cpConstraint* const joint : joints_)
            cpSpaceRemoveConstraint(space_, joint), cpConstraintFree(joint);
        for (cpShape* const shape : shapes_) cpSpaceRemoveShape(space_, shape), cpShapeFree(shape);
        for (cpBody* const body : bodies_) cpSpaceRemoveBody(space_, body), cpBodyFree(body);
        cpSpaceFree(space_);
    }
    TurningChipmunk(const TurningChipmunk&) = delete;
    TurningChipmunk& operator=(const TurningChipmunk&) = delete;

    void step(Real h)
    {
        cpSpaceSetIterations(space_, substeps_ == 1 ? 10 : 1);
        for (int k = 0; k < substeps_; ++k) cpSpaceStep(space_, h / substeps_);
    }
    void poses(JointedScene& scene) const
    {
        for (std::size_t k = 0; k < bodies_.size(); ++k) {
            const cpVect p = cpBodyGetPosition(bodies_[k]);
            scene.bodies.position(static_cast<Index>(k)) << p.x, p.y, cpBodyGetAngle(bodies_[k]);
        }
    }

private:
    static cpVect vector(const Vec2& v) { return cpv(v.x(), v.y()); }
    void add(cpShape* shape, Real mu)
    {
        cpShapeSetFriction(shape, mu);
        shapes_.push_back(cpSpaceAddShape(space_, shape));
    }

    cpSpace* space_;
    int substeps_;
    std::vector<cpBody*> bodies_;
    std::vector<cpShape*> shapes_;
    std::vector<cpConstraint*> joints_;
};
#endif

/// Row visits, of an engine that tells them.
template <class Engine>
std::optional<std::int64_t> work_of([[maybe_unused]] const Engine& world)
{
    if constexpr (requires { world.work(); }) return world.work();
    else return {};
}

template <class Engine>
void add_engine(Registry& registry, const SharedTurning& run, const std::string& chapter,
                const std::string& method, const EngineSettings& settings, bool quick)
{
    const std::string unit = requires(const Engine& world) { world.work(); }
    ? "row_visit" : "none";
    registry.add({chapter, method, run->name,
                  run->parameters + " substeps=" + std::to_string(settings.substeps) +
                      " slop=" + shortest(settings.slop) + " unit=" + unit + " reference=" + run->reference,
                  run->h(), quick, [=] {
                      const auto seconds = std::make_shared<Real>();
                      Task task;
                      task.run = [=] {
                          Engine world(*run, settings);
                          const std::clock_t start = std::clock();
                          for (int k = 0; k < run->steps; ++k) world.step(run->h());
                          *seconds = static_cast<Real>(std::clock() - start) / CLOCKS_PER_SEC;
                      };
                      task.judge = [=] {
                          Engine world(*run, settings);
                          JointedScene scene = run->scene;
                          WorstError watch(*run);
                          for (int k = 0; k < run->steps; ++k) {
                              world.step(run->h());
                              world.poses(scene);
                              watch.look(scene);
                          }
                          return watch.result(work_of(world), "finished");
                      };
                      task.seconds = [=] { return *seconds; };
                      return task;
                  }});
}

template <class Engine>
void add_engine(Registry& registry, const SharedTurning& run, const std::string& chapter,
                const std::string& method, bool quick)
{
    for (const int substeps : {1, 4, 8, 16, 32})
        for (const Real slop : {5e-3, 5e-4, 5e-5}) {
            if (!run->scene.joints.empty() && slop != EngineSettings{}.slop) continue;
            const bool few = quick && slop == EngineSettings{}.slop;
            add_engine<Engine>(registry, run, chapter, method, {substeps, false, slop}, few);
            if (run->rests)
                add_engine<Engine>(registry, run, chapter, method + "_sleeping", {substeps, true, slop}, few);
        }
}

}  // namespace

void add_turning_engines(Registry& registry, const SharedTurning& run)
{
    constexpr bool quick = true;
    add_engine<TurningWorld>(registry, run, "19", "world", run->quick);
    // their joints are pins, without limits or friction
    const bool pins =
        std::all_of(run->scene.placed.begin(), run->scene.placed.end(), [](const PlacedJoint& placed) {
            return placed.joint.kind == JointKind::revolute && placed.count == 2;
        });
    if (!pins) return;
#ifdef RIGID_HAS_BOX2D
    add_engine<TurningBox2d>(registry, run, "peer", "box2d", !quick);
#endif
#ifdef RIGID_HAS_CHIPMUNK
    add_engine<TurningChipmunk>(registry, run, "peer", "chipmunk", !quick);
#endif
}

}  // namespace rigid::results
