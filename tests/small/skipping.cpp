/// The small programs of chapters 9 and 10, which guess and which skip, beside the library and each other.

#include "tests/small/alone.hpp"

#include "chapters/09_active_sets/active_sets.hpp"
#include "chapters/10_skipping_work/by_islands.hpp"
#include "tests/small/library_run.hpp"
#include "tests/small/quiet_sweeps.hpp"
#include "tests/small/sentences.hpp"

#define main small_main
namespace small08_again {
#include "chapters/08_warm_starting/small.cpp"
}
namespace small09 {
#include "chapters/09_active_sets/small.cpp"
}
namespace small10 {
#include "chapters/10_skipping_work/small.cpp"
}
#undef main

using namespace rigid;

TEST_CASE("the small program of chapter 9 has the numbers of the text and the library's to 1e-12")
{
    // By hand, (9.3): from both rows two guesses.
    const MatX A{{2, 1}, {1, 2}};
    const VecX q{{-5, -1}}, lo = VecX::Zero(2);
    std::vector<bool> active(2, true);
    VecX lambda;
    CHECK(small09::guess(A, q, lo, active, lambda, 1) == 1);
    CHECK((lambda - VecX{{3, -1}}).norm() < 1e-15);
    CHECK(small09::guess(A, q, lo, active, lambda) == 1);
    CHECK((lambda - VecX{{2.5, 0}}).norm() < 1e-15);
    // Section 9.3: all wrong rows at once cycle through three guesses; then the first wrong row alone.
    const MatX circle{{8, -4, 6}, {-4, 3, -2}, {6, -2, 6}};
    const VecX three{{5, -4, 1}}, zero = VecX::Zero(3);
    active.assign(3, true);
    for (int round = 0; round < 3; ++round)
        for (const VecX& guessed : {VecX{{-3, -1, 2.5}}, VecX{{0, 0, -1.0 / 6}}, VecX{{0, 4.0 / 3, 0}}}) {
            CHECK(small09::guess(circle, three, zero, active, lambda, 1) == 1);
            CHECK((lambda - guessed).norm() < 1e-13);
        }
    CHECK(small09::guess(circle, three, zero, active, lambda) == 8);
    CHECK((lambda - VecX{{0, 11.0 / 7, 5.0 / 14}}).norm() < 1e-13);

    // b = C/h, as the library's matrix methods have it.
    ActiveSetMemory memory;
    StepData<2> now;
    auto method =
        by_matrix([&](const Mlcp& mlcp, Solution& solution) { active_sets(mlcp, {}, memory, solution); });
    const Real farthest = farthest_in_a_run(
        small09::ten_discs(), [](small09::Discs& d) { return small09::step(d, 1.0 / 240, 1) > 0; },
        [&](DiscScene& scene) {
            step(scene, {.h = 1.0 / 240}, method, now);
            return now.solution.status == Status::solved;
        });
    CHECK(farthest < 1e-12);  // both are exact
}

TEST_CASE("the small program of chapter 9 makes fewer guesses from the last answer and ends where sweeps end")
{
    small09::Discs remembered = small09::ten_discs(), forgetful = remembered;
    small08_again::Discs swept = small08_again::ten_discs();
    int few = 0, many = 0;
    for (int n = 0; n < 480; ++n) {
        few += small09::step(remembered, 1.0 / 240, 0.2);
        forgetful.contacts.clear();
        many += small09::step(forgetful, 1.0 / 240, 0.2);
        if (n >= 100) continue;
        small08_again::step(swept, 1.0 / 240, 0.2);
        // Each step leaves rows of the sweeps off by up to 1e-6 m/s; over 100 of them that has grown to 3e-5 m.
        REQUIRE((remembered.x - swept.x).cwiseAbs().maxCoeff() < 1e-4);
    }
    CHECK(few == 622);  // what section 9.5 says
    CHECK(many == 1356);
    CHECK((remembered.x - forgetful.x).cwiseAbs().maxCoeff() <
          1e-9);  // both exact: the guess is no part of the answer
}

