/// \file random_worlds.hpp
/// Small worlds of the engine with numbers that are meant to go wrong, kind by kind, and what must hold of each of them.
///
///     a call  throws std::invalid_argument and moves nothing, or is obeyed
///     a step  throws nothing; every number that a world shows is finite; a body that is held is reported
///     bytes   a world that was saved and loaded goes on to the same bits
#pragma once

#include "tests/properties/random_definitions.hpp"

namespace rigid::properties {

/// One world from its first call to its last step.
class WorldAttack : RandomDefinitions {
public:
    WorldAttack(Index kind, Random& random, WorldTally& tally)
        : RandomDefinitions(kind, random, tally), world_(some_settings())
    {
    }

    /// \return  a sentence about the first thing that is false; empty: nothing is
    std::string operator()(int steps)
    {
        ++tally_.worlds;
        begin();
        const bool loads = one_of(8);
        for (int i = 0; i < steps && wrong_.empty(); ++i) {
            if (kind_ == 0 && one_of(4)) act();
            if (kind_ == 2 && one_of(20)) act();
            if (loads && i == steps / 2) load(i);
            step(world_, i);
            judge(i);
        }
        if (wrong_.empty()) ask();
        return wrong_;
    }

private:
    // ---- calls --------------------------------------------------------------------------------------
    /// A call is refused with a sentence and moves nothing, or is obeyed.
    template <class Call>
    void attempt(const Call& call)
    {
        const std::uint64_t before = world_.hash();
        try {
            call();
        } catch (const std::invalid_argument&) {
            ++tally_.refused;
            if (world_.hash() != before) wrong_ = "a call that was refused moved something";
        }
    }
    BodyId some(const std::vector<BodyId>& all)
    {
        return all.empty() ? BodyId{}
                           : all[static_cast<std::size_t>(random_.index(static_cast<Index>(all.size())))];
    }
    void join(BodyId a, BodyId b, const Vec2& at)
    {
        const JointKind kind = some_joint_kind();
        RigidJoint joint;
        attempt([&] { joint = world_.joint_at(kind, a, b, at); });
        joint.kind = kind;
        fill_in(joint);
        attempt([&] { world_.add_joint(a, b, joint); });
    }
    void begin()
    {
        attempt([&] { world_.add_wall({{0, 1}, or_any(0)}); });
        if (one_of(3)) {
            const Real angle = random_.uniform(0, 7);
            const Vec2 normal = along(angle, or_any(1));
            attempt([&] { world_.add_wall({normal, -3}, {or_any(random_.uniform()), 0, or_any(0), 0}); });
        }
        if (kind_ == 4 || one_of(4)) {
            std::vector<Vec2> points;
            const Index count = 2 + random_.index(4);
            for (Index i = 0; i < count; ++i)
                points.push_back({or_any(3 - 6 * static_cast<Real>(i) / 5), random_.uniform(-0.4, 0.4)});
            attempt([&] { world_.add_chain(points); });
        }
        const Index count = 3 + random_.index(one_of(24) ? 10 : 3);
        std::vector<BodyId> added;
        for (Index i = 0; i < count; ++i) {
            BodyDefinition body = some_body();
            if (kind_ == 3) body.position = {0.4 * static_cast<Real>(i), 2};
            const std::vector<ShapeDefinition> more =
                one_of(5) ? some_shapes() : std::vector<ShapeDefinition>{};
            attempt([&] { added.push_back(world_.add_body(body, more)); });
        }
        if (kind_ == 3) {
            for (std::size_t i = 0; i < added.size(); ++i)
                join(i == 0 ? BodyId{} : added[i - 1], added[i], {0.4 * static_cast<Real>(i) - 0.2, 2});
            for (Index i = random_.index(3); i > 0; --i) {
                const BodyId a = some(added), b = some(added);
                join(a, b, place());
            }
        } else if (kind_ == 1 || kind_ == 2)
            for (Index i = random_.index(5); i > 0; --i) {
                const BodyId a = one_of(6) ? BodyId{} : some(added), b = some(added);
                join(a, b, place());
            }
    }
    void act()
    {
        const std::vector<BodyId> all = world_.bodies();
        // a body, or one of its shapes: what moves that is the body
        const BodyId body = some(all), other = some(all);
        const BodyId it = body && one_of(4) ? some(world_.shapes(body)) : body;
        const Vec2 at = place(3);
        switch (random_.index(12)) {
        case 0:
        case 1:
            if (all.size() < 7) {
                const BodyDefinition added = some_body();
                const std::vector<ShapeDefinition> more =
                    one_of(3) ? some_shapes() : std::vector<ShapeDefinition>{};
                attempt([&] { world_.add_body(added, more); });
            }
            break;
        case 2:
            if (all.size() > 2) attempt([&] { world_.remove(it); });
            break;
        case 3:
        case 4:
            join(it, other, at);
            break;
        case 5:
            attempt([&] { world_.move(it, at, or_any(random_.uniform(-7, 7))); });
            break;
        case 6:
            attempt([&] { world_.push(it, power(-2, 3) * at, at); });
            break;
        case 7: {
            const Real angle = random_.uniform(0, 7);
            const Vec2 velocity = along(angle, power(-2, 3));
            attempt([&] { world_.set_velocity(it, velocity, or_any(random_.uniform(-50, 50))); });
            break;
        }
        case 8:
            attempt([&] { world_.pull(one_of(3) ? BodyId{} : it, at); });
            break;
        case 9: {
            const Surface surface{or_any(random_.uniform(0, 2)), or_any(random_.uniform()), 0, 0};
            attempt([&] { world_.set_surface(it, surface); });
            break;
        }
        case 10: {
            const WorldSettings settings = some_settings();
            attempt([&] { world_.change(settings); });
            break;
        }
        default: {
            const std::vector<JointId> joints = world_.joints();
            if (joints.empty()) break;
            const JointId gone =
                joints[static_cast<std::size_t>(random_.index(static_cast<Index>(joints.size())))];
            if (one_of(2)) world_.remove(gone);
            else {
                RigidJoint joint = world_.joint(gone);
                joint.motor.speed = or_any(random_.uniform(-30, 30));
                joint.spring.target = or_any(random_.uniform(-1, 1));
                attempt([&] { world_.change(gone, joint); });
            }
        }
        }
    }

