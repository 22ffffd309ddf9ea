/// \file touching_pair.hpp
/// Two bodies that touch, and the points of a manifold as contacts of a step.
#pragma once

#include "chapters/03_mlcp_formulation/step_data.hpp"
#include "chapters/12_contact_manifolds/manifold.hpp"
#include "chapters/12_contact_manifolds/pair_finder.hpp"

namespace rigid {

/// Two bodies and where they touch.
struct TouchingPair {
    int a = 0, b = 0;  ///< a < b
    Manifold manifold;
};

inline std::uint64_t key_of(const TouchingPair& pair)
{
    return pair_key(pair.a, pair.b);
}

/// Where a list that is ascending has this pair, or the first one behind it.
inline std::vector<TouchingPair>::const_iterator
first_from(const std::vector<TouchingPair>& list, std::uint64_t pair)
{
    return std::lower_bound(
        list.begin(), list.end(), pair,
        [](const TouchingPair& p, std::uint64_t key) { return key_of(p) < key; });
}

/// \param a, b           their shapes; a is the world: b touches a wall
/// \param first_feature  of this wall; else 0
inline void add_contacts(const RigidScene& scene, Index a, Index b,
                         const Manifold& m, int first_feature, StepData<3>& now)
{
    const auto radius = [&scene](Index k) {
        return k == world ? 0 : scene.shapes[static_cast<std::size_t>(k)].radius;
    };
    for (int i = 0; i < m.count; ++i) {
        const ManifoldPoint& p = m.points[static_cast<std::size_t>(i)];
        now.sources.push_back(
            {Source::Of::contact, static_cast<int>(now.contacts.size())});
        const Index body_a = scene.carrier(a), body_b = scene.carrier(b);
        now.contacts.push_back({body_a, body_b, m.normal, p.gap,
                                first_feature + p.feature, p.point,
                                radius(a) + p.gap / 2, radius(b) + p.gap / 2,
                                static_cast<int>(a - body_a),
                                static_cast<int>(b - body_b), m.normal_of});
    }
}

}  // namespace rigid
