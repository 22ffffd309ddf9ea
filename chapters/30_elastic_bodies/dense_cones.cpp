// The functions of dense_cones.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/24_friction_is_a_disc/cone_guess.hpp"
#include "chapters/30_elastic_bodies/dense_cones.hpp"

namespace rigid {

void DenseCones::Mix::add(std::size_t k, Real p)
{
    row[static_cast<std::size_t>(count)] = static_cast<int>(k);
    part[static_cast<std::size_t>(count)] = p;
    ++count;
}

void DenseCones::begin(std::size_t m)
{
    if (A.size() < m * m) A.resize(m * m);
    q.setZero(static_cast<Index>(m));
    rows.resize(m);
    for (SolverRow<6>& row : rows) {  // no bodies: all of J M⁻¹ Jᵀ is in A
        row.Ja.setZero(), row.Jb.setZero(), row.Wa.setZero(), row.Wb.setZero();
        row.bias = row.lambda = 0, row.a = row.b = 0;
        row.lo = -infinity, row.hi = infinity;
    }
    feedback.assign(m, Feedback{});
}

ConeRows DenseCones::view() { return {rows, feedback, disc_at_, discs_, {}}; }

void DenseCones::find_discs()
{
    const std::size_t m = rows.size();
    discs_.clear();
    disc_at_.assign(m, -1);
    for (std::size_t k = 0; k < m; ++k)
        rows[k].mass = A[k * m + k] > 0 ? 1 / A[k * m + k] : 0;
    for (std::size_t k = 0; k + 1 < m; ++k) {
        const Feedback &one = feedback[k], &two = feedback[k + 1];
        if (one.bounding == 0 || two.bounding + 1 != one.bounding ||
            one.friction != two.friction)
            continue;
        disc_at_[k] = static_cast<int>(discs_.size());
        const Real a = A[k * m + k], b = A[(k + 1) * m + k + 1],
                   c = A[k * m + k + 1];
        DiscOfRows disc;
        disc.row = k;
        disc.A << a, c, c, b;
        disc.largest = (a + b) / 2 + std::sqrt((a - b) * (a - b) / 4 + c * c);
        discs_.push_back(disc);
        ++k;
    }
}

void DenseCones::velocities()
{
    const std::size_t m = rows.size();
    for (std::size_t i = 0; i < m; ++i) {
        Real w = q[static_cast<Index>(i)];
        const Real* const a = A.data() + i * m;
        for (std::size_t j = 0; j < m; ++j)
            w += a[j] * g_.lambda[static_cast<Index>(j)];
        g_.w[static_cast<Index>(i)] = w;
    }
}

void DenseCones::press()
{
    const ConeRows p = view();
    for (std::size_t k = 0; k < rows.size(); ++k)
        if (p.bound_by(k) < 0) {
            Real& x = g_.lambda[static_cast<Index>(k)];
            x = std::clamp(x, rows[k].lo, rows[k].hi);
        }
    for (std::size_t k = 0; k < rows.size(); ++k) {
        const auto i = static_cast<Index>(k);
        if (p.bound_by(k) < 0) continue;
        const Real bound =
            feedback[k].friction * std::max(Real{0}, g_.lambda[p.bound_by(k)]);
        if (p.disc(k)) {
            g_.lambda.segment<2>(i) = onto_disc(g_.lambda.segment<2>(i), bound);
            ++k;
        } else g_.lambda[i] = std::clamp(g_.lambda[i], -bound, bound);
    }
}

bool DenseCones::accept(Real enough)
{
    from_ = g_.lambda;
    press();
    velocities();
    const Real here = choose_cases(view(), infinity, g_);
    if (here < residual_) residual_ = here, best_ = g_.lambda;
    g_.lambda = from_;
    return here <= enough;
}

void DenseCones::write_equations()
{
    const ConeRows p = view();
    g_.equations.clear(), g_.of_row.clear();
    g_.equation_of.assign(rows.size(), -1);
    tests_.clear(), columns_.clear();
    const auto add = [&](std::size_t k, Real give) -> Mix& {
        g_.equation_of[k] = static_cast<int>(g_.equations.size());
        g_.of_row.push_back(static_cast<int>(k));
        g_.equations.emplace_back();
        g_.equations.back().give = give;
        tests_.emplace_back(), columns_.emplace_back();
        return columns_.back();
    };
    for (std::size_t k = 0; k < rows.size(); ++k)
        if (p.bound_by(k) < 0 && g_.cases[k] == ConeCase::free &&
            rows[k].mass > 0) {
            add(k, cone_share / rows[k].mass).add(k, 1);
            tests_.back().add(k, 1);
        }
    for (std::size_t k = 0; k < rows.size(); ++k) {
        const int normal = p.bound_by(k);
        if (normal < 0) continue;
        const DiscOfRows* const disc = p.disc(k);
        const std::size_t here = k;
        if (disc) ++k;
        const int at = g_.equation_of[static_cast<std::size_t>(normal)];
        const ConeCase now = g_.cases[here];
        if (at < 0) continue;
        Mix& with_normal = columns_[static_cast<std::size_t>(at)];
        const Real mu = feedback[here].friction;
        if (!disc) {
            if (now != ConeCase::free)
                with_normal.add(here, now == ConeCase::low ? -mu : mu);
            else if (rows[here].mass > 0) {
                add(here, cone_share / rows[here].mass).add(here, 1);
                tests_.back().add(here, 1);
            }
            continue;
        }
        if (now == ConeCase::free)
            for (const std::size_t one : {here, here + 1}) {
                add(one, cone_share * disc->largest).add(one, 1);
                tests_.back().add(one, 1);
            }
        else if (now == ConeCase::slides) {
            const Vec2 d = g_.direction[here];
            with_normal.add(here, mu * d.x()),
                with_normal.add(here + 1, mu * d.y());
            Mix& across = add(here, cone_share * disc->largest +
                                        g_.give[static_cast<Index>(here)]);
            across.add(here, -d.y()), across.add(here + 1, d.x());
            tests_.back() = across;
        }
    }
}

//! [elimination]
void DenseCones::factor()
{
    const std::size_t m = rows.size(), n = tests_.size();
    if (matrix_.size() < n * n) matrix_.resize(n * n);
    pivot_.resize(n);
    Real largest = 0;
    for (std::size_t e = 0; e < n; ++e)
        for (std::size_t f = 0; f < n; ++f) {
            Real sum = e == f ? g_.equations[e].give : 0;
            for (int i = 0; i < tests_[e].count; ++i)
                for (int j = 0; j < columns_[f].count; ++j) {
                    const auto a = static_cast<std::size_t>(i),
                               b = static_cast<std::size_t>(j);
                    sum += tests_[e].part[a] * columns_[f].part[b] *
                           A[static_cast<std::size_t>(tests_[e].row[a]) * m +
                             static_cast<std::size_t>(columns_[f].row[b])];
                }
            matrix_[e * n + f] = sum;
            largest = std::max(largest, std::abs(sum));
        }
    for (std::size_t k = 0; k < n; ++k) {
        std::size_t top = k;
        for (std::size_t i = k + 1; i < n; ++i)
            if (std::abs(matrix_[i * n + k]) > std::abs(matrix_[top * n + k]))
                top = i;
        pivot_[k] = static_cast<int>(top);
        if (top != k)
            std::swap_ranges(matrix_.data() + k * n, matrix_.data() + (k + 1) * n,
                             matrix_.data() + top * n);
        const Real* const from = matrix_.data() + k * n;
        if (!(std::abs(from[k]) > 1e-14 * largest)) {
            matrix_[k * n + k] = infinity;  // this unknown stays as it is
            continue;
        }
        for (std::size_t i = k + 1; i < n; ++i) {
            Real* const to = matrix_.data() + i * n;
            if (to[k] == 0) continue;
            const Real l = to[k] /= from[k];
            for (std::size_t j = k + 1; j < n; ++j) to[j] -= l * from[j];
        }
    }
}

void DenseCones::substitute(std::vector<Real>& x) const
{
    const std::size_t n = tests_.size();
    for (std::size_t k = 0; k < n; ++k)
        std::swap(x[k], x[static_cast<std::size_t>(pivot_[k])]);
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t k = 0; k < i; ++k)
            if (std::isfinite(matrix_[k * n + k]))
                x[i] -= matrix_[i * n + k] * x[k];
    for (std::size_t i = n; i-- > 0;) {
        for (std::size_t k = i + 1; k < n; ++k) x[i] -= matrix_[i * n + k] * x[k];
        x[i] = std::isfinite(matrix_[i * n + i]) ? x[i] / matrix_[i * n + i] : 0;
    }
}
//! [elimination]

