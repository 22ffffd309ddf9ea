#include "chapters/03_mlcp_formulation/disc_step.hpp"
#include "chapters/04_pgs/pgs.hpp"
#include "chapters/05_lemke/lemke.hpp"
#include "chapters/08_warm_starting/small_steps.hpp"
#include "chapters/08_warm_starting/warm_step.hpp"
#include "chapters/09_active_sets/active_sets.hpp"
#include "tests/stress/method.hpp"

#include <memory>

namespace rigid::stress {

namespace {

/// Checks what the caller gave, once per run: the door of a program.
template <class Advance>
Step checked(Advance advance)
{
    return [advance = std::move(advance), checked = false](DiscScene& scene, Real h) mutable {
        if (!checked) require_valid(scene), require_step(h);
        checked = true;
        advance(scene, h);
    };
}

/// Throws if an answer calls itself solved and its residual, computed here, says that it isn't.
void require_honest(const Mlcp& mlcp, const Solution& solution)
{
    if (solution.status != Status::solved) return;
    // 1e-6 of the numbers in the problem: a thousand times what the solvers themselves ask for.
    const Real residual = natural_residual(mlcp, solution.lambda);
    if (!(residual <= 1e-6 * std::max(Real{1}, size_of_numbers(mlcp, solution.lambda))))
        throw std::runtime_error("an answer with the residual " + std::to_string(residual) +
                                 " m/s is called solved");
}

/// Chapter 3's step with a solver of the whole MLCP.
template <class Solve>
Step matrix_step(Solve solve)
{
    const auto now = std::make_shared<DiscStep>();
    return checked([now, solve](DiscScene& scene, Real h) {
        DiscSettings settings;
        settings.h = h;
        settings.gravity = scene.gravity;
        step(scene, settings, solve, *now);
        require_honest(now->mlcp, now->solution);
    });
}

Method pgs_method(const std::string& name, Sweeps sweeps, Real omega, int most, Real tolerance)
{
    Method method;
    method.chapter = 4;
    method.name = name;
    method.budget =
        tolerance > 0 ? "to " + std::to_string(tolerance) + " m/s" : std::to_string(most) + " sweeps";
    method.start = [=](const Wish&) {
        const auto memory = std::make_shared<PgsMemory>();
        return matrix_step([=](const Mlcp& mlcp, Solution& solution) {
            PgsSettings settings;
            settings.sweeps = sweeps;
            settings.omega = omega;
            settings.max_sweeps = most;
            settings.tolerance = tolerance;
            cold_start(mlcp, solution.lambda);
            pgs(mlcp, settings, *memory, solution);
        });
    };
    return method;
}

Method lemke_method()
{
    Method method;
    method.chapter = 5;
    method.name = "lemke";
    method.budget = "exact";
    method.most_rows = 100;
    method.start = [](const Wish&) { return matrix_step([](const Mlcp& mlcp) { return lemke(mlcp); }); };
    return method;
}

/// Chapter 6 as it is: an error of position is left alone.
Method impulses(const std::string& name, Order order)
{
    Method method;
    method.chapter = 6;
    method.name = name;
    method.budget = "10 sweeps";
    method.has_restitution = true;
    method.start = [=](const Wish& wish) {
        const auto now = std::make_shared<ImpulseStep>();
        return checked([=](DiscScene& scene, Real h) {
            ImpulseStepSettings settings;
            settings.h = h;
            settings.gravity = scene.gravity;
            settings.restitution = std::max(Real{0}, wish.restitution);
            settings.order = order;
            impulse_step(scene, settings, *now);
        });
    };
    return method;
}

/// What the ways of chapters 7 and 8 have in common.
template <class Settings>
Settings spending(const DiscScene& scene, Real h, const Wish& wish, Stabilizer stabilizer, int sweeps,
                  int repaying, int substeps)
{
    Settings settings;
    settings.h = h;
    settings.gravity = scene.gravity;
    settings.restitution = std::max(Real{0}, wish.restitution);
    settings.sweeps.max_sweeps = sweeps;
    settings.stabilizer.method = stabilizer;
    if (wish.beta >= 0) settings.stabilizer.beta = wish.beta;
    settings.stabilizer.repaying_sweeps = repaying;
    settings.substeps = substeps;
    return settings;
}

std::string budget(int sweeps, int repaying, int substeps)
{
    std::string words = std::to_string(sweeps * substeps) + " sweeps";
    if (repaying > 0)
        words = std::to_string(sweeps * substeps) + " + " + std::to_string(repaying * substeps) + " sweeps";
    return substeps > 1 ? words + " in " + std::to_string(substeps) + " substeps" : words;
}

Method cold(const std::string& name, Stabilizer stabilizer, int sweeps, int repaying, int substeps)
{
    Method method;
    method.chapter = 7;
    method.name = name;
    method.budget = budget(sweeps, repaying, substeps);
    method.has_beta = stabilizer != Stabilizer::none;
    method.has_restitution = true;
    method.start = [=](const Wish& wish) {
        const auto now = std::make_shared<StabilizedStep>();
        return checked([=](DiscScene& scene, Real h) {
            stabilized_step(
                scene,
                spending<StabilizedStepSettings>(scene, h, wish, stabilizer, sweeps, repaying, substeps),
                *now);
        });
    };
    return method;
}

Method warm(const std::string& name, Stabilizer stabilizer, int sweeps, int repaying, int substeps,
            Start start = Start::yesterday)
{
    Method method = cold(name, stabilizer, sweeps, repaying, substeps);
    method.chapter = 8;
    method.start = [=](const Wish& wish) {
        const auto now = std::make_shared<WarmStep>();
        return checked([=](DiscScene& scene, Real h) {
            WarmStepSettings settings =
                spending<WarmStepSettings>(scene, h, wish, stabilizer, sweeps, repaying, substeps);
            settings.start = start;
            warm_step(scene, settings, *now);
        });
    };
    return method;
}

/// The two presets of chapter 8.
Method preset(const std::string& name, const SmallStepSettings& chosen)
{
    Method method;
    method.chapter = 8;
    method.name = name;
    method.budget = std::to_string(chosen.substeps) + " substeps of one sweep, the first step to the end";
    method.start = [=](const Wish&) {
        const auto now = std::make_shared<SmallStep>();
        return checked([=](DiscScene& scene, Real h) {
            SmallStepSettings settings = chosen;
            settings.h = h;
            settings.gravity = scene.gravity;
            small_steps(scene, settings, *now);
        });
    };
    return method;
}

/// Chapter 9 on chapter 3's step.
Method active_sets_method()
{
    Method method;
    method.chapter = 9;
    method.name = "active sets";
    method.budget = "exact";
    method.start = [](const Wish&) {
        const auto memory = std::make_shared<ActiveSetMemory>();
        return matrix_step(
            [memory](const Mlcp& mlcp, Solution& solution) { active_sets(mlcp, {}, *memory, solution); });
    };
    return method;
}

/// Chapter 9 on chapter 7's small steps: the rows of a substep are solved exactly, from yesterday's set.
Method exact_substeps(const std::string& name, Stabilizer stabilizer, Real beta, int substeps)
{
    Method method;
    method.chapter = 9;
    method.name = name;
    method.budget = "exact, " + std::to_string(substeps) + " substeps";
    method.has_beta = true;
    method.has_restitution = true;
    method.start = [=](const Wish& wish) {
        struct Memory {
            StabilizedStep now;
            AssemblyScratch scratch;
            Mlcp mlcp;
            ActiveSetMemory sets;
        };
        const auto memory = std::make_shared<Memory>();
        return checked([=](DiscScene& scene, Real h) {
            StabilizedStep& now = memory->now;
            auto settings = spending<StabilizedStepSettings>(scene, h, wish, stabilizer, 1, 1, substeps);
            if (wish.beta < 0) settings.stabilizer.beta = beta;
            find_step_contacts(scene, settings, now);
            for (int n = 0; n < substeps; ++n) {
                substep_rows(scene, settings, h / substeps, now);
                assemble(now.rows, now.u_star, memory->scratch, memory->mlcp);
                active_sets(memory->mlcp, {}, memory->sets, now.solution);
                require_honest(memory->mlcp, now.solution);
                scene.bodies.u = now.u_star;
                apply(now.rows, now.solution.lambda, scene.bodies.u);
                scene.bodies.x += h / substeps * scene.bodies.u;
            }
            if (stabilizer == Stabilizer::projection)
                project_positions<2>(DiscConstraintAt{scene, now}, now.constraints.size(), {},
                                     scene.links.size(), scene.bodies.inverse_mass, settings.stabilizer, h,
                                     now.goal, scene.bodies.x);
        });
    };
    return method;
}

}  // namespace

std::vector<Method> methods()
{
    return {pgs_method("jacobi", Sweeps::jacobi, 0.5, 10, 0),
            pgs_method("gauss_seidel", Sweeps::gauss_seidel, 1, 10, 0),
            pgs_method("symmetric", Sweeps::symmetric, 1, 10, 0),
            pgs_method("sor 1.3", Sweeps::gauss_seidel, 1.3, 10, 0),
            pgs_method("gauss_seidel to the end", Sweeps::gauss_seidel, 1, 5000, 1e-6),
            lemke_method(),
            impulses("impulses", Order::given),
            impulses("coloured impulses", Order::coloured),
            cold("baumgarte", Stabilizer::baumgarte, 10, 0, 1),
            cold("relaxation", Stabilizer::relaxation, 6, 4, 1),
            cold("split impulse", Stabilizer::split_impulse, 5, 5, 1),
            cold("projection", Stabilizer::projection, 5, 5, 1),
            cold("substeps", Stabilizer::baumgarte, 1, 0, 10),
            warm("warm baumgarte", Stabilizer::baumgarte, 10, 0, 1),
            warm("best multiple", Stabilizer::baumgarte, 10, 0, 1, Start::best_multiple),
            warm("warm relaxation", Stabilizer::relaxation, 6, 4, 1),
            warm("warm split impulse", Stabilizer::split_impulse, 5, 5, 1),
            warm("warm projection", Stabilizer::projection, 5, 5, 1),
            warm("warm substeps", Stabilizer::baumgarte, 1, 0, 10),
            preset("quick steps", quick_steps()),
            preset("careful steps", careful_steps()),
            active_sets_method(),
            exact_substeps("exact steps", Stabilizer::baumgarte, 0.2, 1),
            exact_substeps("exact substeps", Stabilizer::baumgarte, 0.05, 16),
            exact_substeps("exact projected", Stabilizer::projection, 0.5, 4)};
}

}  // namespace rigid::stress
