/// \file known_bodies.hpp
/// The bodies of a world: the scene that they are in, their names, and what the engine knows of each besides.
#pragma once

#include "chapters/19_engine/body_forces.hpp"
#include "chapters/19_engine/places.hpp"

namespace rigid {

/// What the engine knows of a body besides the scene; filter, user and sensor also of each other shape of a body.
struct BodyNotes {
    Filter filter;
    std::uint64_t user = 0;
    bool sensor = false, bullet = false;
    int chain = -1;  ///< first body of the chain that it is an edge of
    int joints = 0;  ///< that hold it
    /// as it was given, whether it counts now or not; 0 = none was [kg, kg m²]
    Real mass = 0, inertia = 0;
    bool dynamic = false, fixed_rotation = false;
    bool disabled = false;
    bool aims = false;  ///< it has a target in the next step
};

/// A body that is switched off, and the velocity that it will have.
struct DisabledBody {
    int body = 0;
    Vec<3> u = Vec<3>::Zero();
};

/// What the engine knows of a joint besides the scene.
struct JointNotes {
    std::uint64_t user = 0;
    /// a body of it is switched off, and it had broken before
    bool off = false, was_broken = false;
};

//! [known]
struct KnownBodies {
    WorldScene scene;
    Places<BodyTag> bodies;  ///< of scene.bodies
    std::vector<BodyNotes> notes;
    std::vector<DisabledBody> disabled;
    //! [known]

    /// Of a shape.
    Index shape_number(BodyId id) const
    {
        return static_cast<Index>(bodies.require(id, "body"));
    }
    /// Of the body that has the shape.
    Index number(BodyId id) const { return scene.carrier(shape_number(id)); }
    /// The world for an id of nothing.
    Index number_or_world(BodyId id) const { return id ? number(id) : world; }
    BodyId id(Index k) const
    {
        return k == world ? BodyId{} : bodies.id(static_cast<std::size_t>(k));
    }
    BodyNotes& note(Index k) { return notes[static_cast<std::size_t>(k)]; }
    const BodyNotes& note(Index k) const
    {
        return notes[static_cast<std::size_t>(k)];
    }
    const Polygon& shape(Index k) const
    {
        return scene.shapes[static_cast<std::size_t>(k)];
    }

    /// Of a body that is switched off it is what it will have.
    Vec<3> velocity(Index k) const
    {
        if (note(k).disabled)
            for (const DisabledBody& it : disabled)
                if (it.body == k) return it.u;
        return scene.bodies.velocity(k);
    }
    void set_velocity(Index k, const Vec<3>& u)
    {
        if (!note(k).disabled) scene.bodies.velocity(k) = u;
        for (DisabledBody& it : disabled)
            if (it.body == k) it.u = u;
    }

    //! [write_mass]
    /// The inverse mass of body k, from its notes.
    void write_inverse_mass(Index k)
    {
        const BodyNotes& it = note(k);
        const bool moves = it.dynamic && !it.disabled;
        const Real m = moves ? 1 / it.mass : 0;
        scene.bodies.inverse_mass.segment<3>(3 * k) << m, m,
            (moves && !it.fixed_rotation ? 1 / it.inertia : 0);
    }
    //! [write_mass]

    /// What acts on body k besides its weight; the list begins with the first that
    /// needs it.
    void act(Index k, const BodyForces& own)
    {
        if (scene.acting.empty() && own == BodyForces{}) return;
        scene.acting.resize(notes.size());
        scene.acting[static_cast<std::size_t>(k)] = own;
    }
    BodyForces acts(Index k) const
    {
        return scene.acting.empty() ? BodyForces{}
                                    : scene.acting[static_cast<std::size_t>(k)];
    }

    /// What sleeps on it would wake if it came or went.
    bool is_ground(Index k) const
    {
        return !scene.bodies.can_move(scene.carrier(k)) && !note(k).sensor &&
               !note(k).disabled;
    }
};

}  // namespace rigid
