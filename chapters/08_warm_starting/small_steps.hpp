/// \file small_steps.hpp
/// Many small steps, one sweep in each, every one warm: chapter 8's step without what a scene of discs does not
/// need.
///
///     contacts → once: who the rows are, their order, mass, bounds, λ start
///     n times with h/n:   u += h g;  C, J, b;  u += M⁻¹ Jᵀ λ;  a sweep;  x += h u
///     projection, once
///
/// The answer is that of warm_step() with the same settings, to rounding. Left out is what does not change within a
/// step, and the way from Constraint to Row to SolverRow: J, C and b are written where the sweep reads them.
/// While the rows are yesterday's, neither keys are looked up nor colours chosen: λ is where it was.
#pragma once

#include "chapters/07_baumgarte/stabilization.hpp"
#include "chapters/08_warm_starting/impulse_cache.hpp"
#include "common/scenes.hpp"

#include <bit>
#include <utility>
#include <vector>

namespace rigid {

struct SmallStepSettings {
    Real h = 1.0 / 60;          ///< time step [s]
    Vec2 gravity = {0, -9.81};  ///< [m/s²]
    int substeps = 8;
    int sweeps = 1;         ///< in each of them at least
    int max_sweeps = 1;     ///< in each of them at most, while a visit changes a row's velocity by more than
    Real tolerance = 0;     ///< this [m/s]
    Real margin = 0.02;     ///< a contact gets its row when its gap is below this [m]
    bool collides = true;   ///< false: nobody looks for contacts
    bool coloured = true;   ///< neighbours in the order of the sweeps share no body
    bool warm = true;
    /// What repays the error, after the last substep. Only β, slops, fastest and the number of sweeps are read.
    StabilizerSettings repay = {Stabilizer::projection, 1, 0, 0, infinity, 1};
};

/// What stays from step to step. All memory is kept.
struct SmallStep {
    std::vector<Contact> contacts;
    std::vector<ImpulseKey> keys, keys_before;
    ImpulseCache cache;
    VecX start;                         ///< λ by the number of the row [N s]
    std::vector<SolverRow<2>> rows;     ///< in the order of the sweeps
    std::vector<Real> rest;             ///< distance at which C = 0, in the same order [m]
    std::vector<int> order, place;      ///< row number of each visit; and where each row number is visited
    std::vector<std::uint64_t> colours; ///< of each body: the colours that its rows have
    std::vector<int> colour;            ///< of each row
    VecX u, x;                          ///< Dof·(K + 1); the last place is the world's
    std::int64_t visits = 0;            ///< by the last step, those of the projection included
    bool same_rows = false;             ///< nothing came or went since the step before
};

/// Greedy colours: each row in turn gets the first colour that no row of its movable bodies has. Rows of
/// one colour share no body, so that the processor need not wait for one visit before it begins the next. Beyond
/// 64 colours rows share the last one, which costs time and nothing else.
inline void choose_colours(const DiscScene& scene, SmallStep& now)
{
    const std::size_t m = now.keys.size(), links = scene.links.size();
    now.colours.assign(static_cast<std::size_t>(scene.bodies.count()), 0);
    now.colour.resize(m);
    int count[64] = {};
    for (std::size_t i = 0; i < m; ++i) {
        const Index a = i < links ? scene.links[i].a : now.contacts[i - links].a;
        const Index b = i < links ? scene.links[i].b : now.contacts[i - links].b;
        std::uint64_t used = 0, none = 0;
        std::uint64_t& of_a =
            a != world && scene.bodies.inverse_mass[2 * a] > 0 ? now.colours[static_cast<std::size_t>(a)] : none;
        std::uint64_t& of_b = scene.bodies.inverse_mass[2 * b] > 0 ? now.colours[static_cast<std::size_t>(b)] : none;
        used = of_a | of_b;
        const int colour = std::min(63, std::countr_one(used));
        of_a |= std::uint64_t{1} << colour;
        of_b |= std::uint64_t{1} << colour;
        now.colour[i] = colour;
        ++count[colour];
    }
    int begin = 0;
    for (int& of_colour : count) begin += std::exchange(of_colour, begin);
    now.order.resize(m);
    for (std::size_t i = 0; i < m; ++i) now.order[static_cast<std::size_t>(count[now.colour[i]]++)] = static_cast<int>(i);
}

/// Who the rows are today, and all of them that a step does not change. λ stays where it is if they are yesterday's.
inline void begin_rows(const DiscScene& scene, const SmallStepSettings& settings, Real h, SmallStep& now)
{
    const std::size_t links = scene.links.size();
    now.contacts.clear();
    if (settings.collides)
        find_contacts(scene.bodies.x, scene.radius, scene.walls, scene.linked, settings.margin, now.contacts);
    const std::size_t m = links + now.contacts.size();
    now.keys.clear();
    for (std::size_t i = 0; i < links; ++i) now.keys.push_back(joint_key(i));
    for (const Contact& contact : now.contacts) now.keys.push_back(contact_key(contact));
    now.same_rows = now.keys == now.keys_before && now.cache.h == h;
    if (!now.same_rows) {
        // λ goes back to its keys, and from these to the rows of today.
        now.start.resize(static_cast<Index>(now.rows.size()));
        for (std::size_t k = 0; k < now.rows.size(); ++k) now.start[now.order[k]] = now.rows[k].lambda;
        if (now.cache.h > 0) store(now.cache, now.keys_before, now.start, now.cache.h);
        load(now.cache, now.keys, h, now.start);
        now.cache.h = h;
        now.keys_before = now.keys;
        if (settings.coloured) choose_colours(scene, now);
        else {
            now.order.resize(m);
            for (std::size_t i = 0; i < m; ++i) now.order[i] = static_cast<int>(i);
        }
        now.place.resize(m);
        for (std::size_t k = 0; k < m; ++k) now.place[static_cast<std::size_t>(now.order[k])] = static_cast<int>(k);
        now.rows.resize(m);
        now.rest.resize(m);
    }
    const Index K = scene.bodies.count();
    for (std::size_t k = 0; k < m; ++k) {
        const auto i = static_cast<std::size_t>(now.order[k]);
        SolverRow<2>& row = now.rows[k];
        if (i < links) {
            if (now.same_rows) continue;
            const Link& link = scene.links[i];
            row.a = static_cast<int>(2 * link.a);
            row.b = static_cast<int>(2 * link.b);
            row.lo = -infinity;
            now.rest[k] = link.length;
        } else {
            const Contact& contact = now.contacts[i - links];
            if (contact.a == world) {
                row.Ja.setZero();
                row.Wa.setZero();
                row.Jb = contact.normal.transpose();
                row.Wb = scene.bodies.inverse_mass[2 * contact.b] * contact.normal;
                now.rest[k] = contact.normal.dot(scene.bodies.x.segment<2>(2 * contact.b)) - contact.gap;
            } else if (!now.same_rows) now.rest[k] = scene.radius[contact.a] + scene.radius[contact.b];
            if (now.same_rows) continue;
            row.a = static_cast<int>(2 * (contact.a == world ? K : contact.a));
            row.b = static_cast<int>(2 * contact.b);
            row.lo = 0;
        }
        const Real A = (row.a == 2 * K ? 0 : scene.bodies.inverse_mass[row.a]) + scene.bodies.inverse_mass[row.b];
        row.mass = A > 0 ? 1 / A : 0;
        row.hi = infinity;
        row.lambda = now.start[static_cast<Index>(i)];
    }
}

/// J, W where the bodies are now. \return C [m]
inline Real refresh(const VecX& x, const VecX& inverse_mass, Real rest, SolverRow<2>& row)
{
    if (row.a == inverse_mass.size()) return row.Jb.dot(x.segment<2>(row.b)) - rest;  // a wall is flat
    Vec2 n = x.segment<2>(row.b) - x.segment<2>(row.a);
    const Real distance = n.norm();
    if (distance > 0) n /= distance; else n = {0, 1};
    row.Ja = -n.transpose();
    row.Jb = n.transpose();
    row.Wa = -inverse_mass[row.a] * n;
    row.Wb = inverse_mass[row.b] * n;
    return distance - rest;
}

//! [small_steps]
/// One time step. Depends on its arguments alone.
inline void small_steps(DiscScene& scene, const SmallStepSettings& settings, SmallStep& now)
{
    require_step(settings.h);
    Bodies<2>& bodies = scene.bodies;
    const Real h = settings.h / settings.substeps;
    const Vec2 gain = h * settings.gravity;
    begin_rows(scene, settings, h, now);
    now.u.resize(bodies.u.size() + 2);
    now.u << bodies.u, 0, 0;

    now.visits = 0;
    const auto m = static_cast<std::int64_t>(now.rows.size());
    for (int n = 0; n < settings.substeps; ++n) {
        for (Index k = 0; k < bodies.u.size(); k += 2)
            if (bodies.inverse_mass[k] > 0) now.u.segment<2>(k) += gain;
        for (std::size_t k = 0; k < now.rows.size(); ++k) {
            SolverRow<2>& row = now.rows[k];
            const Real C = refresh(bodies.x, bodies.inverse_mass, now.rest[k], row);
            row.bias = row.lo == 0 && C > 0 ? C / h : 0;
            now.u.segment<2>(row.a) += row.Wa * row.lambda;
            now.u.segment<2>(row.b) += row.Wb * row.lambda;
        }
        for (int s = 0; s < settings.sweeps; ++s)
            for (SolverRow<2>& row : now.rows) visit(row, now.u);
        now.visits += m * settings.sweeps;
        for (int s = settings.sweeps; s < settings.max_sweeps; ++s) {
            Real change = 0;
            for (SolverRow<2>& row : now.rows) change = std::max(change, std::abs(visit(row, now.u)) * (row.Jb.dot(row.Wb)-row.Ja.dot(row.Wa)));
            now.visits += m;
            if (change <= settings.tolerance) break;
        }
        bodies.x += h * now.u.head(bodies.x.size());
    }
    bodies.u = now.u.head(bodies.u.size());

    // What is left of the error goes out of x, row by row as they are given.
    for (int s = 0; s < settings.repay.repaying_sweeps; ++s)
        for (const int k : now.place) {
            SolverRow<2>& row = now.rows[static_cast<std::size_t>(k)];
            const Real C = refresh(bodies.x, bodies.inverse_mass, now.rest[static_cast<std::size_t>(k)], row);
            const Real move = -row.mass * settings.h * baumgarte_bias(C, row.lo < 0, settings.repay, settings.h);
            if (move == 0) continue;
            if (row.a != bodies.x.size()) bodies.x.segment<2>(row.a) += row.Wa * move;
            bodies.x.segment<2>(row.b) += row.Wb * move;
        }
}
//! [small_steps]

}  // namespace rigid
