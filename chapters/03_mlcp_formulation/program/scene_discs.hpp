/// \file scene_discs.hpp
/// The ten discs, solved exactly, with a live picture of A.
#pragma once

#include "chapters/03_mlcp_formulation/exact.hpp"
#include "chapters/03_mlcp_formulation/program/ten_disc_scene.hpp"
#include "common/measure.hpp"
#include "common/program/program.hpp"

#include <string>
#include <vector>

namespace rigid {

class TenDiscsRun : public Run {
public:
    explicit TenDiscsRun(const View& view) : scene_(ten_discs()), view_(view) {}

    //! [step]
    void step(const Settings& settings, const Input& input) override
    {
        StepSettings step = ten_discs_settings(settings, input);
        step.pulled = pulled_ = held_disc(scene_, input.pressed, input.pointer, pulled_);
        scene_.gravity = steered_gravity(input, view_, settings["gravity"]);

        // Which contacts are at work is seldom news: begin with those of the last step.
        const auto solve = [&](const Mlcp& mlcp, Solution& solution) {
            EnumerationSettings enumeration;
            enumeration.stop_at_first = true;
            enumeration.most_sets = 2'000'000;
            enumeration.first = guess(mlcp);
            solution =
                settings.method == "enumerate" ? enumerate(mlcp, enumeration) : schur(mlcp, enumeration);
            if (solution.status != Status::solved) throw StepFailure(why_not(mlcp, solution));
        };
        auto method = by_matrix(solve);
        rigid::step(scene_, step, method, now_);
        mlcp_ = method.solver.mlcp;
        pairs_ = method.solver.scratch.pairs;

        last_contacts_ = now_.contacts;
        last_lambda_ = now_.solution.lambda;
        if (!scene_.bodies.x.allFinite()) throw StepFailure("a position is no longer finite");
    }
    //! [step]

    std::vector<Real> measure() const override
    {
        Real active = 0;
        for (std::size_t i = scene_.links.size(); i < now_.rows.size(); ++i) active += pushes(i) ? 1 : 0;
        return {static_cast<Real>(now_.contacts.size()),
                active,
                static_cast<Real>(now_.solution.iterations),
                static_cast<Real>(pairs_),
                now_.rows.empty() ? 0 : now_.solution.residual,
                largest_link_error(scene_),
                deepest_penetration(scene_),
                kinetic_energy(scene_.bodies),
                kinetic_energy(scene_.bodies) + potential_energy(scene_.bodies, scene_.gravity)};
    }

    void draw(Canvas& canvas) const override
    {
        canvas.box({0, 0}, {0.75, 0.5}, 0, {Colour::ink, 2, 1, false, false});
        for (Index k = 0; k < scene_.bodies.count(); ++k)
            canvas.disc(
                scene_.bodies.position(k), scene_.radius[k],
                {Colour::blue, 1.5, 0.15 + 0.1 / std::sqrt(scene_.bodies.inverse_mass[2 * k]), true, false});
        for (const Link& link : scene_.links)
            canvas.segment(scene_.bodies.position(link.a), scene_.bodies.position(link.b), link_style);
        for (std::size_t i = scene_.links.size(); i < now_.rows.size(); ++i) {
            const Contact& contact = now_.contacts[i - scene_.links.size()];
            const Vec2 b = scene_.bodies.position(contact.b);
            const Vec2 on_b = b - scene_.radius[contact.b] * contact.normal;
            canvas.segment(on_b - 0.035 * contact.normal, on_b + 0.035 * contact.normal,
                           pushes(i) ? active_style : idle_style);
        }
        canvas.arrow({0, 0}, 0.02 * scene_.gravity, {Colour::green, 2.5, 1, false, false});
        canvas.text(0.022 * scene_.gravity + Vec2(0.015, -0.02), "g", 14, {Colour::green, 1.5, 1});
        draw_matrix(canvas);
    }

private:
    static constexpr Style link_style = {Colour::purple, 4, 1, false, false};
    static constexpr Style active_style = {Colour::red, 4, 1, false, false};
    static constexpr Style idle_style = {Colour::faint, 2.5, 1, false, false};
    static constexpr Style ink = {Colour::ink, 1.5, 1, false, false};

    bool pushes(std::size_t row) const
    {
        const auto i = static_cast<Index>(row);
        return i < now_.solution.lambda.size() && now_.solution.lambda[i] > 0;
    }

