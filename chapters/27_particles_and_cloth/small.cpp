// Chapter 27 in one file, grown from chapter 16: a cloth is a graph of rows.
// Which of them are solved together, and how far, is the method.
//
//     G(x) = Σ m‖x − y‖²/(2h²) + Σ ½ k C²,   y = x₀ + h u*,   C = ‖x_b − x_a‖ − L
//     implicit step: the x of least G, and u = (x − x₀)/h
#include <Eigen/Cholesky>
#include <Eigen/SparseCholesky>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <memory>
#include <string>
#include <vector>
using Eigen::Matrix3d;
using Eigen::Vector3d;
using Vec = Eigen::VectorXd;
using Sparse = Eigen::SparseMatrix<double>;
using Factor = Eigen::SimplicialLDLT<Sparse>;

struct Spring {
    int a, b;                  // particles
    double length, k;          // at rest [m]; stiffness [N/m]
    Vector3d n = {0, 0, 0};    // from a to b
    double C = 0, lambda = 0;  // [m]; Λ [N s²]
};

struct Cloth {
    Vec x, u, inverse_mass;  // three numbers a particle, zero: pinned
    std::vector<Spring> springs = {};
    double g = 9.81;
    std::shared_ptr<Factor> P = nullptr;  // of projective dynamics, made once
};

// n and C where the particles are now.
void measure(Spring& s, const Vec& x)
{
    const Vector3d ab = x.segment<3>(3 * s.b) - x.segment<3>(3 * s.a);
    s.n = ab.normalized();
    s.C = ab.norm() - s.length;
}

// ∂G/∂x, zero at what is pinned.
Vec gradient(Cloth& c, const Vec& x, const Vec& y, double h)
{
    Vec G = Vec::Zero(x.size());
    for (Spring& s : c.springs) {
        measure(s, x);
        G.segment<3>(3 * s.a) -= s.k * s.C * s.n;
        G.segment<3>(3 * s.b) += s.k * s.C * s.n;
    }
    for (int i = 0; i < x.size(); ++i)
        G[i] = c.inverse_mass[i] > 0
                   ? G[i] + (x[i] - y[i]) / (h * h * c.inverse_mass[i])
                   : 0;
    return G;
}

// (27.13): the second derivative of a spring, without what would push sideways.
Matrix3d curvature(const Spring& s)
{
    const double across = s.k * std::max(0.0, s.C / (s.C + s.length));
    return across * Matrix3d::Identity() + (s.k - across) * s.n * s.n.transpose();
}

// H = M/h² + Σ of the springs, or with k in all directions: P, (27.14).
Sparse matrix(Cloth& c, const Vec& x, double h, bool fixed)
{
    std::vector<Eigen::Triplet<double>> list;
    for (int i = 0; i < x.size(); ++i)
        list.emplace_back(
            i, i, c.inverse_mass[i] > 0 ? 1 / (h * h * c.inverse_mass[i]) : 1);
    for (Spring& s : c.springs) {
        measure(s, x);
        const Matrix3d K =
            fixed ? Matrix3d(s.k * Matrix3d::Identity()) : curvature(s);
        for (const int p : {s.a, s.b})
            for (const int q : {s.a, s.b})
                for (int i = 0; i < 9; ++i)
                    if (c.inverse_mass[3 * p] > 0 && c.inverse_mass[3 * q] > 0)
                        list.emplace_back(3 * p + i / 3, 3 * q + i % 3,
                                          p == q ? K(i) : -K(i));
    }
    Sparse H(x.size(), x.size());
    H.setFromTriplets(list.begin(), list.end());
    return H;
}

// (27.11): row by row. `keep` is false for the mistake: Λ is forgotten.
void by_rows(Cloth& c, double h, Vec& x, bool keep)
{
    for (Spring& s : c.springs) {
        measure(s, x);
        if (!keep) s.lambda = 0;
        const double wa = c.inverse_mass[3 * s.a], wb = c.inverse_mass[3 * s.b];
        const double gamma = 1 / (h * h * s.k);
        const double change = -(s.C + gamma * s.lambda) / (wa + wb + gamma);
        s.lambda += change;
        x.segment<3>(3 * s.a) -= wa * change * s.n;
        x.segment<3>(3 * s.b) += wb * change * s.n;
    }
}

// (27.12): particle by particle, each with all of its springs.
void by_particles(Cloth& c, const Vec& y, double h, Vec& x)
{
    std::vector<std::vector<Spring*>> at(x.size() / 3);
    for (Spring& s : c.springs) at[s.a].push_back(&s), at[s.b].push_back(&s);
    for (int k = 0; k < int(at.size()); ++k) {
        const double m = 1 / (h * h * c.inverse_mass[3 * k]);
        if (!std::isfinite(m)) continue;
        Vector3d f = m * (y - x).segment<3>(3 * k);
        Matrix3d H = m * Matrix3d::Identity();
        for (Spring* s : at[k]) {
            measure(*s, x);
            f += (s->a == k ? s->k : -s->k) * s->C * s->n;
            H += curvature(*s);
        }
        x.segment<3>(3 * k) += H.ldlt().solve(f);
    }
}

