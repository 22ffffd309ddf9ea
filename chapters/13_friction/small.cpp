// Chapter 13 in one file, grown from chapter 12: contacts have friction.
//     normal: λ ≥ 0, w ≥ 0, λ w = 0; a second row |λ_t| ≤ μ λ_n, against w_t (13.2)
#include <Eigen/Geometry>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <vector>
using Eigen::Vector2d;
using Vec = Eigen::VectorXd;
using Polygon = Eigen::Matrix2Xd;  // corners, counterclockwise

struct Contact {
    int a, b, name;                  // two bodies; which of their points it is
    Vector2d p;                      // the point
    Eigen::RowVector3d Ja, Jb;       // (12.4)
    double C, bias = 0, lambda = 0;  // gap [m], [m/s], [N s]
    int normal = -1;                 // of friction: the row that bounds it
};

struct Bodies {
    Vec x, u, inverse_mass;        // three numbers a body: x, y, angle
    std::vector<Polygon> corners;  // from the centroid, at angle 0
    double g = 9.81, mu = 0;
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
}

// All friction, then all normals: what is visited last is right.
std::vector<Contact> find_contacts(const Bodies& d)
{
    std::vector<Contact> normals;
    for (int b = 1; b < int(d.corners.size()); ++b)
        for (int a = 0; a < b; ++a) collide(d, a, b, normals);
    std::vector<Contact> found = normals;
    for (Contact& c : found) {
        const Vector2d t(-c.Jb.y(), c.Jb.x());  // (13.3)
        c.Ja = -row(c.p - d.x.segment<2>(3 * c.a), t);
        c.Jb = row(c.p - d.x.segment<2>(3 * c.b), t);
        c.normal = normals.size() + (&c - found.data()), c.name = -1 - c.name;
    }
    found.insert(found.end(), normals.begin(), normals.end());
    return found;
}

// (11.5): an impulse along J changes the velocities and the spins.
void push(const Contact& c, double impulse, Bodies& d)
{
    for (const auto& [k, J] : {std::pair{3 * c.a, c.Ja}, {3 * c.b, c.Jb}})
        d.u.segment<3>(k) +=
            impulse * d.inverse_mass.segment<3>(k).cwiseProduct(J.transpose());
}

// One visit: (6.2) to (6.5), (13.6).
void visit(Contact& c, const std::vector<Contact>& all, Bodies& d)
{
    const double hi = c.normal < 0 ? INFINITY : d.mu * all[c.normal].lambda;
    const double lo = c.normal < 0 ? 0 : -hi;
    double w = c.bias, A = 0;  // (11.7)
    for (const auto& [k, J] : {std::pair{3 * c.a, c.Ja}, {3 * c.b, c.Jb}}) {
        w += J * d.u.segment<3>(k);
        A += J.cwiseAbs2() * d.inverse_mass.segment<3>(k);
    }
    const double change = std::clamp(c.lambda - w / A, lo, hi) - c.lambda;
    c.lambda += change;
    push(c, change, d);
}

void step(Bodies& d, double h, int sweeps)
{
    for (int k = 1; k < d.u.size(); k += 3)
        if (d.inverse_mass[k] > 0) d.u[k] -= d.g * h;  // u*, (3.4)
    std::vector<Contact> contacts = find_contacts(d);
    for (Contact& c : contacts) {
        if (c.normal < 0)  // (3.30), (7.4): but 5 mm of an overlap may stay
            c.bias = c.C > 0 ? c.C / h : 0.2 * std::min(c.C + 0.005, 0.0) / h;
        for (const Contact& old : d.contacts)  // its key: which two touch, where
            if (old.a == c.a && old.b == c.b && old.name == c.name)
                push(c, c.lambda = old.lambda, d);
    }
    for (int n = 0; n < sweeps; ++n)
        for (Contact& c : contacts) visit(c, contacts, d);
    d.x += h * d.u;  // (1.10)
    d.contacts = contacts;
}

// A uniform box of half sizes w, h at (x, y, angle); of mass INFINITY it is fixed.
void add_box(Bodies& d, double w, double h, double mass, const Eigen::Vector3d& at)
{
    for (Vec* v : {&d.x, &d.u, &d.inverse_mass})
        v->conservativeResize(3 * d.corners.size() + 3);
    d.x.tail<3>() = at, d.u.tail<3>().setZero();
    d.inverse_mass.tail<3>() = Eigen::Vector3d(1, 1, 3 / (w * w + h * h)) / mass;
    d.corners.push_back(Polygon{{-w, w, w, -w}, {-h, -h, h, h}});
}

// A floor that falls to the right by an angle, and boxes of 1 m and 1 kg on it.
Bodies boxes(int count, double angle, double mu, double g = 9.81)
{
    Bodies d{{}, {}, {}, {}, g, mu};
    for (int k = 0; k <= count; ++k) {
        const Vector2d at = (k - 0.5) * Vector2d(std::sin(angle), std::cos(angle));
        add_box(d, k ? 0.5 : 100, 0.5, k ? 1 : INFINITY, {at.x(), at.y(), -angle});
    }
    return d;
}

int main(int count, char** word)
{
    // By hand, section 13.1: a block on a slope of 3 in 4. Red: P = m (u − u*).
    std::ofstream out(count < 2 ? "" : word[1]);  // an SVG picture, y upwards
    out << "<svg xmlns='http://www.w3.org/2000/svg' fill='none' width='400' "
           "stroke-width='0.03' viewBox='-1.2 -1.5 4.4 3.5'><g transform="
           "'scale(1 -1)'>\n<path stroke='#808080' d='M-4 3L4-3'/>\n";
    const Eigen::RowVector2d N(0.6, 0.8), T(-0.8, 0.6), up(0, 1);
    for (const double mu : {0.9, 0.5}) {
        Bodies d = boxes(1, std::atan(0.75), mu, 10);
        step(d, 0.1, 100);
        const Eigen::RowVector2d u = d.u.segment<2>(3), P = u + up;
        std::printf("mu = %g: %.3f m/s\n", mu, u.norm());
        out << "<g transform='translate(" << 5 * (0.9 - mu) * Vector2d(1, -0.75)
            << ")'><polygon stroke='#4477AA' points='" << placed(d, 1).transpose()
            << "'/>\n<path stroke='#228833' stroke-dasharray='0.1' d='M"
            << N + mu * T << "L0 0L" << N - mu * T
            << "'/>\n<path stroke='#EE7733' d='M0 0L" << N.dot(P) * N << 'L' << P
            << "'/>\n<path stroke='#CC3311' d='M0 0L" << P
            << "'/>\n<text fill='#808080' transform='scale(1 -1)' font-size='.2' "
            << "x='-1' y='.25'>μ = " << mu << "<tspan x='.5' y='-.48'>λₙ</tspan>"
            << "<tspan x='.36' y='-.84'>λₜ</tspan></text></g>\n";
    }
    out << "</g></svg>\n";
    for (const double degrees : {16.5, 16.9, 30.0}) {  // 16.70 holds; then (13.1)
        Bodies d = boxes(1, degrees * std::acos(-1) / 180, 0.3), start = d;
        for (int n = 0; n < 480; ++n) step(d, 1.0 / 240, 10);
        std::printf("%.1f degrees: %.6f m\n", degrees, (d.x - start.x).norm());
    }
    Bodies tower = boxes(10, 0, 0.6);
    for (int n = 0; n < 2400; ++n) step(tower, 1.0 / 240, 10);
    std::printf("ten boxes: fastest at %.1e m/s\n", tower.u.cwiseAbs().maxCoeff());
}
