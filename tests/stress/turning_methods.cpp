#include "chapters/12_contact_manifolds/manifold_method.hpp"
#include "tests/stress/engine_column.hpp"
#include "tests/stress/jointed.hpp"
#include "tests/stress/stepping.hpp"
#include "tests/stress/turning_honest.hpp"

namespace rigid::stress {

namespace {

/// The second half of RATTLE is a problem of its own, as in the first matrix.
struct HonestRattle {
    void operator()(RigidRattle& by, const StepData<3>& now) const
    {
        Solution second = now.solution;
        second.lambda -= by.correction.lambda_first;
        require_honest(by.solver.mlcp, second);
    }
};

template <class Scene, class Solving, class Honest = HonestTurning>
TurningMethod turning(int chapter, const std::string& name, const std::string& budget, const Solving& by,
                      int substeps = 1, const Honest& honest = {})
{
    auto method = stepping<RoughScene, Scene>(chapter, name, budget, by, substeps, honest);
    method.walls_only = chapter == 11;
    method.friction = chapter == 13;
    return method;
}

Spending baumgarte() { return {Stabilizer::baumgarte, 10, 0, 1, infinity, 0.2}; }

/// Chapter 8's small steps: a sweep for the velocities and one for the positions, eight times.
Spending small_steps() { return {Stabilizer::projection, 1, 1, 8, infinity, 1}; }

/// With errors corrected apart and whole: chapter 9.
Spending split(int substeps) { return {Stabilizer::split_impulse, 1, 0, substeps, infinity, 1}; }

template <class Scene, class Solving>
TurningMethod by_sweeps(int chapter, const std::string& name, const Spending& spending, Start start)
{
    Solving by;
    by.correction = correction_of(spending);
    by.correction.at_the_end = spending.correction == Stabilizer::projection;
    by.start.from = start;
    by.solver.sweeps.max_sweeps = spending.sweeps;
    return turning<Scene>(chapter, name, budget(spending), by, spending.substeps);
}

template <class Scene, class Solving>
TurningMethod exactly(int chapter, const std::string& name, const Spending& spending)
{
    Solving by;
    by.correction = correction_of(spending);
    return turning<Scene>(chapter, name,
                          "exact, " + std::to_string(spending.substeps) +
                              (spending.substeps > 1 ? " substeps" : " step"),
                          by, spending.substeps);
}

TurningMethod by_rattle(const std::string& name, int substeps)
{
    return turning<RigidScene>(11, name,
                               "exact, " + std::to_string(substeps) + (substeps > 1 ? " substeps" : " step") +
                                   " with positions met",
                               RigidRattle{}, substeps, HonestRattle{});
}

}  // namespace

std::vector<TurningMethod> turning_methods()
{
    using FrictionMethod = FrictionSweeps<Manifolds>;
    using Coulomb = ExactFriction<Manifolds>;
    std::vector<TurningMethod> all = {
        by_sweeps<RigidScene, RigidSweeps>(11, "corners cold", baumgarte(), Start::cold),
        by_sweeps<RigidScene, RigidSweeps>(11, "corners warm", baumgarte(), Start::previous),
        by_sweeps<RigidScene, RigidSweeps>(11, "corners best", baumgarte(), Start::best_multiple),
        by_sweeps<RigidScene, RigidSweeps>(11, "corners small steps", small_steps(), Start::best_multiple),
        exactly<RigidScene, RigidExact>(11, "corners exact", baumgarte()),
        exactly<RigidScene, RigidExact>(11, "corners exact substeps", split(8)),
        by_rattle("corners rattle", 1),
        by_rattle("corners rattle substeps", 8),
        by_sweeps<RigidScene, ManifoldSweeps>(12, "smooth cold", baumgarte(), Start::cold),
        by_sweeps<RigidScene, ManifoldSweeps>(12, "smooth warm", baumgarte(), Start::previous),
        by_sweeps<RigidScene, ManifoldSweeps>(12, "smooth best", baumgarte(), Start::best_multiple),
        by_sweeps<RigidScene, ManifoldSweeps>(12, "smooth small steps", small_steps(), Start::best_multiple),
        exactly<RigidScene, ManifoldExact>(12, "smooth exact", baumgarte()),
        exactly<RigidScene, ManifoldExact>(12, "smooth exact split", split(1)),
        exactly<RigidScene, ManifoldExact>(12, "smooth exact substeps", split(8)),
        by_sweeps<RoughScene, FrictionMethod>(13, "rough cold", baumgarte(), Start::cold),
        by_sweeps<RoughScene, FrictionMethod>(13, "rough warm", baumgarte(), Start::previous),
        by_sweeps<RoughScene, FrictionMethod>(13, "rough best", baumgarte(), Start::best_multiple),
        by_sweeps<RoughScene, FrictionMethod>(13, "rough small steps", small_steps(), Start::best_multiple),
        exactly<RoughScene, Coulomb>(13, "rough exact", baumgarte()),
        exactly<RoughScene, Coulomb>(13, "rough exact split", split(1)),
        exactly<RoughScene, Coulomb>(13, "rough exact substeps", split(8)),
        exactly<RoughScene, LemkeFriction<Manifolds>>(13, "rough lemke", baumgarte())};
    // A pile in motion gives an exact method no last answer to begin with: beyond this a step takes a second.
    for (TurningMethod& method : all)
        if (method.name.find("exact") != std::string::npos) method.most_rows = 330;
    all.back().most_rows = 60;  // pivots of a dense tableau
    all.push_back(engine_method<RoughScene>("engine", {}));
    for (TurningMethod& way : ways_of_turning()) all.push_back(std::move(way));
    return all;
}

}  // namespace rigid::stress
