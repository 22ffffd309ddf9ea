/// \file scene_discs.hpp
/// Discs that meet each other and the walls of a box, one row for each contact.
#pragma once

#include "chapters/02_velocity_constraints/geometry.hpp"
#include "chapters/02_velocity_constraints/program/drawing.hpp"
#include "chapters/02_velocity_constraints/program/scene_hand.hpp"
#include "chapters/02_velocity_constraints/solve_rows.hpp"
#include "common/forces.hpp"
#include "common/measure.hpp"
#include "common/program/program.hpp"
#include "common/random.hpp"

#include <algorithm>
#include <array>
#include <memory>
#include <vector>

namespace rigid {

/// Discs in a box. Each contact is one row, and each row has its turn.
class DiscsRun : public Run {
public:
    explicit DiscsRun(const Settings& settings)
    {
        const Index K = static_cast<Index>(settings["count"]);
        scene_.bodies = Bodies<2>(K);
        scene_.radius = VecX::Constant(K, 0.25);
        scene_.walls = {
            {{0, 1}, -1}, {{1, 0}, -1.5}, {{-1, 0}, -1.5}, {{0, -1}, -1}};
        Random random(settings.seed);
        for (Index k = 0; k < K;
             // the first two fly towards each other, the others where there is room
             ++k) {
            scene_.radius[k] = k == 0   ? 0.25
                               : k == 1 ? 0.35
                                        : random.uniform(0.1, 0.2);
            if (k == 0) scene_.bodies.position(k) << -1, -0.25;
            else if (k == 1) scene_.bodies.position(k) << 0.6, 0.5;
            else place_freely(k, random);
            const Real density = 1 / (0.25 * 0.25);  // 1 kg for the first
            scene_.bodies.inverse_mass.segment<2>(2 * k).setConstant(
                1 / (density * scene_.radius[k] * scene_.radius[k]));
            if (k == 0) scene_.bodies.velocity(k) << 2, 0.3;
            if (k == 1) scene_.bodies.velocity(k) << -0.2, -0.9;
        }
        before_ = scene_.bodies.u;
    }

    //! [discs_step]
    /// forces → u* → contacts → rows → λ, row after row → u → x
    void step(const Settings& settings, const Input& input) override
    {
        const Real h = settings.h;
        Bodies<2>& bodies = scene_.bodies;
        bodies.f.setZero();
        add_gravity(bodies, {0, -settings["gravity"]});
        hand_.pull(bodies, input);
        bodies.u += h * bodies.inverse_mass.cwiseProduct(bodies.f);
        before_ = bodies.u;

        // A gap may close in this step, but not more: w = J u + C/h >= 0 where C >
        // 0, (2.3).
        find_contacts(scene_, 0.1, contacts_);
        rows_.clear();
        for (const Contact& contact : contacts_)
            rows_.push_back(unilateral(contact_constraint(contact),
                                       bodies.inverse_mass,
                                       std::max<Real>(contact.gap, 0) / h));

        impulse_ = VecX::Zero(static_cast<Index>(rows_.size()));
        const int rounds = static_cast<int>(settings["rounds"]);
        for (int round = 0; round < rounds; ++round)
            for (std::size_t i = 0; i < rows_.size(); ++i) {
                const Real lambda = solve_row(rows_[i], bodies.u).lambda;
                rows_[i].apply(lambda, bodies.u);
                impulse_[static_cast<Index>(i)] += lambda;
            }
        left_ = 0;
        for (const Row<2>& row : rows_)
            left_ = std::min(left_, row.velocity(bodies.u));
        bodies.x += h * bodies.u;
    }
    //! [discs_step]

    std::vector<Real> measure() const override
    {
        const Vec2 P = momentum(scene_.bodies);
        return {static_cast<Real>(rows_.size()),
                -left_,
                1000 * deepest_penetration(scene_),
                kinetic_energy(scene_.bodies),
                P.x(),
                P.y()};
    }

