/// Chapter 4: projected Gauss-Seidel, its relatives, its rates, and where it fails.

#include "tests/no_allocation.hpp"

#include "chapters/03_mlcp_formulation/exact.hpp"
#include "chapters/03_mlcp_formulation/program/problem_file.hpp"
#include "chapters/03_mlcp_formulation/step.hpp"
#include "chapters/04_pgs/conjugate_gradients.hpp"
#include "chapters/04_pgs/pgs_method.hpp"
#include "chapters/04_pgs/rates.hpp"
#include "common/measure.hpp"
#include "common/program/scripted_pointer.hpp"
#include "common/random.hpp"

#include "tests/catch.hpp"
#include "tests/limit.hpp"
#include "tests/says.hpp"
#include "tests/sentence.hpp"

#include <Eigen/Cholesky>

#include <functional>
#include <numeric>

using namespace rigid;

namespace {

Mlcp problem(const MatX& A, const VecX& q, Real lo = 0, Real hi = infinity)
{
    Mlcp mlcp;
    mlcp.A = A.sparseView();
    mlcp.q = q;
    mlcp.lo = VecX::Constant(q.size(), lo);
    mlcp.hi = VecX::Constant(q.size(), hi);
    return mlcp;
}

/// N rows in a line, (4.8), for one step of 1/60 s.
Mlcp line(Index N, Real end_mass = 1, bool heavy_at_the_floor = false)
{
    return line_problem(N, end_mass, 9.81 / 60, heavy_at_the_floor);
}

/// Its answer by a direct solve.
VecX carried(const Mlcp& mlcp)
{
    const MatX A = mlcp.A;
    return A.ldlt().solve(-mlcp.q);
}

Real merit(const Mlcp& mlcp, const VecX& lambda)
{
    return 0.5 * lambda.dot(mlcp.A * lambda) + mlcp.q.dot(lambda);
}

/// One sweep of a kind; 0 Jacobi, 1 forward, 2 backward.
Real sweep_of(int kind, SweepRows& rows)
{
    return kind == 0 ? sweep_jacobi(rows) : kind == 1 ? sweep_forward(rows) : sweep_backward(rows);
}

/// Sweeps from zero until the largest error is `relative` of the largest λ.
int sweeps_until(const Mlcp& mlcp, Real relative, Real omega = 1, int kind = 1)
{
    const VecX exact = carried(mlcp);
    SweepRows rows;
    prepare(mlcp, omega, {}, rows);
    rows.lambda.setZero();
    int sweeps = 0;
    while ((rows.lambda - exact).lpNorm<Eigen::Infinity>() > relative * exact.lpNorm<Eigen::Infinity>()) {
        sweep_of(kind, rows);
        REQUIRE(++sweeps < 1000000);
    }
    return sweeps;
}

/// The factor by which the error shrinks in the last of so many sweeps from zero.
Real measured_rate(const Mlcp& mlcp, int sweeps, Real omega = 1, int kind = 1)
{
    const VecX exact = carried(mlcp);
    SweepRows rows;
    prepare(mlcp, omega, {}, rows);
    rows.lambda.setZero();
    Real before = 0, after = exact.norm();
    for (int k = 0; k < sweeps; ++k) {
        sweep_of(kind, rows);
        before = after;
        after = (rows.lambda - exact).norm();
    }
    return after / before;
}

/// A random symmetric problem: A = BBᵀ, B with `rank` columns; bounds of all kinds.
Mlcp random_of_rank(Random& random, Index n, Index rank)
{
    MatX B(n, rank);
    for (Index i = 0; i < B.size(); ++i) B.data()[i] = random.normal();
    VecX q(n);
    for (Index i = 0; i < n; ++i) q[i] = random.normal();
    Mlcp mlcp = problem(B * B.transpose(), q);
    for (Index i = 0; i < n; ++i) switch (random.index(4)) {
        case 0:
            break;  // contact
        case 1:
            mlcp.lo[i] = -infinity;
            break;  // joint
        case 2:
            mlcp.lo[i] = -random.uniform(), mlcp.hi[i] = random.uniform();
            break;  // motor
        default:
            mlcp.lo[i] = mlcp.hi[i] = random.uniform(-1, 1);  // pinned
        }
    return mlcp;
}

Mlcp random_symmetric(Random& random, Index n) { return random_of_rank(random, n, 1 + random.index(n + 2)); }

Mlcp random_definite(Random& random, Index n) { return random_of_rank(random, n, n + 2); }

}  // namespace

// ---- discrete identities --------------------------------------------------------------------------

TEST_CASE("two discs in a column by hand miss half as much after each sweep", "[idea]")
{
    // (4.2) and Figure 4.1: A = (1 −1; −1 2), q = (−1, 0), answer (2, 1).
    const Mlcp mlcp = problem((MatX(2, 2) << 1, -1, -1, 2).finished(), VecX(Vec2(-1, 0)));
    const Real by_hand[][2] = {{1, 0.5}, {1.5, 0.75}, {1.75, 0.875}, {1.875, 0.9375}};
    PgsSettings settings;
    settings.tolerance = 0;
    settings.max_sweeps = 0;
    for (const auto& [first, second] : by_hand) {
        ++settings.max_sweeps;
        const Solution solution = pgs(mlcp, settings);
        CHECK(solution.lambda[0] == first);  // halves and quarters: no rounding at all
        CHECK(solution.lambda[1] == second);
        CHECK(solution.iterations == settings.max_sweeps);
    }
}

TEST_CASE("the column of twenty takes the sweeps and residuals of the check in Algorithm 4.1", "[idea]")
{
    PgsMemory memory;
    Solution solution;
    const Mlcp mlcp = line(20);
    cold_start(mlcp, solution.lambda);
    pgs(mlcp, {}, memory, solution);
    CHECK(solution.status == Status::solved);
    CHECK(solution.iterations == 2690);
    CHECK(memory.checks == 22);
    CHECK(pgs(Mlcp{}).status == Status::solved);  // no rows
    CHECK(pgs(Mlcp{}).iterations == 0);
}

TEST_CASE("one visit solves a single row and clamps it to either bound", "[idea]")
{
    const auto answer = [](Real q, Real lo, Real hi) {
        return pgs(problem(MatX::Constant(1, 1, 4), VecX::Constant(1, q), lo, hi));
    };
    CHECK(answer(-2, 0, infinity).lambda[0] == 0.5);
    CHECK(answer(2, 0, infinity).lambda[0] == 0);
    CHECK(answer(2, -infinity, infinity).lambda[0] == -0.5);
    CHECK(answer(-2, -0.1, 0.25).lambda[0] == 0.25);
    CHECK(answer(-2, 0, infinity).iterations == 1);
    CHECK(answer(2, 0, infinity).iterations == 0);  // the cold start was the answer
    CHECK(answer(2, 0, infinity).status == Status::solved);
}

TEST_CASE("a free visit lowers the merit by exactly half of A times the change squared as in (4.6)",
          "[house]")
{
    Random random(3);
    for (int sample = 0; sample < 200; ++sample) {
        Mlcp mlcp = random_definite(random, 6);
        mlcp.lo.setConstant(-infinity);
        mlcp.hi.setConstant(infinity);
        SweepRows rows;
        prepare(mlcp, 1, {}, rows);
        for (Index i = 0; i < 6; ++i) rows.lambda[i] = random.normal();
        const VecX before = rows.lambda;
        const Index i = random.index(6);
        VecX after = before;
        after[i] = visit(rows, static_cast<std::size_t>(i), before.data());
        const Real change = after[i] - before[i];
        const Real fall = merit(mlcp, before) - merit(mlcp, after);
        // Rounding of merits of size up to some hundreds.
        CHECK(fall == Approx(0.5 * mlcp.A.coeff(i, i) * change * change).margin(1e-12 * 100));
    }
}

