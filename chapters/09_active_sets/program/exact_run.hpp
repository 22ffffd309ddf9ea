/// \file exact_run.hpp
/// Scenes of discs whose every step is solved exactly, beginning with yesterday's set; sweeps to compare.
#pragma once

#include "chapters/02_velocity_constraints/program/scene_hand.hpp"
#include "chapters/04_pgs/program/disc_run.hpp"
#include "chapters/09_active_sets/active_sets.hpp"
#include "chapters/09_active_sets/dantzig.hpp"

#include <memory>

namespace rigid {

class ActiveSetRun : public DiscRun {
public:
    /// \param held  the disc that the pointer leads all the time; world = none
    ActiveSetRun(DiscScene scene, Real zoom, const View& view, bool steered, Index held = world)
        : DiscRun(std::move(scene), zoom, view, steered), held_(held)
    {
    }

    //! [step]
    void step(const Settings& settings, const Input& input) override
    {
        listen(settings, input);
        if (held_ != world) lead(settings, input);
        const auto solve = [&](const Mlcp& mlcp, Solution& solution) {
            if (settings.method == "gauss_seidel") {
                cold_start(mlcp, solution.lambda);
                pgs(mlcp, tuned(mlcp), memory_, solution);
            } else if (settings.method == "dantzig") {
                solution = dantzig(mlcp);
            } else {  // memory knows yesterday's set
                if (settings.method == "cold") set_.cases.clear();
                active_sets(mlcp, {}, set_, solution);
            }
        };
        advance(solve);
        counted_ = settings.method == "gauss_seidel" ? "sweeps"
                   : settings.method == "dantzig"    ? "pivots"
                   : now_.solution.iterations == 1   ? "guess"
                                                     : "guesses";
        if (!scene_.bodies.x.allFinite()) throw StepFailure(first_lost_body());
        unsolved_ += now_.solution.status != Status::solved;
    }
    //! [step]

    std::vector<Real> measure() const override
    {
        std::vector<Real> numbers = DiscRun::measure();
        numbers.push_back(set_.work.factorisations);
        numbers.push_back(set_.work.flips);
        numbers.push_back(held_ == world ? 0 : length() / (static_cast<Real>(scene_.links.size()) * 0.1));
        return numbers;
    }

    /// A held chain is a line; the circle is as far as its end can be.
    void draw(Canvas& canvas) const override
    {
        if (held_ == world) return DiscRun::draw(canvas);
        const Real reach = 0.1 * static_cast<Real>(scene_.links.size());
        canvas.disc(shown(scene_.bodies.position(0)), zoom_ * reach, {Colour::faint, 1.5, 1, false, true});
        std::vector<Vec2> line;
        for (Index k = 0; k < scene_.bodies.count(); ++k) line.push_back(shown(scene_.bodies.position(k)));
        canvas.polyline(line, {Colour::blue, 3, 1, false, false});
        canvas.disc(line.front(), 0.02, paint::fixed_body);
        canvas.disc(line.back(), 0.03, {Colour::red, 1.5, 1, true, false});
        if (led_ != world)
            canvas.arrow(shown(scene_.bodies.position(led_)), shown(hand_),
                         {Colour::green, 2, 1, false, false});
        draw_caption(canvas);
        const Vec2 corner = view_.centre + Vec2(-0.93, 0.92).cwiseProduct(view_.half_size);
        canvas.text(corner - Vec2(0, 0.07 * view_.half_size.maxCoeff() * 1.6),
                    "length " + fixed(length(), 2) + " m of " + fixed(reach, 2) + " m", 14, paint::label);
    }

private:
    /// Of the chain [m].
    Real length() const
    {
        Real sum = 0;
        for (const Link& link : scene_.links)
            sum += (scene_.bodies.position(link.b) - scene_.bodies.position(link.a)).norm();
        return sum;
    }

