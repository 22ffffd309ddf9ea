#include "tests/stress/turning.hpp"
#include "tests/stress/turning_fields.hpp"

namespace rigid::stress {

namespace {

/// A rod, on a pin where the method knows one, a box, a disc and a capsule over a floor and a wall.
RoughScene some_bodies(std::uint64_t seed, bool joints)
{
    RoughScene scene = slanted_rods(1, 1);
    if (!joints) scene.joints.clear();
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
    return bad_input_of<RoughScene>([](const TurningMethod& method, int level,
                                       std::uint64_t seed) -> std::optional<Verdict> {
        const RoughScene scene = some_bodies(seed, method.joints);
        FieldsOf<RoughScene> joints = fields_of_rows_and_walls(scene), surfaces = fields_of_surfaces(scene);
        if (method.friction) joints.insert(joints.end(), surfaces.begin(), surfaces.end());
        return spoil_all(method, scene, level, fields_of_bodies(scene), joints);
    });
}

}  // namespace rigid::stress
