// Chapter 10 in one file, grown from chapter 8: skips what cannot matter.
// Pairs far apart, rows of solved islands and bodies at rest cost nothing.
//     A = diag(A₁, A₂, …): no impulse of one island moves a body of another, (10.5)
#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <numeric>
#include <vector>
using Eigen::Vector2d;
using Vec = Eigen::VectorXd;
using Mat = Eigen::MatrixXd;

struct Contact {
    int a, b;    // disc b and disc a, or a wall: -1, -2, …
    Vector2d n;  // from a to b
    double C, lo, bias = 0, lambda = 0;  // gap [m], least λ, [m/s], [N s]
};

struct Discs {
    Vec x, u, inverse_mass, radius;  // two numbers a disc, but one radius
    Mat walls;                       // columns n, c: where n·p ≥ c it is free
    std::vector<Contact> contacts = {};     // of the last step
    std::vector<double> rest = {};          // for how long each disc has rested [s]
    std::vector<int> asleep = {};           // its sleeping island, or -1: awake
    long pairs = 0, visits = 0, moved = 0;  // the work so far
};

// Chapter 8's list by sort and sweep: pairs whose shadows meet, and not both sleep.
std::vector<Contact> find_contacts(Discs& d, bool skip)
{
    std::vector<Contact> found;
    const int K = d.radius.size();
    std::vector<int> order(K);
    std::iota(order.begin(), order.end(), 0);
    const auto left = [&](int k) { return d.x[2 * k] - d.radius[k]; };
    const auto before = [&](int a, int b) { return left(a) < left(b); };
    std::sort(order.begin(), order.end(), before);
    for (int i = 0; i < K; ++i)
        for (int j = i + 1; j < K; ++j) {
            const auto [a, b] = std::minmax(order[i], order[j]);
            const double right = left(order[i]) + 2 * d.radius[order[i]];
            if (skip && left(order[j]) > right + 0.021) break;
            if (d.asleep[a] >= 0 && d.asleep[b] >= 0) continue;
            ++d.pairs;
            const Vector2d ab = d.x.segment<2>(2 * b) - d.x.segment<2>(2 * a);
            const double C = ab.norm() - d.radius[a] - d.radius[b];
            if (C < 0.02) found.push_back({a, b, ab.normalized(), C, 0});
        }
    std::sort(found.begin(), found.end(), [](const Contact& c, const Contact& e) {
        return std::pair(c.a, c.b) < std::pair(e.a, e.b);
    });
    for (int b = 0; b < K; ++b)
        for (int i = 0; i < d.walls.cols() && d.asleep[b] < 0; ++i) {
            const Vector2d n = d.walls.col(i).head<2>(), p = d.x.segment<2>(2 * b);
            const double C = n.dot(p) - d.walls(2, i) - d.radius[b];
            if (C < 0.02) found.push_back({-1 - i, b, n, C, 0});
        }
    return found;
}

// Union-find: for each of K bodies the lowest of its island. A wall joins none.
std::vector<int> islands(const std::vector<Contact>& contacts, int K)
{
    std::vector<int> up(K);
    std::iota(up.begin(), up.end(), 0);
    const auto top = [&](int k) {
        while (up[k] != k) k = up[k] = up[up[k]];
        return k;
    };
    for (const Contact& c : contacts)
        if (c.a >= 0) {
            const auto [low, high] = std::minmax({top(c.a), top(c.b)});
            up[high] = low;
        }
    for (int k = 0; k < K; ++k) up[k] = top(k);
    return up;
}

// (6.5): an impulse along J, on both discs.
void push(const Contact& c, double impulse, Discs& d)
{
    const Vector2d P = impulse * c.n;
    if (c.a >= 0) d.u.segment<2>(2 * c.a) -= d.inverse_mass[2 * c.a] * P;
    d.u.segment<2>(2 * c.b) += d.inverse_mass[2 * c.b] * P;
}

// One visit: (6.2) to (6.5). Returns by how much the row was off [m/s].
double visit(Contact& c, Discs& d)
{
    double w = c.bias + c.n.dot(d.u.segment<2>(2 * c.b));
    if (c.a >= 0) w -= c.n.dot(d.u.segment<2>(2 * c.a));
    const double A =
        d.inverse_mass[2 * c.b] + (c.a < 0 ? 0 : d.inverse_mass[2 * c.a]);
    const double change = std::max(c.lo, c.lambda - w / A) - c.lambda;
    c.lambda += change;
    push(c, change, d);
    return A * std::abs(change);
}

void wake(Discs& d, int island)
{
    for (std::size_t k = 0; k < d.asleep.size(); ++k)
        if (d.asleep[k] == island) d.asleep[k] = -1, d.rest[k] = 0;
}

