/// \file compliant_rows.hpp
/// A row on nodes of an elastic body and on rigid bodies, and the step that has such rows.
///
///     H Δx = −∇G + h Jᵀ λ,   u = u* + M⁻¹ Jᵀ λ,   w = J (ẋ, u) + b                (30.18)
///     A = J_x H⁻¹ J_xᵀ + J_u M⁻¹ J_uᵀ                                            (30.19)
///
/// H, the matrix of Newton's step, stands where a rigid body has its M: a push moves all
/// of the elastic body within the step. Each iteration of Newton solves the problem of
/// all rows whole, in the plane by chapter 13, in space with discs.
#pragma once

#include "chapters/02_velocity_constraints/constraints.hpp"
#include "chapters/30_elastic_bodies/elastic_solver.hpp"

#include <array>
#include <vector>

namespace rigid {

/// Up to two rigid bodies, and a point of the elastic body that lies between up to Dim
/// nodes. b may be the world here, when the row is between a rigid body, or the world,
/// and the elastic one.
template <int Dim>
struct CompliantRow {
    static constexpr int dof = Dim == 2 ? 3 : 6;
    Row<dof> rigid;
    int count = 0;  ///< nodes
    std::array<int, Dim> node{};
    std::array<Real, Dim> share{};      ///< of each node in the point
    Vec<Dim> along = Vec<Dim>::Zero();  ///< J of a node is its share of this
    Vec<Dim> point = Vec<Dim>::Zero();  ///< where it acts [m]
    Real gap = 0;                       ///< of a contact [m]

    /// J of node i, component c.
    Real push(int i, int c) const
    {
        return share[static_cast<std::size_t>(i)] * along[c];
    }
    /// w at the velocities of the nodes and of the bodies [m/s].
    Real velocity(const VecX& v, const VecX& u) const;
    /// f ← f + scale Jᵀ, on freedoms that are not fixed
    void add_push(Real scale, const std::vector<char>& fixed, VecX& f) const;
    /// How much of what it pushes cannot give way: on a body that can move, none.
    enum class Held : unsigned char { none, some, all };
    Held held_by(const ElasticBody<Dim>& body) const;
    /// Whether w is negative and no λ changes it: nodes that are held and a body that
    /// cannot move overlap, or come together.
    bool is_stuck(const ElasticBody<Dim>& body, const VecX& u) const
    {
        return held_by(body) == Held::all && velocity(body.v, u) < 0;
    }
};

template <int Dim>
class CompliantStep {
public:
    static constexpr int dof = CompliantRow<Dim>::dof;
    /// by implicit Euler, with its factor; its iterations and tolerance are those below
    ElasticSolver<Dim> solver;
    int most = 30;          ///< iterations of Newton's method
    Real tolerance = 1e-8;  ///< of the residual with the impulses in it
    Real repaid = 0.2;      ///< share of an overlap that a step pushes out
    Real max_correction_speed = infinity;  ///< at which it does so [m/s]

    std::vector<CompliantRow<Dim>> rows;  ///< of the last step
    Solution solution;                    ///< λ of these [N s]
    NewtonReport report;
    int answers = 0;  ///< systems H⁻¹ Jᵀ that the last step has solved

protected:
    /// Newton's iterations of a step of h with these rows, then velocities; positions of
    /// rigid bodies are the caller's.
    /// \param solve  void(v, u, bool same): λ of all rows into `solution` at these
    ///               velocities; same: A is that of the iteration before
    template <class Solve>
    void iterate(ElasticBody<Dim>& body, Bodies<dof>& bodies, Real h,
                 const Solve& solve);

    /// b of a contact with that gap, or overlap [m/s].
    Real bias_of(Real gap, Real h) const
    {
        return gap > 0 ? gap / h
                       : std::max(repaid * gap / h, -max_correction_speed);
    }
    /// The same for one with the elastic body. What its free nodes share with held ones
    /// is kept from going deeper and not pushed out: they would go as far as 1/share.
    Real bias_of(const CompliantRow<Dim>& row, const ElasticBody<Dim>& body,
                 Real h) const
    {
        using Held = typename CompliantRow<Dim>::Held;
        return row.gap < 0 && row.held_by(body) == Held::some ? 0
                                                              : bias_of(row.gap, h);
    }

    /// (30.19): A_ij, after find_answers(); the lower half counts for both, so that A is
    /// symmetric to the bit.
    Real entry(std::size_t i, std::size_t j) const;

    /// Throws std::invalid_argument, naming the value, for a friction or skin that is
    /// negative, or settings that make no sense.
    void require_valid(Real friction, Real skin, Real margin) const;

private:
    void find_answers(const ElasticBody<Dim>& body);

    std::vector<VecX> answer_;  ///< H⁻¹ Jᵀ of each row
    VecX x0_, v_, change_, push_;
};

//! [step]
template <int Dim>
template <class Solve>
void CompliantStep<Dim>::iterate(ElasticBody<Dim>& body, Bodies<dof>& bodies,
                                 Real h, const Solve& solve)
{
    x0_ = body.x;
    solver.begin(body, h);
    report = {};
    report.residual = solver.report.residual;
    answers = 0;
    solution.lambda.setZero(static_cast<Index>(rows.size()));
    while (report.iterations < most) {
        ++report.iterations;
        const Real before = report.residual;
        const int factorisations = solver.report.factorisations;
        if (!solver.prepare(body)) {
            report.status = Status::singular;
            break;
        }
        const bool same =
            report.iterations > 1 && solver.report.factorisations == factorisations;
        change_ = solver.r;
        solver.factor.solve(change_);
        v_ = (body.x + change_ - x0_) / h;
        for (Index i = 0; i < v_.size(); ++i)
            if (body.fixed[static_cast<std::size_t>(i)]) v_[i] = body.v[i];
        if (!same) find_answers(body);
        solve(v_, bodies.u, same);
        push_.setZero(v_.size());
        for (std::size_t i = 0; i < rows.size(); ++i) {
            const Real lambda = solution.lambda[static_cast<Index>(i)];
            if (rows[i].count == 0 || lambda == 0) continue;
            change_ += (h * lambda) * answer_[i];
            rows[i].add_push(h * lambda, body.fixed, push_);
        }
        // (30.26): λ as a load; only where a whole step ends do these λ belong
        const Real s = solver.descend(body, change_, push_);
        push_ += solver.r;
        report.residual = solver.residual_of(body, push_);
        solver.judge(before, report.residual, tolerance);
        if (s == 0) break;  // nothing is lower: as far as it came
        if (s == 1 && report.residual <= tolerance) {
            report.status = rows.empty() ? Status::solved : solution.status;
            break;
        }
    }
    report.factorisations = solver.report.factorisations;
    for (Index i = 0; i < body.x.size(); ++i)
        if (!body.fixed[static_cast<std::size_t>(i)])
            body.v[i] = (body.x[i] - x0_[i]) / h;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const Row<dof>& row = rows[i].rigid;
        const Real lambda = solution.lambda[static_cast<Index>(i)];
        if (row.a != world) bodies.velocity(row.a) += row.Wa * lambda;
        if (row.b != world) bodies.velocity(row.b) += row.Wb * lambda;
    }
}
//! [step]

extern template struct CompliantRow<2>;
extern template struct CompliantRow<3>;
extern template class CompliantStep<2>;
extern template class CompliantStep<3>;

}  // namespace rigid
