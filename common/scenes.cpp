#include "common/scenes.hpp"

#include "common/elementary.hpp"
#include "common/random.hpp"
#include "common/text.hpp"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <stdexcept>
#include <string>

namespace rigid {

namespace {

[[noreturn]] void refuse(const std::string& what, Real value, const std::string& wanted)
{
    throw std::invalid_argument(what + " is " + shortest(value) + "; it must be " + wanted);
}

void require_body(const std::string& what, Index k, Index count)
{
    if (k < 0 || k >= count)
        throw std::invalid_argument(what + " names body " + std::to_string(k) +
                                    (count == 0
                                         ? "; the scene has no bodies"
                                         : "; the scene has bodies 0 to " + std::to_string(count - 1)));
}

/// An infinite mass is one: that disc cannot move.
void require_mass(Index k, Real mass)
{
    if (!(mass > 0)) refuse("the mass of disc " + std::to_string(k), mass, "positive");
    if (!std::isfinite(1 / mass))
        refuse("the mass of disc " + std::to_string(k), mass, "so large that its inverse is finite");
}

void place(DiscScene& scene, Index k, Vec2 position, Real mass, Real radius)
{
    require_mass(k, mass);
    scene.bodies.position(k) = position;
    scene.bodies.inverse_mass.segment<2>(2 * k).setConstant(1 / mass);
    scene.radius[k] = radius;
}

}  // namespace

void require_count(const std::string& what, Index count)
{
    if (count < 1) refuse("the number of " + what, static_cast<Real>(count), "1 or more");
}

void require_bodies(const DiscScene& scene)
{
    const Index K = scene.bodies.count();
    if (scene.radius.size() != K)
        throw std::invalid_argument("there are " + std::to_string(scene.radius.size()) + " radii for " +
                                    std::to_string(K) + " discs");
    const auto check = [K](const char* kind, std::size_t i, std::initializer_list<Index> bodies) {
        for (const Index k : bodies)
            if (k < 0 || k >= K) require_body(kind + std::to_string(i), k, K);  // the name is only made here
    };
    for (std::size_t i = 0; i < scene.links.size(); ++i)
        check("link ", i, {scene.links[i].a, scene.links[i].b});
    for (std::size_t i = 0; i < scene.bends.size(); ++i)
        check("bend ", i, {scene.bends[i].left, scene.bends[i].middle, scene.bends[i].right});
    for (std::size_t i = 0; i < scene.joints.size(); ++i) {
        const Joint& joint = scene.joints[i];
        check("joint ", i, {joint.a == world ? joint.b : joint.a, joint.b});
    }
}

Real typical_length(const DiscScene& scene)
{
    if (!(scene.length >= 0) || !std::isfinite(scene.length))
        refuse("the length of the scene", scene.length, "positive and finite, or zero to be derived");
    if (scene.length > 0) return scene.length;
    const Index K = std::min(scene.bodies.count(), scene.radius.size());
    Real sum = 0, movable = 0, count = 0;
    for (Index k = 0; k < K; ++k) {
        sum += scene.radius[k];
        if (!(scene.bodies.inverse_mass[2 * k] > 0)) continue;
        movable += scene.radius[k];
        ++count;
    }
    const Real mean = count > 0 ? movable / count : K > 0 ? sum / static_cast<Real>(K) : Real{0.1};
    if (!(mean > 0) || !std::isfinite(10 * mean))
        return 1;  // require_valid() says what is wrong with such radii
    return pow(10.0, std::round(log10(10 * mean)));
}

void link_neighbours(DiscScene& scene)
{
    const Index K = scene.bodies.count();
    for (std::size_t i = 0; i < scene.links.size(); ++i)
        for (const Index k : {scene.links[i].a, scene.links[i].b})
            require_body("link " + std::to_string(i), k, K);
    std::vector<PairSet::Pair> pairs;
    for (const Link& link : scene.links) pairs.emplace_back(link.a, link.b);
    scene.linked = PairSet(std::move(pairs));
}

Index add_disc(DiscScene& scene, const Vec2& position, Real mass, Real radius)
{
    const Index k = scene.bodies.count();
    const std::string name = "disc " + std::to_string(k);
    if (!position.allFinite())
        throw std::invalid_argument("the place of " + name + " is " + shortest(position.x()) + ", " +
                                    shortest(position.y()) + "; it must be finite");
    if (!(radius > 0) || !std::isfinite(radius))
        refuse("the radius of " + name, radius, "a positive number of metres");
    require_mass(k, mass);
    scene.bodies.resize(k + 1);
    scene.radius.conservativeResize(k + 1);
    place(scene, k, position, mass, radius);
    return k;
}

void require_valid(const DiscScene& scene)
{
    require_valid(scene.bodies);
    require_bodies(scene);
    const Index K = scene.bodies.count();
    for (Index k = 0; k < K; ++k)
        if (!(scene.radius[k] > 0) || !std::isfinite(scene.radius[k]))
            refuse("the radius of disc " + std::to_string(k), scene.radius[k], "a positive number of metres");
    for (std::size_t i = 0; i < scene.walls.size(); ++i) {
        const HalfSpace& wall = scene.walls[i];
        const std::string name = "wall " + std::to_string(i);
        const Real length = wall.normal.norm();
        // Six digits: enough that a gap of a metre is right to a micrometre.
        if (!(std::abs(length - 1) < 1e-6)) refuse("the length of the normal of " + name, length, "1");
        if (!std::isfinite(wall.offset)) refuse("the offset of " + name, wall.offset, "finite");
    }
    for (std::size_t i = 0; i < scene.segments.size(); ++i) {
        const Segment& segment = scene.segments[i];
        const std::string name = "segment " + std::to_string(i);
        const Real length = (segment.q - segment.p).norm();
        if (!(length > 0) || !std::isfinite(length))
            refuse("the length of " + name, length, "a positive number of metres");
        if (!(segment.radius >= 0) || !std::isfinite(segment.radius))
            refuse("the radius of " + name, segment.radius, "zero or positive");
    }
    for (std::size_t i = 0; i < scene.links.size(); ++i) {
        const Link& link = scene.links[i];
        const std::string name = "link " + std::to_string(i);
        if (link.a == link.b)
            throw std::invalid_argument(name + " joins body " + std::to_string(link.a) + " to itself");
        if (!(link.length > 0) || !std::isfinite(link.length))
            refuse("the length of " + name, link.length, "a positive number of metres");
    }
    for (std::size_t i = 0; i < scene.bends.size(); ++i) {
        const Bend& bend = scene.bends[i];
        const std::string name = "bend " + std::to_string(i);
        if (bend.left == bend.middle || bend.right == bend.middle || bend.left == bend.right)
            throw std::invalid_argument(name + " names body " +
                                        std::to_string(bend.left == bend.middle ? bend.left : bend.right) +
                                        " twice; it must name three bodies");
        if (!(bend.length > 0) || !std::isfinite(bend.length))
            refuse("the link length of " + name, bend.length, "a positive number of metres");
    }
    for (std::size_t i = 0; i < scene.joints.size(); ++i) {
        const Joint& joint = scene.joints[i];
        const std::string name = "joint " + std::to_string(i);
        if (joint.a == joint.b)
            throw std::invalid_argument(name + " joins body " + std::to_string(joint.a) + " to itself");
        const Real length = joint.direction.norm();
        if (joint.kind == Joint::Kind::rope) {
            if (!(joint.length > 0) || !std::isfinite(joint.length))
                refuse("the length of " + name, joint.length, "a positive number of metres");
            if (joint.a == world) throw std::invalid_argument(name + " is a rope; it needs two bodies");
        } else if (!(std::abs(length - 1) < 1e-6)) {
            refuse("the length of the direction of " + name, length, "1");
        }
        if (!std::isfinite(joint.length)) refuse("the length of " + name, joint.length, "finite");
        if (!std::isfinite(joint.speed)) refuse("the speed of " + name, joint.speed, "finite");
        if (!(joint.force >= 0)) refuse("the force of " + name, joint.force, "zero or positive");
    }
    if (!scene.gravity.allFinite()) throw std::invalid_argument("gravity is not finite");
    if (!(scene.length >= 0) || !std::isfinite(scene.length))
        refuse("the length of the scene", scene.length, "positive and finite, or zero to be derived");
    for (const auto& [a, b] : scene.linked.pairs()) {
        require_body("a pair that does not collide", a, K);
        require_body("a pair that does not collide", b, K);
    }
}

DiscScene ten_discs()
{
    constexpr Index chain = 7;
    constexpr Real radius = 0.05;
    DiscScene scene;
    scene.bodies = Bodies<2>(10);
    scene.radius.resize(10);
    for (Index k = 0; k < chain; ++k) place(scene, k, {-0.3 + 0.1 * static_cast<Real>(k), -0.1}, 0.1, radius);
    place(scene, 7, {-0.3, 0.3}, 0.2, 0.10);
    place(scene, 8, {0.0, 0.3}, 0.4, 0.15);
    place(scene, 9, {0.4, 0.3}, 0.2, 0.08);
    for (Index k = 0; k + 1 < chain; ++k) scene.links.push_back({k, k + 1, 2 * radius});
    for (Index k = 1; k + 1 < chain; ++k) scene.bends.push_back({k - 1, k, k + 1, 2 * radius});
    scene.walls = {{{1, 0}, -0.75}, {{-1, 0}, -0.75}, {{0, 1}, -0.5}, {{0, -1}, -0.5}};
    scene.half_size = {0.8, 0.55};
    link_neighbours(scene);
    return scene;
}

DiscScene column(Index count, Real top_mass)
{
    require_count("discs in a column", count);
    constexpr Real radius = 0.1;
    DiscScene scene;
    scene.bodies = Bodies<2>(count);
    scene.radius.resize(count);
    for (Index k = 0; k < count; ++k)
        place(scene, k, {0, radius * static_cast<Real>(2 * k + 1)}, k + 1 < count ? 1 : top_mass, radius);
    scene.walls = {{{0, 1}, 0}};
    scene.half_size = {0.6, 2 * radius * static_cast<Real>(count) + 0.1};
    return scene;
}

DiscScene column_between_walls(Index count, Real top_mass, Real clearance)
{
    DiscScene scene = column(count, top_mass);
    if (!(clearance >= 0) || !std::isfinite(clearance))
        refuse("the clearance beside a column", clearance, "zero or a positive number of metres");
    const Real from_middle = scene.radius[0] + clearance;
    scene.walls.push_back({{1, 0}, -from_middle});
    scene.walls.push_back({{-1, 0}, -from_middle});
    return scene;
}

DiscScene triangle(Index base)
{
    require_count("discs at the base of a triangle", base);
    constexpr Real radius = 0.1;
    const Index count = base * (base + 1) / 2;
    const Real row_height = std::sqrt(3.0) * radius;
    DiscScene scene;
    scene.bodies = Bodies<2>(count);
    scene.radius.resize(count);
    Index k = 0;
    for (Index row = 0; row < base; ++row)
        for (Index i = 0; i < base - row; ++i)
            place(scene, k++,
                  {radius * static_cast<Real>(2 * i + row + 1 - base),
                   radius + row_height * static_cast<Real>(row)},
                  1, radius);
    const Real wall = radius * static_cast<Real>(base);
    scene.walls = {{{0, 1}, 0}, {{1, 0}, -wall}, {{-1, 0}, -wall}};
    scene.half_size = {wall + 0.1, row_height * static_cast<Real>(base) + 0.1};
    return scene;
}

DiscScene hanging_chain(Index count, Real end_mass)
{
    require_count("links in a chain", count);
    constexpr Real length = 0.1;
    DiscScene scene;
    scene.bodies = Bodies<2>(count + 1);
    scene.radius.resize(count + 1);
    for (Index k = 0; k <= count; ++k)
        place(scene, k, {0, -length * static_cast<Real>(k)}, k < count ? 1 : end_mass, 0.4 * length);
    scene.bodies.inverse_mass.head<2>().setZero();
    for (Index k = 0; k < count; ++k) scene.links.push_back({k, k + 1, length});
    scene.half_size = {0.6 * length * static_cast<Real>(count), 1.1 * length * static_cast<Real>(count)};
    link_neighbours(scene);
    return scene;
}

DiscScene swinging_chain(Index count, Real end_mass)
{
    DiscScene scene = hanging_chain(count, end_mass);
    for (Index k = 1; k <= count; ++k)
        scene.bodies.position(k) = perpendicular(scene.bodies.position(k)).eval();
    scene.half_size.setConstant(scene.half_size.y());
    return scene;
}

DiscScene towed_discs()
{
    constexpr Real length = 0.5;
    DiscScene scene;
    scene.bodies = Bodies<2>(3);
    scene.radius.resize(3);
    place(scene, 0, {length, 0}, 10, 0.15);
    place(scene, 1, {0, 0}, 1, 0.1);
    place(scene, 2, {-length, 0}, 1, 0.1);
    scene.links = {{0, 1, length}, {1, 2, length}};
    scene.gravity = {0, 0};
    scene.half_size = {1, 1};
    link_neighbours(scene);
    return scene;
}

DiscScene perturbed(DiscScene scene, std::uint64_t seed, Real amount)
{
    if (!(amount >= 0) || !std::isfinite(amount))
        refuse("the amount of a perturbation [m]", amount, "finite and not negative");
    Random random(seed);
    for (Index k = 0; k < scene.bodies.count(); ++k) {
        if (!(scene.bodies.inverse_mass[2 * k] > 0)) continue;
        const Real angle = random.uniform(0, 2 * pi);
        scene.bodies.position(k) += amount * Vec2(cos(angle), sin(angle));
    }
    return scene;
}

}  // namespace rigid
