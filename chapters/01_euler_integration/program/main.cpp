// Chapter 1. Euler integration: springs, a throw, a planet and a pendulum under six
// methods.
#include "chapters/01_euler_integration/event.hpp"
#include "chapters/01_euler_integration/exact.hpp"
#include "common/elementary.hpp"
#include "common/program/program.hpp"
#include "common/text.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

namespace rigid {
namespace {

enum class Method {
    explicit_euler,
    symplectic_euler,
    implicit_euler,
    verlet,
    yoshida4,
    rk4,
    dormand_prince
};

constexpr std::array<const char*, 7> method_names = {
    "explicit_euler", "symplectic_euler", "implicit_euler",
    "verlet",         "yoshida4",         "rk4",
    "dormand_prince"};

Method method_of(const std::string& name)
{
    const auto found = std::find(method_names.begin(), method_names.end(), name);
    return static_cast<Method>(found - method_names.begin());
}

/// One body with one force, moved by one of the methods. Nobody else in this program
/// integrates.
template <int N, class A>
struct Mover {
    Counted<A> a;
    Method method;
    State<N> s;
    Tolerance tolerance{};
    Real t = 0;
    Vec<N> now{};       // a(s), carried along by verlet and yoshida4
    Adaptive<N> run{};  // dormand_prince: may be ahead of t by a part of its step
    std::function<Real(const State<N>&)> gap = [](const State<N>&) {
        return Real(1);
    };
    Outcome outcome = Outcome::reached;
    std::vector<State<N>> stops{};  // where a step of dormand_prince ended

    void start()
    {
        require_finite(s);
        now = acceleration(a, s);
        a.evaluations = 0;  // the first evaluation belongs to no step
        if (method == Method::dormand_prince) run = start_adaptive(s, a, tolerance);
        stops = {s};
    }

    //! [step]
    void step(Real h)
    {
        switch (method) {
        case Method::explicit_euler: s = explicit_euler(s, h, a); break;
        case Method::symplectic_euler: s = symplectic_euler(s, h, a); break;
        case Method::implicit_euler:
            if constexpr (std::same_as<A, Spring>)
                s = implicit_euler_spring(s, h, a.a.omega);
            break;
        case Method::verlet:
            if constexpr (PositionAcceleration<A, N>)
                s = velocity_verlet(s, now, h, a);
            break;
        case Method::yoshida4:
            if constexpr (PositionAcceleration<A, N>) s = yoshida4(s, h, a);
            break;
        case Method::rk4: s = rk4(s, h, a); break;
        // steps of its own size; the picture is taken in between
        case Method::dormand_prince:
            while (run.t < t + h && outcome == Outcome::reached) {
                outcome = advance_to_event(run, 1e9, a, tolerance, gap);
                stops.push_back(run.s);
            }
            if (outcome != Outcome::reached && outcome != Outcome::event)
                throw StepFailure(
                    "the adaptive step at t = " + significant(run.t, 6) +
                    " s: " + to_string(outcome));
            s = run.t <= t + h ? run.s
                               : run.last.at(1 - (run.t - t - h) / run.last.h);
            break;
        }
        t += h;
    }
    //! [step]

    void require_finite_now() const
    {
        if (!s.x.allFinite() || !s.u.allFinite())
            throw StepFailure(std::string("the body moved by ") +
                              method_names[static_cast<std::size_t>(method)] +
                              " has left all numbers; a smaller time step helps");
    }
    Real step_size(Real h) const
    {
        return method == Method::dormand_prince ? run.last.h : h;
    }
};

Tolerance tolerance_of(const Settings& settings)
{
    const Real allowed = pow(10, -settings["digits"]);
    return {allowed, allowed, allowed};
}

const Style dashed{Colour::ink, 1.2, 0.8, Paint::dashed};

void remember(std::vector<Vec2>& trail, const Vec2& p, std::size_t most = 20000)
{
    if (trail.size() < most) trail.push_back(p);
}

// ---- springs
// --------------------------------------------------------------------------------------

/// Three equal masses on three equal springs under three Euler methods; below each its
/// phase plane.
class Springs : public Run {
public:
    explicit Springs(const Settings& settings)
        : spring_{2 * pi * settings["frequency"]},
          start_{Vec<1>(settings["amplitude"]), Vec<1>(0)}
    {
        for (Method method : {Method::explicit_euler, Method::symplectic_euler,
                              Method::implicit_euler}) {
            movers_.push_back({{spring_}, method, start_});
            movers_.back().start();
        }
        for (std::size_t i = 0; i < movers_.size(); ++i)
            remember(trails_[i], phase(movers_[i].s));
    }

