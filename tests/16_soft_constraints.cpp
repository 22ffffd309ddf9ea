/// Chapter 16: springs that cannot explode, and what is made of them.

#include "tests/catch.hpp"
#include "tests/order.hpp"
#include "tests/sentence.hpp"

#include "chapters/16_soft_constraints/soft_method.hpp"
#include "chapters/16_soft_constraints/soft_scenes.hpp"
#include "common/random.hpp"

using namespace rigid;

namespace {

/// All that is in a scene of linear springs: kinetic, of weight, of springs [J].
Real whole_energy(const JointedScene& scene)
{
    Real sum = energy(scene);
    for (const PointJoint& joint : scene.joints) {
        const Real C = joint_constraint(scene.bodies.x, joint).C;
        sum += joint.stiffness * C * C / 2;
    }
    return sum;
}

/// A network of bodies on linear springs of all directions, with random velocities: at the rest of all springs, or with
/// springs of any length that pull against each other.
JointedScene random_network(Random& random, Real omega, Real zeta, bool stressed)
{
    JointedScene scene;
    scene.gravity = {0, 0};
    for (int k = 0; k < 6; ++k) {
        const Real x = random.uniform(-2, 2), y = random.uniform(-2, 2), exponent = random.uniform(-1, 1);
        add_body(scene, disc(0.1), std::pow(10.0, exponent), {x, y});
        for (const Index i : {3 * k, 3 * k + 1}) scene.bodies.u[i] = omega * random.uniform(-1, 1);
    }
    for (int i = 0; i < 9; ++i) {
        const Index b = 1 + random.index(5), a = random.index(b + 1) - 1;
        const Real angle = random.uniform(0, 6), free = random.uniform(-1, 1);
        const Real m = 1 / scene.bodies.inverse_mass[3 * b];
        const Vec2 n(std::cos(angle), std::sin(angle));
        Vec2 way = scene.bodies.position(b).head<2>();
        if (a != world) way -= scene.bodies.position(a).head<2>();
        add_linear_spring(scene, a, b, n, stressed ? free : n.dot(way),
                          {m * omega * omega, 2 * zeta * m * omega});
    }
    return scene;
}

template <class Method>
void take(JointedScene& scene, Method& method, Real h, int steps, int substeps = 1)
{
    StepData<3> now;
    for (int i = 0; i < steps; ++i) step(scene, {.h = h, .substeps = substeps}, method, now);
}

/// One body of 2 kg on one spring, away from its rest and moving.
JointedScene one_spring(const Softness& how)
{
    JointedScene scene = hanging_masses({2}, spring_of(how, 0.5));
    scene.gravity = {0, 0};
    scene.bodies.x[1] = -1.3;
    scene.bodies.u[1] = -0.7;
    return scene;
}

}  // namespace

// ------------------------------------------------------------------------------------------------ the spring

TEST_CASE("one step of the spring of section 16.1 is where the text says", "[idea]")
{
    // 1 kg on a spring of 30 Hz, 1 cm out of its rest; each number to the last digit of the text
    const Real h = 1.0 / 60, omega = 60 * pi, x = 0.01;
    const Real at_start = -h * omega * omega * x;
    CHECK(at_start == Approx(-5.9).margin(0.05));
    CHECK(x + h * at_start == Approx(-0.089).margin(5e-4));
    const Real at_end = implicit_velocity(x, 0, {30, 0}, h);
    CHECK(at_end == Approx(-0.54).margin(0.005));
    CHECK(at_end == Approx(at_start / (1 + pi * pi)).epsilon(1e-14));  // (16.4)
    CHECK(x + h * at_end == Approx(0.0009).margin(5e-5));
    const SoftTerms row = soft_terms(Softness{30, 0}, 1, h);  // (16.7) and (16.9), with A = 1
    CHECK(-(row.rate * x) / (1 + row.softness) == Approx(at_end).epsilon(1e-14));
}

TEST_CASE("a spring of 30 Hz and ten times the critical damping has the terms of the reference", "[idea]")
{
    const Softness how{30, 10};
    const Real h = 1.0 / 240;
    for (const Real A : {0.5, 3.0}) {
        const SoftTerms terms = soft_terms(how, A, h);
        CHECK(terms.rate == Approx(9.068652798161135).epsilon(1e-12));
        const Real gamma = terms.softness / A;
        CHECK(1 / (1 + gamma) == Approx(0.9422793210722282).epsilon(1e-12));
        CHECK(gamma / (1 + gamma) == Approx(0.05772067892777181).epsilon(1e-12));
    }
    CHECK(soft_scales(how, h).mass == Approx(0.9422793210722282).epsilon(1e-12));
    CHECK(soft_scales(how, h).impulse == Approx(0.05772067892777181).epsilon(1e-12));
}

