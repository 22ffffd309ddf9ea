/// \file solving.hpp
/// How islands are to be solved, and the unit in which a solve is paid for.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace rigid {

/// Which solver an island of bodies gets. (A solver by colours and lanes is a further one: see
/// IslandChoice.)
enum class Solving : std::uint8_t {
    by_island,  ///< exact where that is cheap or sweeps would be slow, else sweeps
    exact,      ///< whatever can be exact
    sweeps,     ///< no island exactly
};

constexpr std::string_view to_string(Solving solving)
{
    constexpr std::string_view names[] = {"by_island", "exact", "sweeps"};
    return names[static_cast<std::size_t>(solving)];
}

//! [price]
/// What work costs, in entries of a matrix in a sparse factor; each about 1 ns.
namespace price {
constexpr int visit = 8;             ///< of a row, by a sweep
constexpr int lane_visit = 2;        ///< by a sweep in lanes
constexpr int solved_joint = 20;     ///< row of a tree of joints, in each solve
constexpr int factored_joint = 200;  ///< and in each factor
}  // namespace price
//! [price]

}  // namespace rigid
