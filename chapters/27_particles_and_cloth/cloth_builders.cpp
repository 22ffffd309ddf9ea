// The functions of cloth_builders.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/27_particles_and_cloth/cloth_builders.hpp"

namespace rigid {

int add_particle(ClothScene& cloth, const Vec3& at, Real mass)
{
    if (!(mass >= 0) || !std::isfinite(mass))
        throw std::invalid_argument(
            "the mass of a particle is " + shortest(mass) +
            " kg; it must be zero (pinned) or positive and finite");
    const Index k = cloth.bodies.count();
    cloth.bodies.resize(k + 1);
    cloth.bodies.position(k) = at;
    if (cloth.made_at.size() == static_cast<std::size_t>(k))
        cloth.made_at.push_back(at);
    cloth.bodies.inverse_mass.segment<3>(3 * k).setConstant(mass > 0 ? 1 / mass
                                                                     : 0);
    return static_cast<int>(k);
}

int add_rope(ClothScene& cloth, const Vec3& from, const Vec3& to,
             const RopeSpec& spec)
{
    const int n = spec.segments;
    if (n < 1)
        throw std::invalid_argument("a rope has " + std::to_string(n) +
                                    " segments; it must have one or more");
    if (!(spec.mass > 0))
        throw std::invalid_argument("the mass of a rope is " + shortest(spec.mass) +
                                    " kg; it must be positive");
    const int first = cloth.count();
    const Real length = (to - from).norm() / n;
    for (int i = 0; i <= n; ++i)
        add_particle(cloth, from + (to - from) * (Real(i) / n),
                     spec.mass / n / (i == 0 || i == n ? 2 : 1));
    for (int i = 0; i < n; ++i)
        cloth.springs.push_back(
            {first + i, first + i + 1, length, spec.stiffness / length});
    for (int i = 1; i < n && spec.bending > 0; ++i)
        cloth.bends.push_back({{first + i - 1, first + i, first + i + 1, -1},
                               {1 / length, -2 / length, 1 / length, 0},
                               spec.bending / length});
    return first;
}

SheetSpec square_sheet(int squares, Real side, Real stiffness, Real bending)
{
    SheetSpec spec;
    spec.columns = spec.rows = squares;
    spec.spacing = side / std::max(squares, 1);
    spec.stiffness = stiffness, spec.shear = stiffness / 100;
    spec.bending = bending;
    return spec;
}

int add_sheet(ClothScene& cloth, const Vec3& corner, const Vec3& first,
              const Vec3& second, const SheetSpec& spec)
{
    const int C = spec.columns, R = spec.rows, from = cloth.count();
    if (C < 1 || R < 1)
        throw std::invalid_argument("a sheet has " + std::to_string(C) + " by " +
                                    std::to_string(R) +
                                    " squares; it must have one or more");
    if (!(spec.spacing > 0) || !(spec.density > 0))
        throw std::invalid_argument(
            "a sheet has squares of " + shortest(spec.spacing) + " m and " +
            shortest(spec.density) + " kg/m²; both must be positive");
    const auto at = [&](int i, int j) { return from + i + (C + 1) * j; };
    const Real cell = spec.density * spec.spacing * spec.spacing;
    for (int j = 0; j <= R; ++j)
        for (int i = 0; i <= C; ++i)
            add_particle(
                cloth, corner + spec.spacing * (i * first + j * second),
                cell / ((i == 0 || i == C ? 2 : 1) * (j == 0 || j == R ? 2 : 1)));
    const Real diagonal = std::sqrt(Real(2)) * spec.spacing;
    const auto spring = [&](int a, int b, Real length) {
        cloth.springs.push_back(
            {a, b, length, length == diagonal ? spec.shear : spec.stiffness});
    };
    // no two springs that follow each other share a particle: a sweep need not wait
    for (const int odd : {0, 1})
        for (int j = 0; j <= R; ++j)
            for (int i = odd; i < C; i += 2)
                spring(at(i, j), at(i + 1, j), spec.spacing);
    for (int j = 0; j < R; ++j)
        for (int i = 0; i <= C; ++i) spring(at(i, j), at(i, j + 1), spec.spacing);
    const auto rises = [&spec](int i, int j) {
        return !spec.alternate || (i + j) % 2 == 0;
    };
    const auto bend = [&](int a, int b, int c, int d) {
        if (!(spec.bending > 0)) return;
        const ClothHinge hinge{{a, b, c, d}, 0, spec.bending};
        if (spec.how == Bending::angle) cloth.hinges.push_back(hinge);
        if (spec.how == Bending::edges)
            cloth.bends.push_back(bend_of(hinge, cloth.bodies.x));
    };
    for (int j = 0; j < R; ++j)
        for (int i = 0; i < C; ++i) {
            const int a = at(i, j), b = at(i + 1, j), c = at(i + 1, j + 1),
                      d = at(i, j + 1);
            if (rises(i, j)) {
                spring(a, c, diagonal);
                cloth.triangles.push_back({a, b, c});
                cloth.triangles.push_back({a, c, d});
                bend(a, c, d, b);
            } else {
                spring(b, d, diagonal);
                cloth.triangles.push_back({a, b, d});
                cloth.triangles.push_back({b, c, d});
                bend(b, d, a, c);
            }
            // the edges to the next square, with the corners on either side
            if (i + 1 < C)
                bend(b, c, rises(i, j) ? a : d,
                     rises(i + 1, j) ? at(i + 2, j + 1) : at(i + 2, j));
            if (j + 1 < R)
                bend(d, c, rises(i, j) ? a : b,
                     rises(i, j + 1) ? at(i + 1, j + 2) : at(i, j + 2));
        }
    if (!(spec.bending > 0) || spec.how != Bending::quadratic) return from;
    const Real w = 1 / spec.spacing;  // (27.22)
    // a line along the border has half a square beside it
    const auto line = [&](int a, int b, int c, bool border) {
        cloth.bends.push_back({{a, b, c, -1},
                               {w, -2 * w, w, 0},
                               border ? spec.bending / 2 : spec.bending});
    };
    for (int j = 0; j <= R; ++j)
        for (int i = 0; i <= C; ++i) {
            if (i > 0 && i < C)
                line(at(i - 1, j), at(i, j), at(i + 1, j), j == 0 || j == R);
            if (j > 0 && j < R)
                line(at(i, j - 1), at(i, j), at(i, j + 1), i == 0 || i == C);
            if (i < C && j < R)
                cloth.bends.push_back(
                    {{at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)},
                     {w, -w, w, -w},
                     2 * spec.bending});
        }
    return from;
}

}  // namespace rigid
