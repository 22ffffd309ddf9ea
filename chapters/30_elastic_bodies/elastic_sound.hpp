/// \file elastic_sound.hpp
/// What a body that was struck sounds like: its vibrations at one place, and a file of them.
///
///     s(t) = Σ φ_k(node) q̇_k(t),   q_k by (30.24): exact at each sample, whatever the rate
///
/// Tones above half the rate cannot be written by it and are left out.
#pragma once

#include "chapters/30_elastic_bodies/vibration.hpp"

#include <iosfwd>
#include <span>
#include <vector>

namespace rigid {

/// The speed of one freedom of a body from its present state on, without loads.
/// \param count    vibrations
/// \param freedom  Dim·node + axis
/// \param rate     samples a second
/// \throws std::invalid_argument  for a freedom that there is not, a time or rate that is
///         not positive, and less than one sample or an hour or more
/// \throws std::runtime_error     where the vibrations were not found
template <int Dim>
std::vector<Real> sound_of(const ElasticBody<Dim>& body, int count, int freedom,
                           Real seconds, int rate = 44100);

/// A file of one channel and 16 bits a sample (WAV), the loudest sample at 0.9.
/// \throws std::invalid_argument  for no samples, one that is not finite, or a rate that is
///         not positive
void write_wave(std::ostream& out, std::span<const Real> samples, int rate = 44100);

extern template std::vector<Real> sound_of(const ElasticBody<1>&, int, int, Real,
                                           int);
extern template std::vector<Real> sound_of(const ElasticBody<2>&, int, int, Real,
                                           int);
extern template std::vector<Real> sound_of(const ElasticBody<3>&, int, int, Real,
                                           int);

}  // namespace rigid
