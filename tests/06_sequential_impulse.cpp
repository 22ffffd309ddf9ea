/// Chapter 6: sequential impulses, what rows can say, blocks, impacts, orders.

#include "tests/no_allocation.hpp"

#include "chapters/03_mlcp_formulation/assembly.hpp"
#include "chapters/03_mlcp_formulation/exact.hpp"
#include "chapters/04_pgs/pgs.hpp"
#include "chapters/04_pgs/rates.hpp"
#include "chapters/05_lemke/lemke.hpp"
#include "chapters/06_sequential_impulse/block.hpp"
#include "chapters/06_sequential_impulse/impacts.hpp"
#include "chapters/06_sequential_impulse/impulse_method.hpp"
#include "chapters/06_sequential_impulse/lift.hpp"
#include "chapters/06_sequential_impulse/small_scenes.hpp"
#include "chapters/06_sequential_impulse/wrong_clamping.hpp"
#include "common/measure.hpp"
#include "common/program/scripted_pointer.hpp"
#include "common/random.hpp"

#include "tests/catch.hpp"
#include "tests/limit.hpp"
#include "tests/order.hpp"
#include "tests/sentence.hpp"

#include <functional>
#include <numeric>
#include <set>

using namespace rigid;

namespace {

/// Rows at random between bodies at random, of all kinds of bounds; some bodies cannot move.
template <int Dof>
struct RandomRows {
    VecX inverse_mass, u_star;
    std::vector<Row<Dof>> rows;

    RandomRows(Random& random, Index bodies, Index count)
    {
        inverse_mass.resize(Dof * bodies);
        for (Index k = 0; k < bodies; ++k) {
            const bool fixed = k > 0 && random.index(6) == 0;
            for (Index d = 0; d < Dof; ++d) inverse_mass[Dof * k + d] = fixed ? 0 : std::exp(random.normal());
        }
        u_star.resize(Dof * bodies);
        for (Index i = 0; i < u_star.size(); ++i) u_star[i] = random.normal();
        for (Index i = 0; i < count; ++i) {
            Constraint<Dof> c;
            c.b = random.index(bodies);
            c.a = random.index(3) == 0 ? world : random.index(bodies);
            if (c.a == c.b) c.a = world;
            for (Index d = 0; d < Dof; ++d) {
                c.Jb[d] = random.normal();
                if (c.a != world) c.Ja[d] = random.normal();
            }
            const Real b = random.normal();
            switch (random.index(3)) {
            case 0:
                rows.push_back(unilateral(c, inverse_mass, b));
                break;
            case 1: {
                const Real hi = random.uniform(), lo = -random.uniform();
                rows.push_back(make_row(c, inverse_mass, b, lo, hi));
                break;
            }
            default:
                rows.push_back(bilateral(c, inverse_mass, b));
            }
        }
    }
};

/// The rows of a scene of discs at rest, as a step of 1/60 s has them.
struct SceneRows {
    DiscScene scene;
    std::vector<Contact> contacts;
    std::vector<Row<2>> rows;
    VecX u_star;

    explicit SceneRows(DiscScene which, Real h = 1.0 / 60) : scene(std::move(which))
    {
        find_contacts(scene, 1e-6, contacts);
        disc_rows(scene, h, contacts, rows, LeaveErrors{});
        scene.bodies.f.setZero();
        add_gravity(scene.bodies, scene.gravity);
        u_star = scene.bodies.u + h * scene.bodies.inverse_mass.cwiseProduct(scene.bodies.f);
    }
};

/// The largest difference between chapter 4's λ and this chapter's over so many sweeps, relative to the largest λ;
/// of u as well, and of the residual.
template <int Dof>
Real largest_difference(const std::vector<Row<Dof>>& rows, const VecX& u_star, const std::vector<int>& order,
                        int sweeps, bool alternate = false)
{
    const Mlcp mlcp = assemble(rows, u_star);
    SweepRows pgs_rows;
    prepare(mlcp, 1, order, pgs_rows);
    for (Index i = 0; i < mlcp.size(); ++i)
        pgs_rows.lambda[pgs_rows.place_of[std::size_t(i)]] = std::clamp(Real{0}, mlcp.lo[i], mlcp.hi[i]);
    ImpulseMemory<Dof> memory;
    Solution solution;
    begin_sweeps(rows, order, 0, memory, u_star, solution);

    Real largest = 0;
    for (int k = 0; k < sweeps; ++k) {
        const bool backwards = alternate && k % 2 == 1;
        backwards ? sweep_backward(pgs_rows) : sweep_forward(pgs_rows);
        sweep(memory, 0, backwards);
        VecX u, lambda(mlcp.size());
        end_sweeps(order, memory, u, solution);
        for (Index i = 0; i < mlcp.size(); ++i)
            lambda[i] = pgs_rows.lambda[pgs_rows.place_of[std::size_t(i)]];
        const Real scale = 1 + lambda.lpNorm<Eigen::Infinity>();
        largest = std::max(largest, (lambda - solution.lambda).lpNorm<Eigen::Infinity>() / scale);
        VecX expected = u_star;
        apply(rows, lambda, expected);
        largest = std::max(largest, (u - expected).lpNorm<Eigen::Infinity>() /
                                        (1 + expected.lpNorm<Eigen::Infinity>() + scale));
        largest = std::max(largest, std::abs(natural_residual(memory) - natural_residual(mlcp, lambda)) /
                                        (scale + natural_residual(mlcp, lambda)));
    }
    return largest;
}

ImpulseMethod tight()
{
    ImpulseMethod method;
    method.solver.sweeps = {.max_sweeps = 100000, .tolerance = 1e-10};
    return method;
}

constexpr Order all_orders[] = {Order::given, Order::alternating, Order::shuffled, Order::coloured};

}  // namespace

// ---- the same iteration without the matrix --------------------------------------------------------

TEST_CASE("two discs in a column by hand make the visits of chapter 4 on velocities", "[idea]")
{
    // The example of the text: 1 kg each, u* = (−1, −1) m/s, row 1 floor to disc 1, row 2 disc 1 to disc 2.
    VecX inverse_mass = VecX::Ones(4), u = VecX::Zero(4);
    u[1] = u[3] = -1;
    const Contact floor{world, 0, {0, 1}, 0}, between{0, 1, {0, 1}, 0};
    const std::vector<Row<2>> rows = {unilateral(contact_constraint(floor), inverse_mass),
                                      unilateral(contact_constraint(between), inverse_mass)};
    const Real by_hand[][4] = {
        {1, 0.5, -0.5, -0.5}, {1.5, 0.75, -0.25, -0.25}, {1.75, 0.875, -0.125, -0.125}};
    int sweeps = 0;
    for (const auto& [first, second, u1, u2] : by_hand) {
        ImpulseMemory<2> memory;
        Solution solution;
        VecX after = u;
        sequential_impulse<2>(rows, {}, {.max_sweeps = ++sweeps}, memory, after, solution);
        CHECK(solution.lambda[0] == first);  // halves and quarters: no rounding at all
        CHECK(solution.lambda[1] == second);
        CHECK(after[1] == u1);
        CHECK(after[3] == u2);
    }
}

TEST_CASE("the column of twenty takes the sweeps of the check in Algorithm 6.1", "[idea]")
{
    const SceneRows here(column(20));
    ImpulseMemory<2> memory;
    Solution solution;
    VecX u = here.u_star;
    sequential_impulse<2>(here.rows, {}, {.max_sweeps = 10000, .tolerance = 1e-6}, memory, u, solution);
    CHECK(solution.status == Status::solved);
    CHECK(solution.iterations == 1685);
    std::vector<int> floor_first(20);
    std::iota(floor_first.begin(), floor_first.end(), -1);
    floor_first[0] = 19;
    u = here.u_star;
    solution = {};
    sequential_impulse<2>(here.rows, floor_first, {.max_sweeps = 10000, .tolerance = 1e-6}, memory, u,
                          solution);
    CHECK(solution.iterations == 1684);
    const std::vector<Row<2>> none;
    sequential_impulse<2>(none, {}, {.max_sweeps = 10, .tolerance = 1e-6}, memory, u, solution);
    CHECK(solution.status == Status::solved);
    CHECK(solution.iterations == 1);
}

TEST_CASE("the iterates are those of projected Gauss-Seidel sweep by sweep as (6.6) says", "[house]")
{
    Random random(6);
    std::vector<int> order;
    // The sums run in another order: some roundings of numbers up to the scale, in each of 60 sweeps.
    for (int sample = 0; sample < 100; ++sample) {
        const RandomRows<2> discs(random, 8, 20);
        const RandomRows<3> planar(random, 6, 20);
        const RandomRows<6> space(random, 5, 20);
        shuffle_rows(20, random, order);
        for (const bool alternate : {false, true}) {
            CHECK(largest_difference(discs.rows, discs.u_star, order, 60, alternate) < 1e-12);
            CHECK(largest_difference(planar.rows, planar.u_star, {}, 60, alternate) < 1e-12);
            CHECK(largest_difference(space.rows, space.u_star, order, 60, alternate) < 1e-12);
        }
    }
    for (const DiscScene& scene : {column(20), column(20, 100), column_between_walls(20), triangle(8),
                                   hanging_chain(40, 100), ten_discs(), groove(0.3)}) {
        const SceneRows here(scene);
        CHECK(largest_difference(here.rows, here.u_star, {}, 200) < 1e-12);
    }
}

