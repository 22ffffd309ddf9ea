// Chapters 14 and 15 step bodies on joints: sweeps, small steps, and trees solved at once.
#include "docs/results/turning_runs.hpp"

#include "chapters/15_trees/tree_method.hpp"

namespace rigid::results {
namespace {

/// Which bodies touch, for a method whose contacts are manifolds.
template <class Method>
Method touching(const TurningScene& run, Method method)
{
    if constexpr (std::is_base_of_v<Manifolds, decltype(method.contacts)>) {
        method.contacts.finder.filter = forbid_pairs(run.scene.bodies.count(), run.apart);
        never_stop(method.contacts);
    }
    return method;
}

template <class Method>
auto stepping_joints(const TurningScene& run, int substeps, const Method& method)
{
    return [settings = StepSettings{.h = run.h(), .substeps = substeps}, method = touching(run, method),
            now = StepData<3>()](JointedScene& scene, std::int64_t& work, bool& solved) mutable {
        rigid::step(scene, settings, method, now);
        if constexpr (requires { method.solver.joints; }) {
            solved = solved && now.solution.status == Status::solved;
            work = 0;
            for (const JointFactor* const factor : {&method.solver.joints, &method.solver.apart})
                work += factor->tree.work.factored_rows + factor->tree.work.solved_rows;
        } else work += now.visits;
    };
}

template <class Contacts>
void add_methods(Registry& registry, const SharedTurning& run)
{
    const auto text = [](int sweeps, int substeps) {
        return "sweeps=" + std::to_string(sweeps) +
               (substeps > 1 ? " substeps=" + std::to_string(substeps) : "") + " unit=row_visit";
    };
    const auto sweep = [=](int sweeps) {
        JointSweeps<Contacts> method;
        method.correction.method = Stabilizer::projection;
        method.solver.sweeps.max_sweeps = sweeps;
        return method;
    };
    for (const int sweeps : {10, 40})
        add_turning_run(registry, run, "14", "joint_sweeps", text(sweeps, 1), run->quick,
                        [=] { return stepping_joints(*run, 1, sweep(sweeps)); });
    for (const int substeps : {4, 8, 16, 32})
        add_turning_run(registry, run, "14", "joint_small_steps", text(1, substeps), run->quick,
                        [=] { return stepping_joints(*run, substeps, sweep(1)); });
    const auto trees = [&](const std::string& name, int substeps, bool stiff) {
        add_turning_run(registry, run, "15", name, "substeps=" + std::to_string(substeps) + " unit=tree_row",
                        run->quick, [=] {
                            JointTrees<Contacts> method;
                            method.correction.stiff = stiff;
                            return stepping_joints(*run, substeps, method);
                        });
    };
    constexpr bool stiff = true;
    for (const int substeps : {1, 4, 16}) trees("trees", substeps, stiff);
    if (!run->touches)
        for (const int substeps : {1, 4, 16}) trees("trees_without_stiffness", substeps, !stiff);
}

}  // namespace

void add_joint_methods(Registry& registry, const SharedTurning& run)
{
    if (run->touches) add_methods<Manifolds>(registry, run);
    else add_methods<AllBodies>(registry, run);
}

}  // namespace rigid::results
