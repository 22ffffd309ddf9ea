/// Chapter 5: Lemke's algorithm. The walk on problems whose pivots are known, the answers against chapter 3's
/// enumeration and against closed forms, and a search for problems that it gets wrong.

#include "chapters/03_mlcp_formulation/exact.hpp"
#include "chapters/03_mlcp_formulation/program/problem_file.hpp"
#include "chapters/05_lemke/families.hpp"
#include "chapters/05_lemke/lemke.hpp"
#include "chapters/05_lemke/stewart_trinkle.hpp"

#include "tests/catch.hpp"
#include "tests/eigenvalues.hpp"
#include "tests/limit.hpp"
#include "tests/random_problems.hpp"
#include "tests/says.hpp"
#include "tests/sentence.hpp"

#include <functional>
#include <map>
#include <set>

using namespace rigid;

namespace {

constexpr Real identity = 1e-12;  // rounding of a few pivots on numbers of size one

Solution with_ties(const Mlcp& mlcp, TieRule ties, int pivot_limit = 0)
{
    LemkeSettings settings;
    settings.ties = ties;
    settings.pivot_limit = pivot_limit;
    return lemke(mlcp, settings);
}

Mlcp random_spd_problem()
{
    Random random(5);
    return random_spd(3, random);
}

int pivots(const Mlcp& mlcp, TieRule ties)
{
    const Solution solution = with_ties(mlcp, ties);
    REQUIRE(solution.status == Status::solved);
    return solution.iterations;
}

}  // namespace

// ---- the tableau and the walk ---------------------------------------------------------------------------

TEST_CASE("the two contacts of the text take three pivots through the tableaus of the text", "[house]")
{
    // Section 5.2: w1 = 2 z1 + z2 - 5, w2 = z1 + 2 z2 - 6.
    LemkeWalk walk(matrix2(2, 1, 1, 2), vector({-5, -6}), vector({1, 1}), TieRule::lexicographic);
    walk.step();  // z0 enters, w2 leaves
    CHECK(walk.tableau.value(walk.tableau.artificial()) == 6);
    CHECK(walk.tableau.value(2) == 1);  // w1
    CHECK(walk.entering == 1);          // z2
    walk.step();                        // z2 enters, w1 leaves
    CHECK(walk.tableau.value(1) == 1);
    CHECK(walk.tableau.value(walk.tableau.artificial()) == 4);
    CHECK(walk.entering == 0);  // z1
    walk.step();                // z1 enters, z0 leaves
    CHECK(walk.place == LemkeWalk::Place::solution);
    CHECK(walk.pivots == 3);
    // Numbers with thirds in them: a few roundings.
    CHECK(walk.z()[0] == Approx(4.0 / 3).epsilon(1e-15));
    CHECK(walk.z()[1] == Approx(7.0 / 3).epsilon(1e-15));
}

TEST_CASE("the problem of section 5.1 and those of the check in Algorithm 5.1 take the pivots of the text",
          "[idea]")
{
    const Solution corner = lemke(plain_lcp(matrix2(2, 1, 1, 2), vector({-5, -6})));
    CHECK(corner.status == Status::solved);
    CHECK(corner.iterations == 3);
    CHECK((corner.lambda - vector({4.0 / 3, 7.0 / 3})).cwiseAbs().maxCoeff() < identity);
    CHECK(lemke(circulant(3)).iterations == 4);
    for (Index n = 2; n <= 8; ++n) CHECK(lemke(murty(n)).iterations == 1 << n);
    CHECK(lemke(Mlcp{}).status == Status::solved);  // no rows, no pivots
    CHECK(lemke(Mlcp{}).iterations == 0);
}

TEST_CASE("the motor and the joint of the text take three and two pivots", "[idea]")
{
    Mlcp motor = plain_lcp(MatX::Constant(1, 1, 2), vector({-5}));
    motor.hi[0] = 2;
    const Solution full = lemke(motor);
    CHECK(full.status == Status::solved);
    CHECK(full.iterations == 3);
    CHECK(full.lambda[0] == Approx(2).epsilon(identity));
    Mlcp joint = plain_lcp(matrix2(2, 1, 1, 2), vector({-5, -6}));
    joint.lo[0] = -infinity;
    const Solution both = lemke(joint);
    CHECK(both.status == Status::solved);
    CHECK(both.iterations == 2);
    CHECK((both.lambda - vector({4.0 / 3, 7.0 / 3})).cwiseAbs().maxCoeff() < identity);
}

TEST_CASE("the exercises with two rows come out as their solutions say", "[idea]")
{
    const Solution first = lemke(plain_lcp(matrix2(2, 1, 1, 2), vector({-5, 1})));  // exercise 5.1
    CHECK(first.status == Status::solved);
    CHECK(first.iterations == 2);
    CHECK((first.lambda - vector({2.5, 0})).cwiseAbs().maxCoeff() < identity);
    const Mlcp overlap = plain_lcp(matrix2(2, 3, 3, 2), vector({-5, -6}));  // exercise 5.3
    for (const VecX& answer : {vector({2.5, 0}), vector({0, 3}), vector({1.6, 0.6})})
        CHECK(natural_residual(overlap, answer) < identity);
    const Solution found = lemke(overlap);
    CHECK(found.status == Status::solved);
    CHECK(found.iterations == 2);
    CHECK((found.lambda - vector({0, 3})).cwiseAbs().maxCoeff() < identity);
}

TEST_CASE("each vertex of the walk satisfies w = A z + q + d z0 and misses exactly one pair", "[house]")
{
    Random random(1);
    for (int sample = 0; sample < 100; ++sample) {
        const Index n = 2 + random.index(12);
        const MatX A = random_matrix(Kind::positive_real, n, random);
        const VecX q = gaussian(n, 1, random), d = VecX::LinSpaced(n, 1, 3);
        LemkeWalk walk(A, q, d, TieRule::lexicographic);
        for (Limit pivots(10000); walk.place == LemkeWalk::Place::on_the_way && pivots.left();) {
            walk.step();
            const Tableau& tableau = walk.tableau;
            VecX z(n), w(n);
            int missing = 0;
            for (Index i = 0; i < n; ++i) {
                z[i] = tableau.value(i);
                w[i] = tableau.value(n + i);
                CHECK_FALSE((tableau.is_basic(i) && tableau.is_basic(n + i)));
                missing += !tableau.is_basic(i) && !tableau.is_basic(n + i);
            }
            CHECK(missing == (tableau.is_basic(tableau.artificial()) ? 1 : 0));
            const Real size = 1 + z.cwiseAbs().maxCoeff();
            CHECK((w - A * z - q - d * tableau.value(tableau.artificial())).cwiseAbs().maxCoeff() <=
                  identity * static_cast<Real>(n) * size);
            CHECK(tableau.values().minCoeff() >= -identity * size);  // it is a vertex: nothing is negative
        }
    }
}