    void step(const Settings& settings, const Input&) override
    {
        for (std::size_t i = 0; i < movers_.size(); ++i) {
            movers_[i].step(settings.h);
            movers_[i].require_finite_now();
            remember(trails_[i], phase(movers_[i].s));
        }
        t_ += settings.h;
        z_ = settings.h * spring_.omega;
    }

    std::vector<Real> measure() const override
    {
        const auto ratio = [&](std::size_t i) {
            return spring_.energy(movers_[i].s) / spring_.energy(start_);
        };
        return {movers_[0].s.x[0], movers_[1].s.x[0],
                movers_[2].s.x[0], exact_spring(spring_, start_, t_).x[0],
                ratio(0),          ratio(1),
                ratio(2)};
    }

    void draw(Canvas& canvas) const override
    {
        const std::array<const char*, 3> names = {
            "explicit Euler", "symplectic Euler", "implicit Euler"};
        const std::array<Colour, 3> colours = {Colour::orange, Colour::blue,
                                               Colour::green};
        const State<1> exact = exact_spring(spring_, start_, t_);
        for (std::size_t i = 0; i < movers_.size(); ++i) {
            const State<1>& s = movers_[i].s;
            const Real across = 1.2 * (static_cast<Real>(i) - 1), ceiling = 1.25,
                       rest = 0.5;
            const Vec2 mass(across, rest + s.x[0]);
            // The ceiling, the spring as a zigzag, the mass, and where it should be.
            canvas.segment({across - 0.3, ceiling}, {across + 0.3, ceiling},
                           {Colour::ink, 3});
            std::vector<Vec2> zigzag{{across, ceiling}};
            constexpr int turns = 12;
            for (int k = 0; k <= turns; ++k) {
                const Real part = (0.5 + k) / (turns + 1);
                const Real side = k % 2 ? 0.07 : -0.07;
                zigzag.emplace_back(across + side,
                                    ceiling + part * (mass.y() - ceiling));
            }
            zigzag.push_back(mass);
            canvas.polyline(zigzag, {Colour::ink, 1.3});
            canvas.box(mass, {0.1, 0.075}, 0,
                       {colours[i], 1.5, 0.7, Paint::filled});
            canvas.box({across, rest + exact.x[0]}, {0.1, 0.075}, 0, dashed);
            // The phase plane: position upwards, velocity / ω to the right.
            const Vec2 centre(across, -0.72);
            canvas.segment(centre - Vec2(0.52, 0), centre + Vec2(0.52, 0),
                           {Colour::faint, 1});
            canvas.segment(centre - Vec2(0, 0.52), centre + Vec2(0, 0.52),
                           {Colour::faint, 1});
            canvas.text(centre + Vec2(0.03, 0.49), "x", 12, {Colour::ink});
            canvas.text(centre + Vec2(0.52, 0.03), "u/ω", 12, {Colour::ink},
                        Align::right);
            canvas.disc(centre, start_.x.norm(), dashed);
            // What explodes leaves its own picture, not through the others.
            constexpr Real edge = 0.56;
            std::vector<Vec2> trail;
            for (const Vec2& p : trails_[i])
                if (p.norm() <= edge) trail.push_back(centre + p);
            canvas.polyline(trail, {colours[i], 1.3});
            if (phase(s).norm() <= edge)
                canvas.disc(centre + phase(s), 0.025,
                            {colours[i], 1, 1, Paint::filled});
            const Real ratio = spring_.energy(s) / spring_.energy(start_);
            canvas.text({across, 1.36}, names[i], 15, {colours[i]}, Align::centre);
            canvas.text({across, -1.38}, "energy × " + significant(ratio, 3), 14,
                        {colours[i]}, Align::centre);
        }
        canvas.text({-1.75, -1.55},
                    "t = " + fixed(t_, 2) + " s,  hω = " + significant(z_, 3) +
                        ";  dashed: exact",
                    13, {Colour::ink});
    }

private:
    Vec2 phase(const State<1>& s) const { return {s.u[0] / spring_.omega, s.x[0]}; }

