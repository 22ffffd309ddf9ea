/// Chapter 25: what stands, what is mirrored, and a hundred thousand pairs of hulls.

#include "chapters/24_friction_is_a_disc/solid_scenes.hpp"
#include "chapters/25_world_in_space/space_method.hpp"

#include "tests/catch.hpp"

using namespace rigid;

namespace {

/// The farthest that a body has moved sideways and down [m].
Vec2 moved_from(const VecX& start, const SpaceScene& scene)
{
    Vec2 most(0, 0);
    for (Index k = 0; k < scene.bodies.count(); ++k) {
        const Vec3 way = scene.bodies.x.segment<3>(6 * k) - start.segment<3>(6 * k);
        most = most.cwiseMax(Vec2(std::hypot(way.x(), way.z()), -way.y()));
    }
    return most;
}

Vec2 stand(SpaceScene& scene, int substeps, int sweeps, int steps)
{
    const VecX start = scene.bodies.x;
    TouchingCones method;
    method.solver.sweeps = {sweeps, 1e-6};
    StepData<6> now;
    for (int i = 0; i < steps; ++i) step(scene, {.h = 1.0 / 60, .substeps = substeps}, method, now);
    return moved_from(start, scene);
}

/// A scene as a mirror shows it that lies in the plane of x and y.
SpaceScene mirrored(const SpaceScene& scene)
{
    SpaceScene other = scene;
    for (auto& shape : other.shapes)
        for (Hull& hull : shape) {
            for (Vec3& p : hull.vertices) p.z() = -p.z();
            for (std::vector<int>& face : hull.faces) std::reverse(face.begin(), face.end());
        }
    for (SolidWall& wall : other.walls) wall.normal.z() = -wall.normal.z();
    Vec<6> mirror;  // a turn about z stays
    mirror << 1, 1, -1, -1, -1, 1;
    for (Index k = 0; k < other.bodies.count(); ++k) {
        other.bodies.position(k) = mirror.cwiseProduct(scene.bodies.x.segment<6>(6 * k));
        other.bodies.velocity(k) = mirror.cwiseProduct(scene.bodies.u.segment<6>(6 * k));
    }
    return other;
}

Vec3 drawn(Random& random, Real size)
{
    const Real x = random.uniform(-size, size), y = random.uniform(-size, size),
               z = random.uniform(-size, size);
    return {x, y, z};
}

/// Hulls, plates and needles down to a thousandth of their length, boxes, rods and balls; all of any size.
std::vector<SolidForm> odd_forms(Random& random, int count)
{
    std::vector<SolidForm> forms;
    for (int i = 0; i < count; ++i) {
        const Real size = std::pow(10.0, random.uniform(-1, 1));
        Vec3 stretch(size, size, size);
        for (Index c = 0; c < 3; ++c)
            if (random.index(3) == 0) stretch[c] *= std::pow(10.0, random.uniform(-3, 0));
        if (i % 5 == 0) forms.push_back(form_of(solid_box(stretch)));
        else if (i % 5 == 1 && i % 2 == 0) forms.push_back(form_of(solid_ball(size)));
        else if (i % 5 == 1) forms.push_back(form_of(solid_capsule(size, size * random.uniform(0, 0.5))));
        else {
            std::vector<Vec3> cloud;
            const int points = 4 + static_cast<int>(random.index(9));
            for (int k = 0; k < points; ++k) {
                const Vec3 p = drawn(random, 1);
                cloud.push_back(stretch.cwiseProduct(p));
            }
            forms.push_back(form_of(solid_hull(cloud)));
        }
    }
    return forms;
}

}  // namespace

TEST_CASE("small steps let a stack of twenty boxes and one under a thousand times its mass stand", "[idea]")
{
    SpaceScene twenty = box_stack(20, 0.05, 0.5);
    const Vec2 of_twenty = stand(twenty, 16, 50, 600);
    INFO(of_twenty.transpose());
    // measured 2.2 mm and 0.33 mm, of 20 m: a top that leans by 1 cm is not about to fall
    CHECK(of_twenty.x() < 1e-2);
    CHECK(of_twenty.y() < 2e-3);
    SpaceScene heavy = box_stack(4, 0.05, 0.5);
    heavy.bodies.inverse_mass.tail<6>() /= 1000;
    const Vec2 of_heavy = stand(heavy, 64, 50, 300);
    INFO(of_heavy.transpose());
    // measured 0.12 mm and 0.12 mm; the slop is 1 mm
    CHECK(of_heavy.x() < 1e-3);
    CHECK(of_heavy.y() < 1e-3);
}

