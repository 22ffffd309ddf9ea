/// Chapter 30: one element, many of them, and what is known of bars, beams, rings and blocks.

#include "tests/no_allocation.hpp"
// first: it counts what Eigen asks for

#include "tests/catch.hpp"
#include "tests/order.hpp"
#include "tests/sentence.hpp"

#include "chapters/30_elastic_bodies/elastic_loads.hpp"
#include "chapters/30_elastic_bodies/elastic_solver.hpp"
#include "common/random.hpp"

using namespace rigid;

namespace {

/// λ = μ = 1 Pa: E = 2.5 Pa, ν = 1/4.
ElasticMaterial unit_material(StrainLaw law)
{
    return {.young = 2.5, .poisson = 0.25, .density = 24, .law = law};
}

ElasticMesh<2> one_triangle()
{
    ElasticMesh<2> mesh;
    mesh.rest = VecX{{0, 0, 1, 0, 0, 1}};
    mesh.elements = {0, 1, 2};
    return mesh;
}

/// A mesh whose inner nodes lie anywhere.
template <int Dim>
ElasticMesh<Dim> shaken(ElasticMesh<Dim> mesh, Real by)
{
    Random random(5);
    const std::vector<int> surface = surface_nodes(mesh);
    for (int i = 0; i < mesh.nodes(); ++i)
        if (!std::binary_search(surface.begin(), surface.end(), i))
            for (int c = 0; c < Dim; ++c) mesh.rest[Dim * i + c] += by * random.uniform(-1, 1);
    return mesh;
}

/// Every surface node is held at A x, the others are where they are: the answer is A x.
template <int Dim>
void patch_test(const ElasticMesh<Dim>& mesh, StrainLaw law)
{
    ElasticBody<Dim> body(mesh, {.young = 3e4, .poisson = 0.3, .law = law});
    Random random(7);
    Mat<Dim> A = Mat<Dim>::Identity();
    for (Index i = 0; i < A.size(); ++i) A.data()[i] += 0.1 * random.uniform(-1, 1);
    for (const int i : surface_nodes(mesh)) {
        body.hold(i);
        body.x.template segment<Dim>(Dim * i) = A * mesh.at(i);
    }
    ElasticSolver<Dim> solver;
    solver.settings.tolerance = 1e-14;
    solver.rest(body);
    REQUIRE(solver.report.status == Status::solved);
    Real off = 0;
    for (int i = 0; i < mesh.nodes(); ++i) off = std::max(off, (body.at(i) - A * mesh.at(i)).norm());
    CHECK(off < 1e-13);  // some ulp of a metre
    for (int p = 0; p < body.model.points(); ++p)
        CHECK((body.model.deformation(body.x, p) - A).norm() < 1e-12);  // the same over an edge of 0.2 m
}

/// A cantilever of 1 m and height d; returns its tip's sag under 1 N over that of Euler and
/// Bernoulli with Timoshenko's shear, (30.15).
Real sag_ratio(int nx, int ny, int order, Real d, Real nu, Diagonals diagonals = Diagonals::alternate)
{
    ElasticMesh<2> mesh = rectangle_mesh({0, -d / 2}, {1, d}, nx, ny, diagonals);
    if (order == 2) mesh = quadratic(mesh);
    ElasticBody<2> body(mesh, {.young = 1e6, .poisson = nu, .law = StrainLaw::linear});
    for (int i = 0; i < mesh.nodes(); ++i)
        if (mesh.at(i).x() < 1e-9) body.hold(i);
    add_edge_load(
        body, [](const Vec2& p) { return p.x() > 1 - 1e-9; }, Vec2(0, -1 / d));
    ElasticSolver<2> solver;
    solver.rest(body);
    REQUIRE(solver.report.status == Status::solved);
    Real sag = 0;
    for (int i = 0; i < mesh.nodes(); ++i)
        if (mesh.at(i).x() > 1 - 1e-9) sag = std::max(sag, mesh.at(i).y() - body.at(i).y());
    return sag / cantilever_sag({.young = 1e6, .poisson = nu}, 1, d, 1);
}

}  // namespace

