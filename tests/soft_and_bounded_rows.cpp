/// Rows that give way, and rows whose bounds another row's impulse sets: every solver answers them alike.

#include "chapters/07_baumgarte/one_row_step.hpp"
#include "chapters/08_warm_starting/warm_method.hpp"
#include "chapters/09_active_sets/exact_method.hpp"
#include "chapters/10_skipping_work/by_islands.hpp"
#include "common/random.hpp"

#include "tests/catch.hpp"
#include "tests/sentence.hpp"

#include <string>
#include <vector>

using namespace rigid;

namespace {

/// Bodies, u* and rows, without a scene.
struct Problem {
    Bodies<2> bodies;
    VecX u_star;
    std::vector<Row<2>> rows;
};

Row<2> between(const Problem& problem, Index a, Index b, const Vec2& n, Real bias, Real lo, Real hi)
{
    const Constraint<2> c{a, b, 0, a == world ? RowVec<2>::Zero() : RowVec<2>(-n.transpose()), n.transpose()};
    return make_row(c, problem.bodies.inverse_mass, bias, lo, hi);
}

Vec2 direction(Random& random)
{
    const Real angle = random.uniform(0, 2 * pi);
    return {std::cos(angle), std::sin(angle)};
}

/// K bodies of 0.5 to 5 kg, each joined to a few others.
Problem random_bodies(Index K, Random& random)
{
    Problem problem;
    problem.bodies = Bodies<2>(K);
    for (Index k = 0; k < K; ++k)
        problem.bodies.inverse_mass.segment<2>(2 * k).setConstant(1 / random.uniform(0.5, 5));
    problem.u_star = VecX::Zero(2 * K);
    for (Index i = 0; i < 2 * K; ++i) problem.u_star[i] = random.uniform(-1, 1);
    return problem;
}

/// Rods and contacts, half of them soft. The hard ones do not contradict each other: one velocity keeps to all.
Problem soft_problem(Random& random)
{
    Problem problem = random_bodies(6, random);
    VecX fits(12);
    for (Index i = 0; i < 12; ++i) fits[i] = random.uniform(-1, 1);
    for (int i = 0; i < 9; ++i) {
        const Index b = 1 + random.index(5), a = random.index(b + 1) - 1;
        const Vec2 n = direction(random);
        const Real bias = random.uniform(-0.5, 0.5);
        problem.rows.push_back(between(problem, a, b, n, bias, i % 2 ? 0 : -infinity, infinity));
        Row<2>& row = problem.rows.back();
        if (i % 4 < 2) row.softness = random.uniform(0.01, 2);
        else row.bias -= row.velocity(fits) - (i % 2 ? random.uniform(0, 0.5) : 0);
    }
    return problem;
}

/// Contacts of bodies above each other, each with the friction row that it bounds, μ up to `most`.
Problem friction_problem(Random& random, Real most, bool friction_first)
{
    Problem problem = random_bodies(5, random);
    for (Index b = 0; b < 5; ++b) {
        problem.u_star[2 * b + 1] = -random.uniform(0.5, 1.5);
        const Real tilt = random.uniform(-0.2, 0.2), mu = random.uniform(0, most);
        const Vec2 n(std::sin(tilt), std::cos(tilt));
        Row<2> contact = between(problem, b - 1, b, n, 0, 0, infinity);
        Row<2> friction = between(problem, b - 1, b, Vec2(n.y(), -n.x()), 0, -infinity, infinity);
        friction.friction = mu;
        const auto first = static_cast<int>(problem.rows.size());
        friction.bounded_by = friction_first ? first + 1 : first;
        problem.rows.push_back(friction_first ? friction : contact);
        problem.rows.push_back(friction_first ? contact : friction);
    }
    return problem;
}

struct Answer {
    std::string name;
    VecX lambda, u;
    Status status = Status::iteration_limit;
};

template <class Solver>
Answer answer_of(const std::string& name, const Problem& problem, Solver solver)
{
    Problem copy = problem;
    StepData<2> now;
    now.rows = problem.rows;
    now.u_star = problem.u_star;
    now.h = 0.01;
    for (int k = 0; k < static_cast<int>(problem.bodies.count()); ++k) now.active.push_back(k);
    now.solution.lambda.setZero(static_cast<Index>(now.rows.size()));
    solver.solve(copy.bodies, now);
    return {name, now.solution.lambda, copy.bodies.u, now.solution.status};
}

std::vector<Answer> all_answers(const Problem& problem)
{
    const ImpulseSettings tight{200000, 1e-10};
    std::vector<Answer> answers;
    answers.push_back(answer_of("active sets", problem, ExactSolver{}));
    for (const Order order : {Order::given, Order::alternating, Order::shuffled, Order::coloured})
        for (const bool in_pairs : {false, true}) {
            ImpulseSolver<2> solver;
            solver.sweeps = tight;
            solver.ordering = order;
            solver.in_pairs = in_pairs;
            answers.push_back(
                answer_of(std::string(to_string(order)) + (in_pairs ? " pairs" : " rows"), problem, solver));
        }
    for (const int exact_rows : {0, 8}) {
        IslandSolver<2> islands;
        islands.sweeps = tight;
        islands.exact_rows = exact_rows;
        answers.push_back(answer_of("islands", problem, islands));
    }
    return answers;
}

/// (3.15) with the bounds and the softness of the rows [m/s].
Real residual_of(const Problem& problem, const Answer& answer)
{
    Real largest = 0;
    for (std::size_t i = 0; i < problem.rows.size(); ++i) {
        const Row<2>& row = problem.rows[i];
        const Real lambda = answer.lambda[static_cast<Index>(i)];
        const auto [lo, hi] = bounds_of(row, answer.lambda);
        const Real w = row.velocity(answer.u) + row.softness * lambda;
        largest = std::max(largest, natural_residual_row(row.diagonal(), lambda, w, lo, hi));
    }
    return largest;
}

/// A disc on a slope: one contact and the friction that it bounds. `down` is measured along the slope.
struct SlopeScene {
    static constexpr int dof = 2;
    Bodies<2> bodies{1};
    Vec2 gravity = {0, -9.81};
    Real angle = 0, friction = 0;
    Real belt = 0;  ///< speed of the slope along itself [m/s]

