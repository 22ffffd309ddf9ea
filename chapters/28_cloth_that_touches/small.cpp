// Chapter 28 in one file, grown from chapter 27: what touches only pushes.
// A cloth, a ball, and the cloth itself; a bound keeps apart what sweeps leave.
//
//     d = Σ w x,  C = n·d − D,  A = Σ w²/m   of a particle and a ball or a triangle
//     ΔΛ = max(0, Λ − C/A) − Λ,  ‖Λ_t‖ ≤ μ Λ   of each
//     r_a + r_b < ‖d‖                            they do not meet on the way
#include <Eigen/Geometry>
#include <array>
#include <cstdio>
#include <fstream>
#include <vector>
using Eigen::Vector3d;
using Vec = Eigen::VectorXd;

struct Spring {  // of particles a and b
    int a, b;
    double length, k, lambda = 0;  // at rest [m]; stiffness [N/m]; Λ [N s²]
};

struct Row {  // of up to four particles; it only pushes
    std::array<int, 4> p;
    std::array<double, 4> w;  // d = Σ w x
    double D, mu = 0;
    Vector3d n = {0, 0, 0}, from = {0, 0, 0};  // from: d at the start of the step
    double A = 0, lambda = 0;
    Vector3d slide = {0, 0, 0};  // Λ_t
};

struct Cloth {
    Vec x, u, inverse_mass;  // three numbers a particle, zero: pinned
    std::vector<Spring> springs = {};
    std::vector<std::array<int, 3>> triangles = {};
    double g = 9.81, D = 0;     // D: how far it stays from itself [m]; 0: it passes
    double radius = 0, mu = 0;  // of its last particle, if that is a ball
    std::vector<Row> contacts = {}, pairs = {};
};

Vector3d at(const Vec& x, int p) { return x.segment<3>(3 * p); }

// (27.11): row by row.
void by_rows(Cloth& c, double h, Vec& x)
{
    for (Spring& s : c.springs) {
        const Vector3d ab = at(x, s.b) - at(x, s.a), n = ab.normalized();
        const double wa = c.inverse_mass[3 * s.a], wb = c.inverse_mass[3 * s.b];
        const double gamma = 1 / (h * h * s.k);
        const double C = ab.norm() - s.length;
        const double change = -(C + gamma * s.lambda) / (wa + wb + gamma);
        s.lambda += change;
        x.segment<3>(3 * s.a) -= wa * change * n;
        x.segment<3>(3 * s.b) += wb * change * n;
    }
}

Vector3d sum(const Row& s, const Vec& x)  // d
{
    Vector3d d = {0, 0, 0};
    for (int i = 0; i < 4; ++i) d += s.w[i] * at(x, s.p[i]);
    return d;
}

// A row of particles that were at x₀ and are pushed along n.
void add(const Cloth& c, Row s, const Vec& x0, std::vector<Row>& rows)
{
    for (int i = 0; i < 4; ++i) s.A += s.w[i] * s.w[i] * c.inverse_mass[3 * s.p[i]];
    s.from = sum(s, x0);
    if (s.A > 0) rows.push_back(s);
}

// Particles that would come near the ball, the last of them, as it moves.
void find_contacts(Cloth& c, const Vec& x0, const Vec& y)
{
    const int ball = int(x0.size()) / 3 - 1;
    c.contacts.clear();
    for (int p = 0; p < ball && c.radius > 0; ++p) {
        const Vector3d d = at(y, p) - at(y, ball);
        if (d.norm() < c.radius + 0.05)
            add(c, {{p, ball}, {1, -1}, c.radius, c.mu, d.normalized()}, x0,
                c.contacts);
    }
}

