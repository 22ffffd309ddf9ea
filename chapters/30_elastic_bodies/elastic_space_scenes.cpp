#include "common/eigen_instances.hpp"

#include "chapters/30_elastic_bodies/elastic_space_scenes.hpp"

#include "common/elementary.hpp"

namespace rigid {

namespace {

ElasticSpace with_weight(ElasticBody<3> body)
{
    ElasticSpace scene(std::move(body));
    scene.elastic.gravity = scene.gravity;
    return scene;
}

/// Stairs down along x: treads and risers of two triangles each.
std::shared_ptr<const TriangleMesh> stairs_mesh(int steps, Real tread, Real riser,
                                                Real width)
{
    std::vector<Vec3> vertices;
    const auto edge = [&](Real x, Real y) {
        vertices.emplace_back(x, y, -width / 2),
            vertices.emplace_back(x, y, width / 2);
    };
    edge(-tread, steps * riser);
    for (int i = 0; i < steps; ++i) {
        edge(i * tread, (steps - i) * riser);
        edge(i * tread, (steps - i - 1) * riser);
    }
    edge(steps * tread + 4 * tread, 0);
    std::vector<TriangleMesh::Triangle> triangles;
    for (int i = 0; i + 3 < static_cast<int>(vertices.size()); i += 2) {
        triangles.push_back({i, i + 1, i + 2});
        triangles.push_back({i + 2, i + 1, i + 3});
    }
    return triangle_mesh(std::move(vertices), std::move(triangles));
}

}  // namespace

ElasticSpace soft_ball_scene(StrainLaw law, Real young, Real angle, Real friction)
{
    ElasticSpace scene =
        with_weight({ball_mesh({0, 0, 0}, 0.3, 2, 3),
                     {.young = young, .poisson = 0.3, .law = law}});
    const Vec3 normal(sin(angle), cos(angle), 0);
    scene.walls.push_back({normal, -0.3 - scene.skin});
    scene.soft_friction = friction;
    scene.elastic.stiffness_damping = 1e-3;
    return scene;
}

ElasticSpace space_jelly_scene(StrainLaw law, Real young)
{
    ElasticSpace scene =
        with_weight({block_mesh({-0.42, 0.95, -0.2}, {0.4, 0.3, 0.4}, 4, 3, 4),
                     {.young = young, .poisson = 0.4, .law = law}});
    scene.meshes = {stairs_mesh(3, 0.4, 0.3, 2)};
    scene.soft_friction = 0.3;
    scene.elastic.stiffness_damping = 2e-3;
    for (int i = 0; i < scene.elastic.model.nodes(); ++i)
        scene.elastic.v[3 * i] = 0.9;
    return scene;
}

ElasticSpace soft_fingers_scene(StrainLaw law, Real young, Real mass)
{
    const ElasticMesh<3> fingers =
        joined(block_mesh({-0.4, 0.1, -0.1}, {0.15, 0.3, 0.2}, 2, 4, 3),
               block_mesh({0.25, 0.1, -0.1}, {0.15, 0.3, 0.2}, 2, 4, 3));
    ElasticSpace scene =
        with_weight({fingers, {.young = young, .poisson = 0.3, .law = law}});
    for (int i = 0; i < fingers.nodes(); ++i)
        if (std::abs(fingers.at(i).x()) > 0.4 - 1e-9) scene.elastic.hold(i);
    add_body(scene, {solid_box({0.3, 0.3, 0.3})}, mass / 0.027, {0, 0.15, 0});
    scene.walls.push_back({{0, 1, 0}, 0});
    scene.friction = {0.6}, scene.wall_friction = {0.6};
    scene.soft_friction = 0.6;
    scene.elastic.stiffness_damping = 1e-3;
    return scene;
}

ElasticSpace mattress_scene(StrainLaw law, Real young, Real mass)
{
    ElasticSpace scene =
        with_weight({block_mesh({-0.3, 0, -0.3}, {0.6, 0.2, 0.6}, 6, 2, 6),
                     {.young = young, .poisson = 0.3, .law = law}});
    for (int i = 0; i < scene.elastic.model.nodes(); ++i)
        if (scene.elastic.at(i).y() < 1e-9) scene.elastic.hold(i);
    add_body(scene, {solid_box({0.25, 0.2, 0.25})}, mass / (0.25 * 0.2 * 0.25),
             {0.02, 0.5, 0.01}, {0.3, 0.2, 0.1});
    scene.friction = {0.5};
    scene.elastic.stiffness_damping = 2e-3;
    return scene;
}

}  // namespace rigid