    Vec2 normal() const { return {std::sin(angle), std::cos(angle)}; }
    Vec2 along() const { return {std::cos(angle), -std::sin(angle)}; }
};

Real own_restitution(const SlopeScene&, const StepData<2>&, std::size_t) { return 0; }

void free_velocities(SlopeScene& scene, const StepSettings& settings, StepData<2>& now)
{
    now.u_star = scene.bodies.u + settings.part() * scene.gravity;
}

Constraint<2> constraint_at(const SlopeScene& scene, const StepData<2>&, std::size_t i, const VecX& x)
{
    if (i == 0)
        return {world,
                0,
                scene.normal().dot(x),
                RowVec<2>::Zero(),
                scene.normal().transpose(),
                ConstraintKind::unilateral};
    Constraint<2> c{world, 0, 0, RowVec<2>::Zero(), scene.along().transpose(), ConstraintKind::friction};
    c.bounded_by = 0;
    c.friction = scene.friction;
    c.speed = scene.belt;
    return c;
}

void evaluate_constraints(const SlopeScene& scene, StepData<2>& now)
{
    now.constraints.clear();
    for (std::size_t i = 0; i < 2; ++i)
        now.constraints.push_back(constraint_at(scene, now, i, scene.bodies.x));
}

struct TwoRows : PlainContacts {
    template <class Scene, class Method>
    void begin(const Scene&, const StepSettings&, Method&, StepData<2>& now) const
    {
        now.active = {0};
        now.sources = {{Source::Of::joint, 0}, {Source::Of::joint, 1}};
    }
};

template <class Contacts, class Solver>
struct StepMethod {
    Contacts contacts;
    Correction correction;
    WarmStart start;
    Solver solver;
};

/// Calls use(name, method) for one method with each kind of solver and start.
template <class Contacts, class Use>
void for_each_method(const Use& use)
{
    for (const Start start : {Start::cold, Start::previous, Start::best_multiple})
        for (const Stabilizer way : {Stabilizer::none, Stabilizer::baumgarte, Stabilizer::relaxation,
                                     Stabilizer::split_impulse, Stabilizer::projection}) {
            const std::string name = std::string(to_string(start)) + ", " + std::string(to_string(way));
            const auto with = [&](const std::string& solver_name, auto method) {
                method.start.from = start;
                method.correction.method = way;
                use(solver_name + ", " + name, method);
            };
            StepMethod<Contacts, ImpulseSolver<2>> sweeps;
            sweeps.solver.sweeps = {1000, 1e-13};
            with("rows", sweeps);
            sweeps.solver.in_pairs = true;
            with("pairs", sweeps);
            StepMethod<Contacts, ExactSolver> exact;
            exact.solver.find.settings.tolerance = 1e-13;
            with("active sets", exact);
        }
}

/// One body on a spring along x, from its C = x.
struct OnASpring {
    Real stiffness = 0, damping = 0;

