/// Chapter 24: disc friction solved exactly, Algorithm 24.2.

#include "tests/no_allocation.hpp"

#include "chapters/21_joints_in_space/joint_makers.hpp"
#include "chapters/24_friction_is_a_disc/rough_touching.hpp"
#include "chapters/24_friction_is_a_disc/solid_scenes.hpp"

#include "tests/catch.hpp"
#include "tests/sentence.hpp"

using namespace rigid;

namespace {

/// u* + M⁻¹Jᵀλ of the last step: u itself is written in axes that have turned since.
VecX solved_velocities(const StepData<6>& now)
{
    VecX u = now.u_star;
    for (std::size_t k = 0; k < now.rows.size(); ++k)
        now.rows[k].apply(now.solution.lambda[static_cast<Index>(k)], u);
    return u;
}

/// How far a step is from Coulomb's law, by the formulas and not by the solver: (24.3) with ρ = 1/L of each disc, and
/// the natural residual of the other rows [m/s].
Real coulomb_error(const StepData<6>& now)
{
    const VecX u = solved_velocities(now);
    const auto at = [&](std::size_t k) { return now.solution.lambda[static_cast<Index>(k)]; };
    Real worst = 0;
    for (std::size_t k = 0; k < now.rows.size(); ++k) {
        const Row<6>& row = now.rows[k];
        const auto mobility = [](const Row<6>& r, const Row<6>& s) {
            return (r.a == world ? 0 : r.Ja.dot(s.Wa)) + r.Jb.dot(s.Wb);
        };
        const Real a = mobility(row, row);
        if (!(a > 0)) continue;
        const bool pairs = row.bounded_by >= 0 && k + 1 < now.rows.size() &&
                           (now.sources[k].part == first_tangent || now.sources[k].part == first_roll);
        if (!pairs) {
            Real lo = row.lo, hi = row.hi;
            if (row.bounded_by >= 0)
                hi = row.friction * at(static_cast<std::size_t>(row.bounded_by)), lo = -hi;
            worst = std::max(worst, a * std::abs(at(k) - std::clamp(at(k) - row.velocity(u) / a, lo, hi)));
            continue;
        }
        const Row<6>& next = now.rows[k + 1];
        const Real b = mobility(next, next), c = mobility(row, next);
        const Real L = (a + b) / 2 + std::hypot((a - b) / 2, c);
        const Vec2 lambda(at(k), at(k + 1)), w(row.velocity(u), next.velocity(u));
        const Vec2 z = lambda - w / L;
        const Real r = row.friction * at(static_cast<std::size_t>(row.bounded_by));
        worst = std::max(worst, L * (lambda - (z.norm() > r ? Vec2(z * (r / z.norm())) : z)).norm());
        ++k;
    }
    return worst;
}

/// Boxes thrown at each other and at a floor, some of them on a joint.
RoughSolids thrown_boxes(std::uint64_t seed, int boxes, Real mu)
{
    Random random(seed);
    const auto triple = [&random](Real size) {
        const Real x = random.uniform(-size, size), y = random.uniform(-size, size),
                   z = random.uniform(-size, size);
        return Vec3(x, y, z);
    };
    RoughSolids scene;
    for (int i = 0; i < boxes; ++i) {
        const Vec3 size = Vec3(1, 0.8, 1) + triple(0.15);
        const Vec3 theta(0, random.uniform(-1, 1), 0);
        add_body(scene, {solid_box(size)}, random.uniform(200, 2000), {0, 0.4 + 0.8 * i, 0}, theta);
        scene.bodies.position(i).y() =
            i == 0 ? size.y() / 2
                   : scene.bodies.position(i - 1).y() +
                         scene.shapes[static_cast<std::size_t>(i) - 1][0].vertices[0].cwiseAbs().y() +
                         size.y() / 2;
        const Vec3 way = triple(1.5);
        scene.bodies.velocity(i).head<3>() = Vec3(way.x(), 0, way.z());
        scene.bodies.velocity(i)[4] = random.uniform(-2, 2);
    }
    add_floor(scene, mu);
    return scene;
}

/// Balls that have rolled together in the pit of the heap and are struck: one point to a pair, and one answer.
RoughSolids struck_balls(std::uint64_t seed)
{
    RoughSolids scene = mixed_heap(10, 0.3, seed);
    Random random(seed);
    for (auto& shape : scene.shapes) shape = {solid_ball(0.25)};
    for (Index k = 0; k < 10; ++k) {
        const Real moment = 0.4 * 65 * 0.0625;
        scene.bodies.inverse_mass.segment<6>(6 * k) << Vec3::Constant(1.0 / 65), Vec3::Constant(1 / moment);
    }
    RoughCones method;
    StepData<6> now;
    for (int i = 0; i < 90; ++i) step(scene, {.h = 1.0 / 60}, method, now);
    for (Index i = 0; i < scene.bodies.u.size(); ++i) scene.bodies.u[i] += random.uniform(-0.5, 0.5);
    return scene;
}

Real farthest(const VecX& from, const VecX& to)
{
    Real most = 0;
    for (Index k = 0; k < to.size() / 6; ++k)
        most = std::max(most, (to.segment<3>(6 * k) - from.segment<3>(6 * k)).norm());
    return most;
}

/// How far anything moves in four seconds, and how often there was no answer.
std::pair<Real, int> four_seconds(RoughSolids scene, int substeps)
{
    const VecX start = scene.bodies.x;
    RoughCones method = solved_exactly();
    StepData<6> now;
    int unsolved = 0;
    for (int i = 0; i < 240; ++i) {
        step(scene, {.h = 1.0 / 60, .substeps = substeps}, method, now);
        unsolved += now.solution.status != Status::solved;
    }
    return {farthest(start, scene.bodies.x), unsolved};
}

RoughSolids under_a_load(int boxes, Real ratio)
{
    RoughSolids scene = box_stack(boxes, 0.05, 0.5);
    scene.bodies.inverse_mass.tail<6>() /= ratio;
    return scene;
}

}  // namespace

