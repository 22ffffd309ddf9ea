/// \file stretches.hpp
/// A deformation gradient as a turn, stretches along three axes, and another turn.
///
///     F = U diag(σ) Vᵀ,   det U = det V = 1,   R = U Vᵀ                          (30.13)
///
/// The signed form: where the element is inverted, det F < 0, the smallest stretch is
/// negative and R is still a turn. By rotations in planes (one-sided Jacobi) a fixed
/// number of times at most, with + − × ÷ √ alone: the same bits everywhere.
#pragma once

#include "chapters/16_soft_constraints/block_solve.hpp"
#include "common/math.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace rigid {

template <int Dim>
struct Stretches {
    Vec<Dim> sigma = Vec<Dim>::Ones();         ///< σ, the smallest may be negative
    Mat<Dim> U = Mat<Dim>::Identity(), V = U;  ///< turns
};

/// A product of small matrices whose sums have one order with every compiler.
template <int Rows, int Inner, int Columns>
Eigen::Matrix<Real, Rows, Columns>
product(const Eigen::Matrix<Real, Rows, Inner>& a,
        const Eigen::Matrix<Real, Inner, Columns>& b)
{
    Eigen::Matrix<Real, Rows, Columns> c;
    for (int j = 0; j < Columns; ++j)
        for (int i = 0; i < Rows; ++i) {
            Real sum = a(i, 0) * b(0, j);
            for (int k = 1; k < Inner; ++k) sum += a(i, k) * b(k, j);
            c(i, j) = sum;
        }
    return c;
}

template <int N>
Real sum_of_products(const Vec<N>& a, const Vec<N>& b)
{
    Real sum = a[0] * b[0];
    for (int i = 1; i < N; ++i) sum += a[i] * b[i];
    return sum;
}

/// The rotation (c, s) that makes two numbers α, β with the coupling γ independent.
struct PlaneRotation {
    Real c = 1, s = 0, t = 0;
};
inline PlaneRotation uncoupling(Real alpha, Real beta, Real gamma)
{
    const Real zeta = (beta - alpha) / (2 * gamma);
    const Real t =
        (zeta < 0 ? -1 : 1) / (std::abs(zeta) + std::sqrt(1 + zeta * zeta));
    const Real c = 1 / std::sqrt(1 + t * t);
    return {c, c * t, t};
}

//! [stretches]
/// (30.13), by one-sided Jacobi: V turns until the columns of F V are at right
/// angles. Their lengths are the stretches, their directions U.
template <int Dim>
Stretches<Dim> stretches_of(const Mat<Dim>& F)
{
    Stretches<Dim> out;
    Mat<Dim> B = F;
    for (int sweep = 0; sweep < 16; ++sweep) {  // four or five are the rule
        bool turned = false;
        for (int p = 0; p < Dim; ++p)
            for (int q = p + 1; q < Dim; ++q) {
                const Vec<Dim> x = B.col(p), y = B.col(q);
                const Real alpha = sum_of_products<Dim>(x, x),
                           beta = sum_of_products<Dim>(y, y),
                           gamma = sum_of_products<Dim>(x, y);
                if (!(std::abs(gamma) > 1e-16 * std::sqrt(alpha) * std::sqrt(beta)))
                    continue;
                turned = true;
                const PlaneRotation g = uncoupling(alpha, beta, gamma);
                B.col(p) = g.c * x - g.s * y, B.col(q) = g.s * x + g.c * y;
                const Vec<Dim> v = out.V.col(p), w = out.V.col(q);
                out.V.col(p) = g.c * v - g.s * w, out.V.col(q) = g.s * v + g.c * w;
            }
        if (!turned) break;
    }
    int least = 0;
    Vec<Dim> length;
    for (int i = 0; i < Dim; ++i) {
        length[i] = std::sqrt(sum_of_products<Dim>(B.col(i), B.col(i)));
        if (length[i] < length[least]) least = i;
    }
    // The direction of the least stretch is what makes U a turn; so its sign is right.
    if constexpr (Dim == 1) {
        out.U(0, 0) = 1;
    } else if constexpr (Dim == 2) {
        const int other = 1 - least;
        if (length[other] > 0) out.U.col(other) = B.col(other) / length[other];
        else out.U.col(other) = Vec2::Unit(other);
        const Real sign = least == 1 ? 1 : -1;
        out.U.col(least) = sign * perpendicular(out.U.col(other));
    } else {
        const int i = (least + 1) % 3, j = (least + 2) % 3;
        const int large = length[i] >= length[j] ? i : j, middle = i + j - large;
        Vec<3> u = length[large] > 0 ? Vec<3>(B.col(large) / length[large])
                                     : Vec<3>(Vec<3>::Unit(large));
        Vec<3> v = B.col(middle);
        v -= sum_of_products<3>(u, v) * u;
        Real size = std::sqrt(sum_of_products<3>(v, v));
        if (!(size > 1e-12 * length[large]) ||
            !(size > 0)) {  // F has a rank of one
            int axis = 0;
            for (int k = 1; k < 3; ++k)
                if (std::abs(u[k]) < std::abs(u[axis])) axis = k;
            v = Vec<3>::Unit(axis) - u[axis] * u;
            size = std::sqrt(sum_of_products<3>(v, v));
        }
        out.U.col(large) = u;
        out.U.col(middle) = v / size;
        out.U.col(least) = out.U.col(i).cross(out.U.col(j));
    }
    for (int i = 0; i < Dim; ++i)
        out.sigma[i] = sum_of_products<Dim>(out.U.col(i), B.col(i));
    return out;
}
//! [stretches]

