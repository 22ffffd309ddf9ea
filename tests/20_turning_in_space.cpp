/// Chapter 20: rotations, a free spin, mass and inertia.

#include "chapters/20_turning_in_space/exact_tumbling.hpp"
#include "chapters/20_turning_in_space/free_solids.hpp"
#include "chapters/20_turning_in_space/tossed.hpp"
#include "common/random.hpp"

#include "tests/catch.hpp"
#include "tests/order.hpp"
#include "tests/sentence.hpp"

#include <array>

using namespace rigid;

namespace {

Vec3 random_vector(Random& random, Real size)
{
    const Real x = random.uniform(-size, size), y = random.uniform(-size, size),
               z = random.uniform(-size, size);
    return {x, y, z};
}

Real spin_energy(const Vec3& inertia, const Vec3& omega) { return inertia.dot(omega.cwiseAbs2()) / 2; }

/// Error of ω after 5 s of a free spin, for 50 2^i steps.
std::vector<Real> spin_errors(Tumbling way, int halvings)
{
    const Vec3 inertia(1, 2, 3);
    std::vector<Real> errors;
    for (int i = 0; i <= halvings; ++i) {
        const int steps = 50 << i;
        Vec3 theta(0, 0, 0), omega(0.5, 0, 1);
        for (int n = 0; n < steps; ++n) tumble(way, inertia, 5.0 / steps, theta, omega);
        errors.push_back((omega - exact_spin(inertia, 0.5, 1, 5)).norm());
    }
    return errors;
}

/// (20.22): what engines take for the root of (20.20).
Vec3 one_newton_step(const Vec3& inertia, const Vec3& omega, Real h)
{
    const Vec3 L = inertia.cwiseProduct(omega);
    const Mat3 I = inertia.asDiagonal();
    return omega - solve3(I + h * (cross_matrix(omega) * I - cross_matrix(L)), h * cross(omega, L));
}

}  // namespace

// ---- the example by hand ------------------------------------------------------------------------

TEST_CASE("one step of the book of section 20.1 has the numbers that are found by hand", "[idea]")
{
    const Vec3 I = mass_of(solid_box({0.16, 0.24, 0.04}), 0.7 / (0.16 * 0.24 * 0.04)).inertia.diagonal();
    // each number to the last digit of the text
    CHECK((I - Vec3(34.5, 15.9, 48.5) * 1e-4).cwiseAbs().maxCoeff() < 0.05e-4);
    const Vec3 spin(12, 1.2, 1.2), L = I.cwiseProduct(spin);
    CHECK((L - Vec3(41.4, 1.9, 5.8) * 1e-3).cwiseAbs().maxCoeff() < 0.05e-3);
    const Real h = 1.0 / 60;
    const Vec3 turned = L - cross(h * spin, L);
    CHECK((turned - Vec3(41.4, 2.2, 6.3) * 1e-3).cwiseAbs().maxCoeff() < 0.05e-3);
    CHECK((turned.cwiseQuotient(I) - Vec3(11.98, 1.41, 1.29)).cwiseAbs().maxCoeff() < 0.005);
    const auto gain = [&](const Vec3& omega) { return spin_energy(I, omega) / spin_energy(I, spin) - 1; };
    const Vec3 by_start = spin_in_turned_axes(I, spin, h * spin);
    CHECK((by_start - Vec3(11.98, 1.44, 1.28)).cwiseAbs().maxCoeff() < 0.005);
    CHECK(gain(by_start) == Approx(2.5e-4).margin(0.05e-4));
    const Vec3 turn = turn_through_the_middle(I, spin, h), by_middle = spin_in_turned_axes(I, spin, turn);
    CHECK((turn / h - Vec3(11.99, 1.30, 1.25)).cwiseAbs().maxCoeff() < 0.005);
    CHECK((by_middle - Vec3(11.97, 1.42, 1.30)).cwiseAbs().maxCoeff() < 0.005);
    CHECK(gain(by_middle) == Approx(7e-6).margin(0.5e-6));
}

// ---- rotations ----------------------------------------------------------------------------------

TEST_CASE("a quaternion turns a vector about its axis by its angle", "[idea]")
{
    Random random(1);
    for (int i = 0; i < 1000; ++i) {
        const Vec3 theta = random_vector(random, 1.8), r = random_vector(random, 2);
        const Real angle = theta.norm();
        const Vec3 a = theta / angle;
        // Rodrigues, (20.3): what is along the axis stays, what is across it turns in its plane
        const Vec3 along = a * a.dot(r),
                   turned = along + std::cos(angle) * (r - along) + std::sin(angle) * cross(a, r);
        const Mat3 R = rotation_matrix(quaternion_of(theta));
        // a few roundings of numbers below 4
        CHECK((R * r - turned).norm() < 1e-14);
        CHECK((R * R.transpose() - Mat3::Identity()).norm() < 1e-14);
        if (angle < pi) CHECK((rotation_vector(quaternion_of(theta)) - theta).norm() < 1e-14);
    }
}

