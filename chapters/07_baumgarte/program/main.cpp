/// Chapter 7: Baumgarte and the other ways to correct a position error.

#include "chapters/03_mlcp_formulation/assembly.hpp"
#include "chapters/07_baumgarte/overlaps.hpp"
#include "chapters/07_baumgarte/program/scene_one_row.hpp"
#include "chapters/07_baumgarte/program/stabilized_scenes.hpp"

using namespace rigid;

namespace {

const std::vector<std::string> all_ways = {"baumgarte", "relaxation",
                                           "split_impulse", "projection"};

/// (7.9): how high a disc hops that lay so deep in the floor.
Theory hop(Real depth)
{
    return
        [depth](const StepSettings& step, const CorrectedMethod& method) -> Real {
            if (method.correction.method != Stabilizer::baumgarte) return 0;
            const Real v = -baumgarte_bias(-depth, ConstraintKind::unilateral,
                                           method.correction, step.part());
            return std::max(Real{0}, rise(v, 9.81, step.part()) - depth);
        };
}

Demo overlap_scene()
{
    Demo demo = stabilized_demo(
        "overlap",
        "A disc deep in the floor: what corrects it by velocity makes it jump",
        {{0, 0.75}, {1.2, 1.2}},
        {tunables::at_start("depth", "m", "how deep it lies in the floor", 0.1, 0,
                            0.4)},
        2, all_ways, [](const Settings& settings) {
            return stabilized(sunken_disc(settings["depth"]), 1,
                              hop(settings["depth"]));
        });
    preset(demo, "beta", 0.4);
    return demo;
}

Demo crowd_scene()
{
    return stabilized_demo(
        "crowd", "Ten discs that overlap by 0.2 m: what throws them out?",
        {{0, 3.4}, {1.9, 3.6}},
        {tunables::at_start("depth", "m", "of each overlap", 0.2, 0, 0.24)}, 200,
        all_ways, [](const Settings& settings) {
            return stabilized(crowd(10, settings["depth"]), 1);
        });
}

/// (7.8) or (7.21) for rows in a line; 0 where another way corrects.
Theory sag_theory(const DiscScene& scene)
{
    StepData<2> now;
    AllPairs{}.find(scene, {.margin = 1e-6}, now);
    evaluate_constraints(scene, now);
    // Walls beside a column touch and carry nothing.
    std::erase_if(now.constraints, [](const Constraint<2>& c) {
        return c.a == world && std::abs(c.Jb.x()) > 0.5;
    });
    std::vector<Row<2>> rows;
    for (const Constraint<2>& c : now.constraints)
        rows.push_back(bilateral(c, scene.bodies.inverse_mass));
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
    return [A, force, known = std::make_shared<Known>()](
               const StepSettings& step, const CorrectedMethod& method) -> Real {
        const StabilizerSettings& correction = method.correction;
        const int sweeps = method.solver.sweeps.max_sweeps;
        const bool split = correction.method == Stabilizer::split_impulse;
        if (!(split || correction.method == Stabilizer::baumgarte) ||
            correction.beta <= 0)
            return 0;
        if (method.solver.ordering != Order::given ||
            (step.substeps > 1 && method.start.factor > 0))
            return 0;
        const std::vector<Real> of = {
            step.h,       correction.beta, Real(step.substeps),
            Real(sweeps), correction.slop, Real(split)};
        if (of != known->of) {
            const Real h = step.part();
            known->of = of;
            const VecX C =
                split ? split_sag(A, h * force, sweeps, sweeps, correction.beta, h)
                      : sag(A, h * force, sweeps, correction.beta, h);
            known->answer = correction.slop + C.lpNorm<Eigen::Infinity>();
        }
        return known->answer;
    };
}

/// A chain or a column of `count` discs, the last of another mass.
Demo sagging_scene(const std::string& name, const std::string& summary,
                   const View& view, const Tunable& count,
                   const std::function<DiscScene(Index, Real)>& make, Real zoom)
{
    return stabilized_demo(
        name, summary, view, {count, tunables::end_mass(1)}, 16,
        {"baumgarte", "split_impulse", "projection"},
        [make, zoom, count = count.name](const Settings& settings) {
            const auto N = static_cast<Index>(settings[count]);
            const DiscScene discs = make(N, settings["end_mass"]);
            // In a line above or below each other; one disc is such a line.
            const bool at_rest =
                discs.bodies.count() < 2 || discs.bodies.position(1).x() == 0;
            return stabilized(discs, zoom / static_cast<Real>(N),
                              at_rest ? sag_theory(discs) : Theory{});
        });
}

Demo hanging_scene()
{
    return sagging_scene(
        "hanging_chain",
        "A chain that hangs: too few sweeps, and it sags by a formula",
        {{0, -1.45}, {0.6, 1.85}}, tunables::links(10, 1, 200),
        [](Index N, Real R) { return never_meeting(hanging_chain(N, R)); }, 20);
}

Demo swinging_scene()
{
    return sagging_scene(
        "swinging_chain", "A chain let go from the horizontal",
        {{0, -0.4}, {1.5, 1.6}}, tunables::links(10, 1, 200),
        [](Index N, Real R) { return never_meeting(swinging_chain(N, R)); }, 12);
}

Demo column_scene()
{
    return sagging_scene(
        "column",
        "A column between walls: too few sweeps, and it sinks by a formula",
        {{0, 1.1}, {0.6, 1.3}}, tunables::in_column("discs", 10),
        [](Index N, Real R) { return column_between_walls(N, R); }, 10);
}

Demo triangle_scene()
{
    return stabilized_demo(
        "triangle", "A triangle of discs between walls", {{0, 0.98}, {1.2, 1.3}},
        {tunables::base(1, 40)}, 32, {"baumgarte", "projection"},
        [](const Settings& settings) {
            const auto base = static_cast<Index>(settings["base"]);
            return stabilized(triangle(base), 10 / static_cast<Real>(base));
        });
}

Demo towed_scene()
{
    return stabilized_demo(
        "towed_discs", "A puck of 10 kg tows two discs of 1 kg over a table",
        {{0.3, 0.9}, {1.6, 1.6}},
        {tunables::at_start("push", "m/s", "speed of the puck, aside", 0.5, 0, 10)},
        8, {"baumgarte", "none"}, [](const Settings& settings) {
            StabilizedSetup setup = stabilized(towed_discs(), 1);
            setup.scene.bodies.velocity(0) = Vec2(0.2, 1) * settings["push"];
            return setup;
        });
}

Demo ten_discs_scene()
{
    Demo demo = stabilized_demo(
        "ten_discs", "The ten discs in a box that the pointer tilts",
        ten_discs_view, {}, 32, {"baumgarte", "projection"}, [](const Settings&) {
            StabilizedSetup setup = stabilized(ten_discs(), 1);
            setup.pointer = Pointer::steers;
            return setup;
        });
    set_up_ten_discs(demo);
    demo.h = 1.0 / 240;
    demo.tunables = with(demo.tunables, ten_discs_tunables());
    for (Tunable& tunable : demo.tunables)
        tunable.keys = tunable.name == "k" ? Keys::up_and_down : Keys::none;
    return demo;
}

}  // namespace

int main(int argc, char** argv)
{
    const auto make = [] {
        Program program;
        program.name = "07_baumgarte";
        program.title = "Chapter 7. Baumgarte";
        program.scenes = {ten_discs_scene(),    one_row_scene(true),
                          one_row_scene(false), overlap_scene(),
                          crowd_scene(),        hanging_scene(),
                          swinging_scene(),     column_scene(),
                          triangle_scene(),     towed_scene()};
        return program;
    };
    return run_program(make, argc, argv);
}
