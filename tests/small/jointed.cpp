/// The small programs of chapters 14 and 15, joints by sweeps and pins by a tree, beside the library.

#include "tests/small/alone.hpp"

#include "chapters/02_velocity_constraints/constraints.hpp"
#include "chapters/14_joints/joint_stage.hpp"
#include "chapters/14_joints/placed_joints.hpp"
#include "chapters/15_trees/joint_factor.hpp"
#include "tests/catch.hpp"
#include "tests/small/quiet_sweeps.hpp"
#include "tests/small/sentences.hpp"

#define main small_main
namespace small14 {
#include "chapters/14_joints/small.cpp"
}
namespace small15 {
#include "chapters/15_trees/small.cpp"
}
#undef main

using namespace rigid;

namespace {

small15::Bodies loaded_chain(Real ratio)
{
    small15::Bodies d;
    for (int k = 0; k < 50; ++k) small15::add_rod(d, 0.1, 0.1, -7 * pi / 18);
    d.inverse_mass.tail<3>() /= ratio;
    return d;
}

/// The pins of a small program as rows of the library, with b = C/h.
std::vector<Row<3>> library_rows(const small15::Bodies& d, Real h)
{
    std::vector<Row<3>> rows;
    for (std::size_t k = 0; k < d.pins.size(); ++k)
        for (const int i : {0, 1}) {
            Constraint<3> c;
            c.a = d.pins[k].parent < 0 ? world : d.pins[k].parent;
            c.b = static_cast<Index>(k);
            c.C = d.pins[k].C[i];
            if (c.a != world) c.Ja = d.pins[k].Jp.row(i);
            c.Jb = d.pins[k].J.row(i);
            rows.push_back(bilateral(c, d.inverse_mass, c.C / h));
        }
    return rows;
}

/// The trolley of chapter 14 as the library has it, where the world is no body.
JointedScene library_trolley(const small14::Bodies& d)
{
    JointedScene scene;
    scene.length = 1;
    const Vec2 half[] = {{0.15, 0.05}, {0, 0.4}, {0.15, 0.1}, {0.06, 0.06}};
    for (Index k = 0; k < 4; ++k) {
        const Vec<3> inverse = d.inverse_mass.segment<3>(3 * k + 3);
        const Polygon shape = half[k].x() > 0 ? box(2 * half[k].x(), 2 * half[k].y()) : capsule(0.8, 0);
        add_body(scene, shape, Mass{1 / inverse[0], {0, 0}, 1 / inverse[2]}, d.x.segment<2>(3 * k + 3));
    }
    for (const small14::Joint& j : d.joints) {
        RigidJoint joint;
        using small14::Kind;
        joint.kind = j.kind == Kind::slider ? JointKind::prismatic
                     : j.kind == Kind::pin  ? JointKind::revolute
                     : j.kind == Kind::weld ? JointKind::weld
                                            : JointKind::rope;
        joint.a = j.a - 1, joint.b = j.b - 1;
        joint.at_a = j.at_a, joint.at_b = j.at_b, joint.axis = j.axis;
        joint.motor.speed = j.speed, joint.motor.force = j.force;
        if (j.kind == Kind::rope) joint.length = j.upper;
        else joint.lower = j.lower, joint.upper = j.upper;
        add_joint(scene, joint);
    }
    return scene;
}

}  // namespace

TEST_CASE("the small program of chapter 14 has the numbers of the text and the library's to 1e-12")
{
    // By hand, (14.1) and (14.2); sweeps leave 1e-6 m/s of a row, and some of its neighbours' with it.
    for (const bool near : {false, true}) {
        small14::Bodies d = small14::door(near ? 0.005 : 1);
        small14::step(d, 0.1, 1);
        CHECK(d.rows[1].lambda == Approx(near ? 0.075 : 0.15).margin(1e-5));
        CHECK(d.rows[2].lambda == Approx(near ? 0.05 : 0).margin(1e-5));
        CHECK(d.rows[3].lambda == Approx(0.1).epsilon(1e-14));
        CHECK(d.u[5] == Approx(near ? 0.05 : 0.1).margin(1e-5));
    }
    // The trolley until it has been at its stop for half a second, by the library's rows, limits and sweeps.
    small14::Bodies d = small14::trolley();
    JointedScene scene = library_trolley(d);
    QuietMethod<3, WithJoints<WithFriction<AllBodies>>, Correction, WarmStart> method;
    method.contacts.skip_far_limits = false;
    method.correction.method = Stabilizer::baumgarte;
    method.correction.beta = 0.2;
    method.start.from = Start::previous;
    Real farthest = 0;
    for (int n = 0; n < 480; ++n) {
        INFO("step " << n);
        const int sweeps = small14::step(d, 1.0 / 240, 0.2);
        REQUIRE(method(scene) == sweeps);
        const Index size = scene.bodies.x.size();
        farthest = std::max({farthest, (d.x.tail(size) - scene.bodies.x).cwiseAbs().maxCoeff(),
                             (d.u.tail(size) - scene.bodies.u).cwiseAbs().maxCoeff()});
    }
    CHECK(farthest < 1e-12);                  // the same visits, whose sums have another order
    CHECK(d.x[3] == Approx(1).margin(1e-3));  // at its stop, which leaves C/h no more than the sweeps do
}

