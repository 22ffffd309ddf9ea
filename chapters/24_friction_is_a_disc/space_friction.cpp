// The functions of space_friction.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/24_friction_is_a_disc/space_friction.hpp"

namespace rigid {

//! [turn]
Constraint<6> turn_constraint(const SpaceContact& contact, const ContactPlace& p,
                              SpacePart part, int number, Real length)
{
    const Vec3& n = contact.normal;
    const Vec3 t1 = across(n);
    const Vec3 axis = part == spin_part    ? n
                      : part == first_roll ? t1
                                           : Vec3(cross(n, t1));
    Constraint<6> c;
    c.a = contact.a, c.b = contact.b;
    const Vec3 turn = length * axis;
    c.Jb << 0, 0, 0, (p.Rb.transpose() * turn).transpose();
    if (c.a != world) c.Ja << 0, 0, 0, -(p.Ra.transpose() * turn).transpose();
    c.kind = ConstraintKind::friction;
    c.bounded_by = number;
    const Grip& grip = contact.grip;
    c.friction = (part == spin_part ? grip.spinning : grip.rolling) / length;
    return c;
}
//! [turn]

}  // namespace rigid
