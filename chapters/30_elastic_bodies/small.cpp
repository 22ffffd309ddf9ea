// Chapter 30 in one file, grown from chapter 16: triangles with an elastic energy.
// A spring has one number; a triangle has the stretch of all its directions.
//
//     F = Σ x_a G_aᵀ,   Ψ = μ ‖F − R‖² + ½ λ tr²(RᵀF − I),   f_a = −A P G_a
//     G(x) = ½ ‖x − y‖²_M + h² (Ψ(x) − fᵀx),  y = x₀ + h v₀:   x ← x − H⁻¹ ∇G
#include <Eigen/SparseCholesky>
#include <array>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <vector>
using Eigen::Matrix2d;
using Eigen::Vector2d;
using Vec = Eigen::VectorXd;

struct Soft {
    Vec rest, x, v;  // two numbers a node
    std::vector<std::array<int, 3>> triangles;
    double lambda, mu, density;  // [Pa], [kg/m²]
    std::vector<bool> held;      // of each node
    bool linear = false;         // the law that never turns: R = I
    double g = 9.81;
};

// What a triangle has from its rest shape: its area, and the gradients G_a of the
// three functions that are 1 at one corner and 0 at the others.
struct Triangle {
    double area;
    Eigen::Matrix<double, 2, 3> G;
};
Triangle triangle(const Soft& s, const std::array<int, 3>& corners)
{
    Matrix2d edges;
    for (int i : {0, 1})
        edges.col(i) = s.rest.segment<2>(2 * corners[i + 1]) -
                       s.rest.segment<2>(2 * corners[0]);
    Triangle t;
    t.area = (edges(0, 0) * edges(1, 1) - edges(0, 1) * edges(1, 0)) / 2;
    t.G.col(1) << edges(1, 1), -edges(0, 1);
    t.G.col(2) << -edges(1, 0), edges(0, 0);
    t.G.rightCols(2) /= 2 * t.area;
    t.G.col(0) = -t.G.col(1) - t.G.col(2);
    return t;
}

// Stretch and stress of a triangle, (30.2) to (30.5) and (30.12).
struct Strained {
    Matrix2d R, strain, P;
    double energy, twist;
};
Strained strained(const Soft& s, const std::array<int, 3>& corners,
                  const Triangle& t)
{
    Matrix2d F = Matrix2d::Zero(), I = Matrix2d::Identity();
    for (int a = 0; a < 3; ++a)
        F += s.x.segment<2>(2 * corners[a]) * t.G.col(a).transpose();
    Strained out;
    const double c = F(0, 0) + F(1, 1), d = F(1, 0) - F(0, 1), r = std::hypot(c, d);
    out.R = I;
    if (!s.linear && r > 0)
        out.R << c / r, -d / r, d / r, c / r;  // the nearest turn
    const Matrix2d S = out.R.transpose() * F;
    out.strain = (S + S.transpose()) / 2 - I;
    const double trace = out.strain.trace();
    out.P = out.R * (2 * s.mu * out.strain + s.lambda * trace * I);
    out.energy =
        t.area * (s.mu * out.strain.squaredNorm() + s.lambda / 2 * trace * trace);
    out.twist = s.linear
                    ? 0  // (30.22)
                    : std::max(0.0, 2 * s.mu + (2 * s.lambda * trace - 4 * s.mu) /
                                                   std::max(r, 1e-6));
    return out;
}

// Energy; forces −∂Ψ/∂x into f; what they change by, the stiffness, into K.
using Entries = std::vector<Eigen::Triplet<double>>;
double elastic(const Soft& s, Vec& f, double scale, Entries& K)
{
    double energy = 0;
    for (const auto& corners : s.triangles) {
        const Triangle t = triangle(s, corners);
        const Strained at = strained(s, corners, t);
        energy += at.energy;
        Matrix2d quarter;
        quarter << 0, -1, 1, 0;
        for (int a = 0; a < 3; ++a) {
            const Vector2d Ga = t.G.col(a);
            f.segment<2>(2 * corners[a]) -= t.area * at.P * Ga;
            for (int b = 0; b < 3; ++b) {
                const Vector2d Gb = t.G.col(b);
                Matrix2d k = s.lambda * Ga * Gb.transpose() +  // (30.6)
                             s.mu * Gb * Ga.transpose();
                k += s.mu * Ga.dot(Gb) * Matrix2d::Identity() +
                     at.twist / 2 * (quarter * Ga) * (quarter * Gb).transpose();
                k = scale * t.area * at.R * k * at.R.transpose();
                for (int i : {0, 1})
                    for (int j : {0, 1})
                        K.emplace_back(2 * corners[a] + i, 2 * corners[b] + j,
                                       k(i, j));
            }
        }
    }
    return energy;
}

