/// \file body_checks.hpp
/// Which bodies and surfaces a world takes.
#pragma once

#include "chapters/19_engine/definitions.hpp"

#include <cmath>
#include <stdexcept>
#include <string>

namespace rigid {

/// Throws std::invalid_argument for a surface that makes no sense, or whose coefficient of friction is another one while it
/// slides: the solver of a world does not ask whether a contact slides.
inline void require_surface(const Surface& surface, const std::string& name)
{
    require_valid(surface, name);
    if (surface.while_sliding() < surface.friction)
        throw std::invalid_argument(
            name + " has the kinetic friction coefficient " +
            shortest(surface.while_sliding()) + " beside the static one, " +
            shortest(surface.friction) +
            "; in a world there is one, the methods of chapter 13 take both");
}

/// A body beyond would be held there by every step (held_bodies.hpp).
inline bool is_place(const Vec2& position, Real angle)
{
    return std::abs(position.x()) <= largest_number &&
           std::abs(position.y()) <= largest_number &&
           std::abs(angle) <= largest_number;
}

/// A shape is kept about its centroid. Far from it rounding may make one point of two vertices.
inline Mass require_about(const Mass& mass, Polygon shape)
{
    for (Vec2& vertex : shape.vertices) vertex -= mass.centroid;
    require_valid(shape);
    return mass;
}

/// Throws std::invalid_argument, with a sentence, unless a definition makes sense. Returns how its mass is spread.
inline Mass require_valid(const BodyDefinition& body)
{
    require_valid(body.shape);
    require_surface(body.surface, "the body");
    if (!is_place(body.position, body.angle) || !body.velocity.allFinite() ||
        !std::isfinite(body.spin))
        throw std::invalid_argument(
            "the body is at (" + shortest(body.position.x()) + ", " +
            shortest(body.position.y()) + ") m at the angle " +
            shortest(body.angle) + " rad with the velocity (" +
            shortest(body.velocity.x()) + ", " + shortest(body.velocity.y()) +
            ") m/s and the spin " + shortest(body.spin) +
            " rad/s; all must be finite, and no place or angle beyond 1e75");
    if (!(body.density >= 0) || !std::isfinite(body.density))
        throw std::invalid_argument(
            "the density of the body is " + shortest(body.density) +
            " kg/m²; it must be zero or positive, and finite");
    if (body.sensor && (body.density > 0 || body.mass))
        throw std::invalid_argument("the sensor has the density " +
                                    shortest(body.density) +
                                    " kg/m²; it must be 0, without a mass: nothing "
                                    "pushes a sensor");
    const bool pushed = body.mass ? body.mass->mass > 0 || body.mass->inertia > 0
                                  : body.density > 0;
    if (pushed) {
        const Mass mass =
            body.mass ? *body.mass : mass_of(body.shape, body.density);
        if (!(mass.mass > 0 && mass.inertia > 0) || !mass.centroid.allFinite() ||
            !std::isfinite(1 / mass.mass) || !std::isfinite(1 / mass.inertia) ||
            !std::isfinite(mass.inertia))
            throw std::invalid_argument(
                "the body has the mass " + shortest(mass.mass) +
                " kg and the inertia " + shortest(mass.inertia) +
                " kg m²; both and their inverses must be positive and finite");
        return require_about(mass, body.shape);
    }
    Mass fixed;  // what has no area is about the mean of its vertices
    if (body.mass) fixed.centroid = body.mass->centroid;
    else if (body.shape.radius > 0 || body.shape.vertices.size() > 2)
        fixed.centroid = mass_of(body.shape, 1).centroid;
    else {
        for (const Vec2& vertex : body.shape.vertices) fixed.centroid += vertex;
        fixed.centroid /= static_cast<Real>(body.shape.vertices.size());
    }
    if (!fixed.centroid.allFinite())
        throw std::invalid_argument(
            "the centroid of the body is (" + shortest(fixed.centroid.x()) + ", " +
            shortest(fixed.centroid.y()) + "); it must be finite");
    return require_about(fixed, body.shape);
}

/// Throws std::invalid_argument unless gravity gives a mass a weight that is a number.
/// \param mass  0, ∞: cannot be moved
inline void require_weight(Real mass, const Vec2& gravity)
{
    if (std::isfinite(mass) && !(mass * gravity).allFinite())
        throw std::invalid_argument(
            "a body of " + shortest(mass) + " kg under the gravity (" +
            shortest(gravity.x()) + ", " + shortest(gravity.y()) +
            ") m/s² has no finite weight; one of both must be smaller");
}

}  // namespace rigid
