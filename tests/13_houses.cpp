/// Chapter 13: what stands by friction alone, against statics; what friction keeps busy, against closed forms and energy.

#include "chapters/13_friction/friction_problems.hpp"
#include "chapters/13_friction/houses.hpp"
#include "chapters/13_friction/impact_laws.hpp"
#include "chapters/13_friction/moving_scenes.hpp"
#include "common/random.hpp"

#include "tests/catch.hpp"
#include "tests/statics.hpp"

using namespace rigid;

namespace {

using ExactPile = ExactFriction<Manifolds>;
using SweptPile = FrictionSweeps<Manifolds>;

/// Whether a scene is where it was built after so long a time, and how far it has moved at most [m, rad].
struct Stood {
    bool stands = true;
    Real moved = 0;
    int unsolved = 0;
};
template <class Method>
Stood stand(RoughScene scene, Method& method, Real seconds, int substeps = 1)
{
    const VecX start = scene.bodies.x;
    StepData<3> now;
    Stood stood;
    const long steps = std::lround(60 * seconds);
    for (long i = 0; i < steps && stood.stands; ++i) {
        step(scene, {.substeps = substeps}, method, now);
        stood.unsolved += method.solver.unsolved;
        stood.moved = std::max(stood.moved, (scene.bodies.x - start).lpNorm<Eigen::Infinity>());
        stood.stands = stood.moved < 0.1;
    }
    return stood;
}

/// The sweeps that the text recommends for what stands: the first step, which has no impulses to start from, to the end;
/// then ten sweeps a step, or four in each of eight sub-steps.
Stood stand_by_sweeps(RoughScene scene, Real seconds, int substeps)
{
    SweptPile method;
    method.solver.sweeps.max_sweeps = 10000;
    StepData<3> now;
    step(scene, {.substeps = substeps}, method, now);
    method.solver.sweeps.max_sweeps = substeps > 1 ? 4 : 10;
    return stand(scene, method, seconds, substeps);
}

Stood stand_exactly(const RoughScene& scene, Real seconds)
{
    ExactPile method;
    return stand(scene, method, seconds);
}

/// Seconds between two dominoes of a wave that has settled, without friction between them and with feet that do not slip:
/// one unknown, the angle of the foremost; all behind it lean on the next. \cite vanleeuwen2010
Real domino_period(Real gap)
{
    const Real H = Domino::height, d = Domino::thickness, g = 9.81;
    const Real first = std::asin(gap / H), inertia = (H * H + d * d) / 3;
    const int train = 60;
    // angles behind a foremost one at θ, and how each moves with it
    struct Train {
        std::vector<Real> angle, rate;
        Real potential = 0, rates = 0;
    };
    const auto at = [&](Real theta, int count) {
        Train all;
        Real rate = 1;
        for (int i = 0; i < count; ++i) {
            all.angle.push_back(theta);
            all.rate.push_back(rate);
            all.potential += g * (H * std::cos(theta) + d * std::sin(theta)) / 2;
            all.rates += rate * rate;
            // H sin(before − θ) = (gap + d) cos θ − d
            const Real lever = ((gap + d) * std::cos(theta) - d) / H;
            const Real before = theta + std::asin(lever);
            rate *= 1 - (gap + d) * std::sin(theta) / (H * std::sqrt(1 - lever * lever));
            theta = before;
        }
        return all;
    };
    Real speed = 1, period = 0;
    for (int n = 1; n <= train; ++n) {
        // from the moment when domino n begins to tip until it strikes the next: energy is kept
        const Train start = at(0, n);
        const Real energy = inertia * start.rates * speed * speed / 2 + start.potential;
        const int parts = 400;
        period = 0;
        for (int k = 0; k < parts; ++k) {
            const Train now = at(first * (k + 0.5) / parts, n);
            period += first / parts / std::sqrt(2 * (energy - now.potential) / (inertia * now.rates));
        }
        const Train end = at(first, n);
        const Real before = std::sqrt(2 * (energy - end.potential) / (inertia * end.rates));
        // the impact: momentum along the motion that the train has after it
        const Train after = at(0, n + 1);
        Real kept = 0;
        for (int i = 0; i < n; ++i)
            kept += after.rate[static_cast<std::size_t>(i) + 1] * end.rate[static_cast<std::size_t>(i)];
        speed = kept * before / after.rates;
    }
    return period;
}

/// Seconds between two dominoes, counted over the last third of a run.
Real simulated_period(Real gap, Real h)
{
    const int count = 30;
    RoughScene scene = domino_run(count, gap, 5, 1e-4);
    ExactPile method;
    StepData<3> now;
    Real from = 0;
    for (int i = 1; i * h < 20; ++i) {
        step(scene, {.h = h}, method, now);
        if (from == 0 && std::abs(scene.bodies.x[3 * 18 + 2]) > 0.02) from = i * h;
        if (std::abs(scene.bodies.x[3 * 28 + 2]) > 0.02) return (i * h - from) / 10;
    }
    return infinity;
}

}  // namespace

