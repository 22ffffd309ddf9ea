#include "chapters/30_elastic_bodies/vibration.hpp"

#include "common/elementary.hpp"
#include "common/random.hpp"
#include "common/text.hpp"

#include <algorithm>
#include <numeric>
#include <vector>

namespace rigid {

namespace {

/// The small problem A q = ω² B q of a subspace, whole: B = C Cᵀ, then Jacobi. Columns of
/// `turn` are q, normed by B, with ω² ascending.
bool solve_small(MatX A, MatX B, MatX& turn, VecX& squares)
{
    const Index n = A.rows();
    for (Index j = 0; j < n; ++j) {  // B becomes its factor C
        for (Index k = 0; k < j; ++k)
            for (Index i = j; i < n; ++i) B(i, j) -= B(i, k) * B(j, k);
        if (!(B(j, j) > 0)) return false;
        const Real root = std::sqrt(B(j, j));
        for (Index i = j; i < n; ++i) B(i, j) /= root;
    }
    const auto forward = [&](MatX& X) {  // X ← C⁻¹ X
        for (Index c = 0; c < n; ++c)
            for (Index i = 0; i < n; ++i) {
                for (Index k = 0; k < i; ++k) X(i, c) -= B(i, k) * X(k, c);
                X(i, c) /= B(i, i);
            }
    };
    forward(A);
    A.transposeInPlace();
    forward(A);
    MatX V;
    symmetric_eigen(A, V);
    std::vector<Index> order(static_cast<std::size_t>(n));
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(),
                     [&A](Index i, Index j) { return A(i, i) < A(j, j); });
    turn.resize(n, n), squares.resize(n);
    for (Index c = 0; c < n; ++c) {
        const Index from = order[static_cast<std::size_t>(c)];
        squares[c] = A(from, from);
        for (Index i = n - 1; i >= 0; --i) {  // C⁻ᵀ
            Real sum = V(i, from);
            for (Index k = i + 1; k < n; ++k) sum -= B(k, i) * turn(k, c);
            turn(i, c) = sum / B(i, i);
        }
    }
    return true;
}

}  // namespace

