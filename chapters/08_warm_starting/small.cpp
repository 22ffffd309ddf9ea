// Chapter 8 in one file, grown from chapter 7: rows start from their last impulses.
//
//     w = J u + b,   u ← u + M⁻¹ Jᵀ Δλ,   b = β C / h, but C / h for a gap
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

struct Contact {
    int a, b;      // disc b and disc a, or a wall: -1, -2, …
    Vector2d n;    // from a to b
    double C, lo;  // gap [m]; bound of λ: 0, or -∞ for a link, which pulls as well
    double bias = 0, lambda = 0;  // [m/s], [N s]
};

struct Discs {
    Vec x, u, inverse_mass, radius;  // two numbers a disc, but one radius
    int chain;                       // so many discs, the first ones, are linked
    Mat walls;                       // columns n, c: where n·p ≥ c it is free
    double g = 9.81;
    std::vector<Contact> contacts = {};  // of the last step
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

int step(Discs& d, double h, double beta, int most = 100000)
{
    for (int k = 1; k < d.u.size(); k += 2) d.u[k] -= d.g * h;  // u*, (3.4)
    std::vector<Contact> contacts = find_contacts(d);
    for (Contact& c : contacts) {
        c.bias = (c.lo < 0 || c.C < 0 ? beta : 1) * c.C / h;  // (7.4), (3.30)
        for (const Contact& old : d.contacts)  // its key: which two touch
            if (old.a == c.a && old.b == c.b) push(c, c.lambda = old.lambda, d);
    }
    int sweeps = 0;
    for (double off = 1; off > 1e-6 && sweeps < most; ++sweeps) {
        off = 0;
        for (Contact& c : contacts) off = std::max(off, visit(c, d));
    }
    d.x += h * d.u;  // (1.10)
    d.contacts = contacts;
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

Discs column(int K)
{
    const Vec one = Vec::Ones(2 * K);
    Discs d{0 * one, 0 * one, one, 0.1 * one.head(K), 0, Vec{{0, 1, 0}}};
    for (int k = 0; k < K; ++k) d.x[2 * k + 1] = 0.1 * (2 * k + 1);
    return d;
}

int main(int count, char** word)
{
    // By hand, section 8.1: two discs in a column; at last 1 % more gravity.
    Discs two = column(2);
    for (const double g : {9.81, 9.81, 1.01 * 9.81}) {
        two.g = g;
        std::printf("two discs: %d sweeps\n", step(two, 1.0 / 60, 0.2));
    }
    std::vector<Path> paths;
    for (const bool warm : {false, true}) {
        Discs d = ten_discs(), twenty = column(20);
        int sweeps = 0;
        for (int n = 0; n < 480; ++n) {
            if (!warm) d.contacts.clear(), twenty.contacts.clear();
            sweeps += step(d, 1.0 / 240, 0.2);
            step(twenty, 1.0 / 60, 0, 10);
        }
        std::printf("ten discs: %d sweeps; top of 20: %.5f m\n", sweeps,
                    twenty.x[39]);
        for (int k = 0; k < 20; ++k) {
            const Vector2d p = twenty.x.segment<2>(2 * k) + Vector2d(0.5 * warm, 0);
            Path ring{warm ? "#4477AA" : "#CC3311", {}};
            for (double t = 0; t < 6.4; t += 0.2)
                ring.second.push_back(p + 0.1 * Vector2d(std::cos(t), std::sin(t)));
            paths.push_back(ring);
        }
    }
    if (count < 2) return 0;
    std::ofstream out(word[1]);  // an SVG picture of the paths; y points upwards
    out << "<svg xmlns='http://www.w3.org/2000/svg' fill='none' "
           "width='240' stroke-width='0.02' viewBox='-0.75 -4.05 2 4.2'>\n";
    for (const auto& [colour, points] : paths) {
        out << "<polyline stroke='" << colour << "' points='";
        for (const Vector2d& p : points) out << p.x() << ',' << -p.y() << ' ';
        out << "'/>\n";
    }
    out << "</svg>\n";
}
