// The functions of cloth_newton.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/27_particles_and_cloth/cloth_newton.hpp"

#include <Eigen/SparseCholesky>

#include <algorithm>

namespace rigid {

namespace cloth_sums {

/// In one order, whatever the compiler.
Real dot(const VecX& a, const VecX& b)
{
    Real sum = 0;
    for (Index i = 0; i < a.size(); ++i) sum += a[i] * b[i];
    return sum;
}

Real merit(const ClothScene& cloth, const VecX& x, const VecX& y, Real h)
{
    Real sum = 0;
    for (Index i = 0; i < x.size(); ++i)
        if (const Real w = cloth.bodies.inverse_mass[i]; w > 0)
            sum += (x[i] - y[i]) * (x[i] - y[i]) / w;
    return sum / (2 * h * h) + row_energy(cloth, x);
}

}  // namespace cloth_sums

void ClothModel::linearise(const ClothScene& cloth, const VecX& x)
{
    springs.resize(cloth.springs.size());
    for (std::size_t i = 0; i < springs.size(); ++i) {
        const ClothSpring& s = cloth.springs[i];
        const Vec3 d = x.segment<3>(3 * s.b) - x.segment<3>(3 * s.a);
        const Real length = d.norm();
        springs[i].n = length > 0 ? Vec3(d / length) : Vec3(0, 0, 0);
        springs[i].along = s.stiffness;
        springs[i].across =
            length > s.length ? s.stiffness * (1 - s.length / length) : 0;
    }
    hinges.resize(cloth.hinges.size());
    for (std::size_t i = 0; i < hinges.size(); ++i)
        hinge_angle(cloth.hinges[i], x, hinges[i]);
}

void ClothNewton::find_gradient(const ClothScene& cloth, const VecX& x,
                                const VecX& y, Real h)
{
    gradient_.setZero(x.size());
    add_row_forces(cloth, x, gradient_);
    residual = 0;
    for (Index k = 0; k < cloth.bodies.count(); ++k) {
        const Real w = cloth.bodies.inverse_mass[3 * k];
        auto g = gradient_.segment<3>(3 * k);
        if (!(w > 0)) {
            g.setZero();
            continue;
        }
        g = (x.segment<3>(3 * k) - y.segment<3>(3 * k)) / (h * h * w) - g;
        residual = std::max(residual, h * h * w * g.norm());
    }
}

//! [multiply]
void ClothNewton::multiply(const ClothScene& cloth, Real h, const VecX& v,
                           VecX& out) const
{
    for (Index i = 0; i < v.size(); ++i) {
        const Real w = cloth.bodies.inverse_mass[i];
        out[i] = w > 0 ? v[i] / (h * h * w) : 0;
    }
    for (std::size_t i = 0; i < model_.springs.size(); ++i) {
        const ClothModel::Spring& s = model_.springs[i];
        const Index a = 3 * cloth.springs[i].a, b = 3 * cloth.springs[i].b;
        const Vec3 d = v.segment<3>(b) - v.segment<3>(a);
        const Vec3 f = s.across * d + s.n * ((s.along - s.across) * s.n.dot(d));
        out.segment<3>(a) -= f;
        out.segment<3>(b) += f;
    }
    for (const ClothBend& bend : cloth.bends) {
        const Vec3 d = bend.stiffness * bend.value(v);
        for (std::size_t i = 0; i < 4 && bend.p[i] >= 0; ++i)
            out.segment<3>(3 * bend.p[i]) += bend.w[i] * d;
    }
    for (std::size_t k = 0; k < model_.hinges.size(); ++k) {
        const ClothHinge& hinge = cloth.hinges[k];
        const auto& J = model_.hinges[k];
        Real turn = 0;
        for (std::size_t i = 0; i < 4; ++i)
            turn += J[i].dot(v.segment<3>(3 * hinge.p[i]));
        for (std::size_t i = 0; i < 4; ++i)
            out.segment<3>(3 * hinge.p[i]) += hinge.stiffness * turn * J[i];
    }
    for (Index i = 0; i < out.size(); ++i)
        if (!(cloth.bodies.inverse_mass[i] > 0)) out[i] = 0;
}
//! [multiply]

//! [linear]
void ClothNewton::linear(const ClothScene& cloth, const VecX& x0, const VecX& y,
                         Real h, VecX& x)
{
    using cloth_sums::dot;
    model_.linearise(cloth, x0);
    const Index n = x0.size();
    for (VecX* const v : {&scaled_, &image_}) v->resize(n);
    diagonal_.setZero(n);
    for (Index i = 0; i < n; ++i)
        if (const Real w = cloth.bodies.inverse_mass[i]; w > 0)
            diagonal_[i] = 1 / (h * h * w);
    model_.for_each_block(cloth, [this](int p, int q, const Mat3& K) {
        if (p == q) diagonal_.segment<3>(3 * p) += K.diagonal();
    });
    // H Δ = −∂G at x₀, from Δ = y − x₀ on
    find_gradient(cloth, x0, y, h);
    trial_ = y - x0;
    multiply(cloth, h, trial_, image_);
    residual_ = -gradient_ - image_;
    const auto precondition = [&] {
        for (Index i = 0; i < n; ++i)
            scaled_[i] =
                cloth.bodies.inverse_mass[i] > 0 ? residual_[i] / diagonal_[i] : 0;
    };
    precondition();
    direction_ = scaled_;
    Real rho = dot(residual_, scaled_);
    Real size =
        0;  // of the pull that the particles would feel if nothing held them
    for (Index i = 0; i < n; ++i)
        if (diagonal_[i] > 0) size += gradient_[i] * gradient_[i] / diagonal_[i];
    const Real enough = cg_tolerance * cg_tolerance * std::max(size, rho);
    cg_steps = 0;
    while (rho > enough && cg_steps < cg_iterations) {
        ++cg_steps;
        multiply(cloth, h, direction_, image_);
        const Real alpha = rho / dot(direction_, image_);
        trial_ += alpha * direction_;
        residual_ -= alpha * image_;
        precondition();
        const Real next = dot(residual_, scaled_);
        direction_ = scaled_ + (next / rho) * direction_;
        rho = next;
    }
    steps = 1, solved = rho <= enough && rho < infinity;
    x = x0 + trial_;
}
//! [linear]

void ClothNewton::begin(const ClothScene& cloth, const VecX& x0, Real h, VecX& x)
{
    VecX from = x;
    for (Index i = 0; i < x.size(); ++i)
        if (cloth.bodies.inverse_mass[i] > 0) from[i] = x0[i];
    if (cloth_sums::merit(cloth, from, x, h) < cloth_sums::merit(cloth, x, x, h))
        x = from;
}

//! [minimise]
void ClothNewton::minimise(const ClothScene& cloth, const VecX& y, Real h, VecX& x)
{
    number_.assign(static_cast<std::size_t>(cloth.count()), -1);
    int free = 0;
    for (int k = 0; k < cloth.count(); ++k)
        if (cloth.bodies.inverse_mass[3 * k] > 0)
            number_[static_cast<std::size_t>(k)] = free++;
    Real G = cloth_sums::merit(cloth, x, y, h);
    Eigen::SimplicialLDLT<Eigen::SparseMatrix<Real>> factor;
    solved = false;
    for (steps = 0;; ++steps) {
        find_gradient(cloth, x, y, h);
        solved = residual <= tolerance;
        if (solved || steps == iterations) return;
        model_.linearise(cloth, x);
        entries_.clear();
        for (int k = 0; k < cloth.count(); ++k)
            if (const int p = number_[static_cast<std::size_t>(k)]; p >= 0)
                for (int i = 0; i < 3; ++i)
                    entries_.emplace_back(
                        3 * p + i, 3 * p + i,
                        1 / (h * h * cloth.bodies.inverse_mass[3 * k]));
        model_.for_each_block(cloth, [this](int a, int b, const Mat3& K) {
            const int p = number_[static_cast<std::size_t>(a)],
                      q = number_[static_cast<std::size_t>(b)];
            if (p < q || q < 0) return;  // the lower half is enough
            for (int i = 0; i < 3; ++i)
                for (int j = 0; j < 3; ++j)
                    entries_.emplace_back(3 * p + i, 3 * q + j, K(i, j));
        });
        H_.resize(3 * free, 3 * free);
        H_.setFromTriplets(entries_.begin(), entries_.end());
        factor.compute(H_);
        VecX right(3 * free);
        for (int k = 0; k < cloth.count(); ++k)
            if (const int p = number_[static_cast<std::size_t>(k)]; p >= 0)
                right.segment<3>(3 * p) = -gradient_.segment<3>(3 * k);
        const VecX change = factor.solve(right);
        const Real slope = -cloth_sums::dot(right, change);
        // shorter until G falls; near its least value rounding hides the fall
        Real part = 1, next = G;
        for (int halvings = 0; halvings < 30; ++halvings, part /= 2) {
            trial_ = x;
            for (int k = 0; k < cloth.count(); ++k)
                if (const int p = number_[static_cast<std::size_t>(k)]; p >= 0)
                    trial_.segment<3>(3 * k) += part * change.segment<3>(3 * p);
            next = cloth_sums::merit(cloth, trial_, y, h);
            if (next <= G + 1e-4 * part * slope + 1e-14 * std::abs(G)) break;
        }
        x = trial_;
        G = next;
    }
}
//! [minimise]

}  // namespace rigid
