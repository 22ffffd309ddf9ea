/// \file disc_run.hpp
/// A scene of discs, alive: chapter 3's step with sweeps for a solver.
#pragma once

#include "chapters/03_mlcp_formulation/program/ten_disc_scene.hpp"
#include "chapters/04_pgs/conjugate_gradients.hpp"
#include "chapters/04_pgs/pgs.hpp"
#include "chapters/04_pgs/program/drawing.hpp"
#include "chapters/04_pgs/program/scene_sweeps.hpp"
#include "chapters/04_pgs/rates.hpp"
#include "common/measure.hpp"
#include "common/program/program.hpp"

#include <functional>
#include <vector>

namespace rigid {

class DiscRun : public Run {
public:
    /// \param zoom     from metres to the units of the picture
    /// \param view     what the picture shows
    /// \param steered  the pointer sets gravity, and contact forces are arrows; else they are bars
    DiscRun(DiscScene scene, Real zoom, const View& view, bool steered = false)
        : scene_(std::move(scene)), zoom_(zoom), view_(view), steered_(steered)
    {
        require_valid(scene_);
    }

    //! [step]
    void step(const Settings& settings, const Input& input) override
    {
        listen(settings, input);
        const auto solve = [this](const Mlcp& mlcp, Solution& solution) {
            cold_start(mlcp, solution.lambda);  // nothing is remembered from the last step
            if (conjugate_)
                conjugate_gradients(mlcp, pgs_settings_.tolerance, pgs_settings_.max_sweeps, cg_, solution);
            else pgs(mlcp, tuned(mlcp), memory_, solution);
        };
        advance(solve);
        if (!scene_.bodies.x.allFinite()) throw StepFailure(first_lost_body());
        unsolved_ += now_.solution.status != Status::solved;
    }
    //! [step]

    std::vector<Real> measure() const override
    {
        const auto rows = static_cast<Index>(now_.rows.size());
        return {static_cast<Real>(now_.solution.iterations),
                std::isfinite(now_.solution.residual) ? now_.solution.residual : 0,
                static_cast<Real>(rows) * (now_.solution.iterations + memory_.checks),
                static_cast<Real>(rows),
                static_cast<Real>(unsolved_),
                largest_link_error(scene_),
                deepest_penetration(scene_),
                kinetic_energy(scene_.bodies),
                kinetic_energy(scene_.bodies) + potential_energy(scene_.bodies, scene_.gravity)};
    }

    void draw(Canvas& canvas) const override
    {
        for (const HalfSpace& wall : scene_.walls)
            paint::draw_wall(canvas, wall, scene_.walls, zoom_, 1 / zoom_);
        for (const Link& link : scene_.links)
            canvas.segment(shown(scene_.bodies.position(link.a)), shown(scene_.bodies.position(link.b)),
                           paint::link);
        Real heaviest = 0;
        for (Index k = 0; k < scene_.bodies.count(); ++k) heaviest = std::max(heaviest, mass(k));
        for (Index k = 0; k < scene_.bodies.count(); ++k) {
            Style style = mass(k) > 0 ? paint::body : paint::fixed_body;
            if (mass(k) > 0) style.opacity = 0.15 + 0.55 * std::sqrt(mass(k) / heaviest);
            canvas.disc(shown(scene_.bodies.position(k)), zoom_ * scene_.radius[k], style);
        }
        draw_impulses(canvas);
        draw_caption(canvas);
        if (disc_settings_.pulled != world)
            canvas.arrow(shown(scene_.bodies.position(disc_settings_.pulled)), shown(disc_settings_.hand),
                         {Colour::green, 2, 1, false, false});
    }

protected:
    /// One step by a solver of the MLCP; what the step keeps stays with this run.
    template <class Solve>
    void advance(const Solve& solve)
    {
        const auto find = [&solve](const Mlcp& mlcp, Solution& solution) {
            hand_over(solve, mlcp, solution);
        };
        matrix_.solver.find = std::ref(find);
        rigid::step(scene_, disc_settings_, matrix_, now_);
    }

    /// Gravity follows the pointer in the scene that it steers; a pressed button pulls the disc under it.
    void steer(const Settings& settings, const Input& input)
    {
        const Index was_pulled = disc_settings_.pulled;
        if (steered_) {
            disc_settings_ = ten_discs_settings(settings, input);
            scene_.gravity = steered_gravity(input, view_, settings["gravity"]);
        }
        disc_settings_.h = settings.h;
        disc_settings_.hand = input.pointer / zoom_;
        disc_settings_.pulled = held_disc(scene_, input.pressed, disc_settings_.hand, was_pulled);
    }

