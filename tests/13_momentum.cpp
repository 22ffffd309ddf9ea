/// Chapter 13: what becomes of angular momentum where positions move otherwise than velocities say, and of deep overlaps.

#include "chapters/12_contact_manifolds/manifold_method.hpp"
#include "chapters/13_friction/friction_solver.hpp"

#include "tests/catch.hpp"

#include <algorithm>
#include <cmath>

using namespace rigid;

namespace {

/// A box that spins flies into another one, far from everything.
RoughScene two_boxes(Real spin, Real distance = 1.4)
{
    RoughScene scene;
    scene.gravity = {0, 0};
    add_body(scene, box(1, 1), 1, {0, 0});
    add_body(scene, box(1, 0.5), 3, {distance, 0.2});
    scene.bodies.velocity(0) << 2, 0, spin;
    cover(scene, {0.5, 0, 0, 0});
    return scene;
}

/// The point of body k that was at this place when the contact was found.
Vec2 carried(const StepData<3>& now, const VecX& x, Index k, const Vec2& place)
{
    const Vec2 arm = place - now.x_found.segment<2>(3 * k);
    const Real turn = x[3 * k + 2] - now.x_found[3 * k + 2];
    return x.segment<2>(3 * k) + std::cos(turn) * arm + std::sin(turn) * perpendicular(arm);
}

using Coulomb = HoldOrSlide<CoulombSolver<FindFriction>>;

/// Sums up (13.23) over all sub-steps.
struct Watched : Coulomb {
    Real predicted = 0;

    template <int Dof>
    void solve(Bodies<Dof>& bodies, StepData<Dof>& now)
    {
        Coulomb::solve(bodies, now);
        for (std::size_t i = 0; i < now.contacts.size(); ++i) {
            const Contact& contact = now.contacts[i];
            if (contact.normal_of != NormalOf::fixed) continue;
            const Vec2& n = contact.normal;
            const Vec2 apart = carried(now, bodies.x, contact.b, contact.point + contact.core_b * n) -
                               carried(now, bodies.x, contact.a, contact.point - contact.core_a * n);
            predicted += cross2(apart, n) *
                         now.solution.lambda[static_cast<Index>(normal_of(now, static_cast<int>(i)))];
        }
    }
};

struct WatchedMethod {
    WithFriction<Manifolds> contacts;
    Correction correction;
    WarmStart start = last_impulses();
    Watched solver;
};

}  // namespace

TEST_CASE("angular momentum changes by what moves a body otherwise than its velocity says", "[house]")
{
    for (const Stabilizer way : {Stabilizer::none, Stabilizer::baumgarte, Stabilizer::relaxation,
                                 Stabilizer::split_impulse, Stabilizer::projection}) {
        RoughScene scene = two_boxes(20);
        ExactFriction<Manifolds> method;
        method.correction.method = way;
        method.contacts.fast.stop = false;
        StepData<3> now;
        const Real h = 1.0 / 120, start = momenta(scene.bodies)[2];
        Real most = 0;
        for (int i = 0; i < 60; ++i) {
            const VecX x = scene.bodies.x;
            const Real before = momenta(scene.bodies)[2];
            step(scene, {.h = h}, method, now);
            Real predicted = 0;  // (13.22)
            for (Index k = 0; k < 2; ++k) {
                const Vec2 u = scene.bodies.velocity(k).head<2>(),
                           beside = scene.bodies.position(k).head<2>() - x.segment<2>(3 * k) - h * u;
                predicted += cross2(beside, u) / scene.bodies.inverse_mass[3 * k];
            }
            // rounding of momenta of about 10
            CHECK(std::abs(momenta(scene.bodies)[2] - before - predicted) <= 1e-12);
            most = std::max(most, std::abs(momenta(scene.bodies)[2] - start));
        }
        INFO(to_string(way) << ": " << most);
        const bool keeps = way == Stabilizer::none || way == Stabilizer::baumgarte;
        CHECK((most <= 1e-11) == keeps);
    }
}

TEST_CASE("in sub-steps angular momentum changes only where a normal stays while its points slide apart",
          "[house]")
{
    for (const int substeps : {1, 4}) {
        Real most = 0;
        for (int round = 0; round < 8; ++round) {  // the impact is in one sub-step or another
            RoughScene scene = two_boxes(20, 1.4 + 0.011 * round);
            WatchedMethod method;
            method.correction.method = Stabilizer::none;
            method.contacts.fast.stop = false;
            StepData<3> now;
            const Real start = momenta(scene.bodies)[2];
            for (int i = 0; i < 60; ++i) {
                step(scene, {.h = 1.0 / 120, .substeps = substeps}, method, now);
                const Real change = momenta(scene.bodies)[2] - start;
                // rounding of momenta of about 10
                CHECK(std::abs(change - method.solver.predicted) <= 1e-11);
                most = std::max(most, std::abs(change));
            }
        }
        INFO(substeps << ": " << most);
        CHECK((most <= 1e-11) == (substeps == 1));  // corners meet
    }
}

TEST_CASE(
    "two boxes that overlap are thrown apart with the energy of (13.24) and no more than the limit says",
    "[house]")
{
    const Real overlap = 0.4;
    for (const Real limit : {infinity, 2.0})
        for (const Real h : {1.0 / 60, 1.0 / 240}) {
            RoughScene scene;
            scene.gravity = {0, 0};
            for (const Real side : {-0.5, 0.5}) add_body(scene, box(1, 1), 3, {side * (1 - overlap), 0});
            cover(scene, {0, 0, 0, 0});
            ExactFriction<Manifolds> method;
            method.correction.max_correction_speed = limit;
            StepData<3> now;
            step(scene, {.h = h}, method, now);
            const Real speed = std::min(0.2 * overlap / h, limit * now.length);
            // to rounding of 100 J
            CHECK(std::abs(energy(scene) - 3 * speed * speed / 4) <= 1e-11);
        }
}