TEST_CASE("a pivot undoes itself", "[house]")
{
    Random random(2);
    const Index n = 7;
    const VecX q = gaussian(n, 1, random);
    const Tableau start(random_matrix(Kind::spd, n, random), q, VecX::Ones(n));
    Tableau tableau = start;
    for (Index p = 0; p < n; ++p)
        for (Index c = 0; c <= n; ++c) {
            if (std::abs(tableau.column(c)[p]) < 0.05) continue;  // a tiny pivot would multiply the rounding
            tableau.pivot(p, c);
            tableau.pivot(p, c);
            REQUIRE(tableau.basic == start.basic);
            REQUIRE(tableau.nonbasic == start.nonbasic);
        }
    CHECK((tableau.entries() - start.entries()).cwiseAbs().maxCoeff() <
          1e-10);  // a hundred pivots with 1/0.05² each at worst
}

TEST_CASE("the tableau stores n + 2 columns and no unit columns", "[house]")
{
    const Tableau tableau(MatX::Identity(5, 5), -VecX::Ones(5), VecX::Ones(5));
    CHECK(tableau.entries().rows() == 5);
    CHECK(tableau.entries().cols() == 7);
}

TEST_CASE("columns that are not needed are left alone and the answer has the same bits", "[house]")
{
    Random random(4);
    const Index n = 60;
    std::vector<Mlcp> problems = {random_spd(n, random), tridiagonal(VecX::Constant(n, -1)),
                                  stewart_trinkle(BoxStack{})};
    for (const Mlcp& problem : problems) {
        const auto start = [&] {
            return LemkeWalk(MatX(problem.A), problem.q, VecX::Ones(problem.size()), TieRule::lexicographic);
        };
        LemkeWalk lazy = start(), eager = start();
        Limit pivots(20000);
        while (lazy.place == LemkeWalk::Place::on_the_way && pivots.left()) lazy.step();
        while (eager.place == LemkeWalk::Place::on_the_way && pivots.left()) {
            eager.step();
            eager.tableau.entries();  // looks at everything
        }
        CHECK(lazy.pivots == eager.pivots);
        CHECK(lazy.z() == eager.z());
        CHECK(lazy.tableau.column_updates < eager.tableau.column_updates);
        CHECK(eager.tableau.column_updates <= lazy.pivots * (problem.size() + 2));
        CHECK(lazy.tableau.entries() == eager.tableau.entries());
    }
    LemkeWalk half(MatX(problems[0].A), problems[0].q, VecX::Ones(n), TieRule::lexicographic);
    for (Limit pivots(10000); half.place == LemkeWalk::Place::on_the_way && pivots.left();) half.step();
    // About half of the z enter, and each has to see about half of the pivots.
    CHECK(half.tableau.column_updates < half.pivots * (n + 2) / 2);
}

TEST_CASE("nothing is pivoted where q is not negative", "[idea]")
{
    const Solution solution = lemke(plain_lcp(MatX::Identity(4, 4), vector({0, 1, 2, 0})));
    CHECK(solution.status == Status::solved);
    CHECK(solution.iterations == 0);
    CHECK(solution.lambda.isZero(0));
    CHECK(lemke(plain_lcp(MatX(0, 0), VecX(0))).status == Status::solved);
}

// ---- what the textbooks know ----------------------------------------------------------------------------

TEST_CASE("Murty's exponential family takes exactly 2^n pivots whatever the tie rule", "[idea]")
{
    for (const TieRule ties : {TieRule::lexicographic, TieRule::first_row, TieRule::last_row})
        for (Index n = 1; n <= 12; ++n) {
            const Solution solution = with_ties(murty(n), ties);
            REQUIRE(solution.status == Status::solved);
            CHECK(solution.iterations == 1 << n);
            VecX z = VecX::Zero(n);
            z[n - 1] = static_cast<Real>(1 << n);
            CHECK(solution.lambda == z);  // whole numbers below 2^53: no rounding at all
        }
}

TEST_CASE("the transpose of Murty's matrix takes 2^n or 2n or 2 pivots by the tie rule alone", "[idea]")
{
    for (Index n = 2; n <= 12; ++n) {
        CHECK(pivots(murty_transposed(n), TieRule::lexicographic) == 1 << n);
        CHECK(pivots(murty_transposed(n), TieRule::first_row) == 2);
        CHECK(pivots(murty_transposed(n), TieRule::last_row) == 2 * n);
        CHECK((lemke(murty_transposed(n)).lambda - VecX::Unit(n, 0)).isZero(0));
    }
}

TEST_CASE("Murty's matrix with equal q takes two pivots", "[idea]")
{
    for (Index n = 2; n <= 20; ++n) CHECK(pivots(murty_equal(n), TieRule::lexicographic) == 2);
}

TEST_CASE("Fathi's symmetric positive definite family behaves as the transpose does", "[idea]")
{
    for (Index n = 2; n <= 12; ++n) {
        CHECK(pivots(fathi(n), TieRule::lexicographic) == 1 << n);  // exact only with a sound tie tolerance
        CHECK(pivots(fathi(n), TieRule::first_row) == 2);
        CHECK(pivots(fathi(n), TieRule::last_row) == 2 * n);
        // 2^n pivots on numbers like 4n leave their rounding.
        CHECK((lemke(fathi(n)).lambda - VecX::Unit(n, 0)).cwiseAbs().maxCoeff() < 1e-10);
        CHECK(symmetric_eigenvalues(fathi(n).A).minCoeff() > 0);
    }
}

TEST_CASE("thirty rows of Fathi's family would take 2^30 pivots and end at the pivot limit", "[idea]")
{
    const Solution solution = lemke(fathi(30));
    CHECK(solution.status == Status::iteration_limit);
    CHECK(solution.iterations == 10000 + 50 * 30);
    CHECK(solution.residual > 1e-8);
    CHECK(solution.residual == Approx(natural_residual(fathi(30), solution.lambda)));
    CHECK(with_ties(fathi(30), TieRule::first_row).status == Status::solved);
}

TEST_CASE("the pivots of the exponential family double with each row and those of a column grow by one",
          "[idea]")
{
    // The observed order: log2 of the ratio from n to n + 1, and the slope of log pivots over log n.
    for (Index n = 4; n < 12; ++n) {
        const Real ratio = static_cast<Real>(pivots(murty(n + 1), TieRule::lexicographic)) /
                           pivots(murty(n), TieRule::lexicographic);
        CHECK(std::log2(ratio) == Approx(1).margin(0.15));
    }
    const auto column_pivots = [](Index n) {
        return pivots(tridiagonal(VecX::Constant(n, -1)), TieRule::lexicographic);
    };
    for (Index n = 8; n <= 128; n *= 2)
        CHECK(std::log2(static_cast<Real>(column_pivots(2 * n)) / column_pivots(n)) ==
              Approx(1).margin(0.15));
}

