//! [program]
// Twenty-four discs fall into a box and come to rest: the physics of this book in
// a program of its own.
#include "chapters/08_warm_starting/warm_method.hpp"
#include "common/measure.hpp"
#include "common/scenes.hpp"

#include <cstdio>
#include <exception>

int main()
try {
    using namespace rigid;
    DiscScene scene;  // metres, kilograms, seconds; y is up

    // A floor and two walls: the normals point into the box, the offsets are
    // distances along them.
    scene.walls = {{{0, 1}, 0}, {{1, 0}, -0.5}, {{-1, 0}, -0.5}};
    scene.bodies = Bodies<2>(24);
    scene.radius = VecX::Constant(24, 0.1);
    for (Index k = 0; k < 24; ++k) {
        scene.bodies.position(k) << -0.33 + 0.22 * Real(k % 4) + 0.01 * Real(k / 4),
            0.2 + 0.25 * Real(k / 4);
        // [1/kg]; 0 cannot move
        scene.bodies.inverse_mass.segment<2>(2 * k).setConstant(1 / 1.5);
    }
    link_neighbours(scene);
    require_valid(scene);  // throws a sentence about what makes no sense
    StepSettings settings;
    settings.h = 1.0 / 60;  // [s]
    settings.substeps = 4;
    // chapter 8's: sweeps that start from the impulses of the previous step
    WarmMethod method;
    method.correction.method = Stabilizer::split_impulse;
    method.correction.slop = 0.0005;  // [m]
    StepData<2> now;                  // what the step finds on its way
    for (int n = 0; n < 300; ++n) {
        step(scene, settings, method, now);
        if ((n + 1) % 60 == 0)
            std::printf("%d s: %zu contacts, %.6f J, overlap %.6f m\n",
                        (n + 1) / 60, now.contacts.size(),
                        kinetic_energy(scene.bodies), deepest_penetration(scene));
    }
    const bool at_rest =
        kinetic_energy(scene.bodies) < 1e-3 && deepest_penetration(scene) < 2e-3;
    return at_rest ? 0 : 1;
} catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 2;
}
//! [program]
