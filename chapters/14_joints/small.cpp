// Chapter 14 in one file, grown from chapter 11: a joint, a few rows on two bodies.
// Some hold what it does not leave free, others bound or drive what it does.
//     w = J_a u_a + J_b u_b + b,   lo ≤ λ ≤ hi:   λ = lo, λ = hi or w = 0
#include <Eigen/Core>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <vector>
using Eigen::RowVector3d;
using Eigen::Vector2d;
using Eigen::Vector3d;
using Vec = Eigen::VectorXd;
using Path = std::pair<const char*, std::vector<Vector2d>>;  // a colour and points

enum class Kind { pin, slider, weld, rope };

struct Joint {
    Kind kind;
    int a, b;             // its bodies
    Vector2d at_a, at_b;  // its points, in the axes of a and of b
    double lower = -INFINITY, upper = INFINITY;  // limits of what it leaves free, q
    double speed = 0, force = 0;  // of a motor: the wanted dq/dt; at most; 0: none
    Vector2d axis = {1, 0};       // of a slider, in the axes of a
};

struct Row {
    int a, b;
    RowVector3d Ja, Jb;                       // (11.6)
    double C, lo = -INFINITY, hi = INFINITY;  // error or gap [m, rad]; bounds of λ
    double bias = 0, lambda = 0;              // [m/s, rad/s], [N s, N m s]
};

struct Bodies {
    Vec x, u, inverse_mass;  // three numbers a body: x, y, angle; body 0: the world
    std::vector<Joint> joints;
    double g = 9.81;
    std::vector<Row> rows = {};  // of the last step
};

// (11.1): r = R(θ) r̄
Vector2d turned(double theta, const Vector2d& r)
{
    const double c = std::cos(theta), s = std::sin(theta);
    return {c * r.x() - s * r.y(), s * r.x() + c * r.y()};
}

// (11.6): the row of the point at r from the centroid, along n.
RowVector3d row(const Vector2d& r, const Vector2d& n)
{
    return {n.x(), n.y(), r.x() * n.y() - r.y() * n.x()};
}

// What a joint holds, and what acts on its q.
void add_rows(const Bodies& d, const Joint& j, double h, std::vector<Row>& rows)
{
    const int a = j.a, b = j.b;
    const Vector2d ra = turned(d.x[3 * a + 2], j.at_a);
    const Vector2d rb = turned(d.x[3 * b + 2], j.at_b),
                   axis = turned(d.x[3 * a + 2], j.axis);
    const Vector2d gap = d.x.segment<2>(3 * b) + rb - d.x.segment<2>(3 * a) - ra;
    // C = n·(p_b − p_a); where n turns with a, a is pushed at p_b too (11.13)
    const auto along = [&](const Vector2d& n, bool turns) {
        const Vector2d arm = turns ? Vector2d(ra + gap) : ra;
        return Row{a, b, -row(arm, n), row(rb, n), n.dot(gap)};
    };
    const Row angle{a, b, {0, 0, -1}, {0, 0, 1}, d.x[3 * b + 2] - d.x[3 * a + 2]};
    // what it does not leave free: C = 0
    if (j.kind == Kind::pin || j.kind == Kind::weld)
        rows.push_back(along({1, 0}, false)), rows.push_back(along({0, 1}, false));
    if (j.kind == Kind::slider) rows.push_back(along({-axis.y(), axis.x()}, true));
    if (j.kind == Kind::slider || j.kind == Kind::weld) rows.push_back(angle);
    if (j.kind == Kind::weld) return;
    // what it leaves free: q, with limits and a motor
    const Row q = j.kind == Kind::pin      ? angle
                  : j.kind == Kind::slider ? along(axis, true)
                                           : along(gap.normalized(), false);
    const auto limit = [&](double sense, double at) {  // λ only pushes
        if (std::isinf(at)) return;
        rows.push_back({a, b, sense * q.Ja, sense * q.Jb, sense * (q.C - at), 0});
    };
    limit(1, j.lower), limit(-1, j.upper);  // q − lower ≥ 0, upper − q ≥ 0
    if (j.force > 0)                        // w = 0 is the speed
        rows.push_back({a, b, q.Ja, q.Jb, -h * j.speed, -h * j.force, h * j.force});
}

// (11.5): an impulse along J changes the velocity and the spin.
void push(const Row& c, double impulse, Bodies& d)
{
    for (const auto& [k, J] : {std::pair{c.a, c.Ja}, {c.b, c.Jb}})
        d.u.segment<3>(3 * k) +=
            impulse * d.inverse_mass.segment<3>(3 * k).cwiseProduct(J.transpose());
}

// One visit: (6.2) to (6.5). Returns by how much the row was off [m/s].
double visit(Row& c, Bodies& d)
{
    const Vector3d ma = d.inverse_mass.segment<3>(3 * c.a);
    const Vector3d mb = d.inverse_mass.segment<3>(3 * c.b);
    const double w = c.bias + c.Ja.dot(d.u.segment<3>(3 * c.a)) +
                     c.Jb.dot(d.u.segment<3>(3 * c.b));
    const double A = c.Ja.cwiseAbs2().dot(ma) + c.Jb.cwiseAbs2().dot(mb);  // (11.7)
    const double change = std::clamp(c.lambda - w / A, c.lo, c.hi) - c.lambda;
    c.lambda += change;
    push(c, change, d);
    return A * std::abs(change);
}

