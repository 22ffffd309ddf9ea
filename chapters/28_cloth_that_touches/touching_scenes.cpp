// The functions of touching_scenes.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/28_cloth_that_touches/touching_scenes.hpp"

#include "chapters/25_world_in_space/mesh_scenes.hpp"
#include "common/elementary.hpp"

namespace rigid {

namespace touching_parts {

const Vec3 right(1, 0, 0), down(0, -1, 0), forwards(0, 0, 1);

}  // namespace touching_parts

using namespace touching_parts;

TouchingCloth sheet_on_ball(int squares, Real side, Real stiffness, Real friction,
                            Real spin)
{
    TouchingCloth cloth;
    ClothSolid ball;
    ball.radius = 0.5, ball.friction = friction;
    add_solid(cloth, ball, 0, {0, 0, 0});
    cloth.solids.u.segment<3>(3) << 0, spin, 0;
    add_sheet(cloth, {-side / 2, 0.52, -side / 2}, right, forwards,
              square_sheet(squares, side, stiffness, 0));
    cloth.thickness = 0.005;
    cloth.drag = 0.5;
    return cloth;
}

TouchingCloth tablecloth(int squares, Real stiffness, Real friction)
{
    TouchingCloth cloth;
    ClothSolid table, floor;
    table.shape = ClothSolid::Shape::box;
    table.half = {0.48, 0.38, 0.48}, table.radius = 0.02;
    floor.shape = ClothSolid::Shape::wall;
    table.friction = floor.friction = friction;
    add_solid(cloth, table, 0, {0, 0.4, 0});
    add_solid(cloth, floor, 0, {0, 0, 0});
    add_sheet(cloth, {-0.8, 0.9, -0.8}, right, forwards,
              square_sheet(squares, 1.6, stiffness, 1e-4));
    cloth.thickness = 0.005;
    cloth.drag = 0.5;
    return cloth;
}

TouchingCloth catching_sheet(int squares, Real stiffness, Real mass, bool box,
                             bool pinned)
{
    TouchingCloth cloth;
    SheetSpec spec = square_sheet(squares, 2, stiffness, 0);
    spec.shear = stiffness / 10;
    add_sheet(cloth, {-1, 0, -1}, right, forwards, spec);
    for (int j = 0; j <= squares && pinned; ++j)
        for (int i = 0; i <= squares; ++i)
            if (i == 0 || j == 0 || i == squares || j == squares)
                pin(cloth, i + (squares + 1) * j);
    ClothSolid solid;
    solid.friction = 0.4;
    solid.radius = box ? 0.02 : 0.25;
    if (box) solid.shape = ClothSolid::Shape::box, solid.half = {0.23, 0.15, 0.18};
    add_solid(cloth, solid, mass, {0.1, 0.8, 0.05},
              box ? Vec3(0.3, 0.2, 0.1) : Vec3(0, 0, 0));
    cloth.thickness = 0.01;
    return cloth;
}

TouchingCloth folding_sheet(int squares, Real stiffness, Real thickness,
                            Real friction)
{
    TouchingCloth cloth;
    ClothSolid floor;
    floor.shape = ClothSolid::Shape::wall, floor.friction = 0.5;
    add_solid(cloth, floor, 0, {0, 0, 0});
    add_sheet(cloth, {-0.5, 1.05, 0}, right, down,
              square_sheet(squares, 1, stiffness, 2e-5));
    // not quite flat, so that it knows where to fold
    for (int k = 0; k < cloth.count(); ++k) {
        const Vec3 p = cloth.bodies.position(k);
        cloth.bodies.position(k).z() +=
            0.01 * sin(7 * p.y()) + 0.01 * p.x() * p.y();
    }
    cloth.thickness = 0.005;
    cloth.self_thickness = thickness, cloth.self_friction = friction;
    cloth.drag = 0.5;
    return cloth;
}

TouchingCloth sheet_on_mesh(int squares, Real side, Real stiffness, Real friction)
{
    TouchingCloth cloth;
    ClothSolid ground;
    ground.shape = ClothSolid::Shape::mesh, ground.friction = friction;
    ground.mesh = height_field(24, 24, 0.1, [](Real x, Real z) {
        return 0.3 * sin(2.5 * x) * cos(2 * z);
    });
    add_solid(cloth, ground, 0, {0, 0, 0});
    add_sheet(cloth, {-side / 2, 0.4, -side / 2}, right, forwards,
              square_sheet(squares, side, stiffness, 1e-4));
    cloth.thickness = 0.005;
    cloth.drag = 0.5;
    return cloth;
}

TouchingCloth rope_bridge(int squares, Real stiffness, Real mass)
{
    TouchingCloth cloth;
    SheetSpec spec = square_sheet(squares, 4, stiffness, 0);
    spec.rows = std::max(1, 3 * squares / 20);
    spec.density = 4;
    add_sheet(cloth, {-2, 0, -0.3}, right, forwards, spec);
    for (int j = 0; j <= spec.rows; ++j) {
        pin(cloth, (squares + 1) * j);
        pin(cloth, (squares + 1) * j + squares);
    }
    // it sags: the pins stand closer than it is long
    for (int k = 0; k < cloth.count(); ++k) cloth.bodies.position(k).x() *= 0.95;
    ClothSolid box;
    box.shape = ClothSolid::Shape::box;
    box.half = {0.2, 0.15, 0.2}, box.radius = 0.02, box.friction = 0.6;
    add_solid(cloth, box, mass, {0.4, 0.6, 0}, {0, 0.4, 0});
    cloth.thickness = 0.02;
    cloth.drag = 0.2;
    return cloth;
}

TouchingCloth net_in_goal(int squares, Real stiffness, Real mass, Real speed,
                          Real border)
{
    TouchingCloth cloth;
    SheetSpec spec = square_sheet(squares, 3, stiffness, 0);
    spec.rows = std::max(1, 2 * squares / 3);
    spec.density = 0.2;
    add_sheet(cloth, {-1.5, 0, 0}, right, {0, 1, 0}, spec);
    cloth.triangles.clear();  // threads alone
    std::erase_if(cloth.springs, [&spec](const ClothSpring& s) {
        return s.length > 1.2 * spec.spacing;
    });
    for (int j = 0; j <= spec.rows; ++j)
        for (int i = 0; i <= squares; ++i) {
            const int k = i + (squares + 1) * j;
            const Real a = Real(2 * i) / squares - 1,
                       b = Real(2 * j) / spec.rows - 1;
            cloth.bodies.position(k).z() = -0.5 * (1 - a * a) * (1 - b * b);
            if (i > 0 && j > 0 && i < squares && j < spec.rows) continue;
            cloth.bodies.inverse_mass.segment<3>(3 * k).setConstant(
                border > 0 ? 1 / border : 0);
        }
    for (ClothSpring& s : cloth.springs)
        s.length = (cloth.bodies.position(s.b) - cloth.bodies.position(s.a)).norm();
    ClothSolid ball;
    ball.radius = 0.11, ball.friction = 0.4;
    add_solid(cloth, ball, mass, {0.4, 1.1, 1});
    cloth.solids.u[2] = -speed;
    cloth.thickness = 0.005;
    return cloth;
}

TouchingCloth rope_on_drum(int segments, Real stiffness, Real friction, Real pull)
{
    TouchingCloth cloth;
    cloth.gravity.setZero();
    ClothSolid drum;
    drum.shape = ClothSolid::Shape::capsule;
    drum.half = {0, 0.3, 0}, drum.radius = 0.5, drum.friction = friction;
    add_solid(cloth, drum, 0, {0, 0, 0}, {pi / 2, 0, 0});
    for (int i = 0; i <= segments; ++i) {
        const Real angle = pi * (1 - Real(i) / segments);
        add_particle(cloth, {0.5 * cos(angle), 0.5 * sin(angle), 0},
                     0.12 / segments);
    }
    const Real length = sin(pi / (2 * segments));  // of a chord
    for (int i = 0; i < segments; ++i)
        cloth.springs.push_back({i, i + 1, length, stiffness});
    cloth.bodies.f.head<3>() << 0, -pull, 0;
    const int winch = add_particle(cloth, {0.5, -0.2, 0}, 0);
    cloth.springs.push_back({segments, winch, 0.2, stiffness});
    cloth.bodies.velocity(winch) << 0, -0.05, 0;
    cloth.drag = 5;
    return cloth;
}

TouchingCloth flag_on_pole(int squares, Real stiffness, Real mass, Real wind,
                           bool free)
{
    TouchingCloth cloth;
    ClothSolid pole;
    pole.shape = ClothSolid::Shape::capsule;
    pole.half = {0, 0.58, 0}, pole.radius = 0.02;
    add_solid(cloth, pole, mass, {0, 0.6, 0});
    SheetSpec spec = square_sheet(squares, 0.9, stiffness, 1e-4);
    spec.rows = std::max(1, 2 * squares / 3);
    add_sheet(cloth, {0.03, 1.17, 0}, right, down, spec);
    for (int j = 0; j <= spec.rows; ++j) tie(cloth, (squares + 1) * j, 0);
    if (free) {
        cloth.gravity.setZero();
        cloth.solids.u << 0.2, 0, 0.1, 2, 1, 3;
        return cloth;
    }
    tie(cloth, add_particle(cloth, {0, 0, 0}, 0), 0);
    const int top = add_particle(cloth, {0, 1.2, 0}, 0.02);
    tie(cloth, top, 0);
    for (int i = 0; i < 3; ++i) {
        const Real angle = 2 * pi * i / 3 + 0.5;
        const Vec3 peg(0.9 * cos(angle), 0, 0.9 * sin(angle));
        cloth.springs.push_back({top, add_particle(cloth, peg, 0), 1.5, 300});
    }
    cloth.air = 0.7;
    cloth.wind = wind * Vec3(0.96, 0, 0.28);
    return cloth;
}

}  // namespace rigid
