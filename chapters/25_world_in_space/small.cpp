// Chapter 25 in one file, grown from chapter 8: sweeps side by side, in space.
// What moves no body in common can change places: the same order, the same bits.
//
//     level of a visit = 1 + the highest level so far of the bodies that it moves
#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <string>
#include <vector>
using Eigen::Vector2d;
using Eigen::Vector3d;
using Vec = Eigen::VectorXd;
using Mat = Eigen::MatrixXd;
using Path = std::pair<const char*, std::vector<Vector2d>>;  // a colour and points

struct Contact {
    int a, b;      // ball b and ball a, or a wall: -1, -2, …
    Vector3d n;    // from a to b
    double C, lo;  // gap [m]; bound of λ: 0, or -∞ for a link, which pulls as well
    double bias = 0, lambda = 0;  // [m/s], [N s]
    int level = 0;
};

struct Balls {
    Vec x, u, inverse_mass, radius;  // three numbers a ball, but one radius
    int chain;                       // so many balls, the first ones, are linked
    Mat walls;                       // columns n, c: where n·p ≥ c it is free
    double g = 9.81;
    std::vector<Contact> contacts = {};  // of the last step
};

// The links, then all pairs of balls, then balls and walls, with gaps below 2 cm.
std::vector<Contact> find_contacts(const Balls& d)
{
    std::vector<Contact> found;
    const int K = d.radius.size();
    const auto meet = [&](int a, int b, double margin, double lo) {
        const Vector3d ab = d.x.segment<3>(3 * b) - d.x.segment<3>(3 * a);
        const double C = ab.norm() - d.radius[a] - d.radius[b];
        if (C < margin) found.push_back({a, b, ab.normalized(), C, lo});
    };
    for (int b = 1; b < d.chain; ++b) meet(b - 1, b, INFINITY, -INFINITY);
    for (int a = 0; a < K; ++a)
        for (int b = a + 1; b < K; ++b)
            if (b > a + 1 || b >= d.chain) meet(a, b, 0.02, 0);
    for (int b = 0; b < K; ++b)
        for (int i = 0; i < d.walls.cols(); ++i) {
            const Vector3d n = d.walls.col(i).head<3>(), p = d.x.segment<3>(3 * b);
            const double C = n.dot(p) - d.walls(3, i) - d.radius[b];
            if (C < 0.02) found.push_back({-1 - i, b, n, C, 0});
        }
    return found;
}

// (6.5): an impulse along J, on both balls.
void push(const Contact& c, double impulse, Balls& d)
{
    const Vector3d P = impulse * c.n;
    if (c.a >= 0) d.u.segment<3>(3 * c.a) -= d.inverse_mass[3 * c.a] * P;
    d.u.segment<3>(3 * c.b) += d.inverse_mass[3 * c.b] * P;
}

// One visit: (6.2) to (6.5). Returns by how much the row was off [m/s].
double visit(Contact& c, Balls& d)
{
    double w = c.bias + c.n.dot(d.u.segment<3>(3 * c.b));
    if (c.a >= 0) w -= c.n.dot(d.u.segment<3>(3 * c.a));
    const double A =
        d.inverse_mass[3 * c.b] + (c.a < 0 ? 0 : d.inverse_mass[3 * c.a]);
    const double change = std::max(c.lo, c.lambda - w / A) - c.lambda;
    c.lambda += change;
    push(c, change, d);
    return A * std::abs(change);
}

// (25.1): the level of each row, in the order of the sweep.
void find_levels(std::vector<Contact>& contacts, int K)
{
    std::vector<int> highest(K);  // so far, of each ball
    for (Contact& c : contacts) {
        int &b = highest[c.b], &a = c.a < 0 ? b : highest[c.a];
        a = b = c.level = 1 + std::max(a, b);
    }
}

int step(Balls& d, double h, double beta, int most, bool by_levels)
{
    for (int k = 2; k < d.u.size(); k += 3) d.u[k] -= d.g * h;  // u*, (3.4)
    std::vector<Contact> contacts = find_contacts(d);
    for (Contact& c : contacts) {
        c.bias = (c.lo < 0 || c.C < 0 ? beta : 1) * c.C / h;  // (7.4), (3.30)
        for (const Contact& old : d.contacts)  // its key: which two touch
            if (old.a == c.a && old.b == c.b) push(c, c.lambda = old.lambda, d);
    }
    find_levels(contacts, d.radius.size());
    std::vector<Contact*> order;
    for (Contact& c : contacts) order.push_back(&c);
    if (by_levels) {  // rows of one level backwards: any order will do
        std::ranges::reverse(order);
        std::ranges::stable_sort(order, {}, &Contact::level);
    }
    int sweeps = 0;
    for (double off = 1; off > 1e-6 && sweeps < most; ++sweeps) {
        off = 0;
        for (Contact* c : order) off = std::max(off, visit(*c, d));
    }
    d.x += h * d.u;  // (1.10)
    d.contacts = contacts;
    return sweeps;
}

