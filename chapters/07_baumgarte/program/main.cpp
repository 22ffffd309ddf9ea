/// Chapter 7: Baumgarte and the other ways to correct a position error.

#include "chapters/03_mlcp_formulation/assembly.hpp"
#include "chapters/07_baumgarte/overlaps.hpp"
#include "chapters/07_baumgarte/program/scene_one_row.hpp"
#include "chapters/07_baumgarte/program/stabilized_run.hpp"

using namespace rigid;

namespace {

/// What all scenes of discs have in common.
Demo disc_scene(const std::string& name, const std::string& summary, const View& view, Real sweeps)
{
    Demo scene;
    scene.name = name;
    scene.summary = summary;
    scene.view = view;
    scene.h = 1.0 / 60;
    scene.h_low = 1e-4;
    scene.h_high = 1.0 / 20;
    scene.methods = stabilizer_names();
    scene.side_by_side = {"baumgarte", "projection"};
    scene.tunables = stabilizer_tunables(sweeps);
    scene.columns = stabilized_columns();
    return scene;
}

void set(Demo& scene, const std::string& name, Real value)
{
    for (Tunable& tunable : scene.tunables)
        if (tunable.name == name) tunable.value = value;
}

Demo overlap_scene()
{
    Demo scene = disc_scene("overlap", "A disc deep in the floor: what corrects it by velocity makes it jump",
                            {{0, 0.75}, {1.2, 1.2}}, 2);
    scene.side_by_side = {"baumgarte", "relaxation", "split_impulse", "projection"};
    set(scene, "beta", 0.4);
    scene.tunables.insert(scene.tunables.begin(),
                          {"depth", "m", "how deep it lies in the floor", 0.1, 0, 0.4, false, true, false});
    scene.start = [view = scene.view](const Settings& settings) {
        const Real depth = settings["depth"], g = 9.81;
        const auto hop = [depth, g](const StepSettings& step, const CorrectedMethod& method) {
            if (method.correction.method != Stabilizer::baumgarte) return Real{0};
            const Real v = -baumgarte_bias(-depth, ConstraintKind::unilateral, method.correction,
                                           step.part());  // (7.13)
            return std::max(Real{0}, rise(v, g, step.part()) - depth);
        };
        return std::make_unique<StabilizedRun>(sunken_disc(depth), 1, view, hop);
    };
    return scene;
}

Demo crowd_scene()
{
    Demo scene = disc_scene("crowd", "Ten discs that overlap by 0.2 m: what throws them out?",
                            {{0, 3.4}, {1.9, 3.6}}, 200);
    scene.side_by_side = {"baumgarte", "relaxation", "split_impulse", "projection"};
    scene.tunables.insert(scene.tunables.begin(),
                          {"depth", "m", "of each overlap", 0.2, 0, 0.24, false, true, false});
    scene.start = [view = scene.view](const Settings& settings) {
        return std::make_unique<StabilizedRun>(crowd(10, settings["depth"]), 1, view);
    };
    return scene;
}

/// (7.12) or (7.19) for rows in a line; 0 where another way corrects.
StabilizedRun::Theory sag_theory(const DiscScene& scene)
{
    StepData<2> now;
    AllPairs{}.find(scene, {.margin = 1e-6}, now);
    evaluate_constraints(scene, now);
    // Walls beside a column touch and carry nothing.
    std::erase_if(now.constraints,
                  [](const Constraint<2>& c) { return c.a == world && std::abs(c.Jb.x()) > 0.5; });
    std::vector<Row<2>> rows;
    for (const Constraint<2>& c : now.constraints) rows.push_back(bilateral(c, scene.bodies.inverse_mass));
    VecX gravity = VecX::Zero(scene.bodies.x.size());
    for (Index k = 0; k < scene.bodies.count(); ++k)
        if (scene.bodies.can_move(k)) gravity.segment<2>(2 * k) = scene.gravity;
    const Mlcp mlcp = assemble(rows, gravity);  // q = J g: one second of gravity
    const MatX A = mlcp.A;
    const VecX force = -A.partialPivLu().solve(mlcp.q);  // [N]
    struct Known {
        std::vector<Real> of;
        Real answer = 0;
    };
    return [A, force, known = std::make_shared<Known>()](const StepSettings& step,
                                                         const CorrectedMethod& method) -> Real {
        const StabilizerSettings& correction = method.correction;
        const int sweeps = method.solver.sweeps.max_sweeps;
        const bool split = correction.method == Stabilizer::split_impulse;
        if (!(split || correction.method == Stabilizer::baumgarte) || correction.beta <= 0) return 0;
        if (method.solver.ordering != Order::given || (step.substeps > 1 && method.start.factor > 0))
            return 0;
        const std::vector<Real> of = {step.h,       correction.beta, Real(step.substeps),
                                      Real(sweeps), correction.slop, Real(split)};
        if (of != known->of) {
            const Real h = step.part();
            known->of = of;
            const VecX C = split ? split_sag(A, h * force, sweeps, sweeps, correction.beta, h)
                                 : sag(A, h * force, sweeps, correction.beta, h);
            known->answer = correction.slop + C.lpNorm<Eigen::Infinity>();
        }
        return known->answer;
    };
}

Demo sagging_scene(const std::string& name, const std::string& summary, const View& view,
                   const Tunable& count, std::function<DiscScene(Index, Real)> make, Real zoom)
{
    Demo scene = disc_scene(name, summary, view, 16);
    scene.side_by_side = {"baumgarte", "split_impulse", "projection"};
    scene.tunables.insert(scene.tunables.begin(), {"end_mass", "kg", "of the last disc; the others have 1 kg",
                                                   1, 0.01, 1000, false, true, false});
    scene.tunables.insert(scene.tunables.begin(), count);
    scene.start = [view, make, zoom, name = count.name](const Settings& settings) {
        const auto N = static_cast<Index>(settings[name]);
        DiscScene discs = make(N, settings["end_mass"]);
        // In a line above or below each other; one disc is such a line.
        const bool at_rest = discs.bodies.count() < 2 || discs.bodies.position(1).x() == 0;
        return std::make_unique<StabilizedRun>(discs, zoom / static_cast<Real>(N), view,
                                               at_rest ? sag_theory(discs) : StabilizedRun::Theory{});
    };
    return scene;
}

/// A chain whose discs are there to be seen: they do not collide.
DiscScene free_chain(DiscScene chain)
{
    chain.linked = PairSet::all();
    return chain;
}

Demo triangle_scene()
{
    Demo scene = disc_scene("triangle", "A triangle of discs between walls", {{0, 0.98}, {1.2, 1.3}}, 32);
    scene.tunables.insert(scene.tunables.begin(),
                          {"base", "", "discs on the floor", 10, 1, 40, true, true, false});
    scene.start = [view = scene.view](const Settings& settings) {
        const auto base = static_cast<Index>(settings["base"]);
        return std::make_unique<StabilizedRun>(triangle(base), 10 / static_cast<Real>(base), view);
    };
    return scene;
}

Demo towed_scene()
{
    Demo scene = disc_scene("towed_discs", "A puck of 10 kg tows two discs of 1 kg over a table",
                            {{0.3, 0.9}, {1.6, 1.6}}, 8);
    scene.side_by_side = {"baumgarte", "none"};
    scene.tunables.insert(scene.tunables.begin(),
                          {"push", "m/s", "speed of the puck, aside", 0.5, 0, 10, false, true, false});
    scene.start = [view = scene.view](const Settings& settings) {
        DiscScene discs = towed_discs();
        discs.bodies.velocity(0) = Vec2(0.2, 1) * settings["push"];
        return std::make_unique<StabilizedRun>(std::move(discs), 1, view);
    };
    return scene;
}

Demo ten_discs_scene()
{
    Demo scene = disc_scene("ten_discs", "The ten discs in a box that the pointer tilts",
                            {{0, 0.03}, {0.8, 0.58}}, 32);
    scene.h = 1.0 / 240;
    scene.h_low = ten_discs_h_low;
    scene.h_high = ten_discs_h_high;
    scene.steered = true;
    const std::vector<Tunable> shared = ten_discs_tunables();
    scene.tunables.insert(scene.tunables.end(), shared.begin(), shared.end());
    for (Tunable& tunable : scene.tunables) tunable.arrow_keys = tunable.name == "k";
    scene.start = [view = scene.view](const Settings&) {
        return std::make_unique<StabilizedRun>(ten_discs(), 1, view, StabilizedRun::Theory{}, true);
    };
    return scene;
}

}  // namespace