TEST_CASE("turning by one vector and then by another is the product of both", "[idea]")
{
    Random random(2);
    for (int i = 0; i < 1000; ++i) {
        const Vec3 theta = random_vector(random, 3), delta = random_vector(random, 3);
        const Mat3 both = rotation_matrix(quaternion_of(theta)) * rotation_matrix(quaternion_of(delta));
        CHECK((rotation_matrix(quaternion_of(add_rotation(theta, delta))) - both).norm() < 1e-14);
        CHECK(add_rotation(theta, delta).norm() <= pi * (1 + 1e-15));
    }
    // About one axis angles add up, and a full turn is none.
    const Vec3 axis(0, 0.6, 0.8);
    Vec3 theta(0, 0, 0);
    for (int i = 0; i < 10; ++i) theta = add_rotation(theta, 0.7 * axis);
    CHECK((theta - (7 - 2 * pi) * axis).norm() < 1e-14);
}

TEST_CASE("a rotation vector is found again from its matrix also near half a turn", "[idea]")
{
    Random random(3);
    for (int i = 0; i < 1000; ++i) {
        Vec3 axis = random_vector(random, 1);
        axis /= axis.norm();
        const Real angle = i % 2 == 0 ? pi - 1e-9 * random.uniform() : random.uniform(0, pi);
        const Vec3 back = rotation_vector(rotation_matrix(quaternion_of(angle * axis)));
        // near π the vector may come out on the other side, so the matrices are compared
        CHECK((rotation_matrix(quaternion_of(back)) - rotation_matrix(quaternion_of(angle * axis))).norm() <
              1e-13);
    }
}

TEST_CASE("adding half of h omega q to q makes it longer by the square root of (20.14) in each step",
          "[idea]")
{
    const Vec3 omega(1, -2, 3);
    const Real h = 0.01;
    Quaternion q;
    for (int i = 0; i < 100; ++i) {
        const Quaternion rate = q * Quaternion{0, omega};
        q.w += h / 2 * rate.w;
        q.v += h / 2 * rate.v;
    }
    const Real norm = std::sqrt(q.w * q.w + q.v.squaredNorm());
    CHECK(norm == Approx(std::pow(1 + h * h * omega.squaredNorm() / 4, 50)).epsilon(1e-13));
}

// ---- a free body --------------------------------------------------------------------------------

TEST_CASE("the closed form of a free spin obeys Euler's equations and its period is the reference's",
          "[idea]")
{
    const Vec3 inertia(1, 2, 3);
    for (const Vec3& start : {Vec3(0.5, 0, 1), Vec3(1, 0, 0.2)})  // about either outer axis
        for (const Real t : {0.0, 0.7, 3.0, 20.0}) {
            const Real d = 1e-5;
            const Vec3 omega = exact_spin(inertia, start[0], start[2], t),
                       rate = (exact_spin(inertia, start[0], start[2], t + d) -
                               exact_spin(inertia, start[0], start[2], t - d)) /
                              (2 * d);
            // central differences: d² and rounding over d
            CHECK((inertia.cwiseProduct(rate) + cross(omega, inertia.cwiseProduct(omega))).norm() < 1e-9);
        }
    CHECK((exact_spin(inertia, 0.5, 1, 0) - Vec3(0.5, 0, 1)).norm() < 1e-15);
    // reference value S1
    CHECK(spin_period({1, 2, 4}, {0.1, 3, 0.05}) == Approx(9.29398136423654152).epsilon(1e-13));
}

TEST_CASE("a spin with the energy of the middle axis never comes back and one beside it does late", "[idea]")
{
    // 1 (4 - 1) 2² = 6 (6 - 4) 1²: L² = 2 E I₂ to the last digit
    const Vec3 inertia(1, 4, 6);
    for (const Real scale : {1.0, 0.3, 1e-30, 1e30})
        CHECK(spin_period(inertia, scale * Vec3(2, 0.7, 1)) == infinity);
    CHECK(spin_period(inertia, {0, 1, 0}) == infinity);
    const Vec3 late = exact_spin(inertia, 2, 1, 1000);
    // all of the energy is about the middle axis: 4 ω₂² = 1 · 2² + 6 · 1²
    CHECK((late - Vec3(0, std::sqrt(2.5), 0)).norm() < 1e-14);
    // 4 K(k) = 4 log(4/k') but for k'² log k', and k' = √(1 - k²) of a spin (0, ω, e) is e/ω √(I₃ (I₃ - I₁)/(I₂ (I₂ - I₁)))
    for (const Real e : {1e-5, 1e-9, 1e-20, 1e-40}) {
        const Real rate = std::sqrt((6.0 - 4) * (4 - 1) / (6 * 1)), k_rest = e * std::sqrt(6.0 * 5 / (4 * 3));
        CHECK(spin_period(inertia, {0, 1, e}) == Approx(4 * std::log(4 / k_rest) / rate).epsilon(1e-8));
    }
}

