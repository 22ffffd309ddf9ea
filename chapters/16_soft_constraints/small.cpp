// Chapter 16 in one file, grown from chapter 8: a spring is a row that gives way.
//
//     w = J u + b + γ λ,   b = C / h,   γ = 1 / (h² k), which is 0 for k = ∞
//     contact: λ ≥ 0, w ≥ 0, λ w = 0         spring: w = 0
#include <Eigen/Core>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <numbers>
#include <vector>
using Eigen::Vector2d;
using Vec = Eigen::VectorXd;
using Mat = Eigen::MatrixXd;

struct Contact {
    int a, b;         // disc b and disc a, or a wall: -1, -2, …
    Vector2d n;       // from a to b
    double C, lo, k;  // [m]; bound of λ: 0, or -∞ for a spring; stiffness [N/m]
    double bias = 0, gamma = 0, lambda = 0;  // [m/s], [1/kg], [N s]
};

struct Spring {
    int a, b;
    double length, k;  // at rest [m], [N/m]
};

struct Discs {
    Vec x, u, inverse_mass, radius;  // two numbers a disc, but one radius
    std::vector<Spring> springs;
    Mat walls;  // columns n, c: where n·p ≥ c it is free
    double g = 9.81;
    std::vector<Contact> contacts = {};  // of the last step
};

// The springs, then all pairs of discs, then discs and walls, with gaps below 2 cm.
std::vector<Contact> find_contacts(const Discs& d)
{
    std::vector<Contact> found;
    const int K = d.radius.size();
    const auto meet = [&](const Spring& s, double margin, double lo) {
        const Vector2d ab = d.x.segment<2>(2 * s.b) - d.x.segment<2>(2 * s.a);
        const double C = ab.norm() - s.length;
        if (C < margin) found.push_back({s.a, s.b, ab.normalized(), C, lo, s.k});
    };
    for (const Spring& s : d.springs) meet(s, INFINITY, -INFINITY);
    for (int a = 0; a < K; ++a)
        for (int b = a + 1; b < K; ++b)
            meet({a, b, d.radius[a] + d.radius[b], INFINITY}, 0.02, 0);
    for (int b = 0; b < K; ++b)
        for (int i = 0; i < d.walls.cols(); ++i) {
            const Vector2d n = d.walls.col(i).head<2>(), p = d.x.segment<2>(2 * b);
            const double C = n.dot(p) - d.walls(2, i) - d.radius[b];
            if (C < 0.02) found.push_back({-1 - i, b, n, C, 0, INFINITY});
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

// One visit: (16.9). Returns by how much the row was off [m/s].
double visit(Contact& c, Discs& d)
{
    double w = c.bias + c.gamma * c.lambda + c.n.dot(d.u.segment<2>(2 * c.b));
    if (c.a >= 0) w -= c.n.dot(d.u.segment<2>(2 * c.a));
    const double A =
        c.gamma + d.inverse_mass[2 * c.b] + (c.a < 0 ? 0 : d.inverse_mass[2 * c.a]);
    const double change = std::max(c.lo, c.lambda - w / A) - c.lambda;
    c.lambda += change;
    push(c, change, d);
    return A * std::abs(change);
}

int step(Discs& d, double h, int most = 100000)
{
    for (int k = 1; k < d.u.size(); k += 2) d.u[k] -= d.g * h;  // u*, (3.4)
    std::vector<Contact> contacts = find_contacts(d);
    for (Contact& c : contacts) {
        c.bias = c.C / h;
        c.gamma = 1 / (h * h * c.k);           // (16.6)
        for (const Contact& old : d.contacts)  // its key: which two touch, and how
            if (old.a == c.a && old.b == c.b && old.lo == c.lo)
                push(c, c.lambda = old.lambda, d);
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

// 12 by 8 discs above a floor, on springs along both sides and both diagonals.
Discs net(double k)
{
    const Vec one = Vec::Ones(192);
    Discs d{one, 0 * one, 10 * one, 0.075 * one.head(96), {}, Vec{{0, 1, 0}}};
    for (int b = 0; b < 96; ++b) {
        d.x.segment<2>(2 * b) << 0.25 * (b % 12), 0.8 + 0.25 * (b / 12);
        for (int a = 0; a < b; ++a) {
            const double length =
                (d.x.segment<2>(2 * b) - d.x.segment<2>(2 * a)).norm();
            if (length < 0.36) d.springs.push_back({a, b, length, k});
        }
    }
    return d;
}

int main(int count, char** word)
{
    // By hand, section 16.1: 1 kg on a spring of 30 Hz, 1 cm out.
    const double h = 1.0 / 60, omega = 60 * std::numbers::pi, k = omega * omega;
    std::ofstream out(count < 2 ? "" : word[1]);  // an SVG picture; cm downwards
    out << "<svg xmlns='http://www.w3.org/2000/svg' fill='none' width='500' "
           "stroke-width='0.15' viewBox='-1 -11 32 22'>\n<path stroke='#808080' d='"
           "M0-10V10M0 0H30M5-.3v.6m5 0v-.6m5 0v.6m5 0v-.6m5 0v.6m5 0v-.6M0 1";
    for (double t = 0; t < 6 * h; t += h / 20)  // exactly
        out << 'L' << 5 * t / h << ' ' << std::cos(omega * t);
    out << "'/>\n<path stroke='#CC3311' d='M0 1";
    double x = 0.01, v = 0;
    for (int n = 1; n < 4; ++n) {
        v -= h * k * x, x += h * v;
        std::printf("explicit: %.2f m/s, %.4f m\n", v, x);
        out << 'L' << 5 * n << ' ' << 100 * x;
    }
    const Vec mass{{0, 0, 1, 1}};
    Discs d{Vec{{0, 0, 1.01, 0}}, 0 * mass, mass, Vec::Zero(2),
            {{0, 1, 1, k}},       {},       0};
    out << "'/>\n<path stroke='#4477AA' d='M0 1";
    for (int n = 1; n < 7; ++n) {
        step(d, h);
        out << 'L' << 5 * n << ' ' << 100 * (d.x[2] - 1);
        if (n < 2) std::printf("soft row: %.2f m/s, %.4f m\n", d.u[2], d.x[2] - 1);
    }
    out << "'/>\n<g fill='#808080' font-size='1.2'><text x='.4' y='9.8'>10 cm"
           "</text><text x='.4' y='-9'>−10 cm</text><text x='20' y='2.6'>6 steps"
           " of 1/60 s</text><text x='12' y='-5.4'>exactly</text><text x='12' "
           "y='-9' fill='#CC3311'>force of the start of the step</text><text x='12'"
           " y='-7.2' fill='#4477AA'>force of the end of the step</text></g>\n"
           "</svg>\n";
    for (const double stiffness : {120.0, 1e9}) {
        Discs d = net(stiffness);
        for (int n = 0; n < 240; ++n) step(d, 1.0 / 240, 10);
        const auto p = d.x.reshaped(2, 96).transpose();
        const auto size = p.colwise().maxCoeff() - p.colwise().minCoeff();
        std::printf("net of %g N/m: %.3f m wide, %.3f m high\n", stiffness, size[0],
                    size[1]);
    }
}
