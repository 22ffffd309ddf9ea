#include "tests/peers/box2d3_world.hpp"

#include "tests/peers/box2d3_shapes.hpp"

#include <algorithm>
#include <cmath>

namespace rigid {

struct Box2d3World::Inside {
    b2WorldId id{};
    int substeps = 4;
    b2BodyId ground{};
    std::vector<b2BodyId> bodies;
    std::vector<std::size_t> number;  ///< of the body in each place of the World

    b2BodyId of(BodyId id_there) const { return id_there ? bodies[number[id_there.place]] : ground; }
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

void add_joint(b2WorldId world_id, const RigidJoint& joint, b2BodyId a, b2BodyId b)
{
    const auto placed = [&](auto def) {
        def.base.bodyIdA = a, def.base.bodyIdB = b;
        def.base.localFrameA.p = vector(joint.at_a);
        def.base.localFrameA.q = b2MakeRot(static_cast<float>(joint.angle));
        def.base.localFrameB.p = vector(joint.at_b);
        return def;
    };
    if (joint.kind == JointKind::revolute) {
        b2RevoluteJointDef def = placed(b2DefaultRevoluteJointDef());
        def.enableLimit = joint.lower > -infinity;
        def.lowerAngle = static_cast<float>(std::max(joint.lower, -0.99 * pi));
        def.upperAngle = static_cast<float>(std::min(joint.upper, 0.99 * pi));
        def.enableMotor = joint.motor.force > 0;
        def.motorSpeed = static_cast<float>(joint.motor.speed);
        def.maxMotorTorque = static_cast<float>(joint.motor.force);
        b2CreateRevoluteJoint(world_id, &def);
    } else if (joint.kind == JointKind::distance || joint.kind == JointKind::rope) {
        b2DistanceJointDef def = placed(b2DefaultDistanceJointDef());
        def.length = static_cast<float>(joint.length);
        if (joint.kind == JointKind::rope) {
            // a spring of no stiffness leaves the length to the limit
            def.enableSpring = def.enableLimit = true;
            def.minLength = 0, def.maxLength = def.length;
        }
        b2CreateDistanceJoint(world_id, &def);
    } else if (joint.kind == JointKind::weld) {
        const b2WeldJointDef def = placed(b2DefaultWeldJointDef());
        b2CreateWeldJoint(world_id, &def);
    } else refuse(joint.kind, "Box2D 3");
}

}  // namespace

Box2d3World::Box2d3World(const World& here, bool sleeps, int substeps) : inside_(std::make_unique<Inside>())
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
        const b2MassData mass{
            static_cast<float>(here.mass(id)), {0, 0}, static_cast<float>(here.inertia(id))};
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
        const b2Polygon half =
            b2MakeOffsetBox(static_cast<float>(wall_reach * here.settings().length),
                            static_cast<float>(thick), vector((wall.offset - thick) * wall.normal),
                            b2MakeRot(static_cast<float>(std::atan2(-wall.normal.x(), wall.normal.y()))));
        b2CreatePolygonShape(in.ground, &def, &half);
    }
    for (const JointId id : here.joints()) {
        add_joint(in.id, here.joint(id), in.of(here.body_a(id)), in.of(here.body_b(id)));
    }
}

Box2d3World::~Box2d3World() { b2DestroyWorld(inside_->id); }

void Box2d3World::step(Real h) { b2World_Step(inside_->id, static_cast<float>(h), inside_->substeps); }

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
        poses.push_back({static_cast<Real>(p.x), static_cast<Real>(p.y),
                         static_cast<Real>(b2Rot_GetAngle(b2Body_GetRotation(body)))});
    }
}

void Box2d3World::read_velocities(Poses& velocities) const
{
    velocities.clear();
    for (const b2BodyId body : inside_->bodies) {
        const b2Vec2 v = b2Body_GetLinearVelocity(body);
        velocities.push_back({static_cast<Real>(v.x), static_cast<Real>(v.y),
                              static_cast<Real>(b2Body_GetAngularVelocity(body))});
    }
}

}  // namespace rigid
