/// \file asked_manifolds.hpp
/// The contacts stage of the engine where a caller may leave touches out: it is asked for each, and those that do not count get
/// no rows in this step.
#pragma once

#include "chapters/19_engine/body_forces.hpp"

#include <functional>
#include <span>

namespace rigid {

/// Which wall of the scene a body's contact with one is with.
inline std::size_t wall_of(const RigidScene& scene, const Contact& contact)
{
    const auto corners = static_cast<Index>(
        scene.shapes[static_cast<std::size_t>(contact.shape_b())].vertices.size());
    return static_cast<std::size_t>(contact.feature / corners);
}

//! [asked]
struct AskedManifolds : ActedManifolds {
    /// is asked whether the contacts of two bodies, or of a body and a wall, count in
    /// this step; empty = they do
    std::function<bool(std::span<const Contact>)> counts;
    std::vector<std::uint64_t> left_out;  ///< pairs that do not, ascending

    void begin_with(const RigidScene& scene, Real margin, Real h,
                    std::span<const int> bodies, StepData<3>& now)
    {
        left_out.clear();
        ActedManifolds::begin_with(scene, margin, h, bodies, now);
        if (counts) leave_out(scene, now);
    }

private:
    /// Asks for each touch, in their order, and takes out those that do not count:
    /// their contacts with the sources of these, which come last, one for each.
    void leave_out(const RigidScene& scene, StepData<3>& now)
    {
        const std::size_t others = now.sources.size() - now.contacts.size();
        const auto is_same = [&](const Contact& a, const Contact& b) {
            return a.shape_a() == b.shape_a() && a.shape_b() == b.shape_b() &&
                   (a.a != world || wall_of(scene, a) == wall_of(scene, b));
        };
        auto kept = now.contacts.begin();
        for (auto first = now.contacts.begin(); first != now.contacts.end();) {
            const auto last =
                std::find_if(first, now.contacts.end(), [&](const Contact& it) {
                    return !is_same(*first, it);
                });
            const std::span<const Contact> touch(
                &*first, static_cast<std::size_t>(last - first));
            if (counts(touch)) kept = std::copy(first, last, kept);
            else if (first->a != world)
                left_out.push_back(pair_key(first->shape_a(), first->shape_b()));
            first = last;
        }
        now.contacts.erase(kept, now.contacts.end());
        now.sources.resize(others);
        for (std::size_t i = 0; i < now.contacts.size(); ++i)
            now.sources.push_back({Source::Of::contact, static_cast<int>(i)});
    }
};
//! [asked]

}  // namespace rigid
