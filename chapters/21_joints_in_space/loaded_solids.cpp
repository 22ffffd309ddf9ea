// The functions of loaded_solids.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/21_joints_in_space/loaded_solids.hpp"

namespace rigid {

void LoadedSolids::forget()
{
    for (const int k : loaded_) {
        stiffness_[static_cast<std::size_t>(k)].setZero();
        is_loaded_[static_cast<std::size_t>(k)] = false;
    }
    loaded_.clear();
}

void LoadedSolids::sum_stiffness(const JointedSolids& scene, const StepData<6>& now)
{
    const auto count = static_cast<std::size_t>(scene.bodies.count());
    stiffness_.resize(count, Mat3::Zero());
    is_loaded_.resize(count, false);
    for (std::size_t i = 0; i < now.sources.size(); ++i) {
        const Real lambda = now.solution.lambda[static_cast<Index>(i)];
        if (now.sources[i].of != Source::Of::joint || lambda == 0) continue;
        const Constraint<6>& c = now.constraints[i];
        const SpaceJoint& joint = scene.joints[static_cast<std::size_t>(
            now.sources[i].index / joint_slots)];
        add(scene, c.a, joint.at_a, lambda * c.Ja.head<3>().transpose());
        add(scene, c.b, joint.at_b, lambda * c.Jb.head<3>().transpose());
    }
}

void LoadedSolids::add(const JointedSolids& scene, Index k, const Vec3& at,
                       const Vec3& impulse)
{
    if (k == world) return;
    const auto i = static_cast<std::size_t>(k);
    if (!is_loaded_[i]) loaded_.push_back(static_cast<int>(k));
    is_loaded_[i] = true;
    const Vec3 f = rotation_of(scene.bodies.x, k).transpose() * impulse;
    stiffness_[i] += turning_stiffness(f, at);
}

}  // namespace rigid