    Spring spring_;
    State<1> start_;
    std::vector<Mover<1, Spring>> movers_;
    std::array<std::vector<Vec2>, 3> trails_;
    Real t_ = 0, z_ = 0;
};

// ---- projectile
// -----------------------------------------------------------------------------------

/// A javelin's centre of mass, thrown from shoulder height; the run ends on the ground.
class Throw : public Run {
public:
    explicit Throw(const Settings& settings)
        : mover_{{{settings["drag"]}}, method_of(settings.method), {}}
    {
        const Real angle = settings["angle"] * pi / 180;
        start_ = {Vec2(0, 1.8), settings["speed"] * Vec2(cos(angle), sin(angle))};
        mover_.s = start_;
        mover_.tolerance = tolerance_of(settings);
        mover_.gap = [](const State<2>& s) { return s.x.y(); };
        mover_.start();
        trail_ = {start_.x};
        // The truth: the same flight to the last digits.
        const Tolerance tight{1e-13, 1e-13, 1e-13};
        exact_ = start_adaptive(start_, mover_.a.a, tight);
        const Outcome outcome =
            integrate_to_event(exact_, 1000, mover_.a.a, tight, mover_.gap);
        if (outcome != Outcome::event)
            throw StepFailure(std::string("the exact flight: ") +
                              to_string(outcome));
    }

    void step(const Settings& settings, const Input&) override
    {
        h_ = settings.h;
        if (landed()) return;
        mover_.step(settings.h);
        mover_.require_finite_now();
        remember(trail_, mover_.s.x);
    }

    std::vector<Real> measure() const override
    {
        const State<2>& s = mover_.s;
        return {s.x.x(),
                s.x.y(),
                s.u.norm(),
                mover_.a.a.energy(s),
                mover_.step_size(h_),
                landed() ? 1. : 0.,
                landed() ? std::abs(time() - exact_.t) : 0.,
                static_cast<Real>(mover_.a.evaluations)};
    }

    void draw(Canvas& canvas) const override
    {
        const State<2>& s = mover_.s;
        canvas.segment({-5, 0}, {112, 0}, {Colour::ink, 2});
        for (int metres = 0; metres <= 100; metres += 20) {
            canvas.segment({static_cast<Real>(metres), 0},
                           {static_cast<Real>(metres), -1}, {Colour::ink, 1});
            canvas.text({static_cast<Real>(metres), -4},
                        std::to_string(metres) + (metres == 100 ? " m" : ""), 12,
                        {Colour::ink}, Align::centre);
        }
        // Without air: a parabola.
        std::vector<Vec2> parabola;
        const Real g = -mover_.a.a.gravity.y();
        const Real end = exact_impact({0}, start_.x.y(), start_.u.y());
        for (int i = 0; i <= 60; ++i) {
            const Real t = end * i / 60;
            parabola.push_back(start_.x + t * start_.u - Vec2(0, g / 2 * t * t));
        }
        canvas.polyline(parabola, dashed);
        canvas.polyline(trail_, {Colour::blue, 2});
        const std::vector<State<2>>& stops = mover_.stops;
        for (std::size_t i = 0; i < stops.size(); ++i)
            canvas.disc(stops[i].x, 0.6, {Colour::orange, 1.2, 0.6, Paint::filled});
        canvas.disc({exact_.s.x.x(), 0}, 0.8, {Colour::green, 2});
        // The shaft, its velocity, and the drag on it (drawn 20 times too long).
        if (!landed()) {
            const Vec2 along = s.u.normalized();
            canvas.segment(s.x - 1.3 * along, s.x + 1.3 * along, {Colour::ink, 4});
            canvas.arrow(s.x, s.x + 0.35 * s.u, {Colour::blue, 2});
            const Vec2 drag = -mover_.a.a.drag * s.u.norm() * s.u;
            if (drag.norm() > 0)
                canvas.arrow(s.x, s.x + 20 * drag, {Colour::red, 2});
        }
        canvas.text({-4, 30.5},
                    "dashed: without air; green ring: exact landing; orange dots: "
                    "adaptive steps",
                    12, {Colour::ink});
        canvas.text({-4, 28}, "arrows: velocity (blue), drag × 20 (red)", 12,
                    {Colour::ink});
        if (landed())
            canvas.text({-4, 25.5},
                        "lands after " + fixed(time(), 9) + " s (exact " +
                            fixed(exact_.t, 9) + " s) at " + fixed(s.x.x(), 3) +
                            " m; " + std::to_string(mover_.a.evaluations) +
                            " evaluations",
                        12, {Colour::ink});
    }

private:
    bool landed() const
    {
        return mover_.outcome == Outcome::event ? mover_.t >= mover_.run.t
                                                : mover_.s.x.y() <= 0;
    }
    /// When it met the ground: with a fixed step only the end of the step that went below is known
    /// it.
    Real time() const
    {
        return mover_.outcome == Outcome::event ? mover_.run.t : mover_.t;
    }

