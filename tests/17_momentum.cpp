/// Chapter 17: sweeps that go further where they go on in one direction.

#include "tests/wide_problems.hpp"

#include "tests/catch.hpp"

#include "chapters/17_wide_sweeps/line_rates.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

using namespace rigid;

namespace {

template <int L>
WideSolver<3, Real, L> with_momentum()
{
    WideSolver<3, Real, L> solver;
    solver.momentum = true;
    return solver;
}

}  // namespace

TEST_CASE("with the best momentum the slowest error of a line shrinks by 1 − sin θ a sweep", "[idea]")
{
    const int N = 40;
    const LineModes modes(N, 1);
    // bodies of 1 kg, the ends fixed: A has 2 on its diagonal and −1 beside it
    std::vector<Row<2>> rows = line_rows(N + 1);
    WideSolver<2> solver;
    bundle_rows(rows, N + 1, solver.bundles);
    solver.colour(Bodies<2>(N + 1), [&] {
        StepData<2> now;
        now.rows = rows;
        return now;
    }());
    // rows that a colour visits first have the mode's odd places
    VecX lambda = modes.coloured(), u = VecX::Zero(2 * (N + 1));
    for (int i = 0; i < N; ++i) rows[static_cast<std::size_t>(i)].apply(lambda[i], u);
    fill(WideProblem<2>{rows}, solver.bundles, lambda, u, solver.wide);
    SweepMomentum<2, Real, full_lanes<Real>> momentum;
    momentum.begin(solver.wide);
    const Real s = std::sqrt(1 - modes.rate()), z = 1 - s, beta = modes.best_momentum();
    CHECK(s == Approx(rigid::sin(pi / (N + 1))).epsilon(1e-13));
    const VecX start = lambda;
    for (int k = 1; k <= 60; ++k) {
        if (k > 1) momentum.go_on(beta, solver.wide);
        wide_sweep(solver.wide, Real{0}, 1, momentum);
        solver.take_out(WideProblem<2>{rows}, u, lambda);
        // (17.13): a double root, begun by a sweep without momentum
        const Real part = std::pow(z, k) * (1 + k * s);
        INFO("sweep " << k);
        // rounding of 60 sweeps over errors of size 1
        REQUIRE((lambda - part * start).cwiseAbs().maxCoeff() < 1e-13);
    }
}

TEST_CASE("momentum takes a cold pyramid to its answer in a sixth of the sweeps", "[idea]")
{
    Problem p = pyramid_problem(12);
    p.now.solution.lambda.setZero();
    const Answer plain = answer(p, with_momentum<4>(), 1, 1e-6),  // one sweep has nothing to go on
        same_plain = answer(p, WideSolver<3, Real, 4>{}, 1, 1e-6);
    CHECK(same(plain, same_plain));
    const Answer slow = answer(p, WideSolver<3, Real, 4>{}, 20000, 1e-6),
                 quick = answer(p, with_momentum<4>(), 20000, 1e-6);
    REQUIRE(slow.status == Status::solved);
    REQUIRE(quick.status == Status::solved);
    CHECK(6 * quick.iterations < slow.iterations);
    CHECK(natural_residual(p.now.rows, quick.lambda, quick.u, p.now.length) == quick.residual);
}

TEST_CASE("momentum pulls at no contact and leaves friction its bound", "[idea]")
{
    Problem p = pyramid_problem(8);
    VecX& lambda = p.now.solution.lambda;
    lambda.setZero();
    WideSolver<3> solver;
    bundle_rows(p.now.rows, p.scene.bodies.count(), solver.bundles);
    solver.colour(p.scene.bodies, p.now);
    const WideProblem<3> problem{p.now.rows};
    VecX u = p.now.u_star;
    fill(problem, solver.bundles, lambda, u, solver.wide);
    SweepMomentum<3, Real, full_lanes<Real>> momentum;
    momentum.begin(solver.wide);
    int stopped = 0;
    VecX before = lambda;
    for (int k = 0; k < 30; ++k) {
        if (k > 0) momentum.go_on(0.9, solver.wide);
        const VecX further = lambda + 0.9 * (lambda - before);
        before = lambda;
        wide_sweep(solver.wide, Real{0}, 1, momentum);
        solver.take_out(problem, u, lambda);
        for (std::size_t i = 0; i < p.now.rows.size(); ++i) {
            const Row<3>& row = p.now.rows[i];
            const auto n = static_cast<Index>(i);
            // friction goes first, and has the bound that its normal gave it then
            const Real reach = row.bounded_by < 0 ? 0 : row.friction * before[row.bounded_by];
            const Real lo = row.lo - reach, hi = row.hi + reach;
            REQUIRE(lambda[n] >= lo);
            REQUIRE(lambda[n] <= hi);
            stopped += further[n] < lo || further[n] > hi;
        }
    }
    CHECK(stopped > 50);  // so many would have gone beyond
}

