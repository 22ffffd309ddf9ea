#include "chapters/15_trees/tree_method.hpp"
#include "chapters/16_soft_constraints/soft_method.hpp"
#include "tests/stress/engine_column.hpp"
#include "tests/stress/jointed.hpp"
#include "tests/stress/stepping.hpp"
#include "tests/stress/turning_honest.hpp"

namespace rigid::stress {

namespace {

/// What moves bodies by itself, without rows that a solver answers, has nothing that could be called solved.
struct NothingSaid {
    template <class Solving>
    void operator()(const Solving&, const StepData<3>&) const
    {
    }
};

Manifolds& touching(Manifolds& contacts) { return contacts; }
Manifolds& touching(AwakeManifolds& contacts) { return contacts.touching; }

template <class Solving, class Honest = HonestTurning>
JointedMethod jointed(int chapter, const std::string& name, const std::string& budget, Solving by,
                      int substeps = 1, const Honest& honest = {})
{
    never_stop(touching(by.contacts));  // section 15.4
    auto method = stepping<JointedScene>(chapter, name, budget, by, substeps, honest);
    method.friction = true;
    method.springs = !std::is_same_v<Solving, JointRattle<Manifolds>>;
    return method;
}

JointedMethod by_sweeps(const std::string& name, const Spending& spending)
{
    JointSweeps<Manifolds> by;
    by.correction = correction_of(spending);
    by.correction.at_the_end = spending.correction == Stabilizer::projection;
    by.start.from = Start::best_multiple;
    by.solver.sweeps.max_sweeps = spending.sweeps;
    return jointed(14, name, budget(spending), by, spending.substeps);
}

std::string exactly(int substeps)
{
    return "exact, " + std::to_string(substeps) + (substeps > 1 ? " substeps" : " step");
}

}  // namespace

std::vector<JointedMethod> jointed_methods()
{
    SoftSweeps<Manifolds> soft;
    soft.solver.sweeps.max_sweeps = 1;
    BodyDescent<Manifolds> descent;
    return {by_sweeps("joint sweeps", {Stabilizer::baumgarte, 10, 0, 1, infinity, 0.2}),
            by_sweeps("joint small steps", {Stabilizer::projection, 1, 1, 8, infinity, 1}),
            jointed(15, "trees", exactly(1), JointTrees<Manifolds>{}),
            jointed(15, "trees substeps", exactly(8), JointTrees<Manifolds>{}, 8),
            jointed(15, "trees that sleep", exactly(1), SkippingJoints{}),
            jointed(15, "joint rattle", exactly(1) + " with positions met", JointRattle<Manifolds>{}, 1,
                    NothingSaid{}),
            jointed(16, "soft small steps", "8 sweeps in 8 substeps", soft, 8, NothingSaid{}),
            jointed(16, "xpbd", "8 sweeps in 8 substeps", PositionSweeps<Manifolds>{}, 8, NothingSaid{}),
            jointed(16, "block descent", "10 sweeps", descent, 1, NothingSaid{}),
            engine_method<JointedScene>("engine", {})};
}

}  // namespace rigid::stress
