/// \file elastic_contact.hpp
/// An elastic body and rigid bodies in the plane by the same rows.
///
///     H Δx = −∇G + h Jᵀ λ,   u = u* + M⁻¹ Jᵀ λ,   w = J (ẋ, u) + b                (30.18)
///     A = J_x H⁻¹ J_xᵀ + J_u M⁻¹ J_uᵀ                                            (30.19)
///
/// H, the matrix of Newton's step, stands where a rigid body has its M: a push moves all of
/// the elastic body within the step. Each iteration of Newton solves the Coulomb problem
/// of chapter 13 whole. A contact is between an edge of the outline, a capsule as thick as
/// the skin, and a rigid shape or a wall; the outline does not touch itself.
#pragma once

#include "chapters/12_contact_manifolds/manifold.hpp"
#include "chapters/12_contact_manifolds/placed_shape.hpp"
#include "chapters/13_friction/friction_active_sets.hpp"
#include "chapters/30_elastic_bodies/compliant_rows.hpp"

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

/// The step of both.
class ElasticContacts : public CompliantStep<2> {
public:
    /// [m]; contacts with a gap of up to that have a row
    Real margin = 0.03;

    /// One step of h. Throws std::invalid_argument for a step, friction, skin or body that
    /// makes no sense.
    void step(ElasticScene& scene, Real h);

private:
    void find_rows(const ElasticScene& scene, Real h);
    void add_contact(const ElasticScene& scene, CompliantRow<2> row,
                     const Vec2& normal, Real gap, Real h);
    void solve_rows(const VecX& v, const VecX& u, bool same);

    std::vector<std::array<int, 2>> outline_;
    std::vector<int> outline_of_;  ///< elements
    PlacedShapes placed_;
    Mlcp mlcp_;
    std::vector<FrictionBox> boxes_;
    FrictionMemory memory_;
};

}  // namespace rigid
