// Chapter 28: cloth on solids and meshes, cloth on itself, cloth at rest.
#include "tests/no_allocation.hpp"

#include "chapters/25_world_in_space/mesh_scenes.hpp"
#include "chapters/28_cloth_that_touches/cloth_sleep.hpp"
#include "chapters/28_cloth_that_touches/touching_scenes.hpp"
#include "common/random.hpp"
#include "tests/cloths.hpp"
#include "tests/order.hpp"

#include <set>

using namespace rigid;

namespace {

std::vector<std::array<int, 2>> edges_of(const TouchingCloth& cloth)
{
    std::set<std::array<int, 2>> edges;
    for (const auto& t : cloth.triangles)
        for (std::size_t i = 0; i < 3; ++i)
            edges.insert({std::min(t[i], t[(i + 1) % 3]), std::max(t[i], t[(i + 1) % 3])});
    return {edges.begin(), edges.end()};
}

/// Chapter 27's cloth, which may touch something now.
TouchingCloth touching(const ClothScene& cloth)
{
    TouchingCloth out;
    static_cast<ClothScene&>(out) = cloth;
    return out;
}

/// How often an edge goes through a triangle that it has no corner of: both ends on different sides of its plane, and all
/// three volumes of one sign.
int crossings(const TouchingCloth& cloth)
{
    const auto at = [&](int p) -> Vec3 { return cloth.bodies.position(p); };
    const auto edges = edges_of(cloth);
    int count = 0;
    for (const auto& t : cloth.triangles) {
        const Vec3 a = at(t[0]), b = at(t[1]), c = at(t[2]), N = cross(b - a, c - a);
        for (const auto& e : edges) {
            if (std::find(t.begin(), t.end(), e[0]) != t.end() ||
                std::find(t.begin(), t.end(), e[1]) != t.end())
                continue;
            const Vec3 p = at(e[0]), q = at(e[1]), d = q - p;
            if (N.dot(p - a) * N.dot(q - a) >= 0) continue;
            const Real u = d.dot(cross(a - p, b - p)), v = d.dot(cross(b - p, c - p)),
                       w = d.dot(cross(c - p, a - p));
            count += (u > 0 && v > 0 && w > 0) || (u < 0 && v < 0 && w < 0);
        }
    }
    return count;
}

struct Fall {
    int crossings = 0;
    std::size_t rows = 0;
    std::int64_t stopped = 0, unsure = 0;
    bool lost = false;
};

/// A sheet that falls on its edge, for so many steps of 1/60 s.
Fall fall(Real thickness, ClothMethod method, int substeps, int steps, Real speed = 0)
{
    TouchingCloth cloth = folding_sheet(12, 500, thickness);
    for (int k = 0; k < cloth.count(); ++k) cloth.bodies.velocity(k) << 0, -speed, 0;
    Fall found;
    TouchingMemory memory;
    ClothSettings how;
    how.method = method, how.substeps = substeps, how.sweeps = 2;
    for (int n = 0; n < steps; ++n) {
        step(cloth, how, memory);
        found.crossings = std::max(found.crossings, crossings(cloth));
        found.rows = std::max(found.rows, memory.self.rows.size());
        found.lost = found.lost || !memory.solved;
    }
    found.stopped = memory.self.stopped, found.unsure = memory.self.unsure;
    return found;
}

/// A sheet and a smaller one above it that flies down and across, both free, nothing else.
TouchingCloth two_sheets(Real friction)
{
    TouchingCloth cloth;
    cloth.gravity.setZero();
    SheetSpec spec;
    spec.columns = spec.rows = 8, spec.spacing = 0.1, spec.stiffness = 500, spec.shear = 50;
    add_sheet(cloth, {-0.4, 0, -0.4}, {1, 0, 0}, {0, 0, 1}, spec);
    spec.columns = spec.rows = 5;
    const int first = add_sheet(cloth, {-0.2, 0.06, -0.3}, Vec3(1, 0.1, 0).normalized(), {0, 0, 1}, spec);
    for (int k = first; k < cloth.count(); ++k) cloth.bodies.velocity(k) << 0.4, -2, 0.3;
    cloth.self_thickness = 0.02, cloth.self_friction = friction;
    return cloth;
}

Vec3 angular(const TouchingCloth& cloth)
{
    Vec3 sum(0, 0, 0);
    for (Index k = 0; k < cloth.bodies.count(); ++k)
        sum += cross(cloth.bodies.position(k), cloth.bodies.velocity(k)) / cloth.bodies.inverse_mass[3 * k];
    return sum;
}

/// Gravity as it is seen by a floor that is a slope. \param direction  of its fall, from x towards z [rad]
Vec3 down_a_slope(Real slope, Real direction)
{
    return 9.81 * Vec3(rigid::sin(slope) * rigid::cos(direction), -rigid::cos(slope),
                       rigid::sin(slope) * rigid::sin(direction));
}

}  // namespace

