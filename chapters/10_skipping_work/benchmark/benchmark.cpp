/// Chapter 10: what is left out, and what that saves.
///
///     broad/METHOD/SCENE/N   contacts of N discs: all pairs, sort and sweep, the grid in each step, the pairs kept; the
///                            discs take a small step each time. Numbered line by line; `shuffled`: at random
///     sleepers/WHO/K         a step when K discs sleep and none is awake
///     beside/WHO/K           a step of one pendulum beside K sleepers
///     awake/WHO/K            a step of the same discs when none may sleep; chapter 8's step beside this chapter's
///     pile/WHO/N             a step of N discs that lie in valleys, when none may sleep
///     rain/WHO/N             ten seconds of N discs that rain and fall asleep: time of a step on average
///     kept/SLACK             the pile of 2,000; contacts keep their normal for so many micrometres
///     small/ROWS/EXACT/HIT   a hundred columns of so many rows, at rest or hit, swept or solved exactly
///     early/SCENE/SWEEPS     a scene at rest, set off by a nanometre: visits of a step and how far it is off; 0 sweeps = until 1e-6 m/s
///     islands/APART          one column that settles beside a hundred discs: visits
///     net/GROUPS             a net of 10,000 linked discs, kept apart by pairs or by groups: distances computed
///     bounce/WAY/N           a ball that bounces, in air or in none, N fixed steps or adaptive ones to 10^-N
///     factor/N               the factor of a chain of N: its products, and those of a dense one
///
/// WHO is `ours`, or another engine where it is installed, or chapter 8. Engines have the slop that ours has, by their
/// own setting or by a larger world (chapter 8's peers_box2d.hpp), and the same steps: box2d and chipmunk take each in one
/// with their own numbers of iterations, box2d_small and chipmunk_small in eight small ones of one iteration. Each time is
/// the least of several rounds.

#include "chapters/01_euler_integration/event.hpp"
#include "chapters/03_mlcp_formulation/step.hpp"
#include "chapters/08_warm_starting/benchmark/engine_scenes.hpp"
#include "chapters/08_warm_starting/warm_method.hpp"
#include "chapters/10_skipping_work/program/skipping_scenes.hpp"
#include "chapters/10_skipping_work/skipping_world.hpp"
#include "chapters/10_skipping_work/sort_and_sweep.hpp"
#ifdef RIGID_HAS_BOX2D
#include "chapters/08_warm_starting/benchmark/peers_box2d.hpp"
#endif
#ifdef RIGID_HAS_CHIPMUNK
#include "chapters/08_warm_starting/benchmark/peers_chipmunk.hpp"
#endif

#include <benchmark/benchmark.h>

#include <functional>
#include <map>
#include <memory>
#include <numeric>
#include <string>

using namespace rigid;

