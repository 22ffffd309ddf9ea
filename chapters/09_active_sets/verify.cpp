// The functions of verify.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/09_active_sets/verify.hpp"

namespace rigid {

void require_valid(const ActiveSetSettings& settings)
{
    if (!(settings.enough >= 0) || !(settings.enough < infinity))
        throw std::invalid_argument(
            "the residual that is nothing is " + shortest(settings.enough) +
            " m/s; it must be zero or positive, and finite");
    if (!(settings.tolerance > 0) || settings.limit < 0 || settings.patience < 0)
        throw std::invalid_argument(
            "tolerance " + shortest(settings.tolerance) + ", limit " +
            std::to_string(settings.limit) + ", patience " +
            std::to_string(settings.patience) +
            ": the tolerance must be positive, the others not negative");
    require_share(settings.tolerance);
}

bool is_symmetric(const SparseMatrix& A, std::vector<int>& next)
{
    const int* const outer = A.outerIndexPtr();
    const int* const inner = A.innerIndexPtr();
    const Real* const value = A.valuePtr();
    const auto n = static_cast<int>(A.rows());
    next.assign(outer, outer + n);
    for (int i = 0; i < n; ++i)
        for (int p = next[static_cast<std::size_t>(i)]; p < outer[i + 1]; ++p) {
            const int j = inner[p];
            if (j < i) return false;  // its partner should have been passed
            int& mirrored = next[static_cast<std::size_t>(j)];
            if (mirrored >= outer[j + 1] || inner[mirrored] != i) return false;
            const Real difference = std::abs(value[mirrored] - value[p]);
            if (difference > 1e-12 * std::abs(value[p])) return false;
            if (j > i) ++mirrored;
        }
    return true;
}

bool verify_guess(const Mlcp& mlcp, const ActiveSetSettings& settings,
                  const VecX& lambda, Solution& solution)
{
    solution.lambda = lambda;
    clamp_into_bounds(mlcp, solution.lambda);
    const Verification found =
        verify(mlcp, solution.lambda, {settings.tolerance, settings.enough});
    solution.residual = found.residual;
    solution.status = found.solved ? Status::solved : Status::singular;
    return found.solved;
}

}  // namespace rigid
