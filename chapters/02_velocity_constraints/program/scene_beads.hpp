/// \file scene_beads.hpp
/// Beads on wires, and the pendulum: one body and one row.
#pragma once

#include "chapters/01_euler_integration/exact.hpp"
#include "chapters/02_velocity_constraints/curves.hpp"
#include "chapters/02_velocity_constraints/geometry.hpp"
#include "chapters/02_velocity_constraints/program/drawing.hpp"
#include "common/elementary.hpp"
#include "common/forces.hpp"
#include "common/measure.hpp"
#include "common/program/program.hpp"

#include <array>
#include <functional>
#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

namespace rigid {

/// A wire that a bead can run along.
struct Wire {
    std::function<Constraint<2>(const VecX& x)> constraint;  ///< of body 0
    std::vector<Vec2> shape;                                 ///< for the picture
    Vec2 start = {1, 0};                                     ///< a point of it
    /// from it, where there is a formula [m]
    std::function<Real(const Vec2& p)> distance = {};
    Vec2 half_size = {2, 1.9};  ///< of the picture [m]
};

//! [stiff_spring]
/// (2.1): what a stiff spring would do in place of a row: a force that grows with
/// the distance from the wire, -k C along J.
inline void add_stiff_spring(Bodies<2>& bodies, const Constraint<2>& constraint,
                             Real stiffness)
{
    bodies.force(constraint.b) -=
        stiffness * constraint.C * constraint.Jb.transpose();
}
//! [stiff_spring]

/// A bead on a wire, held by a row or, for comparison, by a stiff spring.
class BeadRun : public Run {
public:
    BeadRun(Wire wire, const Settings& settings)
        : wire_(std::move(wire)), bodies_(1)
    {
        remember(settings);
        bodies_.inverse_mass.setConstant(1 / settings["mass"]);
        bodies_.x = wire_.start;
        const Vec2 along =
            perpendicular(wire_.constraint(bodies_.x).Jb.transpose()).normalized();
        bodies_.u = settings["speed"] * along;
        theory_r2_ = bodies_.x.squaredNorm();
        theory_product_ = bodies_.x.norm() * bodies_.u.norm();
        trail_.add(bodies_.x);
    }

    //! [bead_step]
    /// forces → u* → C, J → row → λ → u → x
    void step(const Settings& settings, const Input& input) override
    {
        const Real h = settings.h;
        const Constraint<2> constraint = normalised(wire_.constraint(bodies_.x));
        bodies_.f.setZero();
        add_gravity(bodies_, {0, -settings["gravity"]});
        if (input.pressed) add_pull(bodies_, 0, input.pointer);
        if (settings.method == "spring")
            add_stiff_spring(bodies_, constraint, settings["stiffness"]);
        bodies_.u += h * bodies_.inverse_mass.cwiseProduct(bodies_.f);

        answer_ = {};
        if (settings.method == "row") {
            // 0: C is ignored, see (2.34)
            const Real b = settings["repay"] * constraint.C / h;
            const Row<2> row = bilateral(constraint, bodies_.inverse_mass, b);
            answer_ = solve_row(row, bodies_.u);   // (2.7)
            row.apply(answer_.lambda, bodies_.u);  // (2.5)
        }
        bodies_.x += h * bodies_.u;
        //! [bead_step]
        // (2.32), (2.33)
        theory_r2_ += h * h * theory_product_ * theory_product_ / theory_r2_;
        remember(settings);
        trail_.add(bodies_.x);
    }

    std::vector<Real> measure() const override
    {
        return {drift(), std::sqrt(theory_r2_) - wire_.start.norm(), answer_.lambda,
                answer_.w,
                kinetic_energy(bodies_) +
                    potential_energy(bodies_, {0, -gravity_})};
    }

    void draw(Canvas& canvas) const override
    {
        canvas.polyline(wire_.shape, paint::wire);
        trail_.draw(canvas, {Colour::purple, 1, 0.8});
        const Constraint<2> constraint = normalised(wire_.constraint(bodies_.x));
        const Vec2 x = bodies_.x, u = bodies_.u, n = constraint.Jb.transpose();
        // Metres on the picture per m/s, so that a fast bead's arrow stays in the picture.
        const Real scale = 0.5 * std::min<Real>(1, 2.2 / std::max(u.norm(), 1e-9));
        const Vec2 forbidden = n.dot(u) * n;
        const bool shown = by_row_ && scale * forbidden.norm() > 0.08;
        canvas.segment(x - 0.6 * perpendicular(n), x + 0.6 * perpendicular(n),
                       paint::guide);
        canvas.disc(x, 0.05, paint::body);
        labelled_arrow(canvas, x, 0.45 * n, "Jᵀ", paint::direction);
        if (!shown) labelled_arrow(canvas, x, scale * u, "u", paint::allowed);
        if (shown) {  // what the next row will do
            labelled_arrow(canvas, x, scale * u, "u*", paint::wanted);
            labelled_arrow(canvas, x, scale * (u - forbidden), "u", paint::allowed);
            labelled_arrow(canvas, x + scale * u, -scale * forbidden, "",
                           paint::impulse);
        }
        canvas.text({-0.95 * wire_.half_size.x(), 0.92 * wire_.half_size.y()},
                    "distance from the wire " + fixed(1000 * drift(), 3) + " mm",
                    15, paint::label);
    }

private:
    /// What a picture and a table say of the last step.
    void remember(const Settings& settings)
    {
        gravity_ = settings["gravity"];
        by_row_ = settings.method == "row";
    }

