// The functions of solid_pairs.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/23_faces_that_touch/solid_pairs.hpp"

namespace rigid {

void SolidPairs::mark(const JointedSolids& scene, std::span<const int> bodies)
{
    const auto K = static_cast<std::size_t>(scene.bodies.count());
    if (asks.size() > K) touching.clear(), resting.clear();  // other numbers
    asks.assign(K, 0);
    for (const int k : bodies) asks[static_cast<std::size_t>(k)] = 1;
    const auto asked = [this](const BodyPair& p) {
        return looks(p.a) || looks(p.b);
    };
    std::erase_if(resting, asked);
    std::erase_if(touching, asked);
    resting.insert(resting.end(), touching.begin(), touching.end());
    touching.clear();
}

void SolidPairs::find_pairs(const JointedSolids& scene, Real margin)
{
    const Bodies<6>& bodies = scene.bodies;
    seen.resize(2 * bodies.count());
    radii.resize(bodies.count());
    joined.clear();
    for (const SpaceJoint& joint : scene.joints)
        joined.emplace_back(static_cast<int>(std::min(joint.a, joint.b)),
                            static_cast<int>(std::max(joint.a, joint.b)));
    std::sort(joined.begin(), joined.end());
    for (Index k = 0; k < bodies.count(); ++k) {
        seen.segment<2>(2 * k) = centre_of(bodies.x, k).head<2>();
        const auto i = static_cast<std::size_t>(k);
        radii[k] = reach[i] + ahead_of[i];
    }
    pairs.clear();
    sort_and_sweep(seen, radii, margin, 0, shadows, [&](int a, int b) {
        if (!looks(a) && !looks(b)) return;
        if (!bodies.can_move(a) && !bodies.can_move(b)) return;
        const Vec3 way = centre_of(bodies.x, b) - centre_of(bodies.x, a);
        if (!(way.norm() < radii[a] + radii[b] + margin)) return;
        if (!std::binary_search(joined.begin(), joined.end(), std::pair(a, b)))
            pairs.emplace_back(a, b);
    });
    std::sort(pairs.begin(), pairs.end());
}

}  // namespace rigid
