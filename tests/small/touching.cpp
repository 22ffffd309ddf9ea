/// The small program of chapter 28, rows that only push and a bound on ways, beside the library.

#include <array>
#include <memory>

#include "tests/small/alone.hpp"

#include "chapters/28_cloth_that_touches/touching_step.hpp"
#include "common/random.hpp"
#include "tests/catch.hpp"
#include "tests/small/sentences.hpp"

#define main small_main
namespace small28 {
#include "chapters/28_cloth_that_touches/small.cpp"
}
#undef main

using namespace rigid;

namespace {

/// The library's cloth of the small program's, whose ball is its last particle and does not turn.
TouchingCloth library_cloth(const small28::Cloth& c)
{
    TouchingCloth out;
    const Index n = c.x.size() - (c.radius > 0 ? 3 : 0);
    out.bodies.resize(n / 3);
    out.bodies.x = c.x.head(n), out.bodies.u = c.u.head(n), out.bodies.inverse_mass = c.inverse_mass.head(n);
    out.gravity = {0, -c.g, 0};
    for (const small28::Spring& s : c.springs) out.springs.push_back({s.a, s.b, s.length, s.k});
    out.triangles = c.triangles;
    out.self_thickness = c.D;
    if (!(c.radius > 0)) return out;
    ClothSolid ball;
    ball.radius = c.radius, ball.friction = c.mu;
    add_solid(out, ball, 0, c.x.tail<3>());
    out.solids.inverse_mass.head<3>() = c.inverse_mass.tail<3>();
    out.solids.u.head<3>() = c.u.tail<3>();
    return out;
}

}  // namespace

TEST_CASE("the small program of chapter 28 has the numbers of the text")
{
    for (const Real mu : {0.0, 0.1, 0.5}) {
        small28::Cloth c = small28::on_ball(mu);
        small28::step(c, 0.1, 1, false);
        // 90 mm of overlap against A of 4/3; 30 mm of sliding against mu times that impulse, or against A
        const Real slide = std::min(mu * 0.0675, 0.03 * 0.75);
        CHECK(c.x[0] == Approx(-slide).margin(1e-15));
        CHECK(c.x[1] == Approx(0.5 - 0.0225).epsilon(1e-14));
        CHECK(c.x[3] == Approx(slide / 3).margin(1e-15));
        CHECK(c.x[4] == Approx(-0.0225).epsilon(1e-14));
    }
    for (const bool bound : {false, true}) {
        small28::Cloth c = small28::three_layers();
        small28::step(c, 0.1, 1, bound);
        CHECK(c.x[10] == Approx(bound ? 0.0055 : -0.040).epsilon(1e-13));
        for (const int corner : {1, 4, 7})
            CHECK(c.x[corner] == Approx(bound ? -0.0045 : -0.0375).epsilon(1e-13));
        CHECK(c.x[13] == Approx(bound ? -0.0145 : -0.0475).epsilon(1e-13));
    }
}

TEST_CASE("the small program of chapter 28 falls on a ball as the library does")
{
    for (const Real mu : {0.0, 0.5}) {
        small28::Cloth small = small28::sheet(8, 500);
        small.mu = mu;
        small.inverse_mass.tail<3>().setConstant(2), small.g = 0;
        for (int p = 0; p < 81; ++p) small.u[3 * p + 1] = -1;
        TouchingCloth cloth = library_cloth(small);
        TouchingMemory memory;
        ClothSettings how;
        how.h = 1.0 / 480, how.sweeps = 2;
        for (int n = 0; n < 60; ++n) {
            small28::step(small, 1.0 / 480, 2, false);
            step(cloth, how, memory);
            // the library also takes what pushed an overlap out back from velocities: a few of a curved ball's
            CAPTURE(mu, n);
            CHECK((small.x.head(243) - cloth.bodies.x).cwiseAbs().maxCoeff() < 1e-3);
        }
        CHECK(memory.touch.contacts.size() > 5);
        CHECK((small.x.tail<3>() - cloth.solids.x.head<3>()).norm() < 1e-3);
        CHECK(small.x[244] < -0.005);  // it has been pushed
    }
}

TEST_CASE("the small program of chapter 28 visits contacts and pairs as the library does")
{
    Random random(7);
    for (int n = 0; n < 20; ++n) {
        // a ball that flies through particles, which touch nothing else
        small28::Cloth small = small28::sheet(4, 1);
        small.springs.clear();
        small.g = 0, small.inverse_mass.tail<3>().setConstant(3), small.mu = 0.4;
        for (Index i = 0; i < small.u.size(); ++i) small.u[i] = random.uniform(-3, 3);
        TouchingCloth cloth = library_cloth(small);
        ClothTouching touching;
        touching.touch.margin = 0.05;  // as the small program has it
        const VecX x0 = cloth.bodies.x, y = x0 + 0.05 * cloth.bodies.u;
        VecX x = y;
        touching.begin(cloth, 0.05, x0, y);
        touching.find(cloth, x0, y);
        for (int sweep = 0; sweep < 3; ++sweep) touching.visit(cloth, x);
        small28::step(small, 0.05, 3, false);
        CHECK(touching.touch.contacts.size() == small.contacts.size());
        CHECK((small.x.head(75) - x).cwiseAbs().maxCoeff() < 1e-13);
        CHECK((0.05 * small.u.tail<3>() - touching.touch.moved.head<3>()).norm() < 1e-13);
    }
    // particles and triangles of three layers
    small28::Cloth small = small28::three_layers();
    TouchingCloth cloth = library_cloth(small);
    ClothTouching touching;
    touching.prepare(cloth);
    const VecX x0 = cloth.bodies.x, y = x0 + 0.1 * cloth.bodies.u;
    VecX x = y;
    touching.begin(cloth, 0.1, x0, y);
    touching.self.visit(cloth, x);
    small28::step(small, 0.1, 1, false);
    CHECK(touching.self.rows.size() == small.pairs.size());
    CHECK((small.x - x).cwiseAbs().maxCoeff() < 1e-15);
    // what the small program stops by a bound of its own the library stops by the same theorem: none has passed
    step(cloth, {.h = 0.1, .sweeps = 1}, *std::make_unique<TouchingMemory>());
    CHECK(cloth.bodies.x[10] > cloth.bodies.x[1]);
    CHECK(cloth.bodies.x[1] > cloth.bodies.x[13]);
}

namespace {

Numbers on_a_ball(Numbers in)
{
    small28::Cloth c = small28::on_ball(in["mu"]);
    c.inverse_mass.tail<3>().setConstant(1 / in["mass"]);
    small28::step(c, 0.1, 1, false);
    return {{"down", -1000 * c.x[4]}, {"back", -1000 * c.x[0]}, {"along", 1000 * c.x[3]}};
}
const Sentence said("particle_on_ball", on_a_ball, 1e-12);

}  // namespace
