/// Chapter 26: the tables and the numbers of the text are what its program makes.

#include "tests/catch.hpp"
#include "tests/says.hpp"

#include "chapters/26_four_ways/program/who_can.hpp"
#include "chapters/26_four_ways/spring_forces.hpp"

using namespace rigid;

namespace {

const std::string road = "chapters/26_four_ways/README.md", depth = "chapters/26_four_ways/in_depth.md";

Real error_at(Way way, const WayScene& scene, int rate)
{
    return run_way(way, scene, 1.0 / rate, settings_of(scene)).error;
}

}  // namespace

TEST_CASE("the tables of who can do what are what the program makes", "[house]")
{
    const auto stand_in = [](const std::string& file, const std::vector<std::string>& lines) {
        for (const std::string& line : lines) {
            INFO(line);
            CHECK(says(file, line));
        }
    };
    stand_in(road, error_table(way_scenes(), 1.0 / 240));
    stand_in(depth, energy_table(way_scenes(), 1.0 / 240));
    stand_in(depth, drift_table(way_scenes(), 1.0 / 240));
}

TEST_CASE("the errors that the text of the four ways states are what runs give", "[house]")
{
    // section 26.7, at 60 steps a second: as many digits as the text has
    CHECK(one_digit(error_at(Way::coordinates, pendulum(), 60)) == "2e-9");
    CHECK(one_digit(error_at(Way::acceleration, pendulum(), 60)) == "5e-7");
    CHECK(std::abs(error_at(Way::impulses, pendulum(), 60) - 4.3e-3) <= 0.05e-3);
    CHECK(std::abs(error_at(Way::end_spring, pendulum(), 60) - 4.7e-3) <= 0.05e-3);
    CHECK(std::abs(error_at(Way::positions, pendulum(), 60) - 1.0 / 3) <= 0.05);
    // a pin sees ¼ kg, with the damper that its spring has
    const Real damper = 2 * 0.1 * std::sqrt(1e5 * 0.25), longest = largest_step(0.25, 1e5, damper);
    CHECK(std::abs(1 / longest - 349) <= 0.5);
    CHECK(run_way(Way::spring, pendulum(), 0.99 * longest, settings_of(pendulum())).why_not.empty());
    CHECK_FALSE(run_way(Way::spring, pendulum(), 1.01 * longest, settings_of(pendulum())).why_not.empty());
    // section 26.5
    CHECK(std::abs(run_way(Way::positions, pendulum(), 1.0 / 240, {}).energy_gain + 0.46) <= 0.005);
    // section 26.3: the bead after a second, of which the angle is exact to 1e-12 at this step
    WayScene bead;
    bead.scene = bead_on_a_wire();
    Real angle = rigid::asin(0.6), rate = 1;
    const Real h = 1e-4;
    for (int i = 0; i < 10000; ++i) {
        const auto bend = [](Real at) { return -10 * rigid::sin(at); };
        const Real k1 = bend(angle), k2 = bend(angle + h / 2 * rate),
                   k3 = bend(angle + h / 2 * (rate + h / 2 * k1)), k4 = bend(angle + h * (rate + h / 2 * k2));
        angle += h * (rate + h / 6 * (k1 + k2 + k3));
        rate += h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
    }
    bead.error = [there = Vec2(rigid::sin(angle), -rigid::cos(angle))](const JointedScene& s) {
        return (s.bodies.x.head<2>() - there).norm();
    };
    CHECK(std::abs(error_at(Way::acceleration, bead, 100) - 1.3e-8) <= 0.05e-8);
    JointedScene row_alone = bead.scene;  // and by the row of a velocity, its position left alone
    for (int i = 0; i < 100; ++i) {
        Bodies<3>& bodies = row_alone.bodies;
        const Row<3> row = bilateral(joint_constraint(bodies.x, row_alone.joints[0]), bodies.inverse_mass);
        bodies.u[1] -= 10 * 0.01;
        row.apply(solve_row(row, bodies.u).lambda, bodies.u);
        bodies.x += 0.01 * bodies.u;
    }
    CHECK(std::abs(bead.error(row_alone) - 15.5e-3) <= 0.5e-3);
    // section 26.1: one step of order four
    bead.time = 0.1;
    WayRun four(Way::acceleration, bead, {});
    REQUIRE(four.advance(0.1) == Status::solved);
    CHECK((four.scene().bodies.x.head<2>() - Vec2(0.6537, -0.7568)).cwiseAbs().maxCoeff() <= 0.5e-4);
    CHECK((four.scene().bodies.u.head<2>() - Vec2(0.279, 0.241)).cwiseAbs().maxCoeff() <= 0.5e-3);
    // section 26.2: a ball on a soft row leaves with half its speed at 1/960 s
    WayScene ball = bouncing_ball();
    WayRun falls(Way::end_spring, ball, settings_of(ball));
    Real down = 0, up = 0;
    for (int i = 0; i < 960; ++i) {
        falls.advance(1.0 / 960);
        down = std::min(down, falls.scene().bodies.u[1]);
        up = std::max(up, falls.scene().bodies.u[1]);
    }
    CHECK(std::abs(up / -down - 0.5) <= 0.05);
    // section 26.C: a loop after 16 turns of its crank
    WayRun turns(Way::coordinates, slider_crank_loop(), {});
    for (int i = 0; i < 10000; ++i) REQUIRE(turns.advance(1e-3) == Status::solved);
    CHECK(one_digit(largest_joint_error(turns.scene())) == "2e-7");
}
