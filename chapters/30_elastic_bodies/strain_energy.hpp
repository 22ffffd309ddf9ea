/// \file strain_energy.hpp
/// What a deformation costs: energy, force and stiffness of three laws.
///
///     linear        Ψ = μ ε:ε + ½ λ tr² ε,             ε = ½ (F + Fᵀ) − I              (30.4)
///     corotational  Ψ = μ ‖F − R‖² + ½ λ tr²(RᵀF − I)                                 (30.12)
///     neo-Hookean   Ψ = ½ μ (‖F‖² − d) − μ (J − 1) + ½ (λ + μ) (J − 1)²,   J = det F  (30.14)
///
/// The last two depend on the stretches σ alone, F = U diag(σ) Vᵀ. With g = ∂Ψ/∂σ and
/// H = ∂²Ψ/∂σ² their curvatures are (30.22): stretches along the axes cost H, a twist in
/// the plane of two axes (g_i + g_j)/(σ_i + σ_j), and a flip (a shear that does not turn)
/// (g_i − g_j)/(σ_i − σ_j). Forces need no σ. \cite smith2018 \cite smith2019
/// The linear law is the corotational one that never looks again: σ = 1, U = V = I.
#pragma once

#include "chapters/30_elastic_bodies/stretches.hpp"

#include <array>
#include <string_view>

