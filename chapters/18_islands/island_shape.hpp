/// \file island_shape.hpp
/// What an island looks like to a solver: how many rows, how long, how uneven its masses, how many loops; and from
/// these, what sweeps over it would cost and what an exact solve, in one unit.
///
///     sweeps needed  ≈  N² r                           N bodies from the ground to the farthest one, r largest mass over smallest   (18.1)
///     by sweeps      ≈  8 n N² r                       entries of matrices, n rows; a row visited counts as 8                        (18.2)
///     with momentum  ≈  2·2 n·20 √(N (N + r − 1))      entries, in lanes, a sweep with momentum taken for two                        (18.2a)
///     exactly        ≈  250 m²/k + 3 m³/k^(3/2) + …    m rows with bounds, k bodies, of which joints make one; and its joints        (18.3)
///
/// N links in a row need a number of sweeps that grows with N² (4.11), a heavy body on a light one as many times more as it
/// is heavier (chapter 4). The rows of a heap in the plane are factored in about m³/k^(3/2). \cite george1973
#pragma once

#include "chapters/10_skipping_work/islands.hpp"
#include "chapters/15_trees/joint_tree.hpp"
#include "chapters/18_islands/solving.hpp"

#include <cmath>

namespace rigid {

//! [shape]
struct IslandShape {
    int bodies = 0;  ///< that can move
    int rows = 0;
    int bounded = 0;  ///< m, rows with bounds: contacts, friction, limits, motors
    int loops = 0;    ///< rows of joints that close loops
    int parts = 0;    ///< k, bodies, those that joints hold together taken for one
    int length = 0;   ///< N
    Real mass_ratio = 1;

    bool has_joints() const { return rows > bounded; }
    Real sweeps_needed() const { return Real(length) * length * mass_ratio; }
    Real sweeps_with_momentum() const;
    Real price_of_sweeps() const;
    Real price_of_loops() const;
    Real price_of_exact() const;
};

/// (18.2a)
inline Real IslandShape::sweeps_with_momentum() const
{
    return 20 * std::sqrt(length * (length + mass_ratio - 1));
}
/// (18.2) [entries]
inline Real IslandShape::price_of_sweeps() const
{
    return price::visit * rows * sweeps_needed();
}
/// (18.3), its last two terms: what closes loops of joints
inline Real IslandShape::price_of_loops() const
{
    const Real l = loops;
    return 10 * l * (rows - bounded) + l * l * l / 6;
}
/// (18.3) [entries]
inline Real IslandShape::price_of_exact() const
{
    const Real m = bounded, k = std::max(1, parts);
    const Real heap = 250 * m * m / k + 3 * m * m * m / (k * std::sqrt(k) + 2 * k);
    return heap + 600 * (rows - bounded) + price_of_loops();
}
//! [shape]

/// Looks at islands one after the other; keeps its memory.
class IslandSurveyor {
public:
    /// \param rows  of the step; `members` are those of the island, in their order
    IslandShape operator()(const Bodies<3>& bodies, const std::vector<Row<3>>& rows,
                           std::span<const int> members,
                           std::span<const int> island_bodies)
    {
        IslandShape shape;
        shape.bodies = static_cast<int>(island_bodies.size());
        shape.rows = static_cast<int>(members.size());
        const auto K = static_cast<std::size_t>(bodies.count());
        if (parent_.size() != K + 1) {
            parent_.resize(K + 1);
            depth_.resize(K + 1);
            first_.resize(K + 1);
        }
        ground_ = static_cast<int>(K);
        Real least = infinity, most = 0;
        for (const int k : island_bodies) {
            const Real m = bodies.inverse_mass[3 * k];
            least = std::min(least, m), most = std::max(most, m);
            enter(k);
        }
        enter(ground_);
        if (least > 0) shape.mass_ratio = most / least;
        shape.parts = shape.bodies;
        count_loops(rows, members, shape);
        shape.length = longest(rows, members, island_bodies);
        return shape;
    }

private:
    int& at(std::vector<int>& list, int k)
    {
        return list[static_cast<std::size_t>(k)];
    }
    void enter(int k)
    {
        at(parent_, k) = k;
        at(depth_, k) = -1;
        at(first_, k) = -1;
    }
    int a_of(const Row<3>& row) const
    {
        return moves_a(row) ? static_cast<int>(row.a) : ground_;
    }
    int b_of(const Row<3>& row) const
    {
        return moves_b(row) ? static_cast<int>(row.b) : ground_;
    }

    /// Whether what bounds a row joins the same two bodies.
    bool is_beside_its_bound(const std::vector<Row<3>>& rows,
                             const Row<3>& row) const
    {
        if (row.bounded_by < 0) return false;
        const Row<3>& bound = rows[static_cast<std::size_t>(row.bounded_by)];
        return a_of(bound) == a_of(row) && b_of(bound) == b_of(row);
    }

    /// The rows of joints between two bodies that others join already.
    void count_loops(const std::vector<Row<3>>& rows, std::span<const int> members,
                     IslandShape& shape)
    {
        int last_a = -1, last_b = -1;
        bool closes = false;
        for (const int i : members) {
            const Row<3>& row = rows[static_cast<std::size_t>(i)];
            if (!JointTree::takes(row)) {
                ++shape.bounded;
                continue;
            }
            const int a = a_of(row), b = b_of(row);
            if (a != last_a || b != last_b) {
                closes = lowest_of(parent_, a) == lowest_of(parent_, b);
                if (!closes) unite(parent_, a, b);
                shape.parts -= !closes && a != ground_ && b != ground_;
            }
            shape.loops += closes;
            last_a = a, last_b = b;
        }
    }

    /// The longest of all shortest ways from the ground, counted in bodies; of an
    /// island that floats, from its first body.
    int longest(const std::vector<Row<3>>& rows, std::span<const int> members,
                std::span<const int> island_bodies)
    {
        // the rows of each body, as lists through `next_`
        next_.clear();
        other_.clear();
        const auto hang = [&](int k, int other) {
            next_.push_back(at(first_, k));
            other_.push_back(other);
            at(first_, k) = static_cast<int>(next_.size()) - 1;
        };
        int last_a = -1, last_b = -1;
        for (const int i : members) {
            const Row<3>& row = rows[static_cast<std::size_t>(i)];
            const int a = a_of(row), b = b_of(row);
            if (is_beside_its_bound(rows, row) || (a == last_a && b == last_b))
                continue;
            hang(a, b);
            hang(b, a);
            last_a = a, last_b = b;
        }
        queue_.clear();
        const bool floats = at(first_, ground_) < 0;
        const int start = floats ? island_bodies[0] : ground_;
        at(depth_, start) = floats ? 1 : 0;
        queue_.push_back(start);
        for (std::size_t i = 0; i < queue_.size(); ++i)
            for (int p = at(first_, queue_[i]); p >= 0; p = at(next_, p)) {
                const int k = at(other_, p);
                if (at(depth_, k) >= 0) continue;
                at(depth_, k) = at(depth_, queue_[i]) + 1;
                queue_.push_back(k);
            }
        return at(depth_, queue_.back());
    }

    int ground_ = 0;
    std::vector<int> parent_, depth_, first_, next_, other_, queue_;
};

}  // namespace rigid