TEST_CASE("Jacobi's functions are those of a circle at 0 and hyperbolic at 1 and refuse what is outside",
          "[house]")
{
    for (const Real u : {-30.0, -2.0, 0.0, 1e-9, 0.7, 5.0, 400.0}) {
        CHECK((jacobi_functions(u, 0) - Vec3(std::sin(u), std::cos(u), 1)).norm() < 1e-13);
        const Vec3 limit(std::tanh(u), 1 / std::cosh(u), 1 / std::cosh(u));
        CHECK((jacobi_functions(u, 1) - limit).norm() < 1e-15);
        // it is off by (1 - k) cosh u, and by no more than 1 - k and roundings here
        if (std::abs(u) < 1) CHECK((jacobi_functions(u, 1 - 1e-12) - limit).norm() < 3e-12);
    }
    for (const Real k : {-0.5, 1.5, std::nan("")})
        CHECK(sentence_of([k] {
                  jacobi_functions(2, k);
              }).find("the Jacobi functions are asked for u = 2 and k = ") == 0);
    CHECK(sentence_of([] { jacobi_functions(infinity, 0.5); }) ==
          "the Jacobi functions are asked for u = inf and k = 0.5; u must be finite, and k from 0 to 1");
}

TEST_CASE("moments that are not ascending have no closed form here", "[house]")
{
    CHECK(sentence_of([] {
              spin_form({2, 1, 3}, {1, 1, 1});
          }) == "the moments of inertia are 2, 1, 3 kg m²; they must be ascending, from 1e-50 to 1e50");
    for (const Vec3& spin : {Vec3(0, 0, 0), Vec3(std::nan(""), 1, 1), Vec3(1, infinity, 1), Vec3(1e60, 1, 1)})
        CHECK(sentence_of([&] {
                  spin_period({1, 2, 3}, spin);
              }).find(" rad/s; its length must be from 1e-50 to 1e50") != std::string::npos);
    CHECK(sentence_of([] {
              exact_spin({1, 2, 3}, -0.5, 1, 0);
          }) == "a spin starts with -0.5 and 1 rad/s about its outer axes; both must be positive");
}

TEST_CASE("a free spin follows the elliptic functions to the order of its step", "[idea]")
{
    CHECK(std::abs(order_of(spin_errors(Tumbling::explicit_term, 5)) - 1) < 0.15);
    CHECK(std::abs(order_of(spin_errors(Tumbling::implicit_term, 5)) - 1) < 0.15);
    CHECK(std::abs(order_of(spin_errors(Tumbling::momentum_kept, 5)) - 1) <
          0.3);  // from above: h is large at first
    const std::vector<Real> middle = spin_errors(Tumbling::middle, 5);
    CHECK(std::abs(order_of(middle) - 2) < 0.15);
    CHECK(middle.front() < 0.05 * spin_errors(Tumbling::explicit_term, 0).front());
}

TEST_CASE("a tumbling body is where the reference has it to second order", "[idea]")
{
    // reference value S1: spin and orientation at t = 10
    const Vec3 inertia(1, 2, 4), spin(-0.06566553026641853, 3.000710920532187, 0.04229651561471986);
    const Quaternion there{0.3520594991747969,
                           {0.003580734125936212, 0.9356649913921352, 0.02392302796608458}};
    std::vector<Real> errors;
    for (const int steps : {500, 1000, 2000, 4000}) {
        Vec3 theta(0, 0, 0), omega(0.1, 3, 0.05);
        for (int n = 0; n < steps; ++n) tumble(Tumbling::middle, inertia, 10.0 / steps, theta, omega);
        errors.push_back((omega - spin).norm() +
                         (rotation_matrix(quaternion_of(theta)) - rotation_matrix(there)).norm());
    }
    CHECK(std::abs(order_of(errors) - 2) < 0.15);
    CHECK(errors.back() < 1e-4);
}

TEST_CASE("the explicit term adds the energy of (20.19) in each step and the implicit one takes it", "[idea]")
{
    Random random(4);
    for (int i = 0; i < 100; ++i) {
        const Vec3 inertia(1, 2, 2.5), omega = random_vector(random, 3);
        const Real h = 0.01;
        const Vec3 g = cross(omega, inertia.cwiseProduct(omega));
        const Real gain = h * h / 2 * g.dot(g.cwiseQuotient(inertia));
        const Real E = spin_energy(inertia, omega);
        // rounding of E
        CHECK(spin_energy(inertia, explicit_spin(inertia, omega, h)) - E == Approx(gain).margin(1e-14 * E));
        CHECK(spin_energy(inertia, implicit_spin(inertia, omega, h)) < E);
    }
}

