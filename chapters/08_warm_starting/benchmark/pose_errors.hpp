/// \file pose_errors.hpp
/// How wrong an engine is, from nothing but where its discs are after each step: the same code for all of them.
///
/// Speeds are differences of positions, so that no engine's own velocities are used.
#pragma once

#include "chapters/08_warm_starting/benchmark/chain_reference.hpp"
#include "chapters/08_warm_starting/benchmark/engine_scenes.hpp"
#include "common/measure.hpp"

#include <algorithm>
#include <utility>

namespace rigid {

struct PoseErrors {
    Real link = 0;  ///< largest error of a link's length, over all steps [m]
    /// deepest overlap of two discs or of a disc and a wall, over all steps [m]
    Real overlap = 0;
    /// the larger of the two, over the second half of the steps [m]
    Real late = 0;
    /// farthest that the centre of mass was from where it belongs [m]
    Real drift = 0;
    /// greatest speed of a disc in the second half of the steps [m/s]
    Real speed = 0;
    /// no two neighbours changed places, nothing flew away, all numbers finite
    bool in_order = true;

    /// The larger of the two errors of position.
    Real position() const { return std::max(link, overlap); }
};

/// The centre of mass of the bodies that can move [m].
inline Vec2 centre_of_mass(const Bodies<2>& bodies, const VecX& x)
{
    Vec2 sum = Vec2::Zero();
    Real total = 0;
    for (Index k = 0; k < bodies.count(); ++k) {
        if (!bodies.can_move(k)) continue;
        sum += x.segment<2>(2 * k) / bodies.inverse_mass[2 * k];
        total += 1 / bodies.inverse_mass[2 * k];
    }
    return sum / total;
}

class PoseWatch {
public:
    /// \param scene  as it starts
    /// \param steps  how many there will be
    /// \param h      time step [s]
    PoseWatch(const EngineScene& scene, int steps, Real h)
        : rests_(scene.rests), steps_(steps), h_(h), start_(scene.scene.bodies.x),
          before_(start_)
    {
        // Which discs are neighbours: what a link joins, and what touches.
        for (const Link& link : scene.scene.links)
            neighbours_.emplace_back(link.a, link.b);
        std::vector<Contact> contacts;
        DiscScene discs = scene.scene;
        discs.walls.clear();
        find_contacts(discs, 1e-6, contacts);
        for (const Contact& contact : contacts)
            neighbours_.emplace_back(contact.a, contact.b);

        // Where the centre of mass belongs: at rest where it was; else where the exact motion has it, for the
        // first second. Later the motion of a chain depends on its beginning too much to be compared.
        places_.assign(1, centre_of_mass(scene.scene.bodies, start_));
        if (rests_) return;
        ChainReference exact(scene.scene);
        // of a step: RK4's error is then below 1e-8 m (tests/08_warm_starting.cpp)
        constexpr int parts = 200;
        for (int step = 0; step < std::min(steps, 60); ++step) {
            for (int part = 0; part < parts; ++part) exact.step(h / parts);
            places_.push_back(centre_of_mass(scene.scene.bodies, exact.x));
        }
    }

    /// Looks at the scene after a step.
    void look(const DiscScene& scene)
    {
        ++step_;
        const VecX& x = scene.bodies.x;
        if (!x.allFinite()) {
            errors.in_order = false;
            errors.link = errors.overlap = errors.late = errors.drift =
                errors.speed = infinity;
            return;
        }
        const bool late = 2 * step_ > steps_;
        const Real link = largest_link_error(scene),
                   overlap = deepest_penetration(scene);
        errors.link = std::max(errors.link, link);
        errors.overlap = std::max(errors.overlap, overlap);
        if (late) errors.late = std::max({errors.late, link, overlap});

        const auto place = rests_ ? 0 : static_cast<std::size_t>(step_);
        if (place < places_.size())
            errors.drift =
                std::max(errors.drift,
                         (centre_of_mass(scene.bodies, x) - places_[place]).norm());

        if (late)
            for (Index k = 0; k < x.size(); k += 2)
                errors.speed =
                    std::max(errors.speed,
                             (x.segment<2>(k) - before_.segment<2>(k)).norm() / h_);
        if (rests_)
            for (const auto& [a, b] : neighbours_) {
                const Vec2 was =
                    start_.segment<2>(2 * b) - start_.segment<2>(2 * a);
                if (!(was.dot(x.segment<2>(2 * b) - x.segment<2>(2 * a)) > 0))
                    errors.in_order = false;
            }
        before_ = x;
    }

    PoseErrors errors;

private:
    bool rests_;
    int steps_, step_ = 0;
    Real h_;
    VecX start_, before_;
    std::vector<std::pair<Index, Index>> neighbours_;
    std::vector<Vec2> places_;
};

}  // namespace rigid
