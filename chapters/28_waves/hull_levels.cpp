// The functions of hull_levels.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/28_waves/hull_levels.hpp"

#include <algorithm>

namespace rigid {
namespace {

/// A cell that hulls cover whole has this much of a surface left, so that no row of the matrix is zero.
constexpr Real gap = 1e-9;

Real dot(const std::vector<Real>& a, const std::vector<Real>& b)
{
    Real sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
    return sum;
}

Vec3 rising(const HullLevels::Slice& s)
{
    return {s.rising[0], s.rising[1], s.rising[2]};
}

}  // namespace

/// (1 − W) x + flow between neighbours + what hulls do that x pushes.
void HullLevels::apply(const std::vector<Real>& x, std::vector<Real>& out)
{
    for (std::size_t i = 0; i < cells.size(); ++i)
        out[i] = std::max(1 - cells[i].width, gap) * x[i];
    for (const Face& f : faces) {
        const Real a = f.a < 0 ? 0 : x[static_cast<std::size_t>(f.a)],
                   b = f.b < 0 ? 0 : x[static_cast<std::size_t>(f.b)];
        const Real flow = f.passing * (b - a);
        if (f.a >= 0) out[static_cast<std::size_t>(f.a)] -= flow;
        if (f.b >= 0) out[static_cast<std::size_t>(f.b)] += flow;
    }
    for (Vec3& p : pushed_) p.setZero();
    for (const Slice& s : slices)
        pushed_[static_cast<std::size_t>(s.body)] +=
            force_ * s.width * x[static_cast<std::size_t>(s.cell)] * rising(s);
    for (std::size_t k = 0; k < bodies.size(); ++k)
        pushed_[k] = inverse_[k] * pushed_[k];
    for (const Slice& s : slices)
        out[static_cast<std::size_t>(s.cell)] +=
            h_ * s.width * rising(s).dot(pushed_[static_cast<std::size_t>(s.body)]);
}

//! [hull_levels]
bool HullLevels::solve_once(Real h, Real weight, Real area)
{
    const std::size_t n = cells.size(), K = bodies.size();
    h_ = h, force_ = h * weight * area;
    inverse_.assign(K, Mat3::Zero());
    pushed_.assign(K, Vec3::Zero());
    // the hulls with their waterlines as springs: (M + h² ρ g Σ a J Jᵀ) V' = …
    for (std::size_t k = 0; k < K; ++k)
        if (bodies[k].moves) {
            inverse_[k] = bodies[k].mass;
            pushed_[k] = bodies[k].mass * free_[k];
        }
    for (const Slice& s : slices) {
        const auto k = static_cast<std::size_t>(s.body);
        if (!bodies[k].moves) continue;
        inverse_[k] += h * force_ * s.width * rising(s) * rising(s).transpose();
        pushed_[k] += h * weight * s.volume * rising(s);
    }
    for (std::size_t k = 0; k < K; ++k) {
        bodies[k].velocity = free_[k];
        if (bodies[k].moves) {
            inverse_[k] = Mat3(inverse_[k].inverse());
            bodies[k].velocity = inverse_[k] * pushed_[k];
        }
    }
    // the right-hand side: water that is missing, that slopes send, that hulls push out
    r_.resize(n), x_.assign(n, 0), p_.resize(n), Ap_.resize(n), diagonal_.resize(n);
    for (std::size_t i = 0; i < n; ++i) {
        r_[i] = repaid * cells[i].error + cells[i].inflow;
        diagonal_[i] = std::max(1 - cells[i].width, gap);
    }
    for (const Face& f : faces) {
        if (f.a >= 0) {
            r_[static_cast<std::size_t>(f.a)] += f.passing * f.rise;
            diagonal_[static_cast<std::size_t>(f.a)] += f.passing;
        }
        if (f.b >= 0) {
            r_[static_cast<std::size_t>(f.b)] -= f.passing * f.rise;
            diagonal_[static_cast<std::size_t>(f.b)] += f.passing;
        }
    }
    for (const Slice& s : slices) {
        const auto i = static_cast<std::size_t>(s.cell),
                   k = static_cast<std::size_t>(s.body);
        r_[i] -= h * s.width * rising(s).dot(bodies[k].velocity);
        diagonal_[i] +=
            h * force_ * s.width * s.width * rising(s).dot(inverse_[k] * rising(s));
    }
    // conjugate gradients, each row by its diagonal
    Real largest = 0;
    for (const Real r : r_) largest = std::max(largest, std::abs(r));
    const Real enough = 1e-13 * largest;
    const auto scaled = [&](std::size_t i) { return r_[i] / diagonal_[i]; };
    Real rz = 0;
    for (std::size_t i = 0; i < n; ++i) p_[i] = scaled(i), rz += r_[i] * p_[i];
    residual = largest;
    for (rounds = 0; residual > enough && rounds < 2 * static_cast<int>(n) + 20;
         ++rounds) {
        apply(p_, Ap_);
        const Real alpha = rz / dot(p_, Ap_);
        residual = 0;
        Real next = 0;
        for (std::size_t i = 0; i < n; ++i) {
            x_[i] += alpha * p_[i];
            r_[i] -= alpha * Ap_[i];
            residual = std::max(residual, std::abs(r_[i]));
            next += r_[i] * scaled(i);
        }
        for (std::size_t i = 0; i < n; ++i) p_[i] = scaled(i) + next / rz * p_[i];
        rz = next;
    }
    // and what follows from the levels
    for (Vec3& p : pushed_) p.setZero();
    for (const Slice& s : slices)
        pushed_[static_cast<std::size_t>(s.body)] +=
            force_ * s.width * x_[static_cast<std::size_t>(s.cell)] * rising(s);
    for (std::size_t k = 0; k < K; ++k)
        bodies[k].velocity += inverse_[k] * pushed_[k];
    after_.clear();
    for (const Slice& s : slices) {
        const Real higher =
            x_[static_cast<std::size_t>(s.cell)] -
            h * rising(s).dot(bodies[static_cast<std::size_t>(s.body)].velocity);
        after_.push_back(s.volume + area * s.width * higher);
    }
    return residual <= enough;
}
//! [hull_levels]

bool HullLevels::solve(Real h, Real weight, Real area)
{
    free_.clear();
    for (const Body& body : bodies) free_.push_back(body.velocity);
    bool solved = false;
    for (releases = 0; releases < 10; ++releases) {
        solved = solve_once(h, weight, area);
        bool pulls = false;
        for (std::size_t s = 0; s < slices.size(); ++s)
            if (after_[s] < 0) {
                Cell& cell = cells[static_cast<std::size_t>(slices[s].cell)];
                cell.error -= slices[s].volume / area;
                cell.width = std::max(cell.width - slices[s].width, 0.0);
                slices[s].volume = slices[s].width = 0;
                pulls = true;
            }
        if (!pulls) break;
    }
    for (std::size_t s = 0; s < slices.size(); ++s)
        slices[s].volume = std::max(after_[s], 0.0);
    for (std::size_t i = 0; i < cells.size(); ++i) cells[i].level += x_[i];
    return solved;
}

}  // namespace rigid
