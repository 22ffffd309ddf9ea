/// What has no answer harms nothing else, a correction creates no new error, and what is refused changes nothing.

#include "chapters/03_mlcp_formulation/cases_method.hpp"
#include "chapters/04_pgs/pgs_method.hpp"
#include "chapters/05_lemke/lemke_method.hpp"
#include "chapters/06_sequential_impulse/impulse_method.hpp"
#include "chapters/07_baumgarte/corrected_method.hpp"
#include "chapters/08_warm_starting/warm_method.hpp"
#include "chapters/09_active_sets/exact_method.hpp"
#include "chapters/10_skipping_work/skipping_world.hpp"
#include "common/measure.hpp"

#include "tests/catch.hpp"
#include "tests/sentence.hpp"

#include <functional>
#include <string>
#include <vector>

using namespace rigid;

namespace {

constexpr Real not_a_number = std::numeric_limits<Real>::quiet_NaN();

/// So many steps by a method that begins from nothing.
template <class Method>
void run(DiscScene& scene, const StepSettings& settings, Method method, int steps)
{
    if constexpr (requires { method.contacts.set; }) method.contacts.reset(scene, filter_of(scene));
    StepData<2> now;
    for (int n = 0; n < steps; ++n) step(scene, settings, method, now);
}

/// Calls visit(name, method) with each method of the book in its plainest form.
template <class Visit>
void for_each_method(const Visit& visit)
{
    visit("cases", CasesMethod{});
    visit("sweeps on a matrix", PgsMethod{});
    visit("Lemke", LemkeMethod{});
    visit("impulses", ImpulseMethod{});
    visit("corrected", CorrectedMethod{});
    visit("warm", WarmMethod{});
    visit("exact", ExactMethod{});
    SkippingMethod awake;
    awake.contacts.sleep = false;
    visit("skipping, all awake", awake);
    visit("skipping", SkippingMethod{});
    awake.solver.exact_rows = 0;
    awake.solver.apart = false;
    visit("skipping, in one", awake);
}

/// Adds a disc of 0.1 m; 1 / inverse_mass is its mass [kg], 0 = it cannot move.
void add_disc(DiscScene& scene, const Vec2& x, Real inverse_mass)
{
    const Index k = scene.bodies.count();
    for (VecX* const v : {&scene.bodies.x, &scene.bodies.u, &scene.bodies.f, &scene.bodies.inverse_mass}) {
        v->conservativeResize(2 * k + 2);
        v->tail<2>().setConstant(v == &scene.bodies.inverse_mass ? inverse_mass : 0);
    }
    scene.bodies.position(k) = x;
    scene.radius.conservativeResize(k + 1);
    scene.radius[k] = 0.1;
}

void add_free_disc(DiscScene& scene, const Vec2& x) { add_disc(scene, x, 1); }
void add_fixed_disc(DiscScene& scene, const Vec2& x) { add_disc(scene, x, 0); }

/// Five discs that rest on a floor, half a metre apart.
DiscScene five_at_rest()
{
    DiscScene scene;
    for (int k = 0; k < 5; ++k) add_free_disc(scene, {0.5 * k - 1, 0.1});
    scene.walls = {{{0, 1}, 0}};
    return scene;
}

/// Each method holds the five where they are for a second.
void check_held(const DiscScene& from)
{
    for_each_method([&](const std::string& name, const auto& method) {
        DiscScene scene = from;
        run(scene, {.h = 1.0 / 60}, method, 60);
        CAPTURE(name);
        // Five rows that share nothing: each is solved to rounding, and 60 steps of a gain of h g = 0.16 m/s add up.
        CHECK((scene.bodies.x - from.bodies.x).head<10>().lpNorm<Eigen::Infinity>() < 1e-12);
        CHECK(scene.bodies.x.allFinite());
    });
}

}  // namespace

