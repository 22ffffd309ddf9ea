// Chapter 29 in one file, grown from chapter 12: masses feel only their neighbours.
// A string of them carries waves; so do columns of water, and bodies float on them.
//
//     string   v_i += h c²/Δx² (y_{i-1} - 2 y_i + y_{i+1}),   y_i += h v_i
//     water    u_f -= h g (η_{i+1} - η_i)/Δx,       r_i -= h (q_{i+1} - q_i)/Δx
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <vector>
using Eigen::Vector2d;
using Eigen::Vector3d;
using Vec = Eigen::VectorXd;
using Polygon = std::vector<Vector2d>;  // corners, counterclockwise

struct String {
    double c, dx;
    Vec y, v;  // of all masses; the first and the last are held [m, m/s]
};

// (29.4): chapter 1's two lines. The velocities are half a step before the places.
void leapfrog(String& s, double h)
{
    const double k = s.c * s.c / (s.dx * s.dx);
    for (int i = 1; i + 1 < s.y.size(); ++i)
        s.v[i] += h * k * ((s.y[i - 1] - s.y[i]) + (s.y[i + 1] - s.y[i]));
    for (int i = 1; i + 1 < s.y.size(); ++i) s.y[i] += h * s.v[i];
}

// At rest at y: half a step before, a mass had half a step's velocity less.
String at_rest(const Vec& y, double h)
{
    String s{1, 1, y, Vec::Zero(y.size())};
    leapfrog(s, -h / 2);
    return {1, 1, y, s.v};
}

struct Water {
    double dx, g;
    Vec depth, level, u;  // of cells [m], [m]; of the faces between them [m/s]
};

struct Body {
    Polygon corners;  // from the centroid
    Vector3d x, u, inverse_mass;
};

// The part of a convex polygon where n·p ≤ c.
Polygon cut(const Polygon& p, const Vector2d& n, double c)
{
    Polygon kept;
    for (std::size_t i = 0; i < p.size(); ++i) {
        const Vector2d &a = p[i], &b = p[(i + 1) % p.size()];
        const double sa = n.dot(a) - c, sb = n.dot(b) - c;
        if (sa <= 0) kept.push_back(a);
        if (sa * sb < 0) kept.push_back(a + sa / (sa - sb) * (b - a));
    }
    return kept;
}

Polygon placed(const Body& b)
{
    const Eigen::Rotation2Dd R(b.x[2]);
    Polygon p;
    for (const Vector2d& r : b.corners) p.push_back(b.x.head<2>() + R * r);
    return p;
}

struct Slice {
    int body, cell;
    double area = 0, width = 0;  // under water, and of its waterline
    Vector2d middle = {0, 0};
};

// What of body k is under water in cell i.
Slice slice(const Water& w, const Polygon& whole, int k, int i)
{
    Polygon p = cut(whole, {-1, 0}, -w.dx * i);
    p = cut(cut(p, {1, 0}, w.dx * (i + 1)), {0, 1}, w.level[i]);
    Slice s{k, i};
    for (std::size_t n = 0; n < p.size(); ++n) {
        const Vector2d &a = p[n], &b = p[(n + 1) % p.size()];
        const Vector2d e = a - p[0], f = b - p[0];
        const double area = (e.x() * f.y() - e.y() * f.x()) / 2;
        s.area += area;
        s.middle += area * (e + f) / 3;
        if (std::min(a.y(), b.y()) > w.level[i] - 1e-12)
            s.width += std::abs(b.x() - a.x());
    }
    if (s.area > 0) s.middle = p[0] + s.middle / s.area;
    return s;
}

// (29.15) by Newton's method: bodies lift the surface by half what they displace.
std::vector<Slice> find_slices(Water& w, const std::vector<Body>& bodies,
                               Vec& under)
{
    std::vector<Slice> found;
    for (int round = 0; round < 6; ++round) {
        Vec width = under = 0 * w.depth;
        found.clear();
        for (int k = 0; k < int(bodies.size()); ++k)
            for (int i = 0; i < w.depth.size(); ++i) {
                const Slice s = slice(w, placed(bodies[k]), k, i);
                if (s.area > 0) found.push_back(s);
                under[i] += s.area / w.dx;
                width[i] += s.width / w.dx;
            }
        w.level.array() +=
            (w.depth + under / 2 - w.level).array() / (1 - width.array() / 2);
    }
    return found;
}

