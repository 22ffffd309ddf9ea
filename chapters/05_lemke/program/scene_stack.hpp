/// \file scene_stack.hpp
/// A stack of boxes with friction: the impulses of each vertex of the walk beside its tableau.
#pragma once

#include "chapters/05_lemke/program/walk_run.hpp"
#include "chapters/05_lemke/stewart_trinkle.hpp"

namespace rigid {

class StackRun : public Run {
public:
    StackRun(const BoxStack& stack, const std::string& method, Real tie_digits)
        : walk_(stewart_trinkle(stack), method, tie_digits), stack_(stack),
          scene_(contact_rows(stack))
    {
    }

    void step(const Settings&, const Input&) override { walk_.step(); }
    std::vector<Real> measure() const override { return walk_.measure(); }

    void draw(Canvas& canvas) const override
    {
        const Real box =
            std::min(Real{0.34}, 1.7 / static_cast<Real>(stack_.boxes));
        const auto shown = [&](const Vec2& p) {
            return Vec2(Vec2(-1.25, -0.85) + box / stack_.side * p);
        };
        canvas.segment({-1.9, -0.85}, {-0.6, -0.85}, paint::wall);
        for (Index k = 0; k < stack_.boxes; ++k) {
            const Vec2 half(box / 2, box / 2);
            Style style = paint::body;
            if (k + 1 == stack_.boxes && stack_.top_mass > stack_.mass)
                style.opacity = 0.7;
            canvas.box(shown(centre(k)), half, 0, style);
        }
        const VecX z = walk_.walk.z();
        const Index m = walk_.problem.size() / 4;
        const Real largest = std::max(z.head(3 * m).maxCoeff(), 1e-12);
        for (Index i = 0; i < m; ++i) {
            const Row<3>& row = scene_.rows[static_cast<std::size_t>(i)];
            // The arm of the tangential row is -r_y, that of the normal one r_x.
            const Vec2 point =
                shown(centre(row.b) +
                      Vec2(row.Jb[2],
                           -scene_.rows[static_cast<std::size_t>(m + i)].Jb[2]));
            const Real push = 0.3 * z[i] / largest,
                       drag = 0.3 * (z[m + i] - z[2 * m + i]) / largest;
            if (push > 0.004)
                canvas.arrow(point, point + Vec2(0, push), paint::impulse);
            if (std::abs(drag) > 0.004)
                canvas.arrow(point, point + Vec2(drag, 0), {Colour::green, 2.5, 1});
        }
        canvas.text({-1.25, -1.0}, "red: normal, green: friction impulse", 13,
                    paint::label, Align::centre);
        paint::heat_map(canvas, {-0.3, 0.85}, 1.85, walk_.walk);
        canvas.text({0.1, -1.13}, paint::told(walk_.walk), 14, paint::label,
                    Align::centre);
    }

private:
    /// Where box k stands: by the arms of its contacts with the one below.
    Vec2 centre(Index k) const
    {
        Real x = 0;
        for (Index b = 1; b <= k; ++b) {
            const Row<3>& row = scene_.rows[static_cast<std::size_t>(2 * b)];
            // arm on the lower box less arm on the upper one
            x += -row.Ja[2] - row.Jb[2];
        }
        return {x, stack_.side * (static_cast<Real>(k) + 0.5)};
    }

    ProblemWalk walk_;
    BoxStack stack_;
    ContactRows scene_;
};

inline Demo stack_scene()
{
    Demo scene = walk_scene(
        "box_stack",
        "A stack of boxes with friction: the impulses of each vertex of the walk");
    scene.view = {{-0.15, -0.08}, {1.85, 1.12}};
    scene.tunables = {
        {"boxes", "", "boxes in the stack: n is eight times that", 3, 1, 40,
         Numbers::whole, OnChange::restarts},
        {"friction", "", "coefficient of friction", 0.5, 0, 1, Numbers::real,
         OnChange::restarts},
        {"jostle", "m/s", "size of the random speeds before the impulses", 0.3, 0,
         2, Numbers::real, OnChange::restarts},
        {"top_mass", "kg", "mass of the topmost box; the others have 1 kg", 1, 0.01,
         1000, Numbers::real, OnChange::restarts},
        {"tie_digits", "", "the tie tolerance is 10^-tie_digits", 8, 1, 17,
         Numbers::real, OnChange::restarts}};
    scene.start = [](const Settings& settings) {
        BoxStack stack;
        stack.boxes = static_cast<Index>(settings["boxes"]);
        stack.friction = settings["friction"];
        stack.jostle = settings["jostle"];
        stack.top_mass = settings["top_mass"];
        stack.seed = settings.seed;
        return std::make_unique<StackRun>(stack, settings.method,
                                          settings["tie_digits"]);
    };
    return scene;
}

}  // namespace rigid
