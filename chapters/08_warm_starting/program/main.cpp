/// Chapter 8: warm starting.

#include "chapters/04_pgs/rates.hpp"
#include "chapters/07_baumgarte/closed_forms.hpp"
#include "chapters/08_warm_starting/looped_trusses.hpp"
#include "chapters/08_warm_starting/program/warm_run.hpp"

#include <array>

using namespace rigid;

namespace {

Demo warm_scene(const std::string& name, const std::string& summary, const View& view)
{
    Demo scene;
    scene.name = name;
    scene.summary = summary;
    scene.view = view;
    scene.h = scene.h_high = 1.0 / 60;
    scene.h_low = 1e-4;
    scene.methods = start_names();
    scene.side_by_side = {"cold", "previous", "best_multiple"};
    scene.columns = warm_columns();
    return scene;
}

/// `first` in front of the tunables that all scenes share.
std::vector<Tunable> with(std::vector<Tunable> first, const std::vector<Tunable>& shared)
{
    first.insert(first.end(), shared.begin(), shared.end());
    return first;
}

Demo ten_discs_scene()
{
    Demo scene =
        warm_scene("ten_discs", "Chapter 4's ten discs to the same residual in each step: count the sweeps",
                   {{0, 0.03}, {0.8, 0.58}});
    scene.h = ten_discs_h;
    scene.h_low = ten_discs_h_low;
    scene.h_high = ten_discs_h_high;
    scene.steered = true;
    std::vector<Tunable> shared =
        warm_tunables(2000, Stabilizer::baumgarte, 1);           // b = C/h, as chapter 4 has it
    for (Tunable& tunable : shared) tunable.arrow_keys = false;  // k has the arrow keys here
    scene.tunables = with(ten_discs_tunables(), shared);
    scene.start = [view = scene.view](const Settings&) {
        return std::make_unique<WarmRun>(ten_discs(), 1, view, nullptr, nullptr, true);
    };
    return scene;
}

/// (8.8): how far N equal discs sink in total that start from the previous answer [m]; the last settings are
/// remembered.
WarmRun::Theory sinking(Index N)
{
    return [N, sweeps = -1, h = Real{0}, sunk = Real{0}](const StepSettings& settings,
                                                         const WarmMethod& method) mutable {
        const int max_sweeps = method.solver.sweeps.max_sweeps;
        if (N > 30 || max_sweeps > 200) return Real{0};  // a minute of matrix products
        if (max_sweeps != sweeps || settings.h != h) {
            sweeps = max_sweeps;
            h = settings.h;
            // The rows of the program: contacts from the lowest pair up, then the floor.
            const MatX line = line_problem(N, 1, 9.81 * h).A;
            const VecX carried = line_answer(N, 1, 9.81 * h);
            Eigen::PermutationMatrix<Eigen::Dynamic> floor_last(N);
            for (Index i = 0; i < N; ++i) floor_last.indices()[i] = static_cast<int>((i + N - 1) % N);
            const MatX A = floor_last * line * floor_last.transpose();
            sunk = sag(A, floor_last * carried, sweeps, 1, h).sum();
        }
        return sunk;
    };
}

Demo column_scene()
{
    Demo scene =
        warm_scene("column", "A column of N discs with ten sweeps a step: it falls through itself, or stands",
                   {{0, 1.05}, {0.9, 1.2}});
    scene.tunables = with({{"discs", "", "N, discs in the column", 20, 1, 200, true, true, false},
                           {"top_mass", "kg", "mass of the uppermost disc; the others have 1 kg", 1, 0.01,
                            1000, false, true, false}},
                          warm_tunables(10, Stabilizer::none));
    scene.start = [view = scene.view](const Settings& settings) {
        const auto N = static_cast<Index>(settings["discs"]);
        return std::make_unique<WarmRun>(column(N, settings["top_mass"]), 10 / static_cast<Real>(N), view,
                                         settings["top_mass"] == 1 ? sinking(N) : nullptr);
    };
    return scene;
}

Demo triangle_scene()
{
    Demo scene =
        warm_scene("triangle", "Discs packed as a triangle between walls: how many sweeps until it rests?",
                   {{0, 0.95}, {1.15, 1.15}});
    scene.tunables = with({{"base", "", "discs in the lowest row", 10, 1, 40, true, true, false}},
                          warm_tunables(10, Stabilizer::split_impulse));
    scene.start = [view = scene.view](const Settings& settings) {
        const auto base = static_cast<Index>(settings["base"]);
        return std::make_unique<WarmRun>(triangle(base), 10 / static_cast<Real>(base), view);
    };
    return scene;
}

/// F1: the heavy disc on top is taken away.
Demo removed_scene()
{
    Demo scene = warm_scene("removed", "A heavy disc on two light ones is taken away: does the next one fly?",
                            {{0, 0.42}, {0.9, 0.5}});
    scene.tunables =
        with({{"top_mass", "kg", "mass of the uppermost disc; the others have 1 kg", 100, 1, 1000, false,
               true, false},
              {"when", "", "step before which it is taken away", 120, 1, 10000, true, true, false}},
             warm_tunables(10, Stabilizer::none));
    scene.start = [view = scene.view](const Settings& settings) {
        const auto when = static_cast<int>(settings["when"]);
        const auto take_away = [when](DiscScene& discs, int step) {
            if (step != when) return;
            DiscScene two = column(2);
            two.bodies.x = discs.bodies.x.head(4);
            two.bodies.u = discs.bodies.u.head(4);
            discs = std::move(two);
        };
        return std::make_unique<WarmRun>(column(3, settings["top_mass"]), 1, view, nullptr, take_away);
    };
    return scene;
}

/// All rows bilateral: the theory of (8.10) holds to the letter.
Demo chain_scene()
{
    Demo scene =
        warm_scene("hanging_chain", "A chain at rest whose memory and Baumgarte's bias build each other up",
                   {{0, -1.05}, {1, 1.45}});
    scene.tunables = with({{"links", "", "N, links of 0.1 m", 20, 2, 60, true, true, false},
                           {"weight", "", "gravity in parts of 9.81 m/s²; small = linear for long", 1, 0, 1,
                            false, true, false}},
                          warm_tunables(10, Stabilizer::baumgarte));
    scene.start = [view = scene.view](const Settings& settings) {
        const auto N = static_cast<Index>(settings["links"]);
        DiscScene chain = hanging_chain(N);
        chain.linked = PairSet::all();
        chain.gravity *= settings["weight"];
        const auto rate = [N](const StepSettings&, const WarmMethod& method) {  // of the mode that grows most
            const bool in_the_bias = method.correction.method == Stabilizer::baumgarte;
            const Real beta = in_the_bias ? method.correction.beta : 0;
            const Real factor = method.start.from == Start::cold ? 0 : method.start.factor;
            Real largest = 0;
            for (Index mode = 0; mode < N; ++mode) {
                const Real theta = pi * static_cast<Real>(2 * mode + 1) / static_cast<Real>(2 * N);
                const Real gamma = std::pow(std::cos(theta), 2 * method.solver.sweeps.max_sweeps);
                largest = std::max(largest, step_rate(gamma, factor, beta));
            }
            return largest;
        };
        return std::make_unique<WarmRun>(std::move(chain), 20 / static_cast<Real>(N), view, rate);
    };
    return scene;
}

/// What (8.6) does in a step to the largest error of the five discs, if all that is remembered is used.
Real loop_rate(const StepSettings& settings, const WarmMethod& method)
{
    if (method.start.from != Start::previous || method.start.factor != 1 ||
        method.solver.ordering == Order::shuffled)
        return 0;
    const DiscScene scene = five_discs_in_loops();
    std::vector<Row<2>> rows;
    for (const Link& link : scene.links)
        rows.push_back(bilateral(distance_constraint(scene.bodies.x, link), scene.bodies.inverse_mass));
    std::vector<int> order;
    Colouring colouring;
    Random unused(1);
    order_rows(rows, scene.bodies.count(), method.solver.ordering, unused, colouring, order);
    const auto m = static_cast<Index>(rows.size());
    const auto at = [&](Index i) {
        return order.empty() ? static_cast<std::size_t>(i) : static_cast<std::size_t>(order[std::size_t(i)]);
    };
    MatX A(m, m);
    for (Index j = 0; j < m; ++j) {
        VecX change = VecX::Zero(scene.bodies.u.size());
        rows[at(j)].apply(1, change);
        for (Index i = 0; i < m; ++i) A(i, j) = rows[at(i)].velocity(change);
    }
    const MatX there = gauss_seidel_matrix(A);
    const MatX back = gauss_seidel_matrix(A.reverse()).reverse();  // the rows from the last to the first
    MatX G = MatX::Identity(m, m);
    for (int k = 0; k < method.solver.sweeps.max_sweeps; ++k)
        G = ((method.solver.ordering == Order::alternating && k % 2 == 1 ? back : there) * G).eval();
    return std::pow(memory_rate(G), settings.substeps);
}

/// Rods in loops: what is remembered whole explodes, though nothing pulls.
Demo loop_scene()
{
    Demo scene =
        warm_scene("loop", "Five discs and seven rods, nudged: a remembered impulse makes them explode",
                   {{0.2, -0.15}, {1.1, 1.1}});
    scene.tunables =
        with({{"nudge", "m/s", "speed of one disc at the beginning", 1e-6, 1e-9, 1, false, true, false}},
             warm_tunables(1, Stabilizer::projection, 1));
    for (Tunable& tunable : scene.tunables)
        if (tunable.name == "substeps") tunable.value = 8;
    scene.start = [view = scene.view](const Settings& settings) {
        DiscScene discs = five_discs_in_loops();
        discs.bodies.u *= settings["nudge"] / 1e-6;
        const auto rate = [asked = std::array<Real, 5>{-1, -1, -1, -1, -1},
                           last = Real{0}](const StepSettings& step, const WarmMethod& method) mutable {
            const std::array<Real, 5> now = {static_cast<Real>(method.solver.sweeps.max_sweeps),
                                             static_cast<Real>(step.substeps),
                                             static_cast<Real>(method.solver.ordering),
                                             static_cast<Real>(method.start.from), method.start.factor};
            if (now != asked) last = loop_rate(step, method);
            asked = now;
            return last;
        };
        return std::make_unique<WarmRun>(std::move(discs), 1, view, rate);
    };
    return scene;
}

Demo swing_scene()
{
    Demo scene = warm_scene("swinging_chain",
                            "A chain falls and swings, a heavy disc at its end: small steps beat sweeps",
                            {{0, 0}, {1.1, 1.1}});
    scene.tunables = with({{"links", "", "N, links of 0.1 m", 10, 1, 60, true, true, false},
                           {"end_mass", "kg", "mass of the last disc; the others have 1 kg", 10, 0.01, 1000,
                            false, true, false}},
                          warm_tunables(8, Stabilizer::projection, 1));
    scene.start = [view = scene.view](const Settings& settings) {
        const auto N = static_cast<Index>(settings["links"]);
        DiscScene chain = swinging_chain(N, settings["end_mass"]);
        chain.linked = PairSet::all();
        return std::make_unique<WarmRun>(std::move(chain), 10 / static_cast<Real>(N), view);
    };
    return scene;
}

}  // namespace

int main(int argc, char** argv)
{
    const auto make = [] {
        Program program;
        program.name = "08_warm_starting";
        program.title = "Chapter 8. Warm starting";
        program.scenes = {column_scene(), ten_discs_scene(), removed_scene(), chain_scene(),
                          loop_scene(),   swing_scene(),     triangle_scene()};
        return program;
    };
    return run_program(make, argc, argv);
}
