// The functions of exact_tumbling.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/20_turning_in_space/exact_tumbling.hpp"

namespace rigid {

Vec3 jacobi_functions(Real u, Real k)
{
    const GeometricMean steps(asin(k));
    Real phase = std::ldexp(steps.mean() * u, steps.last);
    for (int n = steps.last; n > 0; --n) {
        const auto i = static_cast<std::size_t>(n);
        phase = (phase + asin(steps.c[i] / steps.a[i] * sin(phase))) / 2;
    }
    const Real sn = sin(phase);
    return {sn, cos(phase), std::sqrt(1 - k * k * sn * sn)};
}

}  // namespace rigid
