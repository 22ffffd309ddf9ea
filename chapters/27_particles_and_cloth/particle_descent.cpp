// The functions of particle_descent.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/27_particles_and_cloth/particle_descent.hpp"

#include "chapters/16_soft_constraints/block_solve.hpp"

#include <algorithm>

namespace rigid {

namespace descent_parts {

/// A of a spring [1/kg]; of one between two pins that of a kilogram.
Real weight_of(const ClothScene& cloth, const ClothSpring& s)
{
    const VecX& w = cloth.bodies.inverse_mass;
    const Real A = w[3 * s.a] + w[3 * s.b];
    return A > 0 ? A : 1;
}

}  // namespace descent_parts

using namespace descent_parts;

void ParticleDescent::find(const ClothScene& cloth)
{
    const auto K = static_cast<std::size_t>(cloth.count());
    const int springs = static_cast<int>(cloth.springs.size()),
              bends = static_cast<int>(cloth.bends.size());
    const auto for_each_meeting = [&](auto&& f) {
        for (int i = 0; i < springs; ++i) {
            const ClothSpring& s = cloth.springs[static_cast<std::size_t>(i)];
            f(s.a, Meeting{i, 0}), f(s.b, Meeting{i, 1});
        }
        for (int i = 0; i < bends; ++i) {
            const ClothBend& b = cloth.bends[static_cast<std::size_t>(i)];
            for (int c = 0; c < b.count(); ++c)
                f(b.p[static_cast<std::size_t>(c)], Meeting{springs + i, c});
        }
        for (std::size_t i = 0; i < cloth.hinges.size(); ++i)
            for (int c = 0; c < 4; ++c)
                f(cloth.hinges[i].p[static_cast<std::size_t>(c)],
                  Meeting{springs + bends + static_cast<int>(i), c});
    };
    stiffness.resize(0), pull.resize(0);
    first_.assign(K + 1, 0);
    for_each_meeting(
        [this](int p, Meeting) { ++first_[static_cast<std::size_t>(p) + 1]; });
    for (std::size_t k = 0; k < K; ++k) first_[k + 1] += first_[k];
    list_.resize(first_.back());
    std::vector<std::size_t> next(first_.begin(), first_.end() - 1);
    for_each_meeting(
        [&](int p, Meeting m) { list_[next[static_cast<std::size_t>(p)]++] = m; });

    std::vector<int> colour(K, -1);
    std::vector<std::size_t>
        taken;  // of each colour: the last particle that saw it
    for (std::size_t k = 0; k < K; ++k) {
        for (std::size_t e = first_[k]; e < first_[k + 1]; ++e) {
            const auto see = [&](int p) {
                const int c = colour[static_cast<std::size_t>(p)];
                if (c >= 0) taken[static_cast<std::size_t>(c)] = k + 1;
            };
            const int row = list_[e].row;
            if (row < springs) {
                see(cloth.springs[static_cast<std::size_t>(row)].a);
                see(cloth.springs[static_cast<std::size_t>(row)].b);
                continue;
            }
            const auto i = static_cast<std::size_t>(row - springs);
            const auto& p =
                row < springs + bends
                    ? cloth.bends[i].p
                    : cloth.hinges[i - static_cast<std::size_t>(bends)].p;
            for (const int other : p)
                if (other >= 0) see(other);
        }
        std::size_t c = 0;
        while (c < taken.size() && taken[c] == k + 1) ++c;
        if (c == taken.size()) taken.push_back(0);
        colour[k] = static_cast<int>(c);
    }
    colours_ = static_cast<int>(taken.size());
    order_.resize(K);
    for (std::size_t k = 0; k < K; ++k) order_[k] = static_cast<int>(k);
    std::stable_sort(order_.begin(), order_.end(), [&](int a, int b) {
        return colour[static_cast<std::size_t>(a)] <
               colour[static_cast<std::size_t>(b)];
    });
}

//! [grow]
void ParticleDescent::begin(const ClothScene& cloth, Real h, bool augmented)
{
    const auto n = static_cast<Index>(cloth.springs.size());
    if (stiffness.size() != n) stiffness.setZero(n), pull.setZero(n);
    for (Index i = 0; i < n; ++i) {
        const ClothSpring& s = cloth.springs[static_cast<std::size_t>(i)];
        if (!augmented) {
            stiffness[i] = s.stiffness, pull[i] = 0;
            continue;
        }
        const Real m_per_h2 = 1 / (h * h * weight_of(cloth, s));
        stiffness[i] =
            std::min(s.stiffness, std::max(m_per_h2, kept * stiffness[i]));
        pull[i] *= kept;  // that of a soft one is zero
    }
}

void ParticleDescent::grow(const ClothScene& cloth, Real h, const VecX& x)
{
    for (Index i = 0; i < stiffness.size(); ++i) {
        const ClothSpring& s = cloth.springs[static_cast<std::size_t>(i)];
        const Real C =
            (x.segment<3>(3 * s.b) - x.segment<3>(3 * s.a)).norm() - s.length;
        if (s.stiffness == infinity) pull[i] += stiffness[i] * C;
        const Real m_per_h2 = 1 / (h * h * weight_of(cloth, s));
        stiffness[i] = std::min(
            s.stiffness, stiffness[i] + beta * m_per_h2 * std::abs(C) / s.length);
    }
}
//! [grow]

//! [sweep]
void ParticleDescent::sweep(const ClothScene& cloth, const VecX& y, Real h, VecX& x)
{
    const int springs = static_cast<int>(cloth.springs.size()),
              bends = static_cast<int>(cloth.bends.size());
    std::array<Vec3, 4> J;
    for (const int k : order_) {
        const Real w = cloth.bodies.inverse_mass[3 * k];
        if (!(w > 0)) continue;
        auto at = x.segment<3>(3 * k);
        Vec3 f = (y.segment<3>(3 * k) - at) / (h * h * w);
        Mat3 H = Mat3::Identity() / (h * h * w);
        const auto p = static_cast<std::size_t>(k);
        for (std::size_t e = first_[p]; e < first_[p + 1]; ++e) {
            const Meeting m = list_[e];
            const auto corner = static_cast<std::size_t>(m.corner);
            if (m.row < springs) {
                const ClothSpring& s =
                    cloth.springs[static_cast<std::size_t>(m.row)];
                const Vec3 d = x.segment<3>(3 * (corner == 0 ? s.b : s.a)) - at;
                const Real length = d.norm();
                if (!(length > 0)) continue;
                const Vec3 n = d / length;
                const Real along = stiffness[m.row],
                           F = pull[m.row] + along * (length - s.length),
                           across = std::max(Real{0}, F / length);
                f += n * F;
                H += across * Mat3::Identity() +
                     (along - across) * n * n.transpose();
            } else if (m.row < springs + bends) {
                const ClothBend& b =
                    cloth.bends[static_cast<std::size_t>(m.row - springs)];
                const Real g = b.stiffness * b.w[corner];
                f -= g * b.value(x);
                H += g * b.w[corner] * Mat3::Identity();
            } else {
                const ClothHinge& hinge =
                    cloth.hinges[static_cast<std::size_t>(m.row - springs - bends)];
                const Real C = hinge_angle(hinge, x, J) - hinge.angle;
                f -= hinge.stiffness * C * J[corner];
                H += hinge.stiffness * J[corner] * J[corner].transpose();
            }
        }
        at += solve_definite<3>(H, f);
    }
}
//! [sweep]

}  // namespace rigid
