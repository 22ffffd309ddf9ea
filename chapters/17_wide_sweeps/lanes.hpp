/// \file lanes.hpp
/// Several numbers that one instruction works on, and how they come from the bodies and go back.
///
///     lane i of V:   the same operation on its own numbers, rounded as one number would be
///
/// A lane type is a number or a vector of the compiler's own (g++ and clang have the same): what is written with + − · and
/// the two functions below is one text for both, and gives the same bits in each lane.
#pragma once

#include "common/math.hpp"

#include <array>
#include <cmath>
#include <type_traits>

#ifdef __clang__
#pragma clang diagnostic ignored "-Wpsabi"
#else
// how vectors wider than a register are passed to functions; all of ours are inline
#pragma GCC diagnostic ignored "-Wpsabi"
#endif

namespace rigid {

//! [lanes]
template <class T, int L>
struct VectorOf {
    typedef T type __attribute__((vector_size(L * sizeof(T))));
};
template <class T>
struct VectorOf<T, 1> {
    using type = T;
};
/// L numbers side by side, a power of two; one is just the number.
template <class T, int L>
using Lanes = typename VectorOf<T, L>::type;

/// As many as fit into a register of this build.
template <class T>
#if defined(__AVX512F__)
constexpr int full_lanes = 64 / int(sizeof(T));
#elif defined(__AVX__)
constexpr int full_lanes = 32 / int(sizeof(T));
#else
constexpr int full_lanes = 16 / int(sizeof(T));
#endif

/// Equal numbers and a NaN leave x as it is.
template <class V>
inline V at_least(const V& x, const V& low)
{
    return x < low ? low : x;
}
template <class V>
inline V at_most(const V& x, const V& high)
{
    return x > high ? high : x;
}
//! [lanes]

/// Lane i.
template <class V>
inline auto lane(const V& many, int i)
{
    if constexpr (std::is_floating_point_v<V>) return many;
    else return many[i];
}
template <class V, class T>
inline void set_lane(V& many, int i, T value)
{
    if constexpr (std::is_floating_point_v<V>) many = static_cast<V>(value);
    else many[i] = static_cast<std::remove_cvref_t<decltype(many[0])>>(value);
}

/// |x| of each lane.
template <class V>
inline V size_of(const V& x)
{
    const V minus = -x;
    return x < V{} ? minus : x;
}

/// The largest of L lanes.
template <int L, class V>
inline auto largest(const V& many)
{
    auto most = lane(many, 0);
    for (int i = 1; i < L; ++i) most = at_least(most, lane(many, i));
    return most;
}

//! [slot]
/// The velocity of one body in memory: with a number to spare, so that it is one
/// load.
template <int Dof, class T>
struct alignas((Dof <= 2   ? 2
                : Dof <= 4 ? 4
                           : 8) *
               sizeof(T)) Slot {
    T u[Dof <= 2 ? 2 : Dof <= 4 ? 4 : 8] = {};
};
//! [slot]

/// Four bodies become three fields, in registers: 7 shuffles instead of 12 loads.
template <class T>
struct Four {
    using V = Lanes<T, 4>;
    static constexpr bool wide = sizeof(T) == 8;

    //! [turn]
    /// Rows (x y ω ·) of four bodies to columns x, y, ω.
    static void turn(const V& p, const V& q, const V& r, const V& s, V (&out)[3])
    {
        if constexpr (wide) {
            const V a = __builtin_shufflevector(p, q, 0, 4, 2, 6),
                    b = __builtin_shufflevector(r, s, 0, 4, 2, 6),
                    c = __builtin_shufflevector(p, q, 1, 5, 3, 7),
                    d = __builtin_shufflevector(r, s, 1, 5, 3, 7);
            out[0] = __builtin_shufflevector(a, b, 0, 1, 4, 5);
            out[1] = __builtin_shufflevector(c, d, 0, 1, 4, 5);
            out[2] = __builtin_shufflevector(a, b, 2, 3, 6, 7);
        } else {
            const V a = __builtin_shufflevector(p, q, 0, 4, 1, 5),
                    b = __builtin_shufflevector(r, s, 0, 4, 1, 5),
                    c = __builtin_shufflevector(p, q, 2, 6, 3, 7),
                    d = __builtin_shufflevector(r, s, 2, 6, 3, 7);
            out[0] = __builtin_shufflevector(a, b, 0, 1, 4, 5);
            out[1] = __builtin_shufflevector(a, b, 2, 3, 6, 7);
            out[2] = __builtin_shufflevector(c, d, 0, 1, 4, 5);
        }
    }
    //! [turn]

