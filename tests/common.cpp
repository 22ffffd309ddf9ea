/// The ground that all chapters stand on: contacts, scenes, forces, measures.

#include "tests/catch.hpp"
#include "tests/scene_of.hpp"
#include "tests/sentence.hpp"

#include "cmake/web/to_chars.hpp"
#include "common/contact.hpp"
#include "common/forces.hpp"
#include "common/measure.hpp"
#include "common/random.hpp"
#include "common/scenes.hpp"
#include "common/text.hpp"
#include "common/typical_length.hpp"

using namespace rigid;

namespace {

/// Rounding of a few sums of numbers of size one.
constexpr Real rounding = 1e-14;

std::string sentence_of(const DiscScene& scene)
{
    try {
        require_valid(scene);
    } catch (const std::invalid_argument& refused) {
        return refused.what();
    }
    return "accepted";
}

/// Three discs anywhere, moving anyhow.
Bodies<2> random_triple(Random& random)
{
    Bodies<2> bodies(3);
    for (Index i = 0; i < 6; ++i) {
        bodies.x[i] = random.uniform(-1, 1);
        bodies.u[i] = random.uniform(-3, 3);
    }
    for (Index k = 0; k < 3; ++k)
        bodies.inverse_mass.segment<2>(2 * k).setConstant(1 / random.uniform(0.1, 4));
    return bodies;
}

Real torque(const Bodies<2>& bodies)
{
    Real sum = 0;
    for (Index k = 0; k < bodies.count(); ++k) sum += cross2(bodies.position(k), bodies.force(k));
    return sum;
}

}  // namespace

TEST_CASE("the normal of a contact points from a to b and the gap is negative in an overlap")
{
    VecX x(4), radius(2);
    x << 0, 0, 0.3, 0.4;  // half a metre apart
    radius << 0.2, 0.35;
    std::vector<Contact> contacts;
    find_contacts(scene_of(x, radius), 0, contacts);
    REQUIRE(contacts.size() == 1);
    CHECK(contacts[0].a == 0);
    CHECK(contacts[0].b == 1);
    CHECK((contacts[0].normal - Vec2(0.6, 0.8)).norm() < rounding);
    CHECK(contacts[0].gap == Approx(-0.05).margin(rounding));
}

TEST_CASE("a wall is body a of its contacts and its normal points into the free space")
{
    VecX x(2), radius(1);
    x << 0, 0.15;
    radius << 0.1;
    std::vector<Contact> contacts;
    find_contacts(scene_of(x, radius, {{{0, 1}, 0}}), 0.1, contacts);
    REQUIRE(contacts.size() == 1);
    CHECK(contacts[0].a == world);
    CHECK(contacts[0].b == 0);
    CHECK(contacts[0].normal == Vec2(0, 1));
    CHECK(contacts[0].gap == Approx(0.05).margin(rounding));

    find_contacts(scene_of(x, radius, {{{0, 1}, 0}}), 0.04, contacts);  // a margin below the gap
    CHECK(contacts.empty());
}

TEST_CASE("discs that a link joins do not collide")
{
    DiscScene scene = ten_discs();
    scene.bodies.position(1) = scene.bodies.position(0) + Vec2(0.01, 0);  // neighbours, deep in each other
    std::vector<Contact> contacts;
    find_contacts(scene, 0, contacts);
    for (const Contact& contact : contacts) CHECK_FALSE((contact.a == 0 && contact.b == 1));
    scene.linked.clear();
    find_contacts(scene, 0, contacts);
    CHECK(std::any_of(contacts.begin(), contacts.end(),
                      [](const Contact& contact) { return contact.a == 0 && contact.b == 1; }));
}

TEST_CASE("two discs with one centre get a contact with a finite normal")
{
    VecX x = VecX::Zero(4), radius = VecX::Constant(2, 0.1);
    std::vector<Contact> contacts;
    find_contacts(scene_of(x, radius), 0, contacts);
    REQUIRE(contacts.size() == 1);
    CHECK(contacts[0].normal.norm() == Approx(1).margin(rounding));
    CHECK(contacts[0].gap == Approx(-0.2).margin(rounding));
}

