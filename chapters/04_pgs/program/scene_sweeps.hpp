/// \file scene_sweeps.hpp
/// One problem, one sweep per step: the error of each method beside its theory line.
#pragma once

#include "chapters/04_pgs/conjugate_gradients.hpp"
#include "chapters/04_pgs/pgs.hpp"
#include "chapters/04_pgs/program/cold_sweeps.hpp"
#include "chapters/04_pgs/program/drawing.hpp"
#include "chapters/04_pgs/rates.hpp"
#include "common/elementary.hpp"
#include "common/program/program.hpp"

#include <memory>
#include <utility>
#include <vector>

namespace rigid {

/// A column of N discs at rest, whose answer (4.9) and rates (4.12), (4.14), (4.19) are known.
class SweepsRun : public Run {
public:
    explicit SweepsRun(const Settings& settings)
        : method_(settings.method), count_(static_cast<Index>(settings["rows"])),
          end_(settings["end_mass"]), floor_(settings["heavy_low"] != 0),
          omega_(method_ == "sor" ? settings["omega"] : 1),
          mlcp_(line_problem(count_, end_, 9.81 / 60, floor_)),
          exact_(line_answer(count_, end_, 9.81 / 60, floor_)),
          lambda_(VecX::Zero(count_))
    {
        if (method_ == "cg") mlcp_.lo.setConstant(-infinity);
        prepare(
            mlcp_, omega_,
            row_order(count_, static_cast<int>(settings["order"]), settings.seed),
            rows_);
        rows_.lambda.setZero();
        const Real rho = floor_ ? 1 / (1 + end_) : line_rate(count_, end_);
        known_ = !floor_ || count_ == 2;
        if (method_ == "jacobi") rate_ = std::sqrt(rho);
        else if (method_ == "gauss_seidel" || method_ == "sor")
            rate_ = sor_rate(omega_, rho);
        else known_ = false;
        // The share of the slowest mode in a cold start, (4.15); for other end masses the line starts at 1.
        weight_ = end_ == 1 && method_ != "sor" ? slowest_weight(count_) : 1;
        note();
    }

    //! [one_sweep]
    void step(const Settings&, const Input&) override
    {
        ++sweeps_;
        if (method_ == "cg") {
            lambda_.setZero();
            Solution solution{lambda_};
            conjugate_gradients(mlcp_, 0, sweeps_, cg_, solution);
            lambda_ = solution.lambda;
        } else {
            if (method_ == "jacobi") change_ = sweep_jacobi(rows_);
            else if (method_ == "symmetric" && sweeps_ % 2 == 0)
                change_ = sweep_backward(rows_);
            else change_ = sweep_forward(rows_);
            for (Index i = 0; i < count_; ++i)
                lambda_[i] =
                    rows_.lambda[rows_.place_of[static_cast<std::size_t>(i)]];
        }
        if (!lambda_.allFinite())
            throw StepFailure("the impulses grew beyond all numbers");
        note();
    }
    //! [one_sweep]

    std::vector<Real> measure() const override
    {
        return {static_cast<Real>(sweeps_),
                errors_.back(),
                theory_.back(),
                residuals_.back(),
                change_,
                merit_,
                ratio_,
                known_ ? rate_ : 0};
    }

    void draw(Canvas& canvas) const override
    {
        draw_column(canvas);
        const Real smallest = std::min(errors_.back(), residuals_.back());
        const int low =
            smallest > 1e-3
                ? -3
                : std::max(-15, static_cast<int>(std::floor(log10(smallest))));
        const Real last = std::max(Real{20}, static_cast<Real>(sweeps_) * 1.15);
        paint::LogChart chart(canvas, {-0.45, -0.5}, {1.4, 1.0}, low, 1, last);
        chart.dots(residuals_, paint::residual);
        chart.dots(errors_, paint::error);
        if (known_)
            chart.line({theory_.front(), weight_ * pow(rate_, last)}, last,
                       paint::theory);
        canvas.text({0.25, -0.64}, "sweeps", 14, paint::label, Align::centre);
        canvas.text({-0.45, 0.545}, "● error / largest λ", 14, paint::error);
        canvas.text({0.05, 0.545}, "● residual [m/s]", 14, paint::residual);
        if (known_)
            canvas.text({0.95, 0.43}, "– – theory: × " + fixed(rate_, 6), 14,
                        paint::label, Align::right);
    }

private:
    void note()
    {
        const Real error = (lambda_ - exact_).lpNorm<Eigen::Infinity>() /
                           exact_.lpNorm<Eigen::Infinity>();
        ratio_ = sweeps_ > 0 && errors_.back() > 0 ? error / errors_.back() : 0;
        errors_.push_back(error);
        residuals_.push_back(natural_residual(mlcp_, lambda_));
        theory_.push_back(known_ ? weight_ * pow(rate_, sweeps_) : 0);
        // What is left of the merit above its minimum, in J·kg/kg: ½ eᵀAe.
        const VecX e = lambda_ - exact_;
        merit_ = 0.5 * e.dot(mlcp_.A * e);
    }

