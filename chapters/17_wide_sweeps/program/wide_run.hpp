/// \file wide_run.hpp
/// One scene under the sweeps of chapter 13 and those of this one.
#pragma once

#include "chapters/11_rotation/program/turning_run.hpp"
#include "chapters/17_wide_sweeps/waits.hpp"
#include "chapters/17_wide_sweeps/wide_method.hpp"

#include <array>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace rigid {

/// Sweeps in the order of the rows, and wide ones in doubles and in floats.
class WideRun : public Run {
public:
    WideRun(JointedScene scene, const Settings& settings) : scene_(std::move(scene))
    {
        start_ = scene_.bodies.x;
        method_ = settings.method;
        given_.correction = steady_contacts();
    }

    void step(const Settings& settings, const Input& input) override
    {
        const StepSettings how = step_settings(settings, input, scene_.bodies);
        const auto take = [&](auto& method) {
            method.solver.sweeps.max_sweeps = static_cast<int>(settings["sweeps"]);
            rigid::step(scene_, how, method, now_);
        };
        const bool careless = settings["colours"] < 1;
        method_ = settings.method;
        if (method_ == "given") take(given_);
        else if (method_ == "floats") {
            floats_.solver.careless = careless;
            take(floats_);
        } else {
            wide_.solver.careless = careless;
            wide_.solver.threads = static_cast<int>(settings["threads"]);
            take(wide_);
        }
        require_finite_state(scene_.bodies);
        look_at_rows();
    }

    std::vector<Real> measure() const override
    {
        Real moved = 0;
        for (Index k = 0; k < scene_.bodies.count(); ++k)
            moved = std::max(moved,
                             (scene_.bodies.x - start_).segment<2>(3 * k).norm());
        return {moved, residual_, static_cast<Real>(chain_),
                static_cast<Real>(bundles_.colours)};
    }

    void draw(Canvas& canvas) const override
    {
        constexpr std::array hues = {Colour::blue,  Colour::orange,
                                     Colour::green, Colour::purple,
                                     Colour::red,   Colour::yellow};
        for (const HalfSpace& wall : scene_.walls) {
            const Vec2 middle = wall.normal * wall.offset,
                       along = 60 * perpendicular(wall.normal);
            canvas.segment(middle - along, middle + along, paint::wall);
        }
        for (Index k = 0; k < scene_.bodies.count(); ++k)
            paint_rigid_body(canvas, scene_, k);
        for (std::size_t i = 0; i < now_.sources.size(); ++i) {
            const Source& source = now_.sources[i];
            if (source.of != Source::Of::contact || source.part != normal_part ||
                i >= bundles_.of_row.size())
                continue;
            const Contact& contact =
                now_.contacts[static_cast<std::size_t>(source.index)];
            const int colour =
                bundles_.colour[static_cast<std::size_t>(bundles_.of_row[i])];
            const Style style = {
                method_ == "given" || colour < 0
                    ? Colour::faint
                    : hues[static_cast<std::size_t>(colour) % hues.size()],
                2.5, 1};
            canvas.segment(scene_.bodies.position(contact.b).head<2>(),
                           contact.point, style);
            if (contact.a != world)
                canvas.segment(scene_.bodies.position(contact.a).head<2>(),
                               contact.point, style);
        }
    }

private:
    /// What the rows of this step look like, whatever has solved them.
    void look_at_rows()
    {
        const Index bodies = scene_.bodies.count();
        bundle_rows(now_.rows, bodies, bundles_);
        colour_bundles(now_.rows, bodies, bundles_);
        std::vector<int> order;
        if (method_ != "given") {
            arrange(now_.rows, bodies, bundles_, ordered_);
            order = visiting_order(ordered_);
        }
        chain_ = longest_chain(now_.rows, std::span<const int>(order), bodies);
        residual_ = natural_residual(now_.rows, now_.solution.lambda,
                                     scene_.bodies.u, now_.length);
    }

    JointedScene scene_;
    StepData<3> now_;
    VecX start_;
    std::string method_;
    JointSweeps<Manifolds> given_;
    WideSweeps<Manifolds> wide_;
    WideSweeps<Manifolds, float> floats_;
    Bundles bundles_;
    WideRows<3, Real, 1> ordered_;
    int chain_ = 0;
    Real residual_ = 0;
};

inline Tunable wide_tunable(const char* name, const char* help, Real value,
                            Real low, Real high,
                            OnChange on_change = OnChange::goes_on)
{
    return {name, "", help, value, low, high, Numbers::whole, on_change};
}

inline Demo wide_demo(const std::string& name, const std::string& summary,
                      const View& view,
                      const std::function<JointedScene(const Settings&)>& setup)
{
    Demo scene = turning_demo<WideRun>(name, summary, view, 1.0 / 60,
                                       {"given", "wide", "floats"}, setup);
    scene.side_by_side = {"given", "wide"};
    scene.tunables.push_back(
        wide_tunable("colours", "0: all bundles have one, to break it", 1, 0, 1));
    scene.tunables.push_back(
        wide_tunable("threads", "that share a colour, of wide", 1, 1, 8));
    scene.columns = {
        {"moved", "m", "the body that has moved farthest", Plot::logarithmic},
        {"residual", "m/s", "natural residual after the sweeps", Plot::logarithmic},
        {"chain", "", "longest chain of visits that wait for each other"},
        {"colours", "", "of the bundles"}};
    return scene;
}

}  // namespace rigid
