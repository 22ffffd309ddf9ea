#include "chapters/11_rotation/rigid_constraints.hpp"
#include "tests/stress/bad_input.hpp"
#include "tests/stress/turning.hpp"

namespace rigid::stress {

namespace {

using Fields = FieldsOf<RoughScene>;

Fields fields_of_bodies(const RoughScene& scene)
{
    Fields fields;
    for (auto vector : {&Bodies<3>::x, &Bodies<3>::u, &Bodies<3>::inverse_mass})
        for (Index i = 0; i < scene.bodies.x.size(); ++i)
            fields.push_back({[=](RoughScene& s, Real&, Wish&) -> Real& { return (s.bodies.*vector)[i]; }});
    for (std::size_t k = 0; k < scene.shapes.size(); ++k) {
        fields.push_back(
            {[=](RoughScene& s, Real&, Wish&) -> Real& { return s.shapes[k].radius; }, false, false, true});
        for (std::size_t i = 0; i < scene.shapes[k].vertices.size(); ++i)
            for (const Index d : {0, 1})
                fields.push_back(
                    {[=](RoughScene& s, Real&, Wish&) -> Real& { return s.shapes[k].vertices[i][d]; }});
    }
    return fields;
}

Fields fields_of_joints_and_walls(const RoughScene& scene)
{
    Fields fields;
    for (std::size_t i = 0; i < scene.walls.size(); ++i) {
        fields.push_back({[=](RoughScene& s, Real&, Wish&) -> Real& { return s.walls[i].normal.x(); }});
        fields.push_back({[=](RoughScene& s, Real&, Wish&) -> Real& { return s.walls[i].normal.y(); }});
        fields.push_back({[=](RoughScene& s, Real&, Wish&) -> Real& { return s.walls[i].offset; }});
    }
    for (std::size_t i = 0; i < scene.joints.size(); ++i) {
        for (auto point : {&PointJoint::at_a, &PointJoint::at_b, &PointJoint::direction})
            for (const Index d : {0, 1})
                fields.push_back(
                    {[=](RoughScene& s, Real&, Wish&) -> Real& { return (s.joints[i].*point)[d]; }});
        fields.push_back({[=](RoughScene& s, Real&, Wish&) -> Real& { return s.joints[i].length; }});
    }
    fields.push_back({[](RoughScene& s, Real&, Wish&) -> Real& { return s.length; }, false, false, true});
    return fields;
}

Fields fields_of_surfaces(const RoughScene& scene)
{
    Fields fields;
    for (std::size_t i = 0; i < scene.surfaces.size(); ++i) {
        fields.push_back({[=](RoughScene& s, Real&, Wish&) -> Real& { return s.surfaces[i].friction; }, false,
                          false, true});
        fields.push_back({[=](RoughScene& s, Real&, Wish&) -> Real& { return s.surfaces[i].restitution; },
                          false, false, true});
        fields.push_back({[=](RoughScene& s, Real&, Wish&) -> Real& { return s.surfaces[i].belt; }});
    }
    return fields;
}

/// A rod on a pin, a box, a disc and a capsule over a floor and a wall.
RoughScene some_bodies(std::uint64_t seed)
{
    RoughScene scene = slanted_rods(1, 1);
    scene.walls = {{{0, 1}, -2}, {{1, 0}, -2}};
    add_body(scene, box(0.5, 0.5), 4, {1, -1.7});
    add_body(scene, disc(0.2), 4, {0, -1.75});
    add_body(scene, capsule(0.4, 0.1), 4, {-1, -1.85});
    cover(scene, {0.5, 0, 0, 0});
    perturb(scene, seed);
    return scene;
}

}  // namespace

TurningStress turning_bad_input()
{
    TurningStress stress{
        "bad input",
        "NaN, ∞ and −∞ in turn in every number of the scene, the step and the method's settings; where "
        "they must be positive, 0 and −1 as well",
        {"bodies and shapes", "walls joints and surfaces", "gravity and h", "settings", "after 10 steps"},
        [](const TurningMethod& method, int level, std::uint64_t seed) -> std::optional<Verdict> {
            const RoughScene scene = some_bodies(seed);
            Fields joints = fields_of_joints_and_walls(scene), surfaces = fields_of_surfaces(scene);
            if (method.friction) joints.insert(joints.end(), surfaces.begin(), surfaces.end());
            return spoil_all(method, scene, level, fields_of_bodies(scene), joints);
        }};
    stress.seeds = {2, 2, 2, 2, 2};
    return stress;
}

}  // namespace rigid::stress
