// The functions of verification.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/03_mlcp_formulation/verification.hpp"

#include "common/text.hpp"

namespace rigid {

void require_share(Real tolerance)
{
    if (!(tolerance < 0.01))
        throw std::invalid_argument(
            "the tolerance of an answer is " + shortest(tolerance) +
            " of the numbers in its rows; it must be below 0.01");
}

void require_tolerance(const char* of, Real tolerance)
{
    if (!(tolerance >= 0 && tolerance < infinity))
        throw std::invalid_argument("the tolerance of " + std::string(of) + " is " +
                                    shortest(tolerance) +
                                    "; it must be zero or positive, and finite");
}

Real row_unit(const Mlcp& mlcp, Index i, Real diagonal)
{
    if (diagonal < 0 || diagonal > 0) return std::sqrt(std::abs(diagonal));
    Real unit = 0, largest = 0;
    for (SparseMatrix::InnerIterator entry(mlcp.A, i); entry; ++entry) {
        const Real neighbour = std::abs(mlcp.A.coeff(entry.col(), entry.col()));
        if (neighbour > 0)
            unit = std::max(unit, std::abs(entry.value()) / std::sqrt(neighbour));
        largest = std::max(largest, std::abs(entry.value()));
    }
    return unit > 0 ? unit : largest > 0 ? std::sqrt(largest) : 1;
}

Real coupled_unit(const Mlcp& mlcp, Index i)
{
    Real unit = row_unit(mlcp, i, mlcp.A.coeff(i, i));
    for (SparseMatrix::InnerIterator entry(mlcp.A, i); entry; ++entry) {
        const Real other = std::abs(mlcp.A.coeff(entry.col(), entry.col()));
        if (other > 0)
            unit = std::max(unit, std::abs(entry.value()) / std::sqrt(other));
    }
    return unit;
}

bool coupled_energy_reaches(const Mlcp& mlcp, Real least)
{
    for (Index i = 0; i < mlcp.size(); ++i) {
        Real N = std::abs(mlcp.q[i]);
        bool moved = false;
        for (SparseMatrix::InnerIterator entry(mlcp.A, i); entry; ++entry) {
            const Real lo = mlcp.lo[entry.col()], hi = mlcp.hi[entry.col()];
            N += std::abs(entry.value()) * std::max({lo, -hi, Real{0}});
            moved = moved || std::abs(entry.value()) > 0;
        }
        // its own unit is not above the coupled one, and found at once
        if (moved && N / row_unit(mlcp, i, mlcp.A.coeff(i, i)) >= least &&
            N / coupled_unit(mlcp, i) >= least)
            return true;
    }
    return false;
}

//! [verify]
Verification verify(const Mlcp& mlcp, const VecX& lambda,
                    const Acceptance& acceptance)
{
    constexpr Real epsilon = std::numeric_limits<Real>::epsilon();
    const Real tau = std::max(acceptance.tolerance, epsilon),
               enough = acceptance.enough;
    Real residual = 0;
    // max N_j, max N_j / d_j: what U_i is made of
    Real speed = 0, energy = 0;
    // and how large they have to be for these v_i
    Real least_speed = 0, least_energy = 0;
    Real least_excuse = 0;  // of what only ε U_i lets in
    bool possible = true, small = true, in_each_row = true;
    for (Index i = 0; i < mlcp.size(); ++i) {
        const Real lo = mlcp.lo[i], hi = mlcp.hi[i];
        Real w = mlcp.q[i], S = std::abs(w), N = S, diagonal = 0, terms = 1;
        bool moved = false;  // by some λ
        for (SparseMatrix::InnerIterator entry(mlcp.A, i); entry;
             ++entry, ++terms) {
            const Index j = entry.col();
            const Real term = entry.value() * lambda[j];
            w += term;
            S += std::abs(term);
            if (mlcp.lo[j] > 0) N += std::abs(entry.value() * mlcp.lo[j]);
            if (mlcp.hi[j] < 0) N += std::abs(entry.value() * mlcp.hi[j]);
            if (j == i) diagonal = entry.value();
            moved = moved || std::abs(entry.value()) > 0;
        }
        const Real natural = natural_residual_row(diagonal, lambda[i], w, lo, hi);
        if (!(natural <= residual)) residual = natural;  // also takes over a NaN
        if (std::isnan(residual)) return {residual, false, false};
        possible =
            possible && std::isfinite(S) && lambda[i] >= lo && lambda[i] <= hi;
        const Real unit = row_unit(mlcp, i, diagonal);
        if (moved) {
            speed = std::max(speed, N);
            energy = std::max(energy, N / unit);
        }
        const Real hidden = epsilon / 2 * terms * S;
        const Real v = violation(lambda[i], w, lo, hi);
        const Real worst = std::max(violation(lambda[i], w - hidden, lo, hi),
                                    violation(lambda[i], w + hidden, lo, hi));
        // nothing is rounded where w = q
        possible = possible && (moved || v <= enough);
        const bool in_its_row = v <= tau * S;
        Real least = 0;  // U_i
        if (v > enough && in_its_row) least = v / tau;
        const Real floor = v > enough && !in_its_row ? v / epsilon : 0;
        least_speed = std::max(least_speed, floor);
        if (floor > 0)
            least_excuse = std::max(least_excuse, floor / coupled_unit(mlcp, i));
        if (worst > 100 * enough)
            least = std::max(least, worst / (100 * std::max(tau, 64 * epsilon)));
        if (diagonal > 0) least_speed = std::max(least_speed, least);
        least_energy = std::max(least_energy, std::max(least, floor) / unit);
        in_each_row = in_each_row && in_its_row;
        small = small && (v <= 64 * epsilon * S || v <= enough);
    }
    const bool within =
        energy > 0 ? least_speed <= speed && least_energy <= energy : small;
    const bool excused = !(least_excuse > 0) || energy <= 0 ||
                         coupled_energy_reaches(mlcp, least_excuse);
    return {residual, possible && within && excused && std::isfinite(energy),
            in_each_row};
}
//! [verify]

}  // namespace rigid
