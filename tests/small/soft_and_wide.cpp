/// The small programs of chapters 16 and 17, springs as rows and rows side by side, beside the library.

#include "tests/small/alone.hpp"

#include "chapters/06_sequential_impulse/row_order.hpp"
#include "chapters/06_sequential_impulse/sequential_impulse.hpp"
#include "chapters/16_soft_constraints/softness.hpp"
#include "chapters/16_soft_constraints/xpbd.hpp"
#include "chapters/17_wide_sweeps/waits.hpp"
#include "tests/catch.hpp"
#include "tests/small/sentences.hpp"

#include <bit>
#include <chrono>

#define main small_main
namespace small06_again {
#include "chapters/06_sequential_impulse/small.cpp"
}
namespace small16 {
#include "chapters/16_soft_constraints/small.cpp"
}
namespace small17 {
#include "chapters/17_wide_sweeps/small.cpp"
}
#undef main

using namespace rigid;

namespace {

/// A constraint between discs as the library writes it.
template <class Contact>
Constraint<2> library_constraint(const Contact& c)
{
    Constraint<2> out;
    out.a = c.a < 0 ? world : c.a;
    out.b = c.b;
    out.C = c.C;
    if (c.a >= 0) out.Ja = -c.n.transpose();
    out.Jb = c.n.transpose();
    out.kind = c.lo < 0 ? ConstraintKind::bilateral : ConstraintKind::unilateral;
    return out;
}

template <class Contact>
std::vector<Row<2>> library_rows(const std::vector<Contact>& contacts, const VecX& inverse_mass, Real h)
{
    std::vector<Row<2>> rows;
    for (const Contact& c : contacts) {
        Row<2> row = bilateral(library_constraint(c), inverse_mass, c.C / h);
        row.lo = c.lo, row.hi = infinity;
        if constexpr (requires { c.gamma; }) row.softness = 1 / (h * h * c.k);
        rows.push_back(row);
    }
    return rows;
}

constexpr Real h = 1.0 / 240;

/// The net of the small program for the library's XPBD.
struct NetScene {
    static constexpr int dof = 2;
    Bodies<2> bodies;
    small16::Discs discs;
    std::vector<small16::Contact> contacts;
};
Vec2 way(const small16::Contact& c, const VecX& x)
{
    const Vec2 b = x.segment<2>(2 * c.b);
    return c.a < 0 ? b : Vec2(b - x.segment<2>(2 * c.a));
}
Constraint<2> constraint_at(const NetScene& scene, const StepData<2>&, std::size_t i, const VecX& x)
{
    small16::Contact c = scene.contacts[i];
    const Vec2 before = way(c, scene.discs.x), now = way(c, x);
    if (c.a < 0) {
        c.C += c.n.dot(now - before);
    } else {
        c.C += now.norm() - before.norm();
        c.n = now.normalized();
    }
    return library_constraint(c);
}

/// The net after 240 steps of ten sweeps over positions.
VecX net_by_positions(Real stiffness)
{
    NetScene scene{Bodies<2>(96), small16::net(stiffness), {}};
    small16::Discs& d = scene.discs;
    scene.bodies.inverse_mass = d.inverse_mass;
    Xpbd xpbd;
    xpbd.sweeps = 10;
    xpbd.velocity_pass = false;
    FreeVelocities none;
    StepData<2> now;
    for (int k = 0; k < 96; ++k) now.active.push_back(k);
    for (int n = 0; n < 240; ++n) {
        scene.bodies.x = d.x, scene.bodies.u = d.u;
        for (int k = 1; k < d.u.size(); k += 2) scene.bodies.u[k] -= d.g * h;
        scene.contacts = small16::find_contacts(d);
        now.rows = library_rows(scene.contacts, d.inverse_mass, h);
        now.constraints.resize(now.rows.size());
        xpbd.move(scene, {.h = h}, none, now);
        d.x = scene.bodies.x, d.u = scene.bodies.u;
    }
    return d.x;
}

/// The extent of a net: wide and high [m].
Vec2 extent(const VecX& x)
{
    const auto places = x.reshaped(2, 96);
    return places.rowwise().maxCoeff() - places.rowwise().minCoeff();
}

}  // namespace

