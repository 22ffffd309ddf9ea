// The functions of cloth_contact.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/28_cloth_that_touches/cloth_contact.hpp"

#include "chapters/16_soft_constraints/block_solve.hpp"

#include <algorithm>

namespace rigid {

void ClothTouch::begin(TouchingCloth& cloth, Real h)
{
    Bodies<6>& solids = cloth.solids;
    const auto K = static_cast<std::size_t>(solids.count());
    const Real time = middle ? h / 2 : h;
    R.resize(K);
    u0 = solids.u;
    for (Index k = 0; k < solids.count(); ++k) {
        R[static_cast<std::size_t>(k)] = rotation_of(solids.x, k);
        if (solids.inverse_mass[6 * k] > 0) {
            solids.u.segment<3>(6 * k) += time * cloth.gravity;
            solids.velocity(k) +=
                time * solids.apply_inverse_mass(k, Vec<6>(solids.force(k)));
        }
    }
    moved = h * solids.u;
    contacts.clear();
}

//! [mesh]
ClothGap gap_to(const TriangleMesh& mesh, const Vec3& p, Real reach,
                std::vector<int>& stack, std::vector<int>& near)
{
    const Vec3 around = Vec3::Constant(reach);
    mesh.near({p - around, p + around}, stack, near);
    ClothGap best{infinity, {0, 1, 0}};
    Real least = reach, farthest = 0;
    bool border = false;
    for (const int t : near) {
        const Vec3 a = mesh.corner(t, 0) - p, b = mesh.corner(t, 1) - p,
                   c = mesh.corner(t, 2) - p;
        const auto w = nearest_of_triangle({a, b, c});
        const Vec3 d = -(w[0] * a + w[1] * b + w[2] * c);
        const Real size = d.norm(), along = d.dot(mesh.normal(t));
        // the same point of two triangles, to rounding
        const bool nearer = size < least - 1e-9 * reach;
        if (!nearer && !(size < least + 1e-9 * reach)) continue;
        if (nearer) border = false;
        for (std::size_t k = 0; k < 3; ++k)
            border =
                border || (w[k] == 0 &&
                           mesh.beyond[static_cast<std::size_t>(t)][(k + 1) % 3] ==
                               TriangleMesh::nobody);
        if (!nearer && !(std::abs(along) > farthest)) continue;
        least = std::min(size, least), farthest = std::abs(along);
        const Real side = along < 0 ? -1 : 1;
        best = {side * size,
                size > 1e-9 * reach ? Vec3(side / size * d) : mesh.normal(t)};
    }
    if (border && best.gap < 0) best.gap = infinity;
    return best;
}
//! [mesh]

//! [find]
void ClothTouch::find(const TouchingCloth& cloth, const VecX& x0, const VecX& x)
{
    contacts.clear();
    const auto tied = [&cloth](int particle, int solid) {
        return std::any_of(cloth.ties.begin(), cloth.ties.end(),
                           [&](const ClothTie& t) {
                               return t.particle == particle && t.solid == solid;
                           });
    };
    for (int s = 0; s < static_cast<int>(cloth.solids.count()); ++s) {
        const ClothSolid& shape = cloth.shapes[static_cast<std::size_t>(s)];
        const Mat3& axes = R[static_cast<std::size_t>(s)];
        const Vec3 centre = centre_of(cloth.solids.x, s),
                   v = moved.segment<3>(6 * s);
        const auto inverse = cloth.solids.inverse_mass.segment<6>(6 * s);
        const Real reach = reach_of(shape) + margin + cloth.thickness;
        for (int i = 0; i < cloth.count(); ++i) {
            const Real w = cloth.bodies.inverse_mass[3 * i];
            if (!(w > 0)) continue;
            // where it comes to, seen from the solid as it has moved
            const Vec3 p = x.segment<3>(3 * i) - v;
            if ((p - centre).squaredNorm() > reach * reach) continue;
            const Vec3 local = axes.transpose() * (p - centre);
            // through a mesh a particle may have come as far as it has moved
            const ClothGap here =
                shape.shape == ClothSolid::Shape::mesh
                    ? gap_to(*shape.mesh, local,
                             margin + cloth.thickness +
                                 (p - x0.segment<3>(3 * i)).norm(),
                             stack, near)
                    : gap_to(shape, local);
            const Real gap = here.gap - cloth.thickness;
            if (!(gap < margin) || tied(i, s)) continue;
            ClothContact c;
            c.particle = i, c.solid = s;
            c.normal = axes * here.normal;
            c.arm = p - here.gap * c.normal - centre;
            c.offset = c.normal.dot(p) - gap;
            c.from = x0.segment<3>(3 * i);
            c.A = c.At = w;
            if (inverse[0] > 0) {
                const Vec3 lever = axes.transpose() * cross(c.arm, c.normal);
                c.A +=
                    inverse[0] + lever.dot(inverse.tail<3>().cwiseProduct(lever));
                c.At +=
                    inverse[0] + c.arm.squaredNorm() * inverse.tail<3>().maxCoeff();
            }
            c.held = !(inverse.maxCoeff() > 0);
            c.goes = way(moved, s, c.arm);
            contacts.push_back(c);
        }
    }
}
//! [find]

//! [ties]
/// Three rows that pull as well: x − (c + R at) = 0, with (w + 1/m_b) 1 − [r]× I⁻¹ [r]×.
Vec3 ClothTouch::tie_impulse(const TouchingCloth& cloth, const ClothTie& tie,
                             const Vec3& d) const
{
    const Mat3& axes = R[static_cast<std::size_t>(tie.solid)];
    const Vec3 arm = axes * tie.at;
    const auto inverse = cloth.solids.inverse_mass.segment<6>(6 * tie.solid);
    const Real w = cloth.bodies.inverse_mass[3 * tie.particle];
    if (!(w > 0 || inverse[0] > 0)) return Vec3(0, 0, 0);
    Mat3 turns;  // Rᵀ [r]×
    for (int i = 0; i < 3; ++i)
        turns.col(i) = axes.transpose() * cross(arm, Vec3::Unit(i));
    const Mat3 A = (w + inverse[0]) * Mat3::Identity() +
                   turns.transpose() * inverse.tail<3>().asDiagonal() * turns;
    return solve_definite<3>(A, -d);
}

void ClothTouch::visit_ties(const TouchingCloth& cloth, VecX& x)
{
    for (const ClothTie& t : cloth.ties) {
        const Vec3 arm = R[static_cast<std::size_t>(t.solid)] * t.at;
        auto at = x.segment<3>(3 * t.particle);
        const Vec3 P = tie_impulse(cloth, t,
                                   at - centre_of(cloth.solids.x, t.solid) - arm -
                                       way(moved, t.solid, arm));
        at += cloth.bodies.inverse_mass[3 * t.particle] * P;
        push(cloth, moved, t.solid, arm, -P);
    }
}
//! [ties]

//! [visit]
void ClothTouch::visit(const TouchingCloth& cloth, VecX& x)
{
    visit_ties(cloth, x);
    for (ClothContact& c : contacts) {
        auto at = x.segment<3>(3 * c.particle);
        const Real w = cloth.bodies.inverse_mass[3 * c.particle];
        const Real mu = cloth.shapes[static_cast<std::size_t>(c.solid)].friction;
        if (!c.held) c.goes = way(moved, c.solid, c.arm);
        const Real C = c.normal.dot(at - c.goes) - c.offset;
        const Real push_by = std::max(Real{0}, c.lambda - C / c.A) - c.lambda;
        c.lambda += push_by;
        Vec3 P = push_by * c.normal;
        if (push_by != 0) {
            at += w * P;
            if (!c.held) push(cloth, moved, c.solid, c.arm, -P);
        }
        if (!(mu > 0) || (c.lambda == 0 && c.slide.isZero(0))) continue;
        if (!c.held) c.goes = way(moved, c.solid, c.arm);
        Vec3 slid = at - c.from - c.goes;
        slid -= c.normal.dot(slid) * c.normal;
        Vec3 next = c.slide - slid / c.At;
        const Real size = next.norm(), most = mu * c.lambda;
        if (size > most) next *= most / size;
        P = next - c.slide;
        c.slide = next;
        at += w * P;
        if (!c.held) push(cloth, moved, c.solid, c.arm, -P);
    }
}
//! [visit]

void ClothTouch::set_velocities(TouchingCloth& cloth, Real h, Real whole)
{
    Bodies<6>& solids = cloth.solids;
    for (Index k = 0; k < solids.count(); ++k) {
        if (!(solids.inverse_mass[6 * k] > 0)) continue;
        const auto way = unlimited.segment<6>(6 * k);
        auto before = u0.segment<6>(6 * k);
        const Vec<6> back = (moved.segment<6>(6 * k) - way) / whole;
        solids.velocity(k) = way / h;
        if (middle) solids.velocity(k) += solids.velocity(k) - before;
        solids.velocity(k) += back;
        before += back;
    }
}

//! [taken_back]
Vec3 taken_back(const Vec3& bounce, const Vec3& normal, Real lambda,
                const Vec3& slide, Real A, Real At, Real most, Real h)
{
    const auto part = [&](const Vec3& P, Real a) {
        const Real size = a * P.squaredNorm();
        return size > 0 ? std::clamp(h * P.dot(bounce) / size, Real{0}, Real{1})
                        : 0;
    };
    const Real along = part(lambda * normal, A);
    const bool sticks = slide.norm() < (1 - 1e-9) * most;
    return -(along * lambda * normal + (sticks ? part(slide, At) : along) * slide) /
           h;
}
//! [taken_back]

void ClothTouch::rest_in_the_middle(TouchingCloth& cloth, Real h,
                                    const VecX& start) const
{
    Bodies<3>& bodies = cloth.bodies;
    const auto bounce = [&](int particle, int solid, const Vec3& arm) -> Vec3 {
        return (bodies.velocity(particle) - start.segment<3>(3 * particle) -
                way(cloth.solids.u, solid, arm) + way(u0, solid, arm)) /
               2;
    };
    const auto change = [&](int particle, int solid, const Vec3& arm,
                            const Vec3& P) {
        bodies.velocity(particle) += bodies.inverse_mass[3 * particle] * P;
        push(cloth, cloth.solids.u, solid, arm, -P);
    };
    for (const ClothTie& t : cloth.ties) {  // sticks whatever it bears
        const Vec3 arm = R[static_cast<std::size_t>(t.solid)] * t.at;
        change(t.particle, t.solid, arm,
               tie_impulse(cloth, t, bounce(t.particle, t.solid, arm)));
    }
    for (const ClothContact& c : contacts)
        if (c.lambda > 0)
            change(c.particle, c.solid, c.arm,
                   taken_back(
                       bounce(c.particle, c.solid, c.arm), c.normal, c.lambda,
                       c.slide, c.A, c.At,
                       cloth.shapes[static_cast<std::size_t>(c.solid)].friction *
                           c.lambda,
                       h));
}

void ClothTouch::end(TouchingCloth& cloth, Real h)
{
    Bodies<6>& solids = cloth.solids;
    calm(cloth, h);
    for (Index k = 0; k < solids.count(); ++k)
        solids.integrate(k, Vec<6>(moved.segment<6>(6 * k) / h), h);
}

//! [calm]
void ClothTouch::calm(TouchingCloth& cloth, Real h) const
{
    for (const ClothContact& c : contacts) {
        if (!(c.lambda > 0)) continue;
        auto u = cloth.bodies.velocity(c.particle);
        const Vec3 point =
            c.held ? Vec3(c.goes / h) : way(cloth.solids.u, c.solid, c.arm);
        const Real parts = c.normal.dot(u - point);
        if (!(parts > 0)) continue;
        const Vec3 P = -parts / c.A * c.normal;
        u += cloth.bodies.inverse_mass[3 * c.particle] * P;
        if (!c.held) push(cloth, cloth.solids.u, c.solid, c.arm, -P);
    }
}
//! [calm]

}  // namespace rigid
