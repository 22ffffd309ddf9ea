// The functions of block_descent.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/16_soft_constraints/block_descent.hpp"

namespace rigid {

void BlockDescent::require_valid() const
{
    const auto between = [](Real value, Real low, Real high, const char* name) {
        if (!(value >= low && value <= high))
            throw std::invalid_argument(std::string(name) + " is " +
                                        shortest(value) + "; it must be from " +
                                        shortest(low) + " to " + shortest(high));
    };
    between(alpha, 0, 1, "alpha of block descent");
    between(gamma, 0, 1, "gamma of block descent");
    between(beta, 0, 1e15, "beta of block descent");
    between(first, 1e-9, most, "the first stiffness of block descent");
    between(most, first, 1e15, "the largest stiffness of block descent");
    if (sweeps < 0)
        throw std::invalid_argument("the number of sweeps is " +
                                    std::to_string(sweeps) +
                                    "; it must be zero or positive");
}

}  // namespace rigid
