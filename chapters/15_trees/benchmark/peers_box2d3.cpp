#include "chapters/15_trees/benchmark/peers_box2d3.hpp"

#include "tests/peers/box2d3_shapes.hpp"

#include <algorithm>
#include <cmath>

namespace rigid {

struct Box2d3Joints::World {
    b2WorldId id{};
    int substeps = 1;
    std::vector<b2BodyId> bodies;
};

namespace {

b2ShapeDef surface_of(int group)
{
    b2ShapeDef def = b2DefaultShapeDef();
    def.material.friction = 0.6F;
    def.filter.groupIndex = -group;
    return def;
}

}  // namespace

Box2d3Joints::Box2d3Joints(const JointedScene& scene, int substeps,
                           const std::vector<int>& group, Real hertz)
    : world_(std::make_unique<World>())
{
    b2WorldDef world_def = b2DefaultWorldDef();
    world_def.gravity = vector(scene.gravity);
    world_def.enableSleep = false;
    world_def.enableContinuous = false;
    world_->id = b2CreateWorld(&world_def);
    world_->substeps = substeps;
    b2BodyDef fixed = b2DefaultBodyDef();
    const b2BodyId ground = b2CreateBody(world_->id, &fixed);
    for (Index k = 0; k < scene.bodies.count(); ++k) {
        const Vec<3> x = scene.bodies.position(k), u = scene.bodies.velocity(k),
                     m = scene.bodies.inverse_mass.segment<3>(3 * k);
        b2BodyDef def = b2DefaultBodyDef();
        def.type = m.isZero(0) ? b2_staticBody : b2_dynamicBody;
        def.position = b2ToPos(vector(x.head<2>()));
        def.rotation = b2MakeRot(static_cast<float>(x[2]));
        def.linearVelocity = vector(u.head<2>());
        def.angularVelocity = static_cast<float>(u[2]);
        const b2BodyId body = b2CreateBody(world_->id, &def);
        const auto i = static_cast<std::size_t>(k);
        if (!group.empty()) add_shape(body, scene.shapes[i], surface_of(group[i]));
        const b2MassData mass{
            static_cast<float>(1 / m[0]), {0, 0}, static_cast<float>(1 / m[2])};
        if (!m.isZero(0)) b2Body_SetMassData(body, mass);
        world_->bodies.push_back(body);
    }
    for (const HalfSpace& wall : scene.walls) {
        if (group.empty()) break;
        b2ShapeDef def = b2DefaultShapeDef();
        def.material.friction = 0.6F;
        const b2Polygon half =
            b2MakeOffsetBox(200, 10, vector((wall.offset - 10) * wall.normal),
                            b2MakeRot(static_cast<float>(
                                std::atan2(-wall.normal.x(), wall.normal.y()))));
        b2CreatePolygonShape(ground, &def, &half);
    }
    for (const PlacedJoint& placed : scene.placed) {
        const RigidJoint& joint = placed.joint;
        b2RevoluteJointDef def = b2DefaultRevoluteJointDef();
        def.base.bodyIdA = joint.a == world
                               ? ground
                               : world_->bodies[static_cast<std::size_t>(joint.a)];
        def.base.bodyIdB = world_->bodies[static_cast<std::size_t>(joint.b)];
        def.base.localFrameA.p = vector(joint.at_a);
        def.base.localFrameA.q = b2MakeRot(static_cast<float>(joint.angle));
        def.base.localFrameB.p = vector(joint.at_b);
        if (hertz > 0) def.base.constraintHertz = static_cast<float>(hertz);
        def.enableLimit = joint.lower > -infinity;
        def.lowerAngle = static_cast<float>(std::max(joint.lower, -0.99 * pi));
        def.upperAngle = static_cast<float>(std::min(joint.upper, 0.99 * pi));
        def.enableMotor = joint.motor.force > 0;
        def.maxMotorTorque = static_cast<float>(joint.motor.force);
        b2CreateRevoluteJoint(world_->id, &def);
    }
}

Box2d3Joints::~Box2d3Joints() { b2DestroyWorld(world_->id); }

void Box2d3Joints::step(Real h)
{
    b2World_Step(world_->id, static_cast<float>(h), world_->substeps);
}

void Box2d3Joints::read(JointedScene& scene) const
{
    for (std::size_t k = 0; k < world_->bodies.size(); ++k) {
        const b2BodyId body = world_->bodies[k];
        const auto i = static_cast<Index>(k);
        const auto p = b2Body_GetPosition(body);
        const b2Vec2 v = b2Body_GetLinearVelocity(body);
        scene.bodies.position(i) << static_cast<Real>(p.x), static_cast<Real>(p.y),
            static_cast<Real>(b2Rot_GetAngle(b2Body_GetRotation(body)));
        scene.bodies.velocity(i) << static_cast<Real>(v.x), static_cast<Real>(v.y),
            static_cast<Real>(b2Body_GetAngularVelocity(body));
    }
}

}  // namespace rigid
