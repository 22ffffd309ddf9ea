/// \file elementary.hpp
/// Sine, cosine and the other elementary functions that physics needs, with the same bits everywhere.
///
/// The C standard does not say how the last bits of std::sin are rounded, so each C library rounds in its own way: glibc
/// on Linux, musl in a page, Microsoft's on Windows. One other bit is enough for two piles to fall apart differently.
/// What IEEE 754 does fix are + − × ÷, the square root, and comparisons, each rounded on its own. The functions here
/// consist of these alone, so they give the same bits with each compiler, operating system and processor that keeps to
/// that standard in doubles, and does not fuse or reorder (`-ffp-contract=off`, no `-ffast-math`).
///
/// The error of each is below 1 ulp (one unit in the last place) for every argument in its domain: measured, not proved;
/// tests/elementary.cpp has the numbers. Outside the domain the result is NaN; poles and overflows give ±infinity, as in
/// the standard library. Of the latter we go on using what is exact by definition: sqrt, abs, floor, round, fmod,
/// remainder, frexp, ldexp, fma.
///
/// The angle of a sine may be any finite number: the multiple of π/2 that is taken away is known to enough digits.
/// Inside namespace rigid, `sin(x)` means the one declared here.
#pragma once

#include "common/math.hpp"

#include <cmath>

namespace rigid {

Real sin(Real angle);
Real cos(Real angle);
/// Both, with the same bits, in less time than one after the other.
struct SineAndCosine {
    Real sine, cosine;
};
SineAndCosine sine_and_cosine(Real angle);
Real tan(Real angle);
Real asin(Real x);
Real atan(Real x);
/// The angle of the point (x, y), from −π to π.
Real atan2(Real y, Real x);

Real exp(Real x);
/// e^x − 1, with all digits also where x is small.
Real expm1(Real x);
Real log(Real x);
/// log(1 + x), with all digits also where x is small.
Real log1p(Real x);
Real log2(Real x);
Real log10(Real x);
Real pow(Real base, Real exponent);

/// √(x² + y²), without overflow on the way.
Real hypot(Real x, Real y);

}  // namespace rigid
