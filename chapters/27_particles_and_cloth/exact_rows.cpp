// The functions of exact_rows.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/27_particles_and_cloth/exact_rows.hpp"

#include <algorithm>

namespace rigid {

namespace exact_parts {

/// The least γ of the matrix, as a part of A_ii: a proximal term (9.12), without which hard rows that say the same have no pivot.
/// What a pass leaves of its error for it, 1e-8, is about what it leaves for rounding, 1e-16 over that.
constexpr Real proximal = 1e-8;

}  // namespace exact_parts

//! [pattern]
void ExactRows::prepare(const ClothScene& cloth)
{
    number_.assign(static_cast<std::size_t>(cloth.count()), -1);
    free_ = 0;
    for (int k = 0; k < cloth.count(); ++k)
        if (cloth.bodies.inverse_mass[3 * k] > 0)
            number_[static_cast<std::size_t>(k)] = free_++;
    lambda.setZero(static_cast<Index>(
        cloth.springs.size() + 3 * cloth.bends.size() + cloth.hinges.size()));
    find_rows(cloth, cloth.bodies.x, 1);
    const int n = 3 * free_ + static_cast<int>(lambda.size());
    std::vector<Eigen::Triplet<Real>> places;
    const auto block = [&](int p, int q) {
        for (int i = 0; i < 9; ++i)
            places.emplace_back(3 * p + i / 3, 3 * q + i % 3, 1.0);
    };
    for (int p = 0; p < free_; ++p) block(p, p);
    for (int i = 3 * free_; i < n; ++i) places.emplace_back(i, i, 1.0);
    for (const ClothSpring& s : cloth.springs) {
        const int p = number_[static_cast<std::size_t>(s.a)],
                  q = number_[static_cast<std::size_t>(s.b)];
        if (p >= 0 && q >= 0) block(p, q), block(q, p);
    }
    const auto first_bend = static_cast<int>(cloth.springs.size()),
               first_hinge = first_bend + 3 * static_cast<int>(cloth.bends.size());
    held_.assign(static_cast<std::size_t>(lambda.size()), 1);
    for (const Entry& e : entries_) {
        const int p = number_[static_cast<std::size_t>(e.particle)];
        if (p < 0) continue;
        held_[static_cast<std::size_t>(e.row)] = 0;
        const bool bend = e.row >= first_bend && e.row < first_hinge;
        for (int i = 0; i < 3; ++i) {
            // a bend has a row for each coordinate
            if (bend && i != (e.row - first_bend) % 3) continue;
            places.emplace_back(3 * free_ + e.row, 3 * p + i, 1.0);
            places.emplace_back(3 * p + i, 3 * free_ + e.row, 1.0);
        }
    }
    system_.A.resize(n, n);
    system_.A.setFromTriplets(places.begin(), places.end());
    system_.A.makeCompressed();
    system_.q.setZero(n);
    all_.assign(static_cast<std::size_t>(n), BoundState::between);
    problem_.shifted = false;
    problem_.diagonal.setConstant(n, -infinity);  // pivots of either sign
    factor_.analyse_pattern(system_);
}
//! [pattern]

void ExactRows::find_rows(const ClothScene& cloth, const VecX& x, Real h)
{
    C_.resize(lambda.size()), gamma_.resize(lambda.size());
    entries_.clear();
    int row = 0;
    const auto begin = [&](Real C, Real k) {
        C_[row] = C;
        gamma_[row] = 1 / (h * h * k);
    };
    for (const ClothSpring& s : cloth.springs) {
        const Vec3 d = x.segment<3>(3 * s.b) - x.segment<3>(3 * s.a);
        const Real length = d.norm();
        const Vec3 n = length > 0 ? Vec3(d / length) : Vec3(0, 0, 0);
        begin(length - s.length, s.stiffness);
        entries_.push_back({row, s.a, -n});
        entries_.push_back({row++, s.b, n});
    }
    for (const ClothBend& b : cloth.bends) {
        const Vec3 d = b.value(x);
        for (int i = 0; i < 3; ++i) {
            begin(d[i], b.stiffness);
            for (std::size_t c = 0; c < 4 && b.p[c] >= 0; ++c)
                entries_.push_back({row, b.p[c], b.w[c] * Vec3::Unit(i)});
            ++row;
        }
    }
    std::array<Vec3, 4> J;
    for (const ClothHinge& hinge : cloth.hinges) {
        begin(hinge_angle(hinge, x, J) - hinge.angle, hinge.stiffness);
        for (std::size_t c = 0; c < 4; ++c)
            entries_.push_back({row, hinge.p[c], J[c]});
        ++row;
    }
}

void ExactRows::add(int row, int column, Real value)
{
    const int* const inner = system_.A.innerIndexPtr();
    const int* const outer = system_.A.outerIndexPtr();
    const int* const at =
        std::lower_bound(inner + outer[row], inner + outer[row + 1], column);
    system_.A.valuePtr()[at - inner] += value;
}

//! [fill]
void ExactRows::fill(const ClothScene& cloth, const VecX& x)
{
    const VecX& w = cloth.bodies.inverse_mass;
    std::fill_n(system_.A.valuePtr(), system_.A.nonZeros(), Real{0});
    for (int k = 0; k < cloth.count(); ++k)
        if (const int p = number_[static_cast<std::size_t>(k)]; p >= 0)
            for (int i = 0; i < 3; ++i) add(3 * p + i, 3 * p + i, 1 / w[3 * k]);
    push_.setZero(lambda.size());  // A_ii
    for (const Entry& e : entries_) {
        push_[e.row] += w[3 * e.particle] * e.J.squaredNorm();
        const int p = number_[static_cast<std::size_t>(e.particle)];
        for (int i = 0; i < 3 && p >= 0; ++i) {
            if (e.J[i] == 0) continue;
            add(3 * free_ + e.row, 3 * p + i, e.J[i]);
            add(3 * p + i, 3 * free_ + e.row, e.J[i]);
        }
    }
    for (Index r = 0; r < lambda.size(); ++r)
        add(3 * free_ + static_cast<int>(r), 3 * free_ + static_cast<int>(r),
            -std::max(gamma_[r], exact_parts::proximal * push_[r]));
    for (std::size_t s = 0; s < cloth.springs.size(); ++s) {  // h² K
        const ClothSpring& spring = cloth.springs[s];
        const Vec3 d = x.segment<3>(3 * spring.b) - x.segment<3>(3 * spring.a);
        const Real length = d.norm(), pull = -lambda[static_cast<Index>(s)];
        if (!(pull > 0 && length > 0)) continue;
        const Mat3 K = pull / length *
                       (Mat3::Identity() - d * d.transpose() / (length * length));
        const int p = number_[static_cast<std::size_t>(spring.a)],
                  q = number_[static_cast<std::size_t>(spring.b)];
        for (int i = 0; i < 3; ++i)
            for (int j = 0; j < 3; ++j) {
                if (p >= 0) add(3 * p + i, 3 * p + j, K(i, j));
                if (q >= 0) add(3 * q + i, 3 * q + j, K(i, j));
                if (p < 0 || q < 0) continue;
                add(3 * p + i, 3 * q + j, -K(i, j));
                add(3 * q + i, 3 * p + j, -K(i, j));
            }
    }
}
//! [fill]

//! [solve]
void ExactRows::solve(const ClothScene& cloth, const VecX& y, Real h, VecX& x)
{
    const VecX& w = cloth.bodies.inverse_mass;
    const Index rows = 3 * free_;
    right_.resize(rows + lambda.size());
    problem_.mlcp = &system_;  // its own, if this is a copy
    solved = false;
    for (steps = 0;; ++steps) {
        find_rows(cloth, x, h);
        residual = 0;
        right_.setZero();
        for (const Entry& e : entries_)
            if (const int p = number_[static_cast<std::size_t>(e.particle)]; p >= 0)
                right_.segment<3>(3 * p) += lambda[e.row] * e.J;
        for (int k = 0; k < cloth.count(); ++k) {
            const int p = number_[static_cast<std::size_t>(k)];
            if (p < 0) continue;
            right_.segment<3>(3 * p) +=
                (y.segment<3>(3 * k) - x.segment<3>(3 * k)) / w[3 * k];
            residual =
                std::max(residual, w[3 * k] * right_.segment<3>(3 * p).norm());
        }
        for (Index i = 0; i < lambda.size(); ++i) {
            if (held_[static_cast<std::size_t>(i)] != 0) {
                C_[i] = 0, gamma_[i] = 1, lambda[i] = 0;
                continue;
            }
            right_[rows + i] = -(C_[i] + gamma_[i] * lambda[i]);
            residual = std::max(residual, std::abs(right_[rows + i]));
        }
        solved = residual <= tolerance;
        if (solved || steps == iterations) return;
        fill(cloth, x);
        factor_.forget();
        if (!factor_.factor(problem_, all_, work_)) return;
        factor_.solve(right_);
        if (!right_.allFinite()) return;
        for (int k = 0; k < cloth.count(); ++k)
            if (const int p = number_[static_cast<std::size_t>(k)]; p >= 0)
                x.segment<3>(3 * k) += right_.segment<3>(3 * p);
        lambda -= right_.tail(lambda.size());
    }
}
//! [solve]

}  // namespace rigid
