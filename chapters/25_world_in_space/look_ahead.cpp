// The functions of look_ahead.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/25_world_in_space/look_ahead.hpp"

namespace rigid {

//! [ahead]
void look_ahead(const SolidScene& scene, Real margin, Real h, Real most,
                SolidPairs& near)
{
    near.ahead_of.assign(near.forms.size(), 0);
    near.way_of.assign(near.forms.size(), 0);
    if (!(most > 0)) return;
    for (Index k = 0; k < scene.bodies.count(); ++k) {
        const auto i = static_cast<std::size_t>(k);
        if (!near.looks(k)) continue;
        const auto u = scene.bodies.velocity(k);
        const Real falls = scene.bodies.can_move(k) ? scene.gravity.norm() * h : 0,
                   turns = u.tail<3>().norm() * near.reach[i],
                   way = h * (u.head<3>().norm() + falls + turns);
        if (!(way > margin / 2)) continue;
        near.way_of[i] = way;
        near.ahead_of[i] = std::min(way, most * near.inner[i]);
    }
}
//! [ahead]

}  // namespace rigid
