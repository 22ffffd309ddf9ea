/// \file friction_islands.hpp
/// A small island with friction solved exactly from where its λ stand, by Algorithm 13.2.
///
///     w = A λ + q,   q = w_now − A λ_now
///
/// What section 10.C does for islands without friction. Here λ itself is the unknown and not its correction: the bounds of
/// friction are a cone around zero, and not around λ_now.
#pragma once

#include "chapters/10_skipping_work/by_islands.hpp"
#include "chapters/13_friction/friction_active_sets.hpp"

namespace rigid {

//! [friction_islands]
struct ExactFrictionIslands {
    /// islands of up to so many rows are solved exactly; 0 = none, all are swept
    int most_rows = 0;
    FrictionSettings settings;

    /// Room for islands of one number of rows. What one found is nothing to the next.
    struct Room {
        Mlcp mlcp;  ///< A is stored full: n columns in each line
        FrictionMemory memory;
        Solution solution;
    };
    std::vector<Room> rooms;
    std::vector<FrictionBox> boxes;

    /// Where Algorithm 13.2 has no answer, λ and u are left as they are.
    /// \param enough  if the natural residual is below this, there is nothing to
    ///                solve [m/s]
    template <int Dof>
    IslandAnswer operator()(std::span<SolverRow<Dof>> rows,
                            std::span<const Feedback> feedback, Real enough,
                            VecX& u)
    {
        IslandAnswer answer;
        const auto n = static_cast<Index>(rows.size());
        if (n > most_rows) return answer;
        take_all_bounds<Dof>(rows, feedback);
        answer.residual = natural_residual<Dof>(rows, u);
        answer.visits = n;
        if (answer.residual <= enough) {
            answer.status = Status::solved;
            return answer;
        }
        Room& room = room_of(n);
        write_problem<Dof>(rows, feedback, u, room);
        room.memory.factor.forget();  // of another island
        friction_active_sets(room.mlcp, boxes, settings, room.memory,
                             room.solution);
        answer.status = room.solution.status;
        answer.residual = room.solution.residual;
        answer.sweeps = room.solution.iterations;
        if (answer.status != Status::solved) return answer;
        for (Index i = 0; i < n; ++i) {
            SolverRow<Dof>& row = rows[static_cast<std::size_t>(i)];
            const Real change = room.solution.lambda[i] - row.lambda;
            row.lambda = room.solution.lambda[i];
            u.template segment<Dof>(row.a) += row.Wa * change;
            u.template segment<Dof>(row.b) += row.Wb * change;
            give_way(&row, feedback[static_cast<std::size_t>(i)]);
        }
        take_all_bounds<Dof>(rows, feedback);
        return answer;
    }
    //! [friction_islands]

private:
    Room& room_of(Index n);

    /// A, q, bounds, boxes, and the λ to start from.
    template <int Dof>
    void write_problem(std::span<const SolverRow<Dof>> rows,
                       std::span<const Feedback> feedback, const VecX& u,
                       Room& room)
    {
        Mlcp& mlcp = room.mlcp;
        const auto n = static_cast<Index>(rows.size());
        boxes.clear();
        for (Index i = 0; i < n; ++i) {
            const SolverRow<Dof>& row = rows[static_cast<std::size_t>(i)];
            const Feedback& follows = feedback[static_cast<std::size_t>(i)];
            for (Index j = 0; j <= i; ++j)
                mlcp.A.valuePtr()[i * n + j] = mlcp.A.valuePtr()[j * n + i] =
                    coupling(row, rows[static_cast<std::size_t>(j)]) +
                    (i == j ? follows.softness : 0);
            room.solution.lambda[i] = row.lambda;
            mlcp.lo[i] = row.lo;
            mlcp.hi[i] = row.hi;
            if (follows.bounding != 0)
                boxes.push_back({i, i + follows.bounding, follows.friction});
        }
        for (Index i = 0; i < n; ++i) {
            const SolverRow<Dof>& row = rows[static_cast<std::size_t>(i)];
            Real q = velocity<Dof>(row, u.template segment<Dof>(row.a),
                                   u.template segment<Dof>(row.b));
            for (Index j = 0; j < n; ++j)
                q -= mlcp.A.valuePtr()[i * n + j] *
                     rows[static_cast<std::size_t>(j)].lambda;
            mlcp.q[i] = q;
        }
    }
};

}  // namespace rigid
