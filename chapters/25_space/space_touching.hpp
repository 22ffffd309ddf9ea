/// \file space_touching.hpp
/// The contacts stage in space: which solids are near each other, where they touch, and the rows of that.
///
///     joints · friction, up to five rows to a contact · normals, one to a contact
#pragma once

#include "chapters/25_space/ellipsoid.hpp"
#include "chapters/25_space/fast_solids.hpp"
#include "chapters/25_space/look_ahead.hpp"
#include "chapters/25_space/mesh_touch.hpp"
#include "chapters/25_space/solid_touch.hpp"
#include "chapters/25_space/space_constraints.hpp"

namespace rigid {

/// The corners of a solid that are near a wall, (25.36); four of them carry it.
void collide(const SolidWall& wall, const PlacedSolid& b, const TouchSettings& how,
             ClipRoom& room, SolidTouch& touch);

struct TouchingSolids : SolidPairs, PlainContacts {
    /// what differs by less than this is the same [margins]
    Real slack = 0.01;
    int points = 4;  ///< of each pair of hulls, at most; 1: the deepest alone

    FastSolids fast;
    /// a gap that two bodies could close in this step has its row: how far each of
    /// them looks ahead at most; 0: no farther than the margin [inner radii]
    Real ahead = 0;

    // What is kept from step to step.
    AllSolids others;
    ClipRoom room;
    SolidTouch touch;
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
        for (std::size_t w = 0; w < scene.walls.size(); ++w)
            touch_wall(scene, w, how, now);
        ground.boxes = ground.triangles = 0;
        for (Index b = 0; b < scene.bodies.count(); ++b)
            if (looks(b) && scene.bodies.can_move(b))
                touch_meshes(scene, b, how, now);
        for (const auto& [a, b] : pairs) touch_pair(scene, a, b, how, now);
        touch_ellipsoids(
            scene, margin, [this](Index k) { return looks(k); }, now);
        // friction first: what is visited last is right (section 13.5)
        for (std::size_t i = 0; i < now.contacts.size(); ++i) {
            const Grip& grip = now.contacts[i].grip;
            if (grip.friction > 0)
                add_rows(i, {first_tangent, second_tangent}, now);
            if (grip.rolling > 0) add_rows(i, {first_roll, second_roll}, now);
            if (grip.spinning > 0) add_rows(i, {spin_part}, now);
        }
        for (std::size_t i = 0; i < now.contacts.size(); ++i)
            add_rows(i, {push_part}, now);
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
    static void add_rows(std::size_t contact,
                         std::initializer_list<SpacePart> parts, StepData<6>& now)
    {
        for (const SpacePart part : parts)
            now.sources.push_back(
                {Source::Of::contact, static_cast<int>(contact), part});
    }

    void touch_wall(const SpaceScene& scene, std::size_t w,
                    const TouchSettings& near, StepData<6>& now);

    void touch_meshes(const SpaceScene& scene, Index b, const TouchSettings& near,
                      StepData<6>& now);

    void touch_pair(const SpaceScene& scene, int a, int b,
                    const TouchSettings& near, StepData<6>& now);

    void add(const SpaceScene& scene, Index a, Index b, Real radius_a,
             Real radius_b, Index first_feature, const Grip& grip,
             StepData<6>& now);

    /// What the text breaks: fewer points than a face needs.
    void keep_deepest();

    Index corners(std::size_t k) const
    {
        Index count = 0;
        for (const PlacedSolid& solid : solids[k])
            count += static_cast<Index>(solid.vertices.size());
        return count;
    }
};

}  // namespace rigid
