/// \file world_run.hpp
/// One runner for every program that has a World: it steps, draws and measures by the public header alone.
#pragma once

#include "chapters/11_rotation/program/rigid_picture.hpp"
#include "chapters/19_engine/moving_worlds.hpp"
#include "common/program/program.hpp"

#include <functional>
#include <memory>
#include <string>
#include <utility>

namespace rigid {

struct WorldSetup {
    World world;
    /// what the scene does itself before each step
    std::function<void(World&, const Settings&)> before = {};
};

class WorldRun : public Run {
public:
    WorldRun(WorldSetup setup, const Settings& settings) : setup_(std::move(setup))
    {
        (void)settings;
        for (const BodyId body : setup_.world.bodies())
            if (setup_.world.mass(body) < infinity)
                top_ = std::max(top_, setup_.world.position(body).y());
    }

    void step(const Settings& settings, const Input& input) override
    {
        World& here = setup_.world;
        WorldSettings how = here.settings();
        how.substeps = static_cast<int>(settings["substeps"]);
        how.sleep = settings["sleep"] > 0;
        how.solving = settings.method == "exact"    ? Solving::exact
                      : settings.method == "sweeps" ? Solving::sweeps
                                                    : Solving::by_island;
        if (how.substeps != here.settings().substeps ||
            how.sleep != here.settings().sleep ||
            how.solving != here.settings().solving)
            here.change(how);
        for (; thrown_ < static_cast<int>(settings["thrown"]); ++thrown_)
            throw_one();
        hold(input);
        if (setup_.before) setup_.before(here, settings);
        here.step(settings.h, listener_);
        if (part_begins_) part_begins_("");
        for (const BodyId body : here.bodies())
            if (!here.position(body).allFinite() ||
                !here.velocity(body).allFinite())
                throw StepFailure("the state of body " +
                                  std::to_string(body.place) + " is not finite");
    }

    void tell_parts(PartListener listener) override
    {
        part_begins_ = std::move(listener);
        listener_ = [this](Stage stage) { part_begins_(to_string(stage)); };
        if (!part_begins_) listener_ = {};
    }

    std::vector<Real> measure() const override
    {
        const World& here = setup_.world;
        const StepWork& work = here.work();
        here.contacts(contacts_);
        Real overlap = 0, gap = 0;
        for (const ContactView& contact : contacts_)
            overlap = std::max(overlap, -contact.gap);
        for (const JointId joint : here.joints())
            if (!here.is_broken(joint)) gap = std::max(gap, here.error(joint));
        return {Real(work.bodies),
                Real(work.awake),
                Real(work.contacts),
                Real(work.rows),
                Real(work.exact),
                Real(work.swept),
                Real(work.rescued),
                Real(work.unsolved),
                Real(work.visits),
                Real(work.tested),
                overlap,
                gap};
    }

    void draw(Canvas& canvas) const override
    {
        const World& here = setup_.world;
        for (const WallId id : here.walls()) {
            const HalfSpace& wall = here.wall(id);
            const Vec2 middle = wall.normal * wall.offset,
                       along = 200 * perpendicular(wall.normal);
            canvas.segment(middle - along, middle + along, paint::wall);
        }
        for (const BodyId body : here.bodies())
            for (const BodyId shape : here.shapes(body)) paint_shape(canvas, shape);
        for (const JointId joint : here.joints()) {
            if (here.is_broken(joint)) continue;
            const RigidJoint& it = here.joint(joint);
            const Vec2 a = here.point_of(here.body_a(joint), it.at_a),
                       b = here.point_of(here.body_b(joint), it.at_b);
            if ((a - b).norm() > 0.02) canvas.segment(a, b, {Colour::purple, 2, 1});
            canvas.disc(b, 0.02, {Colour::orange, 1, 1, Paint::filled});
        }
    }

private:
    /// A shape of a body, by its name.
    void paint_shape(Canvas& canvas, BodyId body) const
    {
        const World& here = setup_.world;
        const Polygon& shape = here.shape(body);
        Style style = here.mass(body) < infinity ? paint::body : paint::fixed_body;
        if (here.mass(body) < infinity && !here.is_awake(body))
            style.colour = Colour::purple;
        std::vector<Vec2> corners;
        for (const Vec2& vertex : shape.vertices)
            corners.push_back(here.point_of(body, vertex));
        if (corners.size() == 1) {
            canvas.disc(corners[0], shape.radius, style);
            const Vec2 rim = shape.vertices[0] + Vec2(0.9 * shape.radius, 0);
            canvas.segment(corners[0], here.point_of(body, rim),
                           {Colour::blue, 1.5, 1});
        } else if (shape.radius > 0)
            canvas.polygon(rounded_outline(corners, shape.radius), style);
        else if (corners.size() == 2)
            canvas.segment(corners[0], corners[1], {style.colour, 3, 0.8});
        else canvas.polygon(corners, style);
    }

    /// The hand pulls the body that is nearest to it.
    void hold(const Input& input)
    {
        World& here = setup_.world;
        if (!input.pressed) {
            if (held_) here.pull({});
            held_ = {};
            return;
        }
        if (!held_ || !here.has(held_)) {
            Real nearest = infinity;
            for (const BodyId body : here.bodies()) {
                const Real d = (here.position(body) - input.pointer).norm();
                if (here.mass(body) < infinity && d < nearest)
                    nearest = d, held_ = body;
            }
        }
        if (held_) here.pull(held_, input.pointer);
    }

    void throw_one()
    {
        const Real side = thrown_ % 2 == 0 ? 1 : -1;
        BodyDefinition box_thrown = body_of(
            box(0.5, 0.5), {side * (1 + 0.3 * (thrown_ % 5)), top_ + 2}, 0.3);
        box_thrown.velocity = {-side * 4, -4};
        setup_.world.add_body(box_thrown);
    }

    WorldSetup setup_;
    PartListener part_begins_;
    StageListener listener_;
    Real top_ = 0;
    int thrown_ = 0;
    BodyId held_;
    mutable std::vector<ContactView> contacts_;
};

/// A scene of this program: columns and tunables that all worlds have.
inline Demo world_demo(const std::string& name, const std::string& summary,
                       const View& view,
                       std::function<WorldSetup(const Settings&)> setup)
{
    Demo scene;
    scene.name = name;
    scene.summary = summary;
    scene.view = view;
    scene.methods = {"by_island", "exact", "sweeps"};
    scene.tunables = {
        {"substeps", "", "parts of a step", 1, 1, 32, Numbers::whole},
        {"sleep", "", "1: what rests, sleeps", 1, 0, 1, Numbers::whole},
        {"thrown", "", "boxes thrown in so far", 0, 0, 60, Numbers::whole,
         OnChange::goes_on, Keys::up_and_down}};
    scene.columns = {
        {"bodies", "", "in the world"},
        {"awake", "", "bodies that a step looks at", Plot::linear},
        {"contacts", "", "points"},
        {"rows", "", "of the step", Plot::linear},
        {"exact", "", "islands solved exactly"},
        {"swept", "", "islands swept"},
        {"rescued", "", "of those, solved exactly after all"},
        {"unsolved", "", "islands above the tolerance"},
        {"visits", "", "rows visited, whatever for", Plot::linear},
        {"tested", "", "boxes compared in search of pairs"},
        {"overlap", "m", "the deepest", Plot::logarithmic},
        {"gap", "m", "the largest error of a joint", Plot::logarithmic}};
    scene.start = [setup = std::move(setup)](const Settings& settings) {
        return std::make_unique<WorldRun>(setup(settings), settings);
    };
    return scene;
}

}  // namespace rigid
