/// The small program of chapter 14, pins by sweeps and by a tree, beside the library's factor of trees.

#include "tests/small/alone.hpp"

#include "chapters/02_velocity_constraints/constraints.hpp"
#include "chapters/14_joints/joint_factor.hpp"
#include "tests/catch.hpp"

#define main small_main
namespace small14 {
#include "chapters/14_joints/small.cpp"
}
#undef main

using namespace rigid;

namespace {

small14::Bodies loaded_chain(Real ratio)
{
    small14::Bodies d;
    for (int k = 0; k < 50; ++k) small14::add_rod(d, 0.1, 0.1, -7 * pi / 18);
    d.inverse_mass.tail<3>() /= ratio;
    return d;
}

/// The pins of a small program as rows of the library, with b = C/h.
std::vector<Row<3>> library_rows(const small14::Bodies& d, Real h)
{
    std::vector<Row<3>> rows;
    for (std::size_t k = 0; k < d.pins.size(); ++k)
        for (const int i : {0, 1}) {
            Constraint<3> c;
            c.a = d.pins[k].parent < 0 ? world : d.pins[k].parent;
            c.b = static_cast<Index>(k);
            c.C = d.pins[k].C[i];
            if (c.a != world) c.Ja = d.pins[k].Jp.row(i);
            c.Jb = d.pins[k].J.row(i);
            rows.push_back(bilateral(c, d.inverse_mass, c.C / h));
        }
    return rows;
}

}  // namespace

TEST_CASE("the small program of chapter 14 has the numbers of the text and the library's to 1e-12")
{
    // By hand, (14.2); and with the second joint locked by limits one rod of 2 m, which starts with 3/4 g.
    for (const bool locked : {false, true}) {
        small14::Bodies d{{}, {}, {}, {}, 1};
        for (int k = 0; k < 2; ++k) small14::add_rod(d, 1, 1, 0);
        if (locked) d.pins[1].lower = d.pins[1].upper = 0;
        small14::step(d, 1, 0);
        CHECK(d.pins[0].lambda[1] == Approx(locked ? 1.0 / 2 : 2.0 / 7).epsilon(1e-12));
        CHECK(d.pins[1].lambda[1] == Approx(locked ? -1.0 / 8 : -1.0 / 14).epsilon(1e-12));
        CHECK(d.u[2] == Approx(locked ? -3.0 / 4 : -9.0 / 7).epsilon(1e-12));
        CHECK(d.u[5] == Approx(locked ? -3.0 / 4 : 3.0 / 7).epsilon(1e-12));
    }
    // The tree of each of 100 steps, by the library's factor.
    small14::Bodies d = loaded_chain(100);
    JointFactor factor;
    const Real h = 1.0 / 240;
    Real farthest = 0, fastest = 0;
    for (int n = 0; n < 100; ++n) {
        small14::Bodies before = d;
        for (int k = 1; k < before.u.size(); k += 3) before.u[k] -= before.g * h;
        small14::find_rows(before);
        const std::vector<Row<3>> rows = library_rows(before, h);
        VecX u = before.u, lambda(Index(rows.size()));
        factor.factor(rows, before.inverse_mass);
        VecX b(Index(rows.size()));
        for (std::size_t i = 0; i < rows.size(); ++i) b[Index(i)] = rows[i].bias;
        factor.solve(rows, b, u, lambda);
        small14::step(d, h, 0);
        farthest = std::max(farthest, (d.u - u).cwiseAbs().maxCoeff());
        fastest = std::max(fastest, d.u.cwiseAbs().maxCoeff());
    }
    // Entries of 1/m cancel down to those of the load, a hundredth of them: two digits of the sixteen (14.G).
    CHECK(farthest < 1e-12 * fastest);
}

TEST_CASE("the small program of chapter 14 solves at once what its sweeps only approach")
{
    small14::Bodies tree = loaded_chain(1), sweeps = tree;
    small14::step(tree, 1.0 / 240, 0);
    small14::step(sweeps, 1.0 / 240, 40000);
    CHECK((tree.u - sweeps.u).cwiseAbs().maxCoeff() < 1e-10);  // by (4.14) 0.999 a sweep leaves e^-40
    // Section 14.3: ten sweeps a step let a chain with a heavy end come apart.
    Real gap[2] = {0, 0};
    for (const int way : {0, 1}) {
        small14::Bodies d = loaded_chain(100);
        for (int n = 0; n < 240; ++n) {
            small14::step(d, 1.0 / 240, way == 0 ? 10 : 0);
            small14::find_rows(d);
            for (const small14::Pin& pin : d.pins) gap[way] = std::max(gap[way], pin.C.norm());
        }
    }
    CHECK(gap[0] > 0.02);
    CHECK(gap[1] < 2e-6);
}
