// The functions of cloth_step.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/27_particles_and_cloth/cloth_step.hpp"

#include <algorithm>

namespace rigid {

namespace cloth_names {

constexpr std::array<std::string_view, 11> all{
    "explicit",   "pbd",      "xpbd",   "threads",  "particles", "augmented",
    "projective", "implicit", "newton", "midpoint", "exact"};

}  // namespace cloth_names

std::string_view to_string(ClothMethod method)
{
    return cloth_names::all[static_cast<std::size_t>(method)];
}

ClothMethod cloth_method(std::string_view name)
{
    const auto found =
        std::find(cloth_names::all.begin(), cloth_names::all.end(), name);
    if (found == cloth_names::all.end())
        throw std::invalid_argument("there is no method \"" + std::string(name) +
                                    "\" for a cloth");
    return static_cast<ClothMethod>(found - cloth_names::all.begin());
}

bool sweeps_rows(ClothMethod method)
{
    return method == ClothMethod::pbd || method == ClothMethod::xpbd ||
           method == ClothMethod::threads;
}

bool takes_hard_rows(ClothMethod method)
{
    return sweeps_rows(method) || method == ClothMethod::augmented ||
           method == ClothMethod::exact;
}

void require_valid(const ClothSettings& s)
{
    require_step(s.h);
    if (s.substeps < 1)
        throw std::invalid_argument("the number of sub-steps is " +
                                    std::to_string(s.substeps) +
                                    "; it must be one or more");
    if (s.sweeps < 0)
        throw std::invalid_argument("the number of sweeps is " +
                                    std::to_string(s.sweeps) +
                                    "; it must be zero or more");
    if (s.limit_passes < 0)
        throw std::invalid_argument("the number of passes of a limit is " +
                                    std::to_string(s.limit_passes) +
                                    "; it must be zero or more");
    if (!(s.pbd_share > 0 && s.pbd_share <= 1))
        throw std::invalid_argument("the share of a visit is " +
                                    shortest(s.pbd_share) +
                                    "; it must lie above zero and be at most one");
    for (const Real strain : {s.strain_limit, s.strength})
        if (!(strain >= 0))
            throw std::invalid_argument("the limit of strain is " +
                                        shortest(strain) +
                                        "; it must be zero or more");
    if (!(s.limit_stiffness >= 0))
        throw std::invalid_argument("the least stiffness that a limit holds is " +
                                    shortest(s.limit_stiffness) +
                                    " N/m; it must be zero or more");
}

void ClothMemory::prepare(const ClothScene& cloth, const ClothSettings& settings)
{
    const Key now{static_cast<std::size_t>(cloth.count()),
                  cloth.springs.size(),
                  cloth.bends.size(),
                  cloth.hinges.size(),
                  cloth.changes,
                  settings.method,
                  settings.part()};
    require_state(cloth);
    if (now == key_) return;
    // triangles had an area when the cloth was made; they need not keep it
    if (key_.changes < 0) require_valid(cloth);
    else require_rows(cloth);
    if (!takes_hard_rows(settings.method)) require_extensible(cloth);
    if (settings.method == ClothMethod::projective)
        projective.prepare(cloth, settings.part());
    if (settings.method == ClothMethod::threads) threads.find(cloth);
    if (settings.method == ClothMethod::particles ||
        settings.method == ClothMethod::augmented)
        particles.find(cloth);
    if (settings.method == ClothMethod::exact) exact.prepare(cloth);
    key_ = now;
}

//! [wind]
void add_wind(const ClothScene& cloth, VecX& f)
{
    for (const auto& t : cloth.triangles) {
        const Vec3 a = cloth.bodies.position(t[0]);
        const Vec3 N =
            cross(cloth.bodies.position(t[1]) - a, cloth.bodies.position(t[2]) - a);
        const Real twice = N.norm();
        if (!(twice > 0)) continue;
        Vec3 v = cloth.wind;
        for (const int k : t) v -= cloth.bodies.velocity(k) / 3;
        const Vec3 n = N / twice;
        const Real across = n.dot(v);
        const Vec3 push =
            n * (cloth.air * twice / 2 * std::abs(across) * across / 3);
        for (const int k : t) f.segment<3>(3 * k) += push;
    }
}
//! [wind]

//! [begin]
void ClothMemory::begin(ClothScene& cloth, const ClothSettings& settings)
{
    Bodies<3>& bodies = cloth.bodies;
    const Real h = settings.part();
    const Real way = settings.method == ClothMethod::midpoint ? h / 2 : h;
    x0 = bodies.x, u0 = bodies.u;
    force = bodies.f;
    if (cloth.air > 0) add_wind(cloth, force);
    if (settings.method == ClothMethod::explicit_euler)
        add_row_forces(cloth, bodies.x, force);
    for (Index k = 0; k < bodies.count(); ++k) {
        const Real w = bodies.inverse_mass[3 * k];
        if (!(w > 0)) continue;
        // drag takes of what it had, not of the forces: it moves no place of rest
        bodies.velocity(k) /= 1 + way * cloth.drag;
        bodies.velocity(k) += way * (cloth.gravity + w * force.segment<3>(3 * k));
    }
    y = x0 + way * bodies.u;
    bodies.x = x0 + h * bodies.u;
}
//! [begin]

void ClothMemory::begin_sweeps(const ClothScene& cloth,
                               const ClothSettings& settings)
{
    rows.positions_alone = settings.method == ClothMethod::pbd;
    rows.share = settings.pbd_share;
    rows.keep_lambda = settings.keep_lambda;
    rows.begin(cloth);
    if (settings.method == ClothMethod::threads) threads.begin();
    visits += settings.sweeps *
              static_cast<std::int64_t>(cloth.springs.size() + cloth.bends.size() +
                                        cloth.hinges.size());
}

void ClothMemory::sweep(const ClothScene& cloth, const ClothSettings& settings,
                        VecX& x)
{
    const bool by_threads = settings.method == ClothMethod::threads;
    if (by_threads && !settings.keep_lambda) threads.begin();
    if (by_threads) threads.sweep(cloth, settings.part(), x);
    rows.sweep(cloth, settings.part(), x, !by_threads);
}

//! [solve]
/// From y to x: the rows that the method solves together, and how far.
void ClothMemory::solve(const ClothScene& cloth, const ClothSettings& settings,
                        VecX& x)
{
    const Real h = settings.part();
    const auto count = static_cast<std::int64_t>(
        cloth.springs.size() + cloth.bends.size() + cloth.hinges.size());
    switch (settings.method) {
    case ClothMethod::explicit_euler:
        visits += count;  // its forces are in y
        break;
    case ClothMethod::pbd:
    case ClothMethod::xpbd:
    case ClothMethod::threads:
        break;  // sweep()
    case ClothMethod::particles:
    case ClothMethod::augmented: {
        const bool grows = settings.method == ClothMethod::augmented;
        particles.begin(cloth, h, grows);
        for (int s = 0; s < settings.sweeps; ++s) {
            particles.sweep(cloth, y, h, x);
            if (grows) particles.grow(cloth, h, x);
        }
        visits += (grows ? 3 : 2) * count * settings.sweeps;
        break;
    }
    case ClothMethod::projective:
        for (int s = 0; s < settings.sweeps; ++s) projective.pass(cloth, y, h, x);
        visits += count * settings.sweeps, solves += settings.sweeps;
        break;
    case ClothMethod::implicit_euler:
        newton.linear(cloth, x0, y, h, x);
        visits += count * (newton.cg_steps + 2), solves += 1;
        solved = solved && newton.solved;
        break;
    case ClothMethod::newton:
    case ClothMethod::midpoint:
        x = y;
        ClothNewton::begin(cloth, x0,
                           settings.method == ClothMethod::midpoint ? h / 2 : h, x);
        newton.minimise(cloth, y,
                        settings.method == ClothMethod::midpoint ? h / 2 : h, x);
        visits += count * (newton.steps + 1), solves += newton.steps;
        solved = solved && newton.solved;
        break;
    case ClothMethod::exact:
        exact.solve(cloth, y, h, x);
        visits += count * (exact.steps + 1), solves += exact.steps;
        solved = solved && exact.solved;
    }
}
//! [solve]

//! [end]
void ClothMemory::end(ClothScene& cloth, const ClothSettings& settings) const
{
    Bodies<3>& bodies = cloth.bodies;
    const Real h = settings.part();
    const bool middle = settings.method == ClothMethod::midpoint;
    for (Index k = 0; k < bodies.count(); ++k) {
        auto u = bodies.velocity(k);
        const Vec3 back = drawn_back.segment<3>(3 * k);
        const bool moves = bodies.inverse_mass[3 * k] > 0;
        if (moves) u = (bodies.position(k) - back - x0.segment<3>(3 * k)) / h;
        if (middle) u += u - u0.segment<3>(3 * k);  // u ← 2 u − u₀, (27.15)
        // what the limit draws back it does once a step, not once a sub-step
        if (moves) u += back / settings.h;
    }
}
//! [end]

void step(ClothScene& cloth, const ClothSettings& settings, ClothMemory& memory)
{
    NothingTouched touch;
    step(cloth, settings, memory, touch);
}

}  // namespace rigid
