/// The small programs of chapters 3 to 5, which solve A λ + q, beside the library.

#include "tests/small/alone.hpp"

#include "chapters/03_mlcp_formulation/enumeration.hpp"
#include "chapters/03_mlcp_formulation/exact.hpp"
#include "chapters/04_pgs/sweeps.hpp"
#include "chapters/05_lemke/lemke.hpp"
#include "tests/small/library_run.hpp"
#include "tests/small/sentences.hpp"

#define main small_main
namespace small03 {
#include "chapters/03_mlcp_formulation/small.cpp"
}
namespace small04 {
#include "chapters/04_pgs/small.cpp"
}
namespace small05 {
#include "chapters/05_lemke/small.cpp"
}
#undef main

using namespace rigid;

namespace {

/// λ ≥ 0 in all rows.
Mlcp contacts_only(const MatX& A, const VecX& q)
{
    Mlcp mlcp;
    mlcp.A = A.sparseView();
    mlcp.q = q;
    mlcp.lo.setZero(q.size());
    mlcp.hi.setConstant(q.size(), infinity);
    return mlcp;
}

MatX dense(const Mlcp& mlcp) { return MatX(mlcp.A); }

/// A step of the library whose problem is solved by solve(mlcp, solution), which returns its work.
template <class Solve>
int library_step(DiscScene& scene, const Solve& solve)
{
    int work = 0;
    StepData<2> now;
    step(scene, {.h = 1.0 / 240},
         by_matrix([&](const Mlcp& mlcp, Solution& solution) { work = solve(mlcp, solution); }), now);
    return work;
}

}  // namespace

TEST_CASE("the small program of chapter 3 has the numbers of the text and the library's to 1e-12")
{
    // By hand, (3.3): of four sets the last fits.
    const MatX A{{1, 0.8}, {0.8, 1}};
    const VecX q{{-2, -2.2}}, lo = VecX::Zero(2);
    for (long set = 0; set < 4; ++set) {
        const VecX lambda = small03::impulses(A, -q, set);
        CHECK((small03::residual(A, q, lo, lambda) <= 1e-9) == (set == 3));
        CHECK(small03::residual(A, q, lo, lambda) ==
              Approx(natural_residual(contacts_only(A, q), lambda)).margin(1e-15));
    }
    VecX lambda;
    CHECK(small03::enumerate(A, q, lo, lambda) == 1);  // the guess
    CHECK((lambda - enumerate(contacts_only(A, q)).lambda).norm() < 1e-12);
    CHECK((lambda - VecX{{2.0 / 3, 5.0 / 3}}).norm() < 1e-12);
    CHECK(small03::enumerate(A, VecX{{-2, -1}}, lo, lambda) == 3);  // the ramp is guessed and is idle
    CHECK((lambda - VecX{{2, 0}}).norm() < 1e-12);

    const Real farthest = farthest_in_a_run(
        small03::ten_discs(), [](small03::Discs& d) { return small03::step(d, 1.0 / 240) > 0; },
        [](DiscScene& scene) {
            return library_step(scene, [](const Mlcp& mlcp, Solution& solution) {
                solution = schur(mlcp);
                return solution.status == Status::solved;
            });
        });
    CHECK(farthest < 1e-12);                                                              // both are exact
    CHECK(work_of_the_text<small03::Discs>(small03::ten_discs, small03::step) == 28693);  // section 3.10
}

TEST_CASE("the small program of chapter 4 has the numbers of the text and the library's to 1e-12")
{
    // By hand, (4.2): after each sweep half is missing.
    const MatX A{{1, -1}, {-1, 2}};
    const VecX q{{-1, 0}}, lo = VecX::Zero(2);
    VecX lambda = lo, same = lo;
    for (int sweep = 1; sweep <= 10; ++sweep) {
        CHECK(small04::pgs(A, q, lo, lambda, 1) == 1);
        sweep_forward(contacts_only(A, q), same);
        CHECK(lambda == same);  // powers of two: every digit
        CHECK(lambda == VecX{{2 - std::ldexp(2, -sweep), 1 - std::ldexp(1, -sweep)}});
    }

    const Real farthest = farthest_in_a_run(
        small04::ten_discs(), [](small04::Discs& d) { return small04::step(d, 1.0 / 240); },
        [](DiscScene& scene) {
            return library_step(scene, [](const Mlcp& mlcp, Solution& solution) {
                int sweeps = 0;
                for (Real off = 1; off > 1e-6; ++sweeps) {
                    const VecX before = solution.lambda;
                    sweep_forward(mlcp, solution.lambda);
                    off = dense(mlcp).diagonal().cwiseProduct(solution.lambda - before).cwiseAbs().maxCoeff();
                }
                return sweeps;
            });
        });
    CHECK(farthest < 1e-12);  // the same visits, whose sums have another order
    CHECK(work_of_the_text<small04::Discs>(small04::ten_discs, small04::step) == 14025);  // section 6.1
}