TEST_CASE("a block that slides is slowed by exactly mu g h against its velocity", "[house]")
{
    for (int i = 0; i < 24; ++i) {
        const Real phi = i * pi / 12;
        RoughSolids scene = sliding_block(3, phi, 0.4);
        RoughCones method = solved_exactly();
        StepData<6> now;
        step(scene, {.h = 1.0 / 240}, method, now);
        REQUIRE(now.solution.status == Status::solved);
        const Vec3 expected = (3 - 0.4 * 9.81 / 240) * Vec3(rigid::cos(phi), 0, -rigid::sin(phi));
        // the residual that is asked for is 1e-9 ℓ/s
        CHECK((solved_velocities(now).head<3>() - expected).norm() < 2e-9);
        CHECK(solved_velocities(now).tail<3>().norm() < 2e-9);
    }
}

TEST_CASE("exact friction is Coulomb's where it says so", "[house]")
{
    int sliding = 0, solved = 0;
    for (const std::uint64_t seed : {1u, 2u, 3u, 4u, 5u, 6u}) {
        RoughSolids scene = thrown_boxes(seed, 6, 0.5);
        RoughCones method = solved_exactly();
        StepData<6> now;
        for (int i = 0; i < 60; ++i) {
            step(scene, {.h = 1.0 / 60}, method, now);
            if (now.solution.status != Status::solved) continue;
            ++solved;
            // u of the step was summed in another order: rounding of 5 m/s beside 1e-9 ℓ/s
            CHECK(coulomb_error(now) <= 1e-9 * now.length + 1e-12);
            const VecX u = solved_velocities(now);
            for (std::size_t k = 0; k < now.rows.size(); ++k)
                sliding += now.sources[k].part == first_tangent && std::abs(now.rows[k].velocity(u)) > 0.01;
        }
    }
    CHECK(solved >= 350);  // of 360
    CHECK(sliding > 500);
}

TEST_CASE("exact friction moves balls as sweeps do that have converged", "[house]")
{
    for (const std::uint64_t seed : {11u, 12u, 13u}) {
        RoughSolids swept = struck_balls(seed), exact = swept;
        RoughCones by_sweeps, by_guesses = solved_exactly();
        by_sweeps.solver.sweeps = {200000, 1e-12};
        StepData<6> now, other;
        step(swept, {.h = 1.0 / 60}, by_sweeps, now);
        step(exact, {.h = 1.0 / 60}, by_guesses, other);
        REQUIRE(now.solution.status == Status::solved);
        REQUIRE(other.solution.status == Status::solved);
        CHECK(now.rows.size() > 30);
        // residuals of 1e-9 ℓ/s, through a heap of ten
        CHECK((solved_velocities(now) - solved_velocities(other)).norm() < 1e-7);
    }
}

