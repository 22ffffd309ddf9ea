#include "chapters/09_active_sets/dantzig.hpp"
#include "chapters/09_active_sets/exact_step.hpp"
#include "tests/stress/matrix_step.hpp"
#include "tests/stress/stabilized_settings.hpp"

namespace rigid::stress {

namespace {

/// Chapter 9 on chapter 3's step: all active rows at once, or one row at a time.
Method on_the_matrix(const std::string& name, bool one_at_a_time)
{
    struct Solve {
        bool one_at_a_time;
        ActiveSetMemory memory;
        void operator()(const Mlcp& mlcp, const Wish& wish, int first, Solution& solution)
        {
            ActiveSetSettings settings;
            spoil_solver(wish, first, {{"tolerance", &settings.tolerance, true}});
            if (one_at_a_time) dantzig(mlcp, settings, memory, solution);
            else active_sets(mlcp, settings, memory, solution);
        }
    };
    Method method = matrix_method(9, name, "exact", {{"tolerance", nullptr, true}},
                                  [one_at_a_time] { return Solve{one_at_a_time, {}}; });
    if (one_at_a_time) method.most_rows = 100;
    return method;
}

/// Chapter 9 on chapter 7's small steps. With `projection` the positions are repaid by five sweeps after the step.
Method on_small_steps(const std::string& name, const Spending& spending)
{
    Method method;
    method.chapter = 9;
    method.name = name;
    method.budget = "exact, " + std::to_string(spending.substeps) +
                    (spending.substeps > 1 ? " substeps" : " step");
    method.has_beta = true;
    method.has_restitution = true;
    StabilizedStepSettings names;
    method.settings = names_of(stabilized_settings(names));
    method.settings.push_back({"exactness", nullptr, true});
    method.start = [=](const std::shared_ptr<const Wish>& wish) {
        const auto now = std::make_shared<ExactStep>();
        return checked([=](DiscScene& scene, Real h) {
            auto settings = settings_for<StabilizedStepSettings>(scene, h, *wish, spending);
            std::vector<Setting> all = stabilized_settings(settings);
            ActiveSetSettings exactness;
            all.push_back({"exactness", &exactness.tolerance, true});
            spoil(*wish, all, settings);
            exact_step(scene, settings, exactness, *now);
            require_honest(now->mlcp, now->solution);
            if (spending.stabilizer == Stabilizer::split_impulse) require_honest(now->errors, now->repaying);
            if (spending.stabilizer == Stabilizer::projection)
                project_positions<2>(DiscConstraintAt{scene, *now}, now->constraints.size(), {},
                                     scene.links.size(), scene.bodies.inverse_mass, settings.stabilizer, h,
                                     now->goal, scene.bodies.x);
        });
    };
    return method;
}

}  // namespace

std::vector<Method> exact_methods(int sweeps)
{
    const int few = sweeps < 8 ? sweeps : 4;
    return {on_the_matrix("active sets", false),
            on_the_matrix("dantzig", true),
            on_small_steps("exact baumgarte", {Stabilizer::baumgarte, 1, 0, 1, infinity, 0.2}),
            on_small_steps("exact substeps", {Stabilizer::baumgarte, 1, 0, sweeps < 8 ? sweeps : 16, infinity, 0.05}),
            on_small_steps("exact projection", {Stabilizer::projection, 1, 5, few, infinity, 0.5}),
            on_small_steps("exact split", {Stabilizer::split_impulse, 1, 0, 1, infinity, 1}),
            on_small_steps("exact split substeps", {Stabilizer::split_impulse, 1, 0, sweeps < 8 ? sweeps : 16, infinity, 1})};
}

}  // namespace rigid::stress
