/// \file joint_curvature.hpp
/// How the J of a joint's row changes as one of its bodies moves: the second derivatives of block descent, K = ∂J/∂x.
///
///     point     C = n·p, n given         K = −(n·r) e eᵀ                    e = (0, 0, 1), r from the centroid to p
///     distance  C = ‖p − q‖              K = w wᵀ/‖p − q‖ − (n·r) e eᵀ      w = (t, n·r), t = n turned by a quarter
///     turning   C = n·s, n turns with    K = −t eᵀ − e tᵀ − (n·s) e eᵀ      of the body whose centroid s begins at
///
/// (16.29a). An angle has none, and neither have the rows of contacts, which are taken as linear over a sub-step.
#pragma once

#include "chapters/11_rotation/point_constraints.hpp"
#include "chapters/16_soft_constraints/block_solve.hpp"

namespace rigid {

//! [curvature]
/// ∂J/∂x of a row, of each of its bodies alone.
struct RowCurvature {
    Mat<3> a = Mat<3>::Zero(), b = Mat<3>::Zero();
};

/// Of n·p (bend = 0), or of ‖p − q‖ with bend = 1/‖p − q‖.
inline Mat<3> point_curvature(const Vec2& r, const Vec2& n, Real bend)
{
    const Vec2 t = perpendicular(n);
    const Vec<3> w(t.x(), t.y(), n.dot(r));
    Mat<3> K = bend * w * w.transpose();
    K(2, 2) -= n.dot(r);
    return K;
}

/// Of n·s where n turns with the body and s begins at its centroid.
inline Mat<3> turning_curvature(const Vec2& s, const Vec2& n)
{
    const Vec2 t = perpendicular(n);
    Mat<3> K = Mat<3>::Zero();
    K.col(2).head<2>() = -t;
    K.row(2).head<2>() = -t.transpose();
    K(2, 2) = -n.dot(s);
    return K;
}

/// (16.29a) of a joint's row.
/// \param nearest  points that are closer than that have no direction to turn: they
///                 count as so far apart [m]
inline RowCurvature joint_curvature(const VecX& x, const PointJoint& joint,
                                    Real nearest)
{
    using Measure = PointJoint::Measure;
    RowCurvature K;
    const Index a = joint.a, b = joint.b;
    const auto centre = [&x](Index k) {
        return k == world ? Vec2(0, 0) : Vec2(x.segment<2>(3 * k));
    };
    const Vec2 pa = point_of(x, a, joint.at_a), pb = point_of(x, b, joint.at_b),
               ra = pa - centre(a), rb = pb - centre(b);
    const auto bend = [nearest](const Direction& d) {
        return 1 / std::max(d.length, nearest);
    };
    switch (joint.measure) {
    case Measure::angle:
        break;
    case Measure::along:
        K.a = -point_curvature(ra, joint.direction, 0);
        K.b = point_curvature(rb, joint.direction, 0);
        break;
    case Measure::distance: {
        const Direction d(pb - pa);
        K.a = point_curvature(ra, -d.n, bend(d));  // ‖p_a − p_b‖
        K.b = point_curvature(rb, d.n, bend(d));
        break;
    }
    case Measure::turning: {
        const Vec2 n = a == world ? joint.direction
                                  : point_of(x, a, joint.direction) - centre(a);
        K.a = turning_curvature(pb - centre(a), n);
        K.b = point_curvature(rb, n, 0);
        break;
    }
    case Measure::pulley: {
        const Direction da(pa - joint.over_a), db(pb - joint.over_b);
        K.a = joint.gear_a * point_curvature(ra, da.n, bend(da));
        K.b = joint.gear_b * point_curvature(rb, db.n, bend(db));
        break;
    }
    case Measure::rack: {
        // n turns with b, and s leads from p_a to b's centroid
        const Vec2 n = point_of(x, b, joint.direction) - centre(b);
        K.a = -joint.gear_b * point_curvature(ra, n, 0);
        K.b = -joint.gear_b * turning_curvature(pa - centre(b), n);
        break;
    }
    }
    if (a == world) K.a.setZero();
    K.a *= joint.sense, K.b *= joint.sense;
    return K;
}
//! [curvature]

/// (16.29) of all joints of a step, where the bodies are.
/// \return  how many rows it has evaluated
std::int64_t find_curvatures(const RigidScene& scene, const StepData<3>& now,
                             RowsOfBodies& meet);

}  // namespace rigid