template <int Dim>
Vibration<Dim> vibrations_of(const ElasticBody<Dim>& body, int count,
                             Real tolerance)
{
    const ElasticModel<Dim>& model = body.model;
    require_valid(body, NewtonOnEnergy{});
    const VecX& rest = model.mesh().rest;
    const Index n = rest.size();
    const auto free = std::count(body.fixed.begin(), body.fixed.end(), char{0});
    if (count < 1 || count > free)
        throw std::invalid_argument(
            "the number of vibrations is " + std::to_string(count) +
            "; it must be from 1 to " + std::to_string(free));
    if (!(tolerance >= 0))
        throw std::invalid_argument("the tolerance of vibrations is " +
                                    shortest(tolerance) +
                                    "; it must be zero or positive");
    BlockMatrix<Dim> K, H;
    K.reset(model.pattern());
    model.add_stiffness(rest, 1, false, K);
    Real shift =
        0;  // far below what swings, and enough that a free body is no obstacle
    for (int i = 0; i < model.nodes(); ++i)
        shift = std::max(shift, model.force_scale(i) /
                                    (model.edge() * model.inertia_at(i)));
    shift /= static_cast<Real>(n) * static_cast<Real>(n);
    // what rounding leaves of K, over M: 2^-52 of the largest ω²
    const Real G = model.steepest(),
               rounding = 2.2e-16 * G * G *
                          (2 * model.lame().mu + std::abs(model.lame().lambda)) /
                          model.material().density;
    BlockLdlt<Dim> factor;
    factor.analyse(model.pattern());
    Vibration<Dim> out;
    out.omega = VecX::Zero(count), out.shapes = MatX::Zero(n, count);
    const auto is_factored = [&] {
        H = K;
        model.add_mass(shift, H);
        fix<Dim>(body.fixed, H);
        return factor.factor(H);
    };
    if (!is_factored()) {
        out.status = Status::singular;
        return out;
    }
    const Index p = std::min<Index>(std::max(count + 8, 2 * count), free);
    Random random(22);
    MatX X(n, p), MX(n, p), KX(n, p);
    for (Index c = 0; c < p; ++c)
        for (Index i = 0; i < n; ++i)
            X(i, c) =
                body.fixed[static_cast<std::size_t>(i)] ? 0 : random.uniform(-1, 1);
    MatX A(p, p), B(p, p), turn;
    VecX x, product, squares;
    const Index rigid = rigid_motions(body);
    const auto clear_fixed = [&body](VecX& v) {
        for (Index i = 0; i < v.size(); ++i)
            if (body.fixed[static_cast<std::size_t>(i)]) v[i] = 0;
    };
    //! [subspace]
    while (out.status != Status::solved && out.iterations < 300) {
        ++out.iterations;
        for (Index c = 0; c < p; ++c) {
            x = X.col(c);
            model.multiply_mass(x, product);
            clear_fixed(product);
            factor.solve(product);  // (K + σM)⁻¹ M
            Real size = 0;
            for (Index i = 0; i < n; ++i)
                size = std::max(size, std::abs(product[i]));
            x = product / size;
            X.col(c) = x;
            model.multiply_mass(x, product);
            MX.col(c) = product;
            K.multiply(x, product);
            KX.col(c) = product;
        }
        for (Index i = 0; i < p; ++i)
            for (Index j = 0; j <= i; ++j) {
                Real a = 0, b = 0;
                for (Index k = 0; k < n; ++k)
                    a += X(k, i) * KX(k, j), b += X(k, i) * MX(k, j);
                A(i, j) = A(j, i) = a, B(i, j) = B(j, i) = b;
            }
        if (!solve_small(A, B, turn, squares)) {
            out.residual = infinity, out.status = Status::singular;
            return out;
        }
        // X, M X and K X turn alike
        for (auto* const m : {&X, &MX, &KX}) {
            const MatX old = *m;
            for (Index c = 0; c < p; ++c)
                for (Index i = 0; i < n; ++i) {
                    Real sum = 0;
                    for (Index k = 0; k < p; ++k) sum += old(i, k) * turn(k, c);
                    (*m)(i, c) = sum;
                }
        }
        out.residual = 0;
        bool is_solved = true;
        for (Index c = 0; c < count; ++c) {
            Real left = 0, size = 0;
            for (Index i = 0; i < n; ++i) {
                if (body.fixed[static_cast<std::size_t>(i)]) continue;
                const Real d = KX(i, c) - squares[c] * MX(i, c), m = MX(i, c);
                left += d * d, size += m * m;
            }
            const Real missed = std::sqrt(left / size),
                       scale = std::abs(squares[c]) + shift;
            out.residual = std::max(out.residual, missed / scale);
            is_solved =
                is_solved && missed <= std::max(tolerance * scale, rounding);
        }
        if (is_solved) {
            // rounding may leave more of K than a slender body has of it
            if (rigid < count && !(rounding <= squares[rigid])) break;
            out.status = Status::solved;
        }
        // Of ω² below the shift all look alike: it goes below them, as far as K + σM
        // stays definite in spite of rounding.
        else if (shift > std::max(squares[count - 1], 1000 * rounding)) {
            shift = std::max(squares[count - 1] / 10, 1000 * rounding);
            if (!is_factored()) {
                out.status = Status::singular;
                return out;
            }
        }
    }
    //! [subspace]
    for (Index c = 0; c < count; ++c)
        out.omega[c] = std::sqrt(std::max<Real>(0, squares[c]));
    out.shapes = X.leftCols(count);
    return out;
}

namespace {

/// How far a force of one moves in h what nothing holds, ∫∫ e^{−ct}.
Real free_way(Real c, Real h)
{
    const Real z = c * h;
    if (z < 1e-3)  // where the difference below would lose its digits
        return h * h / 2 * (1 - z / 3 * (1 - z / 4 * (1 - z / 5)));
    return (h + expm1(-z) / c) / c;
}

}  // namespace

