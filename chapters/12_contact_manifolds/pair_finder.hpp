/// \file pair_finder.hpp
/// Which pairs of bodies are to be looked at: their boxes overlap (in the grid also the circles around them), one of them
/// can move, no joint keeps them apart, and the filter lets them meet.
#pragma once

#include "chapters/10_skipping_work/collision_filter.hpp"
#include "chapters/10_skipping_work/disc_grid.hpp"
#include "chapters/12_contact_manifolds/box_sweep.hpp"
#include "chapters/12_contact_manifolds/box_tree.hpp"

#include <functional>

namespace rigid {

enum class PairSearch { sweep, tree, grid };

inline std::uint64_t pair_key(Index a, Index b)
{
    return static_cast<std::uint64_t>(std::min(a, b)) << 32 |
           static_cast<std::uint64_t>(std::max(a, b));
}

inline std::pair<int, int> bodies_of(std::uint64_t pair)
{
    return {static_cast<int>(pair >> 32), static_cast<int>(pair & 0xffffffffu)};
}

struct PairFinder {
    CollisionFilter filter;
    PairSearch search = PairSearch::tree;
    Real skin = 5;  ///< of the boxes in the tree [margins]
    /// a < b: is asked last whether two bodies may touch; empty = they may
    std::function<bool(int, int)> lets;

    // What is kept from step to step.
    /// of the shapes, with half the margin and their reach around them
    std::vector<Box> boxes;
    /// of each body: how far ahead it looks, 0 = not at all; empty = none does [m]
    std::vector<Real> reach;
    std::vector<char> moves;
    /// the body that each shape is of; empty = each is of its own
    std::vector<Index> whole;
    /// 1: the body looks for others; 0: it is only found
    std::vector<char> asks;
    /// a · 2³² + b of each joint whose bodies may not touch, as it comes, and ascending
    std::vector<std::uint64_t> joints, joined;
    std::vector<std::uint64_t> pairs;  ///< the answer, ascending
    BoxSweep sweep;
    BoxTree tree;
    DiscGrid grid;
    /// of each body: its circle about the centroid, with half the margin [m]
    std::vector<Real> circles;
    std::vector<int> asked;   ///< those that look
    std::int64_t tested = 0;  ///< boxes compared in this step

    bool may_touch(int a, int b) const
    {
        const Index body_a = whole_of(a), body_b = whole_of(b);
        return (moves[static_cast<std::size_t>(a)] ||
                moves[static_cast<std::size_t>(b)]) &&
               body_a != body_b && filter.lets_meet(a, b) &&
               !filter.forbids(std::min(a, b), std::max(a, b)) &&
               !std::binary_search(joined.begin(), joined.end(),
                                   pair_key(body_a, body_b)) &&
               (!lets || lets(std::min(a, b), std::max(a, b)));
    }
    Index whole_of(int k) const
    {
        return whole.empty() ? k : whole[static_cast<std::size_t>(k)];
    }

    Real reach_of(std::size_t k) const { return k < reach.size() ? reach[k] : 0; }

    /// All pairs of a scene. Of two that may touch, one can move: the others only
    /// wait to be found.
    void find(const RigidScene& scene, const PlacedShapes& placed, Real margin);

    /// The pairs that some bodies make, with each other and with all others.
    /// \param looking  ascending; the others are where they were in the last call
    void find(const RigidScene& scene, const PlacedShapes& placed, Real margin,
              std::span<const int> looking);

    /// Between two calls: the box of shape k is here now.
    void place(int k, const Box& box)
    {
        if (tree.place(k, box)) placed_.push_back(k);
    }

    /// Calls visit(k) for each body whose box, as the last call found it, overlaps.
    template <class Visit>
    void near(const Box& box, const Visit& visit) const
    {
        if (searched_ == PairSearch::tree) {
            tree.overlapping(box, visit);
            return;
        }
        for (std::size_t k = 0; k < boxes.size(); ++k)
            if (overlap(box, boxes[k])) visit(static_cast<int>(k));
    }

private:
    std::vector<int> movers_;
    /// of leaves that overlap, of bodies of which one looks, ascending: they change
    /// only where a leaf does, or another body looks
    std::vector<std::uint64_t> near_, fresh_, merged_;
    std::vector<int> renewed_;  ///< bodies with such a change in this call
    std::vector<char> is_renewed_;
    std::vector<int> placed_;  ///< between two calls
    Real margin_ = 0;          ///< of the boxes [m]
    PairSearch searched_ = PairSearch::tree;

    static bool is(const std::vector<char>& list, int k)
    {
        return list[static_cast<std::size_t>(k)] != 0;
    }

    /// Pairs of leaves are kept from call to call; of those the boxes are compared.
    template <class Keep>
    void find_in_tree(const Keep& keep);

    /// The same by chapter 10's grid of the circles around the bodies.
    template <class Keep>
    void find_in_grid(const Keep& keep);

    /// Boxes, tree and joints as they are now.
    void take_in(const RigidScene& scene, const PlacedShapes& placed, Real margin,
                 std::span<const int> looking);

    void renew(int k);

    /// A body whose shape has changed is entered again.
    void put_in_grid(const RigidScene& scene, Index k, Real margin);

    /// Sorted again only when they are not those of the step before.
    void list_joints(const RigidScene& scene);
};

}  // namespace rigid
