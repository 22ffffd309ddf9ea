// The functions of limit_reach.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/14_joints/limit_reach.hpp"

#include "chapters/13_friction/friction_rows.hpp"

namespace rigid {

void LimitReach::look(const JointedScene& scene, const StepSettings& settings,
                      const StepData<3>& now)
{
    h_ = settings.h;
    margin_ = settings.margin;
    length_ = now.length;
    fall_ = settings.h * scene.gravity.norm();
    const bool any = std::any_of(
        now.sources.begin(), now.sources.end(), [&](const Source& source) {
            return source.of == Source::Of::joint &&
                   is_limit(scene.joints[static_cast<std::size_t>(source.index)]);
        });
    if (any) find_fastest(scene, now);
}

//! [far]
bool LimitReach::is_far(const JointedScene& scene, std::size_t j)
{
    const PointJoint& joint = scene.joints[j];
    if (!is_limit(joint)) return false;
    const Constraint<3> c = joint_constraint(scene.bodies.x, joint, &scene.turns);
    const Row<3> row = unilateral(c, scene.bodies.inverse_mass);
    const bool turns = is_of_angles(joint);
    Real D = 0, E = larger(drives_, joint);
    for_each_own_drive(scene, j, [&](const PointJoint& drive) {
        D += drive_speed(scene, drive, joint.sense);
        E -= reach_of(scene, drive) * drive_speed(scene, drive, 0);
    });
    const Real lever = turns ? shorter_lever(scene, joint) : 1,
               margin = margin_ * (turns ? 1 : length_),
               own = std::abs(row.velocity(scene.bodies.u)),
               blow =
                   (larger(speed_, joint) + std::max(Real{0}, E) + fall_) / lever;
    return c.C > margin + 2 * h_ * (own + D + blow);
}
//! [far]

template <class Visit>
void LimitReach::for_each_own_drive(const JointedScene& scene, std::size_t j,
                                    const Visit& visit) const
{
    if (j >= scene.owner.size() || scene.owner[j] < 0) return;
    const PlacedJoint& placed =
        scene.placed[static_cast<std::size_t>(scene.owner[j])];
    for (int i = placed.first; i < placed.first + placed.count; ++i) {
        const PointJoint& drive = scene.joints[static_cast<std::size_t>(i)];
        if (drive.measure == scene.joints[j].measure) visit(drive);
    }
}

Real LimitReach::drive_speed(const JointedScene& scene, const PointJoint& drive,
                             Real sense) const
{
    const bool is_spring = drive.kind == ConstraintKind::spring;
    if (!is_spring && drive.kind != ConstraintKind::motor) return 0;
    const Constraint<3> c = joint_constraint(scene.bodies.x, drive, &scene.turns);
    Real force = is_spring ? drive.stiffness * std::abs(c.C) : drive.force;
    if (is_spring && drive.force > 0) force = std::min(force, drive.force);
    const Real wanted = is_spring ? c.C / h_ : -drive.speed,
               A = unilateral(c, scene.bodies.inverse_mass)
                       .inverse_effective_mass();
    // what holds the bodies otherwise leaves them less mobile than A
    return std::max(
        Real{0},
        std::min(sense == 0 ? std::abs(wanted) : sense * wanted, h_ * force * A));
}

Real LimitReach::reach_of(const RigidScene& scene, const PointJoint& drive) const
{
    if (!is_of_angles(drive)) return 1;
    // of a body that turns about a point of its rim
    return 2 * std::max(drive.a == world ? 0 : farthest_point(scene, drive.a),
                        farthest_point(scene, drive.b));
}

Real LimitReach::shorter_lever(const RigidScene& scene,
                               const PointJoint& joint) const
{
    Real least = infinity;
    for (const Index k : {joint.a, joint.b})
        if (k != world)
            if (const Real R = farthest_point(scene, k); R > 0)
                least = std::min(least, R);
    return std::isfinite(least) ? least : length_;
}

//! [fastest]
void LimitReach::find_fastest(const JointedScene& scene, const StepData<3>& now)
{
    const Bodies<3>& bodies = scene.bodies;
    above_.resize(static_cast<std::size_t>(bodies.count()));
    speed_.resize(above_.size());
    drives_.resize(above_.size());
    const auto for_each_pair = [&](const auto& visit) {
        for (const Source& source : now.sources) {
            const auto i = static_cast<std::size_t>(source.index);
            if (source.of == Source::Of::contact)
                visit(now.contacts[i].a, now.contacts[i].b);
            if (source.of == Source::Of::joint)
                visit(scene.joints[i].a, scene.joints[i].b);
        }
    };
    for_each_pair([&](Index a, Index b) {
        for (const Index k : {a, b})
            if (k != world) {
                at(above_, k) = static_cast<int>(k);
                at(speed_, k) = at(drives_, k) = 0;
            }
    });
    for_each_pair([&](Index a, Index b) {
        if (bodies.can_move(a) && bodies.can_move(b))
            unite(above_, static_cast<int>(a), static_cast<int>(b));
    });
    const auto raise = [&](Index a, Index b, Real belt) {
        Real faster = 0;
        for (const Index k : {a, b})
            if (k != world) {
                const Vec<3> u = bodies.velocity(k);
                faster =
                    std::max(faster, u.head<2>().norm() +
                                         std::abs(u[2]) * farthest_point(scene, k));
            }
        for (const Index k : {a, b})
            if (k != world) {
                Real& V = of_island(speed_, k);
                V = std::max(V, faster + belt);
            }
    };
    for (const Source& source : now.sources) {
        const auto i = static_cast<std::size_t>(source.index);
        if (source.of == Source::Of::contact) {
            const Contact& contact = now.contacts[i];
            raise(contact.a, contact.b, std::abs(surface_of(scene, contact).belt));
        }
        if (source.of != Source::Of::joint) continue;
        const PointJoint& joint = scene.joints[i];
        raise(joint.a, joint.b, 0);
        const Real speed = drive_speed(scene, joint, 0);
        if (!(speed > 0)) continue;
        for (const Index k : {joint.a, joint.b})
            if (k != world && bodies.can_move(k)) {
                of_island(drives_, k) += reach_of(scene, joint) * speed;
                break;  // both are of one island
            }
    }
}
//! [fastest]

}  // namespace rigid
