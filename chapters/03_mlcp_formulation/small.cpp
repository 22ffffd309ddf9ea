// Chapter 3 in one file, grown from chapter 2: many rows, and contacts, which push.
// All rows make one problem, which is solved by trying its cases.
//
//     w = A λ + q,   A = J M⁻¹ Jᵀ,   q = J u* + b,   b = C / h
//     contact: λ ≥ 0, w ≥ 0, λ w = 0         link: w = 0
#include <Eigen/LU>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <vector>
using Eigen::Vector2d;
using Vec = Eigen::VectorXd;
using Mat = Eigen::MatrixXd;
using Path = std::pair<const char*, std::vector<Vector2d>>;  // a colour and points

// (3.15): the natural residual [m/s], zero for the answer and for nothing else.
double residual(const Mat& A, const Vec& q, const Vec& lo, const Vec& lambda)
{
    const Vec room = A.diagonal().cwiseProduct(lambda - lo);
    return (A * lambda + q).cwiseMin(room).lpNorm<Eigen::Infinity>();
}

// (3.14b): the impulses if w = 0 in the rows of the set and λ = 0 in all others.
Vec impulses(Mat A, Vec r, long set)
{
    for (int i = 0; i < r.size(); ++i)
        if (!(set >> i & 1)) A.row(i) = Vec::Unit(r.size(), i), r[i] = 0;
    return A.partialPivLu().solve(r);
}

// Guesses that the rows with q < 0 are at work, then changes the guess in all ways.
// Links come first and are in every set. Returns how many sets were tried.
int enumerate(const Mat& A, const Vec& q, const Vec& lo, Vec& lambda)
{
    long guess = 0;
    for (int i = 0; i < q.size(); ++i)
        if (q[i] < 0 || lo[i] < 0) guess |= 1L << i;
    const long links = (lo.array() < 0).count(), sets = 1L << (q.size() - links);
    for (long change = 0; change < sets; ++change) {
        lambda = impulses(A, -q, guess ^ change << links);
        if (residual(A, q, lo, lambda) <= 1e-9) return int(change) + 1;
    }
    return -1;
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
    const int sets = enumerate(J * W, J * d.u + b, lo, lambda);
    d.u += W * lambda;  // (3.9)
    d.x += h * d.u;     // (1.10)
    return sets;
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
    // By hand, (3.3): a disc of 1 kg in a corner, four sets.
    const Mat J{{0, 1}, {0.6, 0.8}}, A = J * J.transpose();
    const Vec u{{-1, -2}}, q = J * u, lo = Vec::Zero(2);
    std::vector<Path> paths{{"#4477AA", {{1.2, 0}, {0, 0}, {-0.8, 0.6}}}};
    for (long set = 0; set < 4; ++set) {
        const Vec lambda = impulses(A, -q, set);
        const Vec v = u + J.transpose() * lambda, w = J * v;
        const bool fits = residual(A, q, lo, lambda) <= 1e-9;
        std::printf("lambda %6.3f %6.3f N s,  w %5.2f %5.2f m/s%s\n", lambda[0],
                    lambda[1], w[0], w[1], fits ? ": fits" : "");
        paths.push_back({fits ? "#CC3311" : "#808080", {u, v}});
    }

    Discs d = ten_discs();
    int sets = 0;
    for (int n = 0; n < 480; ++n) sets += step(d, 1.0 / 240);
    std::printf("ten discs: %d sets tried in 480 steps\n", sets);
    if (count < 2) return 0;
    std::ofstream out(word[1]);  // an SVG picture of the paths; y points upwards
    out << "<svg xmlns='http://www.w3.org/2000/svg' fill='none' "
           "width='400' stroke-width='0.02' viewBox='-1.2 -0.8 2.5 3'>\n";
    for (const auto& [colour, points] : paths) {
        out << "<polyline stroke='" << colour << "' points='";
        for (const Vector2d& p : points) out << p.x() << ',' << -p.y() << ' ';
        out << "'/>\n";
    }
    out << "<g fill='#808080' font-size='0.13'><text x='1.02' y='0.13'>ux</text>"
           "<text x='0.06' y='-0.65'>uy</text>"
           "<text x='0.3' y='-0.3'>allowed</text>"
           "<text x='-1.17' y='-0.07'>floor alone</text>"
           "<text x='0.36' y='0.33'>ramp alone</text>"
           "<text x='-0.02' y='0.13'>both</text><text x='-1.17' y='2.13'>u*</text>"
           "</g></svg>\n";
}