    // ---- what must hold -----------------------------------------------------------------------------
    void wrong(const std::string& what, int step)
    {
        if (wrong_.empty()) wrong_ = "step " + std::to_string(step) + ": " + what;
    }
    /// Valid calls lead to states that a step can go on from, whatever the calls were.
    void step(World& world, int i)
    {
        if (kind_ == 2 && one_of(20)) {
            const Real h = any();
            try {
                world.step(h);
                return;
            } catch (const std::invalid_argument&) {
                ++tally_.refused;
            }
        }
        takes_step(world, i);
        ++tally_.steps;
    }
    bool takes_step(World& world, int i)
    {
        try {
            world.step(frame);
            return true;
        } catch (const std::exception& thrown) {
            wrong(std::string("it throws: ") + thrown.what(), i);
        }
        return false;
    }
    void judge(int i)
    {
        const StepWork& work = world_.work();
        tally_.held += work.held;
        tally_.unsolved += work.unsolved > 0;
        if (work.held > 0 && work.unsolved == 0) wrong("a body is held and nothing is unsolved", i);
        if (work.held != static_cast<int>(world_.events().held.size()))
            wrong("not all that is held is reported", i);
        if (std::isnan(work.residual)) wrong("the residual is no number", i);
        for (const BodyId body : world_.bodies())
            if (!world_.position(body).allFinite() || !world_.velocity(body).allFinite() ||
                !std::isfinite(world_.angle(body)) || !std::isfinite(world_.spin(body)))
                wrong("body " + std::to_string(body.place) + " is at (" +
                          shortest(world_.position(body).x()) + ", " + shortest(world_.position(body).y()) +
                          ") with the velocity (" + shortest(world_.velocity(body).x()) + ", " +
                          shortest(world_.velocity(body).y()) + ") and the spin " +
                          shortest(world_.spin(body)),
                      i);
        world_.contacts(contacts_);
        for (const ContactView& contact : contacts_)
            if (!std::isfinite(contact.impulse) || !std::isfinite(contact.gap) ||
                !contact.point.allFinite() || !(std::abs(contact.normal.norm() - 1) < 1e-9))
                wrong("a contact at (" + shortest(contact.point.x()) + ", " + shortest(contact.point.y()) +
                          ") with the normal (" + shortest(contact.normal.x()) + ", " +
                          shortest(contact.normal.y()) + ") has the impulse " + shortest(contact.impulse) +
                          " and the gap " + shortest(contact.gap),
                      i);
        for (const JointId joint : world_.joints())
            if (std::isnan(world_.error(joint)) || std::isnan(world_.torque(joint)) ||
                world_.force(joint).hasNaN() || std::isnan(world_.coordinate(joint)))
                wrong("the " + std::string(to_string(world_.joint(joint).kind)) + " joint " +
                          std::to_string(joint.place) + " has the error " + shortest(world_.error(joint)) +
                          ", the force (" + shortest(world_.force(joint).x()) + ", " +
                          shortest(world_.force(joint).y()) + "), the torque " +
                          shortest(world_.torque(joint)) + " and the coordinate " +
                          shortest(world_.coordinate(joint)),
                      i);
    }
    void load(int i)
    {
        World other = World::load(world_.save());
        ++tally_.loaded;
        for (int k = 0; k < 10 && wrong_.empty(); ++k) {
            const bool one = takes_step(world_, i + k), two = takes_step(other, i + k);
            if (one != two || other.hash() != world_.hash())
                wrong("the world that was saved and loaded has other bits", i + k);
        }
    }
    void ask()
    {
        for (int k = 0; k < 4; ++k) {
            const Vec2 from = place(4), way = place(4);
            const Polygon shape = some_shape(power(-1, 0));
            attempt([&] {
                const auto met = world_.ray(from, way);
                if (met && !(met->part >= 0 && met->part <= 1 && met->point.allFinite()))
                    wrong_ = "a ray meets no place";
            });
            attempt([&] {
                const auto met = world_.cast(shape, from, 0, way);
                if (met && !(met->part >= 0 && met->part <= 1)) wrong_ = "a cast meets no place";
            });
            attempt([&] { world_.overlapping(shape, from); });
            attempt([&] { world_.at(from); });
        }
    }

    static constexpr Real frame = 1.0 / 60;
    std::string wrong_;
    World world_;
    std::vector<ContactView> contacts_;
};

}  // namespace rigid::properties
