/// \file dam_run.hpp
/// A dam breaks, beside the exact solution; and water runs up a beach.
#pragma once

#include "chapters/29_waves/program/line_run.hpp"
#include "chapters/29_waves/shallow_water.hpp"

namespace rigid {

/// \param taller  so many times as high as it is
inline void paint_water(Canvas& canvas, const ShallowWater& water, Real taller = 1)
{
    std::vector<Vec2> body, surface, ground;
    const Index n = water.cells();
    for (Index i = 0; i < n; ++i) {
        const Real x = water.x_of(i);
        ground.emplace_back(x, taller * water.bed[i]);
        surface.emplace_back(x, taller * std::max(water.level[i], water.bed[i]));
    }
    canvas.polyline(ground, {Colour::ink, 1.5});
    // strips, as painters fill what is convex
    for (std::size_t i = 0; i + 1 < surface.size(); ++i)
        if (surface[i].y() > ground[i].y() + 1e-4 ||
            surface[i + 1].y() > ground[i + 1].y() + 1e-4)
            canvas.polygon({ground[i], ground[i + 1], surface[i + 1], surface[i]},
                           {Colour::blue, 0, 0.25, Paint::filled});
    canvas.polyline(surface, {Colour::blue, 2});
}

class DamRun : public Run {
public:
    explicit DamRun(const Settings& settings)
        : water_(static_cast<Index>(settings["cells"]), 20, 0),
          right_(settings["ahead"])
    {
        water_.origin = -10;
        const Real slope = settings["beach"];
        for (Index i = 0; i < water_.cells(); ++i) {
            const Real x = water_.x_of(i);
            water_.bed[i] = std::max(0.0, slope * (x - 3));
            const Real level = x < 0 ? 1 : right_;
            water_.depth[i] = std::max(0.0, level - water_.bed[i]);
        }
        level_water(water_);
        volume_ = volume(water_);
        exact_ = slope == 0 && right_ < 1;
    }

    void step(const Settings& settings, const Input&) override
    {
        for (Real left = settings.h; left > 0;) {
            const Real most = 0.5 * stable_step(water_);
            const Real h = left <= most ? left : std::max(most, 1e-6);
            rigid::step(water_, std::min(h, left));
            left -= h;
        }
        t_ += settings.h;
    }

    std::vector<Real> measure() const override
    {
        Real error = 0;
        for (Index i = 0; i < water_.cells() && is_known(); ++i)
            error += water_.dx * std::abs(water_.depth[i] - exact(i).depth);
        return {error, volume(water_) / volume_ - 1, energy(water_)};
    }

    void draw(Canvas& canvas) const override
    {
        paint_water(canvas, water_, 4);
        std::vector<Vec2> wanted;
        for (Index i = 0; i < water_.cells() && is_known(); ++i)
            wanted.emplace_back(water_.x_of(i), 4 * exact(i).depth);
        if (!wanted.empty())
            canvas.polyline(wanted, {Colour::red, 1.5, 1, Paint::dashed});
        canvas.text({9.8, 4.6}, "heights × 4", 14, {Colour::ink}, Align::right);
        if (!is_known()) return;
        canvas.polyline({{0, 0}, {0, 4}}, {Colour::ink, 1.2, 0.8, Paint::dashed});
        canvas.text({0.1, 4.1}, "the dam stood here", 14, {Colour::ink});
        if (right_ > 0) return;
        const Real front = 2 * std::sqrt(water_.g) * t_;  // of 1 m, on dry ground
        canvas.text({front, 0.3}, "2√(gH) t", 14, {Colour::red});
    }

private:
    /// Until something comes to a wall.
    bool is_known() const { return exact_ && t_ > 0 && t_ < 1.6; }
    DamBreak exact(Index i) const
    {
        return dam_break(1, right_, water_.g, water_.x_of(i), t_);
    }

    ShallowWater water_;
    Real right_, t_ = 0, volume_ = 1;
    bool exact_ = false;
};

inline Demo dam_demo()
{
    Demo scene;
    scene.name = "dam";
    scene.summary = "A dam breaks; dashed, the exact solution";
    scene.view = {{0, 2.4}, {10.3, 2.9}};
    scene.h = 1.0 / 60;
    scene.methods = {"columns"};
    scene.tunables = {
        wave_number("cells", "", "columns of water", 400, 20, 4000, Numbers::whole),
        wave_number("ahead", "m", "depth before the dam", 0, 0, 2),
        wave_number("beach", "", "slope of the ground from 3 m on", 0, 0, 1)};
    scene.columns = {
        {"error", "m²", "against Ritter or Stoker, to 1.6 s", Plot::logarithmic},
        {"lost", "", "part of the water that was lost"},
        {"energy", "J", "of the water", Plot::linear}};
    scene.start = [](const Settings& settings) {
        return std::make_unique<DamRun>(settings);
    };
    return scene;
}

}  // namespace rigid
