// The functions of visit_levels.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/25_world_in_space/visit_levels.hpp"

namespace rigid {

//! [levels]
void VisitLevels::add(const ConeRows& rows, int island, std::size_t first,
                      const Bodies<6>& bodies)
{
    const auto moved = [&bodies](int place) {
        return bodies.can_move(place / 6) ? Index{place / 6} : world;
    };
    first_run[static_cast<std::size_t>(island)] = static_cast<int>(runs.size());
    for (std::size_t k = 0; k < rows.rows.size();) {
        LevelRun run = run_at(rows, k);
        run.island = island;
        run.first = static_cast<int>(first + k);
        run.level = next_level(level, moved(rows.rows[k].a), moved(rows.rows[k].b));
        levels = std::max(levels, run.level);
        runs.push_back(run);
        k += static_cast<std::size_t>(run.rows());
    }
}
//! [levels]

void VisitLevels::sort()
{
    const auto bin = [](const LevelRun& run) {
        return static_cast<std::size_t>(run.level * LevelRun::shapes + run.shape());
    };
    bins.assign(static_cast<std::size_t>((levels + 1) * LevelRun::shapes) + 1, 0);
    for (const LevelRun& run : runs) ++bins[bin(run) + 1];
    std::partial_sum(bins.begin(), bins.end(), bins.begin());
    order.resize(runs.size());
    for (std::size_t i = 0; i < runs.size(); ++i)
        order[static_cast<std::size_t>(bins[bin(runs[i])]++)] = static_cast<int>(i);
}

LevelRun VisitLevels::run_at(const ConeRows& p, std::size_t k)
{
    LevelRun run;
    run.kind = kind_at(p, k);
    const std::size_t each = run.kind == RunKind::discs ? 2 : 1;
    for (std::size_t i = k; i < p.rows.size() && run.items < LevelRun::most &&
                            p.rows[i].a == p.rows[k].a &&
                            p.rows[i].b == p.rows[k].b && kind_at(p, i) == run.kind;
         i += each)
        ++run.items;
    return run;
}

}  // namespace rigid
