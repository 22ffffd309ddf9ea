/// Chapter 15: a mechanism of seven bodies with three loops beside its published motion.

#include "chapters/11_rotation/rigid_method.hpp"
#include "chapters/15_trees/joint_accelerations.hpp"
#include "chapters/15_trees/squeezing_mechanism.hpp"

#include "tests/catch.hpp"

using namespace rigid;

TEST_CASE("a squeezing mechanism of seven bodies ends where the literature says", "[idea]")
{
    SqueezingMechanism mechanism;
    JointedScene& scene = mechanism.scene;
    CHECK(largest_joint_error(scene) <= 1e-15);  // the published start closes the loops, to rounding of 0.1 m
    JointAccelerations joints;
    const auto rates = [&](const VecX& s) -> VecX {
        VecX a = mechanism.accelerations(s.head(21));
        joints.find(scene, s.head(21), s.tail(21), a);
        return (VecX(42) << s.tail(21), a).finished();
    };
    VecX s(42);
    s << scene.bodies.x, VecX::Zero(21);
    const long steps = 6000;
    const Real h = 0.03 / static_cast<Real>(steps);
    for (long i = 0; i < steps; ++i) {
        const VecX k1 = rates(s), k2 = rates(s + h / 2 * k1), k3 = rates(s + h / 2 * k2),
                   k4 = rates(s + h * k3);
        s += h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
    }
    // the angles at 0.03 s of the test set for initial value problems
    const std::array<Real, 7> known = {15.81077119629904,   -15.75637105984298, 0.04082224013073101,
                                       -0.5347301163226948, 0.5244099658805304, 0.5347301163226948,
                                       1.048080741042263};
    const std::array<Real, 7> found = SqueezingMechanism::angles(s);
    for (std::size_t i = 0; i < 7; ++i) {
        CAPTURE(i, found[i]);
        CHECK(std::abs(found[i] - known[i]) <= 1e-7);  // 2e-9 was measured: 6000 steps of fourth order
    }
}
