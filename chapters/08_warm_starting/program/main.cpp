/// Chapter 8: warm starting.

#include "chapters/04_pgs/rates.hpp"
#include "chapters/07_baumgarte/closed_forms.hpp"
#include "chapters/08_warm_starting/looped_trusses.hpp"
#include "chapters/08_warm_starting/program/warm_scenes.hpp"
#include "common/elementary.hpp"

#include <array>

using namespace rigid;

namespace {

/// The ten discs to the same residual as chapter 4.
Demo ten_discs_scene()
{
    // b = C/h, as chapter 4 has it
    std::vector<Tunable> shared = warm_tunables(2000, Stabilizer::baumgarte, 1);
    // k has the arrow keys here
    for (Tunable& tunable : shared) tunable.keys = Keys::none;
    Demo demo = warm_demo(
        "ten_discs",
        "Chapter 4's ten discs to the same residual in each step: count the sweeps",
        ten_discs_view, with(ten_discs_tunables(), shared), [](const Settings&) {
            WarmSetup setup = warm(ten_discs(), 1);
            setup.pointer = Pointer::steers;
            return setup;
        });
    set_up_ten_discs(demo);
    return demo;
}

/// (8.8): how far N equal discs sink in total that start from the previous answer [m]; the last settings are
/// remembered.
std::function<Real(const WarmState&)> sinking(Index N)
{
    return [N, sweeps = -1, h = Real{0},
            sunk = Real{0}](const WarmState& state) mutable {
        const int max_sweeps = state.method.solver.sweeps.max_sweeps;
        // a minute of matrix products
        if (N > 30 || max_sweeps > 200) return Real{0};
        if (max_sweeps != sweeps || state.step.h != h) {
            sweeps = max_sweeps;
            h = state.step.h;
            // The rows of the program: contacts from the lowest pair up, then the floor.
            const MatX line = line_problem(N, 1, 9.81 * h).A;
            const VecX carried = line_answer(N, 1, 9.81 * h);
            Eigen::PermutationMatrix<Eigen::Dynamic> floor_last(N);
            for (Index i = 0; i < N; ++i)
                floor_last.indices()[i] = static_cast<int>((i + N - 1) % N);
            const MatX A = floor_last * line * floor_last.transpose();
            sunk = sag(A, floor_last * carried, sweeps, 1, h).sum();
        }
        return sunk;
    };
}

Demo column_scene()
{
    return warm_demo(
        "column",
        "A column of N discs with ten sweeps a step: it falls through itself, or "
        "stands",
        {{0, 1.05}, {0.9, 1.2}},
        with({tunables::in_column("discs", 20, 200), tunables::top_mass(1)},
             warm_tunables(10, Stabilizer::none)),
        [](const Settings& settings) {
            const auto N = static_cast<Index>(settings["discs"]);
            WarmSetup setup =
                warm(column(N, settings["top_mass"]), 10 / static_cast<Real>(N));
            if (settings["top_mass"] == 1) setup.theory = sinking(N);
            return setup;
        });
}

Demo triangle_scene()
{
    return warm_demo(
        "triangle",
        "Discs packed as a triangle between walls: how many sweeps until it rests?",
        {{0, 0.95}, {1.15, 1.15}},
        with({tunables::base(1, 40)}, warm_tunables(10, Stabilizer::split_impulse)),
        [](const Settings& settings) {
            const auto base = static_cast<Index>(settings["base"]);
            return warm(triangle(base), 10 / static_cast<Real>(base));
        });
}

/// F1: the heavy disc on top is taken away.
Demo removed_scene()
{
    return warm_demo(
        "removed",
        "A heavy disc on two light ones is taken away: does the next one fly?",
        {{0, 0.42}, {0.9, 0.5}},
        with({tunables::top_mass(100, 1),
              tunables::count("when", "step before which it is taken away", 120, 1,
                              10000)},
             warm_tunables(10, Stabilizer::none)),
        [](const Settings& settings) {
            WarmSetup setup = warm(column(3, settings["top_mass"]), 1);
            setup.before = [](const Settings& now, const Input&, WarmState& state) {
                if (state.steps != static_cast<int>(now["when"])) return;
                DiscScene two = column(2);
                two.bodies.x = state.scene.bodies.x.head(4);
                two.bodies.u = state.scene.bodies.u.head(4);
                state.scene = std::move(two);
            };
            return setup;
        });
}

/// (8.18), of the mode that grows most. All rows are bilateral: the theory holds to the letter.
Real chain_rate(Index N, const WarmMethod& method)
{
    const bool in_the_bias = method.correction.method == Stabilizer::baumgarte;
    const Real beta = in_the_bias ? method.correction.beta : 0;
    const Real factor = method.start.from == Start::cold ? 0 : method.start.factor;
    Real largest = 0;
    for (Index mode = 0; mode < N; ++mode) {
        const Real theta =
            pi * static_cast<Real>(2 * mode + 1) / static_cast<Real>(2 * N);
        const Real gamma =
            rigid::pow(rigid::cos(theta), 2 * method.solver.sweeps.max_sweeps);
        largest = std::max(largest, step_rate(gamma, factor, beta));
    }
    return largest;
}

Demo chain_scene()
{
    return warm_demo(
        "hanging_chain",
        "A chain at rest whose memory and Baumgarte's bias build each other up",
        {{0, -1.05}, {1, 1.45}},
        with({tunables::links(20, 2, 60),
              tunables::at_start(
                  "weight", "",
                  "gravity in parts of 9.81 m/s²; small = linear for long", 1, 0,
                  1)},
             warm_tunables(10, Stabilizer::baumgarte)),
        [](const Settings& settings) {
            const auto N = static_cast<Index>(settings["links"]);
            WarmSetup setup =
                warm(never_meeting(hanging_chain(N)), 20 / static_cast<Real>(N));
            setup.scene.gravity *= settings["weight"];
            setup.theory = [N](const WarmState& state) {
                return chain_rate(N, state.method);
            };
            return setup;
        });
}

/// What (8.6) does in a step to the largest error of the five discs, if all that is remembered is used.
Real loop_rate(const WarmState& state)
{
    const WarmMethod& method = state.method;
    if (method.start.from != Start::previous || method.start.factor != 1 ||
        method.solver.ordering == Order::shuffled)
        return 0;
    const DiscScene scene = five_discs_in_loops();
    std::vector<Row<2>> rows;
    for (const Link& link : scene.links)
        rows.push_back(bilateral(distance_constraint(scene.bodies.x, link),
                                 scene.bodies.inverse_mass));
    std::vector<int> order;
    Colouring colouring;
    Random unused(1);
    order_rows(rows, scene.bodies.count(), method.solver.ordering, unused,
               colouring, order);
    const auto m = static_cast<Index>(rows.size());
    const auto at = [&](Index i) {
        return order.empty() ? static_cast<std::size_t>(i)
                             : static_cast<std::size_t>(order[std::size_t(i)]);
    };
    MatX A(m, m);
    for (Index j = 0; j < m; ++j) {
        VecX change = VecX::Zero(scene.bodies.u.size());
        rows[at(j)].apply(1, change);
        for (Index i = 0; i < m; ++i) A(i, j) = rows[at(i)].velocity(change);
    }
    const MatX there = gauss_seidel_matrix(A);
    // the rows from the last to the first
    const MatX back = gauss_seidel_matrix(A.reverse()).reverse();
    MatX G = MatX::Identity(m, m);
    for (int k = 0; k < method.solver.sweeps.max_sweeps; ++k)
        G = ((method.solver.ordering == Order::alternating && k % 2 == 1 ? back
                                                                         : there) *
             G)
                .eval();
    return rigid::pow(memory_rate(G), state.step.substeps);
}

/// The same, computed again where the settings are others.
std::function<Real(const WarmState&)> remembered_loop_rate()
{
    return [of = std::array<Real, 5>{-1, -1, -1, -1, -1},
            last = Real{0}](const WarmState& state) mutable {
        const WarmMethod& method = state.method;
        const std::array<Real, 5> now = {
            static_cast<Real>(method.solver.sweeps.max_sweeps),
            static_cast<Real>(state.step.substeps),
            static_cast<Real>(method.solver.ordering),
            static_cast<Real>(method.start.from), method.start.factor};
        if (now != of) last = loop_rate(state);
        of = now;
        return last;
    };
}

/// Rods in loops: what is remembered whole explodes, though nothing pulls.
Demo loop_scene()
{
    Demo demo =
        warm_demo("loop",
                  "Five discs and seven rods, nudged: a remembered impulse makes "
                  "them explode",
                  {{0.2, -0.15}, {1.1, 1.1}},
                  with({tunables::at_start("nudge", "m/s",
                                           "speed of one disc at the beginning",
                                           1e-6, 1e-9, 1)},
                       warm_tunables(1, Stabilizer::projection, 1)),
                  [](const Settings& settings) {
                      WarmSetup setup = warm(five_discs_in_loops(), 1);
                      setup.scene.bodies.u *= settings["nudge"] / 1e-6;
                      setup.theory = remembered_loop_rate();
                      return setup;
                  });
    preset(demo, "substeps", 8);
    return demo;
}

Demo swing_scene()
{
    return warm_demo("swinging_chain",
                     "A chain falls and swings, a heavy disc at its end: small "
                     "steps beat sweeps",
                     {{0, 0}, {1.1, 1.1}},
                     with({tunables::links(10, 1, 60), tunables::end_mass(10)},
                          warm_tunables(8, Stabilizer::projection, 1)),
                     [](const Settings& settings) {
                         const auto N = static_cast<Index>(settings["links"]);
                         return warm(
                             never_meeting(swinging_chain(N, settings["end_mass"])),
                             10 / static_cast<Real>(N));
                     });
}

}  // namespace

int main(int argc, char** argv)
{
    const auto make = [] {
        Program program;
        program.name = "08_warm_starting";
        program.title = "Chapter 8. Warm starting";
        program.scenes = {column_scene(),  ten_discs_scene(), removed_scene(),
                          chain_scene(),   loop_scene(),      swing_scene(),
                          triangle_scene()};
        return program;
    };
    return run_program(make, argc, argv);
}
