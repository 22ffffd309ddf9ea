#include "chapters/06_sequential_impulse/impulse_method.hpp"
#include "chapters/08_warm_starting/small_steps.hpp"
#include "chapters/08_warm_starting/warm_method.hpp"
#include "tests/stress/stepping.hpp"

namespace rigid::stress {

namespace {

/// The answer of the last sub-step, if its λ is that of the rows: relaxation goes on with other biases.
struct HonestAnswer {
    HonestRows rows;
    bool lambda_is_of_these_rows = true;

    template <class Solving>
    void operator()(const Solving&, const StepData<2>& now)
    {
        rows.look(now, lambda_is_of_these_rows);
    }
};

/// Chapter 6 as it is: an error of position is left alone.
Method impulses(const std::string& name, int sweeps, Order order, bool in_pairs = false)
{
    ImpulseMethod by;
    by.solver.ordering = order;
    by.solver.in_pairs = in_pairs;
    by.solver.sweeps.max_sweeps = sweeps;
    return stepping(6, name, std::to_string(sweeps) + " sweeps", by, 1, HonestAnswer{});
}

template <class Solving>
Method spending_method(int chapter, const std::string& name, const Spending& spending, Solving by)
{
    const bool at_the_end = by.correction.at_the_end;
    by.correction = correction_of(spending);
    by.correction.at_the_end = at_the_end;
    by.solver.sweeps.max_sweeps = spending.sweeps;
    return stepping(chapter, name, budget(spending), by, spending.substeps,
                    HonestAnswer{{}, spending.correction != Stabilizer::relaxation});
}

Method cold(const std::string& name, const Spending& spending)
{
    return spending_method(7, name, spending, CorrectedMethod{});
}

/// \param factor  of the previous impulses; the best multiple is taken of that
Method warm(const std::string& name, const Spending& spending, Start start = Start::previous, Real factor = 1,
            bool at_the_end = false)
{
    WarmMethod by;
    by.start.from = start;
    by.start.factor = factor;
    by.correction.at_the_end = at_the_end;
    return spending_method(8, name, spending, by);
}

std::vector<Setting> small_settings(DiscScene& scene, SmallStepSettings& s)
{
    return {{"gravity x", &scene.gravity.x()},
            {"gravity y", &scene.gravity.y()},
            or_infinity("margin", &s.margin),
            or_infinity("first_tolerance", &s.first_tolerance),
            {"beta", &s.correction.beta},
            {"slop", &s.correction.slop},
            {"bilateral_slop", &s.correction.bilateral_slop},
            or_infinity("max_correction_speed", &s.correction.max_correction_speed)};
}

/// A preset of chapter 8. It calls nothing solved.
Method preset(const std::string& name, const SmallStepSettings& chosen)
{
    Method method;
    method.chapter = 8;
    method.name = name;
    method.budget = std::to_string(chosen.substeps) + " substeps of one sweep" +
                    (chosen.first_sweeps > 0 ? ", the very first to the end" : "");
    {
        DiscScene scene;
        SmallStepSettings names;
        method.settings = names_of(small_settings(scene, names));
    }
    method.start = [=](const std::shared_ptr<const Wish>& wish) {
        const auto now = std::make_shared<SmallStep>();
        return checked([=](DiscScene& scene, Real h) {
            SmallStepSettings settings = chosen;
            settings.h = h;
            // Small steps refuse bends, and without a stiffness they are nothing to the other methods. One that makes no
            // sense is bad input all the same.
            for (const Bend& bend : scene.bends)
                if (!(bend.length > 0) || !std::isfinite(bend.length))
                    throw std::invalid_argument("a bend has the length " + shortest(bend.length) +
                                                "; it must be positive and finite");
            struct Aside {  // the scene has them back after the step, whatever happens in it
                DiscScene& scene;
                std::vector<Bend> bends;
                explicit Aside(DiscScene& from) : scene(from) { bends.swap(scene.bends); }
                ~Aside() { bends.swap(scene.bends); }
            } const aside(scene);
            const GravityGuard guard(scene);
            spoil(*wish, small_settings(scene, settings), settings);
            small_steps(scene, settings, *now);
        });
    };
    return method;
}

SmallStepSettings with_substeps(SmallStepSettings settings, int substeps, bool long_first)
{
    settings.substeps = substeps;
    if (!long_first) settings.first_sweeps = 0;
    return settings;
}

}  // namespace

std::vector<Method> impulse_methods(int sweeps)
{
    const int half = sweeps / 2;  // of those that share their sweeps between velocities and positions
    const int most = sweeps - 2 * sweeps / 5;  // relaxation: six with the bias, four without
    const Real unlimited = infinity;
    const Spending baumgarte{Stabilizer::baumgarte, sweeps, 0, 1, unlimited};
    const Spending relaxation{Stabilizer::relaxation, most, sweeps - most, 1, unlimited};
    const Spending split{Stabilizer::split_impulse, half, sweeps - half, 1, unlimited};
    const Spending projection{Stabilizer::projection, half, sweeps - half, 1, unlimited};
    const Spending substeps{Stabilizer::baumgarte, 1, 0, sweeps, unlimited};
    Spending bounded = baumgarte;
    bounded.max_correction_speed = 0.3;
    Spending small{Stabilizer::projection, 1, 1, std::max(1, sweeps - 2), unlimited};
    small.beta = 1;
    return {
        impulses("impulses", sweeps, Order::given),
        impulses("coloured impulses", sweeps, Order::coloured),
        impulses("shuffled impulses", sweeps, Order::shuffled),
        impulses("paired impulses", sweeps, Order::given, true),
        cold("baumgarte", baumgarte),
        cold("baumgarte 0.3 m/s", bounded),
        cold("relaxation", relaxation),
        cold("split impulse", split),
        cold("projection", projection),
        cold("substeps", substeps),
        warm("warm baumgarte", baumgarte),
        warm("warm baumgarte 0.8", baumgarte, Start::previous, 0.8),
        warm("warm relaxation", relaxation),
        warm("warm split impulse", split),
        warm("warm projection", projection),
        warm("warm substeps", substeps),
        warm("best baumgarte", baumgarte, Start::best_multiple),
        warm("best projection", projection, Start::best_multiple),
        warm("best small steps", small, Start::best_multiple, 1, true),
        preset("quick steps", with_substeps(quick_steps(), sweeps < 8 ? sweeps : 8, sweeps >= 8)),
        preset("careful steps", with_substeps(careful_steps(), sweeps < 8 ? 2 * sweeps : 16, sweeps >= 8))};
}

}  // namespace rigid::stress
