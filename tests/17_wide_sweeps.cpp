/// Chapter 17: bundles, colours, lanes, and the sweep that makes them.

#include "tests/no_allocation.hpp"
#include "tests/wide_problems.hpp"

#include "tests/catch.hpp"

#include "chapters/12_contact_manifolds/stacks.hpp"
#include "chapters/17_wide_sweeps/brick_rows.hpp"
#include "chapters/17_wide_sweeps/line_rates.hpp"
#include "chapters/17_wide_sweeps/waits.hpp"
#include "chapters/17_wide_sweeps/wide_method.hpp"
#include "common/random.hpp"

#include <cmath>
#include <cstring>
#include <set>

using namespace rigid;

namespace {

template <int Dof, class T, int L>
void arrange_all(const std::vector<Row<Dof>>& rows, Index bodies, WideSolver<Dof, T, L>& solver)
{
    bundle_rows(rows, bodies, solver.bundles);
    colour_bundles(rows, bodies, solver.bundles);
    arrange(rows, bodies, solver.bundles, solver.wide);
}

template <int L>
void check_bits_of_chapter_6(const std::vector<Row<3>>& rows, const VecX& inverse_mass, const VecX& u,
                             const VecX& start)
{
    const Index bodies = inverse_mass.size() / 3;
    WideSolver<3, Real, L> solver;
    arrange_all(rows, bodies, solver);
    std::vector<int> order = visiting_order(solver.wide);
    ImpulseMemory<3> memory;
    Solution there;
    there.lambda = start;
    VecX u_there = u;
    sequential_impulse(rows, std::span<const int>(order), {7, 0}, memory, u_there, there);

    Bodies<3> moved(bodies);
    moved.inverse_mass = inverse_mass;
    moved.u = u;
    StepData<3> now;
    now.rows = rows;
    now.u_star = u;
    now.solution.lambda = start;
    for (int k = 0; k < bodies; ++k) now.active.push_back(k);
    solver.sweeps = {7, 0};
    solver.solve(moved, now);
    INFO(L << " lanes");
    int others = 0;  // rows that nothing moves keep what they were settled at
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const auto n = static_cast<Index>(i);
        others += rows[i].inverse_effective_mass() > 0 && !(now.solution.lambda[n] == there.lambda[n]);
    }
    CHECK(others == 0);
    CHECK((moved.u.array() == u_there.array()).all());
    CHECK(now.solution.iterations == there.iterations);
}

}  // namespace

// ------------------------------------------------------------------------------------------- bundles and colours

TEST_CASE("four rows between five bodies need two colours and wait once", "[idea]")
{
    const auto rows = line_rows(5);
    CHECK(longest_chain(rows, {}, 5) == 4);  // three waits
    const std::vector<int> coloured = {0, 2, 1, 3};
    CHECK(longest_chain(rows, std::span<const int>(coloured), 5) == 2);  // one
    Bundles bundles;
    bundle_rows(rows, 5, bundles);
    colour_bundles(rows, 5, bundles);
    CHECK(bundles.count() == 4);
    CHECK(bundles.colours == 2);
    CHECK(bundles.colour == std::vector<int>{0, 1, 0, 1});
}

TEST_CASE("all rows of a pair of bodies are one bundle whichever comes first", "[idea]")
{
    auto rows = line_rows(3);
    rows.push_back(rows[0]);
    std::swap(rows.back().a, rows.back().b);
    std::swap(rows.back().Ja, rows.back().Jb);
    std::swap(rows.back().Wa, rows.back().Wb);
    Bundles bundles;
    bundle_rows(rows, 3, bundles);
    CHECK(bundles.count() == 2);
    CHECK(bundles.of_row == std::vector<int>{0, 1, 0});
    CHECK(bundles.rows == std::vector<int>{0, 2, 1});
}

