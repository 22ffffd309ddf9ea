// The functions of space_contact.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/23_faces_that_touch/space_contact.hpp"

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

}  // namespace rigid
