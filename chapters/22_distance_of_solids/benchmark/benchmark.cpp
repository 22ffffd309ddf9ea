/// Chapter 22: what the distance of two solids costs.
///
///     apart/N       the nearest points of two hulls of N corners, a metre apart
///     faces/N, edges/N    the best face and the best pair of edges of the same two where they overlap; products n·p of it
///     boxes         the best face and the best pair of edges of two boxes

#include "chapters/22_distance_of_solids/convex_hull.hpp"
#include "chapters/22_distance_of_solids/gjk.hpp"
#include "chapters/22_distance_of_solids/separating_axes.hpp"
#include "common/random.hpp"

#include <benchmark/benchmark.h>

using namespace rigid;

namespace {

/// Two solids, the second at a place and turned a little.
struct Pair {
    SolidForm form_a, form_b;
    PlacedSolid a, b;

    Pair(const Hull& hull_a, const Hull& hull_b, const Vec3& at)
        : form_a(form_of(hull_a)), form_b(form_of(hull_b))
    {
        a.place(form_a, {0, 0, 0}, Mat3::Identity());
        b.place(form_b, at, rotation_matrix({0.3, 0.2, 0.1}));
    }
    Pair(const Pair&) = delete;  // what is placed points to its form
    Pair& operator=(const Pair&) = delete;
};

/// Corners on a ball of 1 m.
Hull some_hull(Random& random, int corners)
{
    std::vector<Vec3> points;
    for (int k = 0; k < corners; ++k) {
        const Real x = random.uniform(-1, 1), y = random.uniform(-1, 1),
                   z = random.uniform(-1, 1);
        points.push_back(Vec3(x, y, z).normalized());
    }
    return solid_hull(points);
}

Hull first_hull(int corners)
{
    Random random(1);
    return some_hull(random, corners);
}

Hull second_hull(int corners)
{
    Random random(2);
    return some_hull(random, corners);
}

void apart(benchmark::State& state)
{
    const auto corners = static_cast<int>(state.range(0));
    const Pair pair(first_hull(corners), second_hull(corners), {3, 0.3, 0.2});
    for (auto _ : state)
        benchmark::DoNotOptimize(nearest_points(pair.a, pair.b).distance);
}

void faces(benchmark::State& state)
{
    const auto corners = static_cast<int>(state.range(0));
    const Pair pair(first_hull(corners), second_hull(corners), {1, 0.3, 0.2});
    for (auto _ : state)
        benchmark::DoNotOptimize(best_face(pair.a, pair.b, 0).separation);
}

void edges(benchmark::State& state)
{
    const auto corners = static_cast<int>(state.range(0));
    const Pair pair(first_hull(corners), second_hull(corners), {1, 0.3, 0.2});
    for (auto _ : state)
        benchmark::DoNotOptimize(best_across_edges(pair.a, pair.b).separation);
    state.counters["products"] =
        static_cast<Real>(pair.a.directions.size() * pair.b.directions.size() *
                          (pair.a.vertices.size() + pair.b.vertices.size()));
}

void boxes(benchmark::State& state)
{
    const Pair pair(solid_box({1, 1, 1}), solid_box({1, 1, 1}), {0.8, 0.3, 0.2});
    for (auto _ : state) {
        benchmark::DoNotOptimize(best_face(pair.a, pair.b, 0).separation);
        benchmark::DoNotOptimize(best_across_edges(pair.a, pair.b).separation);
    }
}

}  // namespace

BENCHMARK(apart)->Arg(8)->Arg(12)->Arg(24)->Arg(48);
BENCHMARK(faces)->Arg(8)->Arg(12)->Arg(24)->Arg(48);
BENCHMARK(edges)->Arg(8)->Arg(12)->Arg(24)->Arg(48);
BENCHMARK(boxes);

BENCHMARK_MAIN();
