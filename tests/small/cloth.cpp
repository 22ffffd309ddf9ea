/// The small program of chapter 27, a cloth by four kinds of passes, beside the library.

#include <memory>
#include <string>

#include <Eigen/SparseCholesky>

#include "tests/small/alone.hpp"

#include "chapters/27_particles_and_cloth/cloth_step.hpp"
#include "tests/catch.hpp"

#define main small_main
namespace small27 {
#include "chapters/27_particles_and_cloth/small.cpp"
}
#undef main

using namespace rigid;

namespace {

/// The library's cloth of the small program's.
ClothScene library_cloth(const small27::Cloth& c)
{
    ClothScene out;
    out.bodies.resize(c.x.size() / 3);
    out.bodies.x = c.x, out.bodies.u = c.u, out.bodies.inverse_mass = c.inverse_mass;
    out.gravity = {0, -c.g, 0};
    for (const small27::Spring& s : c.springs) out.springs.push_back({s.a, s.b, s.length, s.k});
    return out;
}

}  // namespace

TEST_CASE("the small program of chapter 27 makes the passes of the library")
{
    struct Pair {
        const char* name;
        ClothMethod method;
        int passes;
        Real tolerance;
    };
    for (const Pair& pair :
         {Pair{"rows", ClothMethod::xpbd, 4, 1e-12}, Pair{"one matrix", ClothMethod::projective, 4, 1e-10},
          Pair{"explicit", ClothMethod::explicit_euler, 0, 1e-12},
          Pair{"all together", ClothMethod::newton, 30, 1e-9}}) {  // both to the end
        const bool stiff = pair.method != ClothMethod::explicit_euler;
        small27::Cloth small = small27::sheet(6, stiff ? 500 : 5);
        ClothScene cloth = library_cloth(small);
        ClothMemory memory;
        ClothSettings how;
        how.method = pair.method, how.sweeps = pair.passes;
        for (int n = 0; n < 20; ++n) {
            small27::step(small, 1.0 / 60, pair.name, pair.passes);
            step(cloth, how, memory);
        }
        CAPTURE(pair.name);
        CHECK((small.x - cloth.bodies.x).cwiseAbs().maxCoeff() < pair.tolerance);
        CHECK(small.x.minCoeff() < -0.05);  // it has come down
    }
}

TEST_CASE("the small program of chapter 27 has the numbers of the text")
{
    const auto is = [](const std::string& method, int passes, Real first, Real second) {
        small27::Cloth c = small27::chain(2, 100);
        c.g = 10;
        small27::step(c, 0.1, method, passes);
        CAPTURE(method, passes);
        CHECK(-c.x[4] - 1 == Approx(first).margin(1e-14));
        CHECK(-c.x[7] - 2 == Approx(second).margin(1e-14));
    };
    is("explicit", 0, 0.1, 0.1);
    is("rows", 1, 1.0 / 15, 1.0 / 12);
    is("rows", 2, 11.0 / 180, 29.0 / 360);
    is("particles", 1, 1.0 / 15, 1.0 / 12);
    is("particles", 2, 11.0 / 180, 29.0 / 360);
    is("one matrix", 1, 0.06, 0.08);
    is("all together", 1, 0.06, 0.08);
}
