// Chapter 27: the methods beside each other, limits, tearing, what is refused.
#include "tests/no_allocation.hpp"

#include "common/random.hpp"
#include "tests/cloths.hpp"
#include "tests/order.hpp"

using namespace rigid;

namespace {

/// A chain that was pulled aside, and swings: four masses on springs of about ω = 17.
ClothScene swinging_chain()
{
    ClothScene cloth = hung_masses(4, 300);
    for (int k = 1; k <= 4; ++k) cloth.bodies.position(k) += Vec3(0.3 * k, 0.1 * k, 0.05 * k * k);
    return cloth;
}

/// Where it is after 0.4 s.
VecX after(ClothMethod method, int steps, int sweeps = 200)
{
    ClothScene cloth = swinging_chain();
    ClothMemory memory;
    memory.newton.tolerance = 1e-13;
    ClothSettings how;
    how.h = 0.4 / steps, how.method = method, how.sweeps = sweeps;
    for (int n = 0; n < steps; ++n) step(cloth, how, memory);
    return cloth.bodies.x;
}

/// A crumpled sheet in the air that moves at random.
ClothScene random_sheet(std::uint64_t seed, int squares = 5)
{
    Random random(seed);
    ClothScene cloth = hung_sheet(squares, 200, 1e-3);
    for (Index i = 0; i < cloth.bodies.x.size(); ++i) {
        if (!(cloth.bodies.inverse_mass[i] > 0)) continue;
        cloth.bodies.x[i] += 0.02 * random.uniform(-1, 1);
        cloth.bodies.u[i] = random.uniform(-1, 1);
    }
    return cloth;
}

}  // namespace

TEST_CASE("implicit and explicit Euler are of first order and the midpoint of second", "[idea]")
{
    const VecX exact = after(ClothMethod::midpoint, 12800);
    const auto order = [&](ClothMethod method, int first) {
        std::vector<Real> errors;
        for (int n = first; n <= 8 * first; n *= 2) errors.push_back((after(method, n) - exact).norm());
        return order_of(errors);
    };
    CHECK(order(ClothMethod::newton, 400) == Approx(1).margin(0.15));
    CHECK(order(ClothMethod::explicit_euler, 200) == Approx(1).margin(0.15));
    CHECK(order(ClothMethod::xpbd, 400) == Approx(1).margin(0.15));
    CHECK(order(ClothMethod::midpoint, 100) == Approx(2).margin(0.15));
}

TEST_CASE("all that solve the implicit step to its end have one answer", "[idea]")
{
    using M = ClothMethod;
    const VecX newton = after(M::newton, 20);
    for (const M method : {M::exact, M::particles, M::augmented, M::projective}) {
        CAPTURE(to_string(method));
        // Newton's 1e-13 and the rows' 1e-11 m a step, over 20 steps
        CHECK((after(method, 20, 3000) - newton).cwiseAbs().maxCoeff() < 1e-8);
    }
    // XPBD and threads forget how J turns within a step: they agree with each other, and differ from the implicit step by
    // its square
    const VecX rows = after(M::xpbd, 20, 3000), threads = after(M::threads, 20, 3000);
    const Real off = (rows - newton).cwiseAbs().maxCoeff();
    CHECK(off > 1e-6);
    const Real finer = (after(M::xpbd, 80, 1000) - after(M::newton, 80)).cwiseAbs().maxCoeff();
    CHECK(finer < 0.3 * off);
}

TEST_CASE("a thread is solved in one sweep where rows need the square of its number", "[idea]")
{
    const int n = 40;
    const Real h = 1.0 / 60;
    const auto left = [h](ClothMethod method, int sweeps) {
        ClothScene cloth = hung_masses(n, infinity);
        const VecX held = cloth.bodies.x;  // hard rows hold all where they are
        one_step(cloth, method, h, sweeps);
        return (cloth.bodies.x - held).cwiseAbs().maxCoeff() / (10 * h * h);
    };
    CHECK(left(ClothMethod::threads, 1) < 1e-10);  // straight rows are linear: rounding of 40 m against 3 mm
    CHECK(left(ClothMethod::xpbd, 40) > 0.5);
    const Real more = left(ClothMethod::xpbd, 2000), most = left(ClothMethod::xpbd, 3000);
    const Real c = rigid::cos(pi / (2 * n));  // (27.11a), by then the slowest error alone is left
    CHECK(std::log(most / more) / 1000 == Approx(std::log(c * c)).epsilon(1e-3));
}

