// Chapter 24 in one file, grown from chapter 20: friction is a disc.
// Two rows across the normal have one bound. Boxes touch walls by their corners.
//
//     u = (v, ω), ω in the body's own axes,   w = J u + b,   θ ← θ ⊕ h ξ, (20.9)
//     corner on a wall: λ_n ≥ 0, w_n ≥ 0, λ_n w_n = 0,   ‖λ_t‖ ≤ μ λ_n, against w_t
#include <Eigen/Geometry>
#include <Eigen/LU>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <numbers>
#include <vector>
using Eigen::Quaterniond, Eigen::Vector3d;
using Eigen::Vector2d;
using Vec = Eigen::VectorXd;
using Mat = Eigen::MatrixXd;
using Rows = Eigen::Matrix<double, 3, 6>;  // along t1, t2 and n

struct Contact {
    int a, b, name;  // body b, a wall a: -1, -2, …, and which corner of b
    Rows J;          // of body b, (23.3)
    double C;        // gap [m]
    Vector3d bias = {0, 0, 0}, lambda = {0, 0, 0};  // [m/s], [N s]
};

struct Bodies {
    Vec x, u, inverse_mass;  // six a body: x, rotation vector; v, ω; 1/m, 1/I
    std::vector<Eigen::Matrix3Xd> corners;  // from the centroid, in its own axes
    Mat walls;  // columns n, c: where n·p ≥ c it is free
    double g = 9.81, mu = 0.5;
    std::vector<Contact> contacts = {};  // of the last step
};

// (20.3): the rotation of a rotation vector.
Quaterniond exp(const Vector3d& theta)
{
    return Quaterniond(Eigen::AngleAxisd(theta.norm(), theta.normalized()));
}

// (20.4): θ ⊕ δ, after a turn by δ in the body's own axes.
Vector3d add(const Vector3d& theta, const Vector3d& delta)
{
    const Eigen::AngleAxisd sum(exp(theta) * exp(delta));
    return sum.angle() * sum.axis();
}

// (20.8): the turn hξ of a step; ξ is the spin in the middle of it. The angular
// momentum stays where it is, and the axes turn.
Vector3d turn(const Vector3d& inverse, Vector3d& omega, double h)
{
    const Vector3d L = omega.cwiseQuotient(inverse);
    Vector3d xi = omega;
    for (int n = 0; n < 20; ++n) xi = inverse.cwiseProduct(exp(-h / 2 * xi) * L);
    omega = inverse.cwiseProduct(exp(-h * xi) * L);
    return h * xi;
}

// Corners and walls, with gaps below 2 cm.
std::vector<Contact> find_contacts(const Bodies& d)
{
    std::vector<Contact> found;
    for (int b = 0; b < int(d.corners.size()); ++b)
        for (int k = 0; k < d.corners[b].cols(); ++k)
            for (int i = 0; i < d.walls.cols(); ++i) {
                const Vector3d n = d.walls.col(i).head<3>();
                const Vector3d r = d.corners[b].col(k);
                const auto R = exp(d.x.segment<3>(6 * b + 3)).toRotationMatrix();
                const double C =
                    n.dot(d.x.segment<3>(6 * b) + R * r) - d.walls(3, i);
                if (C >= 0.02) continue;
                Eigen::Matrix3d D;  // t1, t2 and n as rows
                D << n.unitOrthogonal(), n.cross(n.unitOrthogonal()), n;
                D.transposeInPlace();
                Eigen::Matrix3d cross;
                cross << 0, -r.z(), r.y(), r.z(), 0, -r.x(), -r.y(), r.x(), 0;
                Rows J;
                J << D, -D * R * cross;
                found.push_back({-1 - i, b, k, J, C});
            }
    return found;
}

// (24.2): the nearest point of the disc.
Vector2d nearest(const Vector2d& lambda, double radius)
{
    return lambda.norm() > radius ? Vector2d(lambda * (radius / lambda.norm()))
                                  : lambda;
}