TEST_CASE("tridiagonal Z-matrices take at most n + 1 pivots", "[idea]")
{
    Random random(3);
    for (int sample = 0; sample < 300; ++sample) {
        const Index n = 1 + random.index(60);
        CHECK(pivots(tridiagonal(gaussian(n, 1, random)), TieRule::lexicographic) <= n + 1);
    }
}

TEST_CASE("where all ratios tie the lexicographic rule ends and the first row cycles", "[house]")
{
    for (Index n = 3; n <= 20; ++n) {
        const Solution solution = lemke(circulant(n));
        CHECK(solution.status == Status::solved);
        CHECK(solution.iterations <= 2 * n);
    }
    // Three rows, first row first: a vertex comes back, so it would walk forever; the limit stops it.
    const Mlcp problem = circulant(3);
    LemkeWalk walk(MatX(problem.A), problem.q, VecX::Ones(3), TieRule::first_row);
    std::set<std::vector<Index>> seen;
    bool returned = false;
    while (walk.place == LemkeWalk::Place::on_the_way && walk.pivots < 100 && !returned) {
        walk.step();
        std::vector<Index> vertex = walk.tableau.basic;
        std::sort(vertex.begin(), vertex.end());
        returned = !seen.insert(vertex).second;
    }
    CHECK(returned);
    CHECK(with_ties(problem, TieRule::first_row).status == Status::iteration_limit);
}

TEST_CASE("within a cone each weight is a linear function of z0 and most are not in proportion", "[house]")
{
    // The example of section 5.1: A = (2 1; 1 2), q = (−5, −6), d = (1, 1). In the cone of z1 and z2 the weights solve
    // A z = −(q + z0 d).
    const auto weights = [](Real z0) {
        const Vec2 r = Vec2(5, 6) - z0 * Vec2(1, 1);
        return Vec2((2 * r[0] - r[1]) / 3, (2 * r[1] - r[0]) / 3);
    };
    const Vec2 at_0 = weights(0), at_1 = weights(1), at_2 = weights(2);
    CHECK((at_0 - Vec2(4.0 / 3, 7.0 / 3)).norm() < 1e-14);
    CHECK((at_0 - 2 * at_1 + at_2).norm() < 1e-14);                // linear in z0
    CHECK(std::abs(at_0[0] / at_0[1] - at_2[0] / at_2[1]) > 0.1);  // and not in proportion
    CHECK(says("chapters/05_lemke/README.md", "Inside a cone each weight is a linear function of $z_0$."));
}

TEST_CASE("a proof counts what bounded impulses can do and takes no small number for zero", "[house]")
{
    // Rows 0 and 1 want λ0 + λ1 = 1 and λ0 + λ1 = 0: v = (1, −1, 0) proves it, if λ2, which helps row 0 alone, cannot
    // reach 1.
    Mlcp mlcp;
    mlcp.A = (MatX(3, 3) << 1, 1, 1, 1, 1, 0, 1, 0, 1).finished().sparseView();
    mlcp.q = Vec<3>(-1, 0, 0);
    for (const Real most : {0.1, 0.9, 1.1, 10.0})
        for (const int side : {1, -1}) {  // the bound that matters is hi, or lo where row 2 is turned round
            mlcp.lo = Vec<3>(-infinity, -infinity, side > 0 ? -0.1 : -most);
            mlcp.hi = Vec<3>(infinity, infinity, side > 0 ? most : 0.1);
            Mlcp turned = mlcp;
            turned.A = (MatX(3, 3) << 1, 1, side, 1, 1, 0, side, 0, 1).finished().sparseView();
            INFO("up to " << most << " N s on side " << side);
            CHECK(proves_infeasibility(turned, Vec<3>(1, -1, 0)) == (most < 1));
        }
    // A zero that is none: 1e-6 of the entries is no rounding.
    Mlcp nearly;
    nearly.q = Vec2(-1, 0);
    nearly.lo = VecX::Constant(2, -infinity);
    nearly.hi = VecX::Constant(2, infinity);
    nearly.A = (MatX(2, 2) << 1, 1, 1, 1 + 1e-6).finished().sparseView();
    CHECK(!proves_infeasibility(nearly, VecX(Vec2(1, -1))));
}

TEST_CASE("a ray of the first covering vector that proves nothing leads to a second one", "[house]")
{
    // λ = (1, 0) has w = (0, 0); along d = (1, 1) the walk ends on a ray after one pivot.
    const Mlcp mlcp = plain_lcp(matrix2(2, 0, 2, -2), vector({-2, -2}));
    LemkeSettings settings;
    Solution first;
    first.lambda = VecX::Zero(2);
    CHECK_FALSE(walk_once(mlcp, mlcp, 1, 100, settings, first));
    CHECK(first.status == Status::ray_termination);
    const Solution solution = lemke(mlcp);
    CHECK(solution.status == Status::solved);
    CHECK((solution.lambda - Vec2(1, 0)).norm() <= 1e-15);  // the rounding of one division
}

TEST_CASE("where z0 ties with another row the walk ends", "[idea]")
{
    // λ = (0, 2) makes w0 zero too: z0 enters, then z1, and now w0 and z0 reach zero together.
    const Mlcp mlcp = plain_lcp(matrix2(1, 0.5, 0.5, 1), vector({-1, -2}));
    for (const TieRule ties : {TieRule::first_row, TieRule::last_row, TieRule::lexicographic}) {
        LemkeSettings settings;
        settings.ties = ties;
        const Solution solution = lemke(mlcp, settings);
        CHECK(solution.status == Status::solved);
        CHECK(solution.iterations == 2);
    }
}

TEST_CASE("a value that rounding put below zero ties with one that is zero", "[idea]")
{
    const Tableau tableau(matrix2(-1e-3, 0, -1, 0), vector({-1e-15, 0}), VecX::Ones(2));
    CHECK(ratio_test(tableau, 0, TieRule::first_row) == 0);
    CHECK(ratio_test(tableau, 0, TieRule::last_row) == 1);
}

TEST_CASE("a proof may use a row in the direction of its sign only", "[idea]")
{
    const auto proves = [](Real q, Real lo, Real hi, Real v) {
        Mlcp mlcp = plain_lcp(MatX::Ones(1, 1), VecX::Constant(1, q));
        mlcp.lo[0] = lo;
        mlcp.hi[0] = hi;
        return proves_infeasibility(mlcp, VecX::Constant(1, v));
    };
    CHECK_FALSE(proves(1, 0, infinity, -1));   // λ = 0 and w = 1: of a w ≥ 0 nothing follows from v < 0
    CHECK_FALSE(proves(-1, -infinity, 0, 1));  // λ = 0 and w = -1
}

