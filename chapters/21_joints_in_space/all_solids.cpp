// The functions of all_solids.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/21_joints_in_space/all_solids.hpp"

namespace rigid {

void require_bodies(const JointedSolids& scene)
{
    require_bodies(static_cast<const SolidScene&>(scene));
    const Index count = scene.bodies.count();
    for (std::size_t i = 0; i < scene.joints.size(); ++i) {
        const SpaceJoint& joint = scene.joints[i];
        const auto refuse = [i](const std::string& what) {
            throw std::invalid_argument("joint " + std::to_string(i) + " " + what);
        };
        if (joint.a < world || joint.a >= count || joint.b < 0 ||
            joint.b >= count || joint.a == joint.b)
            refuse("joins bodies " + std::to_string(joint.a) + " and " +
                   std::to_string(joint.b) + " among " + std::to_string(count));
        for (std::size_t c = 0; c < coordinates; ++c) {
            const Real lo = joint.lo[c], hi = joint.hi[c];
            const auto refuse_limits = [&](const std::string& why) {
                refuse("has the limits " + shortest(lo) + " and " + shortest(hi) +
                       " of coordinate " + std::to_string(c) + "; " + why);
            };
            if (!(lo <= hi) || lo == infinity || hi == -infinity)
                refuse_limits("a finite value must lie between them");
            const auto [least, most] = range_of(static_cast<Coordinate>(c));
            for (const Real limit : {lo, hi})
                if (std::isfinite(limit) && !(limit >= least && limit <= most))
                    refuse_limits("it lies between " + shortest(least) + " and " +
                                  shortest(most) +
                                  ", and so must a limit that is finite");
        }
        for (const Vec3& v : {joint.at_a, joint.at_b, joint.frame_a, joint.frame_b})
            if (!v.allFinite()) refuse("has a point or a frame that is not finite");
        if (joint.motor < -1 || joint.motor >= coordinates ||
            !(joint.force >= 0 && std::isfinite(joint.speed)))
            refuse("has a motor on coordinate " + std::to_string(joint.motor) +
                   " of the force " + shortest(joint.force) + " and the speed " +
                   shortest(joint.speed));
    }
}

void evaluate_constraints(const JointedSolids& scene, StepData<6>& now)
{
    now.constraints.resize(now.sources.size());
    JointPlace joint;
    for (std::size_t i = 0; i < now.sources.size(); ++i)
        now.constraints[i] = joint.row(scene, now.sources[i]);
}

}  // namespace rigid