// ----------------------------------------------------------------------------------- one element

TEST_CASE("a triangle that is pulled by a tenth has the energy and the forces of section 30.1", "[idea]")
{
    const ElasticModel<2> model(one_triangle(), unit_material(StrainLaw::linear));
    VecX x = model.mesh().rest, f = VecX::Zero(6);
    x[2] += 0.1;
    CHECK(model.add_forces(x, f) == Approx(0.0075).epsilon(1e-13));
    // sums of a few numbers below one
    CHECK((f - VecX{{0.15, 0.05, -0.15, 0, 0, -0.05}}).norm() < 1e-15);
    BlockMatrix<2> K;
    K.reset(model.pattern());
    model.add_stiffness(x, 1, false, K);
    const std::vector<Real> first{2, 1, 1, 2};  // K_00 of (30.6)
    for (int i = 0; i < 4; ++i)
        CHECK(K.block(0)[i] == Approx(first[static_cast<std::size_t>(i)]).epsilon(1e-14));
}

TEST_CASE("a turn is a strain of cos θ − 1 by the linear law and none by the others", "[idea]")
{
    for (const Real angle : {0.1, pi / 3, 2.5, pi}) {
        Mat<2> R;
        R << std::cos(angle), -std::sin(angle), std::sin(angle), std::cos(angle);
        const ElasticModel<2> linear(one_triangle(), unit_material(StrainLaw::linear));
        VecX x(6);
        for (int i = 0; i < 3; ++i) x.segment<2>(2 * i) = R * linear.mesh().at(i);
        // Ψ of ε = (cos θ − 1) I with λ = μ = 1 is 4 (cos θ − 1)², over half a square metre
        const Real strain = std::cos(angle) - 1;
        CHECK(linear.energy(x) == Approx(2 * strain * strain).epsilon(1e-12));
        for (const StrainLaw law : {StrainLaw::corotational, StrainLaw::neo_hookean}) {
            const ElasticModel<2> turning(one_triangle(), unit_material(law));
            VecX f = VecX::Zero(6);
            CHECK(turning.add_forces(x, f) < 1e-15);  // squares of rounding, J − 1 to an ulp
            CHECK(f.norm() < 1e-14);
        }
    }
}

TEST_CASE("forces are minus the slope of the energy and the stiffness is minus that of the forces", "[idea]")
{
    const auto check = [](auto mesh, StrainLaw law) {
        constexpr int Dim = decltype(mesh)::corners - 1;
        const ElasticModel<Dim> model(mesh, unit_material(law));
        Random random(3);
        VecX x = mesh.rest, d = x;
        for (Index i = 0; i < x.size(); ++i) {
            x[i] += 0.2 * random.uniform(-1, 1);
            d[i] = random.uniform(-1, 1);
        }
        BlockMatrix<Dim> K;
        K.reset(model.pattern());
        model.add_stiffness(x, 1, false, K);
        VecX f = VecX::Zero(x.size()), Kd;
        model.add_forces(x, f);
        K.multiply(d, Kd);
        const Real e = 1e-5;
        const VecX ahead = x + e * d, behind = x - e * d;
        VecX fa = VecX::Zero(x.size()), fb = fa;
        const Real Ea = model.add_forces(ahead, fa), Eb = model.add_forces(behind, fb);
        // differences: e² of the third derivative, and 1e-16/e of rounding
        CHECK((Ea - Eb) / (2 * e) == Approx(-f.dot(d)).epsilon(1e-7).margin(1e-8));
        CHECK(((fb - fa) / (2 * e) - Kd).norm() < 1e-6 * Kd.norm());
    };
    for (const StrainLaw law : {StrainLaw::linear, StrainLaw::corotational, StrainLaw::neo_hookean}) {
        check(bar_mesh(3, 3), law);
        check(quadratic(bar_mesh(3, 3)), law);
        check(rectangle_mesh({0, 0}, {3, 2}, 3, 2), law);
        check(quadratic(disc_mesh({0, 0}, 2, 2)), law);
        check(block_mesh({0, 0, 0}, {2, 2, 3}, 2, 2, 3), law);
        check(quadratic(block_mesh({0, 0, 0}, {1, 1, 2}, 1, 1, 2)), law);
    }
}

