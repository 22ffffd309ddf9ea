/// \file renewed_rows.hpp
/// J of some rows where the bodies are now, for a while, and M with what these rows stiffen.
///
///     (M + K) δx = Jᵀ Λ,   J δx = −C            K: Σ r·F where a body turns, 2 T/L at both ends of a line               (15.12a)
#pragma once

#include "chapters/15_trees/line_inertance.hpp"
#include "chapters/15_trees/newton_settings.hpp"

namespace rigid {

//! [foreseen]
/// What C of each row will be by its J: how far off that was tells whether J still fits.
struct ForeseenErrors {
    std::vector<Real> C;  ///< [m, rad]

    /// The bodies are to move by h v.
    void note(Real h, std::span<const int> rows, const VecX& v,
              const StepData<3>& now)
    {
        C.resize(now.rows.size());
        for (const int i : rows) {
            const auto at = static_cast<std::size_t>(i);
            const Row<3>& row = now.rows[at];
            C[at] = now.constraints[at].C + h * (row.velocity(v) - row.bias);
        }
    }
    Real off(int row, Real found) const
    {
        return std::abs(found - C[static_cast<std::size_t>(row)]);
    }
};

/// So many rounds bring what J foresees down to what it does not, at the rate of the
/// last one: one at least.
inline int rounds(Real off, Real before, Real bent, int most)
{
    int count = 1;
    for (Real left = off * (off / before); left > bent && count < most; ++count)
        left *= off / before;
    return count;
}
//! [foreseen]

struct RenewedRows {
    //! [renew]
    /// \param h       Λ is h λ of the last problem [kg m]
    /// \param pulled  whether there was one
    template <class Scene, class Apart>
    void renew(Scene& scene, Real h, std::span<const int> rows,
               std::span<const int> members, const SecondProblem& last, bool pulled,
               Apart& apart, StepData<3>& now)
    {
        Bodies<3>& bodies = scene.bodies;
        begin(rows, members, bodies, now);
        const bool tied = std::any_of(rows.begin(), rows.end(), [&](int i) {
            const Row<3>& row = now.rows[static_cast<std::size_t>(i)];
            return !bodies.can_move(row.a) || !bodies.can_move(row.b);
        });
        for (const int i : rows) {
            const auto at = static_cast<std::size_t>(i);
            if (last.left_out[at])  // not looked at yet
                now.constraints[at] = constraint_at(scene, now, at, bodies.x);
            else if (pulled && is_of_joint(now, i))
                add_stiffness(scene, now, i, h * last.solution.lambda[i], tied,
                              stiffness_);
        }
        for (const int k : members) {
            const auto m = own_.segment<3>(3 * k).array();
            bodies.inverse_mass.segment<3>(3 * k) =
                m / (1 + m * stiffness_.segment<3>(3 * k).array().max(0));
        }
        for (const int i : rows) {
            Row<3>& row = now.rows[static_cast<std::size_t>(i)];
            const Row<3> fresh = bilateral(
                now.constraints[static_cast<std::size_t>(i)], bodies.inverse_mass);
            row.Ja = fresh.Ja, row.Jb = fresh.Jb;
            row.Wa = fresh.Wa, row.Wb = fresh.Wb;
        }
        apart.factor_again(bodies, now);
    }
    //! [renew]
    /// The rows of the step again, those that λ belongs to, and M.
    void put_back(std::span<const int> rows, std::span<const int> members,
                  Bodies<3>& bodies, StepData<3>& now);

private:
    void begin(std::span<const int> rows, std::span<const int> members,
               const Bodies<3>& bodies, const StepData<3>& now);

    std::vector<Row<3>> before_;
    VecX own_;        ///< inverse masses, without K
    VecX stiffness_;  ///< K
    bool renewed_ = false;
};

}  // namespace rigid
