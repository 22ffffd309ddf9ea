/// \file peer_mujoco.hpp
/// A scene of the ways in MuJoCo: coordinates of joints, loops and contacts as soft accelerations, by its semi-implicit Euler step and
/// its other defaults. What hangs on no joint has three of its own in the plane.
#pragma once

#include "chapters/26_four_ways/benchmark/peer_bodies.hpp"

#include <Eigen/Geometry>
#include <mujoco/mujoco.h>

#include <cstring>
#include <iomanip>
#include <sstream>
#include <stdexcept>

namespace rigid {

class MujocoWays {
public:
    static constexpr const char* name = "MuJoCo";

    explicit MujocoWays(const WayScene& way)
    {
        mju_user_warning = [](const char*) {};  // they are counted
        const JointedScene& scene = way.scene;
        const HangingBodies tree(scene);
        model_ = model_of(text_of(scene, tree));
        data_ = mj_makeData(model_);
        const VecX& q = scene.placed.empty() ? scene.bodies.x : tree.q;
        const VecX& dq = scene.placed.empty() ? scene.bodies.u : tree.dq;
        for (Index i = 0; i < q.size(); ++i) {
            const int joint =
                mj_name2id(model_, mjOBJ_JOINT, name_of("j", i).c_str());
            data_->qpos[model_->jnt_qposadr[joint]] = q[i];
            data_->qvel[model_->jnt_dofadr[joint]] = dq[i];
        }
    }
    ~MujocoWays()
    {
        mj_deleteData(data_);
        mj_deleteModel(model_);
    }
    MujocoWays(const MujocoWays&) = delete;
    MujocoWays& operator=(const MujocoWays&) = delete;

    /// Its contacts have no coefficient of restitution.
    static bool can_take(const WayScene& way)
    {
        return way.scene.surfaces.empty() ||
               way.scene.surfaces.front().restitution == 0;
    }
    void step(Real h)
    {
        model_->opt.timestep = h;
        mj_step(model_, data_);
        for (const int one : {mjWARN_BADQPOS, mjWARN_BADQVEL, mjWARN_BADQACC})
            lost_ = lost_ || data_->warning[one].number > 0;
    }
    void read(JointedScene& scene) const
    {
        mj_fwdPosition(model_, data_);
        mj_fwdVelocity(model_, data_);
        for (Index k = 0; k < scene.bodies.count(); ++k) {
            const int body =
                mj_name2id(model_, mjOBJ_BODY, name_of("b", k).c_str());
            const mjtNum *x = data_->xpos + 3 * body, *R = data_->xmat + 9 * body;
            std::array<mjtNum, 6> v;  // turn, then motion
            mj_objectVelocity(model_, data_, mjOBJ_XBODY, body, v.data(), 0);
            scene.bodies.position(k) << x[0], x[1], atan2(R[3], R[0]);
            scene.bodies.velocity(k) << v[3], v[4], v[2];
        }
        if (lost_)
            scene.bodies.x.setConstant(infinity);  // it began again by itself
    }

private:
    static std::string name_of(const char* kind, Index k)
    {
        return kind + std::to_string(k);
    }
    static mjModel* model_of(const std::string& text)
    {
        const auto files = std::make_unique<mjVFS>();
        mj_defaultVFS(files.get());
        mj_makeEmptyFileVFS(files.get(), "scene.xml",
                            static_cast<int>(text.size()));
        std::memcpy(files->filedata[0], text.data(), text.size());
        std::array<char, 1000> fault{};
        mjModel* const model =
            mj_loadXML("scene.xml", files.get(), fault.data(), 1000);
        mj_deleteVFS(files.get());
        if (!model) throw std::runtime_error(fault.data());
        return model;
    }

