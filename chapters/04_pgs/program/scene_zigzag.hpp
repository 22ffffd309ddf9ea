/// \file scene_zigzag.hpp
/// Two rows, one visit per step: the path of λ in the plane, over the contours of the merit.
#pragma once

#include "chapters/04_pgs/pgs.hpp"
#include "chapters/04_pgs/program/drawing.hpp"
#include "common/elementary.hpp"
#include "common/program/program.hpp"
#include "common/text.hpp"

#include <Eigen/LU>
#include <array>
#include <memory>
#include <stdexcept>
#include <vector>

namespace rigid {

/// A = (1 c+s; c−s a): symmetric for s = 0. Both λ ≥ 0. The default is (4.2).
class ZigzagRun : public Run {
public:
    explicit ZigzagRun(const Settings& settings)
    {
        restart(settings, Vec2(settings["start_1"], settings["start_2"]));
    }

    //! [one_visit]
    void step(const Settings& settings, const Input& input) override
    {
        if (changed(settings)) restart(settings, path_.front());
        if (input.pressed) restart(settings, input.pointer / zoom_);
        const std::size_t row = visits_++ % 2;
        Vec2 lambda = path_.back();
        if (settings.method == "jacobi") {  // both at once
            VecX both = lambda;
            sweep_jacobi(mlcp_, both, before_, settings["omega"]);
            lambda = both;
        } else {
            const auto i = static_cast<Index>(row);
            lambda[i] = visit(mlcp_, i, path_.back(), settings["omega"]);
        }
        path_.push_back(lambda);
        if (path_.size() > 400) path_.erase(path_.begin() + 1);
        if (!lambda.allFinite())
            throw StepFailure("the impulses grew beyond all numbers");
    }
    //! [one_visit]

    std::vector<Real> measure() const override
    {
        return {path_.back().x(), path_.back().y(), merit(path_.back()),
                natural_residual(mlcp_, path_.back()),
                (path_.back() - answer_).norm()};
    }

    void draw(Canvas& canvas) const override
    {
        // λ ≥ 0 is allowed.
        canvas.polygon({{0, 0}, {R, 0}, {R, R}, {0, R}},
                       {Colour::green, 0, 0.08, Paint::filled});
        if (symmetric_) draw_contours(canvas);
        draw_row(canvas, 0, Colour::purple, "w₁ = 0");
        draw_row(canvas, 1, Colour::green, "w₂ = 0");
        canvas.arrow({-0.5, 0}, {R + 0.2, 0}, paint::axis);
        canvas.arrow({0, -0.5}, {0, R + 0.2}, paint::axis);
        for (int k = 1; zoom_ * k <= R; ++k) {
            const Real at = zoom_ * k;
            canvas.segment({at, 0}, {at, -0.06}, paint::axis);
            canvas.segment({0, at}, {-0.06, at}, paint::axis);
            canvas.text({at, -0.28}, std::to_string(k), 13, paint::label,
                        Align::centre);
            canvas.text({-0.12, at - 0.06}, std::to_string(k), 13, paint::label,
                        Align::right);
        }
        canvas.text({R + 0.2, -0.5}, "λ₁ [N s]", 14, paint::label, Align::right);
        canvas.text({0.15, R + 0.12}, "λ₂ [N s]", 14, paint::label);
        std::vector<Vec2> shown;
        for (const Vec2& p : path_) {
            shown.push_back((zoom_ * p)
                                .cwiseMin(Vec2(R + 0.2, R + 0.2))
                                .cwiseMax(Vec2(-0.5, -0.5)));
            canvas.disc(shown.back(), 0.05, {Colour::blue, 1, 1, Paint::filled});
        }
        canvas.polyline(shown, {Colour::blue, 2, 1});
        canvas.disc(zoom_ * answer_, 0.09, {Colour::red, 2.5, 1});
        canvas.text(zoom_ * answer_ + Vec2(0.14, -0.22), "answer", 14,
                    {Colour::red, 1, 1});
    }

private:
    static constexpr Real R = 5.2;

    static std::string singular(Real coupling, Real a22)
    {
        return "rows 1 and 2 have no single answer: coupling " +
               shortest(coupling) + " and a22 " + shortest(a22) +
               " make the matrix singular";
    }

    bool changed(const Settings& settings) const
    {
        return settings.tunables != tunables_;
    }

    void restart(const Settings& settings, const Vec2& start)
    {
        tunables_ = settings.tunables;
        const Real c = settings["coupling"], s = settings["skew"];
        A_ << 1, c + s, c - s, settings["a22"];
        if (!(A_.determinant() > 1e-6)) throw StepFailure(singular(c, A_(1, 1)));
        q_ << settings["q1"], settings["q2"];
        mlcp_.A = MatX(A_).sparseView();
        mlcp_.q = q_;
        mlcp_.lo = VecX::Zero(2);
        mlcp_.hi = VecX::Constant(2, infinity);
        symmetric_ = s == 0;
        // A positive definite 2×2 problem has one answer: try all four sets of rows that carry something.
        answer_ = Vec2::Zero();
        const Vec2 both = free_answer();
        for (const Vec2& guess :
             {both, Vec2(-q_.x(), 0), Vec2(0, -q_.y() / A_(1, 1)), Vec2(0, 0)})
            if (natural_residual(mlcp_, guess) < 1e-9) answer_ = guess;
        path_ = {start};
        visits_ = 0;
        zoom_ = symmetric_ && std::max(answer_.maxCoeff(), start.maxCoeff()) < 2.2
                    ? 2
                    : 1;
    }

