// The functions of caught_bodies.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/18_islands/caught_bodies.hpp"

#include <algorithm>

namespace rigid {

void CaughtBodies::begin(Index bodies, const Wide& wide)
{
    bodies_ = static_cast<int>(bodies);
    since_.assign(wide.u.size(), 0);
    pass_ = 2;
}

//! [near]
bool CaughtBodies::visit_near(Real until, Wide& wide)
{
    ++pass_;
    bool off = false;
    for (std::size_t p = 0; p < wide.packets.size(); ++p)
        if (is_near(wide.packets[p])) off |= visit(p, until, wide);
    return off;
}

bool CaughtBodies::is_near(const Packet<lanes>& packet)
{
    const auto changed = [&](int body) { return since(body) >= pass_ - 1; };
    return std::any_of(packet.a.begin(), packet.a.end(), changed) ||
           std::any_of(packet.b.begin(), packet.b.end(), changed);
}
//! [near]

bool CaughtBodies::visit(std::size_t p, Real until, Wide& wide)
{
    const Packet<lanes>& packet = wide.packets[p];
    const auto row = static_cast<std::size_t>(packet.first);
    V off{};
    visit_packet<3, Real, lanes>(packet, &wide.rows[row], &wide.shapes[row],
                                 wide.inverse[p], until, wide.u.data(), off);
    visits_ += packet.rows * std::count_if(packet.a.begin(), packet.a.end(),
                                           [&](int k) { return k < bodies_; });
    if (!(largest<lanes>(off) > 0)) return false;
    for (int l = 0; l < lanes; ++l)
        if (lane(off, l) > 0)
            since(packet.a[static_cast<std::size_t>(l)]) =
                since(packet.b[static_cast<std::size_t>(l)]) = pass_;
    return true;
}

}  // namespace rigid
