/// \file smooth_touching.hpp
/// The contacts stage in space, without friction: which solids are near each other, where they touch, and the rows of that.
///
///     joints · normals, one to a contact
#pragma once

#include "chapters/06_sequential_impulse/impulse_solver.hpp"
#include "chapters/08_warm_starting/warm_start.hpp"
#include "chapters/21_joints_in_space/loaded_solids.hpp"
#include "chapters/23_faces_that_touch/solid_pairs.hpp"
#include "chapters/23_faces_that_touch/solid_touch.hpp"
#include "chapters/23_faces_that_touch/touching_rows.hpp"

namespace rigid {

/// The corners of a solid that are near a wall, (23.2); four of them carry it.
void collide(const SolidWall& wall, const PlacedSolid& b, const TouchSettings& how,
             ClipRoom& room, SolidTouch& touch);

/// What finds the contacts of a step; the stages of this chapter and of the next ones are made of these parts.
struct ContactSearch : SolidPairs, PlainContacts {
    /// what differs by less than this is the same [margins]
    Real slack = 0.01;
    int points = 4;  ///< of each pair of hulls, at most; 1: the deepest alone

    // What is kept from step to step.
    ClipRoom room;
    SolidTouch touch;

    void require_valid() const;

    /// The contacts of one wall, of all bodies that are looked at.
    void touch_wall(const WalledSolids& scene, std::size_t w,
                    const TouchSettings& near, StepData<6>& now);

    /// Those of two bodies.
    void touch_pair(const WalledSolids& scene, int a, int b,
                    const TouchSettings& near, StepData<6>& now);

    /// The row of each contact, which come last (section 13.5).
    static void list_normals(StepData<6>& now)
    {
        for (std::size_t i = 0; i < now.contacts.size(); ++i)
            now.sources.push_back(
                {Source::Of::contact, static_cast<int>(i), push_part});
    }

protected:
    /// The points of `touch` as contacts.
    void add(const WalledSolids& scene, Index a, Index b, Real radius_a,
             Real radius_b, Index first_feature, StepData<6>& now);

private:
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

//! [stage]
struct SmoothTouching : ContactSearch {
    AllSolids others;

    template <class Method>
    void begin(const WalledSolids& scene, const StepSettings& settings,
               Method& method, StepData<6>& now)
    {
        others.begin(scene, settings, method, now);
        require_touching(scene);
        mark(scene, now.active);
        place(scene);
        const Real margin = settings.margin * now.length;
        find_pairs(scene, margin);
        const TouchSettings how{margin, slack * margin};
        for (std::size_t w = 0; w < scene.walls.size(); ++w)
            touch_wall(scene, w, how, now);
        for (const auto& [a, b] : pairs) touch_pair(scene, a, b, how, now);
        list_normals(now);
    }
};
//! [stage]

//! [touching]
/// What keeps a stack at rest: contacts stay closed by a thousandth of ℓ, and what
/// corrects them leaves no velocity.
inline Correction closed_contacts()
{
    Correction correction;
    correction.method = Stabilizer::split_impulse;
    correction.slop = 0.001;
    return correction;
}

/// Solids that touch.
template <class Solver, class Contacts>
struct TouchingMethod {
    Contacts contacts;
    LoadedSolids correction = closed_contacts();
    WarmStart start;
    Solver solver;
};
using SmoothSweeps = TouchingMethod<ImpulseSolver<6>, SmoothTouching>;
//! [touching]

// Compiled once, in smooth_touching.cpp.
extern template void step(WalledSolids&, const StepSettings&, SmoothSweeps&,
                          StepData<6>&);

}  // namespace rigid
