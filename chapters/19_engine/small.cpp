// Chapter 19 in one file, grown from chapter 18: boxes come and go.
// A place and a generation name a box; what was saved goes on to the same bits. To
// leave room for that, boxes do not turn here and have no friction.
#include <Eigen/Core>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>
using Eigen::Vector2d;
using Vec = Eigen::VectorXd;
using Mat = Eigen::MatrixXd;

struct Contact {
    int a, b;    // two bodies
    Vector2d n;  // from a to b
    double C;    // gap [m]
};

struct Id {
    int place, generation;
};

const int K = 8;  // places

struct World {
    // two numbers a place, half: of the size of its box
    Vec x = Vec::Zero(2 * K), u = x, inverse_mass = x, half = x;
    Vec rest = Vec::Zero(K);  // for how long its box has rested [s]
    // of the box that has or had the place; 1: there is one
    std::vector<int> generation = std::vector<int>(K), there = generation;
};

// (12.1): of boxes that do not turn, two axes; the gap is the larger one.
void collide(const World& d, int a, int b, std::vector<Contact>& found)
{
    if (!d.there[a] || !d.there[b]) return;  // a free place meets nothing
    const Vector2d r = d.x.segment<2>(2 * b) - d.x.segment<2>(2 * a);
    const Vector2d sizes = d.half.segment<2>(2 * a) + d.half.segment<2>(2 * b);
    int axis;
    const double C = (r.cwiseAbs() - sizes).maxCoeff(&axis);
    const Vector2d n = Vector2d::Unit(axis) * (r[axis] < 0 ? -1 : 1);
    if (C < 0.02) found.push_back({a, b, n, C});
}

// (10.5): the island of each body; K: it cannot move, or is not there.
std::vector<int> islands(const World& d, std::vector<Contact>& contacts)
{
    std::vector<int> of(K);
    for (int b = 0; b < K; ++b) {
        for (int a = 0; a < b; ++a) collide(d, a, b, contacts);
        of[b] = d.there[b] && d.inverse_mass[2 * b] > 0 ? b : K;
    }
    for (const Contact& c : contacts)
        if (std::max(of[c.a], of[c.b]) < K)
            std::ranges::replace(of, int(of[c.b]), int(of[c.a]));
    return of;
}

void solve(const std::vector<Contact>& contacts, World& d, double h)
{
    const int m = contacts.size();
    Mat J = Mat::Zero(m, d.x.size());
    Vec b(m), lambda = Vec::Zero(m);
    for (int i = 0; i < m; ++i) {
        const Contact& c = contacts[i];
        J.block<1, 2>(i, 2 * c.a) = -c.n.transpose();
        J.block<1, 2>(i, 2 * c.b) = c.n.transpose();
        // (3.30), (7.4): but 5 mm of an overlap may stay
        b[i] = c.C > 0 ? c.C / h : 0.2 * std::min(c.C + 0.005, 0.0) / h;
    }
    const Mat W = d.inverse_mass.asDiagonal() * J.transpose(), A = J * W;
    const Vec q = J * d.u + b;
    for (int n = 0; n < 200; ++n)
        for (int i = 0; i < m; ++i)  // (4.4)
            lambda[i] =
                std::max(0.0, lambda[i] - (A.row(i).dot(lambda) + q[i]) / A(i, i));
    d.u += W * lambda;
}

void step(World& d, double h)
{
    std::vector<Contact> contacts;
    const std::vector<int> of = islands(d, contacts);
    std::vector<double> rest(K + 1, INFINITY);  // of each island
    for (int k = 0; k < K; ++k)
        if (of[k] < K) rest[of[k]] = std::min(rest[of[k]], d.rest[k]);
    const auto sleeps = [&](int k) { return rest[of[k]] >= 0.5; };  // (10.7)
    std::erase_if(contacts, [&](auto& c) { return sleeps(c.a) && sleeps(c.b); });
    for (int k = 0; k < K; ++k)
        if (!sleeps(k)) d.u[2 * k + 1] -= 9.81 * h;  // u*, (3.4)
    solve(contacts, d, h);
    for (int k = 0; k < K; ++k) {
        if (sleeps(k)) continue;
        d.x.segment<2>(2 * k) += h * d.u.segment<2>(2 * k);  // (1.10)
        d.rest[k] = d.u.segment<2>(2 * k).norm() < 2e-3 ? d.rest[k] + h : 0;
    }
}