TEST_CASE("the tossed book has the energy of Figure 20.3 after eight seconds", "[idea]")
{
    const Vec3 I = mass_of(solid_box({0.16, 0.24, 0.04}), 0.7 / (0.16 * 0.24 * 0.04)).inertia.diagonal();
    const auto kept = [&](Tumbling way) {
        Vec3 theta(0, 0, 0), omega = 12 * Vec3(1, 0.01, 0.01);  // as `--scene book` is tossed
        const Real before = spin_energy(I, omega);
        for (int n = 0; n < 1600; ++n) tumble(way, I, 0.005, theta, omega);
        return spin_energy(I, omega) / before;
    };
    CHECK(kept(Tumbling::implicit_term) == Approx(1 - 0.28).margin(0.005));
    CHECK(kept(Tumbling::momentum_kept) == Approx(2.2).margin(0.05));
    CHECK(kept(Tumbling::explicit_term) > 1.2);
    CHECK(std::abs(kept(Tumbling::middle) - 1) < 1e-4);
}

TEST_CASE("a free spin has the errors of the table of section 20.9", "[idea]")
{
    const Vec3 inertia(1, 2, 3);
    const std::array<Tumbling, 4> ways = {Tumbling::explicit_term, Tumbling::implicit_term,
                                          Tumbling::momentum_kept, Tumbling::middle};
    const std::vector<std::pair<int, std::array<Real, 4>>> table = {
        {64, {0.103, 0.085, 0.283, 0.0038}},
        {256, {0.024, 0.023, 0.059, 0.00024}},
        {1024, {0.0059, 0.0058, 0.0141, 0.000015}},
        {4096, {0.0015, 0.0015, 0.0035, 0.00000093}}};
    for (const auto& [steps, errors] : table)
        for (std::size_t way = 0; way < 4; ++way) {
            Vec3 theta(0, 0, 0), omega(0.5, 0, 1);
            for (int n = 0; n < steps; ++n) tumble(ways[way], inertia, 5.0 / steps, theta, omega);
            // the text has two or three digits of it
            CHECK((omega - exact_spin(inertia, 0.5, 1, 5)).norm() == Approx(errors[way]).epsilon(0.035));
        }
}

TEST_CASE("the root of the implicit term takes energy however fast a body spins and one Newton step gives it",
          "[idea]")
{
    // the table of section 20.C
    const auto worst = [](const Vec3& inertia, Real turn, auto&& step) {
        Random random(1);
        Real most = 0;
        for (int i = 0; i < 100000; ++i) {
            const Vec3 omega = random_vector(random, 1).normalized();
            most = std::max(most,
                            spin_energy(inertia, step(inertia, omega, turn)) / spin_energy(inertia, omega));
        }
        return most;
    };
    const std::vector<std::pair<Vec3, std::array<Real, 2>>> table = {
        {{1, 2, 3}, {1.000, 1.005}}, {{0.03, 0.77, 0.80}, {1.001, 2.9}}, {{0.001, 1, 1.001}, {1.002, 81}}};
    for (const auto& [inertia, newton] : table) {
        CHECK(worst(inertia, 0.3, one_newton_step) == Approx(newton[0]).margin(5e-4));
        CHECK(worst(inertia, 1, one_newton_step) == Approx(newton[1]).epsilon(0.02));
        CHECK(worst(inertia, 2, one_newton_step) > 1e6);
        CHECK(worst(inertia, 5, one_newton_step) > 1e6);
        for (const Real turn : {0.3, 1.0, 2.0, 5.0})  // products up to 5: roundings of them
            CHECK(worst(inertia, turn, implicit_spin) <= 1 + 1e-14);
    }
}

TEST_CASE("the implicit term is solved for any body in any order of its axes at up to ten radians a step",
          "[idea]")
{
    Random random(33);
    for (int i = 0; i < 20000; ++i) {
        // any three that a body can have: S of (20.6) from a needle to a ball
        Vec3 S;
        for (Index d = 0; d < 3; ++d) S[d] = std::pow(10, random.uniform(-6, 0));
        const Vec3 inertia(S[1] + S[2], S[2] + S[0], S[0] + S[1]);
        const Vec3 omega = random_vector(random, 1).normalized();
        const Real h = random.uniform(-10, 10);
        const Vec3 next = implicit_spin(inertia, omega, h);
        const Vec3 L = inertia.cwiseProduct(omega), L_next = inertia.cwiseProduct(next);
        // h ω times a rounding of L: the products of (20.20)
        const Real rounding = 1e-15 * (1 + std::abs(h) * next.norm()) * L.norm();
        REQUIRE((L_next - L + h * cross(next, L_next)).norm() <= 10 * rounding);
        REQUIRE(spin_energy(inertia, next) <= spin_energy(inertia, omega) * (1 + 1e-13));
        REQUIRE(L_next.norm() <= L.norm() * (1 + 1e-14));
    }
    // about an axis nothing changes, and without time
    CHECK((implicit_spin({1, 2, 3}, {0, 7, 0}, 1) - Vec3(0, 7, 0)).norm() < 1e-14);
    CHECK((implicit_spin({3, 1, 2}, {1, 2, 3}, 0) - Vec3(1, 2, 3)).norm() < 1e-15);
}