/// cof F = det F · F⁻ᵀ, which has no pole.
template <int Dim>
Mat<Dim> cofactor(const Mat<Dim>& F)
{
    Mat<Dim> C;
    if constexpr (Dim == 1) C(0, 0) = 1;
    else if constexpr (Dim == 2) C << F(1, 1), -F(1, 0), -F(0, 1), F(0, 0);
    else
        for (int i = 0; i < 3; ++i)
            C.col(i) = F.col((i + 1) % 3).cross(F.col((i + 2) % 3));
    return C;
}

//! [turn]
/// R of (30.13): the turn that is nearest to F. In the plane it is known at once. In space
/// R ← ½ (R + R⁻ᵀ), Newton's method for RᵀR = I, doubles the digits in each round and needs
/// no angles; where F is flat or inverted the stretches say.
template <int Dim>
Mat<Dim> turn_of(const Mat<Dim>& F)
{
    Mat<Dim> R = F;
    if constexpr (Dim == 2) {
        const Real c = F(0, 0) + F(1, 1), s = F(1, 0) - F(0, 1),
                   r = std::sqrt(c * c + s * s);
        if (r > 1e-9) {
            R << c / r, -s / r, s / r, c / r;
            return R;
        }
    } else if constexpr (Dim == 3) {
        for (int round = 0; round < 12; ++round) {
            const Mat<3> C = cofactor<3>(R);
            const Real J = sum_of_products<3>(R.col(0), C.col(0));
            if (!(J > 0.01)) break;
            const Mat<3> change = (C / J - R) / 2;
            R += change;
            if (change.cwiseAbs().maxCoeff() < 1e-8) return R;
        }
    }
    const Stretches<Dim> s = stretches_of<Dim>(F);
    return product<Dim, Dim, Dim>(s.U, s.V.transpose());
}
//! [turn]

/// Eigenvalues and eigenvectors of a symmetric matrix, A = V diag(values) Vᵀ, by
/// Jacobi's rotations. Not sorted.
/// \param A  is overwritten; its diagonal becomes the values
template <class Matrix>
void symmetric_eigen(Matrix& A, Matrix& V)
{
    const Index n = A.rows();
    V.setIdentity(n, n);
    for (int sweep = 0; sweep < 30; ++sweep) {
        bool turned = false;
        for (Index p = 0; p < n; ++p)
            for (Index q = p + 1; q < n; ++q) {
                if (!(std::abs(A(p, q)) >
                      1e-16 * (std::abs(A(p, p)) + std::abs(A(q, q)))))
                    continue;
                turned = true;
                const PlaneRotation g = uncoupling(A(p, p), A(q, q), A(p, q));
                const Real change = g.t * A(p, q);
                A(p, p) -= change, A(q, q) += change;
                A(p, q) = A(q, p) = 0;
                for (Index k = 0; k < n; ++k) {
                    if (k != p && k != q) {
                        const Real a = A(k, p), b = A(k, q);
                        A(k, p) = A(p, k) = g.c * a - g.s * b;
                        A(k, q) = A(q, k) = g.s * a + g.c * b;
                    }
                    const Real a = V(k, p), b = V(k, q);
                    V(k, p) = g.c * a - g.s * b;
                    V(k, q) = g.s * a + g.c * b;
                }
            }
        if (!turned) break;
    }
}

}  // namespace rigid