TEST_CASE("no two bundles of a colour share a body that can move", "[idea]")
{
    Random random(4);
    for (int round = 0; round < 20; ++round) {
        const Index bodies = 3 + random.index(40);
        VecX inverse_mass;
        const auto rows = random_rows(random, bodies, 1 + static_cast<int>(random.index(150)), inverse_mass);
        Bundles bundles;
        bundle_rows(rows, bodies, bundles);
        colour_bundles(rows, bodies, bundles);
        REQUIRE(bundles.of_row.size() == rows.size());
        std::set<std::pair<int, Index>> seen;
        for (std::size_t g = 0; g < bundles.count(); ++g) {
            std::set<Index> moved;
            for (int k = bundles.first[g]; k < bundles.first[g + 1]; ++k) {
                const Row<3>& row = rows[static_cast<std::size_t>(bundles.rows[static_cast<std::size_t>(k)])];
                if (row.a != world && !row.Wa.isZero(0)) moved.insert(row.a);
                if (!row.Wb.isZero(0)) moved.insert(row.b);
            }
            CHECK((bundles.colour[g] < 0) == moved.empty());
            if (bundles.colour[g] < Bundles::rest)
                for (const Index k : moved) CHECK(seen.insert({bundles.colour[g], k}).second);
        }
    }
}

TEST_CASE("a bundle of a contact with friction needs one colour where rows need four", "[idea]")
{
    const Problem p = pyramid_problem(6);
    Bundles bundles;
    bundle_rows(p.now.rows, p.scene.bodies.count(), bundles);
    colour_bundles(p.now.rows, p.scene.bodies.count(), bundles);
    Colouring rows;
    std::vector<int> order;
    colour_rows(p.now.rows, p.scene.bodies.count(), rows, order);
    CHECK(bundles.count() * 4 == p.now.rows.size());
    CHECK(bundles.colours <= 5);
    CHECK(*std::max_element(rows.colour.begin(), rows.colour.end()) + 1 >= 4 * 4);
}

TEST_CASE("bodies around a hub beyond the last colour are still solved", "[idea]")
{
    // 200 bodies on one: 63 colours and a rest of 137, one after the other
    std::vector<Row<2>> rows;
    const Index bodies = 201;
    for (Index k = 1; k < bodies; ++k) {
        Constraint<2> c;
        c.a = 0, c.b = k;
        c.Ja = {-1, 0}, c.Jb = {1, 0};
        rows.push_back(unilateral(c, VecX::Ones(2 * bodies), -1));
    }
    Bodies<2> moved(bodies);
    StepData<2> now;
    now.rows = rows;
    now.u_star = moved.u;
    for (int k = 0; k < bodies; ++k) now.active.push_back(k);
    WideSolver<2> solver;
    solver.sweeps = {100000, 1e-9};
    solver.solve(moved, now);
    CHECK(now.solution.status == Status::solved);
    // each leaves at 1 m/s of the hub, which stays by symmetry of momentum: w = 0 in each row
    for (const Row<2>& row : rows) CHECK(std::abs(row.velocity(moved.u)) < 1e-8);
    // rows between bodies change no momentum: none of what was swept was lost
    Real momentum = 0;
    for (Index k = 0; k < bodies; ++k) momentum += moved.u[2 * k];
    CHECK(std::abs(momentum) < 1e-9);
}

// ---------------------------------------------------------------------------------------------------------- lanes

TEST_CASE("lanes have the bits of chapter 6 in the same order", "[house]")
{
    const Problem p = pyramid_problem(8);
    const VecX& inverse_mass = p.scene.bodies.inverse_mass;
    check_bits_of_chapter_6<1>(p.now.rows, inverse_mass, p.now.u_star, p.now.solution.lambda);
    check_bits_of_chapter_6<2>(p.now.rows, inverse_mass, p.now.u_star, p.now.solution.lambda);
    check_bits_of_chapter_6<4>(p.now.rows, inverse_mass, p.now.u_star, p.now.solution.lambda);
    check_bits_of_chapter_6<8>(p.now.rows, inverse_mass, p.now.u_star, p.now.solution.lambda);
}

