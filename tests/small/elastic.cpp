/// The small program of chapter 30, bodies of triangles, beside the library.

#include "tests/small/alone.hpp"

#include "chapters/30_elastic_bodies/elastic_solver.hpp"
#include "tests/catch.hpp"

#include <Eigen/SparseCholesky>

#define main small_main
namespace small30 {
#include "chapters/30_elastic_bodies/small.cpp"
}
#undef main

using namespace rigid;

TEST_CASE("the small program of chapter 30 has the triangle of the text")
{
    small30::Soft one{VecX(6), {}, VecX::Zero(6), {{{0, 1, 2}}}, 1, 1, 1, {}, true, 0};
    one.rest << 0, 0, 1, 0, 0, 1;
    one.x = one.rest;
    one.x[2] += 0.1;
    VecX f = VecX::Zero(6);
    small30::Entries K;
    CHECK(small30::elastic(one, f, 1, K) == Approx(0.0075).epsilon(1e-13));
    CHECK((f - VecX{{0.15, 0.05, -0.15, 0, 0, -0.05}}).norm() < 1e-15);
    CHECK(K[0].value() == Approx(2).epsilon(1e-14));
    CHECK(K[1].value() == Approx(1).epsilon(1e-14));
}

TEST_CASE("the small program of chapter 30 lets a strip fall as the library does")
{
    for (const bool linear : {true, false}) {
        small30::Soft s = small30::strip(linear);
        ElasticMesh<2> mesh;
        mesh.rest = s.rest;
        for (const auto& triangle : s.triangles)
            mesh.elements.insert(mesh.elements.end(), triangle.begin(), triangle.end());
        // λ = 0 and μ = 1 MPa: ν = 0 and E = 2 μ
        ElasticBody<2> body(
            mesh, {.young = 2e6, .poisson = 0, .law = linear ? StrainLaw::linear : StrainLaw::corotational});
        for (int i = 0; i < mesh.nodes(); ++i)
            if (s.held[static_cast<std::size_t>(i)]) body.hold(i);
        body.gravity = {0, -s.g};
        ElasticSolver<2> solver;
        solver.settings.tolerance = 1e-14;
        for (int n = 0; n < 10; ++n) {
            small30::step(s, 1.0 / 60);
            solver.step(body, 1.0 / 60);
        }
        CHECK((s.x - mesh.rest).norm() > 1);  // it has moved
        // rounding of 1e-16 over the softest way of the strip, h² K/M of 1e4 here, ten times
        CHECK((s.x - body.x).cwiseAbs().maxCoeff() < 1e-10);
    }
}