    Mover<2, Projectile> mover_;
    State<2> start_;
    Adaptive<2> exact_;
    std::vector<Vec2> trail_;
    Real h_ = 0;
};

// ---- a planet
// -------------------------------------------------------------------------------------

class Planet : public Run {
public:
    explicit Planet(const Settings& settings)
        : mover_{{},
                 method_of(settings.method),
                 kepler_perihelion({}, settings["eccentricity"])},
          e_(settings["eccentricity"]), start_(mover_.s), h_(settings.h)
    {
        mover_.tolerance = tolerance_of(settings);
        mover_.start();
        trail_ = {start_.x};
    }

    void step(const Settings& settings, const Input&) override
    {
        h_ = settings.h;
        mover_.step(settings.h);
        mover_.require_finite_now();
        remember(trail_, mover_.s.x);
    }

    std::vector<Real> measure() const override
    {
        const Kepler& kepler = mover_.a.a;
        const State<2>& s = mover_.s;
        return {
            s.x.x(),
            s.x.y(),
            std::abs(kepler.energy(s) / kepler.energy(start_) - 1),
            std::abs(kepler.angular_momentum(s) / kepler.angular_momentum(start_) -
                     1),
            (s.x - exact_kepler(kepler, e_, mover_.t).x).norm(),
            mover_.step_size(h_),
            static_cast<Real>(mover_.a.evaluations)};
    }

    void draw(Canvas& canvas) const override
    {
        const State<2>& s = mover_.s;
        const Real minor = std::sqrt(1 - e_ * e_);
        std::vector<Vec2> ellipse;
        for (int i = 0; i <= 120; ++i) {
            const Real E = 2 * pi * i / 120;
            ellipse.emplace_back(cos(E) - e_, minor * sin(E));
        }
        canvas.polyline(ellipse, dashed);
        canvas.polyline(trail_, {Colour::blue, 1.2, 0.8});
        canvas.disc({0, 0}, 0.07, {Colour::yellow, 1.5, 0.9, Paint::filled});
        canvas.disc(exact_kepler(mover_.a.a, e_, mover_.t).x, 0.045,
                    {Colour::ink, 1.5});
        canvas.disc(s.x, 0.04, {Colour::blue, 1, 1, Paint::filled});
        canvas.arrow(s.x, s.x + 0.35 * s.u, {Colour::blue, 1.8});
        canvas.arrow(s.x, s.x + 0.2 * mover_.a.a(s.x), {Colour::red, 1.8});
        const std::vector<Real> m = measure();
        canvas.text(
            {-2.25, 1.28},
            "arrows: velocity (blue), force (red); ring: where it should be", 12,
            {Colour::ink});
        canvas.text({-2.25, -1.23},
                    fixed(mover_.t / (2 * pi), 2) + " periods, " +
                        significant(m[6], 6) + " evaluations",
                    12, {Colour::ink});
        canvas.text({-2.25, -1.35},
                    "energy off by " + significant(m[2], 2) + ", place by " +
                        significant(m[4], 2) + " m",
                    12, {Colour::ink});
    }

private:
    Mover<2, Kepler> mover_;
    Real e_;
    State<2> start_;
    Real h_;
    std::vector<Vec2> trail_;
};

// ---- a pendulum
// -----------------------------------------------------------------------------------

class Swing : public Run {
public:
    explicit Swing(const Settings& settings)
        : mover_{{{9.81, settings["length"]}}, method_of(settings.method), {}},
          theta0_(settings["angle"] * pi / 180), h_(settings.h)
    {
        mover_.s = {Vec<1>(theta0_), Vec<1>(0)};
        mover_.tolerance = tolerance_of(settings);
        mover_.start();
        energy_ = mover_.a.a.energy(mover_.s);
        remember(trail_, phase(mover_.s));
    }

    void step(const Settings& settings, const Input&) override
    {
        h_ = settings.h;
        mover_.step(settings.h);
        mover_.require_finite_now();
        remember(trail_, phase(mover_.s));
    }

    std::vector<Real> measure() const override
    {
        const Pendulum& pendulum = mover_.a.a;
        const Real exact = exact_pendulum(pendulum, theta0_, mover_.t).x[0];
        return {mover_.s.x[0],
                mover_.s.u[0],
                pendulum.energy(mover_.s) - energy_,
                std::abs(std::remainder(mover_.s.x[0] - exact, 2 * pi)),
                mover_.step_size(h_),
                static_cast<Real>(mover_.a.evaluations)};
    }