TEST_CASE("a prescaled sweep is the plain sweep to rounding", "[house]")
{
    Random random(4);
    for (int sample = 0; sample < 300; ++sample) {
        const Mlcp mlcp = random_symmetric(random, 5);
        const Real omega = random.uniform(0.1, 1.9);
        SweepRows rows;
        prepare(mlcp, omega, {}, rows);
        VecX lambda(5), before;
        for (Index i = 0; i < 5; ++i) lambda[i] = std::clamp(random.normal(), mlcp.lo[i], mlcp.hi[i]);
        rows.lambda = lambda;
        const int kind = sample % 3;
        sweep_of(kind, rows);
        if (kind == 0) sweep_jacobi(mlcp, lambda, before, omega);
        else if (kind == 1) sweep_forward(mlcp, lambda, omega);
        else sweep_backward(mlcp, lambda, omega);
        // The sums run in another order, and rows of a rank-1 A may have small diagonals.
        CHECK((rows.lambda - lambda).lpNorm<Eigen::Infinity>() <=
              1e-12 * (1 + lambda.lpNorm<Eigen::Infinity>()) * 1e2);
    }
}

TEST_CASE("a column of discs and a hanging chain assemble into (4.8) and carry (4.9)", "[house]")
{
    const Real h = 1.0 / 60;
    for (const Real mass : {1.0, 100.0}) {
        StepSettings settings;
        settings.h = h;
        settings.margin = 1e-6;
        for (const bool hanging : {false, true}) {
            DiscScene scene = hanging ? hanging_chain(7, mass) : column(7, mass);
            if (hanging) scene.linked = PairSet::all();
            StepData<2> now;
            auto method = by_matrix([](const Mlcp& mlcp) { return pgs(mlcp); });
            step(scene, settings, method, now);
            const Mlcp wanted = line_problem(7, mass, 9.81 * h);
            REQUIRE(method.solver.mlcp.size() == 7);
            // The contacts of the column come with the floor last: sort them by height.
            VecX order(7), sign = VecX::Ones(7);
            for (Index k = 0; k < 7; ++k) order[k] = static_cast<Real>(hanging ? k : (k == 0 ? 6 : k - 1));
            for (Index i = 0; i < 7; ++i) {
                const auto row = static_cast<Index>(order[i]);
                // The rods pull: their λ is negative, and so all is mirrored.
                CHECK((hanging ? -1 : 1) * method.solver.mlcp.q[row] == Approx(wanted.q[i]).margin(1e-12));
                for (Index j = 0; j < 7; ++j)
                    CHECK(method.solver.mlcp.A.coeff(row, static_cast<Index>(order[j])) ==
                          Approx(wanted.A.coeff(i, j)).margin(1e-12));
                const Real lambda = (hanging ? -1 : 1) * now.solution.lambda[row];
                CHECK(lambda ==
                      Approx(line_answer(7, mass, 9.81 * h)[i]).epsilon(1e-4));  // residual 1e-9, κ ~ 1e4
            }
        }
    }
    CHECK((line_answer(7, 3, 2) - carried(line_problem(7, 3, 2))).norm() < 1e-12 * 50);
    CHECK((line_answer(7, 3, 2, true) - carried(line_problem(7, 3, 2, true))).norm() < 1e-12 * 50);
}

// ---- why it converges ---------------------------------------------------------------------------------

TEST_CASE("the merit never rises in 1000 random symmetric problems", "[house]")
{
    Random random(9);
    for (int sample = 0; sample < 1000; ++sample) {
        const Index n = 1 + random.index(12);
        const Mlcp mlcp = random_symmetric(random, n);
        const Real omega = sample % 2 == 0 ? 1 : random.uniform(0.01, 1.99);
        SweepRows rows;
        prepare(mlcp, omega, {}, rows);
        cold_start(mlcp, rows.lambda);
        Real before = merit(mlcp, rows.lambda);
        for (int sweep = 0; sweep < 20; ++sweep) {
            sweep_of(1 + (sample / 2 + sweep) % 2, rows);
            const Real after = merit(mlcp, rows.lambda);
            const Real size = rows.lambda.cwiseAbs().dot(mlcp.A.cwiseAbs() * rows.lambda.cwiseAbs()) +
                              mlcp.q.cwiseAbs().dot(rows.lambda.cwiseAbs());
            REQUIRE(after <= before + 1e-14 * size);  // a few roundings of the sums that the merit is made of
            before = after;
        }
    }
}

TEST_CASE("Jacobi lowers the merit when relaxed by (4.17) and may raise it when not", "[house]")
{
    Random random(10);
    int raised = 0;
    for (int sample = 0; sample < 300; ++sample) {
        const Index n = 2 + random.index(8);
        const Mlcp mlcp = random_symmetric(random, n);
        for (const bool safe : {true, false}) {
            SweepRows rows;
            prepare(mlcp, safe ? 0.99 * safe_jacobi_omega(mlcp) : 1, {}, rows);
            cold_start(mlcp, rows.lambda);
            Real before = merit(mlcp, rows.lambda);
            for (int sweep = 0; sweep < 20; ++sweep) {
                sweep_jacobi(rows);
                const Real after = merit(mlcp, rows.lambda);
                const Real size = rows.lambda.cwiseAbs().dot(mlcp.A.cwiseAbs() * rows.lambda.cwiseAbs()) + 1;
                const bool rises = after > before + 1e-14 * size;
                if (safe) REQUIRE_FALSE(rises);
                raised += rises;
                before = after;
            }
        }
    }
    CHECK(raised > 100);
}

// ---- how fast: theory and measurement -----------------------------------------------------------------

TEST_CASE("Gauss-Seidel on a column of N shrinks the error by cos squared of pi over 2N a sweep", "[house]")
{
    for (const Index N : {2, 5, 10, 20}) {
        const Real c = std::cos(pi / (2 * static_cast<Real>(N)));
        CHECK(line_rate(N, 1) == Approx(c * c).epsilon(1e-14));
        // After N² sweeps the second mode, cos² 3π/2N, is below 1e-8 of the first.
        CHECK(std::abs(measured_rate(line(N), static_cast<int>(N * N) + 10) - c * c) < 1e-8);
    }
}

TEST_CASE("a sweep in which nothing is clamped multiplies the error by the matrix of (4.10a)", "[house]")
{
    // the two discs of (4.2), by hand: (2, 1) becomes (1, 1/2)
    MatX by_hand(2, 2), A(2, 2);
    A << 1, -1, -1, 2;
    by_hand << 0, 1, 0, 0.5;
    CHECK((gauss_seidel_matrix(A) - by_hand).norm() <= 1e-15);
    Random random(410);
    for (int round = 0; round < 100; ++round) {
        const Index n = 2 + round % 7;
        MatX J(n, n + 1);
        for (Index i = 0; i < J.size(); ++i) J.data()[i] = random.uniform(-1, 1);
        A = J * J.transpose();
        VecX answer(n), lambda(n);
        for (Index i = 0; i < n; ++i) answer[i] = random.uniform(-1, 1), lambda[i] = random.uniform(-1, 1);
        const Mlcp mlcp{A.sparseView(), -A * answer, VecX::Constant(n, -infinity),
                        VecX::Constant(n, infinity)};
        const MatX G = gauss_seidel_matrix(A);
        const Real small = A.diagonal().minCoeff() / A.cwiseAbs().maxCoeff();  // what a visit divides by
        for (int sweeps = 0; sweeps < 3; ++sweeps) {
            const VecX predicted = G * (lambda - answer);
            sweep_forward(mlcp, lambda);
            // rounding of some ten products, divided by the smallest diagonal entry
            CHECK((lambda - answer - predicted).norm() <= 1e-13 * (1 + lambda.norm()) / small);
        }
    }
}

