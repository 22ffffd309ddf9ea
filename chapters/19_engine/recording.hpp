/// \file recording.hpp
/// The calls that a world was given, and what came of each step: enough to live through it again.
///
///     Recording film;
///     world.record(&film);                    // from here on
///     …
///     Replay again = film.replay();           // another world, the same calls
///     again.differs_at                        // −1: each step gave the same bits
#pragma once

#include "chapters/19_engine/bytes.hpp"
#include "chapters/19_engine/world.hpp"

namespace rigid {

/// What can be called.
enum class Call : std::uint8_t {
    step,
    change,
    add_body,
    add_chain,
    remove_body,
    move,
    set_velocity,
    set_surface,
    set_filter,
    set_user,
    wake,
    push,
    pull,
    add_wall,
    remove_wall,
    add_joint,
    remove_joint,
    change_joint,
    set_target,
    set_force,
    set_gravity_scale,
    set_damping,
    set_fixed_rotation,
    set_enabled,
    set_kind,
    set_mass,
    set_shape,
    set_bullet,
    set_wall_surface,
    set_joint_user,
    add_shapes,
};

struct Replay {
    World world;
    std::int64_t steps = 0;
    /// the first step after which the hash is another than it was; −1: none
    std::int64_t differs_at = -1;
};

//! [recording]
class Recording {
public:
    /// The world as it was when the recording began.
    World start() const { return World::load(start_); }
    /// Makes the calls again.
    /// \param after   if not empty, is called after each step
    /// \param before  if not empty, is called with the world before the first call: to
    ///                give it the callbacks that it had
    Replay replay(const std::function<void(const World&)>& after = {},
                  const std::function<void(World&)>& before = {}) const;

    /// As bytes, and back; throws for bytes that are no recording.
    std::string save() const;
    static Recording load(std::string_view bytes);
    //! [recording]

private:
    friend class World;
    std::string start_;
    Writer calls_;

    template <class... Arguments>
    void note(Call call, const Arguments&... arguments)
    {
        calls_(call, arguments...);
    }
};

}  // namespace rigid
