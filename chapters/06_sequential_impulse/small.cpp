// Chapter 6 in one file, grown from chapter 4: the same sweeps without the matrix.
// Each visit reads and changes the velocities of two discs.
//
//     w = J u + b,   u ← u + M⁻¹ Jᵀ Δλ,   b = C / h
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

int step(Discs& d, double h)
{
    for (int k = 1; k < d.u.size(); k += 2) d.u[k] -= 9.81 * h;  // u*, (3.4)
    std::vector<Contact> contacts = find_contacts(d);
    for (Contact& c : contacts) c.bias = c.C / h;  // (3.30)
    int sweeps = 0;
    for (double off = 1; off > 1e-6; ++sweeps) {
        off = 0;
        for (Contact& c : contacts) off = std::max(off, visit(c, d));
    }
    d.x += h * d.u;  // (1.10)
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
    // By hand, section 6.1: two discs of 1 kg in a column, g h = 1 m/s.
    Discs two{Vec::Zero(4), Vec{{0, -1, 0, -1}}, Vec::Ones(4), Vec::Ones(2), 0, {}};
    Contact rows[]{{-1, 0, {0, 1}, 0, 0}, {0, 1, {0, 1}, 0, 0}};
    std::vector<Path> paths{{"#4477AA", {{-1, -1}, {0.1, 0.1}}},  // u1 = 0, u1 = u2
                            {"#4477AA", {{0, -1}, {0, 0.1}}},
                            {"#CC3311", {{-1, -1}}}};
    for (int sweep = 1; sweep <= 4; ++sweep)
        for (Contact& c : rows) {
            visit(c, two);
            paths[2].second.push_back({two.u[1], two.u[3]});
            std::printf("lambda %g %g N s, u %g %g m/s\n", rows[0].lambda,
                        rows[1].lambda, two.u[1], two.u[3]);
        }

    Discs d = ten_discs();
    int sweeps = 0;
    for (int n = 0; n < 480; ++n) sweeps += step(d, 1.0 / 240);
    std::printf("ten discs: %d sweeps in 480 steps\n", sweeps);
    if (count < 2) return 0;
    std::ofstream out(word[1]);  // an SVG picture of the paths; y points upwards
    out << "<svg xmlns='http://www.w3.org/2000/svg' fill='none' "
           "width='400' stroke-width='0.02' viewBox='-1.1 -0.2 1.4 1.3'>\n";
    for (const auto& [colour, points] : paths) {
        out << "<polyline stroke='" << colour << "' points='";
        for (const Vector2d& p : points) out << p.x() << ',' << -p.y() << ' ';
        out << "'/>\n";
    }
    out << "<g fill='#808080' font-size='0.06'>"
           "<text x='0.015' y='0.5'>u1 = 0</text>"
           "<text x='-0.85' y='0.6'>u1 = u2</text><text x='0.1' y='1.07'>u1</text>"
           "<text x='-1.09' y='-0.1'>u2</text></g></svg>\n";
}
