/// \file step_data.hpp
/// What a step depends on, what it finds on its way, and the two plainest answers to "what is new to look at?":
/// every pair of discs, and every body.
#pragma once

#include "chapters/02_velocity_constraints/constraints.hpp"
#include "chapters/03_mlcp_formulation/mlcp.hpp"
#include "chapters/03_mlcp_formulation/stages.hpp"
#include "common/contact.hpp"
#include "common/forces.hpp"
#include "common/scenes.hpp"

#include <cstdint>
#include <numeric>
#include <span>
#include <vector>

namespace rigid {

/// What a step depends on besides the scene and the method. Lengths are measured in the length ℓ of the scene,
/// typical_length(), speeds and accelerations in ℓ a second and ℓ a second squared; h is in seconds.
struct StepSettings {
    Real h = 1.0 / 60;  ///< time step [s]
    /// the step is taken in so many parts; contacts are found once
    int substeps = 1;
    /// k of the torsional springs, a pure number; see add_bend_springs()
    Real stiffness = 0;
    Real damping = 0;  ///< of the bends [1/s]
    /// a contact gets its row when its gap is below this [ℓ]
    Real margin = 0.02;
    Index pulled = world;  ///< the disc that a hand pulls; world = none
    Vec2 hand = {0, 0};    ///< where to [m]

    Real part() const { return h / substeps; }  ///< the time of one sub-step [s]
};

/// Throws std::invalid_argument, naming the setting and its value, unless all of them make sense.
/// \param bodies  K
void require_valid(const StepSettings& settings, const Vec2& gravity, Index bodies);

/// Where a constraint of a step comes from.
struct Source {
    enum class Of : unsigned char { link, contact, joint, body };
    Of of = Of::link;
    int index = 0;  ///< in scene.links, now.contacts, scene.joints
    /// which of the rows of this thing: a contact has one until chapter 13
    int part = 0;
};

/// What a step finds on its way, kept for the reader to look at and for the next step to reuse.
template <int Dof>
struct StepData {
    std::vector<int> active;      ///< bodies that the step looks at, ascending
    std::span<const Bend> bends;  ///< springs that it looks at
    std::vector<typename ContactOf<Dof>::Type> contacts;
    /// where the active bodies were when the contacts were found [m]
    VecX x_found;
    std::vector<Source> sources;
    std::vector<Constraint<Dof>> constraints;  ///< one for each source
    std::vector<Row<Dof>> rows;                ///< one for each constraint
    /// 1: the row has its J of the step before (chapter 10); empty = none
    std::vector<std::uint8_t> kept;
    /// the rows are those of the step before, one for one
    bool same_rows = false;
    /// so are the active bodies, and what they hang on
    bool same_bodies = false;
    int substep = 0;  ///< the number of the present one
    Real h = 0;       ///< its length [s]
    /// ℓ, of the scene [m]; the contacts stage writes it
    Real length = 1;
    /// the rows are those of its second half (chapter 9)
    bool second_half = false;
    /// velocities after the forces, before the impulses [m/s]
    VecX u_star;
    /// e of each row, for solvers that let impacts come first (chapter 15); empty =
    /// none bounces
    std::vector<Real> restitution;
    Real slowest_bounce = 0;  ///< an approach that is slower does not bounce [m/s]
    Solution solution;        ///< of the last sub-step
    /// what λ has besides the answer of the rows: arcs and impacts (chapter 15) [N s];
    /// empty = nothing
    VecX besides;
    std::int64_t visits = 0;  ///< rows visited in this step, whatever for
};

/// A second problem on the rows of a step: the same J, other biases (chapter 7 corrects positions by it).
struct SecondProblem {
    std::vector<Real> bias;      ///< b of each row [m/s]
    std::vector<char> left_out;  ///< 1: the row gets no impulse in this problem
    /// what it gives is a part of the motion, no error (chapter 15): solvers that
    /// remember keep the two kinds apart
    bool arcs = false;
    int max_sweeps = 10;  ///< of solvers that sweep
    /// their sweeps end when none changes a row by more than this [m/s]
    Real tolerance = 1e-9;
    Solution solution;  ///< of this problem, by those that answer it apart
};

//! [all_pairs]
/// The contacts stage in its plainest form: every body is looked at, and every pair
/// is tested.
struct AllPairs : PlainContacts {
    /// false: nothing in this scene ever touches, and no pair is tested
    bool collides = true;

    template <class Method>
    void begin(const DiscScene& scene, const StepSettings& settings, Method&,
               StepData<2>& now) const
    {
        find(scene, settings, now);
    }

    void find(const DiscScene& scene, const StepSettings& settings,
              StepData<2>& now) const
    {
        require_bodies(scene);
        const Bodies<2>& bodies = scene.bodies;
        now.length = typical_length(scene);
        now.active.resize(static_cast<std::size_t>(bodies.count()));
        std::iota(now.active.begin(), now.active.end(), 0);
        now.bends = scene.bends;
        now.same_bodies = false;
        now.contacts.clear();
        if (collides)
            find_contacts(scene, settings.margin * now.length, now.contacts);
        // What cannot move cannot be pushed: two such bodies never are a row.
        const auto stand = [&](Index a, Index b) {
            return !bodies.can_move(a) && !bodies.can_move(b);
        };
        std::erase_if(now.contacts, [&](const Contact& contact) {
            return stand(contact.a, contact.b);
        });
        now.x_found = bodies.x;

        now.sources.clear();
        for (std::size_t i = 0; i < scene.links.size(); ++i)
            if (!stand(scene.links[i].a, scene.links[i].b))
                now.sources.push_back({Source::Of::link, static_cast<int>(i)});
        for (std::size_t i = 0; i < now.contacts.size(); ++i)
            now.sources.push_back({Source::Of::contact, static_cast<int>(i)});
        for (std::size_t i = 0; i < scene.joints.size(); ++i)
            if (!stand(scene.joints[i].a, scene.joints[i].b))
                now.sources.push_back({Source::Of::joint, static_cast<int>(i)});
    }
};
//! [all_pairs]

}  // namespace rigid
