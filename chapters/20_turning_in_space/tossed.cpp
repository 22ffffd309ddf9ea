// The functions of tossed.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/20_turning_in_space/tossed.hpp"

namespace rigid {

//! [book]
SolidScene tossed_book(Real omega, Real tilt)
{
    SolidScene scene;
    scene.gravity.setZero();
    const Vec3 size(0.16, 0.24, 0.04);
    const Hull book = solid_box(size);
    add_body(scene, {book}, 0.7 / size.prod(), {0, 0, 0});
    scene.bodies.velocity(0).tail<3>() = omega * Vec3(1, tilt, tilt);
    return scene;
}
//! [book]

SolidScene t_handle(Real omega, Real tilt)
{
    SolidScene scene;
    scene.gravity.setZero();
    add_body(scene,
             {solid_box({0.12, 0.02, 0.02}),
              solid_box({0.02, 0.02, 0.05}, {0, 0, 0.035})},
             7800, {0, 0, 0});
    // the axes in the order of their moments
    const Vec3 inverse = scene.bodies.inverse_mass.segment<3>(3);
    Index middle = 0;
    for (Index i = 0; i < 3; ++i)
        if (inverse[i] < inverse.maxCoeff() && inverse[i] > inverse.minCoeff())
            middle = i;
    Vec3 spin = Vec3::Constant(omega * tilt);
    spin[middle] = omega;
    scene.bodies.velocity(0).tail<3>() = spin;
    return scene;
}

SolidScene spinning_plate()
{
    SolidScene scene;
    scene.gravity.setZero();
    SolidMass mass;
    mass.mass = 4;
    mass.inertia = Vec3(1, 2, 3).asDiagonal();
    add_body(scene, {solid_box({2.4, 1.7, 0.05})}, mass, {0, 0, 0});
    scene.bodies.velocity(0).tail<3>() = Vec3(0.5, 0, 1);
    return scene;
}

}  // namespace rigid