int step(Bodies& d, double h, double beta, int most = 100000)
{
    for (int k = 4; k < d.u.size(); k += 3) d.u[k] -= d.g * h;  // u*, (3.4)
    std::vector<Row> rows;
    for (const Joint& j : d.joints) add_rows(d, j, h, rows);
    for (Row& c : rows) {
        const bool error = c.lo == 0 ? c.C < 0 : c.lo == -INFINITY;
        c.bias = (error ? beta : 1) * c.C / h;  // (7.4), (3.30)
        if (d.rows.size() == rows.size())       // each step has the same rows
            push(c, c.lambda = d.rows[&c - &rows[0]].lambda, d);
    }
    int sweeps = 0;
    for (double off = 1; off > 1e-6 && sweeps < most; ++sweeps) {
        off = 0;
        for (Row& c : rows) off = std::max(off, visit(c, d));
    }
    d.x += h * d.u;  // (1.10)
    d.rows = rows;
    return sweeps;
}

// A uniform box of half sizes w, h at (x, y, angle), or a rod, of which h is zero.
void add_box(Bodies& d, double w, double h, double mass, const Vector3d& at)
{
    const int n = d.x.size();
    for (Vec* v : {&d.x, &d.u, &d.inverse_mass}) v->conservativeResize(n + 3);
    d.x.tail<3>() = at, d.u.tail<3>().setZero();
    d.inverse_mass.tail<3>() = Vector3d(1, 1, 3 / (w * w + h * h)) / mass;
}

// A door of 1 m and 3 kg, seen from above: a pin, a stop, a motor.
Bodies door(double stop)
{
    Bodies d{Vec::Zero(3), Vec::Zero(3), Vec::Zero(3), {}, 0};
    add_box(d, 0.5, 0, 3, {0.5, 0, 0});
    d.joints = {{Kind::pin, 0, 1, {0, 0}, {-0.5, 0}, -INFINITY, stop, 1, 1}};
    return d;
}

// A trolley on a rail, driven to its stop; on it a rod, a box, a ball on a rope.
Bodies trolley()
{
    Bodies d{Vec::Zero(3), Vec::Zero(3), Vec::Zero(3), {}};
    add_box(d, 0.15, 0.05, 10, {-1, 0, 0});
    add_box(d, 0, 0.4, 1, {-1, -0.4, 0});
    add_box(d, 0.15, 0.1, 2, {-1, -0.9, 0});
    add_box(d, 0.06, 0.06, 1, {-1, -1.3, 0});
    d.joints = {{Kind::slider, 0, 1, {0, 0}, {0, 0}, -1, 1, 1.5, 100},
                {Kind::pin, 1, 2, {0, 0}, {0, 0.4}},
                {Kind::weld, 2, 3, {0, -0.4}, {0, 0.1}},
                {Kind::rope, 3, 4, {0, -0.1}, {0, 0}, -INFINITY, 0.3}};
    return d;
}

int main(int count, char** word)
{
    // By hand, section 14.1: a step of 0.1 s far from the stop, and 5 mrad away.
    for (const double stop : {1.0, 0.005}) {
        Bodies d = door(stop);
        const int n = step(d, 0.1, 1);
        std::printf("pin %.4f, stop %.4f, motor %.4f; omega %.4f; %d sweeps\n",
                    d.rows[1].lambda, d.rows[2].lambda, d.rows[3].lambda, d.u[5],
                    n);
    }
    std::vector<Path> paths{{"#808080", {{-1.2, 0}, {1.2, 0}}}};
    Bodies closing = door(1), d = trolley();
    for (int n = 0; n <= 480; ++n) {
        if (n % 60 == 0) {
            const char* colour = n < 480 ? "#808080" : "#4477AA";
            const Vector2d pin(-2.5, -1), end = pin + 2 * closing.x.segment<2>(3);
            paths.push_back({colour, {pin, end}});
            paths.push_back({colour, {}});
            for (const Joint& j : d.joints)
                paths.back().second.push_back(d.x.segment<2>(3 * j.b) +
                                              turned(d.x[3 * j.b + 2], j.at_b));
            std::printf("%4.2f s: door %.3f; trolley %.3f m, rod %.3f\n", n / 240.0,
                        closing.x[5], d.x[3], d.x[8]);
        }
        step(closing, 1.0 / 240, 0.2), step(d, 1.0 / 240, 0.2);
    }
    std::ofstream out(count < 2 ? "" : word[1]);  // an SVG picture, y upwards
    out << "<svg xmlns='http://www.w3.org/2000/svg' fill='none' "
           "width='480' stroke-width='0.02' viewBox='-2.7 -0.3 4.8 1.9'>\n";
    for (const auto& [colour, points] : paths) {
        out << "<polyline stroke='" << colour << "' points='";
        for (const Vector2d& p : points) out << p.x() << ',' << -p.y() << ' ';
        out << "'/>\n";
    }
    out << "<g fill='#808080' font-size='.13'><text x='-2.6' y='1.17'>pin</text>"
           "<text x='-1.9' y='.15'>stop</text><text x='1' y='-.06'>stop</text>"
           "<text x='-1' y='-.06'>slider</text><text x='-1.34' y='.85'>weld</text>"
           "<text x='-1.33' y='1.2'>rope</text></g></svg>\n";
}
