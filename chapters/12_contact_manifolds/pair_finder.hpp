/// \file pair_finder.hpp
/// Which pairs of bodies are to be looked at: their boxes overlap, one of them can move, no joint keeps them from touching, and the filter
/// lets them meet.
#pragma once

#include "chapters/10_skipping_work/collision_filter.hpp"
#include "chapters/12_contact_manifolds/box_sweep.hpp"
#include "chapters/12_contact_manifolds/box_tree.hpp"

namespace rigid {

enum class PairSearch { sweep, tree };

inline std::uint64_t pair_key(Index a, Index b)
{
    return static_cast<std::uint64_t>(std::min(a, b)) << 32 |
           static_cast<std::uint64_t>(std::max(a, b));
}

struct PairFinder {
    CollisionFilter filter;
    PairSearch search = PairSearch::tree;
    Real skin = 5;  ///< of the boxes in the tree [margins]

    // What is kept from step to step.
    std::vector<Box> boxes;  ///< of the shapes, with half the margin around them
    std::vector<char> moves;
    std::vector<std::uint64_t>
        joined;  ///< a · 2³² + b, ascending: a joint joins them
    std::vector<std::uint64_t> pairs;  ///< the answer, ascending
    BoxSweep sweep;
    BoxTree tree;
    std::int64_t tested = 0;  ///< boxes compared in this step

    bool may_touch(int a, int b) const
    {
        return (moves[static_cast<std::size_t>(a)] ||
                moves[static_cast<std::size_t>(b)]) &&
               (filter.meets[static_cast<std::size_t>(filter.group_of(a))] >>
                    filter.group_of(b) &
                1) != 0 &&
               !filter.forbids(std::min(a, b), std::max(a, b)) &&
               !std::binary_search(joined.begin(), joined.end(), pair_key(a, b));
    }

    //! [find]
    void find(const RigidScene& scene, const PlacedShapes& placed, Real margin)
    {
        const auto K = static_cast<std::size_t>(scene.bodies.count());
        boxes.clear();
        moves.clear();
        for (std::size_t k = 0; k < K; ++k) {
            boxes.push_back(grown(placed.boxes[k], margin / 2));
            moves.push_back(scene.bodies.can_move(static_cast<Index>(k)));
        }
        joined.clear();
        for (const PointJoint& joint : scene.joints)
            if (joint.a != world && !joint.collides)
                joined.push_back(pair_key(joint.a, joint.b));
        std::sort(joined.begin(), joined.end());

        pairs.clear();
        const auto keep = [&](int a, int b) {
            if (may_touch(a, b)) pairs.push_back(pair_key(a, b));
        };
        if (search == PairSearch::sweep) {
            overlapping_pairs(boxes, sweep, keep);
            tested = sweep.tested;
        } else find_in_tree(skin * margin, keep);
        std::sort(pairs.begin(), pairs.end());
    }

    /// Each body that can move looks for those behind it, and for those that cannot.
    template <class Keep>
    void find_in_tree(Real tree_skin, const Keep& keep)
    {
        const int K = static_cast<int>(boxes.size());
        if (tree.count() > K) tree.clear();  // bodies were taken away
        tree.skin = tree_skin;
        tree.tested = 0;
        for (int k = 0; k < K; ++k)
            tree.place(k, boxes[static_cast<std::size_t>(k)]);
        for (int k = 0; k < K; ++k) {
            if (!moves[static_cast<std::size_t>(k)]) continue;
            const Box& box = boxes[static_cast<std::size_t>(k)];
            tree.overlapping(box, [&](int b) {
                const bool first = b > k || !moves[static_cast<std::size_t>(b)];
                if (first && overlap(box, boxes[static_cast<std::size_t>(b)]))
                    keep(k, b);
            });
        }
        tested = tree.tested;
    }
    //! [find]
};

}  // namespace rigid
