// Chapter 28: a ball in a net, forces on solids, and what users of other programs have reported about cloth.
#include "chapters/20_turning_in_space/inertia.hpp"
#include "chapters/28_cloth_that_touches/touching_scenes.hpp"
#include "chapters/28_cloth_that_touches/touching_step.hpp"
#include "common/random.hpp"
#include "tests/cloths.hpp"

using namespace rigid;

namespace {

ClothSettings swept(ClothMethod method, int substeps, int sweeps)
{
    ClothSettings how;
    how.method = method, how.substeps = substeps, how.sweeps = sweeps;
    return how;
}

constexpr std::array every{
    ClothMethod::explicit_euler, ClothMethod::pbd,       ClothMethod::xpbd,       ClothMethod::threads,
    ClothMethod::particles,      ClothMethod::augmented, ClothMethod::projective, ClothMethod::implicit_euler,
    ClothMethod::newton,         ClothMethod::midpoint,  ClothMethod::exact};

}  // namespace

TEST_CASE("a net in a goal catches the ball and gains no energy where the sub-steps are short enough",
          "[idea]")
{
    struct Shot {
        Real highest, farthest, back, stretch;
    };
    const auto shoot = [](Real speed, ClothMethod method, int substeps, int sweeps) {
        TouchingCloth cloth = net_in_goal(30, 2e4, 0.43, speed);
        cloth.gravity.setZero();
        TouchingMemory memory;
        const Real start = energy(cloth);
        Shot shot{0, 1, 0, 0};
        ClothSettings how = swept(method, 1, sweeps);
        how.h = 1.0 / 60 / substeps;
        for (int n = 0; n < 36 * substeps; ++n) {  // each sub-step is looked at
            step(cloth, how, memory);
            shot.highest = std::max(shot.highest, energy(cloth) / start);
            shot.farthest = std::min(shot.farthest, cloth.solids.x[2]);
            shot.stretch = std::max(shot.stretch, largest_stretch(cloth));
        }
        shot.back = cloth.solids.u[2];
        return shot;
    };
    for (const auto& [method, sweeps] : {std::pair{ClothMethod::threads, 4}, {ClothMethod::xpbd, 10}}) {
        const Shot slow = shoot(10, method, 40, sweeps), fast = shoot(20, method, 40, sweeps);
        CAPTURE(to_string(method), slow.highest, slow.farthest, slow.back, fast.highest, fast.farthest,
                fast.back);
        for (const Shot& shot : {slow, fast}) {
            CHECK(shot.highest < 1 + 1e-9);  // of the start: nothing gives it energy
            CHECK(shot.farthest < -0.45);    // it has met the net, whose bulge is half a metre
            CHECK(shot.farthest > -0.7);     // which has held it
            CHECK(shot.stretch < 0.25);
        }
        // and given back less than it took
        CHECK(slow.back > 0);
        CHECK(slow.back < 7);
        CHECK(fast.back > 0);
        CHECK(fast.back < 15);
    }
    // with too few the threads of the text store what nobody gave them, and let the ball through
    const Shot few = shoot(20, ClothMethod::threads, 10, 1);
    CHECK(few.highest > 30);
    CHECK(few.farthest < -2);
}