namespace rigid {

enum class StrainLaw : unsigned char { linear, corotational, neo_hookean };

constexpr std::string_view to_string(StrainLaw law)
{
    switch (law) {
    case StrainLaw::linear:
        return "linear";
    case StrainLaw::corotational:
        return "corotational";
    case StrainLaw::neo_hookean:
        return "neo-Hookean";
    }
    return "unknown";
}

/// What an elastic body is made of.
struct ElasticMaterial {
    Real young = 1e5;    ///< E, Young's modulus [Pa]
    Real poisson = 0.3;  ///< ν
    Real density =
        1000;  ///< ρ [kg/m³]; in the plane of a body 1 m thick, in a bar of 1 m²
    StrainLaw law = StrainLaw::corotational;
    /// in the plane: false = it cannot grow thicker (plane strain), true = it does so
    /// freely (plane stress: a thin sheet)
    bool plane_stress = false;
};

/// Throws std::invalid_argument, naming the value, unless E and ρ are positive and
/// −1 < ν < ½.
void require_valid(const ElasticMaterial& material);

/// Lamé's two numbers [Pa], (30.4).
struct Lame {
    Real mu = 0, lambda = 0;
};

/// \param dim  a bar has λ + 2 μ = E: it grows thinner freely
Lame lame_of(const ElasticMaterial& material, int dim);

constexpr int pairs_of(int dim) { return dim * (dim - 1) / 2; }

/// How the stress changes with F, in the axes of the stretches: ∂²Ψ/∂F² (30.22).
template <int Dim>
struct Curvature {
    Mat<Dim> hessian;  ///< H [Pa]
    /// of the pairs (0, 1), (0, 2), (1, 2) [Pa]
    std::array<Real, pairs_of(Dim) + 1> twist{}, flip{};
};

//! [curvature]
/// (30.22) of the corotational and of the neo-Hookean law at the stretches σ.
template <int Dim>
Curvature<Dim> curvature_at(StrainLaw law, const Lame& lame, const Vec<Dim>& sigma)
{
    Curvature<Dim> at;
    const auto [mu, lambda] = lame;
    const bool is_neo = law == StrainLaw::neo_hookean;
    Real trace = 0, J = 1;
    for (int i = 0; i < Dim; ++i) trace += sigma[i] - 1, J *= sigma[i];
    const Real s = (lambda + mu) * (J - 1) - mu;  // ∂Ψ/∂J
    /// the product of all stretches but these
    const auto others = [&sigma](int i, int j) {
        Real all = 1;
        for (int k = 0; k < Dim; ++k)
            if (k != i && k != j) all *= sigma[k];
        return all;
    };
    std::size_t pair = 0;
    for (int j = 0; j < Dim; ++j) {
        const Real c = others(j, j);
        at.hessian(j, j) = is_neo ? mu + (lambda + mu) * c * c : 2 * mu + lambda;
        for (int i = 0; i < j; ++i, ++pair) {
            const Real left = others(i, j);
            at.hessian(i, j) = at.hessian(j, i) =
                is_neo ? (lambda + mu) * c * others(i, i) + s * left : lambda;
            const Real both = sigma[i] + sigma[j];
            // Two stretches that cancel turn any way at no cost: the twist is at its
            // pole, and what stands there has any large number.
            const Real safe =
                std::abs(both) > 1e-6 ? both : (both < 0 ? -1e-6 : 1e-6);
            at.twist[pair] = is_neo ? mu + s * left
                                    : 2 * mu + (2 * lambda * trace - 4 * mu) / safe;
            at.flip[pair] = is_neo ? mu - s * left : 2 * mu;
        }
    }
    return at;
}
//! [curvature]

/// Whether a symmetric matrix is positive definite, by its leading minors.
template <int Dim>
bool is_positive(const Mat<Dim>& A)
{
    if constexpr (Dim == 1) return A(0, 0) > 0;
    else {
        const Real second = A(0, 0) * A(1, 1) - A(0, 1) * A(0, 1);
        if constexpr (Dim == 2) return A(0, 0) > 0 && second > 0;
        else
            return A(0, 0) > 0 && second > 0 &&
                   A(2, 2) * second + 2 * A(0, 1) * A(0, 2) * A(1, 2) >
                       A(0, 0) * A(1, 2) * A(1, 2) + A(1, 1) * A(0, 2) * A(0, 2);
    }
}

//! [project]
/// Takes what would make the stiffness indefinite: negative twists, flips and
/// eigenvalues of H become zero. Newton's step is then downhill.
template <int Dim>
void project(Curvature<Dim>& at)
{
    for (auto* const list : {&at.twist, &at.flip})
        for (Real& value : *list) value = std::max<Real>(0, value);
    if (is_positive<Dim>(at.hessian)) return;
    Mat<Dim> values = at.hessian, V;
    symmetric_eigen(values, V);
    Real least = values(0, 0);
    for (int i = 1; i < Dim; ++i) least = std::min(least, values(i, i));
    if (least >= 0) return;
    at.hessian.setZero();
    for (int k = 0; k < Dim; ++k)
        for (int i = 0; i < Dim; ++i)
            for (int j = 0; j < Dim; ++j)
                at.hessian(i, j) +=
                    V(i, k) * std::max<Real>(0, values(k, k)) * V(j, k);
}
//! [project]

/// The linear law: energy and stress P = ∂Ψ/∂F [Pa] at F, (30.5).
template <int Dim>
Real linear_stress(const Lame& lame, const Mat<Dim>& F, Mat<Dim>& P)
{
    Mat<Dim> strain;
    Real trace = 0, square = 0;
    for (int i = 0; i < Dim; ++i)
        for (int j = 0; j < Dim; ++j)
            strain(i, j) = (F(i, j) + F(j, i)) / 2 - (i == j ? 1 : 0);
    for (int i = 0; i < Dim; ++i) {
        trace += strain(i, i);
        for (int j = 0; j < Dim; ++j) square += strain(i, j) * strain(i, j);
    }
    P = 2 * lame.mu * strain;
    for (int i = 0; i < Dim; ++i) P(i, i) += lame.lambda * trace;
    return lame.mu * square + lame.lambda / 2 * trace * trace;
}

//! [stresses]
/// The corotational law: the turn is all that has to be known of F, (30.12).
template <int Dim>
Real corotational_stress(const Lame& lame, const Mat<Dim>& F, Mat<Dim>& P)
{
    const Mat<Dim> R = turn_of<Dim>(F);
    Real trace = -Dim, square = 0;
    for (int j = 0; j < Dim; ++j)
        for (int i = 0; i < Dim; ++i) {
            trace += R(i, j) * F(i, j);
            square += (F(i, j) - R(i, j)) * (F(i, j) - R(i, j));
        }
    P = 2 * lame.mu * (F - R) + lame.lambda * trace * R;
    return lame.mu * square + lame.lambda / 2 * trace * trace;
}

/// The neo-Hookean law (30.14): P = μ F + ∂Ψ/∂J · cof F, a polynomial.
template <int Dim>
Real neo_hookean_stress(const Lame& lame, const Mat<Dim>& F, Mat<Dim>& P)
{
    const Mat<Dim> C = cofactor<Dim>(F);
    Real J = 0, square = -Dim;
    for (int i = 0; i < Dim; ++i) J += F(i, 0) * C(i, 0);
    for (int j = 0; j < Dim; ++j)
        for (int i = 0; i < Dim; ++i) square += F(i, j) * F(i, j);
    const auto [mu, lambda] = lame;
    P = mu * F + ((lambda + mu) * (J - 1) - mu) * C;
    return mu / 2 * square - mu * (J - 1) + (lambda + mu) / 2 * (J - 1) * (J - 1);
}
//! [stresses]

/// Energy density [J/m³] and stress P = ∂Ψ/∂F [Pa] of a law at F.
template <int Dim>
Real stress_of(StrainLaw law, const Lame& lame, const Mat<Dim>& F, Mat<Dim>& P)
{
    switch (law) {
    case StrainLaw::linear:
        return linear_stress<Dim>(lame, F, P);
    case StrainLaw::corotational:
        return corotational_stress<Dim>(lame, F, P);
    case StrainLaw::neo_hookean:
        break;
    }
    return neo_hookean_stress<Dim>(lame, F, P);
}

}  // namespace rigid
