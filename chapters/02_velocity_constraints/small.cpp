// Chapter 2 in one file, grown from chapter 1: a bead on a wire.
// An impulse along Jᵀ between the two lines of symplectic Euler makes J u + b zero.
//
//     C = ½ (xᵀx − 1),  J = xᵀ,  λ = −(J u + b) / (J M⁻¹ Jᵀ),  u ← u + M⁻¹ Jᵀ λ
#include <Eigen/Core>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <vector>
using Eigen::Vector2d;
using Path = std::pair<const char*, std::vector<Vector2d>>;  // a colour and points

struct Body {
    Vector2d x, u;  // [m], [m/s]
    double inverse_mass = 1;
};

// (2.7): the impulse that makes the row's w = J u + b zero.
double impulse(const Body& body, const Eigen::RowVector2d& J, double b)
{
    const double w = J * body.u + b;
    const double A = J * body.inverse_mass * J.transpose();
    return -w / A;
}

void row_step(Body& body, double h)
{
    const Eigen::RowVector2d J = body.x.transpose();  // (2.2)
    const double lambda = impulse(body, J, 0);
    body.u += body.inverse_mass * J.transpose() * lambda;  // (2.5)
    body.x += h * body.u;                                  // (1.10)
}

// (2.1): a spring in place of the row.
void spring_step(Body& body, double h, double stiffness)
{
    const double C = 0.5 * (body.x.squaredNorm() - 1) / body.x.norm();
    body.u -= h * body.inverse_mass * stiffness * C * body.x.normalized();
    body.x += h * body.u;
}

// (2.8)
double energy(const Body& body)
{
    return 0.5 * body.u.squaredNorm() / body.inverse_mass;
}

int main(int count, char** word)
{
    // By hand, section 2.3: a bead of 2 kg that leaves the wire at 1 m/s.
    const Body before{{0.6, 0.8}, {1, 0.5}, 0.5};
    Body bead = before;
    std::printf("lambda %g N s", impulse(bead, bead.x.transpose(), 0));
    row_step(bead, 0);
    std::printf(", u %g %g m/s, energy %g J, then %g J\n", bead.u[0], bead.u[1],
                energy(before), energy(bead));

    for (const double stiffness : {100, 1000, 10000, 39000, 41000}) {
        Body body{{1, 0}, {0, 1}};
        double farthest = 0;
        for (int n = 0; n < 1000; ++n) {
            spring_step(body, 0.01, stiffness);
            farthest = std::max(farthest, std::abs(body.x.norm() - 1));
        }
        std::printf("spring of %5g N/m: %.3g mm off the wire\n", stiffness,
                    1000 * farthest);
    }
    Body body{{1, 0}, {0, 1}};
    for (int n = 0; n < 1000; ++n) row_step(body, 0.01);
    std::printf("row: %.3f mm off the wire, radius %.12f m\n",
                1000 * (body.x.norm() - 1), body.x.norm());
    if (count < 2) return 0;

    const Vector2d x = bead.x, end = x + before.u;
    std::vector<Path> paths{{"#808080", {}},                 // the wire
                            {"#EE7733", {x, end}},           // u*
                            {"#CC3311", {end, x + bead.u}},  // M⁻¹ Jᵀ λ
                            {"#4477AA", {x, x + bead.u}}};   // u
    for (double t = -0.3; t < 2.2; t += 0.05)
        paths[0].second.push_back({std::cos(t), std::sin(t)});
    std::ofstream out(word[1]);  // an SVG picture of the paths; y points upwards
    out << "<svg xmlns='http://www.w3.org/2000/svg' fill='none' "
           "width='400' stroke-width='0.015' viewBox='-0.7 -1.5 2.5 1.8'>\n";
    for (const auto& [colour, points] : paths) {
        out << "<polyline stroke='" << colour << "' points='";
        for (const Vector2d& p : points) out << p.x() << ',' << -p.y() << ' ';
        out << "'/>\n";
    }
    out << "<g fill='#808080' font-size='0.1'><text x='-0.4' y='-0.75'>wire</text>"
           "<text x='1.35' y='-1.33'>u*</text>"
           "<text x='1.38' y='-0.85'>Jᵀλ/m</text><text x='0.66' y='-0.55'>u</text>"
           "</g></svg>\n";
}
