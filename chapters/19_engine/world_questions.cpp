/// \file world_questions.cpp
/// What a caller asks of a world as a whole: rays, shapes on their way, overlaps, contacts.
#include "common/eigen_instances.hpp"

#include "chapters/19_engine/world.hpp"

#include "chapters/19_engine/contact_lists.hpp"
#include "chapters/19_engine/world_cpp.hpp"

namespace rigid {

namespace {

void require_way(const std::string& what, const Vec2& from, const Vec2& way)
{
    const auto within = [](const Vec2& x) {
        return (x.array().abs() <= largest_number).all();
    };
    if (within(from) && within(way)) return;
    const bool finite = from.allFinite() && way.allFinite();
    throw std::invalid_argument(
        "the " + what + " goes from (" + shortest(from.x()) + ", " +
        shortest(from.y()) + ") m along (" + shortest(way.x()) + ", " +
        shortest(way.y()) + ") m; " +
        (finite ? "none of these may be beyond 1e75" : "they must be finite"));
}
Vec<3> require_cast(const Polygon& shape, const Vec2& from, Real angle,
                    const Vec2& way)
{
    require_valid(shape);
    require_way("shape", from, way);
    if (!std::isfinite(angle))
        throw std::invalid_argument("the shape goes from an angle of " +
                                    shortest(angle) + " rad; it must be finite");
    return {from.x(), from.y(), angle};
}

}  // namespace

void World::prepare_questions() const { place_moved(*state_); }

std::optional<Met> World::ray(const Vec2& from, const Vec2& way,
                              const Filter& filter) const
{
    require_way("ray", from, way);
    place_moved(*state_);
    FirstMet first;
    meet_on_ray(*state_, {from, way}, filter, first);
    return first.met;
}
std::vector<Met> World::ray_all(const Vec2& from, const Vec2& way,
                                const Filter& filter) const
{
    require_way("ray", from, way);
    place_moved(*state_);
    AllMet all;
    meet_on_ray(*state_, {from, way}, filter, all);
    return all.sorted();
}
std::optional<Met> World::cast(const Polygon& shape, const Vec2& from, Real angle,
                               const Vec2& way, const Filter& filter) const
{
    const Vec<3> pose = require_cast(shape, from, angle, way);
    place_moved(*state_);
    FirstMet first;
    meet_on_way(*state_, shape, pose, way, filter, first);
    return first.met;
}
std::vector<Met> World::cast_all(const Polygon& shape, const Vec2& from, Real angle,
                                 const Vec2& way, const Filter& filter) const
{
    const Vec<3> pose = require_cast(shape, from, angle, way);
    place_moved(*state_);
    AllMet all;
    meet_on_way(*state_, shape, pose, way, filter, all);
    return all.sorted();
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
    list.clear();
    list_contacts(
        *state_, [](const Contact&) { return true; }, list);
}
void World::contacts(BodyId body, std::vector<ContactView>& list) const
{
    const State& s = *state_;
    const Index k = s.number(body);
    list.clear();
    if (is_asleep(s, k)) list_resting_contacts(s, k, list);
    else
        list_contacts(
            s, [k](const Contact& c) { return c.a == k || c.b == k; }, list);
}
void World::moved(std::vector<BodyId>& list) const
{
    const State& s = *state_;
    list.clear();
    if (s.work.skipped) return;
    for (const int k : s.now.active)
        if (s.was_there(k)) list.push_back(s.id(k));
}

}  // namespace rigid