TEST_CASE("lanes have the bits of chapter 6 on rows of every kind", "[house]")
{
    Random random(8);
    for (int round = 0; round < 30; ++round) {
        const Index bodies = 12 + random.index(30);
        VecX inverse_mass;
        const auto rows = random_rows(random, bodies, 1 + static_cast<int>(random.index(90)), inverse_mass);
        VecX u(3 * bodies);
        // a body that cannot move is at rest: what it adds to b is the same sum in another order else
        for (Index i = 0; i < u.size(); ++i) u[i] = inverse_mass[i] > 0 ? random.uniform(-1, 1) : 0;
        VecX start(static_cast<Index>(rows.size()));
        for (Index i = 0; i < start.size(); ++i) start[i] = random.uniform(0, 0.2);
        check_bits_of_chapter_6<1>(rows, inverse_mass, u, start);
        check_bits_of_chapter_6<4>(rows, inverse_mass, u, start);
    }
}

template <class T>
Answer swept_by(const BrickRows& all, int threads)
{
    WideSolver<3, T> solver;
    solver.threads = threads;
    solver.sweeps = {30, 0};
    Bodies<3> bodies(all.bodies);
    bodies.inverse_mass = all.inverse_mass;
    StepData<3> now;
    now.rows = all.rows;
    now.u_star = all.u;
    for (int k = 0; k < bodies.count(); ++k) now.active.push_back(k);
    solver.solve(bodies, now);
    // else the threads would have nothing to share
    REQUIRE(solver.wide.colour_first[1] >= shared_packets);
    return {now.solution.lambda, bodies.u, now.solution.iterations};
}

TEST_CASE("a body that can move from now on is moved by wide sweeps though the rows are those of before",
          "[house]")
{
    JointedScene scene;
    add_body(scene, box(1, 1), 1, {0, 0});
    add_body(scene, box(1, 1), 1, {0, 1});
    cover(scene, {0.6, 0, 0, 0});
    const Vec<3> inverse_mass = scene.bodies.inverse_mass.head<3>();
    scene.bodies.inverse_mass.head<3>().setZero();
    WideSweeps<Manifolds> method;
    StepData<3> now;
    for (int k = 0; k < 5; ++k) step(scene, {.h = 1.0 / 60}, method, now);
    REQUIRE(now.rows.size() == 4);
    scene.bodies.inverse_mass.head<3>() = inverse_mass;
    scene.bodies.u[4] = -1;  // the upper one strikes the lower one
    JointedScene same = scene;
    WideSweeps<Manifolds> fresh = method;  // remembers λ, but no packets
    fresh.solver = {};
    fresh.solver.sweeps = method.solver.sweeps;
    StepData<3> then = now;
    step(scene, {.h = 1.0 / 60}, method, now);
    REQUIRE(now.rows.size() == 4);
    step(same, {.h = 1.0 / 60}, fresh, then);
    CHECK(scene.bodies.u == same.bodies.u);
    // one mass of the two, half the speed each
    CHECK(scene.bodies.u[1] == Approx(-0.5 - 9.81 / 60).margin(1e-2));
}

TEST_CASE("the bits do not depend on the number of threads", "[house]")
{
    const BrickRows all = brick_rows(60);
    const Answer one = swept_by<Real>(all, 1), floats = swept_by<float>(all, 1);
    for (const int threads : {2, 3, 5})
        for (int run = 0; run < 3; ++run) CHECK(same(swept_by<Real>(all, threads), one));
    CHECK(same(swept_by<float>(all, 2), floats));
}

TEST_CASE("what moves by itself and is moved by nothing is felt", "[idea]")
{
    Random random(15);
    for (int round = 0; round < 10; ++round) {
        const Index bodies = 12 + random.index(20);
        VecX inverse_mass;
        const auto rows = random_rows(random, bodies, 1 + static_cast<int>(random.index(60)), inverse_mass);
        VecX u(3 * bodies);
        for (Index i = 0; i < u.size(); ++i) u[i] = random.uniform(-1, 1);
        Bodies<3> moved(bodies);
        moved.inverse_mass = inverse_mass;
        moved.u = u;
        StepData<3> now;
        now.rows = rows;
        now.u_star = u;
        for (int k = 0; k < bodies; ++k) now.active.push_back(k);
        WideSolver<3> solver;
        solver.sweeps = {7, 0};
        solver.solve(moved, now);
        const std::vector<int> order = visiting_order(solver.wide);
        ImpulseMemory<3> memory;
        Solution there;
        VecX u_there = u;
        sequential_impulse(rows, std::span<const int>(order), {7, 0}, memory, u_there, there);
        // the same sums in another order, of numbers of size 1, seven times
        CHECK((moved.u - u_there).cwiseAbs().maxCoeff() < 1e-12);
        for (Index i = 0; i < u.size(); ++i)
            if (!(inverse_mass[i] > 0)) CHECK(moved.u[i] == u[i]);
    }
}

