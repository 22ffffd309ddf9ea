/// \file skipping_run.hpp
/// A scene of discs, alive: islands coloured, sleepers faded, counters on the picture. A pressed button pulls the
/// disc under the pointer, and so wakes its island.
#pragma once

#include "chapters/10_skipping_work/scene_edits.hpp"
#include "chapters/10_skipping_work/skipping_world.hpp"
#include "common/program/program.hpp"
#include "common/text.hpp"

#include <array>
#include <cmath>
#include <memory>
#include <utility>
#include <vector>

namespace rigid {

class SkippingRun : public Run {
public:
    SkippingRun(DiscScene scene, CollisionFilter filter, Real margin, Real skin, const View& view)
        : now_(make_world(std::move(scene), std::move(filter), margin, skin)), view_(view),
          group_(static_cast<std::size_t>(now_.scene.bodies.count()), -1)
    {
    }

    void step(const Settings& settings, const Input& input) override
    {
        listen(settings, input);
        if (const auto wait = settings.tunables.find("wait"); wait != settings.tunables.end())
            let_go(wait->second, settings.h);
        skipping_step(now_, settings_);
        for (const int k : now_.method.contacts.set.awake)
            if (!now_.scene.bodies.position(k).allFinite())
                throw StepFailure("the position of body " + std::to_string(k) + " is not finite");
        for (int i = 0; now_.counters.awake > 0 && i < now_.method.solver.islands.count(); ++i)
            for (const int k : now_.method.solver.islands.bodies_of(i))
                group_[static_cast<std::size_t>(k)] = now_.method.solver.islands.rows_of(i).empty()
                                                          ? -1
                                                          : now_.method.solver.islands.bodies_of(i)[0];
    }

    std::vector<Real> measure() const override
    {
        const SkippingCounters& c = now_.counters;
        Real energy = 0;
        for (const int k : now_.method.contacts.set.awake)
            if (const Real inverse = now_.scene.bodies.inverse_mass[2 * k]; inverse > 0)
                energy += now_.scene.bodies.velocity(k).squaredNorm() / (2 * inverse);
        const auto real = [](auto value) { return static_cast<Real>(value); };
        return {real(c.awake),  real(c.islands),     real(c.contacts), real(c.rows),
                real(c.sweeps), real(c.visits),      real(c.tested),   real(c.queries),
                real(c.woken),  real(c.fell_asleep), real(c.unsolved), energy};
    }

    void draw(Canvas& canvas) const override
    {
        const DiscScene& scene = now_.scene;
        for (const HalfSpace& wall : scene.walls) {
            const Vec2 middle = wall.normal * wall.offset;
            const Vec2 along = 2 * view_.half_size.maxCoeff() * perpendicular(wall.normal);
            canvas.segment(middle - along, middle + along, {Colour::ink, 2, 1, false, false});
        }
        for (const int l : visible_links())
            canvas.segment(scene.bodies.position(scene.links[static_cast<std::size_t>(l)].a),
                           scene.bodies.position(scene.links[static_cast<std::size_t>(l)].b),
                           {Colour::ink, 1, 0.5, false, false});
        for (Index k = 0; k < scene.bodies.count(); ++k) {
            const Activity activity = now_.method.contacts.set.activity[static_cast<std::size_t>(k)];
            const Vec2 at = scene.bodies.position(k) - view_.centre;
            if (activity == Activity::gone || std::abs(at.x()) > view_.half_size.x() + scene.radius[k] ||
                std::abs(at.y()) > view_.half_size.y() + scene.radius[k])
                continue;
            Style style = {colour_of(k), 1, 0.65, true, false};
            if (activity == Activity::fixed) style = {Colour::ink, 1, 0.3, true, false};
            if (activity == Activity::asleep) style.opacity = 0.12;
            canvas.disc(scene.bodies.position(k), scene.radius[k], style);
        }
        draw_counters(canvas);
        if (settings_.pulled != world)
            canvas.arrow(scene.bodies.position(settings_.pulled), settings_.hand,
                         {Colour::green, 2, 1, false, false});
    }

private:
    void listen(const Settings& settings, const Input& input)
    {
        settings_.h = settings.h;
        now_.scene.gravity = {0, -settings["gravity"]};
        settings_.sweeps.max_sweeps = static_cast<int>(settings["max_sweeps"]);
        settings_.sweeps.tolerance = std::pow(10, -settings["digits"]);
        settings_.exact_rows = static_cast<int>(settings["exact_rows"]);
        settings_.rest.speed = settings["rest_speed"];
        settings_.rest.time = settings["rest_time"];
        settings_.sleep = settings.method != "no_sleep";
        settings_.islands = settings.method != "one_island";
        settings_.stabilizer.slop = 5e-4;
        settings_.stabilizer.max_correction_speed = 1;
        const Index was = settings_.pulled;
        settings_.hand = input.pointer;
        settings_.pulled = world;
        if (!input.pressed) return;
        if (was != world) settings_.pulled = was;
        else
            now_.method.contacts.broad.grid.near(input.pointer, 0.02, ~std::uint64_t{0}, [&](int b) {
                if (now_.scene.bodies.can_move(b)) settings_.pulled = b;
            });
    }

    /// Body 0 is let go after a time: it gets its mass and 5 m/s.
    void let_go(Real wait, Real h)
    {
        const auto last = static_cast<long>(std::ceil(wait / h));
        if (steps_++ == last)
            change_disc(now_, 0, now_.scene.bodies.position(0), {5, 0}, 1 / (100 * pi * 0.09));
    }

    /// Each island has the colour of its lowest body; who touches nobody is ink.
    Colour colour_of(Index k) const
    {
        constexpr std::array hues = {Colour::blue, Colour::orange, Colour::green,
                                     Colour::red,  Colour::purple, Colour::yellow};
        const int group = group_[static_cast<std::size_t>(k)];
        if (group < 0) return Colour::ink;
        return hues[static_cast<std::size_t>(group) * 2654435761u / 7 % hues.size()];
    }

    const std::vector<int>& visible_links() const
    {
        if (all_links_.size() != now_.scene.links.size())
            for (int l = 0; l < static_cast<int>(now_.scene.links.size()); ++l) all_links_.push_back(l);
        return all_links_;
    }

    void draw_counters(Canvas& canvas) const
    {
        const SkippingCounters& c = now_.counters;
        const auto line = [&](int i, const std::string& text) {
            const Real size = view_.half_size.maxCoeff();
            canvas.text(view_.centre +
                            Vec2(-0.96 * view_.half_size.x(), view_.half_size.y() - size * (0.05 + 0.05 * i)),
                        text, 14);
        };
        line(0, std::to_string(c.awake) + " awake, " + std::to_string(c.islands) + " islands, " +
                    std::to_string(c.rows) + " rows");
        line(1, std::to_string(c.tested) + " pairs tested, " + std::to_string(c.visits) + " row visits");
    }

    SkippingWorld now_;
    SkippingSettings settings_;
    View view_;
    std::vector<int>
        group_;  ///< of each body: the lowest body of the island that it was in when it was awake last
    mutable std::vector<int> all_links_;
    long steps_ = 0;
};

}  // namespace rigid