TEST_CASE("centres whose distance has no square get a unit normal and those that have one their own")
{
    // (1e-160)² is 1e-320, which has four digits; (5e-324)² is 0; that of 1e-74 has all of its digits
    for (const Real distance : {5e-324, 1e-160, 1e-155, 1e-74, 1e-3}) {
        VecX x = VecX::Zero(4), radius = VecX::Constant(2, 0.1);
        x[2] = 0.6 * distance, x[3] = -0.8 * distance;
        std::vector<Contact> contacts;
        find_contacts(scene_of(x, radius), 0, contacts);
        REQUIRE(contacts.size() == 1);
        CHECK(std::abs(contacts[0].normal.norm() - 1) < rounding);
        if (distance > 1e-75) CHECK((contacts[0].normal - Vec2(0.6, -0.8)).norm() < rounding);

        DiscScene beside;  // beyond the end of a wall
        beside.segments = {{{-1, 0}, {0, 0}, 0.05}};
        add_disc(beside, {0.6 * distance, -0.8 * distance}, 1, 0.1);
        find_contacts(beside, 0, contacts);
        REQUIRE(contacts.size() == 1);
        CHECK(std::abs(contacts[0].normal.norm() - 1) < rounding);
    }
}

TEST_CASE("a wall with two ends is solid from both sides and round at its ends")
{
    DiscScene scene;
    scene.segments = {{{-1, 0}, {1, 0}, 0.05}};
    const auto at = [&](Real x, Real y) {
        scene.bodies = Bodies<2>(0);
        scene.radius.resize(0);
        add_disc(scene, {x, y}, 1, 0.1);
        std::vector<Contact> contacts;
        find_contacts(scene, 10, contacts);
        REQUIRE(contacts.size() == 1);
        CHECK(contacts[0].a == world);
        CHECK(contacts[0].feature == 0);
        return contacts[0];
    };
    CHECK(at(0.3, 0.2).normal == Vec2(0, 1));
    CHECK(at(0.3, 0.2).gap == Approx(0.05).margin(rounding));
    CHECK(at(0.3, -0.2).normal == Vec2(0, -1));
    CHECK(at(0.3, -0.12).gap == Approx(-0.03).margin(rounding));
    CHECK((at(1.3, 0.4).normal - Vec2(0.6, 0.8)).norm() < rounding);
    CHECK(at(1.3, 0.4).gap == Approx(0.35).margin(rounding));
    CHECK((at(-1.3, -0.4).normal - Vec2(-0.6, -0.8)).norm() < rounding);
}

TEST_CASE("a disc whose centre is an end of a wall is parted from it along a unit normal")
{
    // The foot of such a centre lies beyond the end by rounding in about one of four.
    Random random(3);
    for (int sample = 0; sample < 100; ++sample) {
        DiscScene scene;
        Segment& wall = scene.segments.emplace_back(Segment{{0, 0}, {0, 0}, 0.05});
        for (Vec2* const end : {&wall.p, &wall.q})
            for (Real& coordinate : *end) coordinate = random.uniform(-1, 1);
        for (const Vec2& end : {wall.p, wall.q}) add_disc(scene, end, 1, 0.1);
        scene.linked = PairSet::all();
        std::vector<Contact> contacts;
        find_contacts(scene, 0, contacts);
        REQUIRE(contacts.size() == 2);
        for (const Contact& contact : contacts) {
            CHECK(contact.normal.norm() == Approx(1).margin(rounding));
            CHECK(contact.gap == Approx(-0.15).margin(rounding));
        }
    }
}

TEST_CASE("pairs that do not collide are a list in which each pair is found in any order")
{
    const PairSet some({{3, 1}, {1, 3}, {0, 2}});
    CHECK(some.pairs() == std::vector<PairSet::Pair>{{0, 2}, {1, 3}});
    CHECK(some.contains(1, 3));
    CHECK(some.contains(3, 1));
    CHECK_FALSE(some.contains(1, 2));
    CHECK(PairSet().empty());
    CHECK_FALSE(PairSet().contains(0, 1));
    CHECK(PairSet::all().contains(5, 7));
    CHECK_FALSE(PairSet::all().empty());
}

