/// \file joint_places.hpp
/// How joints get into the scene of a world and out of it again, and how another number of rows takes the place of theirs.
///
/// Numbers of joints and of their rows are names too, of impulses. So the place of a joint that is taken out stays, as one that
/// is broken, with its rows, until a joint with as many takes it. A joint that gets a limit, a motor or a spring, or loses one,
/// changes its rows with such a place.
#pragma once

#include "chapters/19_engine/world_state.hpp"

namespace rigid {

inline std::vector<PointJoint> rows_of(const RigidJoint& joint)
{
    std::vector<PointJoint> rows;
    add_frame_rows(joint, rows);
    add_drive_rows(joint, rows);
    return rows;
}

/// The rows of a joint's place hold nothing.
inline void hold_nothing(JointedScene& scene, const PlacedJoint& placed)
{
    PointJoint nothing;
    nothing.b = placed.joint.b;
    nothing.at_b = {1, 0};
    nothing.collides = true;
    std::fill_n(scene.joints.begin() + placed.first, placed.count, nothing);
}

/// The place of a joint that is gone with so many rows, the last that became free; −1:
/// there is none.
inline int free_place(const EngineState& state, int rows)
{
    const std::vector<std::uint32_t>& free = state.joints.free;
    const auto found = std::find_if(free.rbegin(), free.rend(), [&](auto place) {
        return state.scene.placed[place].count == rows;
    });
    return found == free.rend() ? -1 : static_cast<int>(*found);
}

//! [change_rows]
/// A joint gets another number of rows: it changes them with a free place, and where
/// there is none that fits, new rows at the end make one. Rows of others stay where
/// they are.
inline void change_rows(EngineState& state, std::size_t number,
                        const RigidJoint& joint, int count)
{
    JointedScene& scene = state.scene;
    int other = free_place(state, count);
    if (other < 0) {
        other = static_cast<int>(scene.placed.size());
        const std::size_t first = scene.joints.size();
        scene.placed.push_back({joint, static_cast<int>(first), count, true});
        scene.joints.resize(first + static_cast<std::size_t>(count));
        scene.owner.resize(scene.joints.size(), other);
        state.joint_notes.emplace_back();
        (void)state.joints.append();
        state.joints.give_back(static_cast<std::size_t>(other));
    }
    PlacedJoint &mine = scene.placed[number],
                &free = scene.placed[static_cast<std::size_t>(other)];
    std::swap(mine.first, free.first);
    std::swap(mine.count, free.count);
    free.joint.a = joint.a, free.joint.b = joint.b;
    hold_nothing(scene, free);
    std::fill_n(scene.owner.begin() + mine.first, mine.count,
                static_cast<int>(number));
    std::fill_n(scene.owner.begin() + free.first, free.count, other);
}

/// Another motor, spring, target or limit, also where there was none.
inline void replace_joint(EngineState& state, std::size_t number,
                          const RigidJoint& joint)
{
    require_valid(joint, number, state.scene.bodies);
    const JointKind kind = state.scene.placed[number].joint.kind;
    if (joint.kind != kind)
        throw std::invalid_argument("joint " + std::to_string(number) + " is a " +
                                    std::string(to_string(kind)) +
                                    " joint and would be a " +
                                    std::string(to_string(joint.kind)) +
                                    " joint; another kind is another joint");
    const auto count = static_cast<int>(rows_of(joint).size());
    if (count != state.scene.placed[number].count)
        change_rows(state, number, joint, count);
    change_joint(state.scene, number, joint);
}
//! [change_rows]

/// A joint of a body that is switched off holds nothing.
inline void switch_joint(EngineState& state, std::size_t number)
{
    PlacedJoint& placed = state.scene.placed[number];
    const auto is_off = [&](Index k) {
        return k != world && state.note(k).disabled;
    };
    const bool off = is_off(placed.joint.a) || is_off(placed.joint.b);
    JointNotes& note = state.joint_notes[number];
    if (off == note.off) return;
    note.off = off;
    if (off) note.was_broken = std::exchange(placed.broken, true);
    else placed.broken = note.was_broken;
}

/// A joint's place stays, as rows that hold nothing.
inline void take_out_joint(EngineState& state, std::size_t number)
{
    PlacedJoint& placed = state.scene.placed[number];
    for (const Index k : {placed.joint.a, placed.joint.b})
        if (k != world) {
            --state.note(k).joints;
            state.list_unstopped(k);
            state.disturb(k);
        }
    hold_nothing(state.scene, placed);
    placed.broken = true;
    state.joint_notes[number] = {};
    state.joints.give_back(number);
}

/// A joint in a free place with as many rows, or at the end.
inline JointId enter_joint(EngineState& state, const RigidJoint& joint)
{
    JointedScene& scene = state.scene;
    const std::vector<PointJoint> rows = rows_of(joint);
    const int free = free_place(state, static_cast<int>(rows.size()));
    JointId id;
    if (free < 0) {
        add_joint(scene, joint);
        id = state.joints.append();
        state.joint_notes.emplace_back();
    } else {
        id = state.joints.take(static_cast<std::size_t>(free));
        PlacedJoint& placed = scene.placed[id.place];
        placed.joint = joint;
        placed.broken = false;
        std::copy(rows.begin(), rows.end(), scene.joints.begin() + placed.first);
    }
    for (const Index k : {joint.a, joint.b})
        if (k != world) {
            ++state.note(k).joints;
            state.list_unstopped(k);
            state.disturb(k);
        }
    switch_joint(state, id.place);
    return id;
}

}  // namespace rigid
