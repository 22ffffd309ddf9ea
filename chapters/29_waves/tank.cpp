// The functions of tank.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/29_waves/tank.hpp"

#include <vector>

namespace rigid {

Tank::Tank(Index nx, Index nz, Real length, Real depth, Real g)
    : level(VecX::Zero(std::max<Index>(nx, 0))), potential(level), nx_(nx), nz_(nz)
{
    if (nx < 2 || nz < 2)
        throw std::invalid_argument("the tank has " + std::to_string(nx) + " by " +
                                    std::to_string(nz) +
                                    " cells; it must have two or more each way");
    for (const Real value : {length, depth, g})
        if (!(value > 0) || !std::isfinite(value))
            throw std::invalid_argument(
                "the length, the depth or the gravity of the tank is " +
                shortest(value) + "; it must be positive and finite");
    const Real dx = length / static_cast<Real>(nx);
    dz_ = depth / static_cast<Real>(nz);
    g_ = g;
    std::vector<Eigen::Triplet<Real>> entries;
    const auto number = [nx](Index i, Index j) {
        return static_cast<int>(j * nx + i);
    };
    const auto link = [&](int a, int b, Real k) {
        entries.emplace_back(a, a, k);
        entries.emplace_back(b, b, k);
        entries.emplace_back(a, b, -k);
        entries.emplace_back(b, a, -k);
    };
    for (Index j = 0; j < nz; ++j)
        for (Index i = 0; i < nx; ++i) {
            if (i > 0) link(number(i - 1, j), number(i, j), 1 / (dx * dx));
            if (j > 0) link(number(i, j - 1), number(i, j), 1 / (dz_ * dz_));
            // the surface is half a cell above the middle of the uppermost
            if (j == nz - 1)
                entries.emplace_back(number(i, j), number(i, j), 2 / (dz_ * dz_));
        }
    Eigen::SparseMatrix<Real> A(nx * nz, nx * nz);
    A.setFromTriplets(entries.begin(), entries.end());
    factor_.compute(A);
    right_ = below_ = VecX::Zero(nx * nz);
    speed_ = VecX::Zero(nx);
}

void Tank::vertical_speed(const VecX& surface, VecX& speed)
{
    right_.tail(nx_) = 2 / (dz_ * dz_) * surface;
    below_ = factor_.solve(right_);
    speed = 2 / dz_ * (surface - below_.tail(nx_));
}

Real Tank::stable_step() const { return 2 / std::sqrt(2 * g_ / dz_); }

//! [tank]
void Tank::step(Real h)
{
    require_step(h);
    if (h > stable_step())
        throw std::invalid_argument("the time step is " + shortest(h) +
                                    " s; the tank is stable up to " +
                                    shortest(stable_step()) + " s");
    for (const auto& [list, name] :
         {std::pair{&level, "level"}, {&potential, "potential"}}) {
        if (list->size() != nx_)
            throw std::invalid_argument(std::string(name) + " has " +
                                        std::to_string(list->size()) +
                                        " entries; the tank has " +
                                        std::to_string(nx_) + " cells along it");
        require_finite(*list, name);
    }
    potential -= h * g_ * level;
    vertical_speed(potential, speed_);
    level += h * speed_;
}
//! [tank]

}  // namespace rigid