TEST_CASE("a disc is added to a scene with its mass and radius or refused by a sentence")
{
    DiscScene scene = column(2);
    CHECK(add_disc(scene, {1, 2}, 4, 0.3) == 2);
    CHECK(add_disc(scene, {3, 2}, infinity, 0.3) == 3);
    CHECK_NOTHROW(require_valid(scene));
    CHECK(scene.bodies.position(2) == Vec2(1, 2));
    CHECK(scene.bodies.velocity(2) == Vec2(0, 0));
    CHECK(scene.bodies.inverse_mass[4] == 0.25);
    CHECK(scene.bodies.inverse_mass[6] == 0);
    CHECK(sentence_of([&] {
              add_disc(scene, {0, 0}, 0, 1);
          }) == "the mass of disc 4 is 0; it must be positive");
    CHECK(sentence_of([&] {
              add_disc(scene, {0, 0}, 1e-310, 1);
          }) == "the mass of disc 4 is 1e-310; it must be so large that its inverse is finite");
    CHECK(sentence_of([&] {
              add_disc(scene, {0, 0}, 1, -1);
          }) == "the radius of disc 4 is -1; it must be a positive number of metres");
    CHECK(sentence_of([&] {
              add_disc(scene, {infinity, 0}, 1, 1);
          }) == "the place of disc 4 is inf, 0; it must be finite");
    CHECK(scene.bodies.count() == 4);  // nothing was added on the way
}

TEST_CASE("the ten-disc scene is what the book says it is")
{
    const DiscScene scene = ten_discs();
    REQUIRE_NOTHROW(require_valid(scene));
    CHECK(scene.bodies.count() == 10);
    CHECK(scene.links.size() == 6);
    CHECK(scene.bends.size() == 5);
    CHECK(scene.walls.size() == 4);
    CHECK(largest_link_error(scene) < rounding);
    CHECK(deepest_penetration(scene) == 0);
    // Seven of 0.1 kg, two of 0.2 kg, one of 0.4 kg: the momentum at 1 m/s is the mass, 1.5 kg.
    Bodies<2> moving = scene.bodies;
    moving.u.setOnes();
    CHECK((momentum(moving) - Vec2(1.5, 1.5)).norm() < rounding);
}

TEST_CASE("the torsional spring pushes with ten g k m sine of the bend angle")
{
    // A right angle with links of 0.1 m and discs of 0.1 kg: each neighbour is pushed by 10·9.81·k·0.1 N.
    Bodies<2> bodies(3);
    bodies.x << 0, 0, 0.1, 0, 0.1, 0.1;
    bodies.inverse_mass.setConstant(10);
    const Bend bend{0, 1, 2, 0.1};
    CHECK(bend_angle(bodies.x, bend) == Approx(pi / 2).margin(rounding));
    add_bend_springs(bodies, {bend}, 2, 0);
    const Real F = 10 * 9.81 * 2 * 0.1;
    CHECK((bodies.force(0) - Vec2(0, -F)).norm() < F * rounding);  // down, across the first link
    CHECK((bodies.force(2) - Vec2(F, 0)).norm() < F * rounding);   // right, across the second link
    CHECK((bodies.force(1) - Vec2(-F, F)).norm() < F * rounding);

    SECTION("and no more than that beyond ninety degrees")
    {
        bodies.x.tail<2>() << 0.1 - 0.08, 0.06;  // bent further
        bodies.f.setZero();
        add_bend_springs(bodies, {bend}, 2, 0);
        CHECK(bend_angle(bodies.x, bend) > pi / 2);
        CHECK(bodies.force(2).norm() == Approx(F).epsilon(1e-13));  // a few roundings
    }
}