// Puts a box into the first free place; one of mass INFINITY is fixed.
Id add_box(World& d, const Vector2d& half, double mass, const Vector2d& at)
{
    const int k = std::ranges::find(d.there, 0) - d.there.begin();
    d.there.at(k) = 1, d.rest[k] = 0;
    d.x.segment<2>(2 * k) = at, d.u.segment<2>(2 * k).setZero();
    d.inverse_mass.segment<2>(2 * k).setConstant(1 / mass);
    d.half.segment<2>(2 * k) = half;
    return {k, ++d.generation[k]};
}

// The place of a box. What names no box, or one that was taken out, is refused.
int place(const World& d, const Id& id)
{
    if (d.there.at(id.place) && d.generation[id.place] == id.generation)
        return id.place;
    throw std::invalid_argument("box " + std::to_string(id.place) +
                                " of generation " + std::to_string(id.generation) +
                                " was removed");
}

// What touches the box that is taken out wakes, and so does its island.
void remove_box(World& d, const Id& id)
{
    const int k = place(d, id);
    std::vector<Contact> touches;
    for (int b = 0; b < K; ++b) collide(d, k, b, touches);
    for (const Contact& c : touches) d.rest[c.b] = 0;
    d.there[k] = 0;
}

// One list writes and reads. What is not in it the step finds again.
void members(World& d, const auto& io)
{
    io(d.x), io(d.u), io(d.inverse_mass), io(d.half);
    io(d.rest), io(d.generation), io(d.there);
}

std::string save(World d)
{
    std::string bytes;
    members(d, [&](auto& list) {
        bytes.append((const char*)list.data(), list.size() * sizeof list[0]);
    });
    return bytes;
}

World load(const std::string& bytes)
{
    World d;
    std::size_t from = 0;
    members(d, [&](auto& list) {
        from += bytes.copy((char*)list.data(), list.size() * sizeof list[0], from);
    });
    return d;
}

unsigned long long hash(const World& d)
{
    unsigned long long sum = 14695981039346656037u;  // FNV-1a
    for (const unsigned char c : save(d)) sum = (sum ^ c) * 1099511628211u;
    return sum;
}

int main(int count, char** word)
{
    // By hand, section 19.1: add, remove, add. Then a tower of five.
    World d;
    add_box(d, {20, 0.5}, INFINITY, {0, -0.5});
    const Id old = add_box(d, {0.5, 0.5}, 1, {-3, 0.5});
    remove_box(d, old);
    const Id now = add_box(d, {0.5, 0.5}, 1, {-3, 0.5});
    for (const Id& i : {old, now})
        std::printf("place %d, generation %d\n", i.place, i.generation);
    try {
        place(d, old);
    } catch (const std::invalid_argument& refused) {
        std::printf("%s\n", refused.what());
    }
    for (int k = 0; k < 5; ++k) add_box(d, {0.5, 0.5}, 1, {0, 0.5 + k});
    for (int n = 0; n < 120; ++n) step(d, 1.0 / 120);
    remove_box(d, {3, 1});  // the second one of the tower
    for (int n = 0; n < 30; ++n) step(d, 1.0 / 120);
    std::ofstream out(count < 2 ? "" : word[1]);  // an SVG picture, y upwards
    out << "<svg xmlns='http://www.w3.org/2000/svg' fill='none' width='720' "
           "stroke-width='0.04' viewBox='-6 -5.2 10 5.7'>\n";
    for (int k = 0; k < K; ++k) {
        const Vector2d size = 2 * d.half.segment<2>(2 * k);
        const Vector2d low = Vector2d(d.x[2 * k], -d.x[2 * k + 1]) - size / 2;
        const bool red = d.there[k] && d.inverse_mass[2 * k] > 0 && d.rest[k] < 0.5;
        out << "<rect x='" << low.x() << "' y='" << low.y() << "' width='"
            << size.x() << "' height='" << size.y() << "' stroke-dasharray='"
            << (d.there[k] ? "" : "0.1") << "' stroke='"
            << (red ? "#CC3311" : "#808080") << "'/>\n";
    }
    out << "</svg>\n";
    World again = load(save(d));
    for (int n = 0; n < 240; ++n) step(d, 1.0 / 120), step(again, 1.0 / 120);
    std::printf("hash %llx, of the loaded one %llx\n", hash(d), hash(again));
}
