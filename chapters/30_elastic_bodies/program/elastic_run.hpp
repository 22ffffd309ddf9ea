/// \file elastic_run.hpp
/// One scene under one of this chapter's laws and rules.
#pragma once

#include "chapters/11_rotation/program/rigid_picture.hpp"
#include "chapters/30_elastic_bodies/elastic_scenes.hpp"
#include "chapters/30_elastic_bodies/vibration.hpp"
#include "common/program/demo_of.hpp"

#include <memory>

namespace rigid {

inline StrainLaw law_of(const Settings& settings)
{
    if (settings.method == "neo_hookean") return StrainLaw::neo_hookean;
    if (settings.method == "linear" || settings.method == "modal")
        return StrainLaw::linear;
    return StrainLaw::corotational;
}

struct ElasticSetup {
    ElasticScene scene;
    bool touches =
        true;  ///< false: there are no contacts, and the rule may be midpoint
    bool rests = false;  ///< a step goes to where forces balance
    int modes = 20;      ///< of the method modal
    std::function<std::vector<Real>(const ElasticScene&)> measure;
    std::function<void(ElasticScene&, Real t)> change;
};

class ElasticRun : public Run {
public:
    ElasticRun(ElasticSetup setup, const Settings& settings)
        : setup_(std::move(setup))
    {
        if (settings.method == "midpoint")
            solver_.settings.rule = TimeRule::implicit_midpoint;
        if (settings.method == "modal")
            modal_ =
                std::make_unique<ModalBody<2>>(setup_.scene.elastic, setup_.modes);
    }

    void step(const Settings& settings, const Input&) override
    {
        ElasticScene& scene = setup_.scene;
        if (setup_.change) setup_.change(scene, t_);
        if (setup_.rests) {
            solver_.rest(scene.elastic);
            systems_ = solver_.report.iterations;
        } else if (modal_) modal_->step(scene.elastic, settings.h);
        else if (setup_.touches) {
            contacts_.step(scene, settings.h);
            systems_ = contacts_.report.iterations;
        } else {
            solver_.step(scene.elastic, settings.h);
            systems_ = solver_.report.iterations;
        }
        if (!scene.elastic.x.allFinite() || !scene.bodies.x.allFinite())
            throw StepFailure("the state of the elastic body is not finite");
        t_ += settings.h;
    }

    std::vector<Real> measure() const override
    {
        std::vector<Real> numbers = setup_.measure(setup_.scene);
        const ElasticBody<2>& body = setup_.scene.elastic;
        numbers.push_back(body.kinetic_energy() + body.elastic_energy() +
                          body.potential_energy());
        numbers.push_back(body.elastic_energy());
        numbers.push_back(systems_);
        return numbers;
    }

    void draw(Canvas& canvas) const override
    {
        const ElasticScene& scene = setup_.scene;
        const ElasticBody<2>& body = scene.elastic;
        const ElasticMesh<2>& mesh = body.model.mesh();
        for (const HalfSpace& wall : scene.walls) {
            const Vec2 middle = wall.normal * wall.offset,
                       along = 60 * perpendicular(wall.normal);
            canvas.segment(middle - along, middle + along, paint::wall);
        }
        for (int e = 0; e < mesh.count(); ++e) {
            std::vector<Vec2> corners;
            constexpr int around[6] = {0, 3, 1,
                                       5, 2, 4};  // with the middles of the edges
            for (const int i : around)
                if (i < mesh.per_element())
                    corners.push_back(body.at(mesh.node(e, i)));
            canvas.polygon(std::move(corners),
                           {Colour::blue, 0.8, 0.35, Paint::filled});
        }
        for (Index k = 0; k < scene.bodies.count(); ++k)
            paint_rigid_body(canvas, scene, k);
    }

private:
    ElasticSetup setup_;
    ElasticSolver<2> solver_;
    ElasticContacts contacts_;
    std::unique_ptr<ModalBody<2>> modal_;
    Real t_ = 0;
    int systems_ = 0;
};

/// A scene with the columns that all of them have.
inline Demo elastic_demo(const std::string& name, const std::string& summary,
                         const View& view, Real h, std::vector<std::string> methods,
                         std::vector<Tunable> tunables, std::vector<Column> columns,
                         std::function<ElasticSetup(const Settings&)> setup)
{
    Demo scene = demo_of<ElasticRun>(name, summary, view, h, std::move(methods),
                                     std::move(tunables), std::move(setup));
    scene.columns = std::move(columns);
    scene.columns.push_back({"energy", "J", "of the elastic body", Plot::linear});
    scene.columns.push_back({"stored", "J", "elastic", Plot::linear});
    scene.columns.push_back({"systems", "", "linear systems of the step"});
    return scene;
}

}  // namespace rigid
