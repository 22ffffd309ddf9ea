/// \file wide_rows.hpp
/// Numbers into lanes and out of them: a row is copied field by field, each into its lane.
#pragma once

#include "chapters/03_mlcp_formulation/step_data.hpp"
#include "chapters/17_wide_sweeps/packets.hpp"

#include <cstring>
#include <span>
#include <type_traits>

namespace rigid {

/// What of the blocks of a row is whose in its lane: J of the first and of the second body there, and what the velocity of a
/// body that nothing moves adds to b.
template <int Dof>
struct LaneBlocks {
    RowVec<Dof> Ja = RowVec<Dof>::Zero(), Jb = RowVec<Dof>::Zero();
    Real bias = 0;
};

//! [blocks]
/// \param u  all velocities; of bodies that nothing moves they are constants [m/s]
template <int Dof>
LaneBlocks<Dof> lane_blocks(const Row<Dof>& row, const Movers& moves, const VecX& u)
{
    LaneBlocks<Dof> lane;
    const bool swapped = row.b < row.a;
    const auto add = [&](Index body, const RowVec<Dof>& J, bool is_low) {
        if (body == world) return;
        if (!(is_low ? moves.low : moves.high))
            lane.bias += J.dot(u.template segment<Dof>(Dof * body));
        else if (is_low && moves.high) lane.Ja = J;
        else lane.Jb = J;
    };
    add(row.a, row.Ja, !swapped);
    add(row.b, row.Jb, swapped);
    return lane;
}
//! [blocks]

/// All velocities, as many numbers a body as its place has.
template <int Dof, class T>
void put_velocities(const VecX& u, std::vector<Slot<Dof, T>>& out)
{
    for (Index k = 0; k < u.size() / Dof; ++k)
        for (int d = 0; d < Dof; ++d)
            out[static_cast<std::size_t>(k)].u[d] = static_cast<T>(u[Dof * k + d]);
}
template <int Dof, class T>
void get_velocities(const std::vector<Slot<Dof, T>>& from, VecX& u)
{
    for (Index k = 0; k < u.size() / Dof; ++k)
        for (int d = 0; d < Dof; ++d)
            u[Dof * k + d] = from[static_cast<std::size_t>(k)].u[d];
}

/// Rows of a step with other biases, and without some of them: chapter 7's second problem.
template <int Dof>
struct WideProblem {
    const std::vector<Row<Dof>>& rows;
    const SecondProblem* second = nullptr;
    bool apart = false;  ///< without those that it leaves out

