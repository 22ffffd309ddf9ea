// The functions of cloth_scenes.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/27_particles_and_cloth/cloth_scenes.hpp"

#include "common/elementary.hpp"

namespace rigid {

namespace cloth_parts {

const Vec3 right(1, 0, 0), down(0, -1, 0), forwards(0, 0, 1);

void set_speed(ClothScene& cloth, int particle, const Vec3& u)
{
    cloth.bodies.velocity(particle) = u;
}

}  // namespace cloth_parts

using namespace cloth_parts;

ClothScene hung_masses(int masses, Real stiffness)
{
    ClothScene cloth;
    cloth.gravity = {0, -10, 0};
    add_particle(cloth, {0, 0, 0}, 0);
    for (int i = 1; i <= masses; ++i) {
        add_particle(cloth, {0, static_cast<Real>(-i), 0}, 1);
        cloth.springs.push_back({i - 1, i, 1, stiffness});
    }
    return cloth;
}

ClothScene hung_sheet(int squares, Real stiffness, Real bending)
{
    ClothScene cloth;
    add_sheet(cloth, {-0.5, 0, 0}, right, forwards,
              square_sheet(squares, 1, stiffness, bending));
    pin(cloth, 0), pin(cloth, squares);
    return cloth;
}

ClothScene hung_net(int squares)
{
    ClothScene cloth;
    add_sheet(cloth, {-0.5, 0, 0}, right, forwards,
              square_sheet(squares, 1, infinity, 0));
    std::erase_if(cloth.springs, [squares](const ClothSpring& s) {
        return s.length > 1.2 / squares;
    });
    cloth.triangles.clear();
    const Real l = Real(1) / squares, step = 2 * pi / 3 / squares,
               radius = l / (2 * sin(step / 2));  // its chords keep their length
    for (int k = 0; k < cloth.count(); ++k) {
        const int i = k % (squares + 1);
        const Real angle = step * i - pi / 3;
        cloth.bodies.position(k) =
            Vec3(radius * sin(angle), radius * (cos(pi / 3) - cos(angle)),
                 l * (k / (squares + 1)));
    }
    pin(cloth, 0), pin(cloth, squares);
    return cloth;
}

ClothScene clamped_strip(int segments)
{
    ClothScene cloth;
    cloth.gravity.setZero();
    RopeSpec rope;
    rope.segments = segments;
    rope.stiffness = 1e6, rope.bending = 1;
    add_rope(cloth, {0, 0, 0}, {1, 0, 0}, rope);
    pin(cloth, 0);
    const Real l = Real(1) / segments;
    const int wall = add_particle(cloth, {-l, 0, 0}, 0);
    cloth.bends.push_back({{wall, 0, 1, -1}, {1 / l, -2 / l, 1 / l, 0}, 2 / l});
    return cloth;
}

ClothScene clamped_strip_across(int segments, Real stiffness)
{
    ClothScene cloth = clamped_strip(segments);
    // half an angle beside half a segment: (1/2)⁴ of the energy
    for (const ClothBend& b : cloth.bends)
        cloth.springs.push_back({b.p[0], b.p[2], Real(2) / segments,
                                 b.p[1] == 0 ? 8 * stiffness : stiffness});
    cloth.bends.clear();
    return cloth;
}

ClothScene clamped_strip(int segments, int rows, Bending how, bool alternate,
                         Real diagonals)
{
    ClothScene cloth;
    cloth.gravity.setZero();
    const Real l = Real(1) / segments;
    SheetSpec spec;
    spec.columns = segments + 1, spec.rows = rows;
    spec.spacing = l, spec.density = 1 / (rows * l);
    spec.stiffness = spec.shear = 1e6 * segments;
    spec.bending = 1 / (rows * l);
    spec.how = how, spec.alternate = alternate;
    add_sheet(cloth, {-l, 0, 0}, right, forwards, spec);
    for (int j = 0; j <= rows; ++j)
        for (const int i : {0, 1}) pin(cloth, i + (segments + 2) * j);
    const auto at_wall = [&](int p) {
        return std::abs(cloth.bodies.position(p).x()) < l / 4;
    };
    const auto set_hinge = [&](Real& stiffness, const std::array<int, 4>& p) {
        const Vec3 edge = cloth.bodies.position(p[1]) - cloth.bodies.position(p[0]);
        if (edge.norm() > 1.2 * l) stiffness *= diagonals;
        if (at_wall(p[0]) && at_wall(p[1])) stiffness *= 2;
    };
    for (ClothBend& b : cloth.bends)
        if (how == Bending::edges) set_hinge(b.stiffness, b.p);
        else if (b.count() == 3 && at_wall(b.p[1])) b.stiffness *= 2;
    for (ClothHinge& b : cloth.hinges) set_hinge(b.stiffness, b.p);
    return cloth;
}

ClothScene flag(int squares, Real stiffness, Real wind)
{
    ClothScene cloth;
    SheetSpec spec = square_sheet(squares, 1.2, stiffness, 1e-4);
    spec.rows = std::max(1, 2 * squares / 3);
    add_sheet(cloth, {0, 0, 0}, right, down, spec);
    for (int j = 0; j <= spec.rows; ++j) pin(cloth, (squares + 1) * j);
    cloth.air = 0.7;
    cloth.wind = wind * Vec3(0.96, 0, 0.28);
    return cloth;
}

ClothScene curtain(int squares, Real stiffness)
{
    ClothScene cloth;
    SheetSpec spec = square_sheet(squares, 1, stiffness, 1e-4);
    spec.rows = 7 * squares / 5;
    add_sheet(cloth, {-0.5, 0, 0}, right, down, spec);
    for (int i = 0; i <= squares; i += 2) pin(cloth, i);
    // not quite flat, so that it knows where to fold
    for (int k = 0; k < cloth.count(); ++k)
        cloth.bodies.position(k).z() +=
            0.002 * sin(20 * cloth.bodies.position(k).x());
    cloth.drag = 0.5;
    return cloth;
}

ClothScene banner(int squares, Real stiffness)
{
    ClothScene cloth;
    SheetSpec spec = square_sheet(squares, 1, stiffness, 1e-4);
    spec.rows = 8 * squares / 5;
    add_sheet(cloth, {-0.5, 0, 0}, right, down, spec);
    pin(cloth, 0), pin(cloth, squares);
    for (int i = 0; i <= squares; ++i)
        cloth.bodies.inverse_mass.segment<3>(3 * (i + (squares + 1) * spec.rows)) /=
            10;
    cloth.air = 0.7;
    cloth.wind = {0, 0, 2};
    return cloth;
}

ClothScene torn_sheet(int squares, Real stiffness, Real speed)
{
    ClothScene cloth;
    SheetSpec spec = square_sheet(squares, 1, stiffness, 1e-4);
    spec.shear = stiffness / 2;
    add_sheet(cloth, {-0.5, 0, 0}, right, down, spec);
    for (int j = 0; j <= squares; ++j) {
        const int left = (squares + 1) * j, last = left + squares;
        pin(cloth, left), pin(cloth, last);
        set_speed(cloth, last, speed * right);
        // a notch in the middle of its lower edge, where the tear begins
        if (j < squares - squares / 8) continue;
        std::erase_if(cloth.springs, [&](const ClothSpring& s) {
            const int middle = left + squares / 2;
            return (s.a == middle && s.b == middle + 1);
        });
    }
    return cloth;
}

Real tension(const ClothScene& cloth, std::size_t spring)
{
    const ClothSpring& s = cloth.springs[spring];
    return s.stiffness *
           ((cloth.bodies.position(s.b) - cloth.bodies.position(s.a)).norm() -
            s.length);
}

}  // namespace rigid
