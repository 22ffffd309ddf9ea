// The functions of sleeping.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/10_skipping_work/sleeping.hpp"

namespace rigid {

void require_valid(const RestSettings& rest)
{
    const auto refuse = [](const char* name, Real value) {
        throw std::invalid_argument(std::string(name) + " is " + shortest(value) +
                                    "; it must be positive and finite");
    };
    if (!(rest.speed > 0) || !std::isfinite(rest.speed))
        refuse("the speed of rest", rest.speed);
    if (!(rest.acceleration > 0) || !std::isfinite(rest.acceleration))
        refuse("the acceleration of rest", rest.acceleration);
    if (!(rest.time > 0) || !std::isfinite(rest.time))
        refuse("the time of rest", rest.time);
}

void SleepingForces::put(int body, const ImpulseKey& key, Real force)
{
    int place = free;
    if (place < 0) {
        place = static_cast<int>(entries.size());
        entries.emplace_back();
    } else {
        free = entries[static_cast<std::size_t>(place)].next;
    }
    int& first = head[static_cast<std::size_t>(body)];
    entries[static_cast<std::size_t>(place)] = {key, force, first};
    first = place;
}

void remember_woken(SleepingForces& forces, std::span<const int> woken,
                    ImpulseCache& cache)
{
    const std::size_t before = cache.entries.size();
    for (const int k : woken)
        forces.take_all(k, [&cache](const ImpulseKey& key, Real force) {
            cache.entries.push_back(
                {key, 0, static_cast<std::uint32_t>(cache.entries.size()),
                 force * cache.h});
        });
    if (cache.entries.size() == before) return;
    std::sort(cache.entries.begin(), cache.entries.end(),
              [](const auto& a, const auto& b) { return a.key < b.key; });
    note_places(cache);
}

}  // namespace rigid