// Layers of nine in a pit, a little beside each other.
Balls poured(int K)
{
    const Vec one = Vec::Ones(3 * K);
    Balls d{one, 0 * one, one, 0.5 * one.head(K), 0, {}};
    d.walls = Mat{{1, -1, 0, 0, 0},
                  {0, 0, 1, -1, 0},
                  {0, 0, 0, 0, 1},
                  {-1.6, -1.6, -1.6, -1.6, 0}};
    for (int k = 0; k < K; ++k)
        d.x.segment<3>(3 * k) << 1.05 * (k % 3 - 1) + 0.01 * (k % 5),
            1.05 * (k / 3 % 3 - 1) + 0.01 * (k % 7), 0.6 + 1.1 * (k / 9);
    return d;
}

// Section 25.1: five rows on four balls.
std::vector<Contact> five_rows()
{
    std::vector<Contact> rows;
    for (const auto& [a, b] : {std::pair{-1, 0}, {0, 1}, {-1, 2}, {1, 2}, {-1, 3}})
        rows.push_back({a, b, {0, 0, 1}, 0, 0});
    find_levels(rows, 4);
    return rows;
}

int main(int count, char** word)
{
    // By hand, section 25.1: the rows in their order, and by levels.
    const std::vector<Contact> five = five_rows();
    std::vector<Path> paths;
    for (int k = 0; k < 8; ++k) {
        const double x = 1.3 * k + (k < 4 ? 0 : 0.8);
        paths.push_back({"#808080", {{x, 0.3}, {x, -4.4}}});
    }
    for (int i = 0; i < 5; ++i) {
        const Contact& c = five[i];
        std::printf("row %d: level %d\n", i + 1, c.level);
        for (const double right : {0.0, 6.0}) {
            const double from = right + 1.3 * (c.a < 0 ? c.b : c.a);
            const double y = right > 0 ? 1.2 - 1.6 * c.level : -i;
            const char* const colours[] = {"#4477AA", "#EE7733", "#CC3311"};
            paths.push_back(
                {colours[c.level - 1], {{from, y}, {right + 1.3 * c.b, y}}});
        }
    }
    // Both orders, of a hundred balls that are poured.
    Balls one_by_one = poured(100), side_by_side = one_by_one;
    for (int n = 0; n < 240; ++n) {
        step(one_by_one, 1.0 / 120, 0.2, 30, false);
        step(side_by_side, 1.0 / 120, 0.2, 30, true);
    }
    int levels = 0;
    for (const Contact& c : side_by_side.contacts)
        levels = std::max(levels, c.level);
    std::printf("%zu rows in %d levels; the same bits: %s\n",
                side_by_side.contacts.size(), levels,
                one_by_one.x == side_by_side.x ? "yes" : "no");
    if (count < 2) return 0;
    std::ofstream out(word[1]);  // an SVG picture of the paths; y points upwards
    out << "<svg xmlns='http://www.w3.org/2000/svg' fill='none' "
           "width='560' stroke-width='0.06' viewBox='-0.8 -0.95 12.9 5.75'>\n";
    const auto label = [&out](double x, double y, const std::string& text) {
        out << "<text fill='#808080' font-size='0.42' x='" << x << "' y='" << y
            << "'>" << text << "</text>\n";
    };
    for (int k = 0; k < 4; ++k)
        for (const double right : {0.0, 6.0})
            label(right + 1.3 * k - 0.14, -0.4, std::string(1, char('A' + k)));
    for (int level = 1; level <= 3; ++level)
        label(10.3, 1.6 * level - 1.05, "level " + std::to_string(level));
    for (const auto& [colour, points] : paths) {
        out << "<polyline stroke='" << colour << "' points='";
        for (const Vector2d& p : points) out << p.x() << ',' << -p.y() << ' ';
        out << "'/>\n";
    }
    for (int i = 8; i < 18; ++i) {
        const auto& [colour, points] = paths[i];
        for (const Vector2d& p : points)
            out << "<circle fill='" << colour << "' r='0.16' cx='" << p.x()
                << "' cy='" << -p.y() << "'/>\n";
        label(points[0].x() - 0.55, 0.15 - points[0].y(),
              std::to_string(i / 2 - 3));
    }
    out << "</svg>\n";
}
