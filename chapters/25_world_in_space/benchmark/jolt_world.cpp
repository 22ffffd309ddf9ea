#include "chapters/25_world_in_space/benchmark/jolt_world.hpp"

// Jolt.h comes first in each source that uses it
#include <Jolt/Jolt.h>

#include <Jolt/Core/Factory.h>
#include <Jolt/Core/JobSystemSingleThreaded.h>
#include <Jolt/Core/TempAllocator.h>
#include <Jolt/Physics/Body/BodyCreationSettings.h>
#include <Jolt/Physics/Collision/GroupFilterTable.h>
#include <Jolt/Physics/Collision/Shape/BoxShape.h>
#include <Jolt/Physics/Collision/Shape/CapsuleShape.h>
#include <Jolt/Physics/Collision/Shape/RotatedTranslatedShape.h>
#include <Jolt/Physics/Collision/Shape/SphereShape.h>
#include <Jolt/Physics/Constraints/HingeConstraint.h>
#include <Jolt/Physics/Constraints/PointConstraint.h>
#include <Jolt/Physics/Constraints/SwingTwistConstraint.h>
#include <Jolt/Physics/PhysicsSettings.h>
#include <Jolt/Physics/PhysicsSystem.h>
#include <Jolt/RegisterTypes.h>

#include <algorithm>
#include <cmath>

namespace rigid {
namespace {

constexpr JPH::ObjectLayer fixed_things = 0, moving_things = 1;

/// What is fixed meets what moves, and what moves all.
struct Layers final : JPH::BroadPhaseLayerInterface,
                      JPH::ObjectVsBroadPhaseLayerFilter,
                      JPH::ObjectLayerPairFilter {
    JPH::uint GetNumBroadPhaseLayers() const override { return 2; }
    JPH::BroadPhaseLayer GetBroadPhaseLayer(JPH::ObjectLayer layer) const override
    {
        return JPH::BroadPhaseLayer(static_cast<JPH::BroadPhaseLayer::Type>(layer));
    }
#if defined(JPH_EXTERNAL_PROFILE) || defined(JPH_PROFILE_ENABLED)
    const char* GetBroadPhaseLayerName(JPH::BroadPhaseLayer layer) const override
    {
        return layer == JPH::BroadPhaseLayer(fixed_things) ? "fixed" : "moving";
    }
#endif
    bool ShouldCollide(JPH::ObjectLayer a, JPH::BroadPhaseLayer b) const override
    {
        return a == moving_things || b == JPH::BroadPhaseLayer(moving_things);
    }
    bool ShouldCollide(JPH::ObjectLayer a, JPH::ObjectLayer b) const override
    {
        return a == moving_things || b == moving_things;
    }
};

JPH::Vec3 vector(const std::array<double, 3>& v)
{
    return {static_cast<float>(v[0]), static_cast<float>(v[1]),
            static_cast<float>(v[2])};
}
JPH::Quat quaternion(const std::array<double, 4>& q)
{
    return JPH::Quat(static_cast<float>(q[0]), static_cast<float>(q[1]),
                     static_cast<float>(q[2]), static_cast<float>(q[3]))
        .Normalized();
}

JPH::ShapeRefC shape_of(const JoltBody& body)
{
    const auto radius = static_cast<float>(body.radius);
    if (body.kind == JoltBody::ball) return new JPH::SphereShape(radius);
    if (body.kind == JoltBody::capsule)  // Jolt's lie along y
        return new JPH::RotatedTranslatedShape(
            JPH::Vec3::sZero(),
            JPH::Quat::sRotation(JPH::Vec3::sAxisZ(), JPH::JPH_PI / 2),
            new JPH::CapsuleShape(static_cast<float>(body.size[0] / 2), radius));
    const JPH::Vec3 half = vector(body.size) / 2;
    return new JPH::BoxShape(half,
                             std::min(JPH::cDefaultConvexRadius, half.ReduceMin()));
}

void begin_jolt()
{
    static const bool begun = [] {
        JPH::RegisterDefaultAllocator();
        JPH::Factory::sInstance = new JPH::Factory;
        JPH::RegisterTypes();
        return true;
    }();
    (void)begun;
}

}  // namespace

struct JoltWorld::State {
    Layers layers;
    JPH::TempAllocatorImpl memory{64 << 20};
    JPH::JobSystemSingleThreaded jobs{JPH::cMaxPhysicsJobs};
    JPH::PhysicsSystem world;
    std::vector<JPH::BodyID> bodies;
    int substeps = 1;

    JPH::BodyInterface& interface() { return world.GetBodyInterfaceNoLock(); }

    void add(const JoltBody& body, JPH::GroupFilterTable* filter,
             JPH::CollisionGroup::SubGroupID number)
    {
        const bool moves = body.mass > 0;
        JPH::BodyCreationSettings made(
            shape_of(body), JPH::RVec3(vector(body.at)), quaternion(body.turn),
            moves ? JPH::EMotionType::Dynamic : JPH::EMotionType::Static,
            moves ? moving_things : fixed_things);
        made.mFriction = static_cast<float>(body.friction);
        made.mAllowSleeping = false;
        made.mLinearDamping = made.mAngularDamping = 0;
        made.mLinearVelocity = vector(body.v);
        made.mAngularVelocity = vector(body.spin);
        made.mCollisionGroup = JPH::CollisionGroup(filter, 0, number);
        if (moves) {
            made.mOverrideMassProperties =
                JPH::EOverrideMassProperties::MassAndInertiaProvided;
            made.mMassPropertiesOverride.mMass = static_cast<float>(body.mass);
            made.mMassPropertiesOverride.mInertia =
                JPH::Mat44::sScale(vector(body.inertia));
        }
        bodies.push_back(interface().CreateAndAddBody(
            made,
            moves ? JPH::EActivation::Activate : JPH::EActivation::DontActivate));
    }

