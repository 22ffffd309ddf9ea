// The functions of row_sweeps.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/27_particles_and_cloth/row_sweeps.hpp"

namespace rigid {

void RowSweeps::begin(const ClothScene& cloth)
{
    lambda.setZero(static_cast<Index>(cloth.springs.size()));
    bend_lambda.setZero(3 * static_cast<Index>(cloth.bends.size()));
    hinge_lambda.setZero(static_cast<Index>(cloth.hinges.size()));
}

//! [sweep]
void RowSweeps::sweep(const ClothScene& cloth, Real h, VecX& x, bool with_springs)
{
    const VecX& w = cloth.bodies.inverse_mass;
    if (!keep_lambda) begin(cloth);
    const Real part = positions_alone ? share : 1;
    const auto gamma_of = [this, h](Real k) {
        return positions_alone ? 0 : 1 / (h * h * k);
    };
    Index row = 0;
    for (const ClothSpring& s : cloth.springs) {
        if (!with_springs) break;
        auto a = x.segment<3>(3 * s.a), b = x.segment<3>(3 * s.b);
        const Vec3 d = b - a;
        const Real length = d.norm(), gamma = gamma_of(s.stiffness);
        const Real wa = w[3 * s.a], wb = w[3 * s.b], A = wa + wb;
        Real& sum = lambda[row++];
        if (!(A > 0) || !(length > 0)) continue;
        const Real change = part * row_change(length - s.length, A, gamma, sum);
        sum += change;
        const Vec3 P = d * (change / length);
        a -= wa * P;
        b += wb * P;
    }
    row = 0;
    for (const ClothBend& bend : cloth.bends) {  // three rows with one A
        const Real gamma = gamma_of(bend.stiffness);
        Real A = 0;
        Vec3 d(0, 0, 0);
        const auto n = static_cast<std::size_t>(bend.count());
        for (std::size_t i = 0; i < n; ++i) {
            A += bend.w[i] * bend.w[i] * w[3 * bend.p[i]];
            d += bend.w[i] * x.segment<3>(3 * bend.p[i]);
        }
        auto sum = bend_lambda.segment<3>(3 * row++);
        if (!(A > 0)) continue;
        const Vec3 change = -part / (A + gamma) * (d + gamma * sum);
        sum += change;
        for (std::size_t i = 0; i < n; ++i)
            x.segment<3>(3 * bend.p[i]) += w[3 * bend.p[i]] * bend.w[i] * change;
    }
    row = 0;
    std::array<Vec3, 4> J;
    for (const ClothHinge& hinge : cloth.hinges) {
        const Real C = hinge_angle(hinge, x, J) - hinge.angle;
        const Real gamma = gamma_of(hinge.stiffness);
        Real A = 0;
        for (std::size_t i = 0; i < 4; ++i)
            A += w[3 * hinge.p[i]] * J[i].squaredNorm();
        Real& sum = hinge_lambda[row++];
        if (!(A > 0)) continue;
        const Real change = part * row_change(C, A, gamma, sum);
        sum += change;
        for (std::size_t i = 0; i < 4; ++i)
            x.segment<3>(3 * hinge.p[i]) += w[3 * hinge.p[i]] * change * J[i];
    }
}
//! [sweep]

//! [limit]
bool StrainLimit::find(const ClothScene& cloth, const VecX& x)
{
    beyond.clear();
    int i = 0;
    for (const ClothSpring& s : cloth.springs) {
        const Real most = (1 + strain) * s.length;
        if (s.stiffness >= stiff &&
            (x.segment<3>(3 * s.b) - x.segment<3>(3 * s.a)).squaredNorm() >
                most * most)
            beyond.push_back(i);
        ++i;
    }
    return !beyond.empty();
}

void StrainLimit::draw_back(const ClothScene& cloth, VecX& x) const
{
    const VecX& w = cloth.bodies.inverse_mass;
    for (const int i : beyond) {
        const ClothSpring& s = cloth.springs[static_cast<std::size_t>(i)];
        auto a = x.segment<3>(3 * s.a), b = x.segment<3>(3 * s.b);
        const Vec3 d = b - a;
        const Real length = d.norm(), over = length - (1 + 0.9 * strain) * s.length;
        const Real A = w[3 * s.a] + w[3 * s.b];
        if (!(over > 0) || !(A > 0)) continue;
        const Vec3 P = d * (over / (A * length));
        a += w[3 * s.a] * P;
        b -= w[3 * s.b] * P;
    }
}
//! [limit]

}  // namespace rigid