// ---- what stands

TEST_CASE("a house of cards stands and falls within two percent of the friction that statics asks for",
          "[idea]")
{
    const Real mu = least_friction(static_contacts(card_house(5, 1)));
    // (13.13) leaves out what the tips can pass on to each other, and how thick a card is.
    CHECK(mu <= card_house_by_hand(5));
    CHECK(mu >= 0.98 * card_house_by_hand(5));
    const Stood above = stand_exactly(card_house(5, 1.02 * mu), 60);
    CHECK(above.stands);
    CHECK(above.moved <= 1e-9);  // no weight is lost: rounding of a few metres, 3,600 steps
    CHECK(above.unsolved == 0);
    CHECK_FALSE(stand_exactly(card_house(5, 0.98 * mu), 10).stands);
    for (const int substeps : {1, 8}) {
        // measured: 7e-10 and 1e-13
        CHECK(stand_by_sweeps(card_house(5, 1.02 * mu), 60, substeps).moved <= 1e-6);
        CHECK_FALSE(stand_by_sweeps(card_house(5, 0.98 * mu), 10, substeps).stands);
    }
}

TEST_CASE("two cards that lean on each other need half the tangent of their angle", "[idea]")
{
    // A thin card: H c = w s / 2 about its foot. The half thickness makes it less by its share of the height.
    const Real hand = card_house_by_hand(1);
    CHECK(std::abs(hand - Cards::sine / Cards::cosine / 2) <= 1e-15);
    // exercise 13.4: under many storeys the whole tangent
    CHECK(std::abs(card_house_by_hand(60) / (2 * hand) - 1) <= 0.01);
    CHECK(card_house_by_hand(60) < 2 * hand);
    for (const Real share : {0.98, 1.02})
        CHECK(stand_exactly(card_house(1, share * hand), 5).stands == (share > 1));
}

TEST_CASE("an arch of ten stones stands and falls within two percent of (13.20)", "[idea]")
{
    const Real mu = least_friction(static_contacts(stone_arch(10, 0.3, 1)));
    CHECK(std::abs(mu - arch_by_hand(10)) <= 1e-4);  // as far as the bisection goes
    const Stood above = stand_exactly(stone_arch(10, 0.3, 1.02 * mu), 60);
    CHECK(above.stands);
    CHECK(above.moved <= 1e-9);  // as the house
    CHECK(above.unsolved == 0);
    CHECK_FALSE(stand_exactly(stone_arch(10, 0.3, 0.98 * mu), 10).stands);
    for (const int substeps : {1, 8}) {
        // measured: 8e-9 and 5e-12
        CHECK(stand_by_sweeps(stone_arch(10, 0.3, 1.02 * mu), 60, substeps).moved <= 1e-6);
        CHECK_FALSE(stand_by_sweeps(stone_arch(10, 0.3, 0.98 * mu), 10, substeps).stands);
    }
}

TEST_CASE("joints near the feet of an arch of many stones are held whatever (13.20) would say of them",
          "[idea]")
{
    const int stones = 20;
    const Real mu = arch_by_hand(stones), psi = std::atan(mu), steepest = (stones / 2 - 1) * pi / stones;
    // Their cone reaches beyond upright: (13.20) has a negative tangent there and would refuse any μ.
    CHECK(steepest + psi > pi / 2);
    CHECK(mu * std::tan(steepest + psi) < 0);
    CHECK(std::abs(least_friction(static_contacts(stone_arch(stones, 0.6, 1))) - mu) <=
          1e-4);  // the bisection
}

TEST_CASE("a thin arch of rough stones folds at hinges where its line of thrust leaves the stones", "[idea]")
{
    const Real mu = 2;
    Real low = 0.05, high = 0.2;
    while (high - low > 1e-5) {
        const Real middle = (low + high) / 2;
        (can_stand(static_contacts(stone_arch(10, middle, mu)), mu) ? high : low) = middle;
    }
    CHECK(std::abs(high / 0.1075 - 1) <= 0.02);  // R5, of a ring of many joints
    CHECK(stand_exactly(stone_arch(10, 1.02 * high, mu), 10).moved <= 1e-9);
    CHECK_FALSE(stand_exactly(stone_arch(10, 0.98 * high, mu), 10).stands);
}

TEST_CASE("an arch of four stones needs the friction of exercise 13.5", "[idea]")
{
    CHECK(std::abs(arch_by_hand(4) - (std::sqrt(17.0) - 3) / 4) <= 1e-15);
    for (const Real share : {0.98, 1.02})
        CHECK(stand_exactly(stone_arch(4, 0.5, share * arch_by_hand(4)), 10).stands == (share > 1));
}