TEST_CASE("particles hold threads that do not stretch by impulses that grow with the sweeps", "[idea]")
{
    // four masses on hard threads that swing; rows that do the same say where to
    const auto swung = [](ClothMethod method, int sweeps) {
        ClothScene cloth = hung_masses(4, infinity);
        for (int k = 1; k <= 4; ++k) cloth.bodies.u[3 * k] = k;
        ClothMemory memory;
        ClothSettings how;
        how.h = 0.01, how.method = method, how.sweeps = sweeps;
        for (int n = 0; n < 40; ++n) step(cloth, how, memory);
        return cloth;
    };
    const VecX exact = swung(ClothMethod::exact, 1).bodies.x;
    const ClothScene few = swung(ClothMethod::augmented, 10), many = swung(ClothMethod::augmented, 200);
    CAPTURE(largest_stretch(few), largest_stretch(many), (few.bodies.x - exact).norm(),
            (many.bodies.x - exact).norm());
    CHECK(largest_stretch(few) < 1e-3);
    CHECK(largest_stretch(many) < 1e-9);
    CHECK((many.bodies.x - exact).cwiseAbs().maxCoeff() < 1e-7);
    // an infinite k has no place in the plain method
    CHECK(refusal([&] { swung(ClothMethod::particles, 1); }) != "nothing was refused");
}

TEST_CASE("passes with one matrix never raise the merit of the step", "[idea]")
{
    for (std::uint64_t seed = 1; seed <= 10; ++seed) {
        const ClothScene cloth = random_sheet(seed);
        const Real h = 0.05;
        VecX y = cloth.bodies.x + h * cloth.bodies.u, x = y;
        const auto merit = [&] {
            Real sum = 0;
            for (Index i = 0; i < x.size(); ++i)
                if (const Real w = cloth.bodies.inverse_mass[i]; w > 0)
                    sum += (x[i] - y[i]) * (x[i] - y[i]) / w;
            return sum / (2 * h * h) + row_energy(cloth, x);
        };
        Projective passes;
        passes.prepare(cloth, h);
        Real last = merit(), first = 0;
        for (int n = 0; n < 50; ++n) {
            passes.pass(cloth, y, h, x);
            const Real now = merit();
            CHECK(now <= last * (1 + 1e-13));
            last = now;
            if (n == 0) first = passes.residual;
        }
        CHECK(passes.residual < 0.5 * first);  // slow, but on its way
    }
}

TEST_CASE("forgotten impulses are position-based dynamics of a share", "[idea]")
{
    // with one γ and one A for all rows, s = A/(A + γ) (27.10)
    const Real h = 0.02, k = 500;
    for (const int sweeps : {1, 7}) {
        ClothScene a = swinging_chain(), b = a;
        pin(a, 2), pin(a, 4), pin(b, 2), pin(b, 4);  // each row has one mass: A = 1
        for (ClothScene* const cloth : {&a, &b})
            for (ClothSpring& s : cloth->springs) s.stiffness = k;
        ClothMemory forgets, positions;
        ClothSettings how;
        how.h = h, how.sweeps = sweeps, how.keep_lambda = false;
        step(a, how, forgets);
        how.method = ClothMethod::pbd, how.pbd_share = 1 / (1 + 1 / (h * h * k));
        step(b, how, positions);
        CHECK((a.bodies.x - b.bodies.x).cwiseAbs().maxCoeff() < 1e-13);
    }
}

TEST_CASE("the angle of a hinge has the derivatives of its differences", "[idea]")
{
    Random random(3);
    for (int n = 0; n < 200; ++n) {
        VecX x(12);
        x << 0, 0, 0, 1, 0, 0, 0.4, 0.8, 0, 0.6, -0.9, 0;
        for (Index i = 0; i < 12; ++i) x[i] += 0.3 * random.uniform(-1, 1);
        ClothHinge hinge;
        std::array<Vec3, 4> J;
        hinge_angle(hinge, x, J);
        for (Index i = 0; i < 12; ++i) {
            VecX up = x, down = x;
            up[i] += 1e-5, down[i] -= 1e-5;
            const Real slope = (hinge_angle(hinge, up) - hinge_angle(hinge, down)) / 2e-5;
            CHECK(J[static_cast<std::size_t>(i / 3)][i % 3] ==
                  Approx(slope).margin(1e-7));  // h² of a third derivative
        }
    }
}