// Where a triangle is nearest to particle p: the weights of d, 1 of p in all.
std::array<double, 4> nearest(const Vec& x, int p, const std::array<int, 3>& t)
{
    const Vector3d y = at(x, t[0]), e = at(x, t[1]) - y, f = at(x, t[2]) - y,
                   N = e.cross(f) / e.cross(f).squaredNorm(), q = at(x, p) - y;
    const double a = q.cross(f).dot(N), b = e.cross(q).dot(N);
    if (a > 0 && b > 0 && a + b < 1) return {1, a + b - 1, -a, -b};
    std::array<double, 4> best = {};
    double least = 1e9;
    for (int i = 0; i < 3; ++i) {  // or one of its edges
        const int j = (i + 1) % 3;
        const Vector3d r = at(x, p) - at(x, t[i]), g = at(x, t[j]) - at(x, t[i]);
        const double u = std::clamp(g.dot(r) / g.dot(g), 0.0, 1.0);
        if ((r - u * g).norm() >= least) continue;
        least = (r - u * g).norm(), best = {1};
        best[1 + i] = u - 1, best[1 + j] = -u;
    }
    return best;
}

// Particles and triangles, nearest where they are now. (Edges: as in the library.)
void find_pairs(Cloth& c, const Vec& x0)
{
    c.pairs.clear();
    for (const auto& t : c.triangles)
        for (int p = 0; p < int(x0.size()) / 3; ++p) {
            if (c.D == 0 || p == t[0] || p == t[1] || p == t[2]) continue;
            Row s{{p, t[0], t[1], t[2]}, nearest(x0, p, t), c.D};
            s.n = sum(s, x0).normalized();
            add(c, s, x0, c.pairs);
        }
}

// (28.1) and (28.3): the normal only pushes, then the disc of friction.
void visit(const Cloth& c, std::vector<Row>& rows, Vec& x)
{
    for (Row& s : rows) {
        const auto push = [&](const Vector3d& P) {
            for (int i = 0; i < 4; ++i)
                x.segment<3>(3 * s.p[i]) += c.inverse_mass[3 * s.p[i]] * s.w[i] * P;
        };
        const double C = s.n.dot(sum(s, x)) - s.D;
        const double next = std::max(0.0, s.lambda - C / s.A);
        push((next - s.lambda) * s.n), s.lambda = next;
        Vector3d slid = sum(s, x) - s.from;
        slid -= s.n.dot(slid) * s.n;
        Vector3d slide = s.slide - slid / s.A;
        const double size = slide.norm(), most = s.mu * s.lambda;
        if (size > most) slide *= most / size;
        push(slide - s.slide), s.slide = slide;
    }
}

// (28.4): nothing goes farther than 0.45 of a distance, so r_a + r_b < ‖d‖.
void bound_ways(const Cloth& c, const Vec& x0, Vec& x)
{
    for (const Row& s : c.pairs)
        for (const int p : s.p) {
            const Vector3d way = at(x, p) - at(x0, p);
            const double part = 0.45 * s.from.norm() / way.norm();
            if (part < 1) x.segment<3>(3 * p) = at(x0, p) + part * way;
        }
}

// One step. `bound` is false for the mistake: rows alone.
void step(Cloth& c, double h, int sweeps, bool bound)
{
    for (int i = 1; i < c.u.size(); i += 3)
        if (c.inverse_mass[i] > 0) c.u[i] -= c.g * h;
    const Vec x0 = c.x;
    Vec x = x0 + h * c.u;  // where the particles would be without rows
    find_contacts(c, x0, x), find_pairs(c, x0);
    for (Spring& s : c.springs) s.lambda = 0;
    for (int n = 0; n < sweeps; ++n)
        by_rows(c, h, x), visit(c, c.contacts, x), visit(c, c.pairs, x);
    c.u = (x - x0) / h;
    if (bound) bound_ways(c, x0, x);
    c.x = x;
}

// A particle of 1 kg, 10 mm above a ball of 3 kg, at 1 m/s down and 0.3 aside.
Cloth on_ball(double mu)
{
    Cloth c{Vec::Zero(6), Vec::Zero(6), Vec::Ones(6)};
    c.x.head<3>() << -0.03, 0.51, 0;
    c.u.head<3>() << 0.3, -1, 0;
    c.inverse_mass.tail<3>() /= 3;
    c.g = 0, c.mu = mu, c.radius = 0.5;
    return c;
}

