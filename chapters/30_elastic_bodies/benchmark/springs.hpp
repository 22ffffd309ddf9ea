/// \file springs.hpp
/// The sheet of equal triangles that is also a net of springs, (30.25): by the methods of chapter 27, and by elements.
#pragma once

#include "chapters/27_particles_and_cloth/cloth_step.hpp"
#include "chapters/30_elastic_bodies/elastic_solver.hpp"

#include <chrono>
#include <map>

namespace rigid {

inline constexpr Real net_weight = 0.2;  ///< [m/s²]
inline constexpr int net_steps = 60;     ///< of a second

inline ElasticBody<2> sheet(StrainLaw law)
{
    ElasticBody<2> body(
        lattice_mesh(1.0 / 32, 33, 5),
        {.young = 1e6, .poisson = 1.0 / 3, .law = law, .plane_stress = true});
    body.model.lump();
    for (int i = 0; i < body.model.nodes(); ++i)
        if (body.at(i).x() < 0.02) body.hold(i);
    body.gravity = {0, -net_weight};
    return body;
}

/// Its sag: that of the far lower corner.
inline Real sag_of(const ElasticBody<2>& body)
{
    return body.model.mesh().rest[2 * 32 + 1] - body.x[2 * 32 + 1];
}

/// After a second, by Newton's method on elements; the time of a step [µs].
inline Real sheet_sag(StrainLaw law, LinearSolve solve, Real tolerance, Real stale,
                      Real& us)
{
    ElasticBody<2> body = sheet(law);
    ElasticSolver<2> solver;
    solver.settings.solve = solve, solver.settings.tolerance = tolerance;
    solver.settings.stale = stale;
    const auto start = std::chrono::steady_clock::now();
    for (int n = 0; n < net_steps; ++n) solver.step(body, 1.0 / net_steps);
    us = 1e6 / net_steps *
         std::chrono::duration<Real>(std::chrono::steady_clock::now() - start)
             .count();
    return sag_of(body);
}

/// The same sheet as springs: two triangles' share along an edge that two have.
inline ClothScene net()
{
    const ElasticBody<2> body = sheet(StrainLaw::linear);
    const ElasticMesh<2>& mesh = body.model.mesh();
    ClothScene cloth;
    cloth.bodies = Bodies<3>(mesh.nodes());
    cloth.gravity = {0, -net_weight, 0};
    for (int i = 0; i < mesh.nodes(); ++i) {
        cloth.bodies.x.segment<3>(3 * i) << mesh.at(i), 0;
        cloth.bodies.inverse_mass.segment<3>(3 * i).setConstant(
            body.fixed[static_cast<std::size_t>(2 * i)]
                ? 0
                : 1 / body.model.mass_at(i));
    }
    std::map<std::array<int, 2>, Real> edges;
    for (int e = 0; e < mesh.count(); ++e)
        for (const auto& [i, j] : edges_of_element<2>()) {
            const int a = mesh.node(e, i), b = mesh.node(e, j);
            edges[{std::min(a, b), std::max(a, b)}] += std::sqrt(3.0) / 4 * 1e6;
        }
    for (const auto& [edge, k] : edges)
        cloth.springs.push_back(
            {edge[0], edge[1], (mesh.at(edge[1]) - mesh.at(edge[0])).norm(), k});
    return cloth;
}

inline Real net_sag(ClothMethod method, int sweeps, Real& us)
{
    ClothScene cloth = net();
    ClothMemory memory;
    ClothSettings settings;
    settings.h = 1.0 / net_steps, settings.method = method,
    settings.sweeps = sweeps;
    const Real before = cloth.bodies.x[3 * 32 + 1];
    const auto start = std::chrono::steady_clock::now();
    for (int n = 0; n < net_steps; ++n) step(cloth, settings, memory);
    us = 1e6 / net_steps *
         std::chrono::duration<Real>(std::chrono::steady_clock::now() - start)
             .count();
    return before - cloth.bodies.x[3 * 32 + 1];
}

}  // namespace rigid
