/// \file visit_levels.hpp
/// Which visits of a sweep can be made side by side while the sweep stays the same to the bit.
///
///     level of a visit = 1 + the highest level so far of the bodies that it moves                       (25.1)
///
/// Visits of one level move no body in common, so none changes what another reads, and their order among each other makes
/// no difference. Each comes after all visits that it follows on a body. So every body meets its rows in the order of the
/// sweep. (Chapter 17's colours choose an order of their own; this keeps the one that is there.)
#pragma once

#include "chapters/24_friction_is_a_disc/cone_rows.hpp"

#include <algorithm>
#include <numeric>
#include <vector>

namespace rigid {

/// What the rows of a run are: all of one kind, so that lanes do the same.
enum class RunKind : unsigned char {
    plain,    ///< rows with bounds of their own
    bounded,  ///< rows that another one bounds, each for itself
    discs     ///< pairs of rows that share a disc
};

//! [level]
/// (25.1): the level of a visit. It is then the highest level so far of the bodies
/// that the visit moves.
/// \param highest  of each body; 0 before the first visit
/// \param a, b     the two bodies; world: none, or one that cannot move
inline int next_level(std::vector<int>& highest, Index a, Index b)
{
    int level = 0;
    for (const Index k : {a, b})
        if (k != world)
            level = std::max(level, highest[static_cast<std::size_t>(k)]);
    ++level;
    for (const Index k : {a, b})
        if (k != world) highest[static_cast<std::size_t>(k)] = level;
    return level;
}
//! [level]

//! [run]
/// Neighbours among the rows, of one kind and between the same two bodies: their
/// velocities are read once, and written once.
struct LevelRun {
    static constexpr int most = 8;  ///< items; few, so that there are few shapes
    RunKind kind = RunKind::plain;
    int items = 0;  ///< rows, or discs
    int first = 0;  ///< row
    int level = 0, island = 0;
    int packet = 0, lane = 0;  ///< where it is visited (level_sweeps.hpp)

    int rows() const { return kind == RunKind::discs ? 2 * items : items; }
    /// runs of one shape can be visited side by side
    int shape() const { return static_cast<int>(kind) * most + items - 1; }
    static constexpr int shapes = 3 * most;
};
//! [run]

/// The runs of several islands. Memory is kept from step to step.
struct VisitLevels {
    std::vector<LevelRun> runs;  ///< as the rows come
    std::vector<int> first_run;  ///< of each island
    std::vector<int> order;      ///< run numbers, by level and shape
    std::vector<int> level;      ///< K: the highest so far of each body
    int levels = 0;
    std::vector<int> bins;  ///< for sorting

    void begin(Index bodies, int islands)
    {
        runs.clear();
        first_run.assign(static_cast<std::size_t>(islands), 0);
        level.assign(static_cast<std::size_t>(bodies), 0);
        levels = 0;
    }

    /// Cuts the rows of an island into runs, and gives each its level, (25.1).
    /// \param first   the number of its first row among all
    /// \param bodies  what of them cannot move has no level
    void add(const ConeRows& rows, int island, std::size_t first,
             const Bodies<6>& bodies);

    /// By level and shape, by counting.
    void sort();

private:
    static RunKind kind_at(const ConeRows& p, std::size_t k)
    {
        return p.disc(k)            ? RunKind::discs
               : p.bound_by(k) >= 0 ? RunKind::bounded
                                    : RunKind::plain;
    }

    static LevelRun run_at(const ConeRows& p, std::size_t k);
};

}  // namespace rigid