TEST_CASE("the row of a spring gives the velocity of the implicit step", "[idea]")
{
    for (const Real f : {0.1, 5.0, 1e4})
        for (const Real zeta : {0.0, 0.3, 1.0, 10.0})
            for (const Real h : {1.0 / 240, 1.0 / 60, 1.0}) {
                const Softness how{f, zeta};
                const Real x = 0.3, v = -0.7, A = 0.5;
                const SoftTerms terms = soft_terms(how, A, h);
                const Real lambda = -(v + terms.rate * x) / (A + terms.softness);
                // sums of terms of the size of v and x/h
                CHECK(v + A * lambda ==
                      Approx(implicit_velocity(x, v, how, h)).epsilon(1e-12).margin(1e-12 * (1 + x / h)));
            }
}

TEST_CASE("a spring is the same by its frequency and by its stiffness", "[idea]")
{
    for (const Real A : {0.01, 1.0, 40.0})
        for (const Real f : {0.5, 60.0})
            for (const Real zeta : {0.0, 0.4, 5.0}) {
                const Softness how{f, zeta};
                const SpringConstants spring = spring_of(how, A);
                for (const Real h : {1e-4, 1.0 / 60}) {
                    const SoftTerms one = soft_terms(how, A, h), other = soft_terms(spring, h);
                    CHECK(one.rate == Approx(other.rate).epsilon(1e-12));
                    CHECK(one.softness == Approx(other.softness).epsilon(1e-12));
                }
                const Softness back = softness_of(spring, A);
                CHECK(back.frequency == Approx(f).epsilon(1e-12));
                CHECK(back.damping_ratio == Approx(zeta).epsilon(1e-12).margin(1e-15));
            }
}

TEST_CASE("the limits of a spring are a hard row that takes back all and one that forgets", "[idea]")
{
    const Real A = 2, h = 0.01;
    const SoftTerms stiff = soft_terms(Softness{infinity, 1}, A, h);
    CHECK(stiff.rate == 1 / h);
    CHECK(stiff.softness == 0);
    CHECK(implicit_velocity(0.3, -0.7, {infinity, 1}, h) == -0.3 / h);
    CHECK(implicit_velocity(0.3, -0.7, {1e9, 1}, h) == Approx(-0.3 / h).epsilon(1e-6));  // as below
    const SoftTerms nearly = soft_terms(Softness{1e9, 1}, A, h);
    // 2ζ/ω beside h: 3e-8
    CHECK(nearly.rate == Approx(1 / h).epsilon(1e-6));
    CHECK(nearly.softness == Approx(0).margin(1e-12));
    // Hard is hard by whichever name, damped or not.
    for (const Real zeta : {0.0, 1.0, 10.0}) {
        const Softness hard{infinity, zeta};
        const SpringConstants spring = spring_of(hard, A);
        CHECK(spring.stiffness == infinity);
        CHECK(soft_terms(hard, A, h).rate == 1 / h);
        CHECK(soft_terms(spring, h).rate == 1 / h);
        CHECK(soft_terms(spring, h).softness == 0);
        CHECK(soft_terms(SpringConstants{infinity, infinity}, h).rate == 1 / h);
        CHECK(softness_of(spring, A).frequency == infinity);
        CHECK(std::isfinite(softness_of(spring, A).damping_ratio));
        CHECK(implicit_velocity(0.3, 0.7, hard, h) == -0.3 / h);
        CHECK(soft_scales(hard, h).mass == 1);
        CHECK(soft_scales(hard, h).impulse == 0);
        CHECK(implicit_velocity(0.3, 0.7, {1e12, zeta}, h) == Approx(-0.3 / h).epsilon(1e-6));
    }
    const SoftTerms thick = soft_terms(Softness{10, 1e12}, A, h);
    CHECK(thick.rate == Approx(0).margin(1e-10));
    CHECK(thick.softness == Approx(0).margin(1e-9));
    const SoftTerms undamped = soft_terms(Softness{10, 0}, A, h);
    const Real turn = 2 * pi * 10 * h;
    const SoftTerms slack = soft_terms(Softness{1e-9, 1}, A, h), loose = soft_terms(Softness{1e-9, 0}, A, h);
    CHECK(slack.rate == Approx(0).margin(1e-8));        // ω/2ζ
    CHECK(slack.softness > 1e9);                        // A/(2ζ h ω)
    CHECK(loose.rate == Approx(1 / h).epsilon(1e-14));  // whatever ω is, if nothing damps
    CHECK(loose.softness > 1e19);
    CHECK(undamped.rate == Approx(1 / h).epsilon(1e-14));
    CHECK(undamped.softness == Approx(A / (turn * turn)).epsilon(1e-14));
}

