/// The sentences whose numbers can be dragged on the site (docs/tools/sentences.py): the small programs give the numbers of
/// sentences.csv, to which docs/web/test/sentences.mjs holds what the pages compute.

#include "tests/small/alone.hpp"

#include "chapters/16_soft_constraints/softness.hpp"
#include "chapters/17_wide_sweeps/waits.hpp"
#include "chapters/18_islands/island_shape.hpp"
#include "chapters/20_turning_in_space/tumbling.hpp"
#include "tests/catch.hpp"

#include <set>
#include <sstream>
#include <string>

#define main small_main
namespace said01 {
#include "chapters/01_euler_integration/small.cpp"
}
namespace said02 {
#include "chapters/02_velocity_constraints/small.cpp"
}
namespace said03 {
#include "chapters/03_mlcp_formulation/small.cpp"
}
namespace said04 {
#include "chapters/04_pgs/small.cpp"
}
namespace said05 {
#include "chapters/05_lemke/small.cpp"
}
namespace said06 {
#include "chapters/06_sequential_impulse/small.cpp"
}
namespace said07 {
#include "chapters/07_baumgarte/small.cpp"
}
namespace said08 {
#include "chapters/08_warm_starting/small.cpp"
}
namespace said09 {
#include "chapters/09_active_sets/small.cpp"
}
namespace said11 {
#include "chapters/11_rotation/small.cpp"
}
namespace said12 {
#include "chapters/12_contact_manifolds/small.cpp"
}
namespace said13 {
#include "chapters/13_friction/small.cpp"
}
namespace said14 {
#include "chapters/14_joints/small.cpp"
}
namespace said15 {
#include "chapters/15_trees/small.cpp"
}
namespace said21 {
#include "chapters/26_four_ways/small.cpp"
}
namespace said_joint {
#include "chapters/21_joints_in_space/small.cpp"
}
namespace said_distance {
#include "chapters/22_distance_of_solids/small.cpp"
}
namespace said_faces {
#include "chapters/23_faces_that_touch/small.cpp"
}
namespace said_disc {
#include "chapters/24_friction_is_a_disc/small.cpp"
}
namespace said23 {
#include "chapters/29_waves/small.cpp"
}
#undef main