TEST_CASE("a column takes the sweeps that chapter 4 needs for six digits", "[house]")
{
    for (const auto& [count, wanted] : {std::pair<Index, int>{2, 20}, {5, 136}, {10, 550}, {20, 2204}}) {
        const Index N = count;  // a lambda may not capture the binding itself
        const SceneRows here(column(N));
        std::vector<int> order(static_cast<std::size_t>(N));  // the floor's row comes last: bottom-up is
        std::iota(order.begin(), order.end(), -1);
        order[0] = static_cast<int>(N) - 1;
        const VecX exact = line_answer(N, 1, 9.81 / 60);
        ImpulseMemory<2> memory;
        Solution solution;
        begin_sweeps(here.rows, order, 0, memory, here.u_star, solution);
        const auto error = [&] {
            Real largest = 0;
            for (Index i = 0; i < N; ++i)
                largest = std::max(largest, std::abs(memory.rows[std::size_t(i)].lambda - exact[i]));
            return largest / exact.maxCoeff();
        };
        int sweeps = 0;
        while (error() > 1e-6 && sweeps < 10000) sweep(memory, 0), ++sweeps;
        CHECK(sweeps == wanted);
    }
}

TEST_CASE("a hub with a thousand contacts needs a thousand rows and no million entries", "[house]")
{
    const Index m = 1000;
    VecX inverse_mass = VecX::Ones(2 * (m + 1));
    std::vector<Row<2>> rows;
    Random random(2);
    for (Index k = 1; k <= m; ++k) {
        const Real angle = random.uniform(0, 2 * pi);
        rows.push_back(
            unilateral(contact_constraint({0, k, {std::cos(angle), std::sin(angle)}, 0}), inverse_mass));
    }
    VecX u = VecX::Zero(2 * (m + 1));
    CHECK(assemble(rows, u).A.nonZeros() == m * m);
    ImpulseMemory<2> memory;
    Solution solution;
    sequential_impulse<2>(rows, {}, {.max_sweeps = 1}, memory, u, solution);
    CHECK(memory.rows.size() == static_cast<std::size_t>(m));
    CHECK(memory.visits == m);
    sequential_impulse<2>(rows, {}, {.max_sweeps = 1, .tolerance = 1e-9}, memory, u, solution);
    CHECK(memory.visits == 2 * m);       // a sweep and a residual
    CHECK(sizeof(SolverRow<2>) == 112);  // the number of the text
}

// ---- what is said of an answer ------------------------------------------------------------------------

TEST_CASE("solved is said only of an answer whose residual meets the tolerance", "[idea]")
{
    Random random(7);
    int solved = 0, limited = 0;
    for (int sample = 0; sample < 300; ++sample) {
        const RandomRows<3> some(random, 4, 1 + random.index(8));
        VecX u = some.u_star;
        ImpulseMemory<3> memory;
        Solution solution;
        const ImpulseSettings settings{1 + static_cast<int>(random.index(60)), 1e-6, sample % 2 == 0};
        sequential_impulse<3>(some.rows, {}, settings, memory, u, solution);
        const Real residual = natural_residual(assemble(some.rows, some.u_star), solution.lambda);
        const bool met = residual <= 1e-6 * (1 + 1e-6);
        CHECK((solution.status == Status::solved) == met);
        CHECK(solution.residual == Approx(residual).margin(1e-12));
        solved += met;
        limited += !met;
    }
    CHECK(solved > 50);
    CHECK(limited > 50);
}

TEST_CASE("an exact solver and sequential impulses move the bodies alike", "[idea]")
{
    Random random(8);
    int compared = 0;
    for (int sample = 0; sample < 200; ++sample) {
        const RandomRows<2> some(random, 5, 6);
        VecX u = some.u_star, exact_u = some.u_star;
        ImpulseMemory<2> memory;
        Solution solution;
        sequential_impulse<2>(some.rows, {}, {.max_sweeps = 200000, .tolerance = 1e-12}, memory, u, solution);
        if (solution.status != Status::solved) continue;
        ++compared;
        const Solution exact = enumerate(assemble(some.rows, some.u_star));
        REQUIRE(exact.status == Status::solved);
        apply(some.rows, exact.lambda, exact_u);
        // w off by 1e-12 over the smallest eigenvalue of A, above 1e-5 here.
        CHECK((u - exact_u).lpNorm<Eigen::Infinity>() < 1e-6);
    }
    CHECK(compared > 150);
}

TEST_CASE("impulses that cancel in the last digits are not called solved", "[idea]")
{
    // One rod twice, with u* = (1.3, 0.4) along it: both share one speed, 0.85 m/s. From ±1e17 N s on, the velocities of
    // the start are lost in its rounding, u = (0, 0), and w = 0 says nothing.
    Bodies<2> bodies(2);
    bodies.x << 0, 0, 1, 0;
    const Row<2> rod = bilateral(distance_constraint(bodies.x, {0, 1, 1}), bodies.inverse_mass);
    const auto solved_from = [&](Real start, VecX& u) {
        u.resize(4);
        u << 1.3, 0, 0.4, 0;
        ImpulseMemory<2> memory;
        Solution solution;
        solution.lambda.resize(2);
        solution.lambda << start, -start;
        sequential_impulse<2>({rod, rod}, {}, {.max_sweeps = 100, .tolerance = 1e-6}, memory, u, solution);
        CHECK(solution.residual <= 1e-6);
        return solution.status;
    };
    VecX u;
    CHECK(solved_from(1e17, u) == Status::iteration_limit);
    CHECK(solved_from(1e6, u) == Status::solved);
    CHECK(u[0] == Approx(0.85).margin(1e-6));
    CHECK(u[2] == Approx(0.85).margin(1e-6));
}

TEST_CASE("rows that nothing moves take their bound or are called infeasible", "[idea]")
{
    VecX inverse_mass = VecX::Zero(4);
    VecX u = VecX::Zero(4);
    u[2] = -1;  // body 1 is carried into body 0, and neither can be stopped
    const Constraint<2> touch = contact_constraint({0, 1, {1, 0}, 0});
    ImpulseMemory<2> memory;
    Solution solution;
    const auto status_of = [&](const Row<2>& row) {
        solution.lambda.resize(0);
        VecX moved = u;
        sequential_impulse<2>({row}, {}, {.max_sweeps = 10, .tolerance = 1e-9}, memory, moved, solution);
        CHECK(moved == u);
        return solution.status;
    };
    CHECK(status_of(unilateral(touch, inverse_mass)) == Status::infeasible);
    CHECK(solution.lambda.allFinite());
    CHECK(status_of(unilateral(touch, inverse_mass, 1)) == Status::solved);  // w = 0
    CHECK(status_of(motor(touch, inverse_mass, 3, 2, 0.5)) == Status::solved);
    CHECK(solution.lambda[0] == 1);  // hF
}

TEST_CASE("a row that nothing moves is hopeless beyond the tolerance alone and is not swept for to the limit",
          "[idea]")
{
    // Row 0 between two bodies that cannot move, row 1 on a body that can.
    Bodies<2> bodies(3);
    bodies.x << 0, 0, 1, 0, 2, 0;
    bodies.inverse_mass.head<4>().setZero();
    const auto solved_with = [&](Real w, int sweeps = 1000) {
        const std::vector<Row<2>> rows = {
            bilateral(distance_constraint(bodies.x, {0, 1, 1}), bodies.inverse_mass, w),
            unilateral(distance_constraint(bodies.x, {1, 2, 1}), bodies.inverse_mass, -1)};
        VecX u = bodies.u;
        ImpulseMemory<2> memory;
        Solution solution;
        sequential_impulse<2>(rows, {}, {.max_sweeps = sweeps, .tolerance = 1e-9}, memory, u, solution);
        if (sweeps > 0) CHECK(u[4] == Approx(1));
        return solution;
    };
    // before a sweep nothing is known but that
    CHECK(solved_with(0.9e-9, 0).status == Status::iteration_limit);
    CHECK(solved_with(1.1e-9, 0).status == Status::infeasible);
    CHECK(solved_with(0.9e-9).status == Status::solved);
    const Solution hopeless = solved_with(1.1e-9);
    CHECK(hopeless.status == Status::infeasible);
    CHECK(hopeless.iterations <= 2);
}

TEST_CASE("a start outside of its bounds is put within them before it moves anything", "[idea]")
{
    const SceneRows here(column(1));
    VecX u = here.u_star;
    ImpulseMemory<2> memory;
    Solution solution;
    solution.lambda = VecX::Constant(1, -3);
    sequential_impulse<2>(here.rows, {}, {.max_sweeps = 0}, memory, u, solution);
    CHECK(solution.lambda[0] == 0);
    CHECK(u == here.u_star);
}

TEST_CASE("sweeps end early when there is nothing left to do", "[idea]")
{
    const SceneRows here(column(1));
    VecX u = here.u_star;
    ImpulseMemory<2> memory;
    Solution solution;
    sequential_impulse<2>(here.rows, {}, {.max_sweeps = 100}, memory, u, solution);
    CHECK(solution.iterations == 2);                    // one row: the second sweep finds nothing
    CHECK(solution.status == Status::iteration_limit);  // no residual was computed
    CHECK(solution.residual == infinity);
    u = here.u_star;
    sequential_impulse<2>(here.rows, {}, {.max_sweeps = 100, .tolerance = 1e-9}, memory, u,
                          solution);  // from the answer
    CHECK(solution.iterations == 1);
    CHECK(solution.status == Status::solved);
    sequential_impulse<2>({}, {}, {.max_sweeps = 100, .tolerance = 1e-9}, memory, u, solution);
    CHECK(solution.status == Status::solved);
}

// ---- clamp the sum, not the correction -------------------------------------------------------------------

