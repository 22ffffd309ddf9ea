// The functions of joint_curvature.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/16_soft_constraints/joint_curvature.hpp"

namespace rigid {

std::int64_t find_curvatures(const RigidScene& scene, const StepData<3>& now,
                             RowsOfBodies& meet)
{
    std::int64_t evaluated = 0;
    meet.no_curvature<3>(now.rows.size());
    for (std::size_t i = 0; i < now.sources.size(); ++i) {
        if (now.sources[i].of != Source::Of::joint) continue;
        const auto j = static_cast<std::size_t>(now.sources[i].index);
        const RowCurvature K =
            joint_curvature(scene.bodies.x, scene.joints[j], 1e-6 * now.length);
        meet.set_curvature<3>(static_cast<int>(i), K.a, K.b);
        ++evaluated;
    }
    return evaluated;
}

}  // namespace rigid