TEST_CASE("a block between two walls falls or is held and both are answers", "[idea]")
{
    FrictionRows block;
    block.inverse_mass = Vec<3>(1, 1, 6);
    block.u_star = Vec<3>(0, -0.1, 0);
    add_contact(block, world, 0, {1, 0}, {0, 0}, {-0.5, 0}, 0.5);
    add_contact(block, world, 0, {-1, 0}, {0, 0}, {0.5, 0}, 0.5);
    for (const Real squeeze : {0.0, 1.0}) {
        Mlcp mlcp = assemble(block.rows, block.u_star);
        std::vector<FrictionBox> boxes;
        boxes_of(block.rows, boxes);
        Solution exact, swept;
        exact.lambda = swept.lambda = Vec<4>(squeeze, 0, squeeze, 0);
        FrictionMemory memory;
        friction_active_sets(mlcp, boxes, {}, memory, exact);
        CHECK(exact.status == Status::solved);
        ImpulseMemory<3> sweeps;
        VecX by_sweeps = block.u_star, by_exact = block.u_star;
        sequential_impulse<3>(block.rows, {}, {100, 1e-12}, sweeps, by_sweeps, swept);
        for (std::size_t i = 0; i < 4; ++i)
            block.rows[i].apply(exact.lambda[static_cast<Index>(i)], by_exact);
        for (const VecX& u : {by_sweeps, by_exact})
            CHECK(std::abs(u[1] - (squeeze > 0 ? 0 : -0.1)) <= 1e-11);  // the sweeps' tolerance
    }
}

// ---- what moves

TEST_CASE("without repayment exact friction never adds energy to rubble in motion", "[idea]")
{
    Random random(2024);
    int unsolved = 0;
    for (int round = 0; round < 50; ++round) {
        const Real mu = random.uniform(0, 1.2);
        RoughScene scene = random_heap(random, 9, mu);
        ExactPile method;
        // as (13.14) needs: b ≥ 0 at each contact, and nobody is put back to where it would have struck something
        method.correction.method = Stabilizer::none;
        method.contacts.fast.stop = false;
        StepData<3> now;
        Real before = energy(scene);
        const Real scale = std::abs(before);
        for (int i = 0; i < 120; ++i) {
            const VecX u = scene.bodies.u;
            step(scene, {.h = 1.0 / 120}, method, now);
            unsolved += method.solver.unsolved;
            REQUIRE(scene.bodies.x.allFinite());
            const Real after = energy(scene);
            const Real least = kinetic_energy(scene.bodies.u - u, scene.bodies.inverse_mass);
            // (13.14); each row is solved to 1e-11 of speeds of metres a second
            CHECK(after <= before - least + 1e-9 * scale);
            before = after;
        }
    }
    CHECK(unsolved == 0);
}

TEST_CASE("a wall that a ball hits and a run of dominoes keep their bodies finite and lose energy", "[idea]")
{
    for (RoughScene scene : {brick_wall(6, 5, 0.6, 12), domino_run(10, 0.35, 1, 0.2)}) {
        ExactPile method;
        method.correction.method = Stabilizer::none;
        method.contacts.fast.stop = false;
        StepData<3> now;
        Real before = energy(scene);
        const Real scale = before;
        for (int i = 0; i < 240; ++i) {
            step(scene, {.h = 1.0 / 240}, method, now);
            REQUIRE(scene.bodies.x.allFinite());
            const Real after = energy(scene);
            CHECK(after <= before + 1e-9 * scale);
            before = after;
        }
    }
}

TEST_CASE("the wave of a run of dominoes has the speed of a train with one unknown", "[idea]")
{
    const Real gap = 0.35, hand = domino_period(gap);
    std::vector<Real> errors;
    for (const Real h : {1.0 / 240, 1.0 / 480, 1.0 / 960})
        errors.push_back(simulated_period(gap, h) / hand - 1);
    CHECK(std::abs(errors.back()) <= 0.02);
    CHECK(std::abs(errors.back()) <= std::abs(errors.front()));
}

