/// \file solid_pairs.hpp
/// Where the solids of a step are, and which of them are near each other.
///
/// Pairs are found by chapter 10's sort and sweep, on the shadows of balls around the bodies. What a joint joins does not
/// collide, and what cannot move makes no row with what cannot move. A body that is not looked at is where it was.
#pragma once

#include "chapters/10_skipping_work/sort_and_sweep.hpp"
#include "chapters/21_joints_in_space/space_joint.hpp"
#include "chapters/22_distance_of_solids/solid_form.hpp"

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
    /// of each body: how far it looks beyond the margin [m]; zero, unless a stage
    /// writes it between place() and find_pairs()
    std::vector<Real> ahead_of;
    std::vector<Real> way_of;  ///< the same to a wall, which has no corner [m]
    SortAndSweep shadows;
    VecX seen, radii;
    std::vector<std::pair<int, int>> pairs, joined;
    std::vector<char> asks;  ///< 1: the step looks at this body
    /// pairs of bodies that touched: of the last step, and of those that are not
    /// looked at as they were last
    std::vector<BodyPair> touching, resting;

    bool looks(Index k) const { return asks[static_cast<std::size_t>(k)] != 0; }

    /// Which bodies look. Pairs of which neither does any more are kept apart.
    void mark(const JointedSolids& scene, std::span<const int> bodies);

    /// Forms of what is new, and all of them that are looked at where the bodies are.
    void place(const JointedSolids& scene)
    {
        const bool all = known != scene.shapes;
        if (all) {
            // a hull that is refused leaves all of this as it was
            std::vector<std::vector<SolidForm>> made(scene.shapes.size());
            for (std::size_t k = 0; k < made.size(); ++k)
                for (const Hull& hull : scene.shapes[k])
                    made[k].push_back(form_of(hull));
            known = scene.shapes;
            forms = std::move(made);
            reach.assign(known.size(), 0);
            inner.resize(known.size());
            for (std::size_t k = 0; k < known.size(); ++k) {
                for (const SolidForm& form : forms[k])
                    reach[k] = std::max(reach[k], form.reach);
                inner[k] = inner_radius(forms[k]);
            }
            solids.assign(known.size(), {});
        }
        ahead_of.assign(known.size(), 0);
        way_of.assign(known.size(), 0);
        for (std::size_t k = 0; k < forms.size(); ++k) {
            const auto body = static_cast<Index>(k);
            if (!all && !looks(body)) continue;
            const Mat3 R = rotation_of(scene.bodies.x, body);
            solids[k].resize(forms[k].size());
            for (std::size_t i = 0; i < forms[k].size(); ++i)
                solids[k][i].place(forms[k][i], centre_of(scene.bodies.x, body), R);
        }
    }

    void find_pairs(const JointedSolids& scene, Real margin);
};

}  // namespace rigid