TEST_CASE("a fold of two triangles has a jump of slope of twice the sine of half its angle", "[idea]")
{
    for (const Real angle : {0.0, 0.3, -1.2, 2.0}) {
        VecX x(12);
        x << 0, 0, 0, 1, 0, 0, 0.3, 0.7, 0, 0.8, -0.6, 0;
        const ClothHinge hinge;
        const ClothBend bend = bend_of(hinge, x);
        const Real height = x[10];
        x[10] = height * rigid::cos(angle), x[11] = height * rigid::sin(angle);  // folded about x
        CHECK(std::abs(hinge_angle(hinge, x)) == Approx(std::abs(angle)).margin(1e-14));
        CHECK(bend.value(x).norm() == Approx(2 * std::abs(rigid::sin(angle / 2))).margin(1e-14));
    }
}

TEST_CASE("a triangle falls in still air as the square of its speed brakes it", "[idea]")
{
    ClothScene cloth;
    for (const Vec3& p : {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 0, 1)}) add_particle(cloth, p, 0.1);
    cloth.triangles = {{0, 1, 2}};
    cloth.air = 0.6;
    ClothMemory memory;
    ClothSettings how;
    how.h = 0.01;
    Real v = 0;
    for (int n = 0; n < 300; ++n) {
        step(cloth, how, memory);
        v += how.h * (9.81 - 0.6 * 0.5 * v * v / 0.3);
        CHECK(-cloth.bodies.u[1] == Approx(v).epsilon(1e-12));
    }
    CHECK(v == Approx(std::sqrt(9.81 * 0.3 / (0.6 * 0.5))).epsilon(1e-6));  // m g = ½ c ρ A v²
}

TEST_CASE("a drag brakes what moves and moves no place of rest", "[idea]")
{
    ClothScene falling;
    add_particle(falling, {0, 0, 0}, 1);
    falling.drag = 5;
    for (int n = 0; n < 500; ++n) one_step(falling, ClothMethod::xpbd, 0.01);
    // u = u/(1 + h d) + h g has its fixed point at g (1 + h d)/d
    CHECK(falling.bodies.u[1] == Approx(-9.81 * 1.05 / 5).epsilon(1e-9));
    ClothScene hung = hung_masses(1, 100);
    hung.drag = 5;
    for (int n = 0; n < 200; ++n) one_step(hung, ClothMethod::newton, 0.1);
    CHECK(hung.bodies.x[4] ==
          Approx(-1.1).margin(1e-9));  // m g/k = 0.1 m, to ten times what Newton's method leaves
}

TEST_CASE("a drag takes the same part of a velocity by every method", "[idea]")
{
    for (int m = 0; m <= static_cast<int>(ClothMethod::exact); ++m) {
        const auto method = static_cast<ClothMethod>(m);
        ClothScene flies;
        flies.gravity.setZero();
        add_particle(flies, {0, 0, 0}, 1);
        flies.bodies.u[0] = 1, flies.drag = 2;
        ClothMemory memory;
        ClothSettings how;
        how.h = 0.001, how.method = method;
        for (int n = 0; n < 500; ++n) step(flies, how, memory);
        CAPTURE(to_string(method));
        // 1/(1 + h d) a step is e^{-d t} to d² t h/2 = 0.001; the middle of the step, to its square
        CHECK(flies.bodies.u[0] ==
              Approx(rigid::exp(-1)).epsilon(method == ClothMethod::midpoint ? 1e-6 : 1.1e-3));
    }
}

TEST_CASE("threads that forget their impulses get stiffer with their sweeps as rows do", "[idea]")
{
    const auto down = [](int sweeps, bool keep) {
        ClothScene cloth = hung_masses(2, 100);
        ClothMemory memory;
        ClothSettings how;
        how.h = 0.1, how.method = ClothMethod::threads, how.sweeps = sweeps, how.keep_lambda = keep;
        step(cloth, how, memory);
        return -cloth.bodies.x[7] - 2;
    };
    CHECK(down(20, true) == Approx(0.08).margin(1e-14));
    CHECK(down(20, false) < 0.001);
}