TEST_CASE("a patch of any elements keeps a constant strain to rounding", "[idea]")
{
    for (const StrainLaw law : {StrainLaw::linear, StrainLaw::corotational, StrainLaw::neo_hookean}) {
        patch_test(shaken(rectangle_mesh({0, 0}, {1, 1}, 4, 4), 0.08), law);
        patch_test(shaken(block_mesh({0, 0, 0}, {1, 1, 1}, 3, 3, 3), 0.08), law);
    }
    patch_test(quadratic(shaken(rectangle_mesh({0, 0}, {1, 1}, 3, 3), 0.08)), StrainLaw::linear);
    patch_test(quadratic(shaken(block_mesh({0, 0, 0}, {1, 1, 1}, 2, 2, 2), 0.08)), StrainLaw::neo_hookean);
}

TEST_CASE("a triangle with equal sides in a sheet of ν = 1/3 is three springs", "[idea]")
{
    const ElasticMesh<2> mesh = lattice_mesh(1, 2, 2);
    const ElasticModel<2> model(
        mesh, {.young = 1, .poisson = 1.0 / 3, .law = StrainLaw::linear, .plane_stress = true});
    BlockMatrix<2> K, springs;
    K.reset(model.pattern()), springs.reset(model.pattern());
    model.add_stiffness(mesh.rest, 1, false, K);
    for (int e = 0; e < mesh.count(); ++e)
        for (const auto& [i, j] : edges_of_element<2>()) {
            const int a = mesh.node(e, i), b = mesh.node(e, j);
            const Vec2 n = mesh.at(b) - mesh.at(a);
            const Mat<2> k = spring_of_lattice(1) * n * n.transpose();  // (30.25)
            for (const auto& [p, q, sign] :
                 {std::tuple{a, a, 1}, {b, b, 1}, {std::max(a, b), std::min(a, b), -1}})
                for (int r = 0; r < 4; ++r)
                    springs.block(model.pattern().slot(p, q))[r] += sign * k(r / 2, r % 2);
        }
    for (std::size_t i = 0; i < K.value.size(); ++i)
        CHECK(K.value[i] == Approx(springs.value[i]).margin(1e-15));  // sums of numbers below one
}

TEST_CASE("turns and stretches of any matrix make it again and the turn is one", "[idea]")
{
    Random random(11);
    const auto check = [&random](auto F) {
        constexpr int Dim = decltype(F)::RowsAtCompileTime;
        for (int n = 0; n < 300; ++n) {
            for (Index i = 0; i < F.size(); ++i) F.data()[i] = random.uniform(-1, 1);
            if (n % 5 == 1) F.row(0) *= 1e-9;    // nearly flat
            if (n % 5 == 2) F.col(0).setZero();  // flat
            if (n % 5 == 3) F = F.col(0) * F.row(0);
            const Stretches<Dim> s = stretches_of<Dim>(F);
            CHECK((s.U * s.sigma.asDiagonal() * s.V.transpose() - F).norm() <
                  1e-14);  // a few ulp of numbers below 2
            CHECK((s.U * s.U.transpose() - Mat<Dim>::Identity()).norm() < 1e-14);
            CHECK(s.U.determinant() == Approx(1).epsilon(1e-14));
            CHECK(s.V.determinant() == Approx(1).epsilon(1e-14));
            int negative = 0;
            for (int i = 0; i < Dim; ++i) negative += s.sigma[i] < -1e-14;
            CHECK(negative <= 1);
        }
    };
    check(Mat<2>());
    check(Mat<3>());
}

// ------------------------------------------------------------------------------ locking and its cure