TEST_CASE(
    "two fixed discs that overlap elsewhere leave five discs at rest where they are whatever the method")
{
    DiscScene scene = five_at_rest();
    add_fixed_disc(scene, {3, 1});
    add_fixed_disc(scene, {3.19, 1});
    check_held(scene);
}

TEST_CASE("rods that no place satisfies leave five discs at rest where they are whatever the method")
{
    SECTION("between two fixed discs")
    {
        DiscScene scene = five_at_rest();
        add_fixed_disc(scene, {3, 1});
        add_fixed_disc(scene, {3.5, 1});
        scene.links = {{5, 6, 0.4}, {5, 6, 0.6}};
        check_held(scene);
    }
    SECTION("between a fixed disc and one that moves")
    {
        DiscScene scene = five_at_rest();
        add_fixed_disc(scene, {3, 1});
        add_free_disc(scene, {3.5, 1});
        scene.links = {{5, 6, 0.4}, {5, 6, 0.6}};
        check_held(scene);
    }
    SECTION("between two that fall")
    {
        DiscScene scene = five_at_rest();
        add_free_disc(scene, {3, 100});
        add_free_disc(scene, {3.5, 100});
        scene.links = {{5, 6, 0.4}, {5, 6, 0.6}};
        check_held(scene);
    }
    SECTION("of a disc that two fixed ones jam")
    {
        DiscScene scene = five_at_rest();
        add_fixed_disc(scene, {3, 1});
        add_free_disc(scene, {3.15, 1});
        add_fixed_disc(scene, {3.3, 1});
        check_held(scene);
    }
}

TEST_CASE("a disc ten millimetres deep below another five above it is corrected without a new overlap")
{
    for (const Stabilizer way : {Stabilizer::none, Stabilizer::baumgarte, Stabilizer::relaxation,
                                 Stabilizer::split_impulse, Stabilizer::projection})
        for (const Real beta : {0.2, 1.0}) {
            CAPTURE(to_string(way), beta);
            DiscScene scene;
            add_free_disc(scene, {0, 0.09});
            add_free_disc(scene, {0, 0.295});
            scene.walls = {{{0, 1}, 0}};
            ExactMethod method;
            method.correction.method = way;
            method.correction.beta = beta;
            method.correction.correction_sweeps = 1000;
            const StepSettings settings{.h = 1.0 / 60};
            StepData<2> now;
            for (int n = 0; n < 60; ++n) {
                step(scene, settings, method, now);
                CHECK(now.solution.status == Status::solved);
                REQUIRE(now.constraints.size() == now.rows.size());
                // The pair and then the floor, each for as long as it is near.
                for (std::size_t i = 0; way == Stabilizer::split_impulse && i < now.rows.size(); ++i) {
                    const Constraint<2>& c = now.constraints[i];
                    Real left = c.C + settings.h * c.Jb.dot(scene.bodies.velocity(c.b));  // C' = C + h J u
                    if (c.a != world) left += settings.h * c.Ja.dot(scene.bodies.velocity(c.a));
                    const Real share = left < 0 ? beta : 1;
                    // Sums of three numbers of a centimetre, over h.
                    CHECK(method.correction.second.bias[i] ==
                          Approx(share * left / settings.h).margin(1e-14));
                }
                const Real between = (scene.bodies.position(1) - scene.bodies.position(0)).norm() - 0.2;
                // Exact answers to 1e-10 of numbers up to 1 m/s; a projection's sweeps end at 1e-9 m/s times h.
                CHECK(between > -1e-9);
                CHECK(scene.bodies.position(0).y() > 0.09 - 1e-9);
            }
            // After a second (1 − β)^60 of the error is left.
            if (way != Stabilizer::none) CHECK(scene.bodies.position(0).y() > 0.1 - 0.01 * 2e-6 - 1e-9);
        }
}

// ---- what is refused changes nothing ----------------------------------------------------------------

