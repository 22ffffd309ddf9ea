// Chapter 11 in one file, grown from chapter 8: bodies turn; J has a third column.
//
//     J = (n, r × n),   w = J u + b,   u ← u + M⁻¹ Jᵀ Δλ
//     corner on a wall: λ ≥ 0, w ≥ 0, λ w = 0
#include <Eigen/Core>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <numbers>
#include <vector>
using Eigen::Vector2d;
using Eigen::Vector3d;
using Vec = Eigen::VectorXd;
using Mat = Eigen::MatrixXd;
using Path = std::pair<const char*, std::vector<Vector2d>>;  // a colour and points

struct Contact {
    int a, b, name;        // body b, a wall a: -1, -2, …, and which corner of b
    Eigen::RowVector3d J;  // of body b, (11.6)
    double C, lo;          // gap [m]; bound of λ
    double bias = 0, lambda = 0;  // [m/s], [N s]
};

struct Bodies {
    Vec x, u, inverse_mass;  // three numbers a body: x, y, angle
    std::vector<std::vector<Vector2d>> corners;  // from the centroid, at angle 0
    Mat walls;  // columns n, c: where n·p ≥ c it is free
    double g = 9.81;
    std::vector<Contact> contacts = {};  // of the last step
};

// (11.1): r = R(θ) r̄
Vector2d turned(double theta, const Vector2d& r)
{
    const double c = std::cos(theta), s = std::sin(theta);
    return {c * r.x() - s * r.y(), s * r.x() + c * r.y()};
}

// (11.6): the row of the point at r from the centroid, along n.
Eigen::RowVector3d row(const Vector2d& r, const Vector2d& n)
{
    return {n.x(), n.y(), r.x() * n.y() - r.y() * n.x()};
}

// Corners and walls, with gaps below 2 cm.
std::vector<Contact> find_contacts(const Bodies& d)
{
    std::vector<Contact> found;
    for (int b = 0; b < int(d.corners.size()); ++b)
        for (int k = 0; k < int(d.corners[b].size()); ++k)
            for (int i = 0; i < d.walls.cols(); ++i) {
                const Vector2d n = d.walls.col(i).head<2>();
                const Vector2d r = turned(d.x[3 * b + 2], d.corners[b][k]);
                const double C = n.dot(d.x.segment<2>(3 * b) + r) - d.walls(2, i);
                if (C < 0.02) found.push_back({-1 - i, b, k, row(r, n), C, 0});
            }
    return found;
}

// (11.5): an impulse along J changes the velocity and the spin.
void push(const Contact& c, double impulse, Bodies& d)
{
    const Vector3d m = d.inverse_mass.segment<3>(3 * c.b);
    d.u.segment<3>(3 * c.b) += impulse * m.cwiseProduct(c.J.transpose());
}

// One visit: (6.2) to (6.5). Returns by how much the row was off [m/s].
double visit(Contact& c, Bodies& d)
{
    const Vector3d m = d.inverse_mass.segment<3>(3 * c.b);
    const double w = c.bias + c.J * d.u.segment<3>(3 * c.b);
    const double A = c.J.cwiseAbs2() * m;  // (11.7)
    const double change = std::max(c.lo, c.lambda - w / A) - c.lambda;
    c.lambda += change;
    push(c, change, d);
    return A * std::abs(change);
}

int step(Bodies& d, double h, double beta, int most = 100000)
{
    for (int k = 1; k < d.u.size(); k += 3) d.u[k] -= d.g * h;  // u*, (3.4)
    std::vector<Contact> contacts = find_contacts(d);
    for (Contact& c : contacts) {
        c.bias = (c.C < 0 ? beta : 1) * c.C / h;  // (7.4), (3.30)
        for (const Contact& old : d.contacts)     // its key: which two touch, where
            if (old.a == c.a && old.b == c.b && old.name == c.name)
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

// A uniform box of half sizes w, h at (x, y, angle), or a rod, of which h is zero.
void add_box(Bodies& d, double w, double h, double mass, const Vector3d& at)
{
    for (Vec* v : {&d.x, &d.u, &d.inverse_mass})
        v->conservativeResize(3 * d.corners.size() + 3);
    d.x.tail<3>() = at, d.u.tail<3>().setZero();
    d.inverse_mass.tail<3>() = Vector3d(1, 1, 3 / (w * w + h * h)) / mass;
    d.corners.push_back({{-w, -h}, {w, -h}, {w, h}, {-w, h}});
    if (h == 0) d.corners.back().resize(2);
}

int main(int count, char** word)
{
    // By hand, section 11.1: a rod at 30 degrees falls at 1 m/s and is struck.
    Bodies rod{{}, {}, {}, {}, Vec{{0, 1, 0}}};
    add_box(rod, 0.5, 0, 1, {0, 0.25, std::numbers::pi / 6});
    rod.u[1] = -1;
    Contact c = find_contacts(rod)[0];
    c.bias = 0.5 * c.J.dot(rod.u);  // e = 1/2
    std::vector<Path> paths{{"#808080", {{-0.6, 0}, {0.7, 0}}}};
    for (const char* colour : {"#808080", "#4477AA"}) {
        std::printf("v %g m/s, omega %g rad/s\n", rod.u[1], rod.u[2]);
        paths.push_back({"#808080", {}});
        for (double s = -0.5; s < 0.51; s += 0.125) {
            const Vector2d r = turned(rod.x[2], {s, 0}), p = rod.x.head<2>() + r;
            const Vector2d v = rod.u.head<2>() + rod.u[2] * Vector2d(-r.y(), r.x());
            paths.push_back({colour, {p, p + 0.2 * v}});
            paths[1].second.push_back(p);
        }
        visit(c, rod);
    }
    std::printf("lambda %g N s\n", c.lambda);
    const Vector2d middle = rod.x.head<2>(), end = paths[1].second[0];
    paths.push_back({"#EE7733", {end, {middle.x(), end.y()}, middle}});  // the arm
    paths.push_back({"#CC3311", {end, end + Vector2d(0, 0.4 * c.lambda)}});

    // Under its weight the rod falls flat, and a box beside it.
    Bodies d{{}, {}, {}, {}, Vec{{0, 1, 0}}};
    add_box(d, 0.5, 0, 1, {0, 0.3, std::numbers::pi / 6});
    add_box(d, 0.2, 0.1, 1, {-0.9, 1, 0.5});
    int sweeps = 0;
    for (int n = 1; n <= 240; ++n) {
        sweeps += step(d, 1.0 / 240, 0.2);
        if (n % 60 == 0)
            std::printf("%4.2f s: rod %.3f m, %.3f rad; box %.3f m, %.3f rad\n",
                        n / 240.0, d.x[1], d.x[2], d.x[4], d.x[5]);
    }
    std::printf("%d sweeps; x %g and %g m\n", sweeps, d.x[0], d.x[3]);
    if (count < 2) return 0;
    std::ofstream out(word[1]);  // an SVG picture of the paths; y points upwards
    out << "<svg xmlns='http://www.w3.org/2000/svg' fill='none' "
           "width='400' stroke-width='0.01' viewBox='-0.7 -0.7 1.5 0.9'>\n";
    for (const auto& [colour, points] : paths) {
        out << "<polyline stroke='" << colour << "' points='";
        for (const Vector2d& p : points) out << p.x() << ',' << -p.y() << ' ';
        out << "'/>\n";
    }
    out << "<g fill='#808080' font-size='0.05'><text x='-0.31' y='-.01'>30°</text>"
           "<text x='-0.2' y='0.06'>arm</text><text x='-0.43' y='-0.2'>λ</text>"
           "</g></svg>\n";
}
