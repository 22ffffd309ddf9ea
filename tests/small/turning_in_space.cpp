/// The small programs of chapters 20 and 21, bodies that turn in space and their joints, beside the library.

#include "tests/small/alone.hpp"

#include "chapters/20_turning_in_space/tumbling.hpp"
#include "chapters/21_joints_in_space/joint_makers.hpp"
#include "tests/catch.hpp"
#include "tests/small/sentences.hpp"

#define main small_main
namespace small20 {
#include "chapters/20_turning_in_space/small.cpp"
}
namespace small21 {
#include "chapters/21_joints_in_space/small.cpp"
}
#undef main

using namespace rigid;

TEST_CASE("the small program of chapter 20 has the numbers of the text and the library's to 1e-12")
{
    // Section 20.1: one step of a book that is tossed.
    small20::Bodies first = small20::book(12, 0.1);
    small20::step(first, 1.0 / 60);
    CHECK((first.u.tail<3>() - Vec3(11.97, 1.42, 1.30)).cwiseAbs().maxCoeff() < 0.005);
    // Section 20.2: two quarter turns.
    const Vec3 quarter_x(pi / 2, 0, 0), quarter_y(0, pi / 2, 0);
    const Real third = 2 * pi / 3;  // a third of a turn, about a diagonal
    CHECK((small20::add(quarter_x, quarter_y) - third / std::sqrt(3.0) * Vec3(1, 1, 1)).norm() < 1e-14);
    CHECK((small20::add(quarter_y, quarter_x) - third / std::sqrt(3.0) * Vec3(1, 1, -1)).norm() < 1e-14);
    CHECK((add_rotation(quarter_y, quarter_x) - small20::add(quarter_y, quarter_x)).norm() < 1e-14);
    small20::Bodies d = small20::book(12, 0.1);
    const Vec3 I = d.inverse_mass.tail<3>().cwiseInverse();
    CHECK((I - Vec3(34.5, 15.9, 48.5) * 1e-4).cwiseAbs().maxCoeff() < 0.05e-4);
    for (const auto& [wobble, turns] : {std::pair{0.1, 0.74}, {0.01, 1.38}}) {
        small20::Bodies slow = small20::book(1, wobble);
        int n = 0;
        for (; slow.u[3] > 0 && n < 20000; ++n) small20::step(slow, 0.001);
        CHECK(n * 0.001 / (2 * pi) == Approx(turns).margin(0.005));
    }
    Vec3 theta(0, 0, 0), omega = d.u.tail<3>();
    for (int n = 0; n < 100; ++n) {
        small20::step(d, 0.005);
        tumble(Tumbling::middle, I, 0.005, theta, omega);
        REQUIRE((d.u.tail<3>() - omega).norm() < 1e-11);  // 12 rad/s, to 1e-12 of it
        REQUIRE((d.x.tail<3>() - theta).norm() < 1e-12);
    }
}

TEST_CASE("the small program of chapter 21 stops the door of section 21.1 with the impulses of the text")
{
    small21::Bodies d = small21::door(pi / 2, 0.5);
    const std::vector<small21::Row> rows = small21::step(d, 0.1, 0, 2000);
    REQUIRE(rows.size() == 6);
    for (const small21::Row& row : rows) {
        // the way y, and the upper limit of the twist
        const Real expected = row.name == 2 ? 0.75 : row.name == 7 ? 0.5 : 0;
        CHECK(row.lambda == Approx(expected).margin(1e-12));
    }
    CHECK(d.u.norm() < 1e-12);
    const Real half = std::sqrt(0.5);
    CHECK((rows[4].Jb.tail<3>() - half * Vec3(0, 1, -1)).norm() < 1e-14);
    CHECK((rows[5].Jb.tail<3>() - half * Vec3(0, 1, 1)).norm() < 1e-14);
}

TEST_CASE("the small program of chapter 21 measures a joint as the library does")
{
    // Two bodies somewhere on a joint whose frames do not agree any more, and one on the world.
    small21::Bodies d{{}, {}, {}, 0};
    JointedSolids scene;
    for (const auto& [at, theta] : {std::pair{Vec3(0.1, 0.2, -0.3), Vec3(0.4, -0.9, 0.3)},
                                    {Vec3(1.2, -0.4, 0.5), Vec3(-0.2, 0.6, 1.1)}}) {
        small21::add_box(d, {1, 2, 3}, 6, at);
        d.x.tail<3>() = theta;
        add_body(scene, {solid_box({1, 2, 3})}, 1.0, at);
    }
    scene.bodies.x = d.x;
    const Vec3 point(0.7, 0.1, 0.2), axis(0.3, -1, 0.4);
    for (const int a : {-1, 0}) {
        small21::Joint joint = small21::join(d, a, 1, point, axis.normalized(), {});
        const SpaceJoint same = joint_at(scene, a, 1, point, axis);
        small21::Bodies moved = d;
        moved.x += VecX::LinSpaced(12, -0.2, 0.3);
        for (int i = 0; i < 6; ++i) {
            const small21::Row row = small21::coordinate(moved, joint, i);
            const Constraint<6> c = coordinate_of(frames_of(moved.x, same), same, static_cast<Coordinate>(i));
            CHECK(row.C == Approx(c.C).margin(1e-12));
            CHECK((row.Jb.transpose() - c.Jb).norm() < 1e-12);
            if (a >= 0) CHECK((row.Ja.transpose() - c.Ja).norm() < 1e-12);
        }
    }
}

namespace {

// What the sentences of these chapters say.

/// What the row of the first swing turns about, in the axes of the door.
Numbers hinge(Numbers in)
{
    const small21::Bodies d = small21::door(in["angle"] * std::numbers::pi / 180, 0);
    const small21::Row row = small21::coordinate(d, d.joints[0], 4);
    return {{"lean", std::atan2(-row.Jb[5], row.Jb[4]) * 180 / std::numbers::pi}};
}

Numbers book(Numbers in)
{
    const auto moment = [](double b, double c) { return 0.7 / 12 * (b * b + c * c); };
    const rigid::Vec3 inertia(moment(0.24, 0.04), moment(0.16, 0.04), moment(0.16, 0.24));
    rigid::Vec3 theta(0, 0, 0), omega(1, in["wobble"] / 100, in["wobble"] / 100);
    int n = 0;
    for (; omega[0] > 0 && n < 20000; ++n)
        rigid::tumble(rigid::Tumbling::middle, inertia, 0.001, theta, omega);
    return {{"turns", n * 0.001 / (2 * std::numbers::pi)}};
}

const Sentence says_hinge("hinge", hinge, 1e-12);
const Sentence says_book("book", book,
                         3e-4);  // whole steps of a thousandth of a second, which is 1.6e-4 turns

}  // namespace
