#include "chapters/30_elastic_bodies/elastic_scenes.hpp"

#include "common/elementary.hpp"

namespace rigid {

namespace {

ElasticScene with_weight(ElasticBody<2> body)
{
    ElasticScene scene(std::move(body));
    scene.elastic.gravity = scene.gravity;
    return scene;
}

/// A box that cannot move, by its lower left and upper right corner.
void add_fixed_box(ElasticScene& scene, const Vec2& low, const Vec2& high)
{
    const Vec2 size = high - low;
    add_body(scene, box(size.x(), size.y()), Mass{0, {0, 0}, 0}, (low + high) / 2);
}

}  // namespace

ElasticScene strip_scene(StrainLaw law, Real young, int order)
{
    ElasticMesh<2> mesh =
        order == 2 ? quadratic(rectangle_mesh({0, -0.05}, {1, 0.1}, 20, 2))
                   : rectangle_mesh({0, -0.05}, {1, 0.1}, 40, 4);
    ElasticScene scene =
        with_weight({mesh, {.young = young, .poisson = 0.3, .law = law}});
    for (int i = 0; i < mesh.nodes(); ++i)
        if (mesh.at(i).x() < 1e-9) scene.elastic.hold(i);
    return scene;
}

ElasticScene spinning_scene(StrainLaw law, Real young, Real omega)
{
    ElasticScene scene(
        ElasticBody<2>(disc_mesh({0, 0}, 0.5, 5), {.young = young, .law = law}));
    ElasticBody<2>& body = scene.elastic;
    for (int i = 0; i < body.model.nodes(); ++i)
        body.v.segment<2>(2 * i) = omega * perpendicular(body.at(i));
    return scene;
}

ElasticScene ball_scene(StrainLaw law, Real young, Real angle)
{
    ElasticScene scene =
        with_weight({disc_mesh({0, 0.31}, 0.3, 5), {.young = young, .law = law}});
    scene.walls.push_back({{sin(angle), cos(angle)}, 0});
    scene.friction = 0.8;
    scene.elastic.stiffness_damping = 1e-3;
    return scene;
}

ElasticScene jelly_scene(StrainLaw law, Real young)
{
    ElasticScene scene =
        with_weight({rectangle_mesh({0.05, 1.5}, {0.6, 0.4}, 9, 6),
                     {.young = young, .poisson = 0.4, .law = law}});
    for (int i = 0; i < 4; ++i)
        add_fixed_box(scene, {0.5 * i, -0.5}, {0.5 * (i + 1), 1.2 - 0.35 * i});
    scene.walls.push_back({{0, 1}, 0});
    scene.friction = 0.3;
    scene.elastic.stiffness_damping = 2e-3;
    for (int i = 0; i < scene.elastic.model.nodes(); ++i)
        scene.elastic.v[2 * i] = 0.8;
    return scene;
}

ElasticScene gripper_scene(StrainLaw law, Real young, Real mass)
{
    const ElasticMesh<2> fingers =
        joined(rectangle_mesh({-0.4, 0.1}, {0.15, 0.4}, 3, 8),
               rectangle_mesh({0.25, 0.1}, {0.15, 0.4}, 3, 8));
    ElasticScene scene =
        with_weight({fingers, {.young = young, .poisson = 0.3, .law = law}});
    for (int i = 0; i < fingers.nodes(); ++i)
        if (std::abs(fingers.at(i).x()) > 0.4 - 1e-9) scene.elastic.hold(i);
    add_body(scene, box(0.3, 0.3), mass / 0.09, {0, 0.15});
    scene.walls.push_back({{0, 1}, 0});
    scene.friction = 0.6;
    scene.elastic.stiffness_damping = 1e-3;
    return scene;
}

template <int Dim>
void move_arms(ElasticBody<Dim>& body, Real t)
{
    const Real closing = t < 0.6 ? 0.22 : 0, rising = t > 0.8 && t < 2 ? 0.5 : 0;
    for (int i = 0; i < body.model.nodes(); ++i)
        if (body.fixed[static_cast<std::size_t>(Dim * i)]) {
            const Real side = body.model.mesh().at(i).x() < 0 ? 1 : -1;
            body.v.template segment<Dim>(Dim * i).setZero();
            body.v.template segment<2>(Dim * i) << side * closing, rising;
        }
}
template void move_arms(ElasticBody<2>&, Real);
template void move_arms(ElasticBody<3>&, Real);

ElasticScene bridge_with_car(StrainLaw law, Real young, Real speed)
{
    ElasticScene scene =
        with_weight({quadratic(rectangle_mesh({-2, -0.2}, {4, 0.2}, 20, 1)),
                     {.young = young, .poisson = 0.3, .density = 400, .law = law}});
    ElasticBody<2>& bridge = scene.elastic;
    for (int i = 0; i < bridge.model.nodes(); ++i)
        if (std::abs(bridge.at(i).x()) > 2 - 1e-9) bridge.hold(i);
    add_fixed_box(scene, {-5, -1}, {-2.01, scene.skin});
    add_fixed_box(scene, {2.01, -1}, {5, scene.skin});
    const Real height = 0.2 + scene.skin, at = -3.2;
    const Index body = add_body(scene, box(1, 0.2), Real{400}, {at, height + 0.15});
    for (const Real side : {-0.4, 0.4}) {
        const Index wheel =
            add_body(scene, disc(0.2), 20 / (pi * 0.04), {at + side, height});
        add_pin(scene, body, {side, -0.15}, wheel, {0, 0});
        add_turning_motor(scene, body, wheel, -speed / 0.2, 60);
    }
    scene.friction = 0.8;
    bridge.stiffness_damping = 2e-3;
    return scene;
}

ElasticScene struck_bar(StrainLaw law, Real young)
{
    ElasticScene scene(
        ElasticBody<2>(quadratic(rectangle_mesh({-0.5, -0.025}, {1, 0.05}, 24, 1)),
                       {.young = young, .poisson = 0, .law = law}));
    ElasticBody<2>& bar = scene.elastic;
    for (int i = 0; i < bar.model.nodes(); ++i)
        if (bar.at(i).x() > 0.45) bar.v[2 * i + 1] = 1;
    bar.stiffness_damping = 1e-5;
    return scene;
}

ElasticBody<2> chime()
{
    ElasticBody<2> bar(quadratic(rectangle_mesh({0, -0.003}, {0.3, 0.006}, 24, 1)),
                       {.young = 2e11,
                        .poisson = 0.3,
                        .density = 7800,
                        .law = StrainLaw::linear,
                        .plane_stress = true});
    for (int i = 0; i < bar.model.nodes(); ++i)
        if (bar.at(i).x() > 0.29) bar.v[2 * i + 1] = 1;
    bar.mass_damping = 1, bar.stiffness_damping = 1e-7;
    return bar;
}

}  // namespace rigid