TEST_CASE("two discs that graze are thrown as (13.21) says", "[idea]")
{
    for (const Real kappa : {0.5, 0.4})
        for (const Real spin : {-40.0, 0.0, 25.0, 200.0})
            for (const Real e : {0.0, 0.9}) {
                const Real r = 0.03, mass = 0.17, mu = 0.08, angle = 0.5;
                RoughScene scene;
                scene.gravity = {0, 0};
                const Mass ball{mass, {0, 0}, kappa * mass * r * r};
                add_body(scene, disc(r), ball, {0, 0});
                add_body(scene, disc(r), ball, 2 * r * Vec2(std::cos(angle), std::sin(angle)));
                cover(scene, {mu, e, 0, 0});
                scene.bodies.velocity(0) << 3, 0, spin;
                const VecX before = scene.bodies.u;
                ExactPile method;
                StepData<3> now;
                step(scene, {.h = 1e-4}, method, now);
                const Vec2 n(std::cos(angle), std::sin(angle)), t = perpendicular(n);
                // a's surface runs past b's along t at 3 t_x + r spin
                const Throw hand = throw_by_hand(mass, kappa, 3 * n.x(), 3 * t.x() + r * spin, mu, e);
                const Vec2 given = mass * scene.bodies.velocity(1).head<2>();
                CHECK(std::abs(given.dot(n) - hand.normal) <= 1e-12);
                CHECK(std::abs(given.dot(t) - hand.tangent) <= 1e-12);
            }
}

TEST_CASE("the break of a pool game keeps momentum and angular momentum until a ball is at the cushion",
          "[idea]")
{
    RoughScene scene = pool_break(8, 60, 0.06, 0);
    ExactPile method;
    StepData<3> now;
    const Vec<3> start = momenta(scene.bodies);
    Real last = energy(scene);
    for (int i = 0; i < 120; ++i) {
        step(scene, {.h = 1.0 / 480}, method, now);
        bool cushion = false;
        for (const Contact& contact : now.contacts) cushion = cushion || contact.a == world;
        if (cushion) break;
        // 1.4 N s in sums of sixteen balls
        CHECK((momenta(scene.bodies) - start).lpNorm<Eigen::Infinity>() <= 1e-12);
        CHECK(energy(scene) <= last * (1 + 1e-10));
        last = energy(scene);
    }
    // the break has reached the ball at the far corner
    CHECK(scene.bodies.velocity(15).head<2>().norm() > 0.1);
}

// ---- impacts

TEST_CASE("Poisson's law gives back e times the impulse of compression whatever friction does", "[idea]")
{
    Random random(61);
    for (int round = 0; round < 300; ++round) {
        const Real angle = random.uniform(0.1, 1.4), slide = random.uniform(-3, 3),
                   mu = random.uniform(0, 1.5), e = random.uniform();
        FrictionRows rod;
        rod.inverse_mass = Vec<3>(1, 1, 12);
        rod.u_star = Vec<3>(slide, -1, 0);
        add_contact(rod, world, 0, {0, 1}, {0, 0}, -Vec2(std::cos(angle), std::sin(angle)) / 2, mu);
        const auto struck = [&](Real coefficient, ImpactLaw law, VecX& u) {
            FindFriction find;
            u = rod.u_star;
            return impact(rod.rows, coefficient, law, find, u).lambda;
        };
        VecX u0, u;
        const VecX compression = struck(0, ImpactLaw::poisson, u0), all = struck(e, ImpactLaw::poisson, u);
        // λ_n of the second half is at its bound e λ_n, or the end would come closer again without more
        const Real leaves = rod.rows[0].velocity(u);
        CHECK(all[0] >= (1 + e) * compression[0] - 1e-12);
        CHECK(std::abs(std::min(all[0] - (1 + e) * compression[0], leaves)) <= 1e-10);
        CHECK(std::abs(all[1]) <= mu * all[0] + 1e-12);
    }
    // R2: it slips one way all the time, and so the laws agree
    FrictionRows rod;
    rod.inverse_mass = Vec<3>(1, 1, 12);
    rod.u_star = Vec<3>(0, -1, 0);
    add_contact(rod, world, 0, {0, 1}, {0, 0}, -Vec2(std::cos(pi / 6), std::sin(pi / 6)) / 2, 0.3);
    FindFriction find;
    VecX u = rod.u_star;
    CHECK(std::abs(impact(rod.rows, 0.5, ImpactLaw::poisson, find, u).lambda[0] - 0.5244226112797739) <=
          1e-12);
}

TEST_CASE("Lemke's friction slides to both sides", "[idea]")
{
    // λ = β₊ − β₋: a block that slides to the right needs one of them, to the left the other.
    for (const Real slide : {-3.0, 3.0}) {
        FrictionRows block;
        block.inverse_mass = Vec<3>(1, 1, 6);
        block.u_star = Vec<3>(slide, -1, 0);
        add_contact(block, world, 0, {0, 1}, {0, 0}, {0, 0}, 0.5);
        Mlcp mlcp = assemble(block.rows, block.u_star);
        const std::vector<FrictionBox> boxes{{1, 0, 0.5}};
        const Solution lemke = stewart_trinkle_by_lemke(mlcp, boxes);
        CHECK(std::abs(lemke.lambda[0] - 1) <= 1e-12);
        CHECK(std::abs(std::abs(lemke.lambda[1]) - 0.5) <= 1e-12);
        CHECK(lemke.lambda[1] * block.rows[1].Jb[0] * slide < 0);
    }
}
