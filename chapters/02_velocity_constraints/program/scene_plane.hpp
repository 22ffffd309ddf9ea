/// \file scene_plane.hpp
/// The plane of two velocities: the half-plane that a row allows, and the nearest point in it.
#pragma once

#include "chapters/02_velocity_constraints/geometry.hpp"
#include "chapters/02_velocity_constraints/program/drawing.hpp"
#include "common/elementary.hpp"
#include "common/program/program.hpp"

#include <algorithm>
#include <memory>
#include <utility>
#include <vector>

namespace rigid {

/// The part of a polygon where J p + bias >= 0.
inline std::vector<Vec2> cut(const std::vector<Vec2>& polygon, const Vec2& J,
                             Real bias)
{
    std::vector<Vec2> kept;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Vec2 p = polygon[i], q = polygon[(i + 1) % polygon.size()];
        const Real wp = J.dot(p) + bias, wq = J.dot(q) + bias;
        if (wp >= 0) kept.push_back(p);
        if ((wp >= 0) != (wq >= 0)) kept.push_back(p + wp / (wp - wq) * (q - p));
    }
    return kept;
}

/// Two beads on one rail. The reader drags the point u* = (u1, u2); the row answers.
class VelocityPlaneRun : public Run {
public:
    explicit VelocityPlaneRun(const Settings& settings)
        : bodies_(2), u_star_(settings["u1"], settings["u2"])
    {
        bodies_.x << -0.25, 0.25;
        slider_ = u_star_;
        step(settings, {});
    }

    //! [plane_step]
    void step(const Settings& settings, const Input& input) override
    {
        const Vec2 slider(settings["u1"], settings["u2"]);
        if (slider != slider_) u_star_ = slider_ = slider;
        if (input.pressed) u_star_ = input.pointer;

        bodies_.inverse_mass << 1 / settings["m1"], 1 / settings["m2"];
        const Constraint<1> touch =
            alignment_constraint<1>(bodies_.x, 0, 1, Vec<1>(1), 0.5);
        row_ = settings.method == "unilateral"
                   ? unilateral(touch, bodies_.inverse_mass, settings["bias"])
                   : bilateral(touch, bodies_.inverse_mass, settings["bias"]);
        bodies_.u = u_star_;
        answer_ = solve_row(row_, bodies_.u);
        row_.apply(answer_.lambda, bodies_.u);
    }
    //! [plane_step]

    std::vector<Real> measure() const override
    {
        const VecX star = u_star_;
        const Vec2 mass = bodies_.inverse_mass.cwiseInverse();
        const Vec2 moved = bodies_.u - star;
        return {u_star_.x(),
                u_star_.y(),
                bodies_.u[0],
                bodies_.u[1],
                row_.velocity(star),
                answer_.w,
                answer_.lambda,
                mass.dot(moved.cwiseAbs2()) / 2,
                mass.dot(bodies_.u - star)};
    }