TEST_CASE("the small program of chapter 10 skips and leaves every bit of chapter 8's")
{
    // By hand, section 10.3, and the library's union-find on the same rows.
    const std::vector<small10::Contact> rows{
        {0, 3, {0, 1}, 0, 0}, {3, 6, {0, 1}, 0, 0}, {-1, 1, {0, 1}, 0, 0}};
    CHECK(small10::islands(rows, 8) == std::vector<int>{0, 1, 2, 0, 4, 5, 0, 7});
    std::vector<int> parent{0, 1, 2, 3, 4, 5, 6, 7};
    unite(parent, 0, 3);
    unite(parent, 3, 6);
    for (int k = 0; k < 8; ++k) CHECK(lowest_of(parent, k) == small10::islands(rows, 8)[std::size_t(k)]);

    small10::Discs all = small10::columns(), some = all;
    small08_again::Discs eight{all.x, all.u, all.inverse_mass, all.radius, 0, all.walls};
    for (int n = 0; n < 300; ++n) {
        small10::step(all, 1.0 / 60, 0, 10, 0);
        small10::step(some, 1.0 / 60, 1, 10, 0);
        small08_again::step(eight, 1.0 / 60, 0.2, 10);
        REQUIRE(all.x == some.x);
        REQUIRE(all.u == some.u);
        // Chapter 8's stops at 1e-6 m/s, this one only where nothing changes: sweeps are at their limit while the ball
        // rolls, so both differ by what those last sweeps change.
        if (n < 30) REQUIRE((all.x - eight.x).cwiseAbs().maxCoeff() < 1e-6);
    }
    CHECK(all.pairs == 300 * 101 * 100 / 2);
    CHECK(some.pairs * 20 < all.pairs);
    CHECK(some.visits < all.visits);
}

TEST_CASE("the small program of chapter 10 lets columns sleep and wakes them when they are touched")
{
    small10::Discs d = small10::columns(), awake = d;
    const auto sleepers = [&]() -> Index {
        return std::count_if(d.asleep.begin(), d.asleep.end(), [](int island) { return island >= 0; });
    };
    Index most = 0;
    for (int n = 0; n < 150; ++n) {
        small10::step(d, 1.0 / 60, 2, 10);
        small10::step(awake, 1.0 / 60, 1, 10);
        most = std::max(most, sleepers());
        // What is touched is awake in the same step: nothing passes through a sleeper by more than a step's way.
        for (const small10::Contact& c : d.contacts)
            if (c.a >= 0) REQUIRE((d.asleep[std::size_t(c.a)] < 0) == (d.asleep[std::size_t(c.b)] < 0));
    }
    CHECK(most >= 95);  // all columns but the first, half a second after the start
    CHECK(sleepers() > 20);
    CHECK(sleepers() < 95);
    CHECK(2 * d.moved < awake.moved);
    // what section 10.9 says, in three digits; one or the other disc may sleep a step earlier
    CHECK(double(awake.pairs) == Approx(30500).epsilon(0.02));
    CHECK(double(d.pairs) == Approx(15400).epsilon(0.02));
    CHECK(double(d.visits) == Approx(82000).epsilon(0.02));
    for (int k = 95; k < 100; ++k)  // the last column stands where ten sweeps from zero have left it
        CHECK((d.x - small10::columns().x).segment<2>(2 * k).norm() < 1e-6);
}

namespace {

// What the sentences of these chapters say.

Numbers guess(Numbers in)
{
    const Eigen::MatrixXd A{{2, 1}, {1, 2}};
    const Eigen::VectorXd q{{-5, in["q2"]}};
    Eigen::VectorXd first, lambda;
    std::vector<bool> once(2, true), active(2, true);
    small09::guess(A, q, two_zeros, once, first, 1);
    const int guesses = small09::guess(A, q, two_zeros, active, lambda);
    return {{"first1", first[0]},
            {"first2", first[1]},
            {"guesses", guesses},
            {"answer1", lambda[0]},
            {"answer2", lambda[1]}};
}

const Sentence says_guess("guess", guess, 1e-12);

}  // namespace
