// The functions of push_joints.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/26_four_ways/push_joints.hpp"

#include "chapters/12_contact_manifolds/manifold.hpp"
#include "chapters/12_contact_manifolds/wall_manifold.hpp"
#include "common/pair_set.hpp"

#include <algorithm>
#include <utility>

namespace rigid {

namespace {

Vec2 into_body(const VecX& x, Index k, const Vec2& p)
{
    const Vec2 d = p - x.segment<2>(3 * k);
    const Real c = cos(x[3 * k + 2]), s = sin(x[3 * k + 2]);
    return {c * d.x() + s * d.y(), -s * d.x() + c * d.y()};
}

Vec2 direction_in_body(const VecX& x, Index k, const Vec2& n)
{
    return into_body(x, k, x.segment<2>(3 * k) + n);
}

PushJoint of_wall(const JointedScene& scene, std::size_t wall, Index b, int vertex)
{
    const HalfSpace& half = scene.walls[wall];
    const Polygon& shape = scene.shapes[static_cast<std::size_t>(b)];
    PushJoint one;
    one.gap.measure = PointJoint::Measure::along;
    one.gap.b = b;
    one.gap.at_b = shape.vertices[static_cast<std::size_t>(vertex)];
    one.gap.direction = half.normal;
    one.gap.length = half.offset + shape.radius;
    one.gap.kind = ConstraintKind::unilateral;
    one.radius = shape.radius;
    if (!scene.surfaces.empty() && !scene.wall_surfaces.empty())
        one.surface = combined(scene.surfaces[static_cast<std::size_t>(b)],
                               scene.wall_surfaces[wall]);
    return one;
}

PushJoint of_pair(const JointedScene& scene, Index a, Index b, const Manifold& m,
                  const ManifoldPoint& point, int edges_of_a)
{
    const VecX& x = scene.bodies.x;
    const auto radius = [&](Index k) {
        return scene.shapes[static_cast<std::size_t>(k)].radius;
    };
    PushJoint one;
    Vec2 n = m.normal;
    one.gap.a = a, one.gap.b = b;
    if (m.face >= edges_of_a) {  // the side is b's
        std::swap(one.gap.a, one.gap.b);
        n = -n;
    }
    const Real ra = radius(one.gap.a), rb = radius(one.gap.b);
    one.gap.at_a = into_body(x, one.gap.a, point.point - (ra + point.gap / 2) * n);
    one.gap.at_b = into_body(x, one.gap.b, point.point + (rb + point.gap / 2) * n);
    one.gap.measure =
        m.face < 0 ? PointJoint::Measure::distance : PointJoint::Measure::turning;
    one.gap.direction = direction_in_body(x, one.gap.a, n);
    one.gap.length = ra + rb;
    one.gap.kind = ConstraintKind::unilateral;
    one.radius = rb;
    if (!scene.surfaces.empty())
        one.surface = combined(scene.surfaces[static_cast<std::size_t>(a)],
                               scene.surfaces[static_cast<std::size_t>(b)]);
    return one;
}

/// Pairs whose boxes overlap, the first grown by the margin, ascending: by the left
/// ends of the boxes, as in chapter 10.
std::vector<PairSet::Pair> pairs_of_boxes(const std::vector<PlacedShape>& placed,
                                          Real margin)
{
    struct Shadow {
        Box box, wide;
        Index k;
    };
    std::vector<Shadow> shadows;
    for (const PlacedShape& one : placed) {
        const Box box = box_of(one.view());
        shadows.push_back(
            {box, grown(box, margin), static_cast<Index>(shadows.size())});
    }
    std::stable_sort(shadows.begin(), shadows.end(),
                     [](const Shadow& a, const Shadow& b) {
                         return a.wide.low.x() < b.wide.low.x();
                     });
    std::vector<PairSet::Pair> pairs;
    for (auto i = shadows.begin(); i != shadows.end(); ++i)
        for (auto j = i + 1;
             j != shadows.end() && j->wide.low.x() <= i->wide.high.x(); ++j) {
            const auto [a, b] =
                i->k < j->k ? std::pair(&*i, &*j) : std::pair(&*j, &*i);
            if (overlap(a->wide, b->box)) pairs.emplace_back(a->k, b->k);
        }
    std::sort(pairs.begin(), pairs.end());
    return pairs;
}

}  // namespace

void require_valid(const EventSettings& settings)
{
    require_not_negative(
        {{"the gap that is closed", settings.gap},
         {"the speed at which a contact rests", settings.rest_speed}});
    if (settings.most_events < 1)
        throw std::invalid_argument("the number of events in a step is " +
                                    std::to_string(settings.most_events) +
                                    "; it must be at least 1");
}

void require_fits(const CollisionFilter& filter, std::size_t bodies)
{
    const auto require = [bodies](const char* list, std::size_t size,
                                  std::size_t right) {
        if (size != 0 && size != right)
            throw std::invalid_argument(
                std::string("the filter of collisions has ") +
                std::to_string(size) + " " + list + " for " +
                std::to_string(bodies) + " bodies; it must be empty or have " +
                std::to_string(right));
    };
    require("groups", filter.group.size(), bodies);
    require("filters", filter.filters.size(), bodies);
    require("beginnings of its list of pairs", filter.first.size(), bodies + 1);
    for (const std::uint8_t group : filter.group)
        if (group >= most_groups)
            throw std::invalid_argument(
                "the filter of collisions has the group " + std::to_string(group) +
                "; there are groups 0 to " + std::to_string(most_groups - 1));
    const std::vector<int>& first = filter.first;
    if (!first.empty() &&
        (first.front() != 0 || !std::is_sorted(first.begin(), first.end()) ||
         first.back() != std::ssize(filter.partner)))
        throw std::invalid_argument(
            "the list of pairs of the filter of collisions does not begin at 0, "
            "ascend and end at its " +
            std::to_string(filter.partner.size()) + " partners");
}

void require_valid_motion(const JointedScene& scene, const CollisionFilter& filter,
                          std::string_view otherwise)
{
    require_valid(static_cast<const RigidScene&>(scene));
    require_valid_surfaces(scene);
    require_fits(filter, scene.shapes.size());
    if (!scene.gravity.allFinite())
        throw std::invalid_argument("gravity is not finite");
    if (scene.cloth.friction > 0)
        throw std::invalid_argument("the scene lies on a cloth; springs, impulses "
                                    "all at once and positions "
                                    "have rows for it, this way has none");
    if (!scene.chains.empty())
        throw std::invalid_argument(
            "the scene has " + std::to_string(scene.chains.size()) +
            " chains of edges that are solid on one side; springs, impulses all at "
            "once and positions take them, this way has both sides alone");
    if (!scene.carried.empty())
        throw std::invalid_argument("the scene has bodies of several shapes; this "
                                    "way has one shape to a body");
    for (const std::vector<Surface>* const list :
         {&scene.surfaces, &scene.wall_surfaces})
        for (const Surface& surface : *list)
            if (surface.rolling > 0)
                throw std::invalid_argument(
                    "a surface resists rolling with an arm of " +
                    shortest(surface.rolling) +
                    " m; springs, impulses all at once and positions have rows "
                    "for it, this way has none");
    for (const PointJoint& joint : scene.joints)
        if (!has_error(joint.kind))
            throw std::invalid_argument("a joint has a motor or a spring; " +
                                        std::string(otherwise));
    for (std::size_t i = 0; i < scene.placed.size(); ++i) {
        const PlacedJoint& one = scene.placed[i];
        if (one.broken || one.joint.breaking_force < infinity ||
            one.joint.breaking_torque < infinity)
            throw std::invalid_argument(
                "joint " + std::to_string(i) +
                (one.broken ? " is broken" : " may break") +
                "; this way holds each joint of a scene, and for good");
    }
}

void require_one_friction(const JointedScene& scene)
{
    if (has_kinetic_friction(scene))
        throw std::invalid_argument(
            "a surface has a smaller coefficient of friction while it slides; this "
            "way has one coefficient for both");
}

Real closing_reach(const JointedScene& scene, Real length, Real h)
{
    Real fastest = scene.gravity.norm() * h;
    for (Index k = 0; k < scene.bodies.count(); ++k) {
        const Polygon& shape = scene.shapes[static_cast<std::size_t>(k)];
        Real arm = length;
        for (const Vec2& vertex : shape.vertices)
            arm = std::max(arm, vertex.norm() + shape.radius);
        const auto u = scene.bodies.velocity(k);
        fastest = std::max(fastest, u.head<2>().norm() + std::abs(u[2]) * arm);
    }
    return 2 * h * fastest;
}

void find_push_joints(const JointedScene& scene, const CollisionFilter& filter,
                      Real margin, std::vector<PushJoint>& found)
{
    found.clear();
    const Bodies<3>& bodies = scene.bodies;
    for (const PointJoint& joint : scene.joints)
        if (joint.kind == ConstraintKind::unilateral) {
            PushJoint one;
            one.gap = joint;
            one.touches = false;
            found.push_back(one);
        }
    std::vector<PlacedShape> placed;
    for (Index k = 0; k < bodies.count(); ++k)
        placed.emplace_back(scene.shapes[static_cast<std::size_t>(k)],
                            bodies.position(k));
    for (Index b = 0; b < bodies.count(); ++b) {
        if (!bodies.can_move(b)) continue;
        const Placed shape = placed[static_cast<std::size_t>(b)].view();
        for (std::size_t w = 0; w < scene.walls.size(); ++w) {
            const Manifold m = collide(scene.walls[w], shape, margin);
            for (int i = 0; i < m.count; ++i)
                found.push_back(of_wall(
                    scene, w, b, m.points[static_cast<std::size_t>(i)].feature));
        }
    }
    std::vector<PairSet::Pair> held;
    for (const PointJoint& joint : scene.joints)
        if (!joint.collides) held.emplace_back(joint.a, joint.b);
    const PairSet joined(std::move(held));
    const auto may_meet = [&](Index a, Index b) {
        return (bodies.can_move(a) || bodies.can_move(b)) &&
               filter.lets_meet(a, b) && !filter.forbids(a, b) &&
               !joined.contains(a, b);
    };
    for (const auto& [a, b] : pairs_of_boxes(placed, margin)) {
        if (!may_meet(a, b)) continue;
        const Placed pa = placed[static_cast<std::size_t>(a)].view(),
                     pb = placed[static_cast<std::size_t>(b)].view();
        const Manifold m = collide(pa, pb, {.margin = margin});
        for (int i = 0; i < m.count; ++i)
            found.push_back(of_pair(
                scene, a, b, m, m.points[static_cast<std::size_t>(i)], pa.edges()));
    }
}

}  // namespace rigid
