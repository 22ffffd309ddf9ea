// The functions of pyramid.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/24_friction_is_a_disc/pyramid.hpp"

namespace rigid {

namespace {

void require_pyramid(int corners)
{
    if (corners < 3)
        throw std::invalid_argument("a pyramid of friction has " +
                                    std::to_string(corners) +
                                    " corners; it must have three or more");
}

void require_numbers(Index count, Index right, const char* of)
{
    if (count != right)
        throw std::invalid_argument(std::string(of) + " has " +
                                    std::to_string(count) + " rows; it must have " +
                                    std::to_string(right));
}

}  // namespace

//! [stop]
Vec2 stop_in_pyramid(Real d, Real phi, int corners)
{
    require_pyramid(corners);
    const Real half = pi / corners;
    // the force is towards the corner next to −v; ψ counts from the middle of the side
    const Real side = std::floor((phi + pi) / (2 * half));
    const Real psi = phi + pi - (2 * side + 1) * half;
    const Real c = cos(psi), s = sin(psi);
    const Real along = d * c * c / cos(half),
               across = (s < 0 ? -d : d) * s * s / sin(half);
    return {along * c + across * s, across * c - along * s};
}
//! [stop]

//! [problem]
Mlcp pyramid_problem(const Mlcp& rows, Real mu, int corners)
{
    require_pyramid(corners);
    require_numbers(rows.q.size(), 3, "the problem of a contact");
    const Index m = corners;
    MatX D = MatX::Zero(3, m + 2);  // impulses of the three rows
    for (Index k = 0; k < m; ++k) {
        const Real angle = 2 * pi * static_cast<Real>(k) / static_cast<Real>(m);
        D(0, k) = cos(angle), D(1, k) = sin(angle);
    }
    D(2, m) = 1;
    MatX A = D.transpose() * (rows.A * D);
    A.col(m + 1).head(m).setOnes();
    A.row(m + 1).head(m).setConstant(-1);
    A(m + 1, m) = mu;
    return {A.sparseView(), D.transpose() * rows.q, VecX::Zero(m + 2),
            VecX::Constant(m + 2, infinity)};
}

Vec3 pyramid_impulses(const VecX& answer, int corners)
{
    require_pyramid(corners);
    require_numbers(answer.size(), corners + 2, "the answer of a pyramid");
    Vec3 lambda(0, 0, answer[corners]);
    for (int k = 0; k < corners; ++k) {
        const Real angle = 2 * pi * k / corners;
        lambda[0] += answer[k] * cos(angle), lambda[1] += answer[k] * sin(angle);
    }
    return lambda;
}
//! [problem]

}  // namespace rigid