TEST_CASE(
    "a disc that falls into a groove of 30 degrees stops or hops by how one clamps as in (6.9) to (6.12)",
    "[house]")
{
    const DiscScene scene = groove(pi / 6);
    const SceneRows here(scene);
    const Real s = std::sqrt(3.0);
    for (const bool wrong : {false, true}) {
        VecX u(2);
        u << 0, -1;
        ImpulseMemory<2> memory;
        Solution solution;
        const ImpulseSettings settings{.max_sweeps = 60, .tolerance = 1e-13};
        if (wrong) impulse_clamping_corrections<2>(here.rows, {}, settings, memory, u, solution);
        else sequential_impulse<2>(here.rows, {}, settings, memory, u, solution);
        if (wrong) {
            CHECK(solution.lambda[0] == Approx(s / 2).epsilon(1e-14));
            CHECK(solution.lambda[1] == Approx(s / 4).epsilon(1e-14));
            CHECK(u[0] == Approx(s / 8).epsilon(1e-14));
            CHECK(u[1] == Approx(1.0 / 8).epsilon(1e-13));
            CHECK(solution.status == Status::iteration_limit);
            CHECK(solution.residual == Approx(s / 8).epsilon(1e-13));  // it pushes, and yet they part
        } else {
            CHECK(solution.lambda[0] == Approx(1 / s).epsilon(1e-12));
            CHECK(solution.lambda[1] == Approx(1 / s).epsilon(1e-12));
            CHECK(u.norm() < 1e-12);
            CHECK(solution.status == Status::solved);
        }
    }
}

TEST_CASE("a disc at rest in a groove stays or jitters or hangs askew by how one clamps", "[house]")
{
    const Real gh = 9.81 / 60;
    for (const bool wrong : {false, true})
        for (const Real margin : {0.02, 1e-9}) {  // contacts known before they close, or when they touch
            DiscScene scene = groove(pi / 6);
            const Vec2 start = scene.bodies.position(0);
            WrongClampingMethod method;
            method.solver.wrong = wrong;
            StepSettings settings;
            method.solver.sweeps = {.max_sweeps = 30};  // the error falls by 4 a sweep: rounding is reached
            settings.margin = margin;
            StepData<2> now;
            Real farthest = 0, first = 0, late = 0;
            for (int k = 0; k < 600; ++k) {
                step(scene, settings, method, now);
                const Real speed = scene.bodies.u.norm();
                if (k == 0) first = speed;
                if (k >= 300) {
                    late = std::max(late, speed);
                    farthest = std::max(farthest, (scene.bodies.position(0) - start).norm());
                }
            }
            if (!wrong) {
                CHECK(late < 1e-13);
                CHECK(farthest < 1e-13);
                continue;
            }
            CHECK(first == Approx(gh / 4).epsilon(1e-12));  // ‖(√3, 1)‖/8 of g h
            CHECK(farthest > 5e-4);                     // some of the first hop of 0.68 mm is never undone
            if (margin < 1e-6) CHECK(late > 0.5 * gh);  // it never comes to rest
            else CHECK(late < 1e-12);                   // it does, in the air
        }
}

TEST_CASE("a floor of two equal half-spaces hides the mistake and a beam on its ends too", "[house]")
{
    // Exercises 6.1 and 6.3: all at 1 m/s downwards.
    const auto lambda = []<int Dof>(const std::vector<Row<Dof>>& rows, VecX u, bool wrong, int sweeps) {
        ImpulseMemory<Dof> memory;
        Solution solution;
        if (wrong) impulse_clamping_corrections<Dof>(rows, {}, {.max_sweeps = sweeps}, memory, u, solution);
        else sequential_impulse<Dof>(rows, {}, {.max_sweeps = sweeps}, memory, u, solution);
        return solution.lambda;
    };
    const Row<2> floor = unilateral(contact_constraint({world, 0, {0, 1}, 0}), VecX::Ones(2));
    const auto support = [](Real x) {
        Constraint<3> at;
        at.a = world;
        at.b = 0;
        at.Jb << 0, 1, x;
        return unilateral(at, VecX(Vec<3>(1, 1, 12)));
    };
    const std::vector<Row<3>> ends = {support(-0.5), support(0.5)}, inside = {support(-0.1), support(0.1)};
    for (const bool wrong : {false, true}) {
        CHECK(lambda(std::vector<Row<2>>{floor, floor}, Vec2(0, -1), wrong, 50) == VecX(Vec2(1, 0)));
        CHECK(lambda(ends, Vec<3>(0, -1, 0), wrong, 1) == VecX(Vec2(0.25, 0.375)));
        // The error falls by 4 in each sweep: 50 reach rounding.
        CHECK((lambda(ends, Vec<3>(0, -1, 0), wrong, 50) - VecX(Vec2(0.5, 0.5))).norm() < 1e-14);
        const Real off = (lambda(inside, Vec<3>(0, -1, 0), wrong, 500) - VecX(Vec2(0.5, 0.5))).norm();
        CHECK((off < 1e-14) == !wrong);
    }
}

TEST_CASE("a link that breaks before the sweeps have converged breaks wrongly", "[idea]")
{
    // Exercise 6.6. In the groove the first sweep gives more than the answer, at the top of a chain less.
    const auto sweeps_of = [](std::vector<Row<2>> rows, const VecX& u_star, int sweeps) {
        for (Row<2>& row : rows) row.lo = -infinity, row.hi = infinity;
        ImpulseMemory<2> memory;
        Solution solution;
        VecX u = u_star;
        sequential_impulse<2>(rows, {}, {.max_sweeps = sweeps}, memory, u, solution);
        return solution.lambda;
    };
    const SceneRows bottom(groove(pi / 6));
    CHECK(sweeps_of(bottom.rows, Vec2(0, -1), 1)[0] == Approx(std::sqrt(3.0) / 2).epsilon(1e-14));
    CHECK(sweeps_of(bottom.rows, Vec2(0, -1), 60)[0] == Approx(1 / std::sqrt(3.0)).epsilon(1e-12));
    const SceneRows chain(hanging_chain(20));
    const Real weight = 20 * 9.81 / 60;
    CHECK(sweeps_of(chain.rows, chain.u_star, 10).cwiseAbs().maxCoeff() < weight / 5);
    CHECK(sweeps_of(chain.rows, chain.u_star, 20000).cwiseAbs().maxCoeff() == Approx(weight).epsilon(1e-9));
}

TEST_CASE("after n sweeps the first row of two is off by what (6.26) says", "[house]")
{
    for (const Real angle : {0.1, 0.4, 0.7, 1.0, 1.3}) {
        const SceneRows here(groove(angle));
        ImpulseMemory<2> memory;
        Solution solution;
        begin_sweeps(here.rows, {}, 0, memory, here.u_star, solution);
        const Real c = std::cos(2 * angle), speed = 9.81 / 60 * std::cos(angle);
        for (int n = 1; n <= 8; ++n) {
            sweep(memory, 0);
            // Roundings of numbers of size speed.
            CHECK(here.rows[0].velocity(memory.u) ==
                  Approx(speed * (1 - c) * std::pow(c, 2 * n - 1)).margin(1e-15));
            CHECK(std::abs(here.rows[1].velocity(memory.u)) < 1e-15);
        }
    }
}

TEST_CASE("a disc in a steep groove creeps to the side of the row that is visited first", "[idea]")
{
    const Real angle = pi / 3, h = 1.0 / 60;
    const int sweeps = 3, steps = 300;
    Real x[4], speed_given = 0;
    for (const Order order : all_orders) {
        DiscScene scene = groove(angle);
        StepSettings settings;
        ImpulseMethod method;
        method.solver.ordering = order;
        method.solver.sweeps.max_sweeps = sweeps;
        StepData<2> now;
        for (int k = 0; k < steps; ++k) step(scene, settings, method, now);
        x[static_cast<int>(order)] = scene.bodies.x[0];
        if (order == Order::given) speed_given = scene.bodies.u.norm();
    }
    // Along the side that is visited last, with the speed of (6.27): each step begins with that of the last one.
    const Real c = std::cos(2 * angle);
    const Real along =
        9.81 * h * std::sin(angle) * std::pow(c, 2 * sweeps - 1) / (1 - std::pow(c, 2 * sweeps));
    CHECK(speed_given == Approx(std::abs(along)).epsilon(1e-10));
    CHECK(x[0] == Approx(steps * h * along * std::cos(angle)).epsilon(1e-3));  // the first steps are slower
    CHECK(x[0] < -1e-3);
    // Two rows of one disc have two colours. Three sweeps, the second one backwards, end as they began, but it
    // is a waste: what the backward sweep visits first is what the last one has just solved.
    CHECK(x[3] == Approx(x[0]).epsilon(1e-10));
    CHECK(std::abs(x[1]) > std::abs(x[0]));
    CHECK(std::abs(x[2]) < 0.3 * std::abs(x[0]));  // a random walk of 300 steps: a part of 1/√300 or so
}

// ---- what a bias and two bounds can say --------------------------------------------------------------------

namespace {

/// A ball of radius 0.1 m that falls from a height onto the floor.
struct Bouncing {
    DiscScene scene = column(1);
    StepSettings settings;
    ImpulseMethod method;
    StepData<2> now;

    Bouncing(Real height, Real e, Real h)
    {
        scene.bodies.x[1] += height;
        settings.h = h;
        method.correction.restitution = e;
        method.solver.sweeps.max_sweeps = 2;
    }
    void step() { rigid::step(scene, settings, method, now); }
    Real height() const { return scene.bodies.x[1] - 0.1; }
    Real speed() const { return scene.bodies.u[1]; }
};

}  // namespace

TEST_CASE("a bounce with e = 1 keeps the energy of the scheme to the last digits as (6.16) says", "[idea]")
{
    // ½v² + gy − ½ghv, which symplectic Euler keeps in free fall, is kept by the bounce as well.
    for (const Real h : {1.0 / 60, 1.0 / 240, 1.0 / 1000}) {
        Bouncing ball(5, 1, h);
        const Real start = 9.81 * 5;
        for (int k = 0; k < static_cast<int>(30 / h); ++k) {
            ball.step();
            const Real v = ball.speed(), kept = 0.5 * v * v + 9.81 * ball.height() - 0.5 * 9.81 * h * v;
            REQUIRE(kept == Approx(start).epsilon(1e-11));  // 30000 roundings
        }
    }
}

