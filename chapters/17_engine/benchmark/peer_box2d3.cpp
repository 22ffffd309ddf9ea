#include "chapters/17_engine/benchmark/peer_box2d3.hpp"

#include "chapters/14_joints/benchmark/box2d3_shapes.hpp"

#include <algorithm>
#include <cmath>

namespace rigid {

struct Box2d3World::Inside {
    b2WorldId id{};
    int substeps = 4;
    b2BodyId ground{};
    std::vector<b2BodyId> bodies;
    std::vector<std::size_t> number;  ///< of the body in each place of the World

    b2BodyId of(BodyId id_there) const
    {
        return id_there ? bodies[number[id_there.place]] : ground;
    }
};

namespace {

b2ShapeDef surface_of(const World& here, BodyId id)
{
    b2ShapeDef def = b2DefaultShapeDef();
    def.material.friction = static_cast<float>(here.surface(id).friction);
    def.material.restitution = static_cast<float>(here.surface(id).restitution);
    def.filter.groupIndex = here.filter(id).group;
    return def;
}

}  // namespace

Box2d3World::Box2d3World(const World& here, bool sleeps, int substeps)
    : inside_(std::make_unique<Inside>())
{
    Inside& in = *inside_;
    b2SetLengthUnitsPerMeter(static_cast<float>(here.settings().length));
    b2WorldDef world_def = b2DefaultWorldDef();
    world_def.gravity = vector(here.settings().gravity);
    world_def.enableSleep = sleeps;
    in.id = b2CreateWorld(&world_def);
    in.substeps = substeps;
    b2BodyDef fixed = b2DefaultBodyDef();
    in.ground = b2CreateBody(in.id, &fixed);
    for (const BodyId id : here.bodies()) {
        b2BodyDef def = b2DefaultBodyDef();
        const bool moves = here.mass(id) < infinity,
                   goes = !here.velocity(id).isZero(0) || here.spin(id) != 0;
        def.type = moves ? b2_dynamicBody : goes ? b2_kinematicBody : b2_staticBody;
        def.position = b2ToPos(vector(here.position(id)));
        def.rotation = b2MakeRot(static_cast<float>(here.angle(id)));
        def.linearVelocity = vector(here.velocity(id));
        def.angularVelocity = static_cast<float>(here.spin(id));
        const b2BodyId body = b2CreateBody(in.id, &def);
        add_shape(body, here.shape(id), surface_of(here, id));
        const b2MassData mass{static_cast<float>(here.mass(id)),
                              {0, 0},
                              static_cast<float>(here.inertia(id))};
        if (moves) b2Body_SetMassData(body, mass);
        in.number.resize(std::max<std::size_t>(in.number.size(), id.place + 1u));
        in.number[id.place] = in.bodies.size();
        in.bodies.push_back(body);
    }
    for (const WallId id : here.walls()) {
        const HalfSpace& wall = here.wall(id);
        b2ShapeDef def = b2DefaultShapeDef();
        def.material.friction = 0.6F;
        const Real thick = 10 * here.settings().length;
        const b2Polygon half = b2MakeOffsetBox(
            static_cast<float>(wall_reach * here.settings().length),
            static_cast<float>(thick), vector((wall.offset - thick) * wall.normal),
            b2MakeRot(
                static_cast<float>(std::atan2(-wall.normal.x(), wall.normal.y()))));
        b2CreatePolygonShape(in.ground, &def, &half);
    }
    for (const JointId id : here.joints()) {
        const RigidJoint& joint = here.joint(id);
        b2RevoluteJointDef def = b2DefaultRevoluteJointDef();
        def.base.bodyIdA = in.of(here.body_a(id));
        def.base.bodyIdB = in.of(here.body_b(id));
        def.base.localFrameA.p = vector(joint.at_a);
        def.base.localFrameA.q = b2MakeRot(static_cast<float>(joint.angle));
        def.base.localFrameB.p = vector(joint.at_b);
        def.enableLimit = joint.lower > -infinity;
        def.lowerAngle = static_cast<float>(std::max(joint.lower, -0.99 * pi));
        def.upperAngle = static_cast<float>(std::min(joint.upper, 0.99 * pi));
        def.enableMotor = joint.motor.force > 0;
        def.motorSpeed = static_cast<float>(joint.motor.speed);
        def.maxMotorTorque = static_cast<float>(joint.motor.force);
        b2CreateRevoluteJoint(in.id, &def);
    }
}

Box2d3World::~Box2d3World() { b2DestroyWorld(inside_->id); }

void Box2d3World::step(Real h)
{
    b2World_Step(inside_->id, static_cast<float>(h), inside_->substeps);
}

void Box2d3World::drive(std::size_t k, const Vec2& velocity, Real spin)
{
    b2Body_SetLinearVelocity(inside_->bodies[k], vector(velocity));
    b2Body_SetAngularVelocity(inside_->bodies[k], static_cast<float>(spin));
}

void Box2d3World::read(Poses& poses) const
{
    poses.clear();
    for (const b2BodyId body : inside_->bodies) {
        const auto p = b2Body_GetPosition(body);
        poses.push_back(
            {static_cast<Real>(p.x), static_cast<Real>(p.y),
             static_cast<Real>(b2Rot_GetAngle(b2Body_GetRotation(body)))});
    }
}

}  // namespace rigid
