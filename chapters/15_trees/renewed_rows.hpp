/// \file renewed_rows.hpp
/// J of some rows where the bodies are now, for a while.
#pragma once

#include "chapters/15_trees/newton_settings.hpp"

namespace rigid {

struct RenewedRows {
    template <class Scene, class Apart>
    void renew(const Scene& scene, std::span<const int> rows,
               const std::vector<char>& left_out, Apart& apart, StepData<3>& now)
    {
        const Bodies<3>& bodies = scene.bodies;
        before_.resize(now.rows.size());
        for (const int i : rows) {
            const auto at = static_cast<std::size_t>(i);
            Row<3>& row = now.rows[at];
            if (!renewed_) before_[at] = row;
            Constraint<3>& c = now.constraints[at];
            if (left_out[at])  // not looked at yet
                c = constraint_at(scene, now, at, bodies.x);
            const Row<3> fresh = bilateral(c, bodies.inverse_mass);
            row.Ja = fresh.Ja, row.Jb = fresh.Jb;
            row.Wa = fresh.Wa, row.Wb = fresh.Wb;
        }
        apart.factor_again(bodies, now);
        renewed_ = true;
    }
    /// The rows of the step again: those that λ belongs to.
    void put_back(std::span<const int> rows, StepData<3>& now);

private:
    std::vector<Row<3>> before_;
    bool renewed_ = false;
};

}  // namespace rigid