TEST_CASE("wide sweeps and chapter 6 agree on the answer", "[idea]")
{
    const Problem p = pyramid_problem(5);
    const Answer wide = answer(p, WideSolver<3>{}, 200000, 1e-11);
    const Answer given = answer(p, ImpulseSolver<3>{}, 200000, 1e-11);
    CHECK(wide.status == Status::solved);
    CHECK(given.status == Status::solved);
    // residuals of 1e-11 in a problem whose slowest mode shrinks by about 1e-3 a sweep
    CHECK((wide.u - given.u).cwiseAbs().maxCoeff() < 1e-7);
}

TEST_CASE("the residual of the lanes is that of the rows", "[house]")
{
    Problem p = pyramid_problem(7);
    WideSolver<3> solver;
    solver.sweeps = {3, 1e-6};
    p.now.solution.lambda.setZero();
    p.now.u_star.array() += 0.1;
    solver.solve(p.scene.bodies, p.now);
    REQUIRE(p.now.solution.residual > 1e-3);
    CHECK(wide_residual(solver.wide) == Approx(p.now.solution.residual).epsilon(1e-10));
    auto broken = solver.wide;  // in a row that many others follow
    broken.rows.front().bias = broken.rows.front().bias + std::numeric_limits<Real>::quiet_NaN();
    CHECK(std::isnan(wide_residual(broken)));
}

TEST_CASE("floats reach a residual that only doubles can have", "[idea]")
{
    const Problem p = pyramid_problem(5);
    const Answer floats = answer(p, WideSolver<3, float>{}, 200000, 1e-11);
    CHECK(floats.status == Status::solved);
    CHECK(floats.residual <= 1e-11);
    CHECK(natural_residual(p.now.rows, floats.lambda, floats.u, p.now.length) == floats.residual);
}

TEST_CASE("of floats without a tolerance the error is that of one number", "[idea]")
{
    const Problem p = pyramid_problem(8);
    const Answer exact = answer(p, WideSolver<3>{}, 20), floats = answer(p, WideSolver<3, float>{}, 20);
    // 20 sweeps, each of which rounds speeds of 0.2 m/s to 24 bits
    CHECK((floats.u - exact.u).cwiseAbs().maxCoeff() < 20 * 0.2 * std::pow(2, -23));
    // u and λ belong together to the rounding of doubles, though floats were swept
    VecX u = p.now.u_star;
    for (std::size_t i = 0; i < p.now.rows.size(); ++i)
        p.now.rows[i].apply(floats.lambda[static_cast<Index>(i)], u);
    CHECK((floats.u - u).cwiseAbs().maxCoeff() < 1e-13);
}

// ---------------------------------------------------------------------------------------------------- convergence

TEST_CASE("on a line the colours leave the error of the given order and twice its residual", "[idea]")
{
    const int N = 40;
    const LineModes modes(N, 1);
    // the slowest mode, by (17.6) to (17.9)
    for (const bool coloured : {false, true}) {
        const VecX e = coloured ? modes.coloured() : modes.given();
        const VecX after = line_sweep(e, coloured);
        CHECK((after - modes.rate() * e).cwiseAbs().maxCoeff() < 1e-14);
        const Real residual = line_residual(after).cwiseAbs().maxCoeff();
        const Real hand = coloured ? modes.residual_coloured() : modes.residual_given();
        CHECK(residual == Approx(modes.rate() * hand).epsilon(1e-9));
    }
    CHECK(modes.residual_coloured() / modes.residual_given() == Approx(2).epsilon(0.06));
}

// ------------------------------------------------------------------------------------------------ as a solver stage

