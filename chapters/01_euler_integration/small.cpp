// Chapter 1 in one file: a mass on a spring, by Euler's three methods and Verlet's.
//
//     dx/dt = u,   du/dt = a = −ω² x        E = ½ u² + ½ ω² x²
//
// Explicit Euler gains energy in each step. With its two lines swapped it does not.
#include <Eigen/Core>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <numbers>
#include <vector>
using Eigen::Vector2d;
using Path = std::pair<const char*, std::vector<Vector2d>>;  // a colour and points

struct Body {
    double x, u;  // [m], [m/s]
};

// (1.5)
void explicit_euler(Body& body, double h, double omega)
{
    const double a = -omega * omega * body.x;
    body.x += h * body.u;
    body.u += h * a;
}

// (1.10): the same two lines in the other order.
void symplectic_euler(Body& body, double h, double omega)
{
    const double a = -omega * omega * body.x;
    body.u += h * a;
    body.x += h * body.u;
}

// (1.14): the force where the step ends.
void implicit_euler(Body& body, double h, double omega)
{
    body.u = (body.u - h * omega * omega * body.x) / (1 + h * h * omega * omega);
    body.x += h * body.u;
}

// (1.24): half a kick, a drift, half a kick with the force where the drift ends.
void velocity_verlet(Body& body, double h, double omega)
{
    body.u += h / 2 * (-omega * omega * body.x);
    body.x += h * body.u;
    body.u += h / 2 * (-omega * omega * body.x);
}

// (1.7)
double energy(const Body& body, double omega)
{
    return 0.5 * body.u * body.u + 0.5 * omega * omega * body.x * body.x;
}

struct Method {
    const char* name;
    void (*step)(Body&, double h, double omega);
    const char* colour;
};

int main(int count, char** word)
{
    std::vector<Path> paths{{"#808080", {}},  // the exact motion is a circle
                            {"#808080", {{-1.3, 0}, {1.3, 0}}},
                            {"#808080", {{0, -1.3}, {0, 1.3}}}};
    for (double t = 0; t < 6.4; t += 0.1)
        paths[0].second.push_back({std::cos(t), std::sin(t)});

    for (const Method& method : {Method{"explicit", explicit_euler, "#CC3311"},
                                 {"symplectic", symplectic_euler, "#4477AA"},
                                 {"implicit", implicit_euler, "#228833"}}) {
        // By hand: ω = 1 rad/s, h = 0.5 s, let go at rest at 1 m.
        std::printf("%s Euler\n", method.name);
        Body body{1, 0};
        paths.push_back({method.colour, {{1, 0}}});
        for (int n = 1; n <= 12; ++n) {
            method.step(body, 0.5, 1);
            paths.back().second.push_back({body.x, body.u});
            if (n <= 2)
                std::printf("    x %g m, u %g m/s, E %g J\n", body.x, body.u,
                            energy(body, 1));
        }
        // Four seconds of 1 Hz, 60 steps a second.
        const double omega = 2 * std::numbers::pi;
        Body spring{1, 0};
        for (int n = 0; n < 240; ++n) method.step(spring, 1.0 / 60, omega);
        std::printf("    after 4 s: %.3f of the energy\n",
                    energy(spring, omega) / energy({1, 0}, omega));
    }
    Body body{1, 0};
    velocity_verlet(body, 0.5, 1);
    std::printf("Verlet\n    x %g m, u %g m/s, E %g J\n", body.x, body.u,
                energy(body, 1));
    if (count < 2) return 0;
    std::ofstream out(word[1]);  // an SVG picture of the paths; y points upwards
    out << "<svg xmlns='http://www.w3.org/2000/svg' fill='none' "
           "width='400' stroke-width='0.03' viewBox='-2.4 -3.4 5.5 5.2'>\n";
    for (const auto& [colour, points] : paths) {
        out << "<polyline stroke='" << colour << "' points='";
        for (const Vector2d& p : points) out << p.x() << ',' << -p.y() << ' ';
        out << "'/>\n";
    }
    out << "<g fill='#808080' font-size='0.25'><text x='1.4' y='0.1'>x [m]</text>"
           "<text x='0.08' y='-1.45'>u [m/s]</text>"
           "<text x='1.3' y='0.8' fill='#CC3311'>explicit</text>"
           "<text x='1.3' y='1.15' fill='#4477AA'>symplectic</text>"
           "<text x='1.3' y='1.5' fill='#228833'>implicit</text></g></svg>\n";
}
