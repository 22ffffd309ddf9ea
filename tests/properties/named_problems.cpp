/// Problems that a solver once got wrong, each by its name.

#include "chapters/03_mlcp_formulation/exact.hpp"
#include "chapters/04_pgs/conjugate_gradients.hpp"
#include "chapters/05_lemke/lemke.hpp"
#include "chapters/09_active_sets/dantzig.hpp"
#include "chapters/09_active_sets/friction_boxes.hpp"
#include "tests/catch.hpp"
#include "tests/no_allocation.hpp"
#include "tests/properties/random_attack.hpp"
#include "tests/properties/verdicts.hpp"
#include "tests/random_problems.hpp"
#include "tests/sentence.hpp"

#if defined(__linux__) && !defined(RIGID_ADDRESS_SANITIZER)
#include <sys/resource.h>
#define RIGID_CAN_LIMIT_MEMORY
#endif

using namespace rigid;
using namespace rigid::properties;

namespace {

Mlcp problem_of(std::initializer_list<Real> A, std::initializer_list<Real> q, std::initializer_list<Real> lo,
                std::initializer_list<Real> hi)
{
    const auto n = static_cast<Index>(q.size());
    Mlcp mlcp = plain_lcp(MatX::Zero(n, n), vector(q));
    MatX dense(n, n);
    Index k = 0;
    for (const Real entry : A) {
        dense(k / n, k % n) = entry;
        ++k;
    }
    mlcp.A = dense.sparseView();
    mlcp.lo = vector(lo);
    mlcp.hi = vector(hi);
    return mlcp;
}

/// All its numbers are small and whole, so all its answers can be had exactly.
constexpr bool whole = true, not_whole = false;

/// No verdict of any solver on it is false.
void check_verdicts(const Mlcp& mlcp, bool is_whole)
{
    AllSolvers solvers;
    Tally tally;
    for (const std::string& sentence : false_verdicts(mlcp, is_whole, solvers.solve(mlcp), tally))
        FAIL_CHECK(sentence);
    CHECK(tally.verdicts >= 6);
}

Status status_of(const std::vector<Answer>& answers, const std::string& solver)
{
    for (const Answer& answer : answers)
        if (answer.solver == solver) return answer.solution.status;
    FAIL("no answer by " << solver);
    return Status::singular;
}

}  // namespace

// ---- the judge itself -----------------------------------------------------------------------------------

TEST_CASE("the judge knows a residual that doubles hide and a size that lambda cannot raise")
{
    const Mlcp mlcp = problem_of({4, -4, -4, 4}, {-2, 1}, {-infinity, -infinity}, {infinity, infinity});
    const VecX absurd = VecX::Constant(2, 1.5e31);
    CHECK(natural_residual(mlcp, absurd) == 0);  // q is lost in the sum
    const WideProblem problem(mlcp);
    CHECK(static_cast<Real>(problem.error(widened(absurd))) == 1);  // all of the 2 m/s that are given
    CHECK(static_cast<Real>(problem.given) == 1);                   // 2 m/s in the unit of a row, √4
    CHECK_FALSE(certain_answer(problem, absurd));
    CHECK_FALSE(search_answer(problem));
}

TEST_CASE("the judge of whole numbers counts the answers of problems whose answers are known")
{
    const Real inf = infinity;
    CHECK(all_answers(problem_of({2, 1, 1, 2}, {-3, -3}, {0, 0}, {inf, inf}))->uniqueness() ==
          Uniqueness::unique);
    CHECK(all_answers(problem_of({1, 1, 1, 1}, {-1, -1}, {0, 0}, {inf, inf}))->uniqueness() ==
          Uniqueness::w_unique);
    CHECK(all_answers(problem_of({-1}, {1}, {0}, {inf}))->uniqueness() == Uniqueness::any);
    CHECK(all_answers(problem_of({1, -1, -1, 1}, {-1, -1}, {0, 0}, {inf, inf}))->uniqueness() ==
          Uniqueness::none);
    CHECK(all_answers(problem_of({0}, {0}, {0}, {1}))->uniqueness() == Uniqueness::w_unique);
    CHECK(all_answers(problem_of({0}, {-1}, {0}, {1}))->uniqueness() == Uniqueness::unique);
    CHECK(all_answers(problem_of({1}, {5}, {3}, {3}))->uniqueness() == Uniqueness::unique);
}

