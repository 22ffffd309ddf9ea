#include "chapters/03_mlcp_formulation/disc_step.hpp"
#include "chapters/04_pgs/pgs.hpp"
#include "chapters/05_lemke/lemke.hpp"
#include "chapters/08_warm_starting/warm_step.hpp"
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

Method stabilized(const std::string& name, Stabilizer stabilizer, int sweeps, int repaying, int substeps)
{
    Method method;
    method.chapter = 7;
    method.name = name;
    method.budget = std::to_string(sweeps * substeps) +
                    (repaying ? " + " + std::to_string(repaying * substeps) : "") + " sweeps" +
                    (substeps > 1 ? " in " + std::to_string(substeps) + " substeps" : "");
    method.has_beta = stabilizer != Stabilizer::none;
    method.start = [=](const Wish& wish) {
        const auto now = std::make_shared<StabilizedStep>();
        return checked([=](DiscScene& scene, Real h) {
            StabilizedStepSettings settings;
            settings.h = h;
            settings.gravity = scene.gravity;
            settings.sweeps.max_sweeps = sweeps;
            settings.stabilizer.method = stabilizer;
            if (wish.beta >= 0) settings.stabilizer.beta = wish.beta;
            settings.stabilizer.repaying_sweeps = repaying;
            settings.substeps = substeps;
            stabilized_step(scene, settings, *now);
        });
    };
    return method;
}

Method warm(const std::string& name, Stabilizer stabilizer, int sweeps, int repaying, int substeps)
{
    Method method = stabilized(name, stabilizer, sweeps, repaying, substeps);
    method.chapter = 8;
    method.start = [=](const Wish& wish) {
        const auto now = std::make_shared<WarmStep>();
        return checked([=](DiscScene& scene, Real h) {
            WarmStepSettings settings;
            settings.h = h;
            settings.gravity = scene.gravity;
            settings.sweeps.max_sweeps = sweeps;
            settings.stabilizer.method = stabilizer;
            if (wish.beta >= 0) settings.stabilizer.beta = wish.beta;
            settings.stabilizer.repaying_sweeps = repaying;
            settings.substeps = substeps;
            settings.warm = true;
            warm_step(scene, settings, *now);
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
            stabilized("no repair", Stabilizer::none, 10, 0, 1),
            stabilized("baumgarte", Stabilizer::baumgarte, 10, 0, 1),
            stabilized("relaxation", Stabilizer::relaxation, 6, 4, 1),
            stabilized("split_impulse", Stabilizer::split_impulse, 5, 5, 1),
            stabilized("projection", Stabilizer::projection, 5, 5, 1),
            stabilized("substeps", Stabilizer::baumgarte, 1, 0, 10),
            warm("warm baumgarte", Stabilizer::baumgarte, 10, 0, 1),
            warm("warm relaxation", Stabilizer::relaxation, 6, 4, 1),
            warm("warm split_impulse", Stabilizer::split_impulse, 5, 5, 1),
            warm("warm projection", Stabilizer::projection, 5, 5, 1),
            warm("warm substeps", Stabilizer::baumgarte, 1, 0, 10),
            warm("warm relaxed substeps", Stabilizer::relaxation, 1, 1, 5),
            warm("warm projected substeps", Stabilizer::projection, 1, 1, 16)};
}

}  // namespace rigid::stress
