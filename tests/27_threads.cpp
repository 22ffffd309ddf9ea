// Chapter 27: threads that do not stretch, their closed forms, their energy, and both ways to solve their rows.
#include "common/random.hpp"
#include "tests/cloths.hpp"
#include "tests/order.hpp"

#include <Eigen/Eigenvalues>

using namespace rigid;

namespace {

/// One step of exact rows, and what is kept of it.
void exact_step(ClothScene& cloth, ClothMemory& memory, Real h)
{
    ClothSettings how;
    how.h = h, how.method = ClothMethod::exact;
    step(cloth, how, memory);
    CHECK(memory.solved);
}

/// What a step of exact rows takes of the energy, by (27.31) [J].
Real loss(const ClothScene& before, const ClothScene& after, const VecX& lambda, Real h)
{
    Real sum = 0;
    for (Index i = 0; i < after.bodies.u.size(); ++i)
        if (const Real w = after.bodies.inverse_mass[i]; w > 0) {
            const Real du = after.bodies.u[i] - before.bodies.u[i];
            sum += du * du / (2 * w);
        }
    for (std::size_t i = 0; i < after.springs.size(); ++i) {
        const ClothSpring& s = after.springs[i];
        const Vec3 d = before.bodies.position(s.b) - before.bodies.position(s.a),
                   now = after.bodies.position(s.b) - after.bodies.position(s.a);
        const Real tension = -lambda[static_cast<Index>(i)] / (h * h);
        sum += tension * (s.length - now.normalized().dot(d));
    }
    return sum;
}

}  // namespace

TEST_CASE("a chain of threads that do not stretch swings with the zeros of Laguerre's polynomial", "[idea]")
{
    // of L3, and of L2 2 -+ sqrt 2; masses of 1 kg under each other, links of 1 m
    const std::vector<std::vector<Real>> zeros{{1},
                                               {2 - std::sqrt(Real{2}), 2 + std::sqrt(Real{2})},
                                               {0.415774556783479, 2.294280360279042, 6.289945082937479}};
    for (const auto& roots : zeros) {
        const auto n = static_cast<Index>(roots.size());
        MatX K = MatX::Zero(n, n);  // across: each link pulls back with its tension over its length
        for (Index i = 0; i < n; ++i) {
            const Real tension = 10.0 * static_cast<Real>(n - i);
            K(i, i) += tension;
            if (i > 0) K(i - 1, i - 1) += tension, K(i, i - 1) -= tension, K(i - 1, i) -= tension;
        }
        const Eigen::SelfAdjointEigenSolver<MatX> modes(K);
        for (Index k = 0; k < n; ++k) {
            const Real square = 10 * roots[static_cast<std::size_t>(k)], h = 0.02, size = 1e-3;
            CHECK(modes.eigenvalues()[k] == Approx(square).epsilon(1e-12));
            // a small swing of that shape by exact rows, under implicit Euler: (1 + h² ω²) x₊ = 2 x − x₋
            ClothScene cloth = hung_masses(static_cast<int>(n), infinity);
            Vec3 above(0, 0, 0);
            for (Index i = 0; i < n; ++i) {
                const Real x = size * modes.eigenvectors()(i, k), across = x - above.x();
                above += Vec3(across, -std::sqrt(1 - across * across), 0);
                cloth.bodies.position(i + 1) = above;
            }
            ClothMemory memory;
            VecX older = cloth.bodies.x, old = older;
            for (int m = 0; m < 20; ++m) {
                exact_step(cloth, memory, h);
                const auto& x = cloth.bodies.x;
                for (Index i = 1; i <= n; ++i) {
                    // at rest before the first step; links come up by the square of the swing, 1e-6 of their pull
                    const Real left = (1 + h * h * square) * x[3 * i] - 2 * old[3 * i] + older[3 * i];
                    CHECK(std::abs(left) < 1e-5 * size);
                }
                older = old, old = x;
            }
        }
    }
}

