/// \file acceleration_level.hpp
/// A constraint as an acceleration: forces from an LCP, a step of order four between events, impacts apart.
///
///     A f + q,   A = J M⁻¹ Jᵀ,   q = J M⁻¹ f_ext + k,   d²C/dt² = A f + q
///     joints     d²C/dt² = 0
///     contacts   0 ≤ f ⟂ d²C/dt² ≥ 0          where C = 0 and dC/dt = 0
///     slides     f_t = −μ f sign(v_t): A is no longer symmetric, and may have no answer (Painlevé)
///     sticks     |f_t| ≤ μ f, a_t = 0
///
/// (26.4), (26.5). Without friction A is symmetric and Dantzig's pivots find f (chapter 9), as in \cite baraff1994; with it
/// what pushed a moment ago is tried first, then chapter 13's guesses or Lemke's algorithm. Where none finds an answer the run
/// ends there, and its status says so.
#pragma once

#include "chapters/13_friction/impact_laws.hpp"
#include "chapters/26_four_ways/push_joints.hpp"

namespace rigid {

struct AccelerationSettings : EventSettings {
    /// what moves more slowly is at rest: closes, sticks [ℓ/s]
    Real stick_speed = 1e-6;
    /// α of Baumgarte's d²C/dt² + 2α dC/dt + α² C = 0 of what is closed [1/s]
    Real rate = 0;
};

/// Throws std::invalid_argument, naming the setting and its value, unless all make sense.
void require_valid(const AccelerationSettings& settings);

/// What a run has done, for benchmarks and for the reader.
struct AccelerationWork {
    std::int64_t evaluations = 0;  ///< of accelerations
    std::int64_t pivots = 0;       ///< of their LCPs
    std::int64_t impacts = 0, events = 0;
};

class AccelerationLevel {
public:
    AccelerationSettings settings;
    CollisionFilter filter;
    AccelerationWork work;

    /// Advances by h seconds. Returns `solved`, or the status of what could not be: `ray termination`, `infeasible` where the
    /// law has no finite force, `iteration limit` after too many events; then the scene stands where that was.
    /// \throws std::invalid_argument  for settings, a step or a scene that make no sense, and for what has no acceleration:
    ///                                motors and springs of joints
    Status advance(JointedScene& scene, Real h);

    /// What advance() asks of settings and scene. \throws std::invalid_argument  as it does
    void require_valid(const JointedScene& scene) const;

    /// The accelerations at (x, u) with the closed contacts of the last call of close(); f of each row in forces().
    /// \param a  of all bodies: [m/s², rad/s²]
    Status accelerations(const JointedScene& scene, const VecX& x, const VecX& u,
                         VecX& a);

    /// Finds what may touch within a motion of `reach` metres, and what of it is closed.
    void close(const JointedScene& scene, Real reach);

    const VecX& forces() const { return solution_.lambda; }
    /// (26.5) as it was solved last, unless joints alone had to be: A, q and the bounds of rows, and which of them are friction.
    const Mlcp& problem() const { return mlcp_; }
    const std::vector<FrictionBox>& boxes() const { return boxes_; }
    std::size_t closed() const { return closed_.size(); }

private:
    struct Closed {
        std::size_t joint = 0;  ///< in near_
        int slides = 0;         ///< sign of v_t; 0: sticks
    };

    bool as_before(const MatX& A);
    bool impact(JointedScene& scene);
    Status move(const JointedScene& scene, Real h, VecX& x, VecX& u);
    /// How far the state is from its next event: below zero is past one.
    Real open(const JointedScene& scene, const VecX& x, const VecX& u) const;

    std::vector<PushJoint> near_;
    std::vector<Closed> closed_;
    Index bodies_closed_ = 0;  ///< of the scene of near_
    std::vector<Row<3>> rows_;
    std::vector<FrictionBox> boxes_;
    std::vector<Real> slip_;  ///< μ sign(v_t) of each row, 0: none
    std::vector<Row<3>> drags_;
    JointAccelerations joints_;
    FindFriction find_;
    FindByStewartTrinkle walk_;
    Mlcp mlcp_;
    Solution solution_;
    VecX guess_;  ///< the last forces with friction [N]
    Real length_ = 1;
};

}  // namespace rigid