TEST_CASE("what a ball loses in a net its border gains", "[idea]")
{
    // a border of 100 kg a particle in place of pins: all momentum is still there, and the ball goes the same way
    TouchingCloth pinned = net_in_goal(30, 2e4, 0.43, 20), heavy = net_in_goal(30, 2e4, 0.43, 20, 100);
    pinned.gravity.setZero(), heavy.gravity.setZero();
    const Vec3 before = momentum(heavy);
    TouchingMemory of_pinned, of_heavy;
    const ClothSettings how = swept(ClothMethod::threads, 40, 4);
    for (int n = 0; n < 30; ++n) step(pinned, how, of_pinned), step(heavy, how, of_heavy);
    // places near 1 m are rounded to 1e-16, over a sub-step of 0.4 ms and times 100 kg: 2e-11 N s, of 100 particles in
    // 1200 sub-steps
    CHECK((momentum(heavy) - before).norm() < 1e-7);
    Vec3 border(0, 0, 0);
    for (int k = 0; k < heavy.count(); ++k)
        if (heavy.bodies.inverse_mass[3 * k] < 0.02)
            border += heavy.bodies.velocity(k) / heavy.bodies.inverse_mass[3 * k];
    CAPTURE(before.z(), border.z(), pinned.solids.u[2], heavy.solids.u[2]);
    CHECK(border.z() < 1.5 * before.z());  // the ball has turned round
    // those of its particles that bear most of 15 N s go off with some cm/s, for a third of a second
    CHECK((pinned.solids.x.head<3>() - heavy.solids.x.head<3>()).norm() < 0.03);
}

TEST_CASE("a force and a torque move a solid that a cloth may touch", "[idea]")
{
    TouchingCloth cloth;
    cloth.gravity.setZero();
    ClothSolid ball;
    ball.radius = 0.1;
    add_solid(cloth, ball, 2, {0, 0, 0});
    cloth.solids.f << 4, 0, -2, 0, 0.008, 0;
    TouchingMemory memory;
    for (int n = 0; n < 60; ++n) step(cloth, swept(ClothMethod::threads, 2, 1), memory);
    CHECK(cloth.solids.u[0] == Approx(2).epsilon(1e-12));
    CHECK(cloth.solids.u[2] == Approx(-1).epsilon(1e-12));
    CHECK(cloth.solids.u[4] == Approx(0.008 / (0.4 * 2 * 0.01)).epsilon(1e-12));  // 2/5 m r²
}

TEST_CASE("a copy of a cloth and of its memory goes on to the same bits by every method", "[idea]")
{
    for (const ClothMethod method : every) {
        INFO(to_string(method));
        TouchingCloth cloth = catching_sheet(6, 300, 1, true, true);
        cloth.self_thickness = 0.01, cloth.solids.u[1] = -4;
        const ClothSettings how = swept(method, 16, 2);
        auto memory = std::make_unique<TouchingMemory>();
        for (int n = 0; n < 15; ++n) step(cloth, how, *memory);
        CHECK_FALSE(memory->touch.contacts.empty());
        TouchingCloth branch = cloth;
        TouchingMemory copy = *memory;
        for (int n = 0; n < 5; ++n) step(cloth, how, *memory);
        memory.reset();  // nothing of the copy is the first one's
        for (int n = 0; n < 5; ++n) step(branch, how, copy);
        CHECK(cloth.bodies.x.allFinite());
        CHECK(branch.bodies.x == cloth.bodies.x);
        CHECK(branch.bodies.u == cloth.bodies.u);
        CHECK(branch.solids.x == cloth.solids.x);
    }
}

TEST_CASE("what falls freely does not deform by any method", "[idea]")
{
    // a level sheet in free fall, of light squares and stiff threads, exploded in another program: warp, issue 642
    for (const ClothMethod method : every) {
        if (method == ClothMethod::explicit_euler) continue;  // far beyond (27.3) rounding explodes
        ClothScene cloth = hung_sheet(12, 1e4, 0);
        for (int k = 0; k < cloth.count(); ++k)
            cloth.bodies.inverse_mass.segment<3>(3 * k).setConstant(1 / 1e-3);
        const VecX start = cloth.bodies.x;
        ClothMemory memory;
        const ClothSettings how = swept(method, 4, 10);
        for (int n = 0; n < 120; ++n) step(cloth, how, memory);
        Real off = 0;
        for (int k = 0; k < cloth.count(); ++k) {
            const Vec3 way = cloth.bodies.position(k) - start.segment<3>(3 * k);
            off = std::max(off, (way - (cloth.bodies.position(0) - start.segment<3>(0))).norm());
        }
        CAPTURE(to_string(method), off);
        CHECK(off < 1e-11);  // rounding of y near 20 m
        CHECK(cloth.bodies.position(0).y() < -19);
    }
}

