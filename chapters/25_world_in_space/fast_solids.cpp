// The functions of fast_solids.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/25_world_in_space/fast_solids.hpp"

namespace rigid {

//! [on_mesh]
Impact impact_on(const TriangleMesh& mesh, int t, const MovingSolid& m,
                 const SolidForm& form, Real inner, Real margin, FastSolids& fast)
{
    if (behind(mesh, t, m.place(form, 0, fast.memory.b))) return {};
    fast.ground.take(mesh, t);
    Real target = margin / 4, tolerance = margin / 4;
    if (inner > 0) target = -std::min(inner, margin) / 2, tolerance = -target / 4;
    Impact impact;
    for (const bool closer : {false, true}) {
        if (closer)  // than it was at the start
            target = std::min(-inner / 2, impact.start - inner / 8),
            tolerance = inner / 16;
        impact = time_of_impact({}, fast.ground.form, m, form, target, tolerance,
                                fast.memory);
        fast.rounds += impact.rounds;
        if (!impact.close || !(inner > 0)) break;
    }
    return impact;
}
//! [on_mesh]

//! [stop_fast]
void stop_fast_solids(SpaceScene& scene, const StepSettings& settings,
                      const StepData<6>& now, const SolidPairs& near,
                      FastSolids& fast)
{
    const auto K = static_cast<std::size_t>(scene.bodies.count());
    const Real margin = settings.margin * now.length;
    const auto motion = [&](int k) {
        const Vec3 spin = scene.bodies.velocity(k).tail<3>();
        return motion_of(near.forms[static_cast<std::size_t>(k)], now.x_found,
                         scene.bodies.x, k, settings.h * spin);
    };
    const auto forms = [&](int k) -> const std::vector<SolidForm>& {
        return near.forms[static_cast<std::size_t>(k)];
    };
    fast.bodies.clear();
    fast.impacts = fast.rounds = 0;
    fast.is_joined.assign(K, 0);
    for (const SpaceJoint& joint : scene.joints)
        for (const Index k : {joint.a, joint.b})
            if (k != world) fast.is_joined[static_cast<std::size_t>(k)] = 1;
    for (const int k : now.active) {
        const auto at = static_cast<std::size_t>(k);
        if (forms(k).empty() || fast.is_joined[at] || !scene.bodies.can_move(k))
            continue;
        const MovingSolid m = motion(k);
        Real turns = 0;
        for (const SolidForm& form : forms(k))
            turns = std::max(turns, turning(m, form));
        if (m.way.norm() + turns > near.inner[at] / 2) fast.bodies.push_back(k);
    }
    if (fast.bodies.empty()) return;

    fast.inner = near.inner;
    fast.part.assign(K, 1);
    fast.is_fast.assign(K, 0);
    for (const int k : fast.bodies) fast.is_fast[static_cast<std::size_t>(k)] = 1;
    // all that each can reach on its way, however it turns
    fast.low.resize(K), fast.high.resize(K);
    for (std::size_t k = 0; k < K; ++k) {
        const MovingSolid m = motion(static_cast<int>(k));
        const Vec3 to = m.from + m.way,
                   out = Vec3::Constant(near.reach[k] + margin);
        fast.low[k] = m.from.cwiseMin(to) - out;
        fast.high[k] = m.from.cwiseMax(to) + out;
    }
    const auto inner_of = [&](int k) {
        return fast.inner[static_cast<std::size_t>(k)];
    };
    const auto may_meet = [&](int a, int b) {
        const auto i = static_cast<std::size_t>(a), j = static_cast<std::size_t>(b);
        return (fast.low[i].array() <= fast.high[j].array()).all() &&
               (fast.low[j].array() <= fast.high[i].array()).all();
    };
    const auto number_of = [&](const MovingSolid& m) {
        return static_cast<std::size_t>(m.forms - near.forms.data());
    };
    // whether it is where contacts were found, and goes no farther than it is long
    const auto stays_near = [&](const MovingSolid& m) {
        const auto body = static_cast<Index>(number_of(m));
        if (m.from != centre_of(now.x_found, body) ||
            m.R != rotation_of(now.x_found, body))
            return false;
        Real turns = 0;
        for (const SolidForm& form : *m.forms)
            turns = std::max(turns, turning(m, form));
        return m.way.norm() + turns <= 2 * near.reach[number_of(m)];
    };
    // within this its row was looked for
    const auto row_within = [&](const MovingSolid& m) {
        return near.ahead_of[number_of(m)];
    };
    // of what has its row, or is close already, only that it gets deeper than half its
    // inner radius, or than it is by an eighth
    const auto search = [&](Real inner, Real held_within, const auto& until) {
        Impact impact = until(margin / 4, margin / 4);
        fast.rounds += impact.rounds;
        const bool held = impact.hit && impact.start < held_within;
        if ((held || impact.close) && inner > 0) {
            const Real deep = std::min(-inner / 2, impact.start - inner / 8);
            impact = until(deep, inner / 16);
            fast.rounds += impact.rounds;
        }
        return impact;
    };
    const auto earlier = [](Impact& first, const Impact& other) {
        if (other.hit && (!first.hit || other.part < first.part)) first = other;
    };
    const auto first_impact = [&](const MovingSolid& a, const MovingSolid& b,
                                  Real inner) {
        Impact first;
        const Real held_within = stays_near(a) && stays_near(b)
                                     ? margin + row_within(a) + row_within(b)
                                     : -infinity;
        for (const SolidForm& p : *a.forms)
            for (const SolidForm& q : *b.forms)
                earlier(first, search(inner, held_within,
                                      [&](Real target, Real tolerance) {
                                          return time_of_impact(a, p, b, q, target,
                                                                tolerance,
                                                                fast.memory);
                                      }));
        return first;
    };
    const auto part_of = [&](int k) -> Real& {
        return fast.part[static_cast<std::size_t>(k)];
    };
    const auto hold = [&](int k, const Impact& impact) {
        if (impact.hit) part_of(k) = std::min(part_of(k), impact.part);
    };
    for (const int a : fast.bodies) {
        const MovingSolid m = motion(a);
        const auto at = static_cast<std::size_t>(a);
        for (int b = 0; b < static_cast<int>(K); ++b)
            if (!fast.is_fast[static_cast<std::size_t>(b)] && may_meet(a, b))
                hold(a, first_impact(m, motion(b),
                                     std::max(fast.inner[at], inner_of(b))));
        const Real held_within =
            stays_near(m) ? margin + near.way_of[at] : -infinity;
        for (const SolidWall& wall : scene.walls)
            for (const SolidForm& form : forms(a))
                hold(a, search(fast.inner[at], held_within,
                               [&](Real target, Real tolerance) {
                                   return time_of_impact(wall, m, form, target,
                                                         tolerance, fast.memory);
                               }));
        for (const auto& mesh : scene.meshes) {
            mesh->near({fast.low[at], fast.high[at]}, fast.ground.stack,
                       fast.ground.near);
            for (const SolidForm& form : forms(a))
                for (const int t : fast.ground.near)
                    hold(a, impact_on(*mesh, t, m, form, fast.inner[at], margin,
                                      fast));
        }
    }
    fast.pairs.clear();
    for (std::size_t i = 0; i < fast.bodies.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
            if (may_meet(fast.bodies[j], fast.bodies[i]))
                fast.pairs.emplace_back(fast.bodies[j], fast.bodies[i]);
    stop_each_other(motion, first_impact, part_of, fast);
    put_back(scene.bodies, settings.h, now.rows, motion, fast);
}
//! [stop_fast]

}  // namespace rigid
