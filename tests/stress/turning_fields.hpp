/// \file turning_fields.hpp
/// The numbers of a scene of bodies that turn, for the stress that spoils them.
#pragma once

#include "chapters/11_rotation/rigid_constraints.hpp"
#include "tests/stress/bad_input.hpp"

namespace rigid::stress {

template <class Scene>
FieldsOf<Scene> fields_of_bodies(const Scene& scene)
{
    FieldsOf<Scene> fields;
    for (auto vector : {&Bodies<3>::x, &Bodies<3>::u, &Bodies<3>::inverse_mass})
        for (Index i = 0; i < scene.bodies.x.size(); ++i)
            fields.push_back({[=](Scene& s, Real&, Wish&) -> Real& { return (s.bodies.*vector)[i]; }});
    for (std::size_t k = 0; k < scene.shapes.size(); ++k) {
        fields.push_back({.at = [=](Scene& s, Real&, Wish&) -> Real& { return s.shapes[k].radius; },
                          .may_be_negative = false,
                          .may_be_zero = true});
        for (std::size_t i = 0; i < scene.shapes[k].vertices.size(); ++i)
            for (const Index d : {0, 1})
                fields.push_back(
                    {[=](Scene& s, Real&, Wish&) -> Real& { return s.shapes[k].vertices[i][d]; }});
    }
    return fields;
}

template <class Scene>
FieldsOf<Scene> fields_of_rows_and_walls(const Scene& scene)
{
    FieldsOf<Scene> fields;
    for (std::size_t i = 0; i < scene.walls.size(); ++i) {
        fields.push_back({[=](Scene& s, Real&, Wish&) -> Real& { return s.walls[i].normal.x(); }});
        fields.push_back({[=](Scene& s, Real&, Wish&) -> Real& { return s.walls[i].normal.y(); }});
        fields.push_back({[=](Scene& s, Real&, Wish&) -> Real& { return s.walls[i].offset; }});
    }
    for (std::size_t i = 0; i < scene.joints.size(); ++i) {
        for (auto point : {&PointJoint::at_a, &PointJoint::at_b, &PointJoint::direction})
            for (const Index d : {0, 1})
                fields.push_back({[=](Scene& s, Real&, Wish&) -> Real& { return (s.joints[i].*point)[d]; }});
        fields.push_back({[=](Scene& s, Real&, Wish&) -> Real& { return s.joints[i].length; }});
    }
    fields.push_back({.at = [](Scene& s, Real&, Wish&) -> Real& { return s.length; },
                      .may_be_negative = false,
                      .may_be_zero = true});
    return fields;
}

template <class Scene>
FieldsOf<Scene> fields_of_surfaces(const Scene& scene)
{
    FieldsOf<Scene> fields;
    for (std::size_t i = 0; i < scene.surfaces.size(); ++i) {
        fields.push_back({.at = [=](Scene& s, Real&, Wish&) -> Real& { return s.surfaces[i].friction; },
                          .may_be_negative = false,
                          .may_be_zero = true});
        fields.push_back({.at = [=](Scene& s, Real&, Wish&) -> Real& { return s.surfaces[i].restitution; },
                          .may_be_negative = false,
                          .may_be_zero = true});
        fields.push_back({[=](Scene& s, Real&, Wish&) -> Real& { return s.surfaces[i].belt; }});
    }
    return fields;
}

}  // namespace rigid::stress