// One visit: the disc of friction, (24.4), then the normal, (6.2) to (6.5).
void visit(Contact& c, Bodies& d)
{
    auto u = d.u.segment<6>(6 * c.b);
    const Rows W = c.J * d.inverse_mass.segment<6>(6 * c.b).asDiagonal();
    const Eigen::Matrix3d A = W * c.J.transpose();
    const Eigen::Matrix2d At = A.topLeftCorner<2, 2>();
    const double half = At.trace() / 2;
    const double L = half + std::sqrt(half * half - At.determinant());
    const double radius = d.mu * c.lambda[2];
    Vector3d w = c.J * u + c.bias, next = c.lambda;
    next.head<2>() -= At.inverse() * w.head<2>();
    if (next.head<2>().norm() > radius)
        next.head<2>() = nearest(c.lambda.head<2>() - w.head<2>() / L, radius);
    u += W.transpose() * (next - c.lambda);
    w = c.J * u + c.bias;
    const double push = std::max(0.0, next[2] - w[2] / A(2, 2)) - next[2];
    u += W.row(2).transpose() * push;
    next[2] += push;
    c.lambda = next;
}

void step(Bodies& d, double h, double beta, int sweeps)
{
    const int K = d.x.size() / 6;
    for (int k = 0; k < K; ++k) d.u[6 * k + 2] -= d.g * h;  // u*, (3.4)
    std::vector<Contact> contacts = find_contacts(d);
    for (Contact& c : contacts) {
        c.bias[2] = (c.C < 0 ? beta : 1) * c.C / h;  // (7.4), (3.30)
        for (const Contact& old : d.contacts)  // its key: which two touch, where
            if (old.a == c.a && old.b == c.b && old.name == c.name) {
                c.lambda = old.lambda;
                d.u.segment<6>(6 * c.b) +=
                    d.inverse_mass.segment<6>(6 * c.b).cwiseProduct(
                        c.J.transpose() * c.lambda);
            }
    }
    for (int n = 0; n < sweeps; ++n)
        for (Contact& c : contacts) visit(c, d);
    for (int k = 0; k < K; ++k) {
        d.x.segment<3>(6 * k) += h * d.u.segment<3>(6 * k);  // (1.10)
        Vector3d omega = d.u.segment<3>(6 * k + 3);
        const Vector3d delta = turn(d.inverse_mass.segment<3>(6 * k + 3), omega, h);
        d.x.segment<3>(6 * k + 3) = add(d.x.segment<3>(6 * k + 3), delta);
        d.u.segment<3>(6 * k + 3) = omega;
    }
    d.contacts = contacts;
}

// A uniform box with the edges e at a place.
void add_box(Bodies& d, const Vector3d& e, double mass, const Vector3d& at)
{
    for (Vec* v : {&d.x, &d.u, &d.inverse_mass})
        v->conservativeResize(v->size() + 6);
    d.x.tail<6>() << at, 0, 0, 0;
    d.u.tail<6>().setZero();
    const Vector3d q = e.cwiseAbs2();
    const Vector3d I = mass / 12 * Vector3d(q[1] + q[2], q[2] + q[0], q[0] + q[1]);
    d.inverse_mass.tail<6>() << Vector3d::Constant(1 / mass), I.cwiseInverse();
    d.corners.push_back(Eigen::Matrix3Xd(3, 8));
    for (int k = 0; k < 8; ++k)
        d.corners.back().col(k) << e[0] * ((k % 4 % 3 > 0) - 0.5),
            e[1] * ((k / 2 % 2) - 0.5), e[2] * (k / 4 - 0.5);
}

// The hoop of section 24.1: 1 kg, 1 m, upright; it touches the floor as it slides.
Bodies hoop(double vx, double vy)
{
    Bodies d{{}, {}, {}, {}, Vec{{0, 0, 1, 0}}};
    add_box(d, {1, 1, 1}, 1, {0, 0, 1});
    d.inverse_mass << 1, 1, 1, 2, 1, 2;
    d.corners[0] = Vector3d(0, 0, -1);
    d.u.head<2>() << vx, vy;
    return d;
}

// The impulse of friction, along x and y.
Vector2d drag(const Contact& c)
{
    return c.J.topLeftCorner<2, 2>().transpose() * c.lambda.head<2>();
}