TEST_CASE("a bounce needs a gap that closes and e > 0 and an overlap that is leaving is not hit again",
          "[house]")
{
    // (6.18), its conditions one by one; h = 0.1 s, threshold 0.2 m/s, v⁻ = −1 m/s unless said otherwise.
    const auto b = [](Real C, Real before, Real after, Real e) {
        return contact_bias(C, before, after, e, 0.2, 0.1);
    };
    CHECK(b(0.05, -1, -1, 0.5) == -0.5);          // 5 cm close within the step: it bounces
    CHECK(b(0.15, -1, -1, 0.5) == 0.15 / 0.1);    // 15 cm do not
    CHECK(b(0.05, -1, -0.4, 0.5) == 0.05 / 0.1);  // nor do 5 cm when the forces hold the bodies back
    CHECK(b(0.05, -0.1, -1, 0.5) == 0.05 / 0.1);  // slower than the threshold
    CHECK(b(0.05, -1, -1, 0) == 0.05 / 0.1);      // e = 0: up to the floor, not stopped above it
    CHECK(b(-0.01, -1, -1, 0.5) == -0.5);         // an overlap that grows is a hit
    CHECK(b(-0.01, -1, 0.05, 0.5) == 0);    // one that the forces part already is none, though C + h J u* < 0
    CHECK(b(-0.01, -0.1, -0.1, 0.5) == 0);  // and what overlaps and is slow is left as it is
}

TEST_CASE("twelve bounces with e = 1 from 5 m peak at 5 m within a thousandth and never above", "[idea]")
{
    Bouncing ball(5, 1, 1.0 / 240);
    Real peak = 0;
    int bounces = 0;
    for (Limit steps(100000); bounces < 13 && steps.left();) {
        const Real before = ball.speed();
        ball.step();
        peak = std::max(peak, ball.height());
        if (before < 0 && ball.speed() > 0) {
            if (bounces > 0) {
                CHECK(peak <= 5 * (1 + 1e-3));
                CHECK(peak >= 5 * (1 - 1e-3));  // the table asks for 1 %; a step near the peak is g h²/8
            }
            ++bounces;
            peak = 0;
        }
    }
}

TEST_CASE("a ball comes to rest at the time of the closed form to order one in h times its logarithm",
          "[idea]")
{
    CHECK(std::sqrt(2 / 9.81) * 9 == Approx(4.063712768871578).epsilon(1e-14));
    // Each impact is up to some steps off, and there are log(v/gh)/log(1/e) of them. Single errors jump about with
    // the phase of the impacts: the mean of some heights.
    for (const Real e : {0.5, 0.8, 0.9}) {
        std::vector<Real> expected, measured;
        for (int n = 960; n <= 15360; n *= 2) {
            const Real h = 1.0 / n;
            Real sum = 0;
            for (const Real height : {0.93, 0.96, 0.98, 1.0, 1.03, 1.07}) {
                Bouncing ball(height, e, h);
                const Real wanted = std::sqrt(2 * height / 9.81) * (1 + e) / (1 - e);
                int rest = 0;
                Limit steps(100 * n);  // 100 s
                for (int k = 1; k <= rest + n / 2 && steps.left(); ++k) {
                    ball.step();
                    if (std::abs(ball.speed()) > 1e-9) rest = k;
                }
                sum += std::abs(rest * h - wanted) / 6;
            }
            expected.push_back(h * std::log(std::sqrt(2 * 9.81) / (9.81 * h)) / std::log(1 / e));
            measured.push_back(sum);
            CHECK(sum < 3 * expected.back());
        }
        const Real order =
            std::log(measured.front() / measured.back()) / std::log(expected.front() / expected.back());
        CHECK(order == Approx(1).margin(0.15));
    }
}

TEST_CASE("the fifth impact comes at the time of the closed form to first order in h", "[idea]")
{
    for (int n = 60; n <= 7680; n *= 2) {
        Bouncing ball(1, 0.8, 1.0 / n);
        int bounces = 0, k = 0;
        for (Limit steps(100 * n); bounces < 5 && steps.left();) {
            const Real before = ball.speed();
            ball.step();
            ++k;
            bounces += before < 0 && ball.speed() > 0;
        }
        // Each flight is off by less than a step at either end.
        CHECK(std::abs(static_cast<Real>(k) / n - 2.584160102089535) < 5.0 / n);
    }
}

TEST_CASE("a threshold that does not scale with h leaves an error that no h takes away", "[idea]")
{
    const Real wanted = std::sqrt(2 / 9.81) * 9;  // e = 0.8
    const auto error = [wanted](Real h, Real slowest) {
        Bouncing ball(1, 0.8, h);
        ball.method.correction.threshold = slowest / (9.81 * h);
        Real rest = 0;
        for (int k = 0; k * h < 6; ++k) {
            ball.step();
            if (std::abs(ball.speed()) > 1e-9) rest = k * h;
        }
        return std::abs(rest - wanted);
    };
    // What is cut off below 0.5 m/s: 2v/g · 1/(1−e) with v between 0.4 and 0.5 m/s.
    CHECK(error(1.0 / 3840, 0.5) > 0.3);
    CHECK(error(1.0 / 3840, 2 * 9.81 / 3840) < 0.03);
}

TEST_CASE("without the threshold a ball that hardly bounces hops on and with it lies still", "[idea]")
{
    for (const Real e : {0.2, 0.5, 0.8}) {
        Real last[2];
        for (const bool threshold : {false, true}) {
            Bouncing ball(1, e, 1.0 / 60);
            if (!threshold) ball.method.correction.threshold = 0;
            last[threshold] = 0;
            for (int k = 0; k < 600; ++k) {
                ball.step();
                if (std::abs(ball.speed()) > 1e-9) last[threshold] = k / 60.0;
            }
        }
        CHECK(last[true] < 0.8 * last[false]);
    }
}

TEST_CASE("a lift is lifted as fast as its motor's force allows and no faster than its speed", "[idea]")
{
    const Real h = 1.0 / 60, m = 2, g = 9.81;
    for (const Real share : {0.5, 0.9, 1.1, 2.0}) {
        DiscScene scene;
        scene.bodies = Bodies<2>(1);
        scene.bodies.inverse_mass.setConstant(1 / m);
        scene.bodies.x << 0.3, 100;
        scene.radius = VecX::Constant(1, 0.1);
        StepSettings settings;
        ImpulseMethod method;
        settings.h = h;
        method.solver.sweeps = {.max_sweeps = 100, .tolerance = 1e-13};
        StepData<2> now;
        const Lift lift{0, 0.3, 0, 1000, 1.5, share * m * g};
        add_lift(scene, lift);
        for (int n = 1; n <= 120; ++n) {
            step(scene, settings, method, now);
            const Real free = n * h * (share - 1) * g;  // at full force all the time
            const Real wanted = std::min(free, 1.5);
            REQUIRE(scene.bodies.u[1] == Approx(wanted).margin(1e-12));
            REQUIRE(scene.bodies.u[0] == 0);
            const Real lambda = now.solution.lambda[1];
            REQUIRE(lambda <= h * lift.force);
            if (free < 1.5) REQUIRE(lambda == h * lift.force);
            if (free > 1.5 + h * g * share) REQUIRE(lambda == Approx(m * g * h).epsilon(1e-12));
        }
    }
}

TEST_CASE("a lift stops at its stop and the stop carries what the motor still pushes", "[idea]")
{
    const Real h = 1.0 / 60, m = 1, g = 9.81;
    DiscScene scene;
    scene.bodies = Bodies<2>(1);
    scene.bodies.x << 0, 0.5;
    scene.radius = VecX::Constant(1, 0.1);
    StepSettings settings;
    ImpulseMethod method;
    settings.h = h;
    method.solver.sweeps = {.max_sweeps = 1000, .tolerance = 1e-13};
    StepData<2> now;
    const Lift lift{0, 0, 0, 1, 1.5, 3 * m * g};
    add_lift(scene, lift);
    for (int n = 0; n < 120; ++n) {
        step(scene, settings, method, now);
        REQUIRE(scene.bodies.x[1] <= 1 + 1e-14);
    }
    CHECK(scene.bodies.x[1] == Approx(1).epsilon(1e-14));
    CHECK(now.solution.lambda[1] == h * lift.force);
    CHECK(now.solution.lambda[3] == Approx(h * 2 * m * g).epsilon(1e-12));
    scene.joints[1].force = -2;
    CHECK(sentence_of([&] { require_valid(scene); }).find("the force of joint 1 is -2") == 0);
}

TEST_CASE("a motor brakes with its whole force what is too fast", "[idea]")
{
    Bodies<2> bodies(1);
    bodies.u << 0, 5;
    const Real h = 0.1, force = 3;
    const Row<2> row =
        motor(alignment_constraint<2>(bodies.x, world, 0, Vec2(0, 1), 0), bodies.inverse_mass, 1, force, h);
    const RowAnswer answer = solve_row(row, bodies.u);
    CHECK(answer.lambda == -h * force);
    CHECK(answer.w == Approx(5 - 1 - h * force));  // still too fast by so much
    bodies.u << 0, 1.2;
    CHECK(solve_row(row, bodies.u).lambda == Approx(-0.2));  // within its force it reaches its speed
}

TEST_CASE("a stop or rope lets a gap close and leaves what is beyond it as it is", "[idea]")
{
    Bodies<2> bodies(1);
    const Real h = 0.1;
    bodies.x << 0, 0.05;
    const auto stop = [&] {
        return one_sided(alignment_constraint<2>(bodies.x, world, 0, Vec2(0, 1), 0), bodies.inverse_mass, h);
    };
    CHECK(stop().bias == 0.05 / h);
    bodies.x << 0, -0.05;
    CHECK(stop().bias == 0);
    CHECK(stop().lo == 0);
}

