// Chapter 22 in one file, grown from chapter 20: how far apart two solids are.
// Two solids are one point, the origin, and the solid of their differences.
//
//     d = min ‖p_b − p_a‖ = distance of the origin to B − A, (22.1), by corners:
//     v = nearest point of the simplex so far,  y = corner that lies lowest along v
//     s(n) = lowest of B − highest of A along n, (22.3): for solids that overlap
#include <Eigen/Geometry>
#include <Eigen/LU>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <numbers>
#include <string>
#include <vector>
using Eigen::Matrix3Xd;
using Eigen::Quaterniond, Eigen::Vector3d;
using Vec = Eigen::VectorXd;
using Mat = Eigen::MatrixXd;

struct Solid {
    Matrix3Xd corners, normals, edges;  // directions of edges; seen from the world
};

// A corner of B − A, with the two that it is made of, and its part of v.
struct Corner {
    Vector3d a, b;
    double weight = 1;
    Vector3d y() const { return b - a; }
};

struct Nearest {
    Vector3d on_a, on_b;
    double distance;
    std::vector<Vector3d> v;  // of each round
};

// (20.3): the rotation of a rotation vector.
Quaterniond exp(const Vector3d& theta)
{
    return Quaterniond(Eigen::AngleAxisd(theta.norm(), theta.normalized()));
}

// The corner that lies farthest along n; of several the first.
Vector3d support(const Solid& p, const Vector3d& n)
{
    int best = 0;
    for (int i = 1; i < p.corners.cols(); ++i)
        if (n.dot(p.corners.col(i)) > n.dot(p.corners.col(best))) best = i;
    return p.corners.col(best);
}

// (22.2): the point of the simplex that is nearest to the origin; what has no part
// of it leaves. Each part of the simplex has a nearest point of its line or plane.
Vector3d nearest_of(std::vector<Corner>& simplex)
{
    std::vector<Corner> best;
    Vector3d nearest(INFINITY, 0, 0);
    for (int part = 1; part < 1 << simplex.size(); ++part) {
        std::vector<Corner> some;
        for (int i = 0; i < int(simplex.size()); ++i)
            if (part >> i & 1) some.push_back(simplex[i]);
        const int n = some.size() - 1;
        Mat D(3, n);
        for (int j = 0; j < n; ++j) D.col(j) = some[j + 1].y() - some[0].y();
        Vec t(n);
        if (n > 0) {
            const Mat G = D.transpose() * D;
            if (!(G.determinant() > 1e-14 * G.diagonal().prod())) continue;
            t = G.inverse() * -(D.transpose() * some[0].y());
        }
        some[0].weight = 1 - t.sum();
        for (int j = 0; j < n; ++j) some[j + 1].weight = t[j];
        bool inside = true;
        Vector3d v(0, 0, 0);
        for (const Corner& c : some)
            inside = inside && c.weight > 0, v += c.weight * c.y();
        if (inside && v.norm() < nearest.norm()) nearest = v, best = some;
    }
    simplex = best;
    return nearest;
}

// Algorithm 22.1.
Nearest nearest_points(const Solid& a, const Solid& b)
{
    std::vector<Corner> simplex{{a.corners.col(0), b.corners.col(0)}};
    Vector3d v = nearest_of(simplex);
    Nearest found;
    found.v = {v};
    for (int round = 0; round < 128; ++round) {
        const Corner next{support(a, v), support(b, -v)};
        if (v.dot(next.y()) >= (1 - 1e-15) * v.squaredNorm()) break;
        std::vector<Corner> more = simplex;
        more.push_back(next);
        const Vector3d nearer = nearest_of(more);
        if (!(nearer.norm() < v.norm())) break;
        v = nearer, simplex = more;
        found.v.push_back(v);
        if (simplex.size() == 4 || v.norm() < 1e-14) v.setZero();
        if (v.isZero(0)) break;
    }
    found.on_a.setZero(), found.on_b.setZero();
    for (const Corner& c : simplex)
        found.on_a += c.weight * c.a, found.on_b += c.weight * c.b;
    found.distance = v.norm();
    return found;
}

// (22.3): how far the solids are apart along n.
double separation(const Solid& a, const Solid& b, const Vector3d& n)
{
    return n.dot(support(b, -n)) - n.dot(support(a, n));
}

// (22.4): the best of all normals and of all directions across two edges.
Vector3d best_axis(const Solid& a, const Solid& b)
{
    std::vector<Vector3d> axes;
    for (const Solid* p : {&a, &b})
        for (int i = 0; i < p->normals.cols(); ++i)
            axes.push_back(p->normals.col(i));
    for (int i = 0; i < a.edges.cols(); ++i)
        for (int j = 0; j < b.edges.cols(); ++j) {
            const Vector3d n = a.edges.col(i).cross(b.edges.col(j));
            if (n.norm() > 1e-6) axes.push_back(n.normalized());
        }
    Vector3d best = axes[0];
    for (const Vector3d& n : axes)
        for (const double sign : {1.0, -1.0})
            if (separation(a, b, sign * n) > separation(a, b, best))
                best = sign * n;
    return best;
}