TEST_CASE("sweeps for six digits on a column are 20 and 136 and 550 and 2204", "[house]")
{
    CHECK(sweeps_until(line(2), 1e-6) == 20);
    CHECK(sweeps_until(line(5), 1e-6) == 136);
    CHECK(sweeps_until(line(10), 1e-6) == 550);
    CHECK(sweeps_until(line(20), 1e-6) == 2204);
}

TEST_CASE("two discs in a column top-down are one visit behind bottom-up", "[house]")
{
    // Exercise 4.1; N s, as the table of section 4.1.
    Mlcp mlcp = problem((MatX(2, 2) << 1, -1, -1, 2).finished(), VecX(Vec2(-1, 0)));
    const std::vector<int> top_down = {1, 0};
    SweepRows rows;
    prepare(mlcp, 1, top_down, rows);
    rows.lambda.setZero();
    const VecX answer = Vec2(2, 1);
    for (int sweep = 1; sweep <= 10; ++sweep) {
        sweep_forward(rows);
        const VecX lambda = Vec2(rows.lambda[rows.place_of[0]], rows.lambda[rows.place_of[1]]);
        if (sweep == 1) CHECK(lambda == VecX(Vec2(1, 0)));
        if (sweep == 2) CHECK(lambda == VecX(Vec2(1.5, 0.5)));
        const Real part = std::pow(0.5, sweep);
        CHECK(answer - lambda ==
              VecX(Vec2(2 * part, 2 * part)));  // bottom-up it is (2, 1) times the same part
    }
}

TEST_CASE("the sweeps for six digits follow from the weight of the slowest mode as in (4.15)", "[house]")
{
    for (const Index N : {10, 20, 40}) {
        const Real theta = pi / (2 * static_cast<Real>(N));
        const Real predicted =
            (std::log(1e-6) - std::log(slowest_weight(N))) / (2 * std::log(std::cos(theta)));
        CHECK(sweeps_until(line(N), 1e-6) == std::ceil(predicted));
    }
    // The table as it is printed.
    for (const Index N : {2, 5, 10, 20}) {
        const Real theta = pi / (2 * static_cast<Real>(N)), rate = std::cos(theta) * std::cos(theta);
        const Real predicted = std::log(1e-6 / slowest_weight(N)) / std::log(rate);
        const std::string line_of_N = " | " + printed(predicted, 1) + " | " +
                                      std::to_string(sweeps_until(line(N), 1e-6)) + " | " +
                                      printed(std::log(1e-6) / std::log(rate), 1) + " |";
        INFO(line_of_N);
        CHECK(says("chapters/04_pgs/in_depth.md", line_of_N));
    }
}

TEST_CASE("a mass R on a mass 1 shrinks the error by R over 1 plus R and the reverse by 1 over 1 plus R",
          "[house]")
{
    for (const Real R : {1.0, 10.0, 100.0, 1e3, 1e4}) {
        CHECK(line_rate(2, R) == Approx(R / (1 + R)).epsilon(1e-12));
        CHECK(std::abs(measured_rate(line(2, R), 10) - R / (1 + R)) < 1e-8);
        if (R <= 100) CHECK(std::abs(measured_rate(line(2, R, true), 3) - 1 / (1 + R)) < 1e-8);
    }
    const auto sweeps = [](Real R) { return std::log(1e-6) / std::log(line_rate(2, R)); };
    CHECK(std::round(sweeps(10)) == 145);
    CHECK(std::round(sweeps(100)) == 1388);
    CHECK(std::round(sweeps(1e3)) == 13822);
    CHECK(std::round(sweeps(1e4)) == 138162);
    // Two rows: the error is one mode from the first sweep on, so the count is that of the formula or one
    // more.
    CHECK(std::abs(sweeps_until(line(2, 10), 1e-6) - sweeps(10)) < 1);
    CHECK(std::abs(sweeps_until(line(2, 1e3), 1e-6) - sweeps(1e3)) < 1);
}

TEST_CASE("forty hanging masses with a heavy end shrink the error as the reference says", "[house]")
{
    CHECK(std::abs(line_rate(40, 1) - 0.9984586669) < 1e-10);
    CHECK(std::abs(line_rate(40, 100) - 0.9997737380) < 1e-10);
    CHECK(std::abs(line_rate(40, 1e3) - 0.9999746893) < 1e-10);
    for (const Real R : {1.0, 100.0, 1e3})
        CHECK(std::abs(measured_rate(line(40, R), 2500) - line_rate(40, R)) < 1e-8);
}

TEST_CASE("Jacobi shrinks the error by the square root of the rate of Gauss-Seidel", "[house]")
{
    // ±cos θ are both modes, of equal weight but for their sign: look two sweeps back.
    for (const Index N : {5, 10}) {
        const Mlcp mlcp = line(N);
        const int k = 2 * static_cast<int>(N * N);
        const Real two = measured_rate(mlcp, k, 1, 0) * measured_rate(mlcp, k + 1, 1, 0);
        CHECK(std::abs(two - line_rate(N, 1)) < 1e-8);
    }
}

TEST_CASE("SOR shrinks the error as Young's formula says on either side of the best omega", "[house]")
{
    const Real rho = line_rate(10, 1);
    // Bilateral rows, nothing to do (q = 0) and a crooked start: λ is the error, and rounding is relative to
    // it.
    Mlcp mlcp = line(10);
    mlcp.lo.setConstant(-infinity);
    mlcp.q.setZero();
    const auto error_after = [&](Real omega, int sweeps) {
        SweepRows rows;
        prepare(mlcp, omega, {}, rows);
        for (Index k = 0; k < 10; ++k) rows.lambda[k] = static_cast<Real>(10 - k * k % 7);
        for (int k = 0; k < sweeps; ++k) sweep_forward(rows);
        return rows.lambda.norm();
    };
    // Below the best ω, 1.73, the slowest mode is real and soon alone: eight digits.
    for (const Real omega : {0.5, 0.8, 1.0, 1.3, 1.5, 1.7})
        CHECK(std::abs(error_after(omega, 501) / error_after(omega, 500) - sor_rate(omega, rho)) < 1e-8);
    // Above it all modes have the size ω − 1 and turn: the mean over many sweeps. The norm swings by a factor
    // of at most some tens, so its logarithm by 4, over 1000 sweeps.
    for (const Real omega : {1.8, 1.9})
        CHECK(std::abs(std::log(error_after(omega, 1100) / error_after(omega, 100)) / 1000 -
                       std::log(omega - 1)) < 0.004);
    CHECK(sor_rate(best_omega(rho), rho) == Approx(best_omega(rho) - 1).epsilon(1e-7));  // √ of rounding
}

