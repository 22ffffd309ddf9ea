// The functions of disc_grid.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/10_skipping_work/disc_grid.hpp"

namespace rigid {

void DiscGrid::reset(Index count, Real extra)
{
    extra_ = extra;
    std::size_t size = 16;
    while (size < 2 * static_cast<std::size_t>(count)) size *= 2;
    buckets_.assign(size, nobody);
    places_.assign(static_cast<std::size_t>(count), {});
    layers_.clear();
}

void DiscGrid::grow(Index count)
{
    places_.resize(static_cast<std::size_t>(count));
    if (buckets_.size() >= 2 * static_cast<std::size_t>(count)) return;
    buckets_.assign(2 * buckets_.size(), nobody);
    for (const Layer& layer : layers_)
        for (const int k : layer.members) enter(k, at(k).column, at(k).line);
}

void DiscGrid::insert(int k, const Vec2& x, Real radius, int group)
{
    Place& place = at(k);
    place.layer = layer_of(group, radius);
    place.radius = radius;
    Layer& layer = layers_[static_cast<std::size_t>(place.layer)];
    layer.largest = std::max(layer.largest, radius);
    place.member = static_cast<int>(layer.members.size());
    layer.members.push_back(k);
    place.x = x;
    enter(k, cell(x.x(), layer), cell(x.y(), layer));
}

void DiscGrid::remove(int k)
{
    leave(k);
    Place& place = at(k);
    std::vector<int>& members =
        layers_[static_cast<std::size_t>(place.layer)].members;
    at(members.back()).member = place.member;
    members[static_cast<std::size_t>(place.member)] = members.back();
    members.pop_back();
    place.layer = nobody;
}

std::size_t DiscGrid::bucket(int layer, int column, int line) const
{
    const std::uint64_t mixed =
        (static_cast<std::uint64_t>(line) * 0x9E3779B97F4A7C15u) >> 20;
    const std::uint64_t place = mixed + static_cast<std::uint64_t>(column) +
                                static_cast<std::uint64_t>(layer) * 0x85EBCA6Bu;
    return place & (buckets_.size() - 1);
}

int DiscGrid::layer_of(int group, Real radius)
{
    int level = 0;
    // = fraction · 2^level, ½ ≤ fraction < 1
    const Real fraction = std::frexp(2 * radius + extra_, &level);
    if (fraction == 0.5) --level;
    for (std::size_t l = 0; l < layers_.size(); ++l)
        if (layers_[l].group == group && layers_[l].level == level)
            return static_cast<int>(l);
    layers_.push_back({group, level, std::ldexp(1.0, -level), 0, {}});
    return static_cast<int>(layers_.size()) - 1;
}

void DiscGrid::enter(int k, int column, int line)
{
    Place& place = at(k);
    place.column = column;
    place.line = line;
    int& head = buckets_[bucket(place.layer, column, line)];
    place.before = nobody;
    place.next = head;
    if (head != nobody) at(head).before = k;
    head = k;
}

}  // namespace rigid
