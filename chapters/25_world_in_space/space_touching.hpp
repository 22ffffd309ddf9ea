/// \file space_touching.hpp
/// The contacts stage in space, whole: chapter 24's, grounds of triangles, and solids that are fast.
///
///     joints · friction, up to five rows to a contact · normals, one to a contact
#pragma once

#include "chapters/24_friction_is_a_disc/rough_touching.hpp"
#include "chapters/25_world_in_space/fast_solids.hpp"
#include "chapters/25_world_in_space/look_ahead.hpp"
#include "chapters/25_world_in_space/mesh_touch.hpp"

namespace rigid {

struct TouchingSolids : RoughSearch {
    FastSolids fast;
    /// a gap that two bodies could close in this step has its row: how far each of
    /// them looks ahead at most; 0: no farther than the margin [inner radii]
    Real ahead = 0;

    // What is kept from step to step.
    AllSolids others;
    MeshMemory ground;

    void require_valid() const;

    //! [stage]
    template <class Method>
    void begin(const SpaceScene& scene, const StepSettings& settings,
               Method& method, StepData<6>& now)
    {
        others.begin(scene, settings, method, now);
        require_touching(scene);
        mark(scene, now.active);
        list_contacts(scene, settings.margin * now.length, settings.h, now);
    }

    /// The same for a step that looks at some bodies only.
    /// \param bodies  ascending; the others are where they were in the last step
    void begin_with(const SpaceScene& scene, Real margin, Real h,
                    std::span<const int> bodies, StepData<6>& now)
    {
        mark(scene, bodies);
        now.x_found = scene.bodies.x;
        AllSolids::list_joints(
            scene, [this](Index k) { return looks(k); }, now);
        list_contacts(scene, margin, h, now);
    }

    void list_contacts(const SpaceScene& scene, Real margin, Real h,
                       StepData<6>& now)
    {
        place(scene);
        look_ahead(scene, margin, h, ahead, *this);
        find_pairs(scene, margin);
        const TouchSettings how{margin, slack * margin};
        touch_walls(scene, how, now);
        touch_meshes(scene, how, now);
        touch_pairs(scene, how, now);
        touch_ellipsoids(
            scene, margin, [this](Index k) { return looks(k); }, now);
        list_rows(now);
    }
    //! [stage]

    /// What a scene needs for all of this.
    template <class Method>
    void require_fit(const SpaceScene& scene, const Method& method) const
    {
        require_touching(scene);
        AllSolids::refuse_unfit(method.correction);
    }

    template <class Method>
    void end(SpaceScene& scene, const StepSettings& settings, Method&,
             const StepData<6>& now)
    {
        if (fast.stop) stop_fast_solids(scene, settings, now, *this, fast);
    }

private:
    void touch_meshes(const SpaceScene& scene, const TouchSettings& near,
                      StepData<6>& now);
    void touch_meshes(const SpaceScene& scene, Index b, const TouchSettings& near,
                      StepData<6>& now);
};

}  // namespace rigid