TEST_CASE("a particle that no row holds falls beside the cloth and does not become no number", "[idea]")
{
    // vertices that no triangle has, of no mass, became NaN in another program: newton, issue 3451
    for (const ClothMethod method : every) {
        ClothScene cloth = hung_sheet(4, 100, 0);
        const int loose = add_particle(cloth, {2, 2, 0}, 0.1), held = add_particle(cloth, {3, 2, 0}, 0);
        ClothMemory memory;
        const ClothSettings how = swept(method, 4, 5);
        for (int n = 0; n < 30; ++n) step(cloth, how, memory);
        CAPTURE(to_string(method));
        CHECK(cloth.bodies.x.allFinite());
        CHECK(cloth.bodies.position(held) == Vec3(3, 2, 0));
        CHECK(cloth.bodies.velocity(loose).y() == Approx(-9.81 * 0.5).epsilon(1e-9));
    }
}

TEST_CASE("triangles that are there twice change neither folds nor contacts with itself", "[idea]")
{
    // a mesh with a back made edges of no length in another program: JoltPhysics, issue 1623
    TouchingCloth once = folding_sheet(8, 500, 0.02), twice = once;
    for (const auto& t : once.triangles) twice.triangles.push_back({t[0], t[2], t[1]});
    TouchingMemory of_once, of_twice;
    for (int n = 0; n < 60; ++n) {
        step(once, swept(ClothMethod::threads, 8, 2), of_once);
        step(twice, swept(ClothMethod::threads, 8, 2), of_twice);
    }
    CHECK(twice.bodies.x.allFinite());
    CHECK(largest_stretch(twice) < 2 * largest_stretch(once) + 0.01);
    CHECK(of_twice.self.unsure == 0);
}

TEST_CASE("a tight cloth around a ball comes to rest", "[idea]")
{
    // a tight cloth on spheres vibrated for ever in another program: PositionBasedDynamics, issue 56
    // threads of 35 N between particles of 0.8 g at 1/16 m: by (27.30) beyond 1/3 in 8 sub-steps, and within in 32
    for (const auto& [method, substeps] :
         {std::pair{ClothMethod::xpbd, 8}, {ClothMethod::threads, 32}, {ClothMethod::threads, 8}}) {
        TouchingCloth cloth;
        ClothSolid ball;
        ball.radius = 0.3, ball.friction = 0.2;
        add_solid(cloth, ball, 0, {0, -0.2, 0});
        SheetSpec spec = square_sheet(16, 1, 5000, 0);
        add_sheet(cloth, {-0.5, 0.1, -0.5}, {1, 0, 0}, {0, 0, 1}, spec);
        for (int i = 0; i <= 16; ++i)
            for (int j = 0; j <= 16; ++j)
                if (i == 0 || j == 0 || i == 16 || j == 16) {
                    pin(cloth, i + 17 * j);
                    cloth.bodies.velocity(i + 17 * j) << 0, -0.2, 0;  // drawn tight for a second
                }
        cloth.thickness = 0.005;
        TouchingMemory memory;
        Real at_rest = 0;
        for (int n = 0; n < 240; ++n) {
            if (n == 60)
                for (int k = 0; k < cloth.count(); ++k)
                    if (!(cloth.bodies.inverse_mass[3 * k] > 0)) cloth.bodies.velocity(k).setZero();
            step(cloth, swept(method, substeps, 2), memory);
            if (n >= 180) at_rest = std::max(at_rest, cloth.bodies.u.cwiseAbs().maxCoeff());
        }
        CAPTURE(to_string(method), substeps, at_rest, memory.touch.contacts.size(), largest_stretch(cloth));
        CHECK(memory.touch.contacts.size() > 20);
        if (method == ClothMethod::threads && substeps == 8) CHECK(at_rest > 0.5);
        else CHECK(at_rest < 1e-3);
    }
}

