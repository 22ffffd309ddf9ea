/// \file scene_links.hpp
/// A chain of links, and three rods that can't all be met.
#pragma once

#include "chapters/02_velocity_constraints/geometry.hpp"
#include "chapters/02_velocity_constraints/program/drawing.hpp"
#include "chapters/02_velocity_constraints/program/scene_hand.hpp"
#include "chapters/02_velocity_constraints/solve_rows.hpp"
#include "common/forces.hpp"
#include "common/measure.hpp"
#include "common/program/program.hpp"

#include <algorithm>
#include <array>
#include <memory>
#include <string>
#include <vector>

namespace rigid {

/// A chain of links that hangs from a nail, let go horizontally.
class ChainRun : public Run {
public:
    explicit ChainRun(const Settings& settings)
    {
        const Index N = static_cast<Index>(settings["links"]);
        length_ = 1.6 / static_cast<Real>(N);
        bodies_ = Bodies<2>(N + 1);
        for (Index k = 0; k <= N; ++k)
            bodies_.position(k) << length_ * static_cast<Real>(k), 0.8;
        bodies_.inverse_mass.head<2>().setZero();
        bodies_.inverse_mass.tail<2>().setConstant(1 / settings["end_mass"]);
    }

    //! [chain_step]
    void step(const Settings& settings, const Input& input) override
    {
        const Real h = settings.h;
        bodies_.f.setZero();
        add_gravity(bodies_, {0, -9.81});
        hand_.pull(bodies_, input);
        bodies_.u += h * bodies_.inverse_mass.cwiseProduct(bodies_.f);

        rows_.clear();
        for (Index k = 0; k + 1 < bodies_.count(); ++k) {
            const Constraint<2> link =
                distance_constraint(bodies_.x, {k, k + 1, length_});
            rows_.push_back(bilateral(link, bodies_.inverse_mass,
                                      settings["repay"] * link.C / h));
        }
        if (settings.method == "one-shot") {
            const RowsAnswer& answer = solver_.solve(rows_, bodies_.u);
            if (answer.verdict == Verdict::conflicting)
                throw StepFailure(sentence(answer));
            apply(rows_, answer.lambda, bodies_.u);
        } else {
            for (int round = 0; round < static_cast<int>(settings["rounds"]);
                 ++round)
                for (const Row<2>& row : rows_)
                    row.apply(solve_row(row, bodies_.u).lambda, bodies_.u);
        }
        residual_ = 0;
        for (const Row<2>& row : rows_)
            residual_ = std::max(residual_, std::abs(row.velocity(bodies_.u)));
        bodies_.x += h * bodies_.u;
    }
    //! [chain_step]

    std::vector<Real> measure() const override
    {
        Real error = 0;
        for (Index k = 0; k + 1 < bodies_.count(); ++k)
            error = std::max(
                error,
                std::abs(distance_constraint(bodies_.x, {k, k + 1, length_}).C));
        return {residual_, 1000 * error,
                kinetic_energy(bodies_) + potential_energy(bodies_, {0, -9.81})};
    }

    void draw(Canvas& canvas) const override
    {
        const Real radius = std::min(0.35 * length_, 0.06);
        for (Index k = 0; k + 1 < bodies_.count(); ++k) {
            const Real C = distance_constraint(bodies_.x, {k, k + 1, length_}).C;
            const bool stretched = C > 0.02 * length_;
            canvas.segment(bodies_.position(k), bodies_.position(k + 1),
                           {stretched ? Colour::red : Colour::ink, 3, 1});
        }
        canvas.disc(bodies_.position(0), 0.03, paint::fixed);
        for (Index k = 1; k < bodies_.count(); ++k)
            canvas.disc(bodies_.position(k),
                        k + 1 == bodies_.count() ? 1.5 * radius : radius,
                        paint::body);
        canvas.text({-1.9, 1.0},
                    "largest link error " + fixed(measure()[1], 1) +
                        " mm (red: more than 2 %)",
                    15, paint::label);
    }

private:
    Bodies<2> bodies_;
    std::vector<Row<2>> rows_;
    RowsSolver<2> solver_;
    HeldBody hand_;
    Real length_ = 0.1, residual_ = 0;
};

inline Demo chain_scene()
{
    Demo scene;
    scene.name = "chain";
    scene.summary = "A hanging chain: all links in one shot by a factorisation, or "
                    "link by link";
    scene.view = {{0, -0.35}, {2, 1.55}};
    scene.h = 1.0 / 240;
    scene.methods = {"one-shot", "row-by-row"};
    scene.side_by_side = scene.methods;
    scene.tunables = {
        {"links", "", "number of links", 16, 1, 60, Numbers::whole,
         OnChange::restarts},
        {"end_mass", "kg", "mass of the last disc; the others have 1 kg", 1, 0.01,
         1000, Numbers::real, OnChange::restarts},
        {"repay", "", "part of the error C/h that the rows' bias requires back", 0,
         0, 1},
        {"rounds", "", "row by row: how often each row has its turn in a step", 10,
         1, 1000, Numbers::whole, OnChange::goes_on, Keys::up_and_down}};
    scene.columns = {
        {"residual", "m/s", "the largest |w| that is left", Plot::logarithmic},
        {"link_error", "mm", "the largest error of a link", Plot::linear},
        {"energy", "J", "kinetic and potential", Plot::linear}};
    scene.start = [](const Settings& settings) {
        return std::make_unique<ChainRun>(settings);
    };
    return scene;
}

/// A disc on three rods. Two hold it already; the third is redundant, or, made to grow, in conflict.
class ConflictRun : public Run {
public:
    explicit ConflictRun(const Settings& settings) : bodies_(1) { solve(settings); }