    /// The discs, with the impulse at each contact as a bar: wanted (outline) and found (filled).
    void draw_column(Canvas& canvas) const
    {
        const Real height = 1.0 / static_cast<Real>(count_),
                   radius = std::min(0.08, 0.45 * height);
        const Real unit = 0.38 / exact_.lpNorm<Eigen::Infinity>();
        canvas.segment({-1.32, -0.5}, {-0.62, -0.5}, paint::wall);
        for (Index k = 0; k < count_; ++k) {
            const Real y = -0.5 + height * static_cast<Real>(k);
            Style body = paint::body;
            if (k == (floor_ ? 0 : count_ - 1) && end_ != 1) body.opacity = 0.75;
            canvas.disc({-1.22, y + height / 2}, radius, body);
            const Real bar = std::min(0.012, 0.2 * height);
            canvas.box({-1.08 + unit * exact_[k] / 2, y},
                       {unit * exact_[k] / 2, bar}, 0, {Colour::ink, 1, 1});
            canvas.box({-1.08 + unit * lambda_[k] / 2, y},
                       {std::abs(unit * lambda_[k]) / 2, bar}, 0,
                       {Colour::red, 0, 0.8, Paint::filled});
        }
        canvas.text({-1.34, 0.545}, "λ: red found, outline wanted", 13,
                    paint::label);
    }

    std::string method_;
    Index count_;
    Real end_;
    bool floor_;
    Real omega_;
    Mlcp mlcp_;
    VecX exact_, lambda_;
    SweepRows rows_;
    CgMemory cg_;
    int sweeps_ = 0;
    bool known_ = true;
    Real rate_ = 0, weight_ = 1, change_ = 0, ratio_ = 0, merit_ = 0;
    std::vector<Real> errors_, residuals_, theory_;
};

inline Demo sweeps_scene()
{
    Demo scene;
    scene.name = "sweeps";
    scene.summary = "One sweep per step on a column at rest: error and residual "
                    "beside the theory line";
    scene.view = {{-0.18, -0.03}, {1.22, 0.68}};
    scene.h = scene.h_low = scene.h_high = 1.0 / 60;
    scene.methods = {"gauss_seidel", "jacobi", "sor", "symmetric", "cg"};
    scene.tunables = {{"rows", "", "N, contacts in the column", 10, 2, 100,
                       Numbers::whole, OnChange::restarts},
                      {"end_mass", "kg",
                       "mass of the uppermost disc; the others have 1 kg", 1, 0.01,
                       10000, Numbers::real, OnChange::restarts},
                      {"heavy_low", "", "1 puts that mass at the floor instead", 0,
                       0, 1, Numbers::whole, OnChange::restarts},
                      {"omega", "", "relaxation of method sor", 1.5, 0.05, 1.95,
                       Numbers::real, OnChange::restarts},
                      {"order",
                       "",
                       "order of the visits: 0 bottom-up, 1 top-down, 2 shuffled",
                       0,
                       0,
                       2,
                       Numbers::whole,
                       OnChange::restarts,
                       Keys::none,
                       {"bottom-up", "top-down", "shuffled"}}};
    scene.columns = {
        {"sweeps", "", "sweeps so far"},
        {"error", "", "largest error of a λ, relative to the largest λ",
         Plot::logarithmic},
        {"theory", "", "what (4.15) says; 0 where it does not", Plot::logarithmic,
         "error"},
        {"residual", "m/s", "natural residual", Plot::logarithmic},
        {"change", "m/s", "largest change in the sweep, as a velocity",
         Plot::logarithmic},
        {"merit", "J", "merit above its lowest value", Plot::logarithmic},
        {"ratio", "", "error after this sweep / error before it", Plot::linear},
        {"rate", "", "what theory says to that; 0 where it does not", Plot::linear,
         "ratio"}};
    scene.start = [](const Settings& settings) {
        return std::make_unique<SweepsRun>(settings);
    };
    return scene;
}

}  // namespace rigid