TEST_CASE("a pyramid stands on wide sweeps as on those of chapter 13", "[idea]")
{
    const auto moved = [](auto method) {
        JointedScene scene;
        static_cast<RigidScene&>(scene) = box_pyramid(10);
        cover(scene, {0.6, 0, 0, 0});
        const VecX start = scene.bodies.x;
        StepData<3> now;
        for (int i = 0; i < 240; ++i) step(scene, {.h = 1.0 / 60}, method, now);
        return (scene.bodies.x - start).cwiseAbs().maxCoeff();
    };
    JointSweeps<Manifolds> given;
    given.correction = steady_contacts();
    // the slop is 5 mm, and a few steps more
    CHECK(moved(given) < 0.02);
    CHECK(moved(WideSweeps<Manifolds>{}) < 0.02);
    CHECK(moved(WideSweeps<Manifolds, float>{}) < 0.02);
    WideSweeps<Manifolds> careless;
    careless.solver.careless = true;
    CHECK(moved(careless) > 0.1);
}

TEST_CASE("bundles get other colours when the solver becomes careless though no row has changed", "[house]")
{
    JointedScene scene;
    static_cast<RigidScene&>(scene) = box_pyramid(8);
    cover(scene, {0.6, 0, 0, 0});
    WideSweeps<Manifolds> method;
    StepData<3> now;
    for (int i = 0; i < 60; ++i) step(scene, {.h = 1.0 / 60}, method, now);
    CHECK(method.solver.bundles.colours > 1);
    method.solver.careless = true;
    step(scene, {.h = 1.0 / 60}, method, now);
    CHECK(method.solver.bundles.colours == 1);
    method.solver.careless = false;
    step(scene, {.h = 1.0 / 60}, method, now);
    CHECK(method.solver.bundles.colours > 1);
}

TEST_CASE("a row that bounds more rows than a bundle holds is refused by its number", "[house]")
{
    Row<3> normal;
    normal.a = world, normal.b = 0;
    std::vector<Row<3>> rows(1 + Bundles::most_rows, normal);
    for (std::size_t i = 1; i < rows.size(); ++i) rows[i].bounded_by = 0;
    Bundles bundles;
    CHECK_THROWS_WITH(bundle_rows(rows, 1, bundles), "row 0 bounds 15 rows; in a bundle there are 15 in all");
    rows.pop_back();
    bundle_rows(rows, 1, bundles);
    CHECK(bundles.count() == 1);
}

TEST_CASE("every correction of chapter 7 runs on wide sweeps and moves bodies as chapter 6 does", "[house]")
{
    for (const Stabilizer stabilizer : {Stabilizer::none, Stabilizer::baumgarte, Stabilizer::relaxation,
                                        Stabilizer::split_impulse, Stabilizer::projection})
        for (const int substeps : {1, 4}) {
            const auto run = [&](auto method) {
                JointedScene scene;
                static_cast<RigidScene&>(scene) = box_stack(3);
                cover(scene, {0.6, 0, 0, 0});
                scene.bodies.x[4] -= 0.01;  // an overlap to be corrected
                method.correction.method = stabilizer;
                method.correction.correction_sweeps = 2000;
                method.correction.tolerance = 1e-13;
                method.solver.sweeps = {5000, 1e-12};
                StepData<3> now;
                for (int i = 0; i < 10; ++i) step(scene, {.h = 1.0 / 60, .substeps = substeps}, method, now);
                return scene.bodies.x;
            };
            JointSweeps<Manifolds> given;
            given.correction = steady_contacts();
            const VecX there = run(given);
            INFO(to_string(stabilizer) << ", " << substeps << " sub-steps");
            // residuals of 1e-12 m/s over ten steps, in a stack that is not unique in its impulses
            CHECK((run(WideSweeps<Manifolds>{}) - there).cwiseAbs().maxCoeff() < 1e-7);
            CHECK((run(WideSweeps<Manifolds, float>{}) - there).cwiseAbs().maxCoeff() < 1e-7);
        }
}