TEST_CASE("a particle on a slope holds below the angle of friction and slides above it in every direction",
          "[idea]")
{
    const Real h = 0.01, g = 9.81;
    // the midpoint, too, whose contacts come after its solve: what they do must not halve what gravity does along them
    for (const ClothMethod method : {ClothMethod::xpbd, ClothMethod::explicit_euler, ClothMethod::newton,
                                     ClothMethod::midpoint, ClothMethod::exact})
        for (const Real mu : {0.5, 0.0})
            for (const Real slope : {0.4, 0.6})  // radians; atan 0.5 = 0.4636
                for (const Real direction : {0.0, 0.7, 2.0}) {
                    INFO(to_string(method) << ", friction " << mu);
                    TouchingCloth cloth;
                    ClothSolid wall;
                    wall.shape = ClothSolid::Shape::wall, wall.friction = mu;
                    add_solid(cloth, wall, 0, {0, 0, 0});
                    add_particle(cloth, {0, 0, 0}, 0.3);
                    cloth.gravity = down_a_slope(slope, direction);
                    TouchingMemory memory;
                    ClothSettings how;
                    how.h = h, how.method = method;
                    for (int n = 0; n < 50; ++n) step(cloth, how, memory);
                    const Real speed =
                        std::max(Real{0}, g * (rigid::sin(slope) - mu * rigid::cos(slope))) * 50 * h;
                    const Vec3 u = cloth.bodies.velocity(0);
                    CHECK(u.y() == Approx(0).margin(1e-14));
                    CHECK(u.x() == Approx(speed * rigid::cos(direction)).margin(1e-12));
                    CHECK(u.z() == Approx(speed * rigid::sin(direction)).margin(1e-12));
                }
}

TEST_CASE("points are as far from each shape as its surface is", "[idea]")
{
    using Shape = ClothSolid::Shape;
    const ClothSolid ball{Shape::ball, {0, 0, 0}, 0.5, 0}, capsule{Shape::capsule, {0, 1, 0}, 0.5, 0},
        box{Shape::box, {1, 2, 3}, 0.5, 0};
    const auto is = [](const ClothGap& found, Real gap, const Vec3& n) {
        CHECK(found.gap == Approx(gap).margin(1e-15));
        CHECK((found.normal - n).norm() < 1e-15);
    };
    is(gap_to(ball, {0, 0, 2}), 1.5, {0, 0, 1});
    is(gap_to(ball, {0.3, 0, 0}), -0.2, {1, 0, 0});
    is(gap_to(capsule, {0.4, 0.9, 0.3}), 0, {0.8, 0, 0.6});
    is(gap_to(capsule, {0, -2, 0}), 0.5, {0, -1, 0});
    is(gap_to(box, {2, 0, 0}), 0.5, {1, 0, 0});
    is(gap_to(box, {4, 2, 7}), 4.5, {0.6, 0, 0.8});
    is(gap_to(box, {0, -1.9, 0}), -0.6, {0, -1, 0});
}

/// A solid that flies and turns into a free sheet, without gravity.
static TouchingCloth thrown_into_a_sheet(int columns, bool box)
{
    TouchingCloth cloth = catching_sheet(columns, 500, 2, box, false);
    cloth.gravity.setZero();
    cloth.solids.u << 0.3, -4, 0.2, 1, 2, -1;
    return cloth;
}

TEST_CASE("a sheet and the solid that it catches keep their momentum", "[idea]")
{
    for (const bool box : {false, true})
        for (const ClothMethod method : {ClothMethod::xpbd, ClothMethod::threads, ClothMethod::midpoint}) {
            INFO(to_string(method));
            TouchingCloth cloth = thrown_into_a_sheet(12, box);
            const Vec3 before = momentum(cloth);
            TouchingMemory memory;
            ClothSettings how;
            how.method = method, how.substeps = 8, how.sweeps = 1;
            std::size_t touched = 0;
            for (int n = 0; n < 40; ++n) {
                step(cloth, how, memory);
                touched = std::max(touched, memory.touch.contacts.size());
            }
            CHECK(touched > 10);
            CHECK(cloth.solids.u[1] > -3.9);                                   // it has been braked
            CHECK((momentum(cloth) - before).norm() < 1e-12 * before.norm());  // rounding of 320 sub-steps
        }
}

TEST_CASE("a sheet with a limit and the solid that it catches keep their momentum in many sub-steps",
          "[idea]")
{
    for (const ClothMethod method : {ClothMethod::xpbd, ClothMethod::threads, ClothMethod::midpoint}) {
        INFO(to_string(method));
        TouchingCloth cloth = thrown_into_a_sheet(8, false);
        const Vec3 before = momentum(cloth);
        TouchingMemory memory;
        ClothSettings how;
        how.method = method, how.substeps = 8, how.sweeps = 4, how.strain_limit = 0.01;
        for (int n = 0; n < 20; ++n) step(cloth, how, memory);
        CHECK(memory.drawn > 1000);
        CHECK(cloth.solids.u[1] > -3.9);                                   // it has been braked
        CHECK((momentum(cloth) - before).norm() < 1e-12 * before.norm());  // rounding of 160 sub-steps
    }
}

TEST_CASE("a ball goes into a sheet and comes back by the midpoint as by explicit steps", "[idea]")
{
    const auto thrown = [](ClothMethod method, int substeps) {
        TouchingCloth cloth = catching_sheet(8, 500, 2, false, true);
        const Real before = energy(cloth);
        TouchingMemory memory;
        ClothSettings how;
        how.method = method, how.substeps = substeps;
        for (int n = 0; n < 40; ++n) step(cloth, how, memory);
        CHECK(memory.touch.contacts.size() > 2);
        CHECK(energy(cloth) < before);
        return std::array{cloth.solids.x[1], cloth.solids.u[1]};
    };
    const auto finest = thrown(ClothMethod::explicit_euler, 256),
               fine = thrown(ClothMethod::explicit_euler, 64), middle = thrown(ClothMethod::midpoint, 64);
    CAPTURE(finest, fine, middle);
    CHECK(finest[1] > 1);  // it is on its way up
    // both are of order one where contacts begin: as far as the larger explicit step, twice for its other sign
    CHECK(std::abs(middle[0] - finest[0]) < 2 * std::abs(fine[0] - finest[0]));
    CHECK(std::abs(middle[1] - finest[1]) < 0.01 * finest[1]);
}

