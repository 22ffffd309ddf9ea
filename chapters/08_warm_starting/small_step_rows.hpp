/// \file small_step_rows.hpp
/// What small_steps() does once in a step: which rows there are, in which order they are visited, and where λ starts.
///
/// Most steps have the rows of the step before. Then there is next to nothing to do.
#pragma once

#include "chapters/06_sequential_impulse/row_order.hpp"
#include "chapters/06_sequential_impulse/sequential_impulse.hpp"
#include "chapters/08_warm_starting/best_multiple.hpp"
#include "chapters/08_warm_starting/impulse_cache.hpp"
#include "chapters/08_warm_starting/small_step_settings.hpp"
#include "common/scenes.hpp"

#include <numeric>
#include <utility>
#include <vector>

namespace rigid {

/// How much of the impulses that it remembers a group starts from.
struct StartOfGroup {
    Real slope = 0;      ///< qᵀλ [J]
    Real curvature = 0;  ///< λᵀAλ [J]
    Real multiple = 1;   ///< s of (8.12)
};

/// Bodies begin … end − 1 are of one group.
struct BodyRun {
    Index begin = 0, end = 0;
    std::size_t group = 0;
};

/// What stays from step to step. All memory is kept. It belongs to one scene: a change of masses or links
/// must set forget_rows.
struct SmallStep {
    std::vector<Contact> contacts;
    std::vector<ImpulseKey> keys, keys_before;
    ImpulseCache cache;              ///< its h is 0 until a step has been made
    VecX remembered;                 ///< λ by the number of the row [N s]
    std::vector<SolverRow<2>> rows;  ///< in the order of the visits
    /// distance at which C = 0, in the same order [m]
    std::vector<Real> rest;
    /// row number of each visit; and where each row number is visited
    std::vector<int> order, place;
    /// bodies and M⁻¹ of the rows as given: all that colours depend on
    std::vector<Row<2>> bodies;
    Colouring colouring;
    BodyGroups groups;
    /// the place in `starts`, in the order of the visits
    std::vector<std::size_t> group_of_row;
    std::vector<BodyRun> runs;         ///< all bodies, in their order
    std::vector<StartOfGroup> starts;  ///< of each group
    VecX mass;                         ///< K [kg]; 0 = nothing moves it
    /// a disc that nothing moves has a velocity
    bool driven = false;
    VecX u, change;   ///< [m/s]; Δu of the guess
    int sweeps = 0;   ///< of the last step, of all sub-steps together
    Real length = 1;  ///< ℓ, of the scene [m]
    /// nothing came or went since the step before
    bool same_rows = false;
    /// in: make the rows again though they may be the same; for one step
    bool forget_rows = false;
};

/// The two bodies of a row by its number: links first, then contacts.
inline std::pair<Index, Index> bodies_of(const DiscScene& scene,
                                         const SmallStep& now, std::size_t i)
{
    const std::size_t links = scene.links.size();
    if (i < links) return {scene.links[i].a, scene.links[i].b};
    return {now.contacts[i - links].a, now.contacts[i - links].b};
}

/// Which rows and bodies have a multiple in common.
void number_groups(const DiscScene& scene, SmallStep& now);

/// The previous λ goes to the keys of its rows, and from there to the present rows. Then their order.
void change_rows(const DiscScene& scene, const SmallStepSettings& settings, Real h,
                 SmallStep& now);

/// Finds the contacts and makes the rows ready for the substeps. Throws std::invalid_argument for a bad setting.
void begin_rows(const DiscScene& scene, const SmallStepSettings& settings,
                SmallStep& now);

}  // namespace rigid