TEST_CASE("faces that slide and spin on four points have more than one answer", "[house]")
{
    for (const std::uint64_t seed : {11u, 12u, 13u}) {
        RoughSolids swept = thrown_boxes(seed, 3, 0.4), exact = swept;
        RoughCones by_sweeps, by_guesses = solved_exactly();
        by_sweeps.solver.sweeps = {200000, 1e-9};
        StepData<6> now, other;
        step(swept, {.h = 1.0 / 60}, by_sweeps, now);
        step(exact, {.h = 1.0 / 60}, by_guesses, other);
        // which point carries how much is free, and friction turns the box by it: both obey Coulomb's law
        CHECK(coulomb_error(now) <= 1e-9 * now.length + 1e-12);
        CHECK(coulomb_error(other) <= 1e-9 * now.length + 1e-12);
        CHECK((solved_velocities(now) - solved_velocities(other)).norm() > 1e-2);  // [m/s]
    }
}

TEST_CASE("exact friction with moments and joints is Coulomb's too", "[house]")
{
    RoughSolids scene;
    add_body(scene, {solid_ball(0.5)}, 500.0, {0, 0.5, 0});
    add_body(scene, {solid_ball(0.4)}, 500.0, {1.2, 0.4, 0.1});
    add_body(scene, {solid_box({0.6, 0.6, 0.6})}, 800.0, {2.2, 0.3, 0});
    scene.joints.push_back(ball_joint(scene, 0, 1, {0.6, 0.5, 0}));
    scene.joints.push_back(hinge(scene, 1, 2, {1.7, 0.4, 0}, {0, 1, 0}));
    add_floor(scene, 0.4);
    scene.rolling.assign(3, 0.02), scene.spinning.assign(3, 0.01);
    scene.bodies.velocity(0).head<3>() = Vec3(1, 0, 2);
    scene.bodies.velocity(1)[4] = 5;
    scene.bodies.velocity(2).head<3>() = Vec3(-1, 0, -1);
    RoughCones method = solved_exactly();
    StepData<6> now;
    int moments = 0;
    for (int i = 0; i < 120; ++i) {
        step(scene, {.h = 1.0 / 120}, method, now);
        REQUIRE(now.solution.status == Status::solved);
        CHECK(coulomb_error(now) <= 1e-9 * now.length + 1e-12);
        for (const Source& source : now.sources)
            moments += source.of == Source::Of::contact && source.part >= first_roll;
    }
    CHECK(moments > 500);
}

TEST_CASE("the velocities of four coplanar points do not depend on where the guesses begin", "[house]")
{
    for (const Real speed : {0.0, 2.0}) {
        RoughSolids scene = sliding_block(speed, 0.7, 0.5);
        VecX u[2], lambda[2];
        for (const int start : {0, 1}) {
            RoughSolids copy = scene;
            RoughCones method = solved_exactly();
            method.solver.sweeps.tolerance = 1e-13;
            StepData<6> now;
            if (start == 1) {  // the load of all four on two corners
                method.start.from = Start::previous;
                step(copy, {.h = 1.0 / 60}, method, now);
                VecX uneven = now.solution.lambda;
                const Index m = uneven.size();
                uneven.tail(4) += 0.4 * uneven.tail(4).mean() * Vec<4>(1, -1, -1, 1);
                REQUIRE(m == 12);
                // solve the same rows from there
                copy = scene;
                now.solution.lambda = uneven;
                copy.bodies.u = now.u_star;
                now.substep = 0;
                method.solver.solve(copy.bodies, now);
                u[1] = solved_velocities(now), lambda[1] = now.solution.lambda;
            } else {
                step(copy, {.h = 1.0 / 60}, method, now);
                u[0] = solved_velocities(now), lambda[0] = now.solution.lambda;
            }
            REQUIRE(now.solution.status == Status::solved);
        }
        CHECK((u[0] - u[1]).norm() < 1e-12);
        CHECK((lambda[0] - lambda[1]).norm() > 1e-3);  // [N s]: those are not unique
    }
}

