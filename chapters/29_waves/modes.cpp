// The functions of modes.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/29_waves/modes.hpp"
#include "common/random.hpp"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <vector>

namespace rigid {
namespace {

void require_grid(Index nx, Index ny, Real a, Real b, Real c)
{
    if (nx < 2 || ny < 2)
        throw std::invalid_argument(
            "the grid has " + std::to_string(nx) + " by " + std::to_string(ny) +
            " intervals; it must have two or more each way");
    for (const Real value : {a, b, c})
        if (!(value > 0) || !std::isfinite(value))
            throw std::invalid_argument(
                "a length or the speed of the membrane is " + shortest(value) +
                "; it must be positive and finite");
}

}  // namespace

StiffnessMatrix rectangle_stiffness(Index nx, Index ny, Real a, Real b, Real c)
{
    require_grid(nx, ny, a, b, c);
    const Real dx = a / static_cast<Real>(nx), dy = b / static_cast<Real>(ny);
    const Real kx = c * c / (dx * dx), ky = c * c / (dy * dy);
    const Index m = nx - 1, n = ny - 1;
    std::vector<Eigen::Triplet<Real>> entries;
    const auto put = [&entries](Index row, Index column, Real value) {
        entries.emplace_back(static_cast<int>(row), static_cast<int>(column),
                             value);
    };
    for (Index j = 0; j < n; ++j)
        for (Index i = 0; i < m; ++i) {
            const Index k = j * m + i;
            put(k, k, 2 * kx + 2 * ky);
            if (i > 0) put(k, k - 1, -kx), put(k - 1, k, -kx);
            if (j > 0) put(k, k - m, -ky), put(k - m, k, -ky);
        }
    StiffnessMatrix K(m * n, m * n);
    K.setFromTriplets(entries.begin(), entries.end());
    return K;
}

//! [drum]
StiffnessMatrix drum_stiffness(Index intervals, Real radius, Real c)
{
    require_grid(intervals, intervals, radius, radius, c);
    const Index n = intervals, side = 2 * n + 1;
    const Real dx = radius / static_cast<Real>(n), k = c * c / (dx * dx);
    const auto along = [n](Index i) { return static_cast<Real>(i - n); };
    // a place that is nearer to the rim than a thousandth of an interval is on it
    std::vector<int> number(static_cast<std::size_t>(side * side), -1);
    const auto at = [&](Index i, Index j) -> int& {
        return number[static_cast<std::size_t>(j * side + i)];
    };
    int count = 0;
    const Real last = static_cast<Real>(n) - 1e-3;
    for (Index j = 0; j < side; ++j)
        for (Index i = 0; i < side; ++i)
            if (along(i) * along(i) + along(j) * along(j) < last * last)
                at(i, j) = count++;
    std::vector<Eigen::Triplet<Real>> entries;
    for (Index j = 1; j + 1 < side; ++j)
        for (Index i = 1; i + 1 < side; ++i) {
            const int self = at(i, j);
            if (self < 0) continue;
            const auto link = [&](int other, Real across, Real outwards) {
                Real stiff = k;
                if (other >= 0) entries.emplace_back(self, other, -k);
                else {  // to the rim, in intervals
                    const Real rim =
                        std::sqrt(static_cast<Real>(n * n) - across * across);
                    stiff = k / (rim - outwards);  // (29.21)
                }
                entries.emplace_back(self, self, stiff);
            };
            link(at(i + 1, j), along(j), along(i));
            link(at(i - 1, j), along(j), -along(i));
            link(at(i, j + 1), along(i), along(j));
            link(at(i, j - 1), along(i), -along(j));
        }
    StiffnessMatrix K(count, count);
    K.setFromTriplets(entries.begin(), entries.end());
    return K;
}
//! [drum]

//! [lowest_modes]
Modes lowest_modes(const StiffnessMatrix& K, Index count, Real tolerance,
                   int most_rounds)
{
    const Index n = K.rows();
    if (count < 1 || 3 * count > n || K.cols() != n)
        throw std::invalid_argument(
            std::to_string(count) + " modes of a matrix of " + std::to_string(n) +
            " rows and " + std::to_string(K.cols()) +
            " columns; it must be square, and have three rows a mode");
    const Eigen::SimplicialLDLT<StiffnessMatrix> factor(K);
    bool definite = factor.info() == Eigen::Success;
    for (Index i = 0; definite && i < n; ++i)  // one by one: NaN is not positive
        definite = factor.vectorD()[i] > 0 && factor.vectorD()[i] < infinity;
    if (!definite)
        throw std::invalid_argument(
            "the stiffness matrix is not positive definite");
    if (most_rounds < 1)
        throw std::invalid_argument("inverse iteration has " +
                                    std::to_string(most_rounds) +
                                    " rounds; it must have one or more");
    // some more than asked for: the error of the last shrinks by ω²_last / ω²_next
    const Index width = std::min(n, count + 4);
    MatX X(n, width);
    Random random(1);
    for (Index j = 0; j < width; ++j)
        for (Index i = 0; i < n; ++i) X(i, j) = random.uniform(-1, 1);
    Modes modes;
    while (!modes.solved && modes.rounds < most_rounds) {
        ++modes.rounds;
        X = factor.solve(X).eval();
        for (Index j = 0; j < width; ++j) {  // Gram-Schmidt, twice
            for (int again = 0; again < 2; ++again)
                for (Index i = 0; i < j; ++i)
                    X.col(j) -= X.col(i).dot(X.col(j)) * X.col(i);
            X.col(j).normalize();
        }
        const MatX KX = K * X, small = X.transpose() * KX;
        const Eigen::SelfAdjointEigenSolver<MatX> solver(small);
        const MatX Z = solver.eigenvectors();
        X = (X * Z).eval();
        const MatX off = KX * Z - X * solver.eigenvalues().asDiagonal();
        modes.residual = 0;
        for (Index j = 0; j < count; ++j)
            modes.residual = std::max(modes.residual,
                                      off.col(j).norm() / solver.eigenvalues()[j]);
        modes.omega = solver.eigenvalues().head(count).cwiseSqrt();
        modes.solved = modes.residual <= tolerance;
    }
    modes.shapes = X.leftCols(count);
    return modes;
}
//! [lowest_modes]

}  // namespace rigid
