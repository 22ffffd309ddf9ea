#include "chapters/30_elastic_bodies/elastic_model.hpp"

#include <Eigen/LU>
#include <array>

namespace rigid {

namespace {

/// Barycentric coordinates of the points of integration: the middle, or Dim + 1 points,
/// exact for polynomials of degree 2.
template <int Dim>
std::vector<Vec<Dim + 1>> points_of(int order)
{
    using Point = Vec<Dim + 1>;
    if (order == 1) return {Point::Constant(1.0 / (Dim + 1))};
    // λ = near at one corner and far at the others, with ∫ λ_i² as it is
    const Real root = 1 / std::sqrt(Dim + 2.0), far = (1 - root) / (Dim + 1);
    std::vector<Point> points;
    for (int i = 0; i <= Dim; ++i) {
        Point p = Point::Constant(far);
        p[i] += root;
        points.push_back(p);
    }
    return points;
}

/// A shape function as a sum of products of two barycentric coordinates and of one.
struct Shape {
    Real product = 0, single = 0;  ///< product λ_i λ_j + single λ_i
    int i = 0, j = 0;
};

template <int Dim>
std::vector<Shape> shapes_of(int order)
{
    std::vector<Shape> shapes;
    for (int i = 0; i <= Dim; ++i)
        shapes.push_back(order == 1 ? Shape{0, 1, i, i} : Shape{2, -1, i, i});
    if (order == 2)
        for (const auto& [a, b] : edges_of_element<Dim>())
            shapes.push_back({4, 0, a, b});
    return shapes;
}

/// ∫ Π λ^k over an element of measure 1: Dim! Π k! / (Dim + Σ k)!
template <int Dim>
Real integral_of(std::initializer_list<int> coordinates)
{
    std::array<int, Dim + 1> power{};
    Real value = 1;
    int degree = 0;
    for (const int c : coordinates) {
        // k! one factor at a time, and (Dim + 1)(Dim + 2)… likewise
        value *= static_cast<Real>(++power[static_cast<std::size_t>(c)]) /
                 static_cast<Real>(Dim + ++degree);
    }
    return value;
}

template <int Dim>
Real integral_of(const Shape& a, const Shape& b)
{
    return a.product * b.product * integral_of<Dim>({a.i, a.j, b.i, b.j}) +
           a.product * b.single * integral_of<Dim>({a.i, a.j, b.i}) +
           a.single * b.product * integral_of<Dim>({a.i, b.i, b.j}) +
           a.single * b.single * integral_of<Dim>({a.i, b.i});
}

}  // namespace

template <int Dim>
ElasticModel<Dim>::ElasticModel(const ElasticMesh<Dim>& mesh,
                                const ElasticMaterial& material)
    : mesh_(mesh), material_(material)
{
    require_valid(mesh_);
    require_valid(material_);
    lame_ = lame_of(material_, Dim);
    edge_ = edge_length(mesh_);
    const int n = mesh_.per_element();
    std::vector<std::array<int, 2>> pairs;
    for (int e = 0; e < mesh_.count(); ++e)
        for (int a = 0; a < n; ++a)
            for (int b = 0; b < a; ++b)
                pairs.push_back({mesh_.node(e, a), mesh_.node(e, b)});
    pattern_ = pattern_of(mesh_.nodes(), std::move(pairs));
    const auto points = points_of<Dim>(mesh_.order);
    const auto shapes = shapes_of<Dim>(mesh_.order);
    per_element_ = static_cast<int>(points.size());
    for (const auto& point : points)
        for (const Shape& s : shapes)
            shape_.push_back(s.product * point[s.i] * point[s.j] +
                             s.single * point[s.i]);
    mass_.assign(static_cast<std::size_t>(pattern_.blocks()), 0);
    share_ = scale_ = lumped_ = VecX::Zero(mesh_.nodes());
    for (int e = 0; e < mesh_.count(); ++e) {
        // ∇λ: rows of the inverse of the edges from corner 0, and minus their sum
        Mat<Dim> edges;
        for (int i = 0; i < Dim; ++i)
            edges.col(i) =
                mesh_.at(mesh_.node(e, i + 1)) - mesh_.at(mesh_.node(e, 0));
        const Mat<Dim> inverse = edges.inverse();
        Eigen::Matrix<Real, Dim + 1, Dim> slope;
        slope.template bottomRows<Dim>() = inverse;
        for (int c = 0; c < Dim; ++c) {
            slope(0, c) = 0;
            for (int i = 1; i <= Dim; ++i) slope(0, c) -= slope(i, c);
        }
        const Real measure = measure_of(mesh_, e);
        for (const auto& point : points) {
            weight_.push_back(measure / per_element_);
            for (int a = 0; a < n; ++a) {
                const Shape& s = shapes[static_cast<std::size_t>(a)];
                Real square = 0;
                for (int c = 0; c < Dim; ++c) {
                    const Real G = s.product * (point[s.i] * slope(s.j, c) +
                                                point[s.j] * slope(s.i, c)) +
                                   s.single * slope(s.i, c);
                    gradient_.push_back(G);
                    square += G * G;
                }
                scale_[mesh_.node(e, a)] += weight_.back() * std::sqrt(square) *
                                            (2 * lame_.mu + std::abs(lame_.lambda));
            }
        }
        const Real m = material_.density * measure;
        Real diagonal = 0;
        for (const Shape& s : shapes) diagonal += integral_of<Dim>(s, s);
        for (int a = 0; a < n; ++a)
            for (int b = 0; b <= a; ++b) {
                const int na = mesh_.node(e, a), nb = mesh_.node(e, b);
                slot_.push_back(pattern_.slot(na, nb));
                const Real part =
                    m * integral_of<Dim>(shapes[static_cast<std::size_t>(a)],
                                         shapes[static_cast<std::size_t>(b)]);
                mass_[static_cast<std::size_t>(slot_.back())] += part;
                share_[na] += part;
                if (a != b) share_[nb] += part;
                else lumped_[na] += part / diagonal;
            }
    }
}

template <int Dim>
Real ElasticModel<Dim>::mass() const
{
    Real sum = 0;
    for (int i = 0; i < nodes(); ++i) sum += share_[i];
    return sum;
}

template <int Dim>
void ElasticModel<Dim>::lump()
{
    is_lumped_ = true;
    mass_.assign(mass_.size(), 0);
    for (int i = 0; i < nodes(); ++i)
        mass_[static_cast<std::size_t>(
            pattern_.start[static_cast<std::size_t>(i)])] = share_[i] = lumped_[i];
}

template <int Dim>
Mat<Dim> ElasticModel<Dim>::deformation(const VecX& x, int point) const
{
    Mat<Dim> F = Mat<Dim>::Zero();
    const Real* G = gradients(point);
    const int e = element_of(point);
    for (int a = 0; a < mesh_.per_element(); ++a, G += Dim) {
        const Real* const xa = x.data() + Dim * mesh_.node(e, a);
        for (int c = 0; c < Dim; ++c)
            for (int r = 0; r < Dim; ++r) F(r, c) += xa[r] * G[c];
    }
    return F;
}

template <int Dim>
Real ElasticModel<Dim>::steepest() const
{
    Real most = 0;
    for (int i = 0; i < nodes(); ++i) most = std::max(most, scale_[i] / lumped_[i]);
    return most * material_.density / (2 * lame_.mu + std::abs(lame_.lambda));
}

template <int Dim>
Vec<Dim> ElasticModel<Dim>::place(int point) const
{
    const int n = mesh_.per_element(), e = element_of(point);
    Vec<Dim> p = Vec<Dim>::Zero();
    for (int a = 0; a < n; ++a)
        p += shape_[static_cast<std::size_t>(point % per_element_ * n + a)] *
             mesh_.at(mesh_.node(e, a));
    return p;
}

//! [stress]
template <int Dim>
Mat<Dim> ElasticModel<Dim>::stress(const Mat<Dim>& F, Real& density) const
{
    Mat<Dim> P;
    density += stress_of<Dim>(material_.law, lame_, F, P);
    return P;
}
//! [stress]

template <int Dim>
Real ElasticModel<Dim>::energy(const VecX& x) const
{
    Real sum = 0;
    for (int p = 0; p < points(); ++p) {
        Mat<Dim> P;
        sum +=
            weight(p) * stress_of<Dim>(material_.law, lame_, deformation(x, p), P);
    }
    return sum;
}

//! [forces]
template <int Dim>
Real ElasticModel<Dim>::add_forces(const VecX& x, VecX& f) const
{
    Real sum = 0;
    for (int p = 0; p < points(); ++p) {
        Real density = 0;
        const Mat<Dim> P = stress(deformation(x, p), density);
        sum += weight(p) * density;
        const Real* G = gradients(p);
        for (int a = 0; a < mesh_.per_element(); ++a, G += Dim) {
            Real* const fa = f.data() + Dim * mesh_.node(element_of(p), a);
            for (int r = 0; r < Dim; ++r)
                for (int c = 0; c < Dim; ++c) fa[r] -= weight(p) * P(r, c) * G[c];
        }
    }
    return sum;
}
//! [forces]

//! [stiffness]
template <int Dim>
void ElasticModel<Dim>::add_stiffness(const VecX& x, Real scale, bool projected,
                                      BlockMatrix<Dim>& H) const
{
    const int n = mesh_.per_element();
    const bool is_linear = material_.law == StrainLaw::linear;
    Stretches<Dim> s;  // at rest, where the linear law stays
    Curvature<Dim> at = curvature_at<Dim>(StrainLaw::corotational, lame_, s.sigma);
    std::array<Vec<Dim>, ElasticMesh<Dim>::most_nodes> t;
    for (int p = 0; p < points(); ++p) {
        if (!is_linear) {
            s = stretches_of<Dim>(deformation(x, p));
            at = curvature_at<Dim>(material_.law, lame_, s.sigma);
            if (projected) project(at);
        }
        const Real* const G = gradients(p);
        for (int a = 0; a < n; ++a)  // t_a = Vᵀ G_a
            for (int i = 0; i < Dim; ++i) {
                Real sum = s.V(0, i) * G[a * Dim];
                for (int c = 1; c < Dim; ++c) sum += s.V(c, i) * G[a * Dim + c];
                t[static_cast<std::size_t>(a)][i] = sum;
            }
        const Real w = scale * weight(p);
        const int e = element_of(p);
        const int* slot =
            slot_.data() + static_cast<std::ptrdiff_t>(e) * n * (n + 1) / 2;
        for (int a = 0; a < n; ++a)
            for (int b = 0; b <= a; ++b, ++slot) {
                const Vec<Dim>&ta = t[static_cast<std::size_t>(a)],
                      &tb = t[static_cast<std::size_t>(b)];
                Mat<Dim> k;  // (30.22) in the axes of the stretches
                for (int i = 0; i < Dim; ++i)
                    for (int j = 0; j < Dim; ++j)
                        k(i, j) = at.hessian(i, j) * ta[i] * tb[j];
                std::size_t pair = 0;
                for (int j = 0; j < Dim; ++j)
                    for (int i = 0; i < j; ++i, ++pair) {
                        const Real same = (at.flip[pair] + at.twist[pair]) / 2,
                                   across = (at.flip[pair] - at.twist[pair]) / 2;
                        k(i, i) += same * ta[j] * tb[j];
                        k(j, j) += same * ta[i] * tb[i];
                        k(i, j) += across * ta[j] * tb[i];
                        k(j, i) += across * ta[i] * tb[j];
                    }
                if (!is_linear)
                    k = product<Dim, Dim, Dim>(product<Dim, Dim, Dim>(s.U, k),
                                               s.U.transpose());
                Real* const to = H.block(*slot);
                const bool turned = mesh_.node(e, a) < mesh_.node(e, b);
                for (int i = 0; i < Dim; ++i)
                    for (int j = 0; j < Dim; ++j)
                        to[i * Dim + j] += w * (turned ? k(j, i) : k(i, j));
            }
    }
}
//! [stiffness]

template <int Dim>
void ElasticModel<Dim>::add_mass(Real scale, BlockMatrix<Dim>& H) const
{
    for (int slot = 0; slot < pattern_.blocks(); ++slot)
        for (int r = 0; r < Dim; ++r)
            H.block(slot)[r * Dim + r] +=
                scale * mass_[static_cast<std::size_t>(slot)];
}

template <int Dim>
void ElasticModel<Dim>::multiply_mass(const VecX& x, VecX& y) const
{
    y.setZero(x.size());
    for (int j = 0; j < nodes(); ++j)
        for (int p = pattern_.start[static_cast<std::size_t>(j)];
             p < pattern_.start[static_cast<std::size_t>(j) + 1]; ++p) {
            const int i = pattern_.row[static_cast<std::size_t>(p)];
            const Real m = mass_[static_cast<std::size_t>(p)];
            for (int r = 0; r < Dim; ++r) {
                y[Dim * i + r] += m * x[Dim * j + r];
                if (i != j) y[Dim * j + r] += m * x[Dim * i + r];
            }
        }
}

template <int Dim>
std::size_t ElasticModel<Dim>::bytes() const
{
    const auto of = [](const auto& list) { return list.size() * sizeof(list[0]); };
    return of(mesh_.elements) + of(weight_) + of(gradient_) + of(slot_) +
           of(mass_) + of(pattern_.start) + of(pattern_.row) +
           sizeof(Real) *
               static_cast<std::size_t>(mesh_.rest.size() + share_.size() +
                                        scale_.size() + lumped_.size());
}

template class ElasticModel<1>;
template class ElasticModel<2>;
template class ElasticModel<3>;

}  // namespace rigid
