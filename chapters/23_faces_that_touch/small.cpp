// Chapter 23 in one file, grown from chapter 20: cubes that stand on their faces.
// What of a face lies over another is a polygon; four of its corners carry.
//
//     keep q with m·(q − p) ≤ 0 for each side of the reference face, (23.1)
//     C = n·(p_b − p_a),  J = (−n, −Rᵀ(r × n)),  (n, Rᵀ(r × n)),  λ ≥ 0, (23.3)
#include <Eigen/Geometry>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <vector>
using Eigen::Matrix3d;
using Eigen::Quaterniond, Eigen::Vector3d;
using Vec = Eigen::VectorXd;
using Vec6 = Eigen::Matrix<double, 6, 1>;

// A corner of the polygon, and which edge leads to the next: of the incident face
// (0 to 3), or along side k of the reference (10 + k).
struct Corner {
    Vector3d at;
    int name, edge;
};

struct Contact {
    int a, b, name;
    Vector3d at;  // on the face that was cut [m]
    double C;     // gap [m]
    Vec6 Ja = Vec6::Zero(), Jb = Vec6::Zero();
    double bias = 0, lambda = 0;  // [m/s], [N s]
};

struct Bodies {
    Vec x, u, inverse_mass;  // six a body: x, rotation vector; v, ω; 1/m, 1/I
    std::size_t points = 4;  // of each pair, at most
    std::vector<Contact> contacts = {};  // of the last step
};

// (20.3): the rotation of a rotation vector.
Quaterniond exp(const Vector3d& theta)
{
    return Quaterniond(Eigen::AngleAxisd(theta.norm(), theta.normalized()));
}

Vector3d centre(const Bodies& d, int k) { return d.x.segment<3>(6 * k); }
Matrix3d axes(const Bodies& d, int k)
{
    return exp(d.x.segment<3>(6 * k + 3)).toRotationMatrix();
}

// (23.1): what of a polygon does not lie beyond side k, which contains p.
std::vector<Corner> cut(const std::vector<Corner>& polygon, const Vector3d& p,
                        const Vector3d& out, int k)
{
    std::vector<Corner> left;
    for (int i = 0; i < int(polygon.size()); ++i) {
        const Corner &c = polygon[i], &d = polygon[(i + 1) % polygon.size()];
        const double out_c = out.dot(c.at - p), out_d = out.dot(d.at - p);
        if (out_c <= 0) left.push_back(c);
        if ((out_c <= 0) == (out_d <= 0)) continue;
        const Vector3d at = c.at + out_c / (out_c - out_d) * (d.at - c.at);
        // having left, it goes on along the side
        left.push_back({at, 100 * (k + 1) + c.edge, out_c <= 0 ? 10 + k : c.edge});
    }
    return left;
}

// The deepest, the farthest from it, the farthest from the line of both, and the
// one that adds the largest triangle.
std::vector<Contact> four_of(const std::vector<Contact>& points, const Vector3d& n)
{
    std::vector<Contact> kept;
    const auto area = [&](int i, int j, const Contact& r) {
        const Vector3d& p = kept[i].at;
        return n.dot((kept[j].at - p).cross(r.at - p));
    };
    double least = INFINITY;
    for (const Contact& p : points) least = std::min(least, p.C);
    for (int k = 0; k < 4; ++k) {
        const Contact* best = nullptr;
        double most = 1e-9, turn = k < 3 || area(0, 1, kept[2]) < 0 ? 1 : -1;
        for (const Contact& p : points) {
            const double score =
                k == 0   ? p.C <= least + 1e-4
                : k == 1 ? (p.at - kept[0].at).norm()
                : k == 2 ? std::abs(area(0, 1, p))
                         : std::max({turn * area(0, 1, p), turn * area(1, 2, p),
                                     turn * area(2, 0, p)});
            if (score > most) most = score, best = &p;
        }
        if (!best) break;
        kept.push_back(*best);
    }
    return kept;
}