// One step. Methods: "explicit", "rows", "forgotten", "particles", "one matrix",
// "all together"; of all but the first so many passes.
void step(Cloth& c, double h, const std::string& method, int passes)
{
    const Vec x0 = c.x;
    for (int i = 1; i < c.u.size(); i += 3)
        if (c.inverse_mass[i] > 0) c.u[i] -= c.g * h;
    Vec y = x0 + h * c.u;  // where the particles would be without springs
    if (method == "explicit")
        y -= h * h * c.inverse_mass.cwiseProduct(gradient(c, x0, x0, h));
    Vec x = y;
    for (Spring& s : c.springs) s.lambda = 0;
    if (method == "one matrix" && !c.P)
        c.P = std::make_shared<Factor>(matrix(c, x, h, true));
    for (int n = 0; n < passes; ++n) {
        if (method == "rows" || method == "forgotten")
            by_rows(c, h, x, method == "rows");
        if (method == "particles") by_particles(c, y, h, x);
        if (method == "one matrix") x -= c.P->solve(gradient(c, x, y, h));
        if (method == "all together")
            x -= Factor(matrix(c, x, h, false)).solve(gradient(c, x, y, h));
    }
    c.u = (x - x0) / h;
    c.x = x;
}

// A chain down from a pin at the origin, all springs at rest.
Cloth chain(int masses, double k)
{
    const int n = 3 * masses + 3;
    Cloth c{Vec::Zero(n), Vec::Zero(n), Vec::Ones(n)};
    c.inverse_mass.head<3>().setZero();
    for (int i = 1; i <= masses; ++i) {
        c.x[3 * i + 1] = -i;
        c.springs.push_back({i - 1, i, 1, k});
    }
    return c;
}

// N by N squares of 1 m / N, level, pinned at two corners; 0.2 kg.
Cloth sheet(int N, double k)
{
    const int n = 3 * (N + 1) * (N + 1);
    Cloth c{Vec(n), Vec::Zero(n), Vec::Constant(n, n / 0.6)};
    for (const int corner : {0, N}) c.inverse_mass.segment<3>(3 * corner).setZero();
    for (int p = 0; p < n / 3; ++p)
        c.x.segment<3>(3 * p) << double(p % (N + 1)) / N, 0,
            double(p / (N + 1)) / N;
    const auto add = [&](int a, int b) {
        const Vector3d d = c.x.segment<3>(3 * b) - c.x.segment<3>(3 * a);
        c.springs.push_back({a, b, d.norm(), k});
    };
    for (int j = 0; j <= N; ++j)
        for (int i = 0; i <= N; ++i) {
            const int p = i + (N + 1) * j;
            if (i < N) add(p, p + 1);
            if (j < N) add(p, p + N + 1);
            if (i < N && j < N)  // diagonals alternate
                (i + j) % 2 ? add(p + 1, p + N + 1) : add(p, p + N + 2);
        }
    return c;
}

double stretch(Cloth& c)
{
    double most = 0;
    for (Spring& s : c.springs)
        measure(s, c.x), most = std::max(most, s.C / s.length);
    return most;
}

int main(int count, char** word)
{
    // By hand, section 27.1: how far both masses have come after one step [mm].
    const auto by_hand = [](const char* name, const std::string& method,
                            int passes) {
        Cloth c = chain(2, 100);
        c.g = 10;
        step(c, 0.1, method, passes);
        std::printf("%-24s %6.1f %6.1f\n", name, -1000 * (c.x[4] + 1),
                    -1000 * (c.x[7] + 2));
    };
    by_hand("explicit", "explicit", 0);
    by_hand("rows, 1 sweep", "rows", 1);
    by_hand("rows, 2 sweeps", "rows", 2);
    by_hand("rows, 20 sweeps", "rows", 20);
    by_hand("forgotten, 1 sweep", "forgotten", 1);
    by_hand("forgotten, 20 sweeps", "forgotten", 20);
    by_hand("particles, 1 sweep", "particles", 1);
    by_hand("one matrix, 1 pass", "one matrix", 1);
    by_hand("all together, 1 solve", "all together", 1);
    Cloth slow = chain(2, 100);
    slow.g = 10;
    for (int n = 0; n < 100000; ++n) step(slow, 1e-6, "explicit", 0);
    std::printf("%-24s %6.1f %6.1f\n", "the motion itself", -1000 * (slow.x[4] + 1),
                -1000 * (slow.x[7] + 2));
    // A sheet on two corners: as many passes a step by each method.
    std::ofstream out(count < 2 ? "" : word[1]);  // SVG, in parallel projection
    out << "<svg xmlns='http://www.w3.org/2000/svg' fill='none' width='720' "
           "stroke-width='0.009' viewBox='-0.3 -0.1 5.35 2.05'>\n";
    double left = 0;
    for (const std::string method :
         {"rows", "particles", "one matrix", "all together"}) {
        Cloth c = sheet(20, 500);
        for (int n = 0; n < 60; ++n) step(c, 1.0 / 60, method, 4);
        std::printf(
            "%-12s stretched by %5.1f %%, lowest at %.3f m\n", method.c_str(),
            100 * stretch(c),
            Eigen::Map<Eigen::Matrix3Xd>(c.x.data(), 3, 441).row(1).minCoeff());
        out << "<path stroke='" << (method[0] == 'a' ? "#CC3311" : "#4477AA")
            << "' d='";
        const auto place = [&](int p) {
            out << left + c.x[3 * p] + 0.35 * c.x[3 * p + 2] << ' '
                << -c.x[3 * p + 1] - 0.35 * c.x[3 * p + 2];
        };
        for (const Spring& s : c.springs)
            if (s.length < 0.06) out << 'M', place(s.a), out << 'L', place(s.b);
        out << "'/>\n<text fill='#808080' stroke='none' font-size='0.12' x='"
            << left + 0.1 << "' y='1.93'>" << method << "</text>\n";
        left += 1.32;
    }
    out << "</svg>\n";
}
