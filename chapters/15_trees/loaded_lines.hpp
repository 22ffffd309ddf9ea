/// \file loaded_lines.hpp
/// The contacts stage with joints, for a correction that knows what a load makes stiff: lines under a load get rows across
/// themselves, (15.16) of geometric_stiffness.hpp.
#pragma once

#include "chapters/14_joints/joint_stage.hpp"
#include "chapters/15_trees/line_inertance.hpp"

namespace rigid {

//! [with_loaded_lines]
template <class Contacts>
struct WithLoadedLines : WithJoints<Contacts> {
    std::vector<Source> with_inerters_;  ///< memory

    template <class Method>
    void begin(const JointedScene& scene, const StepSettings& settings,
               Method& method, StepData<3>& now)
    {
        WithJoints<Contacts>::begin(scene, settings, method, now);
        // a start that keeps no impulses knows of no load
        if (const ImpulseCache* known = method.start.impulses())
            add_inerters(scene, settings, *known, now);
    }

    //! [inerters]
    /// Behind the rows of a joint that is a line, the rows across it that this step
    /// needs.
    void add_inerters(const JointedScene& scene, const StepSettings& settings,
                      const ImpulseCache& known, StepData<3>& now)
    {
        with_inerters_.clear();
        for (std::size_t i = 0; i < now.sources.size(); ++i) {
            const Source& source = now.sources[i];
            with_inerters_.push_back(source);
            if (source.of != Source::Of::joint) continue;
            const auto j = static_cast<std::size_t>(source.index);
            const bool goes_on =
                i + 1 < now.sources.size() &&
                now.sources[i + 1].of == Source::Of::joint &&
                are_one_line(scene, j,
                             static_cast<std::size_t>(now.sources[i + 1].index));
            const int lines = lines_of(scene.joints[j]);
            // the end of a pulley's rope that is tied to the world is no line
            const int first = lines == 2 && scene.joints[j].a == world ? 2 : 1;
            for (int part = first; !goes_on && part <= lines; ++part)
                if (needs_inerter(scene, j, part, settings, known))
                    with_inerters_.push_back(
                        {Source::Of::joint, source.index, part});
        }
        now.sources.swap(with_inerters_);
    }
    //! [inerters]
};
//! [with_loaded_lines]

}  // namespace rigid