TEST_CASE("a cloth and what it touches move the same when all is turned and shifted", "[idea]")
{
    const Mat3 R = rotation_matrix(Vec3(0.5, 0.9, -0.4));
    const Vec3 way(3, -2, 5);
    for (const ClothMethod method : {ClothMethod::xpbd, ClothMethod::threads}) {
        TouchingCloth a = catching_sheet(8, 500, 1, true, true), b = a;
        b.gravity = R * b.gravity;
        for (Index k = 0; k < b.bodies.count(); ++k) {
            b.bodies.position(k) = Vec3(R * b.bodies.position(k) + way);
            b.bodies.velocity(k) = Vec3(R * b.bodies.velocity(k));
        }
        const Mat3 axes = R * rotation_of(a.solids.x, 0);
        b.solids.x.head<3>() = R * a.solids.x.head<3>() + way;
        b.solids.x.tail<3>() = rotation_vector(axes);
        b.solids.u.head<3>() = R * a.solids.u.head<3>();  // the spin is in its own axes
        TouchingMemory of_a, of_b;
        for (int n = 0; n < 40; ++n) {
            step(a, swept(method, 4, 2), of_a);
            step(b, swept(method, 4, 2), of_b);
        }
        CHECK(of_a.touch.contacts.size() > 3);
        Real off = (R * a.solids.x.head<3>() + way - b.solids.x.head<3>()).norm();
        for (Index k = 0; k < b.bodies.count(); ++k)
            off = std::max(off, (R * a.bodies.position(k) + way - b.bodies.position(k)).norm());
        CAPTURE(to_string(method), off);
        CHECK(off < 1e-9);  // rounding, made larger by 160 sub-steps of contacts
    }
}

TEST_CASE("bad numbers between two steps are refused and nothing moves", "[house]")
{
    const auto says = [](const std::function<void(TouchingCloth&)>& spoil, const std::string& sentence) {
        TouchingCloth cloth = catching_sheet(4, 500, 1, false, true);
        TouchingMemory memory;
        for (int n = 0; n < 3; ++n) step(cloth, swept(ClothMethod::threads, 2, 1), memory);
        spoil(cloth);
        const TouchingCloth before = cloth;
        CHECK(refusal([&] { step(cloth, swept(ClothMethod::threads, 2, 1), memory); }) == sentence);
        if (before.bodies.x.allFinite()) CHECK(cloth.bodies.x == before.bodies.x);
        if (before.bodies.u.allFinite()) CHECK(cloth.bodies.u == before.bodies.u);
        if (before.solids.u.allFinite()) CHECK(cloth.solids.u == before.solids.u);
    };
    const Real no_number = std::nan("");
    says([=](TouchingCloth& c) { c.bodies.u[7] = no_number; }, "u[7] is nan; it must be a finite number");
    says([=](TouchingCloth& c) { c.bodies.f[0] = infinity; }, "f[0] is inf; it must be a finite number");
    says([=](TouchingCloth& c) { c.solids.u[1] = no_number; }, "u[1] is nan; it must be a finite number");
    says([=](TouchingCloth& c) { c.solids.f[5] = no_number; }, "f[5] is nan; it must be a finite number");
    says([=](TouchingCloth& c) { c.gravity[1] = no_number; }, "gravity or wind is not finite");
    says([=](TouchingCloth& c) { c.drag = -1; }, "the drag is -1; it must be zero or positive and finite");
    says([=](TouchingCloth& c) { c.springs[3].stiffness = -5, ++c.changes; },
         "the stiffness of spring 3 is -5 N/m; it must be positive");
    says([=](TouchingCloth& c) { c.springs[3].length = 0, ++c.changes; },
         "the length of spring 3 is 0 m; it must be positive and finite");
    says([=](TouchingCloth& c) { c.bodies.inverse_mass.segment<3>(18).setConstant(infinity), ++c.changes; },
         "particle 6 has no mass; it must have a positive one, or 1/m = 0, which pins it");
    says([=](TouchingCloth& c) { c.bodies.inverse_mass[19] = 0, ++c.changes; },
         "particle 6 has the inverse masses 20, 0 and 20 1/kg; the three must be the same");
    says([=](TouchingCloth& c) { c.solids.resize(2); }, "there are 1 shapes for 2 solids; each needs one");
    says([=](TouchingCloth& c) { c.shapes[0].friction = -1; },
         "the friction of solid 0 is -1; it must be zero or positive and finite");
    says([=](TouchingCloth& c) { c.shapes[0].shape = ClothSolid::Shape::mesh; },
         "solid 0 is a mesh without triangles; it needs a mesh");
    says(
        [=](TouchingCloth& c) {
            c.ties.push_back({0, 0}), c.ties[0].at[2] = no_number;
        },
        "the place of tie 0 is not finite");
    says([=](TouchingCloth& c) { c.thickness = no_number; },
         "the thickness of the cloth is nan; it must be zero or positive and finite");
}

