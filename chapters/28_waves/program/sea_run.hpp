/// \file sea_run.hpp
/// Solids on water of two directions: a boat that one steers, a raft, a duck, boxes. The pointer presses the water.
#pragma once

#include "chapters/20_turning_in_space/program/solid_picture.hpp"
#include "chapters/25_world_in_space/space_method.hpp"
#include "chapters/28_waves/sea_scenes.hpp"
#include "chapters/28_waves/water_step.hpp"
#include "common/program/program.hpp"

#include <algorithm>
#include <numeric>

namespace rigid {

struct SeaSetup {
    SeaScene sea;
    Index steered = world;  ///< the body with a propeller and a rudder
    Index watched = 0;      ///< the body whose motion is the table's
};

class SeaRun : public Run {
public:
    SeaRun(SeaSetup setup, const Settings& settings)
        : all_(std::move(setup.sea)), steered_(setup.steered),
          watched_(setup.watched), still_(all_.water.level(0))
    {
        floating_.settings = {settings["displace"] > 0, settings["drag"], 0.01};
        SpaceScene& scene = all_.scene;
        scene.wall_friction.assign(scene.walls.size(), 0.3);
        scene.friction.assign(scene.shapes.size(), 0.3);
        floating_.displace(scene, all_.water);
        method_.solver.sweeps = {20, 1e-9};
        volume_ = volume(all_.water);
        look(settings, {});
        floating_.find(scene, all_.water);
    }

    void step(const Settings& settings, const Input& input) override
    {
        SpaceScene& scene = all_.scene;
        ShallowGrid& water = all_.water;
        floating_.settings.drag = settings["drag"];
        const int parts = std::max(
            1,
            static_cast<int>(std::ceil(settings.h / (0.9 * stable_step(water)))));
        const StepSettings how{.h = settings.h / parts};
        for (int n = 0; n < parts; ++n) {
            // the left wall moves to and fro: as much water comes in as goes out
            t_ += how.h;
            for (Index j = 0; j < water.nz; ++j)
                water.u[water.face_x(0, j)] = settings["waves"] *
                                              std::sqrt(water.g / still_) *
                                              sin(2 * pi * t_ / settings["period"]);
            if (input.pressed) press(input.pointer, how.h);
            if (steered_ != world)
                drive(settings["throttle"], settings["rudder"] * pi / 180, how.h);
            rigid::step(scene, water, floating_, how, method_, now_);
        }
        for (Index k = 0; k < scene.bodies.count(); ++k)
            if (!scene.bodies.position(k).allFinite() ||
                !scene.bodies.velocity(k).allFinite())
                throw StepFailure("the state of body " + std::to_string(k) +
                                  " is not finite");
    }

    std::vector<Real> measure() const override
    {
        const Bodies<6>& bodies = all_.scene.bodies;
        const Vec3 at = centre_of(bodies.x, watched_);
        const Vec3 v = bodies.u.segment<3>(6 * watched_);
        return {at.x(),
                at.y(),
                at.z(),
                upright() * 180 / pi,
                std::sqrt(v.x() * v.x() + v.z() * v.z()),
                volume(all_.water) / volume_ - 1};
    }

    void look(const Settings& settings, const Input&) override
    {
        camera_.target = {0, still_, 0};
        camera_.distance = 16;
        camera_.height = 0.55;
        camera_.azimuth = settings["camera"] * pi / 180;
    }

    /// Rows of water from the farthest to the nearest, and each body after the row that it lies in.
    void draw(Canvas& canvas) const override
    {
        const ShallowGrid& water = all_.water;
        const SpaceScene& scene = all_.scene;
        std::vector<Index> order(static_cast<std::size_t>(scene.bodies.count()));
        std::iota(order.begin(), order.end(), Index{0});
        const auto z_of = [&](Index k) { return scene.bodies.x[6 * k + 2]; };
        std::stable_sort(order.begin(), order.end(),
                         [&](Index a, Index b) { return z_of(a) < z_of(b); });
        auto next = order.begin();
        const auto paint_until = [&](Real z) {
            for (; next != order.end() && z_of(*next) < z; ++next) {
                SolidPicture picture(camera_, Skin::opaque);
                for (const Hull& hull :
                     scene.shapes[static_cast<std::size_t>(*next)])
                    picture.hull(hull, centre_of(scene.bodies.x, *next),
                                 rotation_of(scene.bodies.x, *next),
                                 *next % 2 == 0 ? Colour::orange : Colour::yellow);
                picture.paint(canvas);
            }
        };
        std::vector<char> covered(static_cast<std::size_t>(water.nx * water.nz), 0);
        for (const SolidSlice& slice : floating_.slices)
            covered[static_cast<std::size_t>(slice.cell)] = 1;
        const Index skip = std::max<Index>(1, water.nz / 48);
        for (Index j = 0; j < water.nz; j += skip) {
            paint_until(water.z_of(j));
            std::vector<Vec2> line;
            const auto end_line = [&] {
                if (line.size() > 1)
                    canvas.polyline(line, {Colour::blue, 1.2, 0.8});
                line.clear();
            };
            for (Index i = 0; i < water.nx; ++i) {
                const Index c = water.at(i, j);
                if (covered[static_cast<std::size_t>(c)] != 0) {
                    end_line();  // no water is seen there
                    continue;
                }
                line.push_back(camera_.project(
                    {water.x_of(i), water.level(c), water.z_of(j)}));
            }
            end_line();
        }
        paint_until(infinity);
    }

private:
    /// The angle between the body's own upright, as it lay at the start, and the world's.
    Real upright() const
    {
        const Vec3 up = rotation_of(all_.scene.bodies.x, watched_) * up_;
        return pi / 2 - asin(std::clamp(up.y(), -1.0, 1.0));
    }
    Vec3 own_up() const
    {
        return rotation_of(all_.scene.bodies.x, watched_).transpose() *
               Vec3(0, 1, 0);
    }

