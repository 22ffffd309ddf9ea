// Chapters 6 to 8 step a scene: sweeps on the velocities, five ways to correct an error, the previous impulses.
#include "docs/results/runs.hpp"

#include "chapters/06_sequential_impulse/impulse_method.hpp"
#include "chapters/07_baumgarte/corrected_method.hpp"
#include "chapters/08_warm_starting/small_steps.hpp"
#include "chapters/08_warm_starting/warm_method.hpp"

namespace rigid::results {
namespace {

std::string sweeps_text(int sweeps, int substeps = 1)
{
    return "sweeps=" + std::to_string(sweeps) +
           (substeps > 1 ? " substeps=" + std::to_string(substeps) : "") + " unit=row_visit";
}

template <class Method>
Method coloured(int sweeps)
{
    Method method;
    method.solver.ordering = Order::coloured;
    method.solver.sweeps.max_sweeps = sweeps;
    return method;
}

/// A run of the one step by this method.
template <class Method>
auto stepping(const RunScene& run, Method method)
{
    return [settings = StepSettings{.h = run.h()}, method = std::move(method),
            now = StepData<2>()](DiscScene& scene, std::int64_t& work, bool&) mutable {
        step(scene, settings, method, now);
        work += now.visits;
    };
}

void add_plain(Registry& registry, const SharedRun& run, int sweeps)
{
    add_run(registry, run, "6", "sequential_impulse", sweeps_text(sweeps), sweeps == 10 && run->dense,
            [=] { return stepping(*run, coloured<ImpulseMethod>(sweeps)); });
}

/// One of chapter 7's ways, from a cold start in each step.
void add_stabilized(Registry& registry, const SharedRun& run, Stabilizer stabilizer, int sweeps)
{
    add_run(registry, run, "7", std::string(to_string(stabilizer)), sweeps_text(sweeps),
            sweeps == 10 && run->dense, [=] {
                auto method = coloured<CorrectedMethod>(sweeps);
                method.correction.method = stabilizer;
                return stepping(*run, std::move(method));
            });
}

/// The previous impulses; the error is repaid on the positions, which chapter 8 shows to be safe.
void add_warm(Registry& registry, const SharedRun& run, Start start, int sweeps)
{
    add_run(registry, run, "8", start == Start::previous ? "warm" : "warm_best_multiple", sweeps_text(sweeps),
            sweeps == 10 && run->dense, [=] {
                auto method = coloured<WarmMethod>(sweeps);
                method.correction.method = Stabilizer::projection;
                method.start.from = start;
                return stepping(*run, std::move(method));
            });
}

void add_small(Registry& registry, const SharedRun& run, const SmallStepSettings& preset,
               const std::string& method, int substeps, bool quick)
{
    add_run(registry, run, "8", method, sweeps_text(1, substeps), quick, [=] {
        SmallStepSettings settings = preset;
        settings.h = run->h();
        settings.substeps = substeps;
        settings.collides = run->engine.collides;
        return [settings, now = SmallStep()](DiscScene& scene, std::int64_t& work, bool&) mutable {
            small_steps(scene, settings, now);
            work += static_cast<std::int64_t>(now.rows.size()) *
                    (now.sweeps + settings.correction.correction_sweeps);
        };
    });
}

}  // namespace

void add_impulse_runs(Registry& registry, const SharedRun& run)
{
    for (const int sweeps : {10, 40}) add_plain(registry, run, sweeps);
    for (const Stabilizer stabilizer :
         {Stabilizer::baumgarte, Stabilizer::relaxation, Stabilizer::split_impulse, Stabilizer::projection})
        for (const int sweeps : {10, 40}) add_stabilized(registry, run, stabilizer, sweeps);
    for (const Start start : {Start::previous, Start::best_multiple})
        for (const int sweeps : {10, 40}) add_warm(registry, run, start, sweeps);
    for (const int substeps : {4, 8, 16, 32})
        add_small(registry, run, quick_steps(), "small_steps", substeps, substeps == 8 && run->dense);
    for (const int substeps : {16, 32})
        add_small(registry, run, careful_steps(), "careful_small_steps", substeps,
                  substeps == 16 && run->dense);
}

}  // namespace rigid::results
