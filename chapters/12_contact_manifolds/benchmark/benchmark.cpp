/// Chapter 12: manifolds beside those of two engines, and which pairs are looked at.
///
///     manifold/WHO        pairs of boxes that overlap a little, at random poses: time a pair; the largest error of the
///                         deepest gap [m], and points a pair. book: collide() of shapes that are placed; book_and_place:
///                         with the vertices of both moved to the world, as Box2D does in its function. Box2D computes in
///                         floats and with a skin of its own, which is left out of the gap. Chipmunk keeps its shapes
///                         placed; that of Debian warns of some pairs, and its time has these lines in it.
///                         The gap is held against collide() without a margin, which the tests hold to 1e-9
///     pairs/SCENE/WHO/K   one step of K boxes that move: boxes compared (counted; of the grid also the cells that
///                         were looked into), pairs found, and the time

#include "chapters/12_contact_manifolds/manifold.hpp"
#include "chapters/12_contact_manifolds/pair_finder.hpp"
#include "common/random.hpp"

#include <benchmark/benchmark.h>
#ifdef RIGID_HAS_BOX2D
#include <box2d/box2d.h>
#endif
#ifdef RIGID_HAS_CHIPMUNK
#include <chipmunk/chipmunk.h>
#endif

#include <string>

using namespace rigid;

namespace {

struct BoxPair {
    Vec2 size_a, size_b;  ///< width and height [m]
    Vec<3> a, b;          ///< poses
    Real gap = 0;         ///< deepest [m]
};

/// Boxes of 0.5 m to 2 m that overlap by up to 5 cm.
const std::vector<BoxPair>& box_pairs()
{
    static const std::vector<BoxPair> pairs = [] {
        std::vector<BoxPair> found;
        Random random(1);
        while (found.size() < 1024) {
            BoxPair pair;
            for (Vec2* const size : {&pair.size_a, &pair.size_b})
                for (Index i = 0; i < 2; ++i) (*size)[i] = random.uniform(0.5, 2);
            for (Vec<3>* const at : {&pair.a, &pair.b})
                for (Index i = 0; i < 3; ++i) (*at)[i] = random.uniform(-1.5, 1.5);
            // half of them lie face on face, as in a stack
            if (found.size() % 2 == 0) pair.b[2] = pair.a[2];
            const PlacedShape a(box(pair.size_a.x(), pair.size_a.y()), pair.a),
                b(box(pair.size_b.x(), pair.size_b.y()), pair.b);
            pair.gap = collide(a.view(), b.view()).deepest();
            if (pair.gap < -1e-3 && pair.gap > -0.05) found.push_back(pair);
        }
        return found;
    }();
    return pairs;
}

void report(benchmark::State& state, Real error, Real points)
{
    const auto pairs = static_cast<double>(box_pairs().size());
    state.counters["gap_error"] = error;
    state.counters["points"] = points / pairs;
    state.counters["time_a_pair"] =
        benchmark::Counter(pairs, benchmark::Counter::kIsIterationInvariantRate |
                                      benchmark::Counter::kInvert);
}

void book(benchmark::State& state, bool with_place)
{
    std::vector<PlacedShape> a, b;
    std::vector<Polygon> shape_a, shape_b;
    for (const BoxPair& pair : box_pairs()) {
        shape_a.push_back(box(pair.size_a.x(), pair.size_a.y()));
        shape_b.push_back(box(pair.size_b.x(), pair.size_b.y()));
        a.emplace_back(shape_a.back(), pair.a);
        b.emplace_back(shape_b.back(), pair.b);
    }
    const ManifoldSettings how{0.02, 0.002, nullptr};
    for (auto _ : state)
        for (std::size_t i = 0; i < a.size(); ++i) {
            if (with_place) {
                a[i].move(shape_a[i], box_pairs()[i].a);
                b[i].move(shape_b[i], box_pairs()[i].b);
            }
            benchmark::DoNotOptimize(collide(a[i].view(), b[i].view(), how));
        }
    Real points = 0, error = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        const Manifold m = collide(a[i].view(), b[i].view(), how);
        points += m.count;
        error = std::max(error, std::abs(m.deepest() - box_pairs()[i].gap));
    }
    report(state, error, points);
}

#ifdef RIGID_HAS_BOX2D
void box2d(benchmark::State& state)
{
    std::vector<b2PolygonShape> a(box_pairs().size()), b(box_pairs().size());
    std::vector<b2Transform> at_a(a.size()), at_b(a.size());
    const auto number = [](Real x) { return static_cast<float>(x); };
    for (std::size_t i = 0; i < a.size(); ++i) {
        const BoxPair& pair = box_pairs()[i];
        a[i].SetAsBox(number(pair.size_a.x() / 2), number(pair.size_a.y() / 2));
        b[i].SetAsBox(number(pair.size_b.x() / 2), number(pair.size_b.y() / 2));
        at_a[i].Set({number(pair.a[0]), number(pair.a[1])}, number(pair.a[2]));
        at_b[i].Set({number(pair.b[0]), number(pair.b[1])}, number(pair.b[2]));
    }
    b2Manifold m;
    for (auto _ : state)
        for (std::size_t i = 0; i < a.size(); ++i) {
            b2CollidePolygons(&m, &a[i], at_a[i], &b[i], at_b[i]);
            benchmark::DoNotOptimize(m);
        }
    Real points = 0, error = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        b2CollidePolygons(&m, &a[i], at_a[i], &b[i], at_b[i]);
        b2WorldManifold there;
        there.Initialize(&m, at_a[i], 0, at_b[i], 0);
        Real gap = infinity;
        for (int k = 0; k < m.pointCount; ++k)
            gap = std::min(gap, static_cast<Real>(there.separations[k]));
        points += m.pointCount;
        error = std::max(error, std::abs(gap - box_pairs()[i].gap));
    }
    report(state, error, points);
}
#endif

