/// The small programs of chapters 1 and 2 beside the library.

#include "tests/small/alone.hpp"

#include "chapters/01_euler_integration/integrators.hpp"
#include "chapters/01_euler_integration/systems.hpp"
#include "chapters/02_velocity_constraints/constraints.hpp"
#include "chapters/02_velocity_constraints/curves.hpp"
#include "tests/catch.hpp"
#include "tests/small/sentences.hpp"

#define main small_main
namespace small01 {
#include "chapters/01_euler_integration/small.cpp"
}
namespace small02 {
#include "chapters/02_velocity_constraints/small.cpp"
}
#undef main

using namespace rigid;

namespace {

State<1> library_step(const std::string& name, const State<1>& s, Real h, Real omega)
{
    const Spring spring{omega};
    if (name == "explicit") return explicit_euler(s, h, spring);
    if (name == "symplectic") return symplectic_euler(s, h, spring);
    if (name == "verlet") {
        Vec<1> now = spring(s.x);
        return velocity_verlet(s, now, h, spring);
    }
    return implicit_euler_spring(s, h, omega);
}

}  // namespace

TEST_CASE("the small program of chapter 1 has the numbers of the text and every bit of the library")
{
    const small01::Method methods[] = {{"explicit", small01::explicit_euler, ""},
                                       {"symplectic", small01::symplectic_euler, ""},
                                       {"implicit", small01::implicit_euler, ""},
                                       {"verlet", small01::velocity_verlet, ""}};
    for (const auto& [name, step, colour] : methods) {
        INFO(name);
        small01::Body body{1, 0};
        State<1> s{Vec<1>(1), Vec<1>(0)};
        for (int n = 0; n < 100; ++n) {
            step(body, 0.01, 7);
            s = library_step(name, s, 0.01, 7);
            REQUIRE(body.x == s.x[0]);  // the same operations in the same order
            REQUIRE(body.u == s.u[0]);
        }
    }
    // By hand: sections 1.2 to 1.4 and 1.7, steps of 0.5 s.
    small01::Body one{1, 0}, two{1, 0}, three{1, 0}, four{1, 0};
    for (int n = 0; n < 2; ++n) {
        small01::explicit_euler(one, 0.5, 1);
        small01::symplectic_euler(two, 0.5, 1);
    }
    small01::implicit_euler(three, 0.5, 1);
    small01::velocity_verlet(four, 0.5, 1);
    CHECK(four.x == 0.875);
    CHECK(four.u == -0.46875);
    CHECK(small01::energy(one, 1) == 0.78125);
    CHECK(small01::energy(two, 1) == 0.431640625);
    CHECK(small01::energy(three, 1) == Approx(0.4).epsilon(1e-15));
}

TEST_CASE("the small program of chapter 2 has the numbers of the text and the library's to 1e-12")
{
    // By hand, section 2.3.
    small02::Body bead{{0.6, 0.8}, {1, 0.5}, 0.5};
    CHECK(small02::impulse(bead, bead.x.transpose(), 0) == Approx(-2).epsilon(1e-15));
    CHECK(small02::energy(bead) == Approx(1.25).epsilon(1e-15));
    small02::row_step(bead, 0);
    CHECK(small02::energy(bead) == Approx(0.25).epsilon(1e-15));

    small02::Body body{{1, 0}, {0, 1}};
    Bodies<2> bodies(1);
    bodies.x = Vec2(1, 0);
    bodies.u = Vec2(0, 1);
    bodies.inverse_mass.setOnes();
    Real farthest = 0;
    for (int n = 0; n < 1000; ++n) {
        small02::row_step(body, 0.01);
        const Row<2> row = bilateral(circle_constraint(bodies.x, 0, 1), bodies.inverse_mass, 0);
        row.apply(solve_row(row, bodies.u).lambda, bodies.u);
        bodies.x += 0.01 * bodies.u;
        farthest = std::max(farthest, (body.x - bodies.x).norm() + (body.u - bodies.u).norm());
    }
    CHECK(farthest < 1e-12);                                           // the same sums in another order
    CHECK(body.x.norm() == Approx(1.046637127311678).epsilon(1e-12));  // (2.34)
    // The table of section 2.1.
    for (const auto& [stiffness, least, most] :
         {std::tuple{100.0, 0.0195, 0.0197}, {39000.0, 5e-5, 5.2e-5}, {41000.0, 1e3, 1.2e3}}) {
        INFO(stiffness);
        small02::Body sprung{{1, 0}, {0, 1}};
        Real off = 0;
        for (int n = 0; n < 1000; ++n) {
            small02::spring_step(sprung, 0.01, stiffness);
            off = std::max(off, std::abs(sprung.x.norm() - 1));
        }
        CHECK(off > least);
        CHECK(off < most);
    }
}

namespace {

// What the sentences of these chapters say.

Numbers spring(Numbers in)
{
    Numbers out;
    for (const small01::Method& method : {small01::Method{"explicit", small01::explicit_euler, ""},
                                          {"symplectic", small01::symplectic_euler, ""},
                                          {"implicit", small01::implicit_euler, ""}}) {
        small01::Body body{1, 0};
        for (int n = 0; n < 12; ++n) method.step(body, in["h"], 1);
        out[method.name] = small01::energy(body, 1) / small01::energy({1, 0}, 1);
    }
    return out;
}

Numbers stiff_spring(Numbers in)
{
    small02::Body body{{1, 0}, {0, 1}};
    double farthest = 0;
    for (int n = 0; n < 1000; ++n) {
        small02::spring_step(body, 0.01, 1000 * in["k"]);
        farthest = std::max(farthest, std::abs(body.x.norm() - 1));
    }
    return {{"distance", farthest < 1 ? 1000 * farthest : farthest < 1000 ? farthest : farthest / 1000}};
}

const Sentence says_spring("spring", spring, 1e-12);  // the same operations, in another order
const Sentence says_stiff_spring("stiff_spring", stiff_spring,
                                 1e-6);  // 1000 steps of a spring that explodes magnify their rounding

}  // namespace
