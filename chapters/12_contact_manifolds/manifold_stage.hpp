/// \file manifold_stage.hpp
/// The contacts stage for bodies of any convex shape: which pairs can touch, where, and what each point is called.
///
///     joints · bodies with walls · bodies with bodies      in ascending order of their keys
///
/// Bodies that cannot move are walls of any shape; two of them never make a row. What a joint joins does not collide, nor
/// does what the filter forbids.
#pragma once

#include "chapters/11_rotation/rigid_constraints.hpp"
#include "chapters/12_contact_manifolds/chains.hpp"
#include "chapters/12_contact_manifolds/flush_faces.hpp"
#include "chapters/12_contact_manifolds/look_ahead.hpp"
#include "chapters/12_contact_manifolds/manifold.hpp"
#include "chapters/12_contact_manifolds/pair_finder.hpp"
#include "chapters/12_contact_manifolds/touching_pair.hpp"
#include "chapters/12_contact_manifolds/wall_manifold.hpp"
#include "common/jobs.hpp"

namespace rigid {

//! [stage]
struct Manifolds : PlainContacts {
    PairFinder finder;
    /// what was the reference face or a name stays until another is better by more
    /// than this [margins]
    Real stay = 0.1;
    FastBodies fast;
    /// a gap that two bodies could close in this step has its row: how far each of
    /// them looks ahead at most; 0 = no farther than the margin [inner radii]
    Real ahead = 0;
    /// of each body, where gravity is not all that moves it [m/s²]; empty = it is
    std::vector<Real> falls;
    Jobs jobs;  ///< for pairs

    // What is kept from step to step.
    PlacedShapes placed;
    ChainEdges edges;
    Seams seams;
    std::vector<Real> ways;  ///< of each body that looks ahead, in this step [m]
    std::vector<TouchingPair> touching, before;  ///< ascending
    /// of bodies that are not looked at: as they were last
    std::vector<TouchingPair> resting;

    template <class Method>
    void begin(const RigidScene& scene, const StepSettings& settings, Method&,
               StepData<3>& now)
    {
        require_bodies(scene);
        now.length = typical_length(scene);
        now.active.resize(static_cast<std::size_t>(scene.bodies.count()));
        std::iota(now.active.begin(), now.active.end(), 0);
        const Real margin = settings.margin * now.length;
        placed.move(scene);
        look_ahead(scene, placed, {margin, ahead, settings.h, falls}, finder.asked,
                   now.active, finder.reach, ways);
        finder.find(scene, placed, margin);
        now.x_found = scene.bodies.x;
        list_rows(scene, margin, now);
    }

    /// The same for a step that looks at some bodies only.
    /// \param bodies  ascending; the others are where they were in the last step
    /// \param h       of the step [s]
    void begin_with(const RigidScene& scene, Real margin, Real h,
                    std::span<const int> bodies, StepData<3>& now)
    {
        placed.move(scene, bodies);
        look_ahead(scene, placed, {margin, ahead, h, falls}, finder.asked, bodies,
                   finder.reach, ways);
        finder.find(scene, placed, margin, bodies);
        const VecX& x = scene.bodies.x;
        if (now.x_found.size() != x.size()) now.x_found = x;
        for (const int k : bodies)
            now.x_found.segment<3>(3 * k) = x.segment<3>(3 * k);
        list_rows(scene, margin, now);
    }

    void list_rows(const RigidScene& scene, Real margin, StepData<3>& now)
    {
        edges.list(scene);
        now.contacts.clear();
        now.sources.clear();
        for (std::size_t i = 0; i < scene.joints.size(); ++i)
            if (is_looked_at(scene.joints[i].a) || is_looked_at(scene.joints[i].b))
                now.sources.push_back({Source::Of::joint, static_cast<int>(i)});
        wall_contacts(scene, margin, now);
        pair_contacts(scene, margin, now);
    }

    /// What moved so far that it could have passed through something goes back to
    /// where it would have touched it.
    template <class Method>
    void end(RigidScene& scene, const StepSettings& settings, Method&,
             const StepData<3>& now)
    {
        fast.have_rows = ahead > 0;
        fast.seams = seams.look;
        if (fast.stop)
            stop_fast_bodies(scene, settings, now, placed, edges, finder, touching,
                             fast);
    }
    //! [stage]

    void require_valid() const
    {
        if (!(stay >= 0 && stay < infinity))
            throw std::invalid_argument("stay is " + shortest(stay) +
                                        " margins; it must be zero or positive");
        if (!(ahead >= 0 && ahead < infinity))
            throw std::invalid_argument("shapes look " + shortest(ahead) +
                                        " inner radii ahead; it must be zero or "
                                        "positive, and finite");
        if (!(finder.skin >= 0 && finder.skin < infinity))
            throw std::invalid_argument("the skin of the tree is " +
                                        shortest(finder.skin) +
                                        " margins; it must be zero or positive");
    }

