// Chapter 5 in one file, grown from chapter 4: the problem solved by a finite walk.
//
//     w = A z + q + d z0,   z0 from large down to 0,   z = λ
//     contact: z ≥ 0, w ≥ 0, z w = 0         link: w = 0
#include <Eigen/Core>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <map>
#include <vector>
using Eigen::Vector2d;
using Vec = Eigen::VectorXd;
using Mat = Eigen::MatrixXd;
using Path = std::pair<const char*, std::vector<Vector2d>>;  // a colour and points

// Algorithm 5.1. The lines of the tableau T are q = w − A z − d z0: column 0 is q,
// then come w, z and z0. Returns the number of pivots.
int lemke(const Mat& A, const Vec& q, const Vec& lo, Vec& lambda, int most = 10000)
{
    const int n = q.size(), z0 = 2 * n + 1;
    Mat T(n, 2 * n + 2);
    T << q, Mat::Identity(n, n), -A, -(lo.array() == 0).cast<double>().matrix();
    std::vector<int> basic(n);
    const auto pivot = [&](int p, int c) {  // (5.8)
        T.row(p) /= T(p, c);
        for (int i = 0; i < n; ++i)
            if (i != p) T.row(i) -= T(i, c) * T.row(p);
        basic[p] = c;
    };
    for (int i = 0; i < n; ++i) {
        basic[i] = i + 1;
        if (lo[i] < 0) pivot(i, n + 1 + i);  // a link has w = 0, whatever its z
    }
    int pivots = 0;
    for (int c = z0; c > 0 && pivots < most; ++pivots) {
        std::map<std::vector<double>, int> rows;  // by their ratios, (5.10), (5.13)
        for (int i = 0; i < n; ++i) {
            if (lo[i] < 0 || (c == z0 ? T(i, 0) >= 0 : T(i, c) < 1e-10)) continue;
            const Vec ratios = T.row(i).head(n + 1) / std::abs(T(i, c));
            rows[{ratios.begin(), ratios.end()}] = i;
        }
        if (rows.empty()) break;  // a ray, or nothing to lift
        const int p = rows.begin()->second, leaves = basic[p];
        pivot(p, c);
        c = leaves == z0 ? 0 : leaves + (leaves <= n ? n : -n);  // (5.9)
    }
    lambda.setZero();
    for (int i = 0; i < n; ++i)
        if (basic[i] > n && basic[i] < z0) lambda[basic[i] - n - 1] = T(i, 0);
    return pivots;
}

struct Contact {
    int a, b;      // disc b and disc a, or a wall: -1, -2, …
    Vector2d n;    // from a to b
    double C, lo;  // gap [m]; bound of λ: 0, or -∞ for a link, which pulls as well
};

struct Discs {
    Vec x, u, inverse_mass, radius;  // two numbers a disc, but one radius
    int chain;                       // so many discs, the first ones, are linked
    Mat walls;                       // columns n, c: where n·p ≥ c it is free
};

// The links, then all pairs of discs, then discs and walls, with gaps below 2 cm.
std::vector<Contact> find_contacts(const Discs& d)
{
    std::vector<Contact> found;
    const int K = d.radius.size();
    const auto meet = [&](int a, int b, double margin, double lo) {
        const Vector2d ab = d.x.segment<2>(2 * b) - d.x.segment<2>(2 * a);
        const double C = ab.norm() - d.radius[a] - d.radius[b];
        if (C < margin) found.push_back({a, b, ab.normalized(), C, lo});
    };
    for (int b = 1; b < d.chain; ++b) meet(b - 1, b, INFINITY, -INFINITY);
    for (int a = 0; a < K; ++a)
        for (int b = a + 1; b < K; ++b)
            if (b > a + 1 || b >= d.chain) meet(a, b, 0.02, 0);
    for (int b = 0; b < K; ++b)
        for (int i = 0; i < d.walls.cols(); ++i) {
            const Vector2d n = d.walls.col(i).head<2>(), p = d.x.segment<2>(2 * b);
            const double C = n.dot(p) - d.walls(2, i) - d.radius[b];
            if (C < 0.02) found.push_back({-1 - i, b, n, C, 0});
        }
    return found;
}

