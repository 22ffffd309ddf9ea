/// Chapter 3: contact is either/or. Assembly, the measure of error, the exact ways, and the whole step.

#include "chapters/03_mlcp_formulation/assembly.hpp"
#include "common/random.hpp"

#include "tests/catch.hpp"

using namespace rigid;

namespace {

/// Random rows between random bodies, some of which cannot move, and the world.
template <int Dof>
std::vector<Row<Dof>> random_rows(Random& random, Index m, Index K, VecX& inverse_mass)
{
    inverse_mass.resize(Dof * K);
    for (Index k = 0; k < K; ++k)
        inverse_mass.segment<Dof>(Dof * k).setConstant(random.uniform() < 0.25 ? 0 : random.uniform(0.1, 10));
    std::vector<Row<Dof>> rows;
    for (Index i = 0; i < m; ++i) {
        Constraint<Dof> c;
        c.a = random.index(K + 1) - 1;
        do c.b = random.index(K);
        while (c.b == c.a);
        for (Index d = 0; d < Dof; ++d)
            c.Ja[d] = c.a == world ? 0 : random.normal(), c.Jb[d] = random.normal();
        rows.push_back(
            make_row(c, inverse_mass, random.normal(), random.uniform() < 0.5 ? 0 : -infinity, infinity));
    }
    return rows;
}

/// The matrix J of the text, written out.
template <int Dof>
MatX dense_J(const std::vector<Row<Dof>>& rows, Index K)
{
    MatX J = MatX::Zero(static_cast<Index>(rows.size()), Dof * K);
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const auto line = static_cast<Index>(i);
        if (rows[i].a != world) J.template block<1, Dof>(line, Dof * rows[i].a) += rows[i].Ja;
        J.template block<1, Dof>(line, Dof * rows[i].b) += rows[i].Jb;
    }
    return J;
}

}  // namespace

// ---- assembly ------------------------------------------------------------------------------------------

TEST_CASE("the assembled A and q are the dense triple product and Ju + b")
{
    Random random(1);
    for (int sample = 0; sample < 100; ++sample) {
        const Index K = 2 + random.index(8), m = random.index(20);
        VecX inverse_mass, b(m), u(3 * K);
        const auto rows = random_rows<3>(random, m, K, inverse_mass);
        for (Index i = 0; i < u.size(); ++i) u[i] = random.normal();
        for (Index i = 0; i < m; ++i) b[i] = rows[static_cast<std::size_t>(i)].bias;
        const MatX J = dense_J(rows, K);
        const Mlcp mlcp = assemble(rows, u);
        require_valid(mlcp);
        const MatX A = mlcp.A;
        const MatX wanted = J * inverse_mass.asDiagonal() * J.transpose();
        REQUIRE((A - wanted).norm() <=
                1e-12 * (1 + wanted.norm()));  // sums of a few products, rounded differently
        REQUIRE((mlcp.q - (J * u + b)).norm() <= 1e-12 * (1 + b.norm() + u.norm()));
        REQUIRE(A == A.transpose());
        for (Index i = 0; i < m; ++i) {
            Index last = -1;
            for (SparseMatrix::InnerIterator entry(mlcp.A, i); entry; ++entry) {
                REQUIRE(entry.col() > last);
                last = entry.col();
            }
        }
    }
}