TEST_CASE("a sum of forty last digits is no zero to a proof", "[idea]")
{
    // (1, -1) A = (0, -4e-14): six times what rounding may hide in it, and λ of 2.5e13 would do.
    Mlcp mlcp = plain_lcp(matrix2(1, 1, 1, 1 + 4e-14), vector({-1, 0}));
    mlcp.lo.setConstant(-infinity);
    CHECK_FALSE(proves_infeasibility(mlcp, vector({1, -1})));
    mlcp.A.coeffRef(1, 1) = 1;
    CHECK(proves_infeasibility(mlcp, vector({1, -1})));
}

TEST_CASE("skew two by two problems are solved where there is an answer and infeasible where there is none",
          "[idea]")
{
    const MatX A = matrix2(0, 1, -1, 0);
    const Solution both = lemke(plain_lcp(A, vector({-1, 1})));
    CHECK(both.status == Status::solved);
    CHECK(both.lambda == vector({1, 1}));
    CHECK(lemke(plain_lcp(A, vector({1, 1}))).status == Status::solved);
    for (const VecX& q : {vector({-1, -1}), vector({1, -1}), vector({0, -1})}) {
        const Solution none = lemke(plain_lcp(A, q));
        CHECK(none.status == Status::infeasible);
        CHECK(none.residual > 0.1);
    }
}

TEST_CASE("two contacts that push against each other are solvable or infeasible depending on q", "[idea]")
{
    const MatX A = matrix2(1, -1, -1, 1);
    CHECK(lemke(plain_lcp(A, vector({1, -1}))).status == Status::solved);
    CHECK(lemke(plain_lcp(A, vector({-1, -1}))).status == Status::infeasible);
}

TEST_CASE("a ray that proves nothing is called ray termination", "[idea]")
{
    // z = (1, 0) answers it, but the walk runs along an edge that never ends: A is not copositive.
    const Mlcp problem = plain_lcp(matrix2(-2, 0, 1, -1), vector({2, -1}));
    const Solution solution = lemke(problem);
    CHECK(natural_residual(problem, vector({1, 0})) == 0);
    CHECK(solution.status == Status::ray_termination);
    CHECK(solution.residual > 0.1);
}

TEST_CASE("nearly dependent joints are not called infeasible where there is an answer", "[idea]")
{
    // Two rows that differ by 1e-16 to 1e-6 of their size, and about a third of all rows bilateral: what is left
    // when these are eliminated is known to a few digits only, or to none.
    Random random(23);
    int infeasible = 0, wrongly = 0;
    for (int sample = 0; sample < 4000; ++sample) {
        const Index n = 2 + random.index(5);
        MatX A(n, n);
        VecX q(n);
        for (Real& entry : A.reshaped()) entry = random.normal();
        for (Real& entry : q)
            entry = random.uniform() < 0.5 ? std::floor(random.uniform(-2, 2)) : random.normal();
        A = (A * A.transpose()).eval();
        const Index i = random.index(n), j = random.index(n);
        const Real near = 1 + std::pow(10.0, random.uniform(-16, -6));
        A.row(j) = (A.row(i) * near).eval();
        A.col(j) = (A.col(i) * near).eval();
        Mlcp problem = plain_lcp(A, q);
        for (Index k = 0; k < n; ++k)
            if (random.uniform() < 0.3) problem.lo[k] = -infinity;
        if (lemke(problem).status != Status::infeasible) continue;
        ++infeasible;
        wrongly += enumerate(problem).status == Status::solved;
    }
    CHECK(infeasible > 100);
    CHECK(wrongly == 0);
}

TEST_CASE("of all two-row problems with entries from -2 to 2 none is called infeasible or solved wrongly",
          "[idea]")
{
    int rays = 0;
    for (int code = 0; code < 15625; ++code) {
        Real digit[6];
        for (int k = 0, rest = code; k < 6; ++k, rest /= 5) digit[k] = rest % 5 - 2;
        const Mlcp problem =
            plain_lcp(matrix2(digit[0], digit[1], digit[2], digit[3]), vector({digit[4], digit[5]}));
        const Solution truth = enumerate(problem), solution = lemke(problem);
        INFO("problem " << code);
        if (truth.status == Status::solved) {
            CHECK(solution.status != Status::infeasible);
            rays += solution.status == Status::ray_termination;
        } else {
            CHECK(solution.status != Status::solved);
        }
        if (solution.status == Status::solved) CHECK(solution.residual <= 1e-12);
    }
    CHECK(rays < 1000);  // matrices with negative entries on the diagonal: Lemke promises nothing there
}

TEST_CASE("nearly parallel rows are not called infeasible", "[idea]")
{
    // The answer is about 2e12 in both rows: absurd, but it exists.
    const Solution solution = lemke(plain_lcp(matrix2(1, -1, -1, 1 + 1e-12), vector({-1, -1})));
    CHECK(solution.status != Status::infeasible);
    CHECK((solution.status != Status::solved || solution.residual <= 1e-10));
}

// ---- bounds and bilateral rows --------------------------------------------------------------------------

TEST_CASE("a bilateral row takes any sign and a bounded one stops at its bounds", "[idea]")
{
    Mlcp one = plain_lcp(MatX::Constant(1, 1, 2), vector({6}));
    const auto lambda = [&](Real lo, Real hi) {
        one.lo[0] = lo;
        one.hi[0] = hi;
        const Solution solution = lemke(one);
        REQUIRE(solution.status == Status::solved);
        return solution.lambda[0];
    };
    CHECK(lambda(-infinity, infinity) == Approx(-3).epsilon(identity));
    CHECK(lambda(-1, 1) == Approx(-1).epsilon(identity));
    CHECK(lambda(-5, -4) == Approx(-4).epsilon(identity));
    CHECK(lambda(-5, -2) == Approx(-3).epsilon(identity));
    CHECK(lambda(-infinity, -4) == Approx(-4).epsilon(identity));
    CHECK(lambda(-infinity, 4) == Approx(-3).epsilon(identity));
    CHECK(lambda(7, infinity) == Approx(7).epsilon(identity));
    CHECK(lambda(5, 5) == 5);
}

TEST_CASE("bilateral rows that repeat each other are solved and those that contradict each other are not",
          "[idea]")
{
    Mlcp twice = plain_lcp(MatX::Constant(2, 2, 1), vector({3, 3}));
    twice.lo.setConstant(-infinity);
    const Solution solution = lemke(twice);
    CHECK(solution.status == Status::solved);
    CHECK(solution.lambda.sum() == Approx(-3).epsilon(identity));
    twice.q[1] = 4;
    CHECK(lemke(twice).status == Status::infeasible);
}

