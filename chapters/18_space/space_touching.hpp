/// \file space_touching.hpp
/// The contacts stage in space: which solids are near each other, where they touch, and the rows of that.
///
///     joints · friction, up to five rows to a contact · normals, one to a contact
#pragma once

#include "chapters/18_space/ellipsoid.hpp"
#include "chapters/18_space/fast_solids.hpp"
#include "chapters/18_space/look_ahead.hpp"
#include "chapters/18_space/mesh_touch.hpp"
#include "chapters/18_space/solid_touch.hpp"
#include "chapters/18_space/space_constraints.hpp"

namespace rigid {

//! [wall]
/// The corners of a solid that are near a wall, (18.36); four of them carry it.
inline void collide(const SolidWall& wall, const PlacedSolid& b,
                    const TouchSettings& how, ClipRoom& room, SolidTouch& touch)
{
    room.points.clear();
    touch.normal = wall.normal;
    for (std::size_t i = 0; i < b.vertices.size(); ++i) {
        const Real height = wall.normal.dot(b.vertices[i]) - wall.offset;
        if (height - b.radius() < how.margin)
            room.points.push_back({b.vertices[i] - height * wall.normal,
                                   b.vertices[i], height - b.radius(),
                                   static_cast<int>(i)});
    }
    keep_four(room.points, how.slack, touch);
}
//! [wall]

struct TouchingSolids : SolidPairs {
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

    void require_valid() const
    {
        if (!(slack >= 0 && slack < 1))
            throw std::invalid_argument("the slack of contacts is " +
                                        shortest(slack) +
                                        " margins; it must be from 0 to 1");
        if (!(ahead >= 0) || !std::isfinite(ahead))
            throw std::invalid_argument(
                "solids look " + shortest(ahead) +
                " inner radii ahead; it must be zero or positive and finite");
        if (points < 1 || points > 4)
            throw std::invalid_argument("a pair of hulls has " +
                                        std::to_string(points) +
                                        " points at most; it must be 1 to 4");
    }

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
                    const TouchSettings& near, StepData<6>& now)
    {
        const SolidWall& wall = scene.walls[w];
        for (Index b = 0; b < scene.bodies.count(); ++b) {
            const auto k = static_cast<std::size_t>(b);
            const Real height =
                wall.normal.dot(centre_of(scene.bodies.x, b)) - wall.offset;
            const TouchSettings how{near.margin + ahead_of[k], near.slack};
            if (!looks(b) || !scene.bodies.can_move(b) ||
                height - reach[k] >= how.margin)
                continue;
            Index first = 0;
            for (std::size_t v = 0; v < w; ++v) first += corners(k);
            for (const PlacedSolid& solid : solids[k]) {
                collide(wall, solid, how, room, touch);
                add(scene, world, b, 0, solid.radius(), first,
                    wall_grip(scene, w, k), now);
                first += static_cast<Index>(solid.vertices.size());
            }
        }
    }

    void touch_meshes(const SpaceScene& scene, Index b, const TouchSettings& near,
                      StepData<6>& now)
    {
        const auto k = static_cast<std::size_t>(b);
        const TouchSettings how{near.margin + ahead_of[k], near.slack};
        Index first = 0;  // below zero: hulls on walls have the others
        for (std::size_t m = 0; m < scene.meshes.size(); ++m)
            for (const PlacedSolid& solid : solids[k]) {
                const TriangleMesh& mesh = *scene.meshes[m];
                const int names = take_names(mesh, *solid.form, ground, first);
                collide(mesh, solid, names, how, room, touch, ground);
                for (std::size_t i = 0; i < ground.count; ++i) {
                    touch.normal = ground.manifolds[i].normal;
                    keep_four(ground.manifolds[i].points, how.slack, touch);
                    add(scene, world, b, 0, solid.radius(), first,
                        mesh_grip(scene, m, k), now);
                }
            }
    }

    void touch_pair(const SpaceScene& scene, int a, int b,
                    const TouchSettings& near, StepData<6>& now)
    {
        const auto ka = static_cast<std::size_t>(a),
                   kb = static_cast<std::size_t>(b);
        const TouchSettings how{near.margin + ahead_of[ka] + ahead_of[kb],
                                near.slack};
        Index first = 0;
        const std::size_t before = now.contacts.size();
        for (const PlacedSolid& p : solids[ka])
            for (const PlacedSolid& q : solids[kb]) {
                collide(p, q, how, room, touch);
                add(scene, a, b, p.radius(), q.radius(), first,
                    grip_of(scene, ka, kb), now);
                first += TouchNames(*p.form, *q.form).count();
            }
        if (now.contacts.size() > before) touching.push_back({a, b});
    }

    void add(const SpaceScene& scene, Index a, Index b, Real radius_a,
             Real radius_b, Index first_feature, const Grip& grip, StepData<6>& now)
    {
        if (touch.count == 0) return;
        const Mat3 Ra = rotation_of(scene.bodies.x, a),
                   Rb = rotation_of(scene.bodies.x, b);
        const auto in_axes = [&](Index k, const Mat3& R, const Vec3& p) -> Vec3 {
            return R.transpose() * (p - centre_of(scene.bodies.x, k));
        };
        if (touch.count > points) keep_deepest();
        for (int i = 0; i < touch.count; ++i) {
            const TouchPoint& p = touch.points[static_cast<std::size_t>(i)];
            now.contacts.push_back({a, b, first_feature + p.feature, touch.normal,
                                    in_axes(a, Ra, p.on_a), in_axes(b, Rb, p.on_b),
                                    radius_a, radius_b, grip});
        }
    }

    /// What the text breaks: fewer points than a face needs.
    void keep_deepest()
    {
        const auto end = touch.points.begin() + touch.count;
        std::sort(
            touch.points.begin(), end,
            [](const TouchPoint& p, const TouchPoint& q) { return p.gap < q.gap; });
        touch.count = points;
    }

    Index corners(std::size_t k) const
    {
        Index count = 0;
        for (const PlacedSolid& solid : solids[k])
            count += static_cast<Index>(solid.vertices.size());
        return count;
    }
};

}  // namespace rigid