TEST_CASE("a thin cantilever of linear triangles locks and one of quadratic triangles does not", "[idea]")
{
    // (30.15) is Timoshenko's beam; what is left at the clamp is 0.5 % at this height
    CHECK(sag_ratio(10, 1, 1, 0.1, 0) < 0.45);
    CHECK(sag_ratio(40, 4, 1, 0.1, 0) == Approx(0.842).margin(0.001));  // as Figure 30.2 has it
    CHECK(sag_ratio(10, 1, 2, 0.1, 0) == Approx(1).margin(0.01));
    CHECK(sag_ratio(20, 2, 2, 0.1, 0) == Approx(1).margin(0.006));
    // thinner, with as many elements: worse
    CHECK(sag_ratio(10, 1, 1, 0.01, 0) < 0.01);
    CHECK(sag_ratio(10, 1, 2, 0.01, 0) == Approx(1).margin(0.01));
}

TEST_CASE(
    "as ν comes near a half triangles with parallel diagonals lock and alternate or quadratic ones do not",
    "[idea]")
{
    const Real nu = 0.4999;
    const Real parallel = sag_ratio(40, 4, 1, 0.1, nu, Diagonals::parallel),
               alternate = sag_ratio(40, 4, 1, 0.1, nu),
               quadratic = sag_ratio(20, 2, 2, 0.1, nu, Diagonals::parallel);
    INFO(parallel << ' ' << alternate << ' ' << quadratic);
    CHECK(parallel < 0.1);
    CHECK(alternate > 0.8);
    CHECK(quadratic > 0.9);
    CHECK(quadratic < 1.005);
}

TEST_CASE("the table of locking in section 30.H is what the meshes give", "[house]")
{
    constexpr Diagonals alternate = Diagonals::alternate, parallel = Diagonals::parallel;
    const struct {
        int order;
        Real nu;
        Diagonals diagonals;
        std::array<Real, 4> ratios;  // with 1, 2, 4 and 8 boxes through the height
    } lines[] = {{1, 0, alternate, {0.250, 0.570, 0.842, 0.955}},
                 {1, 0.4999, alternate, {0.292, 0.667, 0.859, 0.945}},
                 {1, 0.4999, parallel, {0.013, 0.013, 0.017, 0.029}},
                 {2, 0, alternate, {0.998, 1.000, 1.000, 1.000}},
                 {2, 0.4999, parallel, {0.840, 0.944, 0.972, 0.980}}};
    for (const auto& [order, nu, diagonals, ratios] : lines)
        for (int i = 0, n = 1; i < 4; ++i, n *= 2) {
            CAPTURE(order, nu, n);
            CHECK(sag_ratio(10 * n, n, order, 0.1, nu, diagonals) ==
                  Approx(ratios[static_cast<std::size_t>(i)]).margin(0.001));  // of the program's corner
        }
    CHECK(sag_ratio(10, 1, 1, 0.01, 0) == Approx(0.007).margin(0.0005));  // section 30.5
}

// ------------------------------------------------------------------------------------ closed forms

TEST_CASE("a block that is pulled to 1.5 is neo-Hooke's block", "[idea]")
{
    // one side held in x, the other moved; the rest is free: the same F everywhere
    ElasticMesh<3> mesh = block_mesh({0, 0, 0}, {1, 1, 1}, 2, 2, 2);
    const ElasticMaterial rubber{.young = 1e5, .poisson = 0.4, .law = StrainLaw::neo_hookean};
    ElasticBody<3> body(mesh, rubber);
    const Real stretch = 1.5;
    for (int i = 0; i < mesh.nodes(); ++i)
        for (int c = 0; c < 3; ++c) {
            const Real at = mesh.at(i)[c];
            const bool side = c == 0 && at > 1 - 1e-9;
            if (at < 1e-9 || side) body.fixed[static_cast<std::size_t>(3 * i + c)] = 1;
            if (side) body.x[3 * i] = stretch;
        }
    ElasticSolver<3> solver;
    solver.settings.tolerance = 1e-13;
    solver.rest(body);
    REQUIRE(solver.report.status == Status::solved);
    const PulledBlock known = pulled_block(lame_of(rubber, 3), stretch);  // (30.20)
    for (int p = 0; p < body.model.points(); ++p) {
        Real density = 0;
        const Mat<3> F = body.model.deformation(body.x, p), P = body.model.stress(F, density);
        CHECK(F(1, 1) == Approx(known.across).epsilon(1e-10));  // as Newton's tolerance leaves it
        CHECK(F(2, 2) == Approx(known.across).epsilon(1e-10));
        CHECK(P(0, 0) == Approx(known.stress).epsilon(1e-10));
        CHECK(std::abs(P(1, 1)) < 1e-9 * known.stress);
    }
}