    Real bias(std::size_t i) const
    {
        return second ? second->bias[i] : rows[i].bias;
    }
    bool left_out(std::size_t i) const { return apart && second->left_out[i]; }
};

/// Floats are swept as differences from a λ that is kept in doubles.
template <class T>
constexpr bool in_differences = sizeof(T) < sizeof(Real);

/// b and bounds of a row as they are swept.
struct Terms {
    Real bias, lo, hi;
};

//! [differences]
/// (17.5): what is left to do for row i, so that floats need not be large.
/// \param u  with the effect of λ [m/s]
template <int Dof>
Terms difference(const std::vector<Row<Dof>>& rows, std::size_t i, Real bias,
                 const VecX& lambda, const VecX& u)
{
    const Row<Dof>& row = rows[i];
    const Real own = lambda[static_cast<Index>(i)];
    const auto [lo, hi] = bounds_of(row, lambda);
    Real w = bias + row.Jb.dot(u.template segment<Dof>(Dof * row.b)) +
             row.softness * own;
    if (row.a != world) w += row.Ja.dot(u.template segment<Dof>(Dof * row.a));
    const int n = row.bounded_by;
    if (n >= 0 && rows[static_cast<std::size_t>(n)].lo < 0)
        throw std::invalid_argument(
            "row " + std::to_string(i) + " is bounded by row " + std::to_string(n) +
            ", whose impulse may be negative; sweeps in floats need one that only "
            "pushes");
    return {w, lo - own, hi - own};
}
//! [differences]

/// One lane of many that lie in memory. (An index into a vector makes clang++ read and write all of them.)
template <class V>
void write_lane(V& many, int i, Real value)
{
    using T = std::remove_cvref_t<decltype(lane(many, 0))>;
    const T number = static_cast<T>(value);
    std::memcpy(reinterpret_cast<char*>(&many) +
                    static_cast<std::size_t>(i) * sizeof(T),
                &number, sizeof(T));
}

/// √x of each lane.
template <class V>
inline V root_of(const V& x)
{
    Eigen::Array<Real, sizeof(V) / sizeof(Real), 1> numbers;
    std::memcpy(numbers.data(), &x, sizeof(V));
    numbers = numbers.sqrt();
    V root;
    std::memcpy(&root, numbers.data(), sizeof(V));
    return root;
}

/// M⁻¹ of the bodies of each packet; none of the bodies of empty lanes.
template <int Dof, class T, int L>
void put_masses(const VecX& inverse_mass, WideRows<Dof, T, L>& out)
{
    for (std::size_t p = 0; p < out.packets.size(); ++p)
        for (int l = 0; l < L; ++l)
            for (int d = 0; d < Dof; ++d) {
                const auto i = static_cast<std::size_t>(l);
                const Index a = Dof * out.packets[p].a[i] + d,
                            b = Dof * out.packets[p].b[i] + d;
                if (a < inverse_mass.size())
                    write_lane(out.inverse[p].a[d], l, inverse_mass[a]);
                if (b < inverse_mass.size())
                    write_lane(out.inverse[p].b[d], l, inverse_mass[b]);
            }
}

//! [fill]
/// Copies rows, λ and u into their lanes.
/// \param lambda  the λ of the rows, within their bounds [N s]
/// \param u       all velocities, Dof·K [m/s]
template <int Dof, class T, int L>
void fill(const WideProblem<Dof>& problem, const Bundles& bundles,
          const VecX& lambda, const VecX& u, WideRows<Dof, T, L>& out)
{
    for (RowShape& shape : out.shapes) shape.soft = false;
    for (std::size_t i = 0; i < problem.rows.size(); ++i) {
        const auto [at, l] = out.place[i];
        if (at < 0) continue;
        const Row<Dof>& row = problem.rows[i];
        const LaneBlocks<Dof> blocks = lane_blocks(
            row, bundles.movers[static_cast<std::size_t>(bundles.of_row[i])], u);
        const bool bounded = row.bounded_by >= 0;
        Terms terms{problem.bias(i) + blocks.bias, bounded ? 0 : row.lo,
                    bounded ? 0 : row.hi};
        if constexpr (in_differences<T>)
            terms = difference(problem.rows, i, problem.bias(i), lambda, u);
        auto& wide = out.rows[static_cast<std::size_t>(at)];
        for (int d = 0; d < Dof; ++d) {
            write_lane(wide.Ja[d], l, blocks.Ja[d]);
            write_lane(wide.Jb[d], l, blocks.Jb[d]);
        }
        const Real A = row.diagonal();
        write_lane(wide.mass, l, A > 0 && !problem.left_out(i) ? 1 / A : 0);
        write_lane(wide.bias, l, terms.bias);
        write_lane(wide.lo, l, terms.lo);
        write_lane(wide.hi, l, terms.hi);
        write_lane(wide.lambda, l,
                   in_differences<T> ? 0 : lambda[static_cast<Index>(i)]);
        write_lane(wide.friction, l, row.friction);
        write_lane(wide.softness, l, row.softness);
        out.shapes[static_cast<std::size_t>(at)].soft |= row.softness > 0;
    }
    if constexpr (in_differences<T>)
        std::fill(out.u.begin(), out.u.end(), Slot<Dof, T>{});
    else put_velocities(u, out.u);
}
//! [fill]

}  // namespace rigid