TEST_CASE("torsional springs and dampers balance linear and angular momentum in any state")
{
    Random random(1);
    for (int sample = 0; sample < 1000; ++sample) {
        Bodies<2> bodies = random_triple(random);
        const Real damping = random.uniform(0, 20), stiffness = random.uniform(0, 5);
        add_bend_springs(bodies, {{0, 1, 2, random.uniform(0.05, 2)}}, stiffness, damping);
        const Vec2 sum = bodies.force(0) + bodies.force(1) + bodies.force(2);
        const Real size = bodies.f.lpNorm<1>();
        // Rounding of sums of forces of this size; lever arms are at most 1.5 m.
        CHECK(sum.norm() <= 1e-15 * size);
        CHECK(std::abs(torque(bodies)) <= 1e-14 * size);
    }
}

TEST_CASE("the torsional damper takes energy and never gives any")
{
    Random random(2);
    for (int sample = 0; sample < 1000; ++sample) {
        Bodies<2> bodies = random_triple(random);
        add_bend_springs(bodies, {{0, 1, 2, 0.1}}, 0, random.uniform(0, 20));
        const Real power = bodies.f.dot(bodies.u);
        CHECK(power <= 1e-14 * bodies.f.lpNorm<1>() * bodies.u.lpNorm<Eigen::Infinity>());
    }
}

TEST_CASE("the bend force is zero where there is no angle to speak of")
{
    Bodies<2> bodies(3);  // three centres in one point
    add_bend_springs(bodies, {{0, 1, 2, 0.1}}, 2, 1);
    CHECK(bodies.f.isZero(0));
}

TEST_CASE("a bend about a disc that cannot move has no force since it is measured in that disc's mass")
{
    Bodies<2> bodies(3);
    bodies.x << -1, 0, 0, 0, 0, 1;  // a right angle
    bodies.u << 0, 1, 0, 0, 1, 0;
    const std::vector<Bend> bend{{0, 1, 2, 1}};
    add_bend_springs(bodies, bend, 2, 1);
    CHECK(bodies.f.norm() > 1);
    bodies.f.setZero();
    bodies.inverse_mass.segment<2>(2).setZero();
    add_bend_springs(bodies, bend, 2, 1);
    CHECK(bodies.f.isZero(0));
}

TEST_CASE("gravity and the pulling hand leave bodies alone that cannot move")
{
    Bodies<2> bodies(2);
    bodies.inverse_mass << 0, 0, 0.5, 0.5;
    add_gravity(bodies, {0, -9.81});
    CHECK(bodies.force(0).isZero(0));
    CHECK((bodies.force(1) - Vec2(0, -2 * 9.81)).norm() < rounding);
    bodies.f.setZero();
    add_pull(bodies, 0, {1, 1});
    CHECK(bodies.f.isZero(0));
}

TEST_CASE("free fall trades potential for kinetic energy")
{
    Bodies<2> bodies(1);
    bodies.inverse_mass.setConstant(0.5);  // 2 kg
    const Vec2 gravity(0, -9.81);
    bodies.x << 3, 4;
    const Real above = potential_energy(bodies, gravity);
    CHECK(above == Approx(2 * 9.81 * 4).epsilon(1e-14));
    bodies.x << 3, 0;
    bodies.u << 0, -std::sqrt(2 * 9.81 * 4);
    CHECK(kinetic_energy(bodies) + potential_energy(bodies, gravity) == Approx(above).epsilon(1e-14));
    CHECK(angular_momentum(bodies) == Approx(2 * 3 * bodies.u[1]).epsilon(1e-14));
}

