/// The small programs of chapters 6 to 8, which sweep over velocities, beside the library.

#include "tests/small/alone.hpp"

#include "tests/small/library_run.hpp"
#include "tests/small/quiet_sweeps.hpp"
#include "tests/small/sentences.hpp"

#define main small_main
namespace small04_again {
#include "chapters/04_pgs/small.cpp"
}
namespace small06 {
#include "chapters/06_sequential_impulse/small.cpp"
}
namespace small07 {
#include "chapters/07_baumgarte/small.cpp"
}
namespace small08 {
#include "chapters/08_warm_starting/small.cpp"
}
#undef main

using namespace rigid;

namespace {

QuietMethod<2, AllPairs, Correction, ColdStart> baumgarte_method(Real beta)
{
    QuietMethod<2, AllPairs, Correction, ColdStart> method;
    method.correction.method = Stabilizer::baumgarte;
    method.correction.beta = beta;
    return method;
}

QuietMethod<2, AllPairs, Correction, WarmStart> warm_method(Real beta)
{
    QuietMethod<2, AllPairs, Correction, WarmStart> method;
    method.correction.method = Stabilizer::baumgarte;
    method.correction.beta = beta;
    method.start.from = Start::previous;
    return method;
}

}  // namespace

TEST_CASE("the small program of chapter 6 has the numbers of the text and the library's to 1e-12")
{
    // By hand, the table of section 6.1.
    small06::Discs two{VecX::Zero(4), VecX{{0, -1, 0, -1}}, VecX::Ones(4), VecX::Ones(2), 0, {}};
    small06::Contact rows[]{{-1, 0, {0, 1}, 0, 0}, {0, 1, {0, 1}, 0, 0}};
    for (const auto& [row, lambda, u1, u2] : {std::tuple{0, 1.0, 0.0, -1.0},
                                              {1, 0.5, -0.5, -0.5},
                                              {0, 1.5, 0.0, -0.5},
                                              {1, 0.75, -0.25, -0.25}}) {
        small06::visit(rows[row], two);
        CHECK(rows[row].lambda == lambda);
        CHECK(two.u == VecX{{0, u1, 0, u2}});
    }

    QuietMethod<2, AllPairs, WholeError, ColdStart> method;
    const Real farthest = farthest_in_a_run(
        small06::ten_discs(), [](small06::Discs& d) { return small06::step(d, 1.0 / 240); }, method);
    CHECK(farthest < 1e-12);  // the same visits, whose sums have another order
    CHECK(work_of_the_text<small06::Discs>(small06::ten_discs, small06::step) == 14025);  // section 6.1
}

TEST_CASE("the small programs of chapters 4 and 6 make the same sweeps and the same velocities")
{
    small04_again::Discs matrix = small04_again::ten_discs();
    small06::Discs visits = small06::ten_discs();
    for (int n = 0; n < 100; ++n) {
        REQUIRE(small04_again::step(matrix, 1.0 / 240) == small06::step(visits, 1.0 / 240));
        REQUIRE((matrix.u - visits.u).norm() < 1e-12);  // (6.6): only the rounding differs
    }
}

TEST_CASE("the small program of chapter 7 has the numbers of the text and the library's to 1e-12")
{
    // By hand, (7.5) and (7.9).
    small07::Discs two{VecX{{0, 0, 0.11, 0}}, VecX::Zero(4), VecX::Ones(4), VecX::Constant(2, 0.05), 2, {}};
    for (int n = 0; n < 30; ++n) {
        CHECK(small07::error(two) == Approx(0.01 * std::pow(0.8, n)).margin(1e-12));
        small07::step(two, 1.0 / 60, 0.2);
    }
    small07::Discs one{VecX{{0, 0}}, VecX::Zero(2), VecX::Ones(2), VecX{{0.1}}, 0, VecX{{0, 1, 0}}};
    small07::step(one, 1.0 / 60, 0.2);
    CHECK(one.u[1] == Approx(1.2).epsilon(1e-12));

    for (const auto& [beta, error] : {std::pair{0.0, 0.0143}, {0.2, 0.0033}, {1.0, 0.0008}}) {
        INFO("beta " << beta);
        small07::Discs d = small07::ten_discs();
        Real worst = 0;
        for (int n = 0; n < 480; ++n) {
            small07::step(d, 1.0 / 240, beta);
            worst = std::max(worst, small07::error(d));
        }
        CHECK(worst == Approx(error).margin(5e-5));  // section 7.2, rounded to 0.1 mm
        QuietMethod method = baumgarte_method(beta);
        const Real farthest = farthest_in_a_run(
            small07::ten_discs(),
            [beta = beta](small07::Discs& small) { return small07::step(small, 1.0 / 240, beta); }, method);
        CHECK(farthest < 1e-12);
    }
}

