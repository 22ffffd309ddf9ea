// Chapter 7 in one file, grown from chapter 6: steps correct the part β of errors.
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

int step(Discs& d, double h, double beta)
{
    for (int k = 1; k < d.u.size(); k += 2) d.u[k] -= 9.81 * h;  // u*, (3.4)
    std::vector<Contact> contacts = find_contacts(d);
    for (Contact& c : contacts)  // (7.4), and (3.30) for a gap
        c.bias = (c.lo < 0 || c.C < 0 ? beta : 1) * c.C / h;
    int sweeps = 0;
    for (double off = 1; off > 1e-6; ++sweeps) {
        off = 0;
        for (Contact& c : contacts) off = std::max(off, visit(c, d));
    }
    d.x += h * d.u;  // (1.10)
    return sweeps;
}

// The largest error of a link, or overlap [m].
double error(const Discs& d)
{
    double largest = 0;
    for (const Contact& c : find_contacts(d))
        largest = std::max(largest, c.lo < 0 ? std::abs(c.C) : -c.C);
    return largest;
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
    // By hand, (7.5): two linked discs, 10 mm too far from each other.
    std::vector<Path> paths{{"#808080", {{0, 0}, {20, 0}}}};
    for (const auto& [beta, colour] : {std::pair{0.0, "#808080"},
                                       {0.2, "#CC3311"},
                                       {1.0, "#228833"},
                                       {1.5, "#4477AA"}}) {
        Discs two{Vec{{0, 0, 0.11, 0}}, Vec::Zero(4), Vec::Ones(4), Vec(2), 2, {}};
        two.radius << 0.05, 0.05;
        paths.push_back({colour, {}});
        for (int n = 0; n <= 20; ++n) {
            paths.back().second.push_back({n, 1000 * find_contacts(two)[0].C});
            if (n < 5) std::printf("%7.3f", paths.back().second[n].y());
            step(two, 1.0 / 60, beta);
        }
        std::printf(" mm with beta = %g\n", beta);
    }
    // (7.9): a disc 0.1 m deep in a floor.
    Discs one{Vec{{0, 0}}, Vec::Zero(2),  Vec::Ones(2), Vec{{0.1}},
              0,           Vec{{0, 1, 0}}};
    step(one, 1.0 / 60, 0.2);
    std::printf("a disc 0.1 m deep leaves at %g m/s\n", one.u[1]);

    for (const double beta : {0.0, 0.2, 1.0}) {
        Discs d = ten_discs();
        double worst = 0;
        for (int n = 0; n < 480; ++n)
            step(d, 1.0 / 240, beta), worst = std::max(worst, error(d));
        std::printf("ten discs, beta = %g: %.2f mm\n", beta, 1000 * worst);
    }
    if (count < 2) return 0;
    std::ofstream out(word[1]);  // an SVG picture of the paths; y points upwards
    out << "<svg xmlns='http://www.w3.org/2000/svg' fill='none' "
           "width='400' stroke-width='0.2' viewBox='-1 -11 22 17'>\n";
    for (const auto& [colour, points] : paths) {
        out << "<polyline stroke='" << colour << "' points='";
        for (const Vector2d& p : points) out << p.x() << ',' << -p.y() << ' ';
        out << "'/>\n";
    }
    out << "<g fill='#808080' font-size='.9'><text x='16' y='1.3'>20 steps</text>"
           "<text x='0' y='-10.3'>10 mm</text></g></svg>\n";
}
