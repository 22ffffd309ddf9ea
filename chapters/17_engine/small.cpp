// Chapter 17 in one file, grown from chapter 13: a small engine of boxes.
// An island is solved exactly where it stands, swept where it moves, or it sleeps.
//
//     normal: λ ≥ 0, w ≥ 0, λ w = 0     tangent: |λ_t| ≤ μ λ_n, against w_t, (13.2)
#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <vector>
using Eigen::Vector2d;
using Vec = Eigen::VectorXd;
using Mat = Eigen::MatrixXd;
using Box = Eigen::Matrix<double, 2, 4>;   // corners, counterclockwise
using Rows = Eigen::Matrix<double, 2, 3>;  // along t, then along n

struct Contact {
    int a, b;                        // two bodies
    Rows Ja, Jb;                     // (12.4), (13.3)
    Vector2d bias, lambda = {0, 0};  // [m/s], [N s]; bias: C, (12.3), and then b
};

struct Bodies {
    Vec x, u, inverse_mass;         // three numbers a body: x, y, angle
    std::vector<Box> corners = {};  // from the centroid, at angle 0
    std::vector<double> rest = {};  // for how long each body has rested [s]
    double g = 9.81, mu = 0.6;
    int exact = 0, swept = 0, slept = 0;  // islands so far
};

struct Island {
    std::vector<int> bodies;
    std::vector<Contact> points;
    double N, light, heavy, fastest, rest;  // its number (17.1); [kg], [m/s], [s]
};

// (11.1): the corners of body b where it is now.
Box placed(const Bodies& d, int b)
{
    const Eigen::Matrix2d R(Eigen::Rotation2Dd(d.x[3 * b + 2]));
    return (R * d.corners[b]).colwise() + d.x.segment<2>(3 * b);
}

// (11.6), along t and n, of the point at r from the centroid.
Rows rows(const Vector2d& r, const Vector2d& n)
{
    return Rows{{-n.y(), n.x(), r.dot(n)},
                {n.x(), n.y(), r.x() * n.y() - r.y() * n.x()}};
}

// Two faces share an interval along t = n⊥, (12.3). Its ends are the points.
void collide(const Bodies& d, int a, int b, std::vector<Contact>& found)
{
    const Box P = placed(d, a), Q = placed(d, b);
    double best = -INFINITY;
    Vector2d n;
    for (int k = 0; k < 8; ++k) {  // (12.1): the normals of a, then those of b
        const double theta = d.x[3 * (k < 4 ? a : b) + 2] + k * std::acos(0);
        const Vector2d m(std::cos(theta), std::sin(theta));
        const double s =
            (m.transpose() * Q).minCoeff() - (m.transpose() * P).maxCoeff();
        if (s > best + (k < 4 ? 0 : 2e-3)) best = s, n = m;
    }
    if (best >= 0.02) return;
    const Vector2d t(-n.y(), n.x());
    const std::vector<int> next{1, 2, 3, 0};
    int i, j;  // the edges that face each other begin here
    (n.transpose() * (P + P(Eigen::all, next))).maxCoeff(&i);
    (n.transpose() * (Q + Q(Eigen::all, next))).minCoeff(&j);
    const Vector2d p1 = P.col(i), p2 = P.col(next[i]);
    const Vector2d q1 = Q.col(next[j]), q2 = Q.col(j);
    const auto at = [&](const Vector2d& v, const Vector2d& w, double tau) {
        return Vector2d(v + (tau - t.dot(v)) / t.dot(w - v) * (w - v));
    };
    const double low = std::max(t.dot(p1), t.dot(q1)),
                 high = std::min(t.dot(p2), t.dot(q2));
    for (const double tau : {high, low}) {
        const Vector2d pa = at(p1, p2, tau), pb = at(q1, q2, tau);
        const Vector2d ra = (pa + pb) / 2 - d.x.segment<2>(3 * a);
        const Vector2d rb = (pa + pb) / 2 - d.x.segment<2>(3 * b);
        const double C = n.dot(pb - pa);
        if (low <= high && C < 0.02)
            found.push_back({a, b, -rows(ra, n), rows(rb, n), {0, C}});
    }
}

