// The functions of space_contact.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/25_space/space_contact.hpp"

namespace rigid {

void find_place(const SpaceContact& contact, const VecX& x, ContactPlace& p)
{
    if (p.b != contact.b || p.a != contact.a) {
        p.a = contact.a, p.b = contact.b;
        p.Ra = rotation_of(x, contact.a), p.Rb = rotation_of(x, contact.b);
    }
    p.arm_a = p.Ra * contact.at_a, p.arm_b = p.Rb * contact.at_b;
    p.way = centre_of(x, contact.b) + p.arm_b - centre_of(x, contact.a) - p.arm_a;
}

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