TEST_CASE("a thick ring under pressure is Lamé's and its error falls as h² and h³", "[idea]")
{
    for (const int order : {1, 2}) {
        std::vector<Real> errors;
        for (const int n : {4, 8, 16}) {
            ElasticMesh<2> mesh = ring_mesh(1, 2, n, 2 * n);
            if (order == 2) mesh = quadratic(mesh);
            const ElasticMaterial steel{.young = 2, .poisson = 0.25, .law = StrainLaw::linear};
            ElasticBody<2> body(mesh, steel);
            for (const int i : surface_nodes(mesh)) {  // the exact displacement all around
                body.hold(i);
                const Real r = mesh.at(i).norm();
                body.x.segment<2>(2 * i) *= 1 + ring_displacement(steel, 1, 2, 1, r) / r;
            }
            ElasticSolver<2> solver;
            solver.rest(body);
            REQUIRE(solver.report.status == Status::solved);
            Real sum = 0, whole = 0;
            for (int i = 0; i < mesh.nodes(); ++i) {
                const Real r = mesh.at(i).norm();
                const Vec2 exact = mesh.at(i) * (ring_displacement(steel, 1, 2, 1, r) / r);
                sum += (body.at(i) - mesh.at(i) - exact).squaredNorm(), whole += exact.squaredNorm();
            }
            errors.push_back(std::sqrt(sum / whole));
        }
        INFO(errors[0] << ' ' << errors[1] << ' ' << errors[2]);
        if (order == 1) CHECK(order_of(errors) == Approx(2).margin(0.15));
        else CHECK(order_of(errors) > 2.85);  // at nodes it may be better than h³
    }
}

TEST_CASE("a hole in a plate that is pulled has three times the stress at its rim", "[idea]")
{
    std::vector<Real> errors;
    for (const int n : {6, 12, 24}) {
        const ElasticMesh<2> mesh = quadratic(ring_mesh(1, 5, n, 2 * n, std::pow(4.0, 1.0 / n)));
        const ElasticMaterial sheet{
            .young = 1, .poisson = 0.3, .law = StrainLaw::linear, .plane_stress = true};
        ElasticBody<2> body(mesh, sheet);
        for (int i = 0; i < mesh.nodes(); ++i) {
            if (mesh.at(i).x() < 1e-9) body.fixed[static_cast<std::size_t>(2 * i)] = 1;
            if (mesh.at(i).y() < 1e-9) body.fixed[static_cast<std::size_t>(2 * i + 1)] = 1;
            if (mesh.at(i).norm() > 4.9) {  // what Kirsch has far out, given
                body.hold(i);
                body.x.segment<2>(2 * i) += hole_displacement(sheet, 1, 1, mesh.at(i));
            }
        }
        ElasticSolver<2> solver;
        solver.rest(body);
        REQUIRE(solver.report.status == Status::solved);
        // σ_xx at the top of the hole, where the points of integration reach it
        Real best = infinity, stress = 0;
        for (int p = 0; p < body.model.points(); ++p) {
            const Real far = (body.model.place(p) - Vec2(0, 1)).norm();
            Real density = 0;
            if (far < best)
                best = far, stress = body.model.stress(body.model.deformation(body.x, p), density)(0, 0);
        }
        errors.push_back(std::abs(stress - 3));
    }
    INFO(errors[0] << ' ' << errors[1] << ' ' << errors[2]);
    // the nearest point is a part of an element away, and σ falls by 7 over a radius
    CHECK(errors.back() < 0.15);
    CHECK(order_of(errors) > 0.8);
}

