/// Chapter 26: the tables and the numbers of the text are what its program makes.

#include "tests/catch.hpp"
#include "tests/says.hpp"

#include "chapters/26_four_ways/acceleration_level.hpp"
#include "chapters/26_four_ways/program/who_can.hpp"
#include "chapters/26_four_ways/reduced_motion.hpp"
#include "chapters/26_four_ways/single_impulses.hpp"
#include "chapters/26_four_ways/spring_forces.hpp"

using namespace rigid;

namespace {

const std::string road = "chapters/26_four_ways/README.md", depth = "chapters/26_four_ways/in_depth.md";

Real error_at(Way way, const WayScene& scene, int rate)
{
    return run_way(way, scene, 1.0 / rate, settings_of(scene)).error;
}

/// The cells of the first table behind a sentence, without its heading: a line a scene.
std::vector<std::vector<std::string>> table_behind(const std::string& sentence)
{
    std::ifstream file(std::filesystem::path(RIGID_SOURCE_DIR) / depth);
    std::vector<std::vector<std::string>> lines;
    bool behind = false;
    int heading = 2;
    for (std::string line; std::getline(file, line);) {
        behind = behind || line.find(sentence) != std::string::npos;
        const bool is_row = line.starts_with("| ") || line.starts_with("|-");
        if (behind && !is_row && !lines.empty()) break;
        if (!behind || !is_row || heading-- > 0) continue;
        lines.emplace_back();
        for (std::size_t from = 2, to = 0; (to = line.find(" |", from)) != std::string::npos; from = to + 3)
            lines.back().push_back(line.substr(from, to - from));
    }
    return lines;
}

/// Holds a table of steps a second to runs: with so many it will do, with half of them it does not.
/// \param will_do  bool(const WayResult&)
template <class WillDo>
void check_steps(const std::string& sentence, const WillDo& will_do)
{
    const std::vector<WayScene> scenes = way_scenes();
    const auto lines = table_behind(sentence);
    REQUIRE(lines.size() == scenes.size());
    for (std::size_t i = 0; i < scenes.size(); ++i) {
        REQUIRE(lines[i].size() == 1 + all_ways.size());
        CHECK(lines[i][0] == scenes[i].name);
        for (const Way way : all_ways) {
            const std::string& word = lines[i][1 + static_cast<std::size_t>(way)];
            INFO(scenes[i].name << " by " << to_string(way) << ": " << word);
            const auto does = [&](int n) {
                return will_do(run_way(way, scenes[i], 1.0 / n, settings_of(scenes[i])));
            };
            if (word == "–") {
                CHECK((!can_take(way, scenes[i]) || !does(3840)));
                continue;
            }
            const int steps = std::stoi(word);
            CHECK(does(steps));
            if (steps > 15) CHECK_FALSE(does(steps / 2));
        }
    }
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

// Some seconds: each cell of three tables is one or two runs of a second of its scene, down to steps of 1/3840 s.
TEST_CASE("the longest steps and the orders that the text lists are what runs give", "[house]")
{
    check_steps("The longest step of 1/15",
                [](const WayResult& result) { return result.why_not.empty() && result.error <= 0.05; });
    check_steps("**The longest stable step**",
                [](const WayResult& result) { return result.why_not.empty(); });
    for (const std::string& line : order_table(way_scenes())) {
        INFO(line);
        CHECK(says(depth, line));
    }
}

TEST_CASE("what the text of the four ways counts and works out by hand is so", "[house]")
{
    // Algorithm 26.1
    CHECK(AccelerationSettings{}.gap == 1e-7);
    CHECK(AccelerationSettings{}.rest_speed == 1e-3);
    CHECK(AccelerationSettings{}.stick_speed == 1e-6);
    CHECK(AccelerationSettings{}.most_events == 200);
    // section 26.1: the step of order four, and the true motion by a thousand of them
    WayScene bead;
    bead.scene = bead_on_a_wire();
    WayRun one(Way::acceleration, bead, {}), many(Way::acceleration, bead, {});
    REQUIRE(one.advance(0.1) == Status::solved);
    for (int i = 0; i < 1000; ++i) REQUIRE(many.advance(1e-4) == Status::solved);
    CHECK(std::abs(one.scene().bodies.x.head<2>().norm() - 1) <= 0.02e-3);
    CHECK((one.scene().bodies.x - many.scene().bodies.x).head<2>().norm() <= 0.025e-3);
    // section 26.4: what hops instead of resting
    SingleImpulses single;
    JointedScene stack = stack_of_five().scene;
    for (int i = 0; i < 240; ++i) REQUIRE(single.advance(stack, 1.0 / 240) == Status::solved);
    INFO(single.collisions);
    CHECK(says(road, std::to_string(single.collisions / 1000) + ",000 collisions in a second"));
    // section 26.5: half the step, half the loss
    const auto lost = [](int n) { return -run_way(Way::positions, pendulum(), 1.0 / n, {}).energy_gain; };
    CHECK(std::abs(lost(240) / lost(480) - 2) <= 0.1);
    CHECK(std::abs(lost(480) / lost(960) - 2) <= 0.1);
    // section 26.6: a doll has three of its own and one for each joint
    CHECK(falling_doll().scene.placed.size() == 9);
    CHECK(falling_doll().scene.bodies.count() == 10);
    CHECK(ReducedMotion(falling_doll().scene).coordinates() == 12);
    // section 26.8: two corners on each of five faces, a normal and a tangent each
    AccelerationLevel level;
    const JointedScene at_rest = stack_of_five().scene;
    level.close(at_rest, 0.05);
    CHECK(2 * level.closed() == 20);
    // section 26.9: a wrist
    CHECK(std::abs(largest_stiffness(1e-3, 0.48, 1.0 / 240)) <= 1e-12);
    // exercise 26.1: the force of the second step
    Vec2 x(0.68, -0.84);
    const Vec2 u(0.8, -0.4), J = x.normalized();
    CHECK(printed(J.x(), 4) == "0.6292");
    CHECK(printed(J.y(), 4) == "-0.7772");
    CHECK(printed(x.norm(), 4) == "1.0807");
    CHECK(printed(J.dot(u), 4) == "0.8143");
    CHECK(printed(-(100 * (x.norm() - 1) + 10 * J.dot(u)), 1) == "-16.2");
    // exercise 26.2
    CHECK(largest_stiffness(0.25, 0, 1.0 / 60) == Approx(3600));
    CHECK(printed(1000 * 9.81 / 3600, 1) == "2.7");
    // section 26.F: the events of the doll
    AccelerationLevel by;
    const WayScene doll = falling_doll();
    by.filter = doll.filter;
    JointedScene falls = doll.scene;
    std::size_t most = 0;
    for (int i = 0; i < 240; ++i) {
        REQUIRE(by.advance(falls, 1.0 / 240) == Status::solved);
        most = std::max(most, by.closed());
    }
    INFO(by.work.events << " events, " << most << " contacts and limits");
    CHECK(says(depth, "makes " + std::to_string(by.work.events) + " in a second"));
    CHECK(says(depth, "up to " + std::to_string(most) + " contacts and limits"));
}