TEST_CASE(
    "what strikes a cloth takes it along as two bodies that stick or slide by every way to solve a step",
    "[idea]")
{
    for (const ClothMethod method :
         {ClothMethod::xpbd, ClothMethod::explicit_euler, ClothMethod::newton, ClothMethod::midpoint})
        for (const Real mu : {0.0, 0.1, 0.5})
            for (const Real h : {1e-2, 1e-3}) {
                CAPTURE(to_string(method), mu, h);
                TouchingCloth cloth;
                cloth.gravity.setZero();
                for (const Vec3& at : {Vec3(-1, 0, -1), Vec3(-1, 0, 2), Vec3(2, 0, -1), Vec3(0, 0.0475, 0)})
                    add_particle(cloth, at, 1);
                cloth.triangles.push_back({0, 1, 2});
                cloth.bodies.velocity(3) << 0.3, -1, 0;
                cloth.self_thickness = 0.02, cloth.self_friction = mu;
                TouchingMemory memory;
                ClothSettings how;
                how.h = h, how.method = method;
                for (int n = 0; n < 0.1 / h - 0.5; ++n) step(cloth, how, memory);
                // 1 kg and, at the middle of three corners, 3 kg: the impulse that stops 1 m/s is 3/4 N s; across it is
                // mu times that, at most what stops 0.3 m/s
                const Real across = std::min(mu * 0.75, 0.3 * 0.75);
                // it strikes 8 mm beside the middle of a metre, and the triangle turns: squares of that
                CHECK((cloth.bodies.velocity(3) - Vec3(0.3 - across, -0.25, 0)).norm() < 2e-4);
                Vec3 mean(0, 0, 0);
                for (int k = 0; k < 3; ++k) mean += cloth.bodies.velocity(k) / 3;
                CHECK((mean - Vec3(across / 3, -0.25, 0)).norm() < 2e-4);
            }
}

TEST_CASE("a box that no impulse moves lifts the cloth on it and carries it along and around", "[idea]")
{
    TouchingCloth cloth;
    ClothSolid lift;
    lift.shape = ClothSolid::Shape::box;
    lift.half = {0.5, 0.1, 0.5}, lift.friction = 0.8;
    add_solid(cloth, lift, 0, {0, -0.1, 0});
    const Vec3 v(0.2, 0.5, 0), omega(0, 1, 0);
    cloth.solids.velocity(0) << v, omega;
    add_sheet(cloth, {-0.2, 0.006, -0.2}, {1, 0, 0}, {0, 0, 1}, square_sheet(8, 0.4, 1000, 0));
    cloth.thickness = 0.005;
    ClothSettings how;
    how.method = ClothMethod::threads, how.substeps = 16, how.sweeps = 4;
    TouchingMemory memory;
    for (int n = 0; n < 90; ++n) step(cloth, how, memory);
    const Vec3 centre = cloth.solids.position(0).head<3>();
    CHECK((centre - Vec3(0, -0.1, 0) - 1.5 * v).norm() < 1e-12);
    Real gap = 0, slip = 0;
    for (int k = 0; k < cloth.count(); ++k) {
        const Vec3 arm = cloth.bodies.position(k) - centre;
        gap = std::max(gap, std::abs(arm.y() - 0.1 - cloth.thickness));
        slip = std::max(slip, (cloth.bodies.velocity(k) - v - cross(omega, arm)).norm());
    }
    CAPTURE(gap, slip);
    CHECK(gap < 1e-12);
    CHECK(slip < 1.1 * 0.2 * sqrt(2.0) / 960);  // a velocity is that of a chord: ω² r h of a sub-step
}

TEST_CASE("a pinned sheet holds a ball of many times its weight", "[idea]")
{
    TouchingCloth cloth = catching_sheet(16, 2000, 5, false, true);
    TouchingMemory memory;
    ClothSettings how;
    how.method = ClothMethod::threads, how.substeps = 10, how.sweeps = 1;
    Real lowest = 1;
    for (int n = 0; n < 240; ++n) {
        step(cloth, how, memory);
        lowest = std::min(lowest, cloth.solids.x[1]);
    }
    CHECK(lowest > -0.7);  // and has not fallen through
    CHECK(lowest < 0.2);
    CHECK(std::abs(cloth.solids.x[0]) < 0.5);
}

TEST_CASE("a rope drawn over a drum has the ratio of its pulls by rows by threads and by explicit steps",
          "[idea]")
{
    struct How {
        ClothMethod method;
        int substeps, sweeps;
    };
    for (const How& one : {How{ClothMethod::xpbd, 4, 10},
                           {ClothMethod::threads, 4, 4},
                           {ClothMethod::explicit_euler, 10, 0}}) {
        TouchingCloth cloth = rope_on_drum(60, 2e4, 0.3, 10);
        TouchingMemory memory;
        ClothSettings how;
        how.h = 1.0 / 600, how.method = one.method, how.substeps = one.substeps, how.sweeps = one.sweeps;
        for (int n = 0; n < 500; ++n) step(cloth, how, memory);
        CAPTURE(to_string(one.method));
        // the rope still moves at the winch's 0.05 m/s through a drag of 5 1/s, and both ends leave the drum half a link
        // early: 1/120 of μπ = 0.9
        CHECK(tension(cloth, cloth.springs.size() - 1) / 10 == Approx(2.566332395208135).epsilon(0.01));
    }
}

