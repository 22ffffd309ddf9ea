// Chapter 26 in one file, grown from chapter 2: one constraint, said in five ways.
// A bead on a wire: a spring, an acceleration, a velocity, a position, or a
// coordinate that is not there.
//
//     C = ‖x‖ − 1,  J = xᵀ/‖x‖,  dC/dt = J u,  d²C/dt² = J a + k
#include <Eigen/Core>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <string>
#include <vector>
using Eigen::RowVector2d;
using Eigen::Vector2d;

const Vector2d gravity{0, -10};  // [m/s²]

struct Body {
    Vector2d x, u;  // [m], [m/s]
    double inverse_mass = 1;
};

double off(const Body& body) { return body.x.norm() - 1; }  // C [m]

// (2.7): the impulse that makes w = J u + b + γ λ zero; γ = 0: a hard row.
double impulse(const Body& body, const RowVector2d& J, double b, double gamma = 0)
{
    const double w = J * body.u + b;
    const double A = J * body.inverse_mass * J.transpose();
    return -w / (A + gamma);
}

RowVector2d across(const Body& body) { return body.x.transpose() / body.x.norm(); }

// A spring k: its force where the bead is now, (26.1).
void spring_step(Body& body, double h, double k)
{
    const RowVector2d J = across(body);
    body.u += h * (gravity - body.inverse_mass * k * off(body) * J.transpose());
    body.x += h * body.u;
}

// The same spring, its force at the end of the step: a row that gives way, (16.9).
void soft_step(Body& body, double h, double k)
{
    const RowVector2d J = across(body);
    body.u += h * gravity;
    const double lambda = impulse(body, J, off(body) / h, 1 / (h * h * k));
    body.u += body.inverse_mass * J.transpose() * lambda;
    body.x += h * body.u;
}

// An acceleration, (26.4): the force that makes J a + k zero.
Vector2d acceleration(const Body& body)
{
    const RowVector2d J = across(body);
    const double along = J * body.u;
    const double k = (body.u.squaredNorm() - along * along) / body.x.norm();
    const double A = J * body.inverse_mass * J.transpose();
    const double f = -(J * gravity + k) / A;  // [N]
    return gravity + body.inverse_mass * J.transpose() * f;
}

void acceleration_step(Body& body, double h, double)
{
    body.u += h * acceleration(body);
    body.x += h * body.u;
}

// The same acceleration in a step of order 4, (1.29).
void runge_kutta_step(Body& body, double h, double)
{
    const auto moved = [&](double t, const Vector2d& u, const Vector2d& a) {
        return Body{body.x + t * u, body.u + t * a, body.inverse_mass};
    };
    const Vector2d a1 = acceleration(body);
    const Body two = moved(h / 2, body.u, a1);
    const Vector2d a2 = acceleration(two);
    const Body three = moved(h / 2, two.u, a2);
    const Vector2d a3 = acceleration(three);
    const Body four = moved(h, three.u, a3);
    const Vector2d a4 = acceleration(four);
    body.x += h / 6 * (body.u + 2 * two.u + 2 * three.u + four.u);
    body.u += h / 6 * (a1 + 2 * a2 + 2 * a3 + a4);
}

// A velocity: the row of chapter 2.
void row_step(Body& body, double h, double)
{
    const RowVector2d J = across(body);  // (2.2)
    body.u += h * gravity;
    const double lambda = impulse(body, J, 0);
    body.u += body.inverse_mass * J.transpose() * lambda;  // (2.5)
    body.x += h * body.u;                                  // (1.10)
}

// A position, (26.7): move first, put back, and see how fast that was.
void position_step(Body& body, double h, double)
{
    const Vector2d before = body.x;
    body.x += h * (body.u + h * gravity);
    const RowVector2d J = across(body);
    const double A = J * body.inverse_mass * J.transpose();
    body.x -= body.inverse_mass * J.transpose() * off(body) / A;
    body.u = (body.x - before) / h;
}

// No constraint: the angle from straight down is all there is, (26.8).
void angle_step(Body& body, double h, double)
{
    double angle = std::atan2(body.x[0], -body.x[1]);
    const Vector2d along{std::cos(angle), std::sin(angle)};
    const double rate = along.dot(body.u) + h * along.dot(gravity);
    angle += h * rate;
    body.x << std::sin(angle), -std::cos(angle);
    body.u << rate * std::cos(angle), rate * std::sin(angle);
}

// (2.8), and the height
double energy(const Body& body)
{
    return (body.u.squaredNorm() / 2 - gravity.dot(body.x)) / body.inverse_mass;
}

struct Way {
    const char *name, *colour;
    void (*step)(Body&, double h, double k);
};
const std::vector<Way> ways{{"spring", "#EE7733", spring_step},
                            {"spring at the end", "#AA7700", soft_step},
                            {"acceleration", "#CC3311", acceleration_step},
                            {"the same, order 4", "#EE3377", runge_kutta_step},
                            {"velocity", "#4477AA", row_step},
                            {"position", "#228833", position_step},
                            {"coordinate", "#AA3377", angle_step}};

// By hand: on the wire, along it at 1 m/s.
Body by_hand() { return {{0.6, -0.8}, {0.8, 0.6}}; }

Body swung(const Way& way, double h, double k, double time)
{
    Body body = by_hand();
    for (int n = 0; n < std::lround(time / h); ++n) way.step(body, h, k);
    return body;
}

int main(int count, char** word)
{
    for (const Way& way : ways) {  // one step, section 26.1
        Body body = by_hand();
        way.step(body, 0.1, 100);
        std::printf("%-18s u %7.4f %7.4f  x %7.4f %7.4f  %8.4f mm off\n", way.name,
                    body.u[0], body.u[1], body.x[0], body.x[1], 1000 * off(body));
    }
    // One second: how far from the truth, how far off the wire, which energy.
    const Vector2d truth = swung(ways[3], 1e-4, 0, 1).x;
    for (const double h : {1.0 / 50, 1.0 / 100, 1.0 / 200, 1.0 / 400}) {
        std::printf("h = 1/%.0f s\n", 1 / h);
        for (const Way& way : ways) {
            const Body body = swung(way, h, 10000, 1);
            std::printf("%-18s error %.2e m, off %9.2e m, energy %+.2e J\n",
                        way.name, (body.x - truth).norm(), off(body),
                        energy(body) - energy(by_hand()));
        }
    }
    std::printf("k = 39000 and 41000 N/m in steps of 0.01 s: %.2e and %.2e m off\n",
                off(swung(ways[0], 0.01, 39000, 10)),
                off(swung(ways[0], 0.01, 41000, 10)));
    if (count < 2) return 0;

    std::ofstream out(word[1]);  // an SVG picture; y points upwards
    out << "<svg xmlns='http://www.w3.org/2000/svg' fill='none' width='560' "
           "stroke-width='0.0012' viewBox='0.574 0.736 0.19 0.13'>\n"
           "<circle r='1' stroke='#808080' stroke-width='0.003'/>\n";
    double line = 0.752;
    for (const Way& way : ways) {
        Body body = by_hand();
        out << "<path stroke='" << way.colour << "' d='M0.6 0.8";
        way.step(body, 0.1, 100);
        out << 'L' << body.x[0] << ' ' << -body.x[1] << "'/>\n<circle fill='"
            << way.colour << "' r='0.0022' cx='" << body.x[0] << "' cy='"
            << -body.x[1] << "'/>\n<text font-size='0.0085' fill='" << way.colour
            << "' font-family='sans-serif' x='0.675' y='" << line << "'>"
            << way.name << "</text>\n";
        line += 0.011;
    }
    out << "</svg>\n";
}