namespace {

/// A scene of everything: contacts, rods, springs, a motor; nothing at rest.
DiscScene busy_scene()
{
    DiscScene scene = ten_discs();
    scene.bodies.u = VecX::LinSpaced(20, -0.5, 0.5);
    scene.joints.push_back({Joint::Kind::motor, world, 8, {1, 0}, 0, 0.3, 5});
    return scene;
}

struct Fault {
    std::string words;  ///< of the sentence
    std::function<void()> make;
};

/// Three steps, then one with each fault, which is refused and changes no bit, then one that is as if nothing had been.
template <class Method>
void check_refused(const std::string& name, Method method,
                   const std::function<std::vector<Fault>(Method&, StepSettings&, DiscScene&)>& faults_of)
{
    const StepSettings settings{.h = 1.0 / 240, .substeps = 2, .stiffness = 1, .damping = 1};
    DiscScene scene = busy_scene();
    if constexpr (requires { method.contacts.set; }) method.contacts.reset(scene, filter_of(scene));
    StepData<2> now;
    for (int n = 0; n < 3; ++n) step(scene, settings, method, now);

    DiscScene as_if = scene;
    Method same = method;
    StepData<2> found = now;
    step(as_if, settings, same, found);

    StepSettings bad_settings = settings;
    Method bad = method;
    DiscScene bad_scene = scene;
    const std::size_t count = faults_of(bad, bad_settings, bad_scene).size();
    for (std::size_t i = 0; i < count; ++i) {
        bad_settings = settings;
        bad = method;
        bad_scene = scene;
        StepData<2> data = now;
        const Fault fault = faults_of(bad, bad_settings, bad_scene)[i];
        CAPTURE(name, fault.words);
        fault.make();
        CHECK(sentence_of([&] { step(bad_scene, bad_settings, bad, data); }).find(fault.words) !=
              std::string::npos);
        CHECK(bad_scene.bodies.x == scene.bodies.x);
        CHECK(bad_scene.bodies.u == scene.bodies.u);
        CHECK(bad_scene.bodies.f == scene.bodies.f);
    }

    // The stages themselves were not touched either: with the settings put right the step has its bits.
    for (std::size_t i = 0; i < count; ++i) {
        bad_settings = settings;
        bad = method;
        bad_scene = scene;
        StepData<2> data = now;
        faults_of(bad, bad_settings, bad_scene)[i].make();
        (void)sentence_of([&] { step(bad_scene, bad_settings, bad, data); });
        Method kept = method;  // the settings of before with the memory of after
        if constexpr (requires { bad.start.cache; }) kept.start.cache = bad.start.cache;
        bad_scene = scene;
        step(bad_scene, settings, kept, data);
        CHECK(bad_scene.bodies.x == as_if.bodies.x);
    }
}

template <class Method>
std::vector<Fault> faults_of_step(Method&, StepSettings& settings, DiscScene& scene)
{
    return {{"the time step h is 0", [&] { settings.h = 0; }},
            {"substeps is 0", [&] { settings.substeps = 0; }},
            {"the margin of contacts is nan", [&] { settings.margin = not_a_number; }},
            {"the hand pulls disc 10", [&] { settings.pulled = 10; }},
            {"gravity", [&] {
                 scene.gravity = {0, not_a_number};
             }}};
}

template <class Method>
std::vector<Fault> faults_of_correction(Method& method)
{
    return {{"the restitution is 2", [&] { method.correction.restitution = 2; }},
            {"the threshold of bounces is nan", [&] { method.correction.threshold = not_a_number; }},
            {"beta is -1", [&] { method.correction.beta = -1; }},
            {"slop is nan", [&] { method.correction.slop = not_a_number; }},
            {"correction_sweeps is -1", [&] { method.correction.correction_sweeps = -1; }}};
}

template <class Method>
std::vector<Fault> faults_of_sweeps(Method& method)
{
    return {{"the tolerance of the sweeps is nan", [&] { method.solver.sweeps.tolerance = not_a_number; }},
            {"the number of sweeps is -1", [&] { method.solver.sweeps.max_sweeps = -1; }}};
}

std::vector<Fault> all(std::vector<std::vector<Fault>> lists)
{
    std::vector<Fault> faults;
    for (std::vector<Fault>& list : lists)
        for (Fault& fault : list) faults.push_back(std::move(fault));
    return faults;
}

}  // namespace