TEST_CASE("threads that do not stretch hang in their discrete catenary to rounding", "[idea]")
{
    // slopes are k (i - (n+1)/2), and the links span what is between the pins: one equation for k
    const int n = 20;
    const Real l = 1.5 / n, span = 1.2, mass = 1.0 / n, g = 9.81;
    const auto reach = [&](Real k) {
        Real sum = 0;
        for (int i = 1; i <= n; ++i) {
            const Real s = k * (i - (n + 1) / 2.0);
            sum += l / std::sqrt(1 + s * s);
        }
        return sum;
    };
    Real low = 0, high = 10;
    for (int i = 0; i < 100; ++i) {
        const Real middle = (low + high) / 2;
        (reach(middle) > span ? low : high) = middle;
    }
    ClothScene cloth;
    RopeSpec rope;
    rope.segments = n, rope.stiffness = infinity;
    add_rope(cloth, {-0.75, 0, 0}, {0.75, 0, 0}, rope);
    // from an arc of a circle, whose chords keep their length
    Real narrow = 1e-3, wide = pi / n;
    for (int i = 0; i < 100; ++i) {
        const Real turn = (narrow + wide) / 2, radius = l / (2 * rigid::sin(turn / 2));
        (2 * radius * rigid::sin(n * turn / 2) > span ? narrow : wide) = turn;
    }
    const Real radius = l / (2 * rigid::sin(narrow / 2));
    for (int i = 0; i <= n; ++i) {
        const Real angle = narrow * (i - n / 2.0);
        cloth.bodies.position(i) << radius * rigid::sin(angle),
            radius * (rigid::cos(narrow * n / 2) - rigid::cos(angle)), 0;
    }
    pin(cloth, 0), pin(cloth, n);
    ClothMemory memory;
    for (int m = 0; m < 400; ++m) exact_step(cloth, memory, 0.05);
    // implicit Euler has taken its swing by then
    CHECK(cloth.bodies.u.cwiseAbs().maxCoeff() < 1e-9);
    Real down = 0;
    for (int i = 1; i <= n; ++i) {
        const Real slope = low * (i - (n + 1) / 2.0), pull = mass * g / low;
        down += l * slope / std::sqrt(1 + slope * slope);
        const Vec3 e = cloth.bodies.position(i) - cloth.bodies.position(i - 1);
        CHECK(e.norm() == Approx(l).margin(1e-10));  // ten times what the rows are solved to
        CHECK(e.y() / e.x() == Approx(slope).margin(1e-8));
        CHECK(cloth.bodies.position(i).y() == Approx(down).margin(1e-9));
        // its pull is the impulse of its row
        CHECK(-memory.exact.lambda[i - 1] / (0.05 * 0.05) ==
              Approx(pull * std::sqrt(1 + slope * slope)).epsilon(1e-7));
    }
}

TEST_CASE("exact rows of threads take the energy that (27.31) says and give none", "[idea]")
{
    for (const bool net : {false, true}) {
        ClothScene cloth = net ? hung_net(5) : hung_masses(6, infinity);
        if (!net)
            for (int k = 1; k <= 6; ++k) cloth.bodies.u[3 * k] = k, cloth.bodies.u[3 * k + 2] = 0.1 * k * k;
        const Real h = 0.01;
        ClothMemory memory;
        Real lost = 0, start = energy(cloth);
        for (int n = 0; n < 100; ++n) {
            const ClothScene before = cloth;
            exact_step(cloth, memory, h);
            const Real by_formula = loss(before, cloth, memory.exact.lambda, h);
            // rows to 1e-11 m under pulls of up to 100 N, and rounding of the height
            CHECK(energy(before) - energy(cloth) == Approx(by_formula).margin(1e-8));
            if (!net) CHECK(by_formula > -1e-8);  // all its threads pull
            lost += by_formula;
        }
        CAPTURE(net, lost, start);
        CHECK(lost > 0.01);
        CHECK(largest_stretch(cloth) < 1e-9);
    }
}

TEST_CASE("a thread under tension that is solved at once trembles across itself beyond (27.30)", "[idea]")
{
    // nine masses between pins, springs drawn out by a tenth: T = k/10
    const int n = 9;
    const Real k = 50, d = 1.1, T = k / 10;
    const auto shaken = [&](Real h, int steps, Real& worst) {
        ClothScene cloth;
        cloth.gravity.setZero();
        const Real s = rigid::sin(n * pi / (2 * (n + 1))), kappa = 4 * h * h * T / d * s * s;
        for (int i = 0; i <= n + 1; ++i) {
            add_particle(cloth, {d * i, 0, 1e-5 * rigid::sin(n * pi * i / (n + 1))},
                         i == 0 || i == n + 1 ? 0 : 1);
            if (i > 0) cloth.springs.push_back({i - 1, i, 1, k});
        }
        ClothMemory memory;
        VecX older = cloth.bodies.x, old = older;
        worst = 0;
        for (int m = 0; m < steps; ++m) {
            ClothSettings how;
            how.h = h, how.method = ClothMethod::threads, how.sweeps = 1;
            step(cloth, how, memory);
            for (int i = 1; i <= n; ++i) {
                const auto at = static_cast<Index>(3 * i + 2);
                // C is longer by the square of the slope, 1e-10 of a tenth
                worst =
                    std::max(worst, std::abs(cloth.bodies.x[at] - (1 - kappa) * (2 * old[at] - older[at])));
            }
            older = old, old = cloth.bodies.x;
        }
        Real size = 0;
        for (int i = 1; i <= n; ++i) size = std::max(size, std::abs(cloth.bodies.x[3 * i + 2]));
        return size;
    };
    const Real s = rigid::sin(n * pi / (2 * (n + 1))), limit = std::sqrt(d / (3 * T)) / s;
    Real worst = 0;
    shaken(0.5 * limit, 20, worst);
    CHECK(worst < 1e-5 * 1e-7);
    CHECK(shaken(0.97 * limit, 200, worst) < 1e-6);
    CHECK(shaken(1.03 * limit, 200, worst) > 1e-3);
}

