/// Chapter 19: what the benchmark takes for right where things move is right.

#include "chapters/19_engine/benchmark/kept_scenes.hpp"

#include "tests/catch.hpp"

using namespace rigid;

TEST_CASE("the motion that engines are measured against is that of the literature", "[house]")
{
    using namespace kept;
    const Motion motion = exact_motion(rods({pi / 2, pi / 2}), 3);
    REQUIRE(motion.x.size() == 181);
    // shared digits of two rods of 1 m and 1 kg; 3 s at a tolerance of 1e-12 leave 1e-10
    CHECK(std::abs(angle_of(0)(motion, 60) + 1.207716238190638) <= 1e-9);
    CHECK(std::abs(angle_of(0)(motion, 180) - 1.025086012288729) <= 1e-9);
    CHECK(std::abs(spin_of(0)(motion, 60) + 3.406517532971958) <= 1e-9);
    CHECK(std::abs(spin_of(0)(motion, 180) + 4.59335710547498) <= 1e-9);
    CHECK(std::abs(energy_kept(energy(rods({0, 0})))(motion) - 1) <= 1e-10);

    // with a rod for its sling nothing is ever slack, and nothing strikes: energy is kept
    const JointedScene thrower = trebuchet_scene(1000, JointKind::distance);
    const Motion thrown = exact_motion(thrower, 2);
    for (const std::size_t n : {60U, 120U})
        CHECK(std::abs(energy(thrown, n) / energy(thrown, 0) - 1) <= 1e-9);
}

TEST_CASE("a light ball on a heavy one rises as the closed form says", "[house]")
{
    using namespace kept;
    for (const Real M : {1.0, 3.0, 100.0}) {
        const Real rise = (3 * M - 1) / (M + 1);
        // a gap of 1e-7 m is all that keeps the blows apart: the height is off by some of it
        CHECK(std::abs(first_apex(M, 1, 2, 1e-7) / (2 * rise * rise) - 1) <= 1e-6);
    }
}

TEST_CASE("a largest value between frames is that of free fall", "[house]")
{
    using namespace kept;
    Motion motion{falling_world({{disc(0.5), 1}}, 1, 0, 1), {}, {}};
    for (int n = 0; n < 60; ++n) {
        const Real t = n * kept::frame;
        motion.x.push_back({Vec<3>::Zero(), {0, 3 * t - 9.81 / 2 * t * t, 0}});
    }
    // a parabola through three points of a parabola: rounding of 0.5 m
    CHECK(std::abs(the_peak(height_of(1, 0), 1)(motion) - 9 / (2 * 9.81)) <= 1e-13);
    CHECK(the_peak(height_of(1, 0), 2)(motion) == 0);
}
