/// \file elastic_loads.hpp
/// Loads on edges, and what is known in closed form of beams, rings, plates and blocks.
#pragma once

#include "chapters/30_elastic_bodies/elastic_solver.hpp"

namespace rigid {

/// Adds a load of so many newtons a metre on every edge of the outline both of whose ends
/// `is_loaded` names. On half a quadratic edge the shares are those of its parabolas,
/// 1/6, 4/6, 1/6 of the whole.
template <class IsLoaded>
void add_edge_load(ElasticBody<2>& body, const IsLoaded& is_loaded,
                   const Vec2& per_metre)
{
    const ElasticMesh<2>& mesh = body.model.mesh();
    std::vector<bool> is_corner(static_cast<std::size_t>(mesh.nodes()));
    for (int e = 0; e < mesh.count(); ++e)
        for (int i = 0; i < 3; ++i)
            is_corner[static_cast<std::size_t>(mesh.node(e, i))] = true;
    for (const auto& [a, b] : outline(mesh)) {
        if (!is_loaded(Vec2(mesh.at(a))) || !is_loaded(Vec2(mesh.at(b)))) continue;
        const Real length = (mesh.at(b) - mesh.at(a)).norm();
        const auto share = [&](int node) {
            return mesh.order == 1                             ? 0.5
                   : is_corner[static_cast<std::size_t>(node)] ? 1.0 / 3
                                                               : 2.0 / 3;
        };
        for (const int node : {a, b})
            body.load.segment<2>(2 * node) += share(node) * length * per_metre;
    }
}

/// (30.15): P L³/3EI of bending and 6 P L/5GA of shear, of a beam of 1 m width that cannot
/// grow wider (E/(1 − ν²) in place of E).
inline Real cantilever_sag(const ElasticMaterial& m, Real length, Real height,
                           Real load)
{
    const Real E = m.plane_stress ? m.young : m.young / (1 - m.poisson * m.poisson);
    const Real G = m.young / (2 * (1 + m.poisson));
    return 4 * load * length * length * length / (E * height * height * height) +
           6 * load * length / (5 * G * height);
}

/// (30.25): the springs of a lattice of triangles of equal sides that is a sheet of
/// modulus E and ν = 1/3: each triangle gives an edge √3/4 · E [N/m], of 1 m thickness.
inline Real spring_of_lattice(Real young) { return std::sqrt(3.0) / 4 * young; }

/// (30.20): a block of the neo-Hookean law, pulled to `stretch` and free at its sides.
struct PulledBlock {
    Real across = 1;  ///< the stretch of its sides
    Real stress = 0;  ///< force over the area at rest [Pa]
};
inline PulledBlock pulled_block(const Lame& lame, Real stretch)
{
    const Real J = 1 + lame.mu / (lame.lambda + lame.mu) * (1 - 1 / stretch);
    const Real square = J / stretch;
    return {std::sqrt(square), lame.mu * (stretch - square / stretch)};
}

/// Lamé's ring in plane strain under a pressure inside: how far a circle grows [m].
inline Real ring_displacement(const ElasticMaterial& m, Real inner, Real outer,
                              Real pressure, Real r)
{
    const Lame lame = lame_of(m, 2);
    const Real C = pressure * inner * inner / (outer * outer - inner * inner);
    return C * r / (2 * (lame.lambda + lame.mu)) +
           C * outer * outer / (2 * lame.mu * r);
}

/// Kirsch's plate, pulled along x by `pull` [Pa], with a hole of radius a [m].
inline Vec2 hole_displacement(const ElasticMaterial& m, Real a, Real pull,
                              const Vec2& at)
{
    const Lame lame = lame_of(m, 2);
    // κ of the plane: (λ + 3 μ)/(λ + μ)
    const Real kappa = (lame.lambda + 3 * lame.mu) / (lame.lambda + lame.mu);
    const Real r = at.norm(), c = at.x() / r, s = at.y() / r;
    const Real c3 = c * (4 * c * c - 3),
               s3 = s * (3 - 4 * s * s);  // of three times the angle
    const Real scale = pull * a / (8 * lame.mu), q = a / r;
    return {scale * (r / a * (kappa + 1) * c + 2 * q * ((1 + kappa) * c + c3) -
                     2 * q * q * q * c3),
            scale * (r / a * (kappa - 3) * s + 2 * q * ((1 - kappa) * s + s3) -
                     2 * q * q * q * s3)};
}

}  // namespace rigid