    /// The same, and what the reader has set for chapter 4's sweeps.
    void listen(const Settings& settings, const Input& input)
    {
        steer(settings, input);
        pgs_settings_.tolerance = std::pow(10, -settings["digits"]);
        pgs_settings_.max_sweeps = static_cast<int>(settings["max_sweeps"]);
        pgs_settings_.omega = settings.method == "sor" ? settings["omega"] : 1;
        pgs_settings_.sweeps = settings.method == "jacobi"      ? Sweeps::jacobi
                               : settings.method == "symmetric" ? Sweeps::symmetric
                                                                : Sweeps::gauss_seidel;
        conjugate_ = settings.method == "cg";
        order_ = static_cast<int>(settings["order"]);
        seed_ = settings.seed;
    }

    /// The settings for this problem: its order of visits, and for Jacobi the relaxation that keeps it from
    /// growing.
    const PgsSettings& tuned(const Mlcp& mlcp)
    {
        if (order_ == 0) pgs_settings_.order.clear();
        else pgs_settings_.order = row_order(mlcp.size(), order_, seed_);
        if (pgs_settings_.sweeps == Sweeps::jacobi)
            pgs_settings_.omega = std::min(1.0, 0.95 * safe_jacobi_omega(mlcp));
        return pgs_settings_;
    }

    Vec2 shown(const Vec2& p) const { return zoom_ * p; }
    Real mass(Index k) const
    {
        const Real inverse = scene_.bodies.inverse_mass[2 * k];
        return inverse > 0 ? 1 / inverse : 0;
    }
    std::string first_lost_body() const
    {
        Index k = 0;
        while (k + 1 < scene_.bodies.count() && scene_.bodies.position(k).allFinite()) ++k;
        return "the position of body " + std::to_string(k) + " is not finite";
    }

    /// Each row's force |λ|/h, to scale with the weight of all: arrows at contacts, or bars across the
    /// normal.
    void draw_impulses(Canvas& canvas) const
    {
        if (now_.solution.lambda.size() != static_cast<Index>(now_.rows.size())) return;
        Real weight = 0;
        for (Index k = 0; k < scene_.bodies.count(); ++k) weight += 9.81 * mass(k);
        const Real unit = (scene_.links.empty() || steered_ ? 0.5 : 0.25) / (weight * disc_settings_.h);
        const std::size_t links = scene_.links.size();
        for (std::size_t i = 0; i < now_.rows.size(); ++i) {
            const Row<2>& row = now_.rows[i];
            const Vec2 normal = row.Jb.transpose();
            const Real length =
                std::min(Real{0.6}, unit * std::abs(now_.solution.lambda[static_cast<Index>(i)]));
            if (length < 0.004) continue;
            const Vec2 touch = shown(scene_.bodies.position(row.b) - normal * scene_.radius[row.b]);
            if (!steered_) {
                canvas.segment(touch - length * perpendicular(normal), touch + length * perpendicular(normal),
                               {Colour::red, 4, 0.9, false, false});
            } else if (i >= links) {
                canvas.arrow(touch, touch + length * normal, paint::impulse);
                if (row.a != world) canvas.arrow(touch, touch - length * normal, paint::impulse);
            }
        }
    }

    /// What the step cost and what is wrong with its answer.
    void draw_caption(Canvas& canvas) const
    {
        const Solution& solution = now_.solution;
        if (!std::isfinite(solution.residual)) return;
        std::string text = std::to_string(solution.iterations) + " " + counted_ + ", residual " +
                           significant(solution.residual, 2) + " m/s";
        if (solution.status != Status::solved) text += ": " + std::string(to_string(solution.status));
        const Vec2 corner = view_.centre + Vec2(-0.93, 0.92).cwiseProduct(view_.half_size);
        const Vec2 line_below(0, 0.035 * view_.half_size.maxCoeff() * 1.6);
        canvas.text(corner, text, 14, solution.status == Status::solved ? paint::label : paint::impulse);
        const Real off = 1000 * std::max(largest_link_error(scene_), deepest_penetration(scene_));
        canvas.text(corner - line_below, "links and contacts off by " + significant(off, 2) + " mm", 14,
                    paint::label);
        if (steered_) {
            canvas.arrow({0, 0}, 0.02 * scene_.gravity, {Colour::green, 2.5, 1, false, false});
            canvas.text(0.022 * scene_.gravity + Vec2(0.015, -0.02), "g", 14,
                        {Colour::green, 1.5, 1, false, false});
        }
    }

    std::string counted_ = "sweeps";  ///< what the solver counts
    DiscScene scene_;
    Real zoom_;
    View view_;
    bool steered_ = false;
    StepSettings disc_settings_;
    PgsSettings pgs_settings_;
    PgsMemory memory_;
    CgMemory cg_;
    StepData<2> now_;
    MatrixMethod<std::function<void(const Mlcp&, Solution&)>> matrix_;
    bool conjugate_ = false;
    int order_ = 0;
    std::uint64_t seed_ = 1;
    int unsolved_ = 0;
};

}  // namespace rigid
