/// What must be the same from each compiler and on each system, each as one number of all its bits: elementary functions,
/// long sums, and worlds that go on for many steps. tests/same_bits/table.py sets the numbers side by side.
///
///     same_bits [STEPS]      10000 steps each, twice at once in two threads where there are any

#include "chapters/19_engine/bytes.hpp"
#include "chapters/19_engine/moving_worlds.hpp"
#include "common/elementary.hpp"
#include "common/random.hpp"

#include <Eigen/Cholesky>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>
#ifndef __EMSCRIPTEN__
#include <thread>
#endif

namespace rigid {
namespace {

struct Line {
    std::string name;
    std::uint64_t hash;
};

std::uint64_t hash_of_numbers(const Real* begin, Index count)
{
    return hash_of({reinterpret_cast<const char*>(begin), sizeof(Real) * static_cast<std::size_t>(count)});
}

std::uint64_t hash_of_functions()
{
    Random random(1);
    std::vector<Real> results;
    for (int i = 0; i < 20000; ++i) {
        const Real x = random.uniform(-10, 10), y = random.uniform(-10, 10), far = 1e9 * x * x * x;
        for (const Real value :
             {sin(x), cos(y), sin(far), cos(far), tan(x), atan2(y, x), asin(0.1 * x), exp(x), expm1(0.1 * y),
              log(std::abs(x)), log1p(std::abs(y)), pow(std::abs(x), y), hypot(x, y), random.normal()})
            results.push_back(value);
    }
    return hash_of_numbers(results.data(), static_cast<Index>(results.size()));
}

MatX random_matrix(Random& random, Index rows, Index columns)
{
    MatX made(rows, columns);
    for (Index j = 0; j < columns; ++j)
        for (Index i = 0; i < rows; ++i) made(i, j) = random.uniform(-1, 1);
    return made;
}

/// Of lengths that no number of lanes divides, and beyond the length at which Eigen begins a new block.
std::uint64_t hash_of_sums()
{
    Random random(2);
    std::vector<Real> results;
    for (const Index n : {2, 3, 5, 17, 100, 301, 1301}) {
        const MatX A = random_matrix(random, 7, n), B = random_matrix(random, n, 9);
        const MatX product = A * B;
        const VecX v = random_matrix(random, n, 1), w = A * v;
        results.insert(results.end(), product.data(), product.data() + product.size());
        results.insert(results.end(), w.data(), w.data() + w.size());
        results.insert(results.end(), {v.sum(), v.norm(), v.dot(B.col(3)), v.tail(n - 1).squaredNorm()});
        if (n > 400) continue;
        const MatX square = random_matrix(random, n, n);
        const MatX positive = square * square.transpose() + MatX::Identity(n, n);
        const VecX x = positive.llt().solve(v);
        results.insert(results.end(), x.data(), x.data() + x.size());
    }
    return hash_of_numbers(results.data(), static_cast<Index>(results.size()));
}

/// Of the positions and velocities after each hundredth step.
template <class EachStep>
std::uint64_t hash_of_run(World world, int steps, EachStep&& before)
{
    std::vector<Real> hashes;
    std::string bytes;
    for (int n = 0; n < steps; ++n) {
        before(world);
        world.step(1.0 / 60);
        if ((n + 1) % 100 == 0) bytes += std::to_string(world.hash()) + ' ';
    }
    return hash_of(bytes);
}

std::vector<Line> all_lines(int steps)
{
    const auto nothing = [](World&) {};
    return {
        {"functions", hash_of_functions()},
        {"sums", hash_of_sums()},
        {"tumbler",
         hash_of_run(tumbler_world(16, 0.5), steps, [](World& w) { turn_tumbler(w, 0.5, 1.0 / 60); })},
        {"doll", hash_of_run(dolls_world(1), steps, nothing)},
        {"rubble", hash_of_run(rubble_world(12, 1), steps, nothing)},
        {"chain", hash_of_run(chain_world(20, 1000), steps, nothing)},
    };
}

}  // namespace
}  // namespace rigid

int main(int count, char** arguments)
{
    using namespace rigid;
    const int steps = count > 1 ? std::atoi(arguments[1]) : 10000;
    std::vector<Line> lines, beside;
#ifndef __EMSCRIPTEN__
    std::thread other([&] { beside = all_lines(steps); });
    lines = all_lines(steps);
    other.join();
#else
    lines = beside = all_lines(steps);
#endif
    for (std::size_t i = 0; i < lines.size(); ++i) {
        if (lines[i].hash != beside[i].hash)
            std::printf("%s differs in another thread\n", lines[i].name.c_str());
        std::printf("%s %016llx\n", lines[i].name.c_str(), static_cast<unsigned long long>(lines[i].hash));
    }
    return 0;
}
