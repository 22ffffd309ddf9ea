// Chapter 25 in one file, grown from chapter 24: sweeps side by side.
// What moves no body in common can change places: the same order, the same bits.
//
//     level of a visit = 1 + the highest level so far of the bodies that it moves
#include <Eigen/Core>
#include <algorithm>
#include <cstdio>
#include <fstream>
#include <numeric>
#include <vector>
using Eigen::Vector3d;
using Vec = Eigen::VectorXd;

struct Row {
    int a, b;    // balls; b = -1: a wall
    Vector3d n;  // from b to a
    double bias, lambda = 0;
    int level = 0;
};

struct Balls {
    Vec x, u;  // three a ball; all of them 1 kg and of the radius 1/2
    double g = 9.81;
};

// (25.1): the level of each row, in the order of the sweep.
void find_levels(std::vector<Row>& rows, int balls)
{
    std::vector<int> highest(balls, 0);  // so far, of each ball
    for (Row& row : rows) {
        row.level = highest[row.a];
        if (row.b >= 0) row.level = std::max(row.level, highest[row.b]);
        highest[row.a] = ++row.level;
        if (row.b >= 0) highest[row.b] = row.level;
    }
}

// One visit, (6.2) to (6.5).
void visit(Row& row, Balls& d)
{
    auto ua = d.u.segment<3>(3 * row.a);
    double w = row.n.dot(ua) + row.bias;
    if (row.b >= 0) w -= row.n.dot(d.u.segment<3>(3 * row.b));
    const double A = row.b >= 0 ? 2 : 1;
    const double change = std::max(0.0, row.lambda - w / A) - row.lambda;
    row.lambda += change;
    ua += change * row.n;
    if (row.b >= 0) d.u.segment<3>(3 * row.b) -= change * row.n;
}

// Balls that touch, and the sides of a pit: |x| and |y| up to 1.6, the floor at 0.
std::vector<Row> find_rows(const Balls& d, double h)
{
    std::vector<Row> rows;
    const int K = d.x.size() / 3;
    const auto add = [&](int a, int b, const Vector3d& n, double gap) {
        if (gap < 0.02) rows.push_back({a, b, n, (gap < 0 ? 0.2 : 1) * gap / h});
    };
    for (int a = 0; a < K; ++a) {
        const Vector3d x = d.x.segment<3>(3 * a);
        add(a, -1, {0, 0, 1}, x.z() - 0.5);
        for (const int i : {0, 1})
            for (const int side : {-1, 1})
                add(a, -1, -side * Vector3d::Unit(i), 1.6 - side * x[i] - 0.5);
        for (int b = 0; b < a; ++b) {
            const Vector3d way = x - d.x.segment<3>(3 * b);
            add(a, b, way.normalized(), way.norm() - 1);
        }
    }
    return rows;
}

// A step. By levels the rows of one level are visited backwards: any order will do.
std::vector<Row> step(Balls& d, double h, int sweeps, bool by_levels)
{
    for (int k = 0; k < d.u.size() / 3; ++k)
        d.u[3 * k + 2] -= d.g * h;  // u*, (3.4)
    std::vector<Row> rows = find_rows(d, h);
    find_levels(rows, d.x.size() / 3);
    std::vector<int> order(rows.size());
    std::iota(order.begin(), order.end(), 0);
    if (by_levels)
        std::sort(order.begin(), order.end(), [&rows](int i, int j) {
            return rows[i].level != rows[j].level ? rows[i].level < rows[j].level
                                                  : i > j;
        });
    for (int n = 0; n < sweeps; ++n)
        for (const int i : order) visit(rows[i], d);
    d.x += h * d.u;  // (1.10)
    return rows;
}

// Layers of nine, a little beside each other.
Balls poured(int count)
{
    Balls d{Vec(3 * count), Vec::Zero(3 * count)};
    for (int k = 0; k < count; ++k)
        d.x.segment<3>(3 * k) << 1.05 * (k % 3 - 1) + 0.01 * (k % 5),
            1.05 * (k / 3 % 3 - 1) + 0.01 * (k % 7), 0.6 + 1.1 * (k / 9);
    return d;
}

// Five rows on four balls, of section 25.1.
std::vector<Row> five_rows()
{
    std::vector<Row> rows;
    for (const auto& [a, b] : {std::pair{0, -1}, {1, 0}, {2, -1}, {2, 1}, {3, -1}})
        rows.push_back({a, b, {0, 0, 1}, 0});
    find_levels(rows, 4);
    return rows;
}

int main(int count, char** word)
{
    const std::vector<Row> five = five_rows();
    for (std::size_t i = 0; i < five.size(); ++i)
        std::printf("row %zu: level %d\n", i + 1, five[i].level);
    // Both orders, of a hundred balls that are poured.
    Balls one_by_one = poured(100), side_by_side = one_by_one;
    std::vector<Row> rows;
    for (int n = 0; n < 240; ++n) {
        step(one_by_one, 1.0 / 120, 30, false);
        rows = step(side_by_side, 1.0 / 120, 30, true);
    }
    int levels = 0;
    for (const Row& row : rows) levels = std::max(levels, row.level);
    std::printf("%zu rows in %d levels; the same bits: %s\n", rows.size(), levels,
                one_by_one.x == side_by_side.x && one_by_one.u == side_by_side.u
                    ? "yes"
                    : "no");
    // The five rows in their order, and by levels.
    std::ofstream out(count < 2 ? "" : word[1]);
    out << "<svg xmlns='http://www.w3.org/2000/svg' width='560' "
           "stroke-width='0.06' "
           "stroke-linecap='round' viewBox='-0.8 -0.8 11.6 5.6'>\n";
    for (const double right : {0.0, 6.0})
        for (int k = 0; k < 4; ++k)
            out << "<path stroke='#808080' stroke-dasharray='0.06 0.14' d='M"
                << right + 1.3 * k << " -0.3V4.4'/>\n";
    for (std::size_t i = 0; i < five.size(); ++i)
        for (const bool by_levels : {false, true}) {
            const Row& row = five[i];
            const char* const colours[] = {"#4477AA", "#EE7733", "#CC3311"};
            const double y = by_levels ? 1.6 * (row.level - 1) + 0.4 : double(i);
            const double from =
                (by_levels ? 6 : 0) + 1.3 * (row.b < 0 ? row.a : row.b);
            const double to = (by_levels ? 6 : 0) + 1.3 * row.a;
            out << "<g stroke='" << colours[row.level - 1] << "' fill='"
                << colours[row.level - 1] << "'><path d='M" << from << ' ' << y
                << 'H' << to << "'/>";
            for (const double x : {from, to})
                out << "<circle cx='" << x << "' cy='" << y << "' r='0.16'/>";
            out << "<text stroke='none' font-family='sans-serif' font-size='0.42' "
                   "x='"
                << from - 0.55 << "' y='" << y + 0.15 << "'>" << i + 1
                << "</text></g>\n";
        }
    out << "</svg>\n";
}
