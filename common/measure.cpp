#include "common/measure.hpp"

#include <algorithm>
#include <cmath>

namespace rigid {

Real kinetic_energy(const Bodies<2>& bodies)
{
    Real sum = 0;
    for (Index k = 0; k < bodies.count(); ++k)
        if (bodies.inverse_mass[2 * k] > 0)
            sum += bodies.velocity(k).squaredNorm() / (2 * bodies.inverse_mass[2 * k]);
    return sum;
}

Real potential_energy(const Bodies<2>& bodies, const Vec2& gravity)
{
    Real sum = 0;
    for (Index k = 0; k < bodies.count(); ++k)
        if (bodies.inverse_mass[2 * k] > 0)
            sum -= gravity.dot(bodies.position(k)) / bodies.inverse_mass[2 * k];
    return sum;
}

Vec2 momentum(const Bodies<2>& bodies)
{
    Vec2 sum = Vec2::Zero();
    for (Index k = 0; k < bodies.count(); ++k)
        if (bodies.inverse_mass[2 * k] > 0) sum += bodies.velocity(k) / bodies.inverse_mass[2 * k];
    return sum;
}

Real angular_momentum(const Bodies<2>& bodies)
{
    Real sum = 0;
    for (Index k = 0; k < bodies.count(); ++k)
        if (bodies.inverse_mass[2 * k] > 0)
            sum += cross2(bodies.position(k), bodies.velocity(k)) / bodies.inverse_mass[2 * k];
    return sum;
}

Real deepest_penetration(const DiscScene& scene)
{
    std::vector<Contact> contacts;
    find_contacts(scene, 0, contacts);
    Real deepest = 0;
    for (const Contact& contact : contacts) deepest = std::max(deepest, -contact.gap);
    return deepest;
}

Real largest_link_error(const DiscScene& scene)
{
    Real largest = 0;
    for (const Link& link : scene.links) {
        const Real distance = (scene.bodies.position(link.b) - scene.bodies.position(link.a)).norm();
        largest = std::max(largest, std::abs(distance - link.length));
    }
    return largest;
}

}  // namespace rigid
