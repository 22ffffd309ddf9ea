/// \file step_part.hpp
/// An island of a step as a step of its own: its bodies and rows numbered from 0.
///
/// So its solver costs as much as the island is large, however many bodies sleep beside it, and no bit of the answer depends on
/// another island. Numbers ascend as they did: the same rows make the same bits.
#pragma once

#include "chapters/03_mlcp_formulation/step_data.hpp"

#include <algorithm>
#include <tuple>
#include <utility>

namespace rigid {

/// Where parts of one step find their own numbers while they are made.
struct PartNumbers {
    std::vector<int> of_body;  ///< of each body of the scene: in the part; −1
    std::vector<int> of_row;   ///< of each row of the step, if it is in the part
};

//! [part]
struct StepPart {
    std::vector<int> rows;    ///< of the step, in the order that they have here
    std::vector<int> bodies;  ///< of the scene, ascending; walls of any kind too
    Bodies<3> local{0};
    StepData<3> now;
    SecondProblem second;
    VecX v;  ///< pseudo-velocities [m/s]
    /// of rows, which the step has not counted yet: several threads may solve parts
    std::int64_t visits = 0;

    //! [part]

    /// Takes an island in: numbers its rows and bodies, and in its rows what is beside
    /// these bodies and cannot move.
    /// \param members  of the island, ascending
    /// \param count    bodies of the scene
    void take(std::span<const int> island_rows, std::span<const int> members,
              const StepData<3>& whole, Index count, PartNumbers& numbers)
    {
        std::vector<int>& number_ = numbers.of_body;
        rows.assign(island_rows.begin(), island_rows.end());
        bodies.assign(members.begin(), members.end());
        number_.resize(static_cast<std::size_t>(count), -1);
        numbers.of_row.resize(whole.rows.size());
        const std::size_t active = bodies.size();
        for (const int k : bodies) at(number_, k) = 0;
        for (const int i : rows)
            for (const Index k : {whole.rows[at(i)].a, whole.rows[at(i)].b})
                if (k != world && at(number_, static_cast<int>(k)) < 0) {
                    at(number_, static_cast<int>(k)) = 1;  // not active here
                    bodies.push_back(static_cast<int>(k));
                }
        const auto beside = bodies.begin() + static_cast<std::ptrdiff_t>(active);
        std::sort(beside, bodies.end());
        std::inplace_merge(bodies.begin(), beside, bodies.end());
        now.active.clear();
        for (std::size_t i = 0; i < bodies.size(); ++i) {
            int& number = at(number_, bodies[i]);
            if (number == 0) now.active.push_back(static_cast<int>(i));
            number = static_cast<int>(i);
        }
        for (const int i : rows)  // a row that moves nothing is in no island
            if (const int n = whole.rows[at(i)].bounded_by; n >= 0)
                numbers.of_row[at(n)] = -1;
        for (std::size_t i = 0; i < rows.size(); ++i)
            numbers.of_row[at(rows[i])] = static_cast<int>(i);
        local.resize(static_cast<Index>(bodies.size()));
        v.setZero(3 * static_cast<Index>(bodies.size()));  // of others, before
        now.rows.resize(rows.size());
        local_.resize(rows.size());
        for (std::size_t i = 0; i < rows.size(); ++i) {
            const Row<3>& row = whole.rows[at(rows[i])];
            local_[i] = {
                row.a == world ? -1 : number_[at(row.a)], number_[at(row.b)],
                row.bounded_by < 0 ? -1 : numbers.of_row[at(row.bounded_by)]};
        }
        for (const int k : bodies) at(number_, k) = -1;  // ready for the next time
    }

    //! [gather]
    /// Takes in the state of the step: rows, velocities, the λ to start from.
    void gather(const Bodies<3>& all, const StepData<3>& whole)
    {
        gather_rows(all, whole);
        gather_velocities(all, whole);
    }
    void gather_velocities(const Bodies<3>& all, const StepData<3>& whole)
    {
        now.h = whole.h;
        now.length = whole.length;
        now.substep = whole.substep;
        now.second_half = whole.second_half;
        now.visits = 0;
        now.u_star.resize(local.u.size());
        for (std::size_t i = 0; i < bodies.size(); ++i) {
            const Index from = 3 * bodies[i], to = 3 * static_cast<Index>(i);
            local.x.segment<3>(to) = all.x.segment<3>(from);
            local.u.segment<3>(to) = all.u.segment<3>(from);
            now.u_star.segment<3>(to) = whole.u_star.segment<3>(from);
        }
        now.solution.lambda.resize(static_cast<Index>(rows.size()));
        for (std::size_t i = 0; i < rows.size(); ++i)
            now.solution.lambda[static_cast<Index>(i)] =
                whole.solution.lambda[rows[i]];
    }
    //! [gather]

    void gather_rows(const Bodies<3>& all, const StepData<3>& whole)
    {
        for (std::size_t i = 0; i < bodies.size(); ++i)
            local.inverse_mass.segment<3>(3 * static_cast<Index>(i)) =
                all.inverse_mass.segment<3>(3 * bodies[i]);
        for (std::size_t i = 0; i < rows.size(); ++i) {
            Row<3>& row = now.rows[i] = whole.rows[at(rows[i])];
            row.a = local_[i].a, row.b = local_[i].b;
            if (row.bounded_by >= 0 &&
                local_[i].bounded_by < 0)  // it stays as it is
                std::tie(row.lo, row.hi) = bounds_of(row, whole.solution.lambda);
            row.bounded_by = local_[i].bounded_by;
        }
    }

    /// Gives back velocities and λ.
    void scatter(Bodies<3>& all, StepData<3>& whole)
    {
        for (const int i : now.active)
            if (const int k = bodies[at(i)]; all.can_move(k))
                all.velocity(k) = local.velocity(i);
        scatter_lambda(whole);
    }
    void scatter_lambda(StepData<3>& whole)
    {
        for (std::size_t i = 0; i < rows.size(); ++i)
            whole.solution.lambda[rows[i]] =
                now.solution.lambda[static_cast<Index>(i)];
        visits += std::exchange(now.visits, 0);
    }

    /// Gives back the answer of a second problem.
    void scatter_apart(SecondProblem& all, VecX& all_v, StepData<3>& whole)
    {
        for (const int i : now.active)
            all_v.segment<3>(3 * bodies[at(i)]) = v.segment<3>(3 * i);
        const VecX& found = second.solution.lambda;
        for (std::size_t i = 0; i < rows.size(); ++i)
            all.solution.lambda[rows[i]] =
                found.size() == static_cast<Index>(rows.size())
                    ? found[static_cast<Index>(i)]
                    : 0;
        whole.visits += std::exchange(now.visits, 0);
    }

    /// The part of a second problem that is about these rows.
    void gather(const SecondProblem& all)
    {
        second.max_sweeps = all.max_sweeps;
        second.arcs = all.arcs;
        second.tolerance = all.tolerance;
        second.bias.resize(rows.size());
        second.left_out.resize(rows.size());
        for (std::size_t i = 0; i < rows.size(); ++i) {
            second.bias[i] = all.bias[at(rows[i])];
            second.left_out[i] =
                all.left_out.empty() ? 0 : all.left_out[at(rows[i])];
        }
    }

private:
    template <class Number>
    static std::size_t at(Number i)
    {
        return static_cast<std::size_t>(i);
    }
    static int& at(std::vector<int>& list, int i)
    {
        return list[static_cast<std::size_t>(i)];
    }
    struct Local {
        int a, b, bounded_by;
    };
    std::vector<Local>
        local_;  ///< of each row: what it names, in numbers of the part
};

}  // namespace rigid
