// Chapter 9 in one file, grown from chapter 8: rows are guessed and solved at once.
// One linear system for those that are active; a wrong guess is corrected.
//
//     w = A λ + q,   A = J M⁻¹ Jᵀ,   q = J u* + b
//     contact: λ ≥ 0, w ≥ 0, λ w = 0         link: w = 0
#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <vector>
using Eigen::Vector2d;
using Vec = Eigen::VectorXd;
using Mat = Eigen::MatrixXd;
using Path = std::pair<const char*, std::vector<Vector2d>>;  // a colour and points

struct Contact {
    int a, b;      // disc b and disc a, or a wall: -1, -2, …
    Vector2d n;    // from a to b
    double C, lo;  // gap [m]; bound of λ: 0, or -∞ for a link, which pulls as well
    double bias = 0, lambda = 0;  // [m/s], [N s]
};

struct Discs {
    Vec x, u, inverse_mass, radius;  // two numbers a disc, but one radius
    int chain;                       // so many discs, the first ones, are linked
    Mat walls;                       // columns n, c: where n·p ≥ c it is free
    double g = 9.81;
    std::vector<Contact> contacts = {};  // of the last step
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

// (9.2): active rows have w = 0, the others λ = 0.
Vec impulses(const Mat& A, const Vec& q, const std::vector<bool>& active)
{
    std::vector<int> F;
    for (int i = 0; i < q.size(); ++i)
        if (active[i]) F.push_back(i);
    Vec lambda = Vec::Zero(q.size());
    const Vec found = A(F, F).llt().solve(-q(F));
    lambda(F) = found;
    return lambda;
}

// Corrects the guess until no row is wrong, (9.4). Returns the number of guesses.
int guess(const Mat& A, const Vec& q, const Vec& lo, std::vector<bool>& active,
          Vec& lambda, int most = 1000)
{
    std::size_t fewest = q.size() + 1;
    int patience = 5;
    for (int guesses = 1;; ++guesses) {
        lambda = impulses(A, q, active);
        const Vec w = A * lambda + q;
        std::vector<int> wrong;
        for (int i = 0; i < q.size(); ++i)
            if (active[i] ? lambda[i] < lo[i] - 1e-12 : w[i] < -1e-12)
                wrong.push_back(i);
        if (wrong.empty()) return guesses;
        if (wrong.size() < fewest) fewest = wrong.size(), patience = 6;
        if (--patience < 0) wrong.resize(1);         // (9.6)
        for (int i : wrong) active[i] = !active[i];  // (9.5)
        if (guesses == most) return guesses;
    }
}

int step(Discs& d, double h, double beta)
{
    for (int k = 1; k < d.u.size(); k += 2) d.u[k] -= d.g * h;  // u*, (3.4)
    std::vector<Contact> contacts = find_contacts(d);
    const int m = contacts.size();
    Mat J = Mat::Zero(m, d.x.size());
    Vec b(m), lo(m), lambda(m);
    std::vector<bool> active(m, true);
    for (int i = 0; i < m; ++i) {
        const Contact& c = contacts[i];
        if (c.a >= 0) J.block<1, 2>(i, 2 * c.a) = -c.n.transpose();
        J.block<1, 2>(i, 2 * c.b) = c.n.transpose();
        b[i] = (c.lo < 0 || c.C < 0 ? beta : 1) * c.C / h;  // (7.4), (3.30)
        lo[i] = c.lo;
        for (const Contact& old : d.contacts)  // its key: which two touch
            if (old.a == c.a && old.b == c.b)
                active[i] = c.lo < 0 || old.lambda > 0;
    }
    const Mat W = d.inverse_mass.asDiagonal() * J.transpose();
    const int guesses = guess(J * W, J * d.u + b, lo, active, lambda);
    for (int i = 0; i < m; ++i) contacts[i].lambda = lambda[i];
    d.u += W * lambda;  // (3.9)
    d.x += h * d.u;     // (1.10)
    d.contacts = contacts;
    return guesses;
}

// Ten discs in a box: a chain of seven that falls on the three others.
Discs ten_discs()
{
    Discs d{Vec(20), Vec::Zero(20), Vec(20), Vec(10), 7, {}};
    d.walls = Mat{{1, -1, 0, 0}, {0, 0, 1, -1}, {-0.75, -0.75, -0.5, -0.5}};
    for (int k = 0; k < 7; ++k) d.x.segment<2>(2 * k) << -0.3 + 0.1 * k, 0.1;
    d.x.tail<6>() << -0.3, -0.3, 0, -0.3, 0.4, -0.3;
    d.inverse_mass << Vec::Constant(14, 10), 5, 5, 2.5, 2.5, 5, 5;
    d.radius << Vec::Constant(7, 0.05), 0.1, 0.15, 0.08;
    return d;
}

int main(int count, char** word)
{
    // By hand: a disc between two walls, (9.3), and three rows that cycle.
    std::vector<Path> paths{{"#808080", {{-0.5, 0}, {3.5, 0}}},
                            {"#808080", {{0, -1.5}, {0, 2.5}}},
                            {"#4477AA", {{1.25, 2.5}, {3.25, -1.5}}},   // w1 = 0
                            {"#4477AA", {{-0.5, 0.75}, {3.5, -1.25}}},  // w2 = 0
                            {"#CC3311", {}}};
    for (const auto& [A, q] :
         {std::pair{Mat{{2, 1}, {1, 2}}, Vec{{-5, -1}}},
          {Mat{{8, -4, 6}, {-4, 3, -2}, {6, -2, 6}}, Vec{{5, -4, 1}}}}) {
        const Vec lo = Vec::Zero(q.size());
        Vec lambda;
        std::vector<bool> active(q.size(), true), all = active;
        for (int k = 0; k < q.size() + 1; ++k) {
            guess(A, q, lo, active, lambda, 1);
            std::printf("lambda");
            for (const double l : lambda) std::printf(" %7.3f", l);
            std::printf(" N s\n");
            if (q.size() == 2) paths[4].second.push_back(lambda.head<2>());
        }
        const int guesses = guess(A, q, lo, all, lambda);
        std::printf("the answer, after %d guesses: lambda_2 = %g N s\n", guesses,
                    lambda[1]);
    }

    for (const bool remembered : {false, true}) {
        Discs d = ten_discs();
        int guesses = 0;
        for (int n = 0; n < 480; ++n) {
            if (!remembered) d.contacts.clear();
            guesses += step(d, 1.0 / 240, 0.2);
        }
        std::printf("ten discs: %d guesses in 480 steps, %s\n", guesses,
                    remembered ? "from the last answer" : "from all rows");
    }
    if (count < 2) return 0;
    std::ofstream out(word[1]);  // an SVG picture of the paths; y points upwards
    out << "<svg xmlns='http://www.w3.org/2000/svg' fill='none' "
           "width='400' stroke-width='0.03' viewBox='-0.6 -2.6 4.2 4.2'>\n";
    for (const auto& [colour, points] : paths) {
        out << "<polyline stroke='" << colour << "' points='";
        for (const Vector2d& p : points) out << p.x() << ',' << -p.y() << ' ';
        out << "'/>\n";
    }
    out << "<g fill='#808080' font-size='0.2'>\n<text x='3.35' y='0.25'>λ1</text>"
           "<text x='0.06' y='-2.4'>λ2</text><text x='1.35' y='-2.4'>w1 = 0</text>"
           "<text x='0.12' y='-0.6'>w2 = 0</text>\n";
    for (const Vector2d& p : paths[4].second)
        out << "<text x='" << p.x() + 0.1 << "' y='" << -0.08 - p.y() << "'>"
            << p.x() << ", " << p.y() << "</text>\n";
    out << "</g></svg>\n";
}
