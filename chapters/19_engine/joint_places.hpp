/// \file joint_places.hpp
/// How joints get into the scene of a world and out of it again, and how other rows take the place of theirs.
///
/// Numbers of joints and of their rows are names too, of impulses. So the place of a joint that is taken out stays, as one that
/// is broken, with its rows, until a joint with as many takes it. A joint that gets a limit, a motor or a spring, or loses one,
/// changes its rows with such a place.
#pragma once

#include "chapters/19_engine/renumbered_impulses.hpp"

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

/// A new place at the end, with so many rows.
inline JointId append_place(EngineState& state, int count)
{
    JointedScene& scene = state.scene;
    const auto first = static_cast<int>(scene.joints.size());
    scene.joints.resize(scene.joints.size() + static_cast<std::size_t>(count));
    scene.owner.resize(scene.joints.size(), static_cast<int>(scene.placed.size()));
    scene.placed.push_back({{}, first, count, true});
    state.joint_notes.emplace_back();
    return state.joints.append();
}

//! [change_rows]
/// A joint gets other rows: it changes them with a free place, and where
/// there is none that fits, new rows at the end make one. Rows of others stay where
/// they are. Rows that stay what they are keep their impulses.
inline void change_rows(EngineState& state, std::size_t number,
                        const RigidJoint& joint,
                        const std::vector<PointJoint>& rows)
{
    JointedScene& scene = state.scene;
    const auto count = static_cast<int>(rows.size());
    int other = free_place(state, count);
    if (other < 0) {
        other = static_cast<int>(append_place(state, count).place);
        state.joints.give_back(static_cast<std::size_t>(other));
    }
    PlacedJoint &mine = scene.placed[number],
                &free = scene.placed[static_cast<std::size_t>(other)];
    const std::vector<PointJoint> before = rows_of(mine.joint);
    renumber_impulses(state, mine, [&](int row) {
        const auto same =
            std::find_if(rows.begin(), rows.end(), [&](const PointJoint& it) {
                return is_same_row(it, before[static_cast<std::size_t>(row)]);
            });
        return same == rows.end()
                   ? -1
                   : free.first + static_cast<int>(same - rows.begin());
    });
    std::swap(mine.first, free.first);
    std::swap(mine.count, free.count);
    free.joint.a = joint.a, free.joint.b = joint.b;
    hold_nothing(scene, free);
    std::fill_n(scene.owner.begin() + mine.first, mine.count,
                static_cast<int>(number));
    std::fill_n(scene.owner.begin() + free.first, free.count, other);
}

/// Throws for a joint that makes no sense; a body that is switched off counts as what
/// it is when it is on.
inline void require_joint(const EngineState& state, std::size_t number,
                          const RigidJoint& joint)
{
    const auto is_off = [&](Index k) {
        return k != world && state.note(k).disabled;
    };
    if (!is_off(joint.a) && !is_off(joint.b))
        return require_valid(joint, number, state.scene.bodies);
    Bodies<3> on = state.scene.bodies;
    for (const Index k : {joint.a, joint.b})
        if (k != world && state.note(k).dynamic)
            on.inverse_mass.segment<3>(3 * k).setOnes();
    require_valid(joint, number, on);
}

/// Another motor, spring, target or limit, also where there was none.
inline void replace_joint(EngineState& state, std::size_t number,
                          const RigidJoint& joint)
{
    require_joint(state, number, joint);
    const JointKind kind = state.scene.placed[number].joint.kind;
    if (joint.kind != kind)
        throw std::invalid_argument("joint " + std::to_string(number) + " is a " +
                                    std::string(to_string(kind)) +
                                    " joint and would be a " +
                                    std::string(to_string(joint.kind)) +
                                    " joint; another kind is another joint");
    const std::vector<PointJoint> rows = rows_of(joint);
    const std::vector<PointJoint> before =
        rows_of(state.scene.placed[number].joint);
    if (!std::equal(rows.begin(), rows.end(), before.begin(), before.end(),
                    is_same_row))
        change_rows(state, number, joint, rows);
    PlacedJoint& placed = state.scene.placed[number];
    placed.joint = joint;
    std::copy(rows.begin(), rows.end(), state.scene.joints.begin() + placed.first);
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

/// Calls visit(number) for each joint of body k; it may take the joint out.
template <class Visit>
void for_each_joint_of(const EngineState& state, Index k, const Visit& visit)
{
    int left = state.note(k).joints;
    for (std::size_t j = 0; left > 0; ++j) {
        const RigidJoint& it = state.scene.placed[j].joint;
        if (!state.joints.has(j) || (it.a != k && it.b != k)) continue;
        --left;
        visit(j);
    }
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
    renumber_impulses(state, placed, [](int) { return -1; });
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
    const auto count = static_cast<int>(rows.size());
    const int free = free_place(state, count);
    const JointId id = free < 0 ? append_place(state, count)
                                : state.joints.take(static_cast<std::size_t>(free));
    PlacedJoint& placed = scene.placed[id.place];
    placed.joint = joint;
    placed.broken = false;
    std::copy(rows.begin(), rows.end(), scene.joints.begin() + placed.first);
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
