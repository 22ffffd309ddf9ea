// The functions of spinning_scenes.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/24_friction_is_a_disc/spinning_scenes.hpp"

namespace rigid {

//! [table]
RoughSolids top_on_table(const TopShape& top, Real mu)
{
    RoughSolids scene = spinning_top(top);
    scene.joints.clear();
    // the pin as a line: it ends in the tip, and not in a ball around it
    scene.shapes[0][0].radius = 0;
    scene.length = 0.1;
    add_floor(scene, mu);
    return scene;
}
//! [table]

}  // namespace rigid
