/// \file elastic_space_scenes.hpp
/// Elastic bodies of tetrahedra that one wants to see: a ball on a slope, jelly on stairs, soft
/// fingers that lift a box, a mattress under a box.
#pragma once

#include "chapters/30_elastic_bodies/elastic_scenes.hpp"
#include "chapters/30_elastic_bodies/elastic_solids.hpp"

namespace rigid {

/// A ball of radius 0.3 m that lies on a slope of `angle` [rad].
ElasticSpace soft_ball_scene(StrainLaw law, Real young, Real angle,
                             Real friction = 0.8);

/// A block of jelly above stairs of triangles, which moves towards them.
ElasticSpace space_jelly_scene(StrainLaw law, Real young);

/// Two soft fingers on arms that close, then lift a box of `mass`.
ElasticSpace soft_fingers_scene(StrainLaw law, Real young, Real mass);
inline void move_fingers(ElasticSpace& scene, Real t)
{
    move_arms(scene.elastic, t);
}

/// A block of 0.6 m × 0.6 m × 0.2 m on the floor, and a box of `mass` above it.
ElasticSpace mattress_scene(StrainLaw law, Real young, Real mass);

}  // namespace rigid
