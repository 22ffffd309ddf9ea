/// \file scene_discs.hpp
/// Discs that meet, a chain of links, and three rods that ask for the impossible.
#pragma once

#include "chapters/02_velocity_constraints/drawing.hpp"
#include "chapters/02_velocity_constraints/geometry.hpp"
#include "chapters/02_velocity_constraints/solve_rows.hpp"
#include "common/forces.hpp"
#include "common/measure.hpp"
#include "common/program/program.hpp"
#include "common/random.hpp"

#include <algorithm>
#include <array>
#include <memory>
#include <vector>

namespace rigid {

/// The body whose centre is nearest to a point, among those that can move.
inline Index nearest_body(const Bodies<2>& bodies, const Vec2& p)
{
    Index best = 0;
    Real distance = infinity;
    for (Index k = 0; k < bodies.count(); ++k) {
        const Real d = (bodies.position(k) - p).norm();
        if (bodies.inverse_mass[2 * k] > 0 && d < distance) best = k, distance = d;
    }
    return best;
}

/// Which body the reader's hand holds: the one that was nearest when the button went down.
class Hand {
public:
    void pull(Bodies<2>& bodies, const Input& input)
    {
        if (!input.pressed) held_ = world;
        else if (held_ == world) held_ = nearest_body(bodies, input.pointer);
        if (held_ != world) add_pull(bodies, held_, input.pointer);
    }

private:
    Index held_ = world;
};

/// Discs in a box. Each contact is one row, and each row has its turn.
class DiscsRun : public Run {
public:
    explicit DiscsRun(const Settings& settings)
    {
        const Index K = static_cast<Index>(settings["count"]);
        scene_.bodies = Bodies<2>(K);
        scene_.radius = VecX::Constant(K, 0.25);
        scene_.walls = {{{0, 1}, -1}, {{1, 0}, -1.5}, {{-1, 0}, -1.5}, {{0, -1}, -1}};
        Random random(settings.seed);
        for (Index k = 0; k < K;
             ++k) {  // the first two fly towards each other, the others where there is room
            scene_.radius[k] = k == 0 ? 0.25 : k == 1 ? 0.35 : random.uniform(0.1, 0.2);
            if (k == 0) scene_.bodies.position(k) << -1, -0.25;
            else if (k == 1) scene_.bodies.position(k) << 0.6, 0.5;
            else place_freely(k, random);
            const Real density = 1 / (0.25 * 0.25);  // 1 kg for the first
            scene_.bodies.inverse_mass.segment<2>(2 * k).setConstant(
                1 / (density * scene_.radius[k] * scene_.radius[k]));
            if (k == 0) scene_.bodies.velocity(k) << 2, 0.3;
            if (k == 1) scene_.bodies.velocity(k) << -0.2, -0.9;
        }
        before_ = scene_.bodies.u;
    }

    //! [discs_step]
    /// forces → u* → contacts → rows → λ, row after row → u → x
    void step(const Settings& settings, const Input& input) override
    {
        const Real h = settings.h;
        Bodies<2>& bodies = scene_.bodies;
        bodies.f.setZero();
        add_gravity(bodies, {0, -settings["gravity"]});
        hand_.pull(bodies, input);
        bodies.u += h * bodies.inverse_mass.cwiseProduct(bodies.f);
        before_ = bodies.u;

        // A gap may close in this step, but not more: w = J u + C/h >= 0 where C > 0, (2.3).
        find_contacts(bodies.x, scene_.radius, scene_.walls, {}, 0.1, contacts_);
        rows_.clear();
        for (const Contact& contact : contacts_)
            rows_.push_back(unilateral(contact_constraint(contact), bodies.inverse_mass,
                                       std::max<Real>(contact.gap, 0) / h));

        impulse_ = VecX::Zero(static_cast<Index>(rows_.size()));
        const int rounds = static_cast<int>(settings["rounds"]);
        for (int round = 0; round < rounds; ++round)
            for (std::size_t i = 0; i < rows_.size(); ++i) {
                const Real lambda = solve_row(rows_[i], bodies.u).lambda;
                rows_[i].apply(lambda, bodies.u);
                impulse_[static_cast<Index>(i)] += lambda;
            }
        left_ = 0;
        for (const Row<2>& row : rows_) left_ = std::min(left_, row.velocity(bodies.u));
        bodies.x += h * bodies.u;
    }
    //! [discs_step]

    std::vector<Real> measure() const override
    {
        const Vec2 P = momentum(scene_.bodies);
        return {static_cast<Real>(rows_.size()), -left_, 1000 * deepest_penetration(scene_),
                kinetic_energy(scene_.bodies),   P.x(),  P.y()};
    }

