// Chapters 11 to 13 step bodies that turn: sweeps, small steps, exact answers, RATTLE.
#include "docs/results/turning_runs.hpp"

#include "chapters/12_contact_manifolds/manifold_method.hpp"
#include "chapters/13_friction/friction_solver.hpp"

namespace rigid::results {
namespace {

/// A run of the one step by this method. \tparam Scene  what the method knows of the scene
template <class Scene, class Method>
auto stepping(const TurningScene& run, int substeps, Method method)
{
    return [settings = StepSettings{.h = run.h(), .substeps = substeps}, method = std::move(method),
            now = StepData<3>()](JointedScene& scene, std::int64_t& work, bool& solved) mutable {
        rigid::step(static_cast<Scene&>(scene), settings, method, now);
        if (method.solver.is_exact) {
            solved = solved && method.solver.unsolved == 0;
            work += settings.substeps;
        } else work += now.visits;
    };
}

std::string text(int sweeps, int substeps)
{
    return "sweeps=" + std::to_string(sweeps) +
           (substeps > 1 ? " substeps=" + std::to_string(substeps) : "") + " unit=row_visit";
}

/// Chapter 8's ways with friction: the last impulses, or the best multiple of them in small steps of one sweep each.
template <class Scene, class Sweeps>
void add_sweeps(Registry& registry, const SharedTurning& run, const std::string& chapter,
                const std::string& prefix)
{
    for (const int sweeps : {10, 40})
        add_turning_run(registry, run, chapter, prefix + "sweeps", text(sweeps, 1), run->quick, [=] {
            Sweeps method;
            method.correction.method = Stabilizer::projection;
            method.start.from = Start::previous;
            method.solver.sweeps.max_sweeps = sweeps;
            return stepping<Scene>(*run, 1, std::move(method));
        });
    for (const int substeps : {4, 8, 16, 32})
        add_turning_run(registry, run, chapter, prefix + "small_steps", text(1, substeps), run->quick, [=] {
            Sweeps method;
            method.correction.method = Stabilizer::projection;
            method.correction.beta = 1;
            method.correction.correction_sweeps = 1;
            method.correction.at_the_end = true;
            method.solver.sweeps.max_sweeps = 1;
            return stepping<Scene>(*run, substeps, std::move(method));
        });
}

template <class Scene, class Exact>
void add_exact_steps(Registry& registry, const SharedTurning& run, const std::string& chapter,
                     const std::string& name)
{
    for (const int substeps : {1, 4, 16})
        add_turning_run(registry, run, chapter, name, "substeps=" + std::to_string(substeps) + " unit=solve",
                        run->quick, [=] {
                            Exact method;
                            if constexpr (requires { method.correction.method; })
                                method.correction = exact_correction();
                            return stepping<Scene>(*run, substeps, std::move(method));
                        });
}

}  // namespace

void add_turning_methods(Registry& registry, const SharedTurning& run)
{
    if (run->scene.joints.empty()) {
        add_sweeps<RoughScene, FrictionSweeps<Manifolds>>(registry, run, "13", "friction_");
        add_exact_steps<RoughScene, ExactFriction<Manifolds>>(registry, run, "13", "exact_friction");
    } else {
        add_sweeps<RigidScene, RigidSweeps>(registry, run, "11", "rods_");
        add_exact_steps<RigidScene, RigidExact>(registry, run, "11", "exact_rods");
        add_exact_steps<RigidScene, RigidRattle>(registry, run, "11", "rattle");
    }
}

}  // namespace rigid::results
