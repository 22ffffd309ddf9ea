// The functions of space_bodies.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/20_turning_in_space/space_bodies.hpp"

namespace rigid {

//! [momenta]
Vec<6> momenta(const Bodies<6>& bodies)
{
    Vec<6> sum = Vec<6>::Zero();
    for (Index k = 0; k < bodies.count(); ++k) {
        const Vec<6> inverse = bodies.inverse_mass.segment<6>(6 * k);
        if (!(inverse.minCoeff() > 0)) continue;
        const Vec<6> Mu = bodies.velocity(k).cwiseQuotient(inverse);
        const Vec3 P = Mu.head<3>(), L = Mu.tail<3>();
        sum.head<3>() += P;
        sum.tail<3>() +=
            cross(centre_of(bodies.x, k), P) + rotation_of(bodies.x, k) * L;
    }
    return sum;
}
//! [momenta]

Real kinetic_energy(const Bodies<6>& bodies)
{
    Real sum = 0;
    for (Index i = 0; i < bodies.u.size(); ++i)
        if (bodies.inverse_mass[i] > 0)
            sum += bodies.u[i] * bodies.u[i] / bodies.inverse_mass[i] / 2;
    return sum;
}

}  // namespace rigid
