// Chapter 16 in one file, grown from chapter 8: a spring is a row that gives way.
// Rows are swept in velocities or, beside it, in positions: XPBD.
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
    int a, b;              // disc b and disc a, or a wall: -1, -2, …
    double length, k, lo;  // at rest [m]; stiffness [N/m]; bound of λ: 0 or -∞
    Vector2d n = {0, 0};   // from a to b
    double C = 0, bias = 0, gamma = 0, lambda = 0;  // [m], [m/s], [1/kg], [N s]
};

struct Discs {
    Vec x, u, inverse_mass, radius;  // two numbers a disc, but one radius
    Mat walls;                       // columns n, c: where n·p ≥ c it is free
    std::vector<Contact> springs = {};
    double g = 9.81;
    std::vector<Contact> contacts = {};  // of the last step
};

// n and C where the discs are now.
void measure(Contact& c, const Discs& d)
{
    Vector2d ab = d.x.segment<2>(2 * c.b);
    if (c.a >= 0) ab -= d.x.segment<2>(2 * c.a);
    c.n = c.a < 0 ? Vector2d(d.walls.col(-1 - c.a).head<2>()) : ab.normalized();
    c.C = c.n.dot(ab) - c.length;
}

// The springs, then all pairs of discs, then discs and walls, with gaps below 2 cm.
std::vector<Contact> find_contacts(const Discs& d)
{
    std::vector<Contact> found = d.springs;
    const int K = d.radius.size();
    for (Contact& c : found) measure(c, d);
    const auto meet = [&](int a, int b, double length) {
        Contact c{a, b, length, INFINITY, 0};
        measure(c, d);
        if (c.C < 0.02) found.push_back(c);
    };
    for (int a = 0; a < K; ++a)
        for (int b = a + 1; b < K; ++b) meet(a, b, d.radius[a] + d.radius[b]);
    for (int b = 0; b < K; ++b)
        for (int i = 0; i < d.walls.cols(); ++i)
            meet(-1 - i, b, d.walls(2, i) + d.radius[b]);
    return found;
}

// (6.5): an impulse along J, on both discs; in positions it moves them.
void push(const Contact& c, double impulse, const Discs& d, Vec& u)
{
    const Vector2d P = impulse * c.n;
    if (c.a >= 0) u.segment<2>(2 * c.a) -= d.inverse_mass[2 * c.a] * P;
    u.segment<2>(2 * c.b) += d.inverse_mass[2 * c.b] * P;
}

// One visit: (16.9) in velocities, (16.21) in positions.
void visit(Contact& c, Discs& d, bool xpbd)
{
    double w = c.bias + c.n.dot(d.u.segment<2>(2 * c.b));
    if (c.a >= 0) w -= c.n.dot(d.u.segment<2>(2 * c.a));
    if (xpbd) measure(c, d), w = c.C;  // where they are now; λ is h λ
    const double A =
        d.inverse_mass[2 * c.b] + (c.a < 0 ? 0 : d.inverse_mass[2 * c.a]);
    const double next = c.lambda - (w + c.gamma * c.lambda) / (A + c.gamma);
    const double change = std::max(c.lo, next) - c.lambda;
    c.lambda += change;
    push(c, change, d, xpbd ? d.x : d.u);
}

void step(Discs& d, double h, bool xpbd, int sweeps)
{
    for (int k = 1; k < d.u.size(); k += 2)
        if (d.inverse_mass[k] > 0) d.u[k] -= d.g * h;  // u*, (3.4)
    const Vec x0 = d.x;
    std::vector<Contact> contacts = find_contacts(d);
    for (Contact& c : contacts) {
        c.bias = c.C / h;
        c.gamma = 1 / (h * h * c.k);           // (16.6), (16.22)
        for (const Contact& old : d.contacts)  // its key: which two touch
            if (old.a == c.a && old.b == c.b && old.lo == c.lo && !xpbd)
                push(c, c.lambda = old.lambda, d, d.u);
    }
    if (xpbd) d.x += h * d.u;
    for (int n = 0; n < sweeps; ++n)
        for (Contact& c : contacts) visit(c, d, xpbd);
    if (xpbd) d.u = (d.x - x0) / h;
    else d.x += h * d.u;  // (1.10)
    d.contacts = contacts;
}

// 12 by 8 discs above a floor, on springs along both sides and both diagonals.
Discs net(double k)
{
    const Vec one = Vec::Ones(192);
    Discs d{one, 0 * one, 10 * one, 0.075 * one.head(96), Vec{{0, 1, 0}}};
    for (int b = 0; b < 96; ++b) {
        d.x.segment<2>(2 * b) << 0.25 * (b % 12), 0.8 + 0.25 * (b / 12);
        for (int a = 0; a < b; ++a) {
            const double length =
                (d.x.segment<2>(2 * b) - d.x.segment<2>(2 * a)).norm();
            if (length < 0.36) d.springs.push_back({a, b, length, k, -INFINITY});
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
           "M0-10V10M0 0H30M0 1";
    for (double t = 0; t < 6 * h; t += h / 20)  // exactly
        out << 'L' << 5 * t / h << ' ' << std::cos(omega * t);
    out << "'/>\n<path stroke='#CC3311' d='M0 1";
    double x = 0.01, v = 0;
    for (int n = 1; n < 4; ++n) {
        v -= h * k * x, x += h * v;
        std::printf("explicit: %.2f m/s, %.4f m\n", v, x);
        out << 'L' << 5 * n << ' ' << 100 * x;
    }
    for (const bool xpbd : {false, true}) {
        Discs d{Vec{{0, 0, 1.01, 0}},
                Vec::Zero(4),
                Vec{{0, 0, 1, 1}},
                Vec::Zero(2),
                {}};
        d.springs = {{0, 1, 1, k, -INFINITY}}, d.g = 0;
        out << "'/>\n<path stroke='#4477AA' d='M0 1";
        for (int n = 1; n < 7; ++n) {
            step(d, h, xpbd, 1);
            out << 'L' << 5 * n << ' ' << 100 * (d.x[2] - 1);
            if (n < 2)
                std::printf("%s: %.2f m/s, %.4f m\n", xpbd ? "XPBD" : "soft row",
                            d.u[2], d.x[2] - 1);
        }
    }
    out << "'/>\n</svg>\n";
    for (const double stiffness : {120.0, 1e9})
        for (const bool xpbd : {false, true}) {
            Discs d = net(stiffness);
            for (int n = 0; n < 240; ++n) step(d, 1.0 / 240, xpbd, 10);
            const auto p = d.x.reshaped(2, 96).transpose();
            const auto size = p.colwise().maxCoeff() - p.colwise().minCoeff();
            std::printf("%g N/m, %s: %.3f m wide, %.3f m high\n", stiffness,
                        xpbd ? "XPBD" : "soft rows", size[0], size[1]);
        }
}
