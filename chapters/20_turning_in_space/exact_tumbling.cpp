// The functions of exact_tumbling.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/20_turning_in_space/exact_tumbling.hpp"

namespace rigid {

Vec3 jacobi_functions(Real u, Real k)
{
    if (!(k >= 0 && k <= 1) || !std::isfinite(u))
        throw std::invalid_argument(
            "the Jacobi functions are asked for u = " + shortest(u) +
            " and k = " + shortest(k) + "; u must be finite, and k from 0 to 1");
    if (k == 1) {  // tanh u, 1/cosh u, 1/cosh u
        const Real e = exp(-std::abs(u)), sech = 2 * e / (1 + e * e);
        const Real tanh = -expm1(-2 * std::abs(u)) / (1 + e * e);
        return {std::copysign(tanh, u), sech, sech};
    }
    const GeometricMean steps(asin(k));
    Real phase = std::ldexp(steps.mean() * u, steps.last);
    for (int n = steps.last; n > 0; --n) {
        const auto i = static_cast<std::size_t>(n);
        phase = (phase + asin(steps.c[i] / steps.a[i] * sin(phase))) / 2;
    }
    const Real sn = sin(phase);
    return {sn, cos(phase), std::sqrt(1 - k * k * sn * sn)};
}

SpinForm spin_form(const Vec3& inertia, const Vec3& omega)
{
    const Real most = 1e50;  // I³ω² of what is within it is a number
    const Real I1 = inertia[0], I2 = inertia[1], I3 = inertia[2];
    if (!(I1 >= 1 / most && I1 < I2 && I2 < I3 && I3 <= most))
        throw std::invalid_argument(
            "the moments of inertia are " + shortest(I1) + ", " + shortest(I2) +
            ", " + shortest(I3) +
            " kg m²; they must be ascending, from 1e-50 to 1e50");
    if (!(omega.norm() >= 1 / most && omega.norm() <= most))
        throw std::invalid_argument(
            "a spin is " + shortest(omega[0]) + ", " + shortest(omega[1]) + ", " +
            shortest(omega[2]) + " rad/s; its length must be from 1e-50 to 1e50");
    // sums of what is positive; only L² − 2 E I₂ = third − first cancels
    const Vec3 w2 = omega.cwiseAbs2();
    const Real below = I1 * (I3 - I1) * w2[0] + I2 * (I3 - I2) * w2[1],
               above = I2 * (I2 - I1) * w2[1] + I3 * (I3 - I1) * w2[2],
               first = I1 * (I2 - I1) * w2[0], third = I3 * (I3 - I2) * w2[2];
    SpinForm s;
    s.swapped = third < first;
    s.I1 = s.swapped ? I3 : I1, s.I2 = I2, s.I3 = s.swapped ? I1 : I3;
    s.upper = s.swapped ? -above : below, s.lower = s.swapped ? -below : above;
    const Real middle = std::abs(third - first), whole = (s.I3 - s.I2) * s.lower,
               rounding = 4 * std::numeric_limits<Real>::epsilon();  // four in each
    s.k_rest = middle <= rounding * (third + first)
                   ? 0
                   : std::sqrt((I3 - I1) * middle / whole);
    s.k = s.k_rest > 0
              ? std::sqrt(std::min((s.I2 - s.I1) * s.upper / whole, Real{1}))
              : 1;
    s.rate = std::sqrt(whole / (I1 * I2 * I3));
    return s;
}

Real spin_period(const Vec3& inertia, const Vec3& omega)
{
    const SpinForm s = spin_form(inertia, omega);
    if (s.k_rest == 0) return infinity;
    // by the mean of 1 and √(1 − k²), which an angle near π/2 would not hold
    Real a = 1, b = s.k_rest;
    while (std::abs(a - b) > 1e-15 * a) {
        const Real mean = (a + b) / 2;
        b = std::sqrt(a * b), a = mean;
    }
    return 2 * pi / (a * s.rate);
}

}  // namespace rigid
