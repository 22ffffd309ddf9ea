#include "chapters/25_world_in_space/space_method.hpp"
#include "tests/stress/space.hpp"
#include "tests/stress/stepping.hpp"

namespace rigid::stress {

namespace {

/// Whether the two rows of a contact's friction are held in a disc together, or each in its own bounds.
enum class Friction : bool { box, disc };

/// Holds an answer that calls itself solved against Coulomb's law, by the formulas and not by the solver: (24.3) with
/// ρ = 1/L of each disc, and the natural residual of the other rows. One step of sixteen.
template <Friction friction>
struct HonestSpace {
    long steps = 0;

    template <class Solving>
    void operator()(const Solving&, const StepData<6>& now)
    {
        if (now.solution.status != Status::solved || steps++ % 16 != 0) return;
        VecX u = now.u_star;
        Real fastest = now.length;  // of one length of the scene a second, or of what the rows have to stop
        for (const Row<6>& row : now.rows) fastest = std::max(fastest, std::abs(row.velocity(u)));
        for (std::size_t k = 0; k < now.rows.size(); ++k) now.rows[k].apply(lambda(now, k), u);
        // 1e-6 of the numbers in the problem, as in the other matrices: a thousand times what the solvers are asked for
        const Real off = error(now, u);
        if (!(off <= 1e-6 * fastest))
            throw SilentError("an answer with the residual " + shortest(off) + " m/s is called solved");
    }

private:
    static Real lambda(const StepData<6>& now, std::size_t k)
    {
        return now.solution.lambda[static_cast<Index>(k)];
    }
    static Real mobility(const Row<6>& r, const Row<6>& s)
    {
        return (r.a == world ? 0 : r.Ja.dot(s.Wa)) + r.Jb.dot(s.Wb);
    }