// (30.8), (30.9): one step of implicit Euler by Newton's method. Returns how many
// linear systems it took.
int step(Soft& s, double h)
{
    const int n = s.x.size();
    const Vec x0 = s.x, y = s.x + h * s.v;
    Entries mass;
    Vec weight = Vec::Zero(n);
    for (const auto& corners : s.triangles) {
        const double m = s.density * triangle(s, corners).area;
        for (int a : corners) weight[2 * a + 1] -= m / 3 * s.g;
        for (int a : corners)
            for (int b : corners)
                for (int i : {0, 1})
                    mass.emplace_back(2 * a + i, 2 * b + i,
                                      a == b ? m / 6 : m / 12);
    }
    Eigen::SparseMatrix<double> M(n, n), H(n, n);
    M.setFromTriplets(mass.begin(), mass.end());
    for (int count = 1;; ++count) {
        Entries entries = mass;
        Vec f = weight;
        elastic(s, f, h * h, entries);
        Vec r = h * h * f - M * (s.x - y);  // −∇G
        H.setFromTriplets(entries.begin(), entries.end());
        for (int k = 0; k < n; ++k)  // held nodes: 1 · Δ = 0
            for (Eigen::SparseMatrix<double>::InnerIterator e(H, k); e; ++e)
                if (s.held[k / 2] || s.held[e.row() / 2])
                    e.valueRef() = e.row() == k;
        for (int k = 0; k < n; ++k)
            if (s.held[k / 2]) r[k] = 0;
        const Vec change =
            Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>>(H).solve(r);
        s.x += change;
        if (s.linear || count == 30 || change.lpNorm<Eigen::Infinity>() < 1e-12) {
            s.v = (s.x - x0) / h;
            return count;
        }
    }
}

// A strip of 1 m × 0.1 m, held at its left end, in boxes of two triangles.
Soft strip(bool linear)
{
    const int nx = 40, ny = 4;
    Soft s{Vec((nx + 1) * (ny + 1) * 2), {}, {}, {}, 0, 1e6, 1000, {}, linear};
    for (int j = 0; j <= ny; ++j)
        for (int i = 0; i <= nx; ++i) {
            const int at = j * (nx + 1) + i;
            s.rest.segment<2>(2 * at) << double(i) / nx, 0.1 * j / ny - 0.05;
            s.held.push_back(i == 0);
            if (i == nx || j == ny) continue;
            const int b = at + 1, c = b + nx + 1, d = c - 1;
            if ((i + j) % 2 == 0)
                s.triangles.insert(s.triangles.end(), {{{at, b, c}}, {{at, c, d}}});
            else s.triangles.insert(s.triangles.end(), {{{at, b, d}}, {{b, c, d}}});
        }
    s.x = s.rest, s.v = 0 * s.rest;
    return s;
}

double length_of(const Soft& s)  // of the line through its middle
{
    double sum = 0;
    for (int i = 0; i < 40; ++i)
        sum += (s.x.segment<2>(2 * (83 + i)) - s.x.segment<2>(2 * (82 + i))).norm();
    return sum;
}

int main(int count, char** word)
{
    // By hand, section 30.1: one triangle with λ = μ = 1 Pa.
    Soft one{Vec(6), {}, Vec::Zero(6), {{{0, 1, 2}}}, 1, 1, 1, {}, true, 0};
    one.rest << 0, 0, 1, 0, 0, 1;
    one.x = one.rest;
    one.x[2] += 0.1;
    Vec f = Vec::Zero(6);
    Entries K;
    const double energy = elastic(one, f, 1, K);
    std::printf("pulled: %.4f J, forces", energy);
    for (int a = 0; a < 3; ++a)
        std::printf(" (%.2f, %.2f)", f[2 * a], f[2 * a + 1]);
    for (const bool linear : {true, false}) {  // turned by 60 degrees
        one.linear = linear;
        const double c = 0.5, s = std::sqrt(0.75);
        one.x << 0, 0, c, s, -s, c;
        const Triangle t = triangle(one, {0, 1, 2});
        const Strained at = strained(one, {0, 1, 2}, t);
        std::printf("\nturned, %s: strain %.2f, energy %.2f J",
                    linear ? "linear" : "corotational", at.strain(0, 0), at.energy);
    }
    std::ofstream out(count < 2 ? "" : word[1]);  // an SVG picture, y upwards
    out << "<svg xmlns='http://www.w3.org/2000/svg' fill='none' width='720' "
           "stroke-width='0.003' viewBox='-0.05 -0.1 1.5 1.4'>\n";
    for (const bool linear : {true, false}) {
        Soft s = strip(linear);
        int systems = 0;
        for (int n = 0; n < 40; ++n) systems += step(s, 1.0 / 60);
        std::printf("\n%s strip: %d systems, tip at (%.3f, %.3f), %.3f m long",
                    linear ? "linear" : "corotational", systems, s.x[2 * 122],
                    s.x[2 * 122 + 1], length_of(s));
        out << "<path stroke='" << (linear ? "#CC3311" : "#4477AA") << "' d='";
        for (const auto& [a, b, c] : s.triangles) {
            for (int k : {a, b, c})
                out << (k == a ? 'M' : 'L') << s.x[2 * k] << ' ' << -s.x[2 * k + 1];
            out << 'Z';
        }
        out << "'/>\n";
    }
    std::printf("\n");
    out << "<g fill='#808080' font-size='0.05'><text x='1.04' y='0.9'>linear</text>"
           "<text x='0.16' y='0.62'>corotational</text></g></svg>\n";
}
