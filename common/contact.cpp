#include "common/contact.hpp"

#include "common/forces.hpp"

#include <stdexcept>
#include <string>

namespace rigid {

void find_contacts(const VecX& x, const VecX& radius, const std::vector<HalfSpace>& walls,
                   const std::vector<bool>& linked, Real margin, std::vector<Contact>& contacts)
{
    const Index K = radius.size();
    const auto refuse = [](const std::string& sentence) { throw std::invalid_argument(sentence); };
    if (x.size() != 2 * K)
        refuse("there are " + std::to_string(x.size()) + " coordinates for the " + std::to_string(K) +
               " radii of discs; each disc has two");
    if (!linked.empty() && static_cast<Index>(linked.size()) != K * K)
        refuse("the table of linked pairs has " + std::to_string(linked.size()) +
               " entries; it must be empty or have " + std::to_string(K * K));
    require_margin(margin);
    contacts.clear();
    for (Index a = 0; a < K; ++a)
        for (Index b = a + 1; b < K; ++b) {
            if (!linked.empty() && linked[static_cast<std::size_t>(a * K + b)]) continue;
            const Vec2 d = x.segment<2>(2 * b) - x.segment<2>(2 * a);
            const Real reach = radius[a] + radius[b] + margin;
            if (d.squaredNorm() >= reach * reach) continue;
            const Real distance = d.norm();
            // Two centres in one point have no direction; any will part them.
            const Vec2 normal = distance > 0 ? Vec2(d / distance) : Vec2(0, 1);
            contacts.push_back({a, b, normal, distance - radius[a] - radius[b], 0});
        }
    for (Index b = 0; b < K; ++b)
        for (std::size_t i = 0; i < walls.size(); ++i) {
            const HalfSpace& wall = walls[i];
            const Real gap = wall.normal.dot(x.segment<2>(2 * b)) - wall.offset - radius[b];
            if (gap < margin) contacts.push_back({world, b, wall.normal, gap, static_cast<Index>(i)});
        }
}

}  // namespace rigid