    static Real error(const StepData<6>& now, const VecX& u)
    {
        Real worst = 0;
        const auto look = [&worst](Real off) {
            if (!(off <= worst)) worst = off;  // also takes over a NaN
        };
        for (std::size_t k = 0; k < now.rows.size(); ++k) {
            const Row<6>& row = now.rows[k];
            const Real a = mobility(row, row), own = lambda(now, k), w = row.velocity(u);
            if (!(a > 0)) continue;
            const bool bounded = row.bounded_by >= 0;
            const Real r = bounded ? row.friction * lambda(now, static_cast<std::size_t>(row.bounded_by)) : 0;
            const int part = now.sources[k].part;
            if (friction == Friction::disc && bounded && (part == first_tangent || part == first_roll)) {
                const Row<6>& next = now.rows[++k];
                const Real b = mobility(next, next), c = mobility(row, next);
                const Real L = (a + b) / 2 + std::hypot((a - b) / 2, c);
                const Vec2 both(own, lambda(now, k)), z = both - Vec2(w, next.velocity(u)) / L;
                look(L * (both - (z.norm() > r ? Vec2(z * (r / z.norm())) : z)).norm());
            } else {
                const Real lo = bounded ? -r : row.lo, hi = bounded ? r : row.hi;
                look(lo <= hi ? a * std::abs(own - std::clamp(own - w / a, lo, hi)) : infinity);
            }
        }
        return worst;
    }
};

template <Friction friction = Friction::disc, class Solving>
SpaceMethod in_space(const std::string& name, const std::string& budget, const Solving& by, int substeps = 1)
{
    auto method = stepping<SpaceScene>(25, name, budget, by, substeps, HonestSpace<friction>{});
    method.friction = requires { by.contacts.slack; };
    method.links_only = !method.friction;
    return method;
}

/// A free body alone: how a spin is carried from step to step (sections 20.5 and 20.C).
SpaceMethod tumbling(const std::string& name, const std::string& budget, Tumbling way)
{
    SpaceMethod method;
    method.chapter = 25;
    method.name = name;
    method.budget = budget;
    method.links_only = true;
    method.most_rows = 0;
    method.start = [way](const std::shared_ptr<const Wish>&) {
        return checked<SpaceScene>([way](SpaceScene& scene, Real h) {
            require_valid(StepSettings{.h = h}, scene.gravity, scene.bodies.count());
            require_bodies(scene);
            (void)typical_length(scene);  // refuses one that is none
            for (Index k = 0; k < scene.bodies.count(); ++k) {
                auto u = scene.bodies.velocity(k);
                if (!(scene.bodies.inverse_mass.segment<6>(6 * k).minCoeff() > 0)) continue;
                u.head<3>() += h * scene.gravity;
                scene.bodies.position(k).head<3>() += h * u.head<3>();
                const Vec3 inertia = scene.bodies.inverse_mass.segment<3>(6 * k + 3).cwiseInverse();
                Vec3 theta = scene.bodies.x.segment<3>(6 * k + 3), omega = u.tail<3>();
                tumble(way, inertia, h, theta, omega);
                scene.bodies.x.segment<3>(6 * k + 3) = theta;
                u.tail<3>() = omega;
            }
        });
    };
    return method;
}

Spending baumgarte() { return {Stabilizer::baumgarte, 10, 0, 1, infinity, 0.2}; }

/// With errors corrected apart and whole, as chapter 9 has it.
Spending split(int substeps) { return {Stabilizer::split_impulse, 1, 1, substeps, infinity, 1}; }

SpaceMethod joints_swept(const std::string& name, const Spending& spending)
{
    SpaceSweeps by;
    by.correction = correction_of(spending);
    by.solver.sweeps.max_sweeps = spending.sweeps;
    return in_space(name, budget(spending), by, spending.substeps);
}

std::string exactly(int substeps)
{
    return "exact, " + std::to_string(substeps) + (substeps > 1 ? " substeps" : " step");
}

SpaceMethod joints_exact(const std::string& name, const Spending& spending)
{
    SpaceExact by;
    by.correction = correction_of(spending);
    SpaceMethod method = in_space(name, exactly(spending.substeps), by, spending.substeps);
    method.most_rows = 500;  // a matrix of all rows: beyond this a step takes a second
    return method;
}

/// The chapter's own way to keep contacts closed, swept so many times.
template <Friction friction, class Solving>
SpaceMethod swept(const std::string& name, int sweeps, int substeps)
{
    Solving by;
    by.solver.sweeps = {sweeps, 1e-9};
    return in_space<friction>(name, budget({Stabilizer::split_impulse, sweeps, 0, substeps}), by, substeps);
}

SpaceMethod cones_with_bias()
{
    TouchingCones by;
    by.correction = correction_of(baumgarte());
    by.solver.sweeps = {10, 1e-9};
    return in_space("cones baumgarte", budget(baumgarte()), by);
}

SpaceMethod cones_exact(const std::string& name, int substeps)
{
    SpaceMethod method = in_space(name, exactly(substeps), exact_cones(), substeps);
    method.most_rows = 720;  // in each step of a heap in motion the directions of sliding are found again
    return method;
}

}  // namespace

std::vector<SpaceMethod> space_methods()
{
    SpaceIslands islands;
    islands.solver.sweeps = {50, 1e-9};
    return {tumbling("tumble explicit", "a free body, (20.19)", Tumbling::explicit_term),
            tumbling("tumble implicit", "a free body, (20.20)", Tumbling::implicit_term),
            tumbling("tumble kept", "a free body, explicit with L put right", Tumbling::momentum_kept),
            joints_swept("joints swept", baumgarte()),
            joints_swept("joints small steps", split(8)),
            in_space("joints islands", "50 sweeps", islands),
            joints_exact("joints exact", baumgarte()),
            joints_exact("joints exact split", split(1)),
            joints_exact("joints exact substeps", split(8)),
            swept<Friction::box, TouchingBoxes>("boxes", 10, 1),
            cones_with_bias(),
            swept<Friction::disc, TouchingCones>("cones", 10, 1),
            swept<Friction::disc, TouchingCones>("cones 50", 50, 1),
            swept<Friction::disc, TouchingCones>("cones small steps", 1, 8),
            cones_exact("cones exact", 1),
            cones_exact("cones exact substeps", 8)};
}

}  // namespace rigid::stress
