/// \file told_stages.hpp
/// The engine's method, telling a listener which stage begins. It has no clock: a caller that wants times reads its own.
#pragma once

#include "chapters/19_engine/world_state.hpp"

namespace rigid {

//! [told]
/// The four stages of a method, each told before it begins. Forces and constraints,
/// which are no stage of a method, are told with its rows.
struct ToldStages {
    struct Contacts : PlainContacts {
        ToldStages& all;
        /// of all stages
        void require_valid() const { require_valid_stages(all.method); }
        template <class Scene, class Method>
        void begin(Scene& scene, const StepSettings& settings, Method&,
                   StepData<3>& now)
        {
            all.tell(Stage::contacts);
            all.method.contacts.begin(scene, settings, all.method, now);
        }
        template <class Scene>
        void end_part(Scene& scene, const StepData<3>& now)
        {
            all.method.contacts.end_part(scene, now);
        }
        template <class Scene, class Method>
        void end(Scene& scene, const StepSettings& settings, Method&,
                 StepData<3>& now)
        {
            all.tell(Stage::contacts);
            all.method.contacts.end(scene, settings, all.method, now);
        }
    };
    struct Correction : PlainCorrection {
        ToldStages& all;
        template <class Scene>
        void rows(Scene& scene, const StepSettings& settings, StepData<3>& now)
        {
            all.method.correction.rows(scene, settings, now);
        }
        template <class Scene, class Solver>
        void move(Scene& scene, const StepSettings& settings, Solver&,
                  StepData<3>& now)
        {
            all.tell(Stage::positions);
            all.method.correction.move(scene, settings, all.method.solver, now);
            if (now.substep + 1 < settings.substeps) all.tell(Stage::rows);
        }
    };
    struct Start : PlainStart {
        ToldStages& all;
        void recall(const StepSettings& settings, StepData<3>& now)
        {
            all.tell(Stage::start);
            all.method.start.recall(settings, now);
            all.tell(Stage::rows);
        }
        void choose(const Bodies<3>& bodies, StepData<3>& now)
        {
            all.method.start.choose(bodies, now);
        }
        void remember(const StepSettings& settings, const StepData<3>& now)
        {
            all.tell(Stage::start);
            all.method.start.remember(settings, now);
        }
    };
    struct Solver : PlainSolver {
        ToldStages& all;
        void solve(Bodies<3>& bodies, StepData<3>& now)
        {
            all.tell(Stage::solver);
            all.method.solver.solve(bodies, now);
        }
    };

    EngineMethod& method;
    const StageListener& listener;
    Contacts contacts{{}, *this};
    Correction correction{{}, *this};
    Start start{{}, *this};
    Solver solver{{}, *this};

    void tell(Stage stage) const
    {
        if (listener) listener(stage);
    }
};
//! [told]

}  // namespace rigid