// --------------------------------------------------------------------------------------- solvers

TEST_CASE("the factor and conjugate gradients give one answer and say what cannot be solved", "[house]")
{
    const ElasticMesh<3> mesh = block_mesh({0, 0, 0}, {2, 2, 3}, 3, 3, 5);
    const ElasticModel<3> model(mesh, unit_material(StrainLaw::neo_hookean));
    BlockMatrix<3> A;
    A.reset(model.pattern());
    model.add_stiffness(mesh.rest, 1, true, A);
    BlockLdlt<3> ldlt;
    ldlt.analyse(model.pattern());
    // without supports K has no inverse; rounding may make the last pivot a tiny number of either sign
    model.add_mass(-1e-3, A);
    CHECK(!ldlt.factor(A));
    model.add_mass(0.1, A);
    REQUIRE(ldlt.factor(A));
    Random random(2);
    VecX b(mesh.rest.size()), y, left;
    for (Index i = 0; i < b.size(); ++i) b[i] = random.uniform(-1, 1);
    VecX x = b;
    ldlt.solve(x);
    A.multiply(x, left);
    CHECK((left - b).norm() < 1e-12 * b.norm());  // condition 1e3 times rounding
    ConjugateGradients cg;
    cg.tolerance = 1e-12;
    CHECK(cg.solve(A, b, y));
    CHECK((x - y).norm() < 1e-9 * x.norm());  // the tolerance times the condition
    cg.most = 3;
    CHECK(!cg.solve(A, b, y));
}

TEST_CASE("what is inside out comes back", "[idea]")
{
    for (const StrainLaw law : {StrainLaw::corotational, StrainLaw::neo_hookean}) {
        ElasticBody<3> body(block_mesh({0, 0, 0}, {1, 1, 1}, 2, 2, 2), {.law = law});
        Random random(4);
        for (Index i = 0; i < body.x.size(); ++i) body.x[i] = random.uniform(0, 1);
        for (const int at : {0, 1, 2, 7, 8, 20})  // of three corners, as many as a body that is free needs
            body.fixed[static_cast<std::size_t>(at)] = 1, body.x[at] = body.model.mesh().rest[at];
        ElasticSolver<3> solver;
        solver.settings.most = 300;
        solver.rest(body);
        CHECK(solver.report.status == Status::solved);
        // at rest, maybe turned: a strain of the tolerance, squared
        CHECK(body.elastic_energy() < 1e-12 * body.model.material().young);
        for (int p = 0; p < body.model.points(); ++p)
            CHECK(body.model.deformation(body.x, p).determinant() == Approx(1).epsilon(1e-6));
    }
}

TEST_CASE("a load on an edge is the whole of it for quadratic meshes that were joined", "[house]")
{
    // corners of the second mesh have higher numbers than the middle nodes of the first
    const ElasticMesh<2> left = rectangle_mesh({0, 0}, {1, 1}, 2, 2),
                         right = rectangle_mesh({2, 0}, {1, 1}, 2, 2);
    const auto loaded = [](const ElasticMesh<2>& mesh) {
        ElasticBody<2> body(mesh, {});
        add_edge_load(body, [](const Vec2& p) { return p.y() > 1 - 1e-9; }, {0, -3});
        return body;
    };
    const ElasticBody<2> both = loaded(joined(quadratic(left), quadratic(right))),
                         one = loaded(quadratic(left));
    CHECK(both.load.head(one.load.size()) == one.load);  // of a mesh, whatever stands beside it
    Real sum = 0;
    for (int i = 0; i < both.model.nodes(); ++i) sum += both.load[2 * i + 1];
    CHECK(sum == Approx(-3 * 2).epsilon(1e-14));  // 3 N/m on 2 m
}