TEST_CASE("a copy of exact rows solves its own system", "[house]")
{
    const ClothScene cloth = hung_masses(4, infinity);
    const Real h = 0.01;
    VecX y = cloth.bodies.x;
    for (int k = 1; k <= 4; ++k) y[3 * k] += 0.01 * k;
    ExactRows one;
    one.prepare(cloth);
    ExactRows copy = one;
    one.prepare(hung_masses(1, infinity));  // what it has is another system now
    VecX x = y;
    copy.solve(cloth, y, h, x);
    CHECK(copy.solved);
    ExactRows fresh;
    fresh.prepare(cloth);
    VecX same = y;
    fresh.solve(cloth, y, h, same);
    CHECK(x == same);
}

TEST_CASE("a cloth that was pressed to a line goes on with another step", "[house]")
{
    ClothScene cloth = hung_sheet(2, 100, 0);
    ClothMemory memory;
    ClothSettings how;
    step(cloth, how, memory);
    cloth.bodies.position(4) = Vec3(cloth.bodies.position(0));  // of the first triangles
    how.substeps = 2;
    CHECK(refusal([&] { step(cloth, how, memory); }) == "nothing was refused");
}

TEST_CASE("threads beyond their limit are drawn back to it and keep their momentum", "[idea]")
{
    ClothScene cloth = random_sheet(5);
    cloth.bodies.inverse_mass.setConstant(1);  // pins would hold it stretched
    cloth.bodies.x *= 1.2;
    StrainLimit limit;
    limit.strain = 0.05;
    int passes = 0;
    for (; passes < 2000 && limit.find(cloth, cloth.bodies.x); ++passes)
        limit.draw_back(cloth, cloth.bodies.x);
    CHECK(passes < 2000);
    CHECK(largest_stretch(cloth) <= 0.05 + 1e-12);  // its square is compared: rounding of that
    ClothScene free = random_sheet(5);
    free.bodies.inverse_mass.setConstant(2);
    free.bodies.x *= 1.2;
    Vec3 sum(0, 0, 0);
    const VecX old = free.bodies.x;
    CHECK(limit.find(free, free.bodies.x));
    CHECK(limit.beyond.size() > 20);
    limit.draw_back(free, free.bodies.x);
    for (Index k = 0; k < free.bodies.count(); ++k) sum += free.bodies.position(k) - old.segment<3>(3 * k);
    CHECK(sum.norm() < 1e-14);
}

TEST_CASE("what a limit draws back is a velocity of the whole step", "[idea]")
{
    for (const ClothMethod method : {ClothMethod::threads, ClothMethod::midpoint}) {
        ClothScene cloth;
        cloth.gravity.setZero();
        add_particle(cloth, {0, 0, 0}, 1);
        add_particle(cloth, {1.2, 0, 0}, 1);
        cloth.springs.push_back({0, 1, 1, 1e-6});
        ClothMemory memory;
        ClothSettings how;
        how.h = 0.1, how.substeps = 4, how.method = method, how.sweeps = 1;
        how.strain_limit = 0.1;
        step(cloth, how, memory);
        CAPTURE(to_string(method));
        // from 1.2 to nine tenths of the strain, half by each; the spring's own pull is 1e-8 m/s
        CHECK(cloth.bodies.x[3] - cloth.bodies.x[0] == Approx(1.09).epsilon(1e-6));
        CHECK(cloth.bodies.u[3] == Approx(-0.055 / 0.1).epsilon(1e-6));
        CHECK(cloth.bodies.u[0] == Approx(0.055 / 0.1).epsilon(1e-6));
    }
}

TEST_CASE("what tears takes its triangles and bends along and falls apart", "[idea]")
{
    ClothScene cloth = torn_sheet(12, 1000, 0.5);
    const std::size_t springs = cloth.springs.size(), triangles = cloth.triangles.size(),
                      bends = cloth.bends.size();
    ClothMemory memory;
    ClothSettings how;
    how.method = ClothMethod::threads, how.substeps = 4, how.sweeps = 2, how.strength = 0.15;
    for (int n = 0; n < 120; ++n) step(cloth, how, memory);
    CHECK(memory.torn > 11);  // each of 13 threads, once
    CHECK(cloth.springs.size() + static_cast<std::size_t>(memory.torn) == springs);
    CHECK(cloth.triangles.size() < triangles);
    CHECK(cloth.bends.size() < bends);
    CHECK(largest_stretch(cloth) <= 0.15);
    for (const auto& t : cloth.triangles)  // none has lost an edge
        for (int i = 0; i < 3; ++i) {
            const int a = t[static_cast<std::size_t>(i)], b = t[static_cast<std::size_t>((i + 1) % 3)];
            CHECK(std::any_of(cloth.springs.begin(), cloth.springs.end(), [&](const ClothSpring& s) {
                return (s.a == a && s.b == b) || (s.a == b && s.b == a);
            }));
        }
}

