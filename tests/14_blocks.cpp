/// Chapter 14: sweeps that visit the rows of a joint together.

#include "tests/no_allocation.hpp"

#include "chapters/14_joints/joint_scenes.hpp"
#include "chapters/14_joints/joint_sweeps.hpp"
#include "common/random.hpp"

#include "tests/catch.hpp"

using namespace rigid;

namespace {

std::vector<Row<3>> rows_of(const JointedScene& scene)
{
    std::vector<Row<3>> rows;
    for (const PointJoint& joint : scene.joints)
        rows.push_back(bilateral(joint_constraint(scene.bodies.x, joint), scene.bodies.inverse_mass));
    return rows;
}

/// Velocities that the rows have to correct.
VecX stirred(const JointedScene& scene, std::uint64_t seed)
{
    Random random(seed);
    VecX u(scene.bodies.u.size());
    for (Index i = 0; i < u.size(); ++i) u[i] = random.uniform(-1, 1);
    return u;
}

/// Boxes one welded or pinned to the next, the first to the world.
JointedScene boxes(JointKind kind, int count)
{
    JointedScene scene;
    for (int k = 0; k < count; ++k) {
        add_body(scene, box(1, 0.4), 5.0, {k + 0.5, 0.1 * k}, 0.2 * k);
        const Real x = k;
        add_joint(scene, joint_at(scene, kind, k == 0 ? world : k - 1, k, {x, 0.1 * k - 0.2}));
    }
    return scene;
}

struct Swept {
    VecX u;
    Solution solution;
};

Swept by_joints(const std::vector<Row<3>>& rows, const VecX& u_star, const ImpulseSettings& settings)
{
    ImpulseMemory<3> memory;
    std::vector<RowRun> runs;
    Swept swept{u_star, {}};
    joint_sweeps(rows, settings, memory, runs, swept.u, swept.solution);
    return swept;
}

Swept by_rows(const std::vector<Row<3>>& rows, const VecX& u_star, const ImpulseSettings& settings)
{
    ImpulseMemory<3> memory;
    Swept swept{u_star, {}};
    sequential_impulse<3>(rows, {}, settings, memory, swept.u, swept.solution);
    return swept;
}

}  // namespace

TEST_CASE("one visit of a joint leaves none of its rows off", "[idea]")
{
    for (const JointKind kind : {JointKind::revolute, JointKind::prismatic, JointKind::weld}) {
        const JointedScene scene = boxes(kind, 1);
        const std::vector<Row<3>> rows = rows_of(scene);
        const Swept swept = by_joints(rows, stirred(scene, 4), {.max_sweeps = 1, .tolerance = 0});
        for (const Row<3>& row : rows)
            CHECK(std::abs(row.velocity(swept.u)) <= 1e-13);  // rounding of speeds of 1 m/s, a few times
        const Swept alone = by_rows(rows, stirred(scene, 4), {.max_sweeps = 1, .tolerance = 0});
        CHECK(std::abs(rows[0].velocity(alone.u)) > 1e-3);  // the second row undoes a part of the first
    }
}

TEST_CASE("sweeps over joints end where sweeps over rows and the whole matrix end and need fewer", "[idea]")
{
    for (const JointKind kind : {JointKind::revolute, JointKind::weld}) {
        const JointedScene scene = boxes(kind, 4);
        const std::vector<Row<3>> rows = rows_of(scene);
        const VecX u_star = stirred(scene, 9);
        const ImpulseSettings settings{.max_sweeps = 100000, .tolerance = 1e-10};
        const Swept joints = by_joints(rows, u_star, settings), alone = by_rows(rows, u_star, settings);
        REQUIRE(joints.solution.status == Status::solved);
        REQUIRE(alone.solution.status == Status::solved);
        CHECK(joints.solution.iterations < alone.solution.iterations);
        VecX u = u_star;
        apply(rows, solve_rows(rows, u_star).lambda, u);
        // a residual of 1e-10 m/s leaves the slowest mode off by what it shrinks in a sweep
        CHECK((joints.u - u).norm() <= 1e-6);
        CHECK((alone.u - u).norm() <= 1e-6);
    }
}

TEST_CASE("a joint that is given twice is swept to the same velocities", "[house]")
{
    JointedScene scene = boxes(JointKind::weld, 2);
    const std::vector<Row<3>> once = rows_of(scene);
    add_joint(scene, scene.placed[1].joint);
    const std::vector<Row<3>> twice = rows_of(scene);
    const ImpulseSettings settings{.max_sweeps = 100000, .tolerance = 1e-11};
    const Swept a = by_joints(once, stirred(scene, 2), settings),
                b = by_joints(twice, stirred(scene, 2), settings);
    CHECK(b.solution.status == Status::solved);
    CHECK((a.u - b.u).norm() <= 1e-7);
}

TEST_CASE("rows with bounds and soft rows are visited one by one among the joints", "[house]")
{
    const JointedScene scene = boxes(JointKind::revolute, 3);
    std::vector<Row<3>> rows = rows_of(scene);
    rows[1].softness = 0.3;
    rows[3].lo = 0;
    const VecX u_star = stirred(scene, 7);
    const ImpulseSettings settings{.max_sweeps = 100000, .tolerance = 1e-11};
    const Swept joints = by_joints(rows, u_star, settings), alone = by_rows(rows, u_star, settings);
    REQUIRE(joints.solution.status == Status::solved);
    CHECK((joints.u - alone.u).norm() <= 1e-7);
    CHECK((joints.solution.lambda - alone.solution.lambda).norm() <= 1e-6);
}

TEST_CASE("sweeps over joints ask for no memory once they have seen a scene", "[house]")
{
    const JointedScene scene = boxes(JointKind::weld, 6);
    const std::vector<Row<3>> rows = rows_of(scene);
    ImpulseMemory<3> memory;
    std::vector<RowRun> runs;
    Solution solution;
    VecX u = stirred(scene, 1);
    const ImpulseSettings settings{.max_sweeps = 10, .tolerance = 0};
    joint_sweeps(rows, settings, memory, runs, u, solution);
    {
        const NoAllocation none;
        for (int i = 0; i < 5; ++i) joint_sweeps(rows, settings, memory, runs, u, solution);
    }
    CHECK(NoAllocation::violations() == 0);
}