    /// For a contact of the previous step its case in that step; for a new one the case by the sign of q.
    std::vector<BoundState> guess(const Mlcp& mlcp) const
    {
        std::vector<BoundState> first;
        const std::size_t links = scene_.links.size();
        for (Index i = 0; i < mlcp.size(); ++i) {
            BoundState row = mlcp.q[i] < 0 ? BoundState::between : BoundState::at_lo;
            const auto k = static_cast<std::size_t>(i);
            for (std::size_t old = 0; k >= links && old < last_contacts_.size(); ++old)
                if (is_same(now_.contacts[k - links], last_contacts_[old]))
                    row = last_lambda_[static_cast<Index>(links + old)] > 0 ? BoundState::between
                                                                            : BoundState::at_lo;
            first.push_back(row);
        }
        return first;
    }

    static bool is_same(const Contact& one, const Contact& other)
    {
        return one.a == other.a && one.b == other.b && (one.a != world || one.normal == other.normal);
    }

    std::string why_not(const Mlcp& mlcp, const Solution& solution) const
    {
        return "the " + std::to_string(static_cast<std::size_t>(mlcp.size()) - scene_.links.size()) +
               " contacts have no answer after " + std::to_string(solution.iterations) +
               " sets of cases: " + std::string(to_string(solution.status));
    }

    /// A square for each entry of A that is not zero; the colours show what the rows do.
    void draw_matrix(Canvas& canvas) const
    {
        const Vec2 corner(0.95, 0.42);
        const Real side = 0.92;
        const auto rows = static_cast<Real>(std::max<std::size_t>(now_.rows.size(), 12));
        const Real cell = side / rows;
        canvas.text({0.95, 0.455}, "A: which rows meet", 14, ink);
        for (Index i = 0; i < mlcp_.size(); ++i) {
            for (SparseMatrix::InnerIterator entry(mlcp_.A, i); entry; ++entry) {
                const Colour colours[] = {style_of(static_cast<std::size_t>(i)).colour,
                                          style_of(static_cast<std::size_t>(entry.col())).colour};
                const auto either = [&](Colour colour) {
                    return colours[0] == colour || colours[1] == colour;
                };
                const Style style = {either(Colour::faint) ? Colour::faint
                                     : either(Colour::red) ? Colour::red
                                                           : Colour::purple,
                                     0, entry.col() == i ? 1 : 0.55, true, false};
                const Vec2 middle =
                    corner + cell * Vec2(static_cast<Real>(entry.col()) + 0.5, -static_cast<Real>(i) - 0.5);
                canvas.box(middle, Vec2::Constant(0.42 * cell), 0, style);
            }
        }
        canvas.box(corner + Vec2(side, -side) / 2, Vec2::Constant(side / 2), 0,
                   {Colour::faint, 1, 1, false, false});
        const Real y = corner.y() - side - 0.05;
        canvas.text({0.95, y}, "link", 13, {Colour::purple, 1.5, 1});
        canvas.text({1.06, y}, "contact that pushes", 13, {Colour::red, 1.5, 1});
        canvas.text({1.87, y}, "idle contact", 13, {Colour::faint, 1.5, 1}, Align::right);
    }

    const Style& style_of(std::size_t row) const
    {
        return row < scene_.links.size() ? link_style : pushes(row) ? active_style : idle_style;
    }

    DiscScene scene_;
    View view_;
    Index pulled_ = world;
    StepData<2> now_;
    Mlcp mlcp_;        ///< of the last step, for the picture of A
    Index pairs_ = 0;  ///< of rows that were multiplied for it
    std::vector<Contact> last_contacts_;
    VecX last_lambda_;
};

inline Demo ten_discs_scene()
{
    Demo scene;
    scene.name = "ten_discs";
    scene.summary = "Ten discs solved exactly; beside them the matrix A and which rows are active";
    scene.view = {{0.58, 0}, {1.4, 0.56}};
    scene.h = ten_discs_h;
    scene.h_low = ten_discs_h_low;
    scene.h_high = ten_discs_h_high;
    scene.methods = {"schur", "enumerate"};
    scene.tunables = ten_discs_tunables();
    scene.steered = true;
    scene.columns = {{"contacts", "", "contacts that have a row", true, false},
                     {"active", "", "contacts that push", true, false},
                     {"sets", "", "sets of cases that were tried", true, true},
                     {"pairs", "", "pairs of rows that were multiplied for A", false, false},
                     {"residual", "m/s", "natural residual of the answer", true, true},
                     {"link_error", "m", "largest difference of a link from its length", true, true},
                     {"penetration", "m", "deepest overlap", false, false},
                     {"kinetic", "J", "kinetic energy", true, false},
                     {"energy", "J", "kinetic energy and that of the weight", false, false}};
    const View view = scene.view;
    scene.start = [view](const Settings&) { return std::make_unique<TenDiscsRun>(view); };
    return scene;
}

}  // namespace rigid
