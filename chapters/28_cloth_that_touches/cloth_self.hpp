/// \file cloth_self.hpp
/// Cloth against itself: a particle and a triangle, or two edges, with a thickness.
///
///     d = Σ wᵢ xᵢ,  Σ wᵢ = 0,   C = n·d − thickness ≥ 0,   ΔΛ = −C/A clamped so that Λ ≥ 0,   A = Σ wᵢ²/mᵢ          (28.3)
///
/// with the weights and the direction of the nearest points at the start of the sub-step. A row alone promises nothing. What
/// does is this: if the corners of one part move by less than r_a and those of the other by less than r_b, seen from any
/// translation, then so does every point of them, and
///
///     r_a + r_b < d   ⟹   they do not meet on the way                                                            (28.4)
///
/// A pair for which that fails is followed along its way in steps that (28.4) allows, and stops before it meets.
#pragma once

#include "chapters/28_cloth_that_touches/nearest_parts.hpp"
#include "chapters/28_cloth_that_touches/touching_cloth.hpp"

namespace rigid {

/// Two parts of a cloth and where they are nearest: weights +1 in all on the one, −1 on the other.
struct ClothParts {
    std::array<int, 4> p{};  ///< a particle and a triangle, or two edges
    bool edges = false;
};
struct ClothNear {
    std::array<Real, 4> w{};
    Vec3 d = {0, 0, 0};  ///< Σ wᵢ xᵢ [m]
};

/// The nearest points of four corners: a particle and a triangle, or two edges.
ClothNear nearest(const std::array<Vec3, 4>& x, bool edges);

/// Points in a grid of equal cells over all of them.
class PointGrid {
public:
    void fill(const std::vector<Vec3>& points, Real cell);
    /// Calls visit(i) for each point of the cells that a box meets, in ascending order
    /// within a cell.
    template <class Visit>
    void near(const Vec3& low, const Vec3& high, const Visit& visit) const
    {
        std::array<int, 3> from, to;
        for (int k = 0; k < 3; ++k)
            from[static_cast<std::size_t>(k)] = along(low[k], k),
            to[static_cast<std::size_t>(k)] = along(high[k], k);
        for (int z = from[2]; z <= to[2]; ++z)
            for (int y = from[1]; y <= to[1]; ++y) {
                const std::size_t row = cell_of(0, y, z);
                const int begin = first_[row + static_cast<std::size_t>(from[0])],
                          end = first_[row + static_cast<std::size_t>(to[0]) + 1];
                for (int i = begin; i < end; ++i)
                    visit(items_[static_cast<std::size_t>(i)]);
            }
    }

private:
    int along(Real at, int k) const
    {
        const Real cells = (at - low_[k]) / cell_;
        return cells > 0 ? static_cast<int>(std::min(
                               cells, static_cast<Real>(
                                          count_[static_cast<std::size_t>(k)] - 1)))
                         : 0;
    }
    std::size_t cell_of(int x, int y, int z) const
    {
        return static_cast<std::size_t>(x) +
               static_cast<std::size_t>(count_[0]) *
                   (static_cast<std::size_t>(y) +
                    static_cast<std::size_t>(count_[1]) *
                        static_cast<std::size_t>(z));
    }

    Vec3 low_ = {0, 0, 0};
    Real cell_ = 1;
    std::array<int, 3> count_{1, 1, 1};
    std::vector<int> first_, items_, cell_of_;
};

/// A row of (28.3).
struct ClothSelfRow {
    ClothParts parts;
    std::array<Real, 4> w{};
    Vec3 normal = {0, 1, 0};
    Vec3 from = {0, 0, 0};   ///< d at the start of the sub-step [m]
    Real A = 0;              ///< [1/kg]
    Real lambda = 0;         ///< Λ [N s²]
    Vec3 slide = {0, 0, 0};  ///< Λ_t [N s²]
};

class ClothSelf {
public:
    std::vector<ClothSelfRow> rows;
    // Counted since the memory was made.
    std::int64_t found = 0;    ///< times that all pairs were found again
    std::int64_t tested = 0;   ///< pairs whose distance was computed for that
    std::int64_t stopped = 0;  ///< particles that stopped before they met
    /// pairs that cannot be promised: at a distance of nothing, or between pins that
    /// would not stop
    std::int64_t unsure = 0;
    /// the last sub-step went beyond reach: it listed or looked at more pairs than it
    /// may, or its ways are no numbers, and all particles went with their mean
    bool lost = false;
    /// in a sub-step, for each particle, edge and triangle; a cloth that falls into
    /// folds lists up to 20 and looks at some thousands, with stops
    static constexpr std::int64_t most_listed = 100, most_looks = 10000;
    std::size_t pairs() const { return pairs_.size(); }

    /// For a cloth whose triangles have changed.
    void prepare(const TouchingCloth& cloth);
    /// The rows of a sub-step from x0, where y is where it would end without rows.
    void begin(const TouchingCloth& cloth, const VecX& x0, const VecX& y);
    /// One visit of each row, normal then disc.
    void visit(const TouchingCloth& cloth, VecX& x);
    /// (28.5), as ClothTouch's.
    void rest_in_the_middle(TouchingCloth& cloth, Real h, const VecX& u0) const;
    /// What pushed an overlap out is no velocity: parts that were pushed do not part.
    void calm(TouchingCloth& cloth) const;
    /// Stops what would meet on the straight way from x0 to x. Velocities stay.
    void stop(const TouchingCloth& cloth, const VecX& x0, VecX& x);

private:
    /// A particle, a triangle or an edge, and its way.
    struct Part {
        Vec3 middle = {0, 0, 0}, way = {0, 0, 0};
        Real radius = 0;  ///< around its middle [m]
        Real spread = 0;  ///< of the ways of its corners around its own [m]
    };
    template <std::size_t N>
    Part part_of(const std::array<int, N>& p, const VecX& x, const VecX& way) const;
    void find(const VecX& x, const VecX& way, Real extra);
    bool add(const ClothParts& parts, const Part& a, const Part& b, const VecX& x,
             Real extra);
    Real strayed(const VecX& x);
    void count_halted()
    {
        for (const char one : halted_) stopped += one;
    }
    bool beyond() const
    {
        return looks_ > most_looks * parts_count_ ||
               std::ssize(pairs_) > most_listed * parts_count_;
    }
    Real free_part(const ClothParts& parts, const VecX& x0, const VecX& x);
    bool halt_pairs(const TouchingCloth& cloth, const VecX& x0, VecX& x,
                    const Vec3& all);

    std::vector<std::array<int, 2>> edges_;
    std::vector<std::array<int, 3>> triangles_;
    Real shortest_ = 0;  ///< spring [m]
    PointGrid grid_;
    std::vector<Vec3> points_;
    std::vector<Part> parts_, others_;
    std::vector<ClothParts> pairs_;
    std::vector<ClothNear> near_;  ///< of each pair, at the start of the sub-step
    // of the list: where it was made, the ways of a sub-step that it was made for, how
    // many of them, and how far all may stray from that [m]
    VecX found_at_, planned_, way_;
    int age_ = 0, horizon_ = 0;
    Real slack_ = 0;
    std::vector<char> halted_;
    std::int64_t looks_ = 0, parts_count_ = 0;  ///< of this sub-step; of this cloth
};

}  // namespace rigid
