/// \file scene_stick_slip.hpp
/// A block on a belt, held back by a spring: it sticks and slips by turns.
#pragma once

#include "chapters/13_friction/program/scenes.hpp"
#include "chapters/13_friction/stick_slip.hpp"

namespace rigid {

/// The spring from a post on the left to the block, with eight coils.
inline void paint_spring(Canvas& canvas, const Vec2& from, const Vec2& to)
{
    std::vector<Vec2> line = {from};
    const Vec2 along = (to - from) / 18;
    for (int i = 1; i <= 16; ++i)
        line.push_back(from + (i + 0.5) * along +
                       (i % 2 == 1 ? 0.05 : -0.05) * Vec2(0, 1));
    line.push_back(to);
    canvas.polyline(line, {Colour::faint, 1.5, 1});
}

inline Demo stick_slip_scene()
{
    Demo scene = friction_demo(
        "stick_slip",
        "A block on a belt and a spring: it sticks, slips, and sticks again",
        {{-0.15, 0.22}, {0.75, 0.5}}, [](const Settings& settings) {
            StickSlip block;
            block.stiffness = settings["stiffness"];
            block.mu_s = settings["mu_s"];
            block.mu_k = std::min(settings["mu_k"], block.mu_s);
            block.belt = settings["belt"];
            const StickSlipByHand hand(block);
            FrictionSetup setup;
            setup.scene = block_on_belt(block);
            setup.measure = [block,
                             hand](const FrictionState& s) -> std::vector<Real> {
                return {s.scene.bodies.x[0], hand.stretch(block, s.t),
                        s.scene.bodies.u[0], s.impulse(tangent_part) / s.h};
            };
            setup.picture = [hand](Canvas& canvas, const FrictionState& s) {
                const Vec2 centre = s.scene.bodies.position(0).head<2>();
                const Vec2 post(-0.8, 0.1);
                canvas.segment({-0.8, 0}, {-0.8, 0.25}, paint::wall);
                paint_spring(canvas, post, {centre.x() - 0.2, 0.1});
                // from where it slips, and where sliding friction holds the spring
                for (const auto& [x, name] :
                     {std::pair{hand.balance + hand.beyond, "slips"},
                      std::pair{hand.balance, "balance"}}) {
                    const bool right = x > hand.balance;
                    const Real high = right ? 0.42 : 0.32;
                    canvas.segment({x, 0}, {x, high},
                                   {Colour::green, 1.5, 1, Paint::dashed});
                    canvas.text({x + (right ? 0.01 : -0.01), high - 0.02}, name, 14,
                                paint::label, right ? Align::left : Align::right);
                }
                canvas.disc(centre, 0.012, {Colour::red, 1, 1, Paint::filled});
            };
            return setup;
        });
    scene.h = 1.0 / 960;
    scene.tunables.push_back({"mu_s", "", "of what holds", 0.6, 0, 2, Numbers::real,
                              OnChange::restarts});
    scene.tunables.push_back({"mu_k", "", "of what slides, at most mu_s", 0.4, 0, 2,
                              Numbers::real, OnChange::restarts});
    scene.tunables.push_back({"stiffness", "N/m", "of the spring", 40, 5, 500,
                              Numbers::real, OnChange::restarts});
    scene.tunables.push_back({"belt", "m/s", "speed of the belt to the right", 0.3,
                              0.01, 2, Numbers::real, OnChange::restarts});
    scene.columns = {{"stretch", "m", "of the spring", Plot::linear},
                     {"by_hand", "m", "closed form", Plot::linear},
                     {"v", "m/s", "of the block", Plot::linear},
                     {"friction", "N", "on the block, to the left", Plot::linear}};
    return scene;
}

}  // namespace rigid
