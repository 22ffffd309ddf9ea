// The functions of impulse_cache.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/08_warm_starting/impulse_cache.hpp"

namespace rigid {

template void sort_by_key(std::vector<ImpulseCache::Entry>&,
                          SortScratch<ImpulseCache::Entry>&);

}  // namespace rigid
