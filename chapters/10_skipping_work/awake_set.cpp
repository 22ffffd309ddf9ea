// The functions of awake_set.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/10_skipping_work/awake_set.hpp"

namespace rigid {

//! [wake]
void AwakeSet::wake(Index k)
{
    while (is_asleep(k)) {
        const auto i = static_cast<std::size_t>(k);
        activity[i] = Activity::awake;
        awake.push_back(static_cast<int>(k));
        woken.push_back(static_cast<int>(k));
        k = std::exchange(ring[i], static_cast<int>(k));
    }
}
//! [wake]

void AwakeSet::sleep(std::span<const int> members)
{
    for (std::size_t i = 0; i < members.size(); ++i) {
        const auto k = static_cast<std::size_t>(members[i]);
        activity[k] = Activity::asleep;
        ring[k] = members[(i + 1) % members.size()];
    }
}

void AwakeSet::tidy()
{
    std::erase_if(awake, [this](int k) { return !is_awake(k); });
    for (std::vector<int>* const list : {&awake, &woken}) {
        if (!std::is_sorted(list->begin(), list->end()))
            std::sort(list->begin(), list->end());
        list->erase(std::unique(list->begin(), list->end()), list->end());
    }
}

}  // namespace rigid