TEST_CASE("the book of section 20.1 turns over when and as fast as the text says", "[idea]")
{
    const Vec3 I = mass_of(solid_box({0.16, 0.24, 0.04}), 0.7 / (0.16 * 0.24 * 0.04)).inertia.diagonal();
    // the last digit of the text
    CHECK((I - Vec3(34.5, 15.9, 48.5) * 1e-4).cwiseAbs().maxCoeff() < 0.05e-4);
    const Real sigma = std::sqrt((I[2] - I[0]) * (I[0] - I[1]) / (I[1] * I[2]));
    CHECK(sigma == Approx(0.583).margin(5e-4));
    CHECK(std::exp(2 * pi * sigma) == Approx(39).margin(0.5));
    const auto turns_until_over = [&](Real wobble) {
        Vec3 theta(0, 0, 0), omega(1, wobble, wobble);
        int n = 0;
        for (; omega[0] > 0 && n < 20000; ++n) tumble(Tumbling::middle, I, 0.001, theta, omega);
        return n * 0.001 / (2 * pi);
    };
    CHECK(turns_until_over(0.1) == Approx(0.74).margin(0.005));
    CHECK(turns_until_over(0.01) == Approx(1.38).margin(0.005));
}

TEST_CASE("the explicit term ends in numbers that are none and the others never do", "[idea]")
{
    const Vec3 inertia(1, 2, 3);
    const auto last = [&](Tumbling way) {
        Vec3 theta(0, 0, 0), omega(0.3, 10, 0.2);
        for (int n = 0; n < 3000; ++n) tumble(way, inertia, 1.0 / 60, theta, omega);
        return spin_energy(inertia, omega) / spin_energy(inertia, {0.3, 10, 0.2});
    };
    CHECK_FALSE(last(Tumbling::explicit_term) < 1e3);
    Vec3 theta(0, 0, 0), omega(0.3, 10, 0.2);
    int steps = 0;
    for (; omega.norm() < 1e6 && steps < 3000; ++steps)
        tumble(Tumbling::explicit_term, inertia, 1.0 / 60, theta, omega);
    CHECK(steps / 60.0 == Approx(18.5).margin(0.05));  // section 20.C
    CHECK(last(Tumbling::implicit_term) < 1);
    // L is kept, so the energy is between L²/2I₃ and L²/2I₁
    CHECK(last(Tumbling::momentum_kept) < 2.01);
    CHECK(std::abs(last(Tumbling::middle) - 1) < 0.01);
}

TEST_CASE("through the middle a spin keeps its angular momentum to rounding and its energy in a band",
          "[idea]")
{
    const Vec3 inertia(1, 2, 3), start(0.01, 1, 0.02);
    for (const Real h : {0.1, 0.3}) {
        Vec3 theta(0, 0, 0), omega = start;
        Real first = 0, last = 0;
        const int steps = h < 0.2 ? 1000000 : 100000;
        for (int n = 0; n < steps; ++n) {
            tumble(Tumbling::middle, inertia, h, theta, omega);
            Real& worst = n < steps / 10 ? first : last;
            worst = std::max(worst, std::abs(spin_energy(inertia, omega) / spin_energy(inertia, start) - 1));
        }
        const Vec3 L = rotation_matrix(quaternion_of(theta)) * inertia.cwiseProduct(omega);
        // up to 1e6 roundings, and they wander: 1e-16 times their root, and what the turns lose
        CHECK((L - inertia.cwiseProduct(start)).norm() < 1e-12 * L.norm());
        CHECK(last <= first * (1 + 1e-6));                // no drift: it repeats itself
        CHECK(last == Approx(h * h / 24).epsilon(0.02));  // and a term in h⁴
    }
    // how wide the band is depends on the body and on its spin
    const auto band = [](const Vec3& moments, Vec3 omega) {
        const Real before = spin_energy(moments, omega);
        Vec3 theta(0, 0, 0);
        Real worst = 0;
        for (int n = 0; n < 20000; ++n) {
            tumble(Tumbling::middle, moments, 0.1, theta, omega);
            worst = std::max(worst, std::abs(spin_energy(moments, omega) / before - 1));
        }
        return worst / (0.01 / 24);
    };
    CHECK(band({0.03, 0.77, 0.80}, Vec3(0.01, 1, 0.02).normalized()) == Approx(2.8).margin(0.1));
    CHECK(band({34.5, 15.9, 48.5}, Vec3(0.01, 1, 0.02).normalized()) == Approx(0.001).margin(1e-4));
    // radians in a step: inexact, and still no explosion
    Vec3 theta(0, 0, 0), omega = 30 * start;
    for (int n = 0; n < 1000; ++n) tumble(Tumbling::middle, inertia, 0.1, theta, omega);
    const Real l = inertia.cwiseProduct(omega).norm();
    CHECK(l == Approx(30 * inertia.cwiseProduct(start).norm()).epsilon(1e-12));
}

