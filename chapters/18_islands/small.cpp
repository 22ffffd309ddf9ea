// Chapter 18 in one file, grown from chapter 13: islands of boxes.
// An island is solved exactly where it stands, swept where it moves, or it sleeps.
//     normal: λ ≥ 0, w ≥ 0, λ w = 0     tangent: |λ_t| ≤ μ λ_n, against w_t, (13.2)
#include <Eigen/Geometry>
#include <Eigen/QR>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <vector>
using Eigen::Vector2d;
using Eigen::Vector3d;
using Vec = Eigen::VectorXd;
using Mat = Eigen::MatrixXd;
using Polygon = Eigen::Matrix2Xd;  // corners, counterclockwise

struct Contact {
    int a, b;       // two bodies
    Vector2d p, n;  // the point; from a to b
    double C;       // gap [m]
};

struct Bodies {
    Vec x, u, inverse_mass;         // three numbers a body: x, y, angle
    std::vector<Polygon> corners;   // from the centroid, at angle 0
    std::vector<double> rest = {};  // for how long each body has rested [s]
    double g = 9.81, mu = 0.6;
    int exact = 0, swept = 0, slept = 0;  // islands so far
};

struct Island {
    std::vector<int> bodies;
    std::vector<Contact> points;
    double light = INFINITY, heavy = 0, fastest = 0, rest = INFINITY;  // [kg], …
    // (18.1), as if all its bodies stood on each other
    double needed() const { return std::pow(bodies.size(), 2) * heavy / light; }
};

// (11.1): the corners of body b where it is now.
Polygon placed(const Bodies& d, int b)
{
    const Eigen::Matrix2d R(Eigen::Rotation2Dd(d.x[3 * b + 2]));
    return (R * d.corners[b]).colwise() + d.x.segment<2>(3 * b);
}

// Two faces have an interval along t = n⊥, (12.3): its ends are the points.
void collide(const Bodies& d, int a, int b, std::vector<Contact>& found)
{
    const Polygon P = placed(d, a), Q = placed(d, b);
    double best = -INFINITY;
    Vector2d n;
    for (int k = 0; k < 8; ++k) {  // (12.1): the normals of a, then those of b
        const double theta = d.x[3 * (k < 4 ? a : b) + 2] + k * std::acos(0);
        const Eigen::RowVector2d m(std::cos(theta), std::sin(theta));
        const double s = (m * Q).minCoeff() - (m * P).maxCoeff();
        if (s > best + (k < 4 ? 0 : 2e-3)) best = s, n = m.transpose();
    }
    if (best >= 0.02) return;
    const Vector2d t(-n.y(), n.x());
    const std::vector<int> next{1, 2, 3, 0};
    int i, j;  // the edges that face each other begin here
    (n.transpose() * (P + P(Eigen::all, next))).maxCoeff(&i);
    (n.transpose() * (Q + Q(Eigen::all, next))).minCoeff(&j);
    const int i2 = (i + 1) % P.cols(), j2 = (j + 1) % Q.cols();
    const auto at = [&](const Vector2d& v, const Vector2d& w, double tau) {
        return Vector2d(v + (tau - t.dot(v)) / t.dot(w - v) * (w - v));
    };
    const double low = std::max(t.dot(P.col(i)), t.dot(Q.col(j2)));
    const double high = std::min(t.dot(P.col(i2)), t.dot(Q.col(j)));
    for (const double tau : {high, low}) {
        const Vector2d pa = at(P.col(i), P.col(i2), tau);
        const Vector2d pb = at(Q.col(j), Q.col(j2), tau), p = (pa + pb) / 2;
        const double C = n.dot(pb - pa);
        if (low <= high && C < 0.02) found.push_back({a, b, p, n, C});
    }
}

// (10.5): bodies that touch; one that cannot move joins none.
std::vector<Island> islands(const Bodies& d)
{
    const int K = d.corners.size();
    std::vector<Contact> contacts;
    std::vector<int> of(K);  // of which island, a number below K, if it can move
    for (int b = 0; b < K; ++b) {
        for (int a = 0; a < b; ++a) collide(d, a, b, contacts);
        of[b] = d.inverse_mass[3 * b] > 0 ? b : K;
    }
    for (const Contact& c : contacts)
        if (std::max(of[c.a], of[c.b]) < K)
            std::ranges::replace(of, int(of[c.b]), int(of[c.a]));
    std::vector<Island> all(K + 1);  // some stay empty, the last cannot move
    for (const Contact& c : contacts)
        all[std::min(of[c.a], of[c.b])].points.push_back(c);
    for (int k = 0; k < K; ++k) {
        Island& i = all[of[k]];
        const double mass = 1 / d.inverse_mass[3 * k];
        i.bodies.push_back(k);
        i.light = std::min(i.light, mass), i.heavy = std::max(i.heavy, mass);
        i.fastest = std::max(i.fastest, d.u.segment<3>(3 * k).norm());
        i.rest = std::min(i.rest, d.rest[k]);
    }
    std::erase_if(all, [](auto& i) { return i.light == INFINITY; });
    return all;
}

