/// Chapter 7: what each way to correct a position error reaches for the same number of row visits.
///
///     error/SCENE/WAY/S   a whole run with S sweeps a step, spent in different ways: error, visits, time of a step
///
/// Scenes: a hanging chain of 20 with 10 kg at its end, a column of 20, the ten discs (error: the largest of any
/// link or contact in the second half of the run), and a swinging chain of 10 (error: where its end is after 1 s,
/// against chain_in_angles.hpp).

#include "chapters/03_mlcp_formulation/program/ten_disc_scene.hpp"
#include "chapters/07_baumgarte/benchmark/chain_in_angles.hpp"
#include "chapters/07_baumgarte/corrected_method.hpp"
#include "common/measure.hpp"
#include "common/program/scripted_pointer.hpp"

#include <benchmark/benchmark.h>

#include <functional>

using namespace rigid;

namespace {

struct Way {
    const char* name;
    Stabilizer method;
    Real beta;
    bool small_steps = false;  ///< the budget buys substeps of one sweep
};

/// What leaves a velocity behind corrects a fifth in a step, what leaves none all of it.
constexpr Way ways[] = {{"none", Stabilizer::none, 0},
                        {"baumgarte", Stabilizer::baumgarte, 0.2},
                        {"relaxation", Stabilizer::relaxation, 0.2},
                        {"split_impulse", Stabilizer::split_impulse, 1},
                        {"projection", Stabilizer::projection, 1},
                        {.name = "small_baumgarte",
                         .method = Stabilizer::baumgarte,
                         .beta = 0.2,
                         .small_steps = true},
                        {.name = "small_relaxation",
                         .method = Stabilizer::relaxation,
                         .beta = 0.2,
                         .small_steps = true},
                        {.name = "small_projection",
                         .method = Stabilizer::projection,
                         .beta = 1,
                         .small_steps = true}};

DiscScene free_chain(DiscScene chain)
{
    chain.linked = PairSet::all();
    return chain;
}

Vec2 swung_end()
{
    static const Vec2 end = [] {
        ChainInAngles chain(VecX::Ones(10), 0.1, pi / 2, 9.81);
        for (int k = 0; k < 10000; ++k) chain.step(1e-4);
        return chain.tip();
    }();
    return end;
}

struct Problem {
    const char* name;
    std::function<DiscScene()> make;
    int steps;
    Real h;
    bool steered = false, swings = false;
};

const std::vector<Problem>& problems()
{
    static const std::vector<Problem> all = {
        {"chain", [] { return free_chain(hanging_chain(20, 10)); }, 1200, 1.0 / 60},
        {"column", [] { return column_between_walls(20); }, 1200, 1.0 / 60},
        {.name = "ten_discs",
         .make = [] { return ten_discs(); },
         .steps = 1200,
         .h = 1.0 / 120,
         .steered = true},
        {.name = "swing",
         .make = [] { return free_chain(swinging_chain(10)); },
         .steps = 60,
         .h = 1.0 / 60,
         .swings = true}};
    return all;
}

/// The budget is spent on sweeps and on correcting sweeps, or on substeps.
void spend(const Problem& problem, const Way& way, int budget,
           StepSettings& settings, CorrectedMethod& method)
{
    settings.h = problem.h;
    method.correction.method = way.method;
    method.correction.beta = way.beta;
    const int passes =
        way.method == Stabilizer::none || way.method == Stabilizer::baumgarte ? 1
                                                                              : 2;
    const int share = std::max(1, budget / passes);
    settings.substeps = way.small_steps ? share : 1;
    method.solver.sweeps.max_sweeps = method.correction.correction_sweeps =
        way.small_steps ? 1 : share;
    if (problem.steered) settings.stiffness = settings.damping = 1;
}

struct Outcome {
    Real error = 0;   ///< [m]
    Real visits = 0;  ///< in a step, on average
};

Outcome run(const Problem& problem, const Way& way, int budget)
{
    DiscScene scene = problem.make();
    StepSettings settings;
    CorrectedMethod method;
    spend(problem, way, budget, settings, method);
    StepData<2> now;
    const View box = {{0, 0}, scene.half_size};
    const ScriptedPointer pointer(1, box);
    Outcome outcome;
    for (int k = 0; k < problem.steps; ++k) {
        if (problem.steered)
            scene.gravity = steered_gravity(
                {.pointer = pointer.at(k * settings.h), .present = true}, box,
                9.81);
        step(scene, settings, method, now);
        outcome.visits += static_cast<Real>(now.visits) / problem.steps;
        const Real off =
            std::max(largest_link_error(scene), deepest_penetration(scene));
        if (!(off < 10)) {  // flown apart: at the edge of the plot
            outcome.error = 10;
            return outcome;
        }
        if (2 * k >= problem.steps && !problem.swings)
            outcome.error = std::max(outcome.error, off);
    }
    if (problem.swings)
        outcome.error = (scene.bodies.position(10) - swung_end()).norm();
    return outcome;
}

void one_error(benchmark::State& state, const Problem& problem, const Way& way,
               int budget)
{
    swung_end();  // once, before the clock runs
    Outcome outcome;
    for (auto _ : state) outcome = run(problem, way, budget);
    state.counters["error_mm"] = 1000 * outcome.error;
    state.counters["visits"] = outcome.visits;
    state.counters["step_us"] = benchmark::Counter(
        problem.steps * 1e-6, benchmark::Counter::kIsIterationInvariantRate |
                                  benchmark::Counter::kInvert);
}

}  // namespace

int main(int argc, char** argv)
{
    for (const Problem& problem : problems())
        for (const Way& way : ways)
            for (int budget = 2; budget <= 256; budget *= 2) {
                const std::string name = std::string("error/") + problem.name +
                                         "/" + way.name + "/" +
                                         std::to_string(budget);
                benchmark::RegisterBenchmark(
                    name.c_str(),
                    [&problem, &way, budget](benchmark::State& state) {
                        one_error(state, problem, way, budget);
                    })
                    ->Iterations(1);
            }
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
    benchmark::RunSpecifiedBenchmarks();
    benchmark::Shutdown();
}
