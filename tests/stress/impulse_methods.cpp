#include "chapters/06_sequential_impulse/block.hpp"
#include "chapters/08_warm_starting/small_steps.hpp"
#include "chapters/08_warm_starting/warm_step.hpp"
#include "tests/stress/stabilized_settings.hpp"

namespace rigid::stress {

namespace {

/// Chapter 6 as it is: an error of position is left alone.
Method impulses(const std::string& name, int sweeps, Order order, bool blocks = false)
{
    Method method;
    method.chapter = 6;
    method.name = name;
    method.budget = std::to_string(sweeps) + " sweeps";
    method.has_restitution = true;
    ImpulseStepSettings names;
    method.settings = names_of(impulse_settings(names));
    method.start = [=](const std::shared_ptr<const Wish>& wish) {
        struct Memory : ImpulseStep {
            std::vector<Block> pairs;
            HonestRows honest;
        };
        const auto now = std::make_shared<Memory>();
        return checked([=](DiscScene& scene, Real h) {
            ImpulseStepSettings settings;
            settings.h = h;
            settings.gravity = scene.gravity;
            settings.restitution = std::max(Real{0}, wish->restitution);
            settings.order = order;
            settings.sweeps.max_sweeps = sweeps;
            spoil(*wish, impulse_settings(settings), settings);
            const auto in_pairs = [&](const auto& rows, const auto& visits, const auto& how, auto& memory,
                                      VecX& u, Solution& solution) {
                block_impulse<2>(rows, visits, how, memory, now->pairs, u, solution);
            };
            if (blocks) impulse_step(scene, settings, in_pairs, *now);
            else impulse_step(scene, settings, *now);
            now->honest.look(*now, true);
        });
    };
    return method;
}

Method cold(const std::string& name, const Spending& spending)
{
    Method method;
    method.chapter = 7;
    method.name = name;
    method.budget = budget(spending);
    method.has_beta = spending.stabilizer != Stabilizer::none;
    method.has_restitution = true;
    StabilizedStepSettings names;
    method.settings = names_of(stabilized_settings(names));
    method.start = [=](const std::shared_ptr<const Wish>& wish) {
        struct Memory : StabilizedStep {
            HonestRows honest;
        };
        const auto now = std::make_shared<Memory>();
        return checked([=](DiscScene& scene, Real h) {
            auto settings = settings_for<StabilizedStepSettings>(scene, h, *wish, spending);
            spoil(*wish, stabilized_settings(settings), settings);
            stabilized_step(scene, settings, *now);
            now->honest.look(*now, spending.stabilizer != Stabilizer::relaxation);
        });
    };
    return method;
}

std::vector<Setting> warm_settings(WarmStepSettings& s)
{
    std::vector<Setting> all = stabilized_settings(s);
    all.push_back({"share", &s.share, false});
    return all;
}

/// \param share  of yesterday's impulses; ignored for the best multiple
Method warm(const std::string& name, const Spending& spending, Start start = Start::yesterday, Real share = 1,
            bool repay_once = false)
{
    Method method = cold(name, spending);
    method.chapter = 8;
    WarmStepSettings names;
    method.settings = names_of(warm_settings(names));
    method.start = [=](const std::shared_ptr<const Wish>& wish) {
        struct Memory : WarmStep {
            HonestRows honest;
        };
        const auto now = std::make_shared<Memory>();
        return checked([=](DiscScene& scene, Real h) {
            auto settings = settings_for<WarmStepSettings>(scene, h, *wish, spending);
            settings.start = start;
            settings.share = share;
            settings.repay_once = repay_once;
            spoil(*wish, warm_settings(settings), settings);
            warm_step(scene, settings, *now);
            now->honest.look(*now, spending.stabilizer != Stabilizer::relaxation);
        });
    };
    return method;
}

std::vector<Setting> small_settings(SmallStepSettings& s)
{
    return {{"gravity x", &s.gravity.x(), false},
            {"gravity y", &s.gravity.y(), false},
            {"margin", &s.margin, true},
            {"first_tolerance", &s.first_tolerance, true},
            {"beta", &s.repay.beta, false},
            {"slop", &s.repay.slop, false},
            {"bilateral_slop", &s.repay.bilateral_slop, false},
            {"fastest", &s.repay.fastest, true},
            {"repaying tolerance", &s.repay.tolerance, true}};
}

/// A preset of chapter 8. It calls nothing solved.
Method preset(const std::string& name, const SmallStepSettings& chosen)
{
    Method method;
    method.chapter = 8;
    method.name = name;
    method.budget = std::to_string(chosen.substeps) + " substeps of one sweep" +
                    (chosen.first_sweeps > 0 ? ", the very first to the end" : "");
    SmallStepSettings names;
    method.settings = names_of(small_settings(names));
    method.start = [=](const std::shared_ptr<const Wish>& wish) {
        const auto now = std::make_shared<SmallStep>();
        return checked([=](DiscScene& scene, Real h) {
            SmallStepSettings settings = chosen;
            settings.h = h;
            settings.gravity = scene.gravity;
            spoil(*wish, small_settings(settings), settings);
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
    const int half = sweeps / 2;           // of those that share their sweeps between velocities and positions
    const int most = sweeps - 2 * sweeps / 5;  // relaxation: six with the bias, four without
    const Real unlimited = infinity;
    const Spending baumgarte{Stabilizer::baumgarte, sweeps, 0, 1, unlimited};
    const Spending relaxation{Stabilizer::relaxation, most, sweeps - most, 1, unlimited};
    const Spending split{Stabilizer::split_impulse, half, sweeps - half, 1, unlimited};
    const Spending projection{Stabilizer::projection, half, sweeps - half, 1, unlimited};
    const Spending substeps{Stabilizer::baumgarte, 1, 0, sweeps, unlimited};
    Spending bounded = baumgarte;
    bounded.fastest = 0.3;
    Spending small{Stabilizer::projection, 1, 1, std::max(1, sweeps - 2), unlimited};
    small.beta = 1;
    return {impulses("impulses", sweeps, Order::given),
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
            warm("warm baumgarte 0.8", baumgarte, Start::yesterday, 0.8),
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