TEST_CASE("a steady wide step allocates nothing", "[house]")
{
    JointedScene scene;
    static_cast<RigidScene&>(scene) = box_pyramid(6);
    cover(scene, {0.6, 0, 0, 0});
    WideSweeps<Manifolds> method;
    WideSweeps<Manifolds, float> floats;
    StepData<3> now;
    for (int i = 0; i < 30; ++i) {
        step(scene, {.h = 1.0 / 60}, method, now);
        step(scene, {.h = 1.0 / 60}, floats, now);
    }
    const NoAllocation none;
    step(scene, {.h = 1.0 / 60}, method, now);
    step(scene, {.h = 1.0 / 60}, floats, now);
    CHECK(NoAllocation::violations() == 0);
}

TEST_CASE("a chain of visits is as long as the line in its order and as its colours in theirs", "[idea]")
{
    const auto rows = line_rows(41);
    CHECK(longest_chain(rows, {}, 41) == 40);
    WideSolver<2> solver;
    arrange_all(rows, 41, solver);
    CHECK(longest_chain(rows, std::span<const int>(visiting_order(solver.wide)), 41) == 2);

    const BrickRows bricks = brick_rows(30);
    CHECK(bricks.rows.size() == 4 * 30 * 30);
    WideSolver<3> wide;
    arrange_all(bricks.rows, bricks.bodies, wide);
    const int given = longest_chain(bricks.rows, {}, bricks.bodies);
    const int coloured =
        longest_chain(bricks.rows, std::span<const int>(visiting_order(wide.wide)), bricks.bodies);
    // four colours of four rows, and then each waits for the one before in its bundle
    CHECK(coloured == 16);
    CHECK(given > 10 * coloured);
}

TEST_CASE("a ring of bodies takes two colours or three", "[idea]")
{
    for (const Index bodies : {4, 5, 8, 11}) {
        auto rows = line_rows(bodies);
        rows.push_back(rows.back());
        rows.back().a = bodies - 1;
        rows.back().b = 0;
        WideSolver<2> solver;
        arrange_all(rows, bodies, solver);
        const int hand = bodies % 2 == 0 ? 2 : 3;
        CHECK(solver.bundles.colours == hand);
        const auto order = visiting_order(solver.wide);
        CHECK(longest_chain(rows, std::span<const int>(order), bodies) == hand);
    }
}

TEST_CASE("the chain of a column is eight visits in colours", "[idea]")
{
    // four rows between neighbours, two for friction before two for the normals
    const Index bodies = 41, N = bodies - 1;
    std::vector<Row<2>> rows;
    for (int part = 0; part < 2; ++part)
        for (const Row<2>& row : line_rows(bodies)) rows.insert(rows.end(), {row, row});
    WideSolver<2> solver;
    arrange_all(rows, bodies, solver);
    const auto order = visiting_order(solver.wide);
    CHECK(longest_chain(rows, std::span<const int>(order), bodies) == 8);
    CHECK(longest_chain(rows, {}, bodies) == 2 * N + 4);
}

TEST_CASE("a cold pyramid takes twice as many sweeps in colours", "[idea]")
{
    const BrickRows all = brick_rows(20);
    WideSolver<3> solver;
    arrange_all(all.rows, all.bodies, solver);
    const std::vector<int> coloured = visiting_order(solver.wide);
    const auto residual = [&](std::span<const int> order, int sweeps) {
        ImpulseMemory<3> memory;
        Solution solution;
        VecX u = all.u;
        sequential_impulse(all.rows, order, {sweeps, 0}, memory, u, solution);
        return natural_residual(all.rows, solution.lambda, u, 1);
    };
    // measured: 0.94, 0.97, 0.92, 0.90
    for (const int n : {10, 20, 40, 80})
        CHECK(residual(coloured, 2 * n) / residual({}, n) == Approx(0.95).margin(0.1));
}

TEST_CASE("a cold column has the same error in colours and twice the residual", "[idea]")
{
    // (4.9): λ* of row i is the weight of all above it
    const int N = 40;
    const VecX cold = VecX::LinSpaced(N, N, 1);
    VecX given = cold, coloured = cold;
    for (int n = 0; n < 160; ++n) given = line_sweep(given, false), coloured = line_sweep(coloured, true);
    CHECK(coloured.cwiseAbs().maxCoeff() / given.cwiseAbs().maxCoeff() == Approx(1).epsilon(0.08));
    CHECK(line_residual(coloured).cwiseAbs().maxCoeff() / line_residual(given).cwiseAbs().maxCoeff() ==
          Approx(2).epsilon(0.08));
}

