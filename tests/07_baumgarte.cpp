/// Chapter 7: what a position error does, and the five ways to repay it.

// Memory that is asked for while a NoAllocation lives is counted: operator new below, Eigen's own by its
// check.
#include <cstdlib>
#include <new>
namespace {
bool allocation_forbidden = false;
int forbidden_allocations = 0;
}  // namespace
#define EIGEN_RUNTIME_NO_MALLOC
#define eigen_assert(condition)                                                                              \
    do {                                                                                                     \
        if (!(condition)) {                                                                                  \
            if (!allocation_forbidden) std::abort();                                                         \
            ++forbidden_allocations;                                                                         \
        }                                                                                                    \
    } while (false)

#include "chapters/02_velocity_constraints/curves.hpp"
#include "chapters/03_mlcp_formulation/assembly.hpp"
#include "chapters/07_baumgarte/closed_forms.hpp"
#include "chapters/07_baumgarte/stabilized_step.hpp"
#include "common/measure.hpp"
#include "common/program/scripted_pointer.hpp"
#include "common/random.hpp"

#include "tests/catch.hpp"

#include <functional>
#include <numeric>

// AddressSanitizer has its own operator new; there only Eigen's allocations are counted.
#if defined(__SANITIZE_ADDRESS__)
#define RIGID_ADDRESS_SANITIZER
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
#define RIGID_ADDRESS_SANITIZER
#endif
#endif
#ifndef RIGID_ADDRESS_SANITIZER
// Not inlined: else the compiler sees malloc() and delete meet and warns.
[[gnu::noinline]] void* operator new(std::size_t size)
{
    if (allocation_forbidden) ++forbidden_allocations;
    if (void* memory = std::malloc(size > 0 ? size : 1)) return memory;
    throw std::bad_alloc();
}
[[gnu::noinline]] void operator delete(void* memory) noexcept { std::free(memory); }
[[gnu::noinline]] void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
#endif

using namespace rigid;

namespace {

/// While it lives, every allocation of this thread is counted.
struct NoAllocation {
    NoAllocation()
    {
        forbidden_allocations = 0;
        allocation_forbidden = true;
        Eigen::internal::set_is_malloc_allowed(false);
    }
    ~NoAllocation()
    {
        Eigen::internal::set_is_malloc_allowed(true);
        allocation_forbidden = false;
    }
    static int violations() { return forbidden_allocations; }
};

constexpr std::array all_ways = {Stabilizer::none, Stabilizer::baumgarte, Stabilizer::relaxation,
                                 Stabilizer::split_impulse, Stabilizer::projection};

/// One body and one bilateral row, as a step takes them: the constraint is evaluated anew in each step.
struct OneRow {
    std::function<Constraint<2>(const VecX&)> constraint;
    StabilizerSettings settings;
    Real h = 0.01;
    Bodies<2> bodies{1};
    VecX v;

    void advance()
    {
        const std::array<Constraint<2>, 1> constraints = {constraint(bodies.x)};
        const std::span<const Constraint<2>> all(constraints);
        std::vector<Row<2>> rows;
        stabilized_rows(all, 1, bodies.inverse_mass, settings, h, rows);
        ImpulseMemory<2> memory;
        Solution solution;
        ImpulseSettings one_sweep;
        one_sweep.max_sweeps = 1;
        sequential_impulse(rows, {}, one_sweep, memory, bodies.u, solution);
        bodies.x += h * bodies.u;
        if (settings.method == Stabilizer::relaxation) {
            relax(all, {}, 1, settings, h, memory);
            bodies.u = memory.u.head<2>();
        }
        if (settings.method == Stabilizer::split_impulse) {
            split_impulse(all, {}, 1, settings, h, memory, v);
            bodies.x += h * v.head<2>();
        }
        if (settings.method == Stabilizer::projection)
            project_positions<2>([this](std::size_t, const VecX& x) { return constraint(x); }, 1, {}, 1,
                                 bodies.inverse_mass, settings, h, bodies.x);
    }
};

OneRow bead()
{
    OneRow run{[](const VecX& x) { return circle_constraint(x, 0, 1); }, {}};
    run.bodies.x << 1, 0;
    run.bodies.u << 0, 1;
    return run;
}

/// A body 0.1 m beside a straight rail along x: C is linear in x.
OneRow beside_a_rail()
{
    OneRow run{[](const VecX& x) { return alignment_constraint<2>(x, world, 0, Vec2(0, 1), 0); }, {}};
    run.bodies.x << 0, 0.1;
    return run;
}

/// A scene with its settings and memory.
struct Discs {
    DiscScene scene;
    StabilizedStepSettings settings;
    StabilizedStep now;