    /// The pointer leads the held disc all the time, or, pressed, the nearest one. The hand comes at 4 m/s at
    /// most: a pointer may jump across the picture, a hand may not.
    void lead(const Settings& settings, const Input& input)
    {
        const Index before = led_;
        if (!input.present) led_ = world;
        else if (!input.pressed) led_ = held_;
        else if (!pressed_) led_ = nearest_body(scene_.bodies, input.pointer / zoom_);
        pressed_ = input.pressed;
        if (led_ != world) {
            if (led_ != before) hand_ = scene_.bodies.position(led_);
            const Vec2 way = input.pointer / zoom_ - hand_;
            hand_ += way * std::min(Real{1}, 4 * settings.h / std::max(way.norm(), Real{1e-9}));
        }
        disc_settings_.pulled = led_;
        disc_settings_.hand = hand_;
    }

    ActiveSetMemory set_;
    Index held_, led_ = world;
    bool pressed_ = false;
    Vec2 hand_ = {0, 0};  ///< [m]
};

inline Demo exact_scene(const std::string& name, const std::string& summary)
{
    Demo scene;
    scene.name = name;
    scene.summary = summary;
    scene.h = 1.0 / 480;
    scene.h_low = 1e-4;
    scene.h_high = 1.0 / 120;
    scene.steered = true;
    scene.methods = {"active_sets", "cold", "dantzig", "gauss_seidel"};
    scene.side_by_side = {"active_sets", "gauss_seidel"};
    scene.tunables = {{"max_sweeps", "", "of gauss_seidel: after so many it makes do with what it has", 10, 1,
                       2000, true, false, false},
                      {"digits", "", "of gauss_seidel: the residual is to be below 10^-digits m/s", 6, 1, 12,
                       false, false, false},
                      {"order", "", "of gauss_seidel: 0 as the rows come, 1 reversed, 2 shuffled", 0, 0, 2,
                       true, false, false}};
    scene.columns = {{"iterations", "", "guesses, pivots or sweeps of the step", true, false},
                     {"residual", "m/s", "natural residual of the step's answer", true, true},
                     {"row_visits", "", "of gauss_seidel: rows visited", false, false},
                     {"rows", "", "links and contacts", false, false},
                     {"unsolved", "", "steps so far that did not meet the tolerance", false, false},
                     {"link_error", "m", "largest difference of a link from its length", true, true},
                     {"penetration", "m", "deepest overlap", false, true},
                     {"kinetic", "J", "kinetic energy", true, false},
                     {"energy", "J", "kinetic energy and that of the weight", false, false},
                     {"factorisations", "", "of active_sets: of the active rows in this step", true, false},
                     {"flips", "", "of active_sets: rows that changed their case in this step", false, false},
                     {"stretch", "", "of a chain: its length over that of its links", true, false}};
    return scene;
}

inline Demo ten_discs_exactly_scene()
{
    Demo scene = exact_scene("ten_discs", "The ten discs, each step solved exactly from yesterday's set");
    set_up_ten_discs(scene);
    scene.start = [view = scene.view](const Settings&) {
        return std::make_unique<ActiveSetRun>(ten_discs(), 1, view, true);
    };
    return scene;
}

/// Two hundred links, which sweeps cannot hold; the pointer leads the lowest disc.
inline Demo long_chain_scene()
{
    Demo scene = exact_scene("long_chain", "A chain of 200 links pulled by its end: exact, and by sweeps");
    scene.view = {{0, -0.85}, {1.5, 1.35}};
    scene.h_high = 1.0 / 240;  // a link that turns fast leaves its length by h²u²/2L in a step
    scene.tunables.insert(scene.tunables.begin(),
                          {{"links", "", "N, links of 0.1 m", 200, 2, 1000, true, true, false},
                           {"end_mass", "kg", "mass of the last disc; the others have 1 kg", 100, 0.01, 1000,
                            false, true, false}});
    scene.start = [view = scene.view](const Settings& settings) {
        const auto N = static_cast<Index>(settings["links"]);
        DiscScene chain = hanging_chain(N, settings["end_mass"]);
        chain.linked = PairSet::all();  // its discs never meet
        return std::make_unique<ActiveSetRun>(std::move(chain), 20 / static_cast<Real>(N), view, false, N);
    };
    return scene;
}

}  // namespace rigid
