// The functions of compliant_rows.hpp.
#include "chapters/30_elastic_bodies/compliant_rows.hpp"

#include "common/text.hpp"

#include <stdexcept>
#include <string>

namespace rigid {

template <int Dim>
Real CompliantRow<Dim>::velocity(const VecX& v, const VecX& u) const
{
    Real w = rigid.bias;
    for (int i = 0; i < count; ++i) {
        const int first = Dim * node[static_cast<std::size_t>(i)];
        Real sum = push(i, 0) * v[first];
        for (int c = 1; c < Dim; ++c) sum += push(i, c) * v[first + c];
        w += sum;
    }
    if (rigid.a != world) w += rigid.Ja.dot(u.template segment<dof>(dof * rigid.a));
    if (rigid.b != world) w += rigid.Jb.dot(u.template segment<dof>(dof * rigid.b));
    return w;
}

template <int Dim>
void CompliantRow<Dim>::add_push(Real scale, const std::vector<char>& fixed,
                                 VecX& f) const
{
    for (int i = 0; i < count; ++i)
        for (int c = 0; c < Dim; ++c)
            if (const int at = Dim * node[static_cast<std::size_t>(i)] + c;
                !fixed[static_cast<std::size_t>(at)])
                f[at] += scale * push(i, c);
}

template <int Dim>
typename CompliantRow<Dim>::Held
CompliantRow<Dim>::held_by(const ElasticBody<Dim>& body) const
{
    if (!(rigid.Wa.array() == 0).all() || !(rigid.Wb.array() == 0).all())
        return Held::none;
    bool some_held = false, some_free = false;
    for (int i = 0; i < count; ++i)
        for (int c = 0; c < Dim; ++c)
            if (push(i, c) != 0)
                (body.fixed[static_cast<std::size_t>(
                     Dim * node[static_cast<std::size_t>(i)] + c)]
                     ? some_held
                     : some_free) = true;
    return !some_free ? Held::all : some_held ? Held::some : Held::none;
}

template <int Dim>
void CompliantStep<Dim>::find_answers(const ElasticBody<Dim>& body)
{
    if (answer_.size() < rows.size()) answer_.resize(rows.size());
    for (std::size_t i = 0; i < rows.size(); ++i) {
        if (rows[i].count == 0) continue;
        answer_[i].setZero(body.x.size());
        rows[i].add_push(1, body.fixed, answer_[i]);
        solver.factor.solve(answer_[i]);
        ++answers;
    }
}

template <int Dim>
Real CompliantStep<Dim>::entry(std::size_t i, std::size_t j) const
{
    const CompliantRow<Dim>&one = rows[std::max(i, j)],
          &other = rows[std::min(i, j)];
    Real a = i == j ? one.rigid.softness : 0;
    if (other.count > 0) {
        const VecX& answer = answer_[std::min(i, j)];
        for (int k = 0; k < one.count; ++k) {
            const int first = Dim * one.node[static_cast<std::size_t>(k)];
            Real sum = one.push(k, 0) * answer[first];
            for (int c = 1; c < Dim; ++c) sum += one.push(k, c) * answer[first + c];
            a += sum;
        }
    }
    for (const auto& [body, J] : {std::pair{one.rigid.a, &one.rigid.Ja},
                                  std::pair{one.rigid.b, &one.rigid.Jb}}) {
        if (body == world) continue;
        if (body == other.rigid.a) a += J->dot(other.rigid.Wa);
        if (body == other.rigid.b) a += J->dot(other.rigid.Wb);
    }
    return a;
}

template <int Dim>
void CompliantStep<Dim>::require_valid(Real friction, Real skin, Real margin) const
{
    for (const auto& [value, name] : {std::pair{friction, "friction"},
                                      {skin, "skin"},
                                      {margin, "margin"},
                                      {repaid, "repaid share"},
                                      {tolerance, "tolerance"}})
        if (!(value >= 0 && value < infinity))
            throw std::invalid_argument(
                "the " + std::string(name) + " of an elastic scene is " +
                shortest(value) + "; it must be zero or positive");
    if (!(max_correction_speed > 0))
        throw std::invalid_argument("the maximum correction speed is " +
                                    shortest(max_correction_speed) +
                                    " m/s; it must be positive");
    if (solver.settings.solve != LinearSolve::direct)
        throw std::invalid_argument(
            "contacts of an elastic body need its factor; choose "
            "LinearSolve::direct");
    if (solver.settings.rule != TimeRule::implicit_euler)
        throw std::invalid_argument(
            "contacts of an elastic body are those of implicit Euler; choose "
            "TimeRule::implicit_euler");
    if (most < 1)
        throw std::invalid_argument(
            "the number of iterations of an elastic scene is at most " +
            std::to_string(most) + "; it must be positive");
}

template struct CompliantRow<2>;
template struct CompliantRow<3>;
template class CompliantStep<2>;
template class CompliantStep<3>;

}  // namespace rigid