// Exactly: as if friction held, guesses which points push and solves for them until
// it is right, then sweeps until nothing changes. Returns whether it got there.
bool solve(const Island& island, Bodies& d, double h, bool exactly, double most)
{
    const int m = 2 * island.points.size();
    Mat J = Mat::Zero(m, d.x.size());
    Vec b = Vec::Zero(m), lambda = b, on = Vec::Ones(m), guess = b;
    for (int i = 0; i < m; i += 2) {
        const Contact& c = island.points[i / 2];
        for (const auto& [k, n] : {std::pair{c.a, Vector2d(-c.n)}, {c.b, c.n}}) {
            const Vector2d r = c.p - d.x.segment<2>(3 * k), t(-n.y(), n.x());
            J.block<2, 3>(i, 3 * k) << t.x(), t.y(), r.x() * t.y() - r.y() * t.x(),
                n.x(), n.y(), r.x() * n.y() - r.y() * n.x();  // (13.3), (12.4)
        }
        // (3.30), (7.4): but 5 mm of an overlap may stay
        b[i + 1] = c.C > 0 ? c.C / h : 0.2 * std::min(c.C + 0.005, 0.0) / h;
    }
    const Mat W = d.inverse_mass.asDiagonal() * J.transpose(), A = J * W;
    const Vec q = J * d.u + b;
    for (int guesses = 0; exactly && guesses < 50 && on != guess; ++guesses) {
        guess = on;  // (9.2); rows may say the same: of all answers the shortest
        const Mat D = on.asDiagonal() * A * on.asDiagonal();
        lambda = D.completeOrthogonalDecomposition().solve(-on.cwiseProduct(q));
        const Vec next = lambda - (A * lambda + q).cwiseQuotient(A.diagonal());
        for (int i = 0; i < m; ++i) on[i] = next[i | 1] > 0;  // of point i / 2
    }
    double off = 1;
    for (int n = 0; off > 1e-9 && n < most; ++n) {
        off = 0;
        for (int i = 0; i < m; ++i) {  // (4.4), (13.6)
            const double hi = i % 2 ? INFINITY : d.mu * std::abs(lambda[i + 1]);
            const double lo = i % 2 ? 0 : -hi, before = lambda[i];
            const double w = A.row(i).dot(lambda) + q[i];
            lambda[i] = std::clamp(before - w / A(i, i), lo, hi);
            off = std::max(off, A(i, i) * std::abs(lambda[i] - before));
        }
    }
    d.u += W * lambda;
    return off <= 1e-9;
}

void step(Bodies& d, double h)
{
    for (const Island& i : islands(d)) {
        if (i.rest >= 0.5 && ++d.slept) continue;                // (10.7)
        for (const int k : i.bodies) d.u[3 * k + 1] -= d.g * h;  // u*, (3.4)
        const bool stands = i.needed() > 8 && i.fastest <= d.g * h;
        const double most = std::clamp(i.needed(), 40.0, 200.0);
        ++(solve(i, d, h, stands, most) && stands ? d.exact : d.swept);
        for (const int k : i.bodies) {
            d.x.segment<3>(3 * k) += h * d.u.segment<3>(3 * k);  // (1.10)
            d.rest[k] = d.u.segment<3>(3 * k).norm() < 2e-3 ? d.rest[k] + h : 0;
        }
    }
}

// A uniform box of half sizes w, h at (x, y, angle); of mass INFINITY it is fixed.
void add_box(Bodies& d, double w, double h, double mass, const Vector3d& at)
{
    for (Vec* v : {&d.x, &d.u, &d.inverse_mass})
        v->conservativeResize(3 * d.corners.size() + 3);
    d.x.tail<3>() = at, d.u.tail<3>().setZero();
    d.inverse_mass.tail<3>() = Vector3d(1, 1, 3 / (w * w + h * h)) / mass;
    d.corners.push_back(Polygon{{-w, w, w, -w}, {-h, -h, h, h}});
    d.rest.push_back(0);
}

int main(int count, char** word)
{
    // By hand, section 18.1: one box; 100 kg on two; a tower of twenty. Red: awake.
    Bodies d;
    add_box(d, 50, 0.5, INFINITY, {0, -0.5, 0});
    add_box(d, 0.5, 0.5, 1, {-14, 0.5, 0});
    for (const int k : {0, 1, 2})
        add_box(d, 0.5, 0.5, k < 2 ? 1 : 100, {-10, 0.5 + k, 0});
    for (int k = 0; k < 20; ++k) add_box(d, 0.5, 0.5, 1, {0, 0.5 + k, 0});
    for (const Island& i : islands(d))
        std::printf("%zu bodies, %zu rows: %g sweeps needed\n", i.bodies.size(),
                    2 * i.points.size(), i.needed());
    std::ofstream out(count < 2 ? "" : word[1]);  // an SVG picture, y upwards
    out << "<svg xmlns='http://www.w3.org/2000/svg' fill='none' "
           "width='720' stroke-width='0.08' viewBox='-16 -6 36 6.6'>\n"
           "<g transform='scale(1 -1)'>\n";
    for (int n = 1; n <= 1200; ++n) {
        if (n == 121) add_box(d, 0.5, 0.5, 3, {-10, 12, 0}), d.u[3 * 25] = 15;
        step(d, 1.0 / 120);
        for (int b = 0; b < int(d.rest.size()) && n == 660; ++b)
            out << "<polygon stroke='"
                << (b > 0 && d.rest[b] < 0.5 ? "#CC3311" : "#808080")
                << "' points='" << placed(d, b).transpose() << "'/>\n";
        if (n % 120 == 0)
            std::printf("%d s: islands %d exact, %d swept, %d asleep\n", n / 120,
                        d.exact, d.swept, d.slept);
    }
    out << "</g></svg>\n";
}
