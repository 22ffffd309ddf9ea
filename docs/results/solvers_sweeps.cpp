// Chapters 4, 6 and 8 on the task "find the impulses of a step": so many sweeps, and the error that is left.
#include "docs/results/one_step.hpp"

#include "chapters/04_pgs/conjugate_gradients.hpp"
#include "chapters/04_pgs/pgs.hpp"
#include "chapters/04_pgs/rates.hpp"
#include "chapters/06_sequential_impulse/block.hpp"
#include "chapters/06_sequential_impulse/row_order.hpp"
#include "chapters/06_sequential_impulse/sequential_impulse.hpp"

namespace rigid::results {
namespace {

/// So many sweeps, and no more: the points of a curve.
std::vector<int> ladder(const StepScene& scene)
{
    constexpr long most_visits = 8'000'000;
    std::vector<int> sweeps;
    for (long k = 1; k <= scene.most_sweeps; k *= 4) {
        if (k * scene.rows() * static_cast<long>(scene.steps.size()) > most_visits) break;
        sweeps.push_back(static_cast<int>(k));
    }
    return sweeps;
}

void add_pgs(Registry& registry, const SharedScene& scene, const std::string& method, int sweeps,
             const PgsSettings& how)
{
    const std::string parameters = "sweeps=" + std::to_string(sweeps) + " unit=row_visit";
    add_solver(registry, scene, "4", method, parameters, sweeps == 16, [=] {
        return [=, assembled = Assembler(), memory = PgsMemory(),
                solution = Solution()](const OneStep& step, std::size_t, Solved& out) mutable {
            const Mlcp& mlcp = assembled(step);
            PgsSettings settings = how;
            settings.tolerance = 0;
            settings.max_sweeps = sweeps;
            if (settings.sweeps == Sweeps::jacobi)
                settings.omega = std::min(1.0, 0.95 * safe_jacobi_omega(mlcp));
            cold_start(mlcp, solution.lambda);
            pgs(mlcp, settings, memory, solution);
            take(solution, mlcp.size() * (solution.iterations + memory.checks), out);
            out.sweeps = solution.iterations;
        };
    });
}

void add_conjugate_gradients(Registry& registry, const SharedScene& scene, int iterations)
{
    const std::string parameters = "sweeps=" + std::to_string(iterations) + " unit=row_visit";
    add_solver(registry, scene, "4", "conjugate_gradients", parameters, iterations == 16, [=] {
        return [=, assembled = Assembler(), memory = CgMemory(),
                solution = Solution()](const OneStep& step, std::size_t, Solved& out) mutable {
            const Mlcp& mlcp = assembled(step);
            solution.lambda.setZero(mlcp.size());
            conjugate_gradients(mlcp, 0, iterations, memory, solution);
            take(solution, mlcp.size() * (solution.iterations + 2), out);  // each multiplies with A once
            out.sweeps = solution.iterations;
        };
    });
}

enum class Kind { cold, warm, blocks };

void add_impulses(Registry& registry, const SharedScene& scene, const std::string& method, int sweeps,
                  Order order, ConstraintKind kind = Kind::cold)
{
    const std::string parameters = "sweeps=" + std::to_string(sweeps) + " unit=row_visit";
    const bool warm = kind == Kind::warm;
    add_solver(registry, scene, warm ? "8" : "6", method, parameters, sweeps == 16, [=] {
        ImpulseSettings settings;
        settings.max_sweeps = sweeps;
        settings.alternate = order == Order::alternating;
        struct Memory {
            ImpulseMemory<2> sweeps;
            Solution solution;
            ImpulseCache cache;
            Random random{1};
            Colouring colouring;
            std::vector<int> order;
            std::vector<Block> blocks;
            VecX u;
        };
        return [=, now = Memory()](const OneStep& step, std::size_t k, Solved& out) mutable {
            if (k == 0) {
                now.cache = {};
                now.random = Random(1);
            }
            if (warm) load(now.cache, step.keys, 1, now.solution.lambda);
            else now.solution.lambda.setZero(static_cast<Index>(step.rows.size()));
            now.u = step.u_star;
            order_rows(step.rows, now.u.size() / 2, order, now.random, now.colouring, now.order);
            if (kind == Kind::blocks)
                block_impulse<2>(step.rows, now.order, settings, now.sweeps, now.blocks, now.u, now.solution);
            else sequential_impulse<2>(step.rows, now.order, settings, now.sweeps, now.u, now.solution);
            if (warm) store(now.cache, step.keys, now.solution.lambda, 1);
            take(now.solution, now.sweeps.visits, out);
            out.sweeps = now.solution.iterations;
        };
    });
}

}  // namespace

void add_sweeps(Registry& registry, const SharedScene& scene)
{
    PgsSettings jacobi, symmetric, sor;
    jacobi.sweeps = Sweeps::jacobi;
    symmetric.sweeps = Sweeps::symmetric;
    sor.omega = scene->omega;
    const std::vector<int> points = ladder(*scene);
    for (const int sweeps : points) add_pgs(registry, scene, "jacobi", sweeps, jacobi);
    for (const int sweeps : points) add_pgs(registry, scene, "gauss_seidel", sweeps, {});
    for (const int sweeps : points) add_pgs(registry, scene, "symmetric_sweeps", sweeps, symmetric);
    for (const int sweeps : points) add_pgs(registry, scene, "sor", sweeps, sor);
    if (scene->bilateral)
        for (const int sweeps : points)
            if (sweeps <= 4 * scene->rows()) add_conjugate_gradients(registry, scene, sweeps);
    for (const int sweeps : points) add_impulses(registry, scene, "sequential_impulse", sweeps, Order::given);
    for (const int sweeps : points)
        add_impulses(registry, scene, "sequential_impulse_coloured", sweeps, Order::coloured);
    if (scene->steps.size() > 1)
        for (const int sweeps : points)
            add_impulses(registry, scene, "warm_impulses", sweeps, Order::given, Kind::warm);
    if (!scene->all_ways) return;
    for (const int sweeps : points) {
        add_impulses(registry, scene, "sequential_impulse_alternating", sweeps, Order::alternating);
        add_impulses(registry, scene, "sequential_impulse_shuffled", sweeps, Order::shuffled);
        add_impulses(registry, scene, "block_impulse", sweeps, Order::given, Kind::blocks);
    }
}

}  // namespace rigid::results
