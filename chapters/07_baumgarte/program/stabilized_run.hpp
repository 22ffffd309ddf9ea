/// \file stabilized_run.hpp
/// A scene of discs, alive: the step with any of the ways to correct.
#pragma once

#include "chapters/03_mlcp_formulation/program/ten_disc_scene.hpp"
#include "chapters/04_pgs/program/drawing.hpp"
#include "chapters/07_baumgarte/program/scene_settings.hpp"
#include "common/measure.hpp"

#include <functional>
#include <vector>

namespace rigid {

class StabilizedRun : public Run {
public:
    /// What the scene should show by theory [m], from the settings of the step and its method.
    using Theory = std::function<Real(const StepSettings&, const CorrectedMethod&)>;

    /// \param zoom     from metres to the units of the picture
    /// \param view     what the picture shows
    /// \param theory   may be empty
    /// \param steered  the pointer sets gravity, as for the ten discs
    StabilizedRun(DiscScene scene, Real zoom, const View& view, Theory theory = {}, bool steered = false)
        : scene_(std::move(scene)), zoom_(zoom), view_(view), theory_(std::move(theory)), steered_(steered)
    {
        require_valid(scene_);
        energy_ = energy();
        highest_ = top();
    }

    void step(const Settings& settings, const Input& input) override
    {
        stabilized_settings(settings, step_, method_);
        if (steps_++ == 0) method_.solver.random = Random(settings.seed);
        if (steered_) {
            scene_.gravity = steered_gravity(input, view_, settings["gravity"]);
            step_.stiffness = settings["k"];
            step_.damping = settings["damping"];
        }
        step_.hand = input.pointer / zoom_;
        step_.pulled = held_disc(scene_, input.pressed, step_.hand, step_.pulled);
        rigid::step(scene_, step_, method_, now_);
        for (Index k = 0; k < scene_.bodies.count(); ++k)
            if (!scene_.bodies.position(k).allFinite())
                throw StepFailure("the position of body " + std::to_string(k) + " is not finite");
        highest_ = std::max(highest_, top());
    }

    std::vector<Real> measure() const override
    {
        Real speed = 0;
        for (Index k = 0; k < scene_.bodies.count(); ++k)
            speed = std::max(speed, scene_.bodies.velocity(k).norm());
        return {largest_link_error(scene_),
                deepest_penetration(scene_),
                theory_ && steps_ > 0 ? theory_(step_, method_) : 0,
                highest_,
                speed,
                energy() - energy_,
                static_cast<Real>(now_.contacts.size()),
                static_cast<Real>(now_.visits)};
    }

    void draw(Canvas& canvas) const override
    {
        const Real across = 4 * view_.half_size.maxCoeff() / zoom_;
        for (const HalfSpace& wall : scene_.walls)
            paint::draw_wall(canvas, wall, scene_.walls, zoom_, across);
        for (const Link& link : scene_.links) {
            const Vec2 a = shown(link.a), b = shown(link.b);
            const Real off = std::abs((b - a).norm() / zoom_ - link.length);
            canvas.segment(a, b, off > visible ? paint::impulse : paint::link);
        }
        for (Index k = 0; k < scene_.bodies.count(); ++k)
            canvas.disc(shown(k), zoom_ * scene_.radius[k],
                        scene_.bodies.inverse_mass[2 * k] > 0 ? paint::body : paint::fixed_body);
        for (std::size_t i = 0; i < now_.sources.size(); ++i)
            if (now_.sources[i].of == Source::Of::contact) draw_overlap(canvas, i);
        if (theory_ && steps_ > 0 && scene_.links.empty() &&
            scene_.bodies.count() == 1) {  // how high it should hop
            const Real y = zoom_ * (scene_.radius[0] + theory_(step_, method_));
            canvas.segment({-view_.half_size.x(), y}, {view_.half_size.x(), y}, paint::theory);
            const Real x = -0.7 * view_.half_size.x();
            canvas.disc({x, zoom_ * highest_}, 0.012 * view_.half_size.y(), paint::body);
        }
        draw_caption(canvas);
        if (step_.pulled != world)
            canvas.arrow(shown(step_.pulled), zoom_ * step_.hand, {Colour::green, 2, 1, false, false});
    }

private:
    static constexpr Real visible = 0.001;  ///< errors above this are red [m]

    Vec2 shown(Index k) const { return zoom_ * scene_.bodies.position(k); }
    Real top() const
    {
        Real y = -infinity;
        for (Index k = 0; k < scene_.bodies.count(); ++k) y = std::max(y, scene_.bodies.position(k).y());
        return y;
    }
    Real energy() const
    {
        return kinetic_energy(scene_.bodies) + potential_energy(scene_.bodies, scene_.gravity);
    }

    /// A red bar where two discs, or a disc and a wall, overlap: as long as the part that they share is wide.
    /// \param i  number of the contact's row
    void draw_overlap(Canvas& canvas, std::size_t i) const
    {
        const Constraint<2> c = constraint_at(scene_, now_, i, scene_.bodies.x);
        const Index b = c.b;
        if (c.C > -visible) return;
        const Vec2 normal = c.Jb.transpose();
        const Real half = std::sqrt(std::max(Real{0}, -c.C * (scene_.radius[b] + c.C / 4)));
        const Vec2 middle = shown(b) - zoom_ * normal * (scene_.radius[b] + (c.a == world ? 1 : 0.5) * c.C);
        canvas.segment(middle - zoom_ * half * perpendicular(normal),
                       middle + zoom_ * half * perpendicular(normal), paint::impulse);
    }

    void draw_caption(Canvas& canvas) const
    {
        const Vec2 corner = view_.centre + Vec2(-0.95, 0.93).cwiseProduct(view_.half_size);
        const Vec2 line(0, 0.056 * view_.half_size.maxCoeff());
        const Real off = 1000 * std::max(largest_link_error(scene_), deepest_penetration(scene_));
        canvas.text(corner, "off by " + significant(off, 2) + " mm", 14,
                    off < 1 ? paint::label : paint::impulse);
        canvas.text(corner - line, std::to_string(now_.visits) + " row visits", 14, paint::label);
    }

    DiscScene scene_;
    Real zoom_;
    View view_;
    Theory theory_;
    bool steered_;
    StepSettings step_;
    CorrectedMethod method_;
    StepData<2> now_;
    Real energy_ = 0, highest_ = 0;
    int steps_ = 0;
};

}  // namespace rigid