TEST_CASE("sweeps grow with the square of N for Gauss-Seidel and in proportion to N for SOR and CG",
          "[house]")
{
    const auto slope = [](const std::function<Real(Index)>& count) {
        Real sx = 0, sy = 0, sxx = 0, sxy = 0;
        const std::vector<Index> sizes = {10, 20, 40, 80, 160};
        for (const Index N : sizes) {
            const Real x = std::log(static_cast<Real>(N)), y = std::log(count(N));
            sx += x, sy += y, sxx += x * x, sxy += x * y;
        }
        const auto n = static_cast<Real>(sizes.size());
        return (n * sxy - sx * sy) / (n * sxx - sx * sx);
    };
    CHECK(std::abs(slope([](Index N) { return sweeps_until(line(N), 1e-3); }) - 2) < 0.15);
    CHECK(std::abs(slope([](Index N) { return sweeps_until(line(N), 1e-3, best_omega(line_rate(N, 1))); }) -
                   1) < 0.15);
    CHECK(std::abs(slope([](Index N) {
                       Mlcp mlcp = line(N);
                       mlcp.lo.setConstant(-infinity);
                       return conjugate_gradients(mlcp, 1e-9).iterations;
                   }) -
                   1) < 0.15);
}

TEST_CASE("conjugate gradients need no more steps than there are rows", "[house]")
{
    Random random(12);
    for (int sample = 0; sample < 100; ++sample) {
        const Index n = 1 + random.index(12);
        Mlcp mlcp = random_definite(random, n);
        mlcp.lo.setConstant(-infinity);
        mlcp.hi.setConstant(infinity);
        // In exact arithmetic n steps end it; rounding of a badly conditioned A may want some more.
        const Solution solution = conjugate_gradients(mlcp, 1e-8, static_cast<int>(3 * n));
        REQUIRE(solution.status == Status::solved);
        CHECK(natural_residual(mlcp, solution.lambda) <= 1e-8);
    }
    for (const Index N : {2, 5, 20, 40}) {
        Mlcp mlcp = line(N);
        mlcp.lo.setConstant(-infinity);
        const Solution solution = conjugate_gradients(mlcp, 1e-12);
        CHECK(solution.iterations == N);
        CHECK((solution.lambda - carried(mlcp)).lpNorm<Eigen::Infinity>() < 1e-11 * carried(mlcp).maxCoeff());
    }
}

TEST_CASE("conjugate gradients refuse bounds and say singular when rows contradict each other", "[house]")
{
    Mlcp mlcp = problem((MatX(2, 2) << 1, 1, 1, 1).finished(), VecX(Vec2(-1, 1)), -infinity);
    CHECK(conjugate_gradients(mlcp).status == Status::singular);
    mlcp.q = Vec2(-1, -1);  // the same row twice: no contradiction
    const Solution twice = conjugate_gradients(mlcp);
    CHECK(twice.status == Status::solved);
    CHECK(twice.lambda.sum() == Approx(1));
    mlcp.hi[1] = 1;
    CHECK(sentence_of([&] { conjugate_gradients(mlcp); }) ==
          "row 1 has a bound; conjugate gradients take bilateral rows only");
    mlcp.hi[1] = infinity;
    mlcp.lo[1] = 0;
    CHECK(sentence_of([&] { conjugate_gradients(mlcp); }) ==
          "row 1 has a bound; conjugate gradients take bilateral rows only");
}

TEST_CASE(
    "conjugate gradients stop where the merit has no lowest point and report the residual of their answer",
    "[house]")
{
    const Mlcp apart = problem((MatX(2, 2) << 1, 1, 1, 1).finished(), VecX(Vec2(-1, 1)), -infinity);
    const Solution nothing = conjugate_gradients(apart);
    CHECK(nothing.status == Status::singular);
    CHECK(nothing.iterations == 0);  // the first direction, (1, −1), has no curvature
    for (const Index N : {5, 20, 60}) {
        Mlcp mlcp = line(N, 1e4);
        mlcp.lo.setConstant(-infinity);
        const Solution solution = conjugate_gradients(mlcp);
        CHECK(solution.residual == natural_residual(mlcp, solution.lambda));
    }
}

// ---- when to stop -------------------------------------------------------------------------------------

TEST_CASE("solved is said at the first sweep that meets the tolerance or one sweep later", "[house]")
{
    for (const Index N : {2, 5, 20})
        for (const Real omega : {0.7, 1.0, 1.5}) {
            const Mlcp mlcp = line(N);
            const Real tolerance = 1e-7;
            SweepRows rows;
            prepare(mlcp, omega, {}, rows);
            rows.lambda.setZero();
            int first = 0;
            for (Limit sweeps(100000); natural_residual(mlcp, rows.lambda) > tolerance && sweeps.left();
                 ++first)
                sweep_forward(rows);
            PgsSettings settings;
            settings.tolerance = tolerance;
            settings.omega = omega;
            PgsMemory memory;
            Solution solution;
            cold_start(mlcp, solution.lambda);
            pgs(mlcp, settings, memory, solution);
            CHECK(solution.status == Status::solved);
            CHECK(solution.iterations >= first);
            CHECK(solution.iterations <= first + 1);
            CHECK(memory.checks < 12 + 2 * std::log2(1 + solution.iterations));
        }
}

TEST_CASE("the residual that is reported is that of the answer", "[idea]")
{
    Random random(14);
    for (int sample = 0; sample < 300; ++sample) {
        const Mlcp mlcp = random_symmetric(random, 1 + random.index(10));
        PgsSettings settings;
        settings.tolerance = std::pow(10, -random.uniform(1, 9));
        settings.max_sweeps = static_cast<int>(random.index(100));
        const Solution solution = pgs(mlcp, settings);
        CHECK(solution.residual == natural_residual(mlcp, solution.lambda));
        // The residual met the tolerance, and so did w in the rows beside their bounds (3.16c).
        CHECK((solution.status == Status::solved) ==
              (solution.residual <= settings.tolerance &&
               verify(mlcp, solution.lambda, {0, settings.tolerance}).solved));
        for (Index i = 0; i < mlcp.size(); ++i) {
            CHECK(solution.lambda[i] >= mlcp.lo[i]);
            CHECK(solution.lambda[i] <= mlcp.hi[i]);
        }
    }
}

TEST_CASE("the sweeps go on to any tolerance and end by themselves where nothing changes any more", "[idea]")
{
    Random random(41);
    for (const Sweeps sweeps : {Sweeps::gauss_seidel, Sweeps::symmetric, Sweeps::jacobi})
        for (const Real omega : {0.3, 1.0, 1.6}) {
            if (sweeps == Sweeps::jacobi && omega > 1) continue;  // (4.17) allows it up to 1 here
            PgsSettings settings;
            settings.sweeps = sweeps;
            settings.omega = omega;
            for (int sample = 0; sample < 50; ++sample) {
                settings.tolerance = std::pow(10, -random.uniform(1, 10));
                CHECK(pgs(line(5), settings).status == Status::solved);
            }
        }
    // Two discs halve what is missing: after 60 sweeps no bit changes.
    PgsSettings all;
    all.tolerance = 0;
    const Solution solution = pgs(line(2), all);
    CHECK(solution.iterations < 100);
    CHECK(solution.residual < 1e-15);
}

TEST_CASE("the change that a relaxed visit reports is the velocity that its row was off by", "[house]")
{
    for (const Real omega : {0.25, 1.0, 1.75}) {
        SweepRows rows;
        prepare(problem(MatX::Constant(1, 1, 4), VecX::Constant(1, -3)), omega, {}, rows);
        for (const int kind : {0, 1, 2}) {
            rows.lambda.setZero();
            CHECK(sweep_of(kind, rows) == Approx(3).epsilon(1e-14));  // w = q = −3 m/s
            CHECK(rows.lambda[0] == Approx(omega * 0.75).epsilon(1e-14));
        }
    }
}