TEST_CASE("a needle that turns by thousands of radians in a step keeps its angular momentum", "[house]")
{
    // of these Newton's method leads every hundredth to no number
    Random random(8);
    for (int i = 0; i < 20000; ++i) {
        const Real across = random.uniform(1, 200), fast = std::pow(10, random.uniform(3, 5));
        const Vec3 inertia(1, across, across);
        const Vec3 start = fast * random_vector(random, 1).normalized();
        Vec3 theta(0, 0, 0), omega = start;
        tumble(Tumbling::middle, inertia, 1, theta, omega);
        const Vec3 L = inertia.cwiseProduct(start),
                   after = rotation_matrix(quaternion_of(theta)) * inertia.cwiseProduct(omega);
        CHECK((after - L).norm() < 1e-13 * L.norm());  // roundings of three rotations
    }
}

TEST_CASE("run backwards a spin through the middle comes back to where it was", "[idea]")
{
    const Vec3 inertia(1, 2, 3), start(0.5, 1, -0.7);
    Vec3 theta(0, 0, 0), omega = start;
    for (int n = 0; n < 200; ++n) tumble(Tumbling::middle, inertia, 0.05, theta, omega);
    for (int n = 0; n < 200; ++n) tumble(Tumbling::middle, inertia, -0.05, theta, omega);
    CHECK((omega - start).norm() < 1e-12);  // 400 roundings, stretched by the tumbling
    CHECK(theta.norm() < 1e-12);
}

// ---- mass and inertia ---------------------------------------------------------------------------

TEST_CASE("ball and box and capsule have the inertia of the tables", "[idea]")
{
    const SolidMass box = mass_of(solid_box({1, 2, 3}), 2);
    CHECK(box.mass == Approx(12));
    CHECK((box.inertia - Mat3(Vec3(13, 10, 5).asDiagonal())).norm() < 1e-13);  // m/12 (b² + c²)
    const SolidMass ball = mass_of(solid_ball(0.5), 3);
    CHECK(ball.mass == Approx(pi / 2));
    CHECK((ball.inertia - 0.4 * ball.mass * 0.25 * Mat3::Identity()).norm() < 1e-15);
    // a capsule is a cylinder and two half balls, each about its own centroid 3r/8 from its plane, moved (20.17)
    const Real r = 0.3, l = 1.4, cylinder = pi * r * r * l, half = 2 * pi / 3 * r * r * r;
    const Real along = cylinder * r * r / 2 + 2 * half * 0.4 * r * r,
               across = cylinder * (r * r / 4 + l * l / 12) +
                        2 * half * (83.0 / 320 * r * r + std::pow(l / 2 + 3 * r / 8, 2));
    const SolidMass capsule = mass_of(solid_capsule(l, r), 1);
    CHECK(capsule.mass == Approx(cylinder + 2 * half));
    CHECK((capsule.inertia - Mat3(Vec3(along, across, across).asDiagonal())).norm() < 1e-14);
}

TEST_CASE("what has no mass of its own is refused with a sentence", "[house]")
{
    const auto with = [](const Hull& hull) { return sentence_of([&] { mass_of(hull, 1); }); };
    // the cylinder of a long capsule outweighs balls of a negative radius
    CHECK(with(solid_capsule(1, -0.1)) == "the radius in m of a body is -0.1; it must be zero or positive");
    CHECK(with(solid_ball(std::nan(""))) == "the radius in m of a body is nan; it must be zero or positive");
    CHECK(sentence_of([] { mass_of(std::vector<Hull>{}, 1); }) == "the body has no hulls");
    Hull hull = solid_box({1, 1, 1});
    for (const int vertex : {-1, 8}) {
        hull.faces[2][1] = vertex;
        CHECK(with(hull) == "a face names vertex " + std::to_string(vertex) + " among 8");
    }
    hull = solid_box({1, 1, 1});
    hull.faces.pop_back();  // a square of 1 m² is open
    CHECK(with(hull) == "the faces of a body do not close: their areas add up to 1 m², along one direction");
    hull = solid_box({1, 1, 1});
    std::swap(hull.faces[3][1], hull.faces[3][3]);  // one face inside out
    CHECK(with(hull).find("do not close") != std::string::npos);
    // Jacobi's method reads one half of it, and leaves out what is no number
    for (const Real beside : {0.3, std::nan("")}) {
        SolidMass mass;
        mass.mass = 1, mass.inertia = Mat3::Identity();
        mass.inertia(0, 1) = beside;
        SolidScene scene;
        CHECK(sentence_of([&] {
                  add_body(scene, {solid_ball(1)}, mass, {0, 0, 0});
              }) == "a body has an inertia that is not symmetric or not finite");
        CHECK(scene.bodies.count() == 0);
    }
}

TEST_CASE("a body far from the origin of its shape has the inertia that it has", "[house]")
{
    for (const Real away : {1e2, 1e5, 1e8}) {
        const Vec3 at(away, -away, 2 * away);
        const SolidMass box = mass_of(solid_box({1, 2, 4}, at), 1);
        // corners are rounded to 1e-16 of where they are; at the first of them (20.15) could cancel as well: sums of
        // fifty terms of 8 kg at six times away²
        const Real rounding = 1e-15 * away, cancelled = away < 1e3 ? 50 * 1e-16 * 8 * 6 * away * away : 0;
        CHECK(box.mass == Approx(8).epsilon(10 * (rounding + cancelled)));
        CHECK((box.centroid - at).norm() < 10 * (rounding + cancelled));
        CHECK((box.inertia - Mat3(Vec3(40, 34, 10).asDiagonal()) / 3).norm() < 100 * rounding + cancelled);
    }
}