TEST_CASE("exact friction turns with the scene and scales with its masses", "[house]")
{
    const auto run = [](const Vec3& turn, Real mass) {
        RoughSolids scene = struck_balls(21);
        const Mat3 R = rotation_matrix(turn);
        for (Index k = 0; k < 10; ++k) {
            scene.bodies.position(k).head<3>() = R * scene.bodies.x.segment<3>(6 * k);
            scene.bodies.position(k).tail<3>() = rotation_vector(R * rotation_of(scene.bodies.x, k));
            scene.bodies.velocity(k).head<3>() = R * scene.bodies.u.segment<3>(6 * k);
        }
        scene.gravity = R * scene.gravity;
        for (SolidWall& wall : scene.walls) wall.normal = R * wall.normal;
        scene.bodies.inverse_mass /= mass;
        RoughCones method = solved_exactly();
        method.solver.sweeps.tolerance = 1e-12;
        StepData<6> now;
        step(scene, {.h = 1.0 / 60}, method, now);
        REQUIRE(now.solution.status == Status::solved);
        VecX u = solved_velocities(now);
        for (Index k = 0; k < 10; ++k) u.segment<3>(6 * k) = R.transpose() * u.segment<3>(6 * k);
        return u;
    };
    const VecX plain = run({0, 0, 0}, 1);
    // residuals of 1e-12, and tangents that lie in other directions
    CHECK((run({0.8, -0.3, 0.5}, 1) - plain).norm() < 1e-9);
    CHECK((run({0, 0, 0}, 1e-3) - plain).norm() < 1e-9);
}

TEST_CASE("exact friction is mirrored with the scene and scales with its unit of length", "[house]")
{
    Vec<6> mirror;  // that lies in the plane of x and y: a turn about z stays
    mirror << 1, 1, -1, -1, -1, 1;
    const auto run = [&](bool in_mirror, Real unit) {
        RoughSolids scene = struck_balls(21);
        for (Index k = 0; k < 10; ++k) {
            for (Hull& hull : scene.shapes[static_cast<std::size_t>(k)]) hull.radius *= unit;
            scene.bodies.inverse_mass.segment<3>(6 * k + 3) /= unit * unit;
            scene.bodies.position(k).head<3>() *= unit;
            scene.bodies.velocity(k).head<3>() *= unit;
            if (!in_mirror) continue;
            const Vec<6> x = scene.bodies.x.segment<6>(6 * k), u = scene.bodies.u.segment<6>(6 * k);
            scene.bodies.position(k) = mirror.cwiseProduct(x);
            scene.bodies.velocity(k) = mirror.cwiseProduct(u);
        }
        scene.gravity *= unit;
        for (SolidWall& wall : scene.walls) {
            wall.offset *= unit;
            if (in_mirror) wall.normal.z() = -wall.normal.z();
        }
        RoughCones method = solved_exactly();
        method.solver.sweeps.tolerance = 1e-12;
        StepData<6> now;
        step(scene, {.h = 1.0 / 60}, method, now);
        REQUIRE(now.solution.status == Status::solved);
        REQUIRE(now.contacts.size() > 10);
        VecX u = solved_velocities(now);
        for (Index k = 0; k < 10; ++k) {
            if (in_mirror) u.segment<6>(6 * k) = mirror.cwiseProduct(Vec<6>(u.segment<6>(6 * k)));
            u.segment<3>(6 * k) /= unit;
        }
        return u;
    };
    const VecX plain = run(false, 1);
    // residuals of 1e-12 ℓ/s, through a heap of ten
    CHECK((run(true, 1) - plain).norm() < 1e-9);
    for (const Real unit : {1e-3, 0.1, 1000.0}) CHECK((run(false, unit) - plain).norm() < 1e-9);
}

TEST_CASE("a stack of twenty and tops of up to a million times the mass stand without small steps", "[house]")
{
    struct Case {
        RoughSolids scene;
        int substeps;
    };
    for (const Case& c :
         {Case{box_stack(20, 0.05, 0.5), 1}, Case{under_a_load(4, 1000), 1}, Case{under_a_load(20, 1000), 1},
          Case{under_a_load(4, 1e6), 1}, Case{box_stack(20, 0.05, 0.5), 4}, Case{under_a_load(4, 1000), 4}}) {
        const auto [moved, unsolved] = four_seconds(c.scene, c.substeps);
        CHECK(moved < 1e-6);  // [m]; 240 steps with residuals of up to 1e-9 m/s add up to 4e-9
        CHECK(unsolved == 0);
    }
}

TEST_CASE("a heap is exact in nearly every step and honest in the others", "[house]")
{
    RoughSolids scene = mixed_heap(20, 0.5, 3);
    RoughCones method = solved_exactly();
    StepData<6> now;
    int solved = 0;
    for (int i = 0; i < 150; ++i) {
        step(scene, {.h = 1.0 / 60}, method, now);
        const Real error = coulomb_error(now);
        CHECK(error <= now.solution.residual + 1e-12 * 10);  // rounding of 10 m/s
        if (now.solution.status == Status::solved) {
            ++solved;
            CHECK(error <= 1e-9 * now.length + 1e-12 * 10);
        }
    }
    CHECK(solved > 140);
}

