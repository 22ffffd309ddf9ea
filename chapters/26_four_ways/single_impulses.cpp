// The functions of single_impulses.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/26_four_ways/single_impulses.hpp"

namespace rigid {

void require_valid(const SingleImpulseSettings& settings)
{
    if (!(settings.hop > 0) || !std::isfinite(settings.hop))
        throw std::invalid_argument("the hop of a microcollision is " +
                                    shortest(settings.hop) +
                                    " lengths of the scene; it must be positive "
                                    "and finite");
    if (settings.most_collisions < 1)
        throw std::invalid_argument("the number of collisions in a step is " +
                                    std::to_string(settings.most_collisions) +
                                    "; it must be at least 1");
}

namespace {

/// Where free bodies are after t seconds.
void fly(const JointedScene& scene, Real t, VecX& x)
{
    const Bodies<3>& bodies = scene.bodies;
    x = bodies.x + t * bodies.u;
    for (Index k = 0; k < bodies.count(); ++k)
        x.segment<2>(3 * k) += t * t / 2 * free_acceleration(scene, k);
}

/// Moves them there. Returns false, and moves nothing, if that is out of all bounds.
bool fly(JointedScene& scene, Real t)
{
    VecX x;
    fly(scene, t, x);
    if (!x.allFinite()) return false;
    Bodies<3>& bodies = scene.bodies;
    bodies.x = x;
    for (Index k = 0; k < bodies.count(); ++k)
        bodies.u.segment<2>(3 * k) += t * free_acceleration(scene, k);
    return true;
}

/// When a gap closes within t_end; t_end or more: not before.
Real closing_time(const JointedScene& scene, const PushJoint& push, Real t_end,
                  VecX& x)
{
    const VecX &x0 = scene.bodies.x, &u = scene.bodies.u;
    const Constraint<3> c = gap_of(push, x0);
    const Row<3> row = bilateral(c, scene.bodies.inverse_mass);
    const Real v = row.velocity(u);
    VecX a;
    free_accelerations(scene, a);
    // C + v t + ½ b t² = 0, then the way itself by halves around it
    const Real b = velocity_product(push.gap, x0, u) + row.velocity(a),
               C = std::max(Real{0}, c.C);
    if (c.C <= 0 && (v < 0 || (v == 0 && b < 0))) return 0;
    const Real root = v * v - 2 * b * C;
    Real t = infinity;
    if (root >= 0) {
        const Real s = std::sqrt(root);
        if (v < 0 && C > 0) t = 2 * C / (-v + s);
        else if (b < 0) t = (v + s) / -b;
    }
    const auto gap_at = [&](Real at) {
        fly(scene, at, x);
        return gap_of(push, x).C;
    };
    Real after = std::min(t_end, 1.02 * t + 1e-9);
    if (gap_at(after) > 0) {  // the way bends: is it closed at the end?
        if (after >= t_end || gap_at(t_end) > 0) return infinity;
        after = t_end;
    }
    Real before = std::min(after, 0.98 * t);
    if (!(gap_at(before) > 0)) before = 0;
    if (before == 0 && !(c.C > 0)) {  // it left just now: from where it is open
        before = after;
        for (int i = 0; i < 40 && !(gap_at(before) > 0); ++i) before /= 2;
        if (!(gap_at(before) > 0)) return infinity;
    }
    for (int i = 0; i < 100; ++i) {
        const Real middle = (before + after) / 2;
        if (!(before < middle && middle < after)) break;
        (gap_at(middle) > 0 ? before : after) = middle;
    }
    return after;
}

}  // namespace

void SingleImpulses::require_valid(const JointedScene& scene) const
{
    rigid::require_valid(settings);
    if (!scene.joints.empty())
        throw std::invalid_argument(
            "the scene has " + std::to_string(scene.joints.size()) +
            " rows of joints; impulses one at a time are those of collisions, and "
            "what is joined never collides");
    require_valid_motion(scene, filter, {});
    require_one_friction(scene);
}

//! [advance]
Status SingleImpulses::advance(JointedScene& scene, Real h)
{
    require_step(h);
    require_valid(scene);
    Bodies<3>& bodies = scene.bodies;
    const Real length = typical_length(scene),
               hop = std::sqrt(2 * scene.gravity.norm() * settings.hop * length);
    Real left = h;
    VecX x;
    for (int count = 0; left > 0; ++count) {
        if (count >= settings.most_collisions) return Status::iteration_limit;
        find_push_joints(scene, filter,
                         0.01 * length + closing_reach(scene, length, left), near_);
        Real first = infinity;
        const PushJoint* meets = nullptr;
        for (const PushJoint& push : near_) {
            const Real t = closing_time(scene, push, left, x);
            if (t < first) first = t, meets = &push;
        }
        if (!(first < left))
            return fly(scene, left) ? Status::solved : Status::iteration_limit;
        if (!fly(scene, first)) return Status::iteration_limit;
        left -= first;
        const Constraint<3> c = gap_of(*meets, bodies.x);
        const Constraint<3> along = drag_of(*meets, c, 0, bodies.x, bodies.u).c;
        const Row<3> n = bilateral(c, bodies.inverse_mass),
                     t = bilateral(along, bodies.inverse_mass);
        Eigen::Matrix<Real, 2, 2> A;
        A << coupling(n, n), coupling(n, t), coupling(t, n), coupling(t, t);
        const OneImpulse before{n.velocity(bodies.u),
                                t.velocity(bodies.u) - along.speed};
        if (!(before.n <= 0) || !(A(0, 0) > 0)) continue;
        const Real e = meets->surface.restitution, mu = meets->surface.friction;
        OneImpulse lambda;
        ++collisions;
        if (-before.n * std::max(e, Real{0}) > hop || !(hop > 0)) {
            lambda = one_contact(A, before, mu, 0);  // (13.27)
            lambda.n *= 1 + e, lambda.t *= 1 + e;
        } else {
            ++micro;
            lambda = one_contact(A, before, mu, std::max(hop, -e * before.n));
        }
        n.apply(lambda.n, bodies.u);
        t.apply(lambda.t, bodies.u);
    }
    return Status::solved;
}
//! [advance]

}  // namespace rigid