TEST_CASE("bad meshes and materials are refused by a sentence", "[house]")
{
    CHECK(sentence_of([] { bar_mesh(1, -5); }) == "the elements of a mesh are -5; there must be 1 or more");
    CHECK(sentence_of([] {
              rectangle_mesh({0, 0}, {1, 1}, 3, 0);
          }) == "the boxes along y of a mesh are 0; there must be 1 or more");
    CHECK(sentence_of([] { ring_mesh(1, 2, 0, 3); }) ==
          "the layers of a mesh are 0; there must be 1 or more");
    CHECK(sentence_of([] {
              disc_mesh({0, 0}, 1, 0);
          }) == "the rings of a mesh are 0; there must be 1 or more");
    CHECK(sentence_of([] { lattice_mesh(1, 1, 3); }) ==
          "the columns of a mesh are 1; there must be 2 or more");
    CHECK(sentence_of([] {
              block_mesh({0, 0, 0}, {1, 1, 1}, 2, 2, -1);
          }) == "the boxes along z of a mesh are -1; there must be 1 or more");
    CHECK(sentence_of([] {
              ball_mesh({0, 0, 0}, 1, 0, 0);
          }) == "the shells of a mesh are 0; there must be 1 or more");
    CHECK(sentence_of([] {
              ball_mesh({0, 0, 0}, 1, -1, 1);
          }) == "the quarterings of a mesh are -1; there must be 0 or more");
    const auto material = [](ElasticMaterial m) { return sentence_of([m] { require_valid(m); }); };
    CHECK(material({.poisson = 0.5}) == "Poisson's ratio is 0.5; it must be above -1 and below 1/2");
    CHECK(material({.poisson = -1}) == "Poisson's ratio is -1; it must be above -1 and below 1/2");
    CHECK(material({.young = -3}) == "Young's modulus is -3 Pa; it must be positive and finite");
    CHECK(material({.density = 0}) == "the density is 0 kg/m³; it must be positive and finite");
    const auto mesh = [](auto change) {
        ElasticMesh<2> m = one_triangle();
        change(m);
        return sentence_of([&m] { ElasticModel<2>(m, {}); });
    };
    CHECK(mesh([](auto&) {}) == "accepted");
    CHECK(mesh([](auto& m) {
              m.elements = {0, 2, 1};
          }) == "element 0 is inverted: its measure is -0.5 where its longest edge is 1.4142135623730951 m; "
                "number its nodes "
                "counterclockwise, and move them apart");
    CHECK(mesh([](auto& m) { m.rest[5] = 0, m.rest[4] = 0.5; }) ==
          "element 0 is flat: its measure is 0 where its longest edge is 1 m; number its nodes "
          "counterclockwise, and move "
          "them apart");
    CHECK(mesh([](auto& m) { m.rest.conservativeResize(8), m.rest.tail(2).setOnes(); }) ==
          "node 3 is loose: it must belong to an element");
    CHECK(mesh([](auto& m) { m.elements[2] = 7; }) == "element 0 has the node 7; there are 3");
    CHECK(sentence_of([] {
              ElasticMesh<2> m = quadratic(one_triangle());
              m.rest[2 * m.node(0, 4)] += 0.25;
              ElasticModel<2>(m, {});
          }) == "node 4 of element 0 is 0.25 m from the middle of its edge; it must be there");
    CHECK(mesh([](auto& m) { m.rest[1] = NAN; }) == "rest[1] is nan; it must be a finite number");
    CHECK(sentence_of([] { edge_length(ElasticMesh<2>{}); }) == "a mesh has no element 0; it has 0");
    CHECK(sentence_of([] { measure_of(one_triangle(), 1); }) == "a mesh has no element 1; it has 1");
    ElasticMesh<2> torn = one_triangle();
    torn.elements[2] = 7;
    CHECK(sentence_of([&torn] { quadratic(torn); }) == "element 0 has the node 7; there are 3");
    CHECK(sentence_of([&torn] { edge_length(torn); }) == "element 0 has the node 7; there are 3");
}
