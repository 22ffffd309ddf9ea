/// \file cloth_threads.hpp
/// Thread by thread: all rows of a line of springs solved together, exactly and in O(n).
///
///     (A + Γ) ΔΛ = −(C + Γ Λ),   A tridiagonal: A_ii = 1/m_i + 1/m_{i+1},   A_{i,i+1} = −n_i·n_{i+1}/m_{i+1}    (27.16)
///
/// XPBD with blocks: its fixed point is the same. What crawls along a thread row by row, through n rows in n² sweeps, goes
/// through it in one.
#pragma once

#include "chapters/27_particles_and_cloth/cloth.hpp"

namespace rigid {

class ClothThreads {
public:
    VecX lambda;  ///< Λ of each spring [N s²]

    /// Parts the springs into threads: from each spring that has none on, both ways,
    /// by the spring that turns least, by less than 60°, and never to a particle that
    /// the thread has.
    void find(const ClothScene& cloth);
    /// Each thread once.
    void sweep(const ClothScene& cloth, Real h, VecX& x);

    std::size_t count() const { return first_.empty() ? 0 : first_.size() - 1; }

private:
    /// a spring of a thread, run through from p to q
    struct Link {
        int spring = 0, p = 0, q = 0;
    };
    std::vector<Link> links_;         ///< thread after thread
    std::vector<std::size_t> first_;  ///< of each thread, and the end
    // of one thread
    std::vector<Vec3> n_;
    std::vector<Real> pivot_, inverse_, right_, beside_;
};

}  // namespace rigid