TEST_CASE("the judge finds false verdicts of each sort")
{
    const Mlcp mlcp = problem_of({2, 1, 1, 2}, {-3, -3}, {0, 0}, {infinity, infinity});
    Solution solution;
    solution.lambda = vector({1, 1});
    solution.status = Status::solved;
    const auto sentences = [&] {
        Tally tally;
        return false_verdicts(mlcp, whole, {{"somebody", solution}}, tally).size();
    };
    CHECK(sentences() == 0);
    solution.uniqueness = Uniqueness::w_unique;
    CHECK(sentences() == 1);
    solution.uniqueness = Uniqueness::unique;
    CHECK(sentences() == 0);
    solution.lambda[0] = 1 + 1e-7;
    CHECK(sentences() == 1);
    solution.lambda[0] = -1;
    CHECK(sentences() == 2);  // outside its bounds, and no answer
    solution.lambda = vector({1, 1});
    solution.status = Status::infeasible;
    CHECK(sentences() == 1);
}

// ---- less said than is true -----------------------------------------------------------------------------

TEST_CASE("redundant rows of a problem whose q is zero have one w")
{
    const Real inf = infinity;
    const Mlcp bilateral = problem_of({1, 0, 1, -1, 0, 1, 0, 1, 1, 0, 1, -1, -1, 1, -1, 2}, {0, 0, 0, 0},
                                      {-inf, -inf, -inf, -inf}, {inf, inf, inf, inf});
    CHECK(enumerate(bilateral).uniqueness == Uniqueness::w_unique);
    check_verdicts(bilateral, whole);
    const Mlcp one_sided = problem_of({1, 0, 1, -1, 0, 1, 0, 1, 1, 0, 1, -1, -1, 1, -1, 2}, {0, 0, 0, 0},
                                      {0, 0, -inf, 0}, {inf, inf, 0, inf});
    check_verdicts(one_sided, whole);
    Mlcp tiny = bilateral;  // the least bound is then the only number that says how large a step is
    tiny.lo.setConstant(-std::ldexp(1.0, -40));
    tiny.hi.setConstant(std::ldexp(1.0, -40));
    CHECK(enumerate(tiny).uniqueness == Uniqueness::w_unique);
    // Where w is not one, it stays known: w = (λ1, 0) for every 0 ≤ λ1 ≤ 2 of the rows λ2 and w2 = 0.
    check_verdicts(problem_of({0, 1, 1, 0}, {0, 0}, {0, -1}, {2, 1}), whole);
    check_verdicts(problem_of({0, 0, 1, 0}, {0, 0}, {0, 0}, {2, 0}), whole);
}

TEST_CASE("the family of a singular set is seen where its equations are all rounding")
{
    const Real inf = infinity;
    const Mlcp mlcp = problem_of({1, -1, -1, 0, -1, 3, 0, 2, -1, 0, 2, -1, 0, 2, -1, 2}, {-3, 10, 0, 7},
                                 {0, -inf, -inf, -inf}, {inf, inf, inf, -2});
    CHECK(schur(mlcp).uniqueness != Uniqueness::unique);
    check_verdicts(mlcp, whole);
}

