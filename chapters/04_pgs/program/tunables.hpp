/// \file tunables.hpp
/// What the reader may change in more than one program: one name, one unit and one sentence for each; value and range are
/// the scene's. And the scenes themselves that several programs run.
#pragma once

#include "common/elementary.hpp"
#include "common/program/program.hpp"
#include "common/scenes.hpp"

#include <cmath>
#include <string>
#include <vector>

namespace rigid {

namespace tunables {

/// A number of things: it restarts the scene.
inline Tunable count(const std::string& name, const std::string& help, Real value,
                     Real low, Real high, Keys keys = Keys::none)
{
    return {name, "", help, value, low, high, Numbers::whole, OnChange::restarts,
            keys};
}
inline Tunable links(Real value, Real low, Real high, Keys keys = Keys::none)
{
    return count("links", "N, links of 0.1 m", value, low, high, keys);
}
inline Tunable in_column(const std::string& name, Real value, Real high = 100,
                         Keys keys = Keys::none)
{
    return count(name, "N, discs in the column", value, 1, high, keys);
}
inline Tunable base(Real low, Real high, Keys keys = Keys::none)
{
    return count("base", "discs in the lowest row", 10, low, high, keys);
}

/// What the scene begins with: it restarts the scene.
inline Tunable at_start(const std::string& name, const std::string& unit,
                        const std::string& help, Real value, Real low, Real high,
                        Keys keys = Keys::none)
{
    return {name, unit, help, value, low, high, Numbers::real, OnChange::restarts,
            keys};
}
inline Tunable top_mass(Real value, Real low = 0.01)
{
    return at_start("top_mass", "kg",
                    "mass of the uppermost disc; the others have 1 kg", value, low,
                    1000);
}
inline Tunable end_mass(Real value)
{
    return at_start("end_mass", "kg", "mass of the last disc; the others have 1 kg",
                    value, 0.01, 1000);
}

/// What may change while the scene runs.
inline Tunable number(const std::string& name, const std::string& unit,
                      const std::string& help, Real value, Real low, Real high,
                      Keys keys = Keys::none)
{
    return {name, unit, help, value, low, high, Numbers::real, OnChange::goes_on,
            keys};
}
inline Tunable whole(const std::string& name, const std::string& help, Real value,
                     Real low, Real high, Keys keys = Keys::none)
{
    return {name, "", help, value, low, high, Numbers::whole, OnChange::goes_on,
            keys};
}
/// \param of  "of gauss_seidel: ", for instance
inline Tunable max_sweeps(Real value, Real low = 1, const std::string& of = "",
                          Keys keys = Keys::none)
{
    return whole("max_sweeps",
                 of + "after so many sweeps a step makes do with what it has",
                 value, low, 2000, keys);
}
inline Tunable digits(const std::string& of = "")
{
    return number("digits", "", of + "the residual is to be below 10^-digits m/s",
                  6, 1, 12);
}
inline Tunable order(const std::string& of = "")
{
    Tunable one = whole(
        "order",
        of + "order of the visits: 0 as the rows come, 1 reversed, 2 shuffled", 0,
        0, 2);
    one.names = {"given", "reversed", "shuffled"};
    return one;
}
/// Of the sweeps that a program has beside its own method, to compare.
inline std::vector<Tunable> sweeps_to_compare()
{
    const std::string of = "of gauss_seidel: ";
    return {max_sweeps(10, 1, of), digits(of), order(of)};
}
/// The order of the rows, as in chapter 6.
inline Tunable row_order()
{
    Tunable one = whole(
        "order", "of the rows: 0 given, 1 alternating, 2 shuffled, 3 coloured", 0,
        0, 3);
    one.names = {"given", "alternating", "shuffled", "coloured"};
    return one;
}
inline Tunable restitution(Real value)
{
    return number("restitution", "", "e of every contact", value, 0, 1);
}
inline Tunable gravity(const std::string& help = "size of gravity")
{
    return number("gravity", "m/s²", help, 9.81, 0, 20);
}
inline Tunable margin(Real low)
{
    return number("margin", "m",
                  "a contact gets its row when its gap is below this", 0.02, low,
                  0.1);
}
inline Tunable beta(Real value, Real high, Keys keys = Keys::none)
{
    return number("beta", "", "part of an error that is corrected in a step", value,
                  0, high, keys);
}
inline Tunable slop()
{
    return number("slop", "m", "an overlap that is left alone", 0, 0, 0.02);
}
inline Tunable substeps(Real high)
{
    return whole("substeps", "small steps in a step", 1, 1, high);
}

}  // namespace tunables

/// `first` in front of what all scenes of a program share.
inline std::vector<Tunable> with(std::vector<Tunable> first,
                                 const std::vector<Tunable>& shared)
{
    first.insert(first.end(), shared.begin(), shared.end());
    return first;
}

/// Another value to begin with.
inline void preset(Demo& demo, const std::string& name, Real value)
{
    for (Tunable& tunable : demo.tunables)
        if (tunable.name == name) tunable.value = value;
}

/// The same scene with discs that are there to be seen: they do not collide with each other.
inline DiscScene never_meeting(DiscScene scene)
{
    scene.linked = PairSet::all();
    return scene;
}

/// A hanging chain that starts a little aside, as a pendulum, and whose discs never meet.
inline DiscScene leaning_chain(Index count, Real end_mass)
{
    DiscScene chain = never_meeting(hanging_chain(count, end_mass));
    for (Index k = 1; k <= count; ++k)
        chain.bodies.position(k) =
            0.1 * static_cast<Real>(k) * Vec2(sin(0.2), -cos(0.2));
    return chain;
}

}  // namespace rigid