    explicit Discs(DiscScene start, Stabilizer method = Stabilizer::baumgarte) : scene(std::move(start))
    {
        settings.gravity = scene.gravity;
        settings.stabilizer.method = method;
    }
    void advance(int steps = 1)
    {
        for (int k = 0; k < steps; ++k) stabilized_step(scene, settings, now);
    }
};

/// A disc of 1 kg and radius 0.5 m that lies a depth C deep in the floor, or in nothing.
DiscScene sunken_disc(Real depth)
{
    DiscScene scene;
    scene.bodies = Bodies<2>(1);
    scene.radius = VecX::Constant(1, 0.5);
    scene.bodies.x << 0, 0.5 - depth;
    scene.walls = {{{0, 1}, 0}};
    return scene;
}

/// Ten discs of radius 0.25 m in a column between walls, each overlapping the next, and the floor, by 0.2 m.
DiscScene crowd()
{
    DiscScene scene = column_between_walls(10);
    scene.radius.setConstant(0.25);
    for (Index k = 0; k < 10; ++k) scene.bodies.position(k) = Vec2(0, 0.05 + 0.3 * static_cast<Real>(k));
    scene.walls = {{{0, 1}, 0}, {{1, 0}, -0.25}, {{-1, 0}, -0.25}};
    return scene;
}

}  // namespace

// ---- identities ---------------------------------------------------------------------------------------

TEST_CASE("a bead without repayment leaves the wire as (7.3) says")
{
    OneRow run = bead();
    run.settings.method = Stabilizer::none;
    Real r2 = 1;
    for (int n = 0; n < 1000; ++n) {
        // A millionth of a millionth: rounding of 1000 steps.
        CHECK(std::abs(run.bodies.x.norm() - std::sqrt(r2)) < 1e-12);
        r2 += run.h * run.h / r2;
        run.advance();
    }
    // Its velocity is that of the last move; the row makes it tangential in the next step.
    CHECK(std::abs(std::abs(cross2(run.bodies.x, run.bodies.u)) - 1) < 1e-12);
    CHECK(std::abs(run.bodies.x.norm() - 1.046637127311678) < 1e-12);
}

TEST_CASE("a linear error shrinks by 1 minus beta in each step")
{
    for (const Stabilizer method : all_ways) {
        if (method == Stabilizer::none) continue;
        OneRow run = beside_a_rail();
        run.settings.method = method;
        run.settings.repaying_sweeps = 1;
        for (int n = 0; n < 30; ++n) run.advance();
        INFO(to_string(method));
        CHECK(run.bodies.x[1] / 0.1 == Approx(1.237940039285e-3).epsilon(1e-12));
        // Only Baumgarte's velocity is left with what it repaid.
        const Real left = method == Stabilizer::baumgarte ? 0.2 * 0.1 * std::pow(0.8, 29) / run.h : 0;
        CHECK(std::abs(run.bodies.u[1] + left) < 1e-15);
    }
    OneRow run = beside_a_rail();
    run.settings.method = Stabilizer::none;
    for (int n = 0; n < 30; ++n) run.advance();
    CHECK(run.bodies.x[1] == 0.1);
}

TEST_CASE("repaying is monotone up to beta 1 and stable below 2 and grows beyond")
{
    for (const Real beta : {0.1, 0.5, 0.9, 1.0, 1.1, 1.5, 1.9, 1.99, 2.01, 2.5}) {
        OneRow run = beside_a_rail();
        run.settings.beta = beta;
        bool monotone = true;
        for (int n = 0; n < 1000; ++n) {
            const Real before = run.bodies.x[1];
            run.advance();
            monotone = monotone && run.bodies.x[1] >= 0 && run.bodies.x[1] <= before;
            if (n == 9)  // 10 steps of the closed form; rounding relative to the 0.1 m it began with
                CHECK(std::abs(run.bodies.x[1] - 0.1 * std::pow(1 - beta, 10)) <
                      1e-14 * std::max(1.0, std::pow(beta - 1, 10)));
        }
        INFO("beta " << beta);
        CHECK(monotone == (beta <= 1));
        CHECK((std::abs(run.bodies.x[1]) < 0.1) == (beta < 2));
    }
}

