// Chapter 12 in one file, grown from chapter 11: bodies touch at two points.
// Points have names, so that each finds its impulse again. The floor is a body too.
//
//     J = (-n, -r_a × n, n, r_b × n),   w = J u + b,   λ ≥ 0, w ≥ 0, λ w = 0
#include <Eigen/Geometry>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <vector>
using Eigen::Vector2d;
using Eigen::Vector3d;
using Vec = Eigen::VectorXd;
using Polygon = Eigen::Matrix2Xd;  // corners, counterclockwise

struct Contact {
    int a, b, name;               // two bodies; which of their points it is
    Vector2d p;                   // the point
    Eigen::RowVector3d Ja, Jb;    // (12.4)
    double C;                     // gap [m]
    double bias = 0, lambda = 0;  // [m/s], [N s]
};

struct Bodies {
    Vec x, u, inverse_mass;        // three numbers a body: x, y, angle
    std::vector<Polygon> corners;  // from the centroid, at angle 0
    double g = 9.81;
    int points = 2;                      // of a pair, at most: the deepest
    std::vector<Contact> contacts = {};  // of the last step
};

// (11.1): the corners of body b where it is now.
Polygon placed(const Bodies& d, int b)
{
    const Eigen::Matrix2d R(Eigen::Rotation2Dd(d.x[3 * b + 2]));
    return (R * d.corners[b]).colwise() + d.x.segment<2>(3 * b);
}

// (11.6): the row of the point at r from the centroid, along n.
Eigen::RowVector3d row(const Vector2d& r, const Vector2d& n)
{
    return {n.x(), n.y(), r.x() * n.y() - r.y() * n.x()};
}

// Outward normals; edge i leads from corner i to the next.
Polygon normals(const Polygon& p)
{
    Polygon next(2, p.cols()), n(2, p.cols());
    next << p.rightCols(p.cols() - 1), p.col(0);
    n << (next - p).row(1), (p - next).row(0);
    return n.colwise().normalized();
}

// (12.1): the separations s_i = min_j n_i·(w_j − v_i) of p's edges from q.
Vec separations(const Polygon& p, const Polygon& q)
{
    const Polygon n = normals(p);
    const Vec own = n.cwiseProduct(p).colwise().sum();
    return (n.transpose() * q).rowwise().minCoeff() - own;
}

// Two faces have an interval in common along t = n⊥, (12.3). Its ends are the
// points, each called by the corner that ends there: b's, if both do within 2 mm.
void collide(const Bodies& d, int a, int b, std::vector<Contact>& found)
{
    const Polygon P = placed(d, a), Q = placed(d, b);
    int i, j;
    const double sa = separations(P, Q).maxCoeff(&i);
    const double sb = separations(Q, P).maxCoeff(&j);
    if (std::max(sa, sb) >= 0.02) return;
    Vector2d n = normals(P).col(i);
    if (sb > sa + 2e-3) n = -normals(Q).col(j);
    const Vector2d t(-n.y(), n.x());
    (n.transpose() * normals(P)).maxCoeff(&i);  // the edges that face each other
    (-n.transpose() * normals(Q)).maxCoeff(&j);
    const int i2 = (i + 1) % P.cols(), j2 = (j + 1) % Q.cols();
    const auto at = [&](const Vector2d& v, const Vector2d& w, double tau) {
        return Vector2d(v + (tau - t.dot(v)) / t.dot(w - v) * (w - v));
    };
    const double low = std::max(t.dot(P.col(i)), t.dot(Q.col(j2)));
    const double high = std::min(t.dot(P.col(i2)), t.dot(Q.col(j)));
    const std::size_t before = found.size();
    for (const auto& [tau, of_a, of_b] : {std::tuple{high, i2, j}, {low, i, j2}}) {
        const Vector2d pa = at(P.col(i), P.col(i2), tau);
        const Vector2d pb = at(Q.col(j), Q.col(j2), tau), p = (pa + pb) / 2;
        const double C = n.dot(pb - pa);
        const bool ends_b = std::abs(tau - t.dot(Q.col(of_b))) < 2e-3;
        if (low <= high && C < 0.02)
            found.push_back({a, b, ends_b ? int(P.cols()) + of_b : of_a, p,
                             -row(p - d.x.segment<2>(3 * a), n),
                             row(p - d.x.segment<2>(3 * b), n), C});
    }
    if (found.size() > before + d.points)  // the deeper one alone
        found.erase(found.end() - 1 - (found.back().C < found[before].C));
}