TEST_CASE("the small program of chapter 8 has the numbers of the text and the library's to 1e-12")
{
    // By hand, section 8.1.
    small08::Discs two = small08::column(2);
    CHECK(small08::step(two, 1.0 / 60, 0.2) == 20);
    CHECK(small08::step(two, 1.0 / 60, 0.2) == 1);
    two.g *= 1.01;
    CHECK(small08::step(two, 1.0 / 60, 0.2) == 13);
    // By hand, section 8.4: the overlap of two discs [g h²] with one sweep a step; 1e-12 of a radius is rounding.
    const auto overlaps = [](bool warm, const std::vector<Real>& expected) {
        small08::Discs d = small08::column(2);
        for (const Real overlap : expected) {
            if (!warm) d.contacts.clear();
            small08::step(d, 1.0 / 60, 0, 1);
            CHECK(0.2 - (d.x[3] - d.x[1]) == Approx(overlap * d.g / 3600).margin(1e-13));
            CHECK(std::abs(d.x[1] - 0.1) < 1e-13);  // the floor is visited last
        }
    };
    overlaps(false, {1, 2.5, 4.25, 6.125, 8.0625, 10.03125});
    overlaps(true, {1, 2, 2.5, 2.5, 2.25, 2, 1.875, 1.875});
    small08::Discs twenty = small08::column(20);
    for (const int sweeps : {1685, 112, 1, 1, 1, 1})
        CHECK(small08::step(twenty, 1.0 / 60, 0) == sweeps);  // no error is corrected

    QuietMethod method = warm_method(0.2);
    const Real farthest = farthest_in_a_run(
        small08::ten_discs(), [](small08::Discs& d) { return small08::step(d, 1.0 / 240, 0.2); }, method);
    CHECK(farthest < 1e-12);
    // section 8.3
    int forgetful = 0;
    const auto remembered = [](small08::Discs& d, Real h) { return small08::step(d, h, 0.2); };
    small08::Discs cold = small08::ten_discs();
    for (int n = 0; n < 480; ++n) cold.contacts.clear(), forgetful += remembered(cold, 1.0 / 240);
    CHECK(forgetful == 14380);
    CHECK(work_of_the_text<small08::Discs>(small08::ten_discs, remembered) == 10949);
    small08::Discs sunk = small08::column(20), stands = sunk;
    for (int n = 0; n < 480; ++n) {
        sunk.contacts.clear();
        small08::step(sunk, 1.0 / 60, 0, 10), small08::step(stands, 1.0 / 60, 0, 10);
    }
    CHECK(sunk.x[39] == Approx(1.02).margin(0.005));
    CHECK(stands.x[39] == Approx(3.85).margin(0.005));
    // Ten sweeps a step hold the column at rest where (8.8) says, 50.8212574362 mm below its place.
    small08::Discs warm = small08::column(20);
    for (int n = 0; n < 2000; ++n) small08::step(warm, 1.0 / 60, 0, 10);
    CHECK(3.9 - warm.x[39] == Approx(0.0508212574362).margin(1e-5));
}

namespace {

// What the sentences of these chapters say.

Numbers visits(Numbers in)
{
    small06::Discs two{Eigen::VectorXd::Zero(4),
                       Eigen::VectorXd{{0, -1, 0, -1}},
                       Eigen::VectorXd::Ones(4),
                       Eigen::VectorXd::Ones(2),
                       0,
                       {}};
    two.inverse_mass.tail<2>() /= in["mass"];
    small06::Contact rows[]{{-1, 0, {0, 1}, 0, 0}, {0, 1, {0, 1}, 0, 0}};
    for (int k = 0; k < in["visits"]; ++k) small06::visit(rows[k % 2], two);
    return {{"lower", two.u[1]}, {"upper", two.u[3]}};
}

Numbers long_link(Numbers in)
{
    small07::Discs two{Eigen::VectorXd{{0, 0, 0.11, 0}},
                       Eigen::VectorXd::Zero(4),
                       Eigen::VectorXd::Ones(4),
                       Eigen::VectorXd{{0.05, 0.05}},
                       2,
                       {}};
    Numbers out;
    for (int n = 0; n <= 20; ++n) {
        if (n == 4) out["after4"] = 1000 * small07::find_contacts(two)[0].C;
        if (n == 20) out["after20"] = 1000 * small07::find_contacts(two)[0].C;
        small07::step(two, 1.0 / 60, in["beta"]);
    }
    return out;
}

Numbers two_discs(Numbers in)
{
    small08::Discs warm = small08::column(2);
    for (int n = 0; n < 2; ++n) small08::step(warm, 1.0 / 60, 0.2);
    small08::Discs cold = warm;
    cold.contacts.clear();
    warm.g = cold.g = 9.81 * (1 + in["percent"] / 100);
    return {{"cold", small08::step(cold, 1.0 / 60, 0.2)}, {"warm", small08::step(warm, 1.0 / 60, 0.2)}};
}

const Sentence says_visits("visits", visits, 1e-12);
const Sentence says_long_link(
    "link", long_link,
    1e-3);  // the row is solved to 1e-6 m/s, a sixtieth of a second long, in each of twenty steps, in millimetres: 3.3e-4
const Sentence says_two_discs("two_discs", two_discs, 0);

}  // namespace