TEST_CASE("what may not guess and may not sweep has no answer and says so", "[house]")
{
    RoughSolids scene = thrown_boxes(31, 6, 0.5);
    RoughCones method = solved_exactly();
    method.solver.newton.settings.most_guesses = 1;
    method.solver.newton.settings.retreats = 0;
    method.solver.sweeps.max_sweeps = 1;
    StepData<6> now;
    step(scene, {.h = 1.0 / 60}, method, now);
    CHECK(now.solution.status == Status::iteration_limit);
    CHECK(method.solver.unanswered == 1);
    CHECK(now.solution.residual > 1e-6);
    CHECK(coulomb_error(now) == Approx(now.solution.residual).epsilon(1e-6));
}

TEST_CASE("islands of too many rows are swept", "[house]")
{
    RoughSolids scene = box_stack(6, 0.05, 0.5);
    RoughCones method = solved_exactly(71);  // 6 faces with 4 points of 3 rows: 72
    StepData<6> now;
    step(scene, {.h = 1.0 / 60}, method, now);
    CHECK(method.solver.guesses == 0);
    method.solver.exact_rows = 72;
    step(scene, {.h = 1.0 / 60}, method, now);
    CHECK(method.solver.guesses > 0);
}

TEST_CASE("the exact solver keeps its memory from step to step", "[house]")
{
    RoughSolids scene = box_stack(8, 0.05, 0.5);
    RoughCones method = solved_exactly();
    StepData<6> now;
    for (int i = 0; i < 5; ++i) step(scene, {.h = 1.0 / 60}, method, now);
    scene.bodies.u[0] += 0.01;  // there is something to solve
    step(scene, {.h = 1.0 / 60}, method, now);
    scene.bodies.u[0] -= 0.02;
    {
        const NoAllocation none;
        step(scene, {.h = 1.0 / 60}, method, now);
    }
    CHECK(NoAllocation::violations() == 0);
    CHECK(method.solver.guesses > 0);
}

TEST_CASE("settings of the exact solver that make no sense are refused", "[house]")
{
    RoughSolids scene = box_stack(2, 0, 0.5);
    StepData<6> now;
    RoughCones method = solved_exactly(-1);
    CHECK_THROWS_WITH(step(scene, {}, method, now),
                      "islands of up to -1 rows are to be solved exactly; it must be zero or more");
    method = solved_exactly();
    method.solver.newton.settings.guesses = -3;
    CHECK_THROWS_WITH(step(scene, {}, method, now),
                      "a number of guesses or steps is -3; it must be zero or more");
}

TEST_CASE("a residual that is no number is never an answer", "[house]")
{
    // two rows of two bodies on walls; one body has a velocity that is none
    SolverRow<6> rows[2] = {};
    for (SolverRow<6>& row : rows) {
        row.Ja.setZero(), row.Wa.setZero();
        row.Jb << 1, 0, 0, 0, 0, 0;
        row.Wb = row.Jb.transpose();
        row.mass = 1, row.hi = infinity;
    }
    const int disc_at[] = {-1, -1}, bodies[] = {0, 1};
    for (const int spoilt : {0, 1}) {
        rows[0].a = rows[0].b = 0, rows[1].a = rows[1].b = 6;
        VecX u = VecX::Zero(12);
        u[6 * spoilt] = std::nan("");
        const ConeRows problem{rows, {}, disc_at, {}, bodies};
        CHECK(std::isnan(residual_of(problem, u)));
        ConeNewton newton;
        CHECK_FALSE(newton.solve(problem, 1e-9, u));
        CHECK_FALSE(newton.residual <= 1e-9);
        for (SolverRow<6>& row : rows) row.lambda = 0;
    }
}

TEST_CASE("an island is swept on as many times as are set however many that are", "[house]")
{
    const ImpulseSettings sweeps{50, 1e-6};
    StepData<6> now;
    now.h = 1.0 / 60, now.length = 1;
    SweepPatience patience;
    patience.times = std::numeric_limits<int>::max();
    for (const int n : {50, 51, 1000, 2000000000}) CHECK_FALSE(patience.is_last(n, sweeps, 100, now));
    CHECK(patience.is_last(50, sweeps, 1e-3, now));
    patience.times = 2;
    CHECK_FALSE(patience.is_last(99, sweeps, 100, now));
    CHECK(patience.is_last(100, sweeps, 100, now));
}
