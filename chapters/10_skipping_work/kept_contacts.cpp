// The functions of kept_contacts.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/10_skipping_work/kept_contacts.hpp"

namespace rigid {

//! [keep]
void keep_contacts(const DiscScene& scene, const AwakeSet& set, BroadPhase& broad,
                   Real slack, KeptContacts& memory, std::vector<Contact>& contacts)
{
    const auto wall_key = [](const Contact& c) {
        return std::pair(c.b, c.feature);
    };
    std::swap(memory.now, memory.before);
    memory.now.clear();
    memory.kept.clear();
    memory.reused = 0;
    const std::size_t last_discs = memory.before.size();
    memory.same = contacts.size() == last_discs + memory.walls;
    std::size_t old = 0, count = 0;
    broad.tested += static_cast<std::int64_t>(broad.pairs.size());
    for (const std::uint64_t pair : broad.pairs) {
        const Index a = first_of(pair), b = second_of(pair);
        const Vec2 d =
            scene.bodies.x.segment<2>(2 * b) - scene.bodies.x.segment<2>(2 * a);
        const Real reach = scene.radius[a] + scene.radius[b] + broad.margin;
        if (d.squaredNorm() >= reach * reach) continue;
        while (old < last_discs && memory.before[old].pair < pair) ++old;
        const bool known = old < last_discs && memory.before[old].pair == pair;
        const bool keep =
            known && (d - memory.before[old].d).squaredNorm() <= slack * slack;
        memory.same = memory.same && known && old == count;
        if (keep) {
            memory.now.push_back(memory.before[old]);
            ++memory.reused;
        } else {
            const Real distance = d.norm();
            memory.now.push_back({pair, d, direction_of(d, distance, {0, 1}),
                                  distance - scene.radius[a] - scene.radius[b]});
        }
        memory.kept.push_back(keep);
        const KeptContacts::Found& found = memory.now.back();
        const Contact contact = {a, b, found.normal,
                                 found.gap + found.normal.dot(d - found.d), 0};
        if (count < contacts.size()) contacts[count] = contact;
        else contacts.push_back(contact);
        ++count;
    }
    // Walls are flat, and their normals those of the step before, but at the ends
    // of a segment.
    for (const int b : set.awake) {
        if (!scene.bodies.can_move(b)) continue;
        for_each_wall(scene, b, broad.margin, [&](const Contact& contact) {
            memory.same = memory.same && count < contacts.size() &&
                          contacts[count].a == world &&
                          wall_key(contacts[count]) == wall_key(contact);
            memory.kept.push_back(memory.same &&
                                  contacts[count].normal == contact.normal);
            if (count < contacts.size()) contacts[count] = contact;
            else contacts.push_back(contact);
            ++count;
        });
    }
    memory.same = memory.same && count == last_discs + memory.walls;
    memory.walls = count - memory.now.size();
    contacts.resize(count);
}
//! [keep]

}  // namespace rigid
