#include "tests/stress/columns.hpp"

namespace rigid::stress {

std::vector<Method> methods(int sweeps)
{
    std::vector<Method> all = matrix_methods(sweeps);
    for (auto more : {impulse_methods(sweeps), exact_methods(sweeps), skipping_methods(sweeps)})
        all.insert(all.end(), more.begin(), more.end());
    return all;
}

}  // namespace rigid::stress