void DenseCones::solve_guess(Real enough)
{
    const ConeRows p = view();
    for (std::size_t k = 0; k < rows.size(); ++k)  // s = 0 to begin with
        if (p.disc(k) && g_.cases[k] == ConeCase::slides) {
            const auto i = static_cast<Index>(k);
            const Real along = g_.direction[k].dot(g_.lambda.segment<2>(i));
            g_.lambda.segment<2>(i) = along * g_.direction[k];
        }
    impose(p, g_);
    write_equations();
    factor();
    Real last = infinity;
    for (int round = 0; round < 10; ++round) {
        velocities();
        const Real left = take_errors(g_);
        if (left <= 1e-3 * enough || !(left < 0.5 * last)) break;
        last = left;
        x_.resize(tests_.size());
        for (std::size_t e = 0; e < tests_.size(); ++e)
            x_[e] = -g_.equations[e].error;
        substitute(x_);
        for (std::size_t e = 0; e < tests_.size(); ++e) {
            const auto k = static_cast<std::size_t>(g_.of_row[e]);
            const auto i = static_cast<Index>(k);
            if (g_.cases[k] == ConeCase::slides)
                g_.lambda.segment<2>(i) +=
                    x_[e] * Vec2(-g_.direction[k].y(), g_.direction[k].x());
            else g_.lambda[i] += x_[e];
        }
        impose(p, g_);
    }
}

