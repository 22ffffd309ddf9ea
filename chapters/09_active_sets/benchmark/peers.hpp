/// \file peers.hpp
/// Other programs' exact solvers behind one door, for benchmark.cpp. Each is given the problem as a dense
/// matrix in its own layout; filling that, and allocating memory, is not part of its time.
///
///     w = A λ + q,   lo ≤ λ ≤ hi,   λ_i = lo_i or λ_i = hi_i or w_i = 0
///
/// A library that is not installed is not in the list.
#pragma once

#include "chapters/03_mlcp_formulation/mlcp.hpp"
#include "chapters/09_active_sets/benchmark/benchmark_stopwatch.hpp"

#include <cstdlib>
#include <numeric>
#include <vector>

#ifdef RIGID_HAS_BULLET
#include <BulletDynamics/MLCPSolvers/btDantzigLCP.h>
#endif
#ifdef RIGID_HAS_SICONOS
extern "C" {
#include <LCP_Solvers.h>
#include <LinearComplementarityProblem.h>
#include <MLCP_Solvers.h>
#include <MixedLinearComplementarityProblem.h>
#include <NumericsMatrix.h>
#include <SolverOptions.h>
#include <lcp_cst.h>
#include <mlcp_cst.h>
}
#include <dlfcn.h>
#endif
#ifdef RIGID_HAS_ODE
// Exported by the library, in no header of it.
class dxWorldProcessMemArena;
struct dxWorldProcessMemoryManager;
struct dxWorldProcessMemoryReserveInfo;
size_t dxEstimateSolveLCPMemoryReq(unsigned n, bool outer_w);
dxWorldProcessMemArena*
dxAllocateTemporaryWorldProcessMemArena(size_t, const dxWorldProcessMemoryManager*,
                                        const dxWorldProcessMemoryReserveInfo*);
void dxFreeTemporaryWorldProcessMemArena(dxWorldProcessMemArena*);
void dxSolveLCP(dxWorldProcessMemArena*, unsigned n, double* A, double* b_and_x,
                double* w, unsigned nub, double* lo_and_hi, int* findex);
#endif

namespace rigid::peers {

struct Answer {
    VecX lambda;  ///< [N s]; infinite where there is none
    Real us = 0;  ///< run time [µs]
    /// false: the library is not here, or the problem is not of its kind
    bool ran = true;
};

inline Answer none(Index n) { return {VecX::Constant(n, infinity), 0, false}; }

/// The rows in an order in which those without bounds come first, as all peers require them.
struct FreeFirst {
    std::vector<int> order;
    int free = 0;
    MatX A;
    VecX q, lo, hi;

