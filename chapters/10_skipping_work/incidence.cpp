// The functions of incidence.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/10_skipping_work/incidence.hpp"

namespace rigid {

void collect(const Incidence& on, std::span<const int> bodies,
             std::vector<int>& items)
{
    items.clear();
    for (const int k : bodies)
        for (const int i : on.of(k)) items.push_back(i);
    if (!std::is_sorted(items.begin(), items.end()))
        std::sort(items.begin(), items.end());
    items.erase(std::unique(items.begin(), items.end()), items.end());
}

}  // namespace rigid
