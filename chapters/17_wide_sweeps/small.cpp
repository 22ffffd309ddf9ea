// Chapter 17 in one file, grown from chapter 6: rows of one colour, side by side.
//     w = J u + b,   u ← u + M⁻¹ Jᵀ Δλ,   b = C / h, in each lane, (17.3)
//     contact: λ ≥ 0, w ≥ 0, λ w = 0         link: w = 0
#include <Eigen/Core>
#include <algorithm>
#include <bit>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <vector>
using Eigen::Vector2d;
using Vec = Eigen::VectorXd;
using Mat = Eigen::MatrixXd;

struct Contact {
    int a, b;    // disc b and disc a, or a wall: -1, -2, …
    Vector2d n;  // from a to b
    double C, lo, bias = 0, lambda = 0;  // gap [m], least λ, [m/s], [N s]
    int colour = 0;
};

struct Discs {
    Vec x, u, inverse_mass, radius;  // two numbers a disc, but one radius
    int chain;                       // so many discs, the first ones, are linked
    Mat walls;                       // columns n, c: where n·p ≥ c it is free
};

// The links, then all pairs of discs, then discs and walls, with gaps below 2 cm.
std::vector<Contact> find_contacts(const Discs& d)
{
    std::vector<Contact> found;
    const int K = d.radius.size();
    const auto meet = [&](int a, int b, double margin, double lo) {
        const Vector2d ab = d.x.segment<2>(2 * b) - d.x.segment<2>(2 * a);
        const double C = ab.norm() - d.radius[a] - d.radius[b];
        if (C < margin) found.push_back({a, b, ab.normalized(), C, lo});
    };
    for (int b = 1; b < d.chain; ++b) meet(b - 1, b, INFINITY, -INFINITY);
    for (int a = 0; a < K; ++a)
        for (int b = a + 1; b < K; ++b)
            if (b > a + 1 || b >= d.chain) meet(a, b, 0.02, 0);
    for (int b = 0; b < K; ++b)
        for (int i = 0; i < d.walls.cols(); ++i) {
            const Vector2d n = d.walls.col(i).head<2>(), p = d.x.segment<2>(2 * b);
            const double C = n.dot(p) - d.walls(2, i) - d.radius[b];
            if (C < 0.02) found.push_back({-1 - i, b, n, C, 0});
        }
    return found;
}

// Each row takes the first colour that neither of its discs has, and its place.
void sort_by_colour(std::vector<Contact>& contacts, int K)
{
    std::vector<unsigned> used(K);  // a bit for each colour
    for (Contact& c : contacts) {
        unsigned &b = used[c.b], &a = c.a < 0 ? b : used[c.a];
        c.colour = std::countr_one(a | b);
        a |= 1u << c.colour, b |= 1u << c.colour;
    }
    std::ranges::stable_sort(contacts, {}, &Contact::colour);
}

// (17.1): the longest chain of visits, each of which waits for the one before.
int chain(const std::vector<Contact>& contacts, int K)
{
    std::vector<int> depth(K);
    for (const Contact& c : contacts) {
        int &b = depth[c.b], &a = c.a < 0 ? b : depth[c.a];
        a = b = 1 + std::max(a, b);
    }
    return std::ranges::max(depth);
}

template <int L, int N = 1>
using Lanes = Eigen::Array<double, L, N>;  // N numbers in each of L lanes

// L rows that share no disc. A wall, and a lane that is left over, have the place
// behind the discs in u, and no inverse mass.
template <int L>
struct Packet {
    Eigen::Array<int, L, 1> a, b;
    Lanes<L, 2> n;
    Lanes<L> ma, mb, A, bias, lambda, lo;
};

template <int L>
std::vector<Packet<L>> pack(const std::vector<Contact>& contacts, const Discs& d)
{
    std::vector<Packet<L>> packets;
    Packet<L> none;
    none.a = none.b = d.radius.size(), none.n = 0, none.A = 1;
    none.ma = none.mb = none.bias = none.lambda = none.lo = 0;
    for (int i = 0, l = L, m = contacts.size(); i < m; ++i, ++l) {
        const Contact& c = contacts[i];
        if (l == L || c.colour != contacts[i - 1].colour)
            packets.emplace_back(none), l = 0;
        Packet<L>& p = packets.back();
        if (c.a >= 0) p.a[l] = c.a, p.ma[l] = d.inverse_mass[2 * c.a];
        p.b[l] = c.b, p.mb[l] = d.inverse_mass[2 * c.b], p.A[l] = p.mb[l] + p.ma[l];
        p.n.row(l) = c.n, p.bias[l] = c.bias, p.lo[l] = c.lo;
    }
    return packets;
}