    explicit FreeFirst(const Mlcp& mlcp)
        : order(static_cast<std::size_t>(mlcp.size()))
    {
        std::iota(order.begin(), order.end(), 0);
        const auto is_free = [&](int i) {
            return std::isinf(mlcp.lo[i]) && std::isinf(mlcp.hi[i]);
        };
        const auto bounded =
            std::stable_partition(order.begin(), order.end(), is_free);
        free = static_cast<int>(bounded - order.begin());
        A = MatX(mlcp.A)(order, order);
        q = mlcp.q(order);
        lo = mlcp.lo(order);
        hi = mlcp.hi(order);
    }
    VecX back(const VecX& lambda) const
    {
        VecX answer(lambda.size());
        answer(order) = lambda;
        return answer;
    }
};

/// One thread for all programs: Siconos calls OpenBLAS, which otherwise takes all processors.
inline void single_thread()
{
#ifdef RIGID_HAS_SICONOS
    using SetThreads = void (*)(int);
    if (void* const found = dlsym(RTLD_DEFAULT, "openblas_set_num_threads"))
        reinterpret_cast<SetThreads>(found)(1);
#endif
}

/// ODE's Dantzig: one index at a time, with an incremental LDLᵀ. \param cfm is added to the diagonal, as ODE
/// does it [1/kg]
inline Answer ode(const FreeFirst& problem, Real cfm = 0)
{
    const Index n = problem.q.size();
    Answer answer = none(n);
    (void)cfm;
#ifdef RIGID_HAS_ODE
    using Rows =
        Eigen::Matrix<Real, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
    // lines of a multiple of four
    Rows A = Rows::Zero(n, n > 1 ? (n + 3) / 4 * 4 : n);
    A.leftCols(n) = problem.A;
    A.diagonal().array() += cfm;
    Eigen::Matrix2Xd b_and_x(2, n), lo_and_hi(2, n);
    b_and_x << -problem.q.transpose(), Eigen::RowVectorXd::Zero(n);  // A x = b + w
    lo_and_hi << problem.lo.transpose(), problem.hi.transpose();
    std::vector<int> findex(static_cast<std::size_t>(n), -1);
    const auto size = static_cast<unsigned>(n);
    auto* const memory = dxAllocateTemporaryWorldProcessMemArena(
        dxEstimateSolveLCPMemoryReq(size, false), nullptr, nullptr);
    // A new arena has to be reset first, which ODE does inline: its first two members are where the next block
    // begins (still null) and where the first one does.
    void** const arena = reinterpret_cast<void**>(memory);
    arena[0] = arena[1];
    answer.us = microseconds([&] {
        dxSolveLCP(memory, size, A.data(), b_and_x.data(), nullptr,
                   static_cast<unsigned>(problem.free), lo_and_hi.data(),
                   findex.data());
    });
    dxFreeTemporaryWorldProcessMemArena(memory);
    answer.lambda = problem.back(b_and_x.row(1).transpose());
    answer.ran = true;
#endif
    return answer;
}

/// Bullet's: the same algorithm.
inline Answer bullet(const FreeFirst& problem)
{
    const Index n = problem.q.size();
    Answer answer = none(n);
#ifdef RIGID_HAS_BULLET
    MatX A = problem.A;  // symmetric: lines are columns
    VecX b = -problem.q, x = VecX::Zero(n), w = x, lo = problem.lo, hi = problem.hi;
    std::vector<int> findex(static_cast<std::size_t>(n), -1);
    static btDantzigScratchMemory memory;  // kept, as Bullet's own solver keeps it
    answer.us = microseconds([&] {
        answer.ran = btSolveDantzigLCP(static_cast<int>(n), A.data(), x.data(),
                                       b.data(), w.data(), problem.free, lo.data(),
                                       hi.data(), findex.data(), memory);
    });
    if (answer.ran) answer.lambda = problem.back(x);
    answer.ran = true;
#endif
    return answer;
}

/// Siconos' Lemke, for a mixed problem with its elimination of the free rows before it.
inline Answer siconos(const FreeFirst& problem)
{
    const Index n = problem.q.size();
    Answer answer = none(n);
#ifdef RIGID_HAS_SICONOS
    const auto bounded = n - problem.free;
    if ((problem.lo.tail(bounded).array() != 0).any() ||
        problem.hi.tail(bounded).array().isFinite().any())
        return answer;
    MatX A = problem.A;
    VecX q = problem.q, z = VecX::Zero(n), w = z;
    int info = 0;
    SolverOptions* const options = solver_options_create(
        problem.free > 0 ? int{SICONOS_MLCP_LCP_LEMKE} : int{SICONOS_LCP_LEMKE});
    const int size = static_cast<int>(n);
    NumericsMatrix* const M = NM_create_from_data(NM_DENSE, size, size, A.data());
    if (problem.free == 0) {
        LinearComplementarityProblem lcp;
        lcp.size = size;
        lcp.M = M;
        lcp.q = q.data();
        answer.us = microseconds(
            [&] { lcp_lexicolemke(&lcp, z.data(), w.data(), &info, options); });
    } else {
        MixedLinearComplementarityProblem* const mlcp =
            mixedLinearComplementarity_new();
        // In its four blocks: its own cutting of M into them writes past their end where m > n.
        const Index n_free = problem.free;
        MatX Aff = A.topLeftCorner(n_free, n_free),
             Abb = A.bottomRightCorner(bounded, bounded);
        MatX Afb = A.topRightCorner(n_free, bounded),
             Abf = A.bottomLeftCorner(bounded, n_free);
        int block_rows[] = {0, problem.free, size}, is_complementary[] = {0, 1};
        mlcp->isStorageType1 = 0;
        mlcp->isStorageType2 = 1;
        mlcp->n = problem.free;
        mlcp->m = size - problem.free;
        mlcp->blocksRows = block_rows;
        mlcp->blocksIsComp = is_complementary;
        mlcp->A = Aff.data();
        mlcp->B = Abb.data();
        mlcp->C = Afb.data();
        mlcp->D = Abf.data();
        mlcp->a = q.data();
        mlcp->b = q.data() + n_free;
        mlcp->M = M;
        mlcp->q = q.data();
        answer.us = microseconds(
            [&] { mlcp_lcp_lemke(mlcp, z.data(), w.data(), &info, options); });
        std::free(mlcp);
    }
    M->matrix0 = nullptr;  // ours
    NM_clear(M);
    std::free(M);
    solver_options_delete(options);
    std::free(options);
    if (z.allFinite()) answer.lambda = problem.back(z);
    answer.ran = true;
#endif
    return answer;
}

}  // namespace rigid::peers