    void draw(Canvas& canvas) const override
    {
        const Real length = mover_.a.a.length;
        const Vec2 pivot(-0.9, 0.25);
        const auto bob = [&](Real angle) {
            return Vec2(pivot + length * Vec2(sin(angle), -cos(angle)));
        };
        std::vector<Vec2> arc;
        for (int i = -60; i <= 60; ++i) arc.push_back(bob(theta0_ * i / 60));
        canvas.polyline(arc, {Colour::faint, 1});
        const Vec2 exact = bob(exact_pendulum(mover_.a.a, theta0_, mover_.t).x[0]);
        canvas.segment(pivot, exact, dashed);
        canvas.disc(exact, 0.09, dashed);
        const Vec2 place = bob(mover_.s.x[0]);
        canvas.segment(pivot, place, {Colour::ink, 3});
        canvas.disc(place, 0.08, {Colour::blue, 1.5, 0.9, Paint::filled});
        canvas.disc(pivot, 0.03, {Colour::ink, 1, 1, Paint::filled});
        // The phase plane: angle to the right, angular velocity upwards, both in units of
        // their largest value.
        const Vec2 centre(1.15, 0.25);
        canvas.segment(centre - Vec2(0.85, 0), centre + Vec2(0.85, 0),
                       {Colour::faint, 1});
        canvas.segment(centre - Vec2(0, 0.85), centre + Vec2(0, 0.85),
                       {Colour::faint, 1});
        canvas.text(centre + Vec2(0.86, 0.04), "angle", 12, {Colour::ink},
                    Align::right);
        canvas.text(centre + Vec2(0.04, 0.8), "angular velocity", 12,
                    {Colour::ink});
        std::vector<Vec2> orbit, trail;
        const Real period = pendulum_period(mover_.a.a, theta0_);
        for (int i = 0; i <= 120; ++i)
            orbit.push_back(centre + phase(exact_pendulum(mover_.a.a, theta0_,
                                                          period * i / 120)));
        for (const Vec2& p : trail_) trail.push_back(centre + p);
        canvas.polyline(trail, {Colour::blue, 1.2, 0.8});
        canvas.polyline(orbit, dashed);
        canvas.disc(centre + phase(mover_.s), 0.03,
                    {Colour::blue, 1, 1, Paint::filled});
        const std::vector<Real> m = measure();
        canvas.text({-2, -1.0},
                    "t = " + fixed(mover_.t, 2) + " s, period " + fixed(period, 6) +
                        " s; dashed: exact",
                    12, {Colour::ink});
        canvas.text({-2, -1.12},
                    "energy off by " + significant(m[2], 2) + " J/kg, angle by " +
                        significant(m[3], 2) + " rad",
                    12, {Colour::ink});
    }

private:
    Vec2 phase(const State<1>& s) const
    {
        const Real fastest =
            2 * std::sqrt(mover_.a.a.g / mover_.a.a.length) * sin(theta0_ / 2);
        return {0.7 * s.x[0] / theta0_, 0.7 * s.u[0] / fastest};
    }

