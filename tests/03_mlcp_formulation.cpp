/// Chapter 3: contact is either/or. Assembly, the measure of error, the exact ways, and the whole step.

#include "chapters/03_mlcp_formulation/assembly.hpp"
#include "chapters/03_mlcp_formulation/cases_method.hpp"
#include "chapters/03_mlcp_formulation/exact.hpp"
#include "chapters/03_mlcp_formulation/program/problem_file.hpp"
#include "chapters/03_mlcp_formulation/program/scene_run.hpp"
#include "chapters/03_mlcp_formulation/program/ten_disc_scene.hpp"
#include "chapters/03_mlcp_formulation/step.hpp"
#include "common/measure.hpp"
#include "common/program/scripted_pointer.hpp"
#include "common/random.hpp"

#include "tests/catch.hpp"
#include "tests/limit.hpp"
#include "tests/no_allocation.hpp"
#include "tests/says.hpp"
#include "tests/scene_of.hpp"
#include "tests/sentence.hpp"

#include <functional>
#include <numeric>
#include <sstream>

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
        Limit draws(1000);
        do c.b = random.index(K);
        while (c.b == c.a && draws.left());
        for (Index d = 0; d < Dof; ++d)
            c.Ja[d] = c.a == world ? 0 : random.normal(), c.Jb[d] = random.normal();
        const Real lo = random.uniform() < 0.5 ? 0 : -infinity, b = random.normal();
        rows.push_back(make_row(c, inverse_mass, b, lo, infinity));
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

VecX normal_vector(Random& random, Index n)
{
    VecX v(n);
    for (Index i = 0; i < n; ++i) v[i] = random.normal();
    return v;
}

MatX normal_matrix(Random& random, Index rows, Index columns)
{
    MatX A(rows, columns);
    for (Index i = 0; i < A.size(); ++i) A.data()[i] = random.normal();
    return A;
}

Mlcp problem(const MatX& A, const VecX& q, Real lo = 0, Real hi = infinity)
{
    Mlcp mlcp;
    mlcp.A = A.sparseView();
    mlcp.q = q;
    mlcp.lo = VecX::Constant(q.size(), lo);
    mlcp.hi = VecX::Constant(q.size(), hi);
    return mlcp;
}

Mlcp problem(std::initializer_list<Real> A, std::initializer_list<Real> q)
{
    const auto n = static_cast<Index>(q.size());
    return problem(MatX(Eigen::Map<const Eigen::Matrix<Real, -1, -1, Eigen::RowMajor>>(A.begin(), n, n)),
                   VecX(Eigen::Map<const VecX>(q.begin(), n)));
}

VecX w_of(const Mlcp& mlcp, const VecX& lambda) { return mlcp.A * lambda + mlcp.q; }

Real size_of(const Mlcp& mlcp, const VecX& lambda)
{
    return 1 + mlcp.q.cwiseAbs().maxCoeff() + (MatX(mlcp.A).cwiseAbs() * lambda.cwiseAbs()).maxCoeff();
}

/// A problem whose answer is known: choose λ and w that fit together, then q = w − A λ.
Mlcp planted(Random& random, const MatX& A, VecX& lambda, VecX& w)
{
    const Index n = A.rows();
    lambda = VecX::Zero(n);
    w = VecX::Zero(n);
    for (Index i = 0; i < n; ++i) (random.uniform() < 0.5 ? lambda : w)[i] = random.uniform(0.1, 2);
    return problem(A, w - A * lambda);
}

/// One disc of 1 kg and radius 0.1 m.
DiscScene one_disc(const Vec2& x, const Vec2& u, std::vector<HalfSpace> walls)
{
    DiscScene scene;
    scene.bodies = Bodies<2>(1);
    scene.bodies.x = x;
    scene.bodies.u = u;
    scene.radius = VecX::Constant(1, 0.1);
    scene.walls = std::move(walls);
    return scene;
}

/// A disc of 1 kg on a rod of 1 m about the origin, released at 90°.
DiscScene pendulum()
{
    DiscScene scene;
    scene.bodies = Bodies<2>(2);
    scene.bodies.x << 0, 0, 1, 0;
    scene.bodies.inverse_mass.head<2>().setZero();
    scene.radius = VecX::Constant(2, 0.1);
    scene.links = {{0, 1, 1}};
    link_neighbours(scene);
    return scene;
}

const auto exact_solve = [](const Mlcp& mlcp) {
    EnumerationSettings settings;
    settings.stop_at_first = true;
    return schur(mlcp, settings);
};

std::vector<Row<2>> rows_of(const DiscScene& scene, Real h, Real margin = 0.01)
{
    std::vector<Contact> contacts;
    find_contacts(scene, margin, contacts);
    std::vector<Row<2>> rows;
    disc_rows(scene, h, contacts, rows);
    return rows;
}

/// The rows of a chain of so many links, stretched out, in no gravity.
Mlcp chain_problem(Index links, AssemblyScratch& scratch)
{
    DiscScene scene = hanging_chain(links);
    scene.bodies.inverse_mass.setOnes();  // let go of its first disc
    Mlcp mlcp;
    assemble(rows_of(scene, 0.01), scene.bodies.u, scratch, mlcp);
    return mlcp;
}

}  // namespace

// ---- assembly ------------------------------------------------------------------------------------------

