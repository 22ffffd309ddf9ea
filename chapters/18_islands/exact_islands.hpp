/// \file exact_islands.hpp
/// An island that is solved exactly, what it need not be solved for, and where it has its memory from.
///
///     u = u* + M⁻¹ Jᵀ λ_old,     r(λ_old, u) ≤ 5 · 10⁻¹⁰ ℓ/s     then λ = λ_old
///
/// The exact solver takes a λ that is as good as that for an answer, too. What rests is neither eliminated, factored nor
/// guessed; so it gives back the memory of its solver, and the next island is solved where that one was.
#pragma once

#include "chapters/18_islands/island_rescue.hpp"

#include <deque>
#include <mutex>

namespace rigid {

//! [stock]
/// Memory for exact solves: lent to an island while it needs it. Several threads may
/// ask for some.
class TreeStock {
public:
    FrictionSettings exact;    ///< of all that is lent: how hard it tries …
    int most_exact = 600;      ///< … and with how many rows with bounds
    std::int64_t visits = 0;   ///< of rows, by what has been given back
    std::int64_t entries = 0;  ///< that it looked at in this step

    TreePart& at(int number)
    {
        const std::lock_guard<std::mutex> alone(door_.one);  // it may be growing
        return one(number);
    }

    /// The number of one for these rows and bodies, which are those of an island.
    int lend(std::span<const int> rows, std::span<const int> members,
             const StepData<3>& now, Index bodies)
    {
        const std::lock_guard<std::mutex> alone(door_.one);
        if (idle_.empty()) {
            idle_.push_back(static_cast<int>(all_.size()));
            all_.emplace_back();
        }
        const int number = idle_.back();
        idle_.pop_back();
        one(number).part.take(rows, members, now, bodies, numbers_);
        one(number).forget();
        return number;
    }
    void take_back(int number)
    {
        const std::lock_guard<std::mutex> alone(door_.one);
        entries += one(number).all_entries();
        visits += std::exchange(one(number).part.visits, 0);
        idle_.push_back(number);
    }
    /// It stays where it is, but begins with nothing, as if it had been back.
    void forget(int number)
    {
        const std::lock_guard<std::mutex> alone(door_.one);
        entries += one(number).all_entries();
        one(number).forget();
    }
    std::size_t size() const { return all_.size(); }

private:
    TreePart& one(int number) { return all_[static_cast<std::size_t>(number)]; }

    /// A copy of the stock has a door of its own.
    struct Door {
        std::mutex one;
        Door() = default;
        Door(const Door&) {}
        Door& operator=(const Door&) { return *this; }
    };
    std::deque<TreePart> all_;  ///< grows where they stand
    std::vector<int> idle_;
    PartNumbers numbers_;
    Door door_;
};
//! [stock]

/// Whose rows are solved, and from where its memory is.
struct RowsToSolve {
    TreeStock& stock;
    std::span<const int> rows, members;
};

/// An island that is solved exactly. Its trees are lent to it while it moves.
struct ExactIsland {
    int trees = -1;           ///< in the stock; −1 = it has none
    bool answered = false;    ///< by its old impulses, in the last sub-step
    Real residual = 0;        ///< then [m/s]
    std::int64_t visits = 0;  ///< of rows, by answers
    bool is_fresh = false;    ///< part and factors are of this sub-step
    bool is_known = false;    ///< it has been solved since it is there

    //! [answered]
    /// \param enough  the tolerance to which others settle [m/s]
    /// \param slow    what is slower after its first solve has come to rest: it is
    ///                answered from now on, and gives its trees back [m/s]
    void solve(const RowsToSolve& of, Real enough, Real slow, Bodies<3>& bodies,
               StepData<3>& now)
    {
        push(now, of.rows, of.members, bodies);
        visits += static_cast<std::int64_t>(of.rows.size());
        residual = natural_residual(now, of.rows, bodies.u);
        answered = residual <= std::min(1e-9 * now.length / 2, enough);
        is_fresh = !answered;
        if (answered) return;
        borrow(of, bodies, now).solve(bodies, now);
        const bool first = !std::exchange(is_known, true);
        if (!are_slow(of.members, bodies.u, slow, now.length)) return;
        if (first) give_back(of.stock);
        else of.stock.forget(trees), is_fresh = false;  // to the same bits
    }
    //! [answered]

    /// Another problem on the same rows needs their factors.
    TreePart& refresh(const RowsToSolve& of, const Bodies<3>& bodies,
                      const StepData<3>& now)
    {
        TreePart& one = borrow(of, bodies, now);
        if (is_fresh) return one;
        one.part.gather(bodies, now);
        one.solver.factor_again(one.part.local, one.part.now);
        is_fresh = true;
        return one;
    }

    void give_back(TreeStock& stock)
    {
        if (trees >= 0) stock.take_back(std::exchange(trees, -1));
        is_fresh = false;
    }

private:
    TreePart& borrow(const RowsToSolve& of, const Bodies<3>& bodies,
                     const StepData<3>& now)
    {
        if (trees < 0)
            trees = of.stock.lend(of.rows, of.members, now, bodies.count());
        TreePart& one = of.stock.at(trees);
        one.solver.exact = of.stock.exact;
        one.solver.most_exact = of.stock.most_exact;
        return one;
    }
};

}  // namespace rigid
