/// \file elastic_model.hpp
/// A mesh and a material: energy, forces, stiffness and mass of all elements together.
///
///     F = Σ_a x_a G_aᵀ,   f_a = −w P G_a,   K_ab = w ∂P/∂F : G_a ⊗ G_b            (30.2), (30.5), (30.6)
///
/// sums over points of integration: G_a = ∇N_a there, w the volume that the point stands
/// for. A linear element has one point, a quadratic one Dim + 1. One code for bars,
/// triangles and tetrahedra.
#pragma once

#include "chapters/30_elastic_bodies/block_matrix.hpp"
#include "chapters/30_elastic_bodies/elastic_mesh.hpp"
#include "chapters/30_elastic_bodies/strain_energy.hpp"

#include <vector>

namespace rigid {

template <int Dim>
class ElasticModel {
public:
    /// Throws std::invalid_argument, naming the thing and the value, for a mesh or a
    /// material that makes no sense.
    ElasticModel(const ElasticMesh<Dim>& mesh, const ElasticMaterial& material);

    const ElasticMesh<Dim>& mesh() const { return mesh_; }
    const ElasticMaterial& material() const { return material_; }
    const Lame& lame() const { return lame_; }
    const BlockPattern& pattern() const { return pattern_; }
    int nodes() const { return mesh_.nodes(); }
    Real edge() const
    {
        return edge_;
    }  ///< a length that displacements compare with [m]

    /// Elastic energy at the positions x [J].
    Real energy(const VecX& x) const;

    /// Adds −∂Ψ/∂x [N] to f; returns the energy [J].
    Real add_forces(const VecX& x, VecX& f) const;

    /// Adds scale · ∂²Ψ/∂x² to H.
    /// \param projected  made positive semi-definite, element by element
    void add_stiffness(const VecX& x, Real scale, bool projected,
                       BlockMatrix<Dim>& H) const;

    /// Adds scale · M to H.
    void add_mass(Real scale, BlockMatrix<Dim>& H) const;
    /// y ← M x
    void multiply_mass(const VecX& x, VecX& y) const;
    /// What a node has of the mass when all move alike, Σ_b M_ab [kg]: what weight pulls
    /// at. Of the corners of a quadratic triangle it is zero.
    Real mass_at(int node) const { return share_[node]; }
    /// A positive number of that size, M_aa, scaled to the mass of the body [kg].
    Real inertia_at(int node) const { return lumped_[node]; }
    Real mass() const;
    /// The masses as numbers of their nodes alone, none between two nodes.
    void lump();
    bool is_lumped() const { return is_lumped_; }

    /// What strain 1 pulls at a node with [N]: what forces compare with.
    Real force_scale(int node) const { return scale_[node]; }
    /// The largest |G|, about [1/m]: a node that moves by a strains what is next to it by
    /// a times that.
    Real steepest() const;

    int points() const { return static_cast<int>(weight_.size()); }
    Real weight(int point) const
    {
        return weight_[static_cast<std::size_t>(point)];
    }
    int element_of(int point) const { return point / per_element_; }
    /// F at a point of integration.
    Mat<Dim> deformation(const VecX& x, int point) const;
    /// Where it is at rest [m].
    Vec<Dim> place(int point) const;
    /// P = ∂Ψ/∂F there [Pa]; adds up the energy density [J/m³].
    Mat<Dim> stress(const Mat<Dim>& F, Real& density) const;
    /// Bytes of the model itself.
    std::size_t bytes() const;

private:
    const Real* gradients(int point) const
    {
        return gradient_.data() +
               static_cast<std::ptrdiff_t>(point) * mesh_.per_element() * Dim;
    }

    ElasticMesh<Dim> mesh_;
    ElasticMaterial material_;
    Lame lame_;
    BlockPattern pattern_;
    Real edge_ = 0;
    bool is_lumped_ = false;
    int per_element_ = 1;         ///< points of integration
    std::vector<Real> weight_;    ///< [m^Dim]
    std::vector<Real> gradient_;  ///< G of each point and node [1/m]
    std::vector<Real> shape_;     ///< N of each point of an element and node
    std::vector<int> slot_;       ///< of the pairs (a, b ≤ a) of each element
    std::vector<Real> mass_;      ///< of each slot [kg]
    VecX share_, scale_, lumped_;
};

extern template class ElasticModel<1>;
extern template class ElasticModel<2>;
extern template class ElasticModel<3>;

}  // namespace rigid
