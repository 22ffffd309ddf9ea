/// \file pool_run.hpp
/// A square of water, or a drum, that the pointer touches.
#pragma once

#include "chapters/29_waves/membrane.hpp"
#include "chapters/29_waves/program/line_run.hpp"

namespace rigid {

class PoolRun : public Run {
public:
    explicit PoolRun(const Settings& settings)
        : field_(static_cast<Index>(settings["cells"]),
                 static_cast<Index>(settings["cells"]), 4 / settings["cells"], 1,
                 settings.method == "drum")
    {
        touch(field_, 1.3, 2.4, 0.5, -0.5);
        h_ = 0.7 * field_.dx / field_.c;
        // as many steps as a step of the picture has room for
        h_ = settings.h / std::ceil(settings.h / h_);
        start_leapfrog(field_, h_);
        energy_ = leapfrog_energy(field_, h_);
    }

    void step(const Settings& settings, const Input& input) override
    {
        field_.damping = settings["damping"];
        if (input.pressed) {
            const Vec2 at = field_place(input.pointer);
            if (at.x() >= 0 && at.x() <= 4 && at.y() >= 0 && at.y() <= 4)
                touch(field_, at.x(), at.y(), 0.3, 0.04);
        }
        const auto steps =
            std::max(1, static_cast<int>(std::lround(settings.h / h_)));
        for (int n = 0; n < steps; ++n) leapfrog(field_, h_);
    }

    std::vector<Real> measure() const override
    {
        Real sum = 0;
        for (Index j = 0; j <= field_.ny; ++j)
            for (Index i = 0; i <= field_.nx; ++i)
                sum += field_.y[field_.at(i, j)] * (i % field_.nx == 0 ? 0.5 : 1) *
                       (j % field_.ny == 0 ? 0.5 : 1);
        return {field_.y[field_.at(field_.nx / 2, field_.ny / 2)],
                leapfrog_energy(field_, h_) / energy_, sum * field_.dx * field_.dx};
    }

    void draw(Canvas& canvas) const override
    {
        // a line for each second row, seen from before and above
        const Index skip = std::max<Index>(1, field_.nx / 48);
        for (Index j = field_.ny; j >= 0; j -= skip) {
            std::vector<Vec2> row;
            for (Index i = 0; i <= field_.nx; ++i)
                row.push_back(picture_place(field_.dx * static_cast<Real>(i),
                                            field_.dx * static_cast<Real>(j),
                                            field_.y[field_.at(i, j)]));
            const Real far = static_cast<Real>(j) / static_cast<Real>(field_.ny);
            canvas.polyline(row, {Colour::blue, 1.4 - 0.6 * far, 1 - 0.5 * far});
        }
        canvas.polyline({picture_place(0, 0, 0), picture_place(4, 0, 0),
                         picture_place(4, 4, 0), picture_place(0, 4, 0),
                         picture_place(0, 0, 0)},
                        {Colour::faint, 1});
    }

private:
    static Vec2 picture_place(Real x, Real y, Real height)
    {
        return {(x - 2) + 0.35 * (y - 2), 0.45 * (y - 2) + 0.8 * height};
    }
    static Vec2 field_place(const Vec2& p)
    {
        const Real y = p.y() / 0.45;
        return {p.x() - 0.35 * y + 2, y + 2};
    }

    Membrane field_;
    Real h_ = 0, energy_ = 1;
};

inline Demo pool_demo()
{
    Demo scene;
    scene.name = "pool";
    scene.summary = "A pool and a drum; touch them";
    scene.view = {{0, 0.05}, {2.9, 1.6}};
    scene.held = "presses the surface";
    scene.methods = {"pool", "drum"};
    scene.tunables = {
        wave_number("cells", "", "intervals each way", 96, 8, 400, Numbers::whole),
        {"damping", "1/s", "of the surface", 0, 0, 10}};
    scene.columns = {{"middle", "m", "height of the middle", Plot::linear},
                     {"energy", "", "over that of the start", Plot::linear},
                     {"volume", "m³", "above the level of rest"}};
    scene.start = [](const Settings& settings) {
        return std::make_unique<PoolRun>(settings);
    };
    return scene;
}

}  // namespace rigid