bool DenseCones::guess_on(Real enough)
{
    for (int n = 0; n < guesses; ++n) {
        velocities();
        // a guess may be far worse than a start that was nearly an answer
        const Real off = choose_cases(view(), n == 0 ? -1 : enough, g_);
        if (!(off < infinity)) break;
        ++guessed;
        solve_guess(enough);
        if (accept(enough)) return true;
    }
    return false;
}

void DenseCones::sweep()
{
    const std::size_t m = rows.size();
    const ConeRows p = view();
    VecX& lambda = g_.lambda;
    const auto w = [&](std::size_t k) {
        Real sum = q[static_cast<Index>(k)];
        const Real* const a = A.data() + k * m;
        for (std::size_t j = 0; j < m; ++j)
            sum += a[j] * lambda[static_cast<Index>(j)];
        return sum;
    };
    for (std::size_t k = 0; k < m; ++k) {
        const auto i = static_cast<Index>(k);
        const int normal = p.bound_by(k);
        const Real bound =
            normal < 0 ? 0
                       : feedback[k].friction * std::max(Real{0}, lambda[normal]);
        if (const DiscOfRows* const disc = p.disc(k)) {
            // (24.4), with the step that is safe
            if (disc->largest > 0)
                lambda.segment<2>(i) = onto_disc(
                    lambda.segment<2>(i) - Vec2(w(k), w(k + 1)) / disc->largest,
                    bound);
            ++k;
            continue;
        }
        const Real lo = normal < 0 ? rows[k].lo : -bound,
                   hi = normal < 0 ? rows[k].hi : bound;
        lambda[i] = std::clamp(lambda[i] - rows[k].mass * w(k), lo, hi);
    }
}

//! [solve]
void DenseCones::solve(Real enough, bool same, Solution& solution)
{
    const std::size_t m = rows.size();
    const auto n = static_cast<Index>(m);
    if (!same) find_discs();
    g_.cases.assign(m, ConeCase::low);
    g_.direction.assign(m, Vec2(1, 0));
    for (VecX* const x : {&g_.give, &g_.w, &g_.base}) x->setZero(n);
    g_.lambda.resize(n);
    for (std::size_t k = 0; k < m; ++k)
        g_.lambda[static_cast<Index>(k)] = rows[k].lambda;
    g_.share = 0;
    residual_ = infinity;
    best_ = g_.lambda;
    guessed = swept = 0;
    bool found = accept(enough);
    for (int time = 0, sweeps = 10; time <= retreats && !found;
         ++time, sweeps *= 3) {
        if (time > 0) {
            g_.lambda = best_;
            for (int s = 0; s < sweeps; ++s) sweep();
            swept += sweeps;
            if ((found = accept(enough))) break;
        }
        found = guess_on(enough);
    }
    solution.lambda = best_;
    solution.residual = residual_;
    solution.iterations = guessed;
    solution.status = found ? Status::solved : Status::iteration_limit;
}
//! [solve]

}  // namespace rigid