namespace {

using Numbers = std::map<std::string, double>;

Numbers numbers(const std::string& text)
{
    Numbers found;
    std::istringstream words(text);
    for (std::string word; words >> word;) {
        const auto equals = word.find('=');
        found[word.substr(0, equals)] = std::stod(word.substr(equals + 1));
    }
    return found;
}

const Eigen::VectorXd none = Eigen::VectorXd::Zero(2);  // lower bounds of two contacts
const double degree = std::numbers::pi / 180;

Numbers spring(Numbers in)
{
    Numbers out;
    for (const said01::Method& method : {said01::Method{"explicit", said01::explicit_euler, ""},
                                         {"symplectic", said01::symplectic_euler, ""},
                                         {"implicit", said01::implicit_euler, ""}}) {
        said01::Body body{1, 0};
        for (int n = 0; n < 12; ++n) method.step(body, in["h"], 1);
        out[method.name] = said01::energy(body, 1) / said01::energy({1, 0}, 1);
    }
    return out;
}

Numbers stiff_spring(Numbers in)
{
    said02::Body body{{1, 0}, {0, 1}};
    double farthest = 0;
    for (int n = 0; n < 1000; ++n) {
        said02::spring_step(body, 0.01, 1000 * in["k"]);
        farthest = std::max(farthest, std::abs(body.x.norm() - 1));
    }
    return {{"distance", farthest < 1 ? 1000 * farthest : farthest < 1000 ? farthest : farthest / 1000}};
}

Numbers corner(Numbers in)
{
    const Eigen::MatrixXd J{{0, 1}, {0.6, 0.8}}, A = J * J.transpose();
    const Eigen::VectorXd u{{in["x"], in["y"]}};
    Eigen::VectorXd lambda;
    REQUIRE(said03::enumerate(A, J * u, none, lambda) > 0);
    const Eigen::VectorXd v = u + J.transpose() * lambda;
    return {{"floor", lambda[0]}, {"ramp", lambda[1]}, {"x", v[0]}, {"y", v[1]}};
}

Numbers column(Numbers in)
{
    const double mass = in["mass"];
    const Eigen::MatrixXd A{{1, -1}, {-1, 1 + 1 / mass}};
    Eigen::VectorXd lambda = none;
    for (int n = 0; n < in["sweeps"]; ++n) said04::pgs(A, Eigen::VectorXd{{-1, 0}}, none, lambda, 1);
    return {{"first", lambda[0]}, {"second", lambda[1]}, {"missing", 100 * (1 - lambda[0] / (1 + mass))}};
}

Numbers cones(Numbers in)
{
    const Eigen::MatrixXd A{{2, 1}, {1, 2}};
    Eigen::VectorXd z = none;
    const int pivots = said05::lemke(A, Eigen::VectorXd{{in["q1"], in["q2"]}}, none, z);
    return {{"pivots", pivots}, {"z1", z[0]}, {"z2", z[1]}};
}

Numbers visits(Numbers in)
{
    said06::Discs two{Eigen::VectorXd::Zero(4),
                      Eigen::VectorXd{{0, -1, 0, -1}},
                      Eigen::VectorXd::Ones(4),
                      Eigen::VectorXd::Ones(2),
                      0,
                      {}};
    two.inverse_mass.tail<2>() /= in["mass"];
    said06::Contact rows[]{{-1, 0, {0, 1}, 0, 0}, {0, 1, {0, 1}, 0, 0}};
    for (int k = 0; k < in["visits"]; ++k) said06::visit(rows[k % 2], two);
    return {{"lower", two.u[1]}, {"upper", two.u[3]}};
}

Numbers long_link(Numbers in)
{
    said07::Discs two{Eigen::VectorXd{{0, 0, 0.11, 0}},
                      Eigen::VectorXd::Zero(4),
                      Eigen::VectorXd::Ones(4),
                      Eigen::VectorXd{{0.05, 0.05}},
                      2,
                      {}};
    Numbers out;
    for (int n = 0; n <= 20; ++n) {
        if (n == 4) out["after4"] = 1000 * said07::find_contacts(two)[0].C;
        if (n == 20) out["after20"] = 1000 * said07::find_contacts(two)[0].C;
        said07::step(two, 1.0 / 60, in["beta"]);
    }
    return out;
}

Numbers two_discs(Numbers in)
{
    said08::Discs warm = said08::column(2);
    for (int n = 0; n < 2; ++n) said08::step(warm, 1.0 / 60, 0.2);
    said08::Discs cold = warm;
    cold.contacts.clear();
    warm.g = cold.g = 9.81 * (1 + in["percent"] / 100);
    return {{"cold", said08::step(cold, 1.0 / 60, 0.2)}, {"warm", said08::step(warm, 1.0 / 60, 0.2)}};
}

Numbers guess(Numbers in)
{
    const Eigen::MatrixXd A{{2, 1}, {1, 2}};
    const Eigen::VectorXd q{{-5, in["q2"]}};
    Eigen::VectorXd first, lambda;
    std::vector<bool> once(2, true), active(2, true);
    said09::guess(A, q, none, once, first, 1);
    const int guesses = said09::guess(A, q, none, active, lambda);
    return {{"first1", first[0]},
            {"first2", first[1]},
            {"guesses", guesses},
            {"answer1", lambda[0]},
            {"answer2", lambda[1]}};
}

Numbers rod(Numbers in)
{
    said11::Bodies d{{}, {}, {}, {}, Eigen::VectorXd{{0, 1, 0}}};
    const double angle = in["angle"] * degree;
    said11::add_box(d, 0.5, 0, 1, {0, 0.5 * std::sin(angle), angle});
    d.u[1] = -1;
    said11::Contact c = said11::find_contacts(d).at(0);
    c.bias = in["e"] * c.J.dot(d.u);
    said11::visit(c, d);
    return {{"lambda", c.lambda}, {"v", d.u[1]}, {"omega", d.u[2]}};
}

Numbers across(Numbers in)
{
    said12::Bodies d{{}, {}, {}, {}, 10};
    said12::add_box(d, 2, 1, INFINITY, {0, 0, 0});
    said12::add_box(d, 1, 0.5, 3, {in["x"], 1.49, 0});
    said12::step(d, 0.1, 0);
    REQUIRE(d.contacts.size() == 2);
    const bool first = d.contacts[0].p.x() < d.contacts[1].p.x();
    return {{"left", d.contacts[first ? 0 : 1].lambda}, {"right", d.contacts[first ? 1 : 0].lambda}};
}

Numbers slope(Numbers in)
{
    said13::Bodies d = said13::boxes(1, in["angle"] * degree, in["mu"], 10);
    said13::step(d, 0.1, 1000);
    return {{"speed", d.u.segment<2>(3).norm()}, {"limit", std::atan(in["mu"]) / degree}};
}

Numbers door(Numbers in)
{
    said14::Bodies d = said14::door(in["gap"] / 1000);
    d.inverse_mass.tail<3>() *= 3 / in["mass"];
    said14::step(d, 0.1, 1);
    return {{"pin", d.rows[1].lambda},
            {"stop", d.rows[2].lambda},
            {"motor", d.rows[3].lambda},
            {"omega", d.u[5]}};
}

Numbers two_rods(Numbers in)
{
    said15::Bodies d{{}, {}, {}, {}, 1};
    said15::add_rod(d, 1, 1, 0);
    said15::add_rod(d, 1, in["mass"], 0);
    said15::step(d, 1, 0);
    return {{"first", d.pins[0].lambda[1]},
            {"second", d.pins[1].lambda[1]},
            {"turn1", 9.81 * d.u[2]},
            {"turn2", 9.81 * d.u[5]},
            {"end", -d.u[2]}};
}

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

Numbers tower(Numbers in)
{
    const int boxes = static_cast<int>(in["boxes"]);
    const rigid::IslandShape shape{boxes, 4 * boxes, 4 * boxes, 0, boxes, boxes, in["ratio"]};
    return {{"sweeps", shape.price_of_sweeps()}, {"exact", shape.price_of_exact()}};
}

Numbers bead_ways(Numbers in)
{
    const auto off = [&](void (*step)(said21::Body&, double, double)) {
        said21::Body body = said21::by_hand();
        step(body, in["h"], 0);
        return 1000 * said21::off(body);
    };
    return {{"spring", off(said21::spring_step)},
            {"inside", -off(said21::acceleration_step)},
            {"velocity", off(said21::row_step)}};
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

/// What the row of the first swing turns about, in the axes of the door.
Numbers hinge(Numbers in)
{
    const said_joint::Bodies d = said_joint::door(in["angle"] * std::numbers::pi / 180, 0);
    const said_joint::Row row = said_joint::coordinate(d, d.joints[0], 4);
    return {{"lean", std::atan2(-row.Jb[5], row.Jb[4]) * 180 / std::numbers::pi}};
}

Numbers triangles(Numbers in)
{
    const double up = in["up"];
    return {
        {"distance", said_distance::nearest_points(said_distance::triangle(0, 0, 4, 4, 1, 3),
                                                   said_distance::triangle(5, 1 + up, 8, 2 + up, 5, 5 + up))
                         .distance}};
}

Numbers squares(Numbers in)
{
    const double right = in["right"], x[] = {0.5, 1.75, 0.5, -0.75}, y[] = {-0.75, 0.5, 1.75, 0.5};
    std::vector<said_faces::Corner> polygon;
    for (int k = 0; k < 4; ++k) polygon.push_back({{x[k] + right, y[k], 0}, k, k});
    for (int k = 0; k < 4; ++k) {
        const Eigen::Vector3d out(k == 0 ? 1 : k == 2 ? -1 : 0, k == 1 ? 1 : k == 3 ? -1 : 0, 0);
        polygon = said_faces::cut(polygon, out, out, k);
    }
    double twice = 0;
    for (std::size_t i = 0; i < polygon.size(); ++i)
        twice += polygon[i].at.cross(polygon[(i + 1) % polygon.size()].at).z();
    return {{"area", twice / 2}};
}

Numbers hoop(Numbers in)
{
    said_disc::Bodies d = said_disc::hoop(1.8, in["across"]);
    said_disc::Contact c = said_disc::find_contacts(d)[0];
    c.lambda[2] = 1;
    said_disc::visit(c, d);
    return {{"along", -said_disc::drag(c)[0]}, {"aside", -said_disc::drag(c)[1]}};
}

Numbers three_masses(Numbers in)
{
    said23::String masses = said23::at_rest(Eigen::VectorXd{{0, 0, 1, 0, 0}}, in["h"]);
    double farthest = 1;
    for (int n = 0; n < 40; ++n) {
        said23::leapfrog(masses, in["h"]);
        farthest = std::max(farthest, masses.y.cwiseAbs().maxCoeff());
    }
    return {{"farthest", farthest}};
}

}  // namespace

TEST_CASE("what can be dragged in a sentence follows as the small programs compute it")
{
    struct Known {
        Numbers (*values)(Numbers);
        double tolerance;  // relative to the number, or to one
    };
    const std::map<std::string, Known> known{
        // the same operations, in another order: 1000 steps of a spring that explodes magnify their rounding
        {"spring", {spring, 1e-12}},
        {"stiff_spring", {stiff_spring, 1e-6}},
        {"corner", {corner, 1e-12}},
        {"column", {column, 1e-12}},
        {"cones", {cones, 1e-12}},
        {"visits", {visits, 1e-12}},
        // the row is solved to 1e-6 m/s, a sixtieth of a second long, in each of twenty steps, in millimetres: 3.3e-4
        {"link", {long_link, 1e-3}},
        {"two_discs", {two_discs, 0}},
        {"guess", {guess, 1e-12}},
        {"rod", {rod, 1e-12}},
        {"across", {across, 1e-5}},  // sweeps to 1e-6 m/s on 3 kg
        {"slope", {slope, 1e-9}},    // a thousand sweeps
        {"door", {door, 1e-5}},      // sweeps to 1e-6 rad/s
        {"two_rods", {two_rods, 1e-9}},
        {"hinge", {hinge, 1e-12}},
        {"triangles", {triangles, 1e-12}},
        {"squares", {squares, 1e-12}},
        {"hoop", {hoop, 1e-12}},
        {"oscillator", {oscillator, 1e-12}},
        {"three_masses", {three_masses, 1e-12}},
        {"line", {line, 0}},
        {"tower", {tower, 1e-12}},
        {"bead_ways", {bead_ways, 1e-9}},  // millimetres off a radius of a metre
        {"book", {book, 3e-4}}};           // whole steps of a thousandth of a second, which is 1.6e-4 turns
    std::ifstream table(std::string(RIGID_SOURCE_DIR) + "/tests/small/sentences.csv");
    REQUIRE(table);
    std::set<std::string> seen;
    for (std::string line; std::getline(table, line);) {
        const auto one = line.find(';'), two = line.find(';', one + 1);
        const std::string model = line.substr(0, one);
        const auto found = known.find(model);
        if (found == known.end()) continue;  // a formula of the text alone
        seen.insert(model);
        INFO(line);
        const Numbers in = numbers(line.substr(one + 1, two - one - 1)), page = numbers(line.substr(two + 1));
        Numbers own = found->second.values(in);
        for (const auto& [name, value] : page) {
            INFO(name << ": " << own[name]);
            REQUIRE(own.count(name) == 1);
            // not "near": what is no number must not pass
            CHECK(std::abs(own[name] - value) <= found->second.tolerance * std::max(1.0, std::abs(value)));
        }
    }
    CHECK(seen.size() == known.size());
}
