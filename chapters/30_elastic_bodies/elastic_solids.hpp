/// \file elastic_solids.hpp
/// An elastic body of tetrahedra and the rigid bodies of chapter 25 by the same rows.
///
///     J_x = s_i n   on the nodes i of the point, Σ s_i = 1;   J_u of a rigid body as (23.3), (24.1)
///     A = J_x H⁻¹ J_xᵀ + J_u M⁻¹ J_uᵀ,   discs of friction (24.3)                    (30.19)
///
/// A node of the surface is a ball as thick as the skin, and a triangle of the surface
/// a flat solid; both meet walls, hulls and grounds of triangles by the functions of
/// chapter 25. Rigid bodies meet each other by its stage. The surface does not touch
/// itself.
#pragma once

#include "chapters/25_world_in_space/space_touching.hpp"
#include "chapters/30_elastic_bodies/compliant_rows.hpp"
#include "chapters/30_elastic_bodies/dense_cones.hpp"

#include <array>
#include <vector>

namespace rigid {

/// Rigid bodies, joints, walls and meshes in space, and one elastic body (of any number
/// of pieces).
struct ElasticSpace : SpaceScene {
    ElasticBody<3> elastic;
    Real soft_friction = 0.5;  ///< μ between the elastic body and all else
    Real skin = 0.005;  ///< radius around the surface of the elastic body [m]

    explicit ElasticSpace(ElasticBody<3> body) : elastic(std::move(body)) {}
};

class ElasticSolids : public CompliantStep<3> {
public:
    /// [m]; contacts with a gap of up to that have a row
    Real margin = 0.02;
    Real enough = 1e-9;  ///< residual of the rows [m/s]
    DenseCones cones;
    TouchingSolids touching;  ///< of rigid bodies with each other, walls and meshes

    /// One step of h. Throws std::invalid_argument for a step, friction, skin or body
    /// that makes no sense.
    void step(ElasticSpace& scene, Real h);

private:
    void find_rows(const ElasticSpace& scene, Real h);
    void find_rigid_rows(const ElasticSpace& scene, Real h);
    /// Nodes, then triangles, of the surface against one hull of body k, or a mesh.
    void touch_nodes(const ElasticSpace& scene, Real h);
    void touch_triangles(const ElasticSpace& scene, Real h);
    void take_touch(const ElasticSpace& scene, Index k, int at, bool is_node,
                    Real h);
    void add_contact(const ElasticSpace& scene, CompliantRow<3> row, Index k,
                     const Vec3& normal, Real h);
    void solve_rows(const VecX& v, const VecX& u, bool same);
    bool is_near(const ElasticSpace& scene, Index k, const Vec3& centre,
                 Real radius) const;

    std::vector<std::array<int, 3>> triangles_;
    std::vector<int> nodes_, triangles_of_;  ///< of the surface; of which elements
    std::vector<int> moving_;
    StepData<6> now_;
    MeshMemory flat_, ground_;  ///< a triangle as a solid; room
    SolidForm ball_;
    PlacedSolid node_;
    ClipRoom room_;
    SolidTouch touch_;
    std::size_t first_of_triangles_ = 0;
};

}  // namespace rigid