    Constraint<2> operator()(const VecX& x) const
    {
        Constraint<2> c{world, 0, x[0], RowVec<2>::Zero(), RowVec<2>(1, 0), ConstraintKind::spring};
        c.stiffness = stiffness;
        c.damping = damping;
        return c;
    }
};

}  // namespace

TEST_CASE("every solver gives rows that give way the one answer that their softness makes unique")
{
    Random random(11);
    for (int trial = 0; trial < 100; ++trial) {
        const Problem problem = soft_problem(random);
        const std::vector<Answer> answers = all_answers(problem);
        for (const Answer& answer : answers) {
            INFO("trial " << trial << ", " << answer.name);
            REQUIRE(answer.status == Status::solved);
            // A residual of 1e-10 m/s was asked for; exact answers are held to 1e-10 of the numbers in a row.
            REQUIRE(residual_of(problem, answer) < 1e-9);
            // The velocities are one answer where some rows are hard; their condition is below 1e4 here.
            REQUIRE((answer.u - answers.front().u).cwiseAbs().maxCoeff() < 1e-5);
        }
    }
}

TEST_CASE("every solver finds impulses of friction that keep to the bounds that they set themselves")
{
    Random random(12);
    for (int trial = 0; trial < 200; ++trial) {
        const Problem problem = friction_problem(random, 0.6, trial % 2 == 1);
        for (const Answer& answer : all_answers(problem)) {
            INFO("trial " << trial << ", " << answer.name);
            REQUIRE(answer.status == Status::solved);
            // The tolerance of the sweeps is 1e-10 m/s; rounds of fixed bounds end at 1e-9 of the numbers.
            REQUIRE(residual_of(problem, answer) < 1e-8);
        }
    }
}

TEST_CASE("a body on an implicit spring has the velocity of the closed form whatever solves its row")
{
    // v' = (v − h ω² x) / (1 + 2 ζ h ω + h² ω²), here without gravity along x; numbers of order 1, a few roundings.
    for (const Real omega : {0.1, 10.0, 188.5, 1e5})
        for (const Real zeta : {0.0, 0.7, 10.0})
            for_each_method<OneRowContacts>([&](const std::string& name, auto method) {
                const Real mass = 2, h = 1.0 / 240;
                OneRowScene<OnASpring> scene;
                scene.bodies.inverse_mass.setConstant(1 / mass);
                scene.bodies.x << 0.3, 0;
                scene.bodies.u << -0.4, 0;
                scene.gravity.setZero();
                scene.at = {mass * omega * omega, 2 * zeta * mass * omega};
                StepData<2> now;
                Real x = 0.3, v = -0.4;
                for (int n = 0; n < 5; ++n) {
                    v = (v - h * omega * omega * x) / (1 + 2 * zeta * h * omega + h * h * omega * omega);
                    x += h * v;
                    step(scene, {.h = h}, method, now);
                }
                INFO(name << ", omega " << omega << ", zeta " << zeta);
                CHECK(scene.bodies.u[0] == Approx(v).epsilon(1e-11).margin(1e-12));
                CHECK(scene.bodies.x[0] == Approx(x).epsilon(1e-11).margin(1e-12));
            });
}

