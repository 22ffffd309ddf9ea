#include "tests/stress/bad_input.hpp"

namespace rigid::stress {

namespace {

using Fields = FieldsOf<DiscScene>;

void add(Fields& fields, VecX Bodies<2>::*vector, Index size)
{
    for (Index i = 0; i < size; ++i)
        fields.push_back({[=](DiscScene& s, Real&, Wish&) -> Real& { return (s.bodies.*vector)[i]; }});
}

Fields fields_of_discs(const DiscScene& scene)
{
    Fields fields;
    for (auto vector : {&Bodies<2>::x, &Bodies<2>::u, &Bodies<2>::f, &Bodies<2>::inverse_mass})
        add(fields, vector, scene.bodies.x.size());
    for (Index k = 0; k < scene.radius.size(); ++k)
        fields.push_back({.at = [=](DiscScene& s, Real&, Wish&) -> Real& { return s.radius[k]; },
                          .may_be_negative = false});
    return fields;
}

Fields fields_of_joints_and_walls(const DiscScene& scene)
{
    Fields fields;
    for (std::size_t i = 0; i < scene.walls.size(); ++i) {
        fields.push_back({[=](DiscScene& s, Real&, Wish&) -> Real& { return s.walls[i].normal.x(); }});
        fields.push_back({[=](DiscScene& s, Real&, Wish&) -> Real& { return s.walls[i].normal.y(); }});
        fields.push_back({[=](DiscScene& s, Real&, Wish&) -> Real& { return s.walls[i].offset; }});
    }
    for (std::size_t i = 0; i < scene.links.size(); ++i)
        fields.push_back({.at = [=](DiscScene& s, Real&, Wish&) -> Real& { return s.links[i].length; },
                          .may_be_negative = false});
    for (std::size_t i = 0; i < scene.bends.size(); ++i)
        fields.push_back({.at = [=](DiscScene& s, Real&, Wish&) -> Real& { return s.bends[i].length; },
                          .may_be_negative = false});
    return fields;
}

/// Seven discs in a chain with bends, three free ones, four walls; a chain alone for methods that know no contacts.
DiscScene scene_for(const Method& method, std::uint64_t seed)
{
    DiscScene scene = method.links_only ? slanted_chain(4, 1) : ten_discs();
    perturb(scene, seed);
    return scene;
}

}  // namespace

Stress bad_input()
{
    return {"bad input",
            "NaN, ∞ and −∞ in turn in every number of the scene, the step and the method's settings; where "
            "they must "
            "be positive, 0 and −1 as well",
            {"discs", "walls and joints", "gravity and h", "settings", "after 10 steps"},
            [](const Method& method, int level, std::uint64_t seed) -> std::optional<Verdict> {
                const DiscScene scene = scene_for(method, seed);
                return spoil_all(method, scene, level, fields_of_discs(scene),
                                 fields_of_joints_and_walls(scene));
            }};
}

}  // namespace rigid::stress
