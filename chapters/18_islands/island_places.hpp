/// \file island_places.hpp
/// Which islands a step has, and where each of them is solved.
///
///     it stands, or has few rows         exactly, or by sweeps until r ≤ tolerance ℓ
///     it moves, with joints              by up to a thousand sweeps, until r ≤ tolerance ℓ
///     it moves, a heap                   by small steps of its own; where something bounces, roughly:  r ≤ g h / 30        (18.5)
///                                        g h the most that this step's forces give one of its bodies
///
/// What moves has another λ in each step, and an error of one step is no error of the next; but a limit that is missed bends a
/// knee. Joints that sweeps would lose are held exactly all the same: they cost O(n), but for the loops that they close.
#pragma once

#include "chapters/10_skipping_work/islands.hpp"
#include "chapters/18_islands/choice_rule.hpp"
#include "chapters/18_islands/island_rescue.hpp"
#include "chapters/18_islands/known_motion.hpp"
#include "chapters/18_islands/turning_pins.hpp"

namespace rigid {

//! [place]
/// Where an island is solved.
enum class IslandPlace : std::uint8_t {
    exact,
    held,        ///< its joints at once, above them sweeps
    swept,       ///< exactly after all, where sweeps are not good enough
    only_swept,  ///< exactly in no case
};

/// \param moves  it is large, and does not stand
/// \param steps  by small steps of its own, then
/// \param fits   what closes the loops of its joints is affordable
inline IslandPlace choose_place(const IslandShape& shape, const ChoiceRule& rule,
                                Solving solving, bool moves, bool steps, bool fits)
{
    if (!fits || solving == Solving::sweeps || (steps && shape.has_joints()))
        return IslandPlace::only_swept;
    const bool has_joints = shape.has_joints();
    const bool ends = may_be_swept(shape, rule);
    if (moves && !has_joints && shape.bounded > rule.moving)
        return IslandPlace::only_swept;
    if (moves && !has_joints && ends) return IslandPlace::swept;
    if (moves && has_joints && !sweeps_cost_more(shape, rule))
        return ends ? IslandPlace::only_swept : IslandPlace::held;
    if (!may_be_exact(shape, rule))
        return has_joints ? IslandPlace::held : IslandPlace::only_swept;
    const bool is_tree = has_joints && shape.loops == 0;  // joints cost O(n)
    return solving == Solving::exact || is_tree || should_be_exact(shape, rule)
               ? IslandPlace::exact
               : IslandPlace::swept;
}
//! [place]

//! [part]
/// (18.6): the part t of the old impulses to start from, 0 … 1: that which leaves
/// the least energy.
/// \param v  zeros, of the length of u; they are zeros again afterwards
inline Real best_part(const StepData<3>& now, std::span<const int> rows,
                      std::span<const int> bodies, VecX& v)
{
    Real slope = 0, curve = 0;
    for (const int i : rows) {
        const Row<3>& row = now.rows[static_cast<std::size_t>(i)];
        const Real lambda = now.solution.lambda[i];
        slope += lambda * row.velocity(now.u_star);
        row.apply(lambda, v);
    }
    for (const int i : rows) {
        const Row<3>& row = now.rows[static_cast<std::size_t>(i)];
        const Real lambda = now.solution.lambda[i];
        curve += lambda * (speed_along(row, v) + row.softness * lambda);
    }
    for (const int k : bodies) v.segment<3>(3 * k).setZero();
    return curve > 0 ? std::clamp(-slope / curve, Real{0}, Real{1}) : 0;
}
//! [part]

struct IslandNote {
    IslandPlace place = IslandPlace::only_swept;
    bool joined = false;        ///< by joints
    bool trees = false;         ///< and they close no loop
    bool large = false;         ///< where it moves it is not like what stands
    bool moves = false;         ///< it is large, and does not stand
    bool steps = false;         ///< by small steps of its own, then
    bool to_sleep = false;      ///< by these until it sleeps
    int length = 0;             ///< N
    int sweeps = 0;             ///< where it is swept, at most
    int lanes = 1;              ///< from so many rows on it is swept in lanes
    bool may_be_exact = false;  ///< where sweeps leave too much
    std::int64_t to_stand = 0;  ///< entries that sweeps may cost where it stands
    int to_rest = 0;            ///< sweeps where it comes to rest; 0 = as it stands
    std::int64_t to_settle = 0;  ///< or entries of an exact solve; 0 = none
    Real enough = 0;             ///< a residual below this is none [m/s]
    Real until = 0;              ///< sweeps end at this one [m/s]
};

class IslandPlaces {
public:
    Islands islands;
    std::vector<IslandNote> notes;  ///< of each
    bool anew = true;               ///< they are to be listed again

    std::size_t count() const { return notes.size(); }
    const IslandNote& note(int island) const
    {
        return notes[static_cast<std::size_t>(island)];
    }
    IslandPlace place(int island) const { return note(island).place; }
    /// The residual above which it is solved exactly after all [m/s]
    Real rescued_above(int island) const
    {
        return place(island) == IslandPlace::swept ? note(island).enough : infinity;
    }

