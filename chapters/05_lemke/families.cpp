// The functions of families.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/05_lemke/families.hpp"

namespace rigid {

Mlcp plain_lcp(const MatX& A, const VecX& q)
{
    Mlcp lcp;
    lcp.A = A.sparseView();
    lcp.q = q;
    lcp.lo = VecX::Zero(q.size());
    lcp.hi = VecX::Constant(q.size(), infinity);
    return lcp;
}

Mlcp murty(Index n)
{
    VecX q(n);
    for (Index i = 0; i < n; ++i)
        q[i] = -(std::ldexp(1, static_cast<int>(n) + 1) -
                 std::ldexp(1, static_cast<int>(i) + 1));
    return plain_lcp(murty_matrix(n), q);
}

Mlcp fathi(Index n)
{
    MatX A(n, n);
    for (Index i = 0; i < n; ++i)
        for (Index j = 0; j < n; ++j)
            A(i, j) =
                static_cast<Real>(i == j ? 4 * i + 1 : 4 * std::min(i, j) + 2);
    return plain_lcp(A, -VecX::Ones(n));
}

Mlcp random_spd(Index n, Random& random)
{
    MatX G(n, n);
    VecX q(n);
    for (Real& entry : G.reshaped()) entry = random.normal();
    for (Real& entry : q) entry = random.normal();
    MatX A = G * G.transpose() / static_cast<Real>(n);
    A.diagonal().array() += 0.01;
    A = ((A + A.transpose()) / 2).eval();
    return plain_lcp(A, q);
}

}  // namespace rigid