void step(Water& w, std::vector<Body>& bodies, double h)
{
    const int n = w.depth.size();
    Vec under;  // b, the thickness of bodies in each cell
    const std::vector<Slice> slices = find_slices(w, bodies, under);
    const auto mean = [](const Vec& v, int f) { return (v[f - 1] + v[f]) / 2; };
    // Slopes push: (29.11), where bodies have their share of the depth, (29.16).
    Vec slope = Vec::Zero(n + 1);
    for (int f = 1; f < n; ++f) {
        slope[f] = (w.level[f] - w.level[f - 1]) / w.dx;
        const double own = mean(w.level, f) - mean(under, f);
        w.u[f] -= h * w.g * slope[f] * own / mean(w.depth, f);
    }
    for (const Slice& s : slices) {  // (29.14): Archimedes, slice by slice
        Body& b = bodies[s.body];
        const Vector2d r = s.middle - b.x.head<2>(),
                       J = h * 1000 * w.g * s.area *
                           Vector2d(-mean(slope, s.cell + 1), 1);
        b.u += b.inverse_mass.cwiseProduct(
            Vector3d(J.x(), J.y(), r.x() * J.y() - r.y() * J.x()));
    }
    for (Body& b : bodies) {
        b.u[1] -= h * w.g;
        b.x += h * b.u;
    }
    // Water flows, (29.12), and takes its momentum along, (29.13).
    Vec q(n + 1), P(n + 1);
    for (int f = 0; f <= n; ++f)
        q[f] = w.u[f] * w.depth[std::clamp(w.u[f] >= 0 ? f - 1 : f, 0, n - 1)];
    const auto through = [&](int i) {
        const double m = (q[i] + q[i + 1]) / 2;
        return m * (m >= 0 ? w.u[i] : w.u[i + 1]);
    };
    for (int f = 1; f < n; ++f)
        P[f] = mean(w.depth, f) * w.u[f] - h / w.dx * (through(f) - through(f - 1));
    w.depth -= h / w.dx * (q.tail(n) - q.head(n));
    for (int f = 1; f < n; ++f) w.u[f] = P[f] / mean(w.depth, f);
}

// A box of half the water's density, upright and half under water, tilted a little.
Body box(double x, double width, double height)
{
    const double a = width / 2, b = height / 2, mass = 500 * width * height;
    return {{{-a, -b}, {a, -b}, {a, b}, {-a, b}},
            {x, 1, 0.02},
            {0, 0, 0},
            Vector3d(1, 1, 3 / (a * a + b * b)) / mass};
}

// A pond 8 m long and 1 m deep with 30 cm more at its left end, and two boxes.
Water pond(int n, const std::vector<Body>& bodies)
{
    Water w{8.0 / n, 9.81, Vec::Ones(n), Vec::Ones(n), Vec::Zero(n + 1)};
    for (const Body& b : bodies)
        for (int i = 0; i < n; ++i)
            w.depth[i] -= slice(w, placed(b), 0, i).area / (2 * w.dx);
    for (Vec* v : {&w.depth, &w.level}) v->head(n / 6).array() += 0.3;
    return w;
}

int main(int count, char** word)
{
    // By hand, section 29.1: three masses, c = Δx = 1, the middle one 1 m out.
    for (const double h : {1.0, 1.2}) {
        String s = at_rest(Vec{{0, 0, 1, 0, 0}}, h);
        std::printf("h = %g s\n", h);
        for (int n = 0; n <= 4; ++n, leapfrog(s, h))
            std::printf("    %6.3f %6.3f %6.3f\n", s.y[1], s.y[2], s.y[3]);
    }
    std::vector<Body> boxes{box(3.01, 0.9, 0.5), box(5.51, 0.5, 0.5)};
    Water w = pond(80, boxes);
    const double volume = w.depth.sum() * w.dx;
    std::ofstream out(count < 2 ? "" : word[1]);  // an SVG picture, y upwards
    out << "<svg xmlns='http://www.w3.org/2000/svg' fill='none' "
           "width='720' stroke-width='0.03' viewBox='-0.1 -1.7 8.2 3.6'>\n";
    for (const double y : {-0.1, 1.8}) {  // at the start, and after four seconds
        for (double t = 0; y > 0 && t < 4; t += 0.005) step(w, boxes, 0.005);
        out << "<g transform='translate(0 " << y << ") scale(1 -1)'>\n"
            << "<path stroke='#808080' d='M0 1.5V0H8V1.5'/>\n"
            << "<polyline stroke='#4477AA' points='";
        for (int i = 0; i < w.level.size(); ++i)
            out << w.dx * (i + 0.5) << ',' << w.level[i] << ' ';
        out << "'/>\n";
        for (const Body& b : boxes) {
            out << "<polygon stroke='#EE7733' points='";
            for (const Vector2d& p : placed(b)) out << p.x() << ',' << p.y() << ' ';
            out << "'/>\n";
        }
        out << "</g>\n<text fill='#808080' font-size='0.26' x='6.6' y='" << y - 1.2
            << "'>" << (y > 0 ? "after 4 s" : "at first") << "</text>\n";
    }
    out << "</svg>\n";
    for (const Body& b : boxes)
        std::printf("box at %.3f m, %.3f m, %.3f rad\n", b.x[0], b.x[1], b.x[2]);
    std::printf("water lost: %.1e of it\n", 1 - w.depth.sum() * w.dx / volume);
}
