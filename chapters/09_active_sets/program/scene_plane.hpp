/// \file scene_plane.hpp
/// Two rows: the plane of λ, the lines w₁ = 0 and w₂ = 0, and the four guesses, each of which has one answer.
#pragma once

#include "chapters/05_lemke/families.hpp"
#include "chapters/09_active_sets/program/guess_run.hpp"
#include "common/text.hpp"

#include <array>

namespace rigid {

class GuessPlaneRun : public Run {
public:
    explicit GuessPlaneRun(const Settings& settings)
        : walk_(problem(settings), settings.method,
                set_of(static_cast<int>(settings["start"])))
    {
        const MatX A(walk_.problem.A);
        const VecX& q = walk_.problem.q;
        answers_[1] = Vec2(-q[0] / A(0, 0), 0);
        answers_[2] = Vec2(0, -q[1] / A(1, 1));
        answers_[3] = -A.partialPivLu().solve(q);
        for (const Vec2& answer : answers_) {
            low_ = low_.cwiseMin(answer);
            high_ = high_.cwiseMax(answer);
        }
        const Real reach = std::max({(high_ - low_).maxCoeff(), Real{1}});
        unit_ = 1.35 / reach;
        origin_ = -unit_ * (low_ + high_) / 2;
        visited_.push_back(guess());
    }

    void step(const Settings&, const Input&) override
    {
        walk_.step();
        if (guess() != visited_.back()) visited_.push_back(guess());
    }
    std::vector<Real> measure() const override { return walk_.measure(); }

    void draw(Canvas& canvas) const override
    {
        const auto shown = [&](const Vec2& p) { return Vec2(origin_ + unit_ * p); };
        const Vec2 corner(0.95, 0.95);
        // Where both λ may be.
        const Vec2 zero = shown({0, 0});
        canvas.polygon(
            {zero, {corner.x(), zero.y()}, corner, {zero.x(), corner.y()}},
            {Colour::green, 0, 0.12, Paint::filled});
        canvas.arrow({-corner.x(), zero.y()}, {corner.x() + 0.03, zero.y()},
                     paint::axis);
        canvas.arrow({zero.x(), -corner.y()}, {zero.x(), corner.y() + 0.03},
                     paint::axis);
        canvas.text({corner.x() + 0.02, zero.y() - 0.09}, "λ₁ [N s]", 13,
                    paint::label, Align::right);
        canvas.text({zero.x() - 0.04, corner.y()}, "λ₂ [N s]", 13, paint::label,
                    Align::right);
        draw_line(canvas, 0, {Colour::purple, 1.5, 1}, "w₁ = 0");
        draw_line(canvas, 1, {Colour::green, 1.5, 1}, "w₂ = 0");

        for (std::size_t k = 1; k < visited_.size(); ++k)
            canvas.arrow(shown(answers_[visited_[k - 1]]),
                         shown(answers_[visited_[k]]), paint::impulse);
        static const std::array<std::string, 4> names = {"none", "row 1", "row 2",
                                                         "both"};
        for (std::size_t k = 0; k < answers_.size(); ++k) {
            const Vec2 p = shown(answers_[k]);
            const bool here = k == visited_.back();
            canvas.disc(p, here ? 0.035 : 0.02,
                        {here ? Colour::red : Colour::ink, 1.5, 1,
                         here ? Paint::filled : Paint::outline});
            const bool left = k == 0 || p.x() < zero.x() - 0.01;
            const Vec2 beside(left ? -0.05 : 0.05, k == 0 ? -0.09 : 0.045);
            canvas.text(p + beside, names[k] + complaint(k), 13,
                        {here ? Colour::red : Colour::ink, 1, 1},
                        left ? Align::right : Align::left);
        }
        canvas.text({0, -1.07}, walk_.told(), 14, paint::label, Align::centre);
    }

private:
    static Mlcp problem(const Settings& settings)
    {
        MatX A(2, 2);
        A << settings["a11"], settings["a12"], settings["a12"], settings["a22"];
        VecX q(2);
        q << settings["q1"], settings["q2"];
        if (!(A.determinant() > 0))
            throw std::invalid_argument(
                "a11 a22 - a12^2 is " + shortest(A.determinant()) +
                "; it must be positive, else A is not positive definite");
        return plain_lcp(A, q);
    }