TEST_CASE("momentum has the same bits in any number of lanes", "[house]")
{
    const Problem p = pyramid_problem(8);
    const Answer one = answer(p, with_momentum<1>(), 70);
    CHECK_FALSE(same(one, answer(p, WideSolver<3, Real, 1>{}, 70)));
    CHECK(same(one, answer(p, with_momentum<2>(), 70)));
    CHECK(same(one, answer(p, with_momentum<4>(), 70)));
    CHECK(same(one, answer(p, with_momentum<8>(), 70)));
}

TEST_CASE("sums of momentum have the same bundles in any number of lanes", "[house]")
{
    const Problem p = pyramid_problem(8);
    const auto places = [&]<int L>(WideSolver<3, Real, L> solver) {
        solver.begin(p.scene.bodies, p.now);
        std::vector<int> of_rows(p.now.rows.size(), -1);
        for (std::size_t i = 0; i < of_rows.size(); ++i)
            for (const Packet<L>& packet : solver.wide.packets)
                if (const auto [row, lane] = solver.wide.place[i];
                    row >= packet.first && row < packet.first + packet.rows)
                    of_rows[i] = packet.number * L + lane;
        return of_rows;
    };
    const std::vector<int> one = places(WideSolver<3, Real, 1>{});
    CHECK(*std::max_element(one.begin(), one.end()) > 8);
    CHECK(*std::min_element(one.begin(), one.end()) == 0);
    CHECK(places(WideSolver<3, Real, 2>{}) == one);
    CHECK(places(WideSolver<3, Real, 4>{}) == one);
    CHECK(places(WideSolver<3, Real, 8>{}) == one);
}

TEST_CASE("what momentum takes beyond a bound and a visit takes back is no change", "[idea]")
{
    using V = Lanes<Real, 1>;
    Problem p = pyramid_problem(1);
    WideSolver<3, Real, 1> solver;
    solver.begin(p.scene.bodies, p.now);
    VecX lambda = VecX::Ones(static_cast<Index>(p.now.rows.size()));
    fill(WideProblem<3>{p.now.rows}, solver.bundles, lambda, p.now.u_star, solver.wide);
    SweepMomentum<3, Real, 1> momentum;
    momentum.begin(solver.wide);
    for (auto& row : solver.wide.rows) row.lambda = V{};  // as a sweep has left them: at their bounds
    momentum.go_on(0.5, solver.wide);
    const Packet<1>& packet = solver.wide.packets[0];
    auto visits = momentum.visits(packet);
    for (int r = 0; r < packet.rows; ++r) {
        const auto at = static_cast<std::size_t>(packet.first + r);
        auto& row = solver.wide.rows[at];
        visits.before(r, row, solver.wide.shapes[at], V{});
        CHECK(lane(row.lambda, 0) == -0.5);
        row.lambda = V{};
        visits.after(r, row);
    }
    CHECK(lane(visits.most, 0) == 0);
    CHECK(lane(visits.back, 0) == 0);
}

TEST_CASE("λ and u belong together whatever momentum has done", "[idea]")
{
    const Problem p = pyramid_problem(8);
    const auto drift = [&](auto solver) {
        solver.momentum = true;
        const Answer found = answer(p, solver, 200);
        VecX u = p.now.u_star;
        for (std::size_t i = 0; i < p.now.rows.size(); ++i)
            p.now.rows[i].apply(found.lambda[static_cast<Index>(i)], u);
        return (found.u - u).cwiseAbs().maxCoeff();
    };
    // sums of 400 sweeps' changes of speeds of 0.2 m/s; floats take u from λ after each pass
    CHECK(drift(WideSolver<3>{}) < 1e-12);
    CHECK(drift(WideSolver<3, float>{}) < 1e-12);
}

TEST_CASE("momentum finds what sweeps find and loses little where it gains nothing", "[idea]")
{
    Random random(17);
    int more = 0;
    for (int trial = 0; trial < 40; ++trial) {
        Problem p;
        VecX inverse_mass;
        const Index bodies = 30;
        p.now.rows = random_rows(random, bodies, 60, inverse_mass);
        p.scene.bodies = Bodies<3>(bodies);
        p.scene.bodies.inverse_mass = inverse_mass;
        for (int k = 0; k < bodies; ++k) p.now.active.push_back(k);
        p.now.u_star = VecX::NullaryExpr(3 * bodies, [&] { return random.uniform(-1, 1); });
        for (Index i = 0; i < 3 * bodies; ++i)
            if (!(inverse_mass[i] > 0)) p.now.u_star[i] = 0;
        p.now.length = 1;
        const Answer plain = answer(p, WideSolver<3>{}, 4000, 1e-8), other = [&] {
            WideSolver<3> solver;
            solver.momentum = true;
            return answer(p, solver, 4000, 1e-8);
        }();
        INFO("trial " << trial << ": " << plain.iterations << " and " << other.iterations << " sweeps");
        if (plain.status == Status::solved) CHECK(other.status == Status::solved);
        // windows of 256 sweeps that were of no use, each followed by one without momentum
        CHECK(other.iterations <= 4 * plain.iterations + 512);
        more += other.iterations > plain.iterations;
    }
    CHECK(more < 15);
}