// A triangle, and a particle D above and D below its middle; the upper one falls.
Cloth three_layers()
{
    Cloth c{Vec(15), Vec::Zero(15), Vec::Ones(15)};
    c.x << 1, 0, 0, 0, 0, 1, -1, 0, -1, 0, 0.01, 0, 0, -0.01, 0;
    c.u[10] = -2;
    c.triangles = {{0, 1, 2}}, c.g = 0, c.D = 0.01;
    return c;
}

// N by N squares of 1 m / N, level, above a ball that is pinned; 0.2 kg.
Cloth sheet(int N, double k)
{
    const int n = 3 * (N + 1) * (N + 1);
    Cloth c{Vec::Zero(n + 3), Vec::Zero(n + 3), Vec::Constant(n + 3, n / 0.6)};
    c.inverse_mass.tail<3>().setZero(), c.radius = 0.3;
    for (int p = 0; p < n / 3; ++p)
        c.x.segment<3>(3 * p) << 1.0 * (p % (N + 1)) / N - 0.4, 0.31,
            1.0 * (p / (N + 1)) / N - 0.5;
    for (int p = 0; p < n / 3; ++p)
        for (const int q : {p + 1, p + N + 1, p + N + 2})
            if (q < n / 3 && (at(c.x, q) - at(c.x, p)).norm() < 1.5 / N)
                c.springs.push_back({p, q, (at(c.x, q) - at(c.x, p)).norm(), k});
    return c;
}

int main(int count, char** word)
{
    // By hand, section 28.1: after one step of 0.1 s [mm].
    for (const double mu : {0.0, 0.1, 0.5}) {
        Cloth c = on_ball(mu);
        step(c, 0.1, 1, false);
        std::printf("mu %.1f: %6.2f aside, ball %5.2f aside, both %5.1f\n", mu,
                    1000 * c.x[0], 1000 * c.x[3], 1000 * c.x[4]);
    }
    for (const bool bound : {false, true}) {
        Cloth c = three_layers();
        step(c, 0.1, 1, bound);
        std::printf("%s %6.1f %6.1f %6.1f\n", bound ? "bounded" : "by rows",
                    1000 * c.x[10], 1000 * c.x[1], 1000 * c.x[13]);
    }
    // A sheet falls on a ball, not on its middle: without friction and with it.
    std::ofstream out(count < 2 ? "" : word[1]);  // SVG, in parallel projection
    out << "<svg xmlns='http://www.w3.org/2000/svg' fill='none' width='720' "
           "stroke-width='0.006' viewBox='-0.4 -0.4 2.2 1.05'>\n";
    for (const double mu : {0.0, 0.5}) {
        Cloth c = sheet(20, 500);
        c.mu = mu;
        for (int n = 0; n < 300; ++n) step(c, 1.0 / 480, 1, false);
        const Eigen::Map<Eigen::Matrix3Xd> x(c.x.data(), 3, 441);
        std::printf("mu %.1f: its middle is at %.3f m\n", mu, x.row(0).mean());
        const double left = mu > 0 ? 1.3 : 0;
        out << "<circle r='0.3' stroke='#808080' cx='" << left
            << "'/><path stroke='" << (mu > 0 ? "#CC3311" : "#4477AA") << "' d='";
        const auto place = [&](int p) {
            const double z = 0.35 * x(2, p);
            out << left + x(0, p) + z << ' ' << -x(1, p) - z;
        };
        for (const Spring& s : c.springs)
            if (s.length < 0.06) out << 'M', place(s.a), out << 'L', place(s.b);
        out << "'/>\n<text fill='#808080' font-size='0.07' x='" << left - 0.3
            << "' y='0.6'>μ = " << mu << "</text>\n";
    }
    out << "</svg>\n";
}