int step(Discs& d, double h)
{
    for (int k = 1; k < d.u.size(); k += 2) d.u[k] -= 9.81 * h;  // u*, (3.4)
    const std::vector<Contact> contacts = find_contacts(d);
    const int m = contacts.size();
    Mat J = Mat::Zero(m, d.x.size());
    Vec b(m), lo(m), lambda = Vec::Zero(m);
    for (int i = 0; i < m; ++i) {
        const Contact& c = contacts[i];
        if (c.a >= 0) J.block<1, 2>(i, 2 * c.a) = -c.n.transpose();
        J.block<1, 2>(i, 2 * c.b) = c.n.transpose();
        b[i] = c.C / h;  // (3.30)
        lo[i] = c.lo;
    }
    const Mat W = d.inverse_mass.asDiagonal() * J.transpose();
    const int pivots = lemke(J * W, J * d.u + b, lo, lambda);
    d.u += W * lambda;  // (3.9)
    d.x += h * d.u;     // (1.10)
    return pivots;
}

// Ten discs in a box: a chain of seven that falls on the three others.
Discs ten_discs()
{
    Discs d{Vec(20), Vec::Zero(20), Vec(20), Vec(10), 7, {}};
    d.walls = Mat{{1, -1, 0, 0}, {0, 0, 1, -1}, {-0.75, -0.75, -0.5, -0.5}};
    for (int k = 0; k < 7; ++k) d.x.segment<2>(2 * k) << -0.3 + 0.1 * k, 0.1;
    d.x.tail<6>() << -0.3, -0.3, 0, -0.3, 0.4, -0.3;
    d.inverse_mass << Vec::Constant(14, 10), 5, 5, 2.5, 2.5, 5, 5;
    d.radius << Vec::Constant(7, 0.05), 0.1, 0.15, 0.08;
    return d;
}

int main(int count, char** word)
{
    // By hand, (5.2): a disc of 0.5 kg in a corner of 60°.
    const Mat A{{2, 1}, {1, 2}};
    const Vec q{{-5, -6}}, lo = Vec::Zero(2);
    std::vector<Path> paths{{"#4477AA", {{1, 3}, {2.5, 0}}},  // w1 = 0, w2 = 0
                            {"#4477AA", {{0, 3}, {3, 1.5}}},
                            {"#CC3311", {{0, 0}}}};
    Vec lambda = Vec::Zero(2);
    for (int pivots = 1; pivots <= 3; ++pivots) {
        lemke(A, q, lo, lambda, pivots);
        std::printf("pivot %d: z %g %g N s\n", pivots, lambda[0], lambda[1]);
        paths[2].second.push_back(lambda);
    }
    Discs d = ten_discs();
    int pivots = 0;
    for (int n = 0; n < 480; ++n) pivots += step(d, 1.0 / 240);
    std::printf("ten discs: %d pivots in 480 steps\n", pivots);
    if (count < 2) return 0;
    std::ofstream out(word[1]);  // an SVG picture of the paths; y points upwards
    out << "<svg xmlns='http://www.w3.org/2000/svg' fill='none' "
           "width='400' stroke-width='0.02' viewBox='-0.2 -3.2 3.4 3.4'>\n";
    for (const auto& [colour, points] : paths) {
        out << "<polyline stroke='" << colour << "' points='";
        for (const Vector2d& p : points) out << p.x() << ',' << -p.y() << ' ';
        out << "'/>\n";
    }
    out << "<g fill='#808080' font-size='0.2'><text x='2.95' y='0.17'>z1</text>"
           "<text x='-0.19' y='-2.6'>z2</text></g></svg>\n";
}
