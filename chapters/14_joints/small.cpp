// Chapter 14 in one file, grown from chapter 11: pins and limits, and a tree of pins
// that is solved from the leaves to the root and back.
//
//     J u + J_p u_p + b = 0: pins, all at once        limit: λ ≥ 0, w ≥ 0, λ w = 0
#include <Eigen/LU>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <numbers>
#include <vector>
using Eigen::Matrix3d;
using Eigen::Vector2d;
using Eigen::Vector3d;
using Vec = Eigen::VectorXd;
using Rows = Eigen::Matrix<double, 2, 3>;                    // of a pin: along x and y
using Path = std::pair<const char*, std::vector<Vector2d>>;  // a colour and points

struct Pin {
    int parent;             // of the body that it holds; -1: the world
    Vector2d above, below;  // the point in the parent, or in the world, and in the body
    double lower = -INFINITY, upper = INFINITY;  // of the angle between both
    Rows J = {}, Jp = {};
    Vector2d C = {0, 0}, bias = {0, 0}, lambda = {0, 0};  // [m], [m/s], [N s]
};

struct Bodies {
    Vec x, u, inverse_mass;  // three numbers a body: x, y, angle
    std::vector<Pin> pins;   // one a body, which holds it; its parent comes before it
    double g = 9.81;
};

// (11.1): r = R(θ) r̄
Vector2d turned(double theta, const Vector2d& r)
{
    const double c = std::cos(theta), s = std::sin(theta);
    return {c * r.x() - s * r.y(), s * r.x() + c * r.y()};
}

// (11.6), along x and along y: the velocity of the point at r.
Rows rows(const Vector2d& r) { return Rows{{1, 0, -r.y()}, {0, 1, r.x()}}; }

void find_pins(Bodies& d, double h)
{
    for (int k = 0; k < int(d.pins.size()); ++k) {
        Pin& pin = d.pins[k];
        const Vector2d r = turned(d.x[3 * k + 2], pin.below);
        pin.J = rows(r), pin.Jp.setZero(), pin.C = d.x.segment<2>(3 * k) + r - pin.above;
        if (pin.parent >= 0) {
            const Vector2d rp = turned(d.x[3 * pin.parent + 2], pin.above);
            pin.Jp = -rows(rp);
            pin.C = d.x.segment<2>(3 * k) + r - d.x.segment<2>(3 * pin.parent) - rp;
        }
        pin.bias = pin.C / h;  // (3.30)
        pin.lambda.setZero();
    }
}

// One visit of a pin: both rows, with K of the two bodies alone.
void visit(Bodies& d, int k)
{
    Pin& pin = d.pins[k];
    auto u = d.u.segment<3>(3 * k), up = d.u.segment<3>(3 * std::max(pin.parent, 0));
    const Rows JM = pin.J * d.inverse_mass.segment<3>(3 * k).asDiagonal();
    const Rows JpM = pin.Jp * d.inverse_mass.segment<3>(3 * std::max(pin.parent, 0)).asDiagonal();
    const Eigen::Matrix2d K = JM * pin.J.transpose() + JpM * pin.Jp.transpose();
    const Vector2d change = -K.inverse() * (pin.J * u + pin.Jp * up + pin.bias);
    pin.lambda += change;
    u += JM.transpose() * change;
    up += JpM.transpose() * change;
}

// All pins at once. Returns the fastest that was wrong [m/s].
void solve_tree(Bodies& d)
{
    const int n = d.pins.size();
    std::vector<Matrix3d> S(n, Matrix3d::Zero()), G(n);  // the mass that hangs on a body
    std::vector<Vector3d> pulled(n, Vector3d::Zero());
    std::vector<Vector2d> r(n);
    for (int k = n - 1; k >= 0; --k) {  // up, from the leaves to the root
        const Pin& pin = d.pins[k];
        const Matrix3d M = d.inverse_mass.segment<3>(3 * k).cwiseInverse().asDiagonal();
        G[k] = (M + S[k]).inverse();            // (14.9)
        d.u.segment<3>(3 * k) -= G[k] * pulled[k];  // (14.10)
        r[k] = pin.J * d.u.segment<3>(3 * k) + pin.bias;
        if (pin.parent < 0) continue;
        const Rows KJp = (pin.J * G[k] * pin.J.transpose()).inverse() * pin.Jp;
        S[pin.parent] += pin.Jp.transpose() * KJp;
        pulled[pin.parent] += KJp.transpose() * (pin.Jp * d.u.segment<3>(3 * pin.parent) + r[k]);
    }
    for (int k = 0; k < n; ++k) {  // down, from the root to the leaves
        Pin& pin = d.pins[k];
        if (pin.parent >= 0) r[k] += pin.Jp * d.u.segment<3>(3 * pin.parent);
        const Vector2d change = -(pin.J * G[k] * pin.J.transpose()).inverse() * r[k];  // (14.8)
        pin.lambda += change;
        d.u.segment<3>(3 * k) += G[k] * pin.J.transpose() * change;  // (14.7)
    }
}

void step(Bodies& d, double h, int sweeps)
{
    for (int k = 1; k < d.u.size(); k += 3) d.u[k] -= d.g * h;  // u*, (3.4)
    find_pins(d, h);
    if (sweeps == 0) solve_tree(d);
    for (int n = 0; n < sweeps; ++n)
        for (int k = 0; k < int(d.pins.size()); ++k) visit(d, k);
    d.x += h * d.u;
}

// A rod of the length L hangs on the end of the last one, or on the world.
void add_rod(Bodies& d, double L, double mass, double angle)
{
    const int n = d.x.size();
    const Vector2d half = turned(angle, {L / 2, 0});
    Vector2d end(0, 0);
    if (n > 0) end = d.x.segment<2>(n - 3) + turned(d.x[n - 1], -d.pins.back().below);
    for (Vec* v : {&d.x, &d.u, &d.inverse_mass}) v->conservativeResize(n + 3);
    d.x.tail<3>() << end + half, angle;
    d.u.tail<3>().setZero();
    d.inverse_mass.tail<3>() << 1 / mass, 1 / mass, 12 / (mass * L * L);
    d.pins.push_back({n / 3 - 1, n > 0 ? Vector2d(-d.pins.back().below) : end, {-L / 2, 0}});
}

int main(int, char**)
{
    Bodies two;
    two.g = 1;
    for (int k = 0; k < 2; ++k) add_rod(two, 1, 1, 0);
    step(two, 1, 0);
    std::printf("lambda %g %g, omega %g %g\n", two.pins[0].lambda[1], two.pins[1].lambda[1], two.u[2], two.u[5]);
    for (double ratio : {1,10,100,1000})
    for (double hz : {60, 240, 960})
    for (const int sweeps : {10, 0}) {
        Bodies d;
        for (int k = 0; k < 50; ++k) add_rod(d, 0.1, 0.1, -70 * std::numbers::pi / 180);
        d.inverse_mass.tail<3>() /= ratio;
        double worst = 0;
        for (int n = 0; n < hz; ++n) {
            step(d, 1.0 / hz, sweeps);
            find_pins(d, 1);
            for (const Pin& pin : d.pins) worst = std::max(worst, pin.C.norm());
        }
        std::printf("%g %g Hz %s: %g m; end at %g %g\n", ratio, hz, sweeps ? "sweeps" : "tree", worst, d.x[147], d.x[148]);
    }
}