namespace {

/// What a line of the table has besides the time. Each line has all columns.
struct Counted {
    Real tested = 0;    ///< distances of two discs, of a step
    Real contacts = 0;  ///< found in a step
    Real rows = 0, kept_rows = 0, sweeps = 0, visits = 0;
    Real awake = 0;  ///< bodies, in the last step
    Real error = 0;  ///< [m]
};

void report(benchmark::State& state, const Counted& counted)
{
    state.counters["tested"] = counted.tested;
    state.counters["contacts"] = counted.contacts;
    state.counters["rows"] = counted.rows;
    state.counters["kept_rows"] = counted.kept_rows;
    state.counters["sweeps"] = counted.sweeps;
    state.counters["visits"] = counted.visits;
    state.counters["awake"] = counted.awake;
    state.counters["error"] = counted.error;
}

Counted counted_in(const SkippingWorld& now)
{
    const SkippingCounters& c = now.counters;
    Counted counted;
    counted.tested = static_cast<Real>(c.tested);
    counted.contacts = c.contacts;
    counted.rows = c.rows;
    counted.kept_rows = c.kept_rows;
    counted.sweeps = c.sweeps;
    counted.visits = static_cast<Real>(c.visits);
    counted.awake = c.awake;
    return counted;
}

benchmark::internal::Benchmark* add(const std::string& name,
                                    std::function<void(benchmark::State&)> run)
{
    return benchmark::RegisterBenchmark(name.c_str(), std::move(run))
        ->Unit(benchmark::kMicrosecond);
}

/// What is settled once and then used by several rounds.
template <class Key, class Thing>
Thing& once(std::map<Key, Thing>& all, const Key& key,
            const std::function<Thing()>& make)
{
    if (const auto found = all.find(key); found != all.end()) return found->second;
    return all.emplace(key, make()).first->second;
}

// ---- contacts --------------------------------------------------------------------------------------

constexpr Real margin = 0.02;

/// Numbers the discs line by line, as a scene is mostly built: neighbours in place are then neighbours in
/// memory.
void number_by_place(DiscScene& scene)
{
    const DiscScene old = scene;
    std::vector<Index> order(static_cast<std::size_t>(scene.bodies.count()));
    std::iota(order.begin(), order.end(), Index{0});
    const auto key = [&](Index k) {
        return std::pair(std::floor(old.bodies.x[2 * k + 1] / 0.5),
                         old.bodies.x[2 * k]);
    };
    std::sort(order.begin(), order.end(),
              [&](Index a, Index b) { return key(a) < key(b); });
    for (Index k = 0; k < scene.bodies.count(); ++k) {
        const Index from = order[static_cast<std::size_t>(k)];
        set_disc(scene, k, old.bodies.x.segment<2>(2 * from), old.radius[from]);
    }
}

DiscScene scattered_by(const std::string& name, Index N)
{
    if (name == "shuffled") return scattered(N, 0.1, 1, 1);
    DiscScene scene =
        name == "sparse"  ? scattered(N, 0.1, 1, 1)
        : name == "dense" ? scattered(N, 0.7, 1, 1)
        : name == "sizes"
            ? scattered(N, 0.3, 100, 1)
            : scattered(N, 0.3, 1, 1, std::sqrt(0.3 * static_cast<Real>(N)));
    number_by_place(scene);
    return scene;
}

/// A breath of wind: each disc moves on a small circle, by 0, 2 or 4 mm a step, drawn by lot: 2 mm on average. It
/// leaves a skin of 10 mm after about six steps, so in each step about a sixth of them query the grid, and none can
/// foretell which.
struct Breath {
    static constexpr unsigned places = 64;
    std::vector<Vec2> circle;
    VecX middle;
    std::vector<unsigned> place;
    std::uint64_t lot = 1;

