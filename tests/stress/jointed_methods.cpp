#include "chapters/15_trees/tree_method.hpp"
#include "chapters/16_soft_constraints/soft_method.hpp"
#include "tests/stress/engine_column.hpp"
#include "tests/stress/jointed_columns.hpp"

namespace rigid::stress {

namespace {

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
    JointedMethod rattle = jointed(15, "joint rattle", exactly(1) + " with positions met",
                                   JointRattle<Manifolds>{}, 1, NothingSaid{});
    rattle.springs = false;
    std::vector<JointedMethod> all = {
        by_sweeps("joint sweeps", {Stabilizer::baumgarte, 10, 0, 1, infinity, 0.2}),
        by_sweeps("joint small steps", {Stabilizer::projection, 1, 1, 8, infinity, 1}),
        jointed(15, "trees", exactly(1), JointTrees<Manifolds>{}),
        jointed(15, "trees substeps", exactly(8), JointTrees<Manifolds>{}, 8),
        jointed(15, "trees that sleep", exactly(1), SkippingJoints{}),
        rattle,
        jointed(16, "soft small steps", "8 sweeps in 8 substeps", soft, 8, NothingSaid{}),
        jointed(16, "xpbd", "8 sweeps in 8 substeps", PositionSweeps<Manifolds>{}, 8, NothingSaid{}),
        jointed(16, "block descent", "10 sweeps", descent, 1, NothingSaid{}),
        engine_method<JointedScene>("engine", {})};
    // Impulses one at a time are not among them: what is joined never collides.
    for (JointedMethod& way : ways_with_joints()) all.push_back(std::move(way));
    return all;
}

}  // namespace rigid::stress
