// The functions of rates.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/04_pgs/rates.hpp"

namespace rigid {

Mlcp line_problem(Index count, Real end_mass, Real impulse, bool heavy_at_the_floor)
{
    VecX inverse_mass = VecX::Ones(count);
    inverse_mass[heavy_at_the_floor ? 0 : count - 1] = 1 / end_mass;
    Mlcp mlcp;
    mlcp.A.resize(count, count);
    mlcp.A.reserve(Eigen::VectorXi::Constant(count, 3));
    for (Index k = 0; k < count; ++k) {
        if (k > 0) mlcp.A.insert(k, k - 1) = -inverse_mass[k - 1];
        mlcp.A.insert(k, k) = inverse_mass[k] + (k > 0 ? inverse_mass[k - 1] : 0);
        if (k + 1 < count) mlcp.A.insert(k, k + 1) = -inverse_mass[k];
    }
    mlcp.A.makeCompressed();
    mlcp.q = VecX::Zero(count);
    mlcp.q[0] = -impulse;
    mlcp.lo = VecX::Zero(count);
    mlcp.hi = VecX::Constant(count, infinity);
    return mlcp;
}

VecX line_answer(Index count, Real end_mass, Real impulse, bool heavy_at_the_floor)
{
    VecX lambda(count);
    Real above = 0;
    for (Index k = count; k-- > 0;) {
        above += k == (heavy_at_the_floor ? 0 : count - 1) ? end_mass : 1;
        lambda[k] = impulse * above;
    }
    return lambda;
}

//! [theta]
Real line_angle(Index count, Real ratio)
{
    // The left side rises from 0 to infinity between 0 and π / 2(N−1).
    Real low = 0, high = pi / (2 * static_cast<Real>(count - 1));
    for (int halving = 0; halving < 100; ++halving) {
        const Real theta = (low + high) / 2;
        const Real side = tan(theta) * tan(static_cast<Real>(count - 1) * theta);
        (side < 1 / ratio ? low : high) = theta;
    }
    return (low + high) / 2;
}
//! [theta]

Real safe_jacobi_omega(const Mlcp& mlcp)
{
    Real largest = 1;
    for (Index i = 0; i < mlcp.size(); ++i) {
        Real sum = 0, diagonal = 0;
        for (SparseMatrix::InnerIterator entry(mlcp.A, i); entry; ++entry) {
            sum += std::abs(entry.value());
            if (entry.col() == i) diagonal = entry.value();
        }
        if (diagonal > 0) largest = std::max(largest, sum / diagonal);
    }
    return 2 / largest;
}

}  // namespace rigid