    /// Distance from the wire: exact for the circle, C/||J|| for the others.
    Real drift() const
    {
        return wire_.distance ? wire_.distance(bodies_.x)
                              : normalised(wire_.constraint(bodies_.x)).C;
    }

    Wire wire_;
    Bodies<2> bodies_;
    RowAnswer answer_;
    Real gravity_ = 0;
    bool by_row_ = false;
    Real theory_r2_ = 1, theory_product_ = 1;
    Trail trail_;
};

inline Wire circle_wire()
{
    Wire wire{[](const VecX& x) { return circle_constraint(x, 0, 1); },
              {},
              {1, 0},
              [](const Vec2& p) { return p.norm() - 1; },
              {1.6, 1.5}};
    for (int i = 0; i <= 200; ++i)
        wire.shape.push_back({cos(2 * pi * i / 200), sin(2 * pi * i / 200)});
    return wire;
}

inline Wire ellipse_wire(Real width, Real height)
{
    const Vec2 half_axes(width, height);
    Wire wire{
        [half_axes](const VecX& x) { return ellipse_constraint(x, 0, half_axes); },
        {},
        {width, 0}};
    for (Vec2 p : circle_wire().shape)
        wire.shape.push_back(p.cwiseProduct(half_axes));
    return wire;
}

/// The points of the plane where g is zero, by the angle in which they are seen from the origin
/// (for curves that go once around it).
template <class G>
std::vector<Vec2> outline(const G& g, Real farthest)
{
    std::vector<Vec2> points;
    for (int i = 0; i <= 400; ++i) {
        const Vec2 e(cos(2 * pi * i / 400), sin(2 * pi * i / 400));
        Real inside = 0, outside = farthest;
        while (outside - inside > 1e-9) {
            const Real middle = (inside + outside) / 2;
            (g(Vec2(middle * e)) < 0 ? inside : outside) = middle;
        }
        points.push_back(inside * e);
    }
    return points;
}

inline Wire own_wire()
{
    //! [own_curve]
    // A curve of your own: any g that is negative around the origin and positive
    // far away. This one is Cassini's oval: the product of the distances from (±1,
    // 0) is 1.21 everywhere on it.
    const auto g = [](const auto& p) {
        // a number, or a number that carries its derivatives
        using T = std::decay_t<decltype(p.x())>;
        const T left = (p.x() + 1.0) * (p.x() + 1.0) + p.y() * p.y();
        const T right = (p.x() - 1.0) * (p.x() - 1.0) + p.y() * p.y();
        return T(left * right - 1.4641);
    };
    //! [own_curve]
    return {[g](const VecX& x) { return curve_constraint(x, 0, g); }, outline(g, 3),
            outline(g, 3).front()};
}

inline Demo bead_scene(const std::string& name, const std::string& summary,
                       Real gravity, std::function<Wire(const Settings&)> make_wire)
{
    Demo scene;
    scene.name = name;
    scene.summary = summary;
    scene.view = {{0, 0}, name == "circle" ? Vec2(1.6, 1.5) : Vec2(2, 1.9)};
    scene.h = 0.01;
    scene.h_low = 1e-4;
    scene.h_high = 0.5;
    scene.methods = {"row", "spring"};
    scene.tunables = {{"speed", "m/s", "speed of the bead at the start", 1, 0, 3,
                       Numbers::real, OnChange::restarts},
                      {"gravity", "m/s²", "downwards", gravity, 0, 20,
                       Numbers::real, OnChange::goes_on, Keys::up_and_down},
                      {"mass", "kg", "mass of the bead", 1, 0.1, 10, Numbers::real,
                       OnChange::restarts},
                      {"repay", "",
                       "part of the error C/h that the row's bias requires back", 0,
                       0, 1},
                      {"stiffness", "N/m",
                       "of the spring that stands in for the row", 1000, 10, 1e5}};
    scene.columns = {
        {"drift", "m", "distance from the wire, outwards", Plot::linear},
        {"circle_theory", "m",
         "growth of the radius that (2.32) foretells on a circle without forces",
         Plot::linear, "drift"},
        {"lambda", "N s", "impulse of the row", Plot::linear},
        {"w", "m/s", "what the row left of the velocity across the wire"},
        {"energy", "J", "kinetic and potential", Plot::linear}};
    scene.start = [make_wire](const Settings& settings) {
        return std::make_unique<BeadRun>(make_wire(settings), settings);
    };
    return scene;
}

}  // namespace rigid
