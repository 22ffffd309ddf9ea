/// \file touching.hpp
/// Which bodies touch, from step to step: what began, what ended, and how hard it began.
///
///     begins   a point of the pair bears an impulse, bounced in a sub-step, or overlaps
///     ends     no point bears one, and each gap is above a tenth of the margin
///
/// Between the two a touch stays what it is: a box at rest on three points, of which one bears nothing now and then, does
/// not end and begin. Bodies that sleep go on touching what they touched.
#pragma once

#include "chapters/13_friction/friction_rows.hpp"
#include "chapters/19_engine/asked_manifolds.hpp"
#include "chapters/19_engine/events.hpp"

#include <iterator>
#include <tuple>

namespace rigid {

/// Two shapes by their numbers, or a shape and a wall by its number; ascending order is that of the step's contacts.
struct TouchKey {
    std::int32_t a = -1, b = 0, wall = -1;

    auto operator<=>(const TouchKey&) const = default;
};

/// A pair that touches, under the names that it had when it began.
struct HeldTouch {
    TouchKey key;
    Touch touch;
};

//! [touching]
struct Touching {
    std::vector<HeldTouch> held;    ///< of bodies that were looked at, ascending
    std::vector<HeldTouch> asleep;  ///< of others, ascending
    std::int64_t walked = 0;        ///< touches passed in the last step

    /// Takes in the contacts of a step.
    /// \param now        as it was taken
    /// \param bounced    of each row: how fast it approached before it bounced [m/s]
    /// \param looking    the bodies that are looked at
    /// \param looked_at  bool(int): its contacts were looked for in this step
    /// \param before     Vec<3>(Index): the velocity of a body before the step
    /// \param name       Touch(const TouchKey&)
    /// \param slowest    slower ones are no hits [m/s]
    template <class LookedAt, class Before, class Name>
    void update(const RigidScene& scene, const StepData<3>& now,
                const std::vector<Real>& bounced, Real margin, Real slowest,
                const std::vector<int>& looking, const LookedAt& looked_at,
                const Before& before, const Name& name, Events& events)
    {
        const auto seen = [&](const HeldTouch& it) {
            return looked_at(it.key.b) || (it.key.a >= 0 && looked_at(it.key.a));
        };
        walked = static_cast<std::int64_t>(held.size());
        if (looking != looking_) sort_out(looking, seen);
        list_pairs(scene, now, bounced, margin);
        next_.clear();
        auto found = pairs_.begin();
        for (const HeldTouch& old : held) {
            for (; found != pairs_.end() && found->key < old.key; ++found)
                begin(*found, now, slowest, before, name, events);
            const bool there = found != pairs_.end() && found->key == old.key;
            if (there && found->near) {
                next_.push_back(old);
                if (found->struck > 0)
                    hit(*found, found->struck, now, slowest, events);
            } else events.ended.push_back(old.touch);
            found += there;
        }
        for (; found != pairs_.end(); ++found)
            begin(*found, now, slowest, before, name, events);
        held.swap(next_);
    }
    //! [touching]

    /// Body k is taken out: what it touched ends.
    void forget(int k, Events& events)
    {
        forget_those([k](const TouchKey& key) { return key.a == k || key.b == k; },
                     events);
    }
    void forget_wall(int wall, Events& events)
    {
        forget_those([wall](const TouchKey& key) { return key.wall == wall; },
                     events);
    }

private:
    template <class Goes>
    void forget_those(const Goes& goes, Events& events)
    {
        for (auto* const list : {&held, &asleep})
            std::erase_if(*list, [&](const HeldTouch& old) {
                if (goes(old.key)) events.ended.push_back(old.touch);
                return goes(old.key);
            });
    }

    /// Other bodies are looked at than in the step before: which touches does that
    /// concern?
    template <class IsSeen>
    void sort_out(const std::vector<int>& looking, const IsSeen& seen)
    {
        walked += static_cast<std::int64_t>(asleep.size());
        looking_ = looking;
        next_.clear();
        std::merge(held.begin(), held.end(), asleep.begin(), asleep.end(),
                   std::back_inserter(next_), ascending);
        held.clear();
        asleep.clear();
        for (const HeldTouch& it : next_) (seen(it) ? held : asleep).push_back(it);
    }
    static bool ascending(const HeldTouch& x, const HeldTouch& y)
    {
        return x.key < y.key;
    }

    struct Pair {
        TouchKey key;
        int contact = 0;       ///< the deepest
        bool touches = false;  ///< it would begin now
        bool near = false;     ///< it would not end now
        Real struck = 0;       ///< the fastest approach that bounced [m/s]
    };

    void list_pairs(const RigidScene& scene, const StepData<3>& now,
                    const std::vector<Real>& bounced, Real margin)
    {
        pairs_.clear();
        for (std::size_t i = normal_of(now, 0); i < now.sources.size(); ++i) {
            const Source& source = now.sources[i];
            const Contact& contact =
                now.contacts[static_cast<std::size_t>(source.index)];
            TouchKey key{static_cast<int>(contact.shape_a()),
                         static_cast<int>(contact.shape_b()), -1};
            if (contact.a == world)
                key.wall = static_cast<int>(wall_of(scene, contact));
            if (pairs_.empty() || pairs_.back().key != key)
                pairs_.push_back({.key = key, .contact = source.index});
            Pair& pair = pairs_.back();
            if (contact.gap <
                now.contacts[static_cast<std::size_t>(pair.contact)].gap)
                pair.contact = source.index;
            const Real struck = bounced.empty() ? 0 : bounced[i];
            const bool bears =
                now.solution.lambda[static_cast<Index>(i)] > 0 || struck > 0;
            pair.struck = std::max(pair.struck, struck);
            pair.touches = pair.touches || bears || contact.gap <= 0;
            pair.near = pair.near || bears || contact.gap <= margin / 10;
        }
        const auto ascending = [](const Pair& x, const Pair& y) {
            return x.key < y.key;
        };
        if (!std::is_sorted(pairs_.begin(), pairs_.end(), ascending))
            std::sort(pairs_.begin(), pairs_.end(), ascending);
    }

    template <class Before, class Name>
    void begin(const Pair& pair, const StepData<3>& now, Real slowest,
               const Before& before, const Name& name, Events& events)
    {
        if (!pair.touches) return;
        next_.push_back({pair.key, name(pair.key)});
        events.began.push_back(next_.back().touch);
        const Contact& contact =
            now.contacts[static_cast<std::size_t>(pair.contact)];
        const auto velocity = [&](Index k) {
            if (k == world) return Vec2(0, 0);
            const Vec<3> u = before(k);
            const Vec2 r = contact.point - now.x_found.segment<2>(3 * k);
            return Vec2(u.head<2>() + u[2] * perpendicular(r));
        };
        hit(pair,
            std::max(pair.struck,
                     contact.normal.dot(velocity(contact.a) - velocity(contact.b))),
            now, slowest, events);
    }

    /// Of the touch that was taken last, if it is fast enough.
    void hit(const Pair& pair, Real speed, const StepData<3>& now, Real slowest,
             Events& events) const
    {
        const Contact& contact =
            now.contacts[static_cast<std::size_t>(pair.contact)];
        if (speed >= slowest)
            events.hits.push_back(
                {next_.back().touch, contact.point, contact.normal, speed});
    }

    std::vector<Pair> pairs_;
    std::vector<HeldTouch> next_;
    std::vector<int> looking_;
};

}  // namespace rigid