    /// The scene in MuJoCo's language: a body stands in the one that it hangs on, where its coordinate is zero.
    static std::string text_of(const JointedScene& scene, const HangingBodies& tree)
    {
        std::ostringstream out;
        out << std::setprecision(17) << "<mujoco><compiler angle='radian'/>"
            << "<option gravity='" << in_space(scene.gravity) << "'/><worldbody>";
        for (const HalfSpace& wall : scene.walls) {
            out << "<geom type='plane' size='0 0 1' pos='"
                << in_space(wall.normal * (wall.offset - stands_back(scene)))
                << "' zaxis='" << in_space(wall.normal) << '\''
                << friction_of(scene);
        }
        if (scene.placed.empty())
            for (Index k = 0; k < scene.bodies.count(); ++k)
                out << "<body name='" << name_of("b", k) << "'>"
                    << "<joint name='" << name_of("j", 3 * k)
                    << "' type='slide' axis='1 0 0'/><joint name='"
                    << name_of("j", 3 * k + 1)
                    << "' type='slide' axis='0 1 0'/><joint name='"
                    << name_of("j", 3 * k + 2) << "' type='hinge' axis='0 0 1'/>"
                    << matter_of(scene, k) << "</body>";
        else write_what_hangs_on(-1, scene, tree, out);
        out << "</worldbody><equality>";
        for (const RigidJoint& loop : tree.loops)
            out << "<connect body1='" << name_of("b", loop.a) << "' body2='"
                << name_of("b", loop.b) << "' anchor='" << in_space(loop.at_a)
                << "'/>";
        out << "</equality></mujoco>";
        return out.str();
    }
    /// \param carriers  the joints of what has no mass between the parent and what hangs on it
    static void write_what_hangs_on(int parent, const JointedScene& scene,
                                    const HangingBodies& tree,
                                    std::ostringstream& out,
                                    const std::string& carriers = {})
    {
        for (std::size_t i = 0; i < tree.links.size(); ++i) {
            if (tree.links[i].parent != parent) continue;
            const RigidJoint& joint = tree.links[i].joint;
            const std::string joints = carriers + joint_of(joint, i);
            if (joint.b >= scene.bodies.count()) {
                write_what_hangs_on(static_cast<int>(i), scene, tree, out, joints);
                continue;
            }
            const Eigen::Rotation2D<Real> turn(joint.angle);
            out << "<body name='" << name_of("b", joint.b) << "' pos='"
                << in_space(joint.at_a - turn * joint.at_b) << "' euler='0 0 "
                << joint.angle << "'>" << joints << matter_of(scene, joint.b);
            write_what_hangs_on(static_cast<int>(i), scene, tree, out);
            out << "</body>";
        }
    }
    static std::string joint_of(const RigidJoint& joint, std::size_t number)
    {
        const Eigen::Rotation2D<Real> turn(joint.angle);
        const bool slides = joint.kind == JointKind::prismatic;
        std::ostringstream out;
        out << std::setprecision(17) << "<joint name='"
            << name_of("j", static_cast<Index>(number)) << "' pos='"
            << in_space(joint.at_b) << "' type='" << (slides ? "slide" : "hinge")
            << "' axis='"
            << (slides ? in_space(turn.inverse() * joint.axis) : "0 0 1") << '\'';
        if (is_limited(joint))
            out << " limited='true' range='" << joint.lower << ' ' << joint.upper
                << '\'';
        out << "/>";
        return out.str();
    }
    static std::string in_space(const Vec2& p)
    {
        std::ostringstream out;
        out << std::setprecision(17) << p.x() << ' ' << p.y() << " 0";
        return out.str();
    }
    static std::string friction_of(const JointedScene& scene)
    {
        std::ostringstream out;
        out << std::setprecision(17) << " friction='"
            << scene.surfaces.front().friction << " 0 0'/>";
        return out.str();
    }
    static std::string matter_of(const JointedScene& scene, Index k)
    {
        std::ostringstream out;
        const Real I = inertia_of_body(scene, k);
        out << std::setprecision(17) << "<inertial pos='0 0 0' mass='"
            << mass_of_body(scene, k) << "' diaginertia='" << I << ' ' << I << ' '
            << I << "'/>";
        if (!meets_something(scene)) return out.str();
        const Polygon& shape = scene.shapes[static_cast<std::size_t>(k)];
        const Vec2 half = half_sides(shape);
        if (is_disc(shape)) out << "<geom type='sphere' size='" << shape.radius;
        else if (is_capsule(shape))
            out << "<geom type='capsule' fromto='" << -length_of(shape) / 2
                << " 0 0 " << length_of(shape) / 2 << " 0 0' size='"
                << radius_of(shape);
        else
            out << "<geom type='box' size='" << half.x() << ' ' << half.y()
                << " 0.5";
        out << "' conaffinity='" << (meet_each_other(scene) ? 1 : 0) << '\''
            << friction_of(scene);
        return out.str();
    }

    mjModel* model_ = nullptr;
    mjData* data_ = nullptr;
    bool lost_ = false;
};

}  // namespace rigid