TEST_CASE("no scale of the rows makes the number of answers a false one")
{
    // Of whole numbers, so how many answers there are is known; scaled by powers of two, so that it stays so.
    const auto scaled = [](const Mlcp& mlcp, const VecX& d) {
        Mlcp other = mlcp;
        other.A = MatX(d.asDiagonal() * MatX(mlcp.A) * d.asDiagonal()).sparseView();
        other.q = mlcp.q.cwiseProduct(d);
        other.lo = mlcp.lo.cwiseQuotient(d);
        other.hi = mlcp.hi.cwiseQuotient(d);
        return other;
    };
    Random random(11);
    int counted = 0, problems = 0;
    for (int k = 0; k < 1000; ++k) {
        const Index n = 1 + random.index(4), rank = 1 + random.index(n);
        MatX G(n, rank);
        for (Index i = 0; i < n; ++i)
            for (Index j = 0; j < rank; ++j) G(i, j) = static_cast<Real>(random.index(7)) - 3;
        Mlcp mlcp = plain_lcp(MatX(G * G.transpose()), VecX::Zero(n));
        VecX planted(n), d(n);
        const bool bilateral = random.index(3) == 0;
        for (Index i = 0; i < n; ++i) {
            planted[i] = static_cast<Real>(random.index(5)) - 2;
            const Index bounds = bilateral ? 0 : random.index(3);
            mlcp.lo[i] = bounds == 0 ? -infinity : bounds == 1 ? 0 : -1;
            mlcp.hi[i] = bounds < 2 ? infinity : 2;
            d[i] = std::ldexp(1.0, static_cast<int>(random.index(997)) - 498);  // 10^±150
        }
        mlcp.q = -(mlcp.A * planted);
        const auto all = all_answers(mlcp);
        if (!all) continue;
        ++problems;
        const Mlcp other = scaled(mlcp, d);
        if (!other.A.coeffs().allFinite() || !other.q.allFinite()) continue;
        std::vector<Solution> solutions = {schur(other), enumerate(other)};
        if (bilateral) solutions.push_back(direct(other));
        for (const Solution& solution : solutions) {
            INFO("problem " << k);
            if (solution.uniqueness == Uniqueness::not_examined) continue;
            ++counted;
            REQUIRE(to_string(solution.uniqueness) == to_string(all->uniqueness()));
        }
    }
    CHECK(problems > 900);
    CHECK(counted > 500);

    // A regular matrix: exactly one λ, (0, −1). At (1, −1) both w are zero to 1e-63 of the numbers in their rows, but not
    // zero, and in the units of the rows it is the same λ to 1e-63.
    const Real inf = infinity;
    const Mlcp far_apart = problem_of(
        {5.430362962610135e-95, 6.474176736915196e-32, 6.474176736915196e-32, 5.884697823303651e+32},
        {6.474176736915196e-32, 5.884697823303651e+32}, {-inf, -inf}, {inf, inf});
    for (const Solution& solution : {direct(far_apart), schur(far_apart), enumerate(far_apart)}) {
        CHECK(solution.status == Status::solved);
        CHECK(solution.uniqueness == Uniqueness::unique);
        CHECK(std::abs(solution.lambda[1] + 1) <= 1e-15);
        // its unit is √(5.9e32 / 5.4e-95) = 3.3e63 times that of λ_2
        CHECK(std::abs(solution.lambda[0]) <= 1e-15 * 3.3e63);
    }
}

// ---- solved, and it was no answer -----------------------------------------------------------------------

TEST_CASE("conflicting rods without bounds are not solved by impulses of 1e31")
{
    const Mlcp mlcp = problem_of({4, -4, -4, 4}, {-2, 1}, {-infinity, -infinity}, {infinity, infinity});
    check_verdicts(mlcp, whole);
    AllSolvers solvers;
    for (const Answer& answer : solvers.solve(mlcp)) {
        INFO(answer.solver);
        CHECK(answer.solution.status != Status::solved);
    }
}

TEST_CASE("bounds that are far away loosen no tolerance")
{
    for (const Real far : {1e10, 1e16, 1e20}) {
        const Mlcp mlcp = problem_of({1}, {3}, {-far}, {far});
        check_verdicts(mlcp, not_whole);
        AllSolvers solvers;
        const std::vector<Answer> answers = solvers.solve(mlcp);
        INFO("bounds of " << far);
        // One row is solved by its own visit, whatever its bounds.
        for (const char* solver : {"active_sets", "active_sets alone", "dantzig"})
            CHECK(status_of(answers, solver) == Status::solved);
    }
}

// ---- infeasible, and there was an answer ----------------------------------------------------------------

TEST_CASE("a proof of infeasibility does not use a row whose lambda has both bounds or none")
{
    check_verdicts(problem_of({-2, 1, 1, -1}, {0, 0}, {-infinity, -infinity}, {0, 2}), whole);
    check_verdicts(problem_of({0, -1, 0, 0}, {0, 0}, {0, -infinity}, {infinity, 2}), whole);
}

TEST_CASE("an answer is not called unique where a whole ray of answers begins")
{
    check_verdicts(
        problem_of({2, -1, 0, -1, 5, 1, 1, -1, 0}, {-7, 3, -2}, {-infinity, -infinity, -infinity}, {2, 0, 0}),
        true);
    check_verdicts(problem_of({1, 1, 0, 0}, {5, 0}, {0, -infinity}, {1, -1}), whole);
}

