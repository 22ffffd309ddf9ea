/// \file elastic_contact.hpp
/// An elastic body and rigid bodies in the plane by the same rows.
///
///     H Δx = −∇G + h Jᵀ λ,   u = u* + M⁻¹ Jᵀ λ,   w = J (ẋ, u) + b                (29.21)
///     A = J_x H⁻¹ J_xᵀ + J_u M⁻¹ J_uᵀ                                            (29.22)
///
/// H, the matrix of Newton's step, stands where a rigid body has its M: a push moves all of
/// the elastic body within the step. Each iteration of Newton solves the Coulomb problem
/// of chapter 13 whole. A contact is between an edge of the outline, a capsule as thick as
/// the skin, and a rigid shape or a wall; the outline does not touch itself.
#pragma once

#include "chapters/12_contact_manifolds/manifold.hpp"
#include "chapters/12_contact_manifolds/placed_shape.hpp"
#include "chapters/13_friction/friction_active_sets.hpp"
#include "chapters/29_elastic_bodies/elastic_solver.hpp"

#include <array>
#include <vector>

namespace rigid {

/// Rigid bodies, joints and walls, and one elastic body (of any number of pieces).
struct ElasticScene : RigidScene {
    ElasticBody<2> elastic;
    Real friction = 0.5;  ///< μ of all contacts
    Real skin = 0.005;    ///< radius of the outline of the elastic body [m]

    explicit ElasticScene(ElasticBody<2> body) : elastic(std::move(body)) {}
};

/// A row on up to two nodes of the elastic body and up to two rigid bodies. b may be the
/// world here, when the row is between a rigid body, or the world, and the elastic one.
struct CompliantRow {
    Row<3> rigid;
    int count = 0;  ///< nodes
    std::array<int, 2> node{};
    std::array<Vec2, 2> push{Vec2(0, 0), Vec2(0, 0)};  ///< blocks of J
    Vec2 point = {0, 0};                               ///< where it acts [m]
    Real gap = 0;                                      ///< of a contact [m]

    Real velocity(const VecX& v, const VecX& u) const;
};

/// The step of both.
class ElasticContacts {
public:
    ElasticSolver<2> solver;  ///< its rule and its linear solver are not looked at
    /// [m]; contacts with a gap of up to that have a row
    Real margin = 0.03;
    Real repaid = 0.2;  ///< share of an overlap that a step pushes out
    int most = 12;      ///< iterations of Newton's method
    Real tolerance = 1e-8;

    std::vector<CompliantRow> rows;  ///< of the last step
    Solution solution;               ///< λ of these [N s]
    NewtonReport report;

    /// One step of h. Throws std::invalid_argument for a step, friction, skin or body that
    /// makes no sense.
    void step(ElasticScene& scene, Real h);

private:
    void find_rows(const ElasticScene& scene, Real h);
    void add_contact(const ElasticScene& scene, CompliantRow row,
                     const Vec2& normal, Real gap, Real h);
    void solve_rows(const ElasticScene& scene, const VecX& v, const VecX& u);

    std::vector<std::array<int, 2>> outline_;
    std::vector<int> outline_of_;  ///< elements
    PlacedShapes placed_;
    std::vector<VecX> answer_;  ///< H⁻¹ Jᵀ of each row
    Mlcp mlcp_;
    std::vector<FrictionBox> boxes_;
    FrictionMemory memory_;
    VecX x0_, v_, change_, left_;
};

}  // namespace rigid
