#include "chapters/30_elastic_bodies/elastic_solver.hpp"

#include "common/bodies.hpp"
#include "common/union_find.hpp"

#include <Eigen/LU>
#include <numeric>

namespace rigid {

template <int Dim>
void require_valid(const ElasticBody<Dim>& body, const NewtonOnEnergy& settings)
{
    const auto size = body.model.mesh().rest.size();
    for (const auto& [list, name] :
         {std::pair{&body.x, "x"}, {&body.v, "v"}, {&body.load, "load"}}) {
        if (list->size() != size)
            throw std::invalid_argument(
                std::string(name) + " of an elastic body has " +
                std::to_string(list->size()) + " entries; its mesh has " +
                std::to_string(size));
        require_finite(*list, name);
    }
    if (body.fixed.size() != static_cast<std::size_t>(size))
        throw std::invalid_argument(
            "fixed has " + std::to_string(body.fixed.size()) +
            " entries; the mesh has " + std::to_string(size));
    for (const auto& [value, name] : {std::pair{body.mass_damping, "mass"},
                                      {body.stiffness_damping, "stiffness"}})
        if (!(value >= 0 && value < infinity))
            throw std::invalid_argument("the damping by " + std::string(name) +
                                        " is " + shortest(value) +
                                        "; it must be zero or positive");
    for (int c = 0; c < Dim; ++c)
        if (!std::isfinite(body.gravity[c]))
            throw std::invalid_argument(
                "gravity[" + std::to_string(c) + "] of an elastic body is " +
                shortest(body.gravity[c]) + " m/s²; it must be finite");
    if (settings.most < 0 || settings.most_linear < 0)
        throw std::invalid_argument(
            "the number of iterations is at most " +
            std::to_string(std::min(settings.most, settings.most_linear)) +
            "; it must be zero or positive");
    if (!(settings.stale >= 0 && settings.stale < 1))
        throw std::invalid_argument(
            "the share that a stale factor has to take the residual to is " +
            shortest(settings.stale) + "; it must be from 0 to 1");
    if (!(settings.tolerance > 0 && settings.linear_tolerance > 0))
        throw std::invalid_argument(
            "the tolerance is " +
            shortest(std::min(settings.tolerance, settings.linear_tolerance)) +
            "; it must be positive");
}

template <int Dim>
Real ElasticBody<Dim>::kinetic_energy() const
{
    VecX Mv;
    model.multiply_mass(v, Mv);
    return ordered_dot(v, Mv) / 2;
}

template <int Dim>
Real ElasticBody<Dim>::potential_energy() const
{
    Real sum = -ordered_dot(load, x);
    for (int i = 0; i < model.nodes(); ++i)
        for (int c = 0; c < Dim; ++c)
            sum -= model.mass_at(i) * gravity[c] * x[Dim * i + c];
    return sum;
}

template <int Dim>
int rigid_motions(const ElasticBody<Dim>& body)
{
    constexpr int turns = pairs_of(Dim), all = Dim + turns;
    const ElasticMesh<Dim>& mesh = body.model.mesh();
    // of each node another one of its piece, in the end the first
    std::vector<int> piece(static_cast<std::size_t>(mesh.nodes()));
    std::iota(piece.begin(), piece.end(), 0);
    for (int e = 0; e < mesh.count(); ++e)
        for (int i = 1; i < mesh.per_element(); ++i)
            unite(piece, mesh.node(e, 0), mesh.node(e, i));
    int free = 0;
    for (int first = 0; first < mesh.nodes(); ++first) {
        if (lowest_of(piece, first) != first) continue;
        Vec<Dim> middle = Vec<Dim>::Zero();
        std::vector<int> nodes;
        for (int i = first; i < mesh.nodes(); ++i)
            if (lowest_of(piece, i) == first)
                nodes.push_back(i), middle += mesh.at(i);
        middle /= static_cast<Real>(nodes.size());
        Real reach = 0;
        for (const int i : nodes)
            reach = std::max(reach, (mesh.at(i) - middle).norm());
        // what the fixed freedoms have of each motion
        MatX held = MatX::Zero(Dim * static_cast<Index>(nodes.size()), all);
        for (std::size_t n = 0; n < nodes.size(); ++n)
            for (int c = 0; c < Dim; ++c) {
                if (!body.fixed[static_cast<std::size_t>(Dim * nodes[n] + c)])
                    continue;
                const auto row = static_cast<Index>(n) * Dim + c;
                held(row, c) = 1;
                const Vec<Dim> arm = (mesh.at(nodes[n]) - middle) / reach;
                int turn = Dim;
                for (int j = 0; j < Dim; ++j)
                    for (int i = 0; i < j; ++i, ++turn)
                        held(row, turn) = c == i ? -arm[j] : c == j ? arm[i] : 0;
            }
        Eigen::FullPivLU<MatX> rank(held);
        rank.setThreshold(1e-9);
        free += all - static_cast<int>(rank.rank());
    }
    return free;
}

template <int Dim>
void ElasticSolver<Dim>::begin(ElasticBody<Dim>& body, Real tau)
{
    const ElasticModel<Dim>& model = body.model;
    tau_ = tau;
    report = {};
    x0_ = body.x;
    f_ = body.load;
    for (int i = 0; i < model.nodes(); ++i)
        for (int c = 0; c < Dim; ++c)
            f_[Dim * i + c] += model.mass_at(i) * body.gravity[c];
    y_ = x0_ + tau * body.v;
    if (settings.solve == LinearSolve::direct && !(analysed_ == model.pattern())) {
        analysed_ = model.pattern();
        factor.analyse(analysed_);
        kept_.has = false;
    }
    damped_ = tau > 0 && (body.mass_damping > 0 || body.stiffness_damping > 0);
    if (damped_) {
        B_.reset(model.pattern());
        model.add_mass(body.mass_damping, B_);
        model.add_stiffness(x0_, body.stiffness_damping, true, B_);
    }
    is_slow_ = false;
    for (Index i = 0; i < y_.size(); ++i)
        if (body.fixed[static_cast<std::size_t>(i)]) body.x[i] = y_[i];
    const Real here = look(body);
    if (!(tau > 0)) return;
    // where it would go by itself, if that is not worse than where it is
    before_ = body.x;
    body.x = y_;
    if (look(body) < here) return;
    body.x = before_;
    look(body);
}

template <int Dim>
Real ElasticSolver<Dim>::look(const ElasticBody<Dim>& body)
{
    const ElasticModel<Dim>& model = body.model;
    r = f_;
    const Real elastic = model.add_forces(body.x, r);
    difference_ = body.x - x0_;
    const Real work = ordered_dot(f_, difference_);
    const Real share = tau_ > 0 ? tau_ * tau_ : 1;
    Real G = share * (elastic - work), size = share * (elastic + std::abs(work));
    r *= share;
    if (tau_ > 0) {
        if (damped_) {
            B_.multiply(difference_, product_);
            const Real lost = tau_ / 2 * ordered_dot(difference_, product_);
            G += lost, size += lost;
            r -= tau_ * product_;
        }
        difference_ = body.x - y_;
        model.multiply_mass(difference_, product_);
        const Real inertia = ordered_dot(difference_, product_) / 2;
        G += inertia, size += inertia;
        r -= product_;
    }
    for (Index i = 0; i < r.size(); ++i)
        if (body.fixed[static_cast<std::size_t>(i)]) r[i] = 0;
    // an energy of small strains may be a difference of numbers of the size of strain 1
    Real strained = 0;
    for (int i = 0; i < model.nodes(); ++i)
        strained += model.force_scale(i) * model.edge();
    rounding_ = 1e-13 * size + 1e-16 * share * strained;
    report.residual = residual_of(body, r);
    return G_ = G;
}

template <int Dim>
Real ElasticSolver<Dim>::residual_of(const ElasticBody<Dim>& body,
                                     const VecX& r_left) const
{
    const ElasticModel<Dim>& model = body.model;
    Real largest = 0;
    for (int i = 0; i < model.nodes(); ++i) {
        const Real scale = tau_ > 0 ? model.inertia_at(i) * model.edge() +
                                          tau_ * tau_ * model.force_scale(i)
                                    : model.force_scale(i);
        for (int c = 0; c < Dim; ++c) {
            const Real share = std::abs(r_left[Dim * i + c]) / scale;
            if (share > largest || std::isnan(share)) largest = share;
        }
    }
    return largest;
}

template <int Dim>
bool ElasticSolver<Dim>::has_kept(const ElasticBody<Dim>& body) const
{
    const ElasticModel<Dim>& model = body.model;
    return settings.keeps_factor && kept_.has && kept_.tau == tau_ &&
           kept_.is_lumped == model.is_lumped() &&
           kept_.lame.mu == model.lame().mu &&
           kept_.lame.lambda == model.lame().lambda &&
           kept_.mass == model.material().density &&
           kept_.alpha == body.mass_damping &&
           kept_.beta == body.stiffness_damping &&
           kept_.law == model.material().law && kept_.fixed == body.fixed &&
           kept_.rest == model.mesh().rest &&
           (kept_.law == StrainLaw::linear || (settings.stale > 0 && !renew_));
}

template <int Dim>
void ElasticSolver<Dim>::keep(const ElasticBody<Dim>& body)
{
    const ElasticModel<Dim>& model = body.model;
    kept_.has = true, kept_.is_lumped = model.is_lumped();
    kept_.law = model.material().law;
    kept_.rest = model.mesh().rest, kept_.lame = model.lame();
    kept_.tau = tau_, kept_.mass = model.material().density;
    kept_.alpha = body.mass_damping, kept_.beta = body.stiffness_damping;
    kept_.fixed = body.fixed;
}

template <int Dim>
void ElasticSolver<Dim>::assemble(const ElasticBody<Dim>& body, bool projected)
{
    const ElasticModel<Dim>& model = body.model;
    H_.reset(model.pattern());
    model.add_stiffness(body.x, tau_ > 0 ? tau_ * tau_ : 1, projected, H_);
    if (tau_ > 0) model.add_mass(1, H_);
    if (damped_)
        for (std::size_t i = 0; i < H_.value.size(); ++i)
            H_.value[i] += tau_ * B_.value[i];
    fix<Dim>(body.fixed, H_);
}

//! [prepare]
template <int Dim>
bool ElasticSolver<Dim>::prepare(const ElasticBody<Dim>& body)
{
    const bool is_direct = settings.solve == LinearSolve::direct;
    is_fresh_ = !(is_direct && has_kept(body));
    if (is_fresh_) is_soft_ = false;
    if (!is_fresh_) return true;
    kept_.has = renew_ = false;
    const auto is_factored = [&](bool projected) {
        assemble(body, projected);
        if (!is_direct) return true;
        ++report.factorisations;
        return factor.factor(H_);
    };
    // The curvature as it is, where the projected one was slow and it is definite.
    if (!(is_direct && is_slow_ && is_factored(false)) && !is_factored(true) &&
        !soften(body))
        return false;
    keep(body);
    return true;
}
//! [prepare]

template <int Dim>
bool ElasticSolver<Dim>::soften(const ElasticBody<Dim>& body)
{
    const ElasticModel<Dim>& model = body.model;
    if (tau_ > 0 || model.material().law == StrainLaw::linear) return false;
    is_soft_ = true;
    for (Real share = 1e-3; share < 10; share *= 10) {
        for (int i = 0; i < model.nodes(); ++i)
            for (int c = 0; c < Dim; ++c)
                H_.block(model.pattern()
                             .start[static_cast<std::size_t>(i)])[c * Dim + c] +=
                    share * model.force_scale(i) / model.edge();
        ++report.factorisations;
        if (factor.factor(H_)) return true;
    }
    return false;
}

template <int Dim>
bool ElasticSolver<Dim>::direction(ElasticBody<Dim>& body)
{
    if (!prepare(body)) return false;
    if (settings.solve == LinearSolve::direct) {
        change_ = r;
        factor.solve(change_);
        return true;
    }
    cg_.tolerance = settings.linear_tolerance, cg_.most = settings.most_linear;
    cg_.solve(H_, r, change_);  // as far as it came it points downhill
    report.linear_iterations += cg_.iterations;
    return cg_.iterations > 0;
}

//! [descend]
template <int Dim>
Real ElasticSolver<Dim>::descend(ElasticBody<Dim>& body, const VecX& change,
                                 const VecX& push)
{
    const Real G = G_, work = push.size() > 0 ? ordered_dot(push, change) : 0;
    const Real slope = ordered_dot(r, change) + work;  // it falls by that at first
    before_ = body.x;
    for (Real s = 1; s > 1e-9; s /= 2) {
        body.x = before_ + s * change;
        const Real next = look(body) - s * work;
        if (next <= G - 1e-4 * s * slope + rounding_ + 1e-13 * std::abs(work))
            return s;
        ++report.halvings;
    }
    body.x = before_;
    look(body);
    return 0;
}
//! [descend]

//! [minimise]
/// Algorithm 30.1: Newton's method with steps that are halved until G falls.
template <int Dim>
void ElasticSolver<Dim>::minimise(ElasticBody<Dim>& body)
{
    // Against a stiff material a load may be less than the tolerance: once at least, and
    // to rest until it is balanced to a thousandth, or to what rounding leaves of F.
    Real enough = settings.tolerance;
    if (tau_ == 0)
        enough = std::min(enough, std::max(report.residual / 1000, noise_));
    const Real nothing = tau_ > 0 || f_.isZero(0) ? 1e-15 : 0;
    while (report.residual > enough ||
           (report.iterations == 0 && report.residual > nothing)) {
        if (report.iterations == settings.most) return;
        ++report.iterations;
        if (!direction(body)) {
            report.status = Status::singular;
            return;
        }
        const Real last = report.residual;
        if (descend(body, change_, {}) == 0) return;  // as far as it came
        // A linear law has no second step: what K leaves it cannot balance.
        if (tau_ == 0 && body.model.material().law == StrainLaw::linear &&
            !(report.residual <= std::max(last / 10, noise_))) {
            body.x = before_;
            look(body);
            report.status = Status::singular;
            return;
        }
        judge(last, report.residual, settings.tolerance);
    }
    report.status = std::isfinite(report.residual) && is_known(body)
                        ? Status::solved
                        : Status::iteration_limit;
}
//! [minimise]

template <int Dim>
bool ElasticSolver<Dim>::is_known(const ElasticBody<Dim>& body)
{
    if (tau_ > 0 || report.iterations == 0) return true;
    renew_ = is_slow_ = true;  // K here, as it is: that of a bent shape is stiffer
    if (!prepare(body) || (is_soft_ && rigid_motions(body) == 0)) return false;
    const auto way_of = [this](const VecX& pull) {
        change_ = pull;
        if (settings.solve == LinearSolve::direct) factor.solve(change_);
        else cg_.solve(H_, pull, change_);
        return change_.cwiseAbs().maxCoeff();
    };
    const Real missed = way_of(r);
    Real way = (body.x - x0_).cwiseAbs().maxCoeff();
    for (Index i = 0; i < f_.size(); ++i)
        if (body.fixed[static_cast<std::size_t>(i)]) f_[i] = 0;
    if (f_.isZero(0)) {
        // held nodes were moved, this time or before, or nothing was
        way = (body.x - body.model.mesh().rest).cwiseAbs().maxCoeff();
        return missed <=
               std::max(0.002 * way, settings.tolerance * body.model.edge());
    }
    if (missed > 0.002 * way) way = std::max(way, way_of(f_));
    return missed <= 0.002 * way;
}

//! [step]
template <int Dim>
void ElasticSolver<Dim>::step(ElasticBody<Dim>& body, Real h)
{
    require_step(h);
    require_valid(body, settings);
    const bool is_euler = settings.rule == TimeRule::implicit_euler;
    const Real tau = is_euler ? h : h / 2;
    begin(body, tau);
    minimise(body);
    for (Index i = 0; i < body.x.size(); ++i) {
        if (body.fixed[static_cast<std::size_t>(i)]) {
            body.x[i] = x0_[i] + h * body.v[i];
            continue;
        }
        const Real mean = (body.x[i] - x0_[i]) / tau;
        body.v[i] = is_euler ? mean : 2 * mean - body.v[i];
        if (!is_euler) body.x[i] += tau * mean;
    }
}
//! [step]

template <int Dim>
bool ElasticSolver<Dim>::is_loose(const ElasticBody<Dim>& body) const
{
    for (int c = 0; c < Dim; ++c) {
        Real sum = 0, size = 0;
        bool is_held = false;
        for (Index i = c; i < f_.size(); i += Dim) {
            is_held = is_held || body.fixed[static_cast<std::size_t>(i)];
            sum += f_[i], size += std::abs(f_[i]);
        }
        if (!is_held && std::abs(sum) > 1e-9 * size) return true;
    }
    return false;
}

template <int Dim>
void ElasticSolver<Dim>::rest(ElasticBody<Dim>& body)
{
    require_valid(body, settings);
    begin(body, 0);
    noise_ = 1e-15 * body.x.cwiseAbs().maxCoeff() * body.model.steepest();
    if (is_loose(body)) report.status = Status::singular;
    else minimise(body);
    if (report.status != Status::singular) body.v.setZero();
}

template <int Dim>
std::size_t ElasticSolver<Dim>::bytes() const
{
    constexpr std::size_t block = Dim * Dim * sizeof(Real);
    return H_.value.size() * sizeof(Real) + B_.value.size() * sizeof(Real) +
           static_cast<std::size_t>(factor.blocks()) * (block + sizeof(int)) +
           static_cast<std::size_t>(8 * r.size()) * sizeof(Real);
}

template struct ElasticBody<1>;
template struct ElasticBody<2>;
template struct ElasticBody<3>;
template int rigid_motions(const ElasticBody<1>&);
template int rigid_motions(const ElasticBody<2>&);
template int rigid_motions(const ElasticBody<3>&);
template void require_valid(const ElasticBody<1>&, const NewtonOnEnergy&);
template void require_valid(const ElasticBody<2>&, const NewtonOnEnergy&);
template void require_valid(const ElasticBody<3>&, const NewtonOnEnergy&);
template class ElasticSolver<1>;
template class ElasticSolver<2>;
template class ElasticSolver<3>;

}  // namespace rigid