TEST_CASE("a spring never adds energy at any step")
{
    for (const Real omega : {1.0, 1e3, 1e6, 1e9}) {
        OneRowScene<OnASpring> scene;
        scene.bodies.x << 0.3, 0;
        scene.bodies.u << -0.4, 0;
        scene.gravity.setZero();
        scene.at = {omega * omega, 0};
        OneRowMethod method;
        StepData<2> now;
        const auto energy = [&] {
            return 0.5 * scene.bodies.u.squaredNorm() +
                   0.5 * omega * omega * scene.bodies.x[0] * scene.bodies.x[0];
        };
        Real before = energy();
        for (int n = 0; n < 1000; ++n) {
            step(scene, {.h = 1.0 / 60}, method, now);
            REQUIRE(energy() <= before * (1 + 1e-12));  // rounding of a few products
            before = energy();
        }
    }
}

TEST_CASE("the best multiple of one soft row is its answer")
{
    Random random(15);
    for (int trial = 0; trial < 20; ++trial) {
        Problem problem = random_bodies(2, random);
        const Real bias = random.uniform(0.1, 1);
        problem.rows.push_back(between(problem, 0, 1, direction(random), bias, -infinity, infinity));
        Row<2>& row = problem.rows[0];
        row.softness = random.uniform(0.1, 5);
        BodyGroups groups;
        find_groups<2>(problem.rows, problem.bodies.inverse_mass, groups);
        MultipleScratch scratch;
        const Real answer = -row.velocity(problem.u_star) / row.diagonal();
        VecX lambda = VecX::Constant(1, 0.3 * answer);
        best_multiple<2>(problem.rows, problem.bodies.inverse_mass, problem.u_star, groups, scratch, lambda);
        CHECK(lambda[0] == Approx(answer).epsilon(1e-12));  // a division and a few products
    }
}

TEST_CASE("a body on a slope sticks below the angle of friction and slides above it as the closed form says")
{
    const Real mu = 0.3, h = 1.0 / 60, g = 9.81;
    for (const Real degrees : {0.0, 10.0, 16.5, 16.9, 30.0, 60.0})
        for_each_method<TwoRows>([&](const std::string& name, auto method) {
            SlopeScene scene;
            scene.angle = degrees * pi / 180;
            scene.friction = mu;
            scene.bodies.inverse_mass.setConstant(0.25);
            StepData<2> now;
            const int steps = 30;
            for (int n = 0; n < steps; ++n) step(scene, {.h = h}, method, now);
            const Real t = steps * h;
            const Real a = std::max(Real{0}, g * (std::sin(scene.angle) - mu * std::cos(scene.angle)));
            INFO(name << ", " << degrees << " degrees");
            // The scheme's own closed form: d = ½ a t² (1 + h/t). Rounding of 30 sums of numbers up to 5.
            CHECK(scene.along().dot(scene.bodies.x) == Approx(a * t * t / 2 * (1 + h / t)).margin(1e-10));
            CHECK(scene.normal().dot(scene.bodies.x) == Approx(0).margin(1e-12));
        });
}

