/// \file choice_rule.hpp
/// From the shape of an island: whether it may be solved exactly, whether it should be, and how many sweeps it is worth.
#pragma once

#include "chapters/18_islands/island_shape.hpp"

namespace rigid {

//! [rule]
struct ChoiceRule {
    /// islands of up to so many bounded rows: a doll, its limits and contacts
    int always = 64;
    int at_most = 4000;   ///< bounded rows, whatever the price
    Real patience = 500;  ///< sweeps; where more are needed they are no way
    /// heaps of so many rows go to lanes, with momentum where they stand
    int wide = 65;
    /// and so many where joints stand; a heap of as many is swept first, whatever
    /// an exact solve may cost
    int large = 1000;
    /// and so many where joints move: each step sweeps over them some 600 times
    int wide_joined = 300;
    /// entries of matrices that one solve may look at: some 40 ms
    std::int64_t entries = 40'000'000;
    /// and sweeps over a heap that comes to rest, if that is enough: about a second
    std::int64_t rest_entries = 800'000'000;
    /// and for each pair of its rows with bounds (18.7): what is solved needs half
    std::int64_t pair_entries = 500;
    /// proximal steps without a better residual: ε falls to its least in 37
    int idle_steps = 60;
    /// a heap that moves, of up to so many bounded rows, is swept with all patience
    int moving = 300;
    /// and what moves on joints is solved exactly, where that costs less
    int moving_joined = 600;
    /// sweeps over one with joints that moves: with 500 the knees of ten dolls bend
    /// 0.04 rad too far, with 1000 0.01
    int joined = 1000;
    /// what moves on pins is solved exactly with up to so many rows of contacts: a
    /// limb that has landed
    int few = 8;
    /// and with more of them goes by small steps, if masses differ by no more
    Real stepped_ratio = 100;
    /// sweeps above joints that are held: with 40 a knee that is struck was 0.1 rad
    /// beyond its limit
    int held = 100;
};

/// A residual to which what rests is solved [m/s]: what is left adds up from step
/// to step, and would keep it awake.
inline Real settled(Real tolerance) { return tolerance / 1000; }

/// A sweep with momentum over so many rows, at most: what goes further costs up to
/// as much again [entries]
inline std::int64_t price_of_momentum(std::int64_t rows)
{
    return 2 * rows * price::lane_visit;
}
/// Whether an island may be solved exactly, and whether it should be.
inline bool may_be_exact(const IslandShape& shape, const ChoiceRule& rule)
{
    return shape.bounded <= rule.at_most &&
           shape.price_of_exact() <= static_cast<Real>(rule.entries);
}
inline bool should_be_exact(const IslandShape& shape, const ChoiceRule& rule)
{
    if (!may_be_exact(shape, rule)) return false;
    if (shape.bounded + shape.loops <= rule.always) return true;
    if (shape.has_joints())
        return shape.sweeps_needed() > rule.patience ||
               shape.price_of_exact() < shape.price_of_sweeps();
    // a heap goes to lanes, a large one in any case
    return shape.rows < rule.large &&
           shape.price_of_exact() <
               shape.sweeps_with_momentum() * Real(price_of_momentum(shape.rows));
}
/// What an exact solve of an island that comes to rest may cost: what is stuck is
/// guessed a few times, and each guess has a factor. 0 where that is too much.
inline std::int64_t rest_price(const IslandShape& shape, const ChoiceRule& rule)
{
    const Real most = Real(rule.entries), some = most / 10;
    if (!may_be_exact(shape, rule)) return std::int64_t(some);
    const Real guessed = 4 * shape.price_of_exact();
    if (shape.rows >= rule.large && guessed > most) return 0;  // by sweeps
    return std::int64_t(std::clamp(guessed, some, most));
}
/// Sweeps with momentum over a heap that comes to rest and that no exact solve may
/// end: up to 23 N are needed (section 18.D). 0 where that is too much.
inline int sweeps_to_rest(const IslandShape& shape, const ChoiceRule& rule)
{
    if (shape.has_joints() || may_be_exact(shape, rule)) return 0;
    const std::int64_t sweeps = 30 * std::int64_t{shape.length};
    const bool fits = sweeps * price_of_momentum(shape.rows) <= rule.rest_entries;
    return fits ? static_cast<int>(sweeps) : 0;
}
/// Sweeps that may go over an island: as many as it needs, if it may be swept.
inline int sweeps_worth(const IslandShape& shape, const ChoiceRule& rule, int least)
{
    const Real needed = shape.sweeps_needed();
    if (!(needed <= rule.patience)) return least;
    return std::max(least, static_cast<int>(1.5 * needed));
}
/// Over one that moves: to the end if it has joints, with all patience if it is a
/// small heap.
inline int sweeps_of_moving(const IslandShape& shape, const ChoiceRule& rule,
                            int least)
{
    if (shape.has_joints()) return std::max(least, rule.joined);
    if (shape.bounded > rule.moving) return sweeps_worth(shape, rule, least);
    return std::max(least, static_cast<int>(rule.patience));
}
/// Whether these end, (18.1): it begins near its answer, so a tenth of the count is
/// enough.
inline bool may_be_swept(const IslandShape& shape, const ChoiceRule& rule)
{
    const Real sweeps = shape.has_joints() ? rule.joined : rule.patience;
    return shape.sweeps_needed() <= 10 * sweeps;
}
/// Of one that moves: whether small steps get through it. What they leave of its
/// joints goes out by their trees.
inline bool may_step(const IslandShape& shape, const ChoiceRule& rule)
{
    return !shape.has_joints() ||
           (shape.loops == 0 && shape.mass_ratio <= rule.stepped_ratio);
}
/// Of one with joints that moves: whether an exact solve costs less.
inline bool sweeps_cost_more(const IslandShape& shape, const ChoiceRule& rule)
{
    return may_be_exact(shape, rule) && shape.bounded <= rule.moving_joined &&
           shape.price_of_exact() < price::visit * Real(shape.rows) * rule.joined;
}
//! [rule]

}  // namespace rigid
