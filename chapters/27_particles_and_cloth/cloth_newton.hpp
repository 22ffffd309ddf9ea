/// \file cloth_newton.hpp
/// All rows together, in positions: the linear solve of an implicit step, and Newton's method to its end.
///
///     G(x) = Σ m‖x − y‖²/(2h²) + E(x),   H Δx = −∂G,   H = M/h² + ∂²E                                   (27.6)
///     of a spring  k [n nᵀ + max(0, 1 − L/‖d‖) (1 − n nᵀ)]: what would push sideways is left out        (27.13)
///
/// With one step from x₀ by conjugate gradients it is the implicit Euler of \cite baraff1998; with a line search to ∂G = 0 it
/// is exact. Implicit midpoint is the same with h/2, and then as far again (27.15).
#pragma once

#include "chapters/27_particles_and_cloth/cloth.hpp"

#include <Eigen/SparseCore>

namespace rigid {

/// The quadratic model of the rows at a position: H times a vector without a matrix.
struct ClothModel {
    struct Spring {
        Vec3 n;
        Real along = 0, across = 0;  ///< k, and k max(0, 1 − L/‖d‖) [N/m]
    };
    std::vector<Spring> springs;
    std::vector<std::array<Vec3, 4>> hinges;  ///< J [1/m]

    void linearise(const ClothScene& cloth, const VecX& x);
    /// Calls f(p, q, block) for each pair of particles of each row, both orders.
    template <class F>
    void for_each_block(const ClothScene& cloth, F&& f) const
    {
        for (std::size_t i = 0; i < springs.size(); ++i) {
            const Mat3 K = block(springs[i]);
            const int a = cloth.springs[i].a, b = cloth.springs[i].b;
            f(a, a, K), f(b, b, K), f(a, b, Mat3(-K)), f(b, a, Mat3(-K));
        }
        for (const ClothBend& bend : cloth.bends)
            for (std::size_t i = 0; i < 4 && bend.p[i] >= 0; ++i)
                for (std::size_t j = 0; j < 4 && bend.p[j] >= 0; ++j)
                    f(bend.p[i], bend.p[j],
                      Mat3(bend.stiffness * bend.w[i] * bend.w[j] *
                           Mat3::Identity()));
        for (std::size_t k = 0; k < hinges.size(); ++k)
            for (std::size_t i = 0; i < 4; ++i)
                for (std::size_t j = 0; j < 4; ++j)
                    f(cloth.hinges[k].p[i], cloth.hinges[k].p[j],
                      Mat3(cloth.hinges[k].stiffness * hinges[k][i] *
                           hinges[k][j].transpose()));
    }
    static Mat3 block(const Spring& s)
    {
        return s.across * Mat3::Identity() +
               (s.along - s.across) * s.n * s.n.transpose();
    }
};

struct ClothNewton {
    Real tolerance = 1e-10;  ///< of h² M⁻¹ ∂G [m]
    int iterations = 50;
    Real cg_tolerance = 1e-3;  ///< of the right side's size
    int cg_iterations = 200;

    // What the last call found.
    int steps = 0;      ///< of Newton
    int cg_steps = 0;   ///< of conjugate gradients
    Real residual = 0;  ///< the largest h²/m ‖∂G‖ [m]
    bool solved = false;

    /// One linear solve: x ← x₀ + h u with (M + h² K) u = M u* + h f(x₀).
    /// \param y  x₀ + h u*
    void linear(const ClothScene& cloth, const VecX& x0, const VecX& y, Real h,
                VecX& x);
    /// Where to begin: x₀ if G is lower there than at y, which is what x is.
    static void begin(const ClothScene& cloth, const VecX& x0, Real h, VecX& x);
    /// The least G, from x on, each step by a sparse factor.
    void minimise(const ClothScene& cloth, const VecX& y, Real h, VecX& x);

private:
    void find_gradient(const ClothScene& cloth, const VecX& x, const VecX& y,
                       Real h);
    void multiply(const ClothScene& cloth, Real h, const VecX& v, VecX& out) const;

    ClothModel model_;
    VecX gradient_, residual_, scaled_, direction_, image_, diagonal_, trial_;
    Eigen::SparseMatrix<Real> H_;
    std::vector<Eigen::Triplet<Real>> entries_;
    std::vector<int> number_;  ///< of a particle among those that can move
};

}  // namespace rigid
