// The functions of line_rates.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/17_wide_sweeps/line_rates.hpp"

namespace rigid {

VecX line_sweep(VecX e, bool coloured)
{
    const Index N = e.size();
    for (Index first = 0; first < (coloured ? 2 : 1); ++first)
        for (Index i = first; i < N; i += coloured ? 2 : 1)
            e[i] = ((i > 0 ? e[i - 1] : 0) + (i + 1 < N ? e[i + 1] : 0)) / 2;
    return e;
}

}  // namespace rigid