TEST_CASE("a belt takes a body along until it has the belt's speed")
{
    for_each_method<TwoRows>([&](const std::string& name, auto method) {
        SlopeScene scene;
        scene.friction = 0.5;
        scene.belt = 1;
        StepData<2> now;
        Real wanted = 0;
        for (int n = 0; n < 30; ++n) {
            step(scene, {.h = 1.0 / 60}, method, now);
            wanted = std::min(Real{1}, wanted + 0.5 * 9.81 / 60);  // μ g h a step
            INFO(name << ", step " << n);
            CHECK(scene.bodies.u[0] == Approx(wanted).margin(1e-11));
        }
    });
}

TEST_CASE("the residual of a row that another one bounds is that of the bounds of this moment")
{
    Problem problem;
    problem.bodies = Bodies<2>(1);
    problem.rows.push_back(between(problem, world, 0, {0, 1}, 0, 0, infinity));
    problem.rows.push_back(between(problem, world, 0, {1, 0}, 0, -infinity, infinity));
    problem.rows[1].bounded_by = 0;
    problem.rows[1].friction = 0.5;
    ImpulseMemory<2> memory;
    Solution solution;
    solution.lambda = Vec2(2, 0.75);
    begin_sweeps<2>(problem.rows, {}, 0, memory, VecX(Vec2(-0.75, -2)), solution);
    CHECK(natural_residual(memory) == 0);  // both rows have w = 0
    memory.rows[0].lambda = 1;             // now half of it is the most that friction may give
    CHECK(natural_residual(memory) == 0.25);
}

TEST_CASE("rows with feedback elsewhere do not change one bit of the rows without")
{
    Random random(13);
    for (int trial = 0; trial < 50; ++trial) {
        Problem plain = random_bodies(8, random);
        for (int i = 0; i < 8; ++i) {
            const Index b = 1 + random.index(5), a = random.index(b + 1) - 1;
            const Vec2 n = direction(random);
            plain.rows.push_back(between(plain, a, b, n, 0, i % 2 ? 0 : -infinity, infinity));
        }
        Problem more = plain;  // bodies 6 and 7 are joined to no other
        more.rows.push_back(between(more, 6, 7, {1, 0}, 0.1, 0, infinity));
        more.rows.push_back(between(more, 6, 7, {0, 1}, 0.1, -infinity, infinity));
        more.rows.back().bounded_by = 8;
        more.rows.back().friction = 0.5;
        ImpulseSolver<2> solver;
        solver.sweeps.max_sweeps = 7;
        const Answer alone = answer_of("alone", plain, solver), beside = answer_of("beside", more, solver);
        CHECK(beside.u.head(12) == alone.u.head(12));
        CHECK(beside.lambda.head(8) == alone.lambda);
    }
}

TEST_CASE("a soft row or a bounded one that makes no sense is refused by name")
{
    Random random(14);
    Problem problem = friction_problem(random, 0.5, false);
    const auto refused = [&](const auto& change) {
        std::vector<Row<2>> rows = problem.rows;
        change(rows);
        return sentence_of([&] { assemble(rows, problem.u_star); });
    };
    CHECK(refused([](auto& rows) { rows[3].bounded_by = 10; }) ==
          "row 3 is bounded by row 10; there are 10 rows");
    CHECK(refused([](auto& rows) { rows[3].bounded_by = 1; }) ==
          "row 3 is bounded by row 1, which another row bounds itself");
    CHECK(refused([](auto& rows) { rows[2].lo = -1; }) ==
          "row 3 is bounded by row 2, which may pull; a row that bounds others must only push");
    CHECK(refused([](auto& rows) { rows[1].friction = -0.5; }) ==
          "row 1 has the friction coefficient -0.5; it must be zero or positive and finite");
    CHECK(refused([](auto& rows) { rows[0].softness = -1; }) ==
          "row 0 has the softness -1 1/kg; it must be zero or positive and finite");
    CHECK(refused([](auto&) {}) == "accepted");
}
