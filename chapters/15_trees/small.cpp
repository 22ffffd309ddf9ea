// Chapter 15 in one file, grown from chapter 11: bodies that hang on pins, a tree.
// It is solved from the leaves to the root and back.
//     J u + J_p u_p + b = 0 for each pin, (15.3)
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
using Rows = Eigen::Matrix<double, 2, 3>;  // of a pin: along x and y
using Path = std::pair<const char*, std::vector<Vector2d>>;  // a colour and points

struct Pin {
    int parent;             // of the body that it holds; -1: the world
    Vector2d above, below;  // the point in the parent, or the world; in the body
    Rows J = Rows::Zero(), Jp = Rows::Zero();
    Vector2d C = {0, 0}, lambda = {0, 0};  // [m], [N s]
};

struct Bodies {
    Vec x, u, inverse_mass;  // three numbers a body: x, y, angle
    std::vector<Pin> pins;   // one a body, which holds it; a parent comes first
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

void find_rows(Bodies& d)
{
    for (int k = 0; k < int(d.pins.size()); ++k) {
        Pin& pin = d.pins[k];
        const Vector2d r = turned(d.x[3 * k + 2], pin.below);
        pin.J = rows(r), pin.Jp.setZero();
        pin.lambda.setZero();
        pin.C = d.x.segment<2>(3 * k) + r - pin.above;
        if (pin.parent < 0) continue;
        const Vector2d rp = turned(d.x[3 * pin.parent + 2], pin.above);
        pin.Jp = -rows(rp);
        pin.C += pin.above - d.x.segment<2>(3 * pin.parent) - rp;
    }
}

// One visit of a pin: both rows at once.
void visit(Bodies& d, int k, double h)
{
    Pin& pin = d.pins[k];
    const int p = std::max(pin.parent, 0);  // its J_p is zero if that is the world
    const Rows W = pin.J * d.inverse_mass.segment<3>(3 * k).asDiagonal();
    const Rows Wp = pin.Jp * d.inverse_mass.segment<3>(3 * p).asDiagonal();
    const Vector2d w =
        pin.J * d.u.segment<3>(3 * k) + pin.Jp * d.u.segment<3>(3 * p) + pin.C / h;
    const Vector2d change =
        -(W * pin.J.transpose() + Wp * pin.Jp.transpose()).inverse() * w;
    pin.lambda += change;
    d.u.segment<3>(3 * k) += W.transpose() * change;
    d.u.segment<3>(3 * p) += Wp.transpose() * change;
}

// All pins at once.
void solve_tree(Bodies& d, double h)
{
    const int n = d.pins.size();
    std::vector<Matrix3d> S(n, Matrix3d::Zero()), G(n);  // S: what hangs on it
    std::vector<Vector3d> pulled(n, Vector3d::Zero());
    std::vector<Vector2d> r(n);
    for (int k = n - 1; k >= 0; --k) {  // up, from the leaves to the root
        const Pin& pin = d.pins[k];
        const Matrix3d M =
            d.inverse_mass.segment<3>(3 * k).cwiseInverse().asDiagonal();
        G[k] = (M + S[k]).inverse();                // (15.6)
        d.u.segment<3>(3 * k) -= G[k] * pulled[k];  // (15.7)
        r[k] = pin.J * d.u.segment<3>(3 * k) + pin.C / h;
        if (pin.parent < 0) continue;
        const Rows KJp = (pin.J * G[k] * pin.J.transpose()).inverse() * pin.Jp;
        S[pin.parent] += pin.Jp.transpose() * KJp;
        pulled[pin.parent] +=
            KJp.transpose() * (pin.Jp * d.u.segment<3>(3 * pin.parent) + r[k]);
    }
    for (int k = 0; k < n; ++k) {  // down, from the root to the leaves
        Pin& pin = d.pins[k];
        if (pin.parent >= 0) r[k] += pin.Jp * d.u.segment<3>(3 * pin.parent);
        const Vector2d change =
            -(pin.J * G[k] * pin.J.transpose()).inverse() * r[k];  // (15.5)
        pin.lambda += change;
        d.u.segment<3>(3 * k) += G[k] * pin.J.transpose() * change;  // (15.4)
    }
}

// With sweeps over the pins, or, if there are none, with the tree.
void step(Bodies& d, double h, int sweeps)
{
    for (int k = 1; k < d.u.size(); k += 3) d.u[k] -= d.g * h;  // u*, (3.4)
    find_rows(d);
    if (sweeps == 0) solve_tree(d, h);
    for (int n = 0; n < sweeps; ++n)
        for (int k = 0; k < int(d.pins.size()); ++k) visit(d, k, h);
    d.x += h * d.u;  // (1.10)
}

// A rod of the length L hangs on the end of the last one, or on the world.
void add_rod(Bodies& d, double L, double mass, double angle)
{
    const int n = d.x.size();
    const Vector2d half = turned(angle, {L / 2, 0});
    Vector2d end(0, 0);
    if (n > 0)
        end = d.x.segment<2>(n - 3) + turned(d.x[n - 1], -d.pins.back().below);
    for (Vec* v : {&d.x, &d.u, &d.inverse_mass}) v->conservativeResize(n + 3);
    d.x.tail<3>() << end + half, angle;
    d.u.tail<3>().setZero();
    d.inverse_mass.tail<3>() << 1 / mass, 1 / mass, 12 / (mass * L * L);
    d.pins.push_back(
        {n / 3 - 1, n > 0 ? Vector2d(-d.pins.back().below) : end, {-L / 2, 0}});
}

int main(int count, char** word)
{
    // By hand, section 15.1: two level rods, g h = 1 m/s; then a quarter of a
    // kilogram in the second one's place, a rod that hangs by its middle.
    std::vector<Path> paths;
    for (const bool replaced : {false, true}) {
        Bodies d{{}, {}, {}, {}, 1};
        add_rod(d, 1, 1, 0), add_rod(d, 1, replaced ? 0.25 : 1, 0);
        if (replaced) d.pins[1].below.setZero(), d.x[3] = 1;
        step(d, 1, 0);
        const Vector2d first = d.pins[0].lambda, second = d.pins[1].lambda;
        std::printf("lambda %.4f, %.4f N s; omega %.4f, %.4f rad/s\n", first.y(),
                    second.y(), d.u[2], d.u[5]);
        const Vector2d wall(replaced ? 2.3 : 0, 0), level = wall + Vector2d(1, 0);
        for (const double t : {0.0, 0.1, 0.2, 0.3}) {  // how they begin to turn
            const Vector2d pin = wall + turned(t * d.u[2], {1, 0});
            std::vector<Vector2d> drawn{wall, pin};
            if (!replaced) drawn.push_back(pin + turned(t * d.u[5], {1, 0}));
            for (int side = 0; replaced && side < 5; ++side)  // the weight
                drawn.push_back(pin +
                                turned(side * std::numbers::pi / 2, {0.05, 0}));
            paths.push_back({t > 0 ? "#4477AA" : "#808080", drawn});
        }
        paths.push_back({"#CC3311", {wall, wall + first}});
        paths.push_back({"#CC3311", {level, level + second}});
    }
    for (const int sweeps : {10, 0}) {
        Bodies d;
        for (int k = 0; k < 50; ++k)
            add_rod(d, 0.1, 0.1, -7 * std::numbers::pi / 18);
        d.inverse_mass.tail<3>() /= 100;
        double gap = 0;
        for (int n = 0; n < 240; ++n) {
            step(d, 1.0 / 240, sweeps);
            find_rows(d);
            for (const Pin& pin : d.pins) gap = std::max(gap, pin.C.norm());
        }
        std::printf("fifty links, %s: %.1e m\n",
                    sweeps > 0 ? "ten sweeps" : "the tree", gap);
    }
    std::ofstream out(count < 2 ? "" : word[1]);  // an SVG picture, y upwards
    out << "<svg xmlns='http://www.w3.org/2000/svg' fill='none' "
           "width='500' stroke-width='0.025' viewBox='-0.1 -0.45 3.6 1'>\n";
    for (const auto& [colour, points] : paths) {
        out << "<polyline stroke='" << colour << "' points='";
        for (const Vector2d& p : points) out << p.x() << ',' << -p.y() << ' ';
        out << "'/>\n";
    }
    out << "<g fill='#808080' font-size='.11'><text x='.03' y='-.2'>λ₁</text>"
           "<text x='.4' y='-.05'>rod 1</text><text x='.96' y='-.05'>λ₂</text>"
           "<text x='1.4' y='-.05'>rod 2</text><text x='2.33' y='-.2'>λ₁</text>"
           "<text x='2.65' y='-.05'>rod 1</text><text x='3.2' y='-.1'>¼ kg</text>"
           "</g></svg>\n";
}