// ---- physics --------------------------------------------------------------------------------------------

TEST_CASE("the lowest contact of a column carries all the weight above it", "[idea]")
{
    for (const Index N : {Index{1}, Index{2}, Index{10}, Index{50}}) {
        const Real m = 2, g = 9.81, h = 1.0 / 60;
        MatX A = 2 / m * MatX::Identity(N, N);
        for (Index i = 0; i + 1 < N; ++i) A(i, i + 1) = A(i + 1, i) = -1 / m;
        A(0, 0) = 1 / m;  // the ground does not yield
        VecX q = VecX::Zero(N);
        q[0] = -g * h;
        const Solution solution = lemke(plain_lcp(A, q));
        REQUIRE(solution.status == Status::solved);
        for (Index k = 0; k < N; ++k) {
            const Real exact = static_cast<Real>(N - k) * m * g * h;
            // The condition of a column of N is about N².
            CHECK(std::abs(solution.lambda[k] - exact) <= identity * exact * static_cast<Real>(N));
        }
    }
}

TEST_CASE("a box on a slope sticks below the angle of friction and slides above with the known acceleration",
          "[idea]")
{
    const Real mu = 0.3, h = 0.01, g = 9.81;
    BoxStack stack;
    stack.boxes = 1;
    stack.offset = stack.jostle = 0;
    stack.friction = mu;
    for (const Real degrees : {5.0, 16.5, 16.9, 30.0}) {
        ContactRows scene = contact_rows(stack);
        const Real angle = degrees * pi / 180;
        scene.u_star << g * h * std::sin(angle), -g * h * std::cos(angle), 0;  // x runs down the slope
        const Solution solution = lemke(stewart_trinkle(assemble(scene.rows, scene.u_star), mu));
        REQUIRE(solution.status == Status::solved);
        VecX u = scene.u_star;
        for (std::size_t i = 0; i < 2; ++i) {
            const auto k = static_cast<Index>(i);
            scene.rows[i].apply(solution.lambda[k], u);
            scene.rows[i + 2].apply(solution.lambda[2 + k] - solution.lambda[4 + k], u);
        }
        const Real slides = h * g * std::max(Real{0}, std::sin(angle) - mu * std::cos(angle));
        CHECK((u - vector({slides, 0, 0})).cwiseAbs().maxCoeff() < identity);
        CHECK((slides > 0) == (degrees > 16.69924423399362));
    }
}

TEST_CASE("a friction problem without a negative bias ends on no ray and its matrix is copositive", "[idea]")
{
    // (13.30), (13.31): random contacts of random bodies, also more contacts than the bodies have coordinates.
    Random random(529);
    for (int sample = 0; sample < 400; ++sample) {
        const Index bodies = 1 + random.index(4), m = 1 + random.index(7);
        const Real mu = random.uniform(0, 1.5);
        VecX inverse_mass(3 * bodies), u_star(3 * bodies);
        for (Index i = 0; i < 3 * bodies; ++i) {
            inverse_mass[i] = random.uniform(0.5, 2);
            u_star[i] = random.normal();
        }
        ContactRows scene{{}, u_star};
        std::vector<Row<3>> along;
        for (Index i = 0; i < m; ++i) {
            const Index b = random.index(bodies), a = random.index(bodies);
            const Real angle = random.uniform(0, 2 * pi), x = random.uniform(-1, 1),
                       y = random.uniform(-1, 1);
            const Vec2 n(std::cos(angle), std::sin(angle)), t(-n.y(), n.x()), r(x, y), other(y, -x);
            scene.rows.push_back(contact_row(a == b ? world : a, b, n, other, r, inverse_mass));
            along.push_back(contact_row(a == b ? world : a, b, t, other, r, inverse_mass));
            scene.rows.back().bias = random.uniform(0, 1);
        }
        scene.rows.insert(scene.rows.end(), along.begin(), along.end());
        const Mlcp rows = assemble(scene.rows, scene.u_star), problem = stewart_trinkle(rows, mu);
        CHECK(lemke(problem).status == Status::solved);
        VecX x(4 * m);
        for (Index i = 0; i < 4 * m; ++i) x[i] = random.index(3) == 0 ? 0 : random.uniform();
        VecX impulses(2 * m);
        impulses << x.head(m), x.segment(m, m) - x.segment(2 * m, m);
        const Real form = impulses.dot(rows.A * impulses) + mu * x.tail(m).dot(x.head(m));
        // A few dozen products of numbers of size one.
        CHECK(x.dot(problem.A * x) == Approx(form).margin(1e-12));
        CHECK(form >= -1e-12);
    }
}

TEST_CASE("a pyramid of four edges has six rows and slows a block down", "[idea]")
{
    // Exercise 13.6: λ_n, four β, γ; the block moves along the first edge and is pressed at 1 m/s.
    MatX A = MatX::Zero(6, 6);
    A(0, 0) = 1;
    const Vec2 edges[] = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}};
    for (Index k = 0; k < 4; ++k) {
        for (Index l = 0; l < 4; ++l) A(1 + k, 1 + l) = edges[k].dot(edges[l]);
        A(1 + k, 5) = 1;
        A(5, 1 + k) = -1;
    }
    A(5, 0) = 0.5;
    const Solution solution = lemke(plain_lcp(A, vector({-1, 1, 0, -1, 0, 0})));
    CHECK(solution.status == Status::solved);
    CHECK((solution.lambda - vector({1, 0, 0, 0.5, 0, 0.5})).cwiseAbs().maxCoeff() < identity);
}

TEST_CASE("every friction problem of a stack of boxes is solved", "[idea]")
{
    for (const Index boxes : {5, 10, 20, 40})
        for (const Real jostle : {0.0, 0.01, 0.1, 1.0})
            for (std::uint64_t seed = 1; seed <= (boxes < 40 ? 4 : 2); ++seed) {
                BoxStack stack;
                stack.boxes = boxes;
                stack.jostle = jostle;
                stack.seed = seed;
                const Mlcp problem = stewart_trinkle(stack);
                REQUIRE(problem.size() == 8 * boxes);
                const Solution solution = lemke(problem);
                INFO(boxes << " boxes, jostled by " << jostle << ", seed " << seed);
                REQUIRE(solution.status == Status::solved);
                CHECK(judged_residual(problem, solution.lambda) <= 1e-10);
            }
}

