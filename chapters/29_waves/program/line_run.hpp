/// \file line_run.hpp
/// A string under leapfrog, under the implicit steps and in sines, beside its exact wave.
#pragma once

#include "chapters/29_waves/spectral.hpp"
#include "common/elementary.hpp"
#include "common/program/demo_of.hpp"

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace rigid {

inline Tunable wave_number(const char* name, const char* unit, const char* help,
                           Real value, Real low, Real high,
                           Numbers numbers = Numbers::real)
{
    return {name, unit, help, value, low, high, numbers, OnChange::restarts};
}

class LineRun : public Run {
public:
    explicit LineRun(const Settings& settings)
        : line_(Index{1} << static_cast<Index>(settings["doublings"]), 4, 1),
          width_(settings["width"]), h_(settings["courant"] * line_.dx / line_.c),
          method_(settings.method)
    {
        const auto ends = static_cast<int>(settings["ends"]);
        if (method_ == "sines" && ends != 0)
            throw std::invalid_argument(
                "sines need fixed ends; set ends to 0, or take another method");
        line_.left = line_.right = ends == 0   ? LineEnd::fixed
                                   : ends == 1 ? LineEnd::free
                                               : LineEnd::open;
        const Index N = line_.intervals();
        for (Index i = 1; i < N; ++i)
            line_.y[i] = start_at(line_.dx * static_cast<Real>(i));
        if (method_ == "leapfrog") {
            h_ = std::min(h_, line_.dx / line_.c);  // (29.6)
            start_leapfrog(line_, h_);
        }
        if (method_ == "sines")
            sines_.emplace(line_, h_, SpectralStep::Of::equation);
        energy_ = energy_now();
    }

    void step(const Settings& settings, const Input& input) override
    {
        const auto steps = static_cast<int>(settings["steps"]);
        for (int n = 0; n < steps; ++n) {
            if (method_ == "leapfrog") leapfrog(line_, h_);
            else if (method_ == "trapezoidal") theta_step(line_, h_, 0.5, memory_);
            else if (method_ == "implicit") theta_step(line_, h_, 1, memory_);
            else sines_->step(line_);
            t_ += h_;
        }
        if (input.pressed) pluck(input.pointer);
        if (!line_.y.allFinite()) throw StepFailure("the string is not finite");
    }

    std::vector<Real> measure() const override
    {
        Real worst = 0;
        for (Index i = 0; i <= line_.intervals() && !touched_; ++i)
            worst = std::max(worst, std::abs(line_.y[i] - exact(i)));
        return {line_.y[line_.intervals() / 4], worst, energy_now() / energy_, t_};
    }

    void draw(Canvas& canvas) const override
    {
        std::vector<Vec2> places, wanted;
        for (Index i = 0; i <= line_.intervals(); ++i) {
            const Real x = line_.dx * static_cast<Real>(i) - 2;
            places.emplace_back(x, line_.y[i]);
            if (!touched_ && line_.left == LineEnd::fixed)
                wanted.emplace_back(x, exact(i));
        }
        canvas.segment({-2, 0}, {2, 0}, {Colour::faint, 1});
        if (!wanted.empty())
            canvas.polyline(wanted, {Colour::ink, 1.2, 0.8, Paint::dashed});
        canvas.polyline(places, {Colour::blue, 2});
        if (line_.intervals() <= 64)
            for (const Vec2& p : places)
                canvas.disc(p, 0.02, {Colour::blue, 1, 1, Paint::filled});
    }

private:
    Real start_at(Real x) const
    {
        const Real s = (x - 1) / width_;
        return s * s < 1 ? 0.5 * (1 - s * s) * (1 - s * s) * (1 - s * s) : 0;
    }
    /// d'Alembert: half of the start to either side, mirrored upside down at both ends.
    Real exact(Index i) const
    {
        const Real L = line_.length();
        const auto odd = [&](Real x) {
            x -= 2 * L * std::floor(x / (2 * L));
            return x <= L ? start_at(x) : -start_at(2 * L - x);
        };
        const Real x = line_.dx * static_cast<Real>(i);
        return (odd(x - line_.c * t_) + odd(x + line_.c * t_)) / 2;
    }
    Real energy_now() const
    {
        return method_ == "leapfrog" ? leapfrog_energy(line_, h_)
                                     : wave_energy(line_);
    }
    void pluck(const Vec2& at)
    {
        touched_ = true;
        for (Index i = 1; i < line_.intervals(); ++i) {
            const Real s = (line_.dx * static_cast<Real>(i) - 2 - at.x()) / 0.3;
            const Real near = std::max(1 - s * s, 0.0);
            line_.y[i] += 0.2 * near * near * (at.y() - line_.y[i]);
        }
    }

    WaveLine line_;
    Real width_, h_, t_ = 0, energy_ = 1;
    std::string method_;
    ThetaMemory memory_;
    std::optional<SpectralStep> sines_;
    bool touched_ = false;
};

inline Demo string_demo()
{
    Demo scene;
    scene.name = "string";
    scene.summary = "A pluck runs along a string; pull at it";
    scene.view = {{0, 0}, {2.3, 0.9}};
    scene.held = "pulls the string";
    scene.methods = {"leapfrog", "trapezoidal", "implicit", "sines"};
    scene.side_by_side = {"leapfrog", "trapezoidal"};
    scene.tunables = {
        wave_number("doublings", "", "2 to this power intervals", 6, 2, 12,
                    Numbers::whole),
        wave_number("courant", "", "C = c h/Δx; leapfrog takes at most 1", 0.5,
                    0.01, 20),
        wave_number("width", "m", "half the width of the pluck", 0.3, 0.01, 1),
        wave_number("ends", "", "0 fixed, 1 free, 2 open", 0, 0, 2, Numbers::whole),
        {"steps", "", "steps of C Δx/c a picture", 1, 1, 100, Numbers::whole}};
    scene.tunables[3].names = {"fixed", "free", "open"};
    scene.columns = {
        {"y", "m", "a quarter of the way along", Plot::linear},
        {"error", "m", "the largest, with fixed ends", Plot::logarithmic},
        {"energy", "", "over that of the start", Plot::linear},
        {"time", "s", "of the string"}};
    scene.start = [](const Settings& settings) {
        return std::make_unique<LineRun>(settings);
    };
    return scene;
}

}  // namespace rigid
