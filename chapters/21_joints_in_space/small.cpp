// Chapter 21 in one file, grown from chapter 20: bodies on joints in space.
// A joint is a frame in either body, and bounds on how the two lie to each other.
//
//     d = R_Aᵀ (p_b − p_a): three ways,   q = q_A⁻¹ q_B: a twist and two swings
//     lo ≤ each of the six ≤ hi;  both the same: it is locked;  a motor drives one
#include <Eigen/Geometry>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <numbers>
#include <vector>
using Eigen::Quaterniond, Eigen::Vector3d;
using Vec = Eigen::VectorXd;
using Six = Eigen::Matrix<double, 6, 1>;

struct Joint {
    int a, b;                  // bodies; a = -1: the world
    Vector3d at_a, at_b;       // its point in either body's axes
    Quaterniond from_a, to_b;  // from the joint's axes to those of the body
    Six lo, hi;                // of x, y, z, twist, swing y, swing z
    int motor = -1;            // which of these it drives
    double speed = 0, force = 0;
};

struct Row {
    int a, b, name;  // name: twice its coordinate, and 1: an upper limit; 12: motor
    Six Ja, Jb;
    double C, bias = 0, lo = -INFINITY, hi = INFINITY, lambda = 0;
};

struct Bodies {
    Vec x, u, inverse_mass;  // six a body: x, rotation vector; v, ω; 1/m, 1/I
    double g = 9.81;
    std::vector<Joint> joints = {};
};

// (20.3): the rotation of a rotation vector.
Quaterniond exp(const Vector3d& theta)
{
    return Quaterniond(Eigen::AngleAxisd(theta.norm(), theta.normalized()));
}

// (20.4): θ ⊕ δ, after a turn by δ in the body's own axes.
Vector3d add(const Vector3d& theta, const Vector3d& delta)
{
    const Eigen::AngleAxisd sum(exp(theta) * exp(delta));
    return sum.angle() * sum.axis();
}

// (20.8): the turn hξ of a step; ξ is the spin in the middle of it. The angular
// momentum stays where it is, and the axes turn.
Vector3d turn(const Vector3d& inverse, Vector3d& omega, double h)
{
    const Vector3d L = omega.cwiseQuotient(inverse);
    Vector3d xi = omega;
    for (int n = 0; n < 20; ++n) xi = inverse.cwiseProduct(exp(-h / 2 * xi) * L);
    omega = inverse.cwiseProduct(exp(-h * xi) * L);
    return h * xi;
}

// Body k: where it is and how it lies; the world lies as it is.
std::pair<Vector3d, Quaterniond> place(const Bodies& d, int k)
{
    if (k < 0) return {Vector3d::Zero(), Quaterniond::Identity()};
    return {d.x.segment<3>(6 * k), exp(d.x.segment<3>(6 * k + 3))};
}

// C and J of coordinate i of a joint: of a way (21.4), of an angle (21.6).
Row coordinate(const Bodies& d, const Joint& joint, int i)
{
    const auto [xa, qa] = place(d, joint.a);
    const auto [xb, qb] = place(d, joint.b);
    const Quaterniond A = qa * joint.from_a, B = qb * joint.to_b;
    Quaterniond q = A.conjugate() * B;
    if (q.w() < 0) q.coeffs() *= -1;
    const Vector3d ra = qa * joint.at_a, rb = qb * joint.at_b, v = q.vec();
    const Vector3d way = xb + rb - xa - ra;
    Row row{joint.a, joint.b, 2 * i, Six::Zero(), Six::Zero(), 0};
    if (i < 3) {
        const Vector3d n = A * Vector3d::Unit(i);
        row.C = n.dot(way);
        row.Jb << n, qb.conjugate() * rb.cross(n);
        row.Ja << -n, qa.conjugate() * -(ra + way).cross(n);
        return row;
    }
    // g(q) = twist or swing, its derivatives with respect to w and v
    const double along = q.w() * q.w() + v.x() * v.x();
    const double gw = i == 3 ? -2 * v.x() / along : 0;
    const Vector3d gv = i == 3 ? Vector3d(2 * q.w() / along, 0, 0)
                               : Vector3d(2 * Vector3d::Unit(i - 3));
    const Vector3d rho = B * ((q.w() * gv - gw * v + gv.cross(v)) / 2);
    row.C = i == 3 ? 2 * std::atan2(v.x(), q.w()) : 2 * v[i - 3];
    row.Jb << 0, 0, 0, qb.conjugate() * rho;
    row.Ja << 0, 0, 0, -(qa.conjugate() * rho);
    return row;
}

