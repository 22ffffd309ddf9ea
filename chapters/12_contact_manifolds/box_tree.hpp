/// \file box_tree.hpp
/// A tree of boxes: each node's box contains those of its two children, each leaf is one body's.
///
///     a box that does not overlap a node's box overlaps nothing below it
///
/// A leaf's box is its body's, grown by a skin; a body that stays inside it costs nothing. A new leaf goes where the
/// perimeters of all boxes grow least, and on the way back up a child changes places with a grandchild wherever that makes a box
/// smaller. \cite goldsmith1987 \cite kopta2012
#pragma once

#include "chapters/12_contact_manifolds/boxes.hpp"

#include <cstdint>
#include <utility>
#include <vector>

namespace rigid {

/// \tparam Box  with overlap(), contains(), joined(), grown() and perimeter(): chapter 18 has boxes in space
template <class Box>
class BoxTreeOf {
public:
    static constexpr int nobody = -1;
    Real skin = 0;  ///< how far a body may move before its leaf does [m]
    /// boxes looked at since the caller last set this to zero
    mutable std::int64_t tested = 0;

    struct Node {
        Box box;
        int parent = nobody, left = nobody, right = nobody;
        int item = nobody;  ///< of a leaf
        bool is_leaf() const { return left == nobody; }
    };

    void clear()
    {
        nodes_.clear();
        leaf_.clear();
        free_ = root_ = nobody;
    }
    int count() const { return static_cast<int>(leaf_.size()); }
    const Node& node(int i) const { return nodes_[static_cast<std::size_t>(i)]; }
    int root() const { return root_; }
    /// The box of an item's leaf.
    const Box& leaf_of(int item) const
    {
        return node(leaf_[static_cast<std::size_t>(item)]).box;
    }

    //! [place]
    /// Puts the box of an item in, or moves it. Items are numbered from 0.
    /// \return  false if it is still within its skin
    bool place(int item, const Box& box)
    {
        if (item >= count())
            leaf_.resize(static_cast<std::size_t>(item) + 1, nobody);
        int& leaf = leaf_[static_cast<std::size_t>(item)];
        if (leaf != nobody) {
            if (contains(at(leaf).box, box)) return false;
            take_out(leaf);
        } else {
            leaf = fresh();
            at(leaf).item = item;
        }
        at(leaf).box = grown(box, skin);
        put_in(leaf);
        return true;
    }
    //! [place]

    void remove(int item)
    {
        int& leaf = leaf_[static_cast<std::size_t>(item)];
        take_out(leaf);
        give_back(leaf);
        leaf = nobody;
    }

    //! [query]
    /// Calls visit(item) for each leaf whose box fulfils touches(box), and looks
    /// below a node only if its box does.
    template <class Touches, class Visit>
    void search(const Touches& touches, const Visit& visit) const
    {
        if (root_ == nobody) return;
        // a node waits once at most; a search within a search goes on above
        const std::size_t bottom = waiting_;
        if (stack_.size() < bottom + nodes_.size())
            stack_.resize(bottom + nodes_.size());
        stack_[waiting_++] = root_;
        while (waiting_ > bottom) {
            const Node& here = node(stack_[--waiting_]);
            ++tested;
            if (!touches(here.box)) continue;
            if (here.is_leaf()) {
                visit(here.item);
                continue;
            }
            stack_[waiting_++] = here.right;
            stack_[waiting_++] = here.left;
        }
    }
    template <class Visit>
    void overlapping(const Box& box, const Visit& visit) const
    {
        search([&](const Box& other) { return overlap(box, other); }, visit);
    }
    //! [query]

private:
    Node& at(int i) { return nodes_[static_cast<std::size_t>(i)]; }

    int fresh()
    {
        if (free_ == nobody) {
            nodes_.push_back({});
            return static_cast<int>(nodes_.size()) - 1;
        }
        const int i = free_;
        free_ = at(i).parent;
        at(i) = {};
        return i;
    }
    void give_back(int i)
    {
        at(i) = {};
        at(i).parent = free_;
        free_ = i;
    }
    void replace_child(int parent, int old, int by)
    {
        if (parent == nobody) root_ = by;
        else (at(parent).left == old ? at(parent).left : at(parent).right) = by;
        if (by != nobody) at(by).parent = parent;
    }

    //! [put_in]
    /// Goes down to where a pair with the new leaf makes the boxes grow least.
    void put_in(int leaf)
    {
        const Box box = at(leaf).box;
        if (root_ == nobody) {
            root_ = leaf;
            at(leaf).parent = nobody;
            return;
        }
        int here = root_;
        while (!at(here).is_leaf()) {
            // a pair here: its box, and what all above it grow by, which is the same
            // for all places below
            const Real both = perimeter(joined(at(here).box, box));
            const Real inherited = both - perimeter(at(here).box);
            const auto cost = [&](int child) {
                const Real grown_to = perimeter(joined(at(child).box, box));
                return inherited + grown_to -
                       (at(child).is_leaf() ? 0 : perimeter(at(child).box));
            };
            const int left = at(here).left, right = at(here).right;
            const Real cost_left = cost(left), cost_right = cost(right);
            if (both <= cost_left && both <= cost_right) break;
            here = cost_left <= cost_right ? left : right;
        }
        const int parent = at(here).parent, pair = fresh();
        replace_child(parent, here, pair);
        at(pair).left = here, at(pair).right = leaf;
        at(here).parent = at(leaf).parent = pair;
        at(pair).box = joined(at(here).box, box);
        for (int up = parent; up != nobody; up = at(up).parent) {
            at(up).box = joined(at(at(up).left).box, at(at(up).right).box);
            rotate(up);
        }
    }
    //! [put_in]

    void take_out(int leaf)
    {
        const int parent = at(leaf).parent;
        if (parent == nobody) {
            root_ = nobody;
            return;
        }
        const int other =
            at(parent).left == leaf ? at(parent).right : at(parent).left;
        const int above = at(parent).parent;
        replace_child(above, parent, other);
        give_back(parent);
        for (int up = above; up != nobody; up = at(up).parent)
            at(up).box = joined(at(at(up).left).box, at(at(up).right).box);
    }

    //! [rotate]
    /// A child of `here` changes places with a child of the other, if that makes the
    /// other's box smaller: the best of four.
    void rotate(int here)
    {
        Real best = 0;
        int up = nobody, down = nobody;
        for (const bool swapped : {false, true}) {
            const int stays = swapped ? at(here).right : at(here).left,
                      other = swapped ? at(here).left : at(here).right;
            if (at(other).is_leaf()) continue;
            for (const bool second : {false, true}) {
                const int goes = second ? at(other).right : at(other).left,
                          keeps = second ? at(other).left : at(other).right;
                const Real gain = perimeter(at(other).box) -
                                  perimeter(joined(at(stays).box, at(keeps).box));
                if (gain > best) best = gain, up = goes, down = stays;
            }
        }
        if (up == nobody) return;
        const int other = at(up).parent;
        replace_child(here, down, up);
        replace_child(other, up, down);
        at(other).box = joined(at(at(other).left).box, at(at(other).right).box);
    }
    //! [rotate]

    std::vector<Node> nodes_;
    std::vector<int> leaf_;            ///< of each item
    mutable std::vector<int> stack_;   ///< nodes to be looked at
    mutable std::size_t waiting_ = 0;  ///< so many of them
    int root_ = nobody, free_ = nobody;
};

using BoxTree = BoxTreeOf<Box>;

}  // namespace rigid