TEST_CASE("symmetric sweeps go forward and backward in turn", "[house]")
{
    const Mlcp mlcp = line(6);
    PgsSettings settings;
    settings.sweeps = Sweeps::symmetric;
    settings.tolerance = 0;
    SweepRows rows;
    prepare(mlcp, 1, {}, rows);
    rows.lambda.setZero();
    for (int k = 0; k < 5; ++k) {
        sweep_of(k % 2 == 0 ? 1 : 2, rows);
        settings.max_sweeps = k + 1;
        CHECK(pgs(mlcp, settings).lambda == rows.lambda);  // to the bit
    }
}

TEST_CASE("a start outside of the bounds is put within them before anything else", "[idea]")
{
    Mlcp mlcp = line(3);
    mlcp.hi.setConstant(2);
    PgsSettings settings;
    settings.max_sweeps = 0;
    PgsMemory memory;
    Solution solution;
    solution.lambda = Vec<3>(-1, 1, 7);
    pgs(mlcp, settings, memory, solution);
    CHECK(solution.lambda == VecX(Vec<3>(0, 1, 2)));
    CHECK(solution.residual == natural_residual(mlcp, solution.lambda));
}

TEST_CASE("a small change does not mean a small residual", "[house]")
{
    // Relaxed by 1/1000 a visit does a thousandth of what it should: the change tests stagnation, not
    // convergence.
    const Mlcp mlcp = line(2);
    SweepRows rows;
    prepare(mlcp, 0.001, {}, rows);
    rows.lambda.setZero();
    const VecX before = rows.lambda;
    sweep_forward(rows);
    CHECK((rows.lambda - before).lpNorm<Eigen::Infinity>() < 2e-4);
    CHECK(natural_residual(mlcp, rows.lambda) > 0.1);
    // And at rate ρ the error is still ρ/(1−ρ) times the last change: (4.16).
    const Mlcp heavy = line(2, 1e3);
    const VecX exact = carried(heavy);
    prepare(heavy, 1, {}, rows);
    rows.lambda.setZero();
    VecX last = rows.lambda;
    for (int k = 0; k < 20; ++k) last = rows.lambda, sweep_forward(rows);
    const Real ratio = (rows.lambda - exact).norm() / (rows.lambda - last).norm();
    CHECK(ratio == Approx(1000).epsilon(1e-9));  // R/(1+R) / (1 − R/(1+R)) = R
}

// ---- where it fails -----------------------------------------------------------------------------------

TEST_CASE("PGS cycles on a matrix that is not symmetric and says iteration limit", "[idea]")
{
    // (4.23): positive definite, one answer (1, 1), and yet (0, 0) → (3, 5) → (0, 0) → …
    const Mlcp mlcp = problem((MatX(2, 2) << 1, 2, -2, 1).finished(), VecX(Vec2(-3, 1)));
    CHECK(natural_residual(mlcp, VecX::Ones(2)) == 0);
    PgsSettings settings;
    settings.tolerance = 0;
    settings.max_sweeps = 1;
    CHECK(pgs(mlcp, settings).lambda == VecX(Vec2(3, 5)));
    settings.max_sweeps = 2;
    CHECK(pgs(mlcp, settings).lambda == VecX(Vec2(0, 0)));
    const Solution solution = pgs(mlcp);
    CHECK(solution.status == Status::iteration_limit);
    CHECK(solution.residual >= 1);
}

TEST_CASE("the skew example settles for omega below two thirds and not above", "[idea]")
{
    // Exercise 4.4: ω² + ω − 1 < (1 − ω)².
    const Mlcp mlcp = problem((MatX(2, 2) << 1, 2, -2, 1).finished(), VecX(Vec2(-3, 1)));
    PgsSettings settings;
    for (const Real omega : {0.3, 0.6, 0.66}) {
        settings.omega = omega;
        CHECK(pgs(mlcp, settings).status == Status::solved);
        CHECK((pgs(mlcp, settings).lambda - VecX::Ones(2)).lpNorm<Eigen::Infinity>() < 1e-8);
    }
    for (const Real omega : {0.67, 0.8, 1.5}) {
        settings.omega = omega;
        CHECK(pgs(mlcp, settings).status == Status::iteration_limit);
    }
}

TEST_CASE("red and black rows shrink the error at the rate of Gauss-Seidel", "[idea]")
{
    // Exercise 4.5: first the odd rows, then the even ones.
    for (const Index N : {5, 10, 20}) {
        const Mlcp mlcp = line(N);
        const VecX exact = carried(mlcp);
        PgsSettings settings;
        settings.tolerance = 0;
        for (const int first : {0, 1})
            for (int i = first; i < static_cast<int>(N); i += 2) settings.order.push_back(i);
        const auto error_after = [&](int sweeps) {
            settings.max_sweeps = sweeps;
            return (pgs(mlcp, settings).lambda - exact).norm();
        };
        // 2 N² sweeps: the second mode is by then below 1e-8 of the slowest.
        const int k = 2 * static_cast<int>(N * N);
        CHECK(std::abs(error_after(k + 1) / error_after(k) - line_rate(N, 1)) < 1e-7);
    }
}

TEST_CASE("keeping w up to date gives the sweeps that compute it", "[house]")
{
    // Exercise 4.3.
    Random random(45);
    for (int sample = 0; sample < 100; ++sample) {
        const Mlcp mlcp = random_definite(random, 8);
        const MatX A = mlcp.A;
        VecX lambda, kept;
        cold_start(mlcp, lambda);
        kept = lambda;
        VecX w = A * kept + mlcp.q;
        for (int sweep = 0; sweep < 20; ++sweep) {
            sweep_forward(mlcp, lambda);
            for (Index i = 0; i < 8; ++i) {
                const Real value = std::clamp(kept[i] - w[i] / A(i, i), mlcp.lo[i], mlcp.hi[i]);
                w += A.col(i) * (value - kept[i]);
                kept[i] = value;
            }
            // Rounding adds up over 20 sweeps of 8 rows.
            CHECK((kept - lambda).lpNorm<Eigen::Infinity>() < 1e-11 * (1 + lambda.lpNorm<Eigen::Infinity>()));
        }
    }
}

TEST_CASE("PGS fails on a sliding contact whose friction is a pyramid", "[idea]")
{
    MatX A(4, 4);
    A << 1, -0.9, 0.9, 0, -0.9, 1, -1, 1, 0.9, -1, 1, 1, 0.3, -1, -1, 0;
    VecX q(4);
    q << -1, 1, -1, 0;
    const Solution solution = pgs(problem(A, q));
    CHECK(solution.status == Status::iteration_limit);
    CHECK(solution.residual > 0.01);
    PgsSettings settings;
    settings.omega = 0.5;  // under-relaxation saves this one: no promise
    CHECK(pgs(problem(A, q), settings).status == Status::solved);
}

TEST_CASE("Jacobi never settles on three equal contacts and Gauss-Seidel needs one sweep", "[idea]")
{
    const Mlcp mlcp = problem(MatX::Ones(3, 3), VecX::Constant(3, -1));
    PgsSettings settings;
    settings.sweeps = Sweeps::jacobi;
    settings.max_sweeps = 1000;
    const Solution jacobi = pgs(mlcp, settings);
    CHECK(jacobi.status == Status::iteration_limit);
    CHECK(jacobi.residual >= 1);
    CHECK(pgs(mlcp).iterations == 1);
    settings.omega = safe_jacobi_omega(mlcp) * 0.9;  // 0.6, below 2/3
    CHECK(pgs(mlcp, settings).status == Status::solved);
}