    void add(const JoltJoint& joint)
    {
        const JPH::BodyLockInterface& locks = world.GetBodyLockInterfaceNoLock();
        JPH::Body* const a =
            joint.a < 0
                ? &JPH::Body::sFixedToWorld
                : locks.TryGetBody(bodies[static_cast<std::size_t>(joint.a)]);
        JPH::Body* const b =
            locks.TryGetBody(bodies[static_cast<std::size_t>(joint.b)]);
        const JPH::Quat A = quaternion(joint.frame_a),
                        B = quaternion(joint.frame_b);
        const auto local = JPH::EConstraintSpace::LocalToBodyCOM;
        const JPH::RVec3 p(vector(joint.at_a)), q(vector(joint.at_b));
        const auto lo = static_cast<float>(joint.lo),
                   hi = static_cast<float>(joint.hi);
        if (joint.is_hinge) {
            JPH::HingeConstraintSettings made;
            made.mSpace = local;
            made.mPoint1 = p, made.mPoint2 = q;
            made.mHingeAxis1 = A.RotateAxisX(), made.mHingeAxis2 = B.RotateAxisX();
            made.mNormalAxis1 = A.RotateAxisY(),
            made.mNormalAxis2 = B.RotateAxisY();
            if (joint.is_bounded)
                made.mLimitsMin = std::clamp(lo, -JPH::JPH_PI, 0.0f),
                made.mLimitsMax = std::clamp(hi, 0.0f, JPH::JPH_PI);
            world.AddConstraint(made.Create(*a, *b));
        } else if (joint.is_bounded) {
            JPH::SwingTwistConstraintSettings made;
            made.mSpace = local;
            made.mPosition1 = p, made.mPosition2 = q;
            made.mTwistAxis1 = A.RotateAxisX(), made.mTwistAxis2 = B.RotateAxisX();
            made.mPlaneAxis1 = A.RotateAxisY(), made.mPlaneAxis2 = B.RotateAxisY();
            made.mNormalHalfConeAngle = made.mPlaneHalfConeAngle =
                std::min(static_cast<float>(joint.cone), JPH::JPH_PI);
            made.mTwistMinAngle = std::max(lo, -JPH::JPH_PI),
            made.mTwistMaxAngle = std::min(hi, JPH::JPH_PI);
            world.AddConstraint(made.Create(*a, *b));
        } else {
            JPH::PointConstraintSettings made;
            made.mSpace = local;
            made.mPoint1 = p, made.mPoint2 = q;
            world.AddConstraint(made.Create(*a, *b));
        }
    }
};

JoltWorld::JoltWorld(const std::vector<JoltBody>& bodies,
                     const std::vector<JoltJoint>& joints,
                     std::array<double, 3> gravity, int substeps, int iterations)
{
    begin_jolt();
    state_ = std::make_unique<State>();
    state_->substeps = substeps;
    const auto count = static_cast<JPH::uint>(bodies.size());
    state_->world.Init(count + 1, 0, 65536, 65536, state_->layers, state_->layers,
                       state_->layers);
    state_->world.SetGravity(vector(gravity));
    if (iterations > 0) {
        JPH::PhysicsSettings settings = state_->world.GetPhysicsSettings();
        settings.mNumVelocitySteps = static_cast<JPH::uint>(iterations);
        state_->world.SetPhysicsSettings(settings);
    }
    // what a joint joins does not touch
    const JPH::Ref<JPH::GroupFilterTable> filter = new JPH::GroupFilterTable(count);
    for (const JoltJoint& joint : joints)
        if (joint.a >= 0)
            filter->DisableCollision(static_cast<JPH::uint>(joint.a),
                                     static_cast<JPH::uint>(joint.b));
    for (std::size_t k = 0; k < bodies.size(); ++k)
        state_->add(bodies[k], filter,
                    static_cast<JPH::CollisionGroup::SubGroupID>(k));
    for (const JoltJoint& joint : joints) state_->add(joint);
    state_->world.OptimizeBroadPhase();
}

JoltWorld::~JoltWorld() = default;

void JoltWorld::step(double h)
{
    state_->world.Update(static_cast<float>(h), state_->substeps, &state_->memory,
                         &state_->jobs);
}

JoltBody JoltWorld::state(std::size_t k) const
{
    JPH::BodyInterface& all = state_->interface();
    const JPH::BodyID id = state_->bodies[k];
    const JPH::RVec3 p = all.GetCenterOfMassPosition(id);
    const JPH::Quat q = all.GetRotation(id);
    const JPH::Vec3 v = all.GetLinearVelocity(id), w = all.GetAngularVelocity(id);
    JoltBody here;
    here.at = {p.GetX(), p.GetY(), p.GetZ()};
    here.turn = {q.GetX(), q.GetY(), q.GetZ(), q.GetW()};
    here.v = {v.GetX(), v.GetY(), v.GetZ()};
    here.spin = {w.GetX(), w.GetY(), w.GetZ()};
    return here;
}

}  // namespace rigid
