// The functions of exact_rows.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/27_particles_and_cloth/exact_rows.hpp"

#include <algorithm>

namespace rigid {

void ExactRows::find_rows(const ClothScene& cloth, const VecX& x, Real h)
{
    const auto springs = static_cast<Index>(cloth.springs.size()),
               bends = static_cast<Index>(cloth.bends.size()),
               hinges = static_cast<Index>(cloth.hinges.size());
    const Index m = springs + 3 * bends + hinges;
    C_.resize(m), gamma_.resize(m);
    if (lambda.size() != m) lambda.setZero(m);
    entries_.clear();
    Index row = 0;
    const auto begin = [&](Real C, Real k) {
        C_[row] = C;
        gamma_[row] = 1 / (h * h * k);
    };
    for (const ClothSpring& s : cloth.springs) {
        const Vec3 d = x.segment<3>(3 * s.b) - x.segment<3>(3 * s.a);
        const Real length = d.norm();
        const Vec3 n = length > 0 ? Vec3(d / length) : Vec3(0, 0, 0);
        begin(length - s.length, s.stiffness);
        entries_.push_back({static_cast<int>(row), s.a, -n});
        entries_.push_back({static_cast<int>(row++), s.b, n});
    }
    for (const ClothBend& b : cloth.bends) {
        const Vec3 d = b.value(x);
        for (int i = 0; i < 3; ++i) {
            begin(d[i], b.stiffness);
            for (std::size_t c = 0; c < 4 && b.p[c] >= 0; ++c) {
                Vec3 J(0, 0, 0);
                J[i] = b.w[c];
                entries_.push_back({static_cast<int>(row), b.p[c], J});
            }
            ++row;
        }
    }
    std::array<Vec3, 4> J;
    for (const ClothHinge& hinge : cloth.hinges) {
        begin(hinge_angle(hinge, x, J) - hinge.angle, hinge.stiffness);
        for (std::size_t c = 0; c < 4; ++c)
            entries_.push_back({static_cast<int>(row), hinge.p[c], J[c]});
        ++row;
    }
}

//! [solve]
void ExactRows::solve(const ClothScene& cloth, const VecX& y, Real h, VecX& x)
{
    const VecX& w = cloth.bodies.inverse_mass;
    solved = false;
    for (steps = 0;; ++steps) {
        find_rows(cloth, x, h);
        VecX r = y - x;
        for (const Entry& e : entries_)
            r.segment<3>(3 * e.particle) += w[3 * e.particle] * lambda[e.row] * e.J;
        for (Index i = 0; i < r.size(); ++i)
            if (!(w[i] > 0)) r[i] = 0;
        right_ = -C_;
        for (Index i = 0; i < right_.size(); ++i)
            right_[i] -= gamma_[i] * lambda[i];
        residual = std::max(right_.cwiseAbs().maxCoeff(), r.cwiseAbs().maxCoeff());
        solved = residual <= tolerance;
        if (solved || steps == iterations) return;
        for (const Entry& e : entries_)
            right_[e.row] -= e.J.dot(r.segment<3>(3 * e.particle));
        // A: two rows that share a particle meet there
        std::sort(entries_.begin(), entries_.end(),
                  [](const Entry& a, const Entry& b) {
                      return a.particle != b.particle ? a.particle < b.particle
                                                      : a.row < b.row;
                  });
        triplets_.clear();
        const Index m = right_.size();
        for (Index i = 0; i < m; ++i)
            triplets_.emplace_back(static_cast<int>(i), static_cast<int>(i),
                                   gamma_[i]);
        for (std::size_t i = 0; i < entries_.size(); ++i)
            for (std::size_t j = i; j < entries_.size() &&
                                    entries_[j].particle == entries_[i].particle;
                 ++j)
                triplets_.emplace_back(entries_[j].row, entries_[i].row,
                                       w[3 * entries_[i].particle] *
                                           entries_[i].J.dot(entries_[j].J));
        Eigen::SparseMatrix<Real> A(m, m);
        A.setFromTriplets(triplets_.begin(), triplets_.end());
        factor_.compute(A);
        if (factor_.info() != Eigen::Success)
            return;  // rows that say the same, none of them soft
        const VecX change = factor_.solve(right_);
        if (!change.allFinite()) return;
        lambda += change;
        x += r;
        for (const Entry& e : entries_)
            x.segment<3>(3 * e.particle) += w[3 * e.particle] * change[e.row] * e.J;
    }
}
//! [solve]

}  // namespace rigid