TEST_CASE("a solid that makes no sense is refused and leaves the cloth as it was", "[house]")
{
    using Shape = ClothSolid::Shape;
    TouchingCloth cloth = catching_sheet(2, 500, 1, false, true);
    const auto says = [&](const ClothSolid& shape, Real mass, const std::string& sentence) {
        CHECK(refusal([&] { add_solid(cloth, shape, mass, {0, 0, 0}); }) == sentence);
        CHECK(cloth.solids.count() == 1);
        CHECK(cloth.shapes.size() == 1);
    };
    says({Shape::wall}, 1,
         "the mass of a solid is 1 kg; a ball, a capsule or a box may have a positive one, and what cannot "
         "move zero");
    says({Shape::ball, {0, 0, 0}, 0.1}, infinity,
         "the mass of a solid is inf; it must be zero or positive and finite");
    says({Shape::ball, {0, 0, 0}, 0}, 1,
         "the volume of the body in m³ is 0; it must be positive: a radius, or faces counterclockwise from "
         "outside");
    CHECK(refusal([&] { tie(cloth, 99, 0); }) == "a tie is of particle 99 and solid 0; there are 9 and 1");
    const auto of = [](const ClothSolid& shape, const std::function<void(TouchingCloth&)>& spoil) {
        TouchingCloth one;
        add_solid(one, shape, 0, {0, 0, 0});
        spoil(one);
        return refusal([&] { require_valid(one); });
    };
    const auto nothing = [](TouchingCloth&) {};
    CHECK(of({Shape::box, {1, 1, std::nan("")}, 0}, nothing) ==
          "half the size of solid 0 is nan; it must be zero or positive and finite");
    CHECK(of({Shape::ball, {0, 1, 0}, 0.5}, nothing) ==
          "solid 0 has half a size of 1 m along y; that of a ball is zero, and of a capsule but along y");
    CHECK(of({Shape::capsule, {0, 1, 2}, 0.5}, nothing) ==
          "solid 0 has half a size of 2 m along z; that of a ball is zero, and of a capsule but along y");
    CHECK(of({Shape::capsule, {0, 1, 0}, 0.5}, [](TouchingCloth& c) { c.solids.inverse_mass[4] = 2; }) ==
          "solid 0 has the inverse masses 0, 0 and 0 1/kg; the three must be the same, and not zero if it "
          "turns");
}

TEST_CASE("a grid of points that an unstable step has thrown beyond all numbers ends and has them all",
          "[house]")
{
    for (const Real lost : {infinity, -infinity, std::nan("")}) {
        PointGrid grid;
        grid.fill({{0, 0, 0}, {1, 2, 3}, {lost, 0, 0}, {0, 1, lost}}, 0.1);
        int seen = 0;
        grid.near({-1, -1, -1}, {4, 4, 4}, [&](int) { ++seen; });
        CHECK(seen == 4);
    }
}