TEST_CASE("a bead with Baumgarte moves by (7.8) in each step and settles where (7.9) says")
{
    for (const Real beta : {0.05, 0.2, 0.5, 1.0, 1.5})
        for (const Real h : {0.01, 0.05}) {
            OneRow run = bead();
            run.h = h;
            run.settings.beta = beta;
            Real D = 0, largest = 0;
            for (int n = 0; n < 1000; ++n) {
                D = D - beta * D + beta * beta * D * D / (4 * (1 + D)) + h * h / (1 + D);
                run.advance();
                largest = std::max(largest, std::abs(run.bodies.x.squaredNorm() - 1 - D));
            }
            INFO("beta " << beta << " h " << h);
            CHECK(largest < 1e-12);
            CHECK(std::abs(D - settled_bead(beta, h)) < 1e-14);
        }
}

TEST_CASE("a chain that hangs with too few sweeps sags by (7.12)")
{
    for (const Index N : {2, 3, 5})
        for (const int sweeps : {1, 2, 3}) {
            Discs run(hanging_chain(N, 3));
            run.settings.sweeps.max_sweeps = sweeps;
            run.settings.stabilizer.beta = 0.3;
            run.advance(6000);  // the slowest mode is gone to the last digit
            DiscScene straight = hanging_chain(N, 3);
            std::vector<Row<2>> rows;
            for (const Link& link : straight.links)
                rows.push_back(
                    bilateral(distance_constraint(straight.bodies.x, link), straight.bodies.inverse_mass));
            const MatX A = assemble(rows, run.now.u_star).A;
            VecX lambda(N);  // (4.9): each link carries what hangs below; it pulls, so its λ is negative
            for (Index k = 0; k < N; ++k)
                lambda[k] = -static_cast<Real>(N - 1 - k + 3) * 9.81 * run.settings.h;
            const VecX C = sag(A, lambda, sweeps, 0.3, run.settings.h);
            for (Index k = 0; k < N; ++k) {
                const Real length = (run.scene.bodies.position(k + 1) - run.scene.bodies.position(k)).norm();
                INFO("N " << N << " sweeps " << sweeps << " link " << k);
                // The lengths are of order 1 m and C is their small difference from 0.1 m.
                CHECK(std::abs(length - 0.1 - C[k]) < 1e-11);
            }
        }
}

TEST_CASE("n substeps of one sweep sag by the square of n less and n sweeps by about n less")
{
    const auto sag_of = [](int substeps, int sweeps, Real carry) {
        Discs run(hanging_chain(10));
        run.settings.substeps = substeps;
        run.settings.sweeps.max_sweeps = sweeps;
        run.settings.carry = carry;
        run.advance(1500);
        return largest_link_error(run.scene);
    };
    const Real one = sag_of(1, 1, 0);
    for (const int n : {2, 4, 8}) {
        CHECK(sag_of(n, 1, 0) == Approx(one / (n * n)).epsilon(1e-6));
        const Real sweeps = sag_of(1, n, 0);
        CHECK(sweeps < one / n);
        CHECK(sweeps > 0.8 * one / n);  // ten rows: G to the n is not near zero yet
    }
}

TEST_CASE("split impulses sag by (7.17), about the square of what Baumgarte's sag is multiplied by")
{
    const Index N = 4;
    for (const int sweeps : {1, 2, 4}) {
        Discs run(hanging_chain(N), Stabilizer::split_impulse);
        run.settings.sweeps.max_sweeps = sweeps;
        run.settings.stabilizer.repaying_sweeps = sweeps;
        run.advance(8000);
        DiscScene straight = hanging_chain(N);
        std::vector<Row<2>> rows;
        for (const Link& link : straight.links)
            rows.push_back(
                bilateral(distance_constraint(straight.bodies.x, link), straight.bodies.inverse_mass));
        const MatX A = assemble(rows, run.now.u_star).A;
        VecX lambda(N);
        for (Index k = 0; k < N; ++k) lambda[k] = -static_cast<Real>(N - k) * 9.81 * run.settings.h;
        const VecX C = split_sag(A, lambda, sweeps, sweeps, 0.2, run.settings.h);
        for (Index k = 0; k < N; ++k) {
            const Real length = (run.scene.bodies.position(k + 1) - run.scene.bodies.position(k)).norm();
            INFO("sweeps " << sweeps << " link " << k);
            CHECK(std::abs(length - 0.1 - C[k]) < 1e-10);
        }
    }
}