// One visit in each lane: (6.2) to (6.5). Returns by how much a row was off [m/s].
template <int L>
double visit(Packet<L>& p, Vec& u)
{
    Lanes<L, 2> ua, ub;
    for (int l = 0; l < L; ++l)  // gather
        ua.row(l) = u.segment<2>(2 * p.a[l]), ub.row(l) = u.segment<2>(2 * p.b[l]);
    const auto along_n = [&](const auto& v) {
        return p.n.col(0) * v.col(0) + p.n.col(1) * v.col(1);
    };
    const Lanes<L> w = p.bias + along_n(ub) - along_n(ua);
    const Lanes<L> change = (p.lambda - w / p.A).max(p.lo) - p.lambda;
    p.lambda += change;
    const Lanes<L, 2> P = p.n.colwise() * change;
    ua -= P.colwise() * p.ma, ub += P.colwise() * p.mb;
    for (int l = 0; l < L; ++l)  // scatter
        u.segment<2>(2 * p.a[l]) = ua.row(l), u.segment<2>(2 * p.b[l]) = ub.row(l);
    return (p.A * change.abs()).maxCoeff();
}

template <int L>
int step(Discs& d, double h, bool coloured)
{
    for (int k = 1; k < d.u.size(); k += 2) d.u[k] -= 9.81 * h;  // u*, (3.4)
    std::vector<Contact> contacts = find_contacts(d);
    for (Contact& c : contacts) c.bias = c.C / h;  // (3.30)
    if (coloured) sort_by_colour(contacts, d.radius.size());
    std::vector<Packet<L>> packets = pack<L>(contacts, d);
    d.u.conservativeResize(d.x.size() + 2), d.u.tail<2>().setZero();
    int sweeps = 0;
    for (double off = 1; off > 1e-6; ++sweeps) {
        off = 0;
        for (Packet<L>& p : packets) off = std::max(off, visit(p, d.u));
    }
    d.u.conservativeResize(d.x.size());
    d.x += h * d.u;  // (1.10)
    return sweeps;
}

// So many discs between two walls, and on them row after row of one less.
Discs pyramid(int base)
{
    const Vec one = Vec::Ones(base * (base + 1));
    Discs d{one, 0 * one, one, 0.1 * one.head(one.size() / 2), 0, {}};
    const double rise = std::sqrt(0.03);
    d.walls = Mat{{1, -1, 0}, {0, 0, 1}, {-0.1 * base, -0.1 * base, 0}};
    for (int j = 0, k = 0; j < base; ++j)
        for (int i = j; i < base; ++i, k += 2)
            d.x.segment<2>(k) << 0.1 * (2 * i + 1 - base - j), 0.1 + rise * j;
    return d;
}

template <int L>
void run(const char* how, bool coloured)
{
    Discs d = pyramid(30);
    const int rows = find_contacts(d).size();
    const auto start = std::chrono::steady_clock::now();
    const int sweeps = step<L>(d, 1.0 / 240, coloured);
    const std::chrono::duration<double, std::nano> t =
        std::chrono::steady_clock::now() - start;
    const double ns = t.count() / sweeps / rows;
    std::printf("%s: %d sweeps, %.1f ns a visit\n", how, sweeps, ns);
}

int main(int count, char** word)
{
    // By hand, section 17.1: four rows between five bodies; then a pyramid.
    std::vector<Contact> line(4), rows = find_contacts(pyramid(8));
    for (int k = 0; k < 4; ++k) line[k].a = k, line[k].b = k + 1;
    std::ofstream out(count < 2 ? "" : word[1]);  // an SVG picture, time downwards
    out << "<svg xmlns='http://www.w3.org/2000/svg' width='500' stroke='#808080' "
           "fill='#808080' font-size='0.4' viewBox='-0.6 -0.6 11.4 5.2'>\n";
    const auto draw = [&](int x) {
        std::vector<int> depth(5);
        for (int k = 0; k < 5; ++k)
            out << "<path stroke-width='.03' d='M" << x + k << " 0v4.5'/><text x='"
                << x + k << "' stroke='none'>" << k + 1 << "</text>\n";
        for (const Contact& c : line) {
            depth[c.a] = depth[c.b] = 1 + std::max(depth[c.a], depth[c.b]);
            out << "<path stroke-width='.3' stroke='hsl(" << 150 * c.colour
                << " 70% 45%)' d='M" << x + c.a << ' ' << depth[c.a] << "h1'/>\n";
        }
    };
    draw(0);
    for (auto* all : {&line, &rows}) {
        std::printf("%zu rows: a chain of %d visits", all->size(), chain(*all, 36));
        sort_by_colour(*all, 36);
        std::printf(", in colours of %d\n", chain(*all, 36));
    }
    draw(6);
    out << "</svg>\n";
    run<1>("as they come", false), run<1>("in colours", true);
    run<8>("eight lanes", true);
}