TEST_CASE("the assembled A and q are the dense triple product and Ju + b", "[house]")
{
    Random random(1);
    for (int sample = 0; sample < 100; ++sample) {
        const Index K = 2 + random.index(8), m = random.index(20);
        VecX inverse_mass, b(m);
        const auto rows = random_rows<3>(random, m, K, inverse_mass);
        const VecX u = normal_vector(random, 3 * K);
        for (Index i = 0; i < m; ++i) b[i] = rows[static_cast<std::size_t>(i)].bias;
        const MatX J = dense_J(rows, K);
        const Mlcp mlcp = assemble(rows, u);
        require_valid(mlcp);
        const MatX A = mlcp.A;
        const MatX wanted = J * inverse_mass.asDiagonal() * J.transpose();
        REQUIRE((A - wanted).norm() <= 1e-12 * (1 + wanted.norm()));  // sums of a few products, rounded apart
        REQUIRE((mlcp.q - (J * u + b)).norm() <= 1e-12 * (1 + b.norm() + J.norm() * u.norm()));
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

TEST_CASE("two rows meet only where both move the same body", "[house]")
{
    // Four discs on one floor, the last one held fast, and a link from the first to the fixed one.
    DiscScene scene;
    scene.bodies = Bodies<2>(4);
    scene.bodies.x << 0, 0.1, 1, 0.1, 2, 0.1, 3, 0.1;
    scene.bodies.inverse_mass.tail<2>().setZero();
    scene.radius = VecX::Constant(4, 0.1);
    scene.walls = {{{0, 1}, 0}};
    scene.links = {{0, 3, 3}};
    link_neighbours(scene);
    const Mlcp mlcp = assemble(rows_of(scene, 0.01), scene.bodies.u);
    REQUIRE(mlcp.size() == 5);
    // Link and three floors meet themselves; the link and the floor of disc 0 each other; the fixed disc
    // nobody.
    CHECK(mlcp.A.nonZeros() == 4 + 2);
    CHECK(mlcp.A.coeff(0, 0) == 1);
    CHECK(mlcp.A.row(4).nonZeros() == 0);
}

TEST_CASE("the work of assembly is the number of pairs that share a body as in (3.20)", "[house]")
{
    for (const Index links : {1, 10, 100, 1000}) {
        AssemblyScratch scratch;
        const Mlcp mlcp = chain_problem(links, scratch);
        CHECK(scratch.pairs == 2 * links - 1);  // each with itself, and with the next
        CHECK(mlcp.A.nonZeros() == 3 * links - 2);
    }
    // 8 multiplications for a pair at most, against the (J M⁻¹) Jᵀ of full matrices: m² times 2K.
    AssemblyScratch scratch;
    chain_problem(1000, scratch);
    CHECK(1000.0 * 1000 * 2 * 1001 / static_cast<Real>(8 * scratch.pairs) > 50);
}

TEST_CASE("assembling again as many rows uses the memory that is there", "[house]")
{
    DiscScene scene = column(50);
    const auto rows = rows_of(scene, 0.01);
    AssemblyScratch scratch;
    Mlcp mlcp;
    assemble(rows, scene.bodies.u, scratch, mlcp);
    const auto places = [&] {
        return std::vector<const void*>{
            mlcp.A.valuePtr(), mlcp.A.innerIndexPtr(), mlcp.A.outerIndexPtr(), mlcp.q.data(),
            mlcp.lo.data(),    scratch.first.data(),   scratch.on_body.data(), scratch.next.data()};
    };
    const auto before = places();
    assemble(rows, scene.bodies.u, scratch, mlcp);
    CHECK(places() == before);
}

TEST_CASE("another order of the rows gives the same problem in that order", "[house]")
{
    Random random(2);
    for (int sample = 0; sample < 50; ++sample) {
        const Index m = 2 + random.index(8);
        VecX inverse_mass;
        auto rows = random_rows<2>(random, m, 5, inverse_mass);
        const VecX u = normal_vector(random, 10);
        const MatX A = assemble(rows, u).A;
        const VecX q = assemble(rows, u).q;
        std::vector<Index> order(static_cast<std::size_t>(m));
        std::iota(order.begin(), order.end(), Index{0});
        for (std::size_t i = order.size(); i > 1; --i)
            std::swap(order[i - 1], order[static_cast<std::size_t>(random.index(static_cast<Index>(i)))]);
        auto shuffled = rows;
        for (std::size_t i = 0; i < order.size(); ++i) shuffled[i] = rows[static_cast<std::size_t>(order[i])];
        const Mlcp other = assemble(shuffled, u);
        for (Index i = 0; i < m; ++i) {
            REQUIRE(other.q[i] == q[order[static_cast<std::size_t>(i)]]);
            for (Index j = 0; j < m; ++j)  // J_i (M⁻¹ J_jᵀ) and J_j (M⁻¹ J_iᵀ) round apart
                REQUIRE(std::abs(other.A.coeff(i, j) -
                                 A(order[static_cast<std::size_t>(i)], order[static_cast<std::size_t>(j)])) <=
                        1e-13 * A.norm());
        }
    }
}

TEST_CASE("assembly refuses rows and velocities that make no sense", "[house]")
{
    DiscScene scene = column(2);
    auto rows = rows_of(scene, 0.01);
    VecX u = scene.bodies.u;
    u[3] = std::nan("");
    CHECK(sentence_of([&] { assemble(rows, u); }).find("u*[3] is") == 0);
    rows[1].b = 7;
    CHECK(sentence_of([&] { assemble(rows, scene.bodies.u); }).find("row 1 joins bodies") == 0);
}

// ---- the measure of error ------------------------------------------------------------------------------

TEST_CASE("the natural residual of the disc on the floor is what the text works out by hand", "[idea]")
{
    // 2 kg, u* = -3 m/s: A = 1/2, q = -3, answer 6 N s.
    const Mlcp mlcp = problem({0.5}, {-3});
    const auto r = [&](Real lambda) { return natural_residual(mlcp, VecX::Constant(1, lambda)); };
    CHECK(r(6) == 0);
    CHECK(r(5) == 0.5);  // still enters at 0.5 m/s
    CHECK(r(7) == 0.5);  // leaves at 0.5 m/s while it is pushed
    CHECK(r(0) == 3);
    CHECK(r(-1) == 3.5);
    const Mlcp leaving = problem({0.5}, {3});
    CHECK(natural_residual(leaving, VecX::Zero(1)) == 0);  // on its bound with the right sign
    CHECK(natural_residual(leaving, VecX::Ones(1)) == 0.5);
}

TEST_CASE("a large impulse does not hide what is left of the velocity", "[idea]")
{
    // 1e20 - (1e20 - 1) is 0 in sixteen digits; the row is off by 1 m/s whatever its impulse is.
    for (const Real lambda : {1.0, 1e20, -1e20, 1e300})
        CHECK(natural_residual_row(1, lambda, 1, -infinity, infinity) == 1);
    CHECK(natural_residual_row(2, 1e20, -3, 0, infinity) == 3);
    CHECK(natural_residual_row(2, 1e20, -3, 0, 1e20) == 0);  // at its upper bound, pressed against it
    CHECK(std::isnan(natural_residual_row(1, infinity, 0, 0, infinity)));
    CHECK(std::isnan(natural_residual_row(1, std::nan(""), 0, 0, infinity)));
}

TEST_CASE("the natural residual is zero for answers and for nothing else", "[idea]")
{
    Random random(3);
    for (int sample = 0; sample < 200; ++sample) {
        const Index n = 1 + random.index(6);
        const MatX B = normal_matrix(random, n, n);
        VecX lambda, w;
        const Mlcp mlcp = planted(random, B * B.transpose() + MatX::Identity(n, n), lambda, w);
        // q was rounded when it was planted.
        CHECK(natural_residual(mlcp, lambda) <= 1e-14 * size_of(mlcp, lambda));
        VecX other = lambda;
        other[random.index(n)] += 0.01;
        // |Δλ_i| A_ii is 0.01 at least, and no answer is nearer: A ⪰ 1.
        CHECK(natural_residual(mlcp, other) > 1e-4);
    }
}

TEST_CASE("a NaN is never a small residual", "[idea]")
{
    const Mlcp mlcp = problem({1, 0, 0, 1}, {1, 1});
    VecX lambda = VecX::Zero(2);
    lambda[0] = std::nan("");
    CHECK(!(natural_residual(mlcp, lambda) <= 1));
}

TEST_CASE("a row without a positive diagonal is measured by its own w", "[house]")
{
    // λ = 1 between 0 and 3. With scale 1 the nearest bound is one away on the one side and two on the other.
    for (const Real a : {0.0, -4.0}) {
        CHECK(natural_residual_row(a, 1, 0.5, 0, 3) == 0.5);
        CHECK(natural_residual_row(a, 1, -1.5, 0, 3) == 1.5);
        CHECK(natural_residual_row(a, 1, 5, 0, 3) == 1);
        CHECK(natural_residual_row(a, 1, -5, 0, 3) == 2);
        CHECK(natural_residual_row(a, 1, 0.5, -infinity, infinity) == 0.5);
    }
}

TEST_CASE("a change that has become small says nothing and the residual does", "[idea]")
{
    // Relax by a factor of 1e-6 and stop when nothing moves by more than 1e-6: at once, and still 3 m/s off.
    const Mlcp mlcp = problem({0.5}, {-3});
    Real lambda = 0;
    const Real step = 1e-7 * 3 / 0.5;
    lambda = std::max(Real{0}, lambda + step);
    CHECK(std::abs(lambda) < 1e-6);
    CHECK(natural_residual(mlcp, VecX::Constant(1, lambda)) > 2.99);
}

TEST_CASE("units of mass change the impulses and not the residual", "[idea]")
{
    Random random(4);
    for (const Real unit : {1000.0, 1e-3, 16.0}) {
        const MatX B = normal_matrix(random, 4, 4);
        const Mlcp in_kg = problem(B * B.transpose(), normal_vector(random, 4));
        Mlcp in_other = in_kg;
        in_other.A = in_kg.A / unit;  // 1/kg
        const VecX lambda = normal_vector(random, 4).cwiseAbs();
        CHECK(natural_residual(in_other, unit * lambda) ==
              Approx(natural_residual(in_kg, lambda)).epsilon(1e-12));
        const VecX answer = enumerate(in_kg).lambda;
        CHECK((enumerate(in_other).lambda - unit * answer).norm() <= 1e-10 * unit * answer.norm());
    }
}

// ---- what counts as an answer ---------------------------------------------------------------------------

TEST_CASE("the share of a row that (3.16c) allows is a share of its own numbers and of the problem's",
          "[house]")
{
    const Mlcp one = problem({1}, {-1});  // λ = 1
    const auto solved = [&one](Real lambda, const Acceptance& acceptance = {}) {
        return verify(one, VecX::Constant(1, lambda), acceptance).solved;
    };
    // S = 2 and U = 1: τ U = 1e-10; a hundredth to either side of it is far more than rounding.
    CHECK(solved(1 - 0.99e-10));
    CHECK_FALSE(solved(1 - 1.01e-10));
    CHECK_FALSE(solved(0));
    CHECK(solved(1 - 1e-3, {1e-10, 1.01e-3}));  // f, in m/s
    CHECK_FALSE(solved(1 - 1e-3, {1e-10, 0.99e-3}));
    CHECK_FALSE(solved(std::nan("")));
    CHECK_FALSE(solved(infinity));
    CHECK_FALSE(solved(-1e-300));  // out of its bounds, if only a little
}

TEST_CASE("a q near zero is solved to the same share as any other", "[house]")
{
    // An answer in units of 1e-15 m/s is no better than one in m/s. Where so little is
    // nothing, f says so.
    for (const Real unit : {1.0, 1e-15, 1e-150, 1e150}) {
        const Mlcp small = problem({1}, {-unit});
        CHECK(verify(small, VecX::Constant(1, unit)).solved);
        CHECK_FALSE(verify(small, VecX::Zero(1)).solved);
        CHECK_FALSE(verify(small, VecX::Constant(1, unit * (1 - 1e-8))).solved);
    }
    CHECK(verify(problem({1}, {-1e-15}), VecX::Zero(1), {1e-10, 1e-13}).solved);
    CHECK(verify(problem({1}, {0}), VecX::Zero(1)).solved);
}

TEST_CASE("where nothing drives a problem only the rounding of its products is forgiven", "[house]")
{
    // q = 0: λ = 0 is the one answer of the first; (1, -1) leaves 1e-11 m/s, the whole of what tells its rows apart.
    Mlcp almost = problem({1, 1, 1, 1 + 1e-11}, {0, 0}), same = problem({1, 1.0 / 3, 1, 1.0 / 3}, {0, 0});
    almost.lo.setConstant(-infinity);
    same.lo.setConstant(-infinity);
    CHECK(verify(almost, VecX::Zero(2)).solved);
    CHECK_FALSE(verify(almost, Eigen::Vector2d(1, -1)).solved);
    // The second has the answers (t, -3 t), which doubles only have to rounding.
    for (const Real t : {0.1, 1 / 7.0, 1e9}) CHECK(verify(same, Eigen::Vector2d(t, -3 * t)).solved);
}

TEST_CASE("no free impulse and no bound and no unused entry loosens the rule", "[house]")
{
    Mlcp quarrel = problem({4, -4, -4, 4}, {-2, 1});
    quarrel.lo.setConstant(-infinity);
    const VecX huge = VecX::Constant(2, 1.5e31);
    CHECK(natural_residual(quarrel, huge) <=
          2);  // by rounding it comes out as anything up to 1e16, here as 2 or 0
    CHECK_FALSE(verify(quarrel, huge).solved);
    CHECK_FALSE(verify(quarrel, huge, {0, 1e-9}).solved);
    CHECK(direct(quarrel).status == Status::singular);
    CHECK(enumerate(quarrel).status == Status::infeasible);
    CHECK(schur(quarrel).status == Status::singular);

    Mlcp bounded = problem({1}, {3});
    for (const Real bound : {1e10, 1e16, 1e20}) {
        bounded.lo[0] = -bound, bounded.hi[0] = bound;
        CHECK_FALSE(verify(bounded, VecX::Zero(1)).solved);
        CHECK(verify(bounded, VecX::Constant(1, -3)).solved);
        CHECK(enumerate(bounded).lambda[0] == -3);
    }

    // Row 2 separates at 1e20 m/s and pushes nothing; in row 1 a millionth of a metre per second is still missing.
    const Mlcp unused = problem({1, 1e20, 1e20, 1e40}, {-1, 1e20});
    VecX lambda(2);
    lambda << 1 - 1e-6, 0;
    CHECK_FALSE(verify(unused, lambda).solved);
    lambda[0] = 1;
    CHECK(verify(unused, lambda).solved);
}

TEST_CASE("a row that no impulse moves is excused by no number of another row", "[house]")
{
    // w_0 = -1 whatever λ is; row 1 is forced to 1e34 m/s, whose rounding is 1e18.
    for (const bool written : {false, true}) {  // zeros that are written down are none, too
        Mlcp still = problem({0, 0, -1, 1}, {-1, -1});
        if (written) {
            still.A.coeffRef(0, 0) = 0;
            still.A.coeffRef(0, 1) = 0;
        }
        still.lo[0] = 1e34;
        const Eigen::Vector2d lambda(1e34, 1e34);
        CHECK_FALSE(verify(still, lambda).solved);
        CHECK(verify(still, lambda, {1e-10, 1.01}).solved);  // unless 1 m/s is nothing
        CHECK_FALSE(verify(still, lambda, {1e-10, 0.99}).solved);
        CHECK(enumerate(still).status != Status::solved);
        CHECK(schur(still).status != Status::solved);
        still.q[0] = 1;
        CHECK(verify(still, lambda).solved);
        // Nor does it excuse another row, however large its own number is.
        Mlcp loud = problem({0, 0, 0, 1}, {1e30, -1});
        if (written) loud.A.coeffRef(0, 1) = 0;
        CHECK(verify(loud, Eigen::Vector2d(0, 1)).solved);
        CHECK_FALSE(verify(loud, Eigen::Vector2d(0, 0)).solved);
    }
}

TEST_CASE("a row of huge numbers with a small diagonal does not excuse another row", "[house]")
{
    // w_0 = 1e-2 λ_0 - 1e20 λ_1 + 1e20 λ_2, with λ_1 ≥ 1, is zero at (0, 1, 1). Row 2 has -10 m/s there; the rounding of
    // 1e20 m/s would be 2e4.
    Mlcp huge = problem({1e-2, -1e20, 1e20, 0, 1, 0, 0, 0, 1}, {0, 1, -11});
    huge.lo[1] = 1;
    CHECK_FALSE(verify(huge, Eigen::Vector3d(0, 1, 1)).solved);
    CHECK(verify(huge, Eigen::Vector3d(0, 1, 11)).solved);
    // Where A is positive semi-definite the largest number excuses what is rounding beside it.
    Mlcp even = problem({1, 0, 0, 1}, {-1e18, -50});  // ε U = 222 m/s
    CHECK(verify(even, Eigen::Vector2d(1e18, 0)).solved);
    even.q[1] = -500;
    CHECK_FALSE(verify(even, Eigen::Vector2d(1e18, 0)).solved);
}

TEST_CASE("a row that nothing moves has the unit of the rows that it moves", "[house]")
{
    // Scaled, the numbers of a problem don't tell its units: λ_1 moves row 0, and no λ moves row 1.
    for (const Real size : {1.0, std::ldexp(1.0, 300), std::ldexp(1.0, -300)}) {
        CHECK(DenseMlcp(problem({size, size, 0, 0}, {1, 1})).A(0, 1) == 1);
        CHECK(DenseMlcp(problem({0, size, 0, 0}, {1, 1})).A(0, 1) == 1);  // row 0: √size
        CHECK(DenseMlcp(problem({0, 0, 0, 0}, {1, 1})).q[1] == 1);
    }
}

TEST_CASE("an impulse that is off its bound by the last digit is not at its bound", "[house]")
{
    Mlcp wall = problem({1}, {1});
    CHECK(verify(wall, VecX::Zero(1)).solved);
    // The natural residual is 1e-17, A_ii times the way to the bound; and yet w = 1 and something pushes.
    CHECK(natural_residual(wall, VecX::Constant(1, 1e-17)) == 1e-17);
    CHECK_FALSE(verify(wall, VecX::Constant(1, 1e-17)).solved);
}

TEST_CASE("a ray of answers behind a singular set that does not fit is seen", "[house]")
{
    Mlcp ray = problem({2, -1, 0, -1, 5, 1, 1, -1, 0}, {-7, 3, -2});
    ray.lo.setConstant(-infinity);
    ray.hi << 2, 0, 0;
    for (const Real third : {-1.0, -2.0, -1000.0}) {
        VecX lambda(3);
        lambda << 2, 0, third;
        REQUIRE(natural_residual(ray, lambda) == 0);
    }
    CHECK(enumerate(ray).status == Status::solved);
    CHECK(enumerate(ray).uniqueness == Uniqueness::any);
    CHECK(schur(ray).uniqueness == Uniqueness::any);
}

TEST_CASE("what rounding leaves open is called neither infeasible nor unique", "[house]")
{
    // Two rows alike to 14 digits: the difference may be all there is, or dirt.
    Mlcp alike = problem({1, 1, 1, 1 + 4e-14}, {-1, -1.5});
    alike.lo.setConstant(-infinity);
    const Solution solution = enumerate(alike);
    CHECK(solution.status == Status::singular);
    CHECK(solution.uniqueness == Uniqueness::not_examined);
}

TEST_CASE("bounds that leave no number are refused", "[house]")
{
    Mlcp nothing = problem({1}, {-1});
    nothing.lo[0] = nothing.hi[0] = infinity;
    CHECK(sentence_of([&] { enumerate(nothing); }) ==
          "row 0 has lo = inf and hi = inf; no impulse is that large");
}

// ---- by hand -------------------------------------------------------------------------------------------

TEST_CASE("the two contacts of the text leave one of four sets", "[idea]")
{
    // A disc of 1 kg in a corner: floor n = (0, 1), ramp n = (0.6, 0.8), u* = (-1, -2).
    const Mlcp mlcp = problem({1, 0.8, 0.8, 1}, {-2, -2.2});
    const Solution solution = enumerate(mlcp);
    CHECK(solution.status == Status::solved);
    CHECK(solution.uniqueness == Uniqueness::unique);
    CHECK(solution.iterations == 4);
    CHECK(solution.lambda[0] == Approx(2.0 / 3).epsilon(1e-13));
    CHECK(solution.lambda[1] == Approx(5.0 / 3).epsilon(1e-13));
    // A disc that slides away from the ramp: only the floor is at work.
    const Solution sliding = enumerate(problem({1, 0.8, 0.8, 1}, {-2, -1}));
    CHECK(sliding.lambda[0] == 2);
    CHECK(sliding.lambda[1] == 0);
    CHECK(w_of(problem({1, 0.8, 0.8, 1}, {-2, -1}), sliding.lambda)[1] == Approx(0.6));
}

TEST_CASE("the two discs of the text meet at the velocity of least change", "[idea]")
{
    // 1 kg at 2 m/s runs after 3 kg at 0 m/s, already touching: u = 0.5 m/s for both, λ = 1.5 N s.
    const Mlcp mlcp = problem({4.0 / 3}, {-2});
    const Solution solution = enumerate(mlcp);
    CHECK(solution.lambda[0] == Approx(1.5).epsilon(1e-14));
    // A ten-digit walk along both velocities: none of the allowed ones is a smaller change.
    const auto change = [](Real ua, Real ub) { return 0.5 * (ua - 2) * (ua - 2) + 1.5 * ub * ub; };
    for (int i = -20; i <= 20; ++i)
        for (int j = -20; j <= 20; ++j) {
            const Real ua = 0.5 + 0.1 * i, ub = 0.5 + 0.1 * j;
            if (ub >= ua) CHECK(change(ua, ub) >= change(0.5, 0.5));
        }
}

// ---- enumeration ---------------------------------------------------------------------------------------

TEST_CASE("enumeration finds what was planted in 900 problems", "[idea]")
{
    // C1: symmetric definite, symmetric semi-definite, and P-matrices that are not symmetric.
    int answers[3] = {};
    for (int seed = 0; seed < 900; ++seed) {
        Random random(static_cast<std::uint64_t>(seed));
        const Index n = 1 + random.index(7);
        const int kind = seed % 3;
        MatX A;
        if (kind == 0) {
            const MatX B = normal_matrix(random, n, n);
            A = B * B.transpose() + 0.1 * MatX::Identity(n, n);
        } else if (kind == 1) {
            const MatX B = normal_matrix(random, n, 1 + random.index(n));
            A = B * B.transpose();
        } else {
            A = normal_matrix(random, n, n);
            for (Index i = 0; i < n; ++i) A(i, i) = A.row(i).cwiseAbs().sum() + 0.1;
        }
        VecX lambda, w;
        const Mlcp mlcp = planted(random, A, lambda, w);
        const Solution solution = enumerate(mlcp);
        INFO("seed " << seed);
        REQUIRE(solution.status == Status::solved);
        const Real scale = size_of(mlcp, lambda);
        REQUIRE(solution.residual <= 1e-10 * scale);  // the tolerance of the reference values
        // For a semi-definite A the w is unique and its rounding is that of A λ.
        REQUIRE((w_of(mlcp, solution.lambda) - w).cwiseAbs().maxCoeff() <= 1e-9 * scale);
        if (kind == 1) REQUIRE(solution.uniqueness != Uniqueness::any);
        else {
            REQUIRE(solution.uniqueness == Uniqueness::unique);
            // The planted A has no eigenvalue below 0.1 (or is diagonally dominant by 0.1).
            REQUIRE((solution.lambda - lambda).cwiseAbs().maxCoeff() <= 1e-9 * scale);
        }
        if (solution.uniqueness != Uniqueness::not_examined)  // where rounding leaves it open
            ++answers[static_cast<int>(solution.uniqueness) - 1];
    }
    CHECK(answers[1] > 20);  // the semi-definite ones had redundant rows indeed
}

TEST_CASE("enumeration says infeasible in 100 problems that have no answer", "[idea]")
{
    for (int seed = 0; seed < 100; ++seed) {
        Random random(static_cast<std::uint64_t>(seed));
        // A = BBᵀ with a null vector v > 0: vᵀw = vᵀq < 0 whatever λ, so some w is negative.
        const Index n = 2 + random.index(5);
        MatX B = normal_matrix(random, n, 1 + random.index(n - 1));
        const VecX v = normal_vector(random, n).cwiseAbs() + VecX::Constant(n, 0.1);
        B -= v * (v.transpose() * B) / v.squaredNorm();
        VecX q = normal_vector(random, n);
        q -= v * (v.dot(q) + 0.1 * v.norm() * (1 + q.norm())) / v.squaredNorm();
        const Solution solution = enumerate(problem(B * B.transpose(), q));
        REQUIRE(solution.status == Status::infeasible);
        REQUIRE(solution.uniqueness == Uniqueness::none);
    }
}

TEST_CASE("a miss of 1e-8 is no answer", "[idea]")
{
    // Two walls come nearer to a disc, one a hair faster: a null vector (1, 1) with (1, 1) q = -1e-8.
    CHECK(enumerate(problem({1, -1, -1, 1}, {-1, 1 - 1e-8})).status == Status::infeasible);
    CHECK(enumerate(problem({1, -1, -1, 1}, {-1, 1 + 1e-8})).status == Status::solved);
}

TEST_CASE("rows that differ in their last digits are not called a contradiction", "[house]")
{
    // The second row is the first times 1 - 1e-8 but for its last digit, and q makes no difference between them.
    // λ = (2e9, -2e9) is an answer to the numbers as they stand: it need not be found, and must not be denied.
    Mlcp alike =
        problem({0.022592671143322165, 0.02259267090252401, 0.02259267090252401, 0.022592670661725857},
                {0.1764003773878488, 0.1764003773878488});
    alike.lo[1] = -infinity;
    alike.hi[1] = 0;
    for (const Solution& solution : {enumerate(alike), schur(alike)}) {
        CHECK(solution.status == Status::singular);
        CHECK(solution.uniqueness == Uniqueness::not_examined);
    }
}

TEST_CASE("a row that nothing moves does not hide that two answers differ", "[house]")
{
    // w = -λ - 1 ≤ 0 at λ = 0, and w = 0 at λ = -1: two answers, whatever the speed of a row that no impulse changes.
    for (const Real speed : {1.0, 1e9}) {
        Mlcp mlcp = problem({0, 0, 0, -1}, {speed, -1});
        mlcp.lo[1] = -infinity;
        mlcp.hi[1] = 0;
        CHECK(enumerate(mlcp).uniqueness == Uniqueness::any);
    }
}

TEST_CASE("enumeration finds what was planted between bounds of all kinds", "[idea]")
{
    for (int seed = 0; seed < 300; ++seed) {
        Random random(static_cast<std::uint64_t>(seed));
        const Index n = 1 + random.index(6);
        const MatX B = normal_matrix(random, n, n);
        const MatX A = B * B.transpose() + 0.1 * MatX::Identity(n, n);
        Mlcp mlcp = problem(A, VecX::Zero(n));
        VecX lambda(n), w = VecX::Zero(n);
        for (Index i = 0; i < n; ++i) {
            mlcp.lo[i] = random.uniform() < 0.3 ? -infinity : random.uniform(-2, 0.5);
            mlcp.hi[i] = random.uniform() < 0.3 ? infinity : random.uniform(0.6, 2);
            if (random.uniform() < 0.1) mlcp.lo[i] = mlcp.hi[i] = random.uniform(-1, 1);
            const Real low = std::max<Real>(mlcp.lo[i], -3), high = std::min<Real>(mlcp.hi[i], 3);
            lambda[i] = random.uniform(low, high);
            const Real where = random.uniform();
            if (where < 0.33 && std::isfinite(mlcp.lo[i]))
                lambda[i] = mlcp.lo[i], w[i] = random.uniform(0.1, 2);
            else if (where > 0.67 && std::isfinite(mlcp.hi[i]))
                lambda[i] = mlcp.hi[i], w[i] = -random.uniform(0.1, 2);
        }
        mlcp.q = w - A * lambda;
        const Solution solution = enumerate(mlcp);
        INFO("seed " << seed);
        REQUIRE(solution.status == Status::solved);
        REQUIRE(solution.uniqueness == Uniqueness::unique);
        REQUIRE((solution.lambda - lambda).cwiseAbs().maxCoeff() <= 1e-9 * size_of(mlcp, lambda));
    }
}

TEST_CASE("three answers with different w are distinguished from one", "[idea]")
{
    const Solution solution = enumerate(problem({1, 2, 2, 1}, {-1, -1}));
    CHECK(solution.status == Status::solved);
    CHECK(solution.uniqueness == Uniqueness::any);
}

TEST_CASE("a ray of answers is seen though each set has one member to show", "[house]")
{
    // w = 0 for every λ ≥ 0: the smallest case of a row that says nothing.
    CHECK(enumerate(problem({0}, {0})).uniqueness == Uniqueness::w_unique);
    // Two contacts that push the same disc the same way share its weight as they like.
    CHECK(enumerate(problem({1, 1, 1, 1}, {-1, -1})).uniqueness == Uniqueness::w_unique);
    // The same, but the second has a gap left: only the first can push.
    CHECK(enumerate(problem({1, 1, 1, 1}, {-1, -0.5})).uniqueness == Uniqueness::unique);
    // They push against each other: λ may grow without end.
    CHECK(enumerate(problem({1, -1, -1, 1}, {0, 0})).uniqueness == Uniqueness::w_unique);
}

TEST_CASE("an answer that only the family of a singular set has is found", "[house]")
{
    // λ₂ ≥ 1 with λ₁ = 0, and no elimination shows it: the block of row 2 is a zero, and the block of both
    // rows gives λ = (-1, 0).
    const Solution solution = enumerate(problem({-1, 1, 0, 0}, {-1, 0}));
    CHECK(solution.status == Status::solved);
    CHECK(solution.lambda[0] == 0);
    CHECK(solution.lambda[1] >= 1 - 1e-12);
    CHECK(solution.iterations == 4);  // each family is asked as its set comes by
    CHECK(solution.uniqueness == Uniqueness::any);
    EnumerationSettings first;  // where one answer is enough they are only asked when nothing else fits
    first.stop_at_first = true;
    CHECK(enumerate(problem({-1, 1, 0, 0}, {-1, 0}), first).iterations > 4);
}

TEST_CASE("a symmetric semi-definite problem never needs the second round", "[house]")
{
    for (int seed = 0; seed < 200; ++seed) {
        Random random(static_cast<std::uint64_t>(seed));
        const Index n = 2 + random.index(4);
        const MatX B = normal_matrix(random, n, 1 + random.index(n - 1));
        VecX lambda, w;
        const Mlcp mlcp = planted(random, B * B.transpose(), lambda, w);
        const Solution solution = enumerate(mlcp);
        REQUIRE(solution.status == Status::solved);
        REQUIRE(solution.iterations == 1 << n);
    }
}

TEST_CASE("sets are visited by their distance from the first guess", "[house]")
{
    const Mlcp mlcp = problem({2, 1, 0, 1, 2, 1, 0, 1, 2}, {-1, 3, -1});  // answer: rows 0 and 2 push
    EnumerationSettings settings;
    settings.stop_at_first = true;
    const auto tried = [&](std::vector<BoundState> first) {
        settings.first = std::move(first);
        const Solution solution = enumerate(mlcp, settings);
        CHECK(solution.status == Status::solved);
        CHECK(solution.uniqueness == Uniqueness::not_examined);
        return solution.iterations;
    };
    const BoundState pushes = BoundState::between, idle = BoundState::at_lo;
    CHECK(tried({pushes, idle, pushes}) == 1);
    CHECK(tried({idle, idle, pushes}) == 2);
    CHECK(tried({pushes, pushes, pushes}) == 3);
    CHECK(tried({idle, pushes, idle}) == 8);
    CHECK(tried({}) == 1);  // q alone guesses right here
    // Every set once.
    CHECK(enumerate(mlcp).iterations == 8);
    settings.most_sets = 2;
    settings.first = {idle, pushes, idle};
    CHECK(enumerate(mlcp, settings).status == Status::iteration_limit);
    // One of another problem would do nothing.
    settings.first = {idle, pushes};
    const std::string wanted = "the set to begin with names 2 rows; there are 3";
    CHECK(sentence_of([&] { enumerate(mlcp, settings); }) == wanted);
    CHECK(sentence_of([&] { schur(mlcp, settings); }) == wanted);
}

TEST_CASE("the order of the rows does not change the answer", "[idea]")
{
    Random random(7);
    for (int sample = 0; sample < 100; ++sample) {
        const Index n = 2 + random.index(5);
        const MatX B = normal_matrix(random, n, n);
        VecX lambda, w;
        const Mlcp mlcp = planted(random, B * B.transpose() + 0.1 * MatX::Identity(n, n), lambda, w);
        Eigen::PermutationMatrix<Eigen::Dynamic> turn(n);
        turn.setIdentity();
        for (Index i = n; i > 1; --i) turn.applyTranspositionOnTheRight(i - 1, random.index(i));
        const Mlcp turned = problem(turn * MatX(mlcp.A) * turn.transpose(), turn * mlcp.q);
        const VecX wanted = turn * enumerate(mlcp).lambda;
        REQUIRE((enumerate(turned).lambda - wanted).norm() <= 1e-10 * (1 + wanted.norm()));
    }
}

TEST_CASE("the answer of the MLCP is the least change of velocity in the metric of the masses as in (3.6)",
          "[idea]")
{
    // KKT ⇔ QP. u is the least change iff (u − u*)ᵀ M (v − u) ≥ 0 for every v that the rows allow.
    Random random(8);
    int compared = 0;
    for (int sample = 0; sample < 200; ++sample) {
        const Index K = 3, m = 1 + random.index(6);
        VecX inverse_mass;
        auto rows = random_rows<2>(random, m, K, inverse_mass);
        for (Index k = 0; k < K; ++k) inverse_mass.segment<2>(2 * k).setConstant(random.uniform(0.2, 5));
        const VecX inside = normal_vector(random, 2 * K), u_star = 2 * normal_vector(random, 2 * K);
        for (Row<2>& row : rows) {  // so that the velocity `inside` is allowed
            const Constraint<2> c{row.a, row.b, 0, row.Ja, row.Jb};
            row = unilateral(c, inverse_mass);
            row.bias = random.uniform(0, 1) - row.velocity(inside);
        }
        const Solution solution = enumerate(assemble(rows, u_star));
        REQUIRE(solution.status == Status::solved);
        VecX u = u_star;
        apply(rows, solution.lambda, u);
        const VecX mass = inverse_mass.cwiseInverse();
        const auto change = [&](const VecX& v) { return 0.5 * (v - u_star).cwiseAbs2().dot(mass); };
        for (const Row<2>& row : rows) REQUIRE(row.velocity(u) >= -1e-10);
        for (int trial = 0; trial < 300; ++trial) {
            const Real spread = std::pow(10, random.uniform(-4, 1));
            const VecX v = (trial % 2 ? u : inside) + spread * normal_vector(random, 2 * K);
            if (std::any_of(rows.begin(), rows.end(), [&](const Row<2>& row) { return row.velocity(v) < 0; }))
                continue;
            ++compared;
            // Worse by half the distance squared at least; rounding of the three squares.
            REQUIRE(change(v) >= change(u) + 0.5 * (v - u).cwiseAbs2().dot(mass) - 1e-10 * (1 + change(v)));
        }
    }
    CHECK(compared > 10000);
}

TEST_CASE("a disc on coincident floors is held with all its weight however it is shared", "[idea]")
{
    // C6 in the plane: one, two, three floors in the same place.
    const Real h = 1.0 / 60;
    for (const int floors : {1, 2, 3}) {
        DiscScene scene =
            one_disc({0, 0.1}, {0, 0}, std::vector<HalfSpace>(static_cast<std::size_t>(floors)));
        scene.bodies.inverse_mass.setConstant(1 / 2.5);
        StepData<2> now;
        StepSettings settings;
        settings.h = h;
        step(scene, settings, by_matrix([](const Mlcp& mlcp) { return enumerate(mlcp); }), now);
        CHECK(now.solution.status == Status::solved);
        CHECK(now.solution.uniqueness == (floors == 1 ? Uniqueness::unique : Uniqueness::w_unique));
        CHECK(now.solution.lambda.sum() == Approx(2.5 * 9.81 * h).epsilon(1e-12));
        CHECK(scene.bodies.u.norm() <= 1e-12);
    }
}

TEST_CASE("enumeration refuses what it cannot try in a lifetime", "[house]")
{
    CHECK(sentence_of([] { enumerate(problem(MatX::Identity(33, 33), VecX::Ones(33))); }) ==
          "the problem has 33 rows; enumeration takes at most 32");
    CHECK(sentence_of([] { enumerate(problem(MatX::Identity(26, 26), VecX::Ones(26))); }) ==
          "the 26 rows have 67108864 sets of cases; enumeration looks at no more than 43046721");
    CHECK(sentence_of([] {
              enumerate(problem(MatX::Identity(17, 17), VecX::Ones(17), -1, 1));
          }).find("the 17 rows have") == 0);
    Mlcp wrong = problem(MatX::Identity(2, 2), VecX::Ones(2));
    wrong.q[1] = std::nan("");
    CHECK(sentence_of([&] { enumerate(wrong); }).find("q[1] is") == 0);
    wrong = problem(MatX::Identity(2, 2), VecX::Ones(2), 1, 0);
    CHECK(sentence_of([&] { enumerate(wrong); }).find("row 0 has lo = 1") == 0);
}

TEST_CASE("a problem without rows is solved", "[idea]")
{
    const Mlcp empty = problem(MatX(0, 0), VecX(0));
    for (const Solution& solution : {enumerate(empty), schur(empty), direct(empty)}) {
        CHECK(solution.status == Status::solved);
        CHECK(solution.lambda.size() == 0);
        CHECK(solution.residual == 0);
    }
}

// ---- direct and Schur ----------------------------------------------------------------------------------

TEST_CASE("in a column of N discs contact k carries all that lies above it", "[house]")
{
    // C3, to 1e-12: one direct solve.
    const Real h = 1.0 / 60;
    for (const Index N : {1, 2, 5, 20, 100, 1000}) {
        DiscScene scene = column(N);
        auto rows = rows_of(scene, h, 0.01);
        REQUIRE(static_cast<Index>(rows.size()) == N);
        for (auto& row : rows) {
            row.lo = -infinity;
            row.bias = 0;  // the gaps are roundings of sums of radii
        }
        VecX u_star = VecX::Zero(2 * N);
        for (Index k = 0; k < N; ++k) u_star[2 * k + 1] = -9.81 * h;
        const Solution solution = direct(assemble(rows, u_star));
        REQUIRE(solution.status == Status::solved);
        for (std::size_t i = 0; i < rows.size(); ++i) {  // the floor's row stands behind those of the pairs
            const Index k = rows[i].b;
            const Real carried = static_cast<Real>(N - k) * 9.81 * h;
            // Condition (2N/π)²; the whole weight is the scale.
            CHECK(std::abs(solution.lambda[static_cast<Index>(i)] - carried) <=
                  1e-12 * static_cast<Real>(N) * 9.81 * h);
        }
    }
}

TEST_CASE("enumeration and Schur agree with the direct solve where all contacts push", "[house]")
{
    const Real h = 1.0 / 60;
    DiscScene scene = column(10);
    VecX u_star = VecX::Zero(20);
    for (Index k = 0; k < 10; ++k) u_star[2 * k + 1] = -9.81 * h;
    auto rows = rows_of(scene, h);
    const Mlcp contacts = assemble(rows, u_star);
    for (auto& row : rows) row.lo = -infinity;
    const VecX exact = direct(assemble(rows, u_star)).lambda;
    CHECK((enumerate(contacts).lambda - exact).norm() <= 1e-12 * exact.norm());
    for (std::size_t i = 0; i < rows.size(); i += 2) rows[i].lo = 0;  // half of them bilateral
    CHECK((schur(assemble(rows, u_star)).lambda - exact).norm() <= 1e-12 * exact.norm());
}

TEST_CASE("Schur finds what enumeration finds in random mixtures of joints and contacts", "[house]")
{
    Random random(9);
    for (int sample = 0; sample < 200; ++sample) {
        const Index n = 2 + random.index(7);
        const MatX B = normal_matrix(random, n, n);
        Mlcp mlcp = problem(B * B.transpose() + 0.1 * MatX::Identity(n, n), normal_vector(random, n));
        for (Index i = 0; i < n; ++i) {
            if (random.uniform() < 0.5) mlcp.lo[i] = -infinity;
            else if (random.uniform() < 0.3) mlcp.hi[i] = 0.5;
        }
        const Solution whole = enumerate(mlcp), parts = schur(mlcp);
        REQUIRE(parts.status == Status::solved);
        REQUIRE(parts.uniqueness == Uniqueness::unique);
        REQUIRE((whole.lambda - parts.lambda).norm() <= 1e-10 * (1 + whole.lambda.norm()));
        REQUIRE(parts.iterations <= whole.iterations);
    }
}

TEST_CASE("an impulse outside of its bounds is no answer although its w is zero", "[house]")
{
    for (const Real lambda : {-1.0, 2.0}) {
        const Mlcp mlcp = problem(MatX::Constant(1, 1, 1), VecX::Constant(1, -lambda), 0, 1);
        const Verification found = verify(mlcp, VecX::Constant(1, lambda));
        CHECK(!found.solved);
        CHECK(found.residual > 0);
    }
    CHECK(verify(problem(MatX::Constant(1, 1, 1), VecX::Constant(1, -0.5), 0, 1), VecX::Constant(1, 0.5))
              .solved);
}

TEST_CASE("rows that depend on each other are singular although rounding leaves them a pivot", "[house]")
{
    // Three directions in the plane: a matrix of rank two, whose last pivot is some 1e-17 and not zero.
    Random random(5);
    int left = 0;
    for (int round = 0; round < 100; ++round) {
        MatX J(3, 2);
        for (Index i = 0; i < 3; ++i) {
            const Real angle = random.uniform(0, 2 * pi);
            J.row(i) << std::cos(angle), std::sin(angle);
        }
        const MatX A = J * J.transpose();
        const VecX q = J * Vec2(random.uniform(-1, 1), 0.5), free = VecX::Constant(3, infinity);
        CHECK(direct({A.sparseView(), q, -free, free}).status == Status::singular);
        left += A.determinant() != 0;
    }
    CHECK(left > 50);
}

TEST_CASE("redundant bilateral rows are reported as singular whether or not they agree", "[house]")
{
    DiscScene scene = hanging_chain(5);
    auto rows = rows_of(scene, 0.01);
    VecX u_star = VecX::Zero(12);
    for (Index k = 1; k <= 5; ++k) u_star[2 * k + 1] = -0.1;
    REQUIRE(direct(assemble(rows, u_star)).status == Status::solved);
    rows.push_back(rows[2]);  // the same link once more
    CHECK(direct(assemble(rows, u_star)).status == Status::singular);
    CHECK(schur(assemble(rows, u_star)).status == Status::singular);
    // Enumeration may answer: one of the many λ.
    const Solution one = enumerate(assemble(rows, u_star));
    CHECK(one.status == Status::solved);
    CHECK(one.uniqueness == Uniqueness::w_unique);
    rows.back().bias = 1;  // and now it contradicts the first
    CHECK(direct(assemble(rows, u_star)).status == Status::singular);
    CHECK(enumerate(assemble(rows, u_star)).status == Status::infeasible);
    // A row between bodies that cannot move.
    scene.bodies.inverse_mass.setZero();
    CHECK(direct(assemble(rows_of(scene, 0.01), u_star)).status == Status::singular);
}

TEST_CASE("small pivots of an indefinite block are refined away", "[house]")
{
    // With any order of its rows the second pivot is 2e-8 and the third -2e8: what rounding does to the first solution is
    // 1e-8 of it, a hundred times what (3.16c) allows. One refinement takes the square of that.
    const Real o = 1 - 1e-8;
    MatX A(3, 3);
    A << 1, o, o, o, 1, -o, o, -o, 1;
    Mlcp mlcp = problem(A, Eigen::Vector3d(-1.3, 0.7, 0.4));
    mlcp.lo.setConstant(-infinity);
    const Solution solution = direct(mlcp);
    CHECK(solution.status == Status::solved);
    CHECK(solution.residual <= 1e-14);  // a few roundings of sums of size 2
    CHECK(schur(mlcp).status == Status::solved);
}

TEST_CASE("the block names a row that adds nothing", "[house]")
{
    MatX A = MatX::Identity(4, 4);
    A(3, 1) = A(1, 3) = 1;  // rows 1 and 3 are one row twice
    BilateralBlock block;
    block.factor(problem(A, VecX::Zero(4)).A, {0, 1, 2, 3});
    CHECK((block.singular_row() == 1 || block.singular_row() == 3));
    block.factor(problem(MatX::Identity(4, 4), VecX::Zero(4)).A, {0, 1, 2, 3});
    CHECK(block.singular_row() == -1);
}

TEST_CASE("an asymmetry of rounding is taken and one of a millionth is refused", "[house]")
{
    for (const bool rounding : {true, false}) {
        Mlcp mlcp = problem({1, 0.5, 0.5 * (rounding ? 1 + 1e-12 : 1 + 1e-6), 1}, {1, 1});
        mlcp.lo.setConstant(-infinity);
        if (rounding) CHECK(direct(mlcp).status == Status::solved);
        else CHECK_THROWS_AS(direct(mlcp), std::invalid_argument);
    }
}

TEST_CASE("a row with only an upper bound is not bilateral", "[house]")
{
    Mlcp mlcp = problem({1}, {-1});
    mlcp.lo[0] = -infinity;
    mlcp.hi[0] = 0.5;
    CHECK_THROWS_AS(direct(mlcp), std::invalid_argument);
    CHECK(schur(mlcp).lambda[0] == 0.5);
}

TEST_CASE("direct refuses bounds and both refuse a block that is not symmetric", "[house]")
{
    CHECK(sentence_of([] { direct(problem({1}, {1})); }) ==
          "row 0 has the bounds 0 and inf; the direct solve needs all rows without bounds (-inf and inf)");
    Mlcp skew = problem({2, 1, 0, 2}, {1, 1});
    skew.lo.setConstant(-infinity);
    const std::string sentence = sentence_of([&] { direct(skew); });
    CHECK(sentence == "A is not symmetric in its bilateral rows: A[0,1] is 1 and A[1,0] is 0; a Cholesky "
                      "decomposition needs them equal");
    CHECK(sentence_of([&] { schur(skew); }) == sentence);
    skew.lo[1] = 0;  // only the bilateral block has to be symmetric
    CHECK(schur(skew).status == Status::solved);
    CHECK((schur(skew).lambda - enumerate(skew).lambda).norm() < 1e-14);
}

// ---- the small problems --------------------------------------------------------------------------------

TEST_CASE("the problems of tests/problems have the answers that they say", "[house]")
{
    int files = 0;
    // fric_boxed_s4 has 1,679,616 cases, more than all others together: chapters 4, 5 and 9 solve it
    for (const char* name : {"blcp_spd_s10", "circulant_ties_12", "column_rest_s3", "disc_chain_s2",
                             "fric_st_s2", "infeasible_psd2", "mass1000_rest_s5", "murty_exp_s6",
                             "murty_q1_s16", "nonsym_pd_s6", "pyramid_impact_s3", "spd_s5"}) {
        const Problem file =
            read_problem(std::string(RIGID_SOURCE_DIR) + "/tests/problems/" + name + ".mlcp");
        INFO(name);
        CHECK(file.name == name);
        ++files;
        const Solution solution = enumerate(file.mlcp);
        if (file.kind == Uniqueness::none) {
            CHECK(solution.status == Status::infeasible);
            CHECK(schur(file.mlcp).status == Status::infeasible);
            continue;
        }
        REQUIRE(solution.status == Status::solved);
        const Real scale = size_of(file.mlcp, file.z);
        CHECK(solution.residual <= 1e-10 * scale);
        CHECK(natural_residual(file.mlcp, file.z) <= 1e-13 * scale);  // what the file says is true
        if (file.kind != Uniqueness::any) CHECK(solution.uniqueness == file.kind);
        const auto compare = [&](const Solution& answer) {
            // z of mass1000 is known to 4e-11 of 1e3: the condition of its A.
            if (file.kind == Uniqueness::unique)
                CHECK((answer.lambda - file.z).cwiseAbs().maxCoeff() <=
                      1e-9 * (1 + file.z.cwiseAbs().maxCoeff()));
            if (file.kind != Uniqueness::any)
                CHECK((w_of(file.mlcp, answer.lambda) - file.w).cwiseAbs().maxCoeff() <= 1e-10 * scale);
        };
        compare(solution);
        if (solution.iterations > 5000)
            continue;  // where nothing is bilateral, Schur is the same enumeration
        const Solution parts = schur(file.mlcp);
        CHECK(parts.status == Status::solved);
        compare(parts);
    }
    CHECK(files == 12);
}

TEST_CASE("a problem that was written is read again", "[house]")
{
    Problem file;
    file.name = "two_walls";
    file.mlcp = problem({2, 0, 0, 2}, {-2, 3});
    std::ostringstream out;
    write_solution(out, file, enumerate(file.mlcp));
    CHECK(out.str() == "name two_walls\nn 2\nstatus solved\nresidual 0\niterations 4\nsolution unique\n"
                       "z\n1 0\nw\n0 3\n");
    std::istringstream in(
        "# a comment\nname two_walls\nn 2\n\nsolution unique # another\nA\n2 1\n1 2\nq\n-3 -3\n"
        "hi\ninf 5\nlo\n-inf 0\nz\n1 1\nw\n0 0\n");
    const Problem read = read_problem(in);
    CHECK(read.name == "two_walls");
    CHECK(read.kind == Uniqueness::unique);
    CHECK(read.mlcp.A.coeff(1, 0) == 1);
    CHECK(read.mlcp.lo[0] == -infinity);
    CHECK(read.mlcp.hi[1] == 5);
    CHECK(read.z == VecX::Ones(2));
    std::istringstream plain("n 1\nA\n2\nq\n-3\n");
    CHECK(read_problem(plain).mlcp.hi[0] == infinity);
}

TEST_CASE("a malformed problem gets one sentence with its line", "[house]")
{
    const auto sentence = [](const std::string& text) {
        return sentence_of([&] {
            std::istringstream in(text);
            read_problem(in);
        });
    };
    CHECK(sentence("n 2\nA\n1 0\n0 1\n") == "line 5: the file ends here, and \"q\" is missing");
    CHECK(sentence("n 2\nq\n1 1\n") == "line 4: the file ends here, and \"A\" is missing");
    CHECK(sentence("name x\n") == "line 2: the file ends here, and \"n\" is missing");
    CHECK(sentence("") == "line 1: the file ends here, and \"n\" is missing");
    CHECK(sentence("n 2\nA\n1 0\n0 1 2\nq\n1 1\n") == "line 4: row 2 of A has 3 entries; it must have 2");
    CHECK(sentence("n 2\nA\n1 0\n0 1\n1 1\nq\n1 1\n").find("line 5: \"1\" is no key and no section") == 0);
    CHECK(sentence("n 2\nA\n1 0\nq\n1 1\n") == "line 4: row 2 of A has 1 entries; it must have 2");
    CHECK(sentence("n 2\nA\n1 0\n0 1\nq\n1\n") == "line 6: section \"q\" has 1 entries; it must have 2");
    CHECK(sentence("n 2\nA\n1 0\n0 1\nq\n") == "line 6: the file ends where section \"q\" should be");
    CHECK(sentence("n 1\nA\n1,5\nq\n1\n") ==
          "line 3: row 1 of A has the entry \"1,5\"; it must be a finite number");
    CHECK(sentence("n 1\nA\nnan\nq\n1\n") ==
          "line 3: row 1 of A has the entry \"nan\"; it must be a finite number");
    CHECK(sentence("n 1\nA\ninf\nq\n1\n").find("line 3: row 1 of A has the entry \"inf\"") == 0);
    CHECK(sentence("n 1\nA\n1e999\nq\n1\n").find("line 3: row 1 of A has the entry \"1e999\"") == 0);
    CHECK(sentence("n 1\nA\n1\nq\n1\nlo\ninf\n").find("line 7: section \"lo\" has the entry \"inf\"") == 0);
    CHECK(sentence("n 1\nA\n1\nq\n1\nlo\n2\nhi\n1\n") ==
          "line 9: entry 1 has lo = 2 and hi = 1; lo must not be above hi (without a section lo is 0)");
    CHECK(sentence("n 1\nA\n1\nq\n1\nhi\n-1\n").find("line 7: entry 1 has lo = 0 and hi = -1") == 0);
    CHECK(sentence("n 0\nA\nq\n") == "line 1: n is \"0\"; it must be a whole number from 1 to 10000");
    for (const char* n : {"-2", "2.5", "10001", "99999999999999999999", "two"})
        CHECK(sentence(std::string("n ") + n + "\n").find("line 1: n is \"") == 0);
    CHECK(sentence("n\n") == "line 1: \"n\" has 0 values on its line; it must have one");
    CHECK(sentence("n 2 3\n") == "line 1: \"n\" has 2 values on its line; it must have one");
    CHECK(sentence("A\n1\n") == "line 1: section \"A\" begins before n was given");
    CHECK(sentence("n 1\nB\n1\n").find("line 2: \"B\" is no key and no section") == 0);
    CHECK(sentence("n 1\nn 1\n") == "line 2: \"n\" is there twice, first in line 1");
    CHECK(sentence("n 1\nA 1\n") == "line 2: the name of the section \"A\" must stand alone on its line");
    CHECK(sentence("n 1\nsolution some\n") ==
          "line 2: the solution is \"some\"; it must be unique, w_unique, any or none");
    CHECK(sentence("n 1\nA\n1\nq\n1\nz\n1\nw\n1\n5\n").find("line 10: \"5\" is no key and no section") == 0);
    CHECK(sentence(std::string(100000, 'x')).size() < 200);
    CHECK(sentence_of([] { read_problem(std::string("/no/such/file")); }) ==
          "the problem /no/such/file can't be read; it must be a file");
}

TEST_CASE("a line of a problem that does not end is refused", "[house]")
{
    const auto sentence = [](const std::string& text) {
        std::istringstream in(text);
        try {
            read_problem(in);
        } catch (const std::invalid_argument& refused) {
            return std::string(refused.what());
        }
        return std::string("accepted");
    };
    CHECK(sentence("n 1\n" + std::string(longest_line + 1, '0')) ==
          "line 2: the line has more than 1000000 characters; a row of the largest problem has fewer");
    CHECK(sentence("n 1\nA\n1\nq\n1\n#" + std::string(longest_line - 1, 'x')) == "accepted");
    CHECK(sentence("n 1\nA\n1\nq\n1") == "accepted");
#ifdef __linux__
    std::ifstream endless("/dev/zero");  // reading it whole would take all memory
    CHECK_THROWS_WITH(read_problem(endless), Catch::Matchers::Contains("line 1: the line has more than"));
#endif
}

TEST_CASE("random text is refused and nothing else happens", "[house]")
{
    Random random(10);
    const std::string letters = "0123456789 .-+einfqAlohzw\n\n  #\t";
    for (int sample = 0; sample < 2000; ++sample) {
        std::string text = sample % 2 ? "n 2\nA\n1 0\n0 1\nq\n" : "";
        for (Index i = random.index(60); i > 0; --i)
            text += letters[static_cast<std::size_t>(random.index(static_cast<Index>(letters.size())))];
        std::istringstream in(text);
        try {
            const Problem problem = read_problem(in);
            require_valid(problem.mlcp);
        } catch (const std::invalid_argument& refused) {
            REQUIRE(std::string(refused.what()).find("line ") == 0);
        }
    }
}

// ---- the whole step ------------------------------------------------------------------------------------

TEST_CASE("a disc that falls freely falls as chapter 1 says to the last digits", "[house]")
{
    DiscScene scene = one_disc({0, 0}, {0, 0}, {});
    StepSettings settings;
    settings.h = 1.0 / 60;
    StepData<2> now;
    for (int k = 0; k < 60; ++k) step(scene, settings, by_matrix(exact_solve), now);
    CHECK(scene.bodies.x[1] == Approx(-4.98675).epsilon(1e-12));  // −½ g t² (1 + h/t)
}

TEST_CASE("a disc lands on the floor and not in it", "[house]")
{
    // Gap 5 cm, 10 m/s, h = 1/60: it would pass through. (3.30) lets it come down to the floor and no
    // further.
    DiscScene scene = one_disc({0, 0.15}, {0.3, -10}, {{{0, 1}, 0}});
    StepSettings settings;
    settings.h = 1.0 / 60;
    settings.margin = 0.2;
    StepData<2> now;
    step(scene, settings, by_matrix(exact_solve), now);
    CHECK(std::abs(scene.bodies.x[1] - 0.1) <= 1e-15);
    CHECK(scene.bodies.u[1] == Approx(-0.05 * 60).epsilon(1e-13));
    CHECK(scene.bodies.u[0] == 0.3);  // no friction
    step(scene, settings, by_matrix(exact_solve), now);
    CHECK(std::abs(scene.bodies.u[1]) <= 1e-13);
    for (int k = 0; k < 1000; ++k) {  // and there it rests, carried by m g h in each step
        step(scene, settings, by_matrix(exact_solve), now);
        REQUIRE(now.solution.lambda.size() == 1);
        REQUIRE(now.solution.lambda[0] == Approx(9.81 / 60).epsilon(1e-12));
    }
    CHECK(std::abs(scene.bodies.x[1] - 0.1) <= 1e-13);
}

TEST_CASE("a turning rod is stretched in one step by what (3.32) says", "[house]")
{
    for (const Real h : {0.01, 0.001}) {
        DiscScene scene = pendulum();
        scene.gravity.setZero();
        scene.bodies.u << 0, 0, 0, 3;
        StepSettings settings;
        settings.h = h;
        StepData<2> now;
        step(scene, settings, by_matrix(exact_solve), now);
        CHECK(largest_link_error(scene) == Approx(std::sqrt(1 + 9 * h * h) - 1).epsilon(1e-9));
        // The next step takes it back, and makes its own: never more than a few h² u²/2L.
        for (int k = 0; k < 1000; ++k) {
            step(scene, settings, by_matrix(exact_solve), now);
            REQUIRE(largest_link_error(scene) <= 1.1 * 9 * h * h / 2);
        }
    }
}

TEST_CASE("momentum and angular momentum stay as they are without outer forces", "[house]")
{
    // B2: a chain and free discs fly into each other; the springs bend, links pull, contacts push.
    DiscScene scene = ten_discs();
    scene.walls.clear();
    Random random(11);
    for (Index k = 0; k < 10; ++k) {
        scene.bodies.velocity(k) = -3 * scene.bodies.position(k);
        const Real uy = random.normal(), ux = random.normal();
        scene.bodies.velocity(k) += 0.3 * Vec2(ux, uy);
    }
    const Vec2 before = momentum(scene.bodies);
    const Real turning = angular_momentum(scene.bodies);
    Real size = 0, most_contacts = 0;
    for (Index k = 0; k < 10; ++k) size += scene.bodies.velocity(k).norm() / scene.bodies.inverse_mass[2 * k];
    StepSettings settings;
    settings.h = 1.0 / 480;
    scene.gravity.setZero();
    settings.stiffness = 3;
    settings.damping = 2;
    StepData<2> now;
    for (int n = 0; n < 400; ++n) {
        step(scene, settings, by_matrix(exact_solve), now);
        REQUIRE(now.solution.status == Status::solved);
        Real pushing = 0;
        for (Index i = 6; i < now.solution.lambda.size(); ++i) pushing += now.solution.lambda[i] > 0 ? 1 : 0;
        most_contacts = std::max(most_contacts, pushing);
        // 1e-13 of Σ‖p‖, for some thousand impulses of which each rounds.
        REQUIRE((momentum(scene.bodies) - before).norm() <= 1e-13 * size);
        REQUIRE(std::abs(angular_momentum(scene.bodies) - turning) <= 1e-12 * size);
    }
    CHECK(most_contacts >= 2);
}

TEST_CASE("the pendulum of the step converges with first order", "[house]")
{
    // A4: released at 90°, θ(1) = −1.405027311524799 for L = 1 m.
    std::vector<Real> errors;
    for (int n = 500; n <= 16000; n *= 2) {
        DiscScene scene = pendulum();
        StepSettings settings;
        settings.h = 1.0 / n;
        StepData<2> now;
        const auto solve = [](const Mlcp& mlcp) { return direct(mlcp); };
        for (int k = 0; k < n; ++k) step(scene, settings, by_matrix(solve), now);
        errors.push_back(std::abs(std::atan2(scene.bodies.x[2], -scene.bodies.x[3]) - -1.405027311524799));
    }
    for (std::size_t i = 1; i < errors.size(); ++i)
        CHECK(std::log2(errors[i - 1] / errors[i]) == Approx(1).margin(0.15));
}

TEST_CASE("at the lowest point the rod of the pendulum pulls with three times the weight", "[house]")
{
    // B3 through the step: tension λ/h = 3 m g, up to O(h).
    DiscScene scene = pendulum();
    StepSettings settings;
    settings.h = 1e-4;
    StepData<2> now;
    Real tension = 0;
    for (Limit steps(100000); scene.bodies.x[2] > 0 && steps.left();) {
        step(scene, settings, by_matrix([](const Mlcp& mlcp) { return direct(mlcp); }), now);
        tension = -now.solution.lambda[0] / settings.h;
    }
    CHECK(tension == Approx(3 * 9.81).epsilon(2e-3));
}

TEST_CASE("a gap closes unseen only above the margin over h and the text says for each of its steps",
          "[house]")
{
    const Real margin = 0.02;
    std::string printed_speeds;
    for (const int n : {240, 360, 480}) {
        const Real h = 1.0 / n, fastest = margin / h;
        printed_speeds +=
            (n == 240 ? "" : ", ") + printed(fastest, 1) + " m/s at 1/" + std::to_string(n) + " s";
        for (const bool too_fast : {false, true}) {  // from just outside of the margin
            VecX x(2), radius = VecX::Constant(1, 0.1);
            x << 0, 0.1 + margin * (1 + 1e-9);
            std::vector<Contact> contacts;
            find_contacts(scene_of(x, radius, {{{0, 1}, 0}}), margin, contacts);
            REQUIRE(contacts.empty());
            x[1] -= h * fastest * (too_fast ? 1.01 : 0.99);
            find_contacts(scene_of(x, radius, {{{0, 1}, 0}}), margin, contacts);
            REQUIRE(contacts.size() == 1);
            CHECK((contacts[0].gap < 0) == too_fast);
        }
    }
    CHECK(says("chapters/03_mlcp_formulation/in_depth.md", printed_speeds));
}

TEST_CASE("heavier discs move the same and a mirrored scene moves mirrored", "[house]")
{
    const auto run = [](DiscScene scene, const Vec2& gravity) {
        StepSettings settings{.h = 1.0 / 480};
        scene.gravity = gravity;
        settings.stiffness = 1;
        StepData<2> now;
        for (int n = 0; n < 300; ++n) step(scene, settings, by_matrix(exact_solve), now);
        return scene.bodies.x;
    };
    const Vec2 gravity(4, -8);
    const VecX x = run(ten_discs(), gravity);
    DiscScene heavy = ten_discs();
    heavy.bodies.inverse_mass /= 4;
    CHECK(run(heavy, gravity) == x);  // a power of four: not a bit is rounded in another way

    DiscScene mirrored = ten_discs();
    for (Index k = 0; k < 10; ++k) mirrored.bodies.x[2 * k] *= -1;
    std::swap(mirrored.walls[0], mirrored.walls[1]);
    VecX back = run(mirrored, {-gravity.x(), gravity.y()});
    for (Index k = 0; k < 10; ++k) back[2 * k] *= -1;
    // Rounding in another order, through the impacts of 0.6 s.
    CHECK((back - x).norm() <= 1e-9);
}

TEST_CASE("a step of zero or of NaN seconds is refused", "[house]")
{
    DiscScene scene = ten_discs();
    StepSettings settings;
    StepData<2> now;
    for (const Real h : {Real{0}, Real{-1}, Real{std::nan("")}, Real{infinity}}) {
        settings.h = h;
        CHECK(sentence_of([&] {
                  step(scene, settings, by_matrix(exact_solve), now);
              }).find("the time step h is") == 0);
    }
}

// ---- the ten discs -------------------------------------------------------------------------------------

namespace {

struct TenDiscsResult {
    Real link_error = 0, penetration = 0;  ///< largest after the first ten steps [m]
    VecX x;
};

/// 600 steps under the pointer of a seed, as the program takes them.
TenDiscsResult ten_discs_run(std::uint64_t seed, Real h, Real k, Real damping, Real gravity, int steps = 600)
{
    DiscScene scene = ten_discs();
    const View view = {{0, 0}, {0.8, 0.55}};
    const ScriptedPointer pointer(seed, view);
    Settings settings;
    settings.h = h;
    settings.tunables = {{"k", k}, {"damping", damping}, {"gravity", gravity}};
    StepData<2> now;
    std::vector<Contact> last;
    TenDiscsResult result;
    for (int n = 0; n < steps; ++n) {
        const Input input = {.pointer = pointer.at(n * h), .present = true};
        scene.gravity = steered_gravity(input, view, gravity);
        step(scene, ten_discs_settings(settings, input), by_matrix(exact_solve), now);
        REQUIRE(now.solution.status == Status::solved);
        REQUIRE(scene.bodies.x.allFinite());
        REQUIRE(scene.bodies.u.allFinite());
        if (n < 10) continue;
        result.link_error = std::max(result.link_error, largest_link_error(scene));
        result.penetration = std::max(result.penetration, deepest_penetration(scene));
    }
    result.x = scene.bodies.x;
    return result;
}

}  // namespace

TEST_CASE("600 steps of the ten discs keep links and contacts to a millimetre", "[house]")
{
    for (std::uint64_t seed = 1; seed <= 5; ++seed)
        for (const Real k : {0.0, 1.0, 3.0}) {
            const TenDiscsResult result = ten_discs_run(seed, ten_discs_h, k, 1, 9.81);
            INFO("seed " << seed << ", k = " << k);
            CHECK(result.link_error < 1e-3);
            CHECK(result.penetration < 1e-3);
        }
}

TEST_CASE("no place of the sliders makes the ten discs lose a number", "[house]")
{
#ifdef RIGID_ADDRESS_SANITIZER
    const unsigned apart = 7;  // minutes under the sanitizers: all sliders low, and all high
#else
    const unsigned apart = 1;
#endif
    const std::vector<Tunable> sliders = ten_discs_tunables();
    const auto at = [&](unsigned ends, std::size_t i) {
        return (ends >> i & 1U) != 0 ? sliders[i].high : sliders[i].low;
    };
    for (const Real h : {ten_discs_h_low, ten_discs_h, ten_discs_h_high})
        for (unsigned ends = 0; ends < 8; ends += apart)
            CHECK(ten_discs_run(2, h, at(ends, 0), at(ends, 1), at(ends, 2)).x.allFinite());
}

TEST_CASE("a second run of the ten discs gives the same bits", "[house]")
{
    CHECK(ten_discs_run(3, ten_discs_h, 1, 1, 9.81).x == ten_discs_run(3, ten_discs_h, 1, 1, 9.81).x);
    CHECK(ten_discs_run(3, ten_discs_h, 1, 1, 9.81).x != ten_discs_run(4, ten_discs_h, 1, 1, 9.81).x);
}

TEST_CASE("the pointer steers gravity as far as its size and no further", "[house]")
{
    const View view = {{1, 0}, {2, 0.5}};
    CHECK(steered_gravity({}, view, 9.81) == Vec2(0, -9.81));
    CHECK(steered_gravity({.pointer = {1, 0}, .present = true}, view, 9.81) == Vec2(0, 0));
    CHECK(steered_gravity({.pointer = {2, 0}, .present = true}, view, 10) == Vec2(5, 0));
    CHECK((steered_gravity({.pointer = {3, 0.5}, .present = true}, view, 10) -
           Vec2(std::sqrt(50), std::sqrt(50)))
              .norm() < 1e-12);
}

namespace {

using CasesState = RunState<CasesMethod>;

const Measured<CasesState> pulled_disc = {
    {"pulled", "", "the disc that the hand pulls"},
    [](const SceneState& state) { return static_cast<Real>(state.step.pulled); }};

/// Two discs of 1 kg and radius 0.1 m at (0, 0) and (1, 0), without gravity.
SceneSetup<CasesMethod> two_free_discs()
{
    SceneSetup<CasesMethod> setup;
    setup.scene.bodies = Bodies<2>(2);
    setup.scene.bodies.x << 0, 0, 1, 0;
    setup.scene.radius = VecX::Constant(2, 0.1);
    setup.scene.gravity = {0, 0};
    return setup;
}

}  // namespace

TEST_CASE("a run pulls the disc that lies under the pressed pointer of its picture and lets it go", "[house]")
{
    SceneSetup<CasesMethod> setup = two_free_discs();
    setup.zoom = 2;  // what is at 1 m is drawn at 2
    SceneRun<CasesMethod> run({}, {pulled_disc, columns::last_rise()}, setup);
    Settings settings;
    settings.h = 1.0 / 60;
    constexpr bool pressed = true, released = false;
    const auto after = [&](const Vec2& pointer, bool down) {
        run.step(settings, {.pointer = pointer, .present = true, .pressed = down});
        return run.measure();
    };
    CHECK(after({2.1, 0}, released)[0] == world);
    CHECK(after({1, 0}, pressed)[0] == world);  // nothing lies at 0.5 m
    CHECK(after({2.1, 0}, pressed)[0] == 1);
    CHECK(after({2.1, 1}, pressed)[0] == 1);  // it is held, wherever the hand goes
    CHECK(after({2.1, 1}, pressed)[1] > 0);
    CHECK(after({2.1, 1}, released)[0] == world);
}

TEST_CASE("a run lets go of a disc that is taken away and names a body that is lost", "[house]")
{
    SceneSetup<CasesMethod> setup = two_free_discs();
    setup.before = [](const Settings&, const Input&, CasesState& state) {
        if (state.steps != 1) return;
        DiscScene one = two_free_discs().scene;
        one.bodies = Bodies<2>(1);
        one.radius = VecX::Constant(1, 0.1);
        state.scene = one;
    };
    SceneRun<CasesMethod> run({}, {pulled_disc}, setup);
    Settings settings;
    settings.h = 1.0 / 60;
    const Input on_the_second = {.pointer = {1, 0}, .present = true, .pressed = true};
    run.step(settings, on_the_second);
    CHECK(run.measure()[0] == 1);
    run.step(settings, on_the_second);
    CHECK(run.measure()[0] == world);

    SceneSetup<CasesMethod> fast = two_free_discs();
    fast.scene.bodies.u << 0, 0, 1e308, 0;
    SceneRun<CasesMethod> lost({}, {pulled_disc}, fast);
    settings.h = 100;  // 1e310 m in a step is no number
    CHECK_THROWS_WITH(lost.step(settings, Input{}), "the position of body 1 is not finite");
}

TEST_CASE("a demo has the columns that its runs measure", "[house]")
{
    Demo demo;
    run_scene<CasesMethod>(demo, {pulled_disc, columns::energy().plotted(), columns::rows()},
                           [](const Settings&) { return two_free_discs(); });
    REQUIRE(demo.columns.size() == 3);
    CHECK(demo.columns[1].name == "energy");
    CHECK(demo.columns[1].plotted());
    CHECK(demo.start(Settings{})->measure() == std::vector<Real>{world, 0, 0});
}

// ---- the exercises ---------------------------------------------------------------------------------

TEST_CASE("the value of the answer is half of q times lambda", "[idea]")
{
    // Exercise 3.2, for random problems from rows: A = B Bᵀ.
    Random random(32);
    for (int i = 0; i < 100; ++i) {
        MatX B(4, 5);
        VecX q(4);
        for (Real& entry : B.reshaped()) entry = random.normal();
        for (Real& entry : q) entry = random.normal();
        const MatX A = B * B.transpose();
        const Mlcp mlcp{A.sparseView(), q, VecX::Zero(4), VecX::Constant(4, infinity)};
        const Solution solution = enumerate(mlcp);
        REQUIRE(solution.status == Status::solved);
        const VecX& lambda = solution.lambda;
        // λᵀw is rounding: each product is at most the size of λ times the tolerance of the rule.
        CHECK(lambda.dot(A * lambda) == Approx(-q.dot(lambda)).margin(1e-9 * (1 + lambda.squaredNorm())));
    }
}

TEST_CASE("three balls that are solved together do not behave as a cradle", "[idea]")
{
    // Exercise 3.3: q = J u* + e J u with e = 1.
    MatX A(2, 2);
    A << 2, -1, -1, 2;
    const Mlcp mlcp{A.sparseView(), Vec2(-2, 0), VecX::Zero(2), VecX::Constant(2, infinity)};
    const Solution solution = enumerate(mlcp);
    REQUIRE(solution.status == Status::solved);
    const VecX& lambda = solution.lambda;
    CHECK((lambda - Vec2(4. / 3, 2. / 3)).norm() < 1e-12);  // a few roundings of numbers of size one
    const Vec<3> u(1 - lambda[0], lambda[0] - lambda[1], lambda[1]);
    CHECK((u - Vec<3>(-1. / 3, 2. / 3, 2. / 3)).norm() < 1e-12);
    CHECK(u.squaredNorm() == Approx(1));
}

TEST_CASE("a positive definite matrix that is not symmetric has one answer", "[idea]")
{
    // Exercise 3.4.
    MatX A(2, 2);
    A << 1, 1, -1, 1;
    Random random(34);
    for (int i = 0; i < 200; ++i) {
        const Real first = random.normal(), second = random.normal();
        const Mlcp mlcp{A.sparseView(), Vec2(first, second), VecX::Zero(2), VecX::Constant(2, infinity)};
        const Solution solution = enumerate(mlcp);
        CHECK(solution.status == Status::solved);
        CHECK(solution.uniqueness == Uniqueness::unique);
    }
}
