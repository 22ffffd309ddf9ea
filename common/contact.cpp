#include "common/contact.hpp"

#include "common/forces.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>

namespace rigid {

Contact segment_contact(const DiscScene& scene, const VecX& x, std::size_t i, Index b)
{
    const Segment& segment = scene.segments[i];
    const auto wall = static_cast<Index>(scene.walls.size() + i);
    const Vec2 centre = x.segment<2>(2 * b);
    const Vec2 along = (segment.q - segment.p).normalized();
    const Real length = (segment.q - segment.p).norm();
    const Vec2 d = centre - segment.p;
    const Real there = along.dot(d);
    const Real reach = scene.radius[b] + segment.radius;
    if (there >= 0 && there <= length) {
        const Vec2 left = perpendicular(along);
        const Real height = left.dot(d);
        return {world, b, height >= 0 ? left : Vec2(-left), std::abs(height) - reach, wall};
    }
    const Vec2 from_end = there < 0 ? d : Vec2(centre - segment.q);
    const Real distance = from_end.norm();
    // Zero for a centre in q whose foot lies beyond it by rounding: any direction parts them.
    return {world, b, direction_of(from_end, distance, perpendicular(along)), distance - reach, wall};
}

void find_contacts(const DiscScene& scene, Real margin, std::vector<Contact>& contacts)
{
    const VecX& x = scene.bodies.x;
    const Index K = scene.radius.size();
    if (x.size() != 2 * K)
        throw std::invalid_argument("there are " + std::to_string(x.size()) + " coordinates for the " +
                                    std::to_string(K) + " radii of discs; each disc has two");
    require_margin(margin);
    contacts.clear();
    for (Index a = 0; a < K && !scene.linked.is_all(); ++a)
        for (Index b = a + 1; b < K; ++b) {
            const Real reach = scene.radius[a] + scene.radius[b] + margin;
            if ((x.segment<2>(2 * b) - x.segment<2>(2 * a)).squaredNorm() >= reach * reach) continue;
            if (!scene.linked.contains(a, b)) contacts.push_back(disc_contact(scene, x, a, b));
        }
    for (Index b = 0; b < K; ++b)
        for_each_wall(scene, b, margin, [&](const Contact& contact) { contacts.push_back(contact); });
}

}  // namespace rigid