TEST_CASE("an iteration that overflows is no answer and leaves finite impulses behind", "[idea]")
{
    const MatX A = MatX::Ones(3, 3) + 1e-3 * MatX::Identity(3, 3);
    PgsSettings settings;
    settings.sweeps = Sweeps::jacobi;
    settings.max_sweeps = 100000;
    const Solution solution = pgs(problem(A, VecX::Constant(3, -1), -infinity), settings);
    CHECK(solution.status == Status::iteration_limit);
    CHECK(solution.lambda.allFinite());
    CHECK(std::isfinite(solution.residual));
    CHECK(solution.residual > settings.tolerance);

    // Numbers at the edge of what a double holds.
    const Solution huge = pgs(problem(MatX::Identity(2, 2) * 1e-300, VecX::Constant(2, -1e300), 0));
    CHECK(huge.lambda.allFinite());
    CHECK((huge.status != Status::solved || huge.residual <= 1e-9));
}

TEST_CASE("nothing that PGS calls solved contains a NaN", "[idea]")
{
    Random random(15);
    const std::vector<Real> odd = {0, 1, -1, 1e-308, 1e308, -1e308, 1e-200, 1e200, 3};
    const auto any = [&] {
        return odd[static_cast<std::size_t>(random.index(static_cast<Index>(odd.size())))];
    };
    for (int sample = 0; sample < 2000; ++sample) {
        const Index n = 1 + random.index(4);
        MatX A(n, n);
        for (Index i = 0; i < A.size(); ++i) A.data()[i] = any();
        VecX q(n);
        for (Index i = 0; i < n; ++i) q[i] = any();
        Mlcp mlcp = problem(A, q, random.index(2) == 0 ? 0 : -infinity);
        PgsSettings settings;
        settings.max_sweeps = 50;
        settings.sweeps = static_cast<Sweeps>(random.index(3));
        settings.omega = random.uniform(0.1, 1.9);
        const Solution solution = pgs(mlcp, settings);
        CHECK(solution.lambda.allFinite());
        CHECK(!(solution.status == Status::solved && !(solution.residual <= settings.tolerance)));
    }
}

TEST_CASE("a row that nothing moves goes to its bound or is called infeasible", "[idea]")
{
    MatX A = MatX::Zero(2, 2);
    A(0, 0) = 2;
    Mlcp mlcp = problem(A, VecX(Vec2(-2, 3)));
    Solution solution = pgs(mlcp);  // w_1 = 3 > 0 with λ_1 = lo = 0
    CHECK(solution.status == Status::solved);
    CHECK(solution.lambda == VecX(Vec2(1, 0)));
    mlcp.hi[1] = 5;
    mlcp.q[1] = -3;  // λ_1 = hi is right
    solution = pgs(mlcp);
    CHECK(solution.status == Status::solved);
    CHECK(solution.lambda == VecX(Vec2(1, 5)));
    mlcp.hi[1] = infinity;  // λ_1 = infinity would be right
    solution = pgs(mlcp);
    CHECK(solution.status == Status::infeasible);
    CHECK(solution.lambda.allFinite());
    for (const Real noise : {0.0, -1e-12, -0.9e-9}) {  // within the tolerance of 1e-9 m/s any λ is right
        mlcp.q[1] = noise;
        CHECK(pgs(mlcp).status == Status::solved);
        CHECK(pgs(mlcp).lambda[0] == Approx(1));
    }
    mlcp.q[1] = -1.1e-9;
    CHECK(pgs(mlcp).status == Status::infeasible);
}

TEST_CASE("a pinned row stays where it is pinned and the others answer to it", "[idea]")
{
    Mlcp mlcp = line(3);
    mlcp.lo[1] = mlcp.hi[1] = 0.25;
    const Solution solution = pgs(mlcp);
    CHECK(solution.status == Status::solved);
    CHECK(solution.lambda[1] == 0.25);
    CHECK(solution.lambda[0] == Approx(0.25 + 9.81 / 60).epsilon(1e-8));
}

// ---- the ten discs ------------------------------------------------------------------------------------

namespace {

/// The ten discs, steered by the seeded pointer, with sweeps from a cold start in every step.
struct TenDiscs {
    DiscScene scene = ten_discs();
    StepSettings settings{.h = 1.0 / 480};
    PgsMethod method;
    StepData<2> now;
    PgsSettings& sweeps = method.solver.find.settings;
    PgsMemory& memory = method.solver.find.memory;
    Mlcp& mlcp = method.solver.mlcp;
    ScriptedPointer pointer{1, {{0, 0}, {0.8, 0.55}}};
    Real gravity = 9.81;
    int steps = 0, most_sweeps = 0, unsolved = 0;

    TenDiscs()
    {
        settings.stiffness = 1;
        settings.damping = 1;
        sweeps.tolerance = 1e-6;
    }
    void advance()
    {
        const Vec2 tilt = pointer.at(steps++ * settings.h).cwiseQuotient(scene.half_size);
        scene.gravity = gravity * tilt / std::max(Real{1}, tilt.norm());
        step(scene, settings, method, now);
        most_sweeps = std::max(most_sweeps, now.solution.iterations);
        unsolved += now.solution.status != Status::solved;
    }
};

}  // namespace

TEST_CASE("600 steps of the ten discs keep links and contacts to a millimetre", "[idea]")
{
    for (const Real stiffness : {0.0, 1.0, 3.0}) {
        TenDiscs run;
        run.settings.stiffness = stiffness;
        for (int k = 0; k < 600; ++k) {
            run.advance();
            if (k < 10) continue;
            REQUIRE(largest_link_error(run.scene) < 1e-3);
            REQUIRE(deepest_penetration(run.scene) < 1e-3);
        }
        CHECK(run.unsolved == 0);
        CHECK(run.most_sweeps < 1000);
    }
}

TEST_CASE("6000 steps of the ten discs keep to a millimetre too", "[idea]")
{
    TenDiscs run;  // 12.5 seconds: everything has met everything
    run.sweeps.tolerance = 1e-4;
    for (int k = 0; k < 6000; ++k) {
        run.advance();
        REQUIRE(largest_link_error(run.scene) < 1e-3);
        REQUIRE(deepest_penetration(run.scene) < 1e-3);
    }
    CHECK(run.unsolved == 0);
}

TEST_CASE("600 steps of the ten discs are the same bits when run again", "[house]")
{
    TenDiscs first, second;
    for (int k = 0; k < 600; ++k) {
        first.advance();
        second.advance();
        REQUIRE(first.scene.bodies.x == second.scene.bodies.x);
        REQUIRE(first.scene.bodies.u == second.scene.bodies.u);
    }
}

TEST_CASE("no slider of the ten discs makes a NaN", "[idea]")
{
    Random random(20);
    const auto end_or_between = [&](int corner, int bit, Real low, Real high) {
        return corner < 0 ? random.uniform(low, high) : (corner >> bit & 1 ? high : low);
    };
    for (int sample = 0; sample < 192; ++sample) {
        const int corner = sample < 128 ? sample : -1;  // all corners, then some places between
        TenDiscs run;
        run.settings.h = end_or_between(corner, 0, 1e-4, 1.0 / 120);
        run.settings.stiffness = end_or_between(corner, 1, 0, 3);
        run.settings.damping = end_or_between(corner, 2, 0, 2);
        run.sweeps.max_sweeps = static_cast<int>(end_or_between(corner, 3, 5, 300));
        run.sweeps.tolerance = std::pow(10, -end_or_between(corner, 4, 1, 12));
        run.sweeps.omega = end_or_between(corner, 5, 0.2, 1.7);
        run.gravity = end_or_between(corner, 6, 0, 20);
        if (sample % 3 == 2) run.sweeps.sweeps = Sweeps::symmetric;
        for (int k = 0; k < 600; ++k) {
            if (k % 100 == 60) {  // now and then a hand that pulls a disc across the box
                run.settings.pulled = random.index(10);
                run.settings.hand = {random.uniform(-0.8, 0.8), random.uniform(-0.55, 0.55)};
            }
            if (k % 100 == 99) run.settings.pulled = world;
            run.advance();
        }
        INFO("sample " << sample);
        CHECK(run.scene.bodies.x.allFinite());
        CHECK(run.scene.bodies.u.allFinite());
        // And nothing has left the box by more than its own size.
        CHECK(run.scene.bodies.x.lpNorm<Eigen::Infinity>() < 2);
    }
}