// The face of a cube of 1 m along ±axis i, counterclockwise as seen from outside.
std::vector<Corner> face(const Bodies& d, int k, int i, double side)
{
    std::vector<Corner> corners;
    for (int c = 0; c < 4; ++c) {
        Vector3d r;
        r[i] = side / 2;
        r[(i + 1) % 3] = (c % 3 == 0 ? -0.5 : 0.5) * side;
        r[(i + 2) % 3] = c < 2 ? -0.5 : 0.5;
        corners.push_back({centre(d, k) + axes(d, k) * r, c, c});
    }
    return corners;
}

// Where two cubes touch: the other's face over the best face of either.
std::vector<Contact> touch(const Bodies& d, int a, int b)
{
    double best = -INFINITY, side = 1;
    int p = a, q = b, axis = 0, j;  // whose face, and which
    Vector3d n;
    for (const auto& [k, l] : {std::pair{a, b}, {b, a}})
        for (int i = 0; i < 6; ++i) {
            const Vector3d m = (i % 2 ? 1 : -1) * axes(d, k).col(i / 2);
            const double s = m.dot(centre(d, l) - centre(d, k)) - 0.5 -
                             (axes(d, l).transpose() * m).cwiseAbs().sum() / 2;
            if (s <= best + 1e-4) continue;  // (22.3)
            best = s, p = k, q = l, axis = i / 2, side = i % 2 ? 1 : -1, n = m;
        }
    const Vector3d seen = axes(d, q).transpose() * n;
    seen.cwiseAbs().maxCoeff(&j);
    std::vector<Corner> polygon = face(d, q, j, seen[j] > 0 ? -1 : 1);
    const std::vector<Corner> reference = face(d, p, axis, side);
    for (int k = 0; k < 4; ++k) {
        const Vector3d& on = reference[k].at;
        polygon = cut(polygon, on, (reference[(k + 1) % 4].at - on).cross(n), k);
    }
    std::vector<Contact> points;
    const Vector3d to_b = p == a ? n : -n;
    for (const Corner& c : polygon) {
        Contact found{a, b, c.name + 1000 * p, c.at, n.dot(c.at - reference[0].at)};
        const auto row = [&](int k) {  // (23.3), at the point of either face
            const Vector3d r = c.at - (k == p ? found.C : 0) * n - centre(d, k);
            Vec6 J;
            J << to_b, axes(d, k).transpose() * r.cross(to_b);
            return J;
        };
        found.Ja = -row(a), found.Jb = row(b);
        if (found.C < 0.02) points.push_back(found);
    }
    points = four_of(points, to_b);
    if (points.size() > d.points) points.resize(d.points);
    return points;
}

void push(Bodies& d, const Contact& c, double lambda)
{
    for (const auto& [k, J] : {std::pair{c.a, c.Ja}, {c.b, c.Jb}})
        d.u.segment<6>(6 * k) +=
            d.inverse_mass.segment<6>(6 * k).cwiseProduct(J * lambda);
}

void step(Bodies& d, double h, double beta, int sweeps)
{
    for (int k = 0; k < d.x.size() / 6; ++k)
        if (d.inverse_mass[6 * k] > 0) d.u[6 * k + 2] -= 9.81 * h;  // u*, (3.4)
    std::vector<Contact> contacts;
    for (int b = 1; b < d.x.size() / 6; ++b)
        for (int a = 0; a < b; ++a)
            for (const Contact& c : touch(d, a, b)) contacts.push_back(c);
    for (Contact& c : contacts) {
        c.bias = (c.C < 0 ? beta : 1) * c.C / h;  // (7.4), (3.30)
        for (const Contact& old : d.contacts)     // its key: which two touch, where
            if (old.a == c.a && old.b == c.b && old.name == c.name)
                c.lambda = old.lambda, push(d, c, c.lambda);
    }
    for (int n = 0; n < sweeps; ++n)
        for (Contact& c : contacts) {  // (6.2) to (6.5)
            const double w = c.Ja.dot(d.u.segment<6>(6 * c.a)) +
                             c.Jb.dot(d.u.segment<6>(6 * c.b)) + c.bias;
            const double A =
                c.Ja.cwiseAbs2().dot(d.inverse_mass.segment<6>(6 * c.a)) +
                c.Jb.cwiseAbs2().dot(d.inverse_mass.segment<6>(6 * c.b));
            const double next = std::max(0.0, c.lambda - w / A);
            push(d, c, next - c.lambda);
            c.lambda = next;
        }
    for (int k = 0; k < d.x.size() / 6; ++k) {  // cubes keep their ω
        d.x.segment<3>(6 * k) += h * d.u.segment<3>(6 * k);
        auto theta = d.x.segment<3>(6 * k + 3);  // (20.4)
        const Vector3d turn = h * d.u.segment<3>(6 * k + 3);
        const Eigen::AngleAxisd sum(exp(theta) * exp(turn));
        theta = sum.angle() * sum.axis();
    }
    d.contacts = contacts;
}

