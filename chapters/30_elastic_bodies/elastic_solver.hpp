/// \file elastic_solver.hpp
/// One step, or the rest, of an elastic body: Newton's method on an energy.
///
///     y = x₀ + τ v₀,   G(x) = ½ ‖x − y‖²_M + τ² (Ψ(x) − fᵀx) + ½ τ (x − x₀)ᵀ B (x − x₀)   (30.8)
///     (M + τ B + τ² K(x)) Δ = −∇G,   x ← x + s Δ,   s = 1, ½, ¼, … until G falls           (30.9)
///
/// Implicit Euler: τ = h. Implicit midpoint: half a step of it, τ = ½ h, and the same way
/// once more. At rest: G = Ψ − fᵀx. B = α M + β K(x₀), (30.10).
#pragma once

#include "chapters/03_mlcp_formulation/mlcp.hpp"
#include "chapters/30_elastic_bodies/block_ldlt.hpp"
#include "chapters/30_elastic_bodies/elastic_model.hpp"

#include <vector>

namespace rigid {

/// A model, where it is and how it moves.
template <int Dim>
struct ElasticBody {
    ElasticModel<Dim> model;
    VecX x, v;                ///< positions [m], velocities [m/s] of the nodes
    VecX load;                ///< forces besides weight [N]
    std::vector<char> fixed;  ///< freedoms that keep their velocity, whatever pulls
    Vec<Dim> gravity = Vec<Dim>::Zero();  ///< [m/s²]
    Real mass_damping = 0;                ///< α [1/s]
    Real stiffness_damping = 0;           ///< β [s]

    ElasticBody(const ElasticMesh<Dim>& mesh, const ElasticMaterial& material)
        : model(mesh, material), x(mesh.rest), v(VecX::Zero(x.size())), load(v),
          fixed(static_cast<std::size_t>(x.size()), 0)
    {
    }
    auto at(int node) const { return x.template segment<Dim>(Dim * node); }
    /// All freedoms of a node.
    void hold(int node)
    {
        for (int c = 0; c < Dim; ++c)
            fixed[static_cast<std::size_t>(Dim * node + c)] = 1;
    }
    Real elastic_energy() const { return model.energy(x); }
    Real kinetic_energy() const;
    /// Of weight and load, zero where all coordinates are [J].
    Real potential_energy() const;
};

enum class TimeRule : unsigned char { implicit_euler, implicit_midpoint };
enum class LinearSolve : unsigned char { direct, conjugate_gradients };

struct NewtonOnEnergy {
    TimeRule rule = TimeRule::implicit_euler;
    LinearSolve solve = LinearSolve::direct;
    /// of the residual, as a share of inertia over an edge and of the force of strain 1
    Real tolerance = 1e-9;
    int most = 30;  ///< iterations
    /// how well a linear system is solved, of conjugate gradients
    Real linear_tolerance = 1e-3;
    int most_linear = 2000;  ///< their iterations
    /// a body that stays linear keeps its factor from step to step
    bool keeps_factor = true;
    /// the factor of another shape serves as long as each iteration takes the residual
    /// down to this share of itself; 0: each iteration has its own
    Real stale = 0;
};

/// Throws std::invalid_argument, naming the thing and the value, for lists of another
/// length than the mesh, numbers that are not finite, or damping below zero.
template <int Dim>
void require_valid(const ElasticBody<Dim>& body, const NewtonOnEnergy& settings);

/// How many ways to move without a strain the fixed freedoms leave to the pieces of a body
/// where it is at rest: 3 of a free one in the plane, 6 in space, 1 of a bar.
template <int Dim>
int rigid_motions(const ElasticBody<Dim>& body);

/// How well a step or a rest was found.
struct NewtonReport {
    Status status = Status::iteration_limit;
    Real residual = infinity;  ///< as NewtonOnEnergy::tolerance measures it
    int iterations = 0, factorisations = 0, linear_iterations = 0, halvings = 0;
};

template <int Dim>
class ElasticSolver {
public:
    NewtonOnEnergy settings;
    NewtonReport report;  ///< of the last call
    BlockLdlt<Dim> factor;