TEST_CASE("the small program of chapter 5 has the numbers of the text and the library's to 1e-12")
{
    // By hand, section 5.2.
    const MatX A{{2, 1}, {1, 2}};
    const VecX q{{-5, -6}}, lo = VecX::Zero(2);
    VecX z(2);
    CHECK(small05::lemke(A, q, lo, z, 2) == 2);
    CHECK((z - VecX{{0, 1}}).norm() < 1e-15);
    CHECK(small05::lemke(A, q, lo, z) == 3);
    CHECK((z - VecX{{4.0 / 3, 7.0 / 3}}).norm() < 1e-15);
    CHECK((z - lemke(contacts_only(A, q)).lambda).norm() < 1e-15);
    // (5.11): all ratios tie. Without (5.13) the first row that ties cycles on the one, the last on the other.
    for (const MatX& circle :
         {MatX{{1, 2, 0}, {0, 1, 2}, {2, 0, 1}}, MatX{{1, 0, 2}, {2, 1, 0}, {0, 2, 1}}}) {
        VecX third(3);
        CHECK(small05::lemke(circle, VecX::Constant(3, -1), VecX::Zero(3), third, 100) <= 6);
        CHECK((third - VecX::Constant(3, 1.0 / 3)).norm() < 1e-15);
    }
    // (5.20): exactly 2ⁿ pivots; here n = 2.
    CHECK(small05::lemke(MatX{{1, 2}, {0, 1}}, VecX{{-6, -4}}, lo, z) == 4);

    const Real farthest = farthest_in_a_run(
        small05::ten_discs(), [](small05::Discs& d) { return small05::step(d, 1.0 / 240); },
        [](DiscScene& scene) {
            return library_step(scene, [](const Mlcp& mlcp, Solution& solution) {
                solution = lemke(mlcp);
                return solution.iterations;
            });
        });
    CHECK(farthest < 1e-12);  // both are exact
    // section 5.9: ties that rounding decides may add or save some
    CHECK(work_of_the_text<small05::Discs>(small05::ten_discs, small05::step) == Approx(4109).epsilon(0.02));
}

namespace {

// What the sentences of these chapters say.

Numbers corner(Numbers in)
{
    const Eigen::MatrixXd J{{0, 1}, {0.6, 0.8}}, A = J * J.transpose();
    const Eigen::VectorXd u{{in["x"], in["y"]}};
    Eigen::VectorXd lambda;
    REQUIRE(small03::enumerate(A, J * u, two_zeros, lambda) > 0);
    const Eigen::VectorXd v = u + J.transpose() * lambda;
    return {{"floor", lambda[0]}, {"ramp", lambda[1]}, {"x", v[0]}, {"y", v[1]}};
}

Numbers column(Numbers in)
{
    const double mass = in["mass"];
    const Eigen::MatrixXd A{{1, -1}, {-1, 1 + 1 / mass}};
    Eigen::VectorXd lambda = two_zeros;
    for (int n = 0; n < in["sweeps"]; ++n) small04::pgs(A, Eigen::VectorXd{{-1, 0}}, two_zeros, lambda, 1);
    return {{"first", lambda[0]}, {"second", lambda[1]}, {"missing", 100 * (1 - lambda[0] / (1 + mass))}};
}

Numbers cones(Numbers in)
{
    const Eigen::MatrixXd A{{2, 1}, {1, 2}};
    Eigen::VectorXd z = two_zeros;
    const int pivots = small05::lemke(A, Eigen::VectorXd{{in["q1"], in["q2"]}}, two_zeros, z);
    return {{"pivots", pivots}, {"z1", z[0]}, {"z2", z[1]}};
}

const Sentence says_corner("corner", corner, 1e-12);
const Sentence says_column("column", column, 1e-12);
const Sentence says_cones("cones", cones, 1e-12);

}  // namespace