std::vector<Contact> find_contacts(const Bodies& d)
{
    std::vector<Contact> found;
    for (int b = 1; b < int(d.corners.size()); ++b)
        for (int a = 0; a < b; ++a) collide(d, a, b, found);
    return found;
}

// (11.5): an impulse along J changes the velocities and the spins.
void push(const Contact& c, double impulse, Bodies& d)
{
    for (const auto& [k, J] : {std::pair{3 * c.a, c.Ja}, {3 * c.b, c.Jb}})
        d.u.segment<3>(k) +=
            impulse * d.inverse_mass.segment<3>(k).cwiseProduct(J.transpose());
}

// One visit: (6.2) to (6.5). Returns by how much the row was off [m/s].
double visit(Contact& c, Bodies& d)
{
    double w = c.bias, A = 0;  // (11.7)
    for (const auto& [k, J] : {std::pair{3 * c.a, c.Ja}, {3 * c.b, c.Jb}}) {
        w += J * d.u.segment<3>(k);
        A += J.cwiseAbs2() * d.inverse_mass.segment<3>(k);
    }
    const double change = std::max(0.0, c.lambda - w / A) - c.lambda;
    c.lambda += change;
    push(c, change, d);
    return A * std::abs(change);
}

int step(Bodies& d, double h, double beta, int most = 100000)
{
    for (int k = 1; k < d.u.size(); k += 3)
        if (d.inverse_mass[k] > 0) d.u[k] -= d.g * h;  // u*, (3.4)
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

// A uniform box of half sizes w, h at (x, y, angle); of mass INFINITY it is fixed.
void add_box(Bodies& d, double w, double h, double mass, const Vector3d& at)
{
    for (Vec* v : {&d.x, &d.u, &d.inverse_mass})
        v->conservativeResize(3 * d.corners.size() + 3);
    d.x.tail<3>() = at, d.u.tail<3>().setZero();
    d.inverse_mass.tail<3>() = Vector3d(1, 1, 3 / (w * w + h * h)) / mass;
    d.corners.push_back(Polygon{{-w, w, w, -w}, {-h, -h, h, h}});
}

int main(int count, char** word)
{
    // By hand, section 12.1: a box lies over the end of a fixed one.
    Bodies across{{}, {}, {}, {}, 10};
    add_box(across, 2, 1, INFINITY, {0, 0, 0});
    add_box(across, 1, 0.5, 3, {1.5, 1.49, 0});
    step(across, 0.1, 0);
    std::ofstream out(count < 2 ? "" : word[1]);  // an SVG picture, y upwards
    out << "<svg xmlns='http://www.w3.org/2000/svg' fill='none' font-size='0.28' "
           "width='400' stroke-width='0.05' viewBox='-2.2 -2.7 5.2 3.8'>\n"
           "<g transform='scale(1 -1)'>\n";
    for (const int b :
         {0, 1})  // green: the reference edge; orange: the incident one
        out << "<polygon stroke='#4477AA' points='" << placed(across, b).transpose()
            << "'/>\n";
    out << "<path stroke='#228833' stroke-width='0.16' d='M-2 1H2'/>\n"
           "<path stroke='#EE7733' stroke-width='0.07' d='M.5 .99H2.5'/>\n"
           "<path stroke='#808080' stroke-dasharray='0.1' d='M.5 .2V1M2 .2V1'/>\n";
    for (const Contact& c : across.contacts) {
        std::printf("point %d: gap %g m, lambda %g N s\n", c.name, c.C, c.lambda);
        out << "<path stroke='#CC3311' d='M" << c.p.x() << " 1v" << c.lambda / 2
            << "m-.1-.1l.1 .1 .1-.1'/>\n<text fill='#808080' transform='scale(1 "
               "-1)'"
            << " x='" << c.p.x() + 0.1 << "' y='-0.6'>"
            << "ab"[c.name / 4] << c.name % 4 << "</text>\n";
    }
    // Six boxes on a floor, with two points a pair, and with the deepest alone.
    for (const int points : {2, 1}) {
        Bodies d;
        d.points = points;
        add_box(d, 50, 0.5, INFINITY, {0, -0.5, 0});
        for (int k = 0; k < 6; ++k) add_box(d, 0.5, 0.5, 1, {0, 0.5 + k, 0});
        for (int n = 0; n < 240; ++n) step(d, 1.0 / 60, 0.2, 10);
        std::printf("points: %d, the top at %.4f m\n", points, d.x[19]);
    }
    out << "</g></svg>\n";
}
