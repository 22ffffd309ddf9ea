/// \file walk_run.hpp
/// A walk of Lemke's algorithm, alive: one pivot per step of the program.
#pragma once

#include "chapters/05_lemke/families.hpp"
#include "chapters/05_lemke/program/drawing.hpp"
#include "common/elementary.hpp"
#include "common/program/program.hpp"

#include <memory>

namespace rigid {

inline TieRule tie_rule(const std::string& method)
{
    return method == "first_row"  ? TieRule::first_row
           : method == "last_row" ? TieRule::last_row
                                  : TieRule::lexicographic;
}

/// A problem and the walk to its answer.
struct ProblemWalk {
    Mlcp problem;
    LemkeWalk walk;

    /// \param tie_digits  the tie tolerance is 10^-tie_digits
    ProblemWalk(const Mlcp& mlcp, const std::string& method, Real tie_digits = 8)
        : problem(mlcp), walk(MatX(mlcp.A), mlcp.q, VecX::Ones(mlcp.size()),
                              tie_rule(method), {1e-10, pow(10, -tie_digits)})
    {
    }

    //! [one_pivot]
    void step()
    {
        if (walk.place == LemkeWalk::Place::on_the_way) walk.step();
    }
    //! [one_pivot]

    /// What z0 is now; before the first pivot as much as is needed.
    Real lift() const
    {
        const Tableau& tableau = walk.tableau;
        if (walk.place == LemkeWalk::Place::solution) return 0;
        if (walk.pivots > 0) return tableau.value(tableau.artificial());
        return -tableau.values()[walk.most_negative_row()];
    }

    static std::vector<Column> columns()
    {
        return {{"pivots", "", "pivots so far"},
                {"z0", "m/s",
                 "the artificial variable: how far all rows are lifted",
                 Plot::linear},
                {"positive", "", "how many z are positive", Plot::linear},
                {"residual", "m/s", "natural residual of the present z",
                 Plot::logarithmic},
                {"largest", "", "largest entry of the tableau but for the column r",
                 Plot::logarithmic},
                {"place", "", "0 on the way, 1 at the solution, 2 at a ray"}};
    }
    std::vector<Real> measure() const
    {
        const VecX z = walk.z();
        const Tableau& tableau = walk.tableau;
        return {
            static_cast<Real>(walk.pivots),
            lift(),
            static_cast<Real>((z.array() > 0).count()),
            natural_residual(problem, z),
            tableau.n > 0
                ? tableau.entries().leftCols(tableau.n + 1).cwiseAbs().maxCoeff()
                : 0,
            static_cast<Real>(walk.place)};
    }
};

/// A walk by itself, its tableau as the picture.
class TableauRun : public Run {
public:
    explicit TableauRun(ProblemWalk walk) : walk_(std::move(walk)) {}

    void step(const Settings&, const Input&) override { walk_.step(); }
    std::vector<Real> measure() const override { return walk_.measure(); }
    void draw(Canvas& canvas) const override
    {
        paint::heat_map(canvas, {-0.86, 0.8}, 1.85, walk_.walk);
        canvas.text({0, -0.98}, paint::told(walk_.walk), 14, paint::label,
                    Align::centre);
    }

private:
    ProblemWalk walk_;
};

/// A scene of pivots: half a second for each when it plays by itself.
inline Demo walk_scene(const std::string& name, const std::string& summary)
{
    Demo scene;
    scene.name = name;
    scene.summary = summary;
    scene.h = 0.5;
    scene.h_low = 0.02;
    scene.h_high = 2;
    scene.view = {{0, -0.02}, {1.06, 1.06}};
    scene.methods = {"lexicographic", "first_row", "last_row"};
    scene.columns = ProblemWalk::columns();
    return scene;
}

/// Families of problems whose pivots are known.
inline Demo tableau_scene()
{
    Demo scene = walk_scene(
        "tableau",
        "The tableau as a heat map, one pivot per step, on problems with a name");
    scene.tunables = {
        {"family", "",
         "0 Murty, 1 its transpose, 2 Murty with equal q, 3 Fathi, 4 "
         "circulant, 5 column, 6 random spd",
         1, 0, 6, Numbers::whole, OnChange::restarts},
        {"rows", "", "n", 4, 1, 40, Numbers::whole, OnChange::restarts},
        {"tie_digits", "", "the tie tolerance is 10^-tie_digits", 8, 1, 17,
         Numbers::real, OnChange::restarts}};
    scene.side_by_side = scene.methods;
    scene.start = [](const Settings& settings) {
        const auto n = static_cast<Index>(settings["rows"]);
        Random random(settings.seed);
        const auto problem = [&] {
            switch (static_cast<int>(settings["family"])) {
            case 0:
                return murty(n);
            case 1:
                return murty_transposed(n);
            case 2:
                return murty_equal(n);
            case 3:
                return fathi(n);
            case 4:
                return circulant(n);
            case 5:
                return tridiagonal(VecX::Constant(n, -9.81 / 60));
            default:
                return random_spd(n, random);
            }
        };
        return std::make_unique<TableauRun>(
            ProblemWalk(problem(), settings.method, settings["tie_digits"]));
    };
    return scene;
}

}  // namespace rigid
