/// \file elastic_space_run.hpp
/// One scene of tetrahedra under one of this chapter's laws.
#pragma once

#include "chapters/25_world_in_space/program/space_picture.hpp"
#include "chapters/30_elastic_bodies/elastic_space_scenes.hpp"
#include "chapters/30_elastic_bodies/program/elastic_run.hpp"

#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace rigid {

struct ElasticSpaceSetup {
    ElasticSpace scene;
    Camera camera;
    Real ground = 0;  ///< half the side of the floor that is drawn [m]; 0: none
    std::function<std::vector<Real>(const ElasticSpace&)> measure;
    std::function<void(ElasticSpace&, Real t)> change;
};

/// The mean place of the nodes, by their masses.
inline Vec3 middle_of(const ElasticBody<3>& body)
{
    Vec3 sum(0, 0, 0);
    for (int i = 0; i < body.model.nodes(); ++i)
        sum += body.model.mass_at(i) * body.at(i);
    return sum / body.model.mass();
}

class ElasticSpaceRun : public Run {
public:
    ElasticSpaceRun(ElasticSpaceSetup setup, const Settings& settings)
        : setup_(std::move(setup)),
          triangles_(surface_triangles(setup_.scene.elastic.model.mesh()))
    {
        contacts_.solver.settings.stale = 0.3;
        look(settings, {});
    }

    void step(const Settings& settings, const Input&) override
    {
        ElasticSpace& scene = setup_.scene;
        if (setup_.change) setup_.change(scene, t_);
        contacts_.step(scene, settings.h);
        if (!scene.elastic.x.allFinite() || !scene.bodies.x.allFinite())
            throw StepFailure("the state of the elastic body is not finite");
        t_ += settings.h;
    }

    std::vector<Real> measure() const override
    {
        std::vector<Real> numbers = setup_.measure(setup_.scene);
        const ElasticBody<3>& body = setup_.scene.elastic;
        numbers.push_back(body.kinetic_energy() + body.elastic_energy() +
                          body.potential_energy());
        numbers.push_back(body.elastic_energy());
        numbers.push_back(contacts_.report.iterations);
        numbers.push_back(contacts_.report.factorisations);
        return numbers;
    }

    void look(const Settings& settings, const Input&) override
    {
        camera_ = setup_.camera;
        camera_.azimuth += settings["camera"] * pi / 180;
    }

    void draw(Canvas& canvas) const override
    {
        const ElasticSpace& scene = setup_.scene;
        if (setup_.ground == 0) {  // slopes, behind all else
            SolidPicture behind(camera_, Skin::opaque);
            for (const SolidWall& wall : scene.walls) {
                const Vec3& n = wall.normal;
                const Vec3 v = across(n), u = cross(v, n);
                const Vec3 c =
                    camera_.target - (n.dot(camera_.target) - wall.offset) * n;
                behind.facet(
                    {c - 2 * u - v, c + 2 * u - v, c + 2 * u + v, c - 2 * u + v},
                    Colour::faint);
            }
            behind.paint(canvas);
        }
        SolidPicture picture(camera_, Skin::opaque);
        if (setup_.ground > 0) picture.ground(setup_.ground, 0);
        for (const auto& mesh : scene.meshes) draw_mesh(picture, *mesh);
        for (Index k = 0; k < scene.bodies.count(); ++k)
            for (const Hull& hull : scene.shapes[static_cast<std::size_t>(k)])
                picture.hull(hull, centre_of(scene.bodies.x, k),
                             rotation_of(scene.bodies.x, k), Colour::orange);
        for (const auto& [a, b, c] : triangles_)
            picture.facet(
                {scene.elastic.at(a), scene.elastic.at(b), scene.elastic.at(c)},
                Colour::blue);
        picture.paint(canvas);
    }

private:
    ElasticSpaceSetup setup_;
    ElasticSolids contacts_;
    std::vector<std::array<int, 3>> triangles_;
    Camera camera_;
    Real t_ = 0;
};

/// A scene with the columns that all of them have.
inline Demo solid_demo(const std::string& name, const std::string& summary,
                       const View& view, Real h, std::vector<std::string> methods,
                       std::vector<Tunable> tunables, std::vector<Column> columns,
                       std::function<ElasticSpaceSetup(const Settings&)> setup)
{
    tunables.push_back(
        {"camera", "°", "where the eye is, around the scene", 0, -180, 180});
    Demo scene =
        demo_of<ElasticSpaceRun>(name, summary, view, h, std::move(methods),
                                 std::move(tunables), std::move(setup));
    scene.columns = std::move(columns);
    scene.columns.push_back({"energy", "J", "of the elastic body", Plot::linear});
    scene.columns.push_back({"stored", "J", "elastic", Plot::linear});
    scene.columns.push_back({"systems", "", "linear systems of the step"});
    scene.columns.push_back({"factors", "", "new ones in the step"});
    return scene;
}

}  // namespace rigid