//! [swing]
void swing(Real omega, Real c, Real force, Real h, Real& q, Real& speed)
{
    // (30.24): about where the force holds it; d² = ω² − c²/4
    if (!(omega * h > 1e-12)) {  // it does not swing: a body that flies
        const Real left = c > 0 ? -expm1(-c * h) / c : h;  // ∫ e^{−ct}
        q += left * speed + free_way(c, h) * force;
        speed += left * (force - c * speed);
        return;
    }
    // what swings so slowly that the force hardly notices: its middle is too far away
    const Real way = free_way(c, h);
    const bool is_near = omega * omega * way > 1e-8;
    const Real middle = force / (omega * omega), x = q - middle;
    const Real square = omega * omega - c * c / 4, d = std::sqrt(std::abs(square));
    Real fall = exp(-c * h / 2), C = 1, S = h;  // cos and sin over d
    if (d * h > 1e-9 && square > 0) C = cos(d * h), S = sin(d * h) / d;
    else if (d * h > 1e-9) {  // cosh and sinh, which alone may be infinite
        const Real less = expm1(-2 * d * h);
        fall = exp(-omega * omega / (c / 2 + d) * h);  // c/2 − d
        C = 1 + less / 2, S = -less / (2 * d);
    }
    q = is_near ? middle + fall * (x * C + (speed + c / 2 * x) * S)
                : fall * (q * C + (speed + c / 2 * q) * S) + way * force;
    speed = fall * (speed * C - (omega * omega * x + c / 2 * speed) * S);
}
//! [swing]

template <int Dim>
ModalBody<Dim>::ModalBody(const ElasticBody<Dim>& body, int count)
    : vibration(vibrations_of(body, count, 1e-8))
{
    q = speed = VecX::Zero(count);
    take(body);
}

template <int Dim>
void ModalBody<Dim>::require_same(const ElasticBody<Dim>& body) const
{
    require_valid(body, NewtonOnEnergy{});
    if (body.x.size() != vibration.shapes.rows())
        throw std::invalid_argument(
            "the body has " + std::to_string(body.x.size()) +
            " freedoms; its vibrations are those of one of " +
            std::to_string(vibration.shapes.rows()));
}

template <int Dim>
void ModalBody<Dim>::take(const ElasticBody<Dim>& body)
{
    require_same(body);
    f_ = body.x - body.model.mesh().rest;
    body.model.multiply_mass(f_, product_);
    VecX momentum;
    body.model.multiply_mass(body.v, momentum);
    for (Index k = 0; k < q.size(); ++k) {
        q[k] = speed[k] = 0;
        for (Index i = 0; i < f_.size(); ++i) {
            q[k] += vibration.shapes(i, k) * product_[i];
            speed[k] += vibration.shapes(i, k) * momentum[i];
        }
    }
}

template <int Dim>
void ModalBody<Dim>::step(ElasticBody<Dim>& body, Real h)
{
    require_step(h);
    require_same(body);
    f_ = body.load;
    for (int i = 0; i < body.model.nodes(); ++i)
        for (int c = 0; c < Dim; ++c)
            f_[Dim * i + c] += body.model.mass_at(i) * body.gravity[c];
    body.x = body.model.mesh().rest;
    body.v.setZero();
    for (Index k = 0; k < q.size(); ++k) {
        const Real* const shape = vibration.shapes.data() + k * f_.size();
        const Real omega = vibration.omega[k];
        Real force = 0;
        for (Index i = 0; i < f_.size(); ++i) force += shape[i] * f_[i];
        swing(omega, body.mass_damping + body.stiffness_damping * omega * omega,
              force, h, q[k], speed[k]);
        for (Index i = 0; i < f_.size(); ++i)
            body.x[i] += shape[i] * q[k], body.v[i] += shape[i] * speed[k];
    }
}

#define RIGID_VIBRATIONS(D)                                                        \
    template Vibration<D> vibrations_of(const ElasticBody<D>&, int, Real);         \
    template struct ModalBody<D>;
RIGID_VIBRATIONS(1)
RIGID_VIBRATIONS(2)
RIGID_VIBRATIONS(3)

}  // namespace rigid