TEST_CASE("a step that is refused for a setting of any stage leaves the scene as it was to the bit")
{
    const auto factor = [](auto& m) {
        return std::vector<Fault>{{"the warm start factor is 2", [&m] { m.start.factor = 2; }}};
    };
    check_refused<PgsMethod>("sweeps on a matrix", {}, [&](auto& m, auto& s, auto& scene) {
        return all({faults_of_step(m, s, scene), factor(m), {{"the number of sweeps is -1", [&m] {
                                                                  m.solver.find.settings.max_sweeps = -1;
                                                              }}}});
    });
    check_refused<LemkeMethod>("Lemke", {}, [&](auto& m, auto& s, auto& scene) {
        return all({faults_of_step(m, s, scene), factor(m), {{"the pivot limit -1", [&m] {
                                                                  m.solver.find.settings.pivot_limit = -1;
                                                              }}}});
    });
    check_refused<ImpulseMethod>("impulses", {}, [&](auto& m, auto& s, auto& scene) {
        return all({faults_of_step(m, s, scene),
                    factor(m),
                    faults_of_sweeps(m),
                    {{"the restitution is nan", [&m] { m.correction.restitution = not_a_number; }}}});
    });
    check_refused<CorrectedMethod>("corrected", {}, [&](auto& m, auto& s, auto& scene) {
        return all({faults_of_step(m, s, scene), factor(m), faults_of_sweeps(m), faults_of_correction(m)});
    });
    check_refused<WarmMethod>("warm", {}, [&](auto& m, auto& s, auto& scene) {
        return all({faults_of_step(m, s, scene),
                    factor(m),
                    faults_of_sweeps(m),
                    faults_of_correction(m),
                    {{"keep is -1", [&m] { m.start.keep = -1; }},
                     {"near_one is nan", [&m] { m.start.rule.near_one = not_a_number; }},
                     {"the greatest multiple is 0", [&m] { m.start.rule.most = 0; }}}});
    });
    check_refused<ExactMethod>("exact", {}, [&](auto& m, auto& s, auto& scene) {
        return all({faults_of_step(m, s, scene),
                    factor(m),
                    faults_of_correction(m),
                    {{"the residual that is nothing is nan", [&m] { m.solver.enough = not_a_number; }},
                     {"patience -1", [&m] { m.solver.find.settings.patience = -1; }}}});
    });
    check_refused<SkippingMethod>("skipping", {}, [&](auto& m, auto& s, auto& scene) {
        return all({faults_of_step(m, s, scene),
                    factor(m),
                    faults_of_sweeps(m),
                    faults_of_correction(m),
                    {{"the speed of rest is 0", [&m] { m.contacts.rest.speed = 0; }},
                     {"row_slack is -1", [&m] { m.contacts.row_slack = -1; }},
                     {"the order is shuffled", [&m] { m.solver.ordering = Order::shuffled; }}}});
    });
}