    explicit Breath(const DiscScene& scene) : middle(scene.bodies.x)
    {
        for (unsigned i = 0; i < places; ++i) {
            const Real angle = 2 * pi * i / places;
            circle.push_back(0.002 * places / (2 * pi) *
                             Vec2(std::cos(angle), std::sin(angle)));
        }
        for (Index k = 0; k < scene.bodies.count(); ++k)
            place.push_back(29 * static_cast<unsigned>(k));
    }
    void move(VecX& x)
    {
        for (std::size_t k = 0; k < place.size(); ++k) {
            lot = lot * 6364136223846793005u + 1442695040888963407u;
            place[k] += static_cast<unsigned>(lot >> 40) % 3;
            const auto i = static_cast<Index>(2 * k);
            x.segment<2>(i) = middle.segment<2>(i) + circle[place[k] % places];
        }
    }
};

void contacts_by_sweep(const DiscScene& scene, SortAndSweep& memory,
                       std::vector<std::uint64_t>& pairs,
                       std::vector<Contact>& contacts)
{
    pairs.clear();
    sort_and_sweep(scene.bodies.x, scene.radius, margin, 0, memory,
                   [&](int a, int b) { pairs.push_back(pair_code(a, b)); });
    std::sort(pairs.begin(), pairs.end());
    contacts.clear();
    Contact contact;
    for (const std::uint64_t pair : pairs)
        if (touches(scene, first_of(pair), second_of(pair), margin, contact))
            contacts.push_back(contact);
}

void broad(benchmark::State& state, const std::string& method,
           const std::string& name)
{
    const auto N = static_cast<Index>(state.range(0));
    DiscScene scene = scattered_by(name, N);
    AwakeSet set = everybody_awake(scene.bodies);
    BroadPhase phase;
    phase.margin = margin;
    phase.skin = method == "kept" ? 0.01 : 0;
    phase.reset(scene, {});
    SortAndSweep memory;
    std::vector<Contact> contacts;
    std::vector<std::uint64_t> pairs;
    Counted counted;
    Real rounds = 0;
    const auto one_round = [&] {
        std::int64_t tested = N * (N - 1) / 2;
        if (method == "all") {
            find_contacts(scene, margin, contacts);
        } else if (method == "sweep") {
            contacts_by_sweep(scene, memory, pairs, contacts);
            tested = memory.tested;
        } else {
            if (method == "grid") phase.reset(scene, {});
            update_pairs(scene, set, phase);
            awake_contacts(scene, set, phase, contacts);
            tested = phase.tested;
        }
        counted.tested += static_cast<Real>(tested);
        counted.contacts += static_cast<Real>(contacts.size());
        ++rounds;
    };
    Breath breath(scene);
    for (int i = 0; i < 12; ++i) {
        breath.move(scene.bodies.x);
        one_round();
    }
    counted = {};
    rounds = 0;
    for (auto _ : state) {
        breath.move(scene.bodies.x);
        one_round();
    }
    counted.tested /= rounds;
    counted.contacts /= rounds;
    report(state, counted);
}

void net_step(benchmark::State& state, bool groups)
{
    const DiscScene scene = net(100);
    SkippingWorld now = make_world(
        scene, groups ? net_filter(scene)
                      : filter_of_links(scene.bodies.count(), scene.links));
    SkippingSettings settings;
    settings.h = 1.0 / 240;
    settings.sweeps.max_sweeps = 2;
    for (auto _ : state) skipping_step(now, settings);
    report(state, counted_in(now));
}

// ---- worlds ----------------------------------------------------------------------------------------

SkippingSettings early_out(Real h, bool may_sleep)
{
    SkippingSettings settings;
    settings.h = h;
    settings.sleep = may_sleep;
    // the sweeps go on until the residual is small, so it does no harm here
    settings.start = Start::previous;
    settings.sweeps.max_sweeps = 40;
    settings.sweeps.tolerance = 1e-5;
    settings.stabilizer.slop = 5e-4;
    settings.stabilizer.max_correction_speed = 1;
    return settings;
}

/// A field of K discs at rest, with or without its pendulum in motion.
DiscScene field_with(Index K, bool pendulum)
{
    DiscScene scene = perturbed(field(K), 1);
    if (pendulum) return scene;
    scene.bodies.inverse_mass.segment<2>(2).setZero();
    scene.links.clear();
    return scene;
}

/// What is stepped: this chapter's step, chapter 8's, or another engine's.
struct Stepper {
    virtual ~Stepper() = default;
    virtual void step() = 0;
    virtual Counted counted() const = 0;
    virtual DiscScene& poses() = 0;
};

struct Ours : Stepper {
    SkippingWorld now;
    SkippingSettings settings;
    Ours(const DiscScene& scene, Real contact_margin, const SkippingSettings& by)
        : now(make_world(scene, filter_of_links(scene.bodies.count(), scene.links),
                         contact_margin)),
          settings(by)
    {
    }
    void step() override { skipping_step(now, settings); }
    Counted counted() const override { return counted_in(now); }
    DiscScene& poses() override { return now.scene; }
};

struct Chapter8 : Stepper {
    DiscScene scene;
    StepData<2> now;
    StepSettings settings;
    WarmMethod method;
    Chapter8(const DiscScene& from, Real contact_margin, const SkippingSettings& by)
        : scene(from)
    {
        link_neighbours(scene);
        settings.h = by.h;
        settings.margin = contact_margin;
        static_cast<StabilizerSettings&>(method.correction) = by.stabilizer;
        method.start.from = by.start;
        method.solver.sweeps = by.sweeps;
        method.solver.ordering = Order::coloured;
    }
    void step() override { rigid::step(scene, settings, method, now); }
    Counted counted() const override
    {
        Counted counted;
        counted.awake =
            static_cast<Real>((scene.bodies.inverse_mass.array() > 0).count() / 2);
        return counted;
    }
    DiscScene& poses() override { return scene; }
};

template <class World>
struct Engine : Stepper {
    EngineScene scene;
    World world;
    Real h;
    int substeps;
    Engine(const DiscScene& from, const SkippingSettings& by, int count)
        : scene{"", from}, world(scene, {by.sleep, by.stabilizer.slop}), h(by.h),
          substeps(count)
    {
    }
    void step() override { world.step(h, substeps); }
    Counted counted() const override
    {
        Counted counted;
        counted.awake = world.awake();
        return counted;
    }
    DiscScene& poses() override
    {
        world.poses(scene.scene);
        return scene.scene;
    }
};

std::unique_ptr<Stepper> stepper(const std::string& who, const DiscScene& scene,
                                 Real contact_margin, const SkippingSettings& by)
{
    if (who == "chapter_8")
        return std::make_unique<Chapter8>(scene, contact_margin, by);
    [[maybe_unused]] const bool small = who.find("_small") != std::string::npos;
#ifdef RIGID_HAS_BOX2D
    if (who.rfind("box2d", 0) == 0)
        return std::make_unique<Engine<Box2dWorld>>(scene, by, small ? 8 : 1);
#endif
#ifdef RIGID_HAS_CHIPMUNK
    if (who.rfind("chipmunk", 0) == 0)
        return std::make_unique<Engine<ChipmunkSpace>>(scene, by, small ? 8 : 1);
#endif
    return std::make_unique<Ours>(scene, contact_margin, by);
}

/// \param small  with those that take small steps
std::vector<std::string> engines(bool small)
{
    std::vector<std::string> who;
#ifdef RIGID_HAS_BOX2D
    who.push_back("box2d");
    if (small) who.push_back("box2d_small");
#endif
#ifdef RIGID_HAS_CHIPMUNK
    who.push_back("chipmunk");
    if (small) who.push_back("chipmunk_small");
#endif
    (void)small;
    return who;
}

using Steppers = std::map<std::string, std::unique_ptr<Stepper>>;

/// A field after two seconds: discs that may sleep do.
void field_step(benchmark::State& state, const std::string& kind,
                const std::string& who)
{
    static Steppers all;
    const auto K = static_cast<Index>(state.range(0));
    Stepper& now = *once<std::string, std::unique_ptr<Stepper>>(
        all, kind + who + std::to_string(K), [&] {
            auto made = stepper(who, field_with(K, kind != "sleepers"), margin,
                                early_out(1.0 / 60, kind != "awake"));
            for (int i = 0; i < 120; ++i) made->step();
            return made;
        });
    for (auto _ : state) now.step();
    const Counted counted = now.counted();
    report(state, counted);
    const Real wanted = kind == "sleepers" ? 0
                        : kind == "beside" ? 1
                                           : static_cast<Real>(K) + 1;
    if (counted.awake != wanted) state.SkipWithError("the wrong ones are awake");
}

/// The rain, wider the more discs there are: the valleys are as deep as those of the program.
DiscScene wide_rain(Index N)
{
    return rain_on_hills(N, 1, 0.018 * static_cast<Real>(N));
}

constexpr Real rain_margin = 0.03, rain_h = 1.0 / 120;

/// Of any two bodies, one of which can move [m]: the stones of the ground overlap on purpose.
Real deepest_overlap(const DiscScene& scene)
{
    std::vector<Contact> contacts;
    find_contacts(scene, 0, contacts);
    Real deepest = 0;
    const auto movable = [&](Index k) { return scene.bodies.can_move(k); };
    for (const Contact& contact : contacts)
        if (movable(contact.a) || movable(contact.b))
            deepest = std::max(deepest, -contact.gap);
    return deepest;
}

/// The rain when it has come to rest, kept awake.
Stepper& pile_of(const std::string& who, Index N)
{
    static Steppers all;
    return *once<std::string, std::unique_ptr<Stepper>>(
        all, who + std::to_string(N), [&] {
            auto made =
                stepper(who, wide_rain(N), rain_margin, early_out(rain_h, false));
            for (int i = 0; i < 2400; ++i) made->step();
            return made;
        });
}

void pile(benchmark::State& state, const std::string& who)
{
    Stepper& now = pile_of(who, static_cast<Index>(state.range(0)));
    for (auto _ : state) now.step();
    Counted counted = now.counted();
    counted.error = deepest_overlap(now.poses());
    report(state, counted);
}

/// The pile of 2,000 with normals that are kept.
void kept(benchmark::State& state)
{
    const auto* const at_rest = dynamic_cast<const Ours*>(&pile_of("ours", 2000));
    SkippingWorld now = at_rest->now;
    SkippingSettings settings = at_rest->settings;
    settings.row_slack = 1e-6 * static_cast<Real>(state.range(0));
    for (int i = 0; i < 20; ++i) skipping_step(now, settings);
    Counted counted;  // over a second, and not in whatever step the clock ends with
    constexpr int steps = 120;
    Real kept_rows = 0, visits = 0;
    for (int i = 0; i < steps; ++i) {
        skipping_step(now, settings);
        counted = counted_in(now);
        kept_rows += counted.kept_rows / steps;
        visits += counted.visits / steps;
    }
    counted.kept_rows = kept_rows;
    counted.visits = visits;
    for (auto _ : state) skipping_step(now, settings);
    report(state, counted);
}

constexpr int rain_steps = 1200;

void rain(benchmark::State& state, const std::string& who)
{
    const DiscScene scene = wide_rain(static_cast<Index>(state.range(0)));
    std::unique_ptr<Stepper> now;
    Counted all;
    for (auto _ : state) {
        state.PauseTiming();
        all = {};
        now = stepper(who, scene, rain_margin, early_out(rain_h, true));
        state.ResumeTiming();
        for (int i = 0; i < rain_steps; ++i) {
            now->step();
            const Counted step = now->counted();
            all.tested += step.tested / rain_steps;
            all.visits += step.visits / rain_steps;
            all.rows += step.rows / rain_steps;
        }
    }
    all.awake = now->counted().awake;
    all.error = deepest_overlap(now->poses());
    report(state, all);
}

// ---- islands and sweeps ----------------------------------------------------------------------------

/// A hundred columns of so many rows each, at rest or hit from above in each step.
void small(benchmark::State& state)
{
    const Index height = state.range(0);
    DiscScene scene = empty_scene(100 * height);
    for (Index k = 0; k < scene.bodies.count(); ++k)
        set_disc(scene, k,
                 {static_cast<Real>(k / height),
                  0.1 + 0.2 * static_cast<Real>(k % height)},
                 0.1);
    scene.walls = {{{0, 1}, 0}};
    scene = perturbed(std::move(scene), 1);
    SkippingSettings settings = early_out(1.0 / 60, false);
    settings.sweeps.tolerance = 1e-8;
    settings.sweeps.max_sweeps = 10000;
    settings.exact_rows = state.range(1) != 0 ? 100 : 0;
    SkippingWorld now = make_world(scene, {});
    for (int i = 0; i < 10; ++i) skipping_step(now, settings);
    Real round = 0;
    for (auto _ : state) {
        // no column is given the time to topple
        now.scene.bodies.x = scene.bodies.x;
        if (state.range(2) != 0) {
            for (Index i = 0; i < 100; ++i)
                now.scene.bodies.velocity(height * i + height - 1) =
                    Vec2(0, -2 + std::cos(static_cast<Real>(i) + 1.7 * round));
        }
        skipping_step(now, settings);
        ++round;
    }
    report(state, counted_in(now));
}

/// 2,000 steps of a scene at rest but for a nanometre: the exact answer is that nothing moves.
void early(benchmark::State& state, const DiscScene& scene)
{
    SkippingSettings settings = early_out(1.0 / 60, false);
    const auto sweeps = static_cast<int>(state.range(0));
    settings.stabilizer.slop = 1e-4;
    settings.sweeps.tolerance = sweeps == 0 ? 1e-6 : 0;
    settings.sweeps.max_sweeps = sweeps == 0 ? 400 : sweeps;
    Counted all;
    for (auto _ : state) {
        all = {};
        SkippingWorld now = make_world(scene, {});
        for (int i = 0; i < 2000; ++i) {
            skipping_step(now, settings);
            if (i < 1000) continue;
            all.sweeps += 1e-3 * now.counters.sweeps;
            all.visits += 1e-3 * static_cast<Real>(now.counters.visits);
        }
        all.error = (now.scene.bodies.x - scene.bodies.x).cwiseAbs().maxCoeff();
    }
    report(state, all);
}

/// One step of a column of thirty that is started cold, beside a hundred single discs.
void apart(benchmark::State& state)
{
    DiscScene scene = empty_scene(130);
    for (Index k = 0; k < 130; ++k)
        set_disc(scene, k,
                 k < 30 ? Vec2(-5, 0.1 + 0.2 * static_cast<Real>(k))
                        : Vec2(0.3 * static_cast<Real>(k), 0.1),
                 0.1);
    scene.walls = {{{0, 1}, 0}};
    SkippingSettings settings = early_out(1.0 / 60, false);
    settings.start = Start::cold;
    settings.islands = state.range(0) != 0;
    settings.exact_rows = 0;
    settings.sweeps.max_sweeps = 20000;
    settings.sweeps.tolerance = 1e-6;
    Counted counted;
    for (auto _ : state) {
        SkippingWorld now = make_world(scene, {});
        skipping_step(now, settings);
        counted = counted_in(now);
    }
    report(state, counted);
}

// ---- time, and a factor ----------------------------------------------------------------------------

/// A ball that falls from 1 m, in air that would let it fall at 10 m/s at most, or in none, and bounces with e = 0.8.
struct Ball {
    static constexpr Real g = 9.81, e = 0.8, end = 2;
    Real drag;  ///< 1/m
    explicit Ball(bool in_air) : drag(in_air ? g / 100 : 0) {}