TEST_CASE("Dantzig's method calls none of 20000 problems infeasible that has an answer")
{
    // The three generators of chapter 5's tests: the random search; planted rows that depend on each other, with
    // another q; and y ≥ 0 with A y = 0 and qᵀy < 0, here by anything from 1 down to less than rounding.
    int infeasible = 0;
    for (std::uint64_t sample = 0; sample < 20000; ++sample) {
        Random random(sample);
        Mlcp mlcp;
        if (sample % 3 == 0) {
            mlcp = detail::chapter_five(1 + random.index(8), random);
        } else if (sample % 3 == 1) {
            VecX lambda;
            mlcp = planted(Kind::psd, 1 + random.index(8), random, lambda);
            for (Real& entry : mlcp.q) entry = random.normal();
        } else {
            const Index n = 2 + random.index(8);
            VecX y(n);
            for (Real& entry : y) entry = random.uniform(0.1, 1);
            MatX G = gaussian(n, std::max<Index>(1, n / 2), random);
            G -= y * (y.transpose() * G) / y.squaredNorm();
            VecX q = gaussian(n, 1, random);
            q -= y * (q.dot(y) + std::pow(10, random.uniform(-18, 0))) / y.squaredNorm();
            mlcp = plain_lcp(G * G.transpose(), q);
        }
        std::vector<int> cursor;
        if (!is_symmetric(mlcp.A, cursor)) continue;
        const Solution driven = dantzig(mlcp);
        if (driven.status != Status::infeasible) continue;
        ++infeasible;
        Tally tally;
        std::vector<Answer> answers{
            {"dantzig", driven}, {"lemke", lemke(mlcp)}, {"active_sets", active_sets(mlcp)}};
        for (const std::string& sentence : false_verdicts(mlcp, false, answers, tally))
            FAIL_CHECK("sample " << sample << ", " << sentence);
    }
    CHECK(infeasible > 3000);  // proofs are found, too
}

// ---- memory ---------------------------------------------------------------------------------------------

TEST_CASE("what the memory of active sets held before does not change an answer")
{
    const Mlcp singular = problem_of({0, 0, -1, 2, 0, -1, 0, -2, -1, 0, 2, 0, 2, -2, 0, -2}, {-3, 2, 0, -1},
                                     {-1, -1, -infinity, -infinity}, {1, 1, 0, 0});
    check_verdicts(singular, whole);
    Random random(7);
    for (int sample = 0; sample < 300; ++sample) {
        const Mlcp mlcp = sample == 0 ? singular : random_attack(sample % 2 == 0 ? 2 : 3, random).mlcp;
        ActiveSetMemory clean, dirty;
        for (VecX* vector : {&dirty.guess.lambda, &dirty.guess.w, &dirty.guess.step, &dirty.guess.here,
                             &dirty.guess.trial, &dirty.guess.way})
            *vector = VecX::Constant(mlcp.size(), 1e3 * sample);
        dirty.guess.cases.assign(static_cast<std::size_t>(mlcp.size()), BoundState::at_hi);
        Solution first, second;
        ActiveSetSettings settings;
        settings.limit = sample % 3 == 0 ? 50 : 0;
        active_sets(mlcp, settings, clean, first);
        active_sets(mlcp, settings, dirty, second);
        INFO("sample " << sample);
        CHECK(first.status == second.status);
        CHECK(first.lambda == second.lambda);
        CHECK(first.iterations == second.iterations);
    }
}

TEST_CASE("kept memory serves a problem without rows")
{
    ActiveSetMemory memory;
    Solution solution;
    const Mlcp none = plain_lcp(MatX(0, 0), VecX(0));
    // Rows go out one after the other: the factor of the first set is kept, with a border for those that went.
    MatX A = MatX::Constant(60, 60, 0.001);
    A.diagonal().setOnes();
    Mlcp going = plain_lcp(A, VecX::Constant(60, -1));
    for (Index i = 0; i < 4; ++i) {
        going.q[i] = 3;
        active_sets(going, {}, memory, solution);
    }
    REQUIRE(memory.work.updates > 0);
    for (const Mlcp& mlcp : {none, plain_lcp(MatX::Identity(3, 3), VecX::Constant(3, -1)), none,
                             problem_of({1, 1, 1, 1}, {-1, -1}, {0, 0}, {infinity, infinity}), none}) {
        active_sets(mlcp, {}, memory, solution);
        CHECK(solution.status == Status::solved);
        CHECK(solution.lambda.size() == mlcp.size());
        dantzig(mlcp, {}, memory, solution);
        CHECK(solution.status == Status::solved);
    }
}