    /// And back; the fourth number of a body is any.
    static void turn_back(const V (&in)[3], V (&out)[4])
    {
        if constexpr (wide) {
            const V a = __builtin_shufflevector(in[0], in[1], 0, 4, 2, 6),
                    c = __builtin_shufflevector(in[0], in[1], 1, 5, 3, 7),
                    b = __builtin_shufflevector(in[2], in[2], 0, 0, 2, 2),
                    d = __builtin_shufflevector(in[2], in[2], 1, 1, 3, 3);
            out[0] = __builtin_shufflevector(a, b, 0, 1, 4, 5);
            out[1] = __builtin_shufflevector(c, d, 0, 1, 4, 5);
            out[2] = __builtin_shufflevector(a, b, 2, 3, 6, 7);
            out[3] = __builtin_shufflevector(c, d, 2, 3, 6, 7);
        } else {
            const V a = __builtin_shufflevector(in[0], in[1], 0, 4, 1, 5),
                    c = __builtin_shufflevector(in[0], in[1], 2, 6, 3, 7),
                    b = __builtin_shufflevector(in[2], in[2], 0, 0, 1, 1),
                    d = __builtin_shufflevector(in[2], in[2], 2, 2, 3, 3);
            out[0] = __builtin_shufflevector(a, b, 0, 1, 4, 5);
            out[1] = __builtin_shufflevector(a, b, 2, 3, 6, 7);
            out[2] = __builtin_shufflevector(c, d, 0, 1, 4, 5);
            out[3] = __builtin_shufflevector(c, d, 2, 3, 6, 7);
        }
    }
};

/// Two halves side by side, and one of them again.
template <class T, int L>
inline Lanes<T, L> joined(const Lanes<T, L / 2>& low, const Lanes<T, L / 2>& high)
{
    if constexpr (L == 8)
        return __builtin_shufflevector(low, high, 0, 1, 2, 3, 4, 5, 6, 7);
    else
        return __builtin_shufflevector(low, high, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10,
                                       11, 12, 13, 14, 15);
}
template <class T, int L, bool upper>
inline Lanes<T, L / 2> half(const Lanes<T, L>& all)
{
    if constexpr (L == 8 && !upper)
        return __builtin_shufflevector(all, all, 0, 1, 2, 3);
    else if constexpr (L == 8) return __builtin_shufflevector(all, all, 4, 5, 6, 7);
    else if constexpr (!upper)
        return __builtin_shufflevector(all, all, 0, 1, 2, 3, 4, 5, 6, 7);
    else return __builtin_shufflevector(all, all, 8, 9, 10, 11, 12, 13, 14, 15);
}

//! [gather]
/// The velocities of L bodies, component by component.
/// \param at  L places in u
template <int Dof, class T, int L>
inline void gather(const Slot<Dof, T>* u, const int* at, Lanes<T, L> (&out)[Dof])
{
    if constexpr (Dof != 3 || L == 1 || (L == 2 && sizeof(T) == 4)) {
        for (int i = 0; i < L; ++i)
            for (int d = 0; d < Dof; ++d) set_lane(out[d], i, u[at[i]].u[d]);
    } else if constexpr (L == 2) {
        using V = Lanes<T, 2>;
        const V *p = reinterpret_cast<const V*>(u[at[0]].u),
                *q = reinterpret_cast<const V*>(u[at[1]].u);
        out[0] = __builtin_shufflevector(p[0], q[0], 0, 2);
        out[1] = __builtin_shufflevector(p[0], q[0], 1, 3);
        out[2] = __builtin_shufflevector(p[1], q[1], 0, 2);
    } else if constexpr (L == 4) {
        using V = Lanes<T, 4>;
        const auto body = [&](int i) -> const V& {
            return *reinterpret_cast<const V*>(u[at[i]].u);
        };
        Four<T>::turn(body(0), body(1), body(2), body(3), out);
    } else {
        Lanes<T, L / 2> low[Dof], high[Dof];
        gather<Dof, T, L / 2>(u, at, low);
        gather<Dof, T, L / 2>(u, at + L / 2, high);
        for (int d = 0; d < Dof; ++d) out[d] = joined<T, L>(low[d], high[d]);
    }
}
//! [gather]

/// And back. Where two lanes have the same body, the last one is right.
template <int Dof, class T, int L>
inline void scatter(const Lanes<T, L> (&in)[Dof], const int* at, Slot<Dof, T>* u)
{
    if constexpr (Dof != 3 || L == 1 || (L == 2 && sizeof(T) == 4)) {
        for (int i = 0; i < L; ++i)
            for (int d = 0; d < Dof; ++d) u[at[i]].u[d] = lane(in[d], i);
    } else if constexpr (L == 2) {
        using V = Lanes<T, 2>;
        V *p = reinterpret_cast<V*>(u[at[0]].u),
          *q = reinterpret_cast<V*>(u[at[1]].u);
        p[0] = __builtin_shufflevector(in[0], in[1], 0, 2);
        q[0] = __builtin_shufflevector(in[0], in[1], 1, 3);
        p[1] = __builtin_shufflevector(in[2], in[2], 0, 2);
        q[1] = __builtin_shufflevector(in[2], in[2], 1, 3);
    } else if constexpr (L == 4) {
        using V = Lanes<T, 4>;
        V bodies[4];
        Four<T>::turn_back(in, bodies);
        for (int i = 0; i < 4; ++i) *reinterpret_cast<V*>(u[at[i]].u) = bodies[i];
    } else {
        Lanes<T, L / 2> low[Dof], high[Dof];
        for (int d = 0; d < Dof; ++d) {
            low[d] = half<T, L, false>(in[d]);
            high[d] = half<T, L, true>(in[d]);
        }
        scatter<Dof, T, L / 2>(low, at, u);
        scatter<Dof, T, L / 2>(high, at + L / 2, u);
    }
}

}  // namespace rigid
