/// \file fast_solids.hpp
/// Solids that go so far in a step that they could be on the other side of something: they are stopped on their way.
///
///     fast:   ‖Δc‖ + max ‖δ × p̄‖ > ½ ρ,   ρ the inner radius
///     stopped at τ:   ω = I⁻¹ R(τ)ᵀ R(1) I ω,  the angular momentum stays;   v by (12.10)                (25.8)
///
/// As in chapter 12, whose rounds for fast bodies among each other are used. What was so near that it has a row in the step,
/// and goes no farther than it is long, is held by it: it is only stopped where it gets half its inner radius deep. What hangs
/// on a joint is never stopped: that would tear it off.
#pragma once

#include "chapters/12_contact_manifolds/fast_bodies.hpp"
#include "chapters/23_faces_that_touch/solid_pairs.hpp"
#include "chapters/25_world_in_space/mesh_touch.hpp"
#include "chapters/25_world_in_space/moving_solid.hpp"
#include "chapters/25_world_in_space/space_scene.hpp"

namespace rigid {

//! [fast_solids]
struct FastSolids {
    bool stop = false;  ///< false: nothing is looked for
    // What the last step found.
    std::vector<int> bodies;  ///< that were fast
    int impacts = 0;          ///< of those, stopped on their way
    int rounds = 0;           ///< distances computed
    std::vector<Real> part;   ///< of the way that each body goes
    std::vector<Real> inner;  ///< inner radii, for the rounds [m]
    std::vector<char> is_fast, is_held, is_joined;
    std::vector<Vec3> low, high;             ///< of what each can reach on its way
    std::vector<std::pair<int, int>> pairs;  ///< of fast bodies that may meet
    SolidImpactMemory memory;
    MeshMemory ground;
};
//! [fast_solids]

//! [put_back]
/// (25.8) for the bodies that were stopped.
template <class Motion>
void put_back(Bodies<6>& bodies, Real h, const std::vector<Row<6>>& rows,
              const Motion& motion, FastSolids& fast)
{
    for (const int k : fast.bodies) {
        const Real part = fast.part[static_cast<std::size_t>(k)];
        if (part >= 1) continue;
        if (fast.impacts++ == 0) {
            fast.is_held.assign(fast.is_fast.size(), 0);
            for (const Row<6>& row : rows)
                for (const Index body : {row.a, row.b})
                    if (body != world)
                        fast.is_held[static_cast<std::size_t>(body)] = 1;
        }
        const MovingSolid m = motion(k);
        const Mat3 R = m.axes_at(part);
        auto u = bodies.velocity(k);
        const Vec3 inverse = bodies.inverse_mass.segment<3>(6 * k + 3);
        if (inverse.minCoeff() > 0) {
            const Vec3 L = Vec3(u.tail<3>()).cwiseQuotient(inverse);
            u.tail<3>() = inverse.cwiseProduct(
                Vec3(R.transpose() * (rotation_of(bodies.x, k) * L)));
        }
        bodies.position(k) << m.centre_at(part), rotation_vector(R);
        const Vec3 gained =
            (1 - part) * h * bodies.inverse_mass[6 * k] * bodies.force(k).head<3>();
        const Real work = gained.dot(u.head<3>());
        if (!fast.is_held[static_cast<std::size_t>(k)]) u.head<3>() -= gained;
        else if (work > 0)
            u.head<3>() *= std::sqrt(
                std::max(Real{0}, 1 - 2 * work / u.head<3>().squaredNorm()));
    }
}
//! [put_back]

/// When a solid that starts before a triangle gets too deep into it. What slides over
/// one is close to the next when it gets there: only depth is an impact.
Impact impact_on(const TriangleMesh& mesh, int t, const MovingSolid& m,
                 const SolidForm& form, Real inner, Real margin, FastSolids& fast);

/// After a step: what went so far that it could have passed through something goes
/// back to where it would have met it.
/// \param near  the forms of the bodies; where they are is not asked
void stop_fast_solids(SpaceScene& scene, const StepSettings& settings,
                      const StepData<6>& now, const SolidPairs& near,
                      FastSolids& fast);

}  // namespace rigid
