/// \file cloth_threads.hpp
/// Thread by thread: all rows of a line of springs solved together, exactly and in O(n).
///
///     (A + Γ) ΔΛ = −(C + Γ Λ),   A tridiagonal: A_ii = 1/m_i + 1/m_{i+1},   A_{i,i+1} = −n_i·n_{i+1}/m_{i+1}    (27.16)
///
/// XPBD with blocks: its fixed point is the same. What crawls along a thread row by row, through n rows in n² sweeps, goes
/// through it in one. Threads that share no particle are solved side by side, eight in a bundle, one in each lane.
#pragma once

#include "chapters/17_wide_sweeps/lanes.hpp"
#include "chapters/27_particles_and_cloth/cloth.hpp"

namespace rigid {

class ClothThreads {
public:
    /// Parts the springs into threads: from each spring that has none on, both ways,
    /// by the spring that turns least, by less than 60°, and never to a particle that
    /// the thread has. Soft threads come first: what is visited last is right last.
    void find(const ClothScene& cloth);
    /// Λ = 0, at the start of a (sub-)step.
    void begin();
    /// Each thread once.
    void sweep(const ClothScene& cloth, Real h, VecX& x);

    std::size_t count() const { return count_; }
    std::size_t bundles() const { return bundles_.size(); }

private:
    static constexpr int lanes = 8;
    using Many = Lanes<Real, lanes>;
    /// a thread: its particles, and the springs between them
    struct Thread {
        std::vector<int> particles, springs;
        Real stiffness = 0;
    };
    /// of a bundle: the most links of its threads, where they begin
    struct Bundle {
        std::size_t links = 0, first = 0, particle = 0;
        int threads = 0;
    };
    /// What does not change: Lengths and compliances 1/k, Λ; a thread that has ended
    /// has links of no length between its last particle and itself.
    struct Link {
        Many length, compliance, lambda;
    };
    struct Place {
        Many x, y, z, w;
    };
    struct Bar {
        Many x, y, z, inverse, right, beside;
    };
    std::vector<Thread> threads_of(const ClothScene& cloth) const;
    void add(const ClothScene& cloth, const std::vector<const Thread*>& bundle);
    void solve(const Bundle& bundle, Real h, const VecX& w, VecX& x);

    std::vector<Bundle> bundles_;
    std::vector<int> at_;  ///< particles: lane by lane, place by place
    std::vector<Link> links_;
    std::vector<Place> places_;  ///< of one bundle
    std::vector<Bar> bars_;
    std::size_t count_ = 0;
};

}  // namespace rigid