TEST_CASE("a steady step of a cloth that touches asks for no memory by any method of one pass", "[house]")
{
    using M = ClothMethod;
    for (const M method :
         {M::explicit_euler, M::pbd, M::xpbd, M::threads, M::particles, M::projective, M::implicit_euler}) {
        TouchingCloth cloth = sheet_on_ball(16, 1.2, 100, 0.3, 1);
        cloth.air = 0.1, cloth.triangles.resize(10);
        TouchingMemory memory;
        ClothSettings how;
        how.method = method, how.sweeps = 2, how.h = 1.0 / 600;
        for (int n = 0; n < 150; ++n) step(cloth, how, memory);
        memory.touch.contacts.reserve(2 * memory.touch.contacts.size() + 100);
        int asked = 0;
        {
            const NoAllocation none;
            for (int n = 0; n < 5; ++n) step(cloth, how, memory);
            asked = NoAllocation::violations();
        }
        CAPTURE(to_string(method));
        CHECK(asked == 0);
    }
}

TEST_CASE("a flag and the pole that it is tied to keep their momentum and stay together", "[idea]")
{
    for (const ClothMethod method : {ClothMethod::xpbd, ClothMethod::threads}) {
        TouchingCloth cloth = flag_on_pole(6, 500, 0.5, 0, true);
        const Vec3 before = momentum(cloth);
        TouchingMemory memory;
        ClothSettings how;
        how.method = method, how.substeps = 8, how.sweeps = 4;
        Real apart = 0;
        for (int n = 0; n < 60; ++n) {
            step(cloth, how, memory);
            for (const ClothTie& t : cloth.ties)
                apart = std::max(
                    apart, (point_of_solid(cloth.solids.x, t.solid, t.at) - cloth.bodies.position(t.particle))
                               .norm());
        }
        CAPTURE(to_string(method), apart);
        CHECK((momentum(cloth) - before).norm() < 1e-12 * before.norm());  // rounding of 480 sub-steps
        // 0.6 m of arm turns by up to 3.7/480 in a sub-step, of which half the square is not in the row: 2e-5 m
        CHECK(apart < 2e-4);
        CHECK((cloth.solids.u.head<3>() - Vec3(0.2, 0, 0.1)).norm() > 0.1);  // the flag pulls at it
    }
}

TEST_CASE("a pole that is tied by its end swings as a rod does", "[idea]")
{
    const Real length = 1.2, kick = 0.05;
    for (const int substeps : {4, 8, 16}) {
        TouchingCloth cloth;
        add_solid(cloth, {ClothSolid::Shape::capsule, {0, 0.58, 0}, 0.02, 0}, 2, {0, -length / 2, 0});
        tie(cloth, add_particle(cloth, {0, 0, 0}, 0), 0);
        const Real about_pin = 1 / cloth.solids.inverse_mass[3] + 2 * length * length / 4;
        const Real omega = std::sqrt(2 * 9.81 * length / 2 / about_pin);
        cloth.solids.u << kick * length / 2, 0, 0, 0, 0, kick;
        TouchingMemory memory;
        ClothSettings how;
        how.substeps = substeps, how.sweeps = 2;
        for (int n = 0; n < 60; ++n) step(cloth, how, memory);
        // an angle of kick/omega = 0.8 degrees makes its period longer by a sixteenth of its square, 1.3e-5, of 3.5 rad
        CHECK(cloth.solids.x[5] == Approx(kick / omega * rigid::sin(omega)).margin(1e-4 * kick / omega));
    }
}

TEST_CASE("nearest points of a particle and a triangle and of two edges are those of a fine search",
          "[house]")
{
    Random random(4);
    for (int n = 0; n < 60; ++n) {
        std::array<Vec3, 4> x;
        for (Vec3& p : x)
            for (Index i = 0; i < 3; ++i) p[i] = random.uniform(-1, 1);
        if (n % 10 == 0) x[3] = x[2] + (x[1] - x[0]);  // edges side by side
        for (const bool edges : {false, true}) {
            const ClothNear near = nearest(x, edges);
            Real least = infinity;
            const int N = 60;
            for (int i = 0; i <= N; ++i)
                for (int j = 0; j <= N; ++j) {
                    const Real s = Real(i) / N, t = Real(j) / N;
                    if (!edges && s + t > 1 + 1e-12) continue;
                    const Vec3 d = edges ? Vec3(x[0] + s * (x[1] - x[0]) - x[2] - t * (x[3] - x[2]))
                                         : Vec3(x[0] - x[1] - s * (x[2] - x[1]) - t * (x[3] - x[1]));
                    least = std::min(least, d.norm());
                }
            CAPTURE(n, edges);
            CHECK(near.d.norm() <= least + 1e-12);
            CHECK(near.d.norm() > least - 0.06);  // half a step of each, of edges up to 3.5 long
            CHECK(near.w[0] + near.w[1] + near.w[2] + near.w[3] == Approx(0).margin(1e-14));
        }
    }
}

