/// \file scene_one_sweep.hpp
/// One sweep per step over the rows of a scene at rest: what an order of the rows does to the error, and that the
/// iterates are those of chapter 4.
#pragma once

#include "chapters/04_pgs/prescaled_sweeps.hpp"
#include "chapters/06_sequential_impulse/program/impulse_scenes.hpp"

#include <array>
#include <memory>

namespace rigid {

class OneSweepRun : public Run {
public:
    explicit OneSweepRun(const Settings& settings) : method_(settings.method)
    {
        const auto size = static_cast<Index>(settings["size"]);
        const auto kind = static_cast<int>(settings["kind"]);
        scene_ = kind == 0   ? triangle(size)
                 : kind == 1 ? column(size, settings["end_mass"])
                             : hanging_chain(size, settings["end_mass"]);
        constexpr Real h = 1.0 / 60;
        std::vector<Contact> contacts;
        find_contacts(scene_, 1e-6, contacts);
        disc_rows(scene_, h, contacts, rows_, LeaveErrors{});
        u_star_ = scene_.bodies.u;
        for (Index k = 0; k < scene_.bodies.count(); ++k)
            if (scene_.bodies.can_move(k))
                u_star_.segment<2>(2 * k) += h * scene_.gravity;

        Random random(settings.seed);
        order_rows(rows_, scene_.bodies.count(), order_of_method(method_), random,
                   colouring_, order_);
        begin_sweeps(rows_, order_, 0, memory_, u_star_, solution_);
        pair_rows(memory_.rows, blocks_);
        prepare(assemble(rows_, u_star_), 1, order_, pgs_);
        pgs_.lambda.setZero();
        // At rest nothing moves: the exact velocity is zero.
        for (Index k = 0; k < scene_.bodies.count(); ++k)
            weight_ += scene_.bodies.inverse_mass[2 * k] > 0
                           ? 9.81 * h / scene_.bodies.inverse_mass[2 * k]
                           : 0;
    }

    void step(const Settings&, const Input&) override
    {
        const bool backwards = method_ == "alternating" && sweeps_ % 2 == 1;
        if (method_ == "blocks")
            for (const Block& block : blocks_) {
                SolverRow<2>& first =
                    memory_.rows[static_cast<std::size_t>(block.first)];
                if (block.second < 0) visit(first, memory_.u);
                else
                    visit_block(
                        first, memory_.rows[static_cast<std::size_t>(block.second)],
                        block.coupling, 0, memory_.u);
            }
        else sweep(memory_, 0, backwards);
        backwards ? sweep_backward(pgs_) : sweep_forward(pgs_);
        ++sweeps_;
    }

    std::vector<Real> measure() const override
    {
        Real sideways = 0, difference = 0;
        for (Index k = 0; k < scene_.bodies.count(); ++k)
            if (scene_.bodies.can_move(k))
                sideways += memory_.u[2 * k] / scene_.bodies.inverse_mass[2 * k];
        for (std::size_t k = 0; k < memory_.rows.size(); ++k)
            difference =
                std::max(difference, std::abs(memory_.rows[k].lambda -
                                              pgs_.lambda[static_cast<Index>(k)]));
        return {static_cast<Real>(sweeps_),
                natural_residual<2>(memory_.rows, memory_.u),
                memory_.u.lpNorm<Eigen::Infinity>() / (9.81 / 60),
                sideways / weight_, method_ == "blocks" ? 0 : difference};
    }

    void draw(Canvas& canvas) const override
    {
        const Real zoom = 0.9 / scene_.half_size.maxCoeff();
        const Vec2 middle(0, scene_.links.empty() ? scene_.half_size.y() / 2
                                                  : -scene_.half_size.y() / 2);
        const auto shown = [&](const Vec2& p) {
            return Vec2(1.7 * zoom * (p - middle));
        };
        for (Index k = 0; k < scene_.bodies.count(); ++k)
            canvas.disc(shown(scene_.bodies.position(k)),
                        1.7 * zoom * scene_.radius[k],
                        {Colour::ink, 1, 0.12, Paint::filled});
        constexpr std::array hues = {Colour::blue,  Colour::orange,
                                     Colour::green, Colour::purple,
                                     Colour::red,   Colour::yellow};
        Real largest = 1e-12;
        for (const SolverRow<2>& row : memory_.rows)
            largest = std::max(largest, std::abs(row.lambda));
        for (std::size_t k = 0; k < memory_.rows.size(); ++k) {
            const std::size_t i =
                order_.empty() ? k : static_cast<std::size_t>(order_[k]);
            const Row<2>& row = rows_[i];
            const Vec2 b = scene_.bodies.position(row.b), n = row.Jb.transpose();
            const Vec2 a = row.a == world ? Vec2(b - scene_.radius[row.b] * n)
                                          : Vec2(scene_.bodies.position(row.a));
            const auto colour =
                order_of_method(method_) == Order::coloured
                    ? hues[static_cast<std::size_t>(colouring_.colour[i]) %
                           hues.size()]
                    : Colour::blue;
            canvas.segment(
                shown(a), shown(b),
                {colour, 1 + 7 * std::abs(memory_.rows[k].lambda) / largest, 1});
        }
        const std::vector<Real> told = measure();
        canvas.text({0, -1.12},
                    std::to_string(sweeps_) + " sweeps, residual " +
                        significant(told[1], 2) + " m/s",
                    14, paint::label, Align::centre);
    }

private:
    std::string method_;
    DiscScene scene_;
    std::vector<Row<2>> rows_;
    VecX u_star_;
    Colouring colouring_;
    std::vector<int> order_;
    ImpulseMemory<2> memory_;
    Solution solution_;
    std::vector<Block> blocks_;
    SweepRows pgs_;
    Real weight_ = 0;
    int sweeps_ = 0;
};

inline Demo one_sweep_scene()
{
    Demo scene;
    scene.name = "one_sweep";
    scene.summary = "One sweep per step on a scene at rest: the error under each "
                    "order of the rows";
    scene.view = {{0, -0.05}, {1.15, 1.15}};
    scene.h = scene.h_low = scene.h_high = 1.0 / 60;
    scene.methods = {"given", "alternating", "shuffled", "coloured", "blocks"};
    scene.side_by_side = {"given", "coloured"};
    scene.tunables = {
        {"kind",
         "",
         "0 triangle, 1 column, 2 hanging chain",
         0,
         0,
         2,
         Numbers::whole,
         OnChange::restarts,
         Keys::none,
         {"triangle", "column", "hanging chain"}},
        {"size", "", "discs along its base, in the column, on the chain", 8, 2, 60,
         Numbers::whole, OnChange::restarts, Keys::up_and_down},
        {"end_mass", "kg", "last disc of column and chain; the others have 1 kg", 1,
         0.01, 1000, Numbers::real, OnChange::restarts}};
    scene.columns = {
        {"sweeps", "", "sweeps so far"},
        {"residual", "m/s", "natural residual", Plot::logarithmic},
        {"fastest", "", "largest velocity left, in units of g h; exact: 0",
         Plot::logarithmic},
        {"sideways", "", "sideways momentum, in units of weight times h; exact: 0",
         Plot::linear},
        {"difference", "N s", "largest difference of an impulse from chapter 4's",
         Plot::logarithmic}};
    scene.start = [](const Settings& settings) {
        return std::make_unique<OneSweepRun>(settings);
    };
    return scene;
}

}  // namespace rigid
