/// \file solid_pairs.hpp
/// Where the solids of a step are, and which of them are near each other.
///
/// Pairs are found by chapter 10's sort and sweep, on the shadows of balls around the bodies. What a joint joins does not
/// collide, and what cannot move makes no row with what cannot move. A body that is not looked at is where it was.
#pragma once

#include "chapters/10_skipping_work/sort_and_sweep.hpp"
#include "chapters/18_space/solid_form.hpp"
#include "chapters/18_space/space_scene.hpp"

#include <span>

namespace rigid {

struct BodyPair {
    int a = 0, b = 0;
};

struct SolidPairs {
    // What is kept from step to step.
    std::vector<std::vector<Hull>> known;       ///< of these the forms are
    std::vector<std::vector<SolidForm>> forms;  ///< of each body's hulls
    std::vector<std::vector<PlacedSolid>> solids;
    std::vector<Real> reach;  ///< of each body, from its centroid [m]
    std::vector<Real> inner;  ///< radius of each body [m]
    /// of each body: how far it looks beyond the margin [m]
    std::vector<Real> ahead_of;
    SortAndSweep shadows;
    VecX seen, radii;
    std::vector<std::pair<int, int>> pairs, joined;
    std::vector<char> asks;  ///< 1: the step looks at this body
    /// pairs of bodies that touched: of the last step, and of those that are not
    /// looked at as they were last
    std::vector<BodyPair> touching, resting;

    bool looks(Index k) const { return asks[static_cast<std::size_t>(k)] != 0; }

    /// Who looks. Pairs that nobody asks for any more are kept apart.
    void mark(const SpaceScene& scene, std::span<const int> bodies)
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

    /// Forms of what is new, and all of them that are looked at where the bodies are.
    void place(const SpaceScene& scene)
    {
        const bool all = known != scene.shapes;
        if (all) {
            known = scene.shapes;
            forms.assign(known.size(), {});
            reach.assign(known.size(), 0);
            inner.resize(known.size());
            for (std::size_t k = 0; k < known.size(); ++k) {
                for (const Hull& hull : known[k]) {
                    forms[k].push_back(form_of(hull));
                    reach[k] = std::max(reach[k], forms[k].back().reach);
                }
                inner[k] = inner_radius(forms[k]);
            }
            solids.assign(known.size(), {});
        }
        for (std::size_t k = 0; k < forms.size(); ++k) {
            const auto body = static_cast<Index>(k);
            if (!all && !looks(body)) continue;
            const Mat3 R = rotation_of(scene.bodies.x, body);
            solids[k].resize(forms[k].size());
            for (std::size_t i = 0; i < forms[k].size(); ++i)
                solids[k][i].place(forms[k][i], centre_of(scene.bodies.x, body), R);
        }
    }

    void find_pairs(const SpaceScene& scene, Real margin)
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
};

}  // namespace rigid
