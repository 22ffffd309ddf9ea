/// \file scene_impact.hpp
/// One disc at the moment of contact: beside the scene all velocities that its rows allow, and the one among
/// them that changes the momentum least.
#pragma once

#include "chapters/03_mlcp_formulation/direct.hpp"
#include "chapters/03_mlcp_formulation/exact.hpp"
#include "chapters/03_mlcp_formulation/program/impact_drawing.hpp"
#include "chapters/03_mlcp_formulation/step.hpp"
#include "common/elementary.hpp"
#include "common/measure.hpp"
#include "common/program/program.hpp"

#include <algorithm>
#include <string>
#include <vector>

namespace rigid {

/// Chapter 2's answer: every row is an equation, w = 0, and λ may pull.
inline Solution as_equations(Mlcp mlcp)
{
    mlcp.lo.setConstant(-infinity);
    mlcp.hi.setConstant(infinity);
    return direct(mlcp);
}

class ImpactRun : public Run {
public:
    /// \param walls  what the disc of 0.1 m radius may hit
    ImpactRun(const Settings& settings, std::vector<HalfSpace> walls, const Vec2& x,
              const Vec2& u)
    {
        scene_.bodies = Bodies<2>(1);
        scene_.bodies.x = x;
        scene_.bodies.u = u;
        scene_.bodies.inverse_mass.setConstant(1 / settings["mass"]);
        scene_.radius = VecX::Constant(1, 0.1);
        scene_.walls = std::move(walls);
        require_valid(scene_);
        start_ = x;
    }

    //! [step]
    void step(const Settings& settings, const Input& input) override
    {
        Bodies<2>& disc = scene_.bodies;
        const Real h = settings.h;
        if (throw_every_ > 0) throw_again(h);
        disc.f.setZero();
        add_gravity(disc, scene_.gravity);
        if (input.pressed) add_pull(disc, 0, input.pointer);
        now_.u_before = disc.u;
        now_.u_star = disc.u + h * disc.inverse_mass.cwiseProduct(disc.f);

        find_contacts(scene_, 0.1, contacts_);
        now_.rows.clear();
        for (const Contact& contact : contacts_) {
            Row<2> row = unilateral(contact_constraint(contact), disc.inverse_mass,
                                    contact.gap / h);
            // J u: the speed at which the gap opens
            const Real before = row.velocity(disc.u) - row.bias;
            const bool hits = row.velocity(now_.u_star) < 0 &&
                              before < -10 * h * scene_.gravity.norm();
            // (3.31): leave with e times that speed
            if (hits) row.bias = settings["e"] * before;
            now_.rows.push_back(row);
        }
        assemble(now_.rows, now_.u_star, scratch_, now_.mlcp);
        now_.solution = settings.method == "equations" ? as_equations(now_.mlcp)
                                                       : enumerate(now_.mlcp);
        if (now_.solution.status != Status::solved)
            throw StepFailure(
                "the disc finds no velocity that its contacts allow (" +
                std::string(to_string(now_.solution.status)) + ")");
        disc.u = now_.u_star;
        apply(now_.rows, now_.solution.lambda, disc.u);
        disc.x += h * disc.u;
        //! [step]
        now_.u = disc.u;
        now_.t = (t_ += h);
        const bool hit =
            (now_.u_before - now_.u).norm() > 20 * h * scene_.gravity.norm();
        const bool thrown = throw_every_ > 0 && steps_ % throw_every_ == 0;
        // long enough on the screen
        const bool over = throw_every_ == 0 && t_ > shown_.t + 0.5;
        if (hit || thrown || over || shown_.mlcp.size() == 0) shown_ = now_;
        ++steps_;
    }

    /// Puts the disc back to where it started every so many steps, with a u* that turns, (-1, -2) m/s
    /// first.
    void throw_every(long steps) { throw_every_ = steps; }

    std::vector<Real> measure() const override
    {
        Real pushes = 0, opens = 0, both = 0;
        for (Index i = 0; i < now_.mlcp.size(); ++i) {
            const Real lambda = now_.solution.lambda[i],
                       w = now_.rows[static_cast<std::size_t>(i)].velocity(now_.u);
            pushes = std::max(pushes, lambda);
            opens = i == 0 ? w : std::min(opens, w);
            both = std::max(both, std::abs(std::min(lambda, w)));
        }
        return {static_cast<Real>(now_.mlcp.size()),
                pushes,
                opens,
                both,
                now_.mlcp.size() ? now_.solution.residual : 0,
                deepest_penetration(scene_),
                kinetic_energy(scene_.bodies) +
                    potential_energy(scene_.bodies, scene_.gravity)};
    }

