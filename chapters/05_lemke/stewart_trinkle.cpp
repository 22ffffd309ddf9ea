// The functions of stewart_trinkle.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/05_lemke/stewart_trinkle.hpp"

namespace rigid {

Row<3> contact_row(Index a, Index b, const Vec2& n, const Vec2& ra, const Vec2& rb,
                   const VecX& inverse_mass)
{
    Constraint<3> constraint;
    constraint.a = a;
    constraint.b = b;
    if (a != world) constraint.Ja << -n.x(), -n.y(), -cross2(ra, n);
    constraint.Jb << n.x(), n.y(), cross2(rb, n);
    return unilateral(constraint, inverse_mass);
}

ContactRows contact_rows(const BoxStack& stack)
{
    const auto refuse = [](const std::string& thing, Real value,
                           const std::string& right) {
        throw std::invalid_argument(thing + " is " + shortest(value) + "; " +
                                    right);
    };
    if (stack.boxes < 1)
        refuse("the number of boxes", static_cast<Real>(stack.boxes),
               "it must be at least 1");
    if (!(stack.mass > 0) || !(stack.top_mass > 0))
        refuse("the mass of a box", std::min(stack.mass, stack.top_mass),
               "it must be positive");
    if (!(stack.side > 0))
        refuse("the side of a box", stack.side, "it must be positive");
    if (!(stack.offset >= 0 && stack.offset < 0.5))
        refuse("the offset", stack.offset, "it must be between 0 and 0.5");
    if (!(stack.friction >= 0))
        refuse("the friction coefficient", stack.friction,
               "it must not be negative");

    Random random(stack.seed);
    const Real s = stack.side;
    VecX x(stack.boxes), inverse_mass(3 * stack.boxes);
    ContactRows scene;
    scene.u_star.resize(3 * stack.boxes);
    for (Index k = 0; k < stack.boxes; ++k) {
        x[k] = (k > 0 ? x[k - 1] : 0) +
               s * random.uniform(-stack.offset, stack.offset);
        const Real mass = k + 1 == stack.boxes ? stack.top_mass : stack.mass;
        inverse_mass.segment<3>(3 * k) << 1 / mass, 1 / mass,
            6 / (mass * s * s);  // a square about its centre
        for (Index d = 0; d < 3; ++d)
            scene.u_star[3 * k + d] = stack.jostle * random.uniform(-1, 1);
        scene.u_star[3 * k + 1] -= stack.fall;
    }
    for (const Vec2& direction : {Vec2(0, 1), Vec2(1, 0)})
        for (Index b = 0; b < stack.boxes; ++b) {
            const Real left =
                b > 0 ? std::max(x[b - 1], x[b]) - s / 2 : x[b] - s / 2;
            const Real right =
                b > 0 ? std::min(x[b - 1], x[b]) + s / 2 : x[b] + s / 2;
            for (const Real p : {left, right})
                scene.rows.push_back(contact_row(b - 1, b, direction,
                                                 {b > 0 ? p - x[b - 1] : 0, s / 2},
                                                 {p - x[b], -s / 2}, inverse_mass));
        }
    return scene;
}

//! [stewart_trinkle]
Mlcp stewart_trinkle(const Mlcp& rows, Real mu)
{
    const int m = static_cast<int>(rows.size() / 2);
    std::vector<Eigen::Triplet<Real>> entries;
    for (int i = 0; i < 2 * m; ++i)
        for (SparseMatrix::InnerIterator a(rows.A, i); a; ++a) {
            const int j = static_cast<int>(a.col());
            entries.emplace_back(i, j, a.value());
            if (i >= m) entries.emplace_back(i + m, j, -a.value());
            if (j >= m) entries.emplace_back(i, j + m, -a.value());
            if (i >= m && j >= m) entries.emplace_back(i + m, j + m, a.value());
        }
    for (int i = 0; i < m; ++i) {
        entries.emplace_back(m + i, 3 * m + i, 1.0);       // γ + v_t
        entries.emplace_back(2 * m + i, 3 * m + i, 1.0);   // γ - v_t
        entries.emplace_back(3 * m + i, i, mu);            // μ λ_n
        entries.emplace_back(3 * m + i, m + i, -1.0);      // - β₊
        entries.emplace_back(3 * m + i, 2 * m + i, -1.0);  // - β₋
    }
    Mlcp lcp;
    lcp.A.resize(4 * m, 4 * m);
    lcp.A.setFromTriplets(entries.begin(), entries.end());
    lcp.q = VecX::Zero(4 * m);
    lcp.q.head(2 * m) = rows.q;
    lcp.q.segment(2 * m, m) = -rows.q.tail(m);
    lcp.lo = VecX::Zero(4 * m);
    lcp.hi = VecX::Constant(4 * m, infinity);
    return lcp;
}
//! [stewart_trinkle]

}  // namespace rigid