TEST_CASE("more rows than a bundle has are cut beside what bounds them", "[house]")
{
    // contacts as a step has them: the rows of friction come before those of normals
    for (const int contacts : {7, 8, 20, 40})
        for (const int apart : {1, 2}) {  // rows of friction of each
            const int drag = apart * contacts;
            std::vector<Row<3>> rows(static_cast<std::size_t>(drag + contacts));
            for (Row<3>& row : rows) row.a = world, row.b = 1;
            for (int i = 0; i < drag; ++i) rows[static_cast<std::size_t>(i)].bounded_by = drag + i / apart;
            rows.push_back({});  // and one of another body
            rows.back().a = world, rows.back().b = 0;
            Bundles bundles;
            bundle_rows(rows, 2, bundles);
            const int most = Bundles::most_rows / (apart + 1), needed = (contacts + most - 1) / most;
            const bool is_one = static_cast<int>(rows.size()) - 1 <= Bundles::most_rows;
            CHECK(bundles.count() == (is_one ? 2U : static_cast<std::size_t>(needed + 1)));
            std::vector<int> seen(rows.size(), 0);
            for (std::size_t g = 0; g < bundles.count(); ++g) {
                REQUIRE(bundles.first[g + 1] - bundles.first[g] <= Bundles::most_rows);
                for (int k = bundles.first[g]; k < bundles.first[g + 1]; ++k) {
                    const auto i = static_cast<std::size_t>(bundles.rows[static_cast<std::size_t>(k)]);
                    ++seen[i];
                    REQUIRE(bundles.of_row[i] == static_cast<int>(g));
                    if (rows[i].bounded_by >= 0)
                        REQUIRE(bundles.of_row[static_cast<std::size_t>(rows[i].bounded_by)] ==
                                static_cast<int>(g));
                    if (k > bundles.first[g])
                        REQUIRE(bundles.rows[static_cast<std::size_t>(k - 1)] < static_cast<int>(i));
                }
            }
            CHECK(std::all_of(seen.begin(), seen.end(), [](int times) { return times == 1; }));
        }
}

TEST_CASE("what a wide sweep cannot do is refused", "[house]")
{
    WideSolver<3> solver;
    solver.threads = 0;
    CHECK_THROWS_WITH(solver.require_valid(), "the number of threads is 0; it must be 1 to 64");
    solver = {};
    solver.sweeps.alternate = true;
    CHECK_THROWS_WITH(solver.require_valid(), "wide sweeps go forwards only; alternate is on");

    auto rows = line_rows(4);
    rows[2].bounded_by = 0;
    Bundles bundles;
    bundle_rows(rows, 4, bundles);
    colour_bundles(rows, 4, bundles);
    WideRows<2, Real, 2> wide;
    CHECK_THROWS_WITH(arrange(rows, 4, bundles, wide),
                      "row 2 is bounded by row 0, which is not one of the rows between the same two bodies; "
                      "a wide sweep visits these together");
}

TEST_CASE("rows that nothing moves are settled or called infeasible", "[idea]")
{
    std::vector<Row<2>> rows = line_rows(3);
    for (Row<2>& row : rows) row.Wa.setZero(), row.Wb.setZero();
    Bodies<2> bodies(3);
    StepData<2> now;
    now.rows = rows;
    now.u_star = bodies.u;
    now.active = {0, 1, 2};
    WideSolver<2> solver;
    solver.sweeps = {10, 1e-9};
    solver.solve(bodies, now);
    CHECK(now.solution.status == Status::solved);
    now.rows[1].bias = 1;
    solver.solve(bodies, now);
    CHECK(now.solution.status == Status::infeasible);
    now.rows[1].softness = 2;  // it gives way instead
    solver.solve(bodies, now);
    CHECK(now.solution.status == Status::solved);
    CHECK(now.solution.lambda[1] == Approx(-0.5));
}
