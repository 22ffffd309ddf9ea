/// \file peers_bullet.hpp
/// Bullet's solver of the same name on the same problem, where it is installed: from its own dense matrix to x.
#pragma once

#include "chapters/03_mlcp_formulation/mlcp.hpp"

#include <BulletDynamics/MLCPSolvers/btSolveProjectedGaussSeidel.h>

namespace rigid {

struct BulletProblem {
    btMatrixXu A;
    btVectorXu b, x, lo, hi;
    btAlignedObjectArray<int> dependency;
    btSolveProjectedGaussSeidel solver;

    explicit BulletProblem(const Mlcp& mlcp)
    {
        const int n = static_cast<int>(mlcp.size());
        A.resize(n, n);
        A.setZero();
        b.resize(n);
        x.resize(n);
        lo.resize(n);
        hi.resize(n);
        dependency.resize(n, -1);
        for (int i = 0; i < n; ++i) {
            for (SparseMatrix::InnerIterator entry(mlcp.A, i); entry; ++entry)
                A.setElem(i, static_cast<int>(entry.col()), entry.value());
            b[i] = -mlcp.q[i];
            lo[i] = mlcp.lo[i];
            hi[i] = mlcp.hi[i];
        }
    }
    void solve(int sweeps)
    {
        x.setZero();
        solver.solveMLCP(A, b, x, lo, hi, dependency, sweeps);
    }
};

}  // namespace rigid
