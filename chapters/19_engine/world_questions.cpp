/// \file world_questions.cpp
/// What a caller asks of a world as a whole: rays, shapes on their way, overlaps, contacts.
#include "common/eigen_instances.hpp"

#include "chapters/19_engine/world.hpp"

#include "chapters/19_engine/world_cpp.hpp"

namespace rigid {

std::optional<Met> World::ray(const Vec2& from, const Vec2& way,
                              const Filter& filter) const
{
    if (!from.allFinite() || !way.allFinite())
        throw std::invalid_argument("the ray goes from (" + shortest(from.x()) +
                                    ", " + shortest(from.y()) + ") m along (" +
                                    shortest(way.x()) + ", " + shortest(way.y()) +
                                    ") m; they must be finite");
    place_moved(*state_);
    return first_on_ray(*state_, {from, way}, filter);
}
std::optional<Met> World::cast(const Polygon& shape, const Vec2& from, Real angle,
                               const Vec2& way, const Filter& filter) const
{
    require_valid(shape);
    const Vec<3> pose(from.x(), from.y(), angle);
    if (!pose.allFinite() || !way.allFinite())
        throw std::invalid_argument("the shape goes from (" + shortest(from.x()) +
                                    ", " + shortest(from.y()) + ") m along (" +
                                    shortest(way.x()) + ", " + shortest(way.y()) +
                                    ") m; they must be finite");
    place_moved(*state_);
    return first_on_way(*state_, shape, pose, way, filter);
}
std::vector<BodyId> World::overlapping(const Polygon& shape, const Vec2& at,
                                       Real angle, const Filter& filter) const
{
    require_valid(shape);
    if (!at.allFinite() || !std::isfinite(angle))
        throw std::invalid_argument("the shape is at (" + shortest(at.x()) + ", " +
                                    shortest(at.y()) + ") m at the angle " +
                                    shortest(angle) + " rad; they must be finite");
    place_moved(*state_);
    const PlacedShape placed(shape, {at.x(), at.y(), angle});
    std::vector<BodyId> found;
    for_each_overlap(*state_, placed.view(), filter,
                     [&](int k) { found.push_back(state_->id(k)); });
    std::sort(found.begin(), found.end());
    return found;
}
std::vector<BodyId> World::at(const Vec2& point, const Filter& filter) const
{
    return overlapping(disc(0), point, 0, filter);
}

void World::contacts(std::vector<ContactView>& list) const
{
    const State& s = *state_;
    list.clear();
    if (s.work.skipped || !s.is_answered()) return;
    for (std::size_t i = 0; i < s.now.sources.size(); ++i) {
        const Source& source = s.now.sources[i];
        if (source.of != Source::Of::contact || source.part != normal_part)
            continue;
        const Contact& c = s.now.contacts[static_cast<std::size_t>(source.index)];
        Touch touch{s.id(c.a), s.id(c.b), {}};
        if (c.a == world) touch.wall = s.walls.id(wall_of(s.scene, c));
        list.push_back({touch, c.point, c.normal, c.gap,
                        s.now.solution.lambda[static_cast<Index>(i)]});
    }
}

}  // namespace rigid
