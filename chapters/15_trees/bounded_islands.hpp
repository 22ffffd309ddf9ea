/// \file bounded_islands.hpp
/// The rows with bounds, and which of them affect each other when joints are held: one problem for each such island.
///
///     place = an assembly, or a body that no joint holds          rows on one place meet, A_ij ≠ 0
///
/// A limit in the knee of a doll moves its head; it does not move another doll, unless a contact joins the two.
#pragma once

#include "chapters/03_mlcp_formulation/assembly.hpp"
#include "chapters/15_trees/joint_factor.hpp"

namespace rigid {

class BoundedIslands {
    template <class List>
    static auto& at(List& list, int i)
    {
        return list[static_cast<std::size_t>(i)];
    }

public:
    std::vector<std::vector<int>> rows;  ///< of each island, ascending
    int count = 0;                       ///< islands; memory of more may be there
    int listed = 0;                      ///< rows in them
    std::vector<int> number;  ///< of each listed row in its island; others: −1
    std::vector<int> of;      ///< the island of each listed row

    /// \param left_out  1: a row that is not to be looked at; empty = none
    void list(const std::vector<Row<3>>& all, const Assemblies& assemblies,
              const std::vector<char>& left_out);

    /// The two places that a row moves, the same one once; −1 = none.
    std::pair<int, int> places_of(const Row<3>& row) const
    {
        int a = moves_a(row) ? place_of(row.a) : -1;
        const int b = moves_b(row) ? place_of(row.b) : -1;
        if (a == b) a = -1;
        return {a, b};
    }
    /// The assembly of a place, or −1: it is the body place − count.
    int assembly_at(int place) const
    {
        return place < assemblies_->count() ? place : -1;
    }
    Index body_at(int place) const { return place - assemblies_->count(); }

    /// Calls visit(i), ascending, for each row i ≥ j on a place of row j.
    template <class Visit>
    void for_each_from(int j, std::pair<int, int> places, const Visit& visit) const
    {
        const auto from = [&](int place, const int*& begin, const int*& end) {
            begin = end = nullptr;
            if (place < 0) return;
            end = rows_on_.data() + on_[static_cast<std::size_t>(place) + 1];
            begin = std::lower_bound(
                rows_on_.data() + on_[static_cast<std::size_t>(place)], end, j);
        };
        const int *p, *last_p, *q, *last_q;
        from(places.first, p, last_p);
        from(places.second, q, last_q);
        while (p != last_p || q != last_q) {  // merge them
            const int i = q == last_q || (p != last_p && *p < *q) ? *p : *q;
            visit(i);
            if (p != last_p && *p == i) ++p;
            if (q != last_q && *q == i) ++q;
        }
    }

private:
    int place_of(Index body) const
    {
        const int assembly = assemblies_->of[static_cast<std::size_t>(body)];
        return assembly >= 0 ? assembly
                             : assemblies_->count() + static_cast<int>(body);
    }

    const Assemblies* assemblies_ = nullptr;
    std::vector<int> lowest_, on_, next_, rows_on_, island_;
};

}  // namespace rigid