TEST_CASE("a belt drags a disc with its force until it has the belt's speed", "[idea]")
{
    const Real h = 1.0 / 60, F = 3, m = 1;
    DiscScene scene = column(1);
    scene.joints = {{Joint::Kind::motor, world, 0, Vec2(1, 0), 0, 2, F}};
    StepSettings settings;
    ImpulseMethod method;
    settings.h = h;
    method.solver.sweeps = {.max_sweeps = 100, .tolerance = 1e-14};
    StepData<2> now;
    for (int n = 1; n <= 120; ++n) {
        step(scene, settings, method, now);
        REQUIRE(scene.bodies.u[0] == Approx(std::min(n * h * F / m, Real{2})).epsilon(1e-12));
        REQUIRE(scene.bodies.u[1] == 0);
    }
}

TEST_CASE("a rope lets a disc fall free until it is taut and then it only pulls", "[idea]")
{
    DiscScene scene = hanging_chain(1);
    scene.links.clear();
    scene.linked.clear();
    scene.bodies.x << 0, 0, 0, -0.3;
    scene.radius.setConstant(0.05);
    scene.joints = {{Joint::Kind::rope, 0, 1, Vec2(0, 1), 1, 0, 0}};
    StepSettings settings;
    ImpulseMethod method;
    settings.h = 1.0 / 240;
    StepData<2> now;
    bool taut = false;
    for (int n = 1; n <= 480; ++n) {
        step(scene, settings, method, now);
        const Real lambda = now.solution.lambda[now.solution.lambda.size() - 1];
        taut = taut || lambda > 0;
        REQUIRE(lambda >= 0);
        if (!taut) REQUIRE(scene.bodies.u[3] == Approx(-9.81 * n * settings.h).epsilon(1e-12));
        REQUIRE(-scene.bodies.x[3] <= 1 + 1e-12);
    }
    CHECK(taut);
    CHECK(-scene.bodies.x[3] == Approx(1).epsilon(1e-12));
    CHECK(now.solution.lambda[now.solution.lambda.size() - 1] == Approx(9.81 * settings.h).epsilon(1e-12));
}

// ---- impacts -----------------------------------------------------------------------------------------------

TEST_CASE("in Newton's cradle all at once throws all of them and one by one throws the last", "[idea]")
{
    for (const Index N : {2, 3, 4, 5, 6}) {
        std::vector<Row<2>> rows;
        const VecX inverse_mass = VecX::Ones(2 * N);
        for (Index k = 0; k + 1 < N; ++k)
            rows.push_back(unilateral(contact_constraint({k, k + 1, {1, 0}, 0}), inverse_mass));
        VecX before = VecX::Zero(2 * N);
        before[0] = 1;

        std::vector<Row<2>> biased = rows;
        newton_biases(biased, 1.0, before);
        const Mlcp mlcp = assemble(biased, before);
        const Real n = static_cast<Real>(N);
        ImpulseMemory<2> memory;
        Solution swept;
        VecX swept_u = before;
        sequential_impulse<2>(biased, {}, {.max_sweeps = 100000, .tolerance = 1e-14}, memory, swept_u, swept);
        for (const Solution& solution : {enumerate(mlcp), lemke(mlcp), swept}) {
            REQUIRE(solution.status == Status::solved);
            VecX u = before;
            apply(biased, solution.lambda, u);
            CHECK(u[0] == Approx(-(n - 2) / n).margin(1e-12));
            for (Index k = 1; k < N; ++k) CHECK(u[2 * k] == Approx(2 / n).margin(1e-12));
            CHECK(u.sum() == Approx(1).epsilon(1e-12));
            CHECK(u.squaredNorm() == Approx(1).epsilon(1e-12));
        }
        for (const bool reversed : {false, true}) {
            std::vector<Row<2>> ordered = rows;
            if (reversed) std::reverse(ordered.begin(), ordered.end());
            VecX u = before;
            Solution solution;
            sequential_impacts(ordered, 1.0, 0.0, 100, u, solution);
            CHECK(solution.status == Status::solved);
            CHECK(solution.iterations == (reversed ? N : 2));  // the last one finds nothing
            for (Index k = 0; k < N; ++k) CHECK(u[2 * k] == (k + 1 < N ? 0 : 1));
        }
    }
}

TEST_CASE("inelastic impacts in turn share the momentum at the rate of Gauss-Seidel", "[house]")
{
    // Exercise 6.5: N balls, e = 0, the first at 1 m/s.
    for (const Index N : {3, 5, 8}) {
        std::vector<Row<2>> rows;
        for (Index k = 0; k + 1 < N; ++k)
            rows.push_back(unilateral(contact_constraint({k, k + 1, {1, 0}, 0}), VecX::Ones(2 * N)));
        const auto error_after = [&](int sweeps) {
            VecX u = VecX::Zero(2 * N);
            u[0] = 1;
            Solution solution;
            sequential_impacts(rows, 0.0, 0.0, sweeps, u, solution);
            for (Index k = 0; k < N; ++k) u[2 * k] -= 1 / static_cast<Real>(N);
            return u.norm();
        };
        // After N² sweeps the second mode is gone; 1e-6 leaves room for the rounding of an error of 1e-8.
        const int sweeps = static_cast<int>(N * N);
        const Real rate = std::pow(std::cos(pi / static_cast<Real>(N)), 2);
        CHECK(std::abs(error_after(sweeps + 1) / error_after(sweeps) - rate) < 1e-6);
        CHECK(error_after(3000) < 1e-14);
    }
}

TEST_CASE("rows that part take no part in an impact and impacts in turn end at the tolerance or say so",
          "[house]")
{
    // Three balls on a line: 1 and 2 meet, 2 and 3 part.
    Bodies<2> bodies(3);
    bodies.x << 0, 0, 1, 0, 2, 0;
    const auto rows_now = [&] {
        std::vector<Row<2>> rows;
        for (Index k = 0; k < 2; ++k)
            rows.push_back(unilateral(distance_constraint(bodies.x, {k, k + 1, 1}), bodies.inverse_mass));
        return rows;
    };
    bodies.u << 1, 0, 0, 0, 2, 0;
    std::vector<Row<2>> rows = rows_now();
    newton_biases(rows, 0.5, bodies.u);
    CHECK(rows[0].bias == -0.5);
    CHECK(rows[1].bias == 0);

    VecX u = bodies.u;
    Solution solution;
    u << 1e-12, 0, 0, 0, 0, 0;
    sequential_impacts<2>(rows_now(), 1, 1e-9, 10, u, solution);
    CHECK(solution.status == Status::solved);
    CHECK(solution.lambda == VecX::Zero(2));  // 1e-12 m/s is no impact

    // With e = 0.5 the three approach each other again and again.
    u << 1, 0, 0, 0, 0, 0;
    sequential_impacts<2>(rows_now(), 0.5, 1e-9, 1, u, solution);
    CHECK(solution.status == Status::iteration_limit);
    CHECK(solution.iterations == 1);
    u << 1, 0, 0, 0, 0, 0;
    sequential_impacts<2>(rows_now(), 0.5, 1e-9, 1000, u, solution);
    CHECK(solution.status == Status::solved);
    CHECK(solution.residual <= 1e-9);
}

TEST_CASE("impacts in turn are not over while two that cannot move approach or a velocity is no number",
          "[idea]")
{
    Bodies<2> bodies(2);
    bodies.x << 0, 0, 1, 0;
    VecX u(4);
    u << 0, 0, -1, 0;
    Solution solution;
    const auto status_of = [&] {
        sequential_impacts<2>({unilateral(distance_constraint(bodies.x, {0, 1, 1}), bodies.inverse_mass)}, 1,
                              1e-9, 10, u, solution);
        return solution.status;
    };
    bodies.inverse_mass.setZero();
    CHECK(status_of() == Status::infeasible);
    CHECK(solution.residual == 1);
    CHECK(u[2] == -1);
    u[2] = 1;  // they part
    CHECK(status_of() == Status::solved);
    CHECK(solution.residual == 0);
    bodies.inverse_mass.setOnes();
    u << std::nan(""), 0, -1, 0;
    CHECK(status_of() == Status::iteration_limit);
    CHECK(std::isnan(solution.residual));
}

TEST_CASE("a swinging cradle throws as many balls as fall on it one by one and all of them at once", "[idea]")
{
    for (const Index lifted : {1, 2}) {
        for (const ImpactOrder law : {ImpactOrder::sequential, ImpactOrder::simultaneous}) {
            DiscScene scene = cradle(5, lifted, 0.5);
            const StepSettings settings{.h = 1.0 / 960};
            ImpactStep now;
            now.restitution = 1;
            now.sweeps = {.max_sweeps = 200, .tolerance = 1e-9};
            VecX highest = VecX::Zero(5);
            for (int k = 0; k < 1150; ++k) {  // half of a period and the rise: 1.2 s
                impact_step(scene, settings, law, now);
                for (Index i = 0; i < 5; ++i) {
                    const Vec2 d = scene.bodies.position(i) - scene.bodies.position(5 + i);
                    highest[i] = std::max(highest[i], std::atan2(d.x(), -d.y()));
                }
            }
            for (Index i = 0; i < 5; ++i) {
                const bool flies = i >= 5 - lifted;
                // The rods are not quite parallel at the impact, and they drift by half a millimetre.
                if (law == ImpactOrder::sequential) CHECK(highest[i] == Approx(flies ? 0.5 : 0).margin(0.01));
                else if (i > 0 && lifted == 1)
                    CHECK(highest[i] == Approx(2 * std::asin(std::sin(0.25) * 0.4)).margin(0.01));
            }
        }
    }
}

// ---- pendulum: order of convergence ---------------------------------------------------------------------

namespace {

DiscScene pendulum(Real angle)
{
    DiscScene scene = hanging_chain(1);
    scene.links[0].length = 1;
    scene.bodies.position(1) = Vec2(std::sin(angle), -std::cos(angle));
    return scene;
}

}  // namespace