TEST_CASE("a cloth that is turned moves as one that is not", "[idea]")
{
    for (const ClothMethod method :
         {ClothMethod::xpbd, ClothMethod::threads, ClothMethod::particles, ClothMethod::projective,
          ClothMethod::newton, ClothMethod::explicit_euler}) {
        ClothScene a = random_sheet(9), b = a;
        const Mat3 R = rotation_matrix(Vec3(0.4, -1.1, 0.7));
        b.gravity = R * b.gravity;
        for (Index k = 0; k < b.bodies.count(); ++k) {
            b.bodies.position(k) = Vec3(R * b.bodies.position(k));
            b.bodies.velocity(k) = Vec3(R * b.bodies.velocity(k));
        }
        ClothMemory of_a, of_b;
        ClothSettings how;
        how.method = method, how.h = 0.002, how.sweeps = 5;  // explicit up to 4 ms
        for (int n = 0; n < 20; ++n) step(a, how, of_a), step(b, how, of_b);
        Real off = 0;
        for (Index k = 0; k < b.bodies.count(); ++k)
            off = std::max(off, (R * a.bodies.position(k) - b.bodies.position(k)).norm());
        CAPTURE(to_string(method));
        CHECK(off < 1e-9);  // rounding, which a crumpled sheet makes larger in each step
    }
}

TEST_CASE("particles of one colour share no row and each is visited once", "[house]")
{
    const ClothScene cloth = random_sheet(2, 9);
    ParticleDescent descent;
    descent.find(cloth);
    CHECK(descent.colours() <= 12);
    std::vector<int> seen(static_cast<std::size_t>(cloth.count()), 0);
    for (const int k : descent.order()) ++seen[static_cast<std::size_t>(k)];
    for (const int times : seen) CHECK(times == 1);
}

TEST_CASE("threads of a sheet are its lines and its diagonals", "[house]")
{
    ClothThreads threads;
    const ClothScene cloth = hung_sheet(8, 100, 0);
    threads.find(cloth);
    // nine lines along each side; diagonals that rise where i − j is even, from −6 to 6, and that fall where i + j is odd,
    // from 1 to 13
    CHECK(threads.count() == 9 + 9 + 7 + 7);
}

TEST_CASE("a steady step of rows threads particles one matrix and conjugate gradients asks for no memory",
          "[house]")
{
    using M = ClothMethod;
    for (const M method : {M::explicit_euler, M::pbd, M::xpbd, M::threads, M::particles, M::augmented,
                           M::projective, M::implicit_euler}) {
        ClothScene cloth = hung_sheet(16, 100);
        cloth.air = 0.1, cloth.triangles.resize(10);
        ClothMemory memory;
        ClothSettings how;
        how.method = method, how.sweeps = 2, how.h = 1.0 / 600;
        for (int n = 0; n < 30; ++n) step(cloth, how, memory);
        int asked = 0;
        {
            const NoAllocation none;
            for (int n = 0; n < 5; ++n) step(cloth, how, memory);
            asked = NoAllocation::violations();
        }
        CAPTURE(to_string(method));
        CHECK(asked == 0);
    }
}