TEST_CASE("a sheet that falls on its edge folds and does not pass through itself", "[idea]")
{
    using M = ClothMethod;
    // without rows of its own it does: the test can fail
    CHECK(fall(0, M::threads, 8, 45).crossings > 20);
    for (const M method : {M::threads, M::xpbd, M::projective}) {
        const Fall found = fall(0.015, method, 8, 45);
        CAPTURE(to_string(method));
        CHECK(found.crossings == 0);
        CHECK(found.rows > 100);  // it lies on itself
        CHECK(found.unsure == 0);
    }
}

TEST_CASE("what would pass within one large step is stopped", "[idea]")
{
    // 10 m/s and 1/60 s: 17 cm a step, ten times the thickness, and rows of one sweep
    const Fall found = fall(0.015, ClothMethod::xpbd, 1, 40, 10);
    CHECK(found.crossings == 0);
    CHECK(found.stopped > 0);
    CHECK(found.unsure == 0);
    CHECK_FALSE(found.lost);
}

TEST_CASE(
    "a thick cloth that explodes ends its step at once with all where they were to each other and says so",
    "[house]")
{
    for (const Real speed : {1e3, 1e6, 1e100, 1e300}) {
        CAPTURE(speed);
        TouchingCloth cloth = folding_sheet(20, 500, 0.01);
        const TouchingCloth before = cloth;
        Random random(5);
        for (Index i = 0; i < cloth.bodies.u.size(); ++i) cloth.bodies.u[i] = random.uniform(-speed, speed);
        TouchingMemory memory;
        ClothSettings how;
        how.method = ClothMethod::explicit_euler;
        step(cloth, how, memory);
        CHECK_FALSE(memory.solved);
        CHECK(memory.self.lost);
        CHECK(memory.self.found == 2);  // for the rows and for the stop; nothing is tried again
        const Vec3 way = cloth.bodies.position(0) - before.bodies.position(0);
        for (int k = 0; k < cloth.count(); ++k) {
            const Vec3 off = cloth.bodies.position(k) - before.bodies.position(k) - way;
            CHECK(off.norm() <= 1e-14 * (way.norm() + 1));  // rounding of places
        }
        // the same cloth at rest is none of that
        cloth = before;
        step(cloth, how, memory);
        CHECK(memory.solved);
        CHECK_FALSE(memory.self.lost);
    }
    // what is no number stays so, and the next step refuses it
    TouchingCloth cloth = folding_sheet(20, 500, 0.01);
    cloth.bodies.f[4] = 1e308;
    TouchingMemory memory;
    step(cloth, {.method = ClothMethod::explicit_euler}, memory);
    CHECK_FALSE(memory.solved);
    CHECK(memory.self.tested == 0);
    CHECK(refusal([&] { step(cloth, {}, memory); }).find("must be a finite number") != std::string::npos);
}

TEST_CASE(
    "two sheets that hit each other keep their momentum and their angular momentum to the order of the step",
    "[idea]")
{
    for (const Real friction : {0.0, 0.5}) {
        std::vector<Real> off;
        for (const int substeps : {4, 8, 16, 32}) {
            TouchingCloth cloth = two_sheets(friction);
            TouchingMemory memory;
            ClothSettings how;
            how.method = ClothMethod::threads, how.substeps = substeps, how.sweeps = 2;
            const Vec3 before = momentum(cloth), turning = angular(cloth);
            std::size_t rows = 0;
            for (int n = 0; n < 12; ++n) {
                step(cloth, how, memory);
                rows = std::max(rows, memory.self.rows.size());
            }
            CAPTURE(friction, substeps);
            CHECK(rows > 10);
            CHECK(cloth.bodies.u.segment<3>(3 * 40)[1] < -0.1);                // the lower sheet was hit
            CHECK((momentum(cloth) - before).norm() < 1e-12 * before.norm());  // rounding of 384 sub-steps
            CHECK(memory.self.stopped == 0);
            off.push_back((angular(cloth) - turning).norm() / turning.norm());
        }
        CAPTURE(friction, off[0], off[1], off[2], off[3]);
        if (friction == 0) {
            // implicit Euler takes impulses where the particles will be: first order in h
            CHECK(off[3] < off[0] / 3);
            CHECK(off[3] < 0.02);
        } else {
            // both forces of a friction act as far from each other as the cloth is thick: a couple that no step makes
            // smaller, of 0.02 m in a sheet that is hit 0.3 m from its middle
            CHECK(off[3] < 0.02 / 0.3);
        }
    }
}

TEST_CASE("parts that are near and move apart are left alone", "[idea]")
{
    TouchingCloth cloth = two_sheets(0.5);
    const int first = 81;  // of the upper sheet
    for (int k = first; k < cloth.count(); ++k) {
        cloth.bodies.position(k).y() -= 0.039;
        cloth.bodies.velocity(k) << 0.4, 1, 0.3;
    }
    TouchingMemory memory;
    ClothSettings how;
    how.h = 1e-4, how.method = ClothMethod::threads, how.sweeps = 1;
    step(cloth, how, memory);
    CHECK(memory.self.rows.size() > 3);
    for (int k = first; k < cloth.count(); ++k)  // rounding of x near 1 m over h
        CHECK((cloth.bodies.velocity(k) - Vec3(0.4, 1, 0.3)).norm() < 1e-10);
}

