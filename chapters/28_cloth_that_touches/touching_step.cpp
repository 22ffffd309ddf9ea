// The functions of touching_step.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/28_cloth_that_touches/touching_step.hpp"

#include <algorithm>

namespace rigid {

void ClothTouching::prepare(const TouchingCloth& cloth, bool middle)
{
    touch.middle = middle;
    const Key now{static_cast<std::size_t>(cloth.count()),
                  cloth.springs.size(),
                  cloth.shapes.size(),
                  cloth.ties.size(),
                  cloth.solids.count(),
                  cloth.changes,
                  cloth.thickness,
                  cloth.self_thickness,
                  cloth.self_friction};
    if (!cloth.solids.x.allFinite() || !cloth.solids.u.allFinite() ||
        !cloth.solids.f.allFinite())
        require_valid(cloth.solids);  // says which number
    const bool same = now == key_;
    if (same && cloth.shapes == shapes_ && cloth.ties == ties_) return;
    require_touchable(cloth);
    shapes_ = cloth.shapes, ties_ = cloth.ties;
    if (same) return;
    Real shortest_spring = infinity;
    for (const ClothSpring& s : cloth.springs)
        shortest_spring = std::min(shortest_spring, s.length);
    touch.margin = cloth.springs.empty() ? 0.01 : shortest_spring / 4;
    if (cloth.self_thickness > 0) self.prepare(cloth);
    key_ = now;
}

void ClothTouching::begin(TouchingCloth& cloth, Real h, const VecX& x0,
                          const VecX& x)
{
    touch.begin(cloth, h);
    if (cloth.self_thickness > 0) self.begin(cloth, x0, x);
    else self.rows.clear(), self.lost = false;
}

void ClothTouching::end(TouchingCloth& cloth, Real h, Real whole, const VecX& x0,
                        const VecX& u0)
{
    touch.set_velocities(cloth, h, whole);
    if (touch.middle) {
        touch.rest_in_the_middle(cloth, h, u0);
        self.rest_in_the_middle(cloth, h, u0);
    }
    self.calm(cloth);
    if (cloth.self_thickness > 0) self.stop(cloth, x0, cloth.bodies.x);
    touch.end(cloth, h);
}

void step(TouchingCloth& cloth, const ClothSettings& settings,
          TouchingMemory& memory)
{
    step(cloth, settings, static_cast<ClothMemory&>(memory),
         static_cast<ClothTouching&>(memory));
}

}  // namespace rigid