    /// −A⁻¹ q: the answer if both rows were bilateral.
    Vec2 free_answer() const
    {
        return Vec2(A_(0, 1) * q_.y() - A_(1, 1) * q_.x(),
                    A_(1, 0) * q_.x() - q_.y()) /
               A_.determinant();
    }

    Real merit(const Vec2& lambda) const
    {
        return 0.5 * lambda.dot(A_ * lambda) + q_.dot(lambda);
    }

    /// The ellipse of equal merit through each of the first points of the path.
    void draw_contours(Canvas& canvas) const
    {
        const Vec2 lowest = free_answer();
        const Real bottom = merit(lowest), l22 = std::sqrt(A_.determinant());
        for (std::size_t k = 0; k < std::min<std::size_t>(path_.size(), 7); ++k) {
            const Real size =
                std::sqrt(std::max(Real{0}, 2 * (merit(path_[k]) - bottom)));
            // A = L Lᵀ: the circle of radius `size`, through L⁻ᵀ
            std::vector<Vec2> part;
            for (int i = 0; i <= 240; ++i) {
                const Real angle = 2 * pi * i / 240,
                           second = size * sin(angle) / l22;
                const Vec2 p =
                    zoom_ *
                    (lowest + Vec2(size * cos(angle) - A_(0, 1) * second, second));
                const bool inside = p.minCoeff() > -0.5 && p.maxCoeff() < R + 0.2;
                if (inside) part.push_back(p);
                if ((!inside || i == 240) && part.size() > 1)
                    canvas.polyline(part, {Colour::faint, 1, 1});
                if (!inside) part.clear();
            }
        }
    }

    /// The line w_i = 0, as far as the picture shows it.
    void draw_row(Canvas& canvas, Index i, Colour colour,
                  const std::string& name) const
    {
        const Vec2 a = A_.row(i), on = -q_[i] * a / a.squaredNorm(),
                   along = perpendicular(a).normalized();
        std::vector<Vec2> part;
        for (int k = -800; k <= 800; ++k) {
            const Vec2 p = zoom_ * (on + 0.01 * k * along);
            if (p.minCoeff() > -0.5 && p.maxCoeff() < R + 0.2) part.push_back(p);
        }
        if (part.size() < 2) return;
        canvas.polyline({part.front(), part.back()},
                        {colour, 1.5, 1, Paint::dashed});
        const Vec2 end =
            part.front().y() > part.back().y() ? part.front() : part.back();
        const bool right = end.x() > R / 2;
        canvas.text(end + Vec2(right ? -0.15 : 0.15, right ? 0 : 0.1), name, 14,
                    {colour, 1, 1}, right ? Align::right : Align::left);
    }

    TunableValues tunables_;
    Eigen::Matrix2d A_ = Eigen::Matrix2d::Identity();
    Vec2 q_ = Vec2::Zero(), answer_ = Vec2::Zero();
    Mlcp mlcp_;
    VecX before_;  ///< Jacobi's copy
    bool symmetric_ = true;
    std::size_t visits_ = 0;
    Real zoom_ = 1;  ///< units of the picture for one N s
    std::vector<Vec2> path_;
};

inline Demo zigzag_scene()
{
    Demo scene;
    scene.name = "zigzag";
    scene.summary = "Two rows, one visit per step: drag the start and watch the "
                    "path of the impulses";
    scene.view = {{2.45, 2.45}, {3.2, 3.2}};
    scene.h = scene.h_low = scene.h_high = 1.0 / 60;
    scene.methods = {"gauss_seidel", "jacobi"};
    scene.tunables = {
        {"coupling", "1/kg",
         "c: how much one row disturbs the other, both ways alike", -1, -1, 1},
        {"a22", "1/kg", "diagonal entry of row 2; that of row 1 is 1", 2, 1, 4},
        {"skew", "1/kg", "s: the part that is not symmetric, as friction makes it",
         0, -3, 3},
        {"q1", "m/s", "velocity of row 1 before any impulse", -1, -5, 5},
        {"q2", "m/s", "velocity of row 2 before any impulse", 0, -5, 5},
        {"omega", "", "relaxation", 1, 0.05, 1.95},
        {"start_1", "N s", "where row 1 starts", 0, 0, 5, Numbers::real,
         OnChange::restarts},
        {"start_2", "N s", "where row 2 starts", 0, 0, 5, Numbers::real,
         OnChange::restarts}};
    scene.columns = {
        {"lambda_1", "N s", "impulse of row 1", Plot::linear},
        {"lambda_2", "N s", "impulse of row 2", Plot::linear},
        {"merit", "J", "½ λᵀAλ + qᵀλ", Plot::linear},
        {"residual", "m/s", "natural residual", Plot::logarithmic},
        {"error", "N s", "distance from the answer", Plot::logarithmic}};
    scene.start = [](const Settings& settings) {
        try {
            return std::make_unique<ZigzagRun>(settings);
        } catch (const StepFailure& singular) {
            // of settings that were so from the start
            throw std::invalid_argument(singular.what());
        }
    };
    return scene;
}

}  // namespace rigid