TEST_CASE("a cloth that makes no sense is refused with a sentence", "[house]")
{
    const auto says = [](const std::function<void(ClothScene&, ClothSettings&)>& spoil,
                         const std::string& sentence) {
        ClothScene cloth = hung_sheet(3, 100);
        cloth.hinges.push_back({{0, 1, 4, 5}, 0, 1});
        ClothSettings how;
        spoil(cloth, how);
        const VecX x = cloth.bodies.x;
        ClothMemory memory;
        const std::string said = refusal([&] { step(cloth, how, memory); });
        CHECK(said == sentence);
        if (x.allFinite()) CHECK(cloth.bodies.x == x);  // nothing has moved
    };
    says([](ClothScene& c, ClothSettings&) { c.springs[2].length = 0; },
         "the length of spring 2 is 0 m; it must be positive and finite");
    says([](ClothScene& c, ClothSettings&) { c.springs[1].stiffness = -5; },
         "the stiffness of spring 1 is -5 N/m; it must be positive");
    says([](ClothScene& c, ClothSettings&) { c.springs[0].b = 99; },
         "spring 0 is on particle 99; there are 16");
    says([](ClothScene& c, ClothSettings&) { c.springs[0].b = c.springs[0].a; },
         "spring 0 has particle 0 twice; its particles must differ");
    says([](ClothScene& c, ClothSettings&) { c.bends[0].stiffness = infinity; },
         "the stiffness of bend 0 is inf N m; it must be positive and finite");
    says([](ClothScene& c, ClothSettings&) { c.hinges[0].angle = std::nan(""); },
         "the angle of hinge 0 is nan; it must be finite");
    says(
        [](ClothScene& c, ClothSettings&) {
            c.bodies.x.segment<3>(3 * c.triangles[0][1]) = c.bodies.x.segment<3>(3 * c.triangles[0][0]);
        },
        "triangle 0 has no area");
    says([](ClothScene& c, ClothSettings&) { c.bodies.x[7] = std::nan(""); },
         "x[7] is nan; it must be a finite number");
    says([](ClothScene&, ClothSettings& s) { s.substeps = 0; },
         "the number of sub-steps is 0; it must be one or more");
    says([](ClothScene&, ClothSettings& s) { s.limit_passes = -3; },
         "the number of passes of a limit is -3; it must be zero or more");
    says([](ClothScene&, ClothSettings& s) { s.limit_stiffness = std::nan(""); },
         "the least stiffness that a limit holds is nan N/m; it must be zero or more");
    says([](ClothScene&, ClothSettings& s) { s.h = -1; },
         "the time step h is -1 s; it must be positive and finite");
    says([](ClothScene& c,
            ClothSettings& s) { c.springs[4].stiffness = infinity, s.method = ClothMethod::newton; },
         "spring 4 is inextensible; only pbd, xpbd, threads, augmented and exact take that, this method "
         "needs a "
         "finite stiffness");
    says([](ClothScene&, ClothSettings& s) { s.method = ClothMethod::projective; },
         "there are 1 hinges; projective dynamics takes bends, whose energy is quadratic, and no angles");
    ClothScene cloth;
    CHECK(refusal([&] {
              add_particle(cloth, {0, 0, 0}, -1);
          }) == "the mass of a particle is -1 kg; it must be zero (pinned) or positive and finite");
    CHECK(refusal([&] { cloth_method("magic"); }) == "there is no method \"magic\" for a cloth");
}

TEST_CASE("a step that ends beyond all numbers is not solved", "[house]")
{
    for (const ClothMethod method :
         {ClothMethod::pbd, ClothMethod::xpbd, ClothMethod::threads, ClothMethod::particles,
          ClothMethod::augmented, ClothMethod::projective, ClothMethod::implicit_euler, ClothMethod::newton,
          ClothMethod::midpoint, ClothMethod::exact})
        for (const Real speed : {1e170, 1e307}) {  // the square of a way is infinite
            ClothScene cloth = hung_sheet(3, 100, 1e-3);
            cloth.bodies.velocity(5) = Vec3(0, speed, 0);
            ClothSettings how;
            how.method = method;
            ClothMemory memory;
            step(cloth, how, memory);
            INFO(to_string(method) << " at " << speed << " m/s");
            CHECK(!memory.solved);
        }
}

TEST_CASE("rows take threads that do not stretch at all", "[idea]")
{
    for (const ClothMethod method : {ClothMethod::exact, ClothMethod::threads}) {
        ClothScene cloth;
        RopeSpec rope;
        rope.segments = 20, rope.stiffness = infinity;
        add_rope(cloth, {0, 0, 0}, {1, 0, 0}, rope);
        pin(cloth, 0);
        ClothMemory memory;
        ClothSettings how;
        how.method = method, how.substeps = 4, how.sweeps = 3;
        for (int n = 0; n < 60; ++n) {
            step(cloth, how, memory);
            // exact: its tolerance of 1e-11 of 1/20 m; threads: what three passes leave of a rope that turns
            CHECK(largest_stretch(cloth) < (method == ClothMethod::exact ? 1e-9 : 1e-3));
            if (method == ClothMethod::exact) CHECK(memory.solved);
        }
    }
}