TEST_CASE("points are as far from a mesh as from the solid that it is the surface of", "[idea]")
{
    // a box of triangles, one side each
    std::vector<Vec3> corners;
    for (int i = 0; i < 8; ++i)
        corners.push_back(Vec3(i & 1 ? 1 : -1, i & 2 ? 0.5 : -0.5, i & 4 ? 0.7 : -0.7));
    const auto mesh = triangle_mesh(corners, {{0, 4, 2},
                                              {4, 6, 2},
                                              {1, 3, 5},
                                              {5, 3, 7},
                                              {0, 1, 4},
                                              {4, 1, 5},
                                              {2, 6, 3},
                                              {6, 7, 3},
                                              {0, 2, 1},
                                              {1, 2, 3},
                                              {4, 5, 6},
                                              {5, 7, 6}});
    const ClothSolid box{ClothSolid::Shape::box, {1, 0.5, 0.7}, 0, 0};
    std::vector<int> stack, near;
    Random random(8);
    int outside = 0;
    for (int n = 0; n < 500; ++n) {
        const Real x = random.uniform(-1.5, 1.5), y = random.uniform(-1, 1), z = random.uniform(-1.2, 1.2);
        const Vec3 p(x, y, z);
        const ClothGap here = gap_to(*mesh, p, 3, stack, near), there = gap_to(box, p);
        CHECK(here.gap == Approx(there.gap).margin(1e-12));
        outside += there.gap > 0;
        if (there.gap > 1e-6) CHECK((here.normal - there.normal).norm() < 1e-9);
    }
    CHECK(outside > 100);
    CHECK(outside < 450);
    CHECK(gap_to(*mesh, Vec3(5, 0, 0), 1, stack, near).gap == infinity);
    // beyond its border a ground has no back: a point just below it beside the border is not inside
    const auto ground = flat_mesh(2, 2, 0.5);
    CHECK(gap_to(*ground, Vec3(0.1, -0.01, 0.1), 0.1, stack, near).gap == Approx(-0.01));
    CHECK(gap_to(*ground, Vec3(0.51, -0.01, 0.1), 0.1, stack, near).gap == infinity);
}

TEST_CASE("a sheet comes to rest on hills and none of it is below them", "[idea]")
{
    TouchingCloth cloth = sheet_on_mesh(20, 1.6, 1000, 0.4);
    TouchingMemory memory;
    ClothSettings how;
    how.method = ClothMethod::threads, how.substeps = 8, how.sweeps = 1;
    std::vector<int> stack, near;
    Real deepest = 1;
    for (int n = 0; n < 90; ++n) {
        step(cloth, how, memory);
        for (int k = 0; k < cloth.count(); ++k)
            deepest = std::min(deepest,
                               gap_to(*cloth.shapes[0].mesh, cloth.bodies.position(k), 0.1, stack, near).gap);
    }
    CHECK(memory.touch.contacts.size() > 200);
    // contacts are visited last: each particle is at its thickness, to rounding of a few triangles' normals
    CHECK(deepest > 0.9 * cloth.thickness);
    CHECK(cloth.bodies.u.cwiseAbs().maxCoeff() < 0.05);
}

TEST_CASE("a particle on an inclined mesh slides in every direction as the disc of friction says", "[idea]")
{
    const Real h = 0.01, mu = 0.5, g = 9.81, slope = 0.6;
    for (const Real direction : {0.0, 0.7, 2.0}) {
        TouchingCloth cloth;
        ClothSolid ground;
        ground.shape = ClothSolid::Shape::mesh, ground.friction = mu;
        ground.mesh = flat_mesh(8, 8, 0.5);
        add_solid(cloth, ground, 0, {0, 0, 0});
        add_particle(cloth, {0.03, 0, 0.05}, 0.3);
        cloth.gravity = down_a_slope(slope, direction);
        TouchingMemory memory;
        ClothSettings how;
        how.h = h;
        for (int n = 0; n < 50; ++n) step(cloth, how, memory);
        const Real speed = g * (rigid::sin(slope) - mu * rigid::cos(slope)) * 50 * h;
        const Vec3 u = cloth.bodies.velocity(0);
        CHECK(u.y() == Approx(0).margin(1e-12));
        CHECK(u.x() == Approx(speed * rigid::cos(direction)).margin(1e-11));
        CHECK(u.z() == Approx(speed * rigid::sin(direction)).margin(1e-11));
    }
}

TEST_CASE("a capsule that can move has the inertia of its closed form and is caught", "[idea]")
{
    ClothSolid capsule{ClothSolid::Shape::capsule, {0, 0.3, 0}, 0.2, 0.5};  // wider than a square
    TouchingCloth cloth = catching_sheet(12, 1000, 1, false, true);
    cloth.solids.resize(0), cloth.shapes.clear();
    add_solid(cloth, capsule, 2, {0, 0.5, 0}, {0.3, 0, 1.2});
    // a cylinder of 0.6 m and a ball of its two ends, by their volumes
    const Real r = 0.2, L = 0.6, cylinder = r * r * L, ball = 4 * r * r * r / 3, all = cylinder + ball;
    const Real axial = 2 / all * (cylinder * r * r / 2 + ball * 2 * r * r / 5);
    CHECK(1 / cloth.solids.inverse_mass[4] == Approx(axial).epsilon(1e-12));
    TouchingMemory memory;
    ClothSettings how;
    how.method = ClothMethod::threads, how.substeps = 8, how.sweeps = 1;
    for (int n = 0; n < 120; ++n) step(cloth, how, memory);
    CHECK(cloth.solids.x[1] > -0.7);
    CHECK(memory.touch.contacts.size() > 3);
}

