// The functions of brick_rows.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/17_wide_sweeps/brick_rows.hpp"

namespace rigid {

BrickRows brick_rows(int base)
{
    BrickRows all;
    all.bodies = static_cast<Index>(base) * (base + 1) / 2;
    VecX& inverse_mass = all.inverse_mass = VecX::Ones(3 * all.bodies);
    for (Index k = 0; k < all.bodies; ++k) inverse_mass[3 * k + 2] = 6;
    std::vector<Row<3>> normals;
    // a contact in the plane y = 0 of a brick whose centre is at x = 0 there
    const auto touch = [&](Index a, Index b, Real from_a, Real from_b) {
        for (const Real side : {-0.24, 0.24}) {
            const auto number = static_cast<int>(normals.size());
            Constraint<3> normal, drag;
            normal.a = drag.a = a;
            normal.b = drag.b = b;
            normal.Jb = {0, 1, from_b + side};
            drag.Jb = {1, 0, 0.5};
            if (a != world) {
                normal.Ja = {0, -1, -(from_a + side)};
                drag.Ja = {-1, 0, 0.5};
            }
            // no two contacts are quite alike
            const Real bias = 1e-4 * (number * 7 % 11);
            normals.push_back(unilateral(normal, inverse_mass, bias));
            all.rows.push_back(bilateral(drag, inverse_mass));
            all.rows.back().friction = 0.6;
            all.rows.back().bounded_by = number;
        }
    };
    Index below = 0, here = 0;
    for (int row = 0; row < base; ++row, below = here - (base - row + 1))
        for (int i = 0; i < base - row; ++i, ++here) {
            if (row == 0) touch(world, here, 0, 0);
            else {
                touch(below + i, here, 0.25, -0.25);
                touch(below + i + 1, here, -0.25, 0.25);
            }
        }
    for (Row<3>& drag : all.rows)
        drag.bounded_by += static_cast<int>(normals.size());
    all.rows.insert(all.rows.end(), normals.begin(), normals.end());
    all.u = VecX::Zero(3 * all.bodies);
    for (Index k = 0; k < all.bodies; ++k) all.u[3 * k + 1] = -9.81 / 60;
    return all;
}

}  // namespace rigid