    void draw(Canvas& canvas) const override
    {
        canvas.box({0, 0}, {1.5, 1}, 0, paint::wire);
        const Bodies<2>& bodies = scene_.bodies;
        const bool few = bodies.count() <= 3;  // else the names would stand in each other's way
        const auto arrow = [&](const Vec2& tail, const Vec2& vector, const char* name, const Style& style) {
            labelled_arrow(canvas, tail, vector, few ? name : "", style, 0.05);
        };
        for (Index k = 0; k < bodies.count(); ++k) {
            const Vec2 x = bodies.position(k);
            canvas.disc(x, scene_.radius[k], paint::body);
            canvas.text(x + scene_.radius[k] * Vec2(-0.55, 0.5), std::to_string(k), 14, paint::label,
                        Align::centre);
            const Vec2 star = before_.segment<2>(2 * k), u = bodies.velocity(k);
            if ((star - u).norm() > 0.05) arrow(x, 0.25 * star, "u*", paint::wanted);
            arrow(x, 0.25 * u, "u", paint::allowed);
        }
        for (std::size_t i = 0; i < contacts_.size() && static_cast<Index>(i) < impulse_.size(); ++i) {
            const Real lambda = impulse_[static_cast<Index>(i)];
            if (lambda <= 0) continue;
            // At the place of contact: the impulse on b along the normal, the one on a against it.
            const Contact& c = contacts_[i];
            const Vec2 along = perpendicular(c.normal),
                       touch = bodies.position(c.b) - c.normal * scene_.radius[c.b];
            canvas.segment(touch - 0.3 * along, touch + 0.3 * along, paint::guide);
            arrow(touch, (few ? 0.3 : 0.1) * c.normal, "n", paint::direction);
            const Vec2 P = std::min(0.2 * lambda, 0.6) * c.normal, tail = touch + (few ? 0.32 : 0.02) * along;
            if (P.norm() < 0.02) continue;
            arrow(tail, P, "+P", paint::impulse);
            if (c.a != world) arrow(tail, -P, "−P", paint::impulse);
        }
    }

private:
    void place_freely(Index k, Random& random)
    {
        for (int attempt = 0; attempt < 1000; ++attempt) {
            const Vec2 p(random.uniform(-1.25, 1.25), random.uniform(-0.75, 0.75));
            bool free = true;
            for (Index j = 0; j < k && free; ++j)
                free = (scene_.bodies.position(j) - p).norm() > scene_.radius[j] + scene_.radius[k];
            scene_.bodies.position(k) = p;
            if (free) return;
        }
    }

    DiscScene scene_;
    std::vector<Contact> contacts_;
    std::vector<Row<2>> rows_;
    VecX impulse_, before_;
    Hand hand_;
    Real left_ = 0;
};

inline Scene discs_scene()
{
    Scene scene;
    scene.name = "discs";
    scene.summary = "Discs that meet each other and the walls without bounce, one row for each contact";
    scene.view = {{0, 0}, {1.6, 1.1}};
    scene.h = 1.0 / 60;
    scene.methods = {"row-by-row"};
    scene.tunables = {
        {"count", "", "number of discs", 2, 1, 14, true, true, false},
        {"rounds", "", "how often each row has its turn in a step", 1, 1, 100, true, false, false},
        {"gravity", "m/s^2", "downwards", 0, 0, 20, false, false, true}};
    scene.columns = {{"rows", "", "contacts of the step", true, false},
                     {"left", "m/s", "the largest approach that the rows left", true, false},
                     {"penetration", "mm", "the deepest overlap", true, false},
                     {"kinetic", "J", "kinetic energy", true, false},
                     {"px", "kg m/s", "momentum along x", false, false},
                     {"py", "kg m/s", "momentum along y", false, false}};
    scene.start = [](const Settings& settings) { return std::make_unique<DiscsRun>(settings); };
    return scene;
}

/// A chain of links that hangs from a nail, let go horizontally.
class ChainRun : public Run {
public:
    explicit ChainRun(const Settings& settings)
    {
        const Index N = static_cast<Index>(settings["links"]);
        length_ = 1.6 / static_cast<Real>(N);
        bodies_ = Bodies<2>(N + 1);
        for (Index k = 0; k <= N; ++k) bodies_.position(k) << length_ * static_cast<Real>(k), 0.8;
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
            const Constraint<2> link = distance_constraint(bodies_.x, {k, k + 1, length_});
            rows_.push_back(bilateral(link, bodies_.inverse_mass, settings["repay"] * link.C / h));
        }
        if (settings.method == "one-shot") {
            const RowsAnswer& answer = solver_.solve(rows_, bodies_.u);
            if (answer.verdict == Verdict::conflicting) throw StepFailure(sentence(answer));
            apply(rows_, answer.lambda, bodies_.u);
        } else {
            for (int round = 0; round < static_cast<int>(settings["rounds"]); ++round)
                for (const Row<2>& row : rows_) row.apply(solve_row(row, bodies_.u).lambda, bodies_.u);
        }
        residual_ = 0;
        for (const Row<2>& row : rows_) residual_ = std::max(residual_, std::abs(row.velocity(bodies_.u)));
        bodies_.x += h * bodies_.u;
    }
    //! [chain_step]

    std::vector<Real> measure() const override
    {
        Real error = 0;
        for (Index k = 0; k + 1 < bodies_.count(); ++k)
            error = std::max(error, std::abs(distance_constraint(bodies_.x, {k, k + 1, length_}).C));
        return {residual_, 1000 * error, kinetic_energy(bodies_) + potential_energy(bodies_, {0, -9.81})};
    }

