/// \file dispersion_run.hpp
/// Each step measures how fast one more wave is on a string of 32 intervals, beside the closed forms.
#pragma once

#include "chapters/29_waves/program/line_run.hpp"

#include <algorithm>
#include <array>

namespace rigid {

class DispersionRun : public Run {
public:
    explicit DispersionRun(const Settings& settings) : C_(settings["courant"]) {}

    void step(const Settings&, const Input&) override
    {
        if (mode_ < 31) ++mode_;
        const Real dx = 1.0 / 32, h = C_ * dx, k = pi * mode_, ck = k;
        WaveLine line(32, 1, 1);
        for (Index i = 1; i < 32; ++i)
            line.y[i] = sin(k * dx * static_cast<Real>(i));
        WaveLine implicit = line, sines = line;
        start_leapfrog(line, h);
        ThetaMemory memory;
        SpectralStep spectral(sines, h, SpectralStep::Of::equation);
        // from rest, y after a step is y cos ωh; measured where y is large
        const Index loud = loudest(line.y);
        const Real start = line.y[loud];
        leapfrog(line, h);
        theta_step(implicit, h, 0.5, memory);
        spectral.step(sines);
        measured_ = {k * dx / pi};
        for (const WaveLine* after : {&line, &implicit, &sines})
            measured_.push_back(acos(after->y[loud] / start) / h / ck);
        measured_.push_back(leapfrog_frequency(k, 1, dx, h) / ck);
        measured_.push_back(trapezoidal_frequency(k, 1, dx, h) / ck);
        dots_.push_back(measured_);
    }

    std::vector<Real> measure() const override { return measured_; }

    void draw(Canvas& canvas) const override
    {
        canvas.segment({0, 0}, {1, 0}, {Colour::ink, 1});
        canvas.segment({0, 0}, {0, 1.05}, {Colour::ink, 1});
        const std::array colours{Colour::blue, Colour::red, Colour::green};
        for (std::size_t method = 0; method < 3; ++method) {
            std::vector<Vec2> curve;
            for (int i = 1; i <= 64 && method < 2; ++i) {
                const Real k = pi * i / 64, h = C_;
                curve.emplace_back(
                    i / 64.0, (method == 0 ? leapfrog_frequency(k, 1, 1, h)
                                           : trapezoidal_frequency(k, 1, 1, h)) /
                                  k);
            }
            if (method == 2) curve = {{0, 1}, {1, 1}};
            canvas.polyline(curve, {colours[method], 1.5});
            for (const std::vector<Real>& dot : dots_)
                canvas.disc({dot[0], dot[method + 1]}, 0.008,
                            {colours[method], 1, 1, Paint::filled});
        }
        canvas.text({1, -0.06}, "two intervals long", 12, {Colour::ink},
                    Align::right);
        canvas.text({0.02, -0.06}, "long waves", 12, {Colour::ink});
        canvas.text({0.02, 1.08}, "speed over that of the exact wave", 12,
                    {Colour::ink});
        canvas.text({0.4, 0.3}, "green: sines; blue: leapfrog; red: trapezoidal",
                    12, {Colour::ink});
    }

private:
    static Real acos(Real x) { return pi / 2 - asin(std::clamp(x, -1.0, 1.0)); }
    static Index loudest(const VecX& y)
    {
        Index found = 0;
        for (Index i = 1; i < y.size(); ++i)
            if (std::abs(y[i]) > std::abs(y[found])) found = i;
        return found;
    }

    Real C_;
    int mode_ = 0;
    std::vector<Real> measured_ = {0, 1, 1, 1, 1, 1};
    std::vector<std::vector<Real>> dots_;
};

inline Demo dispersion_demo()
{
    Demo scene;
    scene.name = "dispersion";
    scene.summary = "How fast each wave is: dots measured, curves in closed form";
    scene.view = {{0.5, 0.5}, {0.62, 0.66}};
    scene.methods = {"all"};
    scene.tunables = {wave_number("courant", "", "C = c h/Δx", 0.8, 0.05, 1)};
    scene.columns = {{"kdx", "", "k Δx/π: 1 is two intervals long"},
                     {"leapfrog", "", "its speed over c", Plot::linear},
                     {"trapezoidal", "", "its speed over c", Plot::linear},
                     {"sines", "", "its speed over c", Plot::linear},
                     {"leapfrog_exact", "", "by (29.5)"},
                     {"trapezoidal_exact", "", "by (29.10)"}};
    scene.start = [](const Settings& settings) {
        return std::make_unique<DispersionRun>(settings);
    };
    return scene;
}

}  // namespace rigid
