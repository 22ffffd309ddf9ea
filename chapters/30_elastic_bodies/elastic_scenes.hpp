/// \file elastic_scenes.hpp
/// Elastic bodies that one wants to see: a strip, a disc that spins, a ball, jelly on stairs,
/// a gripper, a bridge with a car, a bar that is struck.
#pragma once

#include "chapters/30_elastic_bodies/elastic_contact.hpp"

namespace rigid {

/// A strip of 1 m × 0.1 m that is held at its left end. Quadratic triangles.
ElasticScene strip_scene(StrainLaw law, Real young, int order = 2);

/// A disc of radius 0.5 m that turns by `omega` about its middle, without weight.
ElasticScene spinning_scene(StrainLaw law, Real young, Real omega);

/// A ball of radius 0.3 m on a slope of `angle` [rad].
ElasticScene ball_scene(StrainLaw law, Real young, Real angle);

/// A block of jelly above stairs that cannot move.
ElasticScene jelly_scene(StrainLaw law, Real young);

/// Two soft fingers on arms that close, then lift a box of `mass`.
ElasticScene gripper_scene(StrainLaw law, Real young, Real mass);
/// Arms that close, then rise: the velocity of held nodes at the time t [s].
template <int Dim>
void move_arms(ElasticBody<Dim>& body, Real t);
inline void move_gripper(ElasticScene& scene, Real t)
{
    move_arms(scene.elastic, t);
}

/// A bridge of 4 m between two banks, and a car of 120 kg with driven wheels that crosses.
ElasticScene bridge_with_car(StrainLaw law, Real young, Real speed);

/// A free bar of 1 m × 0.05 m, of which one end was struck: it moves at 1 m/s across.
ElasticScene struck_bar(StrainLaw law, Real young);

/// A free bar of steel, 0.3 m × 6 mm, of which one end was struck: its first tone is 347 Hz.
ElasticBody<2> chime();

}  // namespace rigid
