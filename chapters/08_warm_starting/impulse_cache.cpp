// The functions of impulse_cache.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/08_warm_starting/impulse_cache.hpp"

namespace rigid {

template void sort_by_key(std::vector<ImpulseCache::Entry>&,
                          SortScratch<ImpulseCache::Entry>&);

std::string to_string(const ImpulseKey& key)
{
    return std::to_string(key.first) + ", " + std::to_string(key.second) + ", " +
           std::to_string(key.feature) +
           (key.part > 0 ? ", " + std::to_string(key.part) : "");
}

}  // namespace rigid
