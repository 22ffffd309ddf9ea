/// \file friction_stage.hpp
/// The step learns of friction by its rows alone: to the sources of another contacts stage this one adds one for each row of
/// friction_rows.hpp, all of them before the normals (section 13.5).
#pragma once

#include "chapters/13_friction/friction_rows.hpp"
#include "chapters/13_friction/hold_or_slide.hpp"

#include <algorithm>
#include <iterator>

namespace rigid {

//! [with_friction]
/// The contacts stage: whatever another one finds, and for each contact the rows of
/// its surfaces. A contact without friction gets none. Sweeps visit the normals
/// last: what is visited last is right.
template <class Contacts>
struct WithFriction : Contacts {
    std::vector<Source> all;  ///< memory
    /// of the last step: what rests on other surfaces wakes
    std::vector<Surface> surfaces, walls;
    Cloth cloth;

    template <class Method>
    void begin(const RoughScene& scene, const StepSettings& settings,
               Method& method, StepData<3>& now)
    {
        if (!Contacts::is_told) {
            require_valid_surfaces(scene);
            if (!method.solver.knows_sliding) refuse_kinetic_friction(scene);
        }
        if (!((Contacts::is_told || scene.surfaces == surfaces) &&
              scene.wall_surfaces == walls && scene.cloth == cloth)) {
            this->wake_everybody();
            if (!Contacts::is_told) surfaces = scene.surfaces;
            walls = scene.wall_surfaces;
            cloth = scene.cloth;
        }
        Contacts::begin(scene, settings, method, now);
        if (now.active.empty()) return;  // all sleep
        const auto is_normal = [](const Source& source) {
            return source.of == Source::Of::contact;
        };
        all.clear();
        std::remove_copy_if(now.sources.begin(), now.sources.end(),
                            std::back_inserter(all), is_normal);
        if (scene.cloth.friction > 0)
            for (const int k : now.active)
                if (scene.bodies.can_move(k))
                    for (const int part : {sliding_part, spinning_part})
                        all.push_back({Source::Of::body, k, part});
        for (std::size_t i = 0; i < now.contacts.size(); ++i) {
            const int index = static_cast<int>(i);
            const Surface surface = surface_of(scene, now.contacts[i]);
            if (surface.friction > 0)
                all.push_back({Source::Of::contact, index, tangent_part});
            if (surface.rolling > 0)
                all.push_back({Source::Of::contact, index, rolling_part});
        }
        for (std::size_t i = 0; i < now.contacts.size(); ++i)
            all.push_back({Source::Of::contact, static_cast<int>(i), normal_part});
        now.sources.swap(all);
    }
};
//! [with_friction]

}  // namespace rigid