TEST_CASE("the angle of a pendulum through a distance row converges with order one", "[idea]")
{
    std::vector<Real> errors;
    for (int n = 400; n <= 12800; n *= 2) {
        DiscScene scene = pendulum(pi / 2);
        StepSettings settings;
        ImpulseMethod method;
        settings.h = 1.0 / n;
        StepData<2> now;
        for (int k = 0; k < n; ++k) step(scene, settings, method, now);
        const Vec2 x = scene.bodies.position(1);
        errors.push_back(std::atan2(x.x(), -x.y()) + 1.405027311524799);
    }
    CHECK(order_of(errors) == Approx(1).margin(0.15));
    CHECK(std::abs(errors.back()) < 1e-3);
}

TEST_CASE("the period of a pendulum through a distance row converges with order one", "[idea]")
{
    for (const auto& [degrees, period] : {std::pair{10, 2.009892627298601},
                                          {60, 2.152874666880516},
                                          {90, 2.367841947576237},
                                          {120, 2.754089828887826}}) {
        std::vector<Real> errors, tensions;
        for (int n = 400; n <= 12800; n *= 2) {
            DiscScene scene = pendulum(degrees * pi / 180);
            StepSettings settings;
            ImpulseMethod method;
            settings.h = 1.0 / n;
            StepData<2> now;
            Real before = 0, tension_before = 0, part = 0;
            int k = 0;
            Limit steps(100 * n);
            do {
                before = scene.bodies.x[2];
                if (k > 0) tension_before = -now.solution.lambda[0] / settings.h;
                step(scene, settings, method, now);
                ++k;
            } while (scene.bodies.x[2] > 0 && steps.left());
            part = before / (before - scene.bodies.x[2]);  // of the step, at the bottom
            errors.push_back(4 * (k - 1 + part) * settings.h - period);
            const Real tension = -now.solution.lambda[0] / settings.h;
            tensions.push_back(tension_before + part * (tension - tension_before) -
                               9.81 * (3 - 2 * std::cos(degrees * pi / 180)));
        }
        CHECK(order_of(errors) == Approx(1).margin(0.15));
        if (degrees == 90) CHECK(order_of(tensions) == Approx(1).margin(0.15));  // 3mg at the bottom
        CHECK(std::abs(tensions.back()) < 0.05);                                 // of 10 to 39 N
    }
}

TEST_CASE("momentum and angular momentum of a tumbling chain stay to the last digits", "[idea]")
{
    for (const Order order : all_orders) {
        DiscScene scene = swinging_chain(12, 5);
        scene.bodies.inverse_mass.head<2>().setConstant(0.5);
        scene.gravity = {0, 0};
        Random random(4);
        for (Index i = 0; i < scene.bodies.u.size(); ++i) scene.bodies.u[i] = random.normal();
        const Vec2 P = momentum(scene.bodies);
        const Real L = angular_momentum(scene.bodies);
        StepSettings settings;
        ImpulseMethod method;
        settings.h = 1.0 / 240;
        method.solver.ordering = order;
        StepData<2> now;
        Real size = 0;
        for (Index k = 0; k < scene.bodies.count(); ++k)
            size += scene.bodies.velocity(k).norm() / scene.bodies.inverse_mass[2 * k];
        for (int k = 0; k < 300; ++k) step(scene, settings, method, now);
        CHECK((momentum(scene.bodies) - P).norm() < 1e-13 * size);
        // Rods and contacts push along the line of centres: no torque, whatever their length has become.
        CHECK(std::abs(angular_momentum(scene.bodies) - L) < 1e-12 * size);
    }
}

// ---- blocks ------------------------------------------------------------------------------------------------

TEST_CASE("a block of two rows has the answer of the enumeration", "[house]")
{
    Random random(11);
    for (int sample = 0; sample < 3000; ++sample) {
        Mat2 B;
        B << random.normal(), random.normal(), random.normal(), random.normal();
        const Mat2 A = B * B.transpose() + 0.01 * Mat2::Identity();
        Mlcp mlcp;
        mlcp.A = MatX(A).sparseView();
        mlcp.q.resize(2);
        for (const Index i : {1, 0}) mlcp.q[i] = random.normal();
        mlcp.lo.resize(2);
        mlcp.hi.resize(2);
        for (Index i = 0; i < 2; ++i) {
            const Index kind = random.index(4);
            mlcp.lo[i] = kind == 1 ? -infinity : kind == 2 ? -random.uniform() : 0;
            mlcp.hi[i] = kind < 2 ? infinity : random.uniform();
            if (kind == 3) mlcp.lo[i] = mlcp.hi[i];  // pinned
        }
        const Vec2 lambda = solve_block(A, mlcp.q, mlcp.lo, mlcp.hi);
        const Solution exact = enumerate(mlcp);
        REQUIRE(exact.status == Status::solved);
        // The condition of A is below 1e4 or so.
        CHECK((lambda - Vec2(exact.lambda)).norm() <= 1e-10 * (1 + exact.lambda.norm()));
    }
}

TEST_CASE("a disc in a corner and a joint of two links take one block and many rows", "[house]")
{
    std::vector<SceneRows> scenes;
    scenes.emplace_back(groove(0.1));
    scenes.emplace_back(groove(1.4));
    scenes.emplace_back(hanging_chain(2, 100));
    const int wanted[] = {1, 1, 1};
    for (std::size_t i = 0; i < scenes.size(); ++i) {
        const SceneRows& here = scenes[i];
        REQUIRE(here.rows.size() == 2);
        ImpulseMemory<2> memory;
        std::vector<Block> blocks;
        Solution by_block, by_row;
        VecX u = here.u_star, v = here.u_star;
        block_impulse<2>(here.rows, {}, {.max_sweeps = 1, .tolerance = 1e-12}, memory, blocks, u, by_block);
        CHECK(by_block.status == Status::solved);
        CHECK(by_block.iterations == wanted[i]);
        sequential_impulse<2>(here.rows, {}, {.max_sweeps = 100000, .tolerance = 1e-12}, memory, v, by_row);
        CHECK(by_row.status == Status::solved);
        CHECK(by_row.iterations > 100);
        CHECK((u - v).norm() < 1e-9);  // residual 1e-12 over the smallest eigenvalue of A, 0.005
    }
}

TEST_CASE("blocks reach the answer of the rows in every order", "[house]")
{
    for (const DiscScene& scene : {column(10), triangle(5), hanging_chain(12, 10), ten_discs()}) {
        const SceneRows here(scene);
        Random random(3);
        Colouring colouring;
        std::vector<int> order;
        ImpulseMemory<2> memory;
        Solution by_row;
        VecX u = here.u_star;
        sequential_impulse<2>(here.rows, {}, {.max_sweeps = 200000, .tolerance = 1e-11}, memory, u, by_row);
        REQUIRE(by_row.status == Status::solved);
        for (const Order kind : all_orders) {
            order_rows(here.rows, here.scene.bodies.count(), kind, random, colouring, order);
            std::vector<Block> blocks;
            Solution solution;
            VecX v = here.u_star;
            block_impulse<2>(here.rows, order, {200000, 1e-11, kind == Order::alternating}, memory, blocks, v,
                             solution);
            CHECK(solution.status == Status::solved);
            CHECK((u - v).lpNorm<Eigen::Infinity>() < 1e-8);
        }
    }
}

TEST_CASE("a block of two rows has eight digits up to the angle at which pair_rows leaves them single",
          "[house]")
{
    // Degenerate on purpose: w = 0 at a bound, so that rounding decides which guess fits, if any does.
    Random random(31);
    for (int sample = 0; sample < 20000; ++sample) {
        const Real sign = random.index(2) ? 1 : -1;
        const Real c = sign * std::sqrt(1 - std::pow(10, -random.uniform(0.1, 7.9)));
        const Real a = std::exp(random.normal()), b = std::exp(random.normal());
        const Mat2 A = (Mat2() << a * a, a * b * c, a * b * c, b * b).finished();
        Vec2 lo, hi, wanted;
        for (Index i = 0; i < 2; ++i) lo[i] = random.uniform(-1, 0);
        for (Index i = 0; i < 2; ++i) hi[i] = lo[i] + random.uniform(0, 2);
        for (Index i = 0; i < 2; ++i) wanted[i] = random.uniform(lo[i], hi[i]);
        if (random.index(2)) wanted[0] = random.index(2) ? lo[0] : hi[0];
        if (random.index(2)) wanted[1] = random.index(2) ? lo[1] : hi[1];
        const Vec2 q = -A * wanted;
        const Vec2 lambda = solve_block(A, q, lo, hi), w = A * lambda + q;
        // Cramer's rule loses the digits of 1 − c²; a row by itself, while the other is at its bound, loses none.
        const bool at_a_bound = (lambda.array() == lo.array() || lambda.array() == hi.array()).any();
        const Real lost = at_a_bound ? 1 : 1 / (1 - c * c);
        for (const Index i : {0, 1}) {
            REQUIRE(natural_residual_row(A(i, i), lambda[i], w[i], lo[i], hi[i]) <=
                    1e-14 * lost *
                        A.cwiseAbs().sum());  // some 45 roundings: λ goes to 3, w is a sum of three
            REQUIRE((lambda[i] >= lo[i] && lambda[i] <= hi[i]));
        }
    }
}

TEST_CASE("neighbours that share a body are a block unless they are one row to eight digits", "[house]")
{
    Bodies<2> bodies(2);
    const auto blocks_of = [&](Real angle, Index second) {
        const auto along = [&](Real turn, Index k) {
            return unilateral(
                alignment_constraint<2>(bodies.x, world, k, Vec2(std::cos(turn), std::sin(turn)), 0),
                bodies.inverse_mass);
        };
        const std::vector<Row<2>> rows = {along(0, 0), along(angle, second)};
        ImpulseMemory<2> memory;
        Solution solution;
        begin_sweeps<2>(rows, {}, 0, memory, bodies.u, solution);
        std::vector<Block> blocks;
        pair_rows(memory.rows, blocks);
        return blocks.size();
    };
    CHECK(blocks_of(2e-4, 0) == 1);  // 1 − cos² = 4e-8
    CHECK(blocks_of(5e-5, 0) == 2);  // 2.5e-9
    CHECK(blocks_of(0.5, 1) == 2);   // two bodies
}