int main(int argc, char** argv)
{
    const auto make = [] {
        const Tunable links = {"links", "", "N, links of 0.1 m", 10, 1, 200, true, true, false};
        const Tunable discs = {"discs", "", "N, discs in the column", 10, 1, 100, true, true, false};
        Program program;
        program.name = "07_baumgarte";
        program.title = "Chapter 7. Baumgarte";
        program.scenes = {ten_discs_scene(),
                          one_row_scene(true),
                          one_row_scene(false),
                          overlap_scene(),
                          crowd_scene(),
                          sagging_scene(
                              "hanging_chain", "A chain that hangs: too few sweeps, and it sags by a formula",
                              {{0, -1}, {0.6, 1.4}}, links,
                              [](Index N, Real R) { return free_chain(hanging_chain(N, R)); }, 20),
                          sagging_scene(
                              "swinging_chain", "A chain let go from the horizontal", {{0, -0.4}, {1.5, 1.6}},
                              links, [](Index N, Real R) { return free_chain(swinging_chain(N, R)); }, 12),
                          sagging_scene(
                              "column", "A column between walls: too few sweeps, and it sinks by a formula",
                              {{0, 1.1}, {0.6, 1.3}}, discs,
                              [](Index N, Real R) { return column_between_walls(N, R); }, 10),
                          triangle_scene(),
                          towed_scene()};
        return program;
    };
    return run_program(make, argc, argv);
}