    /// One step of h [s].
    /// \throws std::invalid_argument  for a step that is not positive, or a state, load
    ///         or setting that is no number
    void step(ElasticBody<Dim>& body, Real h);

    /// To where forces and loads balance; fixed freedoms stay where they are. `singular`,
    /// and it stays where it is, if nothing holds it: loads pull along an axis along which
    /// no node is fixed, or a linear body can turn. `iteration limit` as well where what
    /// rounding leaves of the forces moves it by more than 1/500 of what its loads do.
    void rest(ElasticBody<Dim>& body);

    // The pieces of a step, for one that has contacts as well (elastic_contact.hpp).
    /// Sets y, x₀, B and the start; moves fixed freedoms. tau = 0: at rest
    void begin(ElasticBody<Dim>& body, Real tau);
    /// −∇G at body.x into `r`, its residual into the report; returns G [J s²].
    Real look(const ElasticBody<Dim>& body);
    /// H at body.x, factored or as a matrix. Returns false if it is not definite.
    bool prepare(const ElasticBody<Dim>& body);
    VecX r;  ///< −∇G [kg m], zero where a freedom is fixed
    /// (30.9) after look(): x ← x + s Δ with the first s = 1, ½, … at which G − pᵀx has
    /// fallen. Returns s; 0 if nothing is lower: x stays.
    /// \param push  p [kg m], an impulse times h on each freedom; empty: none
    Real descend(ElasticBody<Dim>& body, const VecX& change, const VecX& push);
    /// After an iteration that took the residual from `before` to `now`: whether its factor
    /// serves the next one as well, NewtonOnEnergy::stale, and whether a new one was so
    /// slow that the next is tried without the projection of its elements.
    /// \param enough  below it there is nothing to judge by
    void judge(Real before, Real now, Real enough)
    {
        renew_ = !(now <= settings.stale * before || now <= enough);
        is_slow_ = is_slow_ || (is_fresh_ && now > std::max(0.1 * before, enough));
    }
    /// The residual of r: with the impulses of contacts it is less.
    Real residual_of(const ElasticBody<Dim>& body, const VecX& r_left) const;
    /// Bytes that it keeps.
    std::size_t bytes() const;

private:
    void minimise(ElasticBody<Dim>& body);
    bool direction(ElasticBody<Dim>& body);
    bool is_loose(const ElasticBody<Dim>& body) const;
    /// At rest: whether the forces that are left, of rounding at best, move the body by at
    /// most 1/500 of what its loads do. Those of a slender one may do more.
    bool is_known(const ElasticBody<Dim>& body);
    void assemble(const ElasticBody<Dim>& body, bool projected);
    /// At rest, of a shape whose projected K has no inverse (inverted elements): a
    /// spring at every node, as weak as will do.
    bool soften(const ElasticBody<Dim>& body);
    bool has_kept(const ElasticBody<Dim>& body) const;
    void keep(const ElasticBody<Dim>& body);

    Real tau_ = 0;
    VecX x0_, y_, f_, difference_, product_, change_, before_;
    BlockMatrix<Dim> H_, B_;
    ConjugateGradients cg_;
    Real G_ = 0, rounding_ = 0;  ///< where look() was last, and of it
    Real noise_ = 0;             ///< of the residual at rest
    bool damped_ = false, renew_ = false;
    bool is_fresh_ = false;  ///< whether this iteration made its factor
    bool is_slow_ = false;   ///< whether one of this step's was too slow
    bool is_soft_ = false;   ///< whether its matrix is that of soften()
    BlockPattern analysed_;  ///< what the factor's order is of
    /// What the factor at hand is of, if it may be kept.
    struct {
        bool has = false, is_lumped = false;
        StrainLaw law = StrainLaw::linear;
        VecX rest;
        Lame lame;
        Real tau = -1, alpha = 0, beta = 0, mass = 0;
        std::vector<char> fixed;
    } kept_;
};

extern template struct ElasticBody<1>;
extern template struct ElasticBody<2>;
extern template struct ElasticBody<3>;
extern template class ElasticSolver<1>;
extern template class ElasticSolver<2>;
extern template class ElasticSolver<3>;

}  // namespace rigid