TEST_CASE("the small program of chapter 15 has the numbers of the text and the library's to 1e-12")
{
    // By hand, (15.2); a quarter of a kilogram at the first rod's end is all that it needs to know of the second.
    for (const bool replaced : {false, true}) {
        small15::Bodies d{{}, {}, {}, {}, 1};
        small15::add_rod(d, 1, 1, 0);
        small15::add_rod(d, 1, replaced ? 0.25 : 1, 0);
        if (replaced) d.pins[1].below.setZero(), d.x[3] = 1;
        small15::step(d, 1, 0);
        CHECK(d.pins[0].lambda[1] == Approx(2.0 / 7).epsilon(1e-12));
        CHECK(d.pins[1].lambda[1] == Approx(-1.0 / 14).epsilon(1e-12));
        CHECK(d.u[2] == Approx(-9.0 / 7).epsilon(1e-12));
        CHECK(d.u[5] == Approx(replaced ? 0 : 3.0 / 7).epsilon(1e-12));
    }
    // The tree of each of 100 steps, by the library's factor.
    small15::Bodies d = loaded_chain(100);
    JointFactor factor;
    const Real h = 1.0 / 240;
    Real farthest = 0, fastest = 0;
    for (int n = 0; n < 100; ++n) {
        small15::Bodies before = d;
        for (int k = 1; k < before.u.size(); k += 3) before.u[k] -= before.g * h;
        small15::find_rows(before);
        const std::vector<Row<3>> rows = library_rows(before, h);
        VecX u = before.u, lambda(Index(rows.size()));
        factor.factor(rows, before.inverse_mass);
        VecX b(Index(rows.size()));
        for (std::size_t i = 0; i < rows.size(); ++i) b[Index(i)] = rows[i].bias;
        factor.solve(rows, b, u, lambda);
        small15::step(d, h, 0);
        farthest = std::max(farthest, (d.u - u).cwiseAbs().maxCoeff());
        fastest = std::max(fastest, d.u.cwiseAbs().maxCoeff());
    }
    // Entries of 1/m cancel down to those of the load, a hundredth of them: two digits of the sixteen (15.I).
    CHECK(farthest < 1e-12 * fastest);
}

TEST_CASE("the small program of chapter 15 solves at once what its sweeps only approach")
{
    small15::Bodies tree = loaded_chain(1), sweeps = tree;
    small15::step(tree, 1.0 / 240, 0);
    small15::step(sweeps, 1.0 / 240, 40000);
    CHECK((tree.u - sweeps.u).cwiseAbs().maxCoeff() < 1e-10);  // by (4.14) 0.999 a sweep leaves e^-40
    // Section 14.6: ten sweeps a step let a chain with a heavy end come apart.
    Real gap[2] = {0, 0};
    for (const int way : {0, 1}) {
        small15::Bodies d = loaded_chain(100);
        for (int n = 0; n < 240; ++n) {
            small15::step(d, 1.0 / 240, way == 0 ? 10 : 0);
            small15::find_rows(d);
            for (const small15::Pin& pin : d.pins) gap[way] = std::max(gap[way], pin.C.norm());
        }
    }
    CHECK(gap[0] > 0.02);
    CHECK(gap[1] < 2e-6);
}

namespace {

// What the sentences of these chapters say.

Numbers door(Numbers in)
{
    small14::Bodies d = small14::door(in["gap"] / 1000);
    d.inverse_mass.tail<3>() *= 3 / in["mass"];
    small14::step(d, 0.1, 1);
    return {{"pin", d.rows[1].lambda},
            {"stop", d.rows[2].lambda},
            {"motor", d.rows[3].lambda},
            {"omega", d.u[5]}};
}

Numbers two_rods(Numbers in)
{
    small15::Bodies d{{}, {}, {}, {}, 1};
    small15::add_rod(d, 1, 1, 0);
    small15::add_rod(d, 1, in["mass"], 0);
    small15::step(d, 1, 0);
    return {{"first", d.pins[0].lambda[1]},
            {"second", d.pins[1].lambda[1]},
            {"turn1", 9.81 * d.u[2]},
            {"turn2", 9.81 * d.u[5]},
            {"end", -d.u[2]}};
}

const Sentence says_door("door", door, 1e-5);  // sweeps to 1e-6 rad/s
const Sentence says_two_rods("two_rods", two_rods, 1e-9);

}  // namespace
