/// \file bad_input.hpp
/// NaN and infinity in every number that a caller sets: what the matrices have in common.
#pragma once

#include "tests/stress/stresses.hpp"

namespace rigid::stress {

/// A number that a caller sets, somewhere in a scene, in the step, or in the settings of a method.
template <class Scene>
struct FieldOf {
    std::function<Real&(Scene&, Real& h, Wish&)> at;
    bool may_be_infinite = false;
    bool may_be_negative = true;  ///< false: zero and below zero are bad as well
    bool may_be_zero = false;     ///< of those that may not be negative
    bool may_be_minus_infinite = false;
};

template <class Scene>
using FieldsOf = std::vector<FieldOf<Scene>>;

template <class Scene>
FieldsOf<Scene> fields_of_the_step()
{
    FieldsOf<Scene> fields = {
        {.at = [](Scene&, Real& h, Wish&) -> Real& { return h; }, .may_be_negative = false}};
    for (Index d = 0; d < Scene().gravity.size(); ++d)
        fields.push_back({[d](Scene& s, Real&, Wish&) -> Real& { return s.gravity[d]; }});
    return fields;
}

template <class Scene>
FieldsOf<Scene> settings_of(const MethodOf<Scene>& method)
{
    FieldsOf<Scene> fields;
    for (std::size_t i = 0; i < method.settings.size(); ++i)
        fields.push_back({[i](Scene&, Real&, Wish& wish) -> Real& {
                              wish.setting = static_cast<int>(i);
                              return wish.spoilt;
                          },
                          method.settings[i].may_be_infinite});
    return fields;
}

/// Every value that makes no sense in this field.
template <class Scene>
std::vector<Real> bad_values(const FieldOf<Scene>& field)
{
    std::vector<Real> values = {std::nan("")};
    if (!field.may_be_minus_infinite) values.push_back(-infinity);
    if (!field.may_be_infinite) values.push_back(infinity);
    if (!field.may_be_negative) values.push_back(-1);
    if (!field.may_be_negative && !field.may_be_zero) values.push_back(0);
    return values;
}

/// A method at work on a scene, and what may be spoilt about it.
template <class Scene>
struct Work {
    Scene scene;
    std::shared_ptr<Wish> wish = std::make_shared<Wish>();
    StepOf<Scene> step;

    Work(const MethodOf<Scene>& method, const Scene& start) : scene(start), step(method.start(wish)) {}

    /// One step with a bad value in a field: refused with a sentence, and nothing has changed?
    Verdict spoil(const FieldOf<Scene>& field, Real value)
    {
        const Scene before = scene;
        Real h = 1.0 / 60;
        field.at(scene, h, *wish) = value;
        const Scene given = scene;
        Verdict verdict{lost, silent};
        try {
            step(scene, h);
        } catch (const std::invalid_argument& refusal) {
            const bool left_alone =
                (scene.bodies.x.array() == given.bodies.x.array() || given.bodies.x.array().isNaN()).all() &&
                (scene.bodies.u.array() == given.bodies.u.array() || given.bodies.u.array().isNaN()).all();
            if (*refusal.what() != '\0' && left_alone) verdict = {};
            else verdict = {failed, "refused too late"};
        } catch (const std::exception&) {
            verdict = {failed, "not refused as bad input"};
        }
        scene = before;
        *wish = {};
        return verdict;
    }
};

inline Verdict worst(Verdict a, const Verdict& b) { return b.score < a.score ? b : a; }

/// Each field, each bad value, a method that has just begun.
template <class Scene>
Verdict at_the_start(const MethodOf<Scene>& method, const Scene& scene, const FieldsOf<Scene>& fields)
{
    Verdict verdict;
    for (const FieldOf<Scene>& field : fields)
        for (const Real value : bad_values(field))
            verdict = worst(verdict, Work<Scene>(method, scene).spoil(field, value));
    return verdict;
}

/// After ten good steps; and when it was refused, the run goes on as if nothing had been, to the bit.
template <class Scene>
Verdict in_the_middle(const MethodOf<Scene>& method, const Scene& scene, const FieldsOf<Scene>& fields)
{
    Work<Scene> disturbed(method, scene), alone(method, scene);
    const auto advance = [](Work<Scene>& work, int steps) {
        for (int n = 0; n < steps; ++n) work.step(work.scene, 1.0 / 60);
    };
    advance(disturbed, 10);
    advance(alone, 10);
    Verdict verdict;
    for (const FieldOf<Scene>& field : fields)
        for (const Real value : bad_values(field)) verdict = worst(verdict, disturbed.spoil(field, value));
    advance(disturbed, 5);
    advance(alone, 5);
    return disturbed.scene.bodies.x == alone.scene.bodies.x &&
                   disturbed.scene.bodies.u == alone.scene.bodies.u
               ? verdict
               : worst(verdict, {lost, silent});
}

/// The row of a matrix of bodies that turn.
/// \param run  as of StressOf
template <class Scene>
StressOf<Scene> bad_input_of(const decltype(StressOf<Scene>::run)& run)
{
    StressOf<Scene> stress{
        "bad input",
        "NaN, ∞ and −∞ in turn in every number of the scene, the step and the method's settings; where "
        "they must be positive, 0 and −1 as well",
        {"bodies and shapes", "walls joints and surfaces", "gravity and h", "settings", "after 10 steps"},
        run};
    stress.seeds = {2, 2, 2, 2, 2};
    return stress;
}

/// Groups of fields, a level each, and all of them after ten steps.
template <class Scene>
std::optional<Verdict> spoil_all(const MethodOf<Scene>& method, const Scene& scene, int level,
                                 const FieldsOf<Scene>& bodies, const FieldsOf<Scene>& joints)
{
    const FieldsOf<Scene> step = fields_of_the_step<Scene>(), settings = settings_of(method);
    if (level < 4)
        return at_the_start(method, scene,
                            std::array{bodies, joints, step, settings}.at(static_cast<std::size_t>(level)));
    FieldsOf<Scene> all = bodies;
    for (const FieldsOf<Scene>* more : {&joints, &step, &settings})
        all.insert(all.end(), more->begin(), more->end());
    return in_the_middle(method, scene, all);
}

}  // namespace rigid::stress
