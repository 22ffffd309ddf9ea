// The functions of cone_cases.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/24_friction_is_a_disc/cone_cases.hpp"

namespace rigid {

void begin_guess(const ConeRows& p, const VecX& u, ConeGuess& g)
{
    const std::size_t m = p.rows.size();
    const auto n = static_cast<Index>(p.bodies.size());
    g.cases.assign(m, ConeCase::low);
    g.direction.assign(m, Vec2(1, 0));
    g.equation_of.assign(m, -1);
    for (VecX* x : {&g.give, &g.lambda, &g.w, &g.base})
        x->setZero(static_cast<Index>(m));
    g.number.resize(static_cast<std::size_t>(u.size() / 6), -1);
    for (const int k : g.bodies)  // of the island before
        if (static_cast<std::size_t>(k) < g.number.size())
            g.number[static_cast<std::size_t>(k)] = -1;
    g.bodies.assign(p.bodies.begin(), p.bodies.end());
    g.u0.resize(6 * n), g.u.resize(6 * n), g.v.resize(6 * n);
    for (Index i = 0; i < n; ++i) {
        const int k = p.bodies[static_cast<std::size_t>(i)];
        g.number[static_cast<std::size_t>(k)] = static_cast<int>(i);
        g.u0.segment<6>(6 * i) = u.segment<6>(6 * k);
    }
    g.pairs.clear();
    const auto add = [&](int body, const Vec<6>& W, Real lambda) {
        const int i = g.number[static_cast<std::size_t>(body / 6)];
        if (i >= 0) g.u0.segment<6>(6 * i) -= W * lambda;
        return i;
    };
    for (std::size_t k = 0; k < m; ++k) {
        const SolverRow<6>& row = p.rows[k];
        g.lambda[static_cast<Index>(k)] = row.lambda;
        const int a = row.a == row.b ? -1 : add(row.a, row.Wa, row.lambda),
                  b = add(row.b, row.Wb, row.lambda);
        if (a >= 0 && b >= 0) g.pairs.emplace_back(a, b);
    }
}

void cone_velocities(const ConeRows& p, const VecX& outside, ConeGuess& g)
{
    g.u = g.u0;
    const auto number = [&](int body) {
        return g.number[static_cast<std::size_t>(body / 6)];
    };
    for (std::size_t k = 0; k < p.rows.size(); ++k) {
        const SolverRow<6>& row = p.rows[k];
        const Real lambda = g.lambda[static_cast<Index>(k)];
        if (lambda == 0) continue;
        const int a = row.a == row.b ? -1 : number(row.a), b = number(row.b);
        if (a >= 0) g.u.segment<6>(6 * a) += row.Wa * lambda;
        if (b >= 0) g.u.segment<6>(6 * b) += row.Wb * lambda;
    }
    const auto of = [&](int body) -> Vec<6> {
        const int i = number(body);
        return i >= 0 ? Vec<6>(g.u.segment<6>(6 * i))
                      : Vec<6>(outside.segment<6>(body));
    };
    for (std::size_t k = 0; k < p.rows.size(); ++k) {
        const auto i = static_cast<Index>(k);
        g.w[i] = velocity<6>(p.rows[k], of(p.rows[k].a), of(p.rows[k].b));
    }
    if (!(g.share > 0)) return;
    for (std::size_t k = 0; k < p.rows.size(); ++k) {
        const auto i = static_cast<Index>(k);
        const Real shift = g.share * diagonal_of(p, k);
        g.w[i] += shift * (g.lambda[i] - g.base[i]);
        if (!p.disc(k)) continue;
        ++k;
        g.w[i + 1] += shift * (g.lambda[i + 1] - g.base[i + 1]);
    }
}

//! [cone_cases]
Real choose_cases(const ConeRows& p, Real enough, ConeGuess& g)
{
    Real largest = 0;
    bool is_number = true;
    const auto points = [&](std::size_t k) {
        return g.lambda[static_cast<Index>(k)] -
               p.rows[k].mass * g.w[static_cast<Index>(k)];
    };
    for (std::size_t k = 0; k < p.rows.size(); ++k) {
        const auto i = static_cast<Index>(k);
        const int normal = p.bound_by(k);
        const DiscOfRows* disc = p.disc(k);
        Real lo = p.rows[k].lo, hi = p.rows[k].hi, bound = 0;
        if (normal >= 0) {
            const auto n = static_cast<std::size_t>(normal);
            hi = p.feedback[k].friction * std::max(Real{0}, points(n));
            bound = p.feedback[k].friction * std::max(Real{0}, g.lambda[normal]);
            lo = -hi;
        }
        ConeCase& here = g.cases[k];
        Real off = 0;
        if (disc) {
            ++k;
            if (!(disc->largest > 0)) continue;
            const Vec2 lambda = g.lambda.segment<2>(i),
                       z = lambda - g.w.segment<2>(i) / disc->largest;
            off = disc->largest * (lambda - onto_disc(z, bound)).norm();
            if (off > enough) {
                const Real length = z.norm();
                here = !(hi > 0)     ? ConeCase::low
                       : length > hi ? ConeCase::slides
                                     : ConeCase::free;
                g.direction[k - 1] = z / std::max(length, 1e-300);
                g.give[i] = disc->largest * (length - hi) / hi;  // (24.16)
            }
        } else if (p.rows[k].mass > 0) {
            const Real there = points(k);
            off = std::abs(g.lambda[i] - (normal < 0
                                              ? std::clamp(there, lo, hi)
                                              : std::clamp(there, -bound, bound))) /
                  p.rows[k].mass;
            if (off > enough)
                here = there <= lo   ? ConeCase::low
                       : there >= hi ? ConeCase::high
                                     : ConeCase::free;
        }
        is_number = is_number && !std::isnan(off);
        largest = std::max(largest, off);
    }
    return is_number ? largest : infinity;
}
//! [cone_cases]

}  // namespace rigid
