/// \file scene_run.hpp
/// One run for every scene of discs in this book: it steps the scene by a method, follows the pointer, measures and
/// draws. All that is special about a scene or a method is given to it as data and free functions, a SceneSetup.
#pragma once

#include "chapters/03_mlcp_formulation/program/columns.hpp"
#include "chapters/03_mlcp_formulation/program/ten_disc_scene.hpp"

#include <functional>
#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

namespace rigid {

/// What a run is made of. Each function may be empty, but for `draw`.
template <class Method>
struct SceneSetup {
    using State = RunState<Method>;

    DiscScene scene;
    Method method;  ///< as it begins; `tune` writes the reader's settings into it
    Real zoom = 1;  ///< from metres to the units of the picture
    Pointer pointer = Pointer::pulls;
    /// Writes what the reader has set into the step, the method and the scene; called before each step.
    std::function<void(const Settings&, State&)> tune = {};
    /// What else becomes of the scene before a step: joints, a disc that is taken away, a hand of its own.
    std::function<void(const Settings&, const Input&, State&)> before = {};
    std::function<void(State&)> after = {};  ///< what a picture remembers of a step
    /// What the text foretells, for the column and the picture.
    std::function<Real(const State&)> theory = {};
    /// The disc that the pointer gets hold of at a point [m]; empty = the one that lies under it.
    std::function<Index(State&, const Vec2&)> pick = {};
    std::function<void(Canvas&, const State&)> draw = {};
};

template <class Method>
class SceneRun : public Run {
public:
    using State = RunState<Method>;

    /// \param view     what the picture shows
    /// \param columns  what is measured after each step
    SceneRun(const View& view, std::vector<Measured<State>> columns,
             SceneSetup<Method> setup)
        : columns_(std::move(columns)), setup_(std::move(setup))
    {
        require_valid(setup_.scene);
        state_.scene = std::move(setup_.scene);
        state_.method = std::move(setup_.method);
        state_.view = view;
        state_.zoom = setup_.zoom;
        state_.pointer = setup_.pointer;
        state_.theory = std::move(setup_.theory);
        const DiscScene& scene = state_.scene;
        state_.start = {scene.bodies.x, scene.gravity, mechanical_energy(scene)};
        for (Index k = 0; k < scene.bodies.count(); ++k) note_height(k);
    }

    void step(const Settings& settings, const Input& input) override
    {
        if (setup_.tune) setup_.tune(settings, state_);
        follow(settings, input);
        if (setup_.before) setup_.before(settings, input, state_);
        // it is gone
        if (state_.step.pulled >= state_.scene.bodies.count())
            state_.step.pulled = world;
        ++state_.steps;

        rigid::step(state_.scene, state_.step, state_.method, state_.now);

        for (const int k : state_.now.active) {
            if (!state_.scene.bodies.position(k).allFinite())
                throw StepFailure("the position of body " + std::to_string(k) +
                                  " is not finite");
            note_height(k);
        }
        state_.unsolved += state_.now.solution.status != Status::solved;
        state_.visits += state_.now.visits;
        if (setup_.after) setup_.after(state_);
    }

    std::vector<Real> measure() const override
    {
        std::vector<Real> numbers;
        for (const Measured<State>& one : columns_)
            numbers.push_back(one.value(state_));
        return numbers;
    }

    void draw(Canvas& canvas) const override { setup_.draw(canvas, state_); }

private:
    /// The time step is the reader's. A pressed button pulls a disc; in the scene of the ten discs gravity follows.
    void follow(const Settings& settings, const Input& input)
    {
        StepSettings& step = state_.step;
        step.h = settings.h;
        if (state_.pointer == Pointer::ignored) return;
        if (state_.pointer == Pointer::steers) {
            state_.scene.gravity =
                steered_gravity(input, state_.view, settings["gravity"]);
            step.stiffness = settings["k"];
            step.damping = settings["damping"];
        }
        step.hand = input.pointer / state_.zoom;
        if (!input.pressed) step.pulled = world;
        else if (step.pulled == world)
            step.pulled = setup_.pick ? setup_.pick(state_, step.hand)
                                      : disc_under(state_.scene, step.hand);
    }

    void note_height(Index k)
    {
        state_.highest =
            std::max(state_.highest, state_.scene.bodies.position(k).y());
    }

    std::vector<Measured<State>> columns_;
    SceneSetup<Method> setup_;
    State state_;
};

/// A demo's columns, and the run that it starts.
/// \param set_up  what the run is made of; throws std::invalid_argument for settings that make no sense
template <class Method>
void run_scene(
    Demo& demo, const std::vector<Measured<RunState<Method>>>& columns,
    std::type_identity_t<std::function<SceneSetup<Method>(const Settings&)>> set_up)
{
    demo.columns.clear();
    for (const auto& one : columns) demo.columns.push_back(one.column);
    demo.start = [view = demo.view, columns,
                  set_up = std::move(set_up)](const Settings& settings) {
        return std::make_unique<SceneRun<Method>>(view, columns, set_up(settings));
    };
}

}  // namespace rigid