TEST_CASE("ten thousand threads' limit is kept by the largest stretch", "[idea]")
{
    // a smaller sheet than that of the benchmark; its threads are as stiff against their weight
    TouchingCloth cloth = sheet_on_ball(40, 2, 1000, 0.3);
    TouchingMemory memory;
    ClothSettings how;
    how.method = ClothMethod::threads, how.substeps = 10, how.sweeps = 1;
    how.strain_limit = 0.01, how.limit_stiffness = 500;
    Real largest = 0;
    for (int n = 0; n < 90; ++n) {
        step(cloth, how, memory);
        if (n >= 60) largest = std::max(largest, largest_stretch(cloth, 500));
    }
    CHECK(largest < 0.0101);
    CHECK(memory.drawn > 0);
}

TEST_CASE("a sheet that rests sleeps and the other one has the same bits as without", "[idea]")
{
    TouchingCloth cloth = sheet_on_ball(10, 1.0, 500, 0.5);
    const int first = cloth.count();
    SheetSpec spec;
    spec.columns = spec.rows = 6, spec.spacing = 0.1, spec.bending = 1e-4, spec.stiffness = 300;
    add_sheet(cloth, {3, 0, 0}, {1, 0, 0}, {0, 0, 1}, spec);
    pin(cloth, first);
    cloth.bodies.velocity(first) << 0, 0, 0.3;  // its pin never rests
    TouchingCloth plain = cloth;
    SleepingCloth sleeping;
    TouchingMemory memory;
    ClothSettings how;
    how.method = ClothMethod::threads, how.substeps = 4, how.sweeps = 1;
    const auto both = [&](int steps) {
        for (int n = 0; n < steps; ++n) {
            sleeping.step(cloth, how);
            step(plain, how, memory);
        }
        return 3 * (cloth.count() - first);
    };
    const int rest = both(300);
    CHECK(sleeping.parts() == 2);
    CHECK(sleeping.asleep() == 1);
    CHECK(sleeping.asleep(0));
    CHECK(sleeping.skipped > 100 * first);
    // what moves has the same bits
    CHECK(cloth.bodies.x.tail(rest) == plain.bodies.x.tail(rest));
    CHECK(cloth.bodies.u.tail(rest) == plain.bodies.u.tail(rest));
    // what sleeps is where it would be, to a few times of what counts as still
    CHECK((cloth.bodies.x - plain.bodies.x).cwiseAbs().maxCoeff() < 3 * sleeping.still);
    const VecX slept = cloth.bodies.x.head(3 * first);
    both(20);
    CHECK(cloth.bodies.x.head(3 * first) == slept);  // it does not creep
}

TEST_CASE("a copy of a cloth that may sleep goes on to the same bits after the first is gone", "[idea]")
{
    TouchingCloth cloth = sheet_on_ball(8, 1.0, 500, 0.5);
    cloth.drag = 4, cloth.self_thickness = 0.01;
    ClothSettings how;
    how.method = ClothMethod::threads, how.substeps = 4, how.sweeps = 1;
    auto first = std::make_unique<SleepingCloth>();
    int n = 0;
    for (; n < 600 && first->asleep() == 0; ++n) {
        if (n % 40 != 20) {
            first->step(cloth, how);
            continue;
        }
        TouchingCloth other = cloth;
        SleepingCloth copy = *first;
        for (int k = 0; k < 20; ++k) first->step(cloth, how);
        n += 19;
        for (int k = 0; k < 20; ++k) copy.step(other, how);
        CHECK(other.bodies.x == cloth.bodies.x);
        CHECK(copy.asleep() == first->asleep());
        *first = copy;  // and over one that is in use
    }
    CHECK(first->asleep() == 1);
    SleepingCloth copy = *first;
    first.reset();
    cloth.bodies.velocity(0) << 0, 1, 0;
    copy.step(cloth, how);
    CHECK(copy.wakings == 1);
}

TEST_CASE("a cloth that sleeps wakes for wind for its pins for a hand and for what comes near", "[idea]")
{
    const auto asleep = [](SleepingCloth& sleeping) {
        TouchingCloth cloth = touching(hung_sheet(5, 300, 1e-3));
        cloth.drag = 5;
        ClothSolid ball;
        ball.radius = 0.2;
        add_solid(cloth, ball, 0, {0, -0.5, 2});
        ClothSettings how;
        how.method = ClothMethod::threads, how.substeps = 4, how.sweeps = 2;
        for (int n = 0; n < 600 && sleeping.asleep() == 0; ++n) sleeping.step(cloth, how);
        CHECK(sleeping.asleep() == 1);
        sleeping.step(cloth, how);
        CHECK(sleeping.asleep() == 1);
        return cloth;
    };
    ClothSettings how;
    how.method = ClothMethod::threads, how.substeps = 4, how.sweeps = 2;
    const auto wakes = [&](const std::function<void(TouchingCloth&)>& change, int within) {
        SleepingCloth sleeping;
        TouchingCloth cloth = asleep(sleeping);
        change(cloth);
        int n = 0;
        while (sleeping.wakings == 0 && n < 200) sleeping.step(cloth, how), ++n;
        CHECK(n <= within);
    };
    wakes([](TouchingCloth& c) { c.air = 0.7, c.wind = {0, 0, 3}; }, 1);
    wakes([](TouchingCloth& c) { c.gravity *= 2; }, 1);
    wakes([](TouchingCloth& c) { c.bodies.velocity(0) << 0.1, 0, 0; }, 1);
    wakes([](TouchingCloth& c) { c.bodies.velocity(20) << 0, 0, 1; }, 1);
    wakes([](TouchingCloth& c) { c.bodies.f[3 * 20] = 1; }, 1);
    wakes([](TouchingCloth& c) { c.shapes[0].friction = 0.7; }, 1);
    wakes([](TouchingCloth& c) { c.self_thickness = 0.01; }, 1);
    CHECK_FALSE(SleepingCloth().asleep(3));  // before its first step
    // a ball of 0.2 m from 2 m off at 2 m/s: before a second has passed, and not at once
    int n = 0;
    SleepingCloth sleeping;
    TouchingCloth cloth = asleep(sleeping);
    cloth.solids.u[2] = -2;
    while (sleeping.wakings == 0 && n < 200) sleeping.step(cloth, how), ++n;
    CHECK(n > 20);
    CHECK(n < 60);
    CHECK(cloth.solids.x[2] > 0.19);  // not yet there
}