// The rows of all joints: what is locked, the nearer limit of the rest, motors.
std::vector<Row> find_rows(const Bodies& d, double h, double beta)
{
    std::vector<Row> rows;
    for (const Joint& joint : d.joints)
        for (int i = 0; i < 6; ++i) {
            Row row = coordinate(d, joint, i);
            if (joint.motor == i) {
                rows.push_back(row);
                rows.back().name = 12, rows.back().bias = -joint.speed;
                rows.back().hi = h * joint.force, rows.back().lo = -rows.back().hi;
            }
            const double below = row.C - joint.lo[i], above = joint.hi[i] - row.C;
            if (std::min(below, above) == INFINITY) continue;
            const bool locked = joint.lo[i] == joint.hi[i];
            row.C = locked ? below : std::min(below, above);
            if (!locked && above < below) row.Ja *= -1, row.Jb *= -1, row.name += 1;
            if (!locked) row.lo = 0;
            row.bias = (!locked && row.C > 0 ? 1 : beta) * row.C / h;
            rows.push_back(row);
        }
    return rows;
}

// One visit, (6.2) to (6.5).
void visit(Row& row, Bodies& d)
{
    double w = row.bias, A = 0;
    for (const auto& [k, J] : {std::pair{row.a, row.Ja}, {row.b, row.Jb}}) {
        if (k < 0) continue;
        w += J.dot(d.u.segment<6>(6 * k));
        A += J.cwiseAbs2().dot(d.inverse_mass.segment<6>(6 * k));
    }
    const double next = std::clamp(row.lambda - w / A, row.lo, row.hi);
    for (const auto& [k, J] : {std::pair{row.a, row.Ja}, {row.b, row.Jb}})
        if (k >= 0)
            d.u.segment<6>(6 * k) +=
                d.inverse_mass.segment<6>(6 * k).cwiseProduct(J) *
                (next - row.lambda);
    row.lambda = next;
}

std::vector<Row> step(Bodies& d, double h, double beta, int sweeps)
{
    const int K = d.x.size() / 6;
    for (int k = 0; k < K; ++k) d.u[6 * k + 2] -= d.g * h;  // u*, (3.4)
    std::vector<Row> rows = find_rows(d, h, beta);
    for (int n = 0; n < sweeps; ++n)
        for (Row& row : rows) visit(row, d);
    for (int k = 0; k < K; ++k) {
        d.x.segment<3>(6 * k) += h * d.u.segment<3>(6 * k);  // (1.10)
        Vector3d omega = d.u.segment<3>(6 * k + 3);
        const Vector3d delta = turn(d.inverse_mass.segment<3>(6 * k + 3), omega, h);
        d.x.segment<3>(6 * k + 3) = add(d.x.segment<3>(6 * k + 3), delta);
        d.u.segment<3>(6 * k + 3) = omega;
    }
    return rows;
}

// A uniform box with the edges e at a place.
void add_box(Bodies& d, const Vector3d& e, double mass, const Vector3d& at)
{
    for (Vec* v : {&d.x, &d.u, &d.inverse_mass})
        v->conservativeResize(v->size() + 6);
    d.x.tail<6>() << at, 0, 0, 0;
    d.u.tail<6>().setZero();
    const Vector3d q = e.cwiseAbs2();
    const Vector3d I = mass / 12 * Vector3d(q[1] + q[2], q[2] + q[0], q[0] + q[1]);
    d.inverse_mass.tail<6>() << Vector3d::Constant(1 / mass), I.cwiseInverse();
}

// A joint at a point of the world whose x leads along an axis: some are locked.
Joint join(const Bodies& d, int a, int b, const Vector3d& at, const Vector3d& axis,
           const std::vector<int>& locked)
{
    const auto [xa, qa] = place(d, a);
    const auto [xb, qb] = place(d, b);
    const auto frame = Quaterniond::FromTwoVectors(Vector3d::UnitX(), axis);
    Joint joint{a,
                b,
                qa.conjugate() * (at - xa),
                qb.conjugate() * (at - xb),
                qa.conjugate() * frame,
                qb.conjugate() * frame,
                Six::Constant(-INFINITY),
                Six::Constant(INFINITY)};
    for (const int i : locked) joint.lo[i] = joint.hi[i] = 0;
    return joint;
}

