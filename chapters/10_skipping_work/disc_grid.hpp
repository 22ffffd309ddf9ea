/// \file disc_grid.hpp
/// Which discs are near each other: a grid of square cells that has no edges, and a layer of it for each size of disc.
///
///     cell of a layer c = 2^l ≥ 2 r + extra,   disc k is in the cell (⌊x/c⌋, ⌊y/c⌋) of its own layer
///
/// (10.3). A disc whose surface is within reach R of a point can only stand in the cells from ⌊(x − R − r)/c⌋ to
/// ⌊(x + R + r)/c⌋, for r the largest radius of the layer: for two of one size three along each axis, or four where x is
/// on the edge of a cell and rounding adds one. Cells are not stored: a hash puts them on a table of 2K or more lists
/// \cite teschner2003. Putting in, taking out and moving cost the same however many discs there are, so a sleeper costs
/// nothing.
#pragma once

#include "common/math.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace rigid {

class DiscGrid {
public:
    /// cells looked into since the caller last set this to zero
    std::int64_t cells = 0;
    std::int64_t tested = 0;  ///< discs whose distance was computed

    /// Empties the grid and makes room for discs 0 … count − 1.
    /// \param extra  how far beyond its own radius a disc will usually look [m]
    void reset(Index count, Real extra);

    /// Makes room for discs up to count − 1. The table grows when it has become too short, and all are entered again.
    void grow(Index count);

    /// \param group  discs of different groups stand in different layers
    void insert(int k, const Vec2& x, Real radius, int group);

    void remove(int k);

    bool contains(int k) const
    {
        return places_[static_cast<std::size_t>(k)].layer != nobody;
    }
    const Vec2& position(int k) const
    {
        return places_[static_cast<std::size_t>(k)].x;
    }

    void move(int k, const Vec2& x)
    {
        Place& place = at(k);
        const Layer& layer = layers_[static_cast<std::size_t>(place.layer)];
        place.x = x;
        const int column = cell(x.x(), layer), line = cell(x.y(), layer);
        if (column == place.column && line == place.line) return;
        leave(k);
        enter(k, column, line);
    }

    //! [near]
    /// Calls visit(b) for each disc b whose surface is less than `reach` away from
    /// x, or a billionth more, so that rounding loses none; in no particular order.
    /// \param groups  bit g: discs of group g are looked for
    /// \param visit   must not change the grid
    template <class Visit>
    void near(const Vec2& x, Real reach, std::uint64_t groups, const Visit& visit)
    {
        for (std::size_t l = 0; l < layers_.size(); ++l) {
            const Layer& layer = layers_[l];
            if (layer.members.empty() || (groups >> layer.group & 1) == 0) continue;
            const Real around = (reach + layer.largest) * (1 + 1e-9);
            const auto test = [&](int b, const Place& place) {
                ++tested;
                const Real close = (reach + place.radius) * (1 + 1e-9);
                if ((place.x - x).squaredNorm() < close * close) visit(b);
            };
            const int left = cell(x.x() - around, layer),
                      right = cell(x.x() + around, layer);
            const int low = cell(x.y() - around, layer),
                      high = cell(x.y() + around, layer);
            const std::int64_t wide = std::int64_t{right} - left + 1,
                               tall = std::int64_t{high} - low + 1;
            // A giant over many small cells: then it is quicker to ask the small
            // ones one by one.
            if (wide * tall > 8 + static_cast<std::int64_t>(layer.members.size())) {
                for (const int b : layer.members) test(b, at(b));
                continue;
            }
            cells += wide * tall;
            for (int line = low; line <= high; ++line)
                for (int column = left; column <= right; ++column)
                    for (int b =
                             buckets_[bucket(static_cast<int>(l), column, line)];
                         b != nobody;) {
                        const Place& place = at(b);
                        if (place.column == column && place.line == line &&
                            place.layer == static_cast<int>(l))
                            test(b, place);
                        b = place.next;
                    }
        }
    }
    //! [near]

private:
    static constexpr int nobody = -1;

    struct Place {
        Vec2 x = {0, 0};
        Real radius = 0;
        int column = 0, line = 0;  ///< the cell
        int layer = nobody;
        int next = nobody, before = nobody;  ///< in the same list
        /// where in the layer's list of members
        int member = 0;
    };
    struct Layer {
        int group = 0;
        int level = 0;       ///< the cell is 2^level wide
        Real per_metre = 1;  ///< 1 / cell, exact
        Real largest = 0;    ///< largest radius that ever stood here [m]
        std::vector<int> members;
    };

    Place& at(int k) { return places_[static_cast<std::size_t>(k)]; }

    /// Rounded down, and held where an int can follow. Holding never puts two neighbours farther apart. A
    /// coordinate that is not a number goes to the end.
    static int cell(Real x, const Layer& layer)
    {
        constexpr Real far = 1 << 30;
        const Real c = std::floor(x * layer.per_metre);
        return static_cast<int>(c > -far ? (c < far ? c : far) : -far);
    }

    /// Cells that are side by side are side by side in the table, too.
    std::size_t bucket(int layer, int column, int line) const;

    int layer_of(int group, Real radius);

    void enter(int k, int column, int line);

    void leave(int k)
    {
        const Place& place = at(k);
        if (place.next != nobody) at(place.next).before = place.before;
        if (place.before != nobody) at(place.before).next = place.next;
        else buckets_[bucket(place.layer, place.column, place.line)] = place.next;
    }

    Real extra_ = 0;
    /// first disc of each list; the size is a power of two
    std::vector<int> buckets_;
    std::vector<Place> places_;
    std::vector<Layer> layers_;
};

}  // namespace rigid
