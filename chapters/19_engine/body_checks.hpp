/// \file body_checks.hpp
/// Which bodies and surfaces a world takes.
#pragma once

#include "chapters/11_rotation/polygon.hpp"
#include "chapters/19_engine/definitions.hpp"

#include <cmath>
#include <span>
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

/// Throws std::invalid_argument unless a number of a body is zero or positive, and finite.
/// \param what  "the linear damping of the body"
inline void require_not_negative(Real value, const std::string& what,
                                 const char* unit)
{
    if (!(value >= 0) || !std::isfinite(value))
        throw std::invalid_argument(what + " is " + shortest(value) + unit +
                                    "; it must be zero or positive, and finite");
}
inline void require_damping(Real linear, Real angular)
{
    require_not_negative(linear, "the linear damping of the body", " 1/s");
    require_not_negative(angular, "the angular damping of the body", " 1/s");
}
inline void require_gravity_scale(Real scale)
{
    if (!(std::abs(scale) <= largest_number))
        throw std::invalid_argument("the gravity scale of the body is " +
                                    shortest(scale) +
                                    "; it must be finite, and not beyond 1e75");
}

/// Throws std::invalid_argument unless a mass and an inertia are those of a body.
inline void require_mass(Real mass, Real inertia)
{
    if (!(mass > 0 && inertia > 0) || !std::isfinite(1 / mass) ||
        !std::isfinite(1 / inertia) || !std::isfinite(mass) ||
        !std::isfinite(inertia))
        throw std::invalid_argument(
            "the body has the mass " + shortest(mass) + " kg and the inertia " +
            shortest(inertia) +
            " kg m²; both and their inverses must be positive and finite");
}

inline bool has_area(const Polygon& shape)
{
    return shape.radius > 0 || shape.vertices.size() > 2;
}

/// That of its area; what has no area is about the mean of its vertices.
inline Vec2 centroid_of(const Polygon& shape)
{
    if (has_area(shape)) return mass_of(shape, 1).centroid;
    Vec2 sum(0, 0);
    for (const Vec2& vertex : shape.vertices) sum += vertex;
    return sum / static_cast<Real>(shape.vertices.size());
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
    require_damping(body.linear_damping, body.angular_damping);
    require_gravity_scale(body.gravity_scale);
    const bool pushed = body.mass ? body.mass->mass > 0 || body.mass->inertia > 0
                                  : body.density > 0;
    if (pushed) {
        const Mass mass =
            body.mass ? *body.mass : mass_of(body.shape, body.density);
        require_mass(mass.mass, mass.inertia);
        if (mass.centroid.allFinite()) return require_about(mass, body.shape);
    }
    Mass fixed;
    fixed.centroid = body.mass ? body.mass->centroid : centroid_of(body.shape);
    if (!fixed.centroid.allFinite())
        throw std::invalid_argument(
            "the centroid of the body is (" + shortest(fixed.centroid.x()) + ", " +
            shortest(fixed.centroid.y()) + "); it must be finite");
    return require_about(fixed, body.shape);
}

/// The mass of a body of several shapes in the axes of the first one, (19.5). Of a body without mass the centroid is that
/// of its area.
inline Mass mass_of(const BodyDefinition& body,
                    std::span<const ShapeDefinition> more)
{
    if (body.mass) return *body.mass;
    Mass all;
    const auto add = [&all](const Polygon& shape, Real density) {
        const Mass one = mass_of(shape, density);
        const Real mass = all.mass + one.mass;
        if (!(mass > 0)) return;
        const Vec2 way = one.centroid - all.centroid;
        all.inertia += one.inertia + all.mass * one.mass / mass * way.squaredNorm();
        all.centroid += one.mass / mass * way;
        all.mass = mass;
    };
    const auto add_all = [&](Real own, const auto& density_of) {
        if (own > 0) add(body.shape, own);
        for (const ShapeDefinition& it : more)
            if (const Real density = density_of(it); density > 0)
                add(it.shape, density);
    };
    add_all(body.density, [&body](const ShapeDefinition& it) {
        return it.density.value_or(it.sensor ? 0 : body.density);
    });
    if (all.mass > 0) return all;
    const auto areas = [](const Polygon& shape) { return Real(has_area(shape)); };
    add_all(areas(body.shape),
            [&](const ShapeDefinition& it) { return areas(it.shape); });
    if (!(all.mass > 0)) all.centroid = centroid_of(body.shape);
    all.mass = all.inertia = 0;
    return all;
}

/// The same for a body of several shapes.
inline Mass require_valid(const BodyDefinition& body,
                          std::span<const ShapeDefinition> more)
{
    if (more.empty()) return require_valid(body);
    if (body.sensor)
        throw std::invalid_argument(
            "the sensor has " + std::to_string(more.size()) +
            " shapes more; of a body of several shapes the first is no sensor");
    for (const ShapeDefinition& it : more) {
        require_valid(it.shape);
        require_surface(it.surface, "the shape");
        if (!it.density) continue;
        require_not_negative(*it.density, "the density of the shape", " kg/m²");
        if (body.mass || (it.sensor && *it.density > 0))
            throw std::invalid_argument(
                "the shape has the density " + shortest(*it.density) + " kg/m²; " +
                (body.mass
                     ? "the body has a mass that was given, so it must have none"
                     : "it is a sensor, so it must be 0"));
    }
    BodyDefinition whole = body;
    if (!body.mass) whole.mass = mass_of(body, more);
    const Mass mass = require_valid(whole);
    for (const ShapeDefinition& it : more) require_about(mass, it.shape);
    return mass;
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