// A triangle in the plane z = 0.
Solid triangle(double ax, double ay, double bx, double by, double cx, double cy)
{
    Solid p;
    p.corners.resize(3, 3);
    p.corners << ax, bx, cx, ay, by, cy, 0, 0, 0;
    return p;
}

// A box with the edges e at a place.
Solid box(const Vector3d& e, const Vector3d& at, const Vector3d& theta)
{
    Solid p;
    p.normals = p.edges = exp(theta).toRotationMatrix();
    p.corners.resize(3, 8);
    for (int k = 0; k < 8; ++k)
        p.corners.col(k) = at + p.normals * Vector3d(e[0] * ((k & 1) - 0.5),
                                                     e[1] * ((k >> 1 & 1) - 0.5),
                                                     e[2] * ((k >> 2 & 1) - 0.5));
    return p;
}

int main(int count, char** word)
{
    // By hand, section 22.1: two triangles.
    const Solid a = triangle(0, 0, 4, 4, 1, 3), b = triangle(5, 1, 8, 2, 5, 5);
    const Nearest near = nearest_points(a, b);
    for (const Vector3d& v : near.v) std::printf("v = (%g, %g)\n", v[0], v[1]);
    std::printf("distance %g, from (%g, %g) to (%g, %g)\n", near.distance,
                near.on_a[0], near.on_a[1], near.on_b[0], near.on_b[1]);
    // Section 22.3: two cubes that stand on edges, apart and overlapping by 0.1 m.
    const double eighth = std::numbers::pi / 4, touch = 2 * std::sqrt(2.0);
    const Solid low = box({2, 2, 2}, {0, 0, 0}, {0, 0, eighth});
    for (const double gap : {0.1, -0.1}) {
        const Solid high = box({2, 2, 2}, {0, touch + gap, 0}, {eighth, 0, 0});
        const Vector3d n = best_axis(low, high);
        double face = -INFINITY;
        for (const Solid* p : {&low, &high})
            for (int i = 0; i < 6; ++i)
                face = std::max(
                    face, separation(low, high,
                                     (i % 2 ? 1 : -1) * p->normals.col(i / 2)));
        std::printf("distance %.4f, s %.4f along (%.0f, %.0f, %.0f), faces %.4f\n",
                    nearest_points(low, high).distance, separation(low, high, n),
                    std::abs(n[0]), n[1], std::abs(n[2]), face);
    }
    // The triangles; and B − A, with the v of each round.
    std::ofstream out(count < 2 ? "" : word[1]);  // SVG
    out << "<svg xmlns='http://www.w3.org/2000/svg' width='720' "
           "stroke-width='0.06' "
           "fill='none' font-size='0.5' viewBox='-0.6 -5.7 19.4 9.3'>\n";
    const auto line = [&out](const Vector3d& p, const Vector3d& q, double right,
                             const std::string& style) {
        out << "<path d='M" << p[0] + right << ' ' << -p[1] << 'L' << q[0] + right
            << ' ' << -q[1] << "' " << style << "/>\n";
    };
    for (int i = 0; i < 3; ++i) {
        line(a.corners.col(i), a.corners.col((i + 1) % 3), 0, "stroke='#4477AA'");
        line(b.corners.col(i), b.corners.col((i + 1) % 3), 0, "stroke='#EE7733'");
    }
    line(near.on_a, near.on_b, 0, "stroke='#CC3311' stroke-width='0.12'");
    std::vector<Vector3d> y;
    for (int i = 0; i < 9; ++i)
        y.push_back(b.corners.col(i / 3) - a.corners.col(i % 3));
    for (const Vector3d& p : y) {
        out << "<circle cx='" << p[0] + 10 << "' cy='" << -p[1]
            << "' r='0.1' fill='#228833'/>\n";
        for (const Vector3d& q : y) {  // a side, if no difference lies beyond it
            bool side = (q - p).norm() > 0;
            for (const Vector3d& r : y)
                side = side && (q - p).cross(r - p).z() >= 0;
            if (side) line(p, q, 10, "stroke='#228833'");
        }
    }
    for (int i = 0; i < int(near.v.size()); ++i) {
        const Vector3d v = near.v[i], place = v + 0.35 * v.normalized();
        const bool last = i + 1 == int(near.v.size());
        line(Vector3d::Zero(), v, 10,
             last ? "stroke='#CC3311' stroke-width='0.12'" : "stroke='#808080'");
        out << "<text fill='#808080' text-anchor='middle' x='" << place[0] + 10
            << "' y='" << 0.15 - place[1] << "'>" << i << "</text>\n";
    }
    const auto name = [&out](double x, double y, const char* text) {
        out << "<text fill='#808080' x='" << x << "' y='" << y << "'>" << text
            << "</text>\n";
    };
    name(1.2, -1.9, "A"), name(5.8, -2.5, "B"), name(14.8, -3.4, "B − A");
    out << "<circle cx='10' cy='0' r='0.14' fill='#808080'/>\n</svg>\n";
}