TEST_CASE("two rows that say the same are not made a block", "[house]")
{
    const VecX inverse_mass = VecX::Ones(2);
    const Row<2> row = unilateral(contact_constraint({world, 0, {0, 1}, 0}), inverse_mass);
    VecX u(2);
    u << 0, -1;
    ImpulseMemory<2> memory;
    std::vector<Block> blocks;
    Solution solution;
    block_impulse<2>({row, row}, {}, {.max_sweeps = 10, .tolerance = 1e-12}, memory, blocks, u, solution);
    CHECK(blocks.size() == 2);
    CHECK(solution.status == Status::solved);
    CHECK(u.norm() == 0);
}

// ---- the order of the rows ---------------------------------------------------------------------------------

TEST_CASE("rows of one colour share no body that can move and every row has its place", "[house]")
{
    Random random(13);
    for (int sample = 0; sample < 200; ++sample) {
        const RandomRows<2> some(random, 12, 40);
        Colouring colouring;
        std::vector<int> order;
        colour_rows(some.rows, 12, colouring, order);
        std::vector<char> seen;
        CHECK(sentence_of([&] { require_order(order, some.rows.size(), seen); }) == "accepted");
        for (std::size_t c = 0; c + 1 < colouring.start.size(); ++c) {
            std::set<Index> used;
            for (int k = colouring.start[c]; k < colouring.start[c + 1]; ++k) {
                const Row<2>& row = some.rows[static_cast<std::size_t>(order[static_cast<std::size_t>(k)])];
                for (const Index body : {row.a, row.b})
                    if (body != world && some.inverse_mass[2 * body] > 0) CHECK(used.insert(body).second);
            }
        }
        CHECK(colouring.start.back() == 40);
    }
}

TEST_CASE("rows on one body that cannot move are all of one colour", "[house]")
{
    Bodies<2> bodies(11);
    bodies.inverse_mass.head<2>().setZero();
    std::vector<Row<2>> rows;
    for (Index k = 1; k < 11; ++k) {
        bodies.position(k) = Vec2(static_cast<Real>(k), 1);
        const Link link = k % 2 ? Link{k, 0, 1} : Link{0, k, 1};  // as body a, and as body b
        rows.push_back(bilateral(distance_constraint(bodies.x, link), bodies.inverse_mass));
    }
    Colouring memory;
    std::vector<int> order;
    colour_rows(rows, bodies.count(), memory, order);
    for (const int colour : memory.colour) CHECK(colour == 0);
}

TEST_CASE("columns and chains take two colours and triangles at most eleven", "[house]")
{
    const auto colours = [](const DiscScene& scene) {
        const SceneRows here(scene);
        Colouring colouring;
        std::vector<int> order;
        colour_rows(here.rows, here.scene.bodies.count(), colouring, order);
        std::set<int> used(colouring.colour.begin(), colouring.colour.end());
        return used.size();
    };
    CHECK(colours(column(30)) == 2);
    CHECK(colours(hanging_chain(30)) == 2);
    CHECK(colours(triangle(20)) == 6);  // six neighbours: 6 at least, 2 · 6 − 1 at most
}

TEST_CASE("a chain of four rows takes two or three colours by the order of its rows", "[house]")
{
    // Exercise 6.2: five bodies in a line, here from 0.
    const auto colours = [](const std::vector<Index>& first) {
        std::vector<Row<2>> rows;
        for (const Index k : first)
            rows.push_back(unilateral(contact_constraint({k, k + 1, {1, 0}, 0}), VecX::Ones(10)));
        Colouring colouring;
        std::vector<int> order;
        colour_rows(rows, 5, colouring, order);
        return 1 + *std::max_element(colouring.colour.begin(), colouring.colour.end());
    };
    CHECK(colours({0, 1, 2, 3}) == 2);
    CHECK(colours({0, 3, 2, 1}) == 3);
}

TEST_CASE("a body with more rows than there are colours still has all of them visited", "[house]")
{
    const Index m = 100;
    const VecX inverse_mass = VecX::Ones(2 * (m + 1));
    std::vector<Row<2>> rows;
    for (Index k = 1; k <= m; ++k)
        rows.push_back(unilateral(contact_constraint({0, k, {1, 0}, 0}), inverse_mass));
    Colouring colouring;
    std::vector<int> order;
    std::vector<char> seen;
    colour_rows(rows, m + 1, colouring, order);
    CHECK(sentence_of([&] { require_order(order, rows.size(), seen); }) == "accepted");
    CHECK(*std::max_element(colouring.colour.begin(), colouring.colour.end()) == Colouring::most - 1);
}

TEST_CASE("a shuffled order is the same for the same seed and another in the next step", "[house]")
{
    std::vector<int> first, second, again;
    Random random(5), same(5);
    shuffle_rows(50, random, first);
    shuffle_rows(50, random, second);
    shuffle_rows(50, same, again);
    CHECK(first == again);
    CHECK(first != second);
}

TEST_CASE("every order of the rows leads to the same velocities", "[idea]")
{
    for (const DiscScene& scene : {column(8, 10), triangle(5), hanging_chain(15), ten_discs()}) {
        VecX first;
        for (const Order order : all_orders) {
            DiscScene moved = scene;
            ImpulseMethod method = tight();
            method.solver.ordering = order;
            StepData<2> now;
            step(moved, {}, method, now);
            CHECK(now.solution.status == Status::solved);
            if (first.size() == 0) first = moved.bodies.u;
            CHECK((moved.bodies.u - first).lpNorm<Eigen::Infinity>() <
                  1e-7);  // 1e-10 over eigenvalues above 1e-3
        }
    }
}

TEST_CASE("an order that is none is refused by a sentence", "[house]")
{
    const SceneRows here(column(3));
    ImpulseMemory<2> memory;
    Solution solution;
    const auto said = [&](const std::vector<int>& order) {
        return sentence_of([&] {
            VecX u = here.u_star;
            sequential_impulse<2>(here.rows, order, {.max_sweeps = 1}, memory, u, solution);
        });
    };
    CHECK(said({0, 1, 2}) == "accepted");
    CHECK(said({0, 1}) == "the order names 2 rows; there are 3");
    CHECK(said({0, 1, 1}) == "the order names row 1 twice or out of range; it must name each row once");
    CHECK(said({0, 1, 3}) == "the order names row 3 twice or out of range; it must name each row once");
}

// ---- properties of the step ----------------------------------------------------------------------------------

namespace {

/// A heap of discs of random sizes in a box, moving.
DiscScene random_heap(Random& random)
{
    DiscScene scene;
    const Index K = 3 + random.index(8);
    scene.bodies = Bodies<2>(K);
    scene.radius.resize(K);
    for (Index k = 0; k < K; ++k) {
        const Real y = random.uniform(-0.4, 0.4), x = random.uniform(-0.4, 0.4);
        const Real uy = random.normal(), ux = random.normal();
        scene.bodies.position(k) = Vec2(x, y);
        scene.bodies.velocity(k) = Vec2(ux, uy);
        scene.bodies.inverse_mass.segment<2>(2 * k).setConstant(random.uniform(0.2, 5));
        scene.radius[k] = random.uniform(0.05, 0.15);
    }
    scene.walls = {{{1, 0}, -0.5}, {{-1, 0}, -0.5}, {{0, 1}, -0.5}, {{0, -1}, -0.5}};
    if (K > 4) scene.links.push_back({0, 1, 0.3});
    link_neighbours(scene);
    return scene;
}

VecX after_steps(DiscScene scene, const StepSettings& settings, ImpulseMethod method, int steps)
{
    StepData<2> now;
    for (int k = 0; k < steps; ++k) step(scene, settings, method, now);
    return scene.bodies.x;
}

}  // namespace

TEST_CASE("other units of mass and length and time give the same bits in those units", "[house]")
{
    Random random(21);
    for (int sample = 0; sample < 30; ++sample) {
        DiscScene scene = random_heap(random);
        scene.length = 1;
        StepSettings settings;
        ImpulseMethod method;
        method.correction.restitution = 0.5;
        method.solver.ordering = all_orders[sample % 4];
        const VecX here = after_steps(scene, settings, method, 60);
        // Powers of two round nothing.
        const Real mass = 0x1.0p7, length = 0x1.0p-3, time = 0x1.0p2;
        DiscScene other = scene;
        other.bodies.x *= length;
        other.bodies.u *= length / time;
        other.bodies.inverse_mass /= mass;
        other.radius *= length;
        for (HalfSpace& wall : other.walls) wall.offset *= length;
        for (Link& link : other.links) link.length *= length;
        other.gravity *= length / (time * time);
        other.length = length;  // in which the settings are lengths
        settings.h *= time;
        CHECK(after_steps(other, settings, method, 60) == here * length);
    }
}

TEST_CASE("a scene that is turned or seen in a mirror moves as before but turned or mirrored", "[idea]")
{
    Random random(22);
    for (int sample = 0; sample < 40; ++sample) {
        const DiscScene scene = random_heap(random);
        StepSettings settings;
        ImpulseMethod method;
        method.solver.sweeps.max_sweeps = 20;
        const Real angle = random.uniform(0, 2 * pi);
        Mat2 turn;
        turn << std::cos(angle), -std::sin(angle), std::sin(angle), std::cos(angle);
        if (sample % 2 == 1) turn.col(0) *= -1;  // and mirrored
        DiscScene other = scene;
        for (Index k = 0; k < scene.bodies.count(); ++k) {
            other.bodies.position(k) = turn * scene.bodies.position(k);
            other.bodies.velocity(k) = turn * scene.bodies.velocity(k);
        }
        for (HalfSpace& wall : other.walls) wall.normal = turn * wall.normal;
        other.gravity = turn * scene.gravity;
        const VecX here = after_steps(scene, settings, method, 5),
                   there = after_steps(other, settings, method, 5);
        // Roundings of the turned numbers, grown over five steps of impacts.
        for (Index k = 0; k < scene.bodies.count(); ++k)
            CHECK((turn * here.segment<2>(2 * k) - there.segment<2>(2 * k)).norm() < 1e-11);
    }
}

