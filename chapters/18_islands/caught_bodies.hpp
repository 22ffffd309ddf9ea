/// \file caught_bodies.hpp
/// More visits where the last ones have changed much, and nowhere else.
///
/// Of a packet all lanes are visited again, so what comes of it depends on how many lanes there are.
#pragma once

#include "chapters/17_wide_sweeps/wide_sweep.hpp"

#include <utility>

namespace rigid {

/// A body that is caught between others gets more from a small step than a few visits settle. So what visits change is noted
/// with its bodies, and the packets of these are visited again.
class CaughtBodies {
    static constexpr int lanes = full_lanes<Real>;
    using V = Lanes<Real, lanes>;
    using Wide = WideRows<3, Real, lanes>;

public:
    //! [caught]
    /// Visits each packet. Returns whether a row was off by more than this [m/s].
    /// \param bodies  K; further ones are those of empty lanes
    /// \param before  (packet number): what is done to its rows before
    template <class Before>
    bool visit_all(Real until, Index bodies, Wide& wide, const Before& before)
    {
        begin(bodies, wide);
        bool off = false;
        for (std::size_t p = 0; p < wide.packets.size(); ++p) {
            before(p);
            off |= visit(p, until, wide);
        }
        return off;
    }

    /// Visits packets of bodies that this pass or the one before has changed by more.
    bool visit_near(Real until, Wide& wide);
    //! [caught]

    /// Rows visited since the last time.
    std::int64_t take_visits() { return std::exchange(visits_, 0); }

private:
    int& since(int body) { return since_[static_cast<std::size_t>(body)]; }

    void begin(Index bodies, const Wide& wide);
    bool is_near(const Packet<lanes>& packet);
    bool visit(std::size_t p, Real until, Wide& wide);

    std::vector<int>
        since_;  ///< of each body the last pass that changed it by more
    int pass_ = 0, bodies_ = 0;
    std::int64_t visits_ = 0;
};

}  // namespace rigid