TEST_CASE("of 810 stacks under a heavy top each walk solves as many as the text says and the rest are named",
          "[house]")
{
    int all = 0, first = 0, second = 0, light = 0;
    std::map<Status, int> others;
    for (const Index boxes : {5, 10, 20})
        for (const Real top : {1e3, 1e5})
            for (std::uint64_t seed = 1; seed <= 135; ++seed) {
                BoxStack stack;
                stack.boxes = boxes, stack.top_mass = top, stack.seed = seed;
                const Mlcp problem = stewart_trinkle(stack);
                const int limit = 10000 + 50 * static_cast<int>(problem.size());
                Solution solution;
                ++all;
                walk_once(problem, problem, 1, limit, {}, solution);
                const Solution both = lemke(problem);
                if (solution.status == Status::solved) ++first;
                else if (both.status == Status::solved) ++second;
                else ++others[both.status];
                light += both.status == Status::solved && top < 1e4;
            }
    CHECK(all == 810);
    CHECK(light == 405);
    const auto number = [&](Status status) { return std::to_string(others[status]); };
    CHECK(says("chapters/05_lemke/in_depth.md",
               "walk solves " + std::to_string(first) + " and the second " + std::to_string(second) +
                   " more, among them all with 1000 kg. Of the other " +
                   std::to_string(all - first - second) + ", " + number(Status::ray_termination) +
                   " end on a ray that proves nothing, " + number(Status::singular) +
                   " at a vertex that is judged wrong, and " + number(Status::iteration_limit) +
                   " at the limit of pivots"));
}

TEST_CASE("friction opposes sliding and stays in its cone and loses energy", "[idea]")
{
    BoxStack stack;
    stack.boxes = 8;
    stack.fall = 0;
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        stack.seed = seed;
        const ContactRows scene = contact_rows(stack);
        const Mlcp problem = stewart_trinkle(assemble(scene.rows, scene.u_star), stack.friction);
        const Solution solution = lemke(problem);
        REQUIRE(solution.status == Status::solved);
        const Index m = problem.size() / 4;
        VecX u = scene.u_star;
        for (Index i = 0; i < m; ++i) {
            const Real beta = solution.lambda[m + i] - solution.lambda[2 * m + i];
            CHECK(std::abs(beta) <= stack.friction * solution.lambda[i] + 1e-10);
            scene.rows[static_cast<std::size_t>(i)].apply(solution.lambda[i], u);
            scene.rows[static_cast<std::size_t>(m + i)].apply(beta, u);
        }
        Real power = 0;
        for (Index i = 0; i < m; ++i) {
            const auto& row = scene.rows[static_cast<std::size_t>(m + i)];
            power += row.velocity(u) * (solution.lambda[m + i] - solution.lambda[2 * m + i]);
        }
        CHECK(power <= 1e-10);
        // M = diag(1, 1, 1/6) for the unit box.
        Real before = 0, after = 0;
        for (Index k = 0; k < u.size(); ++k) {
            const Real mass = k % 3 == 2 ? 1.0 / 6 : 1;
            before += mass * scene.u_star[k] * scene.u_star[k];
            after += mass * u[k] * u[k];
        }
        CHECK(after <= before * (1 + 1e-10));
    }
}

// ---- against the truth ----------------------------------------------------------------------------------

TEST_CASE("the small problems come out right to the uniqueness that their files state", "[idea]")
{
    for (const char* name : {"blcp_spd_s10", "circulant_ties_12", "column_rest_s3", "disc_chain_s2",
                             "fric_boxed_s4", "fric_st_s2", "infeasible_psd2", "mass1000_rest_s5",
                             "murty_exp_s6", "murty_q1_s16", "nonsym_pd_s6", "pyramid_impact_s3", "spd_s5"}) {
        const Problem problem =
            read_problem(std::string(RIGID_SOURCE_DIR) + "/tests/problems/" + name + ".mlcp");
        const Solution solution = lemke(problem.mlcp);
        INFO(name);
        if (problem.kind == Uniqueness::none) {
            CHECK(solution.status == Status::infeasible);
            continue;
        }
        REQUIRE(solution.status == Status::solved);
        CHECK(solution.residual <= 1e-12);
        // Answers are as good as the residual times the condition, 1e4 for the masses 1 : 1000.
        const VecX w = problem.mlcp.A * solution.lambda + problem.mlcp.q;
        if (problem.kind == Uniqueness::unique)
            CHECK((solution.lambda - problem.z).cwiseAbs().maxCoeff() <=
                  1e-10 * (1 + problem.z.cwiseAbs().maxCoeff()));
        if (problem.kind != Uniqueness::any) CHECK((w - problem.w).cwiseAbs().maxCoeff() <= 1e-10);
    }
}

TEST_CASE("a thousand random problems of each kind agree with the enumeration of chapter 3", "[idea]")
{
    for (const Kind kind : all_kinds) {
        Random random(100 + static_cast<std::uint64_t>(kind));
        int unique = 0;
        for (int sample = 0; sample < 1000; ++sample) {
            const bool large = sample % 100 == 0;  // 3^12 cases take a while
            const Index n = large ? (kind == Kind::bounded ? 8 : 12) : 1 + random.index(5);
            VecX lambda;
            Mlcp problem = planted(kind, n, random, lambda);
            if (sample % 3 == 0)  // without a planted answer: some of these have none
                for (Real& entry : problem.q) entry = random.normal();
            const Solution truth = enumerate(problem), solution = lemke(problem);
            INFO("kind " << static_cast<int>(kind) << ", sample " << sample << ", n = " << n);
            if (truth.uniqueness == Uniqueness::none) {
                CHECK((solution.status == Status::infeasible || solution.status == Status::ray_termination));
                continue;
            }
            REQUIRE(solution.status == Status::solved);
            CHECK(judged_residual(problem, solution.lambda) <= 1e-10 * (1 + problem.q.cwiseAbs().maxCoeff()));
            // Both are accurate to their residual times the condition of the active block, up to 1e4 here.
            const Real size = 1 + truth.lambda.cwiseAbs().maxCoeff();
            const VecX dw = problem.A * (solution.lambda - truth.lambda);
            if (truth.uniqueness == Uniqueness::unique) {
                ++unique;
                CHECK((solution.lambda - truth.lambda).cwiseAbs().maxCoeff() <= 1e-7 * size);
            }
            if (truth.uniqueness != Uniqueness::any) CHECK(dw.cwiseAbs().maxCoeff() <= 1e-8 * size);
        }
        CHECK(unique >= (kind == Kind::psd ? 300 : 900));
    }
}