TEST_CASE("a scene that makes no sense is refused by a sentence that names the thing and the value")
{
    DiscScene scene = ten_discs();
    SECTION("NaN in a position")
    {
        scene.bodies.x[3] = std::nan("");
        CHECK(sentence_of(scene) == "x[3] is nan; it must be a finite number");
    }
    SECTION("a negative mass")
    {
        scene.bodies.inverse_mass[4] = -2;
        CHECK(sentence_of(scene) == "inverse_mass[4] is -2 1/kg; it must be zero (cannot move) or positive");
    }
    SECTION("a velocity too few")
    {
        scene.bodies.u.conservativeResize(19);
        CHECK(sentence_of(scene) == "u has 19 entries; x has 20");
    }
    SECTION("a radius of zero")
    {
        scene.radius[2] = 0;
        CHECK(sentence_of(scene) == "the radius of disc 2 is 0; it must be a positive number of metres");
    }
    SECTION("a normal that is not a unit vector")
    {
        scene.walls[1].normal = {-2, 0};
        CHECK(sentence_of(scene) == "the length of the normal of wall 1 is 2; it must be 1");
    }
    SECTION("a link to a body that does not exist")
    {
        scene.links[0].b = 10;
        CHECK(sentence_of(scene) == "link 0 names body 10; the scene has bodies 0 to 9");
    }
    SECTION("a link of a body to itself")
    {
        scene.links[2] = {4, 4, 0.1};
        CHECK(sentence_of(scene) == "link 2 joins body 4 to itself");
    }
    SECTION("a bend of two bodies")
    {
        scene.bends[1] = {3, 4, 4, 0.1};
        CHECK(sentence_of(scene) == "bend 1 names body 4 twice; it must name three bodies");
        scene.bends[1] = {4, 4, 3, 0.1};
        CHECK(sentence_of(scene) == "bend 1 names body 4 twice; it must name three bodies");
        scene.bends[1] = {4, 3, 4, 0.1};
        CHECK(sentence_of(scene) == "bend 1 names body 4 twice; it must name three bodies");
    }
    SECTION("a joint to a body that does not exist")
    {
        scene.joints.push_back({.b = 10});
        CHECK(sentence_of(scene) == "joint 0 names body 10; the scene has bodies 0 to 9");
    }
    SECTION("a radius too few")
    {
        scene.radius.conservativeResize(9);
        CHECK(sentence_of(scene) == "there are 9 radii for 10 discs");
    }
    SECTION("a link of no length")
    {
        scene.links[1].length = 0;
        CHECK(sentence_of(scene) == "the length of link 1 is 0; it must be a positive number of metres");
    }
    SECTION("a step of zero")
    {
        CHECK_THROWS_WITH(require_step(0), "the time step h is 0 s; it must be positive and finite");
    }
}

TEST_CASE("a scene of no discs or of less than none is refused by a sentence")
{
    CHECK_THROWS_WITH(column(0), "the number of discs in a column is 0; it must be 1 or more");
    CHECK_THROWS_WITH(column(-2), "the number of discs in a column is -2; it must be 1 or more");
    CHECK_THROWS_WITH(column_between_walls(0), "the number of discs in a column is 0; it must be 1 or more");
    CHECK_THROWS_WITH(triangle(0),
                      "the number of discs at the base of a triangle is 0; it must be 1 or more");
    CHECK_THROWS_WITH(hanging_chain(-1), "the number of links in a chain is -1; it must be 1 or more");
    CHECK_THROWS_WITH(swinging_chain(0), "the number of links in a chain is 0; it must be 1 or more");
    CHECK_THROWS_WITH(column(3, 0), "the mass of disc 2 is 0; it must be positive");
    CHECK_THROWS_WITH(hanging_chain(3, std::nan("")), "the mass of disc 3 is nan; it must be positive");
    CHECK_THROWS_WITH(column_between_walls(2, 1, infinity),
                      "the clearance beside a column is inf; it must be zero or a positive number of metres");
    CHECK_THROWS_WITH(
        column_between_walls(2, 1, -0.01),
        "the clearance beside a column is -0.01; it must be zero or a positive number of metres");
    CHECK(column_between_walls(1).bodies.count() == 1);
    CHECK(hanging_chain(1).bodies.count() == 2);
}

TEST_CASE("the length of a scene is a number whatever its discs are")
{
    DiscScene scene;
    CHECK(typical_length(scene) == 1);  // of none
    scene.bodies = Bodies<2>(1);
    scene.bodies.inverse_mass.setZero();
    scene.radius = VecX::Constant(1, 2);
    CHECK(typical_length(scene) == 10);  // of all, as none can move: log10(20) is 1.3
    for (const Real radius : {1e308, infinity, Real(NAN), -1.0, 0.0}) {
        scene.radius.setConstant(radius);
        CHECK(typical_length(scene) == 1);
        if (radius > 1) {  // of bodies that turn: the sum of two is beyond all numbers
            const Bodies<3> bodies(2);
            CHECK(typical_length(bodies, 0, [radius](Index) { return radius; }) == 1);
        }
    }
}

