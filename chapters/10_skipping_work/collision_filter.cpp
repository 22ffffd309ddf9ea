// The functions of collision_filter.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/10_skipping_work/collision_filter.hpp"

namespace rigid {

void CollisionFilter::set_meets(int f, int g, bool yes)
{
    if (f < 0 || g < 0 || f >= most_groups || g >= most_groups)
        throw std::invalid_argument("groups " + std::to_string(f) + " and " +
                                    std::to_string(g) +
                                    " cannot be distinguished; they go from 0 to " +
                                    std::to_string(most_groups - 1));
    const auto bit = [](int i) { return std::uint64_t{1} << i; };
    auto& of_f = meets[static_cast<std::size_t>(f)];
    auto& of_g = meets[static_cast<std::size_t>(g)];
    of_f = yes ? of_f | bit(g) : of_f & ~bit(g);
    of_g = yes ? of_g | bit(f) : of_g & ~bit(f);
}

CollisionFilter forbid_pairs(Index count,
                             std::vector<std::pair<Index, Index>> pairs)
{
    CollisionFilter filter;
    for (auto& [a, b] : pairs) {
        if (a < 0 || b < 0 || a >= count || b >= count || a == b)
            throw std::invalid_argument(
                "the pair of bodies " + std::to_string(a) + " and " +
                std::to_string(b) +
                " cannot be kept apart; there are bodies 0 to " +
                std::to_string(count - 1));
        if (a > b) std::swap(a, b);
    }
    std::sort(pairs.begin(), pairs.end());
    pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
    filter.first.assign(static_cast<std::size_t>(count) + 1, 0);
    for (const auto& [a, b] : pairs) {
        ++filter.first[static_cast<std::size_t>(a) + 1];
        filter.partner.push_back(static_cast<int>(b));
    }
    for (std::size_t k = 1; k < filter.first.size(); ++k)
        filter.first[k] += filter.first[k - 1];
    return filter;
}

}  // namespace rigid