    Real acceleration(Real u) const { return -g - drag * u * std::abs(u); }

    /// Its height after two seconds, flight by flight, in closed form [m].
    Real height() const
    {
        if (drag == 0) return 0.260741728327057;
        const Real rate = std::sqrt(g * drag), fastest = std::sqrt(g / drag);
        const auto dropped = [&](Real t) {
            return std::log(std::cosh(rate * t)) / drag;
        };
        Real top = 1, left = end;
        for (;;) {
            const Real fall = std::acosh(std::exp(drag * top)) / rate;
            if (left <= fall) return top - dropped(left);
            const Real up = e * fastest * std::tanh(rate * fall),
                       rise = std::atan(up / fastest) / rate;
            left -= fall;
            top = std::log1p(up * up / (fastest * fastest)) / (2 * drag);
            if (left <= rise)
                return top + std::log(std::cos(rate * (rise - left))) / drag;
            left -= rise;
        }
    }
};

/// Symplectic Euler; a ball that would end a step below the floor has its speed turned round. Sweeps: steps.
void bounce_fixed(benchmark::State& state, const Ball& ball)
{
    const auto steps = state.range(0);
    const Real h = Ball::end / static_cast<Real>(steps);
    Real y = 1;
    for (auto _ : state) {
        Real u = 0;
        y = 1;
        for (long n = 0; n < steps; ++n) {
            u += h * ball.acceleration(u);
            if (y + h * u < 0 && u < 0) u = -Ball::e * u;
            y += h * u;
        }
        benchmark::DoNotOptimize(y);
    }
    Counted counted;
    counted.sweeps = counted.visits = static_cast<Real>(steps);
    counted.error = std::abs(y - ball.height());
    report(state, counted);
}

/// Chapter 1's adaptive steps, which end at the bounces. Sweeps: steps; visits: evaluations of the acceleration.
void bounce_adaptive(benchmark::State& state, const Ball& ball)
{
    const Real allowed = std::pow(10, -static_cast<Real>(state.range(0)));
    const Tolerance tolerance{allowed, allowed, allowed};
    const auto a = [&](const Vec<1>&, const Vec<1>& u) {
        return Vec<1>(ball.acceleration(u[0]));
    };
    Counted counted;
    for (auto _ : state) {
        counted = {};
        Adaptive<1> run =
            start_adaptive<1>({Vec<1>(1.0), Vec<1>(0.0)}, a, tolerance);
        while (run.t < Ball::end) {
            ++counted.sweeps;
            if (advance_to_event(run, Ball::end, a, tolerance,
                                 [](const State<1>& s) { return s.x[0]; }) !=
                Outcome::event)
                continue;
            run.s.u = -Ball::e * run.s.u;
            run.s.x[0] = std::max(run.s.x[0], 1e-15);
            run.a = a(run.s.x, run.s.u);
        }
        counted.visits = static_cast<Real>(run.evaluations);
        counted.error = std::abs(run.s.x[0] - ball.height());
    }
    report(state, counted);
}

/// Products of the factorisation: visits; those of a dense one: tested.
void factor(benchmark::State& state)
{
    const DiscScene scene = hanging_chain(static_cast<Index>(state.range(0)));
    std::vector<Row<2>> rows;
    disc_rows(scene, 1.0 / 60, {}, rows);
    const Mlcp mlcp = assemble(rows, VecX::Constant(scene.bodies.x.size(), -0.1));
    ActiveSetMemory memory;
    Solution solution;
    for (auto _ : state) active_sets(mlcp, {}, memory, solution);
    Counted counted;
    const std::vector<int>& begin = memory.sparse_factor.elimination.row_begin;
    for (std::size_t k = 0; k + 1 < begin.size(); ++k)
        counted.visits +=
            (begin[k + 1] - begin[k] + 1.0) * (begin[k + 1] - begin[k] + 1.0);
    const auto n = static_cast<Real>(mlcp.size());
    counted.rows = n;
    counted.tested = n * n * n / 3;
    counted.error = solution.residual;
    report(state, counted);
}

void add_all()
{
    for (const std::string name : {"sparse", "dense", "sizes", "line", "shuffled"})
        for (const std::string method : {"all", "sweep", "grid", "kept"}) {
            auto* const one = add("broad/" + method + "/" + name,
                                  [method, name](benchmark::State& state) {
                                      broad(state, method, name);
                                  });
            one->MinTime(0.02)->Repetitions(3);
            for (const int N : {30, 100, 300, 1000, 3000, 10000, 30000, 100000})
                if (method != "all" || N <= 10000) one->Arg(N);
        }
    for (const std::string kind : {"sleepers", "beside", "awake"}) {
        std::vector<std::string> who = engines(false);
        who.insert(who.begin(), "ours");
        if (kind == "awake") who.push_back("chapter_8");
        for (const std::string& w : who) {
            auto* const one =
                add(kind + "/" + w, [kind, w](benchmark::State& state) {
                    field_step(state, kind, w);
                });
            one->MinTime(0.02)->Repetitions(5);
            for (const int K : {0, 1, 10, 100, 1000, 10000})
                if (w != "chapter_8" || K <= 1000) one->Arg(K);
        }
    }
    std::vector<std::string> who = engines(true);
    who.insert(who.begin(), "ours");
    for (const std::string& w : who) {
        auto* const one =
            add("pile/" + w, [w](benchmark::State& state) { pile(state, w); });
        one->MinTime(0.05)->Repetitions(3);
        for (const int N : {500, 2000}) one->Arg(N);
    }
    for (const std::string& w : who) {
        auto* const one =
            add("rain/" + w, [w](benchmark::State& state) { rain(state, w); });
        one->Iterations(1)->Unit(benchmark::kMillisecond);
        for (const int N : {500, 2000}) one->Arg(N);
    }
    auto* const slacks = add("kept", kept)->MinTime(0.05)->Repetitions(5);
    for (const int micrometres : {0, 1, 10, 100, 1000}) slacks->Arg(micrometres);
    auto* const few = add("small", small)->MinTime(0.05)->Repetitions(3);
    for (const int count : {1, 2, 3, 4, 6, 8, 16})
        for (const int exact : {0, 1})
            for (const int hit : {0, 1}) few->Args({count, exact, hit});
    for (const std::string name : {"column", "triangle"}) {
        const DiscScene scene =
            perturbed(name == "column" ? column_between_walls(20) : triangle(8), 1);
        auto* const one = add("early/" + name, [scene](benchmark::State& state) {
            early(state, scene);
        });
        one->Iterations(1);
        for (const int sweeps : {0, 100, 10}) one->Arg(sweeps);
    }
    add("islands", apart)->Iterations(1)->Arg(0)->Arg(1);
    for (const bool groups : {false, true})
        add(groups ? "net/groups" : "net/pairs", [groups](benchmark::State& state) {
            net_step(state, groups);
        })->Iterations(5);
    for (const bool in_air : {false, true}) {
        const Ball ball(in_air);
        const std::string name = in_air ? "bounce/air_" : "bounce/";
        auto* const fixed = add(name + "fixed", [ball](benchmark::State& state) {
                                bounce_fixed(state, ball);
                            })->MinTime(0.01);
        for (const int steps : {10, 100, 1000, 10000, 100000, 1000000, 10000000})
            fixed->Arg(steps);
        auto* const adaptive =
            add(name + "adaptive", [ball](benchmark::State& state) {
                bounce_adaptive(state, ball);
            })->MinTime(0.01);
        for (const int digits : {3, 5, 7, 9, 11}) adaptive->Arg(digits);
    }
    auto* const chain = add("factor", factor)->MinTime(0.01);
    for (const int N : {10, 100, 1000, 10000}) chain->Arg(N);
}

}  // namespace

int main(int argc, char** argv)
{
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
    add_all();
    benchmark::RunSpecifiedBenchmarks();
    benchmark::Shutdown();
}