TEST_CASE("a message has the number itself and not its first six digits")
{
    CHECK_THROWS_WITH(require_step(-1e-9), "the time step h is -1e-09 s; it must be positive and finite");
    CHECK_THROWS_WITH(require_step(std::nan("")), "the time step h is nan s; it must be positive and finite");
    DiscScene scene = ten_discs();
    scene.bodies.inverse_mass[4] = -1e-12;
    CHECK(sentence_of(scene) == "inverse_mass[4] is -1e-12 1/kg; it must be zero (cannot move) or positive");
    for (const Real value : {1e-9, 0.1, 1.0 / 3, -1e300, 5e-324, 123456.789})
        CHECK(parse_real(shortest(value)) == value);
}

TEST_CASE("what is no finite number is written the same in each form")
{
    CHECK(fixed(-infinity, 2) == "-inf");
    CHECK(significant(-infinity, 4) == "-inf");
    for (const Real value : {std::nan(""), -std::nan("")}) {
        CHECK(fixed(value, 2) == "nan");
        CHECK(readable(value) == "nan");
    }
    CHECK(fixed(infinity, 2) == "inf");
    CHECK(fixed(-0.001, 2) == "0.00");  // and zero has no sign
}

TEST_CASE("a page writes each number as every other program does", "[house]")
{
    // std::to_chars, which the pages' compiler has not, is exact: no tolerance
    namespace web = rigid::web;
    std::vector<Real> numbers{
        0,    0.5,    1.5, 2.5,  9.5,  999999.5, 0.045,      0.95,   9.995,     1e-4,
        1e-5, 120000, 1e5, 1e22, 1e23, 0x1p52,   0x1p53 - 1, 5e-324, 0x1p-1022, 1.7976931348623157e308};
    for (int e = -1074; e < 1024; e += 7) numbers.push_back(std::ldexp(Real{1}, e));
    Random random(1);
    for (int i = 0; i < 300; ++i) {
        const Real some = random.uniform(-1, 1);
        for (const Real scale : {1.0, 1e-3, 1e9, 1e-200, 1e300}) numbers.push_back(scale * some);
        numbers.push_back(std::round(1000 * some) / 1000);
        numbers.push_back(std::round(1000 * some) * 1000);
    }
    const auto same = [](const std::string& text, Real value, auto... how) {
        char its[400];
        const auto end = std::to_chars(its, its + sizeof its, value, how...).ptr;
        CHECK(text == std::string(its, end));
    };
    for (const Real value : numbers) {
        same(web::text_of(value, web::Form::shortest), value);
        same(web::text_of(-value, web::Form::shortest), -value);
        for (const int digits : {0, 1, 3, 6, 10, 20}) {
            same(web::text_of(value, web::Form::fixed, digits), value, std::chars_format::fixed, digits);
            same(web::text_of(value, web::Form::general, digits), value, std::chars_format::general, digits);
        }
    }
}

TEST_CASE("random numbers are the same on every machine")
{
    Random random(42);
    // std::mt19937_64 seeded with 42: its first output is 13930160852258120406 by the standard's algorithm.
    CHECK(random.uniform() == static_cast<Real>(13930160852258120406ULL >> 11) * 0x1.0p-53);
    Real mean = 0, square = 0;
    constexpr int count = 100000;
    for (int i = 0; i < count; ++i) {
        const Real value = random.normal();
        mean += value / count;
        square += value * value / count;
    }
    // Three and a bit standard deviations of the mean (1/√n) and of the variance (√(2/n)).
    CHECK(std::abs(mean) < 0.011);
    CHECK(std::abs(square - 1) < 0.016);

    Random untouched(42), refused(42);
    for (const Index none : {Index{0}, Index{-3}})
        CHECK_THROWS_WITH(refused.index(none), "a random number is to be one of " + std::to_string(none) +
                                                   "; there must be 1 or more");
    CHECK(refused.index(1000) == untouched.index(1000));  // a refusal draws nothing
}