// One visit of a point, (6.2) to (6.5): its friction, then its normal.
void visit(Contact& c, Bodies& d)
{
    auto ua = d.u.segment<3>(3 * c.a), ub = d.u.segment<3>(3 * c.b);
    const Rows Wa = c.Ja * d.inverse_mass.segment<3>(3 * c.a).asDiagonal();
    const Rows Wb = c.Jb * d.inverse_mass.segment<3>(3 * c.b).asDiagonal();
    for (const int i : {0, 1}) {
        const double hi = i ? INFINITY : d.mu * c.lambda[1],
                     lo = i ? 0 : -hi;  // (13.6)
        const double w = c.bias[i] + c.Ja.row(i).dot(ua) + c.Jb.row(i).dot(ub);
        const double A = Wa.row(i).dot(c.Ja.row(i)) + Wb.row(i).dot(c.Jb.row(i));
        const double change = std::clamp(c.lambda[i] - w / A, lo, hi) - c.lambda[i];
        c.lambda[i] += change;
        ua += change * Wa.row(i), ub += change * Wb.row(i);
    }
}

// (10.5): bodies that touch; one that cannot move joins none. N counts them from
// the ground to the farthest one, (17.1).
std::vector<Island> islands(const Bodies& d)
{
    const int K = d.corners.size();
    std::vector<Contact> contacts;
    std::vector<int> lowest(K, K), N(K);
    for (int b = 0; b < K; ++b) {
        for (int a = 0; a < b; ++a) collide(d, a, b, contacts);
        if (d.inverse_mass[3 * b] > 0) lowest[b] = b, N[b] = K;
    }
    for (int n = 0; n < K; ++n)
        for (const Contact& c : contacts)
            for (const auto& [i, j] : {std::pair{c.a, c.b}, {c.b, c.a}})
                if (lowest[j] < K) {
                    lowest[j] = std::min(lowest[i], lowest[j]);
                    N[j] = std::min(N[i] + 1, N[j]);
                }
    std::vector<Island> all(K + 1, {{}, {}, 0, INFINITY, 0, 0, INFINITY});
    for (const Contact& c : contacts)
        all[std::min(lowest[c.a], lowest[c.b])].points.push_back(c);
    for (int k = 0; k < K; ++k) {
        Island& i = all[lowest[k]];
        const double mass = 1 / d.inverse_mass[3 * k];
        i.bodies.push_back(k), i.N = std::max(i.N, 1.0 * N[k]);
        i.light = std::min(i.light, mass), i.heavy = std::max(i.heavy, mass);
        i.fastest = std::max(i.fastest, d.u.segment<3>(3 * k).norm());
        i.rest = std::min(i.rest, d.rest[k]);
    }
    all.pop_back();  // what cannot move
    std::erase_if(all, [](const Island& i) { return i.bodies.empty(); });
    return all;
}

// As if friction held: guesses which points push and solves for their rows, (9.2),
// until the guess is right. False if none is, or if friction would not hold: then
// the impulses, cut to their bounds, are what sweeps start from.
bool solve_exactly(Island& island, Bodies& d)
{
    const int m = 2 * island.points.size();
    Mat J = Mat::Zero(m, d.x.size());
    Vec q(m), lambda(m), on = Vec::Ones(m), guess = 0 * on;
    for (int i = 0; i < m; i += 2) {
        const Contact& c = island.points[i / 2];
        J.block<2, 3>(i, 3 * c.a) = c.Ja, J.block<2, 3>(i, 3 * c.b) = c.Jb;
        q.segment<2>(i) = c.bias;
    }
    const Mat W = d.inverse_mass.asDiagonal() * J.transpose(), A = J * W;
    q += J * d.u;
    for (int guesses = 0; guesses < 50 && on != guess; ++guesses) {
        guess = on;
        const Mat D = on.asDiagonal() * A * on.asDiagonal();
        const Eigen::LLT<Mat> factor(D + 1e-6 * Mat::Identity(m, m));
        lambda.setZero();  // rows may say the same: proximal steps, (13.10)
        for (int n = 0; n < 4; ++n)
            lambda = factor.solve(1e-6 * lambda - on.cwiseProduct(q));
        const Vec next = lambda - (A * lambda + q).cwiseQuotient(A.diagonal());
        for (int i = 0; i < m; i += 2)
            on.segment<2>(i).setConstant(next[i + 1] > 0);
    }
    bool holds = on == guess;
    for (int i = 0; i < m; i += 2) {
        const double n = std::max(0.0, lambda[i + 1]), hi = d.mu * n;
        const Vector2d own(std::clamp(lambda[i], -hi, hi), n);
        holds = holds && (own - lambda.segment<2>(i)).norm() < 1e-9;
        island.points[i / 2].lambda = lambda.segment<2>(i) = own;
    }
    d.u += W * lambda;
    return holds;
}

