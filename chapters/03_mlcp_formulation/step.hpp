/// \file step.hpp
/// The step of this book, from force to position, on one screen.
///
///     forces → u* → contacts → C, J → rows (b, bounds) → λ start → λ → u → x
///
/// A scene has bodies, forces, constraints. A method is how it is solved, by four stages, and from
/// here on each chapter replaces one of them:
///
///     contacts     which bodies and which contacts the step looks at      all pairs here; chapter 10
///     correction   what becomes of a position error: b, and x afterwards  C/h here; chapters 6, 7
///     start        the λ that the solver starts from                      zero here; chapter 8
///     solver       λ and u from the rows and u*                           a matrix here; chapters 6, 9, 10
#pragma once

#include "chapters/03_mlcp_formulation/disc_constraints.hpp"
#include "chapters/03_mlcp_formulation/matrix_solver.hpp"
#include "chapters/03_mlcp_formulation/step_data.hpp"
#include "common/text.hpp"

namespace rigid {

//! [whole_error]
/// The correction stage in its plainest form: what we need is C(x + h u) = 0, or ≥
/// 0, after the step. To first order that is C + h J u, hence the bias b = C/h,
/// (3.30). It takes back the whole of an error in one step; why that is rash in
/// general is a later chapter's subject.
struct WholeError : PlainCorrection {
    template <class Scene>
    void rows(const Scene& scene, const StepSettings& settings,
              StepData<Scene::dof>& now) const
    {
        const Real h = settings.part();
        write_rows(scene.bodies, h, now, [h](const auto& c) {
            return has_error(c.kind) ? c.C / h : own_bias(c, h);
        });
    }
    template <class Scene, class Solver>
    void move(Scene& scene, const StepSettings& settings, Solver&,
              StepData<Scene::dof>& now) const
    {
        advance_positions(scene.bodies, settings.part(), now);  // (1.10)
    }
};
//! [whole_error]

/// The start stage in its plainest form: nothing is remembered from step to step, λ = 0.
struct ColdStart : PlainStart {
    /// part of λ that the next sub-step of the same step starts from, 0 … 1
    /// (chapter 7)
    Real factor = 0;

    void require_valid() const
    {
        if (!(factor >= 0 && factor <= 1))
            throw std::invalid_argument("the warm start factor is " +
                                        shortest(factor) +
                                        "; it must be from 0 to 1");
    }
    template <int Dof>
    void recall(const StepSettings&, StepData<Dof>& now) const
    {
        now.solution.lambda.setZero(static_cast<Index>(now.sources.size()));
        now.same_rows = false;
    }
    template <int Dof>
    void choose(const Bodies<Dof>&, StepData<Dof>& now) const
    {
        if (now.substep > 0) now.solution.lambda *= factor;
    }
    template <int Dof>
    void remember(const StepSettings&, const StepData<Dof>&) const
    {
    }
};

/// Asks each stage whether its settings make sense, before the step touches anything.
template <class Method>
void require_valid_stages(const Method& method)
{
    method.contacts.require_valid();
    method.correction.require_valid();
    method.start.require_valid();
    method.solver.require_valid();
}

//! [step]
/// One time step. Depends on its arguments alone. Settings that make no sense are
/// refused before anything changes; if the solver throws, positions stay where they
/// were.
/// \param scene     what there is; it moves
/// \param settings  of the step
/// \param method    four stages with their settings and what they remember:
///                  contacts, correction, start, solver (stages.hpp)
/// \param now       what was found on the way
template <class Scene, StepMethod<Scene> Method>
void step(Scene& scene, const StepSettings& settings, Method&& method,
          StepData<Scene::dof>& now)
{
    require_valid(settings, scene.gravity, scene.bodies.count());
    require_valid_stages(method);
    now.visits = 0;
    now.h = settings.part();
    method.contacts.begin(scene, settings, method, now);
    if (now.active.empty()) return;
    method.start.recall(settings, now);

    for (now.substep = 0; now.substep < settings.substeps; ++now.substep) {
        // forces, and u* that they alone lead to (3.4)
        free_velocities(scene, settings, now);
        // C and J where the bodies are now
        evaluate_constraints(scene, now);
        // w = J u + b with the bounds of λ
        method.correction.rows(scene, settings, now);
        method.start.choose(scene.bodies, now);  // where λ starts
        // λ, and u = u* + M⁻¹ Jᵀ λ (3.9)
        method.solver.solve(scene.bodies, now);
        method.correction.move(scene, settings, method.solver, now);  // x
        // what it has borne may be too much (chapter 14)
        method.contacts.end_part(scene, now);
    }

    method.start.remember(settings, now);
    method.contacts.end(scene, settings, method, now);
}
//! [step]

/// The rows that a step would have, one for each link and then one for each of these contacts, without taking it.
/// \param correction  the stage that chooses b
template <class Correction = WholeError>
void disc_rows(const DiscScene& scene, Real h, const std::vector<Contact>& contacts,
               std::vector<Row<2>>& rows, const Correction& correction = {})
{
    correction.require_valid();
    require_bodies(scene);
    StepData<2> now;
    for (std::size_t i = 0; i < scene.links.size(); ++i)
        now.sources.push_back({Source::Of::link, static_cast<int>(i)});
    now.contacts = contacts;
    for (std::size_t i = 0; i < contacts.size(); ++i)
        now.sources.push_back({Source::Of::contact, static_cast<int>(i)});
    evaluate_constraints(scene, now);
    correction.rows(scene, {.h = h}, now);
    rows.swap(now.rows);
}

/// The method of this chapter, with a solver of the whole MLCP: void(const Mlcp&, Solution&), where the Solution holds
/// the λ to start from, or Solution(const Mlcp&).
//! [method]
template <class Solve>
struct MatrixMethod {
    AllPairs contacts;
    WholeError correction;
    ColdStart start;
    MatrixSolver<Solve> solver;
};
//! [method]

template <class Solve>
MatrixMethod<Solve> by_matrix(Solve solve)
{
    return {{}, {}, {}, {{}, std::move(solve), {}, {}}};
}

}  // namespace rigid
