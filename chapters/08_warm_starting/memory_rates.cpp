// The functions of memory_rates.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/08_warm_starting/memory_rates.hpp"

namespace rigid {

//! [step_rate]
Real step_rate(Real gamma, Real share, Real beta)
{
    // the matrix whose characteristic polynomial is (8.18)
    Eigen::Matrix<Real, 3, 3> companion;
    companion << 1 - beta + gamma * (1 + share + beta), -gamma * (1 + 2 * share),
        gamma * share, 1, 0, 0, 0, 1, 0;
    if (beta == 0) companion.row(0) << gamma * (1 + share), -gamma * share, 0;
    return spectral_radius(companion);
}
//! [step_rate]

}  // namespace rigid