// Cubes of 1 m and 1 kg, each turned a little; the lowest one cannot move.
Bodies stack(int cubes, double turn)
{
    Bodies d;
    d.x = d.u = d.inverse_mass = Vec::Zero(6 * cubes);
    for (int k = 0; k < cubes; ++k) {
        d.x[6 * k + 2] = k, d.x[6 * k + 5] = k * turn;
        if (k) d.inverse_mass.segment<6>(6 * k) << 1, 1, 1, 6, 6, 6;
    }
    return d;
}

// The squares of section 23.1: cut the second at the sides of the first.
std::vector<Corner> by_hand()
{
    const double x[] = {0.5, 1.75, 0.5, -0.75}, y[] = {-0.75, 0.5, 1.75, 0.5};
    std::vector<Corner> polygon;
    for (int k = 0; k < 4; ++k) polygon.push_back({{x[k], y[k], 0}, k, k});
    for (int k = 0; k < 4; ++k) {
        const Vector3d out = exp({0, 0, k * std::asin(1)}) * Vector3d::UnitX();
        polygon = cut(polygon, out, out, k);
    }
    return polygon;
}

int main(int count, char** word)
{
    std::vector<Contact> points;
    for (const Corner& c : by_hand()) {
        std::printf("(%5.2f, %5.2f), named %d\n", c.at[0], c.at[1], c.name);
        points.push_back({0, 1, c.name, c.at, 0});
    }
    std::ofstream out(count < 2 ? "" : word[1]);  // SVG
    out << "<svg xmlns='http://www.w3.org/2000/svg' width='640' fill='none' "
           "stroke-width='0.03' viewBox='-1.4 -2.4 9.2 4.9'>\n<path stroke='#47A' "
           "d='M1 1H-1V-1H1z'/><path stroke='#E73' d='M.5 .75L1.75 -.5L.5 -1.75"
           "L-.75 -.5z'/>\n";
    for (const Contact& p : four_of(points, Vector3d::UnitZ())) {
        std::printf("kept %d\n", p.name);
        out << "<circle cx='" << p.at[0] << "' cy='" << -p.at[1]
            << "' r='0.09' fill='#CC3311'/>\n";
    }
    // A stack on four points to a pair, and on the deepest alone.
    for (const int most : {4, 1}) {
        Bodies d = stack(5, 0.1);
        d.points = most;
        for (int n = 0; n < 45; ++n) step(d, 1.0 / 60, 0.2, 200);
        std::printf("%d points: down by %.4f m\n", most, 4 - d.x[6 * 4 + 2]);
        for (int i = 0; i < 30; ++i) {
            out << "<path stroke='" << (i / 6 % 2 ? "#E73" : "#47A") << "' d='";
            for (const Corner& c : face(d, i / 6, i / 2 % 3, i % 2 ? 1 : -1))
                out << (c.name ? 'L' : 'M')
                    << 0.8 * (c.at[0] + 0.3 * c.at[1]) + 7 - most * 0.75 << ' '
                    << 1.5 - 0.8 * (c.at[2] + 0.25 * c.at[1]);
            out << "Z'/>\n";
        }
    }
    out << "<g fill='#808080' font-size='.3'><text x='3.4' y='2.35'>four points"
           "</text><text x='5.7' y='2.35'>one point</text></g></svg>\n";
}