TEST_CASE("a body that is not there is refused by name wherever rows and scenes come in")
{
    std::vector<Contact> contacts;
    DiscScene short_of_one = column(3);
    short_of_one.bodies.x.setZero(4);
    CHECK(sentence_of([&] { find_contacts(short_of_one, 0, contacts); }) ==
          "there are 4 coordinates for the 3 radii of discs; each disc has two");
    CHECK(sentence_of([&] {
              find_contacts(column(3), not_a_number, contacts);
          }).find("the margin of contacts is nan") == 0);

    for (const Index k : {-1, 3}) {
        const std::string sentence = " names body " + std::to_string(k) + "; the scene has bodies 0 to 2";
        const DiscScene good = column(3);
        DiscScene scene = good;
        scene.links = {{0, 1, 0.2}, {1, k, 0.2}};
        CHECK(sentence_of([&] { link_neighbours(scene); }) == "link 1" + sentence);
        DiscScene bent = good, jointed = good;
        bent.bends = {{0, k, 1, 0.2}};
        jointed.joints.resize(1);
        jointed.joints[0].b = k;
        for_each_method([&](const std::string& name, auto method) {
            CAPTURE(name);
            const auto refused = [&](DiscScene broken) {
                StepData<2> now;
                return sentence_of([&] {
                    if constexpr (requires { method.contacts.set; }) method.contacts.reset(broken, {});
                    step(broken, {}, method, now);
                });
            };
            CHECK(refused(scene) == "link 1" + sentence);
            CHECK(refused(bent) == "bend 0" + sentence);
            CHECK(refused(jointed) == "joint 0" + sentence);
        });

        std::vector<Row<2>> rows(2);
        rows[0].a = world;
        rows[0].b = 2;
        rows[1].a = 0;
        rows[1].b = k;
        const std::string row = "row 1 joins bodies 0 and " + std::to_string(k) + "; there are bodies 0 to 2";
        ImpulseMemory<2> memory;
        Solution solution;
        VecX u = VecX::Zero(6);
        std::vector<int> order;
        std::vector<Block> blocks;
        Colouring colouring;
        BodyGroups groups;
        const VecX inverse_mass = VecX::Ones(6);
        CHECK(sentence_of([&] { sequential_impulse<2>(rows, {}, {}, memory, u, solution); }).find(row) == 0);
        CHECK(sentence_of([&] { block_impulse<2>(rows, {}, {}, memory, blocks, u, solution); }).find(row) ==
              0);
        CHECK(sentence_of([&] { colour_rows<2>(rows, 3, colouring, order); }).find(row) == 0);
        CHECK(sentence_of([&] { find_groups<2>(rows, inverse_mass, groups); }).find(row) == 0);
        CHECK(sentence_of([&] { (void)assemble<2>(rows, u); }).find(row) == 0);
        CHECK(u.isZero(0));
    }

    CHECK(sentence_of([] { (void)column_between_walls(0); }).find("the number of discs in a column is 0") ==
          0);
    CHECK(sentence_of([] { (void)hanging_chain(-1); }).find("the number of links in a chain is -1") == 0);
    CHECK(sentence_of([] { (void)swinging_chain(0); }).find("the number of links in a chain is 0") == 0);
    CHECK(sentence_of([] {
              (void)triangle(-3);
          }).find("the number of discs at the base of a triangle is -3") == 0);
    CHECK(sentence_of([] { (void)column(3, -1); }).find("the mass of disc 2 is -1") == 0);
}

TEST_CASE("where the whole has no answer each block of rows that meet has its own")
{
    // Rows 0 and 2 want 1 m/s and 2 m/s of one body; row 1 shares nothing with them.
    MatX A(3, 3);
    A << 1, 0, 1, 0, 2, 0, 1, 0, 1;
    const Mlcp mlcp{A.sparseView(), Vec<3>(-1, -4, -2), VecX::Constant(3, -infinity),
                    VecX::Constant(3, infinity)};
    CHECK(blocks_of(mlcp) == std::vector<std::vector<int>>{{0, 2}, {1}});
    const Mlcp part = part_of(mlcp, {0, 2});
    CHECK(MatX(part.A) == MatX::Ones(2, 2));
    CHECK(part.q == Vec2(-1, -2));
    Solution solution = schur(mlcp);
    REQUIRE(has_no_answer(solution.status));
    solve_by_blocks(
        mlcp, [](const Mlcp& block, Solution& one) { one = schur(block); }, solution);
    CHECK(has_no_answer(solution.status));  // of the whole it stays true
    CHECK(solution.lambda[1] == 2);
}