TEST_CASE("the small program of chapter 16 has the numbers of the text")
{
    const Real k = 3600 * pi * pi;
    small16::Discs d{
        VecX{{0, 0, 1.01, 0}}, VecX::Zero(4), VecX{{0, 0, 1, 1}}, VecX::Zero(2), {{0, 1, 1, k}}, {}, 0};
    small16::step(d, 1.0 / 60);
    CHECK(d.u[2] == Approx(-0.54).margin(0.005));  // section 16.1
    CHECK(d.u[2] == Approx(implicit_velocity(0.01, 0, {30, 0}, 1.0 / 60)).epsilon(1e-12));
    // Exercise 16.1: a step keeps the part 1/(1 + h²ω²) of the energy.
    const Real off = d.x[2] - 1;
    CHECK((d.u[2] * d.u[2] + k * off * off) / (k * 1e-4) == Approx(1 / (1 + pi * pi)).epsilon(1e-10));
}

TEST_CASE("the small program of chapter 16 makes the visits of the library to 1e-12")
{
    small16::Discs d = small16::net(2000);
    ImpulseMemory<2> memory;
    Real farthest = 0;
    for (int n = 0; n < 100; ++n) {
        small16::Discs before = d;
        for (int k = 1; k < before.u.size(); k += 2) before.u[k] -= before.g * h;
        const auto contacts = small16::find_contacts(before);
        Solution solution;
        solution.lambda.setZero(Index(contacts.size()));
        for (std::size_t i = 0; i < contacts.size(); ++i)
            for (const small16::Contact& old : before.contacts)
                if (old.a == contacts[i].a && old.b == contacts[i].b && old.lo == contacts[i].lo)
                    solution.lambda[Index(i)] = old.lambda;
        VecX u = before.u;
        const std::vector<Row<2>> rows = library_rows(contacts, before.inverse_mass, h);
        sequential_impulse<2>(rows, {}, {.max_sweeps = 10, .tolerance = 0}, memory, u, solution);
        small16::step(d, h, 10);
        farthest = std::max(farthest, (d.u - u).cwiseAbs().maxCoeff());
    }
    CHECK(farthest < 1e-12);  // the same visits, whose sums have another order
    CHECK((d.x - small16::net(2000).x).cwiseAbs().maxCoeff() > 0.5);
}

TEST_CASE("a stiff net stands by positions and is crumpled by as many sweeps over velocities")
{
    // section 16.E
    for (const Real stiffness : {120.0, 1e9}) {
        INFO(stiffness);
        small16::Discs d = small16::net(stiffness);
        for (int n = 0; n < 240; ++n) small16::step(d, h, 10);
        const Vec2 rows = extent(d.x), positions = extent(net_by_positions(stiffness));
        if (stiffness < 1000) {
            CHECK(std::abs(rows[0] - positions[0]) == Approx(0.02).margin(0.005));
        } else {
            CHECK(positions[0] == Approx(2.75).margin(1e-3));  // eleven springs of 0.25 m
            CHECK(positions[1] == Approx(1.75).margin(1e-3));  // seven
            CHECK(rows[0] == Approx(3.1).margin(0.05));
            CHECK(rows[1] == Approx(2.7).margin(0.05));
        }
    }
}