void step(Bodies& d, double h)
{
    for (Island& i : islands(d)) {
        if (i.rest >= 0.5 && ++d.slept) continue;                // (10.8)
        for (const int k : i.bodies) d.u[3 * k + 1] -= d.g * h;  // u*, (3.4)
        for (Contact& c : i.points) {  // (3.30), (7.4), of which 5 mm may stay
            const double C = c.bias[1];
            c.bias[1] = C > 0 ? C / h : 0.2 * std::min(C + 0.005, 0.0) / h;
        }
        const double needed = i.N * i.N * i.heavy / i.light;
        const bool stands = i.fastest <= d.g * h;
        if (stands && needed > 8 && solve_exactly(i, d)) ++d.exact;
        else if (++d.swept)
            for (int n = 0; n < std::clamp(needed, 40.0, 200.0); ++n)
                for (Contact& c : i.points) visit(c, d);
        for (const int k : i.bodies) {
            d.x.segment<3>(3 * k) += h * d.u.segment<3>(3 * k);  // (1.10)
            d.rest[k] = d.u.segment<3>(3 * k).norm() < 2e-3 ? d.rest[k] + h : 0;
        }
    }
}

// A uniform box of half sizes w, h at (x, y); of mass INFINITY it is fixed.
void add_box(Bodies& d, double w, double h, double mass, double x, double y)
{
    const int n = d.x.size();
    for (Vec* v : {&d.x, &d.u, &d.inverse_mass}) v->conservativeResize(n + 3);
    d.x.tail<3>() << x, y, 0;
    d.u.tail<3>().setZero();
    d.inverse_mass.tail<3>() << 1 / mass, 1 / mass, 3 / (w * w + h * h) / mass;
    d.corners.push_back(Box{{-w, w, w, -w}, {-h, -h, h, h}});
    d.rest.push_back(0);
}

int main(int count, char** word)
{
    // By hand, section 17.1: one box; 100 kg on two; a tower of twenty.
    Bodies d, drawn;
    add_box(d, 50, 0.5, INFINITY, 0, -0.5);
    add_box(d, 0.5, 0.5, 1, -14, 0.5);
    for (int k = 0; k < 3; ++k) add_box(d, 0.5, 0.5, k < 2 ? 1 : 100, -10, 0.5 + k);
    for (int k = 0; k < 20; ++k) add_box(d, 0.5, 0.5, 1, 0, 0.5 + k);
    for (const Island& i : islands(d))
        std::printf("%zu bodies, %zu rows: %g sweeps needed\n", i.bodies.size(),
                    2 * i.points.size(), i.N * i.N * i.heavy / i.light);
    for (int n = 1; n <= 1200; ++n) {
        if (n == 121) add_box(d, 0.5, 0.5, 3, -10, 12), d.u[3 * 25] = 15;
        step(d, 1.0 / 120);
        if (n == 660) drawn = d;
        if (n % 120 > 0) continue;
        std::printf("%d s: islands %d exact, %d swept, %d asleep\n", n / 120,
                    d.exact, d.swept, d.slept);
        d.exact = d.swept = d.slept = 0;
    }
    std::ofstream out(count < 2 ? "" : word[1]);  // an SVG picture, y upwards
    out << "<svg xmlns='http://www.w3.org/2000/svg' fill='none' width='720' "
           "stroke-width='0.08' viewBox='-16 -6 36 6.6'>\n";
    for (int b = 0; b < int(drawn.rest.size()); ++b) {
        out << "<polygon stroke='"
            << (b > 0 && drawn.rest[b] < 0.5 ? "#CC3311" : "#808080")
            << "' points='";
        const Box box = placed(drawn, b);
        for (const auto& p : box.colwise()) out << p.x() << ',' << -p.y() << ' ';
        out << "'/>\n";
    }
    out << "</svg>\n";
}
