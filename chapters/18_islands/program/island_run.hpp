/// \file island_run.hpp
/// One scene, each island by its own solver, and pictures that show by which.
#pragma once

#include "chapters/11_rotation/program/turning_run.hpp"
#include "chapters/18_islands/island_method.hpp"

#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace rigid {

class IslandRun : public Run {
public:
    IslandRun(JointedScene scene, const Settings& settings)
        : scene_(std::move(scene)), prices_(settings["prices"] > 0)
    {
        method_ = island_method(scene_, how_);
    }

    void step(const Settings& settings, const Input& input) override
    {
        const StepSettings step = step_settings(settings, input, scene_.bodies);
        const IslandSettings how{
            .solving = settings.method == "exact"    ? Solving::exact
                       : settings.method == "sweeps" ? Solving::sweeps
                                                     : Solving::by_island,
            .substeps = step.substeps,
            .sweeps = static_cast<int>(settings["sweeps"]),
            .sleep = settings["sleep"] > 0};
        if (how != how_) change(method_, how);
        how_ = how;
        prices_ = settings["prices"] > 0;
        rigid::step(scene_, step, method_, now_);
        require_finite_state(scene_.bodies);
    }

    std::vector<Real> measure() const override
    {
        const IslandChoice& solver = method_.solver;
        const bool awake = !now_.active.empty();
        Real overlap = 0;
        for (const Contact& contact : now_.contacts)
            overlap = std::max(overlap, -contact.gap);
        const auto count = [awake](auto number) {
            return awake ? static_cast<Real>(number) : 0;
        };
        return {count(now_.active.size()),
                count(now_.rows.size()),
                count(solver.exact_count),
                count(solver.swept_count),
                count(solver.stepped_count),
                count(solver.rescued_count),
                count(std::max(solver.unsolved, method_.correction.unmet)),
                count(price_of_step(method_, now_)),
                overlap};
    }

    void draw(Canvas& canvas) const override
    {
        for (const HalfSpace& wall : scene_.walls) {
            const Vec2 middle = wall.normal * wall.offset,
                       along = 200 * perpendicular(wall.normal);
            canvas.segment(middle - along, middle + along, paint::wall);
        }
        std::vector<Style> styles(static_cast<std::size_t>(scene_.bodies.count()),
                                  paint::fixed_body);
        const Islands& islands = method_.solver.all.islands;
        for (int i = 0; i < islands.count() && !now_.active.empty(); ++i)
            for (const int k : islands.bodies_of(i))
                styles[static_cast<std::size_t>(k)].colour = solver_of(i).first;
        for (Index k = 0; k < scene_.bodies.count(); ++k) {
            Style& style = styles[static_cast<std::size_t>(k)];
            if (scene_.bodies.can_move(k)) style.opacity = 0.3;
            if (method_.contacts.set.is_asleep(k)) style.colour = Colour::faint;
            paint_rigid_body(canvas, scene_, k, style);
        }
        for (const PlacedJoint& placed : scene_.placed)
            canvas.disc(
                point_of(scene_.bodies.x, placed.joint.b, placed.joint.at_b), 0.04,
                {Colour::orange, 1, 1, Paint::filled});
        if (prices_) write_prices(canvas);
    }

private:
    /// Colour and name of what solves an island.
    std::pair<Colour, const char*> solver_of(int island) const
    {
        const IslandChoice& solver = method_.solver;
        const auto has = [island](const auto& pool) {
            return island < static_cast<int>(pool.place.size()) &&
                   pool.place[static_cast<std::size_t>(island)] >= 0;
        };
        if (solver.all.islands.rows_of(island).empty())
            return {Colour::ink, "free"};
        if (has(solver.exactly)) return {Colour::blue, "exact"};
        if (has(solver.rescuers)) return {Colour::red, "rescued"};
        if (has(solver.held)) return {Colour::purple, "joints held"};
        if (has(solver.wide)) return {Colour::green, "lanes"};
        return {Colour::orange, "swept"};
    }

    /// Both prices above each island.
    void write_prices(Canvas& canvas) const
    {
        const Islands& islands = method_.solver.all.islands;
        for (int i = 0; i < islands.count() && !now_.active.empty(); ++i) {
            const std::span<const int> bodies = islands.bodies_of(i);
            const IslandShape shape =
                survey_(scene_.bodies, now_.rows, islands.rows_of(i), bodies);
            Vec2 top(0, -infinity);
            for (const int k : bodies)
                if (scene_.bodies.position(k)[1] > top.y())
                    top = scene_.bodies.position(k).head<2>();
            const auto solver = solver_of(i);
            const auto line = [&](Real above, const std::string& words) {
                canvas.text(top + Vec2(0, 1 + above), words, 13, {solver.first},
                            Align::centre);
            };
            line(0, solver.second);
            if (shape.rows == 0) continue;
            line(2.2, "sweeps " + grouped(shape.price_of_sweeps()));
            line(1.1, "exactly " + grouped(shape.price_of_exact()));
        }
    }

    /// 86,400
    static std::string grouped(Real number)
    {
        std::string digits = std::to_string(std::llround(number));
        for (int i = static_cast<int>(digits.size()) - 3; i > 0; i -= 3)
            digits.insert(static_cast<std::size_t>(i), ",");
        return digits;
    }

    JointedScene scene_;
    mutable IslandMethod method_;  ///< what it has counted is asked for
    mutable IslandSurveyor survey_;
    StepData<3> now_;
    IslandSettings how_;
    bool prices_ = false;
};

inline Demo island_demo(const std::string& name, const std::string& summary,
                        const View& view, const Tunable& number,
                        const std::function<JointedScene(Real)>& make)
{
    Demo scene = demo_of<IslandRun, JointedScene>(
        name, summary, view, 1.0 / 60, {"by_island", "exact", "sweeps"},
        {number,
         {"substeps", "", "parts of a step", 1, 1, 32, Numbers::whole},
         {"sweeps", "", "over an island, at most", 60, 1, 1000, Numbers::whole},
         {"sleep", "", "1: what rests, sleeps", 1, 0, 1, Numbers::whole},
         {"prices", "", "1: both prices of each island are written on it", 0, 0, 1,
          Numbers::whole}},
        [make, key = number.name](const Settings& s) { return make(s[key]); });
    scene.columns = {
        {"awake", "", "bodies that a step looks at", Plot::linear},
        {"rows", "", "of the step"},
        {"exact", "", "islands solved exactly", Plot::linear},
        {"swept", "", "other islands with rows", Plot::linear},
        {"stepped", "", "of those, by small steps"},
        {"rescued", "", "of those, solved exactly after all"},
        {"unsolved", "", "islands above the tolerance"},
        {"price", "", "of the step, in entries of a matrix", Plot::logarithmic},
        {"overlap", "m", "the deepest, when the step began", Plot::logarithmic}};
    return scene;
}

}  // namespace rigid
