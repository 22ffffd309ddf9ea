// The functions of tumbling.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/20_turning_in_space/tumbling.hpp"

namespace rigid {

//! [tumble]
void tumble(Tumbling way, const Vec3& inertia, Real h, Vec3& theta, Vec3& omega)
{
    Vec3 turn;
    switch (way) {
    case Tumbling::explicit_term:
        omega = explicit_spin(inertia, omega, h);
        turn = h * omega;
        break;
    case Tumbling::implicit_term:
        omega = implicit_spin(inertia, omega, h);
        turn = h * omega;
        break;
    case Tumbling::momentum_kept:
        turn = h * omega;
        omega = spin_in_turned_axes(inertia, omega, turn);
        break;
    case Tumbling::middle:
        turn = turn_through_the_middle(inertia, omega, h);
        omega = spin_in_turned_axes(inertia, omega, turn);
        break;
    }
    theta = add_rotation(theta, turn);
}
//! [tumble]

}  // namespace rigid