    void draw(Canvas& canvas) const override
    {
        canvas.box({0, 0}, {1.5, 1}, 0, paint::wire);
        const Bodies<2>& bodies = scene_.bodies;
        const bool few = bodies.count() <= 3;  // else the names would overlap
        const auto arrow = [&](const Vec2& tail, const Vec2& vector,
                               const char* name, const Style& style) {
            labelled_arrow(canvas, tail, vector, few ? name : "", style, 0.05);
        };
        for (Index k = 0; k < bodies.count(); ++k) {
            const Vec2 x = bodies.position(k);
            canvas.disc(x, scene_.radius[k], paint::body);
            canvas.text(x + scene_.radius[k] * Vec2(-0.55, 0.5), std::to_string(k),
                        14, paint::label, Align::centre);
            const Vec2 star = before_.segment<2>(2 * k), u = bodies.velocity(k);
            if ((star - u).norm() > 0.05)
                arrow(x, 0.25 * star, "u*", paint::wanted);
            arrow(x, 0.25 * u, "u", paint::allowed);
        }
        for (std::size_t i = 0;
             i < contacts_.size() && static_cast<Index>(i) < impulse_.size(); ++i) {
            const Real lambda = impulse_[static_cast<Index>(i)];
            if (lambda <= 0) continue;
            // At the place of contact: the impulse on b along the normal, the one on a against it.
            const Contact& c = contacts_[i];
            const Vec2 along = perpendicular(c.normal),
                       touch = bodies.position(c.b) - c.normal * scene_.radius[c.b];
            canvas.segment(touch - 0.3 * along, touch + 0.3 * along, paint::guide);
            arrow(touch, (few ? 0.3 : 0.1) * c.normal, "n", paint::direction);
            const Vec2 P = std::min(0.2 * lambda, 0.6) * c.normal,
                       tail = touch + (few ? 0.32 : 0.02) * along;
            if (P.norm() < 0.02) continue;
            arrow(tail, P, "+P", paint::impulse);
            if (c.a != world) arrow(tail, -P, "−P", paint::impulse);
        }
    }

private:
    void place_freely(Index k, Random& random)
    {
        for (int attempt = 0; attempt < 1000; ++attempt) {
            const Real y = random.uniform(-0.75, 0.75),
                       x = random.uniform(-1.25, 1.25);
            const Vec2 p(x, y);
            bool free = true;
            for (Index j = 0; j < k && free; ++j)
                free = (scene_.bodies.position(j) - p).norm() >
                       scene_.radius[j] + scene_.radius[k];
            scene_.bodies.position(k) = p;
            if (free) return;
        }
    }

    DiscScene scene_;
    std::vector<Contact> contacts_;
    std::vector<Row<2>> rows_;
    VecX impulse_, before_;
    HeldBody hand_;
    Real left_ = 0;
};

inline Demo discs_scene()
{
    Demo scene;
    scene.name = "discs";
    scene.summary = "Discs that meet each other and the walls without bounce, one "
                    "row for each contact";
    scene.view = {{0, 0}, {1.6, 1.1}};
    scene.h = 1.0 / 60;
    scene.methods = {"row-by-row"};
    scene.tunables = {{"count", "", "number of discs", 2, 1, 14, Numbers::whole,
                       OnChange::restarts},
                      {"rounds", "", "how often each row has its turn in a step", 1,
                       1, 100, Numbers::whole},
                      {"gravity", "m/s²", "downwards", 0, 0, 20, Numbers::real,
                       OnChange::goes_on, Keys::up_and_down}};
    scene.columns = {
        {"rows", "", "contacts of the step", Plot::linear},
        {"left", "m/s", "the largest approach that the rows left", Plot::linear},
        {"penetration", "mm", "the deepest overlap", Plot::linear},
        {"kinetic", "J", "kinetic energy", Plot::linear},
        {"px", "kg m/s", "momentum along x"},
        {"py", "kg m/s", "momentum along y"}};
    scene.start = [](const Settings& settings) {
        return std::make_unique<DiscsRun>(settings);
    };
    return scene;
}

}  // namespace rigid