    void draw(Canvas& canvas) const override
    {
        const Real R = 3;  // m/s on each axis
        const VecX star = u_star_;
        const Vec2 J(row_.Ja[0], row_.Jb[0]),
            mass = bodies_.inverse_mass.cwiseInverse();
        const Vec2 along = perpendicular(J).normalized(),
                   on_line = -row_.bias * J / J.squaredNorm();
        const bool half = row_.lo == 0;

        // The allowed half-plane w >= 0, or the line w = 0.
        const Real E = R + 0.2;
        const std::vector<Vec2> square = {{-E, -E}, {E, -E}, {E, E}, {-E, E}};
        if (half)
            canvas.polygon(cut(square, J, row_.bias),
                           {Colour::green, 0, 0.12, Paint::filled});
        // The line: the square cut from both sides, to a strip without width.
        canvas.polygon(cut(cut(square, J, row_.bias), -J, -row_.bias + 1e-9),
                       {Colour::green, 1.2, 1});
        canvas.arrow({-R, 0}, {R, 0}, {Colour::ink, 1, 1});
        canvas.arrow({0, -R}, {0, R}, {Colour::ink, 1, 1});
        for (int k = -2; k <= 2; ++k) {
            if (k == 0) continue;
            canvas.segment({k * 1.0, -0.05}, {k * 1.0, 0.05}, {Colour::ink, 1, 1});
            canvas.segment({-0.05, k * 1.0}, {0.05, k * 1.0}, {Colour::ink, 1, 1});
            canvas.text({k * 1.0, -0.26}, std::to_string(k), 12, paint::label,
                        Align::centre);
            canvas.text({-0.12, k * 1.0 - 0.06}, std::to_string(k), 12,
                        paint::label, Align::right);
        }
        canvas.text({R - 0.05, -0.3}, "u₁ [m/s]", 14, paint::label, Align::right);
        canvas.text({0.12, R - 0.12}, "u₂ [m/s]", 14, paint::label);
        canvas.text(on_line - 2.15 * along + Vec2(-0.15, 0.12),
                    half ? "w ≥ 0" : "w = 0", 16, {Colour::green, 2, 1},
                    Align::right);

        // The ellipse of all velocities as far from u* as the answer, in the metric of M.
        const Vec2 u = bodies_.u;
        const Real size = std::sqrt(mass.dot((u - u_star_).cwiseAbs2()));
        for (const Real part : {0.5, 1.0}) {
            std::vector<Vec2> ring;
            for (int i = 0; i <= 120; ++i)
                ring.push_back(
                    u_star_ +
                    part * size *
                        Vec2(cos(2 * pi * i / 120) / std::sqrt(mass.x()),
                             sin(2 * pi * i / 120) / std::sqrt(mass.y())));
            std::vector<Vec2> piece;  // what of it is in the square
            for (const Vec2& p : ring) {
                if (p.cwiseAbs().maxCoeff() <= E && size > 1e-6) piece.push_back(p);
                else if (piece.size() > 1)
                    canvas.polyline(std::exchange(piece, {}),
                                    {Colour::faint, 1, 1,
                                     part < 1 ? Paint::dashed : Paint::outline});
                else piece.clear();
            }
            if (piece.size() > 1)
                canvas.polyline(piece, {Colour::faint, 1, 1,
                                        part < 1 ? Paint::dashed : Paint::outline});
        }
        // What the eye would take for the nearest point: the foot of the Euclidean perpendicular.
        const Vec2 foot =
            u_star_ - (J.dot(u_star_) + row_.bias) / J.squaredNorm() * J;
        if (answer_.lambda != 0 && (foot - u).norm() > 0.05) {
            canvas.segment(u_star_, foot, paint::guide);
            canvas.disc(foot, 0.06, {Colour::ink, 1.5, 1});
            canvas.text(foot + Vec2(0.3, 0.12), "foot of the perpendicular", 13,
                        paint::label);
        }
        if (answer_.lambda != 0) canvas.arrow(u_star_, u, paint::impulse);
        canvas.disc(u_star_, 0.08, {Colour::orange, 2, 1, Paint::filled});
        canvas.text(u_star_ + Vec2(0.14, -0.22), "u*", 16, paint::wanted);
        canvas.disc(u, 0.08, {Colour::blue, 2, 1, Paint::filled});
        if (answer_.lambda != 0)
            canvas.text(u + Vec2(-0.14, -0.24), "u", 16, paint::allowed,
                        Align::right);
        canvas.text({-R, R + 0.35},
                    "λ = " + fixed(answer_.lambda, 3) + " N s,  w before " +
                        fixed(row_.velocity(star), 3) + ",  after " +
                        fixed(answer_.w, 3) + " m/s",
                    15, paint::label);
        draw_rail(canvas, {0, -R - 0.75}, mass);
    }

private:
    /// The two beads twice: apart, with the velocities that they come with, and where they touch, with those after
    /// the impulse. 3 m/s is drawn as 1.5 m, so that no arrow meets another.
    void draw_rail(Canvas& canvas, const Vec2& middle, const Vec2& mass) const
    {
        const Real radius = 0.25, scale = 0.5;
        for (const bool after : {false, true}) {
            const Vec2 rail = middle - Vec2(0, after ? 1.25 : 0);
            const VecX& u = after ? bodies_.u : VecX(u_star_);
            const auto& style = after ? paint::allowed : paint::wanted;
            canvas.segment(rail - Vec2(3, 0), rail + Vec2(3, 0), paint::wire);
            canvas.text(rail + Vec2(-3, 0.45), after ? "after" : "before", 14,
                        style);
            for (int k = 0; k < 2; ++k) {
                const Vec2 p =
                    rail + Vec2((k == 0 ? -1 : 1) * (after ? radius : 1.6), 0);
                // equal velocities are not drawn as one arrow
                const Real up = after && k == 1 ? 0.58 : 0.36;
                canvas.disc(p, radius,
                            {Colour::blue, 1.5, std::min(0.2 + 0.1 * mass[k], 0.8),
                             Paint::filled});
                canvas.text(p - Vec2(0, 0.08), k == 0 ? "1" : "2", 14, paint::label,
                            Align::centre);
                if (u[k] != 0)
                    canvas.arrow(p + Vec2(0, up), p + Vec2(scale * u[k], up),
                                 style);
            }
        }
    }

    Bodies<1> bodies_;
    Vec2 u_star_, slider_;
    Row<1> row_;
    RowAnswer answer_;
};

inline Demo plane_scene()
{
    Demo scene;
    scene.name = "feasible";
    scene.summary = "Two beads on a rail: drag the point of their two velocities "
                    "and see what the row makes of it";
    scene.view = {{0, -0.95}, {3.4, 4.55}};
    scene.methods = {"unilateral", "bilateral"};
    scene.tunables = {{"u1", "m/s", "velocity of bead 1 before the row", 2, -3, 3},
                      {"u2", "m/s", "velocity of bead 2 before the row", -2, -3, 3},
                      {"m1", "kg", "mass of bead 1", 1, 0.1, 10},
                      {"m2", "kg", "mass of bead 2", 3, 0.1, 10},
                      {"bias", "m/s",
                       "b: positive lets them approach, negative drives them apart",
                       0, -2, 2}};
    scene.columns = {
        {"u1_before", "m/s", "velocity of bead 1 before the row"},
        {"u2_before", "m/s", "velocity of bead 2 before the row"},
        {"u1", "m/s", "velocity of bead 1 after it", Plot::linear},
        {"u2", "m/s", "velocity of bead 2 after it", Plot::linear},
        {"w_before", "m/s", "J u + b before", Plot::linear},
        {"w", "m/s", "J u + b after", Plot::linear},
        {"lambda", "N s", "impulse", Plot::linear},
        {"distance", "J", "half the squared distance from u*, in the metric of M",
         Plot::linear},
        {"momentum_change", "N s", "zero: what bead 1 loses, bead 2 gains"}};
    scene.start = [](const Settings& settings) {
        return std::make_unique<VelocityPlaneRun>(settings);
    };
    return scene;
}

}  // namespace rigid
