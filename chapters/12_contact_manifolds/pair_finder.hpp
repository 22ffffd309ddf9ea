/// \file pair_finder.hpp
/// Which pairs of bodies are to be looked at: their boxes overlap (in the grid also the circles around them), one of them
/// can move, no joint keeps them apart, and the filter lets them meet.
#pragma once

#include "chapters/10_skipping_work/collision_filter.hpp"
#include "chapters/10_skipping_work/disc_grid.hpp"
#include "chapters/12_contact_manifolds/box_sweep.hpp"
#include "chapters/12_contact_manifolds/box_tree.hpp"

namespace rigid {

enum class PairSearch { sweep, tree, grid };

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
    /// of the shapes, with half the margin and their reach around them
    std::vector<Box> boxes;
    /// of each body: how far ahead it looks, 0 = not at all; empty = none does [m]
    std::vector<Real> reach;
    std::vector<char> moves;
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
        return (moves[static_cast<std::size_t>(a)] ||
                moves[static_cast<std::size_t>(b)]) &&
               (filter.meets[static_cast<std::size_t>(filter.group_of(a))] >>
                    filter.group_of(b) &
                1) != 0 &&
               !filter.forbids(std::min(a, b), std::max(a, b)) &&
               !std::binary_search(joined.begin(), joined.end(), pair_key(a, b));
    }

    Real reach_of(std::size_t k) const { return k < reach.size() ? reach[k] : 0; }

    //! [find]
    /// All pairs of a scene. Of two that may touch, one can move: the others only
    /// wait to be found.
    void find(const RigidScene& scene, const PlacedShapes& placed, Real margin)
    {
        movers_.clear();
        for (Index k = 0; k < scene.bodies.count(); ++k)
            if (scene.bodies.can_move(k)) movers_.push_back(static_cast<int>(k));
        boxes.clear();
        find(scene, placed, margin, movers_);
    }

    /// The pairs that some bodies make, with each other and with all others.
    /// \param looking  ascending; the others are where they were in the last call
    void find(const RigidScene& scene, const PlacedShapes& placed, Real margin,
              std::span<const int> looking)
    {
        take_in(scene, placed, margin, looking);
        pairs.clear();
        const auto keep = [&](int a, int b) {
            if (may_touch(a, b)) pairs.push_back(pair_key(a, b));
        };
        if (search == PairSearch::sweep) {
            overlapping_pairs(boxes, sweep, [&](int a, int b) {
                if (is(asks, a) || is(asks, b)) keep(a, b);
            });
            tested = sweep.tested;
        } else if (search == PairSearch::tree) find_in_tree(keep);
        else find_in_grid(keep);
        std::sort(pairs.begin(), pairs.end());
    }

    /// Each body that looks finds those behind it, and those that do not look.
    template <class Keep>
    void find_in_tree(const Keep& keep)
    {
        tree.tested = 0;
        for (const int k : asked) {
            const Box& box = boxes[static_cast<std::size_t>(k)];
            tree.overlapping(box, [&](int b) {
                if ((b > k || !is(asks, b)) &&
                    overlap(box, boxes[static_cast<std::size_t>(b)]))
                    keep(k, b);
            });
        }
        tested = tree.tested;
    }
    //! [find]

    //! [find_in_grid]
    /// The same by chapter 10's grid of the circles around the bodies.
    template <class Keep>
    void find_in_grid(const Keep& keep)
    {
        grid.tested = grid.cells = 0;
        for (const int k : asked) {
            const auto at = static_cast<std::size_t>(k);
            grid.near(grid.position(k), circles[at], ~std::uint64_t{0}, [&](int b) {
                if ((b > k || !is(asks, b)) &&
                    overlap(boxes[at], boxes[static_cast<std::size_t>(b)]))
                    keep(std::min(k, b), std::max(k, b));
            });
        }
        tested = grid.tested;
    }
    //! [find_in_grid]

private:
    std::vector<int> movers_;
    Real margin_ = 0;  ///< of the boxes [m]
    PairSearch searched_ = PairSearch::tree;

    static bool is(const std::vector<char>& list, int k)
    {
        return list[static_cast<std::size_t>(k)] != 0;
    }

    /// Boxes, tree and joints as they are now.
    void take_in(const RigidScene& scene, const PlacedShapes& placed, Real margin,
                 std::span<const int> looking)
    {
        const auto K = static_cast<std::size_t>(scene.bodies.count());
        const bool all =
            boxes.size() != K || margin != margin_ || search != searched_;
        searched_ = search;
        if (tree.count() > static_cast<int>(K))
            tree.clear();  // some were taken away
        if (search == PairSearch::grid && circles.size() != K) {
            circles.assign(K, 0);
            grid.reset(scene.bodies.count(), 0);
        }
        tree.skin = skin * margin;
        margin_ = margin;
        const auto take = [&](std::size_t k) {
            boxes[k] = grown(placed.boxes[k], margin / 2 + reach_of(k));
            moves[k] = scene.bodies.can_move(static_cast<Index>(k));
            if (search == PairSearch::grid)
                put_in_grid(scene, static_cast<Index>(k), margin);
            else if (search == PairSearch::tree)
                tree.place(static_cast<int>(k), boxes[k]);
        };
        boxes.resize(K);
        moves.resize(K);
        asks.resize(K);
        for (const int k : asked)
            if (static_cast<std::size_t>(k) < K)
                asks[static_cast<std::size_t>(k)] = 0;
        asked.assign(looking.begin(), looking.end());
        for (const int k : asked) asks[static_cast<std::size_t>(k)] = 1;
        for (std::size_t k = 0; all && k < K; ++k) take(k);
        for (const int k : asked)
            if (!all) take(static_cast<std::size_t>(k));
        list_joints(scene);
    }

    /// A body whose shape has changed is entered again.
    void put_in_grid(const RigidScene& scene, Index k, Real margin)
    {
        const auto at = static_cast<std::size_t>(k);
        const Polygon& shape = scene.shapes[at];
        Real circle = 0;
        for (const Vec2& vertex : shape.vertices)
            circle = std::max(circle, vertex.norm());
        circle += shape.radius + margin / 2 + reach_of(at);
        const int body = static_cast<int>(k);
        const Vec2 x = scene.bodies.position(k).head<2>();
        if (circles[at] == circle) grid.move(body, x);
        else {
            if (circles[at] > 0) grid.remove(body);
            circles[at] = circle;
            grid.insert(body, x, circle, 0);
        }
    }

    /// Sorted again only when they are not those of the step before.
    void list_joints(const RigidScene& scene)
    {
        std::size_t count = 0;
        bool same = true;
        for (const PointJoint& joint : scene.joints) {
            if (joint.a == world || joint.collides) continue;
            const std::uint64_t key = pair_key(joint.a, joint.b);
            if (count == joints.size()) joints.push_back(~key);
            same = same && joints[count] == key;
            joints[count++] = key;
        }
        same = same && count == joined.size();
        joints.resize(count);
        if (same) return;
        joined = joints;
        std::sort(joined.begin(), joined.end());
    }
};

}  // namespace rigid