TEST_CASE("every scene is valid and starts with its links at their length and its discs touching at most")
{
    const std::vector<DiscScene> scenes = {
        ten_discs(),  column(5, 100), column_between_walls(5, 100), column_between_walls(5, 1, 0.01),
        triangle(1),  triangle(6),    hanging_chain(7, 10),         swinging_chain(7, 10),
        towed_discs()};
    for (const DiscScene& scene : scenes) {
        CHECK_NOTHROW(require_valid(scene));
        CHECK(deepest_penetration(scene) <= rounding);
        CHECK(largest_link_error(scene) <= rounding);
    }
}

TEST_CASE("a triangle of discs touches the floor and both walls and each disc stands on two")
{
    const Index base = 5;
    const DiscScene scene = triangle(base);
    REQUIRE(scene.bodies.count() == base * (base + 1) / 2);
    std::vector<Contact> contacts;
    find_contacts(scene, 1e-9, contacts);
    Index on_walls = 0, beside = 0, upright = 0;
    for (const Contact& contact : contacts) {
        if (contact.a == world) ++on_walls;
        else if (std::abs(contact.normal.y()) < 0.1) ++beside;
        else ++upright;
    }
    CHECK(on_walls == base + 2);             // the floor, and a wall at each end of the lowest row
    CHECK(beside == base * (base - 1) / 2);  // in each row one less than discs
    CHECK(upright == base * (base - 1));     // two below each disc that is not on the floor
    for (const Contact& contact : contacts)
        if (contact.a != world && std::abs(contact.normal.y()) > 0.1)
            CHECK(contact.normal.y() == Approx(std::sqrt(3.0) / 2).epsilon(1e-12));
}

TEST_CASE("a perturbation sets off each disc that can move by its amount in a direction of its own")
{
    const DiscScene at_rest = hanging_chain(40, 1000);
    constexpr Real amount = 1e-3;
    const DiscScene moved = perturbed(at_rest, 7, amount), again = perturbed(at_rest, 7, amount);
    CHECK(moved.bodies.x == again.bodies.x);
    CHECK(moved.bodies.x != perturbed(at_rest, 8, amount).bodies.x);
    CHECK(moved.bodies.position(0) == at_rest.bodies.position(0));
    CHECK(moved.bodies.u == at_rest.bodies.u);
    Vec2 sum = Vec2::Zero();
    for (Index k = 1; k <= 40; ++k) {
        const Vec2 off = (moved.bodies.position(k) - at_rest.bodies.position(k)) / amount;
        // A position of 4 m is rounded to 4e-16 m, and that is 4e-13 of a millimetre.
        CHECK(std::abs(off.norm() - 1) < 1e-12);
        sum += off;
    }
    // Forty directions drawn by lot: their mean is about 1/sqrt(40) long, and 1 if they were all the same.
    CHECK(sum.norm() / 40 < 0.4);
    CHECK(perturbed(at_rest, 7, 0).bodies.x == at_rest.bodies.x);
    CHECK_THROWS_WITH(perturbed(at_rest, 7, -1),
                      "the amount of a perturbation [m] is -1; it must be finite and not negative");
    CHECK_THROWS_AS(perturbed(at_rest, 7, infinity), std::invalid_argument);
}

TEST_CASE("a swinging chain is a hanging chain turned by a quarter turn with its anchor in place")
{
    const DiscScene hanging = hanging_chain(4, 3), swinging = swinging_chain(4, 3);
    CHECK(swinging.bodies.inverse_mass == hanging.bodies.inverse_mass);
    for (Index k = 0; k <= 4; ++k) {
        CHECK(swinging.bodies.position(k).x() == -hanging.bodies.position(k).y());
        CHECK(swinging.bodies.position(k).y() == 0);
    }
}