    static std::vector<BoundState> set_of(int number)
    {
        const auto active = [number](int row) {
            return (number >> row) % 2 == 1 ? BoundState::between
                                            : BoundState::at_lo;
        };
        return {active(0), active(1)};
    }

    /// 0 none, 1 row one, 2 row two, 3 both.
    std::size_t guess() const
    {
        return (walk_.guess(0) == BoundState::between ? 1U : 0U) +
               (walk_.guess(1) == BoundState::between ? 2U : 0U);
    }

    /// What a guess gets wrong.
    std::string complaint(std::size_t k) const
    {
        const VecX w = walk_.problem.A * VecX(answers_[k]) + walk_.problem.q;
        std::string text;
        for (Index i = 0; i < 2; ++i) {
            const std::string number = i == 0 ? "₁" : "₂";
            const bool active = (k >> i) % 2 == 1;
            if (active && answers_[k][i] < 0)
                text += (text.empty() ? ": λ" : ", λ") + number + " < 0";
            if (!active && w[i] < -1e-12)
                text += (text.empty() ? ": w" : ", w") + number + " < 0";
        }
        return text.empty() ? ": right" : text;
    }

    /// w_i = 0 within the picture, and its name where it leaves it.
    void draw_line(Canvas& canvas, Index i, const Style& style,
                   const std::string& name) const
    {
        const Vec2 a(walk_.problem.A.coeff(i, 0), walk_.problem.A.coeff(i, 1));
        const Vec2 n = a.normalized(), along = perpendicular(n);
        const Vec2 middle = origin_ - unit_ * n * (walk_.problem.q[i] / a.norm());
        Real from = -10, to = 10;  // how far the picture goes on both sides
        for (Index axis = 0; axis < 2; ++axis) {
            if (std::abs(along[axis]) < 1e-9) continue;
            const Real first = (-0.95 - middle[axis]) / along[axis],
                       second = (0.95 - middle[axis]) / along[axis];
            from = std::max(from, std::min(first, second));
            to = std::min(to, std::max(first, second));
        }
        if (from >= to) return;
        canvas.segment(middle + from * along, middle + to * along, style);
        const Vec2 high =
            along.y() > 0 ? Vec2(middle + to * along) : Vec2(middle + from * along);
        canvas.text(high + Vec2(0, 0.03), name, 13, style, Align::centre);
    }

    GuessWalk walk_;
    std::array<Vec2, 4> answers_ = {Vec2(0, 0), Vec2(0, 0), Vec2(0, 0), Vec2(0, 0)};
    std::vector<std::size_t> visited_;
    Vec2 low_ = {0, 0}, high_ = {0, 0}, origin_ = {0, 0};
    Real unit_ = 1;
};

inline Demo plane_scene()
{
    Demo scene;
    scene.name = "plane";
    scene.summary = "Two rows and their four guesses in the plane of λ: what each "
                    "gets wrong, and the way";
    scene.view = {{-0.12, -0.03}, {1.25, 1.12}};
    scene.h = 1;
    scene.h_low = 0.02;
    scene.h_high = 2;
    scene.methods = {"active_sets"};
    scene.tunables = {
        {"start",
         "",
         "the first guess: 0 none, 1 row 1, 2 row 2, 3 both",
         3,
         0,
         3,
         Numbers::whole,
         OnChange::restarts,
         Keys::none,
         {"none", "row 1", "row 2", "both"}},
        {"a11", "1/kg", "of A, row 1", 2, 0.5, 4, Numbers::real,
         OnChange::restarts},
        {"a22", "1/kg", "of A, row 2", 2, 0.5, 4, Numbers::real,
         OnChange::restarts},
        {"a12", "1/kg", "of A, off its diagonal", 1, -3, 3, Numbers::real,
         OnChange::restarts},
        {"q1", "m/s", "of q, row 1", -5, -6, 6, Numbers::real, OnChange::restarts},
        {"q2", "m/s", "of q, row 2", -1, -6, 6, Numbers::real, OnChange::restarts}};
    scene.columns = GuessWalk::columns();
    scene.start = [](const Settings& settings) {
        return std::make_unique<GuessPlaneRun>(settings);
    };
    return scene;
}

}  // namespace rigid