// skip = 0: nothing, 1: pairs and rows, 2: bodies at rest too
void step(Discs& d, double h, int skip, int most = 100000, double enough = 1e-6)
{
    const int K = d.radius.size();
    d.rest.resize(K), d.asleep.resize(K, -1);
    std::vector<Contact> contacts;
    for (bool found = false; !found;) {
        found = true;
        contacts = find_contacts(d, skip > 0);
        for (const Contact& c : contacts)  // a sleeper that is touched wakes
            for (const int k : {c.a, c.b})
                if (k >= 0 && d.asleep[k] >= 0) found = false, wake(d, d.asleep[k]);
    }
    const Vec before = d.u;
    for (int k = 0; k < K; ++k)
        if (d.asleep[k] < 0) d.u[2 * k + 1] -= 9.81 * h;  // u*, (3.4)
    const std::vector<int> island = islands(contacts, K);
    std::vector<std::vector<Contact*>> rows(K);
    for (Contact& c : contacts) {
        c.bias = (c.C < 0 ? 0.2 : 1) * c.C / h;  // (7.4), (3.30)
        for (const Contact& old : d.contacts)    // its key: which two touch
            if (old.a == c.a && old.b == c.b) push(c, c.lambda = old.lambda, d);
        rows[skip > 0 ? island[c.b] : 0].push_back(&c);
    }
    for (const std::vector<Contact*>& own : rows) {
        double off = 1;  // each island stops when it is solved, (10.6)
        for (int sweeps = 0; off > enough && sweeps < most; ++sweeps) {
            off = 0;
            for (Contact* c : own) off = std::max(off, visit(*c, d)), ++d.visits;
        }
    }
    for (const Contact& old : d.contacts)  // sleepers remember
        if (d.asleep[old.b] >= 0) contacts.push_back(old);
    d.contacts = contacts;
    std::vector<bool> restless(K);  // (10.7), for half a second, of a whole island
    for (int k = 0; k < K; ++k) {
        if (d.asleep[k] >= 0) continue;
        d.x.segment<2>(2 * k) += h * d.u.segment<2>(2 * k), ++d.moved;  // (1.10)
        const Vector2d u = d.u.segment<2>(2 * k), was = before.segment<2>(2 * k);
        const bool rests = u.norm() <= 1e-3 && (u - was).norm() <= 0.02 * h;
        d.rest[k] = rests ? d.rest[k] + h : 0;
        if (d.rest[k] < 0.5) restless[island[k]] = true;
    }
    for (int k = 0; k < K && skip > 1; ++k)
        if (d.asleep[k] < 0 && !restless[island[k]])
            d.asleep[k] = island[k], d.u.segment<2>(2 * k).setZero();
}

// Twenty columns of five discs on a floor, and a ball that rolls into the first.
Discs columns()
{
    Discs d{Vec(202), Vec::Zero(202), Vec::Ones(202), Vec(101), Vec{{0, 1, 0}}};
    for (int k = 0; k < 100; ++k)
        d.x.segment<2>(2 * k) << 0.5 * (k / 5), 0.1 + 0.2 * (k % 5);
    d.x.tail<2>() << -1, 0.3;
    d.radius << Vec::Constant(100, 0.1), 0.3;
    d.inverse_mass.tail<2>().setConstant(0.1), d.u[200] = 1;
    return d;
}

int main(int count, char** word)
{
    // By hand, section 10.3: eight bodies, but 2 and 5 are fixed and join nothing.
    const int joined[][2]{{2, 1}, {0, 3}, {2, 4}, {5, 4}, {3, 6}};
    std::vector<Contact> rows{{-1, 1, {0, 1}, 0, 0}};
    const Mat at{{1, 1},  {-2, -1}, {-1, 1}, {2, 1},
                 {0, -1}, {1, 0},   {3, 0},  {2, -1}};
    std::ofstream out(count < 2 ? "" : word[1]);  // an SVG picture
    out << "<svg xmlns='http://www.w3.org/2000/svg' width='500' font-size='0.35' "
           "fill='#808080' stroke-width='0.04' viewBox='-2.5 -1.7 6.2 3.1'>\n";
    for (const auto& [a, b] : joined) {
        rows.push_back({a == 2 || a == 5 ? -1 : a, b, {0, 1}, 0, 0});
        out << "<path stroke='#808080' d='M" << at.row(a) << 'L' << at.row(b)
            << "'/>\n";
    }
    const std::vector<int> island = islands(rows, 8);
    for (int k = 0; k < 8; ++k) {
        std::printf("body %d: island %d\n", k, island[k]);
        out << "<g transform='translate(" << at.row(k)
            << ")'><circle r='.2' fill='hsl(" << 80 * island[k] << " "
            << (k == 2 || k == 5 ? 0 : 60) << "% 50%)'/><text x='-.1' y='-.3'>" << k
            << "</text></g>\n";
    }
    out << "</svg>\n";
    Discs all = columns(), some = all, asleep = all;
    for (int n = 0; n < 150; ++n) {
        step(all, 1.0 / 60, 0, 10, 0), step(some, 1.0 / 60, 1, 10, 0);
        step(asleep, 1.0 / 60, 2, 10);
    }
    std::printf("the same bits: %s\n", all.x == some.x ? "yes" : "no");
    for (const Discs& d : {all, some, asleep})
        std::printf("%ld pairs %ld visits %ld moved\n", d.pairs, d.visits, d.moved);
}