TEST_CASE("the inertia of a cube and of a board has seven digits wherever they are", "[house]")
{
    Random random(7);
    for (const Real thick : {1.0, 0.1, 0.01})
        for (const Real away : {3.0, 30.0, 100.0, 300.0, 700.0, 3000.0})
            for (int i = 0; i < 20; ++i) {
                const Mat3 R = rotation_matrix(random_vector(random, 2));
                const Vec3 at = away * random_vector(random, 1);
                Hull board = solid_box({1, thick, 1});
                const Mat3 I = mass_of(board, 1).inertia;
                for (Vec3& p : board.vertices) p = R * p + at;
                const SolidMass far = mass_of(board, 1);
                CHECK((far.inertia - R * I * R.transpose()).norm() < 1e-7 * I.norm());
                CHECK((far.centroid - at).norm() < 1e-7);
            }
}

TEST_CASE("a body that may turn about a point has the energy of its spin alone", "[house]")
{
    SolidScene scene;
    add_body(scene, {solid_box({1, 1, 1})}, 6.0, {0, 1, 0});
    scene.bodies.inverse_mass.head<3>().setZero();
    scene.bodies.u[3] = 2;
    CHECK(energy(scene) == Approx(2));  // I = m/6 = 1 kg m²
}

TEST_CASE("the inertia of a polyhedron turns with it and does not depend on where the origin is", "[idea]")
{
    Random random(5);
    for (int i = 0; i < 50; ++i) {
        const Vec3 away = random_vector(random, 3), theta = random_vector(random, 2);
        const Mat3 R = rotation_matrix(quaternion_of(theta));
        Hull hull = solid_box({1, 2, 3});
        hull.vertices[7] = hull.vertices[7] * 0.8;  // a corner pushed in: its three faces are triangles now
        hull.faces = {{0, 4, 6, 2}, {0, 1, 5, 4}, {0, 2, 3, 1}, {1, 3, 7}, {1, 7, 5},
                      {2, 6, 7},    {2, 7, 3},    {4, 5, 7},    {4, 7, 6}};
        const SolidMass before = mass_of(hull, 1.5);
        for (Vec3& p : hull.vertices) p = R * p + away;
        const SolidMass after = mass_of(hull, 1.5);
        CHECK(after.mass == Approx(before.mass).epsilon(1e-12));
        CHECK((after.centroid - R * before.centroid - away).norm() < 1e-12);
        // sums of products with 3 + 3 m from the origin: 50 kg m² times rounding
        CHECK((after.inertia - R * before.inertia * R.transpose()).norm() < 1e-11);
    }
}

TEST_CASE("principal axes make the inertia diagonal and a body lies as it was given", "[idea]")
{
    Random random(6);
    for (int i = 0; i < 100; ++i) {
        Mat3 I;
        const Vec3 moments(1, 1.5, 2), theta = random_vector(random, 2);
        const Mat3 R = rotation_matrix(quaternion_of(theta));
        I = R * moments.asDiagonal() * R.transpose();
        const PrincipalAxes principal = principal_axes(I);
        const Mat3 back = principal.axes * principal.moments.asDiagonal() * principal.axes.transpose();
        CHECK((back - I).norm() < 1e-14);
        CHECK((principal.axes.transpose() * principal.axes - Mat3::Identity()).norm() < 1e-14);
        CHECK((cross(principal.axes.col(0), principal.axes.col(1)) - principal.axes.col(2)).norm() < 1e-14);

        SolidScene scene;
        const Vec3 at = random_vector(random, 2), lies = random_vector(random, 1.5);
        Hull box = solid_box({1, 2, 3});
        for (Vec3& p : box.vertices) p = R * p;
        const SolidMass mass = mass_of(box, 1);
        add_body(scene, {box}, mass, at, lies);
        const Mat3 L = rotation_matrix(quaternion_of(lies));
        for (std::size_t v = 0; v < 8; ++v)
            CHECK(
                (point_of_solid(scene.bodies.x, 0, scene.shapes[0][0].vertices[v]) - at - L * box.vertices[v])
                    .norm() < 1e-13);
        CHECK((world_inertia(scene.bodies, 0) - L * mass.inertia * L.transpose()).norm() < 1e-13);
    }
}

TEST_CASE("two quarter turns about different axes are a third of a turn about the diagonal", "[idea]")
{
    const Vec3 theta = add_rotation({pi / 2, 0, 0}, {0, pi / 2, 0});
    CHECK((theta - 2 * pi / 3 / std::sqrt(Real{3}) * Vec3(1, 1, 1)).norm() < 1e-14);
}