    void draw(Canvas& canvas) const override
    {
        const Real radius = std::min(0.35 * length_, 0.06);
        for (Index k = 0; k + 1 < bodies_.count(); ++k) {
            const Real C = distance_constraint(bodies_.x, {k, k + 1, length_}).C;
            const bool stretched = C > 0.02 * length_;
            canvas.segment(bodies_.position(k), bodies_.position(k + 1),
                           {stretched ? Colour::red : Colour::ink, 3, 1, false, false});
        }
        canvas.disc(bodies_.position(0), 0.03, paint::fixed);
        for (Index k = 1; k < bodies_.count(); ++k)
            canvas.disc(bodies_.position(k), k + 1 == bodies_.count() ? 1.5 * radius : radius, paint::body);
        canvas.text({-1.9, 1.0}, "largest link error " + fixed(measure()[1], 1) + " mm (red: more than 2 %)",
                    15, paint::label);
    }

private:
    Bodies<2> bodies_;
    std::vector<Row<2>> rows_;
    RowsSolver<2> solver_;
    Hand hand_;
    Real length_ = 0.1, residual_ = 0;
};

inline Scene chain_scene()
{
    Scene scene;
    scene.name = "chain";
    scene.summary = "A hanging chain: all links in one shot by a factorisation, or link by link";
    scene.view = {{0, -0.35}, {2, 1.55}};
    scene.h = 1.0 / 240;
    scene.methods = {"one-shot", "row-by-row"};
    scene.side_by_side = scene.methods;
    scene.tunables = {
        {"links", "", "number of links", 16, 1, 60, true, true, false},
        {"end_mass", "kg", "mass of the last disc; the others have 1 kg", 1, 0.01, 1000, false, true, false},
        {"repay", "", "part of the error C/h that the rows' bias asks back", 0, 0, 1, false, false, false},
        {"rounds", "", "row by row: how often each row has its turn in a step", 10, 1, 1000, true, false,
         true}};
    scene.columns = {{"residual", "m/s", "the largest |w| that is left", true, true},
                     {"link_error", "mm", "the largest error of a link", true, false},
                     {"energy", "J", "kinetic and potential", true, false}};
    scene.start = [](const Settings& settings) { return std::make_unique<ChainRun>(settings); };
    return scene;
}

/// A disc on three rods. Two hold it already; the third is redundant, or, told to grow, in conflict.
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
            // The third rod is told to grow: ||x - p|| - L(t) = 0 with dL/dt = growth, so b = -growth.
            const Real growth = i == 2 ? settings["growth"] : 0;
            rows.push_back(
                bilateral(anchor_constraint(bodies_.x, 0, anchors[i], 1), bodies_.inverse_mass, -growth));
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
            canvas.segment(anchors[i], x, {odd ? Colour::red : Colour::green, 4, 1, false, false});
            canvas.disc(anchors[i], 0.05, paint::fixed);
            const Vec2 away = anchors[i].normalized();
            canvas.text(anchors[i] + 0.14 * away - Vec2(0, 0.05), "w = " + fixed(w, 3) + " m/s", 14,
                        {odd ? Colour::red : Colour::green, 1.5, 1, false, false},
                        away.x() > 0.3    ? Align::left
                        : away.x() < -0.3 ? Align::right
                                          : Align::centre);
        }
        canvas.disc(x, 0.12, {Colour::blue, 1.5, 0.6, true, false});
        const char* words = answer_.verdict == Verdict::independent ? "independent"
                            : answer_.verdict == Verdict::redundant
                                ? "redundant: one velocity, many λ"
                                : "conflicting: no velocity meets all three";
        canvas.text({0, -1.45}, "three rows of rank " + std::to_string(answer_.rank) + ", " + words, 15,
                    paint::label, Align::centre);
    }

private:
    const std::array<Vec2, 3> anchors = {Vec2(-std::sqrt(0.75), 0.5), Vec2(std::sqrt(0.75), 0.5),
                                         Vec2(0, -1)};
    Bodies<2> bodies_;
    RowsAnswer answer_;
};

inline Scene conflict_scene()
{
    Scene scene;
    scene.name = "conflict";
    scene.summary =
        "Three rods, of which one is told to grow: redundant rows, and rows that contradict each other";
    scene.view = {{0, -0.3}, {2, 1.4}};
    scene.methods = {"compromise", "refuse"};
    scene.tunables = {
        {"growth", "m/s", "how fast the third rod is told to grow", 0.1, -1, 1, false, false, true}};
    scene.columns = {{"w1", "m/s", "what is left of the first row", true, false},
                     {"w2", "m/s", "of the second", true, false},
                     {"w3", "m/s", "of the third", true, false},
                     {"lambda1", "N s", "impulse of the first row", true, false},
                     {"lambda2", "N s", "of the second", false, false},
                     {"lambda3", "N s", "of the third", false, false},
                     {"rank", "", "how many rows say something new", false, false},
                     {"conflict", "", "1: no velocity meets all rows", true, false}};
    scene.start = [](const Settings& settings) { return std::make_unique<ConflictRun>(settings); };
    return scene;
}

}  // namespace rigid