TEST_CASE("a softness that makes no sense is refused by name", "[house]")
{
    CHECK(sentence_of([] {
              require_valid(Softness{0, 1}, "joints");
          }) == "the frequency of joints is 0 Hz; it must be positive (infinite: hard)");
    // without damping its γ would be A/0, and γ λ no number
    CHECK(sentence_of([] {
              require_valid(Softness{1e-165, 0}, "contacts");
          }) == "the frequency of contacts is 1e-165 Hz; it must be 1e-75 or more");
    CHECK(sentence_of([] { require_valid(Softness{1e-75, 0}, "contacts"); }) == "accepted");
    CHECK(sentence_of([] {
              require_valid(Softness{1, -1}, "contacts");
          }) == "the damping ratio of contacts is -1; it must be zero or positive and finite");
    CHECK(sentence_of([] { require_valid(Softness{infinity, 0}, "contacts"); }) == "accepted");
}

TEST_CASE("one step of each method on one spring is the implicit step", "[idea]")
{
    for (const Real f : {0.5, 20.0, 1e3})
        for (const Real zeta : {0.0, 0.7, 10.0}) {
            const Softness how{f, zeta};
            const Real h = 1.0 / 60;
            // along n = (0, −1): x = C = 0.3, v = 0.7
            const Real expected = -implicit_velocity(0.3, 0.7, how, h);
            const auto check = [&](auto method, Real tolerance) {
                JointedScene scene = one_spring(how);
                take(scene, method, h, 1);
                CHECK(scene.bodies.u[1] == Approx(expected).margin(tolerance));
                CHECK(scene.bodies.x[1] == Approx(-1.3 + h * expected).margin(tolerance * h));
            };
            // the size of what is added is x/h = 18 m/s
            check(SoftSweeps<AllBodies>{}, 1e-11);
            check(SoftExact<AllBodies>{}, 1e-11);
            check(PositionSweeps<AllBodies>{}, 1e-11);
            BodyDescent<AllBodies> descent;
            descent.correction.first = descent.correction.most = 1e15;
            check(descent, 1e-11);
        }
}

// ------------------------------------------------------------------------------------------------ energy

TEST_CASE("the energy that an implicit step loses is the sum of squares of the text", "[house]")
{
    Random random(1);
    for (int round = 0; round < 200; ++round) {
        const Real zeta = random.uniform(0, 2), exponent = random.uniform(-3, 1), h = 0.01;
        const Real omega = std::pow(10.0, exponent) / h;
        const Softness how{omega / (2 * pi), zeta};
        const Real x = random.uniform(-1, 1), v = omega * random.uniform(-1, 1);
        const Real w = implicit_velocity(x, v, how, h), y = x + h * w;
        const Real lost = (v * v + omega * omega * x * x - w * w - omega * omega * y * y) / 2;
        const Real squares =
            (w - v) * (w - v) / 2 + omega * omega * h * h * w * w / 2 + 2 * zeta * omega * h * w * w;
        CHECK(lost == Approx(squares).epsilon(1e-10).margin(1e-12 * omega * omega));
    }
}

TEST_CASE("the energy of linear springs never rises whatever the step", "[idea]")
{
    Random random(2);
    for (const bool stressed : {false, true})
        for (const Real turn : {1e-3, 1e-1, 1.0, 1e2, 1e4, 1e6})  // h ω
            for (const Real zeta : {0.0, 0.5}) {
                // springs that pull against each other with kC leave the rounding of h k C in the velocities
                if (stressed && turn > 1e2) continue;
                const Real h = 0.01, omega = turn / h;
                JointedScene scene = random_network(random, omega, zeta, stressed);
                SoftExact<AllBodies> method;
                Real before = whole_energy(scene);
                const Real start = before;
                StepData<3> now;
                int rises = 0;
                for (int i = 0; i < 100; ++i) {
                    step(scene, {.h = h}, method, now);
                    const Real after = whole_energy(scene);
                    // rounding of sums of this size
                    rises += !(after <= before + 1e-10 * start);
                    before = after;
                }
                INFO(turn);
                CHECK(rises == 0);
                CHECK(before < start);
            }
}

