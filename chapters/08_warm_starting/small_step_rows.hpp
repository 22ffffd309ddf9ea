/// \file small_step_rows.hpp
/// What small_steps() does once in a step: which rows there are, in which order they are visited, and where λ starts.
///
/// Most steps have the rows of the step before. Then there is next to nothing to do.
#pragma once

#include "chapters/06_sequential_impulse/row_order.hpp"
#include "chapters/06_sequential_impulse/sequential_impulse.hpp"
#include "chapters/07_baumgarte/stabilization.hpp"
#include "chapters/08_warm_starting/best_multiple.hpp"
#include "chapters/08_warm_starting/impulse_cache.hpp"
#include "common/forces.hpp"
#include "common/scenes.hpp"
#include "common/text.hpp"

#include <numeric>
#include <utility>
#include <vector>

namespace rigid {

struct SmallStepSettings {
    Real h = 1.0 / 60;  ///< time step [s]
    int substeps = 8;   ///< n
    int sweeps = 1;     ///< in each of them
    int first_sweeps =
        1000;  ///< in the very first, which has no previous answer: at most, while a visit changes
    Real first_tolerance = 1e-5;  ///< the velocity of its row by more than this [ℓ/s]
    Real margin = 0.02;           ///< a contact gets its row when its gap is below this [ℓ]
    bool collides = true;         ///< false: nothing ever touches, and no contact is looked for
    bool coloured = true;         ///< neighbours in the order of the visits share no body
    /// Each substep starts from the best multiple of what the one before it left, or from nearly that: a pile that
    /// only just balances topples when all its loads change a little together.
    MultipleRule start = {0.2, 10};
    /// What corrects the error after the last substep: all of it (β = 1) beyond the slops. An overlap of half a
    /// millimetre is left alone: moving discs that nearly balance topples them.
    StabilizerSettings correction = {Stabilizer::projection, 1, 0.0005, 0, 3, 1, 0};
};

/// How much of the impulses that it remembers a group starts from.
struct StartOfGroup {
    Real slope = 0;      ///< qᵀλ [J]
    Real curvature = 0;  ///< λᵀAλ [J]
    Real multiple = 1;   ///< s of (8.14)
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
    std::vector<Real> rest;          ///< distance at which C = 0, in the same order [m]
    std::vector<int> order, place;   ///< row number of each visit; and where each row number is visited
    std::vector<Row<2>> bodies;      ///< bodies and M⁻¹ of the rows as given: all that colours depend on
    Colouring colouring;
    BodyGroups groups;
    std::vector<std::size_t> group_of_row;  ///< the place in `starts`, in the order of the visits
    std::vector<BodyRun> runs;              ///< all bodies, in their order
    std::vector<StartOfGroup> starts;       ///< of each group
    VecX mass;                              ///< K [kg]; 0 = cannot move
    VecX u, change;                         ///< [m/s]; Δu of the guess
    int sweeps = 0;                         ///< of the last step
    Real length = 1;                        ///< ℓ, of the scene [m]
    bool same_rows = false;                 ///< nothing came or went since the step before
    bool forget_rows = false;  ///< in: make the rows anew though they may be the same; for one step
};

/// The two bodies of a row by its number: links first, then contacts.
inline std::pair<Index, Index> bodies_of(const DiscScene& scene, const SmallStep& now, std::size_t i)
{
    const std::size_t links = scene.links.size();
    if (i < links) return {scene.links[i].a, scene.links[i].b};
    return {now.contacts[i - links].a, now.contacts[i - links].b};
}

/// Which rows and bodies have a multiple in common.
inline void number_groups(const DiscScene& scene, SmallStep& now)
{
    now.groups.of.clear();  // it holds the numbers of the last call
    find_groups<2>(now.bodies, scene.bodies.inverse_mass, now.groups);
    std::vector<Index>& of = now.groups.of;  // the lowest body of the group; becomes its number, from 0
    now.starts.clear();
    now.runs.clear();
    now.mass.resize(scene.bodies.count());
    for (Index k = 0; k < scene.bodies.count(); ++k) {
        const Real w = scene.bodies.inverse_mass[2 * k];
        now.mass[k] = w > 0 ? 1 / w : 0;
        Index& group = of[static_cast<std::size_t>(k)];
        if (group == k) {
            group = static_cast<Index>(now.starts.size());
            now.starts.emplace_back();
        } else {
            group = of[static_cast<std::size_t>(group)];  // a lower body: it has its number
        }
        const auto number = static_cast<std::size_t>(group);
        if (now.runs.empty() || now.runs.back().group != number) now.runs.push_back({k, k, number});
        now.runs.back().end = k + 1;
    }
    now.group_of_row.resize(now.bodies.size());
    for (std::size_t i = 0; i < now.bodies.size(); ++i)
        now.group_of_row[static_cast<std::size_t>(now.place[i])] =
            static_cast<std::size_t>(of[static_cast<std::size_t>(now.groups.of_row[i])]);
}

/// The previous λ goes to the keys of its rows, and from there to the present rows. Then their order.
inline void change_rows(const DiscScene& scene, const SmallStepSettings& settings, Real h, SmallStep& now)
{
    const std::size_t m = now.keys.size();
    now.remembered.resize(static_cast<Index>(now.rows.size()));
    for (std::size_t k = 0; k < now.rows.size(); ++k) now.remembered[now.order[k]] = now.rows[k].lambda;
    if (now.cache.h > 0) store(now.cache, now.keys_before, now.remembered, now.cache.h);
    load(now.cache, now.keys, h, now.remembered);
    now.keys_before = now.keys;

    now.bodies.resize(m);
    for (std::size_t i = 0; i < m; ++i) {
        const auto [a, b] = bodies_of(scene, now, i);
        now.bodies[i].a = a;
        now.bodies[i].b = b;
        if (a != world) now.bodies[i].Wa = scene.bodies.inverse_mass.segment<2>(2 * a);
        now.bodies[i].Wb = scene.bodies.inverse_mass.segment<2>(2 * b);
    }
    if (settings.coloured) colour_rows(now.bodies, scene.bodies.count(), now.colouring, now.order);
    else {
        now.order.resize(m);
        std::iota(now.order.begin(), now.order.end(), 0);
    }

    now.rows.resize(m);
    now.rest.resize(m);
    now.place.resize(m);
    for (std::size_t k = 0; k < m; ++k) {
        const auto i = static_cast<std::size_t>(now.order[k]);
        const Index a = now.bodies[i].a, b = now.bodies[i].b;
        SolverRow<2>& row = now.rows[k];
        now.place[i] = static_cast<int>(k);
        row.a = static_cast<int>(2 * (a == world ? b : a));
        row.b = static_cast<int>(2 * b);
        const Real A = (a == world ? 0 : scene.bodies.inverse_mass[row.a]) + scene.bodies.inverse_mass[row.b];
        row.mass = A > 0 ? 1 / A : 0;
        row.lo = i < scene.links.size() ? -infinity : 0;
        row.hi = infinity;
        row.lambda = now.remembered[static_cast<Index>(i)];
    }
    number_groups(scene, now);
}

/// Finds the contacts and makes the rows ready for the substeps. Throws std::invalid_argument for a bad setting.
inline void begin_rows(const DiscScene& scene, const SmallStepSettings& settings, SmallStep& now)
{
    require_step(settings.h);
    require_bodies(scene);
    if (!scene.joints.empty())
        throw std::invalid_argument(
            "the scene has " + std::to_string(scene.joints.size()) +
            " joints; small_steps() knows none: take step() by WarmMethod with sub-steps");
    if (!scene.bends.empty())
        throw std::invalid_argument(
            "the scene has " + std::to_string(scene.bends.size()) +
            " bends; small_steps() knows no torsional springs: take step() by WarmMethod with sub-steps");
    require_forces(scene.gravity, 0, 0, {0, 0});
    require_margin(settings.margin);
    require_valid(settings.correction);
    require_valid(settings.start);
    if (!(settings.first_tolerance >= 0))
        throw std::invalid_argument("first_tolerance is " + shortest(settings.first_tolerance) +
                                    "; it must be zero or positive");
    if (settings.substeps < 1 || settings.sweeps < 1)
        throw std::invalid_argument("there are " + std::to_string(settings.substeps) + " substeps of " +
                                    std::to_string(settings.sweeps) + " sweeps; both must be 1 or more");
    if (settings.correction.beta != 1)
        throw std::invalid_argument("beta is " + shortest(settings.correction.beta) +
                                    "; small steps repay the whole error, so it must be 1");
    if (!scene.segments.empty())
        throw std::invalid_argument(
            "the scene has walls with ends; small steps take only half-spaces for walls, "
            "whose normals stay");
    const Real h = settings.h / settings.substeps;
    const std::size_t links = scene.links.size();
    now.contacts.clear();
    now.length = typical_length(scene);
    if (settings.collides) find_contacts(scene, settings.margin * now.length, now.contacts);
    now.keys.clear();
    for (std::size_t i = 0; i < links; ++i) now.keys.push_back(link_key(i));
    for (const Contact& contact : now.contacts) now.keys.push_back(contact_key(contact));

    now.same_rows = !std::exchange(now.forget_rows, false) && now.cache.h == h && now.keys == now.keys_before;
    if (!now.same_rows) change_rows(scene, settings, h, now);
    now.cache.h = h;

    // At which distance C is zero, and the normals of walls.
    for (std::size_t i = 0; i < now.keys.size(); ++i) {
        const auto k = static_cast<std::size_t>(now.place[i]);
        if (i < links) {
            now.rest[k] = scene.links[i].length;
            continue;
        }
        const Contact& contact = now.contacts[i - links];
        if (contact.a != world) {
            now.rest[k] = scene.radius[contact.a] + scene.radius[contact.b];
            continue;
        }
        SolverRow<2>& row = now.rows[k];
        row.Ja.setZero();
        row.Wa.setZero();
        row.Jb = contact.normal.transpose();
        row.Wb = scene.bodies.inverse_mass[row.b] * contact.normal;
        now.rest[k] = contact.normal.dot(scene.bodies.x.segment<2>(row.b)) - contact.gap;
    }
}

}  // namespace rigid