#ifdef RIGID_HAS_CHIPMUNK
void chipmunk(benchmark::State& state)
{
    std::vector<cpBody*> bodies;
    std::vector<cpShape*> shapes;
    for (const BoxPair& pair : box_pairs())
        for (const bool second : {false, true}) {
            const Vec2& size = second ? pair.size_b : pair.size_a;
            const Vec<3>& at = second ? pair.b : pair.a;
            cpBody* const body = cpBodyNew(1, 1);
            cpBodySetPosition(body, cpv(at[0], at[1]));
            cpBodySetAngle(body, at[2]);
            bodies.push_back(body);
            shapes.push_back(cpBoxShapeNew(body, size.x(), size.y(), 0));
            cpShapeCacheBB(shapes.back());
        }
    for (auto _ : state)
        for (std::size_t i = 0; i < shapes.size(); i += 2)
            benchmark::DoNotOptimize(cpShapesCollide(shapes[i], shapes[i + 1]));
    Real points = 0, error = 0;
    for (std::size_t i = 0; i < shapes.size(); i += 2) {
        const cpContactPointSet set = cpShapesCollide(shapes[i], shapes[i + 1]);
        Real gap = infinity;
        for (int k = 0; k < set.count; ++k)
            gap = std::min(gap, static_cast<Real>(set.points[k].distance));
        points += set.count;
        error = std::max(error, std::abs(gap - box_pairs()[i / 2].gap));
    }
    report(state, error, points);
    for (cpShape* const shape : shapes) cpShapeFree(shape);
    for (cpBody* const body : bodies) cpBodyFree(body);
}
#endif

/// K boxes that drift: of one size on a square, of sizes from 0.1 m to 3 m, or in a column.
RigidScene drifting(const std::string& kind, int K)
{
    RigidScene scene;
    Random random(2);
    const Real side = std::sqrt(Real(K)) * 1.6;
    for (int k = 0; k < K; ++k) {
        const Real size =
            kind == "unequal" ? std::pow(10, random.uniform(-1, 0.5)) : 1;
        const Real x = random.uniform(0, 1), y = random.uniform(0, 1),
                   angle = random.uniform(0, 7);
        const Vec2 at = kind == "column" ? Vec2(4 * x, side * side / 4 * y)
                                         : Vec2(side * x, side * y);
        add_body(scene, box(size, size), Mass{1, {0, 0}, 1}, at, angle);
        for (Index i = 0; i < 3; ++i)
            scene.bodies.u[3 * k + i] = random.uniform(-1, 1);
    }
    return scene;
}

void pairs(benchmark::State& state, const std::string& kind, PairSearch search)
{
    RigidScene scene = drifting(kind, static_cast<int>(state.range(0)));
    PairFinder finder;
    finder.search = search;
    PlacedShapes placed;
    placed.move(scene);
    finder.find(scene, placed, 0.02);
    for (auto _ : state) {
        scene.bodies.x += 1.0 / 60 * scene.bodies.u;
        placed.move(scene);
        finder.find(scene, placed, 0.02);
        scene.bodies.x -= 1.0 / 60 * scene.bodies.u;
        placed.move(scene);
        finder.find(scene, placed, 0.02);
    }
    state.counters["compared"] = static_cast<double>(finder.tested);
    if (search == PairSearch::grid)
        state.counters["cells"] = static_cast<double>(finder.grid.cells);
    state.counters["pairs"] = static_cast<double>(finder.pairs.size());
}

}  // namespace

int main(int argc, char** argv)
{
    benchmark::RegisterBenchmark(
        "manifold/book", [](benchmark::State& state) { book(state, false); });
    benchmark::RegisterBenchmark(
        "manifold/book_and_place",
        [](benchmark::State& state) { book(state, true); });
#ifdef RIGID_HAS_BOX2D
    benchmark::RegisterBenchmark("manifold/box2d", box2d);
#endif
#ifdef RIGID_HAS_CHIPMUNK
    benchmark::RegisterBenchmark("manifold/chipmunk", chipmunk);
#endif
    for (const char* const kind : {"equal", "unequal", "column"})
        for (const PairSearch search :
             {PairSearch::sweep, PairSearch::tree, PairSearch::grid}) {
            const std::string name = std::string("pairs/") + kind +
                                     (search == PairSearch::sweep  ? "/sweep"
                                      : search == PairSearch::tree ? "/tree"
                                                                   : "/grid");
            benchmark::RegisterBenchmark(name.c_str(),
                                         [kind, search](benchmark::State& state) {
                                             pairs(state, kind, search);
                                         })
                ->RangeMultiplier(4)
                ->Range(64, 16384)
                ->Unit(benchmark::kMicrosecond);
        }
    benchmark::Initialize(&argc, argv);
    benchmark::RunSpecifiedBenchmarks();
}