TEST_CASE("a heavy disc sinks into a light one by what (4.26) says", "[idea]")
{
    for (const Real R : {10.0, 100.0})
        for (const int sweeps : {5, 10, 20}) {
            DiscScene scene = column(2, R);
            PgsMethod method;
            method.solver.find.settings.tolerance = 0;
            method.solver.find.settings.max_sweeps = sweeps;
            StepSettings settings{.h = 1.0 / 60};
            StepData<2> now;
            for (int k = 0; k < 2000; ++k) step(scene, settings, method, now);
            const Real rho = R / (1 + R), gap = scene.bodies.position(1).y() - scene.bodies.position(0).y();
            const Real depth = 9.81 / 3600 * std::pow(rho, sweeps - 1) / (1 - std::pow(rho, sweeps));
            INFO("R = " << R << ", " << sweeps << " sweeps");
            // 2000 steps are many times the time in which the fall dies out: what is left is rounding.
            CHECK(scene.radius[0] + scene.radius[1] - gap == Approx(depth).epsilon(1e-6));
        }
}

TEST_CASE("the clamped rows of the ten discs are in the residual too", "[idea]")
{
    // A contact that should push but has λ = 0 is an error like any other: cold start, no sweep.
    TenDiscs run;
    for (int k = 0; k < 200; ++k) run.advance();
    Mlcp mlcp = run.mlcp;
    Index pushing = -1;
    for (Index i = 6; i < mlcp.size(); ++i)
        if (run.now.solution.lambda[i] > 1e-3) pushing = i;
    REQUIRE(pushing >= 0);
    VecX lambda = run.now.solution.lambda;
    CHECK(natural_residual(mlcp, lambda) <= 1e-6);
    lambda[pushing] = 0;
    CHECK(natural_residual(mlcp, lambda) > 1e-3);
}

TEST_CASE("a steady step of the ten discs allocates nothing", "[house]")
{
    // Steady: as many rows as in the step before, and no more entries of A than ever before.
    TenDiscs run;
    int steady = 0, allocated = 0;
    Index entries = 0;
    for (int k = 0; k < 3000; ++k) {
        const Index rows = run.mlcp.size();
        {
            const NoAllocation guard;
            run.advance();
        }
        if (k > 100 && run.mlcp.size() == rows && run.mlcp.A.nonZeros() <= entries) {
            ++steady;
            allocated += NoAllocation::violations() > 0;
        }
        entries = std::max(entries, run.mlcp.A.nonZeros());
    }
    CHECK(steady > 2000);
    CHECK(allocated == 0);
}

// ---- exact answers ------------------------------------------------------------------------------------

TEST_CASE("PGS and SOR give the checked answers of the small problems with symmetric matrices", "[idea]")
{
    for (const char* name : {"spd_s5", "column_rest_s3", "pyramid_impact_s3", "disc_chain_s2", "blcp_spd_s10",
                             "fric_boxed_s4", "mass1000_rest_s5"}) {
        const Problem known = read_problem(std::string(RIGID_SOURCE_DIR "/tests/problems/") + name + ".mlcp");
        INFO(name);
        for (const Real omega : {1.0, 1.3}) {
            PgsSettings settings;
            settings.tolerance = 1e-11;
            settings.max_sweeps = 400000;
            settings.omega = omega;
            const Solution solution = pgs(known.mlcp, settings);
            REQUIRE(solution.status == Status::solved);
            const VecX w = known.mlcp.A * solution.lambda + known.mlcp.q;
            // The answers are known to 6e-14; the error is the residual times the condition, here up to 1e5.
            CHECK((w - known.w).lpNorm<Eigen::Infinity>() < 1e-8);
            if (known.kind == Uniqueness::unique)
                CHECK((solution.lambda - known.z).lpNorm<Eigen::Infinity>() <
                      1e-5 * (1 + known.z.maxCoeff()));
        }
    }
}

TEST_CASE("PGS agrees with the enumeration of all active sets on random problems", "[idea]")
{
    Random random(21);
    for (int sample = 0; sample < 200; ++sample) {
        const Mlcp mlcp = random_definite(random, 1 + random.index(7));
        PgsSettings settings;
        settings.tolerance = 1e-12;
        settings.max_sweeps = 1000000;
        const Solution swept = pgs(mlcp, settings), exact = enumerate(mlcp);
        REQUIRE(swept.status == Status::solved);
        REQUIRE(exact.status == Status::solved);
        // The residual over the smallest eigenvalue, which is above 1e-4 here.
        CHECK((swept.lambda - exact.lambda).lpNorm<Eigen::Infinity>() < 1e-7);
    }
}

TEST_CASE("what PGS cannot promise it does not call solved", "[idea]")
{
    for (const char* name : {"fric_st_s2", "nonsym_pd_s6", "murty_exp_s6", "murty_q1_s16",
                             "circulant_ties_12", "infeasible_psd2"}) {
        const Problem known = read_problem(std::string(RIGID_SOURCE_DIR "/tests/problems/") + name + ".mlcp");
        INFO(name);
        for (const Sweeps kind : {Sweeps::gauss_seidel, Sweeps::jacobi, Sweeps::symmetric}) {
            PgsSettings settings;
            settings.sweeps = kind;
            const Solution solution = pgs(known.mlcp, settings);
            CHECK(solution.lambda.allFinite());
            CHECK((solution.status == Status::solved) ==
                  (natural_residual(known.mlcp, solution.lambda) <= 1e-9));
            if (known.kind == Uniqueness::none) CHECK(solution.status == Status::iteration_limit);
        }
    }
}

// ---- properties ---------------------------------------------------------------------------------------

TEST_CASE("every order of the rows leads to the same answer", "[idea]")
{
    Random random(16);
    for (int sample = 0; sample < 200; ++sample) {
        const Index n = 2 + random.index(8);
        const Mlcp mlcp = random_definite(random, n);
        PgsSettings settings;
        settings.tolerance = 1e-12;
        settings.max_sweeps = 1000000;
        const Solution given = pgs(mlcp, settings);
        settings.order.resize(static_cast<std::size_t>(n));
        std::iota(settings.order.rbegin(), settings.order.rend(), 0);
        const Solution reversed = pgs(mlcp, settings);
        for (std::size_t k = settings.order.size(); k-- > 1;)
            std::swap(settings.order[k],
                      settings.order[static_cast<std::size_t>(random.index(Index(k) + 1))]);
        const Solution shuffled = pgs(mlcp, settings);
        REQUIRE(given.status == Status::solved);
        REQUIRE(reversed.status == Status::solved);
        REQUIRE(shuffled.status == Status::solved);
        // A residual of 1e-12 is an error of at most that over the smallest eigenvalue of A, here above 1e-4.
        CHECK((given.lambda - reversed.lambda).lpNorm<Eigen::Infinity>() < 1e-7);
        CHECK((given.lambda - shuffled.lambda).lpNorm<Eigen::Infinity>() < 1e-7);
    }
}

