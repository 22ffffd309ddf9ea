/// \file stages.hpp
/// The four stages of a method as step() calls them: what each of them has, by which laws, and what one does that has
/// nothing to do there.
///
/// Nothing is looked for: a stage without an operation that the step calls is refused by the concept. What most stages
/// leave empty stands once, in the struct that a stage of its kind derives from.
#pragma once

#include "common/bodies.hpp"

#include <type_traits>

namespace rigid {

struct StepSettings;
template <int Dof>
struct StepData;
struct SecondProblem;
struct StabilizerSettings;  // chapter 7
struct ImpulseCache;        // chapter 8
struct Islands;             // chapter 10

/// A contacts stage without settings, for which all bodies are awake.
struct PlainContacts {
    /// the owner of the scene has checked it, and reports what it changes
    static constexpr bool is_told = false;

    void require_valid() const {}
    /// throws where the scene or the other stages are none that it is made for
    template <class Scene, class Method>
    void require_fit(const Scene&, const Method&) const
    {
    }
    template <class Scene, class Data>
    void end_part(Scene&, const Data&) const
    {
    }
    template <class Scene, class Method, class Data>
    void end(Scene&, const StepSettings&, Method&, const Data&) const
    {
    }
    bool is_asleep(Index) const { return false; }
    void wake(Index) const {}
    void wake_everybody() const {}
};

/// A correction stage without settings, which leaves nothing for a later step.
struct PlainCorrection {
    void require_valid() const {}
    void describe(StabilizerSettings&) const {}
    bool pushes(int) const { return false; }
};

/// A start stage that remembers nothing.
struct PlainStart {
    void require_valid() const {}
    ImpulseCache* impulses() const { return nullptr; }
};

/// A solver stage that leaves nothing in the velocities, and knows of no islands.
struct PlainSolver {
    /// its answers are exact, those of second problems too, or their status says that
    /// they are not
    static constexpr bool is_exact = false;
    /// it knows which contacts slide (chapter 13)
    static constexpr bool knows_sliding = false;
    int unsolved = 0;  ///< problems of the last step without a good enough answer

    void require_valid() const {}
    Real noise() const { return 0; }
    const Islands* islands_found() const { return nullptr; }
};

/// Which bodies the step looks at, and where its rows come from.
///
/// - require_valid() throws where settings make no sense, and changes nothing.
/// - begin() fills now.active (ascending), contacts, sources, x_found, length. It moves
///   no body. No active body: the step ends there, without end().
/// - end_part() sees what each sub-step has found, and moves nothing.
/// - end() may put bodies back to where they touched, and let them fall asleep.
/// - wake() and wake_everybody() are for what sees more than the stage does; called
///   before begin(), or where its caller calls it again. is_asleep() then says no.
template <class Stage, class Scene, class Method>
concept ContactsStage = requires(Stage stage, Scene& scene,
                                 const StepSettings& settings, Method& method,
                                 StepData<Scene::dof>& now, Index k)
{
    stage.require_valid();
    stage.begin(scene, settings, method, now);
    stage.end_part(scene, now);
    stage.end(scene, settings, method, now);
    bool{stage.is_asleep(k)};
    stage.wake(k);
    stage.wake_everybody();
    bool{Stage::is_told};
};

/// What becomes of a position error.
///
/// - rows() writes now.rows, one for each constraint; it may change u*, and masses
///   until move(), but neither x nor u.
/// - move() brings x to the end of the sub-step; u only as far as the solver's answer
///   to a second problem, or the way itself, asks for.
/// - describe() writes what rests depend on: a change of it wakes all.
/// - pushes(i): row i had an overlap moved out in this sub-step.
template <class Stage, class Scene, class Solver>
concept CorrectionStage = requires(Stage stage, Scene& scene,
                                   const StepSettings& settings, Solver& solver,
                                   StepData<Scene::dof>& now,
                                   StabilizerSettings& how)
{
    stage.require_valid();
    stage.rows(scene, settings, now);
    stage.move(scene, settings, solver, now);
    stage.describe(how);
    bool{stage.pushes(0)};
};

/// The λ that the solver starts from.
///
/// - recall(), once a step, gives λ one number for each source, and says whether the
///   rows are those of the step before.
/// - choose(), in each sub-step, makes that the guess; no row and no velocity changes.
/// - remember() keeps what it needs of λ after the last sub-step.
/// - impulses() is what it remembers, for others to read and to add to; nullptr: none.
template <class Stage, int Dof>
concept StartStage = requires(Stage stage, const Bodies<Dof>& bodies,
                              const StepSettings& settings, StepData<Dof>& now)
{
    stage.require_valid();
    stage.recall(settings, now);
    stage.choose(bodies, now);
    stage.remember(settings, now);
    stage.impulses();
};

/// λ and u from the rows and u*.
///
/// - solve() begins at the λ that it finds, writes now.solution, and leaves
///   u = u* + M⁻¹ Jᵀ λ of the active bodies (u* alone where its status says that it has
///   no answer). No x changes, and no J.
/// - noise() [ℓ/s]: it may leave as much in the velocity of what is at rest.
/// - islands_found(): of the rows of this step; nullptr: they have not been found.
template <class Stage, int Dof>
concept SolverStage = requires(Stage stage, Bodies<Dof>& bodies, StepData<Dof>& now)
{
    stage.require_valid();
    stage.solve(bodies, now);
    Real{stage.noise()};
    stage.islands_found();
    int{stage.unsolved};
    bool{Stage::is_exact};
    bool{Stage::knows_sliding};
};

/// A solver that answers other biases on the rows that it has just solved.
///
/// - solve_again(): from the same u*; λ and u become that answer.
/// - solve_apart(): from rest; v = M⁻¹ Jᵀ Λ of the active bodies, λ and u stay.
template <class Stage, int Dof>
concept SolvesAgain = requires(Stage stage, SecondProblem& second, VecX& v,
                               Bodies<Dof>& bodies, StepData<Dof>& now)
{
    stage.solve_again(second, bodies, now);
    stage.solve_apart(second, v, now);
};

/// Four stages that fit a kind of scene and each other.
template <class Any, class Scene, class Method = std::remove_reference_t<Any>>
concept StepMethod = ContactsStage<decltype(Method::contacts), Scene, Method> &&
    CorrectionStage<decltype(Method::correction), Scene,
                    decltype(Method::solver)> &&
    StartStage<decltype(Method::start), Scene::dof> &&
    SolverStage<decltype(Method::solver), Scene::dof>;

}  // namespace rigid
