/// \file basin_run.hpp
/// A round dam breaks in a basin with an island, seen from before and above; the pointer presses the water.
#pragma once

#include "chapters/29_waves/program/line_run.hpp"
#include "chapters/29_waves/water_field.hpp"

namespace rigid {

class BasinRun : public Run {
public:
    explicit BasinRun(const Settings& settings)
        : water_(static_cast<Index>(settings["cells"]),
                 static_cast<Index>(settings["cells"]), 4 / settings["cells"], 0)
    {
        for (Index j = 0; j < water_.ny; ++j)
            for (Index i = 0; i < water_.nx; ++i) {
                const Vec2 at = water_.middle_of(i, j);
                const Real off = (at - Vec2(2.9, 1.4)).squaredNorm() / 0.36;
                const Index k = water_.at(i, j);
                water_.bed[k] =
                    settings["island"] * std::max(0.0, 1 - off) * (1 + off);
                const Real level =
                    (at - Vec2(1.5, 2.5)).norm() < 0.6 ? 2 * still : still;
                water_.depth[k] = std::max(0.0, level - water_.bed[k]);
            }
        volume_ = volume(water_);
        energy_ = energy(water_);
    }

    void step(const Settings& settings, const Input& input) override
    {
        const Vec2 at = input.pressed ? place_of(input.pointer) : Vec2(-1, -1);
        const bool pressed = at.minCoeff() >= 0 && at.maxCoeff() <= 4;
        for (Real left = settings.h; left > 0;) {
            const Real h = std::min(left, 0.9 * stable_step(water_));
            if (pressed) press(water_, at, 0.4, 0.1, h);
            const Real taken = std::min(h, stable_step(water_));
            rigid::step(water_, taken);
            left -= taken;
        }
    }

    std::vector<Real> measure() const override
    {
        const Index k = water_.at(water_.nx / 2, water_.ny / 2);
        return {water_.bed[k] + water_.depth[k] - still,
                volume(water_) / volume_ - 1, energy(water_) / energy_};
    }

    void draw(Canvas& canvas) const override
    {
        canvas.polyline({picture_of(0, 0, still), picture_of(4, 0, still),
                         picture_of(4, 4, still), picture_of(0, 4, still),
                         picture_of(0, 0, still)},
                        {Colour::faint, 1});
        // a line for some of the rows, of ground where it is dry
        const Index skip = std::max<Index>(1, water_.ny / 48);
        for (Index j = water_.ny - 1; j >= 0; j -= skip) {
            const Real far = static_cast<Real>(j) / static_cast<Real>(water_.ny);
            std::vector<Vec2> line;
            bool wet = true;
            const auto end_line = [&] {
                if (line.size() > 1)
                    canvas.polyline(line, {wet ? Colour::blue : Colour::ink,
                                           1.4 - 0.6 * far, 1 - 0.5 * far});
                if (!line.empty()) line = {line.back()};
            };
            for (Index i = 0; i < water_.nx; ++i) {
                const Index k = water_.at(i, j);
                const Vec2 at = water_.middle_of(i, j);
                const bool is_wet = water_.depth[k] > 1e-4;
                if (is_wet != wet) end_line(), wet = is_wet;
                line.push_back(
                    picture_of(at.x(), at.y(), water_.bed[k] + water_.depth[k]));
            }
            end_line();
        }
    }

private:
    static Vec2 picture_of(Real x, Real y, Real height)
    {
        return {(x - 2) + 0.35 * (y - 2), 0.45 * (y - 2) + 0.8 * (height - still)};
    }
    static Vec2 place_of(const Vec2& p)  ///< on the level of rest
    {
        const Real y = p.y() / 0.45;
        return {p.x() - 0.35 * y + 2, y + 2};
    }

    static constexpr Real still = 0.4;  ///< depth away from the island [m]
    WaterField water_;
    Real volume_ = 1, energy_ = 1;
};

inline Demo basin_demo()
{
    Demo scene;
    scene.name = "basin";
    scene.summary = "A round dam breaks beside an island; press the water";
    scene.view = {{0, 0.05}, {2.9, 1.6}};
    scene.h = 1.0 / 120;
    scene.held = "presses the water";
    scene.methods = {"columns"};
    scene.tunables = {
        wave_number("cells", "", "columns each way", 96, 8, 400, Numbers::whole),
        wave_number("island", "m", "height of the island", 0.7, 0, 1)};
    scene.columns = {{"middle", "m", "height of the middle above the level of rest",
                      Plot::linear},
                     {"lost", "", "part of the water that was lost"},
                     {"energy", "", "over that of the start", Plot::linear}};
    scene.start = [](const Settings& settings) {
        return std::make_unique<BasinRun>(settings);
    };
    return scene;
}

}  // namespace rigid