TEST_CASE("renumbering the rows and visiting them in the old order is the old iteration", "[idea]")
{
    Random random(17);
    for (int sample = 0; sample < 100; ++sample) {
        const Index n = 6;
        const Mlcp mlcp = random_definite(random, n);
        std::vector<int> name(static_cast<std::size_t>(n));  // row i is now called name[i]
        std::iota(name.begin(), name.end(), 0);
        for (std::size_t k = name.size(); k-- > 1;)
            std::swap(name[k], name[static_cast<std::size_t>(random.index(Index(k) + 1))]);
        Mlcp renamed = mlcp;
        MatX A(n, n);
        for (Index i = 0; i < n; ++i) {
            const Index to = name[static_cast<std::size_t>(i)];
            for (Index j = 0; j < n; ++j) A(to, name[static_cast<std::size_t>(j)]) = mlcp.A.coeff(i, j);
            renamed.q[to] = mlcp.q[i];
            renamed.lo[to] = mlcp.lo[i];
            renamed.hi[to] = mlcp.hi[i];
        }
        renamed.A = A.sparseView();
        PgsSettings settings;
        settings.tolerance = 0;
        settings.max_sweeps = 7;
        const Solution before = pgs(mlcp, settings);
        settings.order = name;
        const Solution after = pgs(renamed, settings);
        for (Index i = 0; i < n; ++i)  // only the order of the sums differs
            CHECK(after.lambda[name[static_cast<std::size_t>(i)]] == Approx(before.lambda[i]).margin(1e-11));
    }
}

TEST_CASE("other units of mass and length give the same sweeps and the same impulses in those units",
          "[house]")
{
    Random random(18);
    for (int sample = 0; sample < 100; ++sample) {
        Mlcp mlcp = random_definite(random, 6);
        for (const bool exact : {true, false}) {
            // Powers of two round nothing: bit for bit. Others: the last digits, over some hundred sweeps.
            const Real mass = exact ? 0x1.0p10 : 453.6, length = exact ? 0x1.0p-7 : 0.3048;
            Mlcp other = mlcp;
            other.A = mlcp.A / mass;
            other.q = mlcp.q * length;
            other.lo = mlcp.lo * (mass * length);
            other.hi = mlcp.hi * (mass * length);
            PgsSettings settings;
            settings.tolerance = 1e-6;
            const Solution here = pgs(mlcp, settings);
            settings.tolerance *= length;
            const Solution there = pgs(other, settings);
            CHECK(there.status == here.status);
            const VecX back = there.lambda / (mass * length);
            if (exact) {
                CHECK(there.iterations == here.iterations);
                CHECK(back == here.lambda);
            } else {
                CHECK((back - here.lambda).norm() <= 1e-9 * (1 + here.lambda.norm()) + 1e-5);
            }
        }
    }
}

TEST_CASE("bad input of PGS is refused by a sentence", "[house]")
{
    Mlcp mlcp = line(3);
    PgsSettings settings;
    const auto said = [&] { return sentence_of([&] { pgs(mlcp, settings); }); };
    SECTION("relaxation")
    {
        settings.omega = 2;
        CHECK(said() == "the relaxation omega is 2; it must lie between 0 and 2");
        settings.omega = std::nan("");
        CHECK(said() == "the relaxation omega is nan; it must lie between 0 and 2");
    }
    SECTION("order")
    {
        settings.order = {0, 1};
        CHECK(said() == "the order names 2 rows; the problem has 3");
        settings.order = {0, 2, 2};
        CHECK(said() == "the order names row 2 twice or out of range; it must name each row once");
        settings.order = {0, 1, 3};
        CHECK(said() == "the order names row 3 twice or out of range; it must name each row once");
    }
    SECTION("tolerance")
    {
        settings.tolerance = std::nan("");
        CHECK(said() == "the tolerance of the sweeps is nan; it must be zero or positive, and finite");
        settings.tolerance = infinity;
        CHECK(said() == "the tolerance of the sweeps is inf; it must be zero or positive, and finite");
        mlcp.lo.setConstant(-infinity);
        CHECK(sentence_of([&] { conjugate_gradients(mlcp, infinity, 10); }) ==
              "the tolerance of conjugate gradients is inf; it must be zero or positive, and finite");
    }
    SECTION("start")
    {
        PgsMemory memory;
        Solution solution;
        CHECK(sentence_of([&] { pgs(mlcp, settings, memory, solution); }) ==
              "the start has 0 impulses or one that is not finite; the problem has 3 rows");
    }
    SECTION("NaN in q")
    {
        mlcp.q[1] = std::nan("");
        CHECK(said() != "accepted");
    }
    SECTION("crossed bounds")
    {
        mlcp.lo[1] = 1;
        mlcp.hi[1] = -1;
        CHECK(said() != "accepted");
    }
    SECTION("no rows at all")
    {
        mlcp = problem(MatX(0, 0), VecX(0));
        CHECK(pgs(mlcp).status == Status::solved);
        CHECK(pgs(mlcp).iterations == 0);
    }
}

TEST_CASE("the guard against allocations notices them", "[house]")
{
    VecX grows;
    std::vector<int> also;
    {
        const NoAllocation guard;
        grows.resize(10);
        also.resize(10);
    }
    CHECK(NoAllocation::violations() >= 2);
}

TEST_CASE("a steady solve allocates nothing and gives the same bits each time", "[house]")
{
    const Mlcp mlcp = line(50, 10);
    PgsSettings settings;
    settings.tolerance = 1e-6;
    settings.order.resize(50);
    std::iota(settings.order.rbegin(), settings.order.rend(), 0);
    PgsMemory memory;
    Solution solution;
    VecX first;
    for (const Sweeps kind : {Sweeps::jacobi, Sweeps::gauss_seidel, Sweeps::symmetric}) {
        settings.sweeps = kind;
        cold_start(mlcp, solution.lambda);
        pgs(mlcp, settings, memory, solution);
        first = solution.lambda;
        {
            const NoAllocation guard;
            cold_start(mlcp, solution.lambda);
            pgs(mlcp, settings, memory, solution);
        }
        CHECK(NoAllocation::violations() == 0);
        CHECK(solution.lambda == first);
    }
    Mlcp free_rows = mlcp;
    free_rows.lo.setConstant(-infinity);
    CgMemory cg;
    solution.lambda.setZero();
    conjugate_gradients(free_rows, 1e-9, 1000, cg, solution);
    {
        const NoAllocation guard;
        solution.lambda.setZero();
        conjugate_gradients(free_rows, 1e-9, 1000, cg, solution);
    }
    CHECK(NoAllocation::violations() == 0);
}

TEST_CASE("conjugate gradients do not call an impulse of 1e31 N s an answer", "[house]")
{
    // The rows contradict each other; w comes out as zero by luck and prints as (-2, 1).
    Mlcp quarrel;
    MatX A(2, 2);
    A << 4, -4, -4, 4;
    quarrel.A = A.sparseView();
    quarrel.q = VecX(2);
    quarrel.q << -2, 1;
    quarrel.lo = VecX::Constant(2, -infinity);
    quarrel.hi = VecX::Constant(2, infinity);
    CHECK(conjugate_gradients(quarrel).status == Status::singular);
    CHECK(pgs(quarrel).status == Status::iteration_limit);
}

TEST_CASE("a row with tiny entries is not one that nothing moves", "[idea]")
{
    Mlcp tiny;
    tiny.A = MatX(-1e-20 * MatX::Identity(1, 1)).sparseView(0, 0);
    tiny.q = VecX::Ones(1);
    tiny.lo = VecX::Constant(1, -infinity);
    tiny.hi = VecX::Constant(1, infinity);
    CHECK(pgs(tiny).status == Status::iteration_limit);  // λ = 1e20 would do
}