    void step(const Settings& settings, const Input& input) override
    {
        bodies_.f.setZero();
        if (input.pressed) add_pull(bodies_, 0, input.pointer);
        bodies_.u += settings.h * bodies_.inverse_mass.cwiseProduct(bodies_.f);
        solve(settings);
        bodies_.x += settings.h * bodies_.u;
    }

    //! [conflict_step]
    void solve(const Settings& settings)
    {
        std::vector<Row<2>> rows;
        for (std::size_t i = 0; i < 3; ++i) {
            // The third rod is made to grow: ||x - p|| - L(t) = 0 with dL/dt =
            // growth, so b = -growth.
            const Real growth = i == 2 ? settings["growth"] : 0;
            rows.push_back(bilateral(anchor_constraint(bodies_.x, 0, anchors[i], 1),
                                     bodies_.inverse_mass, -growth));
        }
        answer_ = solve_rows(rows, bodies_.u);
        if (answer_.verdict == Verdict::conflicting && settings.method == "refuse")
            throw StepFailure(sentence(answer_));
        apply(rows, answer_.lambda, bodies_.u);
    }
    //! [conflict_step]

    std::vector<Real> measure() const override
    {
        return {answer_.w[0],
                answer_.w[1],
                answer_.w[2],
                answer_.lambda[0],
                answer_.lambda[1],
                answer_.lambda[2],
                static_cast<Real>(answer_.rank),
                answer_.verdict == Verdict::conflicting ? 1.0 : 0.0};
    }

    void draw(Canvas& canvas) const override
    {
        const Vec2 x = bodies_.x;
        for (std::size_t i = 0; i < 3; ++i) {
            const Real w = answer_.w[static_cast<Index>(i)];
            const bool odd = std::abs(w) > 1e-9;
            canvas.segment(anchors[i], x,
                           {odd ? Colour::red : Colour::green, 4, 1});
            canvas.disc(anchors[i], 0.05, paint::fixed);
            const Vec2 away = anchors[i].normalized();
            canvas.text(anchors[i] + 0.14 * away - Vec2(0, 0.05),
                        "w = " + fixed(w, 3) + " m/s", 14,
                        {odd ? Colour::red : Colour::green, 1.5, 1},
                        away.x() > 0.3    ? Align::left
                        : away.x() < -0.3 ? Align::right
                                          : Align::centre);
        }
        canvas.disc(x, 0.12, {Colour::blue, 1.5, 0.6, Paint::filled});
        const char* words = answer_.verdict == Verdict::independent ? "independent"
                            : answer_.verdict == Verdict::redundant
                                ? "redundant: one velocity, many λ"
                                : "conflicting: no velocity meets all three";
        canvas.text({0, -1.45},
                    "three rows of rank " + std::to_string(answer_.rank) + ", " +
                        words,
                    15, paint::label, Align::centre);
    }

private:
    const std::array<Vec2, 3> anchors = {Vec2(-std::sqrt(0.75), 0.5),
                                         Vec2(std::sqrt(0.75), 0.5), Vec2(0, -1)};
    Bodies<2> bodies_;
    RowsAnswer answer_;
};

inline Demo conflict_scene()
{
    Demo scene;
    scene.name = "conflict";
    scene.summary = "Three rods, of which one has to grow: redundant rows, and "
                    "rows that contradict each other";
    scene.view = {{0, -0.3}, {2, 1.4}};
    scene.methods = {"compromise", "refuse"};
    scene.tunables = {{"growth", "m/s", "how fast the third rod has to grow", 0.1,
                       -1, 1, Numbers::real, OnChange::goes_on, Keys::up_and_down}};
    scene.columns = {
        {"w1", "m/s", "what is left of the first row", Plot::linear},
        {"w2", "m/s", "of the second", Plot::linear},
        {"w3", "m/s", "of the third", Plot::linear},
        {"lambda1", "N s", "impulse of the first row", Plot::linear},
        {"lambda2", "N s", "of the second"},
        {"lambda3", "N s", "of the third"},
        {"rank", "", "how many rows say something new"},
        {"conflict", "", "1: no velocity meets all rows", Plot::linear}};
    scene.start = [](const Settings& settings) {
        return std::make_unique<ConflictRun>(settings);
    };
    return scene;
}

}  // namespace rigid