// A door of 3 kg, 1 m wide and 2 m high, on a hinge; it opens to 90°.
Bodies door(double angle, double spin)
{
    Bodies d{{}, {}, {}, 0};
    add_box(d, {2, 1, 0}, 3, {0, 0.5, 0});
    d.joints = {join(d, -1, 0, {0, 0, 0}, {1, 0, 0}, {0, 1, 2, 4, 5})};
    d.joints[0].hi[3] = std::numbers::pi / 2;
    d.x << 0, std::cos(angle) / 2, std::sin(angle) / 2, angle, 0, 0;
    d.u << 0, -std::sin(angle) * spin / 2, std::cos(angle) * spin / 2, spin, 0, 0;
    return d;
}

int main(int count, char** word)
{
    // By hand, section 21.1: the door arrives at its stop, at 0.5 rad/s.
    Bodies d = door(std::numbers::pi / 2, 0.5);
    for (const Row& row : step(d, 0.1, 0, 2000))
        std::printf(
            "row %2d: J %5.2f %5.2f %5.2f %5.2f %5.2f %5.2f, lambda %6.3f\n",
            row.name, row.Jb[0], row.Jb[1], row.Jb[2], row.Jb[3], row.Jb[4],
            row.Jb[5], row.lambda);
    std::ofstream out(count < 2 ? "" : word[1]);  // SVG, in parallel projection
    out << "<svg xmlns='http://www.w3.org/2000/svg' width='640' fill='none' "
           "stroke-linecap='round' viewBox='-4.6 -1 9 5'>\n";
    const auto draw = [&out](const Bodies& d, int k, const std::vector<Vector3d>& r,
                             bool upright, int colour, double width) {
        const auto [x, q] = place(d, k);
        out << "<path stroke='" << (colour ? "#CC3311" : "#4477AA")
            << "' stroke-width='" << width << "' d='M";
        for (const Vector3d& corner : r) {
            Vector3d p = x + q * corner;
            if (upright) p = Vector3d(p.y() - 4, p.z(), p.x() - 1);
            out << p.x() - 0.3 * p.y() << ' ' << -p.z() - 0.4 * p.y() << ' ';
        }
        out << "z'/>\n";
    };
    // A motor drives it from the middle: it turns at its speed until the stop.
    d = door(0.5, 0);
    d.joints[0].motor = 3, d.joints[0].speed = 1, d.joints[0].force = 20;
    for (int n = 0; n <= 150; step(d, 1.0 / 120, 0.2, 200), ++n)
        if (n % 30 == 0)
            draw(d, 0, {{1, -.5, 0}, {1, .5, 0}, {-1, .5, 0}, {-1, -.5, 0}}, true,
                 n == 150, 0.04);
    std::printf("the door: %.2f degrees, %.2f rad/s\n",
                d.x[3] * 180 / std::numbers::pi, d.u[3]);
    // Four rods on ball joints, let go level and pushed to the side.
    d = Bodies{{}, {}, {}};
    for (int k = 0; k < 4; ++k) add_box(d, {1, 0.1, 0.1}, 1, {k + 0.5, 0, 0});
    for (int k = 0; k < 4; ++k)
        d.joints.push_back(
            join(d, k - 1, k, {1.0 * k, 0, 0}, {1, 0, 0}, {0, 1, 2}));
    d.u[6 * 3 + 1] = 3;
    double open = 0;
    for (int n = 0; n <= 240; ++n) {
        for (int k = 0; k < 4 && n % 40 == 0; ++k)
            draw(d, k, {{-0.45, 0, 0}, {0.45, 0, 0}}, false, k % 2,
                 0.03 + 0.0003 * n);
        for (const Row& row : step(d, 1.0 / 240, 0.2, 100))
            open = std::max(open, std::abs(row.C));
    }
    out << "</svg>\n";
    std::printf("rods: their joints open by %.1e m at most\n", open);
}