    /// Its joints make rows: it moves, and this step looks at it.
    bool is_looked_at(Index k) const
    {
        return k != world && finder.moves[static_cast<std::size_t>(k)] &&
               finder.asks[static_cast<std::size_t>(k)];
    }

    /// A blow turns a body within the step: where one end of an edge is looked for
    /// ahead, so is the other, four times as far; of a thin one as far as it goes.
    static Real second_within(Real reach, Real way)
    {
        return std::max(4 * reach, way);
    }
    Real way_of(std::size_t k) const { return k < ways.size() ? ways[k] : 0; }

    void wall_contacts(const RigidScene& scene, Real margin, StepData<3>& now) const
    {
        for (const int b : finder.asked) {
            if (!finder.moves[static_cast<std::size_t>(b)]) continue;
            const Box& box = finder.boxes[static_cast<std::size_t>(b)];
            const Vec2 middle = (box.low + box.high) / 2,
                       half = (box.high - box.low) / 2;
            const Placed shape = placed.of(b);
            for (std::size_t w = 0; w < scene.walls.size(); ++w) {
                const HalfSpace& wall = scene.walls[w];
                const Real way = way_of(static_cast<std::size_t>(b)),
                           reach = finder.reach_of(static_cast<std::size_t>(b)),
                           near = margin + way;
                if (wall.normal.dot(middle) - wall.normal.cwiseAbs().dot(half) >
                    wall.offset + near)
                    continue;
                add_contacts(scene, world, b,
                             collide(wall, shape, near, second_within(reach, way)),
                             static_cast<int>(w) * shape.size(), now);
            }
        }
    }

    //! [pair_contacts]
    /// The manifolds of the pairs, with what they were when last looked at beside
    /// them.
    void pair_contacts(const RigidScene& scene, Real margin, StepData<3>& now)
    {
        std::swap(touching, before);
        put_to_rest();
        touching.resize(finder.pairs.size());
        in_pieces(jobs, static_cast<int>(touching.size()), 256,
                  [&](int first, int end) { collide_pairs(margin, first, end); });
        std::erase_if(touching, [](const TouchingPair& it) {
            return it.manifold.count == 0;
        });
        seams.leave_out(scene, placed, edges, margin, touching);
        for (const TouchingPair& pair : touching)
            add_contacts(scene, pair.a, pair.b, pair.manifold, 0, now);
        if (woke_)
            std::erase_if(resting, [this](const auto& pair) { return asks(pair); });
    }

    /// Those of some pairs, from first on.
    void collide_pairs(Real margin, int first, int end)
    {
        auto old =
            first_from(before, finder.pairs[static_cast<std::size_t>(first)]);
        for (auto k = static_cast<std::size_t>(first);
             k < static_cast<std::size_t>(end); ++k) {
            const std::uint64_t pair = finder.pairs[k];
            const auto [a, b] = bodies_of(pair);
            while (old != before.end() && key_of(*old) < pair) ++old;
            const bool known = old != before.end() && key_of(*old) == pair;
            const Manifold* const last = known ? &old->manifold : at_rest(pair);
            const Real reach = finder.reach_of(static_cast<std::size_t>(a)) +
                               finder.reach_of(static_cast<std::size_t>(b));
            const Real way = way_of(static_cast<std::size_t>(a)) +
                             way_of(static_cast<std::size_t>(b));
            const ManifoldSettings how{margin + reach, stay * margin, last,
                                       second_within(reach, way)};
            touching[k] = {a, b,
                           edges.has(a) || edges.has(b)
                               ? collide_in_chain(placed, edges, a, b, how)
                               : collide(placed.of(a), placed.of(b), how)};
        }
    }
    //! [pair_contacts]

private:
    std::vector<int> asked_before_;
    bool woke_ = false;  ///< other bodies ask than in the step before

    static bool ascending(const TouchingPair& a, const TouchingPair& b)
    {
        return key_of(a) < key_of(b);
    }

    bool asks(const TouchingPair& pair) const
    {
        return finder.asks[static_cast<std::size_t>(pair.a)] != 0 ||
               finder.asks[static_cast<std::size_t>(pair.b)] != 0;
    }

    /// Pairs of the step before of which neither body looks any more are kept apart.
    void put_to_rest()
    {
        woke_ = finder.asked != asked_before_;
        if (!woke_) return;
        asked_before_ = finder.asked;
        const std::size_t old = resting.size();
        for (const TouchingPair& pair : before)
            if (!asks(pair)) resting.push_back(pair);
        std::inplace_merge(resting.begin(),
                           resting.begin() + static_cast<std::ptrdiff_t>(old),
                           resting.end(), ascending);
    }

    const Manifold* at_rest(std::uint64_t pair) const
    {
        const auto at = first_from(resting, pair);
        return at != resting.end() && key_of(*at) == pair ? &at->manifold : nullptr;
    }
};

}  // namespace rigid
