// The functions of rolling_solid.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/24_friction_is_a_disc/rolling_solid.hpp"

namespace rigid {

//! [rates]
Vec<6> rolling_rates(const RollingSolid& solid, const Vec<6>& y)
{
    const Vec3 gamma = y.head<3>(), omega = y.tail<3>();
    const Mat3& S = solid.surface.stretch;
    const Vec3 turning = cross(gamma, omega);
    const Vec3 s = S.transpose() * gamma, s_rate = S.transpose() * turning;
    const Real length = s.norm();
    const Vec3 r = lowest_point(solid.surface, gamma);
    const Vec3 r_rate =
        S * (s * (s.dot(s_rate) / (length * length)) - s_rate) / length;
    const Vec3 push = cross(r_rate, omega) + cross(omega, cross(r, omega)) +
                      solid.gravity * gamma;
    const Mat3 I = solid.inertia.asDiagonal(), arm = cross_matrix(r);
    const Vec3 L = solid.inertia.cwiseProduct(omega);
    Vec<6> rates;
    rates << turning, solve3(I - solid.mass * arm * arm,
                             solid.mass * cross(r, push) - cross(omega, L));
    return rates;
}
//! [rates]

Vec<6> roll(const RollingSolid& solid, const Vec<6>& y, Real h)
{
    const Vec<6> k1 = rolling_rates(solid, y);
    const Vec<6> k2 = rolling_rates(solid, y + h / 2 * k1);
    const Vec<6> k3 = rolling_rates(solid, y + h / 2 * k2);
    const Vec<6> k4 = rolling_rates(solid, y + h * k3);
    return y + h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
}

Real rolling_energy(const RollingSolid& solid, const Vec<6>& y)
{
    const Vec3 gamma = y.head<3>(), omega = y.tail<3>();
    const Vec3 r = lowest_point(solid.surface, gamma);
    return solid.inertia.dot(omega.cwiseAbs2()) / 2 +
           solid.mass *
               (cross(r, omega).squaredNorm() / 2 - solid.gravity * gamma.dot(r));
}

}  // namespace rigid