TEST_CASE("the energy of an explicit spring rises where the implicit one is quiet", "[house]")
{
    // v' = v − h ω² x, then x' = x + h v', h ω = 2.01
    Real x = 1, v = 0;
    for (int i = 0; i < 200; ++i) {
        v -= 2.01 * 2.01 * x;
        x += v;
    }
    CHECK(std::abs(x) > 1e6);
}

// ------------------------------------------------------------------------------------------------ redundancy

TEST_CASE("four redundant rows are definite with softness and off by softness times impulse", "[idea]")
{
    // one body of 1 kg on four equal rows under its weight: λ = gh/4 each as γ → 0
    Bodies<2> bodies(1);
    VecX u(2);
    u << 0, -9.81 / 60;
    Constraint<2> up;
    up.Jb = {0, 1};
    for (const Real gamma : {1e-1, 1e-3, 1e-6}) {
        std::vector<Row<2>> rows(4, unilateral(up, bodies.inverse_mass));
        for (Row<2>& row : rows) row.softness = gamma;
        const Mlcp mlcp = assemble(rows, u);
        const MatX A = MatX(mlcp.A);
        VecX apart(4);  // what A alone does not see
        apart << 1, -1, 0, 0;
        CHECK(apart.dot(A * apart) == Approx(2 * gamma).epsilon(1e-8));
        const Solution solution = [&] {
            ActiveSetMemory memory;
            Solution found;
            found.lambda.setZero(4);
            active_sets(mlcp, {}, memory, found);
            return found;
        }();
        REQUIRE(solution.status == Status::solved);
        const Real lambda = 9.81 / 60 / (4 + gamma);
        for (Index i = 0; i < 4; ++i) CHECK(solution.lambda[i] == Approx(lambda).epsilon(1e-9));
        VecX after = u;
        apply(rows, solution.lambda, after);
        CHECK(after[1] == Approx(-gamma * lambda).epsilon(1e-6));
    }
}

// ------------------------------------------------------------------------------------------------ exercises

TEST_CASE("an undamped spring keeps the part of its energy that exercise 16.1 says", "[idea]")
{
    for (const Real f : {0.3, 9.0, 700.0}) {
        const Softness how{f, 0};
        const Real h = 1.0 / 60, omega = 2 * pi * f, x = 0.2, v = -0.4 * omega;
        const Real w = implicit_velocity(x, v, how, h), y = x + h * w, turn = h * omega;
        const Real before = v * v + omega * omega * x * x, after = w * w + omega * omega * y * y;
        // y is a difference of x and h w, which are (hω)² times as large: 5e3
        CHECK(after / before == Approx(1 / (1 + turn * turn)).epsilon(1e-8));
    }
}

TEST_CASE("a critically damped spring of one radian a step has the numbers of exercise 16.2", "[idea]")
{
    const Real h = 0.01;
    const SoftTerms terms = soft_terms(Softness{1 / (2 * pi * h), 1}, 2, h);
    CHECK(terms.rate * h == Approx(1.0 / 3).epsilon(1e-14));
    CHECK(terms.softness == Approx(2.0 / 3).epsilon(1e-14));
}

TEST_CASE("two springs side by side are one of the sum of their stiffness", "[idea]")
{
    const auto after = [](const std::vector<Real>& stiffness) {
        JointedScene scene = hanging_masses({2}, {stiffness[0], 0});
        for (std::size_t i = 1; i < stiffness.size(); ++i)
            add_linear_spring(scene, world, 0, {0, -1}, 1, {stiffness[i], 0});
        scene.bodies.x[1] = -1.2;
        SoftExact<AllBodies> method;
        take(scene, method, 1.0 / 60, 3);
        return scene.bodies.u[1];
    };
    CHECK(after({300, 50}) == Approx(after({350})).epsilon(1e-12));
}

TEST_CASE("the small system of a body gives back the motion that it was made of", "[house]")
{
    Random random(15);
    for (int n = 0; n < 200; ++n) {
        Mat<3> B;
        for (Index i = 0; i < 9; ++i) B(i / 3, i % 3) = random.normal();
        Vec<3> x;
        for (Index i = 0; i < 3; ++i) x[i] = random.normal();
        const Mat<3> H = B * B.transpose() + 0.1 * Mat<3>::Identity();
        // ten roundings, times the condition number, at most about 300
        CHECK((solve_definite<3>(H, H * x) - x).norm() < 1e-12 * (1 + x.norm()));
    }
}