    /// Where the pointer's ray meets the still water.
    Vec3 on_water(const Vec2& pointer) const
    {
        const Mat3 A = camera_.axes();
        const Vec3 through = camera_.target + pointer.x() * A.row(0).transpose() +
                             pointer.y() * A.row(1).transpose(),
                   eye = camera_.eye(), way = through - eye;
        return eye + (still_ - eye.y()) / way.y() * way;
    }
    /// A hand of a metre presses: the water around it is pushed away.
    void press(const Vec2& pointer, Real h)
    {
        ShallowGrid& water = all_.water;
        const Vec3 at = on_water(pointer);
        const auto push = [&](Real& speed, Real x, Real z, bool along_x) {
            const Real a = x - at.x(), b = z - at.z(), s = a * a + b * b;
            if (s < 1) speed += h * 20 * (1 - s) * (along_x ? a : b);
        };
        for (Index j = 0; j < water.nz; ++j)
            for (Index i = 0; i < water.nx; ++i) {
                const Real x = water.x_of(i), z = water.z_of(j),
                           half = water.dx / 2;
                if (i > 0) push(water.u[water.face_x(i, j)], x - half, z, true);
                if (j > 0) push(water.w[water.face_z(i, j)], x, z - half, false);
            }
    }
    /// A propeller at the stern, turned by the rudder; it throws the water behind it the other way.
    void drive(Real throttle, Real rudder, Real h)
    {
        SpaceScene& scene = all_.scene;
        ShallowGrid& water = all_.water;
        const Mat3 R = rotation_of(scene.bodies.x, steered_) * start_;
        const Vec3 stern =
            centre_of(scene.bodies.x, steered_) + R * Vec3(-1.1, -0.1, 0);
        if (stern.y() > still_ + 0.3) return;  // it is out of the water
        const Vec3 F = throttle * (R * Vec3(cos(rudder), 0, sin(rudder)));
        const Vec3 arm = stern - centre_of(scene.bodies.x, steered_);
        Vec<6> P;
        P << h * F, rotation_of(scene.bodies.x, steered_).transpose() *
                        cross(arm, Vec3(h * F));
        scene.bodies.velocity(steered_) +=
            scene.bodies.apply_inverse_mass(steered_, P);
        const auto cell = [&](Real x, Real origin, Index n) {
            return std::clamp<Index>(static_cast<Index>((x - origin) / water.dx), 1,
                                     n - 1);
        };
        const Index i = cell(stern.x(), water.origin_x, water.nx),
                    j = cell(stern.z(), water.origin_z, water.nz),
                    c = water.at(i, j);
        const Real area = water.density * water.dx * water.dx / 2;
        water.u[water.face_x(i, j)] -=
            h * F.x() / (area * (water.depth[c - 1] + water.depth[c]) + 1);
        water.w[water.face_z(i, j)] -=
            h * F.z() / (area * (water.depth[c - water.nx] + water.depth[c]) + 1);
    }

    SeaScene all_;
    Index steered_, watched_;
    Real still_;
    SolidFloating floating_;
    TouchingBoxes method_;
    StepData<6> now_;
    Camera camera_;
    Real t_ = 0, volume_ = 1;
    Vec3 up_ = own_up();
    /// from the axes of the steered body's shape to its own
    Mat3 start_ =
        steered_ == world
            ? Mat3(Mat3::Identity())
            : Mat3(rotation_of(all_.scene.bodies.x, steered_).transpose());
};

}  // namespace rigid
