/// \file scene_linkage.hpp
/// Linkages whose exact energy never changes, under RATTLE, the exact split and C/h.
#pragma once

#include "chapters/04_pgs/program/drawing.hpp"
#include "chapters/09_active_sets/linkages.hpp"
#include "chapters/09_active_sets/rattle.hpp"
#include "common/program/program.hpp"
#include "common/text.hpp"

#include <algorithm>
#include <memory>

namespace rigid {

class LinkageRun : public Run {
public:
    explicit LinkageRun(DiscScene scene) : scene_(std::move(scene)), start_(energy())
    {
        split_.correction = exact_correction();
        whole_.correction.method = Stabilizer::baumgarte;
        whole_.correction.beta = 1;
    }

    void step(const Settings& settings, const Input&) override
    {
        const StepSettings how{.h = settings.h, .substeps = static_cast<int>(settings["substeps"])};
        if (settings.method == "rattle") rigid::step(scene_, how, rattle_, now_);
        else if (settings.method == "split") rigid::step(scene_, how, split_, now_);
        else rigid::step(scene_, how, whole_, now_);
        if (!scene_.bodies.x.allFinite()) throw StepFailure("a position is not finite");
        unsolved_ += now_.solution.status != Status::solved;
        path_.push_back(scene_.bodies.x.tail<2>());
        if (path_.size() > 400) path_.erase(path_.begin());
    }

    std::vector<Real> measure() const override
    {
        return {energy() - start_, kinetic_energy(scene_.bodies), largest_link_error(scene_),
                static_cast<Real>(rattle_.correction.iterations), static_cast<Real>(unsolved_)};
    }

    void draw(Canvas& canvas) const override
    {
        const Real zoom = 1 / scene_.half_size.maxCoeff();
        const auto shown = [&](const Vec2& p) { return Vec2(zoom * p); };
        std::vector<Vec2> path;
        for (const Vec2& p : path_) path.push_back(shown(p));
        if (path.size() > 1) canvas.polyline(path, {Colour::faint, 1.5, 1, false, false});
        for (const Link& link : scene_.links)
            canvas.segment(shown(scene_.bodies.position(link.a)), shown(scene_.bodies.position(link.b)),
                           paint::link);
        for (Index k = 0; k < scene_.bodies.count(); ++k)
            canvas.disc(shown(scene_.bodies.position(k)), 0.03,
                        scene_.bodies.inverse_mass[2 * k] > 0 ? paint::body : paint::fixed_body);
        canvas.text({0, -1.1}, "energy off by " + significant(energy() - start_, 2) + " J", 14, paint::label,
                    Align::centre);
    }

private:
    Real energy() const
    {
        return kinetic_energy(scene_.bodies) + potential_energy(scene_.bodies, scene_.gravity);
    }

    DiscScene scene_;
    Real start_;
    RattleMethod rattle_;
    ExactMethod split_, whole_;
    StepData<2> now_;
    std::vector<Vec2> path_;
    int unsolved_ = 0;
};

inline Demo linkage_scene()
{
    Demo scene;
    scene.name = "linkage";
    scene.summary = "A linkage that nothing brakes: which step keeps its energy?";
    scene.view = {{0, -0.05}, {1.15, 1.15}};
    scene.h = 1.0 / 60;
    scene.h_low = 1e-4;
    scene.h_high = 1.0 / 60;
    scene.methods = {"rattle", "split", "whole_error"};
    scene.side_by_side = {"rattle", "split"};
    scene.tunables = {{"kind", "", "0 the four-bar linkage, 1 a pendulum of rods, 2 a chain of ten", 0, 0, 2,
                       true, true, false},
                      {"rods", "", "of the pendulum", 2, 1, 20, true, true, false},
                      {"substeps", "", "parts of each step", 1, 1, 64, true, false, false}};
    scene.columns = {{"energy_error", "J", "energy minus that of the start", true, false},
                     {"kinetic", "J", "kinetic energy", true, false},
                     {"link_error", "m", "largest difference of a link from its length", true, true},
                     {"passes", "", "of Newton's method in the last step, of rattle", false, false},
                     {"unsolved", "", "steps so far whose status is not solved", false, false}};
    scene.start = [](const Settings& settings) {
        const int kind = static_cast<int>(settings["kind"]);
        return std::make_unique<LinkageRun>(kind == 0   ? four_bar()
                                            : kind == 1 ? linked_discs(static_cast<Index>(settings["rods"]))
                                                        : free_swinging_chain());
    };
    return scene;
}

}  // namespace rigid
