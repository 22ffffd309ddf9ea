/// \file touching_pair.hpp
/// Two bodies that touch, and the points of a manifold as contacts of a step.
#pragma once

#include "chapters/03_mlcp_formulation/step_data.hpp"
#include "chapters/12_contact_manifolds/manifold.hpp"

namespace rigid {

/// Two bodies and where they touch.
struct TouchingPair {
    int a = 0, b = 0;  ///< a < b
    Manifold manifold;
};

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
        now.contacts.push_back(
            {body_a, body_b, m.normal, p.gap, first_feature + p.feature, p.point,
             radius(a) + p.gap / 2, radius(b) + p.gap / 2,
             static_cast<int>(a - body_a), static_cast<int>(b - body_b)});
    }
}

}  // namespace rigid
