// Chapter 20 in one file, grown from chapter 11: bodies that turn in space.
// A step turns the body and leaves its angular momentum where it is.
//
//     u = (v, ω), ω in the body's own axes,   θ ← θ ⊕ h ξ,   I ω ← exp(−h ξ) I ω
//     ξ, the spin in the middle of the step:  I ω = exp(h/2 ξ) I ξ
#include <Eigen/Geometry>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <numbers>
#include <vector>
using Eigen::Quaterniond, Eigen::Vector3d;
using Vec = Eigen::VectorXd;

struct Bodies {
    Vec x, u, inverse_mass;  // six a body: x, rotation vector; v, ω; 1/m, 1/I
    double g = 9.81;
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

void step(Bodies& d, double h)
{
    const int K = d.x.size() / 6;
    for (int k = 0; k < K; ++k) d.u[6 * k + 2] -= d.g * h;  // u*, (3.4)
    for (int k = 0; k < K; ++k) {
        d.x.segment<3>(6 * k) += h * d.u.segment<3>(6 * k);  // (1.10)
        Vector3d omega = d.u.segment<3>(6 * k + 3);
        const Vector3d delta = turn(d.inverse_mass.segment<3>(6 * k + 3), omega, h);
        d.x.segment<3>(6 * k + 3) = add(d.x.segment<3>(6 * k + 3), delta);
        d.u.segment<3>(6 * k + 3) = omega;
    }
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
}

double spin_energy(const Bodies& d)
{
    const Vector3d omega = d.u.segment<3>(3);
    const Vector3d inverse = d.inverse_mass.segment<3>(3);
    return omega.cwiseAbs2().cwiseQuotient(inverse).sum() / 2;
}

// A book of 0.7 kg that spins about its middle axis, with a wobble.
Bodies book(double spin, double wobble)
{
    Bodies d{{}, {}, {}, 0};
    add_box(d, {0.16, 0.24, 0.04}, 0.7, {0, 0, 0});
    d.u.tail<3>() << spin, spin * wobble, spin * wobble;
    return d;
}

const Vector3d to_eye(-0.3, -1, 0.4);

// Where a point is in the picture, a parallel projection.
std::ostream& put(std::ostream& out, char what, const Vector3d& p)
{
    return out << what << p.x() - 0.3 * p.y() << ' ' << -p.z() - 0.4 * p.y();
}

// Of the angular momentum, which is R I ω in the room, the way that it points.
void draw_momentum(std::ostream& out, const Bodies& d)
{
    const Vector3d inverse = d.inverse_mass.tail<3>(), omega = d.u.tail<3>();
    const Vector3d L = exp(d.x.tail<3>()) * omega.cwiseQuotient(inverse);
    const Vector3d way = 0.2 * L.normalized(), up(0, 0, 0.03);
    const Vector3d from = d.x.head<3>(), to = from + way, neck = to - 0.2 * way;
    out << "<path stroke-width='0.012' fill='none' d='";
    put(put(out, 'M', from), 'L', to);
    put(put(put(out, 'M', neck + up), 'L', to), 'L', neck - up) << "'/>\n";
}

// One half of the book, as six faces of four corners each.
void draw_half(std::ostream& out, const Bodies& d, double side, const char* colour)
{
    const auto R = exp(d.x.tail<3>()).toRotationMatrix();
    for (int i = 0; i < 6; ++i) {
        const int a = i / 2, b = (a + 1) % 3, c = (a + 2) % 3;
        const double end = i % 2 ? 0.5 : -0.5;
        if (end * R.col(a).dot(to_eye) < 0) continue;  // it faces away
        out << "<path fill='" << colour << "' d='";
        for (const auto& [p, q] :
             {std::pair{-.5, -.5}, {.5, -.5}, {.5, .5}, {-.5, .5}}) {
            Vector3d r;
            r[a] = end, r[b] = p, r[c] = q;
            r = R * Vector3d(0.08 * (r[0] + side / 2), 0.24 * r[1], 0.04 * r[2]);
            r += d.x.head<3>();
            put(out, p + q < -0.5 ? 'M' : 'L', r);
        }
        out << "Z'/>\n";
    }
}

int main(int count, char** word)
{
    // By hand, section 20.1: the first step of a book that is tossed.
    const double h = 1.0 / 60;
    Bodies one = book(12, 0.1);
    const Vector3d inverse = one.inverse_mass.tail<3>(), omega = one.u.tail<3>();
    const Vector3d L = omega.cwiseQuotient(inverse), delta = h * omega;
    const auto print = [](const char* what, const Vector3d& v, double unit) {
        std::printf("%s: %.2f %.2f %.2f\n", what, v[0] / unit, v[1] / unit,
                    v[2] / unit);
    };
    print("moments [1e-4 kg m2]", inverse.cwiseInverse(), 1e-4);
    print("angular momentum [1e-3 kg m2/s]", L, 1e-3);
    print("spin after a step, by hand [rad/s]",
          inverse.cwiseProduct(L - delta.cross(L)), 1);
    print("by the turn of the start", inverse.cwiseProduct(exp(-delta) * L), 1);
    step(one, h);
    print("through the middle", one.u.tail<3>(), 1);
    for (const double wobble : {0.1, 0.01}) {
        Bodies d = book(1, wobble);
        int n = 0;
        for (; d.u[3] > 0; ++n) step(d, 0.001);
        std::printf("wobble %g: over after %.2f turns\n", wobble,
                    n * 0.001 / (2 * std::numbers::pi));
    }
    // Section 20.2: two quarter turns.
    const Vector3d x = std::numbers::pi / 2 * Vector3d::UnitX();
    const Vector3d y = std::numbers::pi / 2 * Vector3d::UnitY();
    for (const Vector3d& sum : {add(x, y), add(y, x)}) {
        std::printf("two quarter turns: %.0f degrees, ",
                    sum.norm() * 180 / std::numbers::pi);
        print("about", sum, sum.norm());
    }
    // Section 20.5: eight seconds, by the turn of the start and of the middle.
    Bodies middle = book(12, 0.1), start = middle;
    const double E = spin_energy(middle);
    for (int n = 0; n < 1600; ++n) {
        step(middle, 0.005);
        const Vector3d spin = start.u.tail<3>();
        start.u.tail<3>() =
            inverse.cwiseProduct(exp(-0.005 * spin) * spin.cwiseQuotient(inverse));
    }
    std::printf("energy after 8 s: %.4f, by the turn of the start %.2f\n",
                spin_energy(middle) / E, spin_energy(start) / E);
    // The book, thrown up and to the right: nine pictures of it.
    std::ofstream out(count < 2 ? "" : word[1]);  // SVG, in parallel projection
    out << "<svg xmlns='http://www.w3.org/2000/svg' width='640' stroke='#808080' "
           "stroke-width='0.004' stroke-linejoin='round' viewBox='-0.25 -1 2.9 "
           "1.36'>\n";
    Bodies d = book(12, 0.1);
    d.g = 9.81, d.u.head<3>() << 3, 0, 3.9;
    for (int n = 0; n <= 48; ++n, step(d, h)) {
        if (n % 6) continue;
        const Vector3d red_way = exp(d.x.tail<3>()) * Vector3d::UnitX();
        const bool red_is_near = red_way.dot(to_eye) > 0;
        for (const bool red :
             {!red_is_near, red_is_near})  // the farther half first
            draw_half(out, d, red ? 1 : -1, red ? "#CC3311" : "#4477AA");
        draw_momentum(out, d);
        if (n % 24 == 0)
            out << "<text stroke='none' fill='#808080' font-size='0.07' x='"
                << d.x[0] << "' y='" << 0.24 - d.x[2] << "'>" << n * h
                << " s</text>\n";
    }
    out << "</svg>\n";
    std::printf("after 0.8 s the spin about the middle axis is %.2f rad/s\n",
                d.u[3]);
}
