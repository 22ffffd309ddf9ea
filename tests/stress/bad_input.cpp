#include "tests/stress/stresses.hpp"

namespace rigid::stress {

namespace {

/// A number that a caller sets, somewhere in a scene, in the step, or in the settings of a method.
struct Field {
    std::function<Real&(DiscScene&, Real& h, Wish&)> at;
    bool may_be_infinite = false;
    bool may_be_negative = true;  ///< false: zero and below zero are bad as well
};

using Fields = std::vector<Field>;

void add(Fields& fields, VecX Bodies<2>::*vector, Index size)
{
    for (Index i = 0; i < size; ++i)
        fields.push_back({[=](DiscScene& s, Real&, Wish&) -> Real& { return (s.bodies.*vector)[i]; }});
}

Fields fields_of_discs(const DiscScene& scene)
{
    Fields fields;
    for (auto vector : {&Bodies<2>::x, &Bodies<2>::u, &Bodies<2>::f, &Bodies<2>::inverse_mass})
        add(fields, vector, scene.bodies.x.size());
    for (Index k = 0; k < scene.radius.size(); ++k)
        fields.push_back({[=](DiscScene& s, Real&, Wish&) -> Real& { return s.radius[k]; }, false, false});
    return fields;
}

Fields fields_of_joints_and_walls(const DiscScene& scene)
{
    Fields fields;
    for (std::size_t i = 0; i < scene.walls.size(); ++i) {
        fields.push_back({[=](DiscScene& s, Real&, Wish&) -> Real& { return s.walls[i].normal.x(); }});
        fields.push_back({[=](DiscScene& s, Real&, Wish&) -> Real& { return s.walls[i].normal.y(); }});
        fields.push_back({[=](DiscScene& s, Real&, Wish&) -> Real& { return s.walls[i].offset; }});
    }
    for (std::size_t i = 0; i < scene.links.size(); ++i)
        fields.push_back(
            {[=](DiscScene& s, Real&, Wish&) -> Real& { return s.links[i].length; }, false, false});
    for (std::size_t i = 0; i < scene.bends.size(); ++i)
        fields.push_back(
            {[=](DiscScene& s, Real&, Wish&) -> Real& { return s.bends[i].length; }, false, false});
    return fields;
}

Fields fields_of_the_step()
{
    return {{[](DiscScene& s, Real&, Wish&) -> Real& { return s.gravity.x(); }},
            {[](DiscScene& s, Real&, Wish&) -> Real& { return s.gravity.y(); }},
            {[](DiscScene&, Real& h, Wish&) -> Real& { return h; }, false, false}};
}

Fields settings_of(const Method& method)
{
    Fields fields;
    for (std::size_t i = 0; i < method.settings.size(); ++i)
        fields.push_back({[i](DiscScene&, Real&, Wish& wish) -> Real& {
                              wish.setting = static_cast<int>(i);
                              return wish.spoilt;
                          },
                          method.settings[i].may_be_infinite});
    return fields;
}

/// Every value that makes no sense in this field.
std::vector<Real> bad_values(const Field& field)
{
    std::vector<Real> values = {std::nan(""), -infinity};
    if (!field.may_be_infinite) values.push_back(infinity);
    if (!field.may_be_negative) values.insert(values.end(), {0, -1});
    return values;
}

bool same(const DiscScene& a, const DiscScene& b)
{
    return a.bodies.x == b.bodies.x && a.bodies.u == b.bodies.u;
}

/// A method at work on a scene, and what may be spoilt about it.
struct Work {
    DiscScene scene;
    std::shared_ptr<Wish> wish = std::make_shared<Wish>();
    Step step;

    Work(const Method& method, const DiscScene& start) : scene(start), step(method.start(wish)) {}

    /// One step with a bad value in a field: refused with a sentence, and nothing has changed?
    Verdict spoil(const Field& field, Real value)
    {
        const DiscScene before = scene;
        Real h = 1.0 / 60;
        field.at(scene, h, *wish) = value;
        const DiscScene given = scene;
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

/// Seven discs in a chain with bends, three free ones, four walls; a chain alone for methods that know no contacts.
DiscScene scene_for(const Method& method, std::uint64_t seed)
{
    DiscScene scene = method.links_only ? slanted_chain(4, 1) : ten_discs();
    perturb(scene, seed);
    return scene;
}

Verdict worst(Verdict a, const Verdict& b) { return b.score < a.score ? b : a; }

/// Each field, each bad value, a method that has just begun.
Verdict at_the_start(const Method& method, const DiscScene& scene, const Fields& fields)
{
    Verdict verdict;
    for (const Field& field : fields)
        for (const Real value : bad_values(field))
            verdict = worst(verdict, Work(method, scene).spoil(field, value));
    return verdict;
}

/// After ten good steps; and when it was refused, the run goes on as if nothing had been, to the bit.
Verdict in_the_middle(const Method& method, const DiscScene& scene, const Fields& fields)
{
    Work disturbed(method, scene), alone(method, scene);
    const auto advance = [](Work& work, int steps) {
        for (int n = 0; n < steps; ++n) work.step(work.scene, 1.0 / 60);
    };
    advance(disturbed, 10);
    advance(alone, 10);
    Verdict verdict;
    for (const Field& field : fields)
        for (const Real value : bad_values(field)) verdict = worst(verdict, disturbed.spoil(field, value));
    advance(disturbed, 5);
    advance(alone, 5);
    return same(disturbed.scene, alone.scene) ? verdict : worst(verdict, {lost, silent});
}

}  // namespace

Stress bad_input()
{
    return {"bad input",
            "NaN, ∞ and −∞ in turn in every number of the scene, the step and the method's settings; where "
            "they must "
            "be positive, 0 and −1 as well",
            {"discs", "walls and joints", "gravity and h", "settings", "after 10 steps"},
            [](const Method& method, int level, std::uint64_t seed) -> std::optional<Verdict> {
                const DiscScene scene = scene_for(method, seed);
                const Fields discs = fields_of_discs(scene), joints = fields_of_joints_and_walls(scene),
                             step = fields_of_the_step(), settings = settings_of(method);
                if (level < 4)
                    return at_the_start(
                        method, scene,
                        std::array{discs, joints, step, settings}.at(static_cast<std::size_t>(level)));
                Fields all = discs;
                for (const Fields* more : {&joints, &step, &settings})
                    all.insert(all.end(), more->begin(), more->end());
                return in_the_middle(method, scene, all);
            }};
}

}  // namespace rigid::stress