int main(int count, char** word)
{
    std::ofstream out(count < 2 ? "" : word[1]);  // SVG
    out << "<svg xmlns='http://www.w3.org/2000/svg' fill='none' width='640' "
           "stroke-width='0.008' viewBox='-1.5 -1.3 2.1 1.5'>\n<g "
           "transform='translate(-0.72 -0.75)' stroke='#808080'><path "
           "d='M-.5 .5H.5V-.5H-.5z' stroke-dasharray='0.03'/><circle r='0.5'/>\n";
    // By hand, section 24.1: one visit, and where more of them lead.
    Bodies d = hoop(1.8, 2.4);
    Contact c = find_contacts(d)[0];
    c.lambda[2] = 1;
    for (int n = 0; n <= 20; ++n, visit(c, d)) {
        const Vector3d w = c.J * d.u;
        const Vector2d p = drag(c), q = -c.J.topLeftCorner<2, 2>().transpose() *
                                        w.head<2>() / 3;  // L = 3
        if (n < 3 || n == 20)
            std::printf("after %2d: lambda %.4f %.4f, w %.4f %.4f\n", n, p[0], p[1],
                        -3 * q[0], -3 * q[1]);
        if (n > 1) continue;
        const Vector2d to = nearest(p + q, 0.5);
        out << "<path stroke='#4477AA' d='M" << p[0] << ' ' << -p[1] << 'L'
            << p[0] + q[0] << ' ' << -p[1] - q[1]
            << "'/><path stroke='#CC3311' d='M" << p[0] + q[0] << ' '
            << -p[1] - q[1] << 'L' << to[0] << ' ' << -to[1]
            << "'/><circle fill='#CC3311' r='0.02' cx='" << to[0] << "' cy='"
            << -to[1] << "'/>\n";
    }
    out << "<path stroke-width='0.003' d='M-.5 0H.5M0 -.5V.5'/><g stroke='none' "
           "fill='#808080' font-size='0.06'><text x='.24' y='-.02'>along</text>"
           "<text x='.02' y='-.4'>across</text><text x='-.26' y='.43'>1</text>"
           "<text x='-.4' y='.38'>2</text><text x='-.35' y='-.2'>½ N s</text>"
           "</g></g>\n";
    // Friction is a disc: a block slides as far in any direction, v²/(2 μ g).
    for (const double degrees : {0.0, 30.0, 45.0}) {
        Bodies d{{}, {}, {}, {}, Vec{{0, 0, 1, 0}}};
        add_box(d, {1, 1, 0.2}, 1, {0, 0, 0.1});
        const double a = degrees * std::numbers::pi / 180;
        d.u.head<2>() << 2 * std::cos(a), 2 * std::sin(a);
        for (int n = 0; n < 480; ++n) step(d, 1.0 / 240, 0.2, 20);
        std::printf("%g degrees: %.4f m, %.4f degrees\n", degrees,
                    d.x.head<2>().norm(),
                    std::atan2(d.x[1], d.x[0]) * 180 / std::numbers::pi);
    }
    // A book of 0.7 kg that spins about its middle axis falls on a floor.
    d = Bodies{{}, {}, {}, {}, Vec{{0, 0, 1, 0}}};
    add_box(d, {0.16, 0.24, 0.04}, 0.7, {0, 0, 1});
    d.u << 0.7, 0, 0, 12, 1.2, 1.2;
    for (int n = 0; n <= 480; ++n, step(d, 1.0 / 240, 0.2, 20)) {
        if (n % 24 || (n > 140 && n < 480)) continue;
        const auto R = exp(d.x.tail<3>()).toRotationMatrix();
        const Eigen::Matrix3Xd p = (R * d.corners[0]).colwise() + d.x.head<3>();
        out << "<path stroke='" << (n < 480 ? "#4477AA" : "#CC3311") << "' d='";
        for (const int k : {0, 1, 2, 3, 0, 4, 5, 6, 7, 4, 5, 1, 2, 6, 7, 3})
            out << (k == 0 ? 'M' : 'L') << p(0, k) + 0.3 * p(1, k) << ' '
                << -p(2, k) - 0.3 * p(1, k);
        out << "'/>\n";
    }
    out << "</svg>\n";
    std::printf("the book lies at z = %.4f m, fastest at %.1e\n", d.x[2],
                d.u.cwiseAbs().maxCoeff());
}
