/// \file statics.hpp
/// Whether forces exist that hold a scene at rest: a linear program of its own, apart from every solver of the book.
///
///     Gᵀ x = weight,   x ≥ 0,     columns of G: the two edges n ± μ t of the cone of each contact
///
/// Phase one of the simplex method in a dense table, with Bland's rule: it ends.
#pragma once

#include "chapters/12_contact_manifolds/manifold_method.hpp"
#include "chapters/13_friction/surfaces.hpp"

namespace rigid {

/// The least sum of |C x − d| over x ≥ 0, divided by that of |d|.
inline Real least_misfit(const MatX& C, const VecX& d)
{
    const Index m = C.rows(), n = C.cols();
    MatX table = MatX::Zero(m + 1, n + 1);
    table.block(0, 0, m, n) = C;
    table.block(0, n, m, 1) = d;
    std::vector<Index> basis(static_cast<std::size_t>(m), n);  // n: the row's own artificial unknown
    for (Index i = 0; i < m; ++i) {
        if (table(i, n) < 0) table.row(i) *= -1;
        table.row(m) -= table.row(i);
    }
    const Real tiny = 1e-9;  // of entries of size 1: less is rounding
    for (int pivots = 0; pivots < 20000; ++pivots) {
        Index enters = 0;
        while (enters < n && !(table(m, enters) < -tiny)) ++enters;
        if (enters == n) break;
        Index leaves = -1;
        for (Index i = 0; i < m; ++i) {
            if (!(table(i, enters) > tiny)) continue;
            const Real ratio = table(i, n) / table(i, enters);
            const Real least = leaves < 0 ? infinity : table(leaves, n) / table(leaves, enters);
            if (ratio < least - 1e-13 ||
                (ratio <= least + 1e-13 && basis[std::size_t(i)] < basis[std::size_t(leaves)]))
                leaves = i;
        }
        if (leaves < 0) break;
        table.row(leaves) /= table(leaves, enters);
        for (Index i = 0; i <= m; ++i)
            if (i != leaves && table(i, enters) != 0) table.row(i) -= table(i, enters) * table.row(leaves);
        basis[static_cast<std::size_t>(leaves)] = enters;
    }
    // The table has its own rounding: what counts is the x that it found.
    VecX x = VecX::Zero(n);
    for (Index i = 0; i < m; ++i)
        if (basis[static_cast<std::size_t>(i)] < n)
            x[basis[static_cast<std::size_t>(i)]] = std::max(Real{0}, table(i, n));
    return (C * x - d).lpNorm<1>() / d.lpNorm<1>();
}

/// The contacts of a scene as it is, as forces and moments on its bodies: normals and tangents.
struct StaticContacts {
    MatX normal, tangent;  ///< one column to a contact
    VecX weight;           ///< what they have to carry [N, N m]
};
inline StaticContacts static_contacts(const RoughScene& scene)
{
    Manifolds stage;
    StepData<3> now;
    int nothing = 0;
    stage.begin(scene, {}, nothing, now);
    std::vector<Contact> touching;
    for (const Contact& contact : now.contacts)
        if (contact.gap < 1e-9) touching.push_back(contact);
    const Index K = scene.bodies.count(), n = static_cast<Index>(touching.size());
    StaticContacts all{MatX::Zero(3 * K, n), MatX::Zero(3 * K, n), VecX::Zero(3 * K)};
    for (Index i = 0; i < n; ++i) {
        const Contact& c = touching[static_cast<std::size_t>(i)];
        const auto push = [&](Index k, const Vec2& force, MatX& columns) {
            if (k == world || !scene.bodies.can_move(k)) return;
            const Vec2 arm = c.point - scene.bodies.position(k).head<2>();
            columns.block<3, 1>(3 * k, i) << force, cross2(arm, force);
        };
        for (const Real side : {-1.0, 1.0}) {
            push(side < 0 ? c.a : c.b, side * c.normal, all.normal);
            push(side < 0 ? c.a : c.b, side * perpendicular(c.normal), all.tangent);
        }
    }
    for (Index k = 0; k < K; ++k)
        if (scene.bodies.can_move(k))
            all.weight.segment<2>(3 * k) = -scene.gravity / scene.bodies.inverse_mass[3 * k];
    return all;
}

/// Whether forces within all cones hold the scene.
inline bool can_stand(const StaticContacts& contacts, Real mu)
{
    MatX edges(contacts.normal.rows(), 2 * contacts.normal.cols());
    edges << contacts.normal + mu * contacts.tangent, contacts.normal - mu * contacts.tangent;
    return least_misfit(edges, contacts.weight) < 1e-9;
}

/// The least μ with which it can, to 1e-4; infinity above 3.
inline Real least_friction(const StaticContacts& contacts)
{
    if (!can_stand(contacts, 3)) return infinity;
    Real low = 0, high = 3;
    while (high - low > 1e-4) {
        const Real middle = (low + high) / 2;
        (can_stand(contacts, middle) ? high : low) = middle;
    }
    return high;
}

}  // namespace rigid