    //! [look]
    /// While rows and bodies are those of the step before, and what stood stands, so
    /// are islands and places.
    /// \param sweeps     over an island, where nothing else is said
    /// \param tolerance  [m/s]
    /// \return           whether they are those of the step before
    bool look(const Bodies<3>& bodies, const StepData<3>& now,
              const ChoiceRule& rule, Solving solving, int sweeps, Real tolerance)
    {
        const bool same = motion_.is_same(now.rows) && now.same_rows &&
                          now.same_bodies && !anew && moves_as_before(bodies, now);
        if (!same) {
            find_islands(bodies, now, {}, islands);
            notes.assign(static_cast<std::size_t>(islands.count()), {});
            for (std::size_t i = 0; i < notes.size(); ++i)
                if (!islands.rows_of(static_cast<int>(i)).empty())
                    notes[i] = look_at(static_cast<int>(i), bodies, now, rule,
                                       solving, sweeps);
        }
        anew = false;
        for (std::size_t i = 0; i < notes.size(); ++i) {  // (18.5)
            IslandNote& note = notes[i];
            note.enough = note.until = tolerance;
            if (!note.large) continue;
            const std::span<const int> members =
                islands.bodies_of(static_cast<int>(i));
            Real speed = given_speed(members, bodies.u, now.u_star);
            if (!note.moves)
                speed = std::min(speed, fastest(members, bodies.u, now.length));
            note.enough = std::max(tolerance, speed / 30);
            if (note.moves && !note.joined) note.until = note.enough;
        }
        return same;
    }
    //! [look]

private:
    bool moves(int island, const Bodies<3>& bodies, const StepData<3>& now) const
    {
        return !stand(islands.bodies_of(island), bodies.u, now.u_star, now.length);
    }
    bool moves_as_before(const Bodies<3>& bodies, const StepData<3>& now) const
    {
        for (std::size_t i = 0; i < notes.size(); ++i)
            if (notes[i].large && !notes[i].to_sleep &&
                notes[i].moves != moves(static_cast<int>(i), bodies, now))
                return false;
        return true;
    }

    //! [steps]
    /// Of rows that can all be in small steps, contacts, pins, and angles that nothing
    /// soft holds, how many are of contacts; else 0.
    static int can_step(std::span<const int> rows, const StepData<3>& now)
    {
        int contacts = 0;
        for (const int row : rows) {
            const auto at = static_cast<std::size_t>(row);
            const Constraint<3>& c = now.constraints[at];
            if (now.sources[at].of == Source::Of::contact) ++contacts;
            else if (!is_angle(c)) {
                if (!is_pin(now, row) && !(row > 0 && is_pin(now, row - 1)))
                    return 0;
            } else if (now.rows[at].softness > 0 ||
                       c.kind == ConstraintKind::spring ||
                       c.kind == ConstraintKind::inerter)
                return 0;
        }
        return contacts;
    }
    //! [steps]

    IslandNote look_at(int island, const Bodies<3>& bodies, const StepData<3>& now,
                       const ChoiceRule& rule, Solving solving, int sweeps)
    {
        IslandNote note;
        note.sweeps = sweeps;
        note.lanes = rule.large;
        if (solving == Solving::sweeps) return note;
        const IslandShape shape = survey_(bodies, now.rows, islands.rows_of(island),
                                          islands.bodies_of(island));
        note.joined = shape.has_joints();
        note.trees = note.joined && shape.loops == 0;
        note.length = shape.length;
        const int stepped =
            may_step(shape, rule) ? can_step(islands.rows_of(island), now) : 0;
        note.large =
            solving == Solving::by_island &&
            (shape.bounded > rule.always || (note.joined && stepped > rule.few));
        // what lies on joints is expensive to solve while it comes to rest
        note.to_sleep = note.large && note.joined && stepped > 0 &&
                        !sweeps_cost_more(shape, rule);
        note.moves = note.to_sleep || (note.large && moves(island, bodies, now));
        note.steps = note.moves && stepped > 0;
        if (!note.joined) note.lanes = rule.wide;
        else if (note.moves) note.lanes = rule.wide_joined;
        const bool fits = shape.price_of_loops() <= static_cast<Real>(rule.entries);
        note.place =
            choose_place(shape, rule, solving, note.moves, note.steps, fits);
        note.sweeps = note.moves ? sweeps_of_moving(shape, rule, sweeps)
                                 : sweeps_worth(shape, rule, sweeps);
        note.may_be_exact = may_be_exact(shape, rule);
        note.to_stand = note.may_be_exact
                            ? static_cast<std::int64_t>(shape.price_of_exact())
                            : rule.entries;
        note.to_rest = sweeps_to_rest(shape, rule);
        note.to_settle = rest_price(shape, rule);
        return note;
    }

    IslandSurveyor survey_;
    KnownMotion motion_;
};

}  // namespace rigid
