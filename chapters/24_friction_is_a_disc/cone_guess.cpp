// The functions of cone_guess.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/24_friction_is_a_disc/cone_guess.hpp"

namespace rigid {

void impose(const ConeRows& p, ConeGuess& g)
{
    for (std::size_t k = 0; k < p.rows.size(); ++k) {
        const auto i = static_cast<Index>(k);
        if (p.bound_by(k) >= 0 || g.cases[k] == ConeCase::free) continue;
        const Real bound =
            g.cases[k] == ConeCase::high ? p.rows[k].hi : p.rows[k].lo;
        g.lambda[i] = std::isfinite(bound) ? bound : 0;
    }
    for (std::size_t k = 0; k < p.rows.size(); ++k) {
        const auto i = static_cast<Index>(k);
        const int normal = p.bound_by(k);
        const DiscOfRows* disc = p.disc(k);
        if (normal < 0) continue;
        const bool open =
            g.cases[static_cast<std::size_t>(normal)] != ConeCase::free;
        const Real bound = p.feedback[k].friction * g.lambda[normal];
        if (disc) {
            if (open || g.cases[k] == ConeCase::low)
                g.lambda.segment<2>(i).setZero();
            else if (g.cases[k] == ConeCase::slides) {
                const Vec2 d = g.direction[k], across(-d.y(), d.x());
                const Real s = across.dot(g.lambda.segment<2>(i));
                g.lambda.segment<2>(i) = bound * d + s * across;
            }
            ++k;
        } else if (open) g.lambda[i] = 0;
        else if (g.cases[k] != ConeCase::free)
            g.lambda[i] = g.cases[k] == ConeCase::low ? -bound : bound;
    }
}

//! [cone_equations]
void write_equations(const ConeRows& p, ConeGuess& g)
{
    g.equations.clear();
    g.of_row.clear();
    g.equation_of.assign(p.rows.size(), -1);
    const Real share = std::max(g.share, cone_share);
    const auto number = [&](int body) {
        return g.number[static_cast<std::size_t>(body / 6)];
    };
    const auto add = [&](std::size_t k, Real give) -> ConeEquation& {
        const SolverRow<6>& row = p.rows[k];
        g.equation_of[k] = static_cast<int>(g.equations.size());
        g.of_row.push_back(static_cast<int>(k));
        g.equations.push_back({row.Ja, row.Jb, row.Wa, row.Wb, give, 0,
                               row.a == row.b ? -1 : number(row.a), number(row.b)});
        return g.equations.back();
    };
    for (std::size_t k = 0; k < p.rows.size(); ++k)
        if (p.bound_by(k) < 0 && g.cases[k] == ConeCase::free && p.rows[k].mass > 0)
            add(k, share / p.rows[k].mass);
    for (std::size_t k = 0; k < p.rows.size(); ++k) {
        const int normal = p.bound_by(k);
        if (normal < 0) continue;
        const DiscOfRows* disc = p.disc(k);
        const std::size_t here = k;
        if (disc) ++k;
        const int at = g.equation_of[static_cast<std::size_t>(normal)];
        const ConeCase now = g.cases[here];
        if (at < 0) continue;
        const Real mu = p.feedback[here].friction;
        const SolverRow<6>& row = p.rows[here];
        if (!disc) {
            if (now == ConeCase::free) {
                if (row.mass > 0) add(here, share / row.mass);
                continue;
            }
            const Real s = now == ConeCase::low ? -mu : mu;
            ConeEquation& n = g.equations[static_cast<std::size_t>(at)];
            n.Wa += s * row.Wa, n.Wb += s * row.Wb;
        } else if (now == ConeCase::free) {
            add(here, share * disc->largest);
            add(here + 1, share * disc->largest);
        } else if (now == ConeCase::slides) {
            const SolverRow<6>& next = p.rows[here + 1];
            const Vec2 d = g.direction[here];
            ConeEquation& n = g.equations[static_cast<std::size_t>(at)];
            n.Wa += mu * (d.x() * row.Wa + d.y() * next.Wa);
            n.Wb += mu * (d.x() * row.Wb + d.y() * next.Wb);
            ConeEquation& s =
                add(here, share * disc->largest + g.give[static_cast<Index>(here)]);
            s.Ja = d.x() * next.Ja - d.y() * row.Ja,
            s.Jb = d.x() * next.Jb - d.y() * row.Jb;
            s.Wa = d.x() * next.Wa - d.y() * row.Wa,
            s.Wb = d.x() * next.Wb - d.y() * row.Wb;
        }
    }
}
//! [cone_equations]

Real take_errors(ConeGuess& g)
{
    Real largest = 0;
    for (std::size_t e = 0; e < g.equations.size(); ++e) {
        const auto k = static_cast<std::size_t>(g.of_row[e]);
        const auto i = static_cast<Index>(k);
        ConeEquation& equation = g.equations[e];
        equation.error = g.w[i];
        if (g.cases[k] == ConeCase::slides) {
            const Vec2 across(-g.direction[k].y(), g.direction[k].x());
            equation.error = across.dot(g.w.segment<2>(i)) +
                             g.give[i] * across.dot(g.lambda.segment<2>(i));
        }
        if (!std::isfinite(equation.error)) return infinity;
        largest = std::max(largest, std::abs(equation.error));
    }
    return largest;
}

//! [cone_guess]
Real solve_guess(const ConeRows& p, const VecX& outside, Real enough,
                 BodyFactor& factor, ConeGuess& g)
{
    for (std::size_t k = 0; k < p.rows.size(); ++k)  // s = 0 to begin with
        if (p.disc(k) && g.cases[k] == ConeCase::slides) {
            const auto i = static_cast<Index>(k);
            const Real along = g.direction[k].dot(g.lambda.segment<2>(i));
            g.lambda.segment<2>(i) = along * g.direction[k];
        }
    impose(p, g);
    write_equations(p, g);
    factor.factor(g.equations);
    Real last = infinity, left = 0;
    for (int round = 0; round < 10; ++round) {
        cone_velocities(p, outside, g);
        left = take_errors(g);
        if (left <= 1e-3 * enough || !(left < 0.5 * last)) break;
        last = left;
        g.v.setZero();
        for (const ConeEquation& r : g.equations) {
            const Real push = r.error / r.give;
            if (r.a >= 0) g.v.segment<6>(6 * r.a) -= r.Wa * push;
            if (r.b >= 0) g.v.segment<6>(6 * r.b) -= r.Wb * push;
        }
        factor.solve(g.v);
        for (std::size_t e = 0; e < g.equations.size(); ++e) {
            const ConeEquation& r = g.equations[e];
            Real off = r.error;
            if (r.a >= 0) off += r.Ja.dot(g.v.segment<6>(6 * r.a));
            if (r.b >= 0) off += r.Jb.dot(g.v.segment<6>(6 * r.b));
            const auto k = static_cast<std::size_t>(g.of_row[e]);
            const auto i = static_cast<Index>(k);
            const Real change = -off / r.give;
            if (g.cases[k] == ConeCase::slides)
                g.lambda.segment<2>(i) +=
                    change * Vec2(-g.direction[k].y(), g.direction[k].x());
            else g.lambda[i] += change;
        }
        impose(p, g);
    }
    return left;
}
//! [cone_guess]

}  // namespace rigid