TEST_CASE("rows that nothing moves have the unit of the rows that they move")
{
    // w_1 = w_3 = 0 whatever λ is; λ_3 is free, and helps row 4. In numbers of 1 every solver sees that, and
    // in huge ones a unit of 1 beside 1e62 made that λ all that its equation had.
    const Real a = std::ldexp(1.0, 414), x = std::ldexp(1.0, -236), inf = infinity;
    const MatX A = Eigen::Matrix<Real, 5, 5, Eigen::RowMajor>{
        {-1, 0, -1, 1, 1}, {0, 0, 0, 0, 0}, {1, 1, 0, 0, -1}, {0, 0, 0, 0, 0}, {-1, -1, 1, 1, 1}};
    const VecX q = Eigen::Vector<Real, 5>(4, 0, 1, 0, -2),
               lo = Eigen::Vector<Real, 5>(-1, -inf, 0, -inf, -inf),
               hi = Eigen::Vector<Real, 5>(-1, -1, inf, inf, inf);
    for (const bool huge : {false, true}) {
        Mlcp mlcp = plain_lcp(huge ? MatX(A * a) : A, huge ? VecX(q * (a * x)) : q);
        mlcp.lo = huge ? VecX(lo * x) : lo;
        mlcp.hi = huge ? VecX(hi * x) : hi;
        check_verdicts(mlcp, not_whole);
        CHECK(enumerate(mlcp).status == Status::solved);
    }
}

#ifdef RIGID_CAN_LIMIT_MEMORY
TEST_CASE("memory that cannot be had leaves the memory of active sets whole")
{
    const auto dense = [](Index n) {
        MatX A = MatX::Constant(n, n, 0.001);
        A.diagonal().setOnes();
        return plain_lcp(A, VecX::Constant(n, -1));
    };
    const Mlcp small = dense(60), large = dense(2500);
    ActiveSetMemory memory;
    Solution solution;
    active_sets(small, {}, memory, solution);
    REQUIRE(solution.status == Status::solved);
    rlimit before{}, limit{};
    REQUIRE(getrlimit(RLIMIT_AS, &before) == 0);
    long pages = 0;
    if (std::FILE* statm = std::fopen("/proc/self/statm", "r")) {
        if (std::fscanf(statm, "%ld", &pages) != 1) pages = 0;
        std::fclose(statm);
    }
    REQUIRE(pages > 0);
    bool refused_memory = false;
    for (const int megabytes : {20, 70}) {  // 2500² numbers are 50 MB: for A, then for its factor
        limit = before;
        limit.rlim_cur = static_cast<rlim_t>(pages) * 4096 + static_cast<rlim_t>(megabytes) * 1024 * 1024;
        REQUIRE(setrlimit(RLIMIT_AS, &limit) == 0);
        try {
            active_sets(large, {}, memory, solution);
        } catch (const std::bad_alloc&) {
            refused_memory = true;
        }
        setrlimit(RLIMIT_AS, &before);
        active_sets(small, {}, memory, solution);
        CHECK(solution.status == Status::solved);
    }
    CHECK(refused_memory);
}
#endif

TEST_CASE("rows that differ in their last digits are not called infeasible because of their units")
{
    // Scaled by a factor that is no power of two, these matrices are rounded to singular ones.
    const Mlcp two =
        problem_of({0.06675039295125638, 0.06675039011502407, 0.06675039011502407, 0.06675038727879187},
                   {-1.7226437191379207, -1.7226437191379171}, {-infinity, 0}, {2, infinity});
    const Mlcp three = problem_of(
        {1.9180185645187895, -0.7546631663515521, 1.918018650244488, -0.7546631663515521, 2.6951270881770197,
         -0.7546632000811667, 1.918018650244488, -0.7546632000811667, 1.9180187359701906},
        {1, -0.5476545878115057, 1}, {-infinity, 0, 0}, {infinity, infinity, infinity});
    for (const Mlcp& mlcp : {two, three}) {
        CHECK(enumerate(mlcp).status != Status::infeasible);
        CHECK(enumerate(mlcp, {.stop_at_first = true, .first = {}}).status != Status::infeasible);
        CHECK(schur(mlcp).status != Status::infeasible);
    }
}

TEST_CASE("bounds that leave no finite lambda are refused with a sentence")
{
    for (const Real nowhere : {infinity, -infinity}) {
        const Mlcp mlcp = problem_of({2, 1, 1, 2}, {-1, -1}, {0, nowhere}, {infinity, nowhere});
        CHECK(sentence_of([&] { active_sets(mlcp); }) != "accepted");
        CHECK(sentence_of([&] { dantzig(mlcp); }) != "accepted");
        CHECK(sentence_of([&] { lemke(mlcp); }) != "accepted");
        CHECK(sentence_of([&] { enumerate(mlcp); }) != "accepted");
    }
}