TEST_CASE("the order of the bodies does not matter to rounding", "[idea]")
{
    Random random(23);
    int compared = 0;
    for (int sample = 0; sample < 30; ++sample) {
        const DiscScene scene = random_heap(random);
        const Index K = scene.bodies.count();
        DiscScene other = scene;  // the same bodies from the last to the first
        for (Index k = 0; k < K; ++k) {
            other.bodies.position(k) = scene.bodies.position(K - 1 - k);
            other.bodies.velocity(k) = scene.bodies.velocity(K - 1 - k);
            other.bodies.inverse_mass.segment<2>(2 * k) =
                scene.bodies.inverse_mass.segment<2>(2 * (K - 1 - k));
            other.radius[k] = scene.radius[K - 1 - k];
        }
        for (Link& link : other.links) link.a = K - 1 - link.a, link.b = K - 1 - link.b;
        link_neighbours(other);
        ImpulseMethod method = tight();
        method.solver.sweeps.tolerance = 1e-12;
        const StepSettings settings{.margin = 1e-3};
        StepData<2> now, then;
        DiscScene a = scene, b = other;
        step(a, settings, method, now);
        step(b, settings, method, then);
        if (now.solution.status != Status::solved || then.solution.status != Status::solved) continue;
        ++compared;
        for (Index k = 0; k < K; ++k)  // 1e-12 over the smallest eigenvalue that counts
            CHECK((a.bodies.velocity(k) - b.bodies.velocity(K - 1 - k)).norm() < 1e-8);
    }
    CHECK(compared > 20);
}

TEST_CASE("a row turned round is the same row", "[house]")
{
    // a and b exchanged, the normal turned: the same J, and the same bits.
    Random random(24);
    for (int sample = 0; sample < 100; ++sample) {
        RandomRows<3> some(random, 5, 12);
        std::vector<Row<3>> turned = some.rows;
        for (Row<3>& row : turned)
            if (row.a != world) {
                std::swap(row.a, row.b);
                std::swap(row.Ja, row.Jb);
                std::swap(row.Wa, row.Wb);
            }
        ImpulseMemory<3> memory;
        Solution first, second;
        VecX u = some.u_star, v = some.u_star;
        sequential_impulse<3>(some.rows, {}, {.max_sweeps = 20}, memory, u, first);
        sequential_impulse<3>(turned, {}, {.max_sweeps = 20}, memory, v, second);
        CHECK(u == v);
        CHECK(first.lambda == second.lambda);
    }
}

TEST_CASE("the same run gives the same bits again in every order", "[house]")
{
    for (const Order order : all_orders) {
        Random random(25);
        const DiscScene scene = random_heap(random);
        StepSettings settings;
        ImpulseMethod method;
        method.solver.ordering = order;
        method.correction.restitution = 0.3;
        CHECK(after_steps(scene, settings, method, 300) == after_steps(scene, settings, method, 300));
    }
}

TEST_CASE("200 bad scenes are refused with a sentence or run without a NaN", "[house]")
{
    Random random(26);
    int refused = 0, ran = 0;
    for (int sample = 0; sample < 200; ++sample) {
        DiscScene scene = random_heap(random);
        const Index K = scene.bodies.count(), k = random.index(K);
        switch (sample % 10) {
        case 0:  // two centres in one point
            scene.bodies.position(k) = scene.bodies.position((k + 1) % K);
            break;
        case 1:
            scene.radius[k] = random.index(2) == 0 ? 0 : -1;
            break;
        case 2:
            scene.bodies.x[2 * k] = random.index(2) == 0 ? std::nan("") : infinity;
            break;
        case 3:
            scene.bodies.u[2 * k] = std::nan("");
            break;
        case 4:  // static against static
            scene.bodies.inverse_mass.setZero();
            break;
        case 5:
            scene.links.push_back({k, k, 0.1});
            break;
        case 6:  // 1e-12 kg beside 1 kg
            scene.bodies.inverse_mass.segment<2>(2 * k).setConstant(1e12);
            break;
        case 7:
            scene.bodies.inverse_mass[2 * k] = -1;
            break;
        case 8:  // a link between two fixed bodies, and one of no length
            scene.bodies.inverse_mass.segment<2>(2 * k).setZero();
            scene.bodies.inverse_mass.segment<2>(2 * ((k + 1) % K)).setZero();
            scene.links.push_back({k, (k + 1) % K, sample % 3 == 0 ? 0 : 0.1});
            break;
        default:  // all of them in one point, very fast
            for (Index i = 0; i < K; ++i) scene.bodies.position(i).setZero();
            scene.bodies.u *= 1e6;
        }
        link_neighbours(scene);
        StepSettings settings;
        ImpulseMethod method;
        method.solver.ordering = all_orders[sample % 4];
        method.correction.restitution = random.uniform();
        if (sentence_of([&] { require_valid(scene); }) != "accepted") {
            ++refused;
            continue;
        }
        ++ran;
        StepData<2> now;
        for (int i = 0; i < 50; ++i) {
            step(scene, settings, method, now);
            REQUIRE(scene.bodies.x.allFinite());
            REQUIRE(scene.bodies.u.allFinite());
            REQUIRE(now.solution.lambda.allFinite());
        }
    }
    CHECK(refused >= 80);
    CHECK(ran >= 80);
}

TEST_CASE("bad settings of a step are refused by a sentence and the scene stays as it was", "[house]")
{
    DiscScene scene = column(2);
    const VecX before = scene.bodies.x;
    StepData<2> now;
    const auto said = [&](const std::function<void(StepSettings&, ImpulseMethod&)>& change) {
        StepSettings settings;
        ImpulseMethod method;
        change(settings, method);
        return sentence_of([&] { step(scene, settings, method, now); });
    };
    for (const Real h : {0.0, -1.0, std::nan("")})
        CHECK(said([h](auto& s, auto&) { s.h = h; }).find("the time step h is") == 0);
    CHECK(sentence_of([] { cradle(0, 0, 0); }) ==
          "the number of balls of a cradle is 0; it must be 1 or more");
    CHECK(said([](auto&, auto& m) { m.correction.restitution = 1.5; }) ==
          "the restitution is 1.5; it must be from 0 to 1");
    CHECK(said([](auto&, auto& m) { m.correction.restitution = std::nan(""); }) != "accepted");
    CHECK(said([](auto&, auto& m) { m.correction.threshold = -1; }) ==
          "the threshold of bounces is -1; it must be zero or positive");
    CHECK(said([](auto& s, auto&) { s.margin = -0.1; }) ==
          "the margin of contacts is -0.1; it must be zero or positive");
    CHECK(said([](auto&, auto& m) { m.solver.sweeps.tolerance = std::nan(""); }) ==
          "the tolerance of the sweeps is nan; it must be zero or positive, and finite");
    CHECK(said([](auto&, auto& m) { m.solver.sweeps.tolerance = infinity; }) ==
          "the tolerance of the sweeps is inf; it must be zero or positive, and finite");
    {  // also without a step
        ImpulseSettings sweeps;
        sweeps.tolerance = infinity;
        ImpulseMemory<2> memory;
        VecX u = scene.bodies.u;
        Solution solution;
        CHECK(sentence_of([&] { sequential_impulse<2>({}, {}, sweeps, memory, u, solution); }) ==
              "the tolerance of the sweeps is inf; it must be zero or positive, and finite");
    }
    CHECK(said([](auto&, auto& m) { m.solver.sweeps.max_sweeps = -1; }) ==
          "the number of sweeps is -1; it must be zero or positive");
    scene.gravity = {0, infinity};
    CHECK(said([](auto&, auto&) {}) == "gravity is not finite");
    scene.gravity = {0, -9.81};
    CHECK(scene.bodies.x == before);
    CHECK(said([](auto&, auto&) {}) == "accepted");
}

TEST_CASE("nothing that is called solved contains a NaN", "[idea]")
{
    SceneRows here(column(3));
    for (const int part : {0, 1}) {
        std::vector<Row<2>> rows = here.rows;
        VecX u = here.u_star;
        if (part == 0) rows[1].bias = std::nan("");
        else u[1] = std::nan("");
        ImpulseMemory<2> memory;
        Solution solution;
        sequential_impulse<2>(rows, {}, {.max_sweeps = 50, .tolerance = 1e-6}, memory, u, solution);
        CHECK(solution.status != Status::solved);
    }
}

// ---- memory --------------------------------------------------------------------------------------------------

TEST_CASE("the guard against allocations notices them", "[house]")
{
    VecX grows;
    {
        const NoAllocation guard;
        grows.resize(10);
    }
    CHECK(NoAllocation::violations() >= 1);
}

TEST_CASE("a steady step allocates nothing in any order by rows or by blocks", "[house]")
{
    for (const DiscScene& start : {triangle(6), hanging_chain(20), ten_discs()}) {
        for (const Order order : all_orders) {
            DiscScene scene = start;
            StepSettings settings;
            ImpulseMethod method;
            method.solver.ordering = order;
            method.correction.restitution = 0.5;
            settings.stiffness = settings.damping = 1;
            method.solver.sweeps = {.max_sweeps = 10, .tolerance = 1e-9};
            WrongClampingMethod wrong;
            static_cast<ImpulseSolver<2>&>(wrong.solver) = method.solver;
            StepData<2> now;
            const auto both = [&] {
                scene.bodies = start.bodies;
                method.solver.in_pairs = false;
                step(scene, settings, method, now);
                scene.bodies = start.bodies;
                method.solver.in_pairs = true;
                step(scene, settings, method, now);
                scene.bodies = start.bodies;
                step(scene, settings, wrong, now);
            };
            both();
            {
                const NoAllocation guard;
                both();
            }
            CHECK(NoAllocation::violations() == 0);
        }
    }
}
