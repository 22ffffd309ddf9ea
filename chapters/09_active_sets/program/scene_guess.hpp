/// \file scene_guess.hpp
/// A pile of boxes that is hit: the guess which contacts push, and its corrections, one per step.
#pragma once

#include "chapters/09_active_sets/benchmark/problems.hpp"
#include "chapters/09_active_sets/program/drawing.hpp"
#include "chapters/09_active_sets/program/guess_run.hpp"

#include <memory>

namespace rigid {

class GuessRun : public Run {
public:
    GuessRun(BoxPile pile, const Motion& motion, const std::string& method,
             bool at_once)
        : pile_(std::move(pile)), walk_(pile_problem(pile_, motion).mlcp(), method)
    {
        if (at_once) walk_.to_the_end();
        for (const Vec2& p : pile_.centre) reach_ = reach_.cwiseMax(p.cwiseAbs());
        reach_ += Vec2(0.6, 0.6);
    }

    void step(const Settings&, const Input&) override { walk_.step(); }
    std::vector<Real> measure() const override { return walk_.measure(); }

    void draw(Canvas& canvas) const override
    {
        const Real zoom = std::min(0.95 / reach_.x(), 1.7 / reach_.y());
        const auto shown = [&](const Vec2& p) {
            return Vec2(Vec2(0, -0.85) + zoom * p);
        };
        canvas.segment(shown({-reach_.x(), 0}), shown({reach_.x(), 0}),
                       paint::wall);
        for (std::size_t k = 0; k < pile_.centre.size(); ++k) {
            Style style = paint::body;
            style.opacity = pile_.mass[k] > 1 ? 0.6 : 0.2;
            canvas.box(shown(pile_.centre[k]), zoom * Vec2(0.49, 0.49), 0, style);
        }
        const VecX& lambda = walk_.lambda;
        const Real largest =
            std::max(lambda.size() ? lambda.cwiseAbs().maxCoeff() : 0, 1e-12);
        const Real dot = std::min(0.09 * zoom, 0.022);
        Index i = 0;
        for (const BoxPile::Stands& pair : pile_.stands)
            for (const Vec2& end : ends_of_contact(pile_, pair)) {
                // A little inwards: where three boxes meet, points would hide each other.
                const Vec2 inwards =
                    pile_.centre[static_cast<std::size_t>(pair.above)] - end;
                const Vec2 p =
                    shown(end + Vec2(0.12 * (inwards.x() > 0 ? 1 : -1), 0));
                const Real length = 0.45 * zoom * lambda[i] / largest;
                const bool pulls = length < 0;
                if (std::abs(length) > 0.004)
                    canvas.arrow(p, p + Vec2(0, length),
                                 pulls ? Style{Colour::orange, 2.5, 1}
                                       : paint::impulse);
                paint::row_mark(canvas, p, dot,
                                walk_.guess(i) == BoundState::between,
                                walk_.wrong(i));
                ++i;
            }
        canvas.text({0, -1.0}, walk_.told(), 14, paint::label, Align::centre);
    }

private:
    BoxPile pile_;
    GuessWalk walk_;
    Vec2 reach_ = {0, 0};  ///< half of the width and the height of the pile [m]
};

inline Demo guess_scene()
{
    Demo scene;
    scene.name = "guess";
    scene.summary =
        "Which contacts push? A pile of boxes is hit: each step corrects the guess";
    scene.view = {{0, -0.05}, {1.05, 1.08}};
    scene.h = 0.5;  // half a second for each correction when it plays by itself
    scene.h_low = 0.02;
    scene.h_high = 2;
    scene.methods = {"active_sets", "dantzig", "lemke"};
    scene.side_by_side = {"active_sets", "dantzig"};
    scene.tunables = {
        {"pile",
         "",
         "0 a column, 1 a column of 1 kg and 1000 kg in turns, 2 a pyramid",
         2,
         0,
         2,
         Numbers::whole,
         OnChange::restarts,
         Keys::none,
         {"column", "1 to 1000", "pyramid"}},
        {"levels", "", "boxes in the column, levels of the pyramid", 5, 1, 500,
         Numbers::whole, OnChange::restarts},
        {"jostle", "m/s", "size of the random speeds before the impulses", 1, 0, 5,
         Numbers::real, OnChange::restarts},
        {"at_once", "", "1: all corrections in the first step", 0, 0, 1,
         Numbers::whole, OnChange::restarts}};
    scene.columns = GuessWalk::columns();
    scene.start = [](const Settings& settings) {
        const auto levels = static_cast<Index>(settings["levels"]);
        const auto kind = static_cast<int>(settings["pile"]);
        const Motion motion{9.81 / 60, settings["jostle"], settings.seed};
        if (kind == 2 && levels > 32)
            throw std::invalid_argument("the pyramid has " +
                                        std::to_string(levels) +
                                        " levels; it may have 32 (2048 rows)");
        BoxPile pile =
            kind == 2 ? box_pyramid(levels)
                      : box_column(levels, {.top_mass = kind == 1 ? 1000.0 : 1.0,
                                            .alternate = kind == 1});
        return std::make_unique<GuessRun>(std::move(pile), motion, settings.method,
                                          settings["at_once"] > 0);
    };
    return scene;
}

}  // namespace rigid