TEST_CASE("a scene of solids in a mirror moves as its mirror image", "[idea]")
{
    SpaceScene scene = mixed_heap(6, 0.4, 9), other = mirrored(scene);
    scene.length = other.length = 1;
    for (SpaceScene* one : {&scene, &other}) {
        TouchingCones method;
        method.solver.sweeps = {5000, 1e-12};
        StepData<6> now;
        for (int i = 0; i < 60; ++i) step(*one, {.h = 1.0 / 120}, method, now);
        CHECK(now.contacts.size() > 3);
    }
    const SpaceScene back = mirrored(other);
    for (Index k = 0; k < 6; ++k)
        // half a second of tumbling parts what differs by roundings
        CHECK((back.bodies.x.segment<3>(6 * k) - scene.bodies.x.segment<3>(6 * k)).norm() < 1e-6);
}

TEST_CASE("a ball that slides has gone as far as the reference has it to first order", "[idea]")
{
    // reference value G3: 10 m/s, μ = 0.2 rolls at 50/7 m/s from 1.45623998835008 s and 12.48205704300069 m on
    std::vector<Real> errors;
    for (const int steps : {125, 250, 500, 1000}) {
        SpaceScene scene = thrown_ball(10, 0.2);
        TouchingCones method;
        method.solver.sweeps = {20000, 1e-13};
        StepData<6> now;
        for (int i = 0; i < steps; ++i) step(scene, {.h = 2.0 / steps}, method, now);
        CHECK(scene.bodies.u[0] == Approx(50.0 / 7).epsilon(1e-10));
        const Real exact = 12.48205704300069 + 50.0 / 7 * (2 - 1.45623998835008);
        errors.push_back(std::abs(scene.bodies.x[0] - exact));
    }
    for (std::size_t i = 0; i + 1 < errors.size(); ++i)
        CHECK(std::log2(errors[i] / errors[i + 1]) == Approx(1).margin(0.15));
}

TEST_CASE("a hundred thousand pairs of odd hulls touch in numbers", "[house]")
{
    Random random(41);
    const std::vector<SolidForm> forms = odd_forms(random, 120);
    ClipRoom room;
    SolidTouch touch;
    PlacedSolid a, b;
    int touching = 0, wrong = 0;
    for (int n = 0; n < 100000; ++n) {
        const SolidForm &fa = forms[static_cast<std::size_t>(random.index(120))],
                        &fb = forms[static_cast<std::size_t>(random.index(120))];
        const Vec3 turn_a = drawn(random, 3), turn_b = n % 3 == 0 ? turn_a : drawn(random, 3),
                   far = drawn(random, n % 7 == 0 ? 1e4 : 1), way = drawn(random, 1);
        const Real near = std::pow(10.0, -random.uniform(0, 12));
        a.place(fa, far, rotation_matrix(turn_a));
        // one in four in the same place, one in four as far as they reach, and a little more or less
        const Real apart = n % 4 == 0   ? near
                           : n % 4 == 1 ? (fa.reach + fb.reach) * (1 + near)
                                        : (fa.reach + fb.reach) * random.uniform(0, 1);
        b.place(fb, far + apart * way.normalized(), rotation_matrix(turn_b));
        const Real margin = 0.02 * (fa.reach + fb.reach);
        collide(a, b, {margin, 0.01 * margin}, room, touch);
        if (touch.count == 0) continue;
        ++touching;
        bool fine = touch.count <= 4 && std::abs(touch.normal.norm() - 1) < 1e-9;
        for (int i = 0; i < touch.count && fine; ++i) {
            const TouchPoint& p = touch.points[static_cast<std::size_t>(i)];
            fine = p.on_a.allFinite() && p.on_b.allFinite() && p.gap < margin &&
                   p.gap > -2 * (fa.reach + fb.reach);
        }
        wrong += !fine;
    }
    CHECK(wrong == 0);
    INFO(touching);
    CHECK(touching > 30000);
}