TEST_CASE("a square of threads with both diagonals keeps its shape though one row says what the others do",
          "[idea]")
{
    ClothScene cloth;
    const Vec3 corners[]{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    for (const Vec3& p : corners) add_particle(cloth, p, 1);
    const auto thread = [&](int a, int b) {
        cloth.springs.push_back({a, b, (corners[b] - corners[a]).norm(), infinity});
    };
    thread(0, 1), thread(1, 2), thread(2, 3), thread(3, 0), thread(0, 2), thread(1, 3);
    for (int k = 0; k < 4; ++k) {  // it flies and spins in its plane
        const Vec3 r = cloth.bodies.position(k) - Vec3(0.5, 0.5, 0);
        cloth.bodies.velocity(k) = Vec3(1 - 3 * r.y(), 3 * r.x(), 0);
    }
    const Vec3 before = momentum(cloth);
    ClothMemory memory;
    for (int n = 0; n < 100; ++n) {
        exact_step(cloth, memory, 0.01);
        CHECK(largest_stretch(cloth) < 1e-9);
    }
    CHECK((momentum(cloth) - before - Vec3(0, -4 * 9.81, 0)).norm() < 1e-9);
}

TEST_CASE("exact rows hold a net whose threads pull by many times what a step of its particles bears",
          "[idea]")
{
    // at its corners 1 N over 0.09 g at 1/24 m is h² T/(m L) = 80 in steps of 1/60 s
    ClothScene cloth = hung_net(24);
    ClothMemory memory;
    for (int n = 0; n < 30; ++n) {
        exact_step(cloth, memory, 1.0 / 60);
        CHECK(largest_stretch(cloth) < 1e-9);
        CHECK(memory.exact.steps < 25);
    }
    const Real most = -memory.exact.lambda.minCoeff() * 3600,
               least_mass = 1 / cloth.bodies.inverse_mass.maxCoeff();
    CHECK(most * 24 / (3600 * least_mass) > 20);
}

TEST_CASE("the factor of a rope costs as much for each of its threads however long it is", "[house]")
{
    Index before = 0;
    for (const int n : {100, 200}) {
        ClothScene rope = hung_masses(n, infinity);
        ClothMemory memory;
        exact_step(rope, memory, 0.01);
        if (n == 200) CHECK(static_cast<Real>(memory.exact.entries()) < 2.1 * static_cast<Real>(before));
        before = memory.exact.entries();
    }
}

TEST_CASE("exact rows that no places can meet say so and stay finite", "[idea]")
{
    // straight between pins that are as far apart as it is long: it cannot give way to its weight
    ClothScene cloth;
    RopeSpec rope;
    rope.segments = 4, rope.stiffness = infinity;
    add_rope(cloth, {0, 0, 0}, {1, 0, 0}, rope);
    pin(cloth, 0), pin(cloth, 4);
    ClothMemory memory;
    ClothSettings how;
    how.method = ClothMethod::exact;
    step(cloth, how, memory);
    CHECK_FALSE(memory.solved);
    CHECK(cloth.bodies.x.allFinite());
}

TEST_CASE("rows and numbers that change while a cloth moves are looked at", "[house]")
{
    const auto says = [](const std::function<void(ClothScene&)>& spoil, const std::string& sentence) {
        ClothScene cloth = hung_sheet(3, 100);
        ClothMemory memory;
        step(cloth, {}, memory);
        spoil(cloth);
        CHECK(refusal([&] { step(cloth, {}, memory); }) == sentence);
    };
    says([](ClothScene& c) { c.springs[1].stiffness = -5, ++c.changes; },
         "the stiffness of spring 1 is -5 N/m; it must be positive");
    says([](ClothScene& c) { c.bodies.u[4] = std::nan(""); }, "u[4] is nan; it must be a finite number");
    says([](ClothScene& c) { c.bodies.inverse_mass.segment<3>(15).setConstant(infinity), ++c.changes; },
         "particle 5 has no mass; it must have a positive one, or 1/m = 0, which pins it");
}