TEST_CASE("a steady step with a limit and with sleep asks for no memory", "[house]")
{
    TouchingCloth cloth = sheet_on_ball(12, 1.2, 300, 0.3, 1);
    const int first = cloth.count();
    SheetSpec spec;
    spec.columns = spec.rows = 4;
    add_sheet(cloth, {3, 0, 0}, {1, 0, 0}, {0, -1, 0}, spec);
    for (int i = 0; i <= 4; ++i) pin(cloth, first + i);
    SleepingCloth sleeping;
    ClothSettings how;
    how.method = ClothMethod::threads, how.substeps = 4, how.sweeps = 1, how.strain_limit = 0.01;
    for (int n = 0; n < 150; ++n) sleeping.step(cloth, how);
    CHECK(sleeping.asleep() == 1);  // the sheet that hangs; the ball turns
    sleeping.memory.touch.contacts.reserve(2 * sleeping.memory.touch.contacts.size() + 100);
    sleeping.memory.limit.beyond.reserve(cloth.springs.size());
    int asked = 0;
    {
        const NoAllocation none;
        for (int n = 0; n < 5; ++n) sleeping.step(cloth, how);
        asked = NoAllocation::violations();
    }
    CHECK(asked == 0);
}

TEST_CASE("a thickness or a mesh or a sleep that makes no sense is refused with a sentence", "[house]")
{
    const auto says = [](const std::function<void(TouchingCloth&)>& spoil, const std::string& sentence) {
        TouchingCloth cloth = folding_sheet(4, 500, 0.01);
        spoil(cloth);
        TouchingMemory memory;
        CHECK(refusal([&] { step(cloth, {}, memory); }) == sentence);
    };
    says([](TouchingCloth& c) { c.self_thickness = 0.2; },
         "the thickness of the cloth against itself is 0.2 m, and the length of spring 0 0.25 m; it must be "
         "at most "
         "half of that");
    says([](TouchingCloth& c) { c.self_friction = -1; },
         "the friction of the cloth on itself is -1; it must be zero or positive and finite");
    says([](TouchingCloth& c) { c.shapes.push_back({}); }, "there are 2 shapes for 1 solids; each needs one");
    says([](TouchingCloth& c) { c.shapes[0].shape = ClothSolid::Shape::mesh; },
         "solid 0 is a mesh without triangles; it needs a mesh");
    TouchingCloth cloth = touching(hung_sheet(3, 100));
    ClothSolid mesh;
    mesh.shape = ClothSolid::Shape::mesh, mesh.mesh = flat_mesh(2, 2, 1);
    CHECK(refusal([&] {
              add_solid(cloth, mesh, 1, {0, 0, 0});
          }) == "the mass of a solid is 1 kg; a ball, a capsule or a box may have a positive one, and what "
                "cannot move "
                "zero");
    TouchingCloth pole = flag_on_pole(4, 500, 1, 0);
    SleepingCloth rests;
    CHECK(refusal([&] { rests.step(pole, {}); }) ==
          "a cloth that may sleep has 5 ties; it must have none: what they hold is not left out");
    CHECK(refusal([&] { tie(pole, pole.ties[1].particle, 0); }) ==
          "a tie is of particle 5, which tie 1 has; a particle has one");
    pole.ties[2].particle = 5;
    CHECK(refusal([&] { require_valid(pole); }) ==
          "tie 2 is of particle 5, which tie 1 has; a particle has one");
    pole.ties[1].solid = 3;
    TouchingMemory kept;
    CHECK(refusal([&] { step(pole, {}, kept); }) == "tie 1 is of particle 5 and solid 3; there are 20 and 1");
    SleepingCloth sleeping;
    sleeping.still = std::nan("");
    CHECK(refusal([&] { sleeping.step(cloth, {}); }) ==
          "the way of a cloth that counts as still is nan; it must be zero or positive and finite");
    sleeping.still = 0.002, sleeping.time = std::nan("");
    CHECK(refusal([&] { sleeping.step(cloth, {}); }) ==
          "the time after which a cloth sleeps is nan s; it must be zero or positive");
    sleeping.time = 0.5;
    ClothSettings how;
    how.strength = 0.1;
    CHECK(refusal([&] { sleeping.step(cloth, how); }) ==
          "the strength of a cloth that may sleep is 0.1; it must be infinite: what tears changes rows while "
          "parts are "
          "left out");
}
