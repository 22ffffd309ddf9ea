// The functions of schur.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/03_mlcp_formulation/schur.hpp"

namespace rigid {

VecX SchurComplement::whole(const Mlcp& mlcp, const VecX& rest_lambda) const
{
    VecX lambda(mlcp.size());
    VecX right = -(A_BN * rest_lambda);
    for (std::size_t k = 0; k < bilateral.size(); ++k)
        right[static_cast<Index>(k)] -= mlcp.q[bilateral[k]];
    const VecX bilateral_lambda = block.solve(right);
    for (std::size_t k = 0; k < bilateral.size(); ++k)
        lambda[bilateral[k]] = bilateral_lambda[static_cast<Index>(k)];
    for (std::size_t k = 0; k < others.size(); ++k)
        lambda[others[k]] = rest_lambda[static_cast<Index>(k)];
    return lambda;
}

//! [eliminate]
void eliminate_bilateral(const Mlcp& mlcp, SchurComplement& schur)
{
    schur.bilateral.clear();
    schur.others.clear();
    // of a row within its part
    std::vector<int> place(static_cast<std::size_t>(mlcp.size()));
    for (Index i = 0; i < mlcp.size(); ++i) {
        std::vector<Index>& part =
            is_bilateral(mlcp, i) ? schur.bilateral : schur.others;
        place[static_cast<std::size_t>(i)] = static_cast<int>(part.size());
        part.push_back(i);
    }
    const auto B = static_cast<Index>(schur.bilateral.size()),
               N = static_cast<Index>(schur.others.size());
    schur.block.factor(mlcp.A, schur.bilateral);
    if (schur.block.singular_row() >= 0) return;

    std::vector<Eigen::Triplet<Real>> BN, NB, NN;
    for (Index i = 0; i < mlcp.size(); ++i)
        for (SparseMatrix::InnerIterator entry(mlcp.A, i); entry; ++entry) {
            const bool row = is_bilateral(mlcp, i),
                       column = is_bilateral(mlcp, entry.col());
            if (row && column) continue;
            auto& part = row ? BN : column ? NB : NN;
            part.emplace_back(place[static_cast<std::size_t>(i)],
                              place[static_cast<std::size_t>(entry.col())],
                              entry.value());
        }
    schur.A_BN.resize(B, N);
    schur.A_BN.setFromTriplets(BN.begin(), BN.end());
    SparseMatrix A_NB(N, B), A_NN(N, N);
    A_NB.setFromTriplets(NB.begin(), NB.end());
    A_NN.setFromTriplets(NN.begin(), NN.end());

    VecX q_B(B);
    schur.rest.q.resize(N);
    schur.rest.lo.resize(N);
    schur.rest.hi.resize(N);
    for (Index k = 0; k < B; ++k)
        q_B[k] = mlcp.q[schur.bilateral[static_cast<std::size_t>(k)]];
    for (Index k = 0; k < N; ++k) {
        const Index i = schur.others[static_cast<std::size_t>(k)];
        schur.rest.q[k] = mlcp.q[i];
        schur.rest.lo[k] = mlcp.lo[i];
        schur.rest.hi[k] = mlcp.hi[i];
    }
    MatX S = A_NN;
    const VecX A_ii = S.diagonal(), q_i = schur.rest.q;
    for (Index k = 0; k < N; ++k)
        S.col(k) -= A_NB * schur.block.solve(VecX(schur.A_BN.col(k)));
    schur.rest.A = S.sparseView();
    schur.rest.q -= A_NB * schur.block.solve(q_B);
    schur.kept = 1;
    const auto keep = [&schur](Real before, Real after) {
        const Real taken = std::abs(before - after);
        if (taken > 0) schur.kept = std::min(schur.kept, std::abs(after) / taken);
    };
    for (Index k = 0; k < N; ++k) {
        keep(A_ii[k], S(k, k));
        keep(q_i[k], schur.rest.q[k]);
    }
}
//! [eliminate]

//! [schur]
Solution schur(const Mlcp& mlcp, const EnumerationSettings& settings)
{
    require_valid(mlcp);
    SchurComplement parts;
    eliminate_bilateral(mlcp, parts);
    Solution solution;
    if (parts.block.singular_row() >= 0) {
        solution.lambda =
            VecX::Zero(mlcp.size()).cwiseMax(mlcp.lo).cwiseMin(mlcp.hi);
        solution.residual = natural_residual(mlcp, solution.lambda);
        solution.status = Status::singular;
        return solution;
    }
    EnumerationSettings of_rest = settings;
    if (!settings.first.empty()) {
        require_all_rows(settings.first, mlcp.size());
        of_rest.first.clear();
        for (const Index i : parts.others)
            of_rest.first.push_back(settings.first[static_cast<std::size_t>(i)]);
    }
    solution = enumerate(parts.rest, of_rest);
    solution.lambda = parts.whole(mlcp, solution.lambda);
    // Where A_BB is nearly singular S has lost digits: what was found has to prove
    // itself, and what was not found or not seen twice proves nothing.
    if (!(std::min(parts.block.least_pivot(), parts.kept) >= 1e-3)) {
        solution.uniqueness = Uniqueness::not_examined;
        if (solution.status == Status::infeasible)
            solution.status = Status::singular;
    }
    if (solution.status == Status::solved)
        conclude(mlcp, solution, settings.tolerance, Status::singular);
    else solution.residual = natural_residual(mlcp, solution.lambda);
    return solution;
}
//! [schur]

}  // namespace rigid
