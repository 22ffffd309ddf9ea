// The functions of scene_edits.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/10_skipping_work/scene_edits.hpp"

namespace rigid {

void require_disc(const SkippingWorld& now, Index k)
{
    if (k < 0 || k >= now.scene.bodies.count())
        throw std::invalid_argument("there is no disc " + std::to_string(k) +
                                    " among " +
                                    std::to_string(now.scene.bodies.count()));
    if (now.method.contacts.set.activity[static_cast<std::size_t>(k)] ==
        Activity::gone)
        throw std::invalid_argument("disc " + std::to_string(k) +
                                    " was taken away");
}

}  // namespace rigid
