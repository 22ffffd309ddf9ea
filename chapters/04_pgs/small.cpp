// Chapter 4 in one file, grown from chapter 3: the problem solved row by row.
// Each row is solved as if all others were right, and clamped.
//
//     w = A λ + q,   A = J M⁻¹ Jᵀ,   q = J u* + b,   b = C / h
//     contact: λ ≥ 0, w ≥ 0, λ w = 0         link: w = 0
#include <Eigen/Core>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <vector>
using Eigen::Vector2d;
using Vec = Eigen::VectorXd;
using Mat = Eigen::MatrixXd;
using Path = std::pair<const char*, std::vector<Vector2d>>;  // a colour and points

// (4.4): sweeps, in which each row takes its own answer, clamped, until no row has
// been off by more than 1e-6 m/s. Returns the number of sweeps.
int pgs(const Mat& A, const Vec& q, const Vec& lo, Vec& lambda, int most = 100000)
{
    int sweeps = 0;
    for (double off = 1; off > 1e-6 && sweeps < most; ++sweeps) {
        off = 0;
        for (int i = 0; i < q.size(); ++i) {
            const double w = A.row(i).dot(lambda) + q[i];
            const double change =
                std::max(lo[i], lambda[i] - w / A(i, i)) - lambda[i];
            lambda[i] += change;
            off = std::max(off, A(i, i) * std::abs(change));
        }
    }
    return sweeps;
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
    const int sweeps = pgs(J * W, J * d.u + b, lo, lambda);
    d.u += W * lambda;  // (3.9)
    d.x += h * d.u;     // (1.10)
    return sweeps;
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
    // By hand, (4.2): two discs of 1 kg in a column, g h = 1 m/s.
    const Mat A{{1, -1}, {-1, 2}};
    const Vec q{{-1, 0}}, lo = Vec::Zero(2);
    std::vector<Path> paths{{"#808080", {{0, 1.25}, {0, 0}, {2.25, 0}}},
                            {"#4477AA", {{1, 0}, {2.2, 1.2}}},  // w1 = 0, w2 = 0
                            {"#4477AA", {{0, 0}, {2.2, 1.1}}},
                            {"#CC3311", {{0, 0}}}};
    Vec lambda = Vec::Zero(2);
    for (int sweep = 1; sweep <= 6; ++sweep) {
        const double before = lambda[1];
        pgs(A, q, lo, lambda, 1);
        std::printf("sweep %d: lambda %g %g N s\n", sweep, lambda[0], lambda[1]);
        paths[3].second.insert(paths[3].second.end(),
                               {{lambda[0], before}, lambda});
    }

    Discs d = ten_discs();
    int sweeps = 0;
    for (int n = 0; n < 480; ++n) sweeps += step(d, 1.0 / 240);
    std::printf("ten discs: %d sweeps in 480 steps\n", sweeps);
    if (count < 2) return 0;
    std::ofstream out(word[1]);  // an SVG picture of the paths; y points upwards
    out << "<svg xmlns='http://www.w3.org/2000/svg' fill='none' "
           "width='400' stroke-width='0.02' viewBox='-0.15 -1.35 2.5 1.5'>\n";
    for (const auto& [colour, points] : paths) {
        out << "<polyline stroke='" << colour << "' points='";
        for (const Vector2d& p : points) out << p.x() << ',' << -p.y() << ' ';
        out << "'/>\n";
    }
    out << "<g fill='#808080' font-size='0.09'><text x='2.15' y='0.08'>λ1</text>"
           "<text x='-0.13' y='-1.2'>λ2</text>"
           "<text x='1.7' y='-0.55'>w1 = 0</text>"
           "<text x='0.2' y='-0.3'>w2 = 0</text></g></svg>\n";
}