    Mover<1, Pendulum> mover_;
    Real theta0_, h_, energy_ = 0;
    std::vector<Vec2> trail_;
};

template <class Scenery>
std::unique_ptr<Run> start(const Settings& settings)
{
    return std::make_unique<Scenery>(settings);
}

Tunable digits_of_steps(Real value)
{
    return {"digits",
            "",
            "a step of dormand_prince may be off by 10^-digits, relative and in m "
            "and m/s",
            value,
            2,
            12,
            Numbers::whole,
            OnChange::restarts};
}

Program program()
{
    Demo springs;
    springs.name = "springs";
    springs.summary =
        "Three equal springs under explicit, symplectic and implicit Euler";
    springs.view = {{0, -0.1}, {1.85, 1.6}};
    springs.methods = {"three_eulers"};
    springs.tunables = {{"frequency", "Hz", "oscillations per second", 1, 0.1, 5,
                         Numbers::real, OnChange::restarts},
                        {"amplitude", "m", "how far up the masses start", 0.15,
                         0.01, 0.5, Numbers::real, OnChange::restarts}};
    springs.columns = {
        {"x_explicit", "m", "place under explicit Euler"},
        {"x_symplectic", "m", "place under symplectic Euler"},
        {"x_implicit", "m", "place under implicit Euler"},
        {"x_exact", "m", "where it should be"},
        {"energy_explicit", "", "energy / energy at the start, explicit Euler",
         Plot::logarithmic},
        {"energy_symplectic", "", "energy / energy at the start, symplectic Euler",
         Plot::linear},
        {"energy_implicit", "", "energy / energy at the start, implicit Euler",
         Plot::logarithmic}};
    springs.start = start<Springs>;

    Demo javelin;
    javelin.name = "projectile";
    javelin.summary =
        "A javelin's centre of mass with quadratic drag, until it meets the ground";
    javelin.view = {{53, 13.5}, {59, 19.5}};
    javelin.methods = {"dormand_prince", "rk4", "symplectic_euler",
                       "explicit_euler"};
    javelin.tunables = {{"speed", "m/s", "of the throw", 30, 1, 32, Numbers::real,
                         OnChange::restarts},
                        {"angle", "°", "of the throw, above the horizontal", 40, 0,
                         90, Numbers::real, OnChange::restarts},
                        {"drag", "1/m", "k in a = -k |u| u", 0.001, 0, 0.1,
                         Numbers::real, OnChange::restarts},
                        digits_of_steps(9)};
    javelin.columns = {
        {"x", "m", "distance"},
        {"y", "m", "height", Plot::linear},
        {"speed", "m/s", "length of the velocity", Plot::linear},
        {"energy", "J/kg", "kinetic and potential, for one kilogram", Plot::linear},
        {"step_size", "s", "of the last step that the method took"},
        {"landed", "", "1 once it is on the ground"},
        {"impact_error", "s", "time of impact against the exact one, once landed"},
        {"evaluations", "", "how often the force was evaluated"}};
    javelin.start = start<Throw>;

    Demo kepler;
    kepler.name = "kepler";
    kepler.summary =
        "A planet around its sun: GM = 1, semi-major axis 1, from the point "
        "nearest to the sun";
    kepler.view = {{-0.75, 0}, {1.6, 1.42}};
    kepler.h = 0.05;
    kepler.methods = {
        "symplectic_euler", "explicit_euler", "verlet", "yoshida4", "rk4",
        "dormand_prince"};
    kepler.side_by_side = {"explicit_euler", "symplectic_euler", "rk4"};
    kepler.tunables = {{"eccentricity", "", "0 = a circle", 0.6, 0, 0.95,
                        Numbers::real, OnChange::restarts},
                       digits_of_steps(6)};
    kepler.columns = {
        {"x", "m", "place"},
        {"y", "m", "place"},
        {"energy_error", "", "relative error of the energy", Plot::logarithmic},
        {"momentum_error", "", "relative error of the angular momentum"},
        {"position_error", "m", "distance from where it should be",
         Plot::logarithmic},
        {"step_size", "s", "of the last step that the method took", Plot::linear},
        {"evaluations", "", "how often the force was evaluated"}};
    kepler.start = start<Planet>;

    Demo pendulum;
    pendulum.name = "pendulum";
    pendulum.summary = "A pendulum let go at rest";
    pendulum.view = {{0, 0.05}, {2.1, 1.3}};
    pendulum.methods = {"verlet", "explicit_euler", "symplectic_euler", "yoshida4",
                        "rk4",    "dormand_prince"};
    pendulum.side_by_side = {"explicit_euler", "symplectic_euler"};
    pendulum.tunables = {{"angle", "°", "where it is let go, from straight down",
                          120, 1, 179, Numbers::real, OnChange::restarts},
                         {"length", "m", "of the pendulum", 1, 0.1, 1,
                          Numbers::real, OnChange::restarts},
                         digits_of_steps(6)};
    pendulum.columns = {
        {"angle", "rad", "from straight down", Plot::linear},
        {"rate", "rad/s", "angular velocity"},
        {"energy_error", "J/kg", "energy less energy at the start", Plot::linear},
        {"angle_error", "rad", "against the exact angle", Plot::logarithmic},
        {"step_size", "s", "of the last step that the method took"},
        {"evaluations", "", "how often the force was evaluated"}};
    pendulum.start = start<Swing>;

    return {"01_euler_integration",
            "Chapter 1. Euler integration",
            {springs, javelin, kepler, pendulum},
            {},
            {}};
}

}  // namespace
}  // namespace rigid

int main(int argc, char** argv)
{
    return rigid::run_program(rigid::program, argc, argv);
}