TEST_CASE("the small program of chapter 17 has the waits and the colours of the text and of the library")
{
    std::vector<small17::Contact> line(4, {0, 0, {1, 0}, 0, 0});
    for (int k = 0; k < 4; ++k) line[std::size_t(k)].a = k, line[std::size_t(k)].b = k + 1;
    CHECK(small17::chain(line, 5) == 4);  // section 17.1
    small17::sort_by_colour(line, 5);
    CHECK(small17::chain(line, 5) == 2);

    const small17::Discs d = small17::pyramid(8);
    std::vector<small17::Contact> given = small17::find_contacts(d), sorted = given;
    const std::vector<Row<2>> rows = library_rows(given, d.inverse_mass, h);
    Colouring colouring;
    std::vector<int> order;
    colour_rows(rows, 36, colouring, order);
    small17::sort_by_colour(sorted, 36);
    for (std::size_t i = 0; i < order.size(); ++i) {
        const small17::Contact& c = given[std::size_t(order[i])];
        REQUIRE(sorted[i].a == c.a);
        REQUIRE(sorted[i].b == c.b);
        REQUIRE(sorted[i].colour == colouring.colour[std::size_t(order[i])]);
    }
    CHECK(small17::chain(given, 36) == longest_chain<2>(rows, {}, 36));
    CHECK(small17::chain(sorted, 36) == longest_chain<2>(rows, order, 36));
    CHECK(small17::chain(given, 36) == 38);  // what the text says of its picture
    CHECK(small17::chain(sorted, 36) == 6);
}

TEST_CASE("the small program of chapter 17 has every bit of chapter 6's in one lane and in eight")
{
    const small06_again::Discs start = small06_again::ten_discs();
    small06_again::Discs six = start;
    small17::Discs given{start.x, start.u, start.inverse_mass, start.radius, start.chain, start.walls};
    small17::Discs one = given, eight = given;
    for (int n = 0; n < 100; ++n) {
        INFO("step " << n);
        REQUIRE(small17::step<1>(given, h, false) == small06_again::step(six, h));
        REQUIRE(given.x == six.x);
        REQUIRE(given.u == six.u);
        REQUIRE(small17::step<1>(one, h, true) == small17::step<8>(eight, h, true));
        REQUIRE(one.x == eight.x);
        REQUIRE(one.u == eight.u);
    }
    CHECK((given.x - start.x).norm() > 0.5);
    CHECK(one.x != given.x);  // another order, another error below the tolerance
    CHECK((one.x - given.x).cwiseAbs().maxCoeff() < 1e-3);
}

namespace {

// What the sentences of these chapters say.

Numbers oscillator(Numbers in)
{
    const double omega = 2 * std::numbers::pi * in["hertz"], h = 1.0 / 60;
    Numbers out;
    for (const bool implicit : {false, true}) {
        double x = 0.01, v = 0;
        for (int n = 1; n <= 10; ++n) {
            v = implicit ? rigid::implicit_velocity(x, v, {in["hertz"], in["zeta"]}, h)
                         : v - h * (omega * omega * x + 2 * in["zeta"] * omega * v);
            x += h * v;
            if (n == 1) out[implicit ? "implicit" : "explicit"] = 1000 * x;
        }
        out[implicit ? "implicit10" : "explicit10"] = 1000 * x;
    }
    return out;
}

Numbers line(Numbers in)
{
    const int bodies = static_cast<int>(in["bodies"]);
    std::vector<rigid::Row<2>> rows(static_cast<std::size_t>(bodies - 1));
    std::vector<int> coloured;
    for (int i = 0; i < bodies - 1; ++i) {
        rigid::Row<2>& row = rows[static_cast<std::size_t>(i)];
        row.a = i;
        row.b = i + 1;
        row.Wa.setOnes();
        row.Wb.setOnes();
    }
    for (const int first : {0, 1})
        for (int i = first; i < bodies - 1; i += 2) coloured.push_back(i);
    return {{"rows", rows.size()},
            {"chain", rigid::longest_chain(rows, {}, bodies)},
            {"coloured", rigid::longest_chain<2>(rows, coloured, bodies)}};
}

const Sentence says_oscillator("oscillator", oscillator, 1e-12);
const Sentence says_line("line", line, 0);

}  // namespace
