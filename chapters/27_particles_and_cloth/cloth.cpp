// The functions of cloth.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/27_particles_and_cloth/cloth.hpp"

#include <algorithm>
#include <span>

namespace rigid {

namespace cloth_checks {

using Text = std::string;

void require_particles(const ClothScene& cloth, std::span<const int> p,
                       const Text& who)
{
    for (std::size_t i = 0; i < p.size(); ++i) {
        if (p[i] < 0 || p[i] >= cloth.count())
            throw std::invalid_argument(who + " is on particle " +
                                        std::to_string(p[i]) + "; there are " +
                                        std::to_string(cloth.count()));
        for (std::size_t j = 0; j < i; ++j)
            if (p[i] == p[j])
                throw std::invalid_argument(who + " has particle " +
                                            std::to_string(p[i]) +
                                            " twice; its particles must differ");
    }
}

void require_stiffness(Real k, const Text& who, const Text& unit, bool or_infinite)
{
    if (!(k > 0) || (!or_infinite && !std::isfinite(k)))
        throw std::invalid_argument(
            "the stiffness of " + who + " is " + shortest(k) + " " + unit +
            "; it must be positive" + (or_infinite ? "" : " and finite"));
}

}  // namespace cloth_checks

void require_not_negative(Real value, const std::string& what)
{
    if (!(value >= 0) || !std::isfinite(value))
        throw std::invalid_argument(what + " is " + shortest(value) +
                                    "; it must be zero or positive and finite");
}

void require_state(const ClothScene& cloth)
{
    const Bodies<3>& b = cloth.bodies;
    const Index n = b.x.size();
    const bool fine = n % 3 == 0 && b.u.size() == n && b.f.size() == n &&
                      b.inverse_mass.size() == n && b.x.allFinite() &&
                      b.u.allFinite() && b.f.allFinite() &&
                      b.inverse_mass.allFinite();
    if (!fine) {
        for (Index i = 0; i < b.inverse_mass.size(); ++i)
            if (b.inverse_mass[i] == infinity)
                throw std::invalid_argument(
                    "particle " + std::to_string(i / 3) +
                    " has no mass; it must have a positive one, or 1/m = 0, which "
                    "pins it");
        require_valid(b);  // says which number
    }
    if (!cloth.gravity.allFinite() || !cloth.wind.allFinite())
        throw std::invalid_argument("gravity or wind is not finite");
    if (!(cloth.air >= 0) || !std::isfinite(cloth.air))
        require_not_negative(cloth.air, "the drag of the air");
    if (!(cloth.drag >= 0) || !std::isfinite(cloth.drag))
        require_not_negative(cloth.drag, "the drag");
}

void require_rows(const ClothScene& cloth)
{
    using namespace cloth_checks;
    require_state(cloth);
    require_valid(cloth.bodies);
    for (Index k = 0; k < cloth.bodies.count(); ++k) {
        const auto w = cloth.bodies.inverse_mass.segment<3>(3 * k);
        if (w[1] != w[0] || w[2] != w[0])
            throw std::invalid_argument(
                "particle " + std::to_string(k) + " has the inverse masses " +
                shortest(w[0]) + ", " + shortest(w[1]) + " and " + shortest(w[2]) +
                " 1/kg; the three must be the same");
    }
    for (std::size_t i = 0; i < cloth.springs.size(); ++i) {
        const ClothSpring& s = cloth.springs[i];
        const Text who = "spring " + std::to_string(i);
        require_particles(cloth, std::array{s.a, s.b}, who);
        if (!(s.length > 0) || !std::isfinite(s.length))
            throw std::invalid_argument("the length of " + who + " is " +
                                        shortest(s.length) +
                                        " m; it must be positive and finite");
        require_stiffness(s.stiffness, who, "N/m", true);
    }
    for (std::size_t i = 0; i < cloth.bends.size(); ++i) {
        const ClothBend& b = cloth.bends[i];
        const Text who = "bend " + std::to_string(i);
        require_particles(cloth, {b.p.data(), static_cast<std::size_t>(b.count())},
                          who);
        require_stiffness(b.stiffness, who, "N m", false);
        for (const Real w : b.w)
            if (!std::isfinite(w))
                throw std::invalid_argument("a weight of " + who + " is " +
                                            shortest(w) +
                                            " 1/m; it must be finite");
    }
    for (std::size_t i = 0; i < cloth.hinges.size(); ++i) {
        const ClothHinge& b = cloth.hinges[i];
        const Text who = "hinge " + std::to_string(i);
        require_particles(cloth, b.p, who);
        require_stiffness(b.stiffness, who, "N m", false);
        if (!std::isfinite(b.angle))
            throw std::invalid_argument("the angle of " + who + " is " +
                                        shortest(b.angle) + "; it must be finite");
    }
    for (std::size_t i = 0; i < cloth.triangles.size(); ++i)
        require_particles(cloth, cloth.triangles[i],
                          "triangle " + std::to_string(i));
}

void require_valid(const ClothScene& cloth)
{
    require_rows(cloth);
    for (std::size_t i = 0; i < cloth.triangles.size(); ++i) {
        const auto& t = cloth.triangles[i];
        const Vec3 a = cloth.bodies.position(t[0]);
        if (!(cross(cloth.bodies.position(t[1]) - a,
                    cloth.bodies.position(t[2]) - a)
                  .norm() > 0))
            throw std::invalid_argument("triangle " + std::to_string(i) +
                                        " has no area");
    }
}

void require_extensible(const ClothScene& cloth)
{
    for (std::size_t i = 0; i < cloth.springs.size(); ++i)
        if (!(cloth.springs[i].stiffness < infinity))
            throw std::invalid_argument(
                "spring " + std::to_string(i) +
                " is inextensible; only pbd, xpbd, threads, augmented and "
                "exact take that, this method needs a finite stiffness");
}

//! [hinge]
Real hinge_angle(const ClothHinge& h, const VecX& x, std::array<Vec3, 4>& J)
{
    const Vec3 p0 = x.segment<3>(3 * h.p[0]), p1 = x.segment<3>(3 * h.p[1]),
               p2 = x.segment<3>(3 * h.p[2]), p3 = x.segment<3>(3 * h.p[3]);
    const Vec3 e = p1 - p0, m = cross(e, p2 - p0), n = cross(p3 - p0, e);
    const Real length = e.norm(), m2 = m.squaredNorm(), n2 = n.squaredNorm();
    if (!(length > 0 && m2 > 0 && n2 > 0)) {  // no triangle, no angle
        J.fill(Vec3::Zero());
        return 0;
    }
    J[2] = m * (length / m2), J[3] = n * (length / n2);
    // what a corner does not carry its edge does, by the lever of the foot
    const Real t2 = (p2 - p0).dot(e) / (length * length),
               t3 = (p3 - p0).dot(e) / (length * length);
    J[0] = -(1 - t2) * J[2] - (1 - t3) * J[3];
    J[1] = -t2 * J[2] - t3 * J[3];
    return atan2(cross(n, m).dot(e) / length, m.dot(n));
}
//! [hinge]

Real hinge_angle(const ClothHinge& h, const VecX& x)
{
    std::array<Vec3, 4> J;
    return hinge_angle(h, x, J);
}

//! [bend_of]
ClothBend bend_of(const ClothHinge& h, const VecX& x)
{
    const Vec3 p0 = x.segment<3>(3 * h.p[0]), e = x.segment<3>(3 * h.p[1]) - p0;
    ClothBend bend{h.p, {}, h.stiffness};
    for (const std::size_t k : {2u, 3u}) {
        const Vec3 r = x.segment<3>(3 * h.p[k]) - p0;
        const Real foot = r.dot(e) / e.squaredNorm();
        bend.w[k] = e.norm() / cross(e, r).norm();  // one over the height
        bend.w[0] -= (1 - foot) * bend.w[k];
        bend.w[1] -= foot * bend.w[k];
    }
    return bend;
}
//! [bend_of]

Real row_energy(const ClothScene& cloth, const VecX& x)
{
    Real sum = 0;
    for (const ClothSpring& s : cloth.springs) {
        const Real C =
            (x.segment<3>(3 * s.b) - x.segment<3>(3 * s.a)).norm() - s.length;
        if (s.stiffness < infinity) sum += s.stiffness * C * C / 2;
    }
    for (const ClothBend& b : cloth.bends)
        sum += b.stiffness * b.value(x).squaredNorm() / 2;
    for (const ClothHinge& h : cloth.hinges) {
        const Real C = hinge_angle(h, x) - h.angle;
        sum += h.stiffness * C * C / 2;
    }
    return sum;
}

Real energy(const ClothScene& cloth)
{
    Real sum = row_energy(cloth, cloth.bodies.x);
    for (Index k = 0; k < cloth.bodies.count(); ++k) {
        const Real w = cloth.bodies.inverse_mass[3 * k];
        if (!(w > 0)) continue;
        sum += (cloth.bodies.velocity(k).squaredNorm() / 2 -
                cloth.gravity.dot(cloth.bodies.position(k))) /
               w;
    }
    return sum;
}

//! [forces]
void add_row_forces(const ClothScene& cloth, const VecX& x, VecX& f)
{
    for (const ClothSpring& s : cloth.springs) {
        const Vec3 d = x.segment<3>(3 * s.b) - x.segment<3>(3 * s.a);
        const Real length = d.norm();
        if (!(length > 0)) continue;
        const Vec3 pull = d * (s.stiffness * (length - s.length) / length);
        f.segment<3>(3 * s.a) += pull;
        f.segment<3>(3 * s.b) -= pull;
    }
    for (const ClothBend& b : cloth.bends) {
        const Vec3 d = b.stiffness * b.value(x);
        for (std::size_t i = 0; i < 4 && b.p[i] >= 0; ++i)
            f.segment<3>(3 * b.p[i]) -= b.w[i] * d;
    }
    std::array<Vec3, 4> J;
    for (const ClothHinge& h : cloth.hinges) {
        const Real moment = h.stiffness * (hinge_angle(h, x, J) - h.angle);
        for (std::size_t i = 0; i < 4; ++i)
            f.segment<3>(3 * h.p[i]) -= moment * J[i];
    }
}
//! [forces]

Real largest_stretch(const ClothScene& cloth, Real stiff)
{
    Real most = 0;
    const VecX& x = cloth.bodies.x;
    for (const ClothSpring& s : cloth.springs)
        if (s.stiffness >= stiff)
            most = std::max(most,
                            (x.segment<3>(3 * s.b) - x.segment<3>(3 * s.a)).norm() /
                                    s.length -
                                1);
    return most;
}

Real mean_stretch(const ClothScene& cloth, Real stiff)
{
    Real sum = 0;
    int count = 0;
    const VecX& x = cloth.bodies.x;
    for (const ClothSpring& s : cloth.springs) {
        if (!(s.stiffness >= stiff)) continue;
        ++count;
        sum += std::max(
            Real{0},
            (x.segment<3>(3 * s.b) - x.segment<3>(3 * s.a)).norm() / s.length - 1);
    }
    return count == 0 ? 0 : sum / count;
}

Vec3 momentum(const ClothScene& cloth)
{
    Vec3 sum(0, 0, 0);
    for (Index k = 0; k < cloth.bodies.count(); ++k)
        if (const Real w = cloth.bodies.inverse_mass[3 * k]; w > 0)
            sum += cloth.bodies.velocity(k) / w;
    return sum;
}

//! [tear]
int tear(ClothScene& cloth, Real strain)
{
    const VecX& x = cloth.bodies.x;
    int torn = 0;
    std::erase_if(cloth.springs, [&](const ClothSpring& s) {
        const Real length = (x.segment<3>(3 * s.b) - x.segment<3>(3 * s.a)).norm();
        if (!(length > (1 + strain) * s.length)) return false;
        ++torn;
        const auto has_both = [&s](const auto& p) {
            return std::find(p.begin(), p.end(), s.a) != p.end() &&
                   std::find(p.begin(), p.end(), s.b) != p.end();
        };
        std::erase_if(cloth.triangles, has_both);
        std::erase_if(cloth.bends,
                      [&](const ClothBend& b) { return has_both(b.p); });
        std::erase_if(cloth.hinges,
                      [&](const ClothHinge& h) { return has_both(h.p); });
        return true;
    });
    cloth.changes += torn > 0;
    return torn;
}
//! [tear]

}  // namespace rigid