    void draw(Canvas& canvas) const override
    {
        for (const HalfSpace& wall : scene_.walls) {
            const Vec2 along = 3 * perpendicular(wall.normal),
                       middle = wall.normal * wall.offset;
            const std::vector<Vec2> line = impact_picture::clipped(
                {middle - along, middle + along, middle + along - 3 * wall.normal,
                 middle - along - 3 * wall.normal},
                impact_picture::scene_corner, impact_picture::scene_size);
            if (line.size() > 2)
                canvas.polygon(line, {Colour::ink, 1, 0.25, Paint::filled});
        }
        const Vec2 x = scene_.bodies.position(0);
        canvas.disc(x, scene_.radius[0], {Colour::blue, 1.5, 0.35, Paint::filled});
        for (const Contact& contact : contacts_)
            if (contact.gap < 0.02) {
                const Vec2 touch =
                    x - contact.normal * (scene_.radius[0] + contact.gap);
                canvas.arrow(touch, touch + 0.15 * contact.normal,
                             {Colour::green, 2, 1});
            }
        if (now_.u.size())
            canvas.arrow(x, x + 0.15 * now_.u.head<2>(), {Colour::blue, 2, 1});
        if (!shown_.rows.empty()) {
            impact_picture::draw_velocities(canvas, shown_);
            impact_picture::draw_sets(canvas, shown_);
        } else {
            canvas.text(impact_picture::plane_middle, "no contact near: u = u*", 14,
                        impact_picture::ink, Align::centre);
        }
    }

private:
    void throw_again(Real h)
    {
        if (steps_ % throw_every_ != 0) return;
        const auto throws = steps_ / throw_every_;
        const Real turn = static_cast<Real>(throws) * 50 * pi / 180;
        const Vec2 first(-1, -2);
        scene_.bodies.x = start_;
        scene_.bodies.u = cos(turn) * first + sin(turn) * perpendicular(first) -
                          h * scene_.gravity;
    }

    DiscScene scene_;
    VecX start_;
    long steps_ = 0, throw_every_ = 0;
    std::vector<Contact> contacts_;
    AssemblyScratch scratch_;
    ImpactMoment now_, shown_;
    Real t_ = 0;
};

/// What both scenes of one disc have in common.
inline Demo impact_scene(const std::string& name, const std::string& summary)
{
    Demo scene;
    scene.name = name;
    scene.summary = summary;
    scene.view = {{0.95, 0.33}, {2.1, 1.3}};
    scene.h = 1.0 / 60;
    scene.h_low = 1e-3;
    scene.h_high = 1.0 / 20;
    scene.methods = {"either_or", "equations"};
    scene.tunables = {{"e", "",
                       "restitution: leave with e times the speed of approach", 0.6,
                       0, 1, Numbers::real, OnChange::goes_on, Keys::up_and_down},
                      {"mass", "kg", "mass of the disc", 1, 0.1, 100, Numbers::real,
                       OnChange::restarts}};
    scene.columns = {
        {"contacts", "", "rows of the step"},
        {"lambda", "N s", "largest impulse", Plot::linear},
        {"w", "m/s", "smallest J u + b", Plot::linear},
        {"both", "", "largest |min(λ, w)| of a row: zero if it is either/or"},
        {"residual", "m/s", "natural residual", Plot::logarithmic},
        {"penetration", "m", "deepest overlap"},
        {"energy", "J", "kinetic energy and that of the weight", Plot::linear}};
    return scene;
}

/// A disc that bounces on a floor, between far walls.
inline Demo bounce_scene()
{
    Demo scene = impact_scene(
        "bounce",
        "A disc bounces; beside it all velocities that its contact allows");
    scene.view = {{0.95, 0.53}, {2.1, 1.15}};
    scene.tunables.push_back({"tilt", "°", "of the floor", 0, -40, 40,
                              Numbers::real, OnChange::restarts});
    scene.start = [](const Settings& settings) {
        const Real tilt = settings["tilt"] * pi / 180;
        return std::make_unique<ImpactRun>(
            settings,
            std::vector<HalfSpace>{
                {{-sin(tilt), cos(tilt)}, 0}, {{1, 0}, -1}, {{-1, 0}, -1}},
            Vec2(-0.6, 1.1), Vec2(0.4, 0));
    };
    return scene;
}

/// A disc that touches floor and ramp is thrown again and again, each time in another direction.
inline Demo corner_scene()
{
    Demo scene = impact_scene(
        "corner",
        "A disc is thrown into a corner: two contacts, four sets of either/or");
    scene.tunables[0].value = 0;
    scene.tunables.push_back({"ramp", "°", "slope of the ramp",
                              atan(0.75) * 180 / pi, 10, 85, Numbers::real,
                              OnChange::restarts});
    scene.start = [](const Settings& settings) {
        const Real ramp = settings["ramp"] * pi / 180;
        const Vec2 normal(sin(ramp), cos(ramp)), x(0, 0.1);
        auto run = std::make_unique<ImpactRun>(
            settings,
            std::vector<HalfSpace>{{{0, 1}, 0}, {normal, normal.dot(x) - 0.1}}, x,
            Vec2(0, 0));
        run->throw_every(40);
        return run;
    };
    return scene;
}

}  // namespace rigid