TEST_CASE("planted answers of up to two hundred rows are found", "[idea]")
{
    for (const Kind kind : all_kinds) {
        Random random(200 + static_cast<std::uint64_t>(kind));
        for (int sample = 0; sample < 60; ++sample) {
            const Index n = sample == 0 ? 200 : 1 + random.index(60);
            VecX lambda;
            const Mlcp problem = planted(kind, n, random, lambda);
            const Solution solution = lemke(problem);
            INFO("kind " << static_cast<int>(kind) << ", sample " << sample << ", n = " << n);
            REQUIRE(solution.status == Status::solved);
            CHECK(judged_residual(problem, solution.lambda) <= 1e-10 * (1 + problem.q.cwiseAbs().maxCoeff()));
            const VecX dw = problem.A * (solution.lambda - lambda);
            CHECK(dw.cwiseAbs().maxCoeff() <= 1e-7 * (1 + problem.q.cwiseAbs().maxCoeff()));
        }
    }
}

TEST_CASE("infeasible semidefinite problems are recognised", "[idea]")
{
    // y ≥ 0 with A y = 0 and qᵀy < 0 is planted: no z has A z + q ≥ 0.
    Random random(300);
    int proved = 0;
    for (int sample = 0; sample < 300; ++sample) {
        const Index n = 2 + random.index(10);
        VecX y(n), q(n);
        for (Real& entry : y) entry = random.uniform(0.1, 1);
        MatX G = gaussian(n, std::max<Index>(1, n / 2), random);
        G -= y * (y.transpose() * G) / y.squaredNorm();
        for (Real& entry : q) entry = random.normal();
        q -= y * (q.dot(y) + random.uniform(0.1, 1)) / y.squaredNorm();
        const Solution solution = lemke(plain_lcp(G * G.transpose(), q));
        CHECK((solution.status == Status::infeasible || solution.status == Status::ray_termination));
        proved += solution.status == Status::infeasible;
    }
    CHECK(proved >= 290);  // a few rays are too blurred by rounding to prove anything
}

TEST_CASE("a random search finds no problem that is called solved with a residual above 1e-8 or that loops",
          "[idea]")
{
    Random random(400);
    int solved = 0;
    constexpr int budget = 60000;
    for (int sample = 0; sample < budget; ++sample) {
        const Index n = 1 + random.index(sample % 50 == 0 ? 30 : 8);
        MatX A(n, n);
        VecX q(n);
        const Index shape = random.index(7);
        for (Real& entry : A.reshaped())
            entry = shape < 2 ? std::floor(random.uniform(-2, 3)) : random.normal();  // ties, zeros, singular
        for (Real& entry : q)
            entry = random.uniform() < 0.5 ? std::floor(random.uniform(-2, 2)) : random.normal();
        if (shape == 1) A = (A * A.transpose()).eval();
        if (shape == 3) A = (A * A.transpose() + 1e-9 * MatX::Identity(n, n)).eval();
        if (shape == 4) {  // nearly the same row twice
            A = (A * A.transpose()).eval();
            const Index i = random.index(n), j = random.index(n);
            const Real near = std::pow(10.0, random.uniform(-16, -6));
            A.row(j) = A.row(i) * (1 + near);
            A.col(j) = A.col(i) * (1 + near);
        }
        if (shape == 5) {  // masses from grams to kilotons
            A = (A * A.transpose() + 0.01 * MatX::Identity(n, n)).eval();
            VecX scale(n);
            for (Real& entry : scale) entry = std::pow(10.0, random.uniform(-3, 3));
            A = (scale.asDiagonal() * A * scale.asDiagonal()).eval();
        }
        if (shape == 6) A = (A - A.transpose()).eval();
        Mlcp problem = plain_lcp(A, q);
        if (random.uniform() < 0.4)
            for (Index i = 0; i < n; ++i) {
                const Real which = random.uniform();
                if (which < 0.3) problem.lo[i] = -infinity;
                else if (which < 0.5) problem.hi[i] = random.uniform();
                else if (which < 0.6) problem.hi[i] = problem.lo[i];
                else if (which < 0.7) problem.hi[i] = 1e-12;
            }
        LemkeSettings settings;
        settings.ties = static_cast<TieRule>(random.index(3));
        settings.pivot_limit = 2000;
        const Solution solution = lemke(problem, settings);
        CHECK(solution.iterations <= settings.pivot_limit);
        CHECK(solution.lambda.size() == n);
        if (solution.status != Status::solved) continue;
        ++solved;
        if (!(judged_residual(problem, solution.lambda) <= 1e-8)) FAIL_CHECK("sample " << sample);
    }
    CHECK(solved > budget / 3);  // the search also looks at problems that have answers
}

// ---- units, bounds, and what is said --------------------------------------------------------------------

TEST_CASE("twenty boxes with friction are solved at every mass from 1e-9 to 1e9 kg", "[idea]")
{
    for (std::uint64_t seed = 1; seed <= 10; ++seed) {
        int pivots_of_one = 0;
        for (const int power : {0, -9, -6, -3, 3, 5, 6, 9}) {
            BoxStack stack;
            stack.boxes = 20;
            stack.seed = seed;
            stack.mass = stack.top_mass = std::pow(10, power);
            const Solution solution = lemke(stewart_trinkle(stack));
            INFO("seed " << seed << ", 1e" << power << " kg");
            REQUIRE(solution.status == Status::solved);
            if (power == 0) pivots_of_one = solution.iterations;
            CHECK(solution.iterations == pivots_of_one);  // another unit of mass is the same walk
        }
    }
}

TEST_CASE("a bound that is far away does not swallow what pushes", "[idea]")
{
    for (const Real bound : {1e10, 1e16, 1e20}) {
        Mlcp one = plain_lcp(MatX::Ones(1, 1), vector({3}));
        one.lo[0] = -bound;
        one.hi[0] = bound;
        const Solution solution = lemke(one);
        CHECK(solution.status == Status::solved);
        CHECK(solution.lambda[0] == -3);

        Mlcp three = random_spd_problem();
        three.lo.setConstant(-bound);
        three.hi.setConstant(bound);
        const Solution free = lemke(three);
        CHECK(free.status == Status::solved);
        CHECK(free.residual <= 1e-14);  // a few roundings of numbers of size one
    }
}

TEST_CASE("the lift can rise on the way to an answer", "[house]")
{
    LemkeWalk walk(matrix2(-2, -2, 3, -1), vector({2, -1}), vector({1, 1}), TieRule::lexicographic);
    walk.step();
    CHECK(walk.tableau.value(walk.tableau.artificial()) == 1);
    walk.step();  // z2 enters: z0 = 1 + z2 until w1 = 3 - z2 is zero
    CHECK(walk.tableau.value(walk.tableau.artificial()) == 4);
    for (int pivot = 0; pivot < 4 && walk.place == LemkeWalk::Place::on_the_way; ++pivot) walk.step();
    CHECK(walk.place == LemkeWalk::Place::solution);
}

