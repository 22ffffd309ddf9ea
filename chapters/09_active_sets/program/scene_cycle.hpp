/// \file scene_cycle.hpp
/// The three rows of section 9.3: the eight guesses as the corners of a cube, and where flipping all wrong rows (9.5)
/// leads from each.
#pragma once

#include "chapters/05_lemke/families.hpp"
#include "chapters/09_active_sets/dense_llt.hpp"
#include "common/program/program.hpp"

#include <array>

namespace rigid {

class CycleRun : public Run {
public:
    explicit CycleRun(const Settings& settings)
        : now_(static_cast<std::size_t>(settings["start"]))
    {
        MatX A(3, 3);
        A << 8, -4, 6, -4, 3, -2, 6, -2, 6;
        VecX q(3);
        q << 5, -4, 1;
        const Mlcp mlcp = plain_lcp(A, q);
        GuessedProblem problem;
        set_up(mlcp, {}, problem);
        DenseLlt factor;
        factor.load(mlcp);
        for (std::size_t k = 0; k < 8; ++k) {
            Guess guess;
            guess.lambda = guess.w = guess.step = VecX::Zero(3);
            for (std::size_t i = 0; i < 3; ++i)
                guess.cases.push_back((k >> i) % 2 == 1 ? BoundState::between
                                                        : BoundState::at_lo);
            ActiveSetWork work;
            factor.factor(problem, guess.cases, work);
            solve_guess(problem, factor, guess);
            next_[k] = k;
            for (const Index i : guess.wrong) next_[k] ^= std::size_t{1} << i;
            wrong_[k] = guess.wrong.size();
        }
        // after eight corrections every guess is where it will stay
        for (std::size_t k = 0; k < 8; ++k) {
            std::size_t end = k;
            for (int n = 0; n < 8; ++n) end = next_[end];
            for (std::size_t n = 0; n < 8; ++n, end = next_[end])
                in_cycle_[end] = next_[end] != end;
        }
    }

    void step(const Settings&, const Input&) override { now_ = next_[now_]; }
    std::vector<Real> measure() const override
    {
        return {static_cast<Real>(now_), static_cast<Real>(wrong_[now_])};
    }

    void draw(Canvas& canvas) const override
    {
        for (std::size_t k = 0; k < 8; ++k)
            for (std::size_t i = 0; i < 3; ++i)
                if (const std::size_t other = k | std::size_t{1} << i; other != k)
                    canvas.segment(corner(k), corner(other), {Colour::faint, 1, 1});
        for (std::size_t k = 0; k < 8; ++k) {
            if (next_[k] == k) continue;
            const Style style = {in_cycle_[k] ? Colour::red : Colour::blue,
                                 in_cycle_[k] ? 3.0 : 1.8, 1};
            const Vec2 from = corner(k), to = corner(next_[k]),
                       way = (to - from).normalized();
            canvas.arrow(from + 0.07 * way, to - 0.07 * way, style);
        }
        for (std::size_t k = 0; k < 8; ++k) {
            const Colour colour = next_[k] == k  ? Colour::green
                                  : in_cycle_[k] ? Colour::red
                                                 : Colour::ink;
            canvas.disc(corner(k), 0.045, {colour, 1.5, 1, Paint::filled});
            // Outwards; but outside of the corner 1, 2, which lies before the others, an arrow goes past.
            const bool right = k % 2 == 1 && k != 3, above = (k >> 1) % 2 == 1;
            const Vec2 beside(right ? 0.08 : -0.08, above ? 0.05 : -0.1);
            canvas.text(corner(k) + beside, name(k), 14, {colour, 1, 1},
                        right ? Align::left : Align::right);
        }
    }

private:
    /// Row 1 is to the right, row 2 upwards, row 3 into the picture.
    static Vec2 corner(std::size_t k)
    {
        const auto side = [k](int i) { return (k >> i) % 2 == 1 ? 1.0 : 0.0; };
        return Vec2(-0.85, -0.75) + side(0) * Vec2(1.2, 0) +
               side(1) * Vec2(0, 1.1) + side(2) * Vec2(0.5, 0.42);
    }
    static std::string name(std::size_t k)
    {
        std::string rows;
        for (std::size_t i = 0; i < 3; ++i)
            if ((k >> i) % 2 == 1)
                rows += (rows.empty() ? "" : ", ") + std::to_string(i + 1);
        return rows.empty() ? "none" : rows;
    }

    std::array<std::size_t, 8> next_ = {}, wrong_ = {};
    std::array<bool, 8> in_cycle_ = {};
    std::size_t now_ = 7;
};

inline Demo cycle_scene()
{
    Demo scene;
    scene.name = "cycle";
    scene.summary = "Three rows on which flipping all wrong rows cycles: the eight "
                    "guesses and where each leads";
    scene.view = {{0, 0}, {1.25, 0.98}};
    scene.h = 1;
    scene.h_low = 0.02;
    scene.h_high = 2;
    scene.methods = {"active_sets"};
    scene.tunables = {{"start", "",
                       "the first guess: bit i of the number is row i + 1", 7, 0, 7,
                       Numbers::whole, OnChange::restarts}};
    scene.columns = {
        {"guess", "", "bit i of the number: row i + 1 is active", Plot::linear},
        {"wrong", "", "rows that contradict the guess", Plot::linear}};
    scene.start = [](const Settings& settings) {
        return std::make_unique<CycleRun>(settings);
    };
    return scene;
}

}  // namespace rigid