TEST_CASE("a box with two equal edges turns over slowly and a cube never", "[idea]")
{
    // 1 % of wobble stays below 2 %; that of the book of three edges grows to all of ω
    const auto wobble = [](const Vec3& edges, const Vec3& spin) {
        const Vec3 inertia = mass_of(solid_box(edges), 1).inertia.diagonal();
        Vec3 theta(0, 0, 0), omega = spin;
        Real most = 0;
        for (int i = 0; i < 5000; ++i) {
            tumble(Tumbling::middle, inertia, 0.01, theta, omega);
            most = std::max(most, (omega - spin).norm());
        }
        return most;
    };
    CHECK(wobble({0.2, 0.2, 0.05}, {0.01, 0.01, 1}) < 0.04);
    CHECK(wobble({0.2, 0.1, 0.1}, {1, 0.01, 0.01}) < 0.04);
    CHECK(wobble({0.16, 0.24, 0.04}, {1, 0.01, 0.01}) > 1);
    CHECK(wobble({0.2, 0.2, 0.2}, {1, 0.01, 0.01}) < 1e-9);  // 5000 roundings
    // about one of the two equal axes: half a turn at ω₃ (I₃ − I₁)/I₁
    const Vec3 inertia = mass_of(solid_box({0.2, 0.2, 0.05}), 1).inertia.diagonal();
    Vec3 theta(0, 0, 0), omega(1, 0.01, 0.01);
    Real t = 0;
    for (; omega.y() > -0.01 && t < 1000; t += 0.01) tumble(Tumbling::middle, inertia, 0.01, theta, omega);
    CHECK(omega.x() < -0.99);
    CHECK(t == Approx(pi * inertia[0] / ((inertia[2] - inertia[0]) * 0.01)).epsilon(1e-3));
    CHECK(t / (2 * pi) == Approx(57).margin(0.5));  // digits of the text
}

TEST_CASE("the energy that an angular momentum allows is what exercise 20.1 says", "[house]")
{
    const Vec3 I = mass_of(solid_box({0.16, 0.24, 0.04}), 0.7 / (0.16 * 0.24 * 0.04)).inertia.diagonal();
    const Vec3 spin(12, 1.2, 1.2);
    const Real most = I.cwiseProduct(spin).squaredNorm() / (2 * I.minCoeff()), start = spin_energy(I, spin);
    CHECK(most == Approx(0.553).margin(0.0005));  // digits of the text
    CHECK(most / start == Approx(2.18).margin(0.005));
    // and the scheme that keeps the momentum alone ends there
    Vec3 theta(0, 0, 0), omega = spin;
    for (int i = 0; i < 60 * 120; ++i) tumble(Tumbling::momentum_kept, I, 1.0 / 60, theta, omega);
    CHECK(spin_energy(I, omega) / start == Approx(most / start).margin(0.02));
}

TEST_CASE("a plate wobbles in the room twice as fast as it spins as exercise 20.3 says", "[house]")
{
    const Vec3 inertia(1, 1, 2);  // thin and round
    const Real spin = 10, h = 1e-4;
    Vec3 theta(0, 0, 0), omega(0.01, 0, spin);
    const Vec3 L = inertia.cwiseProduct(omega), axis = L.normalized();
    const Vec3 across = cross(axis, Vec3(1, 0, 0)).normalized(), along = cross(across, axis);
    const auto azimuth = [&] {
        const Vec3 top = rotation_matrix(quaternion_of(theta)).col(2);
        return std::atan2(top.dot(across), top.dot(along));
    };
    Real in_plate = 0, in_room = 0;
    for (int i = 0; i < 10000; ++i) {
        const Real before = std::atan2(omega.y(), omega.x()), there = azimuth();
        tumble(Tumbling::middle, inertia, h, theta, omega);
        in_plate += std::remainder(std::atan2(omega.y(), omega.x()) - before, 2 * pi);
        in_room += std::remainder(azimuth() - there, 2 * pi);
    }
    // in one second; (Ω h)² of the step and the square of the wobble, 1e-6, are left
    CHECK(in_plate == Approx(spin).epsilon(1e-5));
    CHECK(in_room == Approx(2 * spin).epsilon(1e-5));
}

TEST_CASE("the step moves a free body as the middle does to the bit", "[house]")
{
    SolidScene scene = tossed_book(12, 0.01);
    const Vec3 inertia = scene.bodies.inverse_mass.segment<3>(3).cwiseInverse();
    Vec3 theta = scene.bodies.x.segment<3>(3), omega = scene.bodies.u.segment<3>(3);
    FreeFlight method;
    StepData<6> now;
    for (int i = 0; i < 500; ++i) step(scene, {.h = 1.0 / 240}, method, now);
    for (int n = 0; n < 500; ++n) tumble(Tumbling::middle, inertia, 1.0 / 240, theta, omega);
    CHECK(scene.bodies.x.segment<3>(3) == theta);
    CHECK(scene.bodies.u.segment<3>(3) == omega);
}