TEST_CASE("a direction that a bound turns away proves nothing", "[house]")
{
    Mlcp problem = plain_lcp(matrix2(-2, 1, 1, -1), vector({0, 0}));
    problem.lo.setConstant(-infinity);
    problem.hi = vector({0, 2});
    REQUIRE(natural_residual(problem, vector({0, 0})) == 0);
    CHECK(lemke(problem).status != Status::infeasible);
    CHECK_FALSE(proves_infeasibility(problem, vector({-1, -2})));
    CHECK_FALSE(proves_infeasibility(problem, vector({-1, -1})));
    // And one that is a proof: no λ ≤ 0 makes -λ ≤ -1.
    Mlcp none = plain_lcp(matrix2(1, -1, -1, 1), vector({-1, -1}));
    CHECK(proves_infeasibility(none, vector({1, 1})));
    CHECK_FALSE(proves_infeasibility(none, vector({1, 0.5})));
}

TEST_CASE("with q near zero what is solved is as right as with any other q", "[idea]")
{
    Random random(600);
    int solved = 0, wrong = 0;
    constexpr int budget = 4000;
    for (int sample = 0; sample < budget; ++sample) {
        const Index n = 1 + random.index(6);
        const VecX q = gaussian(n, 1, random);
        Mlcp problem = plain_lcp(random_matrix(Kind::spd, n, random), q);
        const Real unit = std::pow(10, random.uniform(-30, -10));
        problem.q *= unit;
        for (Index i = 0; i < n; ++i) {
            if (random.uniform() < 0.5) problem.lo[i] = -random.uniform();
            if (random.uniform() < 0.5) problem.hi[i] = random.uniform();
        }
        const Solution solution = lemke(problem);
        if (solution.status != Status::solved) continue;
        ++solved;
        wrong += !(judged_residual(problem, solution.lambda) <= 1e-9 * problem.q.cwiseAbs().maxCoeff());
    }
    CHECK(wrong == 0);
    CHECK(solved > budget * 99 / 100);
}

// ---- properties -----------------------------------------------------------------------------------------

TEST_CASE("masses and lengths in other units and rows in another order give the same impulses", "[idea]")
{
    Random random(500);
    for (int sample = 0; sample < 200; ++sample) {
        const Index n = 1 + random.index(20);
        VecX lambda;
        const Mlcp problem = planted(all_kinds[sample % 6 == 1 ? 0 : sample % 6], n, random, lambda);
        const Solution solution = lemke(problem);
        REQUIRE(solution.status == Status::solved);
        const Real size = 1 + solution.lambda.cwiseAbs().maxCoeff();

        const Real mass = std::pow(10.0, random.uniform(-6, 6)),
                   length = std::pow(10.0, random.uniform(-6, 6));
        Mlcp scaled = problem;
        scaled.A /= mass;
        scaled.q *= length;
        scaled.lo *= mass * length;
        scaled.hi *= mass * length;
        const Solution same = lemke(scaled);
        REQUIRE(same.status == Status::solved);
        CHECK((same.lambda / (mass * length) - solution.lambda).cwiseAbs().maxCoeff() <= 1e-8 * size);

        Eigen::PermutationMatrix<Eigen::Dynamic> order(static_cast<int>(n));
        order.setIdentity();
        for (Index i = n - 1; i > 0; --i) std::swap(order.indices()[i], order.indices()[random.index(i + 1)]);
        Mlcp shuffled = problem;
        shuffled.A = MatX(order * MatX(problem.A) * order.transpose()).sparseView();
        shuffled.q = order * problem.q;
        shuffled.lo = order * problem.lo;
        shuffled.hi = order * problem.hi;
        const Solution also = lemke(shuffled);
        REQUIRE(also.status == Status::solved);
        CHECK((also.lambda - order * solution.lambda).cwiseAbs().maxCoeff() <= 1e-8 * size);
    }
}

TEST_CASE("the same problem gives the same bits twice", "[house]")
{
    const Mlcp problem = stewart_trinkle(BoxStack{});
    const Solution first = lemke(problem), second = lemke(problem);
    CHECK(first.lambda == second.lambda);
    CHECK(first.iterations == second.iterations);
}

TEST_CASE("a problem that makes no sense is refused with a sentence", "[house]")
{
    Mlcp problem = plain_lcp(MatX::Identity(2, 2), vector({-1, -1}));
    LemkeSettings settings;
    SECTION("NaN in q")
    {
        problem.q[1] = std::nan("");
        CHECK(sentence_of([&] { lemke(problem); }) == "q[1] is nan; it must be finite");
    }
    SECTION("lo above hi")
    {
        problem.lo[0] = 2;
        problem.hi[0] = 1;
        CHECK(sentence_of([&] { lemke(problem); }) != "accepted");
    }
    SECTION("a tolerance of zero")
    {
        settings.tolerance = 0;
        CHECK(sentence_of([&] { lemke(problem, settings); }) ==
              "the tolerance is 0, enough 0 m/s and the pivot limit 0; the tolerance must be positive, the "
              "others "
              "not negative, enough finite");
    }
    SECTION("a speed that is nothing without a limit")
    {
        settings.enough = infinity;
        CHECK(sentence_of([&] { lemke(problem, settings); }) ==
              "the tolerance is 1e-10, enough inf m/s and the pivot limit 0; the tolerance must be positive, "
              "the "
              "others not negative, enough finite");
    }
    SECTION("a stack without boxes")
    {
        BoxStack stack;
        stack.boxes = 0;
        CHECK(sentence_of([&] { contact_rows(stack); }) == "the number of boxes is 0; it must be at least 1");
    }
}

TEST_CASE("numbers too large for doubles end with a true status", "[idea]")
{
    const Solution solution = lemke(plain_lcp(matrix2(1e300, 1e300, 1e300, 1e300), vector({-1e300, -1e308})));
    if (solution.status == Status::solved) CHECK(solution.residual <= 1e298);
    const Solution tiny = lemke(plain_lcp(matrix2(1e-300, 0, 0, 1e300), vector({-1, -1})));
    if (tiny.status == Status::solved) CHECK(tiny.residual <= 1e-10);
}

TEST_CASE("a vertex that is no number is never the best one", "[house]")
{
    // two rows that are nearly one: what refines the last vertex divides zero by zero
    Mlcp mlcp = plain_lcp(matrix2(5.7039634567063388e-09, -9.6407002086939298e-22, -9.6407002086939298e-22,
                                  1.6294476852693525e-34),
                          vector({2.138231777304978e-82, -0.00052321042201440571}));
    mlcp.lo[1] = -infinity;
    const Solution solution = lemke(mlcp);
    CHECK(solution.lambda.allFinite());
    CHECK(std::isfinite(solution.residual));
    CHECK(solution.status != Status::solved);
}
